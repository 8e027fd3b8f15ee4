//! Section A: the file, its package, its parts and its sheets.

use rodete::finding::Exit::{self, Limit, Refused, Unreadable};
use rodete::text::Language;

use super::workbook::{DATA, Expected, Parts, cell, compare, impeller, sound};

fn file(row: &'static str, bytes: Vec<u8>, what: &'static str, remedy: &'static str) -> Expected {
    at(row, bytes, Unreadable, "", what, remedy)
}

fn at(
    row: &'static str,
    bytes: Vec<u8>,
    exit: Exit,
    place: &str,
    what: &'static str,
    remedy: &'static str,
) -> Expected {
    Expected { row, bytes, exit, place: place.to_owned(), what, remedy }
}

/// A zip of one stored part of the given name.
fn zip_of(names: &[&str]) -> Vec<u8> {
    Parts(names.iter().map(|name| ((*name).to_owned(), b"x".to_vec())).collect()).zip()
}

/// The bytes with one changed, `ahead` bytes after the first `marker`.
fn with_byte(mut bytes: Vec<u8>, marker: &[u8], ahead: usize, change: u8) -> Vec<u8> {
    let found = bytes.windows(marker.len()).position(|window| window == marker).unwrap();
    bytes[found + ahead] ^= change;
    bytes
}

#[test]
fn what_is_no_sound_xlsx_is_refused_by_name() {
    let whole = sound(Language::En);
    let half = whole[..whole.len() / 2].to_vec();
    let old = b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1rest".to_vec();
    let ods = Parts(vec![("mimetype".into(), b"application/vnd.oasis.opendocument.spreadsheet".to_vec())]).stored();
    compare(vec![
        file("A2", Vec::new(), "the file is empty", "copy it again"),
        file("A3", half, "not a complete .xlsx (zip end missing)", "copy it again"),
        file("A3 4 bytes", b"PK\x03\x04".to_vec(), "not a complete .xlsx (zip end missing)", "copy it again"),
        file(
            "A4",
            b"hello\nworld".to_vec(),
            "this is not an .xlsx workbook (starts with \"hello\")",
            "save it as .xlsx",
        ),
        file("A4 escapes", b"\x1b[2Jx".to_vec(), "(starts with \"\\u{1b}[2Jx\")", "save it as .xlsx"),
        file("A5", old, "old .xls or password-protected", "save it as an Excel workbook (.xlsx) without a password"),
        file("A6 .ods", ods, "this is an OpenDocument (.ods) file", "save it as .xlsx"),
        file(
            "A6 .xlsb",
            zip_of(&["[Content_Types].xml", "xl/workbook.bin"]),
            "this is an Excel (.xlsb) file",
            "save it as .xlsx",
        ),
        file(
            "A6 .docx",
            zip_of(&["[Content_Types].xml", "word/document.xml"]),
            "this is an Office (.docx) file",
            "save it as .xlsx",
        ),
        file("A6 .zip", zip_of(&["a.txt"]), "this is an archive (.zip) file", "save it as .xlsx"),
    ]);
}

#[test]
fn a_damaged_package_is_refused_with_its_part() {
    let stored = Parts::sound().stored();
    let sheet = b"<sheetData>";
    let packed = Parts::sound().zip();
    let header = DATA.as_bytes();
    compare(vec![
        at(
            "A7",
            with_byte(stored.clone(), sheet, 30, 1),
            Unreadable,
            DATA,
            "sheet1.xml is damaged (checksum)",
            "copy it again",
        ),
        at(
            "A8",
            with_byte(packed, header, header.len() + 2, 0xff),
            Unreadable,
            DATA,
            "sheet1.xml is damaged (",
            "copy it again",
        ),
    ]);
}

