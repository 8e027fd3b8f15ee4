//! A comparison as four tables: inputs, derived values, findings, programs. The terminal and the workbook show the same.

use super::{Block, Comparison, Derived, Found, Input, ProgramPair, Shown};
use crate::escape::{excerpt, printable};
use crate::finding::{CellPlace, Grade};
use crate::kind::checks;
use crate::machine::axis::Axis;
use crate::number::{decimal, shown};
use crate::text::{Language, Text, t};

/// What a cell holds.
#[derive(Clone, Debug, PartialEq)]
pub enum ComparedCell {
    /// It is empty.
    Nothing,
    /// A number.
    Number(f64),
    /// A text in both languages.
    Text(Text),
}

/// A row of a table of the comparison.
#[derive(Clone, Debug)]
pub struct ComparedRow {
    /// The cells, one for each heading.
    pub cells: Vec<ComparedCell>,
    /// What it compares is not the same.
    pub differs: bool,
}

/// The names of the tables.
pub static NAMES: [Text; 4] =
    [t("Entradas", "Inputs"), t("Derivados", "Derived"), t("Avisos", "Findings"), t("Programas", "Programs")];
/// Decimals of the figures shown.
const DECIMALS: usize = 6;
/// Most characters of a block that are shown.
const BLOCK: usize = 40;

impl ComparedRow {
    /// The cells as texts. Figures that differ do not look the same.
    #[must_use]
    pub fn texts(&self, language: Language) -> Vec<String> {
        let rounded = |one: &ComparedCell| match one {
            ComparedCell::Nothing => String::new(),
            ComparedCell::Number(number) => shown(*number, DECIMALS),
            ComparedCell::Text(text) => printable(text.get(language)),
        };
        let numbers: Vec<_> = self.cells.iter().filter(|one| matches!(one, ComparedCell::Number(_))).collect();
        let alike =
            self.differs && numbers.windows(2).any(|pair| pair[0] != pair[1] && rounded(pair[0]) == rounded(pair[1]));
        let whole =
            |one: &ComparedCell| if let ComparedCell::Number(number) = one { decimal(*number) } else { rounded(one) };
        self.cells.iter().map(|one| if alike { whole(one) } else { rounded(one) }).collect()
    }
}

/// A table of the comparison, on a sheet of its own.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The name of its sheet.
    pub name: Text,
    /// What it holds.
    pub title: Text,
    /// The headings, one for each column.
    pub headings: Vec<Text>,
    /// The rows below them.
    pub lines: Vec<ComparedRow>,
}

fn text(text: impl Into<String>) -> ComparedCell {
    let text = text.into();
    if text.is_empty() { ComparedCell::Nothing } else { ComparedCell::Text(Text::same(text)) }
}

fn number(value: Option<f64>) -> ComparedCell {
    value.map_or(ComparedCell::Nothing, ComparedCell::Number)
}

/// `one`, or `one / other` where the two are not the same.
fn both(pair: [Option<String>; 2]) -> String {
    match pair {
        [Some(one), Some(other)] if one == other => one,
        [one, other] => {
            let [one, other] = [one, other].map(|side| side.unwrap_or_else(|| "–".to_owned()));
            format!("{one} / {other}")
        }
    }
}

fn cell(place: &CellPlace) -> String {
    format!("{}!{}", place.sheet, place.cell)
}

fn input(one: &Input) -> ComparedRow {
    let value = |value: &Option<Shown>| match value {
        None => ComparedCell::Nothing,
        Some(Shown::Number(number)) => ComparedCell::Number(*number),
        Some(Shown::Text(text)) => ComparedCell::Text(text.clone()),
    };
    let cells = both(one.cells.each_ref().map(|place| place.as_ref().map(cell)));
    let cells = if one.cells == [None, None] { String::new() } else { cells };
    let cells = vec![
        ComparedCell::Text(one.symbol.clone()),
        value(&one.values[0]),
        value(&one.values[1]),
        text(one.unit.label()),
        text(cells),
        ComparedCell::Text(one.meaning.clone()),
    ];
    ComparedRow { cells, differs: true }
}

