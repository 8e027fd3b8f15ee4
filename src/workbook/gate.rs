//! The gate: what a file must be before a spreadsheet reader may see it.
//!
//! calamine trusts its input: it reserves memory for a declared count, does not mind a wrong checksum, and takes a sheet
//! in UTF-16 for an empty one. Whatever it relies on is therefore looked at here first, with this module's own walk over
//! the same parts.

use quick_xml::events::Event;

use crate::escape::{excerpt, printable};
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::text::Text;

use super::limits;
use super::package::{Package, unreadable};
use super::xml::{self, attribute, damaged, raw};

/// How a sheet is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A sheet of cells.
    Cells,
    /// A sheet that is one chart or dialogue: it has no cells.
    Other,
}

/// A sheet as the workbook lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetEntry {
    /// Its name.
    pub name: String,
    /// The package's part that holds its cells.
    pub part: String,
    /// What it consists of.
    pub kind: Kind,
    /// Not shown to the user.
    pub hidden: bool,
}

/// A workbook that passed the gate.
#[derive(Debug)]
pub struct Gated<'a> {
    /// The package.
    pub package: Package<'a>,
    /// The sheets in their order.
    pub sheets: Vec<SheetEntry>,
    /// How many shared texts there are.
    pub strings: usize,
    /// Notes on the file.
    pub notes: Vec<Finding>,
}

/// Lets a workbook through, or says why not.
///
/// # Errors
/// [`Exit::Unreadable`] for what is no sound `.xlsx` (old `.xls`, password, `.ods`, `.xlsb`, text, a cut or damaged
/// package, a document type, missing parts), [`Exit::Limit`] for what exceeds [`limits`].
pub fn gate(bytes: &[u8]) -> Result<Gated<'_>, Refusal> {
    signature(bytes)?;
    let mut package = Package::open(bytes)?;
    format(&mut package)?;
    let (folder, workbook) = root(&mut package)?;
    let relations = relations(&mut package, &folder, &workbook)?;
    let sheets = sheets(&mut package, &folder, &workbook, &relations)?;
    let strings = strings(&mut package, &format!("{folder}sharedStrings.xml"))?;
    styles(&mut package, &format!("{folder}styles.xml"))?;
    structure(&mut package, &format!("{folder}theme/theme1.xml"), limits::ATTRIBUTE, |_, _| Ok(()))?;
    let mut notes = Vec::new();
    if package.has_ending("vbaproject.bin") {
        notes.push(Finding::note(
            Place::File,
            Text::fixed(
                "el libro lleva macros (.xlsm): ni se ejecutan ni se leen",
                "the workbook carries macros (.xlsm): they are neither run nor read",
            ),
        ));
    }
    Ok(Gated { package, sheets, strings, notes })
}

/// Judges the first bytes.
fn signature(bytes: &[u8]) -> Result<(), Refusal> {
    if bytes.is_empty() {
        return Err(refuse(
            Text::fixed("el archivo está vacío", "the file is empty"),
            Text::fixed("vuelva a copiarlo del original", "copy it again from the original"),
        ));
    }
    if bytes.starts_with(b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1") {
        return Err(refuse(
            Text::fixed(
                "es un .xls antiguo o un libro protegido con contraseña",
                "old .xls or password-protected workbook",
            ),
            Text::fixed(
                "guárdelo como libro de Excel (.xlsx) sin contraseña",
                "save it as an Excel workbook (.xlsx) without a password",
            ),
        ));
    }
    if !bytes.starts_with(b"PK") {
        let head: String = String::from_utf8_lossy(bytes.get(..64).unwrap_or(bytes)).chars().take(16).collect();
        let head = printable(head.lines().next().unwrap_or_default());
        return Err(refuse(
            say!(
                "no es un libro .xlsx (empieza por \"{head}\")",
                "this is not an .xlsx workbook (starts with \"{head}\")"
            ),
            Text::fixed(
                "ábralo en Excel o LibreOffice y guárdelo como .xlsx",
                "open it in Excel or LibreOffice and save it as .xlsx",
            ),
        ));
    }
    Ok(())
}

fn refuse(what: Text, remedy: Text) -> Refusal {
    Refusal::new(Exit::Unreadable, Finding::stop(Place::File, what, remedy))
}

