//! As much of the WebDriver protocol (W3C, <https://www.w3.org/TR/webdriver2/>) as these tests need:
//! JSON over HTTP to a driver of our own, which each browser has.

use crate::engines::Screen;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The key under which WebDriver hands out elements.
const ELEMENT: &str = "element-6066-11e4-a52e-4f735466cecf";

/// A browser window; dropping it closes the browser.
pub struct WebDriver {
    driver: Child,
    port: u16,
    session: String,
    /// Goes after the browser that draws on it.
    _screen: Option<Screen>,
}

/// An element of the page.
pub struct Element(String);

impl WebDriver {
    /// Starts a driver, and with it a browser of these capabilities, on a screen if it needs one.
    pub fn start(driver: &str, screen: Option<Screen>, wanted: Value) -> WebDriver {
        let display = screen.as_ref().map(|screen| screen.display.as_str());
        // On a busy machine a driver may end before it has begun, or find its port taken.
        let started = (0..3).find_map(|_| start_driver(driver, display));
        let (driver, port) = started.unwrap_or_else(|| panic!("{driver} does not answer"));
        let mut browser = WebDriver { driver, port, session: String::new(), _screen: screen };
        let session =
            browser.call("POST", "/session", json!({ "capabilities": { "alwaysMatch": wanted } }));
        browser.session = session["sessionId"].as_str().expect("a session").to_string();
        browser
    }

    /// Makes the window this large, its frame included.
    #[track_caller]
    pub fn resize(&self, width: u32, height: u32) {
        self.post("window/rect", json!({ "width": width, "height": height }));
    }

    #[track_caller]
    pub fn open(&self, address: &str) {
        self.post("url", json!({ "url": address }));
    }

    /// Runs a script in the page (its `arguments` are these) and returns what it returns.
    #[track_caller]
    pub fn execute(&self, script: &str, arguments: &[Value]) -> Value {
        self.post("execute/sync", json!({ "script": script, "args": arguments }))
    }

    #[track_caller]
    pub fn find(&self, css: &str) -> Element {
        let found = self.post("element", json!({ "using": "css selector", "value": css }));
        Element(found[ELEMENT].as_str().expect("an element").to_string())
    }

    #[track_caller]
    pub fn click(&self, element: &Element) {
        self.post(&format!("element/{}/click", element.0), json!({}));
    }

    /// Types into an element.
    #[track_caller]
    pub fn type_into(&self, element: &Element, text: &str) {
        self.post(&format!("element/{}/value", element.0), json!({ "text": text }));
    }

    /// Presses and releases keys, one after the other, wherever the focus is.
    #[track_caller]
    pub fn press(&self, keys: &[&str]) {
        let strokes: Vec<Value> = keys
            .iter()
            .flat_map(|key| ["keyDown", "keyUp"].map(|kind| json!({ "type": kind, "value": key })))
            .collect();
        let keyboard = json!({ "type": "key", "id": "keyboard", "actions": strokes });
        self.post("actions", json!({ "actions": [keyboard] }));
    }

    /// Drags with the mouse from the middle of an element.
    #[track_caller]
    pub fn drag(&self, element: &Element, right_px: i32, down_px: i32) {
        let moves = |x: i32, y: i32, origin: Value| {
            json!({
                "type": "pointerMove", "duration": 50, "x": x, "y": y, "origin": origin,
            })
        };
        let strokes = json!([
            moves(0, 0, json!({ ELEMENT: element.0 })),
            { "type": "pointerDown", "button": 0 },
            moves(right_px / 2, down_px / 2, json!("pointer")),
            moves(right_px / 2, down_px / 2, json!("pointer")),
            { "type": "pointerUp", "button": 0 },
        ]);
        let mouse = json!({ "type": "pointer", "id": "mouse", "actions": strokes });
        self.post("actions", json!({ "actions": [mouse] }));
    }

    /// An element as it is on the screen, as a PNG in base 64.
    #[track_caller]
    pub fn screenshot(&self, element: &Element) -> String {
        let path = format!("/session/{}/element/{}/screenshot", self.session, element.0);
        self.call("GET", &path, Value::Null).as_str().expect("a picture").to_string()
    }

    /// A command of the Chrome DevTools Protocol: for Chromium alone.
    #[track_caller]
    pub fn devtools(&self, command: &str, parameters: Value) -> Value {
        self.post("goog/cdp/execute", json!({ "cmd": command, "params": parameters }))
    }

