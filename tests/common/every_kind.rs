//! Every command on every case of every kind in both languages, by the binary that knows them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Output;

use calamine::{Data, Reader, Xlsx, open_workbook};
use rodete::cli::rows;
use rodete::kind::Kind;
use rodete::parameter::Case;
use rodete::text::Language;
use serde_json::Value as Json;

/// A binary, run in a folder with `KEPT` naming it.
pub type Run<'a> = &'a dyn Fn(&Path, &[&str]) -> Output;

fn done(run: Run<'_>, folder: &Path, words: &[&str]) -> String {
    let Output { status, stdout, stderr } = run(folder, words);
    assert!(status.success(), "{words:?}: {status}\n{}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).unwrap()
}

/// Runs every command.
pub fn every_command(kinds: &[&dyn Kind], run: Run<'_>) {
    let place = tempfile::tempdir().unwrap();
    let version = done(run, place.path(), &["--version"]);
    for kind in kinds {
        let form = kind.form();
        assert!(version.contains(&format!("workbook {}: schema {}", form.kind, form.schema)), "{version}");
        for case in kind.cases() {
            for language in Language::ALL {
                book(*kind, case, language, run);
            }
        }
    }
    explained(kinds, run, place.path());
}

/// What is made of a new workbook.
fn book(kind: &dyn Kind, case: &Case, language: Language, run: Run<'_>) {
    let place = tempfile::tempdir().unwrap();
    let (form, folder) = (kind.form(), place.path());
    let done = |words: &[&str]| done(run, folder, words);
    done(&["new", form.kind, "book.xlsx", "--case", case.name, "--lang", language.code()]);
    let checked: Json = serde_json::from_str(&done(&["check", "book.xlsx", "--json"])).unwrap();
    let quantities = checked["workbooks"][0]["quantities"].as_array().unwrap();
    assert!(!quantities.is_empty(), "{kind:?} {}: {checked}", case.name);
    // Half of the way in each language.
    if language == Language::Es {
        done(&["view", "book.xlsx", "-o", "page.html"]);
        let page = fs::read_to_string(folder.join("page.html")).unwrap();
        let headed = page.contains("<title>") && !page.contains("<title></title>");
        assert!(headed && page.contains("default-src 'none'"), "{kind:?} {}", case.name);
        return;
    }

    // A stand-in for typst keeps what the report is made of.
    let keeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typst/keeps.sh");
    let report = if cfg!(unix) { ["--typst", keeps.to_str().unwrap()].to_vec() } else { vec!["--no-report"] };
    done(&[vec!["build", "book.xlsx", "-o", "out"], report].concat());
    let names: Vec<_> = fs::read_dir(folder.join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let programs: Vec<_> = names.iter().filter(|name| name.ends_with(".nc")).cloned().collect();
    let known = |name: &String| form.programs.iter().any(|key| *name == format!("book-{key}.nc"));
    assert!(!programs.is_empty() && programs.iter().all(known), "{kind:?} {}: {names:?}", case.name);
    for drawing in form.drawings {
        assert!(names.contains(&format!("book-{drawing}.dxf")), "{kind:?} {}: {names:?}", case.name);
    }
    for (solid, _) in form.solids {
        assert!(names.contains(&format!("book-{solid}.stl")), "{kind:?} {}: {names:?}", case.name);
    }
    assert_eq!(names.contains(&"book-viewer.html".to_owned()), form.viewer, "{kind:?} {}: {names:?}", case.name);
    // The first sheet of the results lists the files beside it, and no other.
    let mut results: Xlsx<std::io::BufReader<fs::File>> = open_workbook(folder.join("out/book-results.xlsx")).unwrap();
    let first = results.worksheet_range_at(0).unwrap().unwrap();
    let row = first.rows().find(|row| row[0] == Data::String("Files".to_owned())).unwrap();
    let listed = row[1].to_string();
    let listed: BTreeSet<_> = listed.lines().filter_map(|line| line.split_once(": ")).map(|(name, _)| name).collect();
    let beside = names.iter().map(String::as_str).filter(|name| *name != "book-results.xlsx").collect();
    assert_eq!(listed, beside, "{kind:?} {}", case.name);
    #[cfg(unix)]
    {
        let contents: Json =
            serde_json::from_slice(&fs::read(folder.join("report.typ/contents.json")).unwrap()).unwrap();
        assert_eq!((&contents["kind"], &contents["language"]), (&form.kind.into(), &language.code().into()));
        assert!(contents["tables"].as_array().unwrap().len() > 1, "{kind:?} {}", case.name);
        assert!(folder.join("report.typ/kind/setup.typ").exists(), "its chapters stand beside the templates");
    }
    // The results are an input again.
    done(&["check", "out/book-results.xlsx"]);
}

/// Every row of these kinds, and none of another.
fn explained(kinds: &[&dyn Kind], run: Run<'_>, folder: &Path) {
    for language in Language::ALL {
        let page = done(run, folder, &["explain", "--all", "--markdown", "--lang", language.code()]);
        let told: Vec<_> = page.lines().filter_map(|line| line.strip_prefix("### ")).map(str::to_owned).collect();
        let rows: Vec<_> = rows(kinds).into_iter().map(|rule| format!("{} {}", rule.code, rule.name())).collect();
        assert_eq!(told, rows);
        let own: Vec<_> = kinds.iter().flat_map(|kind| kind.rules()).copied().flatten().collect();
        let codes: Vec<_> = own.iter().map(|rule| rule.code).collect();
        let told = done(run, folder, &[&["explain", "--lang", language.code()], &codes[..]].concat());
        for rule in own {
            assert!(told.contains(&rule.name()) && told.contains(rule.why.get(language)), "{told}");
            assert!(rows.contains(&format!("{} {}", rule.code, rule.name())), "{}", rule.code);
        }
    }
}
