//! The Markdown pages of the repository, and their fenced blocks.

use std::fs;
use std::path::{Path, PathBuf};

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README and its translations, what stands beside them, and every page below `docs`, by their paths in the repository.
pub fn pages() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() && path.starts_with(root().join("docs")) {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                found.push(path.strip_prefix(root()).unwrap().to_owned());
            }
        }
        if folder == root() {
            folders = vec![root().join("docs")];
        }
    }
    found.sort();
    assert!(found.len() > 8, "the pages are found: {found:?}");
    found
}

/// The text of a page.
pub fn text(page: &Path) -> String {
    fs::read_to_string(root().join(page)).unwrap()
}

/// What stands on a page, from above.
#[derive(Debug)]
pub enum Piece<'a> {
    /// A line outside of fences, with its number from 1.
    Line(usize, &'a str),
    /// A fenced block: what stands behind its fence, and its lines; the number is that of its first line.
    Fence(usize, &'a str, Vec<&'a str>),
}

/// The pieces of a page.
pub fn pieces(text: &str) -> Vec<Piece<'_>> {
    let (mut pieces, mut lines) = (Vec::new(), text.lines().enumerate());
    while let Some((number, line)) = lines.next() {
        let open = line.trim_start();
        let ticks = open.len() - open.trim_start_matches('`').len();
        if ticks < 3 {
            pieces.push(Piece::Line(number + 1, line));
            continue;
        }
        let (fence, indent) = (&open[..ticks], line.len() - open.len());
        let inside = lines.by_ref().map(|(_, line)| line).take_while(|line| line.trim() != fence);
        let block = inside.map(|line| line.get(indent..).unwrap_or("")).collect();
        pieces.push(Piece::Fence(number + 2, open[ticks..].trim(), block));
    }
    pieces
}
