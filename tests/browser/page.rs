//! The built page in a browser of its own, and what its visitor does with it.

use crate::base64;
use crate::engines::Engine;
use crate::server::{Server, dist};
use crate::webdriver::{Element, WebDriver};
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A tab with the page in it.
pub struct Page {
    browser: WebDriver,
    pub server: Server,
    /// One browser at a time: two of them would fight for the processor that draws for them.
    _alone: MutexGuard<'static, ()>,
}

/// What the `<html>` element says of the page.
#[derive(Clone, Debug, PartialEq, Eq, Default, serde::Deserialize)]
#[serde(default)]
pub struct State {
    pub state: String,
    pub plant: String,
    pub individual: String,
    pub day: String,
    pub cells: String,
    pub fingerprint: String,
    pub backend: String,
}

/// How long a plant may take to grow on a busy machine that draws without a graphics card.
const PATIENCE: Duration = Duration::from_secs(120);

static ALONE: Mutex<()> = Mutex::new(());

impl Page {
    /// Opens a link (`#…`, or nothing) in a fresh browser. None where there is no such browser or no
    /// built page: the test is skipped then, which is said. Under `./playground test` that is a
    /// failure, unless it found before that the browser cannot be had.
    pub fn open(engine: impl Into<Engine>, link: &str) -> Option<Page> {
        let page = Page::start(engine)?;
        page.visit(link);
        Some(page)
    }

    /// A browser that has not gone anywhere yet.
    pub fn start(engine: impl Into<Engine>) -> Option<Page> {
        let engine = engine.into();
        let missing = match Page::try_to_start(engine) {
            Ok(page) => return Some(page),
            Err(missing) => missing,
        };
        let is_required = std::env::var("BROWSER_TESTS").is_ok_and(|wanted| wanted == "required");
        assert!(!is_required || engine.is_given_up(), "{missing}");
        skip(&missing);
        None
    }

    fn try_to_start(engine: Engine) -> Result<Page, String> {
        if std::env::var("BROWSER_TESTS").is_ok_and(|wanted| wanted == "off") {
            return Err("BROWSER_TESTS is off".to_string());
        }
        if engine.is_given_up() {
            return Err(format!("{} could not be installed here", engine.name()));
        }
        if !dist().join("index.html").is_file() {
            return Err("the page is not built: ./playground build".to_string());
        }
        let alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(Page { browser: engine.start()?, server: Server::start(&dist()), _alone: alone })
    }

    /// Loads the page anew with this link.
    #[track_caller]
    pub fn visit(&self, link: &str) {
        self.go(&format!("{}{link}", self.server.address()));
    }

    /// Goes to any address.
    #[track_caller]
    pub fn go(&self, address: &str) {
        self.browser.open("about:blank");
        self.browser.open(address);
    }

    /// Opens an address in a frame with this `sandbox`, and goes into it.
    #[track_caller]
    pub fn go_to_frame(&self, address: &str, sandbox: &str) {
        let icon = "<link rel=icon href=data:>";
        let frame =
            format!("{icon}<iframe sandbox='{sandbox}' width=1200 height=700 src='{address}'>");
        let platform = Path::new(env!("CARGO_TARGET_TMPDIR")).join("platform");
        std::fs::create_dir_all(&platform).expect("a folder can be made");
        std::fs::write(platform.join("index.html"), frame).expect("a file can be written");
        self.go(&Server::start(&platform).address());
        self.browser.enter_frame();
    }

    /// Opens a page of somebody else's, and stays in it.
    #[track_caller]
    pub fn go_to_host(&self, html: &str) {
        let host = Path::new(env!("CARGO_TARGET_TMPDIR")).join("host");
        std::fs::create_dir_all(&host).expect("a folder can be made");
        std::fs::write(host.join("index.html"), html).expect("a file can be written");
        self.go(&Server::start(&host).address());
    }

    /// Does something in the first frame of the page.
    #[track_caller]
    pub fn in_frame<T>(&self, act: impl FnOnce() -> T) -> T {
        self.browser.enter_frame();
        let done = act();
        self.browser.leave_frame();
        done
    }

    #[track_caller]
    pub fn state(&self) -> State {
        let data = self.run("return {...document.documentElement.dataset}");
        serde_json::from_value(data).expect("words and numbers")
    }

