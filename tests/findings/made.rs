//! Every row is raised by its own example: the workbooks, the files and the commands.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Cursor};
use std::path::Path;
use std::sync::Mutex;

use rodete::cli::rows;
use rodete::finding::{Example, Exit, Finding, Grade, Refusal, Rule};
use rodete::kind::{Kind, Provenance};
use rodete::kinds::lathe::rules::{NothingToCompare, ProgramNotJudged};
use rodete::kinds::{self, KINDS, lathe};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::parameter::list::{Row, Rows};
use rodete::parameter::{Form, Value};
use rodete::sweep::asked;
use rodete::text::Language;
use rodete::text::t;
use rodete::workbook::offsets_table::OffsetsTable;
use rodete::workbook::results::{self, Tables};
use rodete::workbook::{self, Input, offsets_sheet, stamp, sweep_sheet, template};

use super::workbook::{DATA, Parts, sound, written, written_with_variants};

/// What is told of an input, whether it is taken or refused.
fn told<T>(read: Result<T, Refusal>, findings: impl FnOnce(T) -> Vec<Finding>) -> Vec<Finding> {
    match read {
        Ok(read) => findings(read),
        Err(refusal) => {
            assert_ne!(refusal.exit, Exit::Done);
            refusal.findings
        }
    }
}

fn named(kind: &str) -> &'static dyn Kind {
    *KINDS.iter().find(|one| one.form().kind == kind).unwrap()
}

/// The workbook that `new` writes for these words: a kind, and `--case NAME` where another than its usual case is meant. Hundreds of
/// rows begin with one of a few: each is written once.
fn new(words: &str) -> (&'static Form, Vec<u8>) {
    static WRITTEN: Mutex<BTreeMap<String, Vec<u8>>> = Mutex::new(BTreeMap::new());
    let (kind, case) = words.split_once(" --case ").map_or((words, None), |(kind, case)| (kind, Some(case)));
    let kind = named(kind);
    let case = kind.cases().iter().find(|one| case.is_none_or(|case| one.name == case)).expect("a case of the kind");
    let mut all = WRITTEN.lock().unwrap();
    (kind.form(), all.entry(words.to_owned()).or_insert_with(|| written(kind, case, Language::En)).clone())
}

/// The results of the full impeller.
fn results_of_full() -> Vec<u8> {
    let (form, bytes) = new("impeller --case full");
    let source = Provenance { workbook: "a.xlsx".to_owned(), sha256: String::new(), version: "0" };
    let outcome = kinds::run(form, workbook::read(&bytes, &[form]).unwrap().values, source).unwrap();
    let files = [("a-blade.nc".to_owned(), t("Un álabe", "One blade"))];
    let mut out = Cursor::new(Vec::new());
    results::write(&outcome, &files, Tables::Live, Language::En, &mut out).unwrap();
    out.into_inner()
}

/// The part of a sheet by its name.
fn part(parts: &Parts, sheet: &str) -> String {
    let listed = parts.text("xl/workbook.xml");
    let before = listed.split(&format!("<sheet name=\"{sheet}\"")).next().unwrap();
    assert_ne!(before.len(), listed.len(), "no sheet {sheet}");
    format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1)
}

/// A cell as a spreadsheet takes what is typed.
fn typed(address: &str, text: &str) -> String {
    let number = text.parse::<f64>().is_ok();
    match text {
        "" => String::new(),
        "TRUE" | "FALSE" => format!("<c r=\"{address}\" t=\"b\"><v>{}</v></c>", u8::from(text == "TRUE")),
        _ if text.starts_with('=') => format!("<c r=\"{address}\"><f>{}</f></c>", &text[1..]),
        _ if text.starts_with('#') => format!("<c r=\"{address}\" t=\"e\"><v>{text}</v></c>"),
        _ if number => format!("<c r=\"{address}\"><v>{text}</v></c>"),
        _ => {
            let text = text.trim_start_matches('\'');
            format!("<c r=\"{address}\" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is></c>")
        }
    }
}

