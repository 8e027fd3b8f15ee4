//! Form and results go into every hard book; all that was there stays.

use rodete::kinds::KINDS;

use super::made::{BOOKS, Results, book, differing, host, kept, parts, read, values, with_form};

#[test]
fn every_other_part_keeps_its_bytes() {
    for name in BOOKS {
        let before = book(name);
        let formed = with_form(KINDS[0], &before);
        assert_eq!(differing(&kept(&before), &kept(&formed)), Vec::<String>::new(), "{name}");
        let results = Results::of(&formed);
        let built = results.put_into(&formed);
        assert_eq!(differing(&kept(&before), &kept(&built)), Vec::<String>::new(), "{name}");
        let gone: Vec<_> = parts(&before).into_keys().filter(|one| !parts(&built).contains_key(one)).collect();
        assert!(gone.iter().all(|one| one.contains("calcChain")), "{name}: {gone:?}");
        assert_eq!(values(&built, results.sheets()), values(&results.bytes, results.sheets()), "{name}");
        assert_eq!(read(&formed).values, read(&built).values, "{name}");
    }
}

#[test]
fn own_sheets_names_and_views_stand_as_they_did() {
    for name in BOOKS {
        let before = book(name);
        let built = {
            let formed = with_form(KINDS[0], &before);
            Results::of(&formed).put_into(&formed)
        };
        let listed = |bytes: &[u8]| rodete::workbook::gate(bytes).expect("a book").sheets;
        let (was, is) = (listed(&before), listed(&built));
        assert_eq!(was, is[..was.len()], "{name}");
        // What stands in the workbook part stands there still, in its order: something was put between, nothing taken away.
        for part in ["xl/workbook.xml", "Book/main.part"] {
            let Some(was) = parts(&before).remove(part) else { continue };
            let is = String::from_utf8(parts(&built).remove(part).expect("the part")).expect("UTF-8");
            let was = String::from_utf8(was).expect("UTF-8");
            let mut at = 0;
            for piece in was.split_inclusive('>') {
                let found = is[at..].find(piece);
                at += found.unwrap_or_else(|| panic!("{name}: {piece} is lost")) + piece.len();
            }
        }
        assert!(!host(&built).present().ours.is_empty(), "{name}");
    }
}

#[test]
fn the_second_and_the_third_time_nothing_grows() {
    for name in BOOKS {
        let formed = with_form(KINDS[0], &book(name));
        let results = Results::of(&formed);
        let first = results.put_into(&formed);
        let again = Results::of(&first);
        assert_eq!(again.made, results.made, "{name}: the sheets keep their names");
        let second = again.put_into(&first);
        let third = again.put_into(&second);
        assert_eq!(differing(&parts(&first), &parts(&second)), Vec::<String>::new(), "{name}");
        assert!(first == second && second == third, "{name}: the same bytes");
    }
}

#[test]
fn every_kind_goes_into_a_hard_book() {
    for kind in KINDS {
        let formed = with_form(*kind, &book("h1.xlsx"));
        let results = Results::of(&formed);
        let built = results.put_into(&formed);
        assert_eq!(differing(&kept(&book("h1.xlsx")), &kept(&built)), Vec::<String>::new());
        assert_eq!(values(&built, results.sheets()), values(&results.bytes, results.sheets()));
        assert_eq!(read(&formed).values, read(&built).values);
    }
}

/// LibreOffice up to 6.0 writes such a list of types: each part of relationships by name, and no type for the ending.
#[test]
fn every_new_part_has_a_type_where_the_host_has_none_for_relationships() {
    let types =
        |bytes: &[u8]| String::from_utf8(parts(bytes).remove("[Content_Types].xml").expect("types")).expect("UTF-8");
    let own = types(&book("h1.xlsx"));
    let usual =
        own.split_inclusive('>').find(|one| one.contains("Default") && one.contains("\"rels\"")).expect("a default");
    let named: String = parts(&book("h1.xlsx"))
        .into_keys()
        .filter(|part| part.ends_with(".rels"))
        .map(|part| {
            let kind = "application/vnd.openxmlformats-package.relationships+xml";
            format!("<Override PartName=\"/{part}\" ContentType=\"{kind}\"/>")
        })
        .collect();
    let listed = own.replace(usual, "").replace("</Types>", &format!("{named}</Types>"));
    let mut out = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (part, content) in parts(&book("h1.xlsx")) {
        out.start_file(&*part, zip::write::SimpleFileOptions::default()).expect("a part");
        let content = if part == "[Content_Types].xml" { listed.clone().into_bytes() } else { content };
        std::io::Write::write_all(&mut out, &content).expect("its contents");
    }
    let host = out.finish().expect("a package").into_inner();
    let formed = with_form(KINDS[0], &host);
    let first = Results::of(&formed).put_into(&formed);
    let second = Results::of(&first).put_into(&first);
    assert!(first == second, "the same bytes");
    let added: Vec<String> =
        parts(&second).into_keys().filter(|part| part.ends_with(".rels") && part.contains("rodete")).collect();
    assert!(added.len() > 1, "{added:?}");
    for part in added {
        assert_eq!(types(&second).matches(&format!("PartName=\"/{part}\"")).count(), 1, "{part}");
    }
}
