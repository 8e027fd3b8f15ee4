//! The program of the torch, as published or complete.

use crate::finding::{Finding, Raise, Size};
use crate::gcode::control::Slower;
use crate::gcode::feed_word::FeedWord;
use crate::gcode::header::{Header, Origin, Work};
use crate::gcode::program::{Part, Program};
use crate::gcode::word::{Distance, Number, NumberFormat, Word};
use crate::gcode::writer::Writer;
use crate::kinds::pipe::form::{D_BRANCH, DIALECT};
use crate::kinds::pipe::insert::arcs::{Triple, triples};
use crate::kinds::pipe::insert::cut::{Cut, Follows, Leg};
use crate::kinds::pipe::insert::design::{Design, Mode};
use crate::kinds::pipe::insert::parameters::F as F_FIELD;
use crate::kinds::pipe::insert::rules::FasterThanFWord;
use crate::kinds::pipe::rates::CutMove;
use crate::kinds::pipe::{counted, kerf_in_header};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::{Milli, OutOfFormat};
use crate::number::shown;
use crate::parameter::at;
use crate::text::{Text, t};

/// The points of the template: j = 0 … N.
#[must_use]
pub fn template_points(design: &Design) -> Vec<nalgebra::Vector2<f64>> {
    let outline = design.template();
    (0..=design.N).map(|j| outline.curve(std::f64::consts::TAU * f64::from(j) / f64::from(design.N))).collect()
}

/// The program as published: a rapid move to the first point, and an arc for every triple, with six decimals. It carries no
/// feed, no torch and no end. Straight moves where no control takes the arc.
///
/// # Errors
/// For a position that no program may carry.
pub fn published(design: &Design) -> Result<Program, OutOfFormat> {
    let points = template_points(design);
    for point in &points {
        Milli::round(point.x)?;
        Milli::round(point.y)?;
    }
    let start = points.first().map_or(0.0, |first| first.y);
    let mut parts = vec![Part::Line(format!("G0 X0 Y{}", six(start)))];
    parts.extend(triples(&points, design.arc_tolerance).iter().map(|triple| Part::Line(published_line(triple))));
    Ok(Program {
        key: "insert",
        title: TITLE,
        control: design.post.control,
        law: design.post.control.feed.law,
        format: NumberFormat::Six,
        block_step: None,
        start: Position::default(),
        parts,
    })
}

fn six(value: f64) -> String {
    // −0 would be another word.
    format!("{:.6}", if value.abs() < 0.000_000_5 { 0.0 } else { value })
}

fn published_line(triple: &Triple) -> String {
    let (code, x, y) = (triple.code(), six(triple.to.x), six(triple.to.y));
    match triple.circle {
        Some(circle) => format!("{code} X{x} Y{y} R{}", six(circle.radius)),
        None => format!("{code} X{x} Y{y}"),
    }
}

/// What the program is called.
pub const TITLE: Text = t("Corte del injerto", "Cut of the branch");

/// The letters of the two axes.
#[must_use]
pub const fn letters(mode: Mode) -> [char; 2] {
    match mode {
        Mode::Flat => ['X', 'Y'],
        Mode::Rotary => ['A', 'X'],
    }
}

/// How the complete program counts: a flat sheet's by positions, that of a turning pipe as its control's rotary axes do.
#[must_use]
pub fn distance(design: &Design) -> Distance {
    match design.mode {
        Mode::Flat => Distance::Absolute,
        Mode::Rotary => counted(design.post.control.rotary.delivered),
    }
}

/// The rapid moves to the pierce: by increments of A, which is taken to stand at 0, one of X and, where A turns, one of A.
#[must_use]
pub fn approach(design: &Design, pierce: [Milli; 2]) -> usize {
    if distance(design) == Distance::Incremental && pierce[0] != Milli::ZERO { 2 } else { 1 }
}

/// The way of a leg over the surface that is cut, mm, from where the last one ended.
fn way(design: &Design, from: [Milli; 2], leg: &Leg) -> f64 {
    let by = |axis: usize| (leg.to[axis] - from[axis]).value();
    let [first, second] = match design.mode {
        Mode::Flat => [by(0), by(1)],
        Mode::Rotary => [by(0).to_radians() * design.branch.D / 2.0, by(1)],
    };
    (first * first + second * second).sqrt()
}