/// A new workbook with cells changed; with a sheet of variants where a cell is of that.
fn changed(kind: &str, cells: &[(&str, &str)]) -> Vec<u8> {
    let (form, bytes) = new(kind);
    let variants = cells.iter().any(|(place, _)| place.starts_with("SWEEP!"));
    let bytes = if variants { written_with_variants(named(kind), Language::En) } else { bytes };
    let values = workbook::read(&bytes, &[form]).unwrap().values;
    let mut parts = Parts::of(&bytes);
    for (place, text) in cells {
        let (sheet, address) = match place.split_once('!') {
            Some((sheet, address)) => (sheet.to_owned(), address.to_owned()),
            None => {
                let (symbol, which) = place.split_once(':').unwrap_or((place, "value"));
                let (_, parameter) = form.parameters().find(|(_, one)| one.symbol() == symbol).unwrap();
                let at = &values.cells[parameter.key];
                let column = ["symbol", "", "value", "unit"].iter().position(|one| *one == which).unwrap();
                (at.sheet.clone(), at.cell.replace('C', &"ABCD"[column..=column]))
            }
        };
        let part = part(&parts, &sheet);
        parts = parts.cell(&part, &address, &typed(&address, text));
    }
    parts.zip()
}

/// A sheet of offsets, its cells changed.
fn offsets(cells: &[(&str, &str)]) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    let mut file = VarFile::default();
    file.complete();
    offsets_sheet::write(&file, LengthUnit::Millimetre, "linuxcnc.var", Language::En, &mut out).unwrap();
    let parts = Parts::of(&out.into_inner());
    cells.iter().fold(parts, |parts, (address, text)| parts.cell(DATA, address, &typed(address, text))).zip()
}

/// A zip of one stored part of each name.
fn zip_of(names: &[&str]) -> Vec<u8> {
    Parts(names.iter().map(|name| ((*name).to_owned(), b"x".to_vec())).collect()).zip()
}

/// The bytes with one changed, so many bytes after every place where the marker stands.
fn with_byte(mut bytes: Vec<u8>, marker: &[u8], ahead: usize, to: u8) -> Vec<u8> {
    let found: Vec<_> = (0..bytes.len()).filter(|at| bytes[*at..].starts_with(marker)).collect();
    assert!(!found.is_empty());
    found.into_iter().for_each(|at| bytes[at + ahead] = to);
    bytes
}

/// A sheet of a name and `<sheetData>` replaced.
fn data(from: &str, to: &str) -> Vec<u8> {
    Parts::sound().replace(DATA, from, to).zip()
}

