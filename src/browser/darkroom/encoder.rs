//! The browser's own encoder of films (W3C, WebCodecs). What `web-sys` has of it is not stable yet.

use crate::export::{Codec, Film, FilmColours, FilmFormat, Sample, write_mp4};
use js_sys::{Object, Promise, Reflect, Uint8Array};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::OffscreenCanvas;

#[wasm_bindgen]
extern "C" {
    type VideoEncoder;
    #[wasm_bindgen(constructor, catch)]
    fn new(init: &Object) -> Result<VideoEncoder, JsValue>;
    #[wasm_bindgen(method, catch)]
    fn configure(this: &VideoEncoder, config: &Object) -> Result<(), JsValue>;
    #[wasm_bindgen(method, catch)]
    fn encode(this: &VideoEncoder, frame: &VideoFrame, options: &Object) -> Result<(), JsValue>;
    #[wasm_bindgen(method, catch)]
    fn flush(this: &VideoEncoder) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, getter, js_name = encodeQueueSize)]
    fn encode_queue_size(this: &VideoEncoder) -> u32;

    type VideoFrame;
    #[wasm_bindgen(constructor, catch)]
    fn new(canvas: &OffscreenCanvas, init: &Object) -> Result<VideoFrame, JsValue>;
    #[wasm_bindgen(method)]
    fn close(this: &VideoFrame);

    type EncodedVideoChunk;
    #[wasm_bindgen(method, getter, js_name = byteLength)]
    fn byte_length(this: &EncodedVideoChunk) -> u32;
    #[wasm_bindgen(method, getter)]
    fn timestamp(this: &EncodedVideoChunk) -> f64;
    #[wasm_bindgen(method, getter, js_name = type)]
    fn kind(this: &EncodedVideoChunk) -> String;
    #[wasm_bindgen(method, js_name = copyTo)]
    fn copy_to(this: &EncodedVideoChunk, to: &Uint8Array);
}

/// Frames that may wait to be encoded: more take memory and time for nothing.
const MOST_WAITING: u32 = 4;
/// A key frame in so many seconds: players seek to those.
const KEY_S: u32 = 2;
const MICROSECONDS: f64 = 1e6;

pub struct FilmEncoder {
    encoder: VideoEncoder,
    film: Film,
    made: Rc<RefCell<Made>>,
    _output: Closure<dyn FnMut(EncodedVideoChunk, JsValue)>,
    _error: Closure<dyn FnMut(JsValue)>,
}

/// What has been encoded.
#[derive(Default)]
struct Made {
    samples: Vec<Sample>,
    /// What the encoder says of a decoder that is to show it.
    decoder: Option<JsValue>,
    error: Option<String>,
}

impl FilmEncoder {
    pub fn new(film: &Film) -> Result<FilmEncoder, String> {
        let made = Rc::<RefCell<Made>>::default();
        let (takes, fails, rate) = (made.clone(), made.clone(), film.frames_per_s());
        let output = Closure::<dyn FnMut(EncodedVideoChunk, JsValue)>::new(
            move |chunk: EncodedVideoChunk, more: JsValue| {
                let bytes = Uint8Array::new_with_length(chunk.byte_length());
                chunk.copy_to(&bytes);
                let frame = (chunk.timestamp() / MICROSECONDS * f64::from(rate)).round() as u32;
                let is_key = chunk.kind() == "key";
                let mut made = takes.borrow_mut();
                made.samples.push(Sample { bytes: bytes.to_vec(), frame, is_key });
                let decoder = member(&more, "decoderConfig");
                if made.decoder.is_none() && decoder.is_truthy() {
                    made.decoder = Some(decoder);
                }
            },
        );
        let error = Closure::<dyn FnMut(JsValue)>::new(move |why: JsValue| {
            fails.borrow_mut().error = Some(failed(&why));
        });
        let init =
            object(&[("output", output.as_ref().clone()), ("error", error.as_ref().clone())]);
        let encoder = VideoEncoder::new(&init).map_err(|why| failed(&why))?;
        encoder.configure(&config(film)).map_err(|why| failed(&why))?;
        Ok(FilmEncoder { encoder, film: film.clone(), made, _output: output, _error: error })
    }

