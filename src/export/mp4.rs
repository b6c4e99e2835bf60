//! Encoded frames as an MP4 (ISO/IEC 14496-12): one track, all frames of one length, the table of frames before
//! the frames, so that a film plays while it is loaded.

/// How frames are encoded, with what a decoder must know before it sees one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Codec {
    /// With its `AVCDecoderConfigurationRecord` (ISO/IEC 14496-15).
    H264(Vec<u8>),
    /// VP9 with 8 bits, with its profile and level (VP Codec ISO Media File Format Binding).
    Vp9 { profile: u8, level: u8 },
}

/// The colours of a film, by the numbers of ISO/IEC 23091-2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilmColours {
    pub primaries: u16,
    pub transfer: u16,
    pub matrix: u16,
    pub full_range: bool,
}

/// An encoded frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    pub bytes: Vec<u8>,
    /// The number of the frame that it shows, from 0 on.
    pub frame: u32,
    /// Whether it can be decoded without those before.
    pub is_key: bool,
}

/// The matrix of a picture that is shown as it is.
const UNIT: [u32; 9] = [0x1_0000, 0, 0, 0, 0x1_0000, 0, 0, 0, 0x4000_0000];

/// Writes a film of samples in the order in which they are decoded. The link of what it shows stands in it as its
/// comment.
pub fn write_mp4(
    codec: &Codec,
    colours: FilmColours,
    size_px: [u16; 2],
    frames_per_s: u32,
    samples: &[Sample],
    link: &str,
) -> Vec<u8> {
    let kind: &[u8] = match codec {
        Codec::H264(_) => b"isom\0\0\x02\0isomiso2avc1mp41",
        Codec::Vp9 { .. } => b"isom\0\0\x02\0isomiso2mp41",
    };
    let ftyp = a_box(b"ftyp", &[kind]);
    let stsd = full_box(b"stsd", 0, &[&words(&[1]), &entry(codec, colours, size_px)]);
    let moov = |offset: u32| {
        let stbl = a_box(b"stbl", &[&stsd, &table(samples, offset)]);
        moov(&stbl, size_px, frames_per_s, samples.len() as u32, &comment(link))
    };
    let first = (ftyp.len() + moov(0).len() + 8) as u32;
    let frames: Vec<&[u8]> = samples.iter().map(|sample| &sample.bytes[..]).collect();
    [ftyp, moov(first), a_box(b"mdat", &frames)].concat()
}

fn moov(stbl: &[u8], size_px: [u16; 2], frames_per_s: u32, count: u32, more: &[u8]) -> Vec<u8> {
    let [width, height] = size_px.map(u32::from);
    // Time is counted in frames.
    let mut header = vec![0, 0, frames_per_s, count, 0x1_0000, 0x100_0000, 0, 0];
    header.extend(UNIT);
    header.extend([0, 0, 0, 0, 0, 0, 2]);
    let mut track = vec![0, 0, 1, 0, count, 0, 0, 0, 0];
    track.extend(UNIT);
    track.extend([width << 16, height << 16]);
    let here = full_box(b"url ", 1, &[]);
    let sources = a_box(b"dinf", &[&full_box(b"dref", 0, &[&words(&[1]), &here])]);
    let video = full_box(b"vmhd", 1, &[&words(&[0, 0])]);
    let minf = a_box(b"minf", &[&video, &sources, stbl]);
    // The language is not said ("und").
    let media = full_box(b"mdhd", 0, &[&words(&[0, 0, frames_per_s, count, 0x55c4_0000])]);
    let handler = full_box(b"hdlr", 0, &[&[0; 4], b"vide", &[0; 13]]);
    let mdia = a_box(b"mdia", &[&media, &handler, &minf]);
    // Shown, in the film.
    let tkhd = full_box(b"tkhd", 3, &[&words(&track)]);
    let mvhd = full_box(b"mvhd", 0, &[&words(&header)]);
    a_box(b"moov", &[&mvhd, &a_box(b"trak", &[&tkhd, &mdia]), more])
}

/// A comment, as most programs read it (QuickTime File Format, metadata of iTunes).
fn comment(text: &str) -> Vec<u8> {
    let handler = full_box(b"hdlr", 0, &[&[0; 4], b"mdirappl", &[0; 9]]);
    // In UTF-8, in no language.
    let data = a_box(b"data", &[&words(&[1, 0]), text.as_bytes()]);
    let list = a_box(b"ilst", &[&a_box(b"\xa9cmt", &[&data])]);
    a_box(b"udta", &[&full_box(b"meta", 0, &[&handler, &list])])
}

/// What the frames are.
fn entry(codec: &Codec, colours: FilmColours, size_px: [u16; 2]) -> Vec<u8> {
    let [width, height] = size_px.map(u32::from);
    // The first source, 72 dots to an inch, one frame a sample, no name, 24 bits.
    let mut picture = words(&[0, 1, 0, 0, 0, 0, width << 16 | height, 0x48_0000, 0x48_0000, 0]);
    picture.extend([0, 1]);
    picture.extend([0; 32]);
    picture.extend([0, 24, 255, 255]);
    let FilmColours { primaries, transfer, matrix, full_range } = colours;
    let mut colour = b"nclx".to_vec();
    colour.extend([primaries, transfer, matrix].map(u16::to_be_bytes).concat());
    colour.push(u8::from(full_range) << 7);
    let colour = a_box(b"colr", &[&colour]);
    match codec {
        Codec::H264(record) => a_box(b"avc1", &[&picture, &a_box(b"avcC", &[record]), &colour]),
        Codec::Vp9 { profile, level } => {
            // 8 bits, and colours at the places of every second pixel.
            let depth = 8 << 4 | 1 << 1 | u8::from(full_range);
            let numbers = [primaries, transfer, matrix].map(|number| number as u8);
            let more = [&[*profile, *level, depth], &numbers[..], &[0, 0]].concat();
            let vpcc = full_box(b"vpcC", 1 << 24, &[&more]);
            a_box(b"vp09", &[&picture, &vpcc, &colour])
        }
    }
}

