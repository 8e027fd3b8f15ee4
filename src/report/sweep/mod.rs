//! What came of a sweep as a PDF: what was varied, what came out, the best designs and their front, what each input does, cautions.

mod effects;

use std::collections::BTreeSet;

use serde::Serialize;

use super::number;
use super::stationery::Logo;
use super::svg::{Dots, dots};
use crate::figure::Axes;
use crate::finding::Finding;
use crate::kind::measure::{Level, Measure};
use crate::parameter::field::Chosen;
use crate::parameter::{FieldKind, Parameter, Value, Values, title_block};
use crate::sweep::plan::{Input, Levels, Method, Spread};
use crate::sweep::results::{Built, COLOURS, Coded, Results};
use crate::sweep::row::State;
use crate::sweep::table::{CAUTION, CODES, Cells, Column, FEASIBLE, FRONT, ID, STATE, plain};
use crate::table::Unit;
use crate::text::{Language, Text, t};
use crate::typeset;
use crate::typeset::characters::Words;
use crate::typeset::compiler::Typst;
use crate::typeset::failure::ReportFailure;

/// The typst template.
const TEMPLATE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/sweep.typ"));
/// Most rows of a table that are printed; the workbook has all.
const ROWS: usize = 40;
/// Most columns beside the first two that a table has across a page; more stand in a table below.
const ACROSS: usize = 10;
/// Most values of a list that are named one by one.
const NAMED: usize = 12;
/// Most figures.
const FIGURES: usize = 4;
/// Radii of a design and of one of the best, mm of paper.
const RADII: [f64; 2] = [0.5, 0.9];

/// What the report says of the workbook beside the results.
#[derive(Clone, Copy, Debug)]
pub struct Titled<'a> {
    /// The SHA-256 of its bytes.
    pub sha256: &'a str,
    /// Its values, the title block among them.
    pub values: &'a Values,
    /// The picture in the title block.
    pub logo: Option<&'a Logo>,
    /// What a person should know of the plan.
    pub notes: &'a [Finding],
}

#[derive(Serialize)]
struct Contents {
    language: &'static str,
    version: &'static str,
    sha256: String,
    title: String,
    part: String,
    logo: Option<&'static str>,
    page: [String; 2],
    /// The title block, row by row: what it is, what is given, and how many of twelve columns it takes.
    block: Vec<(String, String, u8)>,
    /// `note`, or `caution` where no design is feasible, or some of the best were rejected when they were built whole.
    grade: &'static str,
    verdict: String,
    chapters: Vec<Chapter>,
}

#[derive(Default, Serialize)]
struct Chapter {
    title: String,
    paragraphs: Vec<String>,
    figures: Vec<Figure>,
    tables: Vec<Table>,
}

impl Chapter {
    /// True where there is something below its title.
    fn filled(&self) -> bool {
        !self.paragraphs.is_empty() || !self.figures.is_empty() || !self.tables.is_empty()
    }
}

#[derive(Serialize)]
struct Table {
    columns: Vec<Heading>,
    rows: Vec<Vec<String>>,
    note: String,
}

#[derive(Clone, Serialize)]
struct Heading {
    name: String,
    unit: String,
    number: bool,
    /// It shares the width that is left.
    wide: bool,
}