/// Names the packages that are no `.xlsx`.
fn format(package: &mut Package<'_>) -> Result<(), Refusal> {
    let other = |name: &str| {
        refuse(
            say!("es un archivo {name}, no un libro .xlsx", "this is an {name} file, not an .xlsx workbook"),
            Text::fixed("guárdelo como .xlsx", "save it as .xlsx"),
        )
    };
    if let Some(mime) = package.part("mimetype", limits::STRUCTURE)? {
        let mime = String::from_utf8_lossy(&mime);
        if mime.contains("opendocument.spreadsheet") {
            return Err(other("OpenDocument (.ods)"));
        }
        return Err(other(&excerpt(mime.trim(), 60)));
    }
    if package.has("xl/workbook.bin") {
        return Err(other("Excel (.xlsb)"));
    }
    if package.has_beginning("word/") {
        return Err(other("Office (.docx)"));
    }
    if package.has_beginning("ppt/") {
        return Err(other("Office (.pptx)"));
    }
    if !package.has("[Content_Types].xml") {
        return Err(other("archive (.zip)"));
    }
    structure(package, "[Content_Types].xml", limits::ATTRIBUTE, |_, _| Ok(()))?;
    Ok(())
}

/// Walks a part that describes the workbook; false where it is missing. No attribute may have more than `attribute` bytes.
fn structure(
    package: &mut Package<'_>,
    part: &str,
    attribute: usize,
    mut visit: impl FnMut(usize, &Event<'_>) -> Result<(), Refusal>,
) -> Result<bool, Refusal> {
    let Some(bytes) = package.part(part, limits::STRUCTURE)? else {
        return Ok(false);
    };
    let text = xml::text(part, bytes)?;
    xml::walk(part, &text, |depth, event| {
        if let Event::Start(start) = event
            && let Some(long) = start.attributes().flatten().find(|one| one.value.len() > attribute)
        {
            let (name, most) = (excerpt(long.key.as_ref(), 40), attribute);
            return Err(limit(
                part,
                say!(
                    "el atributo {name} ocupa más de {most} bytes",
                    "the attribute {name} is longer than {most} bytes"
                ),
            ));
        }
        visit(depth, event)
    })?;
    Ok(true)
}

fn limit(part: &str, what: Text) -> Refusal {
    Refusal::new(Exit::Limit, Finding::stop(Place::Part(part.to_owned()), what, xml::save_again()))
}

/// The folder of the workbook part, and its name, from the package's own relationships.
fn root(package: &mut Package<'_>) -> Result<(String, String), Refusal> {
    let mut target = None;
    structure(package, "_rels/.rels", limits::ATTRIBUTE, |_, event| {
        if let Event::Start(start) = event
            && start.local_name().as_ref() == "Relationship"
            && raw(start, "Type").is_some_and(|kind| kind.ends_with("/relationships/officeDocument"))
        {
            target = attribute(start, "Target").or(target.take());
        }
        Ok(())
    })?;
    let target = target.ok_or_else(|| no_sheets("_rels/.rels"))?;
    let (folder, name) = target.split_at(target.rfind('/').map_or(0, |slash| slash + 1));
    let folder = folder.strip_prefix('/').unwrap_or(folder).to_owned();
    let name = if name.is_empty() { "workbook.xml" } else { name }.to_owned();
    if package.has(&format!("{folder}{name}")) {
        Ok((folder, name))
    } else {
        Err(no_sheets(&format!("{folder}{name}")))
    }
}

fn no_sheets(part: &str) -> Refusal {
    let name = excerpt(part, 80);
    unreadable(say!(
        "el libro no tiene hojas: falta {name}, o no nombra ninguna",
        "there are no sheets: {name} is missing or names none"
    ))
}

/// A relationship of the workbook part: its target and its type.
struct Relation {
    id: String,
    target: String,
    kind: String,
}

fn relations(package: &mut Package<'_>, folder: &str, workbook: &str) -> Result<Vec<Relation>, Refusal> {
    let part = format!("{folder}_rels/{workbook}.rels");
    let mut relations = Vec::new();
    let found = structure(package, &part, limits::ATTRIBUTE, |_, event| {
        if let Event::Start(start) = event
            && start.local_name().as_ref() == "Relationship"
            && let Some(id) = raw(start, "Id")
        {
            if relations.len() >= 2 * limits::SHEETS {
                return Err(limit(&part, Text::fixed("demasiadas relaciones", "too many relationships")));
            }
            relations.push(Relation {
                id: id.into_owned(),
                target: raw(start, "Target").unwrap_or_default().into_owned(),
                kind: raw(start, "Type").unwrap_or_default().into_owned(),
            });
        }
        Ok(())
    })?;
    if found { Ok(relations) } else { Err(no_sheets(&part)) }
}

fn sheets(
    package: &mut Package<'_>,
    folder: &str,
    workbook: &str,
    relations: &[Relation],
) -> Result<Vec<SheetEntry>, Refusal> {
    let part = format!("{folder}{workbook}");
    let mut sheets = Vec::new();
    structure(package, &part, limits::ATTRIBUTE, |_, event| {
        let Event::Start(start) = event else { return Ok(()) };
        if start.local_name().as_ref() != "sheet" {
            return Ok(());
        }
        let name = attribute(start, "name").unwrap_or_default();
        let shown = excerpt(&name, 80);
        let faulty =
            |es: &str, en: &str| damaged(&part, say!("la hoja \"{shown}\" {es}", "the sheet \"{shown}\" {en}"));
        if sheets.len() >= limits::SHEETS {
            return Err(limit(&part, Text::fixed("demasiadas hojas", "too many sheets")));
        }
        let hidden = match raw(start, "state").as_deref() {
            None | Some("visible") => false,
            Some("hidden" | "veryHidden") => true,
            Some(_) => return Err(faulty("tiene un estado desconocido", "has an unknown state")),
        };
        let id = start
            .attributes()
            .flatten()
            .filter(|one| one.key.local_name().as_ref() == "id")
            .last()
            .map(|one| one.value.into_owned())
            .unwrap_or_default();
        // The last relationship of an id counts.
        let relation = relations.iter().rev().find(|relation| relation.id == id);
        let relation = relation.ok_or_else(|| faulty("no tiene parte en el paquete", "has no part in the package"))?;
        let kind = match relation.kind.rsplit('/').next() {
            Some("worksheet") => Kind::Cells,
            Some("chartsheet" | "dialogsheet") => Kind::Other,
            _ => return Err(faulty("es de una clase que no se lee", "is of a kind that is not read")),
        };
        let target = &relation.target;
        let path = target.strip_prefix('/').map_or_else(|| format!("{folder}{target}"), str::to_owned);
        sheets.push(SheetEntry { name, part: path, kind, hidden });
        Ok(())
    })?;
    if sheets.is_empty() {
        return Err(no_sheets(&part));
    }
    if let Some(lost) = sheets.iter().find(|sheet| !package.has(&sheet.part)) {
        let (name, missing) = (excerpt(&lost.name, 80), excerpt(&lost.part, 80));
        return Err(damaged(
            &lost.part,
            say!(
                "falta la parte {missing} de la hoja \"{name}\"",
                "the part {missing} of the sheet \"{name}\" is missing"
            ),
        ));
    }
    Ok(sheets)
}

/// Counts the shared texts.
fn strings(package: &mut Package<'_>, part: &str) -> Result<usize, Refusal> {
    let Some(bytes) = package.part(part, limits::PART)? else {
        return Ok(0);
    };
    let text = xml::text(part, bytes)?;
    // Five bytes, `<si/>`, are the shortest text.
    let room = text.len() / 5;
    let mut count = 0_usize;
    let mut depth_of_text = None;
    xml::walk(part, &text, |depth, event| {
        match event {
            Event::Start(start) if start.local_name().as_ref() == "sst" => {
                let declared = raw(start, "uniqueCount").and_then(|value| value.trim().parse::<u128>().ok());
                let room = room.min(limits::STRINGS);
                if declared.is_some_and(|declared| u128::try_from(room).is_ok_and(|room| declared > room)) {
                    return Err(limit(
                        part,
                        Text::fixed(
                            "uniqueCount anuncia más textos de los que caben en la parte",
                            "uniqueCount announces more texts than the part can hold",
                        ),
                    ));
                }
            }
            Event::Start(start) if start.local_name().as_ref() == "si" => {
                if depth != 2 || depth_of_text.is_some() {
                    return Err(damaged(
                        part,
                        Text::fixed("la tabla de textos está dañada", "the table of shared texts is damaged"),
                    ));
                }
                depth_of_text = Some(depth);
                count += 1;
                if count > limits::STRINGS {
                    let most = limits::STRINGS;
                    return Err(limit(
                        part,
                        say!("el libro tiene más de {most} textos", "the workbook has more than {most} texts"),
                    ));
                }
            }
            Event::End(_) if depth_of_text == Some(depth) => depth_of_text = None,
            _ => {}
        }
        Ok(())
    })?;
    Ok(count)
}

/// Looks at the cell formats, which calamine copies into memory one by one.
fn styles(package: &mut Package<'_>, part: &str) -> Result<(), Refusal> {
    let mut formats = 0_usize;
    let mut within = false;
    structure(package, part, limits::FORMAT_ATTRIBUTE, |_, event| {
        if matches!(event, Event::End(end) if end.local_name().as_ref() == "cellXfs") {
            within = false;
        }
        let Event::Start(start) = event else { return Ok(()) };
        match start.local_name().as_ref() {
            "cellXfs" => within = true,
            "xf" if within => {
                formats += 1;
                if formats > limits::FORMATS {
                    let most = limits::FORMATS;
                    return Err(limit(
                        part,
                        say!("el libro tiene más de {most} formatos", "the workbook has more than {most} cell formats"),
                    ));
                }
            }
            "numFmt" => {
                let code = attribute(start, "formatCode").unwrap_or_default();
                if code.matches('[').count() > limits::BRACKETS {
                    return Err(limit(
                        part,
                        Text::fixed(
                            "un formato de número tiene demasiados corchetes",
                            "a number format has too many brackets",
                        ),
                    ));
                }
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(())
}
