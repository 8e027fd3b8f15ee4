//! The verification of an impeller: every program read back once, every judge asked.

use crate::finding::{Finding, Grade, Place};
use crate::gcode::interpreter::{Fault, Interpreter, NO_FEED};
use crate::gcode::program::Program;
use crate::impeller::blade::Blade;
use crate::impeller::design::{Design, Style};
use crate::impeller::figures::Curve;
use crate::impeller::splitter::Splitter;
use crate::number::grid::Milli;
use crate::table::{Column, Index, Table};
use crate::text::Text;
use crate::verify::agreement::{Agreement, Passes};
use crate::verify::arcs::Arcs;
use crate::verify::check::{At, Check, FAULT, Verdict};
use crate::verify::closure::{Closure, Turn};
use crate::verify::cutting::{Cutting, Known};
use crate::verify::feed::Feeds;
use crate::verify::step::watch;
use crate::verify::stock::Clear;
use crate::verify::text::read;
use crate::verify::travel::Axes;
use crate::verify::turning::Turning;

/// What came of the verification.
#[derive(Debug)]
pub struct Verification {
    /// Every check of every program, in their order.
    pub checks: Vec<Check>,
    /// What there is to say beside the table.
    pub findings: Vec<Finding>,
    /// How far the tip goes into the metal along each track, for the figure.
    pub curves: Vec<Curve>,
}

/// The geometry that programs are held against.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'a> {
    /// The design.
    pub design: &'a Design,
    /// The blade.
    pub blade: &'a Blade,
    /// The splitter, where there is one.
    pub splitter: Option<&'a Splitter>,
}

/// Reads the programs of an impeller back and judges them.
#[must_use]
pub fn verify(geometry: Geometry<'_>, programs: &[Program]) -> Verification {
    let mut known = Known::new(geometry);
    let mut verification = Verification { checks: Vec::new(), findings: Vec::new(), curves: Vec::new() };
    for program in programs {
        let checks = if program.key == "blank" {
            Vec::new()
        } else {
            judge(geometry, program, &mut program.read_back(), &mut known)
        };
        let characters = read(program);
        let bytes = characters.bytes();
        let text = characters.check();
        verification.add(program, checks, text);
        verification.findings.extend(too_long(program, bytes));
    }
    verification.curves = known.curves();
    verification
}

/// Judges the motions that a program's text gives. A text that the interpreter refuses is asked nothing else.
pub fn judge(geometry: Geometry<'_>, program: &Program, text: &mut Interpreter<'_>, known: &mut Known) -> Vec<Check> {
    let design = geometry.design;
    let mut agreement = Agreement::new(design.machine, expected(design, program));
    let mut closure = Closure::new(turn(design, program));
    let mut axes = Axes::new(&design.travel);
    let mut turning = Turning::default();
    let mut feeds = Feeds::new(design);
    let mut arcs = Arcs::default();
    let mut clear_moves = std::mem::take(&mut known.clear_moves);
    let mut clear = Clear::new(design, &mut clear_moves);
    let mut cutting = Cutting::new(geometry, known);
    let mut judges: [&mut dyn crate::verify::step::Judge; 8] =
        [&mut agreement, &mut closure, &mut axes, &mut turning, &mut feeds, &mut cutting, &mut clear, &mut arcs];
    let read = watch(program, &mut *text, &mut judges);
    let mut checks = vec![reading(program, text, read.as_ref().err().map(Box::as_ref))];
    if read.is_ok() {
        checks.extend(judges.iter_mut().flat_map(|judge| judge.checks(program)));
    }
    known.clear_moves = clear_moves;
    checks
}

/// How the interpreter took the text.
fn reading(program: &Program, text: &Interpreter<'_>, fault: Option<&Fault>) -> Check {
    let lines = text.lines();
    let name = Text::fixed("Leído de nuevo por el intérprete", "Read back by the interpreter");
    let value = Text::new(format!("{lines} líneas"), format!("{lines} lines"));
    let check = Check::passed("reading", name, program, value, Text::same(program.dialect.name));
    if let Some(fault) = fault {
        let at = At { line: fault.line, n: None, point: None };
        let what = Text::new(
            format!("el control no toma la línea {} de «{}»: {}", fault.line, program.title.es, fault.what.es),
            format!("the control does not take line {} of \"{}\": {}", fault.line, program.title.en, fault.what.en),
        );
        let remedy = if fault.remedy.is_empty() { FAULT } else { fault.remedy.clone() };
        return check.at(Some(at)).found(Verdict::Stop, what, remedy);
    }
    // Of feeds the judge of feeds speaks.
    match text.remarks().into_iter().find(|remark| remark.grade >= Grade::Caution && remark.what != NO_FEED) {
        None => check,
        Some(remark) => check.found(
            Verdict::Caution,
            Text::new(
                format!("«{}»: {}", program.title.es, remark.what.es),
                format!("\"{}\": {}", program.title.en, remark.what.en),
            ),
            remark.remedy,
        ),
    }
}