#[derive(Serialize)]
struct Figure {
    file: String,
    caption: String,
    /// Colour and text of each kind of dot.
    legend: Vec<(&'static str, String)>,
}

/// Sets the report of a sweep; gives it with what is found of it: a logo that typst cannot draw.
///
/// # Errors
/// A [`ReportFailure`] where typst does not do its work.
pub fn pdf(
    results: &Results<'_>,
    titled: &Titled<'_>,
    language: Language,
    typst: &Typst,
) -> Result<(Vec<u8>, Vec<Finding>), ReportFailure> {
    match (set(results, titled, language, typst), titled.logo) {
        (Err(failure), Some(logo)) if failure.refused() => {
            let pdf = set(results, &Titled { logo: None, ..*titled }, language, typst)?;
            Ok((pdf, vec![titled.values.locate(logo.not_drawn())]))
        }
        (set, _) => Ok((set?, Vec::new())),
    }
}

fn set(
    results: &Results<'_>,
    titled: &Titled<'_>,
    language: Language,
    typst: &Typst,
) -> Result<Vec<u8>, ReportFailure> {
    let mut setter = Setter { results, titled, words: Words::new(language), pictures: Vec::new() };
    let contents = setter.contents();
    let mut files = vec![
        ("sweep.typ".to_owned(), TEMPLATE.as_bytes().to_vec()),
        ("contents.json".to_owned(), serde_json::to_vec(&contents)?),
    ];
    files.append(&mut setter.pictures);
    files.extend(titled.logo.map(|logo| (logo.file().to_owned(), logo.bytes().to_vec())));
    typeset::document(&files, typst)
}

/// The contents as they come about.
struct Setter<'a> {
    results: &'a Results<'a>,
    titled: &'a Titled<'a>,
    words: Words,
    /// Figures as files by name.
    pictures: Vec<(String, Vec<u8>)>,
}