#[test]
fn hostile_packages_are_refused() {
    let many: Vec<String> = (0..2_000).map(|index| format!("part{index}")).collect();
    let many: Vec<&str> = many.iter().map(String::as_str).collect();
    // The writer refuses a name given twice, so one is renamed in the finished bytes, in both of its places.
    let mut doubled = Parts::sound().put("xl/aa", "1").put("xl/ab", "2").stored();
    while let Some(found) = doubled.windows(5).position(|window| window == b"xl/ab") {
        doubled[found + 4] = b'a';
    }
    let bomb = |size: usize| Parts::sound().put("xl/media/image1.png", vec![0; size]).zip();
    let four: Parts =
        (0..5).fold(Parts::sound(), |parts, index| parts.put(&format!("xl/media/{index}.png"), vec![0; 60 << 20]));
    compare(vec![
        at(
            "A9",
            bomb((64 << 20) + 1),
            Limit,
            "xl/media/image1.png",
            "the workbook unpacks to more than 64 MiB in one part",
            "or make that part smaller",
        ),
        at(
            "A9 in all",
            four.zip(),
            Limit,
            "",
            "unpacks to more than 256 MiB in all",
            "make its images and the sheets with much data smaller",
        ),
        file("A10 many", zip_of(&many), "the package has more than 1000 entries", ""),
        file("A10 twice", doubled, "two entries of the package have the same name", ""),
        file("A10 capitals", Parts::sound().put("XL/Workbook.xml", "x").zip(), "(apart from upper and lower case)", ""),
        file(
            "A10 outside",
            Parts::sound().put("xl/../../etc/passwd", "x").zip(),
            "is named \"xl/../../etc/passwd\" and points outside",
            "",
        ),
        file("A10 backslash", Parts::sound().put("xl\\..\\..\\x", "x").zip(), "points outside the package", ""),
        file("A10 absolute", Parts::sound().put("/etc/passwd", "x").zip(), "points outside the package", ""),
        file("A10 drive", Parts::sound().put("C:\\x", "x").zip(), "points outside the package", ""),
    ]);
}

/// Deflate and plain storage are the methods of an .xlsx.
#[test]
fn another_compression_method_is_refused_by_its_name() {
    let mut bytes = Parts::sound().stored();
    let local = bytes.windows(4).position(|window| window == b"PK\x03\x04").unwrap();
    let central = bytes.windows(4).position(|window| window == b"PK\x01\x02").unwrap();
    bytes[local + 8] = 12;
    bytes[central + 10] = 12;
    let refusal = impeller(&bytes).unwrap_err();
    assert_eq!(refusal.exit, Unreadable);
    assert!(refusal.findings[0].what.en.contains("is damaged (compression method Bzip2"), "{refusal:?}");
}

/// A part that says it is smaller than it is must not be unpacked to its end.
#[test]
fn a_part_that_lies_about_its_size_is_refused() {
    let mut bytes = Parts::sound().put("xl/media/image1.png", vec![0; 32 << 20]).zip();
    let size = u32::to_le_bytes(32 << 20);
    let mut changed = 0;
    while let Some(found) = bytes.windows(4).position(|window| window == size) {
        bytes[found..found + 4].copy_from_slice(&1_000_u32.to_le_bytes());
        changed += 1;
    }
    assert!(changed > 0);
    let refusal = impeller(&bytes).unwrap_err();
    assert_eq!(refusal.exit, Unreadable);
    assert!(refusal.findings[0].what.en.contains("image1.png is damaged"), "{refusal:?}");
}