/// The workbook of an example's key that is read as an impeller's, or another's, form.
fn made(key: &str) -> Option<Vec<u8>> {
    let sound = Parts::sound;
    let (strings, styles, list) = ("xl/sharedStrings.xml", "xl/styles.xml", "xl/workbook.xml");
    let relations = "xl/_rels/workbook.xml.rels";
    let formats = |formats: &str| {
        let text = Parts::sound().text(styles);
        let (start, end) = (text.find("<cellXfs").unwrap(), text.find("</cellXfs>").unwrap() + 10);
        Parts::sound().replace(styles, &text[start..end], &format!("<cellXfs>{formats}</cellXfs>"))
    };
    let number_format = |code: &str| {
        let formats = format!("<numFmts count=\"1\"><numFmt numFmtId=\"164\" formatCode=\"{code}\"/></numFmts><fonts");
        Parts::sound().replace(styles, "<fonts", &formats).zip()
    };
    let image = |size: usize| vec![0; size];
    let tools = |cells: &[(&str, &str)]| {
        let cells: Vec<_> = cells.iter().map(|(at, text)| (format!("TOOLS!{at}"), *text)).collect();
        let cells: Vec<_> = cells.iter().map(|(at, text)| (at.as_str(), *text)).collect();
        changed("lathe", &cells)
    };
    Some(match key {
        "empty" => Vec::new(),
        "old" => b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1rest".to_vec(),
        "text" => b"hello\nworld".to_vec(),
        "g-code" => b"O1234\nG21 G90\n".to_vec(),
        "zip" => zip_of(&["a.txt"]),
        "macros" => sound().put("xl/vbaProject.bin", b"\xD0\xCF".to_vec()).zip(),
        "many-entries" => {
            let names: Vec<String> = (0..2_000).map(|index| format!("part{index}")).collect();
            zip_of(&names.iter().map(String::as_str).collect::<Vec<_>>())
        }
        "half" => {
            let whole = super::workbook::sound(Language::En);
            whole[..whole.len() / 2].to_vec()
        }
        "directory" => with_byte(sound().stored(), b"PK\x01\x02", 1, b'Q'),
        // The writer refuses a name given twice, so one is renamed in the finished bytes, in both of its places.
        "doubled" => with_byte(sound().put("xl/aa", "1").put("xl/ab", "2").stored(), b"xl/ab", 4, b'a'),
        "capitals" => sound().put("XL/Workbook.xml", "x").zip(),
        "outside" => sound().put("xl/../../etc/passwd", "x").zip(),
        "encrypted" => with_byte(with_byte(sound().stored(), b"PK\x01\x02", 8, 1), b"PK\x03\x04", 6, 1),
        "checksum" => with_byte(sound().stored(), b"<sheetData>", 30, b'~'),
        "bomb" => sound().put("xl/media/image1.png", image((64 << 20) + 1)).zip(),
        "bombs" => {
            let five =
                (0..5).fold(sound(), |parts, index| parts.put(&format!("xl/media/{index}.png"), image(60 << 20)));
            five.zip()
        }
        "utf16" => {
            let units = sound().text(DATA).encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
            sound().put(DATA, [vec![0xff, 0xfe], units].concat()).zip()
        }
        "latin1" => {
            let mut latin = sound().text(DATA).into_bytes();
            latin.splice(latin.len() - 20..latin.len() - 20, [0xe1, 0x20]);
            sound().put(DATA, latin).zip()
        }
        "entity" => data("<sheetData>", "<sheetData>&xxe;"),
        "deep" => data("<sheetData>", &format!("{}{}<sheetData>", "<a>".repeat(300), "</a>".repeat(300))),
        "attributes" => {
            let many: String = (0..100_001).map(|index| format!("a{index}=\"\" ")).collect();
            data("<sheetData>", &format!("<sheetData {many}>"))
        }
        "dtd" => data("<worksheet", "<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><worksheet"),
        "encoding" => data("encoding=\"UTF-8\"", "encoding=\"latin1\""),
        "cut" => data("</worksheet>", ""),
        "long-format" => number_format(&"0".repeat(5_000)),
        "brackets" => number_format(&"[".repeat(300)),
        "announced" => sound().replace(strings, "uniqueCount=\"", "uniqueCount=\"4294967295").zip(),
        "nested-text" => sound().replace(strings, "</sst>", "<si><si/></si></sst>").zip(),
        "million-texts" => sound().put(strings, format!("<sst>{}</sst>", "<si/>".repeat(1_000_001))).zip(),
        "schema-1" => include_bytes!("../golden/impeller-schema-1.xlsx").to_vec(),
        "formats" => formats(&"<xf/>".repeat(65_537)).zip(),
        "no-texts" => sound().put(strings, "<texts/>").zip(),
        "no-workbook" => sound().without(list).zip(),
        "relations" => {
            let many: String =
                (100..2_101).map(|index| format!("<Relationship Id=\"r{index}\" Type=\"x\" Target=\"y\"/>")).collect();
            sound().replace(relations, "</Relationships>", &format!("{many}</Relationships>")).zip()
        }
        "sheets" => {
            let many: String = (3..1_002)
                .map(|index| format!("<sheet name=\"s{index}\" sheetId=\"{index}\" r:id=\"rId1\"/>"))
                .collect();
            sound().replace(list, "</sheets>", &format!("{many}</sheets>")).zip()
        }
        "state" => sound().replace(list, "name=\"DATA\"", "name=\"DATA\" state=\"odd\"").zip(),
        "unrelated" => sound().replace(list, "r:id=\"rId1\"", "r:id=\"rId99\"").zip(),
        "macro-sheet" => {
            let (from, to) = ("worksheet\" Target=\"worksheets/sheet1", "xlMacrosheet\" Target=\"worksheets/sheet1");
            sound().replace(relations, from, to).zip()
        }
        "sheet-outside" => sound().replace(relations, "worksheets/sheet1.xml", "../../sheet1.xml").zip(),
        "no-part" => sound().without(DATA).zip(),
        "rows" => {
            let rows: String =
                (200..10_202).map(|row| format!("<row r=\"{row}\"><c r=\"A{row}\"><v>1</v></c></row>")).collect();
            data("</sheetData>", &format!("{rows}</sheetData>"))
        }
        "far" => data("</sheetData>", "<row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row></sheetData>"),
        "dimension" => data("<sheetData>", "<dimension ref=\"ZZZZZZZZ9:A1\"/><sheetData>"),
        "foreign" => data("<sheetData>", "<sheetData><x/>"),
        "cells-twice" => data("</sheetData>", "</sheetData><sheetData/>"),
        "merge-not-valid" => data("</sheetData>", "</sheetData><mergeCells><mergeCell ref=\"?\"/></mergeCells>"),
        "outside-grid" => data("</sheetData>", "<row r=\"200\"><c r=\"XFE200\"><v>1</v></c></row></sheetData>"),
        "other-row" => data("</sheetData>", "<row r=\"200\"><c r=\"A201\"><v>1</v></c></row></sheetData>"),
        "cell-twice" => sound().value("R", "", "<v>25</v></c><c r=\"C7\"><v>26</v>").zip(),
        "reference" => sound().number("R", "1&#50;").zip(),
        "no-text" => sound().value("part", "t=\"s\"", "<v>99999</v>").zip(),
        "no-truth" => sound().value("R", "t=\"b\"", "<v>2</v>").zip(),
        "spill" => sound().value("n", "t=\"e\"", "<v>#SPILL!</v>").zip(),
        "unknown-type" => sound().value("R", "t=\"q\"", "<v>25</v>").zip(),
        "nan" => sound().number("R", "NaN").zip(),
        "abc" => sound().number("R", "abc").zip(),
        "merged" => data("</sheetData>", "</sheetData><mergeCells><mergeCell ref=\"B7:C7\"/></mergeCells>"),
        "date" => sound().value("R", "t=\"d\"", "<v>2023-03-15T00:00:00</v>").zip(),
        "percentage" => formats("<xf numFmtId=\"0\"/><xf numFmtId=\"10\"/>").value("e", "s=\"1\"", "<v>2.1</v>").zip(),
        "long-text" => sound().string("part", &"x".repeat(40_000)).zip(),
        "chart" => {
            let (from, to) = ("worksheet\" Target=\"worksheets/sheet1", "chartsheet\" Target=\"worksheets/sheet1");
            sound().replace(relations, from, to).zip()
        }
        "changed-results" => {
            let parts = Parts::of(&results_of_full());
            let part = part(&parts, "DATA");
            parts.replace(&part, "<v>25</v>", "<v>26</v>").zip()
        }
        "lost-name" => {
            let parts = Parts::of(&results_of_full());
            let listed = parts.text("xl/workbook.xml");
            let (before, rest) = listed.split_once("<definedName name=\"thickness_e\">").unwrap();
            let (_, after) = rest.split_once("</definedName>").unwrap();
            parts.put("xl/workbook.xml", format!("{before}{after}")).zip()
        }
        "copied-results" => {
            let (form, bytes) = new("impeller --case full");
            let results = |R| {
                let mut values = workbook::read(&bytes, &[form]).unwrap().values;
                values.values.insert("R", Value::Real(R));
                let source = Provenance { workbook: "a.xlsx".to_owned(), sha256: String::new(), version: "0" };
                let mut out = Cursor::new(Vec::new());
                results::write(&kinds::run(form, values, source).unwrap(), &[], Tables::Live, Language::En, &mut out)
                    .unwrap();
                Parts::of(&out.into_inner())
            };
            let (now, before) = (results(25.0), results(26.0));
            let part = part(&now, "Annex 2");
            now.put(&part, before.text(&part)).zip()
        }
        "hidden" => sound().replace(list, "name=\"DATA\"", "name=\"DATA\" state=\"hidden\"").zip(),
        "formula" => sound().value("R", "", "<f>20+5</f><v>25</v>").zip(),
        "other-sheet" => sound().replace(list, "name=\"DATA\"", "name=\"Sheet1\"").zip(),
        "case" => sound().replace(list, "name=\"DATA\"", "name=\"Data\"").zip(),
        "second-case" => sound().replace(list, "name=\"CALIBRATION\"", "name=\"Calibration\"").zip(),
        "copied-form" => {
            let parts = sound();
            let (copy, data) = (part(&parts, "CALIBRATION"), parts.text(DATA));
            parts.put(&copy, data).replace(list, "name=\"CALIBRATION\"", "name=\"DATA (2)\"").zip()
        }
        "renamed-form" => {
            let parts = Parts::of(&new("lathe").1);
            let (other, program) = (part(&parts, "PROGRAM 2"), parts.text(&part(&parts, "PROGRAM")).to_owned());
            parts.put(&other, program).replace(list, "name=\"PROGRAM 2\"", "name=\"PROGRAM2\"").zip()
        }
        "third-program" => {
            let parts = Parts::of(&new("lathe").1);
            let (other, program) = (part(&parts, "PROFILE"), parts.text(&part(&parts, "PROGRAM")).to_owned());
            parts.put(&other, program).replace(list, "name=\"PROFILE\"", "name=\"PROGRAM 3\"").zip()
        }
        "two-sheets" => sound().replace(list, "name=\"CALIBRATION\"", "name=\"DATOS\"").zip(),
        "symbols" => {
            let cell = |row| {
                format!("<c r=\"A{row}\" t=\"inlineStr\"><is><t>foo{row}</t></is></c><c r=\"C{row}\"><v>1</v></c>")
            };
            let rows: String = (200..221).map(|row| format!("<row r=\"{row}\">{}</row>", cell(row))).collect();
            data("</sheetData>", &format!("{rows}</sheetData>"))
        }
        "no-tools" => {
            let (_, bytes) = new("lathe");
            Parts::of(&bytes).replace(list, "name=\"TOOLS\"", "name=\"Notes\"").zip()
        }
        "no-rows" => {
            let parts = Parts::of(&new("lathe").1);
            let part = part(&parts, "TOOLS");
            let text = parts.text(&part);
            let first = text.find("<row r=\"6\"").unwrap();
            let end = text.find("</sheetData>").unwrap();
            parts.put(&part, format!("{}{}", &text[..first], &text[end..])).zip()
        }
        "many-tools" => {
            let parts = Parts::of(&new("lathe").1);
            let part = part(&parts, "TOOLS");
            let rows: String =
                (400..900).map(|row| format!("<row r=\"{row}\"><c r=\"A{row}\"><v>1</v></c></row>")).collect();
            parts.replace(&part, "</sheetData>", &format!("{rows}</sheetData>")).zip()
        }
        "heading" => tools(&[("X5", "foo")]),
        "heading-twice" => tools(&[("X5", "T")]),
        "no-column" => tools(&[("V5", "")]),
        "column-unit-empty" => tools(&[("V4", "")]),
        "column-unit" => tools(&[("V4", "inch")]),
        "column-unit-none" => tools(&[("A4", "mm")]),
        _ => return None,
    })
}

