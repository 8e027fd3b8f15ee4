//! Workbooks for the corpus: a sound one, and its package taken apart and put together again.

use std::io::{Cursor, Read, Write};

use rodete::finding::{Exit, Finding, Grade, Place, Refusal};
use rodete::kind::Kind;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::{Case, FieldKind, Value};
use rodete::text::Language;
use rodete::workbook::{Filled, read, sweep_sheet, template};
use zip::write::SimpleFileOptions;

/// The part of the first sheet.
pub const DATA: &str = "xl/worksheets/sheet1.xml";
/// The part of the second sheet.
pub const CALIBRATION: &str = "xl/worksheets/sheet2.xml";

/// The case of the impeller for tests that need any: it is computed in a tenth of the time of the usual one.
pub fn quick() -> &'static Case {
    CASES.iter().find(|case| case.name == "full").expect("the published method in full")
}

/// The quick case of a kind: the impeller's [`quick`], of others the usual one.
pub fn quick_of(kind: &dyn Kind) -> &'static Case {
    if kind.form().kind == FORM.kind { quick() } else { &kind.cases()[0] }
}

/// A sound workbook: the quick case, with an empty calibration sheet.
pub fn sound(language: Language) -> Vec<u8> {
    sound_book(&quick().values(language), language).save_to_buffer().unwrap()
}

/// The sound workbook with a sheet of variants: settings by their symbols, inputs by the columns of their list, and a sheet of designs
/// where there are any. What reads as a number is one.
pub fn with_variants(settings: &[(&str, &str)], inputs: &[[&str; 6]], designs: &[&[&str]]) -> Vec<u8> {
    with_variants_of(&quick().values(Language::En), settings, inputs, designs)
}

/// The values of a case of the impeller with a blade too thick for any design: a sweep that has another thickness finds at once what each
/// input does around it, so that its time goes into the designs of the plan.
pub fn thick(case: &Case) -> Vec<(&'static str, Value)> {
    let mut values = case.values(Language::En);
    values.iter_mut().filter(|(key, _)| *key == "e").for_each(|(_, value)| *value = Value::Real(50.0));
    values
}

