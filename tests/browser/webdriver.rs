//! As much of the WebDriver protocol (W3C, <https://www.w3.org/TR/webdriver2/>) as these tests need:
//! JSON over HTTP to a chromedriver of our own.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

/// The key under which WebDriver hands out elements.
const ELEMENT: &str = "element-6066-11e4-a52e-4f735466cecf";

/// A browser window; dropping it closes the browser.
pub struct WebDriver {
    driver: Child,
    port: u16,
    session: String,
}

/// An element of the page.
pub struct Element(String);

/// Starts chromedriver; the port that it tells.
fn start_driver(chromedriver: &str) -> Option<(Child, u16)> {
    let mut driver = Command::new(chromedriver)
        .arg("--port=0")
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap_or_else(|e| panic!("{chromedriver} does not start: {e}"));
    let told = BufReader::new(driver.stdout.take().expect("a piped output")).lines();
    let port = told.map_while(Result::ok).find_map(|line| {
        let (_, port) = line.split_once("successfully on port ")?;
        port.trim_end_matches('.').parse().ok()
    });
    if port.is_none() {
        let _ = driver.wait();
    }
    Some((driver, port?))
}

impl WebDriver {
    /// Starts chromedriver and a Chromium with these arguments.
    pub fn start(chromedriver: &str, chromium: &str, arguments: &[&str]) -> WebDriver {
        // On a busy machine chromedriver may end before it has begun.
        let started = (0..3).find_map(|_| start_driver(chromedriver));
        let (driver, port) = started.expect("chromedriver tells its port");
        let mut browser = WebDriver { driver, port, session: String::new() };
        let options = json!({ "binary": chromium, "args": arguments });
        let wanted = json!({
            "goog:chromeOptions": options,
            "goog:loggingPrefs": { "browser": "ALL" },
        });
        let session =
            browser.call("POST", "/session", json!({ "capabilities": { "alwaysMatch": wanted } }));
        browser.session = session["sessionId"].as_str().expect("a session").to_string();
        browser
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

    /// An element as it is on the screen, as a PNG in base 64.
    #[track_caller]
    pub fn screenshot(&self, element: &Element) -> String {
        let path = format!("/session/{}/element/{}/screenshot", self.session, element.0);
        self.call("GET", &path, Value::Null).as_str().expect("a picture").to_string()
    }

    /// A command of the Chrome DevTools Protocol.
    #[track_caller]
    pub fn devtools(&self, command: &str, parameters: Value) -> Value {
        self.post("goog/cdp/execute", json!({ "cmd": command, "params": parameters }))
    }

    /// Goes into the first frame of the page, in which scripts run and elements are found from then on.
    #[track_caller]
    pub fn enter_frame(&self) {
        self.post("frame", json!({ "id": 0 }));
    }

    /// What the console has said since the last call, without mere remarks.
    #[track_caller]
    pub fn complaints(&self) -> Vec<String> {
        self.console(&["SEVERE"])
    }

    /// What the console has said on these levels since the last call.
    #[track_caller]
    pub fn console(&self, levels: &[&str]) -> Vec<String> {
        let entries = self.post("se/log", json!({ "type": "browser" }));
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
            Err(e) => panic!("{method} {path}: chromedriver does not answer: {e}"),
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
