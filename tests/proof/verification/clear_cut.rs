//! The judges of a clear cut: any finishing block that is shifted by 0.05 mm into the metal, and one fault at a time in the
//! text of its programs.
//!
//! Blocks are taken from the text's own positions. Where the tool touches, and what is into the metal there, is found on a
//! dense grid of points of faces, noses and rim, without the judges' search. `RODETE_SHIFTED=all` puts every block of the
//! first channel through the judges of the text, one by one; otherwise a few of each kind are, and every one through the
//! bounds alone.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;
use rodete::finding::Grade;
use rodete::gcode::header::Origin;
use rodete::gcode::program::{Program, Role};
use rodete::kind::method::Method;
use rodete::kinds::impeller::clear::cut::{Job, Which};
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::clear::programs::programs;
use rodete::kinds::impeller::clearance::{Stand, Until, WORK, Walls};
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::floor_depth::within;
use rodete::kinds::impeller::part::{Face, Part};
use rodete::kinds::impeller::proof::nose::Nose;
use rodete::kinds::impeller::sweep::Sweep;
use rodete::kinds::impeller::{self, Impeller};
use rodete::machine::axis::{Axis, Pose, Position};
use rodete::machine::rotary::TiltingTable;
use rodete::number::grid::Milli;
use rodete::parameter::Value;
use rodete::text::Language;

use crate::common;

/// By how much a block is shifted, mm.
const SHIFT: f64 = 0.05;
/// What the judges admit at the tolerance of the form, 0.01 mm.
const LIMIT: f64 = 0.011;
/// A tool this near to a face touches it: where the fit leaves a rest, it is no nearer.
const TOUCHING: f64 = 0.012;

/// A clear cut with its plan and its programs.
struct PlannedCut {
    design: Design,
    model: impeller::Model,
    plan: Plan,
    programs: Vec<Program>,
}

