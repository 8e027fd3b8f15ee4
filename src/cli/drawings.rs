//! The files of an outcome's drawings at 1:1: DXF, SVG and what is printed.

use std::ffi::OsString;
use std::io::Write;

use super::plan::Item;
use crate::drawing::{self, NotDrawn, dxf, svg, template};
use crate::escape::printable;
use crate::finding::{Exit, Finding, Refusal};
use crate::kind::{Drawing, Kind, Outcome};
use crate::report::{Attachment, Content, Role};
use crate::store::{self, Set};
use crate::text::{Language, Text};
use crate::typeset::compiler::Typst;

/// The formats that are written in any case: extension and media type.
const FORMATS: [(&str, &str); 2] = [("dxf", "image/vnd.dxf"), ("svg", "image/svg+xml")];

/// Endings of every drawing file that a build may write.
pub(super) fn endings(kinds: &[&dyn Kind]) -> impl Iterator<Item = String> {
    let extensions = FORMATS.into_iter().map(|(extension, _)| extension).chain(["pdf"]);
    kinds
        .iter()
        .flat_map(|kind| kind.form().drawings)
        .flat_map(move |key| extensions.clone().map(move |extension| ending(key, extension)))
}

fn ending(key: &str, extension: &str) -> String {
    format!("-{key}.{extension}")
}

fn name(item: &Item, drawing: &Drawing, extension: &str) -> OsString {
    store::file_name(&item.stem, &ending(drawing.key, extension))
}

fn titled<'a>(outcome: &'a Outcome, drawing: &'a Drawing, language: Language) -> drawing::Drawing<'a> {
    drawing::Drawing {
        figure: &drawing.figure,
        arcs: &drawing.arcs,
        title: &drawing.title,
        part: outcome.part(),
        source: &outcome.source,
        language,
    }
}

/// Adds DXF and SVG of every drawing to the set.
///
/// # Errors
/// Exit 5 where one cannot be written; exit 1 where one cannot be drawn.
pub(super) fn write(item: &Item, outcome: &Outcome, language: Language, set: &mut Set<'_>) -> Result<(), Refusal> {
    for drawing in &outcome.drawings {
        let titled = titled(outcome, drawing, language);
        let fault = |why: NotDrawn| Refusal::new(Exit::Fault, why.finding(&drawing.title));
        for (extension, bytes) in [("dxf", dxf::dxf(&titled)), ("svg", svg::svg(&titled))] {
            let bytes = bytes.map_err(fault)?;
            set.write(&name(item, drawing, extension), |out| out.write_all(&bytes))?;
        }
    }
    Ok(())
}

/// Adds the PDF of every drawing that is printed to the set; gives a finding for each that fails, which keeps nothing else
/// from being delivered.
///
/// # Errors
/// Exit 5 where one cannot be written.
pub(super) fn print(
    item: &Item,
    outcome: &Outcome,
    language: Language,
    typst: &Typst,
    set: &mut Set<'_>,
) -> Result<Vec<Finding>, Refusal> {
    let mut failed = Vec::new();
    for drawing in &outcome.drawings {
        let Some(paper) = drawing.paper else { continue };
        match template::pdf(&titled(outcome, drawing, language), paper, typst) {
            Ok(pdf) => {
                set.write(&name(item, drawing, "pdf"), |out| out.write_all(&pdf))?;
            }
            Err(why) => failed.push(why.finding(&drawing.title)),
        }
    }
    Ok(failed)
}

/// The names of the drawings' files with what they are; with what is printed, or without.
pub(super) fn named(item: &Item, outcome: &Outcome, printed: bool) -> impl Iterator<Item = (OsString, Text)> {
    outcome.drawings.iter().flat_map(move |drawing| {
        let pdf = (printed && drawing.paper.is_some()).then_some("pdf");
        let extensions = FORMATS.into_iter().map(|(extension, _)| extension).chain(pdf);
        extensions.map(|extension| (name(item, drawing, extension), described(drawing, extension)))
    })
}

/// What a drawing's file is.
fn described(drawing: &Drawing, extension: &str) -> Text {
    let Text { es, en } = &drawing.title;
    let kind = extension.to_uppercase();
    Text::new(format!("{es}, 1:1, {kind}"), format!("{en}, 1:1, {kind}"))
}

