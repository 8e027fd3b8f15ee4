//! What came of one design.

use crate::finding::rules::BrokeOff;
use crate::finding::{Exit, Finding, Grade, Refusal};
use crate::kind::measure::{Level, MeasuredOutcome};
use crate::kind::{Kind, Outcome, Provenance, Wants};
use crate::parameter::field::Fields;
use crate::parameter::{Value, Values};
use crate::sweep::plan::Plan;
use crate::text::Text;

/// How the work on a design ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It was done.
    Done,
    /// It contradicts itself, or a finding stops it.
    Refused,
    /// rodete failed.
    Failed,
}

impl State {
    /// Its word in the rows.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Refused => "refused",
            Self::Failed => "failed",
        }
    }
}

/// What came of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its index in the plan.
    pub id: u64,
    /// The values of its inputs.
    pub inputs: Vec<Value>,
    /// The measures of its kind, in their order.
    pub measures: Vec<Option<f64>>,
    /// How its work ended.
    pub state: State,
    /// It is done, every objective has a value, and no constraint is broken.
    pub feasible: bool,
    /// How many stops were found.
    pub stops: i64,
    /// How many cautions.
    pub cautions: i64,
    /// Their codes, each once, in the order of the codes.
    pub codes: Vec<&'static str>,
    /// Why it was not done: the code of the first stop; of one that is done, the constraint that is broken, or the objective
    /// that has no value.
    pub reason: Option<String>,
    /// The value that the reason found, where it is a number.
    pub value: Option<f64>,
    /// The limit that it was compared with.
    pub limit: Option<f64>,
    /// By how much it misses the limit: never positive.
    pub margin: Option<f64>,
    /// What a failure said.
    pub message: Option<String>,
}

/// The values of a workbook with those of a design's inputs in their place.
#[must_use]
pub fn values(base: &Values, plan: &Plan, inputs: &[Value]) -> Values {
    let mut values = base.clone();
    for (input, value) in plan.inputs.iter().zip(inputs) {
        values.values.insert(input.parameter.key, value.clone());
    }
    values
}

/// Works a design out, by its index or with other values of its inputs, and gives its row. It is a function of kind, workbook,
/// plan and these values alone.
#[must_use]
pub fn judged(kind: &dyn Kind, base: &Values, plan: &Plan, id: u64, inputs: Vec<Value>) -> Row {
    let mut row = Row::new(kind, id, inputs);
    let values = values(base, plan, &row.inputs);
    match (Fields::of(plan.form, values), plan.level) {
        (Err(refusal), _) => row.refused(&refusal),
        (Ok(fields), Level::Limits) => match kind.limits(&fields) {
            Ok(limits) => {
                row.found(&limits.findings);
                if limits.findings.iter().any(Finding::is_fault) {
                    row.fails(&limits.findings);
                }
                row.measured(
                    kind,
                    plan,
                    &MeasuredOutcome { quantities: &limits.quantities, ..MeasuredOutcome::default() },
                );
            }
            Err(refusal) => row.refused(&refusal),
        },
        (Ok(fields), Level::Program) => {
            match kind.run(fields, Vec::new(), source(), Wants { row: true, ..Wants::default() }) {
                Ok(outcome) => row.outcome(kind, plan, &outcome),
                Err(refusal) => row.refused(&refusal),
            }
        }
    }
    row
}

/// What is said of a design, with its number.
#[must_use]
pub fn of_design(id: u64, Text { es, en }: &Text) -> Text {
    Text::new(format!("diseño {id}: {es}"), format!("design {id}: {en}"))
}

/// The same of what a finding says.
#[must_use]
pub fn says(id: u64, finding: &Finding) -> Text {
    of_design(id, &finding.what)
}

/// What a design is told under a code, worked out anew; `None` where it is not.
#[must_use]
pub fn told(kind: &dyn Kind, base: &Values, plan: &Plan, id: u64, code: &str) -> Option<Text> {
    let findings = match (Fields::of(plan.form, values(base, plan, &plan.design(id))), plan.level) {
        (Err(refusal), _) => refusal.findings,
        (Ok(fields), Level::Limits) => {
            kind.limits(&fields).map_or_else(|refusal| refusal.findings, |limits| limits.findings)
        }
        (Ok(fields), Level::Program) => kind
            .run(fields, Vec::new(), source(), Wants { row: true, ..Wants::default() })
            .map_or_else(|refusal| refusal.findings, |outcome| outcome.findings),
    };
    findings.into_iter().find(|one| one.code() == code).map(|one| one.what)
}

/// What a design's programs are headed with: no workbook, so that no row depends on the name of one.
fn source() -> Provenance {
    Provenance { workbook: "sweep".to_owned(), sha256: "0".repeat(64), version: env!("CARGO_PKG_VERSION") }
}

impl Row {
    fn new(kind: &dyn Kind, id: u64, inputs: Vec<Value>) -> Self {
        Self {
            id,
            inputs,
            measures: vec![None; kind.measures().len()],
            state: State::Done,
            feasible: false,
            stops: 0,
            cautions: 0,
            codes: Vec::new(),
            reason: None,
            value: None,
            limit: None,
            margin: None,
            message: None,
        }
    }

