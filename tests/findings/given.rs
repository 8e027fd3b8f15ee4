//! Rows that no input raises, raised by what is given to those that say them: bounds to a judge in the place of those that it
//! searches for, and values to a form in the place of those that a workbook gives.

use rodete::finding::Finding;
use rodete::gcode::header::Origin;
use rodete::gcode::program::Program;
use rodete::kind::Provenance;
use rodete::kind::method::Method;
use rodete::kinds;
use rodete::kinds::impeller::clear::cut::{Job, Which};
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::clearance::{Bounds, WORK};
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::outside;
use rodete::kinds::impeller::parameters::FORM;
use rodete::kinds::impeller::proof::clear::ClearCutting;
use rodete::kinds::impeller::proof::flanks::{self, Clearance, Clearances};
use rodete::kinds::impeller::proof::stock::{BoundedMove, Clear};
use rodete::kinds::impeller::track::Track;
use rodete::kinds::impeller::{Impeller, cases::CASES};
use rodete::parameter::field::Fields;
use rodete::proof;
use rodete::proof::check::{At, Check, Question};
use rodete::proof::enclosed::{Enclosed, Remedy, Tolerance, bound};
use rodete::proof::step::{Judge, Steps};
use rodete::text::{Language, t};

use super::slips::values;

/// Bounds between which it is not decided whether the tool enters, mm.
const OPEN: [f64; 2] = [-0.02, 0.03];

/// A design of an impeller with its programs.
fn impeller(case: &str, cells: &[(&'static str, &'static str)]) -> (Design, Vec<Program>) {
    let design = Design::new(&Fields::of(&FORM, values(&CASES, Some(case), cells)).unwrap()).unwrap();
    let model = Impeller::model(&design).unwrap();
    let origin = Origin { workbook: "W.XLSX", sha256: "0", version: "0.0.0", language: Language::En };
    let programs = Impeller::programs(&design, &model, &origin).unwrap().programs;
    (design, programs)
}

fn named<'p>(programs: &'p [Program], key: &str) -> &'p Program {
    programs.iter().find(|program| program.key == key).unwrap()
}

fn found(checks: &[Check]) -> Vec<Finding> {
    checks.iter().filter_map(|check| check.finding().cloned()).collect()
}

/// What is told of the clearance of a pass along a track to blades, or to splitters.
fn flank(track: Track, fade: &'static str, to_splitters: bool, [lower, upper]: [f64; 2]) -> Vec<Finding> {
    let (design, programs) = impeller("full", &[("splitter_fade", fade)]);
    let bounds = Bounds { lower, upper, place: None, work: WORK };
    let met = Some(Clearance { bounds, other: 12.0, at: At::line(40) });
    let given = match to_splitters {
        true => Clearances { splitters: met, ..Clearances::default() },
        false => Clearances { blades: met, ..Clearances::default() },
    };
    let program = named(&programs, if track.of_splitter() { "splitter" } else { "blade" });
    found(&flanks::checks(&design, program, &[(track, given)]))
}

/// What is told where all moves outside the part come so near to the stock.
fn stock([lower, upper]: [f64; 2]) -> Vec<Finding> {
    let (design, programs) = impeller("full", &[]);
    let program = named(&programs, "blade");
    let mut known: Vec<BoundedMove> = Vec::new();
    let judged = |known: &mut Vec<BoundedMove>| {
        let judges: Vec<Box<dyn Judge + '_>> = vec![Box::new(Clear::new(&design, design.d_t, known))];
        let (plan, rapids) = (proof::step::Plan::of(program), Impeller::rapids(&design, program));
        found(&proof::of(program, program.setting(), plan, judges, &[], Impeller::ANSWERED, rapids).checks)
    };
    assert!(judged(&mut known).is_empty());
    assert!(!known.is_empty());
    known.iter_mut().for_each(|(_, bounds)| *bounds = outside::Bounds { lower, upper, work: 0 });
    judged(&mut known)
}

/// What is told where the finishing of a clear cut comes so near to the faces.
fn faces([lower, upper]: [f64; 2]) -> Vec<Finding> {
    let cells = [("splitters", "no"), ("c_s", "0.4"), ("kappa", "0.95"), ("tol", "0.01"), ("delta", "")];
    let (design, programs) = impeller("clear", &cells);
    let asked = design.clear.as_ref().unwrap();
    let plan = Plan::new(&Job::of(&design), &asked.cut).unwrap();
    let program = named(&programs, "finish");
    let mut judge = ClearCutting::new(&design, asked, &plan, Which::Finish);
    let (mut steps, mut text) = (Steps::new(proof::step::Plan::of(program)), program.read_back());
    while let Some(motion) = text.next() {
        judge.see(&steps.next(motion.unwrap(), *text.in_force()));
    }
    let bounds = Bounds { lower, upper, place: None, work: WORK };
    found(&[judge.faces_check(program, (bounds, At::line(1200)))])
}

/// What is told of a path that is off so much where it is looked at, and no more than so much between, mm.
fn path(off: f64, most: f64) -> Vec<Finding> {
    let mut enclosed = Enclosed::new([0.0], [0.022], 0);
    enclosed.take(At::line(30), &[0.0, 1.0], |_| [off], |_, _| [most], |one, _| *one);
    let (_, programs) = impeller("full", &[]);
    let [value, limit] = bound(enclosed.at_most(0), 0.022);
    let asked = Question::new("path", t("Trayectoria", "Path"), named(&programs, "blade")).showing(value, limit);
    let rest = t("por el redondeo de extremos y radios a 0.001 mm", "for the rounding of ends and radii to 0.001 mm");
    let what = t("los arcos se apartan de la curva exacta", "the arcs leave the exact curve by");
    found(&[enclosed.within(asked, 0, &Tolerance::of_arcs(0.02, 0.022, &rest), what, Remedy::Fault)])
}

/// What is told of the values of a form, some of them other.
fn form(cells: &[(&'static str, &'static str)]) -> Vec<Finding> {
    Fields::of(&FORM, values(&CASES, Some("full"), cells)).unwrap_err().findings
}

/// What is told of an end position farther than a program can say.
fn far() -> Vec<Finding> {
    let values = values(&CASES, Some("full"), &[("X_e", "150000")]);
    let source = Provenance { workbook: "W.XLSX".to_owned(), sha256: "0".to_owned(), version: "0.0.0" };
    match kinds::run(&FORM, values, source) {
        Ok(outcome) => outcome.findings,
        Err(refusal) => refusal.findings,
    }
}

/// What is told of what an example's key stands for.
pub fn told(key: &str) -> Vec<Finding> {
    match key {
        "given-blade" => flank(Track::Obverse, "each-side", false, OPEN),
        "given-published-splitter" => flank(Track::Out, "published", false, OPEN),
        "given-splitter" => flank(Track::Out, "each-side", false, OPEN),
        "given-splitters" => flank(Track::Out, "each-side", true, OPEN),
        "given-splitters-overlap" => flank(Track::Out, "each-side", true, [-0.21, -0.2]),
        "given-splitter-by-blade" => flank(Track::Obverse, "each-side", true, OPEN),
        "given-stock" => stock(OPEN),
        "given-near-stock" => stock([0.8, 1.9]),
        "given-faces" => faces(OPEN),
        "given-path" => path(0.019, 0.024),
        "given-missing" => form(&[("R", "")]),
        "given-mistyped" => form(&[("R", "ten")]),
        "given-far" => far(),
        _ => super::handed::told(key).unwrap_or_else(|| panic!("nobody gives {key}")),
    }
}
