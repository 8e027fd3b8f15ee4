//! Defined names: those of the engineer stay, ours are added once, none is there twice.

use std::collections::BTreeSet;

use proptest::prelude::*;
use rodete::finding::Exit;
use rodete::kinds::KINDS;

use super::common::workbook::Parts;
use super::made::{Results, book, host, said, with_form};

const BOOK: &str = "xl/workbook.xml";

/// The defined names of a book: name in lower case, sheet, formula.
fn names(bytes: &[u8]) -> Vec<(String, Option<String>, String)> {
    let text = Parts::of(bytes).text(BOOK);
    let listed =
        text.split_once("<definedNames>").map_or("", |(_, rest)| rest.split("</definedNames>").next().unwrap_or(""));
    let attribute = |tag: &str, name: &str| {
        tag.split_once(&format!(" {name}=\"")).map(|(_, rest)| rest.split('"').next().unwrap_or("").to_owned())
    };
    listed
        .split("<definedName")
        .skip(1)
        .map(|one| {
            let (tag, rest) = one.split_once('>').expect("a tag");
            let formula = rest.split("</definedName>").next().unwrap_or("").to_owned();
            (attribute(tag, "name").expect("a name").to_lowercase(), attribute(tag, "localSheetId"), formula)
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn names_of_the_engineer_stay_and_none_is_there_twice(
        own in proptest::collection::btree_map("[a-zA-Z_][a-z_]{0,12}[A-Z_]", (prop::option::of(0_usize..3), 1_u32..99), 0..8),
    ) {
        let formed = with_form(KINDS[0], &book("h3.xlsx"));
        let there: BTreeSet<_> = names(&formed).into_iter().map(|(name, ..)| name).collect();
        let mut seen = BTreeSet::new();
        let own: Vec<_> = own
            .into_iter()
            .filter(|(name, _)| !there.contains(&name.to_lowercase()) && seen.insert(name.to_lowercase()))
            .collect();
        let text: String = own
            .iter()
            .map(|(name, (sheet, value))| {
                let sheet = sheet.map_or_else(String::new, |sheet| format!(" localSheetId=\"{sheet}\""));
                format!("<definedName name=\"{name}\"{sheet}>{value}</definedName>")
            })
            .collect();
        let with = Parts::of(&formed).replace(BOOK, "</definedNames>", &format!("{text}</definedNames>")).zip();
        let built = Results::of(&with).put_into(&with);
        let (was, is) = (names(&with), names(&built));
        for name in &was {
            prop_assert!(is.contains(name), "{name:?} is lost");
        }
        let keys: BTreeSet<_> = is.iter().map(|(name, sheet, _)| (name, sheet)).collect();
        prop_assert_eq!(keys.len(), is.len(), "a name twice");
        let added = is.iter().filter(|name| !was.contains(name));
        for (name, ..) in added {
            let ours = ["rodete_", "_xlnm.", "derived_", "stale_inputs", "build_stamp"].iter().any(|begin| name.starts_with(begin));
            prop_assert!(ours, "{}", name);
        }
    }
}

#[test]
fn no_name_of_ours_is_an_address_in_any_notation() {
    let formed = with_form(KINDS[0], &book("h1.xlsx"));
    for kind in KINDS {
        let built = if kind.form().kind == "impeller" {
            Results::of(&formed).put_into(&formed)
        } else {
            with_form(*kind, &book("h1.xlsx"))
        };
        for (name, ..) in names(&built).into_iter().filter(|(name, ..)| !name.starts_with("_xlnm.")) {
            let letters = name.chars().take_while(char::is_ascii_alphabetic).count();
            let digits = name.chars().skip(letters).all(|one| one.is_ascii_digit()) && letters < name.len();
            prop_assert_plain(!(letters <= 3 && digits), &name);
            // R1C1, and F1C1 of the Spanish one.
            let mut rest = name.as_str();
            for letter in [&['r', 'f'][..], &['c'][..]] {
                rest = rest.strip_prefix(letter).unwrap_or(rest).trim_start_matches(|one: char| one.is_ascii_digit());
            }
            prop_assert_plain(!rest.is_empty(), &name);
        }
    }
}

fn prop_assert_plain(holds: bool, name: &str) {
    assert!(holds, "{name} reads as an address");
}

#[test]
fn an_input_whose_name_was_lost_gets_it_again_and_one_that_was_taken_is_refused() {
    let formed = with_form(KINDS[0], &book("h3.xlsx"));
    let at = names(&formed).into_iter().find(|(name, ..)| name == "torus_r").expect("the name").2;
    let whole = format!("<definedName name=\"torus_R\">{at}</definedName>");
    for lost in ["", "<definedName name=\"torus_R\">#REF!</definedName>"] {
        let without = Parts::of(&formed).replace(BOOK, &whole, lost).zip();
        let built = Results::of(&without).put_into(&without);
        let is = names(&built).into_iter().find(|(name, ..)| name == "torus_r").expect("the name");
        assert_eq!(is.2.replace("&apos;", ""), at.replace("&apos;", ""), "{lost}");
    }
    let taken = Parts::of(&formed).replace(BOOK, &whole, "<definedName name=\"Torus_r\">42</definedName>").zip();
    let results = Results::of(&taken);
    let refused = host(&taken).put(&results.donor()).expect_err("another torus_R");
    assert_eq!(refused.exit, Exit::Refused);
    assert_eq!(said(&refused), "B0112 the workbook's name Torus_r already stands for something else: 42\n");
}

/// A workbook has its tables and its defined names of one stock (ISO 29500-1, 18.5.1.2): Excel would repair the file.
#[test]
fn a_table_that_is_called_as_one_of_our_names_is_refused() {
    const TYPE: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.table+xml";
    let formed = with_form(KINDS[0], &book("h3.xlsx"));
    let with = |name: &str| {
        let table = format!(
            "<table xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\" id=\"99\" name=\"own\" displayName=\"{name}\" ref=\"A1:C3\"/>"
        );
        let part = format!("<Override PartName=\"/xl/tables/table99.xml\" ContentType=\"{TYPE}\"/></Types>");
        let parts = Parts::of(&formed).put("xl/tables/table99.xml", table);
        parts.replace("[Content_Types].xml", "</Types>", &part).zip()
    };
    let own = with("Own");
    Results::of(&own).put_into(&own);
    let taken = with("Stale_Inputs");
    let refused = host(&taken).put(&Results::of(&taken).donor()).expect_err("a table of that name");
    assert_eq!(said(&refused), "B0112 the workbook's name Stale_Inputs already stands for something else: A1:C3\n");
    assert!(host(&taken).has_room_for_results().is_err() && host(&own).has_room_for_results().is_ok());
}