/// The sheet of offsets of an example's key, and the unit that it is read in.
fn made_offsets(key: &str) -> Option<(Vec<u8>, LengthUnit)> {
    let bytes = match key {
        "offsets-none" => sound(Language::En),
        "offsets-no-schema" => offsets(&[("B3", "")]),
        "offsets-schema" => offsets(&[("B3", "rodete-offsets 9")]),
        "offsets-tables" => offsets(&[("A8", "System")]),
        "offsets-unit-empty" => offsets(&[("B5", "")]),
        "offsets-unit" => offsets(&[("B5", "cm")]),
        "offsets-inches" => offsets(&[("B5", "inch")]),
        "offsets-empty" => {
            let parts = Parts::of(&offsets(&[]));
            let text = parts.text(DATA);
            let (first, end) = (text.find("<row r=\"6\"").unwrap(), text.find("</sheetData>").unwrap());
            parts.put(DATA, format!("{}{}", &text[..first], &text[end..])).zip()
        }
        "offsets-g92" => offsets(&[("K15", "30")]),
        "offsets-inactive" => offsets(&[("L6", "no")]),
        "offsets-active" => offsets(&[("L7", "yes")]),
        "offsets-left" => offsets(&[("A14", "")]),
        "offsets-mistyped" => offsets(&[("A7", "G 55")]),
        "offsets-millimetres" => offsets(&[]),
        _ => return None,
    };
    let unit = if key == "offsets-millimetres" { LengthUnit::Inch } else { LengthUnit::Millimetre };
    Some((bytes, unit))
}

