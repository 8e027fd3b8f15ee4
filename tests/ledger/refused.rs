//! Bad inputs: every cell of every kind spoilt in some ways, designs that contradict themselves, and files that are no
//! workbooks.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use rodete::kinds::KINDS;
use serde_json::Value;

use crate::command::Place;
use crate::golden::Item;
use crate::package::Parts;
use crate::plain::Sums;

/// What every cell of a workbook is given at once.
const SPOILT: [(&str, &str); 6] = [
    ("empty", ""),
    ("a-word", "nonsense"),
    ("a-comma", "1,5"),
    ("below-all", "-1000000000"),
    ("beyond-all", "1000000000"),
    ("a-fraction", "0.123456789"),
];

/// Kind, case, and the cells that contradict others.
const CONTRADICTIONS: &str = "\
impeller full meridian_r=25
impeller full meridian_r=26
impeller full depth_a_p=10
impeller full blades_N=6
impeller full blades_N=9
impeller full blades_N=1 thickness_e=45
impeller full thickness_e=12 safety_d_s=8
impeller full meridian_r=3 tool_diameter_d_t=6.5 blank_step_C=0.5 blades_N=2
impeller full safety_d_s=0.1
impeller full spindle_height_R_B=10 height_H=5
impeller full B_min=100 B_max=-10
impeller full feed_F=6001
impeller full feed_F=
impeller full dialect=linuxcnc
impeller full dialect=fagor-8070
impeller full start_codes=M3_G0
impeller full start_codes=M30
impeller full end_codes=M5
impeller full blank_length_L_b=15
impeller full blank_end_X_e=50
impeller full blank_step_C=16
impeller full distance=G90
impeller full retract=G0_B90
impeller full blades_N=1 thickness_e=0.1 tool_diameter_d_t=0.5 safety_d_s=5
impeller full intervals_n=2 blades_N=5 splitter_fade=published
impeller full intervals_n=2 blades_N=5 splitter_fade=each-side
impeller full B_max=80 Z_min=-200
impeller full calibration_H=60
impeller tfg-2021 style=full
impeller tfg-2021 dialect=linuxcnc start_codes=M3
impeller tfg-2021 intervals_n=100000 blades_N=15 thickness_e=0.1 tool_diameter_d_t=2
lathe shaft dialect=fagor-8055-t
lathe shaft decimal_point=
lathe shaft stock_bore_d=50
lathe shaft held_L4=120
lathe shaft facing_L5=60
lathe shaft tailstock=yes
lathe shaft travel_X_min=100 travel_X_max=0
lathe shaft body_BX_min=10
lathe blank dialect=fanuc-lathe-a
pipe-hole set-in angle_theta=10
pipe-hole set-in eccentricity_e=100
pipe-hole set-in branch_size=
pipe-hole set-in branch_schedule=
pipe-hole set-in branch_diameter_D=60
pipe-hole set-in groove_gamma=80
pipe-hole set-in land_h=50
pipe-hole set-in root_gap_b=60
pipe-hole set-in least_gap_g0=50
pipe-hole set-in greatest_height_D_max=1
pipe-hole set-in retract_Z_s=1
pipe-hole set-in lead_in=500
pipe-hole set-in hold_on=M30
pipe-insert square eccentricity_e=100
pipe-insert square branch_size=8
pipe-insert square header_schedule=
pipe-insert square branch_wall_t=60
pipe-insert square offset_Z=-500
pipe-insert square kerf=60
pipe-insert square lead_in=500
pipe-insert square overcut=500
pipe-insert square feed_F=
pipe-insert square torch_on=G1
pipe-insert square end_codes=M5
pipe-insert 3on4-2023 dialect=linuxcnc
pipe-insert 3on4-2023 mode=rotary
";

/// A document for each workbook that is checked, by name.
fn checked(place: &Place, books: &[(String, Vec<u8>)]) -> Vec<Item> {
    let mut sums = Sums::default();
    let mut words = vec!["check".to_owned()];
    for (number, (name, bytes)) in books.iter().enumerate() {
        let file = format!("{number}.xlsx");
        place.write(&file, bytes);
        sums.take(name, bytes);
        words.push(file);
    }
    let words: Vec<_> = words.iter().map(String::as_str).collect();
    let document: Value = serde_json::from_slice(&place.json(&words)).unwrap();
    let mut documents = document["workbooks"].as_array().unwrap().clone();
    assert_eq!(documents.len(), books.len());
    let item = |((name, _), document): (&(String, Vec<u8>), &mut Value)| {
        document.as_object_mut().unwrap().remove("workbook");
        Item::new(format!("refused/{name}"), &sums.value(document))
    };
    books.iter().zip(&mut documents).map(item).collect()
}

