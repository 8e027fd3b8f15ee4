//! Any number of books of others: `RODETE_BOOKS=FOLDER cargo test --test graft corpus -- --ignored --nocapture`.

use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

use rodete::graft::Host;
use rodete::kinds::KINDS;
use rodete::workbook::names::Present;

use super::made::{Results, differing, host, parts, read, said, values, with_form};

/// Parts that are the same but for those that a graft edits.
fn kept(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let edited = |name: &str, content: &[u8]| {
        let (name, head) =
            (name.to_lowercase(), String::from_utf8_lossy(&content[..content.len().min(3_000)]).into_owned());
        name.contains("rodete-")
            || name.contains("calcchain")
            || name == "[content_types].xml"
            || name.ends_with("workbook.xml.rels")
            || head.contains("workbook xmlns")
            || head.contains(":workbook ")
            || head.contains("<workbook ")
            || head.contains("styleSheet")
    };
    parts(bytes).into_iter().filter(|(name, content)| !edited(name, content)).collect()
}

/// What came of one book.
fn tried(bytes: &[u8], known: &mut BTreeMap<String, Results>) -> Result<(), String> {
    Host::open(bytes).map_err(|refusal| said(&refusal))?;
    let formed = with_form(KINDS[0], bytes);
    let present = Present { taken: Vec::new(), ..host(&formed).present() };
    let filled = read(&formed);
    let clash = host(bytes).present().taken.join("|").to_lowercase();
    let plain = ![
        "annex", "data", "summary", "charts", "incr", "checks", "calib", "blank", "splitter", "views", "verif", "inter",
    ]
    .iter()
    .any(|word| clash.contains(word));
    let key = if plain { format!("{:?} {present:?}", filled.values.cells) } else { clash };
    let results = known.entry(key).or_insert_with(|| Results::of(&formed));
    let built = results.put_into(&formed);
    assert_eq!(differing(&kept(bytes), &kept(&built)), Vec::<String>::new());
    assert_eq!(values(&built, results.sheets()), values(&results.bytes, results.sheets()));
    let again = results.put_into(&built);
    assert!(again == built, "the second time other bytes");
    Ok(())
}

fn books(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            books(&path, found);
        } else if path.extension().is_some_and(|one| one == "xlsx" || one == "xlsm") {
            found.push(path);
        }
    }
}

#[test]
#[ignore = "takes books of others from the folder that RODETE_BOOKS names"]
fn every_book_of_a_folder_takes_the_sheets_or_says_why_not() {
    let folder = std::env::var_os("RODETE_BOOKS").expect("RODETE_BOOKS names a folder");
    let (mut found, mut known) = (Vec::new(), BTreeMap::new());
    books(Path::new(&folder), &mut found);
    found.sort();
    let (mut taken, mut refused, mut failed) = (0, 0, Vec::new());
    for path in &found {
        let bytes = std::fs::read(path).expect("a book");
        let known = std::panic::AssertUnwindSafe(&mut known);
        match catch_unwind(move || {
            let known = known;
            tried(&bytes, known.0)
        }) {
            Ok(Ok(())) => taken += 1,
            Ok(Err(why)) => {
                refused += 1;
                println!("{}: {}", path.display(), why.lines().next().unwrap_or_default());
            }
            Err(_) => failed.push(path.display().to_string()),
        }
    }
    println!("{taken} taken, {refused} refused, {} failed", failed.len());
    assert!(failed.is_empty() && taken > 0, "{}", failed.join("\n"));
}
