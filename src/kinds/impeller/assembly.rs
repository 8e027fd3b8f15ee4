//! Putting passes together into one program, in the published layout or in the full one.

use std::sync::Arc;

use crate::gcode::feed_word::FeedWord;
use crate::gcode::program::{Feed, Part, Path, Program, Role};
use crate::gcode::word::{Distance, NumberFormat, Word};
use crate::gcode::writer::Writer;
use crate::kinds::impeller::clear::asked::Mill;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::track::Track;
use crate::machine::axis::{Axis, Pose, Position};
use crate::machine::tip_way::longest;
use crate::number::grid::{Milli, OutOfFormat, TURN};
use crate::text::Text;

/// How often feeds had to give way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limited {
    /// Moves slowed down so that no axis exceeds F_max.
    pub by_axis: usize,
    /// Moves whose F word reached an end of its format.
    pub by_format: usize,
}

impl Limited {
    /// The same in so many channels or blades, which are all alike.
    #[must_use]
    pub const fn times(self, count: u32) -> Self {
        Self { by_axis: self.by_axis * count as usize, by_format: self.by_format * count as usize }
    }
}

const ALL: &[Axis] = &[Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C];

/// One pass: from a safe point through the points of a path to the next safe point, with its F words.
#[derive(Clone, Debug)]
pub struct BladePass {
    track: Track,
    points: Arc<[Position]>,
    backwards: bool,
    through: Feed,
    end: Arc<[Position]>,
    out: Feed,
    /// Moves whose feed gave way.
    pub limited: Limited,
}

impl BladePass {
    /// The pass, its feeds computed so that the tip moves over the part at F.
    ///
    /// # Errors
    /// For a feed that no program may carry.
    pub fn new(
        design: &Design,
        track: Track,
        from: Position,
        points: &Arc<[Position]>,
        to: Position,
    ) -> Result<Self, OutOfFormat> {
        let backwards = track.backwards();
        let mut limited = Limited::default();
        let ordered: Vec<Position> = if backwards { points.iter().rev().copied().collect() } else { points.to_vec() };
        let last = ordered.last().copied().unwrap_or(from);
        let through = feeds(design, design.F, from, &ordered, &mut limited)?;
        let out = feeds(design, design.F, last, &[to], &mut limited)?;
        Ok(Self { track, points: Arc::clone(points), backwards, through, end: Arc::new([to]), out, limited })
    }
}

/// The F word and the time of each move. The time is what the tip needs over the part at a feed F, by an upper
/// bound of its way, or longer where an
/// axis would exceed F_max: the axes run many times the tip's way.
///
/// # Errors
/// For a feed that no program may carry.
pub fn feeds(
    design: &Design,
    F: Option<f64>,
    from: Position,
    points: &[Position],
    limited: &mut Limited,
) -> Result<Feed, OutOfFormat> {
    let (Style::Full, Some(F)) = (design.style, F) else {
        return Ok(Feed::None);
    };
    let law = design.post.control.feed.law;
    let (mut words, mut times) = (Vec::with_capacity(points.len()), Vec::with_capacity(points.len()));
    let mut at = from;
    for to in points {
        let differences = to.differences(&at);
        let mut seconds = longest(design.machine, &Pose::from(at), &Pose::from(*to)) * 60.0 / F;
        let greatest = differences.iter().fold(0.0_f64, |most, difference| most.max(difference.abs()));
        if let Some(F_max) = design.F_max
            && greatest * 60.0 / F_max > seconds
        {
            seconds = greatest * 60.0 / F_max;
            limited.by_axis += 1;
        }
        let resultant = differences.iter().map(|difference| difference * difference).sum::<f64>().sqrt();
        let word = FeedWord::lasting(law, seconds, resultant)?;
        limited.by_format += usize::from(resultant > 0.0 && word.is_fastest(law));
        words.push(word);
        times.push(if resultant > 0.0 { law.seconds(word.value(), resultant) } else { 0.0 });
        at = *to;
    }
    Ok(Feed::Each { words: words.into(), seconds: times.into() })
}

/// A program being put together.
#[derive(Debug)]
pub struct Assembly<'a> {
    design: &'a Design,
    mill: Mill,
    writer: Writer,
    start: Position,
    /// Where the passes begin: the published programs start here.
    first: Position,
    at: Position,
    /// Whole turns that C stands beyond the positions of the tracks.
    turns: Milli,
}

impl<'a> Assembly<'a> {
    /// A program whose passes begin at a safe point.
    ///
    /// The published layout starts right there. The full one is taken away, if the workbook says how, and then goes over the
    /// work zero and comes down to the retract height; otherwise it goes to that height first. From there it goes to the safe
    /// point outside the part. B and C turn to 0 with X and Y, but where every turn is an increment: there they turn after Z.
    ///
    /// Where the rotary axes may be rollover they are taken to stand at 0. One absolute block with targets inside a turn, in
    /// plus, brings them to where the passes begin: an axis that is rollover and one that is not make the same motion, and
    /// so they do of every increment after it. An angle that is reached already is not written.
    ///
    /// # Errors
    /// For a position that no program may carry.
    pub fn new(design: &'a Design, first: Position) -> Result<Self, OutOfFormat> {
        Self::with(design, design.mill(Which::Rough), first)
    }

