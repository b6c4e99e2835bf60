//! The built page on hosts that people have: nginx as `docs/hosting.md` sets it up, and Python's, which
//! sends no headers of its own. The other tests have a third one, under a path of its own.

use crate::engines::{Graphics, is_left_out, tool};
use crate::page::{Page, skip};
use crate::server::dist;
use crate::three_engines::journey;
use crate::webdriver::free_port;
use serde_json::{Value, json};
use std::fs;
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn the_page_lives_on_nginx() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    let Some(host) = Host::nginx() else { return };
    journey(&page, &host.address);
    // What the guide promises: nothing that has changed is taken from a cache, nothing else is asked twice.
    let answers = |name: &str| answers(&page, name);
    for name in ["./", "offline.js", "posters/croton.avif"] {
        assert_eq!(answers(name)["cache-control"], "no-cache", "{name}");
    }
    let bundle = format!("{}/page_bg.wasm", bundles(&page));
    let wasm = answers(&bundle);
    assert_eq!(wasm["cache-control"], "public, max-age=31536000, immutable");
    assert_eq!(
        (&wasm["content-type"], &wasm["content-encoding"]),
        (&json!("application/wasm"), &json!("gzip"))
    );
    assert_eq!(
        answers("install/manifest.webmanifest")["content-type"],
        "application/manifest+json"
    );
    assert_eq!(answers("posters/croton.avif")["content-type"], "image/avif");
}

#[test]
fn the_page_lives_on_pythons_server() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    let Some(host) = Host::python() else { return };
    journey(&page, &host.address);
}

/// The headers with which the open page's host answers.
fn answers(page: &Page, name: &str) -> Value {
    let script = format!(
        "return fetch('{name}', {{ cache: 'reload' }}).then(answer => {{
             if (!answer.ok) throw new Error('{name}: ' + answer.status);
             return Object.fromEntries(answer.headers)
         }})"
    );
    page.run(&script)
}

fn bundles(page: &Page) -> String {
    let folder = page.run("return document.documentElement.dataset.bundles");
    folder.as_str().expect("a folder").to_string()
}

/// A server that has the built page; dropping it ends it.
struct Host {
    server: Child,
    address: String,
}

impl Host {
    /// With the very lines of the guide.
    fn nginx() -> Option<Host> {
        let nginx = found("nginx", tool("NGINX", &["nginx"]))?;
        let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/hosting.md");
        let guide = fs::read_to_string(guide).expect("a guide");
        let (_, lines) = guide.split_once("```nginx\n").expect("lines for nginx");
        let lines = lines.split("```").next().unwrap_or_default();
        let port = free_port();
        let folder = folder("nginx");
        let server = lines
            .replace("listen 80;", &format!("listen 127.0.0.1:{port};"))
            .replace("/srv/clonal-mosaic/", &format!("{}/", dist().display()));
        // Everything that it writes goes where it may.
        let writes: String = ["client_body", "proxy", "fastcgi", "uwsgi", "scgi"]
            .map(|kind| format!("{kind}_temp_path {}/{kind};\n", folder.display()))
            .concat();
        let types = "/etc/nginx/mime.types";
        let all = format!(
            "daemon off; master_process off; pid {0}/pid; error_log stderr; events {{}}\n\
             http {{ include {types}; access_log off;\n{writes}{server}}}",
            folder.display()
        );
        let file = folder.join("nginx.conf");
        fs::write(&file, all).expect("it can be written");
        Host::start(Command::new(nginx).arg("-c").arg(file), port, "mosaic/")
    }

    fn python() -> Option<Host> {
        let python = found("python3", tool("PYTHON", &["python3"]))?;
        let port = free_port();
        let mut command = Command::new(python);
        command.args([
            "-m",
            "http.server",
            &port.to_string(),
            "--bind",
            "127.0.0.1",
            "--directory",
        ]);
        Host::start(command.arg(dist()), port, "")
    }

    fn start(command: &mut Command, port: u16, path: &str) -> Option<Host> {
        let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
        let mut server = quiet.spawn().expect("a server that starts");
        let begun = Instant::now();
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            assert!(begun.elapsed() < Duration::from_secs(20), "{command:?} does not answer");
            assert!(matches!(server.try_wait(), Ok(None)), "{command:?} has ended");
            std::thread::sleep(Duration::from_millis(50));
        }
        Some(Host { server, address: format!("http://127.0.0.1:{port}/{path}") })
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// A server of this name, or none, which is said; under `./playground test` it must be there unless that
/// found that it cannot be had.
fn found(name: &str, program: Result<String, String>) -> Option<String> {
    let is_required = std::env::var("BROWSER_TESTS").is_ok_and(|wanted| wanted == "required");
    match program {
        Ok(program) => Some(program),
        Err(missing) => {
            assert!(!is_required || is_left_out(name), "{missing}");
            skip(&missing);
            None
        }
    }
}

/// An empty folder of the tests' own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("it can be made");
    folder
}