/// What is told of a path of an example's key.
fn opened(key: &str, folder: &Path) -> Option<Vec<Finding>> {
    let book = folder.join("impeller.xlsx");
    let (mut input, mut path) = (Input::Workbook, folder.join("book.xlsx"));
    match key {
        "held-open" | "fails-and-open" => {
            fs::write(folder.join("~$impeller.xlsx"), "").unwrap();
            // EBUSY, EIO
            let answer = io::Error::from_raw_os_error(if key == "held-open" { 16 } else { 5 });
            return Some(workbook::unopened(input, &book, &answer).findings);
        }
        "folder" => path = folder.to_owned(),
        "device" => path = "/dev/zero".into(),
        "missing" => {}
        "misspelt" | "other-name" | "through-file" => {
            fs::write(&book, "x").unwrap();
            let name = match key {
                "misspelt" => "impeler.xlsx",
                "other-name" => "another.xlsx",
                _ => "impeller.xlsx/book.xlsx",
            };
            path = folder.join(name);
        }
        "unreadable" | "unreadable-and-open" => {
            fs::write(&book, "x").unwrap();
            let mut permissions = fs::metadata(&book).unwrap().permissions();
            std::os::unix::fs::PermissionsExt::set_mode(&mut permissions, 0);
            fs::set_permissions(&book, permissions).unwrap();
            if key == "unreadable-and-open" {
                fs::write(folder.join("~$impeller.xlsx"), "").unwrap();
            }
            path = book;
        }
        "long-name" => path = folder.join("x".repeat(300)),
        "large" | "large-var" => {
            if key == "large-var" {
                (input, path) = (Input::VarFile, folder.join("linuxcnc.var"));
            }
            fs::File::create(&path).unwrap().set_len(workbook::limits::FILE + 1).unwrap();
        }
        _ => return None,
    }
    Some(told(workbook::open_as(input, &path), |_| Vec::new()))
}

