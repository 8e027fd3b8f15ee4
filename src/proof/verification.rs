//! What the judges of a workbook kind answered: checks, findings, and the table of them.

use crate::finding::clause::OfProgram;
use crate::finding::figures::count;
use crate::finding::{Finding, Grade, Limit, Place, Raise, Rule};
use crate::gcode::interpreter::{Interpreter, Refused};
use crate::gcode::program::Program;
use crate::proof::Judged;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::{ChecksPassed, MemoryExceeded};
use crate::table::{Column, Index, Law, Print, Table};
use crate::text::{Text, many, t};

/// What came of the verification.
#[derive(Debug, Default)]
pub struct Verification {
    /// Every check of every program, in their order.
    pub checks: Vec<Check>,
    /// What there is to say beside the table.
    pub findings: Vec<Finding>,
}

/// How the interpreter took the text: refused, or with each caution of it once. Of the rows of `answered` others speak.
#[must_use]
pub fn reading(program: &Program, text: &Interpreter<'_>, refused: Option<&Refused>, answered: &[&Rule]) -> Vec<Check> {
    let lines = text.lines();
    let name = t("Leído por el intérprete", "Read back by the interpreter");
    let value = many(lines, ["línea", "líneas"], ["line", "lines"]);
    let asked = Question::new("reading", name, program).showing(value, Text::same(program.control.name));
    let of_program =
        |found: Finding, place| found.with_clause(&OfProgram { title: program.title.clone() }).placed(place);
    if let Some(refused) = refused {
        let asked = asked.at(Some(At::line(refused.line))).seen(1);
        let found = Finding::from(refused.clone());
        return vec![asked.unless(Some(|place| of_program(found, place))).apart()];
    }
    let asked = asked.seen(lines);
    let mut told: Vec<&Rule> = Vec::new();
    let mut checks = Vec::new();
    for remark in text.remarks() {
        let rule = remark.rule();
        if remark.grade >= Grade::Caution && !answered.contains(&rule) && !told.contains(&rule) {
            told.push(rule);
            checks.push(asked.clone().unless(Some(|place| of_program(remark, place))).apart());
        }
    }
    if checks.is_empty() {
        checks.push(asked.passes());
    }
    checks
}

/// The caution for a program that its control may not hold.
fn too_long(program: &Program, bytes: u64, fewer: Text) -> Option<Finding> {
    let memory = program.control.text.memory;
    (bytes > memory).then(|| {
        let place = Place::Block { program: program.key, line: 1 };
        let told = MemoryExceeded { program: program.title.clone(), bytes, fewer }.at(place);
        let [value, most] = [bytes, memory].map(count);
        told.with(bytes.to_string(), memory.to_string()).measuring(value, Limit::AtMost(most))
    })
}

impl Verification {
    /// Takes in what came of a program. Stops are said for each program; what else there is to say, once. `fewer` is what makes
    /// it shorter.
    pub fn add(&mut self, program: &Program, judged: Judged, fewer: Text) {
        let Judged { checks, bytes, .. } = judged;
        let stopped = checks.iter().any(|check| check.grade() == Some(Grade::Stop));
        let held = checks.iter().filter(|check| check.grade().is_none()).count();
        for check in &checks {
            let same = |known: &Check| {
                let [one, other] =
                    [known, check].map(|check| (check.key(), check.grade(), check.finding().map(Finding::rule)));
                one == other
            };
            let said = self.checks.iter().any(same);
            if let Some(finding) = check.finding()
                && (finding.grade == Grade::Stop || !said)
            {
                self.findings.push(finding.clone());
            }
        }
        if !stopped {
            // The sentence names the program; no line of it is meant.
            let passed = ChecksPassed { program: program.title.clone() }.at(Place::File);
            self.findings.push(passed.with(held.to_string(), ""));
        }
        self.checks.extend(checks);
        self.findings.extend(too_long(program, bytes, fewer));
    }

    /// The table of the verification: a row for each check of each program.
    #[must_use]
    pub fn table(&self, programs: &[Program], source: Text) -> Table {
        let column = |symbol: Text, entry: &dyn Fn(&Check) -> Text| {
            Column::texts(symbol, Law::None, self.checks.iter().map(entry).collect())
        };
        let title = |check: &Check| {
            let program = programs.iter().find(|program| program.key == check.program());
            program.map_or_else(|| Text::same(check.program()), |program| program.title.clone())
        };
        Table {
            key: "verification",
            name: t("Verificación", "Verification"),
            title: t("Verificación de los programas", "Verification of the programs"),
            source,
            print: Print::Whole,
            index: Index::None,
            columns: vec![
                column(t("Programa", "Program"), &title),
                column(t("Comprobación", "Check"), &|check| check.name().clone()),
                column(t("Valor", "Value"), &|check| check.value().clone()),
                column(t("Límite", "Limit"), &|check| check.limit().clone()),
                column(t("Lugar", "Place"), &|check| check.at().map_or_else(|| Text::same(""), |at| at.words())),
                column(t("Resultado", "Verdict"), &Check::word),
            ],
        }
    }
}
