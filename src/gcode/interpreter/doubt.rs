//! What is in doubt behind a refused block: what it would have put into force is not known, and a refusal that hangs on it
//! follows from the first and is not reported again.

use std::collections::BTreeSet;

use crate::finding::{Finding, Raise};
use crate::gcode::code::{G, Group, M};
use crate::gcode::control::Codes;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter::{F, S, T, U, W};
use crate::gcode::interpreter::block::{AXES, Parameter};
use crate::gcode::interpreter::cursor::comments;
use crate::gcode::interpreter::refused::{Refused, place};
use crate::gcode::rules::flow::FollowingErrors;
use crate::machine::axis::Axis;
use crate::text::{Text, t};

/// Parts of what is in force, one bit each: the nine axes first.
pub(super) type State = u32;
/// The motion or the cycle, with its words that stay.
pub(super) const MOTION: State = 1 << 9;
/// F and what it means.
pub(super) const FEED: State = 1 << 10;
/// S.
pub(super) const SPEED: State = 1 << 11;
/// The way the spindle turns.
pub(super) const SPINDLE: State = 1 << 12;
/// Tool and offset.
pub(super) const TOOL: State = 1 << 13;
pub(super) const PLANE: State = 1 << 14;
/// The program's unit of length.
pub(super) const UNIT: State = 1 << 15;
/// Absolute or incremental.
pub(super) const DISTANCE: State = 1 << 16;
/// Parameters; their names are kept beside.
const PARAMETERS: State = 1 << 17;
/// What the position hangs on beside its axes.
pub(super) const MODES: State = PLANE | UNIT | DISTANCE;
/// The first block of a turning cycle of two.
pub(super) const FIRST_BLOCK: State = 1 << 18;
/// The length of a tool, taken up or not.
pub(super) const LENGTH: State = 1 << 19;
/// The axes X and Z of a lathe.
pub(super) const LATHE: State = axis(Axis::X) | axis(Axis::Z);
/// All axes.
const ALL: State = (1 << 9) - 1;

/// The bit of an axis.
pub(super) const fn axis(axis: Axis) -> State {
    1 << axis as u32
}

/// What is in doubt, and what was left out because of it.
#[derive(Debug, Default)]
pub(super) struct Doubts {
    state: State,
    parameters: BTreeSet<String>,
    /// The number that is being read hangs on one of those parameters.
    lost: bool,
    /// The file and the line of the first refused block.
    since: Option<(Option<String>, usize)>,
    /// How many refusals were left out, and what they hung on.
    left_out: u64,
    because: State,
}

impl Refused {
    /// A refusal that may follow from what is in doubt.
    pub(super) fn hanging_on(mut self: Box<Self>, state: State) -> Box<Self> {
        self.hangs |= state;
        self
    }
}

/// The number behind a letter at a place of a line, as far as it is written out.
pub(super) fn number(line: &[u8], at: usize) -> Option<f64> {
    let digits = line.get(at..)?.iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count();
    std::str::from_utf8(line.get(at..at + digits)?).ok()?.parse().ok()
}

/// What a G code may put into force.
fn of_code(number: f64, codes: &Codes) -> State {
    #[expect(clippy::cast_possible_truncation, reason = "saturates; codes are below 1000")]
    let whole = number as i64;
    match usize::try_from(whole.saturating_mul(10)).ok().and_then(|tenths| codes.get(tenths)) {
        Some(G::Pass(_)) => return MOTION,
        Some(G::Feed(_)) => return FEED,
        // G70 and G71 of a Fagor, which on a lathe of system A are cycles.
        Some(G::Inch | G::Millimetre) => return UNIT,
        _ => {}
    }
    match whole {
        17..=19 => PLANE,
        20 | 21 => UNIT,
        90 | 91 => DISTANCE,
        93..=95 => FEED,
        96 | 97 => SPEED,
        40..=42 => MOTION,
        71..=76 => MOTION | FIRST_BLOCK,
        0..=3 | 5 | 7..=9 | 32..=39 | 70 | 77..=89 => MOTION,
        43 | 44 | 49 => ALL | LENGTH,
        15 | 16 => PLANE,
        10 | 28..=30 | 47 | 48 | 50 | 52..=59 | 92 | 159 => ALL,
        60..=68 => MOTION,
        _ => 0,
    }
}