    /// The same with a tool.
    ///
    /// # Errors
    /// For a position that no program may carry.
    pub fn with(design: &'a Design, mill: Mill, first: Position) -> Result<Self, OutOfFormat> {
        let turned = first.get(Axis::C).thousandths();
        let whole = if design.turns_by_increments() { turned.rem_euclid(TURN) - turned } else { 0 };
        let turns = Milli::new(whole);
        let first = first.moved(Axis::C, turns);
        let mut assembly = {
            let writer = Writer::new(design.post, Vec::new());
            Self { design, mill, writer, start: first, first, at: first, turns }
        };
        match design.style {
            Style::Annex => {
                let codes = design.start_codes.iter().chain(&design.coolant).copied();
                let codes = std::iter::once(Word::whole('G', 91)).chain(codes);
                assembly.writer.block(codes.collect::<Vec<_>>());
            }
            Style::Full => assembly.approach()?,
        }
        Ok(assembly)
    }

    fn approach(&mut self) -> Result<(), OutOfFormat> {
        let design = self.design;
        let height = Milli::round(design.retract_height())?;
        self.start = Position::default().with(Axis::Z, height);
        self.at = self.start;
        self.writer.safety();
        if !design.retract.0.is_empty() {
            self.writer.part(Part::Away(design.retract.clone()));
        }
        self.writer.tool(self.mill.T, self.mill.D);
        let speed = self.mill.S.map(|S| Word::whole('S', S));
        self.writer.block(speed.into_iter().chain(design.start_codes.iter().copied()).collect::<Vec<_>>());
        if !design.coolant.is_empty() {
            self.writer.block(design.coolant.clone());
        }
        let zeros = |axes: &[Axis]| axes.iter().map(|axis| Word::size(axis.letter(), Milli::ZERO)).collect::<Vec<_>>();
        let down = vec![Word::size('Z', height)];
        let by_increments = design.turns_by_increments();
        let over_zero = zeros(if by_increments { &[Axis::X, Axis::Y] } else { &[Axis::X, Axis::Y, Axis::B, Axis::C] });
        // Taken away, the tool is above everything, and comes down over the work zero; otherwise it goes up first.
        let blocks = if design.retract.0.is_empty() { [down, over_zero] } else { [over_zero, down] };
        for words in blocks {
            self.writer.rapid(words);
        }
        let first = self.first;
        let over = |from: Position, axes: &[Axis]| axes.iter().fold(from, |at, &axis| at.with(axis, first.get(axis)));
        let turned = over(self.at, &[Axis::B, Axis::C]);
        if by_increments {
            let path = Path {
                distance: Distance::Absolute,
                moving_only: true,
                ..self.path(Arc::new([turned]), &[Axis::B, Axis::C], true)
            };
            self.writer.part(Part::Path(path));
            self.at = turned;
        }
        if self.distance() == Distance::Incremental {
            self.writer.distance(Distance::Incremental);
        }
        self.go(turned, &[Axis::B, Axis::C]);
        self.go(over(self.at, &[Axis::X, Axis::Y]), &[Axis::X, Axis::Y]);
        self.go(over(self.at, &[Axis::Z]), &[Axis::Z]);
        self.writer.begin_feed();
        Ok(())
    }

    fn distance(&self) -> Distance {
        match self.design.style {
            Style::Annex => Distance::Incremental,
            Style::Full => self.design.distance,
        }
    }

    fn path(&self, positions: Arc<[Position]>, axes: &'static [Axis], rapid: bool) -> Path {
        Path {
            role: Role::Clear,
            positions,
            backwards: false,
            turn: Milli::ZERO,
            axes,
            rapid,
            distance: self.distance(),
            moving_only: self.design.turns_by_increments(),
            feed: Feed::None,
        }
    }

    /// A move outside the part to a position of the tracks, of the axes named: the published layout writes it like any
    /// other block, the full one as a rapid move.
    pub fn cross(&mut self, to: Position, axes: &'static [Axis]) {
        self.go(to.moved(Axis::C, self.turns), axes);
    }

    fn go(&mut self, to: Position, axes: &'static [Axis]) {
        let full = self.design.style == Style::Full;
        let path = self.path(Arc::new([to]), if full { axes } else { ALL }, full);
        self.writer.part(Part::Path(path));
        self.at = to;
    }

