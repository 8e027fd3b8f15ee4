//! `explain --all --markdown`: every finding on one page.

use std::fmt::Write;

use super::markdown::{headed, plain};
use super::row::{FOR_EXAMPLE, graded, shown};
use super::told::{self, ShownFinding};
use crate::finding::Rule;
use crate::kind::Kind;
use crate::text::{Language, Text, t};

/// The page of these rows, which are sorted by their codes.
pub(super) fn page(rows: &[&Rule], kinds: &[&dyn Kind], language: Language) -> String {
    let title = t("Mensajes de rodete", "Findings of rodete");
    let about = t(
        "Cada código con su gravedad, lo que dice, por qué, qué hacer y una entrada que lo provoca. Tras *por ejemplo* las cifras y los nombres son los de esa entrada; donde no hay ejemplo, hay puntos suspensivos en su lugar. Un código no cambia de significado ni se reutiliza. Esta página es la salida de `rodete explain --all --markdown --lang es`.",
        "Each code with its grade, what it says, why, what to do, and an input that raises it. After *for example* the figures and names are those of that input; where there is no example, an ellipsis stands for them. A code never changes its meaning and is never reused. This page is the output of `rodete explain --all --markdown --lang en`.",
    );
    let mut page = headed(&title, &about, language);
    let mut room = "";
    for rule in rows {
        let letter = rule.code.get(..1).unwrap_or_default();
        if letter != room {
            room = letter;
            let _ = write!(page, "\n## {room}: {}\n", room_of(letter).get(language));
        }
        let _ = write!(page, "\n### {} {}\n\n", rule.code, rule.name());
        let ShownFinding { what, remedy, example } = told::of(rule);
        let example = if example { format!(", {}", FOR_EXAMPLE.get(language)) } else { String::new() };
        let _ = writeln!(page, "**{}**{example}: {}", graded(rule, language), plain(what.get(language)));
        let _ = write!(page, "\n{}: {}\n", t("Por qué", "Why").get(language), plain(rule.why.get(language)));
        if !remedy.is_empty() {
            let _ = write!(page, "\n{}: {}\n", t("Remedio", "Remedy").get(language), plain(remedy.get(language)));
        }
        let mut example = String::new();
        shown(&mut example, rule, kinds, language);
        let lines: String =
            example.lines().map(|line| format!("{}\n", line.strip_prefix("  ").unwrap_or(line))).collect();
        let _ = write!(page, "\n```text\n{lines}```\n");
    }
    page
}

/// What the codes of each letter are of. K is nobody's in rodete, so that the codes of other binaries' kinds stay free.
pub(super) const ROOMS: [(&str, Text); 13] = [
    ("B", t("el libro en el que se ponen hojas", "the workbook that sheets are put into")),
    ("C", t("el control y lo que se escribe para él", "the control, and what is written for it")),
    ("D", t("los diseños de un barrido", "the designs of a sweep")),
    ("G", t("la lectura de programas", "the reading of programs")),
    ("K", t("los tipos de libro de fuera de rodete", "workbook kinds outside rodete")),
    ("L", t("el torno", "the lathe")),
    ("P", t("parámetros que se contradicen", "parameters that contradict each other")),
    ("S", t("el almacén de salidas", "the store of outputs")),
    ("T", t("la composición del informe", "the typesetting of the report")),
    ("U", t("el uso del comando", "the use of the command")),
    ("V", t("la verificación", "the proof")),
    ("W", t("el libro", "the workbook")),
    ("X", t("rodete mismo y el código de los tipos de libro", "rodete itself, and the code of workbook kinds")),
];

/// What the codes of a letter are of; no binary runs with a letter that is none of a room.
fn room_of(letter: &str) -> Text {
    ROOMS.iter().find(|(room, _)| *room == letter).map_or(t("", ""), |(_, of)| of.clone())
}
