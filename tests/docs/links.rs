//! Links of the pages to files and headings of the repository lead somewhere.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::markdown::{Piece, pages, pieces, root, text};

/// The anchor that a heading gets on a code host: small letters, no punctuation, hyphens for blanks.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|one| one.is_alphanumeric() || matches!(one, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|one| if one == ' ' { '-' } else { one }).collect()
}

/// The text of a heading without its marks: links are their words, code is what it says.
fn spoken(heading: &str) -> String {
    let (mut plain, mut rest) = (String::new(), heading);
    while let Some((before, link)) = rest.split_once('[') {
        plain.push_str(before);
        let Some((words, behind)) = link.split_once("](") else {
            rest = link;
            continue;
        };
        plain.push_str(words);
        rest = behind.split_once(')').map_or("", |(_, rest)| rest);
    }
    plain.push_str(rest);
    plain.replace(['`', '*', '\\'], "")
}

/// The anchors of a page.
fn anchors(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for piece in pieces(text) {
        let Piece::Line(_, line) = piece else { continue };
        if let Some(heading) = line.strip_prefix('#') {
            let own = anchor(&spoken(heading.trim_start_matches('#')));
            let often = seen.entry(own.clone()).or_default();
            found.push(if *often == 0 { own } else { format!("{own}-{often}") });
            *often += 1;
        }
        found.extend(line.split("id=\"").skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned));
    }
    found
}

/// Where the links and pictures of a line lead.
fn targets(line: &str) -> Vec<String> {
    // What stands as code is no link.
    let plain: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
    let linked = plain.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next().map(str::to_owned));
    let drawn = ["src=\"", "href=\""].into_iter().flat_map(|mark| {
        plain.split(mark).skip(1).filter_map(|rest| rest.split('"').next().map(str::to_owned)).collect::<Vec<_>>()
    });
    linked.chain(drawn).collect()
}

/// A path without `.` and `..`.
fn resolved(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    plain
}

#[test]
fn every_link_leads_to_a_file_and_a_heading_that_is_there() {
    let (mut faults, mut followed) = (Vec::new(), 0);
    for page in pages() {
        let text_of_page = text(&page);
        for piece in pieces(&text_of_page) {
            let Piece::Line(number, line) = piece else { continue };
            for target in targets(line) {
                if target.contains("://") || target.starts_with("mailto:") {
                    continue;
                }
                followed += 1;
                let (file, heading) = target.split_once('#').unwrap_or((&target, ""));
                let meant = if file.is_empty() {
                    page.clone()
                } else {
                    resolved(&page.parent().unwrap_or(Path::new("")).join(file))
                };
                let mut fault = |what: &str| faults.push(format!("{}:{number}: {target}: {what}", page.display()));
                if !root().join(&meant).exists() {
                    fault("no such file");
                } else if !heading.is_empty() && !anchors(&text(&meant)).iter().any(|one| one == heading) {
                    fault("no such heading");
                }
            }
        }
    }
    assert!(followed > 10, "links are found: {followed}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn headings_and_links_are_read_as_a_code_host_reads_them() {
    assert_eq!(
        anchors("# Exit codes\n```\n# no heading\n```\n## `--json`: what [it](a.md) says\n# Exit codes"),
        ["exit-codes", "--json-what-it-says", "exit-codes-1"]
    );
    assert_eq!(
        targets("[a](b.md#c), `[no](x)` and ![d](e.png \"f\") <img src=\"g.png\">"),
        ["b.md#c", "e.png", "g.png"]
    );
    assert_eq!(resolved(Path::new("docs/en/../dev/./a.md")), Path::new("docs/dev/a.md"));
}