    /// The blocks of a pass and the one that leaves it, with C turned on by `turn` and by the turns made before.
    pub fn cut(&mut self, pass: &BladePass, turn: Milli) {
        let turn = turn + self.turns;
        let through = Path {
            role: Role::Cut(pass.track.key()),
            backwards: pass.backwards,
            turn,
            feed: pass.through.clone(),
            ..self.path(Arc::clone(&pass.points), ALL, false)
        };
        let out = Path {
            role: Role::Leave(pass.track.key()),
            turn,
            feed: pass.out.clone(),
            ..self.path(Arc::clone(&pass.end), ALL, false)
        };
        if let Some(end) = out.position(0) {
            self.at = end;
        }
        self.writer.part(Part::Path(through));
        self.writer.part(Part::Path(out));
    }

    /// A turn with so many whole ones that C comes to a position by half a turn at most.
    #[must_use]
    pub fn nearest(&self, to: Position, turn: Milli) -> Milli {
        let by = (to.get(Axis::C) + self.turns - self.at.get(Axis::C)).thousandths();
        let whole = (by + TURN / 2).div_euclid(TURN);
        turn - Milli::new(whole * TURN)
    }

    /// A rapid move outside the part, C turned on, of the axes that move.
    pub fn over(&mut self, to: Position, turn: Milli) {
        let to = to.moved(Axis::C, turn + self.turns);
        let moves = |axes: &[Axis]| axes.iter().any(|&axis| to.get(axis) != self.at.get(axis));
        let axes: &'static [Axis] = match (moves(&[Axis::X, Axis::Y, Axis::B]), moves(&[Axis::Z]), moves(&[Axis::C])) {
            (false, true, false) => &[Axis::Z],
            (false, false, true) => &[Axis::C],
            (false, true, true) => &[Axis::Z, Axis::C],
            (true, false, _) => &[Axis::X, Axis::Y, Axis::B, Axis::C],
            _ => ALL,
        };
        self.go(to, axes);
    }

    /// A rapid move straight up.
    pub fn up(&mut self, z: Milli) {
        self.go(self.at.with(Axis::Z, z), &[Axis::Z]);
    }

    /// Cuts through points under a name, C turned on.
    pub fn through(&mut self, key: &'static str, points: &Arc<[Position]>, feed: &Feed, turn: Milli) {
        let turn = turn + self.turns;
        let path = Path { role: Role::Cut(key), turn, feed: feed.clone(), ..self.path(Arc::clone(points), ALL, false) };
        if let Some(end) = points.len().checked_sub(1).and_then(|last| path.position(last)) {
            self.at = end;
        }
        self.writer.part(Part::Path(path));
    }

    /// Turns C alone, at a safe point.
    pub fn turn_to(&mut self, safe: Position, turn: Milli) {
        let to = safe.moved(Axis::C, turn + self.turns);
        let path = self.path(Arc::new([to]), &[Axis::C], self.design.style == Style::Full);
        self.writer.part(Part::Path(path));
        self.at = to;
    }

    /// The turn to the next blade that closes the published program of one blade; a complete program goes back to its
    /// start instead and so needs none.
    pub fn turn_on(&mut self, turn: Milli) {
        if self.design.style == Style::Annex {
            self.turn_to(self.first, turn);
        }
    }

    /// Closes the program: the full layout goes back to its start, C to a whole turn or, where the rotary axes may be
    /// rollover, back to 0.
    #[must_use]
    pub fn finish(mut self, operation: Operation, title: Text) -> Program {
        let design = self.design;
        if design.style == Style::Full {
            self.writer.end_feed();
            let over = |at: Position, from: Position, axes: &[Axis]| {
                axes.iter().fold(at, |at, &axis| at.with(axis, from.get(axis)))
            };
            let turned = self.at.get(Axis::C) - self.first.get(Axis::C);
            let turns = turned.thousandths().div_euclid(TURN);
            // Turned back all the way where the next run takes the axes to stand at 0, on whole turns elsewhere.
            let turns = if design.turns_by_increments() { 0 } else { turns };
            let home = self.start.with(Axis::C, Milli::new(turns * TURN));
            self.go(over(self.at, home, &[Axis::Z]), &[Axis::Z]);
            self.go(over(self.at, home, &[Axis::X, Axis::Y]), &[Axis::X, Axis::Y]);
            self.go(over(self.at, home, &[Axis::B, Axis::C]), &[Axis::B, Axis::C]);
        }
        let mut end = design.end_codes.clone();
        if self.distance() == Distance::Incremental {
            end.insert(0, Word::whole('G', 90));
        }
        self.writer.block(end);
        Program {
            key: operation.key(),
            title,
            control: design.post.control,
            law: self.writer.law(),
            format: if design.style == Style::Full { NumberFormat::Fixed } else { NumberFormat::Trimmed },
            block_step: Some(design.block_step),
            start: self.start,
            parts: self.writer.finish(),
        }
    }
}
