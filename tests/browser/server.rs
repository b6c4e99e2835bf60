//! A static host, as simple as the simplest that the page must live on.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// Serves a folder under `http://127.0.0.1:PORT/a/sub/path/` until the tests end, and remembers what
/// it was asked for.
pub struct Server {
    port: u16,
    requested: Arc<Mutex<Vec<String>>>,
    is_down: Arc<AtomicBool>,
}

/// The page must not mind where on a host it lies.
const PREFIX: &str = "/a/sub/path/";

impl Server {
    pub fn start(folder: &Path) -> Server {
        Server::with_headers(folder, "")
    }

    /// The same with lines of headers of its own, each with its line end.
    pub fn with_headers(folder: &Path, headers: &str) -> Server {
        Server::answering(folder, &format!("Cache-Control: max-age=600\r\n{headers}"))
    }

    /// Lets the browser keep nothing in its own cache.
    pub fn without_caching(folder: &Path) -> Server {
        Server::answering(folder, "Cache-Control: no-store\r\n")
    }

    fn answering(folder: &Path, headers: &str) -> Server {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a free port");
        let port = listener.local_addr().expect("a bound address").port();
        let requested = Arc::new(Mutex::new(Vec::new()));
        let (folder, log) = (folder.to_path_buf(), requested.clone());
        let headers = headers.to_string();
        let is_down = Arc::new(AtomicBool::new(false));
        let hangs_up = is_down.clone();
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                if hangs_up.load(Ordering::Relaxed) {
                    continue;
                }
                let (folder, log, headers) = (folder.clone(), log.clone(), headers.clone());
                // A browser that hangs up is no concern of ours.
                std::thread::spawn(move || answer(stream, &folder, &log, &headers));
            }
        });
        Server { port, requested, is_down }
    }

    /// From now on nobody gets an answer, as without a network.
    pub fn go_down(&self) {
        self.is_down.store(true, Ordering::Relaxed);
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}{PREFIX}", self.port)
    }

    /// The files that were asked for so far, without their queries. What the browser has in its
    /// cache it does not ask for again.
    pub fn requested(&self) -> Vec<String> {
        self.requested.lock().expect("no answer panics").clone()
    }
}

fn answer(
    mut stream: TcpStream,
    folder: &Path,
    log: &Mutex<Vec<String>>,
    headers: &str,
) -> std::io::Result<()> {
    let mut lines = BufReader::new(stream.try_clone()?).lines();
    let request = lines.next().unwrap_or(Ok(String::new()))?;
    while lines.next().is_some_and(|line| line.is_ok_and(|line| !line.is_empty())) {}
    let target = request.split(' ').nth(1).unwrap_or("/");
    let path = target.split('?').next().unwrap_or("");
    let content = path.strip_prefix(PREFIX).and_then(|name| {
        log.lock().expect("no answer panics").push(name.to_string());
        let name = if name.is_empty() { "index.html" } else { name };
        let file = folder.join(name);
        let within =
            Path::new(name).components().all(|c| matches!(c, std::path::Component::Normal(_)));
        let bytes = if within { fs::read(&file).ok()? } else { return None };
        Some((media_type(&file), bytes))
    });
    let (status, kind, bytes) = match content {
        Some((kind, bytes)) => ("200 OK", kind, bytes),
        None => ("404 Not Found", "text/plain", b"not here".to_vec()),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\
         Connection: close\r\n{headers}\r\n",
        bytes.len()
    )?;
    stream.write_all(&bytes)
}

fn media_type(file: &Path) -> &'static str {
    match file.extension().and_then(|e| e.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript",
        Some("wasm") => "application/wasm",
        Some("css") => "text/css",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("avif") => "image/avif",
        Some("ico") => "image/x-icon",
        Some("txt") => "text/plain",
        Some("webmanifest" | "json") => "application/json",
        _ => "application/octet-stream",
    }
}

/// The built page.
pub fn dist() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("dist")
}