    /// Waits until the page says this of itself; the state that it then has.
    #[track_caller]
    pub fn wait(&self, what: &str, is_so: impl Fn(&State) -> bool) -> State {
        let begun = Instant::now();
        loop {
            let state = self.state();
            if is_so(&state) {
                return state;
            }
            if begun.elapsed() > PATIENCE || state.state == "error" {
                let complaints = self.browser.complaints();
                let files = self.run(
                    "return performance.getEntriesByType('resource').map(e =>
                         e.name.split('/').pop() + ' ' + Math.round(e.startTime) + ' to '
                         + Math.round(e.responseEnd) + ' ms')",
                );
                let messages = self.messages();
                panic!("waited for {what}: {state:?}, {messages:?}, {complaints:#?}, {files}");
            }
            std::thread::sleep(Duration::from_millis(30));
        }
    }

    /// Waits until all that was asked for is on the screen.
    #[track_caller]
    pub fn ready(&self) -> State {
        self.wait("the page to rest", |s| s.state == "ready")
    }

    /// Waits until this day is on the screen.
    #[track_caller]
    pub fn on_day(&self, day: u32) -> State {
        self.wait(&format!("day {day}"), |s| s.state == "ready" && s.day == day.to_string())
    }

    /// Waits until something holds that only a script can tell.
    #[track_caller]
    pub fn wait_for(&self, what: &str, script: &str) {
        // What it asks for may be yet to come.
        let tried = format!(
            "try {{ return (() => {{ {script} }})() }} catch (error) {{ return String(error) }}"
        );
        self.wait(what, |_| self.run(&tried) == true);
    }

    #[track_caller]
    pub fn run(&self, script: &str) -> Value {
        self.browser.execute(script, &[])
    }

    #[track_caller]
    pub fn text(&self, id: &str) -> String {
        let script = "return document.getElementById(arguments[0]).textContent";
        let text = self.browser.execute(script, &[json!(id)]);
        text.as_str().unwrap_or_default().trim().to_string()
    }

    /// The messages that the visitor sees.
    #[track_caller]
    pub fn messages(&self) -> String {
        let script = "const m = document.getElementById('messages');
                      return m && m.checkVisibility() ? m.innerText : ''";
        self.run(script).as_str().unwrap_or_default().to_string()
    }

    #[track_caller]
    pub fn element(&self, css: &str) -> Element {
        self.browser.find(css)
    }

    #[track_caller]
    pub fn click(&self, id: &str) {
        self.browser.click(&self.element(&format!("#{id}")));
    }

    /// Replaces what stands in a field and leaves it with Enter.
    #[track_caller]
    pub fn fill_in(&self, id: &str, text: &str) {
        let select = "const e = document.getElementById(arguments[0]); e.focus(); e.select()";
        self.browser.execute(select, &[json!(id)]);
        self.browser.type_into(&self.element(&format!("#{id}")), &format!("{text}{}", keys::ENTER));
    }

    /// Drops a file on the page.
    pub fn drop(&self, name: &str, kind: &str, bytes: &[u8]) {
        self.run(&format!(
            "const data = new DataTransfer();
             const bytes = Uint8Array.from(atob('{}'), c => c.charCodeAt(0));
             data.items.add(new File([bytes], '{name}', {{type: '{kind}'}}));
             document.dispatchEvent(new DragEvent('drop', {{dataTransfer: data, bubbles: true, cancelable: true}}))",
            base64::written(bytes)
        ));
    }

    /// Drags the day slider there and lets go.
    #[track_caller]
    pub fn drag_to_day(&self, day: f64) {
        let script = "const e = document.getElementById('day'); e.value = arguments[0];
                      e.dispatchEvent(new Event('input', {bubbles: true}));
                      e.dispatchEvent(new Event('change', {bubbles: true}))";
        self.browser.execute(script, &[json!(day)]);
    }

    #[track_caller]
    pub fn choose(&self, plant: &str) {
        let radio = format!("#plants label:has(input[value={plant}])");
        self.browser.click(&self.element(&radio));
    }

    #[track_caller]
    pub fn press(&self, keys: &[&str]) {
        self.browser.press(keys);
    }

    /// Drags with the mouse from the middle of an element.
    #[track_caller]
    pub fn drag(&self, css: &str, right_px: i32, down_px: i32) {
        self.browser.drag(&self.element(css), right_px, down_px);
    }

    /// The part of the address after the `#`.
    #[track_caller]
    pub fn link(&self) -> String {
        let hash = self.run("return location.hash");
        hash.as_str().unwrap_or_default().trim_start_matches('#').to_string()
    }

    /// Waits until the canvas has all its pixels: while a slow device draws changes it has fewer.
    #[track_caller]
    pub fn sharp(&self) {
        self.wait_for(
            "all pixels",
            "const canvas = document.getElementById('canvas');
             return canvas.width === Math.round(canvas.clientWidth * devicePixelRatio)",
        );
    }

    /// Makes pages that are loaded from now on take software for a graphics card.
    #[track_caller]
    pub fn pretend_card(&self) {
        self.before_pages(
            "if (window.GPUAdapterInfo)
                 Object.defineProperty(GPUAdapterInfo.prototype, 'isFallbackAdapter', {get: () => false});
             const ask = WebGL2RenderingContext.prototype.getParameter;
             WebGL2RenderingContext.prototype.getParameter = function (what) {
                 const said = ask.call(this, what);
                 return /SwiftShader/.test(said) ? 'A graphics card' : said
             }",
        );
    }

    /// Makes pages that are loaded from now on run this script before their own.
    #[track_caller]
    pub fn before_pages(&self, script: &str) {
        let source = format!("(() => {{ {script} }})()");
        self.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": source }));
    }

    /// Waits until the page asks for no frames any more; how many it has asked for, if it was opened
    /// after `count_frames`.
    #[track_caller]
    pub fn rest(&self) -> u64 {
        let asked = || self.run("return window.frames_asked || 0").as_u64().expect("a number");
        let (begun, mut before) = (Instant::now(), asked());
        loop {
            std::thread::sleep(Duration::from_millis(1_500));
            let now = asked();
            if now == before {
                return now;
            }
            assert!(begun.elapsed() < PATIENCE, "the page asks for frames for ever: {now}");
            before = now;
        }
    }

    /// Makes pages that are loaded from now on count the frames that they ask for.
    #[track_caller]
    pub fn count_frames(&self) {
        self.before_pages(
            "const ask = window.requestAnimationFrame.bind(window);
             window.frames_asked = 0;
             window.requestAnimationFrame = callback => { window.frames_asked += 1; return ask(callback) }",
        );
    }

    /// What the canvas shows, with all its pixels.
    #[track_caller]
    pub fn picture(&self) -> Picture {
        self.sharp();
        Picture::decode(&self.png("#canvas"))
    }

    /// Whether the page has asked for a file of such a name; the service worker, which keeps all files, does not count.
    #[track_caller]
    pub fn has_asked_for(&self, name: &str) -> bool {
        let script =
            "return performance.getEntriesByType('resource').some(e => e.name.includes(NAME))";
        self.run(&script.replace("NAME", &json!(name).to_string())) == true
    }

    /// An element as it is on the screen, as a PNG file.
    #[track_caller]
    pub fn png(&self, css: &str) -> Vec<u8> {
        base64::read(&self.browser.screenshot(&self.element(css)))
    }

    #[track_caller]
    pub fn devtools(&self, command: &str, parameters: Value) -> Value {
        self.browser.devtools(command, parameters)
    }

    /// Errors on the console since the last call.
    #[track_caller]
    pub fn complaints(&self) -> Vec<String> {
        self.browser.complaints()
    }

    /// Errors and warnings on the console since the last call.
    #[track_caller]
    pub fn warnings(&self) -> Vec<String> {
        self.browser.console(&["SEVERE", "WARNING"])
    }
}

