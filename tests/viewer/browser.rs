//! Chromium without a screen, driven over WebDriver: chromedriver and a small HTTP client.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;

/// How long a page may take for anything.
const DEADLINE: Duration = Duration::from_secs(60);

/// True where Chromium and its driver can be called. Where they must be there, their absence fails the test.
pub fn chromium() -> bool {
    let there = |name: &str| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success());
    let found = there("chromium") && there("chromedriver");
    if !found {
        assert!(std::env::var_os("CI").is_none(), "chromium and chromedriver are needed here and cannot be called");
        // Not through the macros, whose output a passing test keeps to itself.
        let _ = writeln!(
            std::io::stderr(),
            "\n*** chromium or chromedriver is not installed: NOT TESTED that the viewer draws and plays ***\n"
        );
    }
    found
}

/// A browser with one page.
pub struct Browser {
    driver: Child,
    port: u16,
    session: String,
    _profile: TempDir,
}

impl Browser {
    /// Starts one. `webgl`: false for a browser without it.
    pub fn start(webgl: bool) -> Self {
        let profile = tempfile::tempdir().expect("a temporary folder");
        let mut driver = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("chromedriver can be called");
        let mut lines = BufReader::new(driver.stdout.take().expect("its output")).lines();
        let port = lines
            .by_ref()
            .map(|line| line.expect("a line of chromedriver"))
            .find_map(|line| line.split_once("started successfully on port ")?.1.trim_end_matches('.').parse().ok())
            .expect("chromedriver names its port");
        // What it says later must not fill the pipe.
        std::thread::spawn(move || lines.count());
        let mut arguments: Vec<String> = [
            "--headless=new",
            "--no-sandbox",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            "--force-color-profile=srgb",
            "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1",
            // Small: every frame is drawn by software.
            "--window-size=840,560",
            "--force-device-scale-factor=0.5",
        ]
        .map(str::to_owned)
        .into();
        arguments.push(format!("--user-data-dir={}", profile.path().display()));
        arguments.extend(
            if webgl {
                ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
            } else {
                ["--disable-gpu", "--disable-3d-apis"]
            }
            .map(str::to_owned),
        );
        let mut browser = Self { driver, port, session: String::new(), _profile: profile };
        let wanted = json!({ "capabilities": { "alwaysMatch": {
            "browserName": "chrome",
            "goog:chromeOptions": { "args": arguments },
            "goog:loggingPrefs": { "browser": "ALL" },
            "timeouts": { "script": 60_000, "pageLoad": 60_000 },
        } } });
        let made = browser.call("POST", "/session", &wanted);
        browser.session = made["sessionId"].as_str().expect("a session").to_owned();
        browser
    }

