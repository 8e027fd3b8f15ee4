//! What stands in one block.

use crate::gcode::code::{G, GROUPS, Group, M};
use crate::gcode::control::WordsSeen;
use crate::gcode::in_force::Compensation;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::turning::edge::Square;

/// The letters of words as indices, counted from A = 0.
pub(super) mod letter {
    macro_rules! letters {
        ($($name:ident = $character:literal),*) => { $(pub(in super::super) const $name: usize = ($character - b'A') as usize;)* };
    }
    letters!(
        A = b'A',
        B = b'B',
        C = b'C',
        D = b'D',
        E = b'E',
        F = b'F',
        H = b'H',
        I = b'I',
        J = b'J',
        K = b'K',
        L = b'L',
        M = b'M',
        P = b'P',
        Q = b'Q',
        R = b'R',
        S = b'S',
        T = b'T',
        U = b'U',
        V = b'V',
        W = b'W',
        X = b'X',
        Y = b'Y',
        Z = b'Z'
    );
}

/// The letters of the axes in the order of [`Axis::ALL`](crate::machine::axis::Axis::ALL).
pub(super) const AXES: [usize; 9] =
    [letter::X, letter::Y, letter::Z, letter::A, letter::B, letter::C, letter::U, letter::V, letter::W];

/// How many groups of M codes there are.
const MACHINE_GROUPS: usize = 11;

/// A parameter that a block sets.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Parameter {
    Number(usize),
    Name(String),
}

/// `,C` or `,R`, or I, K or R on a line along one axis: how the corner at the end of the block's line is broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EdgeWord {
    /// As it is written, as `,C`.
    pub(super) name: &'static str,
    /// By an arc, else by a chamfer.
    pub(super) round: bool,
    /// Its number, without a sign.
    pub(super) value: f64,
    /// What it says of the corner, without a comma.
    pub(super) square: Option<Square>,
    /// The column of its comma or letter.
    pub(super) column: usize,
    /// Its number has no decimal point although a control may scale it for that.
    pub(super) pointless: bool,
}

/// The polar words of a block: distance and angle, each with its column.
type Polar = [Option<(f64, usize)>; 2];

/// One block: its words and codes. Reused from line to line.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Where it stands.
    pub(super) spot: Spot,
    /// On which side the move of a cycle that it makes is compensated, whatever is in force.
    pub(super) side: Option<Compensation>,
    /// One bit for each letter that stands in the block.
    pub(super) present: u32,
    /// One bit for each letter whose number has no decimal point although a control may scale it for that.
    pub(super) pointless: u32,
    /// The parts of what is in force that its words give, as a number of theirs hangs on a parameter of a rejected block: one bit each.
    pub(super) lost: u32,
    /// How the corner behind the block is broken.
    pub(super) edge: Option<EdgeWord>,
    /// `@` and `^`: distance and angle of a polar position.
    pub(super) polar: Polar,
    values: [f64; 26],
    columns: [u16; 26],
    /// One bit for each group of which a G code stands in the block.
    pub(super) groups: u16,
    g: [G; GROUPS],
    g_columns: [u16; GROUPS],
    machine_groups: u16,
    m: [(M, u32); MACHINE_GROUPS],
    m_columns: [u16; MACHINE_GROUPS],
    /// How many M codes there are.
    pub(super) machine_codes: usize,
    /// Parameters set by the block, once it has been read.
    pub(super) settings: Vec<(Parameter, f64)>,
    /// Which words may still come.
    pub(super) seen: WordsSeen,
    /// It begins with `/`: a switch of the control may pass over it.
    pub(super) skippable: bool,
}

#[expect(clippy::cast_possible_truncation, reason = "a line has at most 4096 characters")]
const fn short(column: usize) -> u16 {
    column as u16
}

impl Block {
    /// An empty block at a place.
    pub(super) const fn at(spot: Spot) -> Self {
        Self {
            spot,
            side: None,
            present: 0,
            pointless: 0,
            lost: 0,
            edge: None,
            polar: [None; 2],
            values: [0.0; 26],
            columns: [0; 26],
            groups: 0,
            g: [G::Rapid; GROUPS],
            g_columns: [0; GROUPS],
            machine_groups: 0,
            m: [(M::Pause, 0); MACHINE_GROUPS],
            m_columns: [0; MACHINE_GROUPS],
            machine_codes: 0,
            settings: Vec::new(),
            seen: WordsSeen::NONE,
            skippable: false,
        }
    }