#[test]
fn hostile_or_broken_parts_are_refused_by_name() {
    let sound = Parts::sound;
    let strings = "xl/sharedStrings.xml";
    let dtd = "<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><worksheet";
    let cut = sound().text(DATA);
    let utf16: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(sound().text(DATA).encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let mut latin = sound().text(DATA).into_bytes();
    latin.splice(latin.len() - 20..latin.len() - 20, [0xe1, 0x20]);
    let unique = sound().text(strings);
    let unique = {
        let start = unique.find("uniqueCount=\"").unwrap() + 13;
        let end = start + unique[start..].find('"').unwrap();
        format!("{}4294967295{}", &unique[..start], &unique[end..])
    };
    let brackets =
        format!("<numFmts count=\"1\"><numFmt numFmtId=\"164\" formatCode=\"{}\"/></numFmts><fonts", "[".repeat(300));
    let long =
        format!("<numFmts count=\"1\"><numFmt numFmtId=\"164\" formatCode=\"{}\"/></numFmts><fonts", "0".repeat(5_000));
    compare(vec![
        at(
            "A11",
            sound().put(strings, unique).zip(),
            Limit,
            strings,
            "uniqueCount announces more texts than the part can hold",
            "",
        ),
        at(
            "A17",
            sound().replace(DATA, "<worksheet", dtd).zip(),
            Unreadable,
            DATA,
            "declares a document type (DTD)",
            "",
        ),
        at(
            "A17 entity",
            sound().replace(DATA, "<sheetData>", "<sheetData>&xxe;").zip(),
            Unreadable,
            DATA,
            "XML not well formed at byte",
            "",
        ),
        at(
            "A17 in styles",
            sound().replace("xl/styles.xml", "<styleSheet", "<!DOCTYPE a><styleSheet").zip(),
            Unreadable,
            "xl/styles.xml",
            "declares a document type",
            "",
        ),
        at(
            "A18 cut",
            sound().put(DATA, &cut[..cut.len() - 40]).zip(),
            Unreadable,
            DATA,
            "the part xl/worksheets/sheet1.xml is damaged: XML not well formed",
            "",
        ),
        at("A18 cut between tags", sound().replace(DATA, "</worksheet>", "").zip(), Unreadable, DATA, "is cut off", ""),
        at("A18 bytes", sound().put(DATA, latin).zip(), Unreadable, DATA, "is not valid UTF-8", ""),
        at(
            "A18 encoding",
            sound().replace(DATA, "encoding=\"UTF-8\"", "encoding=\"latin1\"").zip(),
            Unreadable,
            DATA,
            "declares the encoding latin1",
            "",
        ),
        at(
            "A19",
            sound().put(DATA, utf16).zip(),
            Refused,
            DATA,
            "no cells can be read",
            "open it in Excel or LibreOffice and save it again",
        ),
        file(
            "A20 no part",
            sound().without("xl/workbook.xml").zip(),
            "there are no sheets: xl/workbook.xml is missing",
            "",
        ),
        file(
            "A20 no relationships",
            sound().without("_rels/.rels").zip(),
            "there are no sheets: _rels/.rels is missing",
            "",
        ),
        file("A20 none", sound().put("xl/workbook.xml", "<workbook/>").zip(), "there are no sheets", ""),
        at(
            "A21",
            sound().without(DATA).zip(),
            Unreadable,
            DATA,
            "the part xl/worksheets/sheet1.xml of the sheet \"DATA\" is missing",
            "",
        ),
        at(
            "A22 index",
            sound().value("part", "t=\"s\"", "<v>99999</v>").zip(),
            Unreadable,
            &cell("part"),
            "refers to shared text 99999",
            "clear cell",
        ),
        at(
            "A22 not a number",
            sound().value("part", "t=\"s\"", "<v>x</v>").zip(),
            Unreadable,
            &cell("part"),
            "refers to shared text x",
            "clear cell",
        ),
        at(
            "A22 no table",
            sound().without(strings).zip(),
            Unreadable,
            "A1",
            "but the workbook has only 0",
            "clear cell",
        ),
        at(
            "F28 depth",
            sound()
                .replace(DATA, "<sheetData>", &format!("{}{}<sheetData>", "<a>".repeat(300), "</a>".repeat(300)))
                .zip(),
            Limit,
            DATA,
            "has more than 256 nested elements",
            "",
        ),
        at(
            "A16 too many",
            sound()
                .replace(
                    DATA,
                    "<sheetData>",
                    &format!("<sheetData {}>", (0..100_001).map(|index| format!("a{index}=\"\" ")).collect::<String>()),
                )
                .zip(),
            Limit,
            DATA,
            "has more than 100000 attributes in one tag",
            "",
        ),
        at(
            "styles: brackets",
            sound().replace("xl/styles.xml", "<fonts", &brackets).zip(),
            Limit,
            "xl/styles.xml",
            "too many brackets",
            "",
        ),
        at(
            "styles: long attribute",
            sound().replace("xl/styles.xml", "<fonts", &long).zip(),
            Limit,
            "xl/styles.xml",
            "the attribute formatCode is longer than 320 bytes",
            "",
        ),
    ]);
}

#[test]
fn cells_outside_the_grid_are_refused() {
    let with = |row: &str| Parts::sound().replace(DATA, "</sheetData>", &format!("{row}</sheetData>")).zip();
    let outside = |row, bytes, what| at(row, bytes, Refused, "DATA", what, "");
    compare(vec![
        outside(
            "A13 column",
            with("<row r=\"200\"><c r=\"XFE200\"><v>1</v></c></row>"),
            "a cell outside the sheet grid (\"XFE200\"",
        ),
        outside(
            "A13 row",
            with("<row r=\"1048577\"><c r=\"A1048577\"><v>1</v></c></row>"),
            "outside the sheet grid (\"1048577\"",
        ),
        outside(
            "A13 implied",
            with("<row r=\"1048576\"/><row><c><v>1</v></c></row>"),
            "outside the sheet grid (\"A1048577\"",
        ),
        outside(
            "A14 digits",
            with("<row r=\"200\"><c r=\"A99999999999\"><v>1</v></c></row>"),
            "outside the sheet grid (\"A99999999999\"",
        ),
        outside(
            "A14 letters",
            with("<row r=\"200\"><c r=\"ZZZZZZZZ1\"><v>1</v></c></row>"),
            "outside the sheet grid (\"ZZZZZZZZ1\"",
        ),
        at(
            "A14 dimension",
            Parts::sound().replace(DATA, "<sheetData>", "<dimension ref=\"ZZZZZZZZ9:A1\"/><sheetData>").zip(),
            Unreadable,
            DATA,
            "its dimension is not valid",
            "",
        ),
        at(
            "A14 other row",
            with("<row r=\"200\"><c r=\"A201\"><v>1</v></c></row>"),
            Refused,
            "A201",
            "cell A201 is written in row 200",
            "clear",
        ),
    ]);
}

#[test]
fn the_sheet_must_be_there_under_its_name() {
    let named =
        |name: &str| Parts::sound().replace("xl/workbook.xml", "name=\"DATA\"", &format!("name=\"{name}\"")).zip();
    let second = |name: &str| {
        Parts::sound().replace("xl/workbook.xml", "name=\"CALIBRATION\"", &format!("name=\"{name}\"")).zip()
    };
    let chart = Parts::sound().replace(
        "xl/_rels/workbook.xml.rels",
        "relationships/worksheet\" Target=\"worksheets/sheet1.xml\"",
        "relationships/chartsheet\" Target=\"worksheets/sheet1.xml\"",
    );
    compare(vec![
        at(
            "A23 blank",
            named("DATA "),
            Refused,
            "",
            "sheet \"DATOS\" or \"DATA\" not found; there are: \"DATA \", \"CALIBRATION\"",
            "rename the sheet \"DATA \" to \"DATA\"",
        ),
        at("A23 case", named("Datos"), Refused, "", "there are: \"Datos\"", "rename the sheet \"Datos\" to \"DATOS\""),
        at(
            "A23 other",
            named("Sheet1"),
            Refused,
            "",
            "not found; there are: \"Sheet1\"",
            "if it is the sheet of the data under another name",
        ),
        at(
            "A23 escapes",
            named("&#x202e;x"),
            Refused,
            "",
            "there are: \"\\u{202e}x\"",
            "if it is the sheet of the data under another name",
        ),
        at("A23 chart", chart.zip(), Refused, "DATA", "the sheet \"DATA\" has no cells", ""),
        at(
            "A24",
            second("Data"),
            Refused,
            "",
            "it is not clear which sheet to read: \"DATA\", \"Data\"",
            "keep only one of these sheets",
        ),
        at(
            "A24 both languages",
            second("DATOS"),
            Refused,
            "",
            "it is not clear which sheet to read: \"DATA\", \"DATOS\"",
            "keep only one of these sheets",
        ),
    ]);
}

#[test]
fn the_schema_is_looked_at_first() {
    let both = Parts::sound().string("schema", "rodete-impeller 3").value("R", "t=\"n\"", "<v>abc</v>");
    let versions = "schema is \"rodete-impeller 3\"; rodete reads \"rodete-impeller 2\"";
    // A fault that keeps the sheet from being read is told first; one that does not, never.
    let other = Parts::sound().string("schema", "rodete-impeller 3").number("R", "-1");
    let refusal = impeller(&other.zip()).unwrap_err();
    assert_eq!(refusal.findings.len(), 1, "{refusal:?}");
    assert_eq!(
        (refusal.findings[0].value.as_str(), refusal.findings[0].limit.as_str()),
        ("rodete-impeller 3", "\"rodete-impeller 2\"")
    );
    compare(vec![
        at("A28", other.zip(), Refused, &cell("schema"), versions, "make a new workbook"),
        at("A28 unsound", both.zip(), Refused, &cell("R"), "as a number", ""),
        at(
            "A28 empty",
            Parts::sound().cell(DATA, &cell("schema"), "").zip(),
            Refused,
            &cell("schema"),
            "schema is empty; rodete reads \"rodete-impeller 2\"",
            "make a new workbook",
        ),
        at(
            "A28 no row",
            Parts::sound().cell(DATA, "A4", "").zip(),
            Refused,
            "DATA",
            "the row \"schema\", which names the workbook's schema, is missing",
            "make a new workbook",
        ),
        at(
            "A28 twice",
            Parts::sound().string("schema", "x").cell(DATA, "A9", "<c r=\"A9\" t=\"str\"><v>schema</v></c>").zip(),
            Refused,
            "A4,A9",
            "several rows have the symbol \"schema\"",
            "keep only one row",
        ),
        at(
            "A29",
            Parts::sound().value("R", "", "<f>20+5</f>").zip(),
            Refused,
            &cell("R"),
            "holds a formula without a stored value",
            "open the workbook in Excel or LibreOffice and save it",
        ),
        at(
            "A29 empty value",
            Parts::sound().value("R", "", "<f>20+5</f><v></v>").zip(),
            Refused,
            &cell("R"),
            "holds a formula without a stored value",
            "",
        ),
    ]);
}