fn derived(one: &Derived) -> ComparedRow {
    let cells = vec![
        text(one.symbol),
        number(one.values[0]),
        number(one.values[1]),
        number(apart(one.values).filter(|_| one.differs())),
        text(one.unit.label()),
        ComparedCell::Text(one.meaning.clone()),
    ];
    ComparedRow { cells, differs: one.differs() }
}

fn found(one: &Found<'_>) -> ComparedRow {
    let finding = one.finding();
    let seen = match one.sides {
        [Some(_), None] => Text::same("A"),
        [None, _] => Text::same("B"),
        _ => Text::same("A, B"),
    };
    let said = |side: usize| {
        one.sides[side].map_or(ComparedCell::Nothing, |finding| {
            let [es, en] = [Language::Es, Language::En].map(|language| {
                let (what, [value, _]) = (finding.what.get(language), finding.shown(language));
                let known = value.is_empty() || what.contains(value);
                if known { what.to_owned() } else { format!("{what}: {value}") }
            });
            ComparedCell::Text(Text::new(es, en))
        })
    };
    let cells = vec![
        ComparedCell::Text(seen),
        ComparedCell::Text(finding.grade.name()),
        text(finding.code()),
        said(0),
        said(1),
        ComparedCell::Text(checks::place(&finding.place)),
    ];
    ComparedRow { cells, differs: one.differs() }
}

/// A count as a cell.
#[expect(clippy::cast_precision_loss, reason = "counts of motions and lines are far below 2^53")]
fn count(count: Option<u64>) -> ComparedCell {
    number(count.map(|count| count as f64))
}

fn program(one: &ProgramPair) -> Vec<ComparedRow> {
    let mut lines = Vec::new();
    let mut line = |what: Text, [a, b]: [ComparedCell; 2], apart: ComparedCell, differs: bool| {
        lines.push(ComparedRow { cells: vec![text(one.key), ComparedCell::Text(what), a, b, apart], differs });
    };
    let nothing = || [ComparedCell::Nothing, ComparedCell::Nothing];
    let verdict = match one.motions {
        [Some(_), Some(_)] if one.equal() => t("los mismos movimientos", "the same motions"),
        [Some(_), Some(_)] if one.moves_alike() => {
            t("los mismos movimientos, otras palabras", "the same motions, other words")
        }
        [Some(_), Some(_)] => t("los movimientos difieren", "other motions"),
        [Some(_), None] => t("solo en A", "only in A"),
        _ => t("solo en B", "only in B"),
    };
    line(verdict, nothing(), ComparedCell::Nothing, !one.equal());
    let [a, b] = one.motions;
    line(t("movimientos", "motions"), one.motions.map(count), ComparedCell::Nothing, a != b);
    if let Some(first) = one.first {
        let n = first.motion;
        let what = Text::new(format!("primero distinto, el {n}: línea"), format!("first other motion, {n}: line"));
        line(what, first.lines.map(|line| count(line.map(|line| line as u64))), ComparedCell::Nothing, true);
    }
    if let (Some(blocks), true) = (&one.words, one.moves_alike()) {
        let said = |block: &Option<Block>| {
            block
                .as_ref()
                .map_or(ComparedCell::Nothing, |block| text(format!("{}: {}", block.line, excerpt(&block.text, BLOCK))))
        };
        line(
            t("primer bloque distinto", "first other block"),
            blocks.each_ref().map(said),
            ComparedCell::Nothing,
            true,
        );
    }
    let named = |axis: Axis| {
        let letter = axis.letter();
        if one.turning && axis == Axis::X {
            Text::new(format!("{letter} (diámetro)"), format!("{letter} (diameter)"))
        } else {
            Text::same(letter)
        }
    };
    for apart in &one.apart {
        let unit = if apart.axis.rotary() { "°" } else { "mm" };
        let (axis, n) = (named(apart.axis), apart.motion);
        let what = Text::new(
            format!("mayor diferencia, {unit}: {}, el {n}", axis.es),
            format!("greatest apart, {unit}: {}, motion {n}", axis.en),
        );
        line(what, nothing(), ComparedCell::Number(apart.by), true);
    }
    for axis in Axis::ALL {
        let end = one.end.map(|end| end.map(|end| settled(end.get(axis))));
        let what = Text::new(format!("final {}", named(axis).es), format!("end {}", named(axis).en));
        if end.iter().flatten().any(|at| *at != 0.0) {
            line(what, end.map(number), number(apart(end)), end[0] != end[1]);
        }
    }
    for axis in Axis::ALL {
        let reach = one.extents.map(|extents| extents.map(|extents| extents.of(axis).map(settled)));
        let said = |reach: Option<[f64; 2]>| {
            reach.map_or(ComparedCell::Nothing, |[low, high]| text(format!("{} … {}", shown(low, 3), shown(high, 3))))
        };
        let what = Text::new(format!("recorrido {}", named(axis).es), format!("extent {}", named(axis).en));
        if reach.iter().flatten().any(|reach| *reach != [0.0, 0.0]) {
            line(what, reach.map(said), ComparedCell::Nothing, reach[0] != reach[1]);
        }
    }
    let seconds = one.seconds.map(|seconds| seconds.map(settled));
    line(t("tiempo, s", "time, s"), seconds.map(number), number(apart(seconds)), seconds[0] != seconds[1]);
    lines
}

