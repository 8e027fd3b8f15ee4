//! The files that a report lists and attaches.

#![expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use sha2::{Digest, Sha256};

use super::document::File;
use super::rules::TooLargeToAttach;
use super::{Attachment, Content, Role, number};
use crate::finding::{Finding, Place, Raise};
use crate::limits::ATTACHED_BYTES;
use crate::typeset::characters::Words;

/// Copies the attachments into the folder, with their SHA-256; files that are too large are only listed.
pub(super) fn files(
    attachments: &[Attachment<'_>],
    folder: &Path,
    words: &mut Words,
    findings: &mut Vec<Finding>,
) -> io::Result<Vec<File>> {
    let mut carried = 0;
    let mut files = Vec::with_capacity(attachments.len());
    for (at, attachment) in attachments.iter().enumerate() {
        let (bytes, sha256) = match attachment.content {
            Content::Bytes(bytes) => (u64::try_from(bytes.len()).unwrap_or(u64::MAX), digest(bytes)?),
            Content::File(path) => (fs::metadata(path)?.len(), digest(fs::File::open(path)?)?),
        };
        let name = file_name(&words.line(&attachment.name));
        let twice = files.iter().any(|file: &File| file.name == name);
        let beside = attachment.role == Role::Beside;
        let copy = (!twice && !beside && bytes <= ATTACHED_BYTES - carried).then(|| format!("attachment-{at}"));
        match &copy {
            Some(copy) => {
                carried += bytes;
                match attachment.content {
                    Content::Bytes(bytes) => fs::write(folder.join(copy), bytes)?,
                    Content::File(path) => fs::copy(path, folder.join(copy)).map(drop)?,
                }
            }
            None if twice || beside => {}
            None => findings.push(TooLargeToAttach { name: name.clone() }.at(Place::File).with(
                format!("{} bytes", number::grouped(bytes)),
                format!("{} bytes", number::grouped(ATTACHED_BYTES)),
            )),
        }
        files.push(File {
            name,
            description: words.text(&attachment.description),
            sha256,
            bytes: number::grouped(bytes),
            mime: attachment.mime,
            relation: if attachment.role == Role::Input { "source" } else { "supplement" },
            carried: copy,
        });
    }
    Ok(files)
}

/// A name that a PDF can carry: no folders, and not only dots.
fn file_name(name: &str) -> String {
    let name = name.replace(['/', '\\'], "_");
    if name.trim_matches('.').is_empty() { "_".to_owned() } else { name }
}

/// SHA-256 in lower-case hexadecimal.
fn digest(mut bytes: impl Read) -> io::Result<String> {
    let mut hash = Sha256::new();
    let mut buffer = [0; 64 * 1024];
    loop {
        let count = match bytes.read(&mut buffer) {
            Ok(0) => break,
            Ok(count) => count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        hash.update(buffer.get(..count).unwrap_or_default());
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::{Language, Text};

    #[test]
    fn what_lies_beside_the_report_is_listed_and_not_carried() {
        let folder = tempfile::tempdir().unwrap();
        let attachment = |name: &str, role| Attachment {
            name: name.to_owned(),
            role,
            mime: "text/plain",
            description: Text::same(name),
            content: Content::Bytes(b"abc"),
        };
        let given = [attachment("a.svg", Role::Result), attachment("a.stl", Role::Beside)];
        let mut findings = Vec::new();
        let listed = files(&given, folder.path(), &mut Words::new(Language::En), &mut findings).unwrap();
        let told: Vec<_> = listed.iter().map(|file| (file.name.as_str(), file.carried.is_some())).collect();
        assert_eq!(told, [("a.svg", true), ("a.stl", false)]);
        assert!(listed.iter().all(|file| file.sha256.starts_with("ba7816bf")), "SHA-256 of abc");
        assert!(findings.is_empty(), "it is not too large");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