    /// The row of a design on which rodete failed: with what it said, but not where in its source.
    #[must_use]
    pub fn failed(kind: &dyn Kind, id: u64, inputs: Vec<Value>, refusal: &Refusal) -> Self {
        let mut row = Self::new(kind, id, inputs);
        row.refused(refusal);
        row.state = State::Failed;
        row
    }

    fn outcome(&mut self, kind: &dyn Kind, plan: &Plan, outcome: &Outcome) {
        self.found(&outcome.findings);
        match outcome.exit() {
            Exit::Done => {}
            Exit::Fault => self.fails(&outcome.findings),
            _ => self.state = State::Refused,
        }
        self.measured(kind, plan, &MeasuredOutcome::of(outcome));
    }

    fn refused(&mut self, refusal: &Refusal) {
        self.found(&refusal.findings);
        self.state = State::Refused;
        if refusal.exit == Exit::Fault {
            self.fails(&refusal.findings);
        }
    }

    fn fails(&mut self, findings: &[Finding]) {
        self.state = State::Failed;
        let first = findings.iter().find(|one| one.grade == Grade::Stop);
        self.message = first.map(BrokeOff::without_place);
    }

    /// Takes in what was found.
    fn found(&mut self, findings: &[Finding]) {
        let count = |grade: Grade| findings.iter().filter(|one| one.grade == grade).count();
        let count = |grade: Grade| i64::try_from(count(grade)).unwrap_or(i64::MAX);
        (self.stops, self.cautions) = (count(Grade::Stop), count(Grade::Caution));
        self.codes = codes(findings);
        let Some(first) = findings.iter().find(|one| one.grade == Grade::Stop) else { return };
        self.state = State::Refused;
        self.reason = Some(first.code().to_owned());
        [self.value, self.limit] = first.figures().missed();
        self.margin = self.value.zip(self.limit).map(|(value, limit)| -(limit - value).abs());
    }

    /// Takes the measures, and compares them with the constraints.
    fn measured(&mut self, kind: &dyn Kind, plan: &Plan, known: &MeasuredOutcome<'_>) {
        let within = |level: Level| level <= plan.level;
        self.measures =
            kind.measures().iter().map(|one| if within(one.level) { one.of(known) } else { None }).collect();
        if self.state != State::Done {
            return;
        }
        let of = |key: &str| {
            let at = kind.measures().iter().position(|one| one.key == key)?;
            self.measures.get(at).copied().flatten()
        };
        let broken = plan.constraints.iter().find(|one| of(one.measure.key).is_none_or(|value| one.room(value) < 0.0));
        let unvalued = plan.objectives.iter().find(|one| of(one.measure.key).is_none());
        self.feasible = broken.is_none() && unvalued.is_none();
        if let Some(broken) = broken {
            let value = of(broken.measure.key);
            self.reason = Some(broken.to_string());
            (self.value, self.limit) = (value, Some(broken.bound));
            self.margin = value.map(|value| broken.room(value));
        } else if let Some(unvalued) = unvalued {
            self.reason = Some(unvalued.to_string());
        }
    }
}

/// The codes of stops and cautions, each once, in the order of the codes.
#[must_use]
pub fn codes(findings: &[Finding]) -> Vec<&'static str> {
    let mut codes: Vec<_> = findings.iter().filter(|one| one.grade > Grade::Note).map(Finding::code).collect();
    codes.sort_unstable();
    codes.dedup();
    codes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::sample::Stopped;
    use crate::finding::{Limit, Place, Raise};
    use crate::gcode::program::Program;
    use crate::proof::check::{Question, bounded};
    use crate::text::Text;

    #[test]
    fn of_a_value_between_two_bounds_the_stricter_one_counts() {
        let program = Program { title: Text::same("Finish"), ..Program::sample("finish") };
        let check = Question::new("splitters", Text::same("Clearance"), &program)
            .showing(bounded(-0.15, -0.14), Text::same("≥ -0.005 mm"))
            .seen(1)
            .measuring(-0.150_000_4)
            .against(Limit::AtLeast(-0.005))
            .holds(false, |place| Stopped { what: Text::same("cuts"), todo: Text::same("less") }.at(place));
        let found = check.finding().expect("a finding");
        assert_eq!(found.figures().missed(), [Some(-0.150_000_4), Some(-0.005)]);
    }

    #[test]
    fn a_message_names_no_file() {
        let at = "src/kinds/impeller/ribs.rs:120".to_owned();
        let found = BrokeOff::of("a point, of 3:4".to_owned(), at).at(Place::File);
        assert!(found.what.en.ends_with("a point, of 3:4, src/kinds/impeller/ribs.rs:120"), "{}", found.what.en);
        let said = BrokeOff::without_place(&found);
        assert!(said.starts_with("fault in rodete ") && said.ends_with(": a point, of 3:4"), "{said}");
        let other = Stopped { what: Text::same("no room, see:3"), todo: Text::same("less") }.at(Place::File);
        assert_eq!(BrokeOff::without_place(&other), "no room, see:3");
    }
}