/// The refusal of a cutting speed for which a move on the turning pipe would have no F word. A time in seconds that is too
/// short for its decimals has one: what that slows is reported where the program is read back.
#[must_use]
pub fn beyond_f_word(design: &Design, cut: &Cut) -> Option<Finding> {
    let (law, F) = (design.post.control.feed.law, design.F.filter(|_| design.mode == Mode::Rotary)?);
    match law.slower() {
        Slower::More => return None,
        Slower::Less => {}
    }
    let before = std::iter::once(cut.pierce).chain(cut.legs.iter().map(|leg| leg.to));
    let words = before.zip(&cut.legs).map(|(at, leg)| law.word(way(design, at, leg) * 60.0 / F, resultant(at, leg)));
    let word = words.fold(0.0_f64, f64::max);
    let (greatest, speed) = (law.greatest(), |value| Size::feed(value, 3));
    // What a word is beyond the greatest by, F is beyond the greatest F by.
    let most = speed((F * greatest / word).floor());
    let told = FasterThanFWord { F: speed(F), word: Size::number(word, 3), greatest: Size::number(greatest, 3), most };
    (word > greatest).then(|| told.at(at([F_FIELD.key(), D_BRANCH.key(), DIALECT.key()])))
}

/// The moves of the cut with the ways of their axes and the time that each takes at F, s.
#[must_use]
pub fn runs(design: &Design, cut: &Cut, F: f64) -> Vec<CutMove> {
    let before = std::iter::once(cut.pierce).chain(cut.legs.iter().map(|leg| leg.to));
    let axes = match design.mode {
        Mode::Flat => [Axis::X, Axis::Y],
        Mode::Rotary => [Axis::A, Axis::X],
    };
    let run = |(from, leg): ([Milli; 2], &Leg)| CutMove {
        by: (0..2).map(|axis| (axes[axis], (leg.to[axis] - from[axis]).value())).collect(),
        seconds: way(design, from, leg) * 60.0 / F,
        at: match leg.follows {
            Follows::Curve([from, _]) => Some(("φ", from)),
            Follows::Corner(at) => Some(("φ", at)),
            Follows::WayIn | Follows::Beyond => None,
        },
    };
    before.zip(&cut.legs).map(run).collect()
}

/// The way of a leg over both axes, degrees taken as mm, from where the last one ended.
fn resultant(from: [Milli; 2], leg: &Leg) -> f64 {
    let by = |axis: usize| (leg.to[axis] - from[axis]).value();
    (by(0) * by(0) + by(1) * by(1)).sqrt()
}

/// The complete program.
///
/// On a flat sheet F is in mm a minute (G94). On the turning pipe it is made block by block, so that the torch runs over
/// the pipe's outside at F: as the control wants it, the time of the move, its inverse, or the resultant of mm and degrees.
/// By increments (see [`distance`]) A is taken to stand at 0; it is left where the cut ends, as it is not known that the torch
/// is clear of the pipe there.
///
/// # Errors
/// For a number that no program may carry.
pub fn full(design: &Design, cut: &Cut, origin: &Origin<'_>) -> Result<Program, OutOfFormat> {
    let work = Work { part: &design.part, material: &design.material, number: design.program };
    let mut header = Header::new(design.post.control, "insert", &TITLE, work, origin);
    comments(design, &mut header);
    let writer = Writer::new(design.post, header.parts);
    let mut writer = if design.mode == Mode::Rotary { writer } else { writer.along_the_path() };
    let letters = letters(design.mode);
    let place = |to: [Milli; 2]| letters.into_iter().zip(to).map(|(letter, size)| Word::size(letter, size));
    let law = writer.law();
    let distance = distance(design);
    writer.safety();
    match distance {
        Distance::Absolute => writer.rapid(place(cut.pierce)),
        Distance::Incremental => {
            let [turn, along] = letters.map(|letter| move |size| [Word::size(letter, size)]);
            writer.rapid(along(cut.pierce[1]));
            writer.distance(Distance::Incremental);
            if approach(design, cut.pierce) > 1 {
                writer.rapid(turn(cut.pierce[0]));
            }
        }
    }
    writer.block(design.torch_on.clone());
    if design.pierce_delay > 0.0 {
        writer.dwell(design.pierce_delay)?;
    }
    writer.begin_feed();
    let F = design.F.unwrap_or(0.0);
    let mut at = cut.pierce;
    for leg in &cut.legs {
        let code = match leg.bend {
            None => 1,
            Some(bend) if bend.clockwise => 2,
            Some(_) => 3,
        };
        let mut words = vec![Word::whole('G', code)];
        match distance {
            Distance::Absolute => words.extend(place(leg.to)),
            Distance::Incremental => {
                let by = [0, 1].map(|axis| leg.to[axis] - at[axis]);
                words.extend(place(by).filter(|word| word.number != Number::Size(Milli::ZERO)));
            }
        }
        words.extend(leg.bend.map(|bend| Word::size('R', bend.radius)));
        let feed = if design.mode == Mode::Flat {
            FeedWord::lasting(law, 60.0 / F, 1.0)?
        } else {
            FeedWord::lasting(law, way(design, at, leg) * 60.0 / F, resultant(at, leg))?
        };
        writer.feed(words, feed);
        at = leg.to;
    }
    writer.block(design.torch_off.clone());
    writer.end_feed();
    if distance == Distance::Incremental {
        writer.distance(Distance::Absolute);
    }
    writer.block(design.end_codes.clone());
    let start = Position::default();
    Ok(Program {
        key: "insert",
        title: TITLE,
        control: design.post.control,
        law,
        format: NumberFormat::Fixed,
        block_step: Some(design.block_step),
        start,
        parts: writer.finish(),
    })
}