/// What the report lists and carries of the drawings in a set.
pub(super) fn attachments<'a>(item: &Item, outcome: &Outcome, set: &'a Set<'_>) -> Vec<Attachment<'a>> {
    let formats = FORMATS.into_iter().chain([("pdf", "application/pdf")]);
    let one = |drawing: &Drawing, (extension, mime): (&str, &'static str)| {
        let name = name(item, drawing, extension);
        Some(Attachment {
            role: Role::Result,
            mime,
            description: described(drawing, extension),
            content: Content::File(set.draft(&name)?),
            name: printable(&name.to_string_lossy()),
        })
    };
    outcome.drawings.iter().flat_map(|drawing| formats.clone().filter_map(move |format| one(drawing, format))).collect()
}

#[cfg(test)]
#[expect(clippy::disallowed_methods, reason = "tests write into a folder of their own")]
mod tests {
    use std::path::{Path, PathBuf};

    use super::*;
    use crate::figure::{Figure, Ink, Paper, Stroke};
    use crate::kind::Provenance;
    use crate::kinds;
    use crate::kinds::impeller::cases::CASES;
    use crate::kinds::impeller::parameters::FORM;
    use crate::parameter::Values;
    use crate::store::{Existing, Folder};

    fn outcome(points: Vec<[f64; 2]>) -> Outcome {
        let mut values = Values { language: Language::En, ..Values::default() };
        let case = CASES.iter().find(|case| case.name == "full").unwrap();
        values.values.extend(case.values(Language::En));
        let source = Provenance { workbook: "case.xlsx".into(), sha256: "0".repeat(64), version: "1" };
        let mut outcome = kinds::run(&FORM, values, source).unwrap();
        let stroke = Stroke { ink: Ink::Cut, points, filled: false, arrow: false };
        outcome.drawings = [Some(Paper::A4), None]
            .into_iter()
            .zip(["wrap", "contour"])
            .map(|(paper, key)| Drawing {
                key,
                title: Text::same(key),
                figure: Figure {
                    letters: Figure::LETTERS,
                    key,
                    height: Figure::HEIGHT,
                    caption: Text::same(""),
                    axes: None,
                    strokes: vec![stroke.clone()],
                    labels: Vec::new(),
                    legend: Vec::new(),
                },
                arcs: Vec::new(),
                paper,
            })
            .collect();
        outcome
    }

    fn item(folder: &Path) -> Item {
        Item { workbook: PathBuf::from("pipe.xlsx"), stem: "pipe".into(), folder: folder.to_owned() }
    }

    #[test]
    fn every_drawing_is_written_and_a_typst_that_is_missing_keeps_none_back() {
        let place = tempfile::tempdir().unwrap();
        let folder = Folder::open(place.path()).unwrap();
        let mut set = Set::new(&folder, &[], Existing::Replace);
        let (item, outcome) = (item(place.path()), outcome(vec![[0.0, 0.0], [300.0, 50.0]]));
        write(&item, &outcome, Language::En, &mut set).unwrap();
        let failed = print(&item, &outcome, Language::Es, &Typst::installed("/nowhere/typst"), &mut set).unwrap();
        assert_eq!(failed.len(), 1, "only what is printed needs typst");
        let what = &failed[0].what.es;
        assert!(what.starts_with("la plantilla «wrap» no se ha podido componer: no se puede ejecutar"), "{what}");
        let names: Vec<_> = set.written().map(|file| file.name.to_string_lossy().into_owned()).collect();
        assert_eq!(names, ["pipe-wrap.dxf", "pipe-wrap.svg", "pipe-contour.dxf", "pipe-contour.svg"]);
        let attached: Vec<_> = attachments(&item, &outcome, &set).into_iter().map(|file| file.name).collect();
        assert_eq!(attached, names);
    }

    #[test]
    fn a_drawing_that_is_no_drawing_is_a_fault() {
        let place = tempfile::tempdir().unwrap();
        let folder = Folder::open(place.path()).unwrap();
        let mut set = Set::new(&folder, &[], Existing::Replace);
        let refusal =
            write(&item(place.path()), &outcome(vec![[0.0, f64::NAN]; 2]), Language::En, &mut set).unwrap_err();
        assert_eq!(refusal.exit, Exit::Fault);
    }
}
