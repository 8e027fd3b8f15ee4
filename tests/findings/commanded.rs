//! Every row is raised by its own example: the commands, the folders and the documents.

use std::any::Any;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use rodete::cli::rows;
use rodete::drawing::{Drawing, template};
use rodete::figure::{Figure, Ink, Paper, Stroke};
use rodete::finding::{Example, Finding, Grade, Place, Rule};
use rodete::kinds::KINDS;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::FieldKind;
use rodete::parameter::Value;
use rodete::report::stationery::{Logo, Stationery, Template};
use rodete::report::{self, Attachment, Content, Role};
use rodete::store::sha256;
use rodete::text::{Language, Text};
use rodete::typeset::compiler::Typst;
use rodete::typeset::failure::ReportFailure;

use super::common;
use super::common::workbook::Parts;
use super::made::may_read_all;

/// The pieces of a row's sentence between its fields.
fn pieces(template: &str) -> Vec<&str> {
    template.split('{').flat_map(|piece| piece.split_once('}').map_or([piece, ""], |(_, rest)| [rest, ""])).collect()
}

/// What stands behind a sentence that a text begins with; none where it begins with another.
fn behind<'t>(template: &str, text: &'t str) -> Option<&'t str> {
    let mut pieces = pieces(template).into_iter();
    let mut rest = text.strip_prefix(pieces.next().unwrap_or_default())?;
    for piece in pieces {
        rest = &rest[rest.find(piece)? + piece.len()..];
    }
    Some(rest)
}