/// A figure to six decimals: what is beyond them is the rounding of sums.
fn settled(value: f64) -> f64 {
    (value * 1e6).round() / 1e6 + 0.0
}

/// How far the second is from the first, where they are not the same.
fn apart(pair: [Option<f64>; 2]) -> Option<f64> {
    if let [Some(from), Some(to)] = pair { Some(to - from).filter(|by| *by != 0.0) } else { None }
}

impl Comparison<'_> {
    /// The four tables: inputs that differ; all derived values, findings and programs, with what differs marked.
    #[must_use]
    pub fn sheets(&self) -> [Sheet; 4] {
        let value = || [Text::same("A"), Text::same("B")];
        let [a, b] = value();
        let inputs =
            vec![t("Símbolo", "Symbol"), a, b, t("Unidad", "Unit"), t("Celda", "Cell"), t("Significado", "Meaning")];
        let [a, b] = value();
        let quantities =
            vec![t("Símbolo", "Symbol"), a, b, t("B − A", "B − A"), t("Unidad", "Unit"), t("Significado", "Meaning")];
        let [a, b] = value();
        let findings = vec![t("En", "In"), t("Grado", "Grade"), t("Código", "Code"), a, b, t("Lugar", "Place")];
        let [a, b] = value();
        let programs = vec![t("Programa", "Program"), t("Qué", "What"), a, b, t("Diferencia", "Difference")];
        let rank = |grade: Grade| std::cmp::Reverse(grade);
        let mut all: Vec<&Found<'_>> = self.findings.iter().collect();
        all.sort_by_key(|one| (!one.differs(), rank(one.finding().grade)));
        [
            Sheet {
                name: NAMES[0].clone(),
                title: t("Entradas que difieren", "Inputs that differ"),
                headings: inputs,
                lines: self.inputs.iter().map(input).collect(),
            },
            Sheet {
                name: NAMES[1].clone(),
                title: t("Valores derivados", "Derived values"),
                headings: quantities,
                lines: self.quantities.iter().map(derived).collect(),
            },
            Sheet {
                name: NAMES[2].clone(),
                title: t("Avisos y comprobaciones", "Findings and checks"),
                headings: findings,
                lines: all.into_iter().map(found).collect(),
            },
            Sheet {
                name: NAMES[3].clone(),
                title: t("Programas, movimiento a movimiento", "Programs, motion by motion"),
                headings: programs,
                lines: self.programs.iter().flat_map(program).collect(),
            },
        ]
    }
}