/// True where the permissions of files do not hold: for the user that may do everything.
pub fn may_read_all() -> bool {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("closed");
    fs::write(&path, "x").unwrap();
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    std::os::unix::fs::PermissionsExt::set_mode(&mut permissions, 0);
    fs::set_permissions(&path, permissions).unwrap();
    fs::read(path).is_ok()
}

/// What was told of workbooks already, by kind and cells: many rows are of one.
type Known = BTreeMap<(&'static str, &'static [(&'static str, &'static str)]), Vec<Finding>>;

/// The shipped lathe workbook of an example's key, and the lists that it is filled in with in place of its own.
fn made_turning(key: &str) -> Option<Vec<u8>> {
    let case = &lathe::cases::CASES[0];
    let mut values: Vec<_> = case.values(Language::En);
    let mut lists = (case.listed)(Language::En);
    let mut put = |list: &'static str, sheet: &str, rows: Vec<Vec<(&'static str, Value)>>| {
        let row = |values: Vec<_>| Row { values: values.into_iter().collect(), cells: BTreeMap::new() };
        lists.retain(|other| !sheet.is_empty() || other.list != list);
        lists.push(Rows { list, sheet: sheet.to_owned(), rows: rows.into_iter().map(row).collect() });
    };
    let blocks = |text: &str| -> Vec<Vec<(&'static str, Value)>> {
        text.split('|').map(|line| vec![("program/BLOCK", Value::Line(line.to_owned()))]).collect()
    };
    let point = |code: &'static str, X: f64, Z: f64, R: f64| {
        let (code, X, Z) = (Value::Choice(code), Value::Real(X), Value::Real(Z));
        let radius = (R > 0.0).then_some(("profile/R", Value::Real(R)));
        vec![("profile/G", code), ("profile/X", X), ("profile/Z", Z)].into_iter().chain(radius).collect::<Vec<_>>()
    };
    let head = "G50 S2500|T0101|G97 S900 M3|M8|G0 X54. Z2.";
    match key {
        "subprogram-sheets" => ["O0005", "O5"].into_iter().for_each(|sheet| put("subprogram", sheet, blocks("M99"))),
        "profile-long" => {
            put("program", "", blocks(&format!("{head}|X46.|G1 Z-20. F.2|X54.|G0 X100. Z50.|M30")));
            let arc = |at: usize| point("2", 40.0, if at.is_multiple_of(2) { 0.0 } else { -2000.0 }, 2000.0);
            put("profile", "", std::iter::once(point("1", 40.0, 0.0, 0.0)).chain((1..400).map(arc)).collect());
        }
        "part-gone" => {
            put("program", "", blocks(&format!("{head}|G0 X-.4|G1 Z-125. F.2|G0 X100. Z50.|M30")));
            put("profile", "", vec![point("1", 10.0, 0.0, 0.0), point("1", 10.0, -20.0, 0.0)]);
            values.iter_mut().filter(|(key, _)| *key == "D").for_each(|(_, value)| *value = Value::Real(8.0));
        }
        _ => return None,
    }
    let mut out = Cursor::new(Vec::new());
    template::write(&lathe::Lathe, &values, &lists, &case.note, Language::En, &mut out).unwrap();
    Some(out.into_inner())
}