    /// The same block, the move of a cycle that it makes compensated on a side.
    pub(super) fn of_cycle(&self, side: Compensation) -> Self {
        Self { side: Some(side), ..self.clone() }
    }

    /// Empties the block, which stays at its line.
    pub(super) fn clear(&mut self) {
        self.spot.n = None;
        self.present = 0;
        self.pointless = 0;
        self.lost = 0;
        self.edge = None;
        self.polar = [None; 2];
        self.groups = 0;
        self.machine_groups = 0;
        self.machine_codes = 0;
        self.settings.clear();
        self.seen = WordsSeen::NONE;
        self.skippable = false;
    }

    /// True where a letter has a word.
    pub(super) const fn has(&self, letter: usize) -> bool {
        self.present & (1 << letter) != 0
    }

    /// The number of a letter's word.
    pub(super) fn get(&self, letter: usize) -> Option<f64> {
        if self.has(letter) { self.values.get(letter).copied() } else { None }
    }

    /// The column of a letter's word.
    pub(super) fn column(&self, letter: usize) -> usize {
        self.columns.get(letter).copied().unwrap_or(0).into()
    }

    /// Puts a word in; the column of the first one if the letter has one already.
    pub(super) fn put(&mut self, letter: usize, value: f64, column: usize) -> Result<(), usize> {
        if self.has(letter) {
            return Err(self.column(letter));
        }
        if let (Some(slot), Some(place)) = (self.values.get_mut(letter), self.columns.get_mut(letter)) {
            *slot = value;
            *place = short(column);
            self.present |= 1 << letter;
        }
        Ok(())
    }

    /// Divides the number of a letter's word.
    pub(super) fn divide(&mut self, letter: usize, by: f64) {
        if let Some(value) = self.values.get_mut(letter) {
            *value /= by;
        }
    }

    /// Takes a word out, as its meaning has been used up.
    pub(super) fn take(&mut self, letter: usize) -> Option<f64> {
        let value = self.get(letter);
        self.present &= !(1 << letter);
        value
    }

    /// The G code of a group that stands in the block; `None` where there is none.
    pub(super) fn g(&self, group: Group) -> Option<G> {
        let at = group as usize;
        if self.groups & (1 << at) != 0 { self.g.get(at).copied() } else { None }
    }

    /// The column of a group's G code.
    pub(super) fn g_column(&self, group: Group) -> usize {
        self.g_columns.get(group as usize).copied().unwrap_or(0).into()
    }

    /// The column of the first code among some groups, one bit for each.
    pub(super) fn group_column(&self, groups: u16) -> usize {
        let columns = (0..GROUPS).filter(|&at| self.groups & groups & (1 << at) != 0);
        columns.filter_map(|at| self.g_columns.get(at)).copied().min().unwrap_or(0).into()
    }

    /// Puts a G code in; the column of the first one if its group has one already. G80 gives way to the motion that
    /// stands beside it.
    pub(super) fn put_g(&mut self, g: G, column: usize) -> Result<(), usize> {
        let at = g.group() as usize;
        if self.groups & (1 << at) != 0 {
            if g == G::Cancel {
                return Ok(());
            }
            if self.g[at] != G::Cancel {
                return Err(self.g_columns[at].into());
            }
        }
        self.groups |= 1 << at;
        self.g[at] = g;
        self.g_columns[at] = short(column);
        Ok(())
    }

    /// The M code of a group, with its number.
    pub(super) fn m(&self, group: u8) -> Option<(M, u32)> {
        let at = usize::from(group);
        if self.machine_groups & (1 << at) != 0 { self.m.get(at).copied() } else { None }
    }

    /// The column of a group's M code.
    pub(super) fn m_column(&self, group: u8) -> usize {
        self.m_columns.get(usize::from(group)).copied().unwrap_or(0).into()
    }

    /// True where the block has M codes.
    pub(super) const fn has_machine_codes(&self) -> bool {
        self.machine_groups != 0
    }

    /// Puts an M code in; the column of the first one if its group has one already.
    pub(super) fn put_m(&mut self, m: M, number: u32, column: usize) -> Result<(), usize> {
        let at = usize::from(m.group());
        self.machine_codes += 1;
        if self.machine_groups & (1 << at) != 0 {
            return Err(self.m_columns[at].into());
        }
        self.machine_groups |= 1 << at;
        self.m[at] = (m, number);
        self.m_columns[at] = short(column);
        Ok(())
    }
}