fn new(place: &Place, kind: &str, case: &str, language: &str) -> Parts {
    let file = format!("new-{kind}-{case}-{language}.xlsx");
    if !place.path(&file).is_file() {
        place.run(&["new", kind, &file, "--case", case, "--lang", language]);
    }
    Parts::of(&place.read(&file))
}

/// Each kind with all cells but the schema spoilt.
fn spoilt(place: &Place) -> Vec<(String, Vec<u8>)> {
    let mut books = Vec::new();
    for (kind, case) in KINDS.iter().map(|kind| (kind.form().kind, kind.cases()[0].name)) {
        for language in ["en", "es"] {
            for (name, value) in SPOILT {
                let parts = new(place, kind, case, language);
                let cells: BTreeSet<_> = parts.names().into_keys().filter(|cell| cell != "schema").collect();
                assert!(cells.len() > 5, "{kind}");
                let edits: Vec<_> = cells.iter().map(|cell| (cell.as_str(), value)).collect();
                books.push((format!("{kind}/cells/{name}/{language}"), parts.with(&edits).zip()));
            }
        }
    }
    books
}

fn contradictions(place: &Place) -> Vec<(String, Vec<u8>)> {
    let book = |line: &str| {
        let mut words = line.split(' ');
        let (kind, case) = (words.next().unwrap(), words.next().unwrap());
        let edits: Vec<_> = words.map(|word| word.split_once('=').unwrap()).collect();
        let edits: Vec<_> = edits.into_iter().map(|(cell, value)| (cell, value.replace('_', " "))).collect();
        let name = line.replacen(' ', "/", 2).replace(' ', ",");
        let parts = edits.iter().fold(new(place, kind, case, "en"), |parts, (cell, value)| parts.put(cell, value));
        (name, parts.zip())
    };
    CONTRADICTIONS.lines().map(book).collect()
}

fn packages(place: &Place) -> Vec<(String, Vec<u8>)> {
    let sound = || new(place, "impeller", "full", "en");
    let whole = sound().zip();
    let without = |part: &str| {
        let mut parts = sound();
        assert!(parts.0.remove(part).is_some(), "{part}");
        parts.zip()
    };
    let with = |part: &str, from: &str, to: &str| {
        let mut parts = sound();
        let text = String::from_utf8(parts.0[part].clone()).unwrap();
        assert!(text.contains(from), "{part}");
        parts.0.insert(part.to_owned(), text.replacen(from, to, 1).into_bytes());
        parts.zip()
    };
    let earlier = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/impeller-schema-1.xlsx");
    let earlier = fs::read(earlier).unwrap();
    let books = [
        ("nothing", Vec::new()),
        ("half", whole[..whole.len() / 2].to_vec()),
        ("text", b"hello\nworld\n".to_vec()),
        ("old-xls", b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1rest".to_vec()),
        ("archive", Parts([("a.txt".to_owned(), b"a".to_vec())].into()).zip()),
        ("no-workbook", without("xl/workbook.xml")),
        ("no-relations", without("xl/_rels/workbook.xml.rels")),
        ("no-strings", without("xl/sharedStrings.xml")),
        ("no-sheet", without("xl/worksheets/sheet1.xml")),
        ("other-sheet-name", with("xl/workbook.xml", "name=\"DATA\"", "name=\"Tabelle1\"")),
        ("torn-xml", with("xl/worksheets/sheet1.xml", "</sheetData>", "")),
        ("doctype", with("xl/worksheets/sheet1.xml", "<worksheet", "<!DOCTYPE a><worksheet")),
        ("other-schema", sound().put("schema", "rodete-impeller 99").zip()),
        ("schema-1", sound().put("schema", "rodete-impeller 1").zip()),
        ("earlier-schema", earlier),
        ("an-error", with("xl/worksheets/sheet1.xml", "<v>25</v>", "<v>#REF!</v>")),
        ("not-finite", with("xl/worksheets/sheet1.xml", "<v>25</v>", "<v>INF</v>")),
    ];
    books.into_iter().map(|(name, bytes)| (format!("package/{name}"), bytes)).collect()
}

pub fn items() -> Vec<Item> {
    let place = Place::new();
    let all = [spoilt(&place), contradictions(&place), packages(&place)].concat();
    let mut items = checked(&place, &all);
    let of_empty = ["impeller/cells/empty/en", "impeller/cells/empty/es", "lathe/cells/empty/en"];
    let (printed, files) = (Place::new(), ["0.xlsx", "6.xlsx", "12.xlsx"]);
    for (file, of) in files.into_iter().zip(of_empty) {
        printed.write(file, &all.iter().find(|(name, _)| name == of).unwrap().1);
    }
    let words = [&["check"][..], &files, &["--lang", "es"]].concat();
    items.push(Item::new("refused/printed/es", &printed.said(&words)));
    items
}