    fn call(&self, method: &str, path: &str, body: &Value) -> Value {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("chromedriver listens");
        stream.set_read_timeout(Some(DEADLINE * 2)).expect("a deadline");
        let body = if method == "POST" { body.to_string() } else { String::new() };
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Type: application/json\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
            self.port,
            body.len()
        );
        stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(body.as_bytes())).expect("a request");
        let mut reader = BufReader::new(stream);
        let (mut line, mut length) = (String::new(), None);
        while reader.read_line(&mut line).is_ok_and(|read| read > 2) {
            if let Some(value) = line.to_lowercase().strip_prefix("content-length:") {
                length = value.trim().parse::<usize>().ok();
            }
            line.clear();
        }
        let mut answer = vec![0; length.expect("a length")];
        reader.read_exact(&mut answer).expect("the whole answer");
        let answer: Value = serde_json::from_slice(&answer).expect("JSON");
        let value = answer["value"].clone();
        assert!(value.get("error").is_none(), "{method} {path}: {value}");
        value
    }

    fn post(&self, command: &str, body: &Value) -> Value {
        self.call("POST", &format!("/session/{}/{command}", self.session), body)
    }

    /// Opens a file with something behind its `#`, and waits until it is drawn.
    pub fn open(&self, file: &Path, fragment: &str) -> Value {
        // A page whose address differs in its fragment only is not loaded again.
        self.post("url", &json!({ "url": "about:blank" }));
        self.post("url", &json!({ "url": format!("file://{}#{fragment}", file.display()) }));
        self.until("it is drawn", |status| status["loaded"].as_f64() > Some(0.0))
    }

    /// Runs a script and gives what it returns.
    pub fn run(&self, script: &str) -> Value {
        self.post("execute/sync", &json!({ "script": script, "args": [] }))
    }

    /// What the page says of itself after the next frame.
    pub fn status(&self) -> Value {
        let script = "const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(() => done(document.getElementById('status').textContent)));";
        let text = self.post("execute/async", &json!({ "script": script, "args": [] }));
        serde_json::from_str(text.as_str().unwrap_or_default()).unwrap_or_default()
    }

    /// Waits for a status.
    pub fn until(&self, what: &str, met: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let status = self.status();
            if met(&status) {
                return status;
            }
            assert!(began.elapsed() < DEADLINE, "not within the deadline: {what}: {status} {:?}", self.console());
        }
    }

    /// Types keys, as WebDriver names them.
    pub fn keys(&self, keys: &[&str]) -> Value {
        let actions: Vec<Value> = keys
            .iter()
            .flat_map(|key| [json!({ "type": "keyDown", "value": key }), json!({ "type": "keyUp", "value": key })])
            .collect();
        self.post("actions", &json!({ "actions": [{ "type": "key", "id": "keys", "actions": actions }] }));
        self.status()
    }

    /// Clicks on an element.
    pub fn click(&self, css: &str) -> Value {
        let found = self.post("element", &json!({ "using": "css selector", "value": css }));
        let id = found.as_object().and_then(|found| found.values().next()).and_then(Value::as_str).expect("an element");
        self.post(&format!("element/{id}/click"), &json!({}));
        self.status()
    }

    /// A command of Chromium's own protocol.
    pub fn developer(&self, command: &str, parameters: &Value) -> Value {
        self.post("goog/cdp/execute", &json!({ "cmd": command, "params": parameters }))
    }

    /// The page's size in pixels of CSS.
    pub fn resize(&self, width: u32, height: u32) {
        let phone = width < 760;
        self.developer(
            "Emulation.setDeviceMetricsOverride",
            &json!({ "width": width, "height": height, "deviceScaleFactor": if phone { 2 } else { 1 }, "mobile": phone }),
        );
    }

    /// A picture of the page, kept as a file for whoever wants to look; how many of its pixels have how many colours, within
    /// a rectangle given in shares of its width and height.
    pub fn picture(&self, file: &Path, part: [f64; 4]) -> Vec<(String, u64)> {
        let shot = self.call("GET", &format!("/session/{}/screenshot", self.session), &Value::Null);
        let coded = shot.as_str().expect("a picture");
        std::fs::write(file, decoded(coded)).expect("a picture to write");
        let script = "const [coded, [x, y, w, h], done] = arguments, image = new Image();
            image.onload = () => {
              const canvas = document.createElement('canvas'), context = canvas.getContext('2d');
              Object.assign(canvas, { width: image.width, height: image.height });
              context.drawImage(image, 0, 0);
              const px = context.getImageData(x * image.width, y * image.height, w * image.width, h * image.height).data;
              const counts = new Map();
              for (let at = 0; at < px.length; at += 4) {
                const key = [px[at] >> 4, px[at + 1] >> 4, px[at + 2] >> 4].map((v) => v.toString(16)).join('');
                counts.set(key, (counts.get(key) ?? 0) + 1);
              }
              done([...counts].sort((one, other) => other[1] - one[1]));
            };
            image.src = 'data:image/png;base64,' + coded;";
        let counts = self.post("execute/async", &json!({ "script": script, "args": [coded, part] }));
        let one = |pair: &Value| Some((pair[0].as_str()?.to_owned(), pair[1].as_u64()?));
        counts.as_array().into_iter().flatten().filter_map(one).collect()
    }

    /// What the page has written on the console since it was asked last.
    pub fn console(&self) -> Vec<String> {
        let log = self.post("se/log", &json!({ "type": "browser" }));
        log.as_array().into_iter().flatten().map(|entry| entry["message"].to_string()).collect()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // Not through `call`, which fails the test: it may be failing already.
        if let Ok(mut stream) = TcpStream::connect(("127.0.0.1", self.port)) {
            let _ = stream.set_read_timeout(Some(Duration::from_secs(20)));
            let _ = write!(
                stream,
                "DELETE /session/{} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n",
                self.session
            );
            let _ = stream.read(&mut [0; 64]);
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

fn decoded(base64: &str) -> Vec<u8> {
    let value = |byte: u8| match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let letters: Vec<u8> = base64.bytes().filter(|byte| !byte.is_ascii_whitespace() && *byte != b'=').collect();
    letters
        .chunks(4)
        .flat_map(|chunk| {
            let group =
                chunk.iter().fold(0_u32, |group, byte| group << 6 | u32::from(value(*byte))) << (6 * (4 - chunk.len()));
            group.to_be_bytes()[1..chunk.len()].to_vec()
        })
        .collect()
}
