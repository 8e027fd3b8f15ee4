//! What the pages in Markdown have in common.

use std::fmt::Write;

use crate::escape::printable;
use crate::text::{Language, Text};

/// Text in which nothing is Markdown.
pub(super) fn plain(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for one in printable(text).chars() {
        if matches!(one, '*' | '_' | '<' | '>' | '`' | '[' | ']' | '|' | '\\' | '#') {
            shown.push('\\');
        }
        shown.push(one);
    }
    shown
}

/// A page's title and what it is.
pub(super) fn headed(title: &Text, about: &Text, language: Language) -> String {
    format!("# {}\n\n{}\n", title.get(language), about.get(language))
}

/// The first rows of a table.
pub(super) fn write_head(page: &mut String, rule: &str, heads: &[&str]) {
    let _ = write!(page, "\n| {} |\n{rule}\n", heads.join(" | "));
}
