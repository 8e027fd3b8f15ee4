//! One Spanish term for a thing: the words that the list of words gave up stand in no Spanish text.

use std::fs;
use std::path::{Path, PathBuf};

use crate::markdown::{pages, root, text};

/// Terms that are given up, in small letters; each is in the list's column of words that are not so.
const GIVEN_UP: &[&str] =
    &["ranuradora", "cuchilla", "lama", "sobremetal", "micrómetro", "fresa plana", "fresa cilíndrica", "fresa de bola"];

/// Words of lists that a Spanish form does not offer: a page says what stands in the cell.
const OF_THE_ENGLISH_FORM: &[&str] = &[
    "method = clear",
    "method = published",
    "style = full",
    "style = annex",
    "splitter_fade = each-side",
    "rotary = linear",
];

/// True of a text that has the term as words of its own, in one number or the other.
fn has(text: &str, term: &str) -> bool {
    text.match_indices(term).any(|(at, _)| {
        let after = text[at + term.len()..].trim_start_matches('s');
        !text[..at].ends_with(char::is_alphanumeric) && !after.starts_with(char::is_alphanumeric)
    })
}

/// A text in small letters, each run of blanks one blank.
fn plain(text: &str) -> String {
    text.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ")
}

fn below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            below(&path, found);
        } else if path
            .extension()
            .is_some_and(|extension| ["rs", "js", "tsv", "typ"].iter().any(|one| extension == *one))
        {
            found.push(path);
        }
    }
}

/// The pages but for the list itself and the history.
fn read() -> Vec<(PathBuf, String)> {
    let unread = |page: &PathBuf| page.ends_with("words.md") || page.ends_with("CHANGELOG.md");
    let mut read: Vec<_> =
        pages().into_iter().filter(|page| !unread(page)).map(|page| (page.clone(), text(&page))).collect();
    let mut sources = Vec::new();
    ["src", "report-templates"].iter().for_each(|folder| below(&root().join(folder), &mut sources));
    assert!(sources.len() > 100, "the sources are found");
    read.extend(sources.into_iter().map(|path| (path.clone(), fs::read_to_string(&path).unwrap())));
    read
}

#[test]
fn a_term_that_is_given_up_stands_in_no_text() {
    let list = text(Path::new("docs/dev/words.md"));
    let not_so = list.lines().filter_map(|line| line.trim_end_matches('|').rsplit('|').next()).collect::<Vec<_>>();
    for term in GIVEN_UP {
        assert!(not_so.iter().any(|cell| has(cell, term)), "{term} is not in the list of words");
    }
    for (path, text) in read() {
        let text = plain(&text);
        let found: Vec<_> = GIVEN_UP.iter().filter(|term| has(&text, term)).collect();
        assert!(found.is_empty(), "{}: {found:?}; docs/dev/words.md says the word", path.display());
    }
}

#[test]
fn spanish_pages_name_the_words_that_the_spanish_form_offers() {
    for page in pages().into_iter().filter(|page| page.starts_with("docs/es") || page.ends_with("README.es.md")) {
        let text = plain(&text(&page)).replace('`', "");
        let found: Vec<_> = OF_THE_ENGLISH_FORM.iter().filter(|words| has(&text, words)).collect();
        assert!(found.is_empty(), "{}: {found:?}", page.display());
    }
}

#[test]
fn a_term_is_found_as_words_of_its_own() {
    assert!(has("una lama.", "lama") && has("las lamas", "lama") && has("lama", "lama"));
    assert!(!has("se llama", "lama") && !has("lamada", "lama") && !has("", "lama"));
}