/// What is told of a workbook of a kind that is computed.
fn computed(kind: &str, bytes: &[u8]) -> Vec<Finding> {
    let source = Provenance { workbook: String::new(), sha256: String::new(), version: "0" };
    match workbook::read(bytes, &[new(kind).0]) {
        Ok(filled) => told(kinds::run(filled.form, filled.values, source), |outcome| outcome.findings),
        Err(refusal) => refusal.findings,
    }
}

/// What is told of a workbook's sheet of variants.
fn swept(kind: &str, bytes: &[u8]) -> Vec<Finding> {
    match sweep_sheet::read(bytes, named(kind).form(), Language::En) {
        Ok(sheet) => {
            let sheet = sheet.unwrap();
            match asked::plan(named(kind), &sheet.fields, sheet.designs) {
                Ok((_, notes)) => sheet.findings.into_iter().chain(notes).collect(),
                Err(findings) => findings,
            }
        }
        Err(refusal) => refusal.findings,
    }
}

/// What a row's example is told; none where it is of another test.
fn raised(rule: &Rule, known: &mut Known) -> Option<Vec<Finding>> {
    let read = |bytes: &[u8]| {
        told(workbook::read(bytes, &KINDS.iter().map(|kind| kind.form()).collect::<Vec<_>>()), |filled| {
            filled
                .findings
                .into_iter()
                .chain(filled.stale)
                .chain(filled.astray)
                .chain(stamp::others(bytes).unwrap())
                .collect()
        })
    };
    match rule.example {
        Example::Workbook { kind, cells } if rule.code.starts_with('D') => Some(swept(kind, &changed(kind, cells))),
        // A contradiction is told by the kind, what stands before it by the reading.
        Example::Workbook { kind, cells } if !rule.code.starts_with('W') => {
            Some(known.entry((kind, cells)).or_insert_with(|| computed(kind, &changed(kind, cells))).clone())
        }
        Example::Workbook { kind, cells } => Some(read(&changed(kind, cells))),
        Example::Made { key: "program-beyond-memory", .. } => Some(super::slips::beyond_memory()),
        Example::Made { key, .. } if key.starts_with("given-") => Some(super::given::told(key)),
        // Programs are read elsewhere.
        Example::Made { key, .. } if key.starts_with("program-") => None,
        Example::Made { key, .. } => {
            if let Some(bytes) = made_turning(key) {
                return Some(computed("lathe", &bytes));
            }
            if let Some(bytes) = made(key) {
                return Some(read(&bytes));
            }
            if let Some((bytes, unit)) = made_offsets(key) {
                return Some(told(OffsetsTable::read(&bytes, unit), |table| table.findings));
            }
            // Documents, folders and commands are those of another test.
            rule.code.starts_with('W').then(|| {
                let folder = tempfile::tempdir().unwrap();
                opened(key, folder.path()).unwrap_or_else(|| panic!("nobody makes {key}"))
            })
        }
        _ => None,
    }
}