/// Where each frame is, how long it is shown, and which can be begun with. `offset`: of the first, in the file.
fn table(samples: &[Sample], offset: u32) -> Vec<u8> {
    let count = samples.len() as u32;
    let mut parts = vec![full_box(b"stts", 0, &[&words(&[1, count, 1])])];
    let late: Vec<u32> =
        (0..).zip(samples).map(|(k, sample)| sample.frame.wrapping_sub(k)).collect();
    if late.iter().any(|&late| late != 0) {
        let rows: Vec<u32> = late.into_iter().flat_map(|late| [1, late]).collect();
        parts.push(full_box(b"ctts", 1 << 24, &[&words(&[count]), &words(&rows)]));
    }
    let keys = (1..).zip(samples).filter(|(_, sample)| sample.is_key).map(|(k, _)| k);
    let keys: Vec<u32> = keys.collect();
    parts.push(full_box(b"stss", 0, &[&words(&[keys.len() as u32]), &words(&keys)]));
    parts.push(full_box(b"stsc", 0, &[&words(&[1, 1, count, 1])]));
    let sizes: Vec<u32> = samples.iter().map(|sample| sample.bytes.len() as u32).collect();
    parts.push(full_box(b"stsz", 0, &[&words(&[0, count]), &words(&sizes)]));
    parts.push(full_box(b"stco", 0, &[&words(&[1, offset])]));
    parts.concat()
}

fn a_box(kind: &[u8; 4], parts: &[&[u8]]) -> Vec<u8> {
    let length: usize = parts.iter().map(|part| part.len()).sum();
    let head = [(8 + length as u32).to_be_bytes(), *kind].concat();
    [&head[..], &parts.concat()].concat()
}

/// A box with a version (the highest eight bits) and flags.
fn full_box(kind: &[u8; 4], version_and_flags: u32, parts: &[&[u8]]) -> Vec<u8> {
    let head = version_and_flags.to_be_bytes();
    a_box(kind, &[&[&head[..]], parts].concat())
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_be_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use re_mp4::{Mp4, StsdBoxContent};

    const LINK: &str = "croton?v=1&s=2&d=3";
    const COLOURS: FilmColours =
        FilmColours { primaries: 1, transfer: 13, matrix: 6, full_range: false };

    /// Frames 0, 1, 2 ... in this order of decoding.
    fn samples(order: &[u32]) -> Vec<Sample> {
        let bytes = |frame: u32| vec![frame as u8; 3 + frame as usize];
        let sample = |&frame: &u32| Sample { bytes: bytes(frame), frame, is_key: frame % 3 == 0 };
        order.iter().map(sample).collect()
    }

    /// The record of a stream of 640 x 360 pixels.
    fn record() -> Vec<u8> {
        let sps = [0x67, 0x42, 0xc0, 0x1e, 0xda, 0x02, 0x80, 0xbf, 0xe5, 0xc0, 0x44, 0x00];
        let mut record = vec![1, 0x42, 0xc0, 0x1e, 0xff, 0xe1, 0, sps.len() as u8];
        record.extend(sps);
        record.extend([1, 0, 4, 0x68, 0xce, 0x3c, 0x80]);
        record
    }

    #[test]
    fn a_film_is_read_by_another_reader() {
        for codec in [Codec::H264(record()), Codec::Vp9 { profile: 0, level: 31 }] {
            let samples = samples(&[0, 1, 2, 3, 4]);
            let bytes = write_mp4(&codec, COLOURS, [640, 360], 30, &samples, LINK);
            let mp4 = Mp4::read_bytes(&bytes).unwrap();
            let track = mp4.tracks().values().next().unwrap();
            assert_eq!(
                (track.width, track.height, track.timescale, track.duration),
                (640, 360, 30, 5)
            );
            assert_eq!(track.samples.len(), 5);
            assert!(bytes.windows(LINK.len()).any(|window| window == LINK.as_bytes()));
            for (read, sample) in track.samples.iter().zip(&samples) {
                let at = read.offset as usize;
                assert_eq!(&bytes[at..at + read.size as usize], &sample.bytes);
                assert_eq!(read.is_sync, sample.is_key);
                assert_eq!(
                    (read.composition_timestamp, read.duration),
                    (i64::from(sample.frame), 1)
                );
            }
            match &track.trak(&mp4).mdia.minf.stbl.stsd.contents {
                StsdBoxContent::Avc1(avc1) => assert_eq!((avc1.width, avc1.height), (640, 360)),
                StsdBoxContent::Vp09(vp09) => {
                    assert_eq!(
                        (vp09.vpcc.profile, vp09.vpcc.level, vp09.vpcc.bit_depth),
                        (0, 31, 8)
                    );
                    // It reads no primaries, and so the numbers after them as others.
                    assert_eq!(vp09.vpcc.chroma_subsampling, 1);
                }
                other => panic!("{other:?}"),
            }
        }
    }

    #[test]
    fn frames_that_come_in_another_order_are_shown_in_their_own() {
        let samples = samples(&[0, 3, 1, 2, 4]);
        let bytes = write_mp4(&Codec::H264(record()), COLOURS, [640, 360], 30, &samples, LINK);
        let mp4 = Mp4::read_bytes(&bytes).unwrap();
        let track = mp4.tracks().values().next().unwrap();
        let shown: Vec<i64> = track.samples.iter().map(|read| read.composition_timestamp).collect();
        assert_eq!(shown, [0, 3, 1, 2, 4]);
    }
}