    /// Goes into the first frame of the page, in which scripts run and elements are found from then on.
    #[track_caller]
    pub fn enter_frame(&self) {
        self.post("frame", json!({ "id": 0 }));
    }

    /// Goes back to the page around the frames.
    #[track_caller]
    pub fn leave_frame(&self) {
        self.post("frame", json!({ "id": Value::Null }));
    }

    /// What the console has said since the last call, without mere remarks.
    pub fn complaints(&self) -> Vec<String> {
        self.console(&["SEVERE"])
    }

    /// What the console has said on these levels since the last call. Chromium alone tells it; the others
    /// say nothing.
    pub fn console(&self, levels: &[&str]) -> Vec<String> {
        let log = format!("/session/{}/se/log", self.session);
        let answer = request(self.port, "POST", &log, &json!({ "type": "browser" }));
        let entries = answer.map(|answer| answer["value"].clone()).unwrap_or_default();
        let entries = entries.as_array().cloned().unwrap_or_default();
        entries
            .iter()
            .filter(|entry| levels.iter().any(|level| entry["level"] == *level))
            .map(|entry| entry["message"].as_str().unwrap_or_default().to_string())
            // Of graphics the browser talks to itself.
            .filter(|told| {
                !told.contains("GL Driver Message") && !told.ends_with("No available adapters.")
            })
            .collect()
    }

    #[track_caller]
    fn post(&self, command: &str, body: Value) -> Value {
        self.call("POST", &format!("/session/{}/{command}", self.session), body)
    }

    #[track_caller]
    fn call(&self, method: &str, path: &str, body: Value) -> Value {
        match request(self.port, method, path, &body) {
            Ok(answer) if answer["value"]["error"].is_null() => answer["value"].clone(),
            Ok(answer) => panic!("{method} {path} {body}: {}", answer["value"]["message"]),
            Err(e) => panic!("{method} {path}: the driver does not answer: {e}"),
        }
    }
}

impl Drop for WebDriver {
    fn drop(&mut self) {
        let session = format!("/session/{}", self.session);
        // The driver goes in any case.
        let _ = request(self.port, "DELETE", &session, &Value::Null);
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

/// A port that nobody listens at.
pub fn free_port() -> u16 {
    let free = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr());
    free.expect("a free port").port()
}

/// How long a driver may take until it listens.
const PATIENCE: Duration = Duration::from_secs(20);

/// Starts a driver on a free port; none if it does not begin to answer.
fn start_driver(driver: &str, display: Option<&str>) -> Option<(Child, u16)> {
    let port = free_port();
    let mut command = Command::new(driver);
    command.arg(format!("--port={port}")).stdout(Stdio::null()).stderr(Stdio::null());
    if let Some(display) = display {
        // Without a graphics card the browser's own list of cards would forbid it to draw.
        command.env("DISPLAY", display).env("LIBGL_ALWAYS_SOFTWARE", "1");
    }
    let mut child = command.spawn().unwrap_or_else(|e| panic!("{driver} does not start: {e}"));
    let begun = Instant::now();
    while begun.elapsed() < PATIENCE && matches!(child.try_wait(), Ok(None)) {
        if request(port, "GET", "/status", &Value::Null).is_ok_and(|s| s["value"]["ready"] == true)
        {
            return Some((child, port));
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    let _ = child.kill();
    let _ = child.wait();
    None
}

fn request(port: u16, method: &str, path: &str, body: &Value) -> std::io::Result<Value> {
    let body = if body.is_null() { String::new() } else { body.to_string() };
    let mut stream = TcpStream::connect(("127.0.0.1", port))?;
    write!(
        stream,
        "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\
         Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
        body.len()
    )?;
    let mut reader = BufReader::new(stream);
    let mut length = 0;
    loop {
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let Some((name, value)) = line.trim().split_once(':') else {
            if line.trim().is_empty() {
                break;
            }
            continue;
        };
        if name.eq_ignore_ascii_case("content-length") {
            length = value.trim().parse().map_err(std::io::Error::other)?;
        }
    }
    let mut answer = vec![0; length];
    reader.read_exact(&mut answer)?;
    serde_json::from_slice(&answer).map_err(std::io::Error::other)
}