/// The word that a finding of a grade begins with, gravest first.
fn heads(language: Language) -> [(Grade, &'static str); 3] {
    [
        (Grade::Stop, "error"),
        (Grade::Caution, if language == Language::Es { "precaución" } else { "caution" }),
        (Grade::Note, if language == Language::Es { "nota" } else { "note" }),
    ]
}

/// True of a line that a finding begins with.
fn begins(line: &str, head: &str) -> bool {
    line.strip_prefix(head).is_some_and(|rest| {
        let code = rest.split(": ").next().unwrap_or_default();
        code.is_empty() || (code.len() == 6 && code.starts_with(' '))
    })
}

/// True where a text tells of a row, with its code and its remedy, and of nothing graver.
fn tells(rule: &Rule, text: &str, language: Language) -> bool {
    let lines = || text.match_indices('\n').map(|(at, _)| at + 1).chain([0]).map(|at| &text[at..]);
    let own = heads(language).into_iter().filter(|(grade, _)| *grade <= rule.grade).any(|(_, head)| {
        let head = format!("{head} {}: ", rule.code);
        lines().filter_map(|line| line.strip_prefix(head.as_str())).any(|told| {
            let rest = behind(rule.what.get(language), told);
            let remedy = pieces(rule.remedy.get(language));
            rest.is_some_and(|rest| {
                let mut rest = rest;
                remedy.iter().all(|piece| rest.find(piece).map(|at| rest = &rest[at + piece.len()..]).is_some())
            })
        })
    });
    let graver = heads(language).into_iter().filter(|(grade, _)| *grade > rule.grade);
    own && !graver.into_iter().any(|(_, head)| lines().any(|line| begins(line, head)))
}

/// Sentence and remedy of a row as a text tells them.
fn sentences(rule: &Rule, text: &str) -> (String, String) {
    let mut lines = text.lines().skip_while(|line| !line.contains(&format!(" {}: ", rule.code)));
    let what = lines.next().and_then(|line| line.split_once(": ")).map_or("", |(_, what)| what);
    let remedy = lines
        .take_while(|line| !heads(Language::En).iter().chain(&heads(Language::Es)).any(|(_, head)| begins(line, head)));
    let remedy =
        remedy.filter_map(|line| line.strip_prefix("hint: ").or_else(|| line.strip_prefix("sugerencia: "))).next();
    (what.to_owned(), remedy.unwrap_or_default().to_owned())
}

/// Runs a command in a folder: all that it prints. Where there is a folder `bin` in it, no other programs are at hand than those in that.
fn run(folder: &Path, words: &[String], language: Language) -> String {
    let mut rodete = Command::new(env!("CARGO_BIN_EXE_rodete"));
    if folder.join("bin").is_dir() {
        rodete.env("PATH", folder.join("bin"));
    }
    let output = rodete.current_dir(folder).args(words).args(["--lang", language.code()]).output().unwrap();
    [output.stderr, output.stdout].map(|text| String::from_utf8(text).unwrap()).concat()
}

/// A file's name as a notice holds it.
fn named(name: &str) -> serde_json::Value {
    serde_json::json!({ "Unix": name.as_bytes() })
}

/// The words of a command, and what must live as long as it runs.
type CommandWords = (Vec<String>, Option<Box<dyn Any>>);

/// Makes what an example's key stands for.
fn made(key: &str, folder: &Path) -> Option<CommandWords> {
    let path = |name: &str| folder.join(name);
    let put = |name: &str, text: &str| fs::write(path(name), text).unwrap();
    let view = "view part.nc";
    let mut held: Option<Box<dyn Any>> = None;
    put("part.nc", "G0 X1\nM30\n");
    let line = match key {
        "closed-folder" => {
            fs::create_dir(path("closed")).unwrap();
            fs::set_permissions(path("closed"), fs::Permissions::from_mode(0o555)).unwrap();
            "new impeller closed/impeller.xlsx".to_owned()
        }
        "link-to-nothing" => {
            symlink(path("nowhere"), path("out")).unwrap();
            "new impeller out/impeller.xlsx".to_owned()
        }
        "file-as-folder" | "no-folder" => {
            put("out", "x");
            format!("new impeller out/{}impeller.xlsx", if key == "no-folder" { "" } else { "part/" })
        }
        "long-output" => format!("new impeller {}/impeller.xlsx", "x".repeat(300)),
        "held" => {
            let lock = fs::File::create(path(".rodete.lock")).unwrap();
            lock.try_lock().unwrap();
            held = Some(Box::new(lock));
            "new impeller".to_owned()
        }
        "output-link" => {
            symlink(path("part.nc"), path("part.html")).unwrap();
            view.to_owned()
        }
        "output-folder" => {
            fs::create_dir(path("part.html")).unwrap();
            view.to_owned()
        }
        "input-as-output" => {
            put("part.html", "G0 X1\nM30\n");
            "view part.html -o part.html".to_owned()
        }
        "open-output" => {
            put("~$part.html", "");
            view.to_owned()
        }
        "illegible" => {
            put(".rodete-delivery.json", "x");
            "new impeller".to_owned()
        }
        "settled" | "mixed" => {
            put("a.nc", "new");
            let before = serde_json::json!({ "second": named(".rodete-b.tmp"), "sha256": sha256(b"old") });
            let new = serde_json::json!({ "name": named("a.nc"), "sha256": sha256(b"new"),
                "draft": named(".rodete-a.tmp"), "before": before });
            let lost = serde_json::json!({ "name": named("c.nc"), "sha256": sha256(b"lost"),
                "draft": named(".rodete-c.tmp"), "before": null });
            let files = if key == "mixed" { vec![new, lost] } else { vec![new] };
            put(".rodete-delivery.json", &serde_json::json!({ "files": files }).to_string());
            "new impeller".to_owned()
        }
        "leftover" => {
            fs::create_dir(path("out")).unwrap();
            put("out/turn-report.pdf", "x");
            put("turn.nc", TURNING);
            "simulate turn.nc --dialect fanuc-lathe-a -o out".to_owned()
        }
        "no-desktop" => {
            fs::create_dir(path("bin")).unwrap();
            fs::write(path("impeller.xlsx"), common::workbook::sound(Language::En)).unwrap();
            "build impeller.xlsx --no-report --open".to_owned()
        }
        "no-logo" | "no-templates" | "cmyk-logo" => {
            let named = common::workbook::Parts::sound().string("logo", "logo.svg").zip();
            let bare = common::workbook::sound(Language::En);
            fs::write(path("impeller.xlsx"), if key == "no-templates" { bare } else { named }).unwrap();
            if key == "cmyk-logo" {
                // By its first bytes, not by its name.
                let four = b"\xFF\xD8\xFF\xC0\0\x14\x08\0\x28\0\x28\x04\x01\x11\0\x02\x11\0\x03\x11\0\x04\x11\0";
                fs::write(path("logo.svg"), four).unwrap();
            }
            match key {
                "no-logo" | "cmyk-logo" => "build impeller.xlsx".to_owned(),
                _ => "build impeller.xlsx --templates nowhere".to_owned(),
            }
        }
        "changed-logo" => {
            let logo = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"4\"/>";
            put("logo.svg", logo);
            let named = common::workbook::Parts::sound().string("logo", "logo.svg").zip();
            fs::write(path("impeller.xlsx"), named).unwrap();
            run(folder, &["build", "impeller.xlsx", "--no-report"].map(str::to_owned), Language::En);
            put("logo.svg", &logo.replace('4', "5"));
            "check impeller-out/impeller-results.xlsx".to_owned()
        }
        "two-kinds" => {
            run(folder, &["new", "lathe"].map(str::to_owned), Language::En);
            run(folder, &["new", "impeller", "--case", "full"].map(str::to_owned), Language::En);
            "compare impeller.xlsx lathe.xlsx".to_owned()
        }
        "compare-over-book" => {
            for file in ["a.xlsx", "b.xlsx", "c.xlsx"] {
                run(folder, &["new", "impeller", "--case", "full", file].map(str::to_owned), Language::En);
            }
            "compare a.xlsx b.xlsx -o c.xlsx".to_owned()
        }
        "workbook-as-program" | "workbook-as-var" | "lathe-tools" => {
            run(folder, &["new", "lathe"].map(str::to_owned), Language::En);
            match key {
                "lathe-tools" => "verify part.nc --tools lathe.xlsx --dialect linuxcnc".to_owned(),
                "workbook-as-var" => "offsets lathe.xlsx".to_owned(),
                _ => "simulate lathe.xlsx".to_owned(),
            }
        }
        "large-subprogram" => {
            put("turn.nc", "M98 P1000\nM30\n");
            let large = rodete::workbook::limits::FILE + 1;
            fs::File::create(path("O1000.nc")).unwrap().set_len(large).unwrap();
            "simulate turn.nc --dialect fanuc-lathe-a".to_owned()
        }
        "long-var" | "long-line" => {
            let text = if key == "long-var" { "1 0\n".repeat(100_000) } else { format!("1 0{}\n", " ".repeat(300)) };
            put("linuxcnc.var", &text);
            "offsets linuxcnc.var".to_owned()
        }
        "endless-view" => {
            put("long.nc", &format!("G0 X1\n{}M30\n", "X1\nX2\n".repeat(500_001)));
            "view long.nc --dialect fagor-8055".to_owned()
        }
        _ => match variants(key, folder) {
            Some(line) => line.to_owned(),
            None => into(key, folder)?.to_owned(),
        },
    };
    Some((line.split(' ').map(str::to_owned).collect(), held))
}

/// Makes a workbook with variants, and says the command.
fn variants(key: &str, folder: &Path) -> Option<&'static str> {
    const LIMITS: [(&str, &str); 2] = [("method", "factorial"), ("level", "limits")];
    const BLADES: [&str; 6] = ["N", "", "", "", "3; 4; 5", ""];
    let list = [("method", "list"), ("level", "limits")];
    let put = |bytes: Vec<u8>| fs::write(folder.join("a.xlsx"), bytes).unwrap();
    let run = |line: &str| drop(run(folder, &line.split(' ').map(str::to_owned).collect::<Vec<_>>(), Language::En));
    put(common::workbook::with_variants(&LIMITS, &[BLADES], &[]));
    Some(match key {
        "sweep-without-sheet" => {
            put(common::workbook::sound(Language::En));
            "sweep a.xlsx"
        }
        "sweep-list" => {
            put(common::workbook::with_variants(&list, &[BLADES], &[&["N", "e"], &["4", "2"]]));
            "sweep a.xlsx --dry-run"
        }
        "sweep-list-gap" => {
            put(common::workbook::with_variants(&list, &[], &[&["N", "F"], &["4", ""]]));
            "sweep a.xlsx --dry-run"
        }
        "sweep-list-bare" => {
            put(common::workbook::with_variants(&list, &[], &[&["N", "", "e"], &["4", "7", "2"]]));
            "sweep a.xlsx --dry-run"
        }
        "sweep-list-empty" => {
            put(common::workbook::with_variants(&list, &[], &[&["N", "e"]]));
            "sweep a.xlsx --dry-run"
        }
        "sweep-list-wide" => {
            let far: [&str; 52] = std::array::from_fn(|at| if at == 0 || at == 51 { "4" } else { "" });
            put(common::workbook::with_variants(&list, &[], &[&["N"], &far]));
            "sweep a.xlsx --dry-run"
        }
        "sweep-many-inputs" => {
            let numbers = FORM.parameters().filter_map(|(_, one)| match one.kind {
                FieldKind::Real { min, max } => Some((one, min, max)),
                FieldKind::Whole { min, max } => Some((one, f64::from(min), f64::from(max))),
                _ => None,
            });
            let inputs: Vec<[String; 4]> = numbers
                .take(21)
                .map(|(one, min, max)| [one.symbol().to_owned(), min.to_string(), max.to_string(), String::new()])
                .collect();
            let inputs: Vec<[&str; 6]> = inputs
                .iter()
                .map(|[name, min, max, none]| [name, min, max, none, none, none].map(String::as_str))
                .collect();
            put(common::workbook::with_variants(
                &[("method", "saltelli"), ("samples", "8"), ("objectives", "N_max max")],
                &inputs,
                &[],
            ));
            "sweep a.xlsx --dry-run"
        }
        "sweep-other-plan" => {
            run("sweep a.xlsx -o s --chunk 0/1");
            "sweep a.xlsx -o s --limit 2"
        }
        "sweep-other-workbook" => {
            run("sweep a.xlsx -o s --chunk 0/1");
            fs::rename(folder.join("a.xlsx"), folder.join("b.xlsx")).unwrap();
            "sweep b.xlsx -o s --fresh"
        }
        "sweep-changed-since" => {
            run("sweep a.xlsx -o s --top 1");
            let top = fs::read_dir(folder.join("s/top")).unwrap().map(|entry| entry.unwrap().path());
            let design = top.min().unwrap();
            fs::write(design, "edited").unwrap();
            "sweep a.xlsx -o s --top 1"
        }
        "sweep-names-in-case" => {
            put(common::workbook::with_variants(
                &[("method", "factorial"), ("level", "limits"), ("objectives", "gap_true max")],
                &[["N", "", "", "", "4; 5", ""], ["n", "", "", "", "20; 40", ""]],
                &[],
            ));
            "sweep a.xlsx -o s --top 0"
        }
        "sweep-other-chunks" => {
            run("sweep a.xlsx -o s --chunk 0/2");
            "sweep a.xlsx -o s --chunk 0/3"
        }
        "sweep-missing" => {
            run("sweep a.xlsx -o s --chunk 0/2");
            "sweep a.xlsx -o s --merge"
        }
        "sweep-torn" => {
            run("sweep a.xlsx -o s --chunk 0/1");
            for entry in fs::read_dir(folder.join("s/chunks")).unwrap().map(|entry| entry.unwrap().path()) {
                if entry.extension().is_some_and(|ending| ending == "parquet") {
                    let bytes = fs::read(&entry).unwrap();
                    fs::write(&entry, &bytes[..bytes.len() - 9]).unwrap();
                }
            }
            "sweep a.xlsx -o s --chunk 0/1"
        }
        "sweep-none" => {
            put(common::workbook::with_variants(&LIMITS, &[["e", "50", "60", "5", "", ""]], &[]));
            "sweep a.xlsx -o s --top 0"
        }
        "sweep-rejected-whole" => {
            let inputs = [["e", "", "", "", "4; 4.25", ""], ["splitters", "", "", "", "no", ""]];
            put(common::workbook::with_variants(&LIMITS, &inputs, &[]));
            "sweep a.xlsx -o s --top 2"
        }
        "sweep-no-slurm" => "sweep a.xlsx -o s --submit slurm --chunks 1",
        _ => return None,
    })
}