#[test]
fn what_is_made_for_every_row_raises_it_and_nothing_graver() {
    let (mut wrong, mut known) = (Vec::new(), Known::new());
    let all = may_read_all();
    for rule in rows(KINDS) {
        if all && matches!(rule.example, Example::Made { key: "unreadable" | "unreadable-and-open", .. }) {
            continue;
        }
        let Some(findings) = raised(rule, &mut known) else { continue };
        let own = findings.iter().find(|finding| finding.is(rule));
        let whole = own.is_some_and(|own| {
            assert!(own.data.iter().map(|(name, _)| *name).eq(rule.fields.iter().copied()), "{}", rule.code);
            super::told::compare_finding(rule, own);
            own.grade <= rule.grade
        });
        // What a person should know of a plan stands beside what else there is to say of it, which does not stop it, and
        // beside what its proof finds; that a part is compared or not judged, beside what went wrong with it.
        let plan = rule.code.starts_with('P');
        let gravest = if plan { rule.grade.max(Grade::Caution) } else { rule.grade };
        let proof = |finding: &Finding| plan && finding.rule().code.starts_with('V');
        let beside = [ProgramNotJudged::RULE, NothingToCompare::RULE].contains(&rule);
        let graver = findings.iter().any(|finding| finding.grade > gravest && !proof(finding));
        if !whole || graver && !beside {
            let told: Vec<_> = findings
                .iter()
                .map(|one| format!("    {} {:?} {} | {}", one.rule().code, one.grade, one.what.en, one.remedy.en))
                .collect();
            wrong.push(format!("{} {}:\n{}", rule.code, rule.ident, told.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}
