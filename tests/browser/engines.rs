//! The browsers that the tests drive: where they are, and how each starts with something to draw with
//! on a machine without a graphics card.

use crate::webdriver::WebDriver;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// What Chromium has to draw with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Graphics {
    WebGpu,
    WebGl2,
    Neither,
}

/// A browser engine. Firefox and WebKit find no adapter for WebGPU without a graphics card, so they draw
/// with WebGL2, on a screen of their own that nobody sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    Chromium(Graphics),
    Firefox,
    WebKit,
}

impl From<Graphics> for Engine {
    fn from(graphics: Graphics) -> Engine {
        Engine::Chromium(graphics)
    }
}

impl Engine {
    pub fn name(self) -> &'static str {
        match self {
            Engine::Chromium(_) => "Chromium",
            Engine::Firefox => "Firefox",
            Engine::WebKit => "WebKit",
        }
    }

    /// What the page draws with here.
    pub fn backend(self) -> &'static str {
        match self {
            Engine::Chromium(Graphics::WebGpu) => "webgpu",
            Engine::Chromium(Graphics::Neither) => "none",
            _ => "webgl2",
        }
    }

    /// Whether `./playground` said that this machine cannot have it.
    pub fn is_given_up(self) -> bool {
        is_left_out(self.name())
    }

    /// Starts it; in an error, what is missing for that.
    pub fn start(self) -> Result<WebDriver, String> {
        match self {
            Engine::Chromium(graphics) => start_chromium(graphics),
            Engine::Firefox => start_firefox(),
            Engine::WebKit => start_webkit(),
        }
    }
}

const CHROMIUM_ARGUMENTS: [&str; 10] = [
    "--headless=new",
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--force-device-scale-factor=1",
    "--window-size=1280,800",
];

impl Graphics {
    /// Without a graphics card a WebGPU canvas loses its device unless all of these are given.
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Graphics::WebGpu => &[
                "--enable-unsafe-webgpu",
                "--use-webgpu-adapter=swiftshader",
                "--enable-features=Vulkan",
                "--use-vulkan=swiftshader",
                "--use-angle=swiftshader",
            ],
            Graphics::WebGl2 => &["--enable-unsafe-swiftshader"],
            Graphics::Neither => &["--disable-gpu", "--disable-3d-apis"],
        }
    }
}

fn start_chromium(graphics: Graphics) -> Result<WebDriver, String> {
    let driver = tool("CHROMEDRIVER", &["chromedriver"])?;
    let binary = tool(
        "CHROMIUM",
        &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"],
    )?;
    let arguments = [&CHROMIUM_ARGUMENTS, graphics.arguments()].concat();
    let wanted = json!({
        "goog:chromeOptions": { "binary": binary, "args": arguments },
        "goog:loggingPrefs": { "browser": "ALL" },
    });
    Ok(WebDriver::start(&driver, None, wanted))
}

fn start_firefox() -> Result<WebDriver, String> {
    let driver = tool("GECKODRIVER", &["geckodriver"])?;
    let binary = tool("FIREFOX", &["firefox-esr", "firefox"])?;
    // Headless it has no WebGL2, and without this it refuses to draw with software.
    let preferences = json!({ "webgl.force-enabled": true });
    let wanted = json!({ "moz:firefoxOptions": { "binary": binary, "prefs": preferences } });
    Ok(start_on_screen(&driver, Screen::start()?, wanted))
}

fn start_webkit() -> Result<WebDriver, String> {
    let driver = tool("WEBKIT_DRIVER", &["WebKitWebDriver"])?;
    let binary = tool("WEBKIT", &["MiniBrowser"])?;
    let options = json!({ "binary": binary, "args": ["--automation"] });
    let wanted = json!({ "browserName": "MiniBrowser", "webkitgtk:browserOptions": options });
    Ok(start_on_screen(&driver, Screen::start()?, wanted))
}

fn start_on_screen(driver: &str, screen: Screen, wanted: Value) -> WebDriver {
    let browser = WebDriver::start(driver, Some(screen), wanted);
    browser.resize(1280, 900);
    browser
}

/// A screen without a machine, for browsers that draw in windows only; dropping it ends it.
pub struct Screen {
    server: Child,
    /// Its name, as the environment variable `DISPLAY` has it.
    pub display: String,
}

impl Screen {
    fn start() -> Result<Screen, String> {
        let mut server = Command::new(tool("XVFB", &["Xvfb"])?)
            // It takes the first number that is free, and tells it.
            .args(["-displayfd", "1", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|e| format!("Xvfb does not start: {e}"))?;
        let mut number = String::new();
        let told = server.stdout.take().expect("a piped output");
        let _ = BufReader::new(told).read_line(&mut number);
        let screen = Screen { server, display: format!(":{}", number.trim()) };
        if number.trim().is_empty() {
            return Err("Xvfb has no screen to give".to_string());
        }
        Ok(screen)
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Whether `./playground` found that something cannot be had here.
pub fn is_left_out(name: &str) -> bool {
    let left_out = std::env::var("LEFT_OUT").unwrap_or_default();
    left_out.split_whitespace().any(|other| other == name)
}

/// A program: named by an environment variable, or by one of these names on the PATH or in the folders
/// where Debian's packages hide servers and WebKit's browser.
pub fn tool(variable: &str, names: &[&str]) -> Result<String, String> {
    if let Ok(path) = std::env::var(variable) {
        return Ok(path);
    }
    let path = std::env::var_os("PATH").unwrap_or_default();
    let hidden = format!("/usr/lib/{}-linux-gnu/webkit2gtk-4.1", std::env::consts::ARCH);
    std::env::split_paths(&path)
        .chain(["/usr/sbin".into(), hidden.into()])
        .flat_map(|folder| names.iter().map(move |name| folder.join(name)))
        .find(|file| Path::is_file(file))
        .map(|file| file.to_string_lossy().into_owned())
        .ok_or_else(|| format!("there is no {} on the PATH, nor in ${variable}", names[0]))
}