/// Says that the running test is skipped, past the test harness, which would keep it to itself.
pub fn skip(why: &str) {
    let test = std::thread::current().name().unwrap_or_default().to_string();
    let _ = writeln!(std::io::stderr(), "SKIPPED {test}: {why}");
}

pub(crate) use crate::keys;

/// A screenshot: rows of RGB from the top.
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub rgb: Vec<[u8; 3]>,
}

impl Picture {
    pub fn decode(bytes: &[u8]) -> Picture {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut data).expect("a whole PNG");
        let step = info.color_type.samples();
        assert!(step >= 3, "a picture in colour");
        let pixels = data[..info.buffer_size()].chunks_exact(step);
        Picture {
            width: info.width as usize,
            height: info.height as usize,
            rgb: pixels.map(|p| [p[0], p[1], p[2]]).collect(),
        }
    }

    /// Mean difference of two pictures of one size, 0 to 255.
    pub fn difference(&self, other: &Picture) -> f64 {
        assert_eq!((self.width, self.height), (other.width, other.height));
        let pairs = self.rgb.iter().flatten().zip(other.rgb.iter().flatten());
        let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        sum as f64 / (3 * self.rgb.len()) as f64
    }

    /// How many different colours there are.
    pub fn colours(&self) -> usize {
        self.rgb.iter().collect::<std::collections::HashSet<_>>().len()
    }
}