fn comments(design: &Design, header: &mut Header) {
    let mm = |value: f64| format!("{value:.3}");
    let (D, t, theta) = (mm(design.branch.D), mm(design.branch.t), shown(design.theta, 3));
    header.line(&format!("INJERTO DIAM. {D} PARED {t}"), &format!("BRANCH DIAM. {D} WALL {t}"));
    let (D, t, e) = (mm(design.header.D), mm(design.header.t), mm(design.e));
    header.line(&format!("TUBO BASE DIAM. {D} PARED {t}"), &format!("HEADER DIAM. {D} WALL {t}"));
    header.line(&format!("ANGULO {theta} EXCENTRICIDAD {e}"), &format!("ANGLE {theta} ECCENTRICITY {e}"));
    let F = shown(design.F.unwrap_or(0.0), 3);
    let [es, en] = kerf_in_header(design.kerf);
    header.line(&format!("{es} - AVANCE {F} MM-MIN"), &format!("{en} - FEED {F} MM-MIN"));
    match design.mode {
        Mode::Flat => {
            let round = mm(design.outline().round());
            header.line(
                &format!("CHAPA PLANA - DE X0 A X{round} UNA VUELTA - Y0 EN EL BORDE"),
                &format!("FLAT SHEET - X0 TO X{round} IS ONCE ROUND - Y0 EDGE"),
            );
        }
        Mode::Rotary => {
            header.line("A0 EN LA LINEA DE PHI 0", "A0 IS THE LINE OF PHI 0");
            header.line(
                "SENTIDO DE A SEGUN ISO 841 - EL TUBO GIRA AL REVES",
                "A GOES ROUND THE PIPE BY ISO 841 - PIPE TURNS BACKWARDS",
            );
            header.line(
                "X A LO LARGO - X0 EN EL BORDE - POSITIVO HACIA EL CORTE",
                "X ALONG THE PIPE - X0 EDGE - GROWS TOWARDS THE CUT",
            );
            match distance(design) {
                Distance::Incremental => {
                    header.true_for_both();
                    header.line(
                        "ANTES DE ARRANCAR A DEBE MARCAR 0 - ACABA PASADA LA VUELTA",
                        "A MUST SHOW 0 BEFORE - IT ENDS BEYOND A TURN",
                    );
                }
                Distance::Absolute => {
                    header.line("SOLO VALE SI A NO ES EJE ROLLOVER", "VALID ONLY IF A IS NOT A ROLLOVER AXIS");
                }
            }
        }
    }
    header.line("ALTURA DE LA ANTORCHA - LA MANTIENE SU CONTROL DE ALTURA", "TORCH HEIGHT - BY ITS OWN CONTROL");
}