/// How many passes of each track a program should make.
fn expected(design: &Design, program: &Program) -> Passes {
    let N = usize::try_from(design.N).unwrap_or(usize::MAX);
    match program.key {
        "blade" => [1, 1, 0, 0],
        "splitter" => [0, 0, 1, 1],
        _ if design.splitters => [N; 4],
        _ => [N, N, 0, 0],
    }
}

/// The turn of C that a program should leave.
fn turn(design: &Design, program: &Program) -> Turn {
    match (design.style, program.key) {
        (Style::Annex, "blade" | "splitter") => {
            Turn::Exactly(Milli::round(360.0 / f64::from(design.N)).unwrap_or(Milli::ZERO))
        }
        _ => Turn::Whole,
    }
}

/// The caution for a program that its control may not hold.
fn too_long(program: &Program, bytes: u64) -> Option<Finding> {
    (bytes > program.dialect.memory).then(|| {
        Finding::caution(
            Place::Block { program: program.key, line: 1 },
            Text::new(
                format!(
                    "el programa «{}» ocupa {bytes} bytes, más que la memoria habitual del control",
                    program.title.es
                ),
                format!("program \"{}\" takes {bytes} bytes, more than the control's usual memory", program.title.en),
            ),
            Text::fixed("ejecútelo desde disco o red, o un n menor", "run it from disk or network, or a smaller n"),
        )
        .with(bytes.to_string(), program.dialect.memory.to_string())
    })
}

impl Verification {
    /// Takes the checks of a program. Stops are said for each program; what else there is to say, once.
    fn add(&mut self, program: &Program, mut checks: Vec<Check>, text: Check) {
        checks.push(text);
        let stopped = checks.iter().any(|check| check.verdict == Verdict::Stop);
        let held = checks.iter().filter(|check| check.verdict == Verdict::Passed).count();
        for check in &checks {
            let said = self.checks.iter().any(|known| known.key == check.key && known.verdict == check.verdict);
            if let Some(finding) = check.finding()
                && (check.verdict == Verdict::Stop || !said)
            {
                self.findings.push(finding);
            }
        }
        if !stopped {
            self.findings.push(
                Finding::new(
                    Grade::Note,
                    Place::Block { program: program.key, line: 1 },
                    Text::new(
                        format!(
                            "comprobaciones que cumple «{}», leído de nuevo: vea la tabla Verificación",
                            program.title.es
                        ),
                        format!(
                            "checks that \"{}\", read back, has passed: see the table Verification",
                            program.title.en
                        ),
                    ),
                    Text::fixed("", ""),
                )
                .with(held.to_string(), ""),
            );
        }
        self.checks.extend(checks);
    }

    /// The table of the verification: a row for each check of each program.
    #[must_use]
    pub fn table(&self, programs: &[Program]) -> Table {
        let column = |symbol: Text, entry: &dyn Fn(&Check) -> Text| {
            Column::texts(symbol, "", self.checks.iter().map(entry).collect())
        };
        let title = |check: &Check| {
            let program = programs.iter().find(|program| program.key == check.program);
            program.map_or_else(|| Text::same(check.program), |program| program.title.clone())
        };
        Table {
            key: "verification",
            name: Text::fixed("Verificación", "Verification"),
            title: Text::fixed("Verificación de los programas", "Verification of the programs"),
            source: Text::fixed(
                "Leída de los programas, bloque a bloque; las pistas se miden en el primer programa que las recorre",
                "Read back from the programs, block by block; tracks are measured in the first program that cuts them",
            ),
            index: Index::None,
            columns: vec![
                column(Text::fixed("Programa", "Program"), &title),
                column(Text::fixed("Comprobación", "Check"), &|check| check.name.clone()),
                column(Text::fixed("Valor", "Value"), &|check| check.value.clone()),
                column(Text::fixed("Límite", "Limit"), &|check| check.limit.clone()),
                column(Text::fixed("Lugar", "Place"), &|check| {
                    check.at.map_or_else(|| Text::same(""), |at| at.words())
                }),
                column(Text::fixed("Resultado", "Verdict"), &|check| check.verdict.name()),
            ],
        }
    }
}