    /// Takes what stands on a canvas as the next frame.
    pub async fn add(&self, canvas: &OffscreenCanvas, k: u32) -> Result<(), String> {
        let rate = f64::from(self.film.frames_per_s());
        let us = |frames: u32| (f64::from(frames) / rate * MICROSECONDS).round();
        let times = [("timestamp", us(k)), ("duration", us(k + 1) - us(k))];
        let frame = VideoFrame::new(canvas, &object(&times.map(|(name, us)| (name, us.into()))))
            .map_err(|why| failed(&why))?;
        let is_key = k.is_multiple_of(KEY_S * self.film.frames_per_s());
        let encoded = self.encoder.encode(&frame, &object(&[("keyFrame", is_key.into())]));
        frame.close();
        encoded.map_err(|why| failed(&why))?;
        loop {
            if let Some(why) = self.made.borrow_mut().error.take() {
                return Err(why);
            }
            super::a_moment().await;
            if self.encoder.encode_queue_size() <= MOST_WAITING {
                return Ok(());
            }
        }
    }

    /// The film, once all frames are encoded, with a link in it.
    pub async fn finish(self, link: &str) -> Result<Vec<u8>, String> {
        let flushed = self.encoder.flush().map_err(|why| failed(&why))?;
        JsFuture::from(flushed).await.map_err(|why| failed(&why))?;
        let made = std::mem::take(&mut *self.made.borrow_mut());
        if made.samples.len() != self.film.frames as usize {
            let (made, frames) = (made.samples.len(), self.film.frames);
            return Err(format!("The browser encoded {made} of {frames} frames: try a GIF."));
        }
        let decoder = made.decoder.unwrap_or_default();
        let codec =
            codec(&self.film, &decoder).ok_or("The browser says too little of its film.")?;
        let colours = colours(&member(&decoder, "colorSpace"));
        let size_px = self.film.size_px.map(|length| length as u16);
        let rate = self.film.frames_per_s();
        Ok(write_mp4(&codec, colours, size_px, rate, &made.samples, link))
    }
}

/// What an encoder is asked for.
fn config(film: &Film) -> Object {
    let codec = match &film.format {
        FilmFormat::Mp4 { codec } => &**codec,
        FilmFormat::Gif => "",
    };
    let [width, height] = film.size_px.map(JsValue::from);
    object(&[
        ("codec", codec.into()),
        ("width", width),
        ("height", height),
        ("framerate", film.frames_per_s().into()),
        ("bitrate", film.bits_per_s().into()),
        // Of H.264, with the record of its parameters beside the frames.
        ("avc", object(&[("format", "avc".into())]).into()),
    ])
}

fn codec(film: &Film, decoder: &JsValue) -> Option<Codec> {
    let FilmFormat::Mp4 { codec } = &film.format else { return None };
    if codec.starts_with("avc1") {
        let record = member(decoder, "description");
        // A view of a buffer, or a buffer.
        let record = match record.dyn_ref::<js_sys::ArrayBuffer>() {
            Some(buffer) => Uint8Array::new(buffer),
            None if record.is_object() => {
                let number = |name| member(&record, name).as_f64().unwrap_or_default() as u32;
                let buffer = member(&record, "buffer");
                let (at, length) = (number("byteOffset"), number("byteLength"));
                Uint8Array::new_with_byte_offset_and_length(&buffer, at, length)
            }
            None => return None,
        };
        return Some(Codec::H264(record.to_vec()));
    }
    // `vp09.00.40.08`: profile, level and bits.
    let mut numbers = codec.split('.').skip(1).map(|number| number.parse().ok());
    Some(Codec::Vp9 { profile: numbers.next()??, level: numbers.next()?? })
}

/// The numbers of what the encoder calls its colours; of what it does not say those of television.
fn colours(said: &JsValue) -> FilmColours {
    let word = |name| member(said, name).as_string().unwrap_or_default();
    let number = |word: &str| match word {
        "bt470bg" => 5,
        "smpte170m" => 6,
        "iec61966-2-1" => 13,
        _ => 1,
    };
    FilmColours {
        primaries: number(&word("primaries")),
        transfer: number(&word("transfer")),
        matrix: number(&word("matrix")),
        full_range: member(said, "fullRange").is_truthy(),
    }
}

fn failed(why: &JsValue) -> String {
    let why = member(why, "message").as_string().unwrap_or_default();
    format!("The browser cannot encode this film: try a smaller one, or a GIF. ({why})")
}

fn member(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or_default()
}

fn object(members: &[(&str, JsValue)]) -> Object {
    let object = Object::new();
    for (name, value) in members {
        // Plain objects take every member.
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object
}