/// The same of other values of the impeller.
pub fn with_variants_of(
    values: &[(&'static str, Value)],
    settings: &[(&str, &str)],
    inputs: &[[&str; 6]],
    designs: &[&[&str]],
) -> Vec<u8> {
    let mut workbook = sound_book(values, Language::En);
    let put = |sheet: &mut rust_xlsxwriter::Worksheet, row: u32, column: u16, text: &str| match text.parse::<f64>() {
        Ok(number) => drop(sheet.write(row, column, number).unwrap()),
        Err(_) if text.is_empty() => {}
        Err(_) => drop(sheet.write(row, column, text).unwrap()),
    };
    let sheet = workbook.add_worksheet().set_name("SWEEP").unwrap();
    for (row, (symbol, value)) in (1..).zip(settings) {
        put(sheet, row, 0, symbol);
        put(sheet, row, 2, value);
    }
    let head = u32::try_from(settings.len()).unwrap() + 2;
    for (column, heading) in (0..).zip(["input", "from", "to", "step", "values", "distribution"]) {
        put(sheet, head, column, heading);
    }
    for (row, input) in (head + 1..).zip(inputs) {
        (0..).zip(input).for_each(|(column, text)| put(sheet, row, column, text));
    }
    if !designs.is_empty() {
        let sheet = workbook.add_worksheet().set_name("DESIGNS").unwrap();
        for (row, design) in (0..).zip(designs) {
            (0..).zip(*design).for_each(|(column, text)| put(sheet, row, column, text));
        }
    }
    workbook.save_to_buffer().unwrap()
}

fn sound_book(values: &[(&'static str, Value)], language: Language) -> rust_xlsxwriter::Workbook {
    let mut workbook = rust_xlsxwriter::Workbook::new();
    for described in FORM.sheets {
        let sheet = workbook.add_worksheet();
        sheet.set_name(described.name.get(language)).unwrap();
        sheet.write(0, 0, described.title.get(language)).unwrap();
        let mut row = 2;
        for section in described.sections {
            sheet.write(row, 0, section.title.get(language)).unwrap();
            for parameter in section.parameters {
                row += 1;
                sheet.write(row, 0, parameter.symbol()).unwrap();
                sheet.write(row, 1, parameter.meaning.get(language)).unwrap();
                match values.iter().find(|value| value.0 == parameter.key).map(|value| &value.1) {
                    None => {}
                    Some(Value::Real(number)) => drop(sheet.write(row, 2, *number).unwrap()),
                    Some(Value::Whole(number)) => drop(sheet.write(row, 2, *number).unwrap()),
                    Some(Value::Line(line)) => drop(sheet.write(row, 2, line).unwrap()),
                    Some(Value::Choice(key)) => {
                        let FieldKind::Choice(choices) = parameter.kind else { panic!("{key}") };
                        let choice = choices.iter().find(|choice| choice.key == *key).unwrap();
                        sheet.write(row, 2, choice.label.get(language)).unwrap();
                    }
                }
                sheet.write(row, 3, parameter.unit.label()).unwrap();
            }
            row += 2;
        }
    }
    workbook
}

/// A case of a kind as the command for new workbooks writes it: validation, groups, a drawing, defined names and all.
pub fn written(kind: &dyn Kind, case: &Case, language: Language) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    let (values, lists) = (case.values(language), (case.listed)(language));
    template::write(kind, &values, &lists, &case.note, language, &mut out).unwrap();
    out.into_inner()
}

/// The case that a kind suggests to vary, with the sheet of variants that it suggests, as `new --sweep` writes it.
pub fn written_with_variants(kind: &dyn Kind, language: Language) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    let suggested = kind.suggested();
    let case = kind.cases().iter().find(|one| suggested.case.is_none_or(|name| one.name == name)).unwrap();
    let (values, lists) = (case.values(language), (case.listed)(language));
    let variants = sweep_sheet::suggested(suggested, language);
    template::write_with_variants(kind, (&values, &lists), &variants, &case.note, language, &mut out).unwrap();
    out.into_inner()
}

/// The row, counted from 1, where [`sound`] puts a parameter.
pub fn row(key: &str) -> usize {
    for described in FORM.sheets {
        let mut row = 3;
        for section in described.sections {
            for parameter in section.parameters {
                row += 1;
                if parameter.key == key {
                    return row;
                }
            }
            row += 2;
        }
    }
    panic!("{key}")
}

/// The address of a parameter's value cell in [`sound`].
pub fn cell(key: &str) -> String {
    format!("C{}", row(key))
}

/// A package as its parts.
#[derive(Clone)]
pub struct Parts(pub Vec<(String, Vec<u8>)>);

impl Parts {
    pub fn of(bytes: &[u8]) -> Self {
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        Self(
            (0..archive.len())
                .map(|index| {
                    let mut entry = archive.by_index(index).unwrap();
                    let mut content = Vec::new();
                    entry.read_to_end(&mut content).unwrap();
                    (entry.name().unwrap().into_owned(), content)
                })
                .collect(),
        )
    }

    /// The English sound workbook.
    pub fn sound() -> Self {
        Self::of(&sound(Language::En))
    }

    pub fn has(&self, part: &str) -> bool {
        self.0.iter().any(|one| one.0 == part)
    }

    pub fn text(&self, part: &str) -> String {
        String::from_utf8(self.0.iter().find(|one| one.0 == part).unwrap().1.clone()).unwrap()
    }

    pub fn put(mut self, part: &str, content: impl Into<Vec<u8>>) -> Self {
        let content = content.into();
        match self.0.iter_mut().find(|one| one.0 == part) {
            Some(found) => found.1 = content,
            None => self.0.push((part.to_owned(), content)),
        }
        self
    }

    pub fn without(mut self, part: &str) -> Self {
        let before = self.0.len();
        self.0.retain(|one| one.0 != part);
        assert_ne!(self.0.len(), before, "{part}");
        self
    }

    /// Replaces a text that must be there.
    pub fn replace(self, part: &str, from: &str, to: &str) -> Self {
        let text = self.text(part);
        assert!(text.contains(from), "{part} has no {from}");
        self.put(part, text.replace(from, to))
    }

    /// Replaces a cell's element; an empty `xml` removes it.
    pub fn cell(self, part: &str, address: &str, xml: &str) -> Self {
        let text = self.text(part);
        let open = format!("<c r=\"{address}\"");
        let digits = address.trim_start_matches(|one: char| one.is_ascii_alphabetic());
        let text = match text.find(&open) {
            Some(start) => {
                let rest = &text[start..];
                let tag = rest.find('>').unwrap();
                let end = if rest[..tag].ends_with('/') { tag + 1 } else { rest.find("</c>").unwrap() + 4 };
                format!("{}{xml}{}", &text[..start], &rest[end..])
            }
            None => {
                let row = text.find(&format!("<row r=\"{digits}\"")).unwrap();
                let at = row + text[row..].find("</row>").unwrap();
                format!("{}{xml}{}", &text[..at], &text[at..])
            }
        };
        self.put(part, text)
    }

    /// Gives a parameter of the first sheet another value cell: its attributes and what stands in it.
    pub fn value(self, key: &str, attributes: &str, inner: &str) -> Self {
        let address = cell(key);
        self.cell(DATA, &address, &format!("<c r=\"{address}\" {attributes}>{inner}</c>"))
    }

    /// Gives a parameter a number.
    pub fn number(self, key: &str, number: &str) -> Self {
        self.value(key, "", &format!("<v>{number}</v>"))
    }

    /// Gives a parameter a text.
    pub fn string(self, key: &str, text: &str) -> Self {
        self.value(key, "t=\"inlineStr\"", &format!("<is><t xml:space=\"preserve\">{text}</t></is>"))
    }

    pub fn zip(&self) -> Vec<u8> {
        self.zip_with(SimpleFileOptions::default())
    }

    pub fn stored(&self) -> Vec<u8> {
        self.zip_with(SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored))
    }

    fn zip_with(&self, options: SimpleFileOptions) -> Vec<u8> {
        let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, content) in &self.0 {
            writer.start_file(name.as_str(), options).unwrap();
            writer.write_all(content).unwrap();
        }
        writer.finish().unwrap().into_inner()
    }
}