impl Reader<'_, '_> {
    /// A line without its comments and blanks, its letters in upper case.
    pub(super) fn without_comments(&self, text: &[u8]) -> Vec<u8> {
        let mut line = text.to_ascii_uppercase();
        if let Ok(comments) = comments(text, self.memory.control.lexis.comments) {
            for (column, text) in comments {
                line.iter_mut().skip(column).take(text.len() + 2).for_each(|byte| *byte = b' ');
            }
        } else if self.memory.control.lexis.comments.in_parentheses() {
            line.truncate(line.iter().position(|byte| *byte == b'(').unwrap_or(line.len()));
        }
        line.retain(|byte| !byte.is_ascii_whitespace());
        line
    }

    /// What a line that was refused would have put into force, by its letters: more rather than less.
    fn doubt_line(&mut self, text: &[u8], refused: usize) {
        let line = self.without_comments(text);
        // A feed whose unit is not known stays so until F comes again.
        let mut state = if self.state.modal.feed_unit.is_some() { FEED } else { 0 };
        for (at, &byte) in line.iter().enumerate() {
            state |= match byte {
                b'G' => number(&line, at + 1).map_or(MOTION, |code| of_code(code, self.memory.control.codes)),
                b'M' => match number(&line, at + 1) {
                    Some(code) if code == 6.0 || code == 61.0 => TOOL,
                    _ => SPINDLE,
                },
                b'@' | b'^' => ALL,
                b'#' => {
                    let rest = line.get(at + 1..).unwrap_or_default();
                    let mut parts = rest.splitn(2, |byte| *byte == b'=');
                    let name = String::from_utf8_lossy(parts.next().unwrap_or_default()).to_ascii_lowercase();
                    // A number that is read alone keeps its value; a name may be why the line was refused.
                    if parts.next().is_some() || name.parse::<usize>().is_err() {
                        self.memory.doubts.parameters.insert(name);
                    }
                    PARAMETERS
                }
                _ => self.of_letter(byte),
            };
        }
        self.memory.doubts.state |= state;
        let file = self.memory.library.file(self.block.spot.text).cloned();
        self.memory.doubts.since.get_or_insert((file, refused));
    }

    /// What a word of a letter may put into force.
    fn of_letter(&self, letter: u8) -> State {
        let index = usize::from(letter.wrapping_sub(b'A'));
        match letter {
            b'U' if self.memory.control.axes.by_letters() => axis(Axis::X),
            b'W' if self.memory.control.axes.by_letters() => axis(Axis::Z),
            b'F' => FEED,
            b'S' => SPEED,
            b'T' | b'D' | b'H' => TOOL,
            _ => AXES.iter().position(|&one| one == index).map_or(0, |axis| 1 << axis),
        }
    }

    /// A number begins to be read.
    pub(super) fn begin_number(&mut self) {
        self.memory.doubts.lost = false;
    }

    /// A parameter is read: true where a rejected block would have set it, and the number hangs on that.
    pub(super) fn see_parameter(&mut self, name: impl FnOnce() -> String) -> bool {
        let lost = !self.memory.doubts.parameters.is_empty() && self.doubt_of(&name()) != 0;
        self.memory.doubts.lost |= lost;
        lost
    }

    /// The number of a word has been read: what it gives is in doubt as the parameter is that it hangs on.
    pub(super) fn see_word(&mut self, letter: u8) {
        if self.memory.doubts.lost {
            let state = self.of_letter(letter.to_ascii_uppercase());
            self.block.lost |= state;
            self.memory.doubts.state |= state;
        }
    }

    /// The number that a parameter gets has been read: certain again, or in doubt itself.
    pub(super) fn see_setting(&mut self, parameter: &Parameter) {
        let doubts = &mut self.memory.doubts;
        if doubts.parameters.is_empty() {
            return;
        }
        let name = match parameter {
            Parameter::Number(number) => number.to_string(),
            Parameter::Name(name) => format!("<{name}>"),
        };
        if doubts.lost {
            doubts.parameters.insert(name);
        } else {
            doubts.parameters.remove(&name);
        }
    }