/// An engineer's own workbook with a sheet of each name.
fn own(names: &[&str]) -> Parts {
    let mut workbook = rust_xlsxwriter::Workbook::new();
    for name in names {
        workbook.add_worksheet().set_name(*name).unwrap().write(0, 0, "own").unwrap();
    }
    Parts::of(&workbook.save_to_buffer().unwrap())
}

/// Makes a workbook that sheets are put into, and says the command.
fn into(key: &str, folder: &Path) -> Option<&'static str> {
    const BOOK: &str = "xl/workbook.xml";
    const LINKS: &str = "xl/_rels/workbook.xml.rels";
    const NEW: &str = "new impeller --into own.xlsx";
    let link = |kind: &str| {
        let space = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
        format!("<Relationship Id=\"own\" Type=\"{space}/{kind}\" Target=\"own.xml\"/></Relationships>")
    };
    let before_views = |element: &str| own(&["Notes"]).replace(BOOK, "<bookViews>", &format!("{element}<bookViews>"));
    let linked = |kind: &str| own(&["Notes"]).replace(LINKS, "</Relationships>", &link(kind));
    let form = || {
        run(folder, &["new", "impeller", "own.xlsx", "--case", "full"].map(str::to_owned), Language::En);
        Parts::of(&fs::read(folder.join("own.xlsx")).unwrap())
    };
    let (parts, line) = match key {
        "into-signed" => (own(&["Notes"]).put("_xmlsignatures/origin.sigs", ""), NEW),
        "into-locked" => (before_views("<workbookProtection lockStructure=\"1\"/>"), NEW),
        "into-revisions-locked" => (before_views("<workbookProtection lockRevision=\"true\"/>"), NEW),
        "into-shared" => (linked("revisionHeaders"), NEW),
        "into-strict" => {
            let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
            (own(&["Notes"]).replace(BOOK, main, "http://purl.oclc.org/ooxml/spreadsheetml/main"), NEW)
        }
        "into-template" => (own(&["Notes"]).replace("[Content_Types].xml", "sheet.main+xml", "template.main+xml"), NEW),
        "into-views" => {
            let parts = own(&["Notes"]);
            (parts.replace(BOOK, "</workbook>", "<customWorkbookViews/></workbook>"), NEW)
        }
        "into-no-styles" => (own(&["Notes"]).without("xl/styles.xml"), NEW),
        "into-formats" => {
            let formats = "<xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\"/>".repeat(65_489);
            (own(&["Notes"]).replace("xl/styles.xml", "</cellXfs>", &format!("{formats}</cellXfs>")), NEW)
        }
        "into-large" => {
            let listed = |number| format!("<sheet name=\"Own {number}\" sheetId=\"{number}\" r:id=\"rId1\"/>");
            let sheets: String = (2..=999).map(listed).collect();
            (own(&["Notes"]).replace(BOOK, "</sheets>", &format!("{sheets}</sheets>")), NEW)
        }
        "into-mark" => {
            let name = "<definedName name=\"rodete_sheet_summary\">DATA!$A$1</definedName><definedName name=\"rodete_title_summary\">\"own\"";
            let parts = form().replace(BOOK, "<definedNames>", &format!("<definedNames>{name}</definedName>"));
            (parts, "build own.xlsx --into --no-report")
        }
        "into-name" => {
            let parts = form().replace(BOOK, "name=\"torus_R\">", "name=\"torus_R\">2*");
            (parts, "build own.xlsx --into --no-report")
        }
        "into-form" => (form(), NEW),
        "into-list" => (own(&["TOOLS", "HERRAMIENTAS"]), "new lathe --into own.xlsx"),
        "into-macros" => (own(&["Notes"]).put("xl/vbaProject.bin", "own"), NEW),
        "into-read-only" => {
            let parts = own(&["Notes"]);
            let (from, to) = ("<workbookPr", "<fileSharing readOnlyRecommended=\"1\"/><workbookPr");
            (parts.replace(BOOK, from, to), NEW)
        }
        "into-precision" => (own(&["Notes"]).replace(BOOK, "<calcPr", "<calcPr fullPrecision=\"0\""), NEW),
        "into-results" => {
            let name = "<definedNames><definedName name=\"stale_inputs\">DATA!$C$1</definedName><definedName name=\"derived_k\">DATA!$Z$2</definedName>";
            (form().replace(BOOK, "<definedNames>", name), "build own.xlsx --into --no-report")
        }
        "into-kept" => {
            fs::write(folder.join("own.xlsx.bak"), "own").unwrap();
            (own(&["Notes"]), NEW)
        }
        "into-manual" => (own(&["Notes"]).replace(BOOK, "<calcPr", "<calcPr calcMode=\"manual\""), NEW),
        "into-links" => (linked("externalLink"), NEW),
        "into-copied" => {
            let turns_red = |formula: &str| {
                let rule = format!("<cfRule type=\"expression\" priority=\"1\"><formula>{formula}</formula></cfRule>");
                format!("</sheetData><conditionalFormatting sqref=\"A1\">{rule}</conditionalFormatting>")
            };
            // As sheets are written now, and as they were before they had a stamp.
            let stamped = turns_red("IF(EXACT(build_stamp,\"0123456789abcdef\"),FALSE,TRUE)");
            let earlier = turns_red("stale_inputs&lt;&gt;0");
            let own = own(&["Notes", "Earlier"]).replace("xl/worksheets/sheet1.xml", "</sheetData>", &stamped);
            (own.replace("xl/worksheets/sheet2.xml", "</sheetData>", &earlier), NEW)
        }
        "into-protected" => (own(&["Notes"]), NEW),
        _ => return None,
    };
    fs::write(folder.join("own.xlsx"), parts.zip()).unwrap();
    if key == "into-protected" {
        fs::set_permissions(folder.join("own.xlsx"), fs::Permissions::from_mode(0o444)).unwrap();
    }
    Some(line)
}