/// Reads a workbook as an impeller workbook.
pub fn impeller(bytes: &[u8]) -> Result<Filled, Refusal> {
    read(bytes, &[&FORM])
}

/// What a refusal must say.
pub struct Expected {
    /// The row of the corpus of bad inputs.
    pub row: &'static str,
    pub bytes: Vec<u8>,
    pub exit: Exit,
    /// The cell, sheet or part that the finding names; empty for the file.
    pub place: String,
    /// The English message, whole or a distinctive part of it.
    pub what: &'static str,
    /// The English remedy, whole or a distinctive part of it.
    pub remedy: &'static str,
}

/// A place as text.
pub fn place(finding: &Finding) -> String {
    match &finding.place {
        Place::File => String::new(),
        Place::Part(part) => part.clone(),
        Place::Sheet(sheet) => sheet.clone(),
        Place::Cells(cells) => cells.iter().map(|cell| cell.cell.as_str()).collect::<Vec<_>>().join(","),
        other => panic!("{other:?}"),
    }
}

/// Reads every workbook and compares what is said of it; all differences are shown at once.
pub fn compare(corpus: Vec<Expected>) {
    let mut wrong = Vec::new();
    for one in corpus {
        match impeller(&one.bytes) {
            Ok(_) => wrong.push(format!("{}: accepted, expected {:?}", one.row, one.what)),
            Err(refusal) => {
                let fits = refusal.exit == one.exit
                    && refusal.findings.iter().any(|finding| {
                        finding.grade == Grade::Stop
                            && finding.what.en.contains(one.what)
                            && finding.remedy.en.contains(one.remedy)
                            && place(finding) == one.place
                    });
                let bilingual = refusal.findings.iter().all(|finding| {
                    !finding.what.es.is_empty() && finding.remedy.es.is_empty() == finding.remedy.en.is_empty()
                });
                if !fits || !bilingual {
                    let said: Vec<_> = refusal
                        .findings
                        .iter()
                        .map(|finding| format!("    [{}] {} | {}", place(finding), finding.what.en, finding.remedy.en))
                        .collect();
                    wrong.push(format!(
                        "{}: expected {:?} [{}] {:?} | {:?}\n  got {:?}\n{}",
                        one.row,
                        one.exit,
                        one.place,
                        one.what,
                        one.remedy,
                        refusal.exit,
                        said.join("\n")
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