    /// True where a refusal follows from what is in doubt: it is counted and not reported. What its block would have put into
    /// force is in doubt in any case.
    pub(super) fn follows(&mut self, fault: &Refused, line: &[u8]) -> bool {
        let because = self.memory.doubts.state & fault.hangs;
        // What a control does not make of a cycle changes the part: that is reported, but where its first block was.
        let follows = because != 0 && !fault.fatal && (!fault.uncut || because & FIRST_BLOCK != 0);
        if follows {
            self.memory.doubts.left_out += 1;
            self.memory.doubts.because |= because;
        }
        self.doubt_line(line, if fault.line == 0 { self.block.spot.line } else { fault.line });
        follows
    }

    /// A block was executed: what it put into force is certain again.
    pub(super) fn certain(&mut self) {
        if self.memory.doubts.state == 0 {
            return;
        }
        let block = &self.block;
        let mut known = 0;
        for (letter, state) in [(F, FEED), (S, SPEED), (T, TOOL)] {
            known |= if block.has(letter) { state } else { 0 };
        }
        let groups =
            [(Group::Motion, MOTION), (Group::Plane, PLANE), (Group::Units, UNIT), (Group::Distance, DISTANCE)];
        for (group, state) in groups {
            known |= if block.g(group).is_some() { state } else { 0 };
        }
        if matches!(block.m(7), Some((M::Spindle(_) | M::SpindleOff, _))) {
            known |= SPINDLE;
        }
        known |= if block.g(Group::ToolLength).is_some() { LENGTH } else { 0 };
        known |= if matches!(block.g(Group::NonModal), Some(G::Turning(_))) { FIRST_BLOCK } else { 0 };
        let state = self.memory.doubts.state & !known;
        let moved = matches!(block.g(Group::NonModal), None | Some(G::MachineCoordinates));
        if moved && !self.state.modal.incremental && state & (UNIT | DISTANCE) == 0 {
            for (index, &letter) in AXES.iter().enumerate() {
                let increment = self.memory.control.axes.by_letters() && (letter == U || letter == W);
                known |= if block.has(letter) && !increment { 1 << index } else { 0 };
            }
        }
        self.memory.doubts.state &= !known | self.block.lost;
    }

    /// True where a part of what is in force is in doubt: a remark that hangs on it would follow from the refused block.
    pub(super) fn in_doubt(&self, state: State) -> bool {
        self.memory.doubts.holds(state)
    }

    /// What a parameter that is not defined hangs on.
    pub(super) fn doubt_of(&self, name: &str) -> State {
        if self.memory.doubts.parameters.contains(name) { PARAMETERS } else { 0 }
    }
}

impl Doubts {
    /// True where a block has been refused.
    pub(super) const fn any_refused(&self) -> bool {
        self.since.is_some()
    }

    /// True where a part of what is in force is in doubt.
    pub(super) const fn holds(&self, state: State) -> bool {
        self.state & state != 0
    }

    /// The sentence about the refusals that were left out.
    pub(super) fn left_out(&self) -> Option<Finding> {
        let Self { left_out, because, since, .. } = self;
        let (file, line) = since.as_ref().filter(|_| *left_out > 0)?;
        let mut names: Vec<(String, String)> = Axis::ALL
            .into_iter()
            .filter(|one| because & axis(*one) != 0)
            .map(|one| (one.letter().to_string(), one.letter().to_string()))
            .collect();
        for (state, es, en) in [
            (MOTION, "el movimiento en vigor", "the motion in force"),
            (FEED, "el avance", "the feed"),
            (SPEED, "la velocidad del husillo", "the spindle's speed"),
            (SPINDLE, "el sentido de giro del husillo", "the spindle's direction of rotation"),
            (TOOL, "la herramienta", "the tool"),
            (PLANE, "el plano", "the plane"),
            (UNIT, "la unidad", "the unit"),
            (DISTANCE, "cotas absolutas o incrementales", "absolute or incremental"),
            (PARAMETERS, "un parámetro", "a parameter"),
            (FIRST_BLOCK, "el primer bloque de un ciclo", "the first block of a cycle"),
        ] {
            if because & state != 0 {
                names.push((es.to_owned(), en.to_owned()));
            }
        }
        let (es, en): (Vec<_>, Vec<_>) = names.into_iter().unzip();
        let unknown = Text::new(es.join(", "), en.join(", "));
        let errors = match left_out {
            1 => t("1 error que sigue", "1 error that follows"),
            many => Text::new(format!("{many} errores que siguen"), format!("{many} errors that follow")),
        };
        let told = FollowingErrors { count: *left_out, errors, unknown };
        Some(told.at(place(file.as_deref(), *line, Vec::new())))
    }
}