/// A turning program at which the example machine finds nothing.
const TURNING: &str = "G50 S2500\nT0101\nG97 S900 M3\nG0 X54. Z2.\nG1 X48. F0.2\nZ-20.\nX54.\nG0 X100. Z50.\nM30\n";

/// What a document that is set, or not, is told.
fn set(key: &str) -> Option<Vec<Finding>> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let script = |text: &str| {
        fs::write(path("typst"), format!("#!/bin/sh\n{text}\n")).unwrap();
        fs::set_permissions(path("typst"), fs::Permissions::from_mode(0o755)).unwrap();
        Typst::installed(path("typst"))
    };
    let report = |typst: &Typst, part: &str, stationery: &Stationery<'_>| {
        let outcome = common::outcome("tfg-2021", &[("part", Value::Line(part.to_owned()))]);
        fs::File::create(path("large")).unwrap().set_len(33 << 20).unwrap();
        let file = path("large");
        let attachment = Attachment {
            name: "large.xlsx".to_owned(),
            role: Role::Input,
            mime: "text/plain",
            description: Text::same("large"),
            content: Content::File(&file),
        };
        match report::typeset(&outcome, &[attachment], stationery, Language::En, typst) {
            Ok(report) => report.findings,
            Err(failure) => vec![failure.finding()],
        }
    };
    let bare = Stationery::default();
    let whole = "for word; do output=$word; done; printf '%%PDF-1.7\\n%%%%EOF\\n' > \"$output\"";
    Some(match key {
        "no-tmpdir" => vec![ReportFailure::Folder(std::io::ErrorKind::NotFound.into()).finding()],
        "no-json" => vec![ReportFailure::Json(serde_json::from_str::<f64>("NaN").unwrap_err()).finding()],
        "no-typst" => report(&Typst::installed("/nowhere/typst"), "a", &bare),
        "false-typst" => report(&script("exit 1"), "a", &bare),
        "false-templates" => {
            let templates = [Template { path: "cover.typ".to_owned(), bytes: b"#nothing".to_vec() }];
            let stationery = Stationery { templates: &templates, ..Stationery::default() };
            report(&script("echo cover.typ:1:2: error: unknown variable: nothing >&2; exit 1"), "a", &stationery)
        }
        "endless-templates" => {
            let templates = [Template { path: "cover.typ".to_owned(), bytes: b"#while true {}".to_vec() }];
            let stationery = Stationery { templates: &templates, ..Stationery::default() };
            report(&script("sleep 60").with_deadline(std::time::Duration::from_millis(200)), "a", &stationery)
        }
        "false-built-in" => {
            script("exit 1");
            report(&Typst::embedded(path("typst")), "a", &bare)
        }
        "false-kind" => report(
            &script("echo 'style.typ:20:2: error: assertion failed: kind/labels.typ: title is missing' >&2; exit 1"),
            "a",
            &bare,
        ),
        "false-logo" => {
            let logo = Logo::new("logo.png".to_owned(), b"\x89PNG\r\n\x1a\n".to_vec(), Place::File).ok();
            let stationery = Stationery { logo, ..Stationery::default() };
            report(&script(&format!("if [ -e logo.png ]; then exit 1; fi; {whole}")), "a", &stationery)
        }
        "misnamed-templates" => {
            let templates = &[Template { path: "cubierta.typ".to_owned(), bytes: Vec::new() }];
            report(&script(whole), "a", &Stationery { templates, ..Stationery::default() })
        }
        "large-attachment" => report(&script(whole), "a", &bare),
        "foreign-letters" => report(&script(whole), "\u{4e2d}", &bare),
        "wide-drawing" | "empty-drawing" => {
            let wide = if key == "wide-drawing" { 20_000.0 } else { f64::NAN };
            let points = vec![[0.0, 0.0], [wide, 20_000.0]];
            let stroke = Stroke { ink: Ink::Cut, points, filled: false, arrow: false };
            let (strokes, labels, legend) = (vec![stroke], Vec::new(), Vec::new());
            let figure = Figure {
                key: "wide",
                letters: Figure::LETTERS,
                caption: Text::same(""),
                height: 1.0,
                axes: None,
                strokes,
                labels,
                legend,
            };
            let (title, source) = (Text::same("wide"), common::source());
            let drawing = Drawing {
                figure: &figure,
                arcs: &[],
                title: &title,
                part: "",
                source: &source,
                language: Language::En,
            };
            let printed = template::pdf(&drawing, Paper::A4, &Typst::installed("/nowhere/typst"));
            vec![printed.unwrap_err().finding(&title)]
        }
        _ => return None,
    })
}