impl PlannedCut {
    /// The case `clear` with few lanes, written with positions.
    fn new(changes: &[(&'static str, Value)]) -> Self {
        let mut all = common::absolute(&[("c_s", Value::Real(0.4)), ("kappa", Value::Real(0.95))]);
        all.extend_from_slice(changes);
        let design = Design::new(&common::fields("clear", &all)).unwrap();
        let plan = Plan::new(&Job::of(&design), &design.clear.as_ref().unwrap().cut).unwrap();
        let origin = Origin { workbook: "", sha256: "", version: "", language: Language::En };
        let programs = programs(&design, &plan, &origin).unwrap().programs;
        Self { model: Impeller::model(&design).unwrap(), design, plan, programs }
    }

    fn program(&self, key: &str) -> &Program {
        self.programs.iter().find(|program| program.key == key).unwrap()
    }

    fn text(&self, key: &str) -> Vec<String> {
        self.program(key).text().lines().map(str::to_owned).collect()
    }

    /// The worst verdict of each check on a text in the place of a program's; `None` where it cannot be read to its end.
    fn verdicts(&self, key: &str, text: &[String]) -> BTreeMap<&'static str, Option<Grade>> {
        let checks = common::checks::<Impeller>(&self.design, &self.model, self.program(key), &text.join("\n"));
        let mut worst = BTreeMap::new();
        for check in checks {
            let known = worst.entry(check.key()).or_insert(check.grade());
            *known = check.grade().max(*known);
        }
        worst
    }
}

/// The finishing blocks of the first channel: key, line, and the positions before, at and after its end.
fn blocks(program: &Program) -> Vec<(&'static str, usize, [Position; 3])> {
    let moves: Vec<_> = program.moves().collect();
    let cuts = |at: usize| match moves[at].path.role {
        Role::Cut(key) => Some(key),
        Role::Clear | Role::Leave(_) => None,
    };
    let first = moves.iter().find(|one| matches!(one.path.role, Role::Cut(_))).unwrap();
    let whole = |turn: Milli| turn.thousandths().rem_euclid(360_000);
    let channel = whole(first.path.turn);
    let own = |at: &Position, turn: Milli| at.moved(Axis::C, Milli::ZERO - turn);
    (0..moves.len() - 1)
        .filter_map(|at| {
            let (one, next) = (&moves[at], &moves[at + 1]);
            let key = cuts(at).filter(|key| FINISHING.contains(key))?;
            let inside = whole(one.path.turn) == channel && cuts(at + 1).is_some() && next.step == one.step + 1;
            inside.then(|| {
                (
                    key,
                    one.line,
                    [own(&one.from, one.path.turn), own(&one.to, one.path.turn), own(&next.to, one.path.turn)],
                )
            })
        })
        .collect()
}

const FINISHING: [&str; 5] = ["floor", "obverse", "reverse", "contour", "splitter"];

fn stand(position: &Position) -> Stand {
    Stand::from(&Pose::from(*position))
}

/// Points of the faces of all blades, and of the splitters with their half rounds.
fn points(design: &Design, v_s: f64) -> [Vec<Vector3<f64>>; 2] {
    let part = Part::new(design);
    let pitch = TAU / f64::from(design.N);
    let turned = |x: Vector3<f64>, by: f64| {
        let (sin, cos) = by.sin_cos();
        Vector3::new(x.x * cos - x.y * sin, x.x * sin + x.y * cos, x.z)
    };
    let mut one_blade = Vec::new();
    let mut one_splitter = Vec::new();
    let take = |points: &mut Vec<Vector3<f64>>, x: Vector3<f64>| {
        if part.trimmed(&x) && (0.0..=part.a_p).contains(&part.depth(&x)) {
            points.push(x);
        }
    };
    for step in 0..=900 {
        let v = PI - 0.1 + (FRAC_PI_2 + 0.2) * f64::from(step) / 900.0;
        for face in Face::ALL {
            for h in 0..=14 {
                let x = part.ruling(face, v).at(-0.1 + (part.a_p + 0.3) * f64::from(h) / 14.0);
                take(&mut one_blade, x);
                if v >= v_s {
                    take(&mut one_splitter, x);
                }
            }
        }
    }
    let (P, frame) = part.frame(v_s);
    for step in 0..=120 {
        let (sin, cos) = (-FRAC_PI_2 + PI * f64::from(step) / 120.0).sin_cos();
        for h in 0..=14 {
            let deep = -0.1 + (part.a_p + 0.3) * f64::from(h) / 14.0;
            take(&mut one_splitter, P + (frame.b * sin - frame.t * cos) * (part.e / 2.0) - frame.N * deep);
        }
    }
    let all = |points: &[Vector3<f64>], offset: f64| {
        (0..design.N)
            .flat_map(|k| points.iter().map(move |x| turned(*x, pitch * f64::from(k) + offset)))
            .collect::<Vec<_>>()
    };
    [all(&one_blade, 0.0), all(&one_splitter, pitch / 2.0)]
}

/// Where from the tool's axis, across it, the nearest of some points lies.
fn nearest(machine: TiltingTable, at: &Stand, points: &[Vector3<f64>]) -> Option<[f64; 2]> {
    let seen = points.iter().map(|x| machine.to_machine(x, at.B, at.C) - at.at).filter(|x| x.z >= 0.0);
    let least = seen.min_by(|one, two| one.xy().norm_squared().total_cmp(&two.xy().norm_squared()))?;
    Some([least.x, least.y])
}

/// How deep the rim is below the floor, inside the blank.
fn below_floor(design: &Design, at: &Stand, a: f64) -> f64 {
    let part = Part::new(design);
    (0..360)
        .map(|turn| f64::from(turn).to_radians().sin_cos())
        .map(|(sin, cos)| design.machine.to_part(&(at.at + Vector3::new(cos, sin, 0.0) * a), at.B, at.C))
        .filter(|x| part.trimmed(x))
        .map(|x| part.depth(&x) - part.a_p)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// A finishing block that touches something, and the shift that takes it 0.05 mm into that.
#[derive(Clone, Copy)]
struct Shifted {
    key: &'static str,
    line: usize,
    at: [Position; 3],
    /// Of X, Y and Z.
    by: [f64; 3],
    /// What must find it.
    check: &'static str,
}

fn all_shifted(cut: &PlannedCut) -> Vec<Shifted> {
    let (design, v_s) = (&cut.design, cut.plan.told.splitter_from.unwrap());
    let a = design.mill(Which::Finish).d / 2.0;
    let [blades, splitters] = points(design, v_s);
    let mut found = Vec::new();
    for (key, line, at) in blocks(cut.program("finish")) {
        let here = stand(&at[1]);
        let shifted = |by: [f64; 3], check| Shifted { key, line, at, by, check };
        for (points, check) in [(&blades, "faces"), (&splitters, "splitters")] {
            let Some([x, y]) = nearest(design.machine, &here, points) else { continue };
            let far = x.hypot(y);
            if (far - a).abs() < TOUCHING {
                found.push(shifted([x / far * SHIFT, y / far * SHIFT, 0.0], check));
            }
        }
        if below_floor(design, &here, a) > -0.002 {
            found.push(shifted([0.0, 0.0, -SHIFT], "floor"));
        }
    }
    found
}

/// The positions about a block, it being shifted.
fn positions(one: &Shifted) -> [Position; 3] {
    let [before, at, after] = one.at;
    let axes = [Axis::X, Axis::Y, Axis::Z];
    let at = axes.into_iter().zip(one.by).fold(at, |at, (axis, by)| at.moved(axis, Milli::round(by).unwrap()));
    [before, at, after]
}

/// The text with one word of one line moved on.
fn moved(lines: &[String], line: usize, words: &[(char, f64)]) -> Vec<String> {
    let mut lines = lines.to_vec();
    let found =
        lines[line - 1].split(' ').map(|word| match words.iter().find(|(letter, _)| word.starts_with(*letter)) {
            Some((letter, by)) => {
                let value = (word[1..].parse::<f64>().unwrap() + by) + 0.0;
                format!("{letter}{:.3}", if value.abs() < 0.0005 { 0.0 } else { value })
            }
            None => word.to_owned(),
        });
    lines[line - 1] = found.collect::<Vec<_>>().join(" ");
    lines
}

#[test]
fn any_finishing_block_shifted_by_a_twentieth_into_the_metal_is_caught() {
    let cut = PlannedCut::new(&[]);
    let (design, v_s) = (&cut.design, cut.plan.told.splitter_from.unwrap());
    let text = cut.text("finish");
    let clean = cut.verdicts("finish", &text);
    for check in ["faces", "splitters", "floor", "agreement", "tool"] {
        assert_eq!(clean[check], None, "{check}");
    }
    let all = all_shifted(&cut);
    let pitch = TAU / f64::from(design.N);
    let turns = |offset: f64| (0..design.N).map(|k| pitch * f64::from(k) + offset).collect::<Vec<_>>();
    let radius = design.mill(Which::Finish).d / 2.0;
    let walls = |offset: f64, from: f64| Walls::new(Part::new(design), design.machine, radius, turns(offset), from);
    let (blades, splitters) = (walls(0.0, f64::MIN), walls(pitch / 2.0, v_s));
    let nose = Nose::new(design, v_s, radius);
    let mut kinds: BTreeMap<(&str, &str), Vec<&Shifted>> = BTreeMap::new();
    for one in &all {
        kinds.entry((one.key, one.check)).or_default().push(one);
        let at = positions(one);
        let stands = at.map(|at| stand(&at));
        let into = match one.check {
            "floor" => {
                let sweep = Sweep::through(0, design.machine, &at, 0.0);
                within(
                    design.torus,
                    design.a_p,
                    design.clear.as_ref().unwrap().cut.tool(Which::Finish),
                    &[sweep],
                    LIMIT,
                )
                .unwrap()
                .most
            }
            "faces" => -blades.clearance(&stands, Until::Within(0.0005), WORK).lower,
            _ => {
                let faces = splitters.clearance(&stands, Until::Within(0.0005), WORK).lower;
                let sweep = Sweep::through(0_usize, design.machine, &at, nose.reach());
                let ways = nose.ways(&sweep.stretches);
                let noses = turns(pitch / 2.0)
                    .into_iter()
                    .filter_map(|turn| nose.clearance((&sweep.stretches, &ways), turn, [0.1, 0.0005]))
                    .map(|bounds| bounds.lower);
                -noses.fold(faces, f64::min)
            }
        };
        assert!(into > LIMIT, "{} line {} {}: {into}", one.key, one.line, one.check);
    }
    // Each kind of pass touches what it is there for.
    for (key, check) in [
        ("floor", "floor"),
        ("obverse", "faces"),
        ("reverse", "faces"),
        ("contour", "splitters"),
        ("splitter", "splitters"),
    ] {
        assert!(kinds.get(&(key, check)).is_some_and(|found| found.len() > 10), "{key} {check}: {:?}", kinds.keys());
    }
    let every = std::env::var("RODETE_SHIFTED").is_ok_and(|which| which == "all");
    for ((key, check), found) in kinds {
        let step = if every { 1 } else { found.len().div_ceil(2) };
        for one in found.iter().step_by(step) {
            let [x, y, z] = one.by;
            let worst = cut.verdicts("finish", &moved(&text, one.line, &[('X', x), ('Y', y), ('Z', z)]));
            assert_eq!(
                (worst[check], worst["agreement"]),
                (Some(Grade::Stop), Some(Grade::Stop)),
                "{key} line {}: {check}",
                one.line
            );
        }
    }
}

/// A line in the middle of a pass of the first channel.
fn middle(cut: &PlannedCut, key: &str) -> usize {
    let lines: Vec<usize> =
        blocks(cut.program("finish")).into_iter().filter(|one| one.0 == key).map(|one| one.1).collect();
    lines[lines.len() / 2]
}

#[test]
fn one_fault_at_a_time_in_the_text_of_a_clear_cut_is_caught() {
    let cut = PlannedCut::new(&[("splitters", Value::Choice("no"))]);
    let text = cut.text("finish");
    let line = middle(&cut, "obverse");
    let replaced = |from: &str, to: &str| {
        let block = |one: &String| one.starts_with('N') && one.contains(from);
        let at = text.iter().position(block).unwrap_or_else(|| panic!("{from}"));
        let mut lines = text.clone();
        lines[at] = lines[at].replacen(from, to, 1);
        lines
    };
    let of_word = |letter: char| {
        let word = text[line - 1].split(' ').find(|word| word.starts_with(letter)).unwrap();
        word[1..].parse::<f64>().unwrap()
    };
    let without = |letter: char| {
        let mut lines = text.clone();
        let words: Vec<&str> = text[line - 1].split(' ').filter(|word| !word.starts_with(letter)).collect();
        lines[line - 1] = words.join(" ");
        lines
    };
    let dropped = {
        let mut lines = text.clone();
        lines.remove(line - 1);
        lines
    };
    let swapped = {
        let mut lines = text.clone();
        let [(one, one_words), (two, two_words)] = [line - 1, line].map(|at| text[at].split_once(' ').unwrap());
        lines[line - 1] = format!("{one} {two_words}");
        lines[line] = format!("{two} {one_words}");
        lines
    };
    let rapid = {
        let mut lines = text.clone();
        lines[line - 1] = lines[line - 1].replacen("G1", "G0", 1);
        lines
    };
    for (fault, lines, checks) in [
        ("the sign of a C", moved(&text, line, &[('C', -2.0 * of_word('C'))]), &["agreement", "faces"][..]),
        ("a block dropped", dropped, &["agreement", "characters"]),
        ("two blocks swapped", swapped, &["agreement"]),
        ("a feed lost", without('F'), &["agreement"]),
        ("a feed ten times as fast", moved(&text, line, &[('F', 9.0 * of_word('F'))]), &["agreement", "feed-tip"]),
        ("another tool", replaced("T2 D2", "T1 D2"), &["tool"]),
        ("the spindle the other way", replaced("M3", "M4"), &["tool"]),
        ("a tenth of the speed", replaced("S12000", "S1200"), &["tool"]),
        // The control would take a length up with Z: the judge of the tool stops it.
        ("a length offset", replaced("G44", "G43"), &["tool"]),
        ("C a turn too far", moved(&text, line, &[('C', 360.0)]), &["agreement", "turning"]),
        ("a cut at rapid", rapid, &["agreement"]),
        ("a millimetre too deep", moved(&text, line, &[('Z', -1.0)]), &["agreement", "floor"]),
    ] {
        assert_ne!(lines, text, "{fault}");
        let worst = cut.verdicts("finish", &lines);
        for check in checks {
            assert_eq!(worst.get(check).copied().flatten(), Some(Grade::Stop), "{fault}: {check} of {worst:?}");
        }
    }
}

#[test]
fn a_rapid_move_through_metal_of_a_clear_cut_is_caught() {
    let cut = PlannedCut::new(&[("splitters", Value::Choice("no"))]);
    for key in ["rough", "finish"] {
        let (program, text) = (cut.program(key), cut.text(key));
        let clean = cut.verdicts(key, &text);
        assert_eq!((clean["clear-moves"], clean["agreement"]), (None, None), "{key}");
        // After a pass the tool goes up; if it stays below, it crosses the part on its way to the next.
        let moves: Vec<_> = program.moves().collect();
        let up = moves.windows(3).find(|three| {
            let clear = three[1..].iter().all(|one| one.path.role == Role::Clear && one.path.rapid);
            let z = |at: &Position| at.get(Axis::Z).value();
            clear && matches!(three[0].path.role, Role::Cut(_)) && z(&three[1].to) > z(&three[1].from) + 1.0
        });
        // Roughing joins its run-outs without going up: there the turn at the end is taken 15 mm nearer.
        let (line, words) = match up {
            Some(three) => {
                let by = three[1].from.get(Axis::Z).value() - three[1].to.get(Axis::Z).value();
                (three[1].line, vec![('Z', by)])
            }
            None => {
                let link = moves
                    .windows(2)
                    .find(|two| matches!(two[0].path.role, Role::Cut(_)) && two[1].path.role == Role::Clear);
                (link.unwrap()[1].line, vec![('Z', -400.0)])
            }
        };
        let mut lines = moved(&text, line, &words);
        if up.is_some() {
            // The crossing stays as low.
            let by = words[0].1;
            let next = lines[line].clone();
            if next.contains('Z') {
                lines = moved(&lines, line + 1, &[('Z', by)]);
            }
        }
        assert_ne!(lines, text, "{key}");
        let worst = cut.verdicts(key, &lines);
        assert_eq!((worst["clear-moves"], worst["agreement"]), (Some(Grade::Stop), Some(Grade::Stop)), "{key} {line}");
    }
}
