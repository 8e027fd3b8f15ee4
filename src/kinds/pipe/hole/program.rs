//! The program of the hole.

use crate::gcode::control::FeedLaw;
use crate::gcode::feed_word::FeedWord;
use crate::gcode::header::{Header, Origin, Work};
use crate::gcode::program::Program;
use crate::gcode::word::{Distance, NumberFormat, Word};
use crate::gcode::writer::Writer;
use crate::kinds::pipe::hole::cut::{Cut, Follows, Leg, Place};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::{counted, kerf_in_header};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::{Milli, OutOfFormat};
use crate::number::shown;
use crate::text::{Text, t};

/// What the program is called.
pub const TITLE: Text = t("Agujero biselado", "Bevelled hole");

/// The axes that the program moves, in the order of a [`Place`].
pub const AXES: [Axis; 5] = [Axis::A, Axis::X, Axis::Z, Axis::B, Axis::C];

/// The block that holds the height control, or lets it go; `None` where neither workbook nor control has one.
#[must_use]
pub fn hold(design: &Design, on: bool) -> Option<Vec<Word>> {
    let given = if on { &design.hold_on } else { &design.hold_off };
    if !given.is_empty() {
        return Some(given.clone());
    }
    design.post.writing.height.words(on)
}

/// How the program turns A, B and C.
#[must_use]
pub fn distance(design: &Design) -> Distance {
    counted(design.post.control.rotary.delivered)
}

/// The words of a move between two places: all axes where it goes to, or those that move, and by how much.
fn words(distance: Distance, from: Place, to: Place) -> Vec<Word> {
    let axes = AXES.into_iter().zip(from.into_iter().zip(to));
    match distance {
        Distance::Absolute => axes.map(|(axis, (_, to))| Word::size(axis.letter(), to)).collect(),
        Distance::Incremental => axes
            .filter(|(_, (from, to))| from != to)
            .map(|(axis, (from, to))| Word::size(axis.letter(), to - from))
            .collect(),
    }
}

/// The F word of a leg, so that it takes its time.
fn feed(law: FeedLaw, from: Place, leg: &Leg) -> Result<FeedWord, OutOfFormat> {
    let by = (0..5).map(|axis| (leg.to[axis] - from[axis]).value());
    let resultant = by.map(|by| by * by).sum::<f64>().sqrt();
    FeedWord::lasting(law, leg.seconds, resultant)
}

/// The complete program.
///
/// By increments, A, B and C are taken to stand at 0, and are turned back there over the safe height: nothing else says on
/// which turn they stand.
///
/// # Errors
/// For a number that no program may carry.
pub fn full(design: &Design, cut: &Cut, origin: &Origin<'_>) -> Result<Program, OutOfFormat> {
    let work = Work { part: &design.part, material: &design.material, number: design.program };
    let mut header = Header::new(design.post.control, "hole", &TITLE, work, origin);
    comments(design, &mut header);
    let mut writer = Writer::new(design.post, header.parts);
    let law = writer.law();
    let safe = Milli::round(design.R_o() + design.Z_s)?;
    let distance = distance(design);
    let over = |[A, X, _, B, C]: Place| [A, X, safe, B, C];
    let home = |[_, X, ..]: Place| [Milli::ZERO, X, safe, Milli::ZERO, Milli::ZERO];
    writer.safety();
    writer.rapid([Word::size('Z', safe)]);
    if distance == Distance::Incremental {
        writer.rapid([Word::size('X', cut.pierce[1])]);
        writer.distance(Distance::Incremental);
    }
    let mut turns = words(distance, home(cut.pierce), over(cut.pierce));
    turns.retain(|word| word.letter != 'Z');
    let mut down = words(distance, over(cut.pierce), cut.pierce);
    down.retain(|word| word.letter == 'Z');
    for words in [turns, down] {
        if !words.is_empty() {
            writer.rapid(words);
        }
    }
    let mut held = false;
    if cut.pierce_held
        && let Some(words) = hold(design, true)
    {
        writer.block(words);
        held = true;
    }
    writer.block(design.torch_on.clone());
    if design.pierce_delay > 0.0 {
        writer.dwell(design.pierce_delay)?;
    }
    writer.begin_feed();
    let mut at = cut.pierce;
    for leg in &cut.legs {
        if leg.held != held
            && let Some(words) = hold(design, leg.held)
        {
            writer.block(words);
            held = leg.held;
        }
        let F = feed(law, at, leg)?;
        writer.feed(std::iter::once(Word::whole('G', 1)).chain(words(distance, at, leg.to)), F);
        at = leg.to;
    }
    writer.block(design.torch_off.clone());
    if held && let Some(words) = hold(design, false) {
        writer.block(words);
    }
    writer.end_feed();
    if distance == Distance::Incremental {
        writer.distance(Distance::Absolute);
    }
    writer.rapid([Word::size('Z', safe)]);
    let back = words(Distance::Incremental, over(at), home(at));
    if distance == Distance::Incremental && !back.is_empty() {
        writer.distance(Distance::Incremental);
        writer.rapid(back);
        writer.distance(Distance::Absolute);
    }
    writer.block(design.end_codes.clone());
    Ok(Program {
        key: "hole",
        title: TITLE,
        control: design.post.control,
        law,
        format: NumberFormat::Fixed,
        block_step: Some(design.block_step),
        start: Position::default(),
        parts: writer.finish(),
    })
}