impl Setter<'_> {
    fn contents(&mut self) -> Contents {
        let Titled { sha256, values, logo, .. } = *self.titled;
        let refuted = self.results.refuted().map(|one| format!(". {}", self.words.text(&one)));
        let chapters = vec![self.varied(), self.came_out(), self.best(), self.inputs(), self.cautions()];
        Contents {
            language: self.words.language.code(),
            version: env!("CARGO_PKG_VERSION"),
            sha256: sha256.to_owned(),
            title: self.words.text(&t("Informe del barrido", "Report of the sweep")),
            part: self.words.line(values.line(self.results.plan.form.part)),
            logo: logo.map(Logo::file),
            page: [t("Página", "Page"), t("de", "of")].map(|one| self.words.text(&one)),
            block: self.block(),
            grade: if self.results.counts.feasible > 0 && refuted.is_none() { "note" } else { "caution" },
            verdict: self.words.text(&self.results.counted()) + &refuted.unwrap_or_default(),
            chapters: chapters.into_iter().filter(Chapter::filled).collect(),
        }
    }

    fn block(&mut self) -> Vec<(String, String, u8)> {
        let Titled { sha256, values, .. } = *self.titled;
        let form = self.results.plan.form;
        let material = form.material.map_or("", |material| values.line(material));
        let own = |field: &'static Parameter| field.meaning.clone();
        [
            (own(&title_block::CUSTOMER.row), values.line(&title_block::CUSTOMER), 4),
            (own(&title_block::DRAWING.row), values.line(&title_block::DRAWING), 4),
            (own(&title_block::REVISION.row), values.line(&title_block::REVISION), 2),
            (t("Fecha", "Date"), values.line(&title_block::DATE), 2),
            (t("Pieza", "Part"), values.line(form.part), 4),
            (t("Material", "Material"), material, 2),
            (t("Elaborado", "Prepared by"), values.line(&title_block::AUTHOR), 3),
            (t("Revisado", "Checked by"), values.line(&title_block::CHECKER), 3),
            (t("Libro de datos", "Workbook"), self.results.source, 4),
            (t("SHA-256 del libro", "SHA-256 of the workbook"), sha256, 8),
        ]
        .map(|(name, given, columns)| (self.words.text(&name), self.words.line(given), columns))
        .into()
    }

    fn heading(&mut self, name: &Text, unit: &str, number: bool) -> Heading {
        Heading { name: self.words.text(name), unit: self.words.line(unit), number, wide: false }
    }

    /// The plan: how designs were chosen, and what each input may be.
    fn varied(&mut self) -> Chapter {
        let plan = self.results.plan;
        let (count, seed) = (plan.count, plan.seed);
        let method = plan.method.label();
        let judged = self.results.judged_by();
        let chance = if matches!(plan.method, Method::Latin | Method::Sobol | Method::Saltelli) {
            Text::new(format!(", seed = {seed}"), format!(", seed = {seed}"))
        } else {
            t("", "")
        };
        let mut paragraphs = vec![Text::new(
            format!("{count} diseños, method = {}{}. Cada uno se comprueba {}.", method.es, chance.es, judged.es),
            format!("{count} designs, method = {}{}. Each is checked {}.", method.en, chance.en, judged.en),
        )];
        let list = |name: Text, all: Vec<String>| {
            let all = all.join("; ");
            (!all.is_empty()).then(|| Text::new(format!("{}: {all}.", name.es), format!("{}: {all}.", name.en)))
        };
        let objectives = plan.objectives.iter().map(ToString::to_string).collect();
        let constraints = plan.constraints.iter().map(ToString::to_string).collect();
        paragraphs.extend(list(t("Objetivos", "Objectives"), objectives));
        paragraphs.extend(list(t("Restricciones", "Constraints"), constraints));
        let columns = vec![
            self.heading(&t("entrada", "input"), "", false),
            Heading { wide: true, ..self.heading(&t("significado", "meaning"), "", false) },
            self.heading(&t("en el libro", "in the workbook"), "", true),
            self.heading(&t("unidad", "unit"), "", false),
            Heading { wide: true, ..self.heading(&t("valores", "values"), "", false) },
        ];
        let rows = plan.inputs.iter().map(|input| self.input(input)).collect();
        Chapter {
            title: self.words.text(&t("Qué varía", "What varies")),
            paragraphs: paragraphs.iter().map(|one| self.words.text(one)).collect(),
            tables: vec![Table { columns, rows, note: String::new() }],
            ..Chapter::default()
        }
    }

    fn input(&mut self, input: &Input) -> Vec<String> {
        let parameter = input.parameter;
        let here = self.titled.values.values.get(parameter.key).map(|value| self.value(parameter, value));
        let levels = match &input.levels {
            Levels::Steps { from, step, count } => {
                let last = input.level(count.saturating_sub(1));
                let to = last.map(|value| self.value(parameter, &value)).unwrap_or_default();
                let (from, step) = (number::trimmed(*from, 6), number::trimmed(*step, 6));
                Text::new(
                    format!("de {from} a {to}, paso {step}: {count}"),
                    format!("{from} to {to}, step {step}: {count}"),
                )
            }
            Levels::Values(values) if values.len() <= NAMED => {
                let values: Vec<String> = values.iter().map(|value| self.value(parameter, value)).collect();
                Text::new(values.join("; "), values.join("; "))
            }
            Levels::Values(values) => {
                let count = values.len();
                Text::new(format!("{count} valores"), format!("{count} values"))
            }
            Levels::Range { from, to, spread } => {
                let [from, to] = [from, to].map(|end| number::trimmed(*end, 6));
                let spread = match spread {
                    Spread::Uniform => String::new(),
                    Spread::Normal { mean, deviation } => {
                        format!(", normal {} {}", number::trimmed(*mean, 6), number::trimmed(*deviation, 6))
                    }
                };
                Text::new(format!("de {from} a {to}{spread}"), format!("{from} to {to}{spread}"))
            }
        };
        vec![
            self.words.line(&input.symbol()),
            self.words.text(&parameter.meaning),
            here.unwrap_or_default(),
            self.words.line(parameter.unit.label()),
            self.words.text(&levels),
        ]
    }

    fn value(&mut self, parameter: &Parameter, value: &Value) -> String {
        match value {
            Value::Real(value) => number::trimmed(*value, 6),
            Value::Whole(value) => value.to_string(),
            Value::Line(line) => self.words.line(line),
            Value::Choice(key) => match &parameter.kind {
                FieldKind::Choice(choices) => choices
                    .iter()
                    .find(|one| one.key == *key)
                    .map_or_else(|| (*key).to_owned(), |one| self.words.text(&one.label)),
                _ => (*key).to_owned(),
            },
        }
    }

    /// Why designs are not good.
    fn came_out(&mut self) -> Chapter {
        let Results { why, plan, .. } = *self.results;
        let told = if why.is_empty() {
            t("Todos los diseños valen.", "Every design is feasible.")
        } else {
            t(
                "Cada diseño que no vale cuenta una vez, por su primer motivo. rodete explain CÓDIGO lo explica.",
                "Each design that is not good counts once, by its first reason. rodete explain CODE explains it.",
            )
        };
        Chapter {
            title: self.words.text(&t("Qué ha salido", "What came out")),
            paragraphs: vec![self.words.text(&told)],
            tables: self.codes(why, &t("motivo", "reason"), plan.count).into_iter().collect(),
            ..Chapter::default()
        }
    }

    /// Codes with how many of so many designs have each; `None` where there is none.
    fn codes(&mut self, codes: &[Coded], name: &Text, of: u64) -> Option<Table> {
        let columns = vec![
            self.heading(name, "", false),
            self.heading(&t("diseños", "designs"), "", true),
            self.heading(&t("parte", "share"), "%", true),
            Heading { wide: true, ..self.heading(&t("qué dice", "what it says"), "", false) },
        ];
        let row = |one: &Coded| {
            let share = 100.0 * count(one.count) / count(of.max(1));
            vec![
                self.words.line(&one.code),
                number::grouped(one.count),
                number::fixed(share, 1),
                self.words.text(&one.what),
            ]
        };
        let rows: Vec<Vec<String>> = codes.iter().take(ROWS).map(row).collect();
        (!rows.is_empty()).then(|| Table { columns, rows, note: self.left_out(codes.len()) })
    }

    /// How many rows are left out; empty where none are.
    fn left_out(&mut self, rows: usize) -> String {
        match rows.checked_sub(ROWS) {
            None | Some(0) => String::new(),
            Some(more) => self.words.text(&Text::new(
                format!("{more} más, en el libro del barrido"),
                format!("{more} more, in the workbook of the sweep"),
            )),
        }
    }

    /// The best designs, and how objectives stand to each other.
    fn best(&mut self) -> Chapter {
        let brief = self.results.brief();
        let rows = brief.rows();
        let mut chapter =
            Chapter { title: self.words.text(&t("Los mejores diseños", "The best designs")), ..Chapter::default() };
        if self.results.counts.feasible == 0 {
            chapter.paragraphs.push(self.words.text(&t("Ningún diseño vale.", "No design is feasible.")));
            return chapter;
        }
        self.figures(&mut chapter);
        if rows == 0 {
            return chapter;
        }
        for told in [
            self.results.listed(),
            t(
                "●: está en el frente. La columna «generado» da el código por el que rodete rechaza el diseño al generarlo entero; los que generó están en la carpeta top como libros calculados: antes de cortar uno, lea su libro de resultados.",
                "●: on the front. The column \"built\" has the code for which rodete rejects the design when it builds it whole; those that it built are in the folder top as workbooks: before you cut one, read its results workbook.",
            ),
        ] {
            chapter.paragraphs.push(self.words.text(&told));
        }
        let of = u64::try_from(self.results.tried().0).unwrap_or_default();
        chapter.tables.extend(self.codes(self.results.rejected, &t("rechazado por", "rejected for"), of));
        let shown = rows.min(ROWS);
        let filled = |column: &&Column| column.name == ID || (0..rows).any(|row| has(&column.cells, row));
        let mut columns: Vec<&Column> = brief.columns.iter().filter(filled).collect();
        // The mark of the front beside the index.
        columns.sort_by_key(|one| (one.name != ID, one.name != FRONT));
        let Some((first, others)) = columns.split_first() else { return chapter };
        for part in others.chunks(ACROSS) {
            let of_part: Vec<&Column> = std::iter::once(*first).chain(part.iter().copied()).collect();
            let mut columns: Vec<Heading> = of_part.iter().map(|one| self.column(one)).collect();
            let decimals: Vec<usize> = of_part.iter().map(|one| self.decimals(one, shown)).collect();
            let mut rows: Vec<Vec<String>> = (0..shown)
                .map(|row| {
                    of_part.iter().zip(&decimals).map(|(one, decimals)| self.cell(one, row, *decimals)).collect()
                })
                .collect();
            // What the whole build said stands beside the index of every part.
            columns.insert(1, self.heading(&t("generado", "built"), "", false));
            rows.iter_mut().zip(self.results.built).for_each(|(row, built)| row.insert(1, self.whole(built.as_ref())));
            chapter.tables.push(Table { columns, rows, note: self.left_out(brief.rows()) });
        }
        chapter
    }

    /// What the whole build of a design said: yes, no, or the code that it was rejected for.
    fn whole(&mut self, built: Option<&Built>) -> String {
        match built.map(Built::stop) {
            Some(Some(stop)) => stop.code().to_owned(),
            Some(None) => self.words.text(&t("sí", "yes")),
            None => self.words.text(&t("no", "no")),
        }
    }

    fn column(&mut self, column: &Column) -> Heading {
        let name = match column.name.as_str() {
            FRONT => t("frente", "front"),
            CAUTION => t("precauciones", "cautions"),
            CODES => t("códigos", "codes"),
            name => Text::new(plain(name).to_owned(), plain(name).to_owned()),
        };
        let number = matches!(column.cells, Cells::Number(_) | Cells::Whole(_));
        Heading { wide: column.name == CODES, ..self.heading(&name, column.unit, number) }
    }

    fn cell(&mut self, column: &Column, row: usize, decimals: usize) -> String {
        match &column.cells {
            Cells::Truth(_) => if column.cells.truth(row) { "●" } else { "" }.to_owned(),
            Cells::Text(_) => {
                let text = column.cells.text(row).unwrap_or_default().to_owned();
                let input = self.results.plan.inputs.iter().find(|one| one.column() == column.name);
                match input.map(|one| &one.parameter.kind) {
                    Some(FieldKind::Choice(choices)) => choices
                        .iter()
                        .find(|one| one.key == text)
                        .map_or(text.clone(), |one| self.words.text(&one.label)),
                    _ => self.words.line(&text.replace(';', "; ")),
                }
            }
            cells => cells.number(row).map(|value| number::rounded(value, decimals)).unwrap_or_default(),
        }
    }

    /// The decimals of a column: of a measure those of its unit, of an input as it is planned; more where rows would look alike, but for
    /// lengths, angles and times: what lies beyond is rounding.
    fn decimals(&self, column: &Column, shown: usize) -> usize {
        let unit = self.measure(&column.name).map(|measure| measure.unit);
        if let Some(unit @ (Unit::Millimetre | Unit::Degree | Unit::Second)) = unit {
            return number::usable(unit);
        }
        let values: Vec<f64> = (0..shown).filter_map(|row| column.cells.number(row)).collect();
        number::telling(&values, unit.map_or(4, number::usable))
    }

    fn measure(&self, name: &str) -> Option<&'static Measure> {
        self.results.kind.measures().iter().find(|one| one.key == name)
    }

    /// Objectives over each other; a single one over each input.
    fn figures(&mut self, chapter: &mut Chapter) {
        let plan = self.results.plan;
        let keys: Vec<&str> = plan.objectives.iter().map(|one| one.measure.key).collect();
        let mut pairs: Vec<(String, &str)> = Vec::new();
        for (at, x) in keys.iter().enumerate() {
            pairs.extend(keys[at + 1..].iter().map(|y| ((*x).to_owned(), *y)));
        }
        if let [only] = keys.as_slice() {
            pairs.extend(plan.inputs.iter().map(|one| (one.column(), *only)));
        }
        for (x, y) in pairs {
            if chapter.figures.len() < FIGURES {
                chapter.figures.extend(self.figure(&x, y));
            }
        }
    }

    fn figure(&mut self, x: &str, y: &str) -> Option<Figure> {
        let Results { all, top, .. } = *self.results;
        let best: BTreeSet<u64> = top.ids().collect();
        let state = all.column(STATE)?;
        let done = |row: usize| state.text(row) == Some(State::Done.word());
        let (across, up, front) = (all.column(x)?, all.column(y)?, all.column(FRONT)?);
        let feasible = all.column(FEASIBLE)?;
        // What is drawn last lies on top.
        let [front_colour, best_colour, feasible_colour, broken_colour] = COLOURS;
        let kinds = [
            (broken_colour, RADII[0], t("incumplen una restricción", "a constraint is broken")),
            (feasible_colour, RADII[0], t("los demás diseños válidos", "other feasible designs")),
            (best_colour, RADII[1], t("otros de los mejores", "others of the best")),
            (front_colour, RADII[1], t("el frente", "the front")),
        ];
        let mut clouds = kinds.each_ref().map(|(colour, radius, _)| Dots { colour, radius: *radius, at: Vec::new() });
        for (row, id) in all.ids().enumerate() {
            let kind = match (front.truth(row), best.contains(&id)) {
                (true, _) => 3,
                (false, true) => 2,
                (false, false) => usize::from(feasible.truth(row)),
            };
            if !done(row) {
                continue;
            }
            if let (Some(x), Some(y)) = (across.number(row), up.number(row)) {
                clouds[kind].at.push([x, y]);
            }
        }
        let axes = Axes { x: self.axis(x), y: self.axis(y) };
        let picture = dots(&axes, &clouds, self.words.language)?;
        let file = format!("figure-{}.svg", self.pictures.len());
        self.pictures.push((file.clone(), picture.into_bytes()));
        let caption = Text::new(format!("{}; {}", axes.y.es, axes.x.es), format!("{}; {}", axes.y.en, axes.x.en));
        let shown = kinds.iter().zip(&clouds).rev().filter(|(_, dots)| !dots.at.is_empty());
        let legend = shown.map(|((_, _, text), dots)| (dots.colour, self.words.text(text))).collect();
        Some(Figure { file, caption: self.words.text(&caption), legend })
    }

    /// The title of an axis: what its column is called, and its unit.
    fn axis(&self, column: &str) -> Text {
        let unit = self.results.all.columns.iter().find(|one| one.name == column).map_or("", |one| one.unit);
        let name = self.results.name(column);
        if unit.is_empty() { name } else { Text::new(format!("{} ({unit})", name.es), format!("{} ({unit})", name.en)) }
    }

    /// What a person must judge before a design is cut.
    fn cautions(&mut self) -> Chapter {
        let Results { cautions, cut, counts, top, plan, .. } = *self.results;
        let mut texts: Vec<Text> = self.titled.notes.iter().map(|one| one.what.clone()).collect();
        if plan.level == Level::Limits {
            texts.push(t(
                "Los diseños se han comprobado por sus límites derivados: los programas de los que no se han generado enteros no están comprobados.",
                "The designs were checked by the derived limits: the programs of those that were not built whole are not checked.",
            ));
        }
        if cut {
            texts.push(t("El frente es más largo de lo que se marca.", "The front is longer than what is marked."));
        }
        if counts.failed > 0 {
            let failed = counts.failed;
            texts.push(Text::new(
                format!("rodete ha fallado en {failed} diseños; la columna message dice por qué: comuníquelo."),
                format!("rodete failed on {failed} designs; the column message says why: report it."),
            ));
        }
        let rows = u64::try_from(top.rows()).unwrap_or_default();
        if !cautions.is_empty() {
            texts.push(Text::new(
                format!("Precauciones de los {rows} mejores diseños:"),
                format!("Cautions of the best {rows} designs:"),
            ));
        }
        Chapter {
            title: self.words.text(&t("Precauciones", "Cautions")),
            paragraphs: texts.iter().map(|one| self.words.text(one)).collect(),
            tables: self.codes(cautions, &t("código", "code"), rows).into_iter().collect(),
            ..Chapter::default()
        }
    }
}

/// True where a cell holds something to be shown.
fn has(cells: &Cells, row: usize) -> bool {
    cells.number(row).is_some() || cells.truth(row) || cells.text(row).is_some_and(|text| !text.is_empty())
}

/// A count as a factor.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
const fn count(number: u64) -> f64 {
    number as f64
}
