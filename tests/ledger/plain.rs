//! Outputs in the form in which they are compared: without the sums of other files, which have lines of their own.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::golden::hexadecimal;

/// What a finding says. What else a document comes to say of one is no matter of the ledger.
const FINDING: [&str; 7] = ["grade", "name", "what", "place", "value", "limit", "remedy"];

/// The SHA-256 sums that may stand in outputs: whole, or in two halves as at the head of a program.
#[derive(Default)]
pub struct Sums(BTreeMap<String, String>);

impl Sums {
    /// Takes a file's sum.
    pub fn take(&mut self, name: &str, bytes: &[u8]) {
        let sum = hexadecimal(bytes);
        let (first, second) = sum.split_at(32);
        for (part, of) in [(first, "first half of the "), (second, "second half of the "), (sum.as_str(), "")] {
            self.0.insert(part.to_owned(), format!("<{of}sum of {name}>"));
        }
    }

    /// The text with each sum replaced by the name of its file.
    pub fn named(&self, text: &[u8]) -> Vec<u8> {
        let digit = |byte: &u8| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
        let mut plain = Vec::with_capacity(text.len());
        for run in text.chunk_by(|one, next| digit(one) == digit(next)) {
            let name = if matches!(run.len(), 32 | 64) { str::from_utf8(run).ok() } else { None };
            plain.extend_from_slice(name.and_then(|run| self.0.get(run)).map_or(run, |name| name.as_bytes()));
        }
        plain
    }

    /// A document of JSON with each sum replaced, its keys sorted, without the version and the sizes of files.
    pub fn json(&self, text: &[u8]) -> Vec<u8> {
        let document = serde_json::from_slice(text);
        let mut document: Value = document.unwrap_or_else(|why| panic!("{why}: {}", String::from_utf8_lossy(text)));
        self.value(&mut document)
    }

    /// A part of a document, likewise.
    pub fn value(&self, part: &mut Value) -> Vec<u8> {
        settle(part);
        self.named(serde_json::to_string_pretty(part).unwrap().as_bytes())
    }
}

fn settle(value: &mut Value) {
    match value {
        Value::Object(object) => {
            // Version and schema of a document.
            if object.remove("rodete").is_some() {
                object.remove("schema");
            }
            if object.contains_key("sha256") {
                object.remove("bytes");
            }
            if object.contains_key("grade") && object.contains_key("what") {
                // The name goes with the code; only the alarms' names stood here before other rows had any.
                let alarm = object.get("alarm").is_some_and(Value::is_string);
                let named =
                    object.get("code").and_then(Value::as_str).is_none_or(|code| alarm && code.starts_with('L'));
                object.retain(|key, _| FINDING.contains(&key.as_str()) && (named || key != "name"));
            }
            object.values_mut().for_each(settle);
        }
        Value::Array(values) => values.iter_mut().for_each(settle),
        _ => {}
    }
}

/// A page of the viewer taken apart: its scene, and the page without it.
pub fn page(html: &[u8]) -> (Vec<u8>, Vec<u8>) {
    let text = str::from_utf8(html).unwrap();
    let (before, rest) = text.split_once("id=\"scene\">").unwrap();
    let (scene, after) = rest.split_once("</script>").unwrap();
    (scene.as_bytes().to_vec(), format!("{before}{after}").into_bytes())
}