fn comments(design: &Design, header: &mut Header) {
    let mm = |value: f64| format!("{value:.3}");
    let (D, t) = (mm(design.header.D), mm(design.header.t));
    header.line(&format!("TUBO BASE DIAM. {D} PARED {t}"), &format!("HEADER DIAM. {D} WALL {t}"));
    let (D, theta, e) = (mm(design.branch.D), shown(design.theta, 3), mm(design.e));
    header.line(
        &format!("INJERTO DIAM. {D} ANGULO {theta} EXCENTR. {e}"),
        &format!("BRANCH DIAM. {D} ANGLE {theta} ECCENTR. {e}"),
    );
    let (gamma, b, h) = (shown(design.gamma, 3), mm(design.b), mm(design.h));
    header.line(&format!("BISEL {gamma} HOLGURA {b} TALON {h}"), &format!("GROOVE {gamma} ROOT GAP {b} LAND {h}"));
    let F = shown(design.F, 3);
    let [es, en] = kerf_in_header(design.kerf);
    header.line(&format!("{es} - AVANCE {F} MM-MIN"), &format!("{en} - FEED {F} MM-MIN"));
    header.line(
        "X0 EN EL EJE DEL INJERTO - Z0 EN EL EJE DEL TUBO BASE",
        "X0 ON THE AXIS OF THE BRANCH - Z0 ON THE AXIS OF THE PIPE",
    );
    header.line(
        "SENTIDO DE A SEGUN ISO 841 - EL TUBO GIRA AL REVES",
        "A GOES ROUND THE PIPE BY ISO 841 - PIPE TURNS BACKWARDS",
    );
    header.line("X Y Z SON LA PUNTA DE LA ANTORCHA - Y SIEMPRE 0", "X Y Z OF THE TORCH TIP - Y ALWAYS 0");
    header.line("B INCLINA Y C GIRA LA ANTORCHA SOBRE SU PUNTA", "B TILTS AND C SWINGS THE TORCH ABOUT ITS TIP");
    match distance(design) {
        Distance::Incremental => {
            header.true_for_both();
            header.line(
                "ANTES DE ARRANCAR A B C DEBEN MARCAR 0 - ACABAN EN 0",
                "A B C MUST SHOW 0 BEFORE - THERE THEY END",
            );
        }
        Distance::Absolute => {
            header.line("SOLO VALE SI A B C NO SON EJES ROLLOVER", "VALID ONLY IF A B C ARE NOT ROLLOVER AXES");
        }
    }
    let last = design.torch();
    let shoulder = mm(last.shoulder());
    let (r_g, R_g) = (mm(design.r_g), mm(design.R_g));
    header.line(
        &format!("ANTORCHA R {r_g} CUERPO R {R_g} A {shoulder} DE LA PUNTA"),
        &format!("TORCH R {r_g} BODY R {R_g} AT {shoulder} FROM THE TIP"),
    );
}

/// What a leg follows, in a word.
#[must_use]
pub const fn follows(follows: Follows) -> Text {
    match follows {
        Follows::WayIn => t("entrada", "lead-in"),
        Follows::Curve(_) => t("curva", "curve"),
    }
}
