//! What the judges of a workbook kind answered: checks, findings, and the table of them.

use crate::finding::{Finding, Grade, Place};
use crate::gcode::interpreter::{Fault, Interpreter};
use crate::gcode::program::Program;
use crate::gcode::rules::modes::{NoFeed, NoSpeedLimit};
use crate::gcode::word::Word;
use crate::proof::check::{At, Check, FAULT, Verdict};
use crate::proof::text;
use crate::table::{Column, Index, Print, Table};
use crate::text::Text;

/// What came of the verification.
#[derive(Debug, Default)]
pub struct Verification {
    /// Every check of every program, in their order.
    pub checks: Vec<Check>,
    /// What there is to say beside the table.
    pub findings: Vec<Finding>,
}

/// How the interpreter took the text.
#[must_use]
pub fn reading(program: &Program, text: &Interpreter<'_>, fault: Option<&Fault>) -> Check {
    let lines = text.lines();
    let name = Text::fixed("Leído de nuevo por el intérprete", "Read back by the interpreter");
    let value = Text::new(format!("{lines} líneas"), format!("{lines} lines"));
    let check = Check::passed("reading", name, program, value, Text::same(program.control.name));
    if let Some(fault) = fault {
        let at = At { line: fault.line, n: None, point: None };
        let what = Text::new(
            format!("el control no toma la línea {} de «{}»: {}", fault.line, program.title.es, fault.what.es),
            format!("the control does not take line {} of \"{}\": {}", fault.line, program.title.en, fault.what.en),
        );
        let remedy = if fault.remedy.is_empty() { FAULT } else { fault.remedy.clone() };
        return check.at(Some(at)).found(Verdict::Stop, what, remedy);
    }
    // Of feeds and of the limit of the speed their judges speak.
    let theirs = [NoFeed::RULE, NoSpeedLimit::RULE];
    let own = |remark: &Finding| remark.grade >= Grade::Caution && !theirs.iter().any(|rule| remark.is(rule));
    match text.remarks().into_iter().find(own) {
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

/// The check that every motion is as planned: how many agreed, how many were planned, and where the first was another.
#[must_use]
pub fn as_planned(program: &Program, agreed: usize, planned: usize, different: Option<(At, Text)>) -> Check {
    let title = &program.title;
    let name = Text::fixed("Cada movimiento, como en el plan", "Every motion as planned");
    let value = Text::new(format!("{agreed} movimientos"), format!("{agreed} motions"));
    let check = Check::passed("agreement", name, program, value, Text::same(planned.to_string()));
    let ended = || {
        let what = Text::new(
            format!("el texto acaba tras {agreed} movimientos de {planned}"),
            format!("the text ends after {agreed} of {planned} motions"),
        );
        (At { line: 1, n: None, point: None }, what)
    };
    match different.or_else(|| (agreed != planned).then(ended)) {
        None => check,
        Some((at, what)) => check.at(Some(at)).found(
            Verdict::Stop,
            Text::new(
                format!("«{}» no es lo planeado en la {}: {}", title.es, at.words().es, what.es),
                format!("\"{}\" is not what was planned at {}: {}", title.en, at.words().en, what.en),
            ),
            FAULT,
        ),
    }
}

/// The check that the torch burns over the feed moves and over no rapid move, from the text. Of a program without the codes
/// that turn it on and off, as the published one, the moves are only counted.
#[must_use]
pub fn torch(program: &Program, codes: Option<[&[Word]; 2]>) -> Check {
    let name = Text::fixed("Antorcha: encendida solo en el corte", "Torch: on in the cut only");
    let written = |codes: &[Word]| {
        let mut block = String::new();
        codes.iter().for_each(|word| word.write(program.format, &mut block));
        block
    };
    let codes = codes.map(|codes| codes.map(written));
    let (mut burning, mut line, mut cuts, mut wrong) = (false, 0, 0, None);
    let mut lines = program.lines();
    while let Some((_, text)) = lines.next() {
        line += 1;
        let first = text.split(' ').next().unwrap_or_default();
        let rapid = matches!(first, "G0");
        let feed = matches!(first, "G1" | "G2" | "G3" | "G01" | "G02" | "G03");
        if let Some([on, off]) = &codes {
            burning = text == on || burning && text != off;
        }
        cuts += usize::from(feed);
        if feed != burning && (feed || rapid) {
            wrong.get_or_insert(line);
        }
    }
    if burning {
        wrong.get_or_insert(line);
    }
    let value = Text::new(format!("{cuts} movimientos de corte"), format!("{cuts} cutting moves"));
    let check = Check::passed("torch", name, program, value, Text::same(""));
    match wrong {
        _ if codes.is_none() => check.informing(),
        None => check,
        Some(line) => check.at(Some(At { line, n: None, point: None })).found(
            Verdict::Stop,
            Text::new(
                format!("la antorcha no está como debe en la línea {line}"),
                format!("the torch is not as it should be at line {line}"),
            ),
            FAULT,
        ),
    }
}

/// The caution for a program that its control may not hold.
fn too_long(program: &Program, bytes: u64) -> Option<Finding> {
    (bytes > program.control.text.memory).then(|| {
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
        .with(bytes.to_string(), program.control.text.memory.to_string())
    })
}

impl Verification {
    /// Takes the checks of a program, and those of its text as characters. Stops are said for each program; what else
    /// there is to say, once.
    pub fn add(&mut self, program: &Program, mut checks: Vec<Check>) {
        let characters = text::read(program);
        let bytes = characters.bytes();
        checks.push(characters.check());
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
        self.findings.extend(too_long(program, bytes));
    }

    /// The table of the verification: a row for each check of each program.
    #[must_use]
    pub fn table(&self, programs: &[Program], source: Text) -> Table {
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
            source,
            index: Index::None,
            print: Print::Whole,
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