/// What is wrong with a row's example; nothing where it is of another test.
fn wrong(rule: &Rule) -> Option<String> {
    if let Example::Made { key, .. } = rule.example
        && let Some(findings) = set(key)
    {
        let own = findings.iter().find(|one| one.is(rule) && one.grade <= rule.grade);
        own.iter().for_each(|own| super::told::compare_finding(rule, own));
        let whole = own.is_some() && findings.iter().all(|one| one.grade <= rule.grade);
        return (!whole).then(|| format!("{} {}: {findings:?}", rule.code, rule.ident));
    }
    let mut told = Vec::new();
    for language in Language::ALL {
        let folder = tempfile::tempdir().unwrap();
        let (words, held) = match rule.example {
            Example::Command { files, words } => {
                for (name, lines) in files {
                    fs::write(folder.path().join(name), lines.replace('|', "\n") + "\n").unwrap();
                }
                (words.iter().map(|word| (*word).to_owned()).collect(), None)
            }
            // A full disk under standard output, workbooks and programs are those of other tests.
            Example::Made { key: "stdout-full", .. } => return None,
            Example::Made { key, .. }
                if rule.code.starts_with(['W', 'P', 'L'])
                    || key.starts_with("program-")
                    || key.starts_with("given-") =>
            {
                return None;
            }
            Example::Made { key, .. } => made(key, folder.path()).unwrap_or_else(|| panic!("nobody makes {key}")),
            _ => return None,
        };
        let text = run(folder.path(), &words, language);
        drop(held);
        if !tells(rule, &text, language) {
            return Some(format!("{} {}: rodete {}\n{text}", rule.code, rule.ident, words.join(" ")));
        }
        told.push(sentences(rule, &text));
    }
    let [(what_es, remedy_es), (what_en, remedy_en)] = told.try_into().unwrap();
    super::told::compare(rule, [&what_es, &what_en], [&remedy_es, &remedy_en]);
    None
}

#[test]
fn the_command_of_every_row_tells_it_in_both_languages_and_nothing_graver() {
    let all = may_read_all();
    let rules = rows(KINDS)
        .into_iter()
        .filter(|rule| !(all && matches!(rule.example, Example::Made { key: "closed-folder", .. })));
    let wrong: Vec<_> = rules.filter_map(wrong).collect();
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}
