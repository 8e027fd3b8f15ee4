//! Passes of threads: what must stay the same from one pass of a thread to the next.

use super::alarm::{Alarm, Cause, TOUCH};
use super::motion_totals::Tally;
use super::path::Piece;
use super::tool::{Cutter, TurningTool};
use crate::gcode::motion::Thread;
use crate::number::trig::tan;

/// Passes of threads farther apart than this across are different threads, mm: more than any thread is deep.
const APART: f64 = 6.0;

/// Spindle speeds that differ by no more than this share count as equal. Fanuc Series 0i-T operator's manual, threading: the spindle
/// speed must stay the same from roughing to finishing, because the lag of the tool depends on it; hence G97.
const SAME_SPEED: f64 = 1e-3;

/// How far from the groove of the passes before, along the thread, a pass may begin, mm.
///
/// # Derivation
/// Positions in inches have four decimals, and so has the lead: of a thread of 14 turns an inch, a pass five leads away is up to
/// 0.006 mm off. On a flank at 30° to the depth, 0.01 mm along the thread is 0.017 mm of depth. Our choice.
const OFF_GROOVE: f64 = 0.01;

/// The greatest depth of one pass of a thread, on the radius, mm.
///
/// # References
/// Tungaloy, General Catalogue 2020–2021, user's guide, threading: "Set the first infeed to 150 ~ 200% of nose R and do not allow it
/// to exceed 0.5 mm." The first pass is the deepest of the tables of the makers (Sumitomo, General Catalogue 2019–2020, page 415: 0.16
/// to 0.25 mm for leads of 1 to 3 mm), so that the limit holds for all.
pub(super) const DEEPEST_PASS: f64 = 0.5;

/// In how many places along its metal the depth of a pass is compared with those before. Our choice.
const LOOKS: u32 = 64;

/// A pass of a thread, or a block of one.
pub(super) struct ThreadPass<'a> {
    pub thread: Thread,
    /// Where it starts and ends, `[z, r]`.
    pub way: Piece,
    /// How many revolutions the spindle has made when it begins, since the angle 0 at which its first block would begin.
    pub turned: f64,
    /// The tool's place in the turret.
    pub place: u32,
    pub tool: &'a TurningTool,
    /// How deep the metal is that it meets, mm.
    pub deep: f64,
    /// From where to where the tool stands in metal: the least and the greatest `[z, r]`.
    pub metal: [[f64; 2]; 2],
}

/// Where a pass lies, or a block of one; mm.
#[derive(Clone, Copy, Debug)]
struct Groove {
    /// The number of the pass: its blocks have the same.
    pass: usize,
    /// Where along the thread it would be at the spindle's angle 0.
    phase: f64,
    /// How far its first block goes in the direction in which the tip points.
    depth: f64,
    /// Its ends: where they are along the thread, and how far the tip goes there; the lesser place first.
    ends: [[f64; 2]; 2],
}

impl Groove {
    /// How far the tip goes at a place along the thread, mm; `None` beyond the ends.
    fn at(&self, along: f64) -> Option<f64> {
        let [[from, start], [to, end]] = self.ends;
        let inside = along >= from - TOUCH && along <= to + TOUCH && to > from;
        inside.then(|| start + (end - start) * ((along - from) / (to - from)).clamp(0.0, 1.0))
    }
}

/// One start of a thread: passes in one groove.
#[derive(Clone, Debug)]
struct Start {
    passes: Vec<Groove>,
    /// The first pass that is off the groove of those before.
    off: Option<Alarm>,
}

/// What a tool has cut of a thread, in one direction.
#[derive(Clone, Debug)]
struct CutThread {
    place: u32,
    forward: bool,
    /// Along which axis the thread runs: 0 for z, 1 for r.
    axis: usize,
    thread: Thread,
    /// The speed of the spindle in the first pass, rpm.
    speed: f64,
    /// Another speed was reported.
    told: bool,
    /// The position along the thread at which depths are compared, mm.
    along: f64,
    /// How far along the thread a flank of the insert goes for each mm of depth.
    flank: f64,
    starts: Vec<Start>,
}

impl CutThread {
    /// True where a block of a pass goes on along the thread.
    fn goes_on(&self, pass: &ThreadPass<'_>) -> bool {
        let by = pass.way[1][self.axis] - pass.way[0][self.axis];
        self.place == pass.place && by != 0.0 && (by > 0.0) == self.forward
    }

    /// How far along the thread a pass is behind another at the same angle of the spindle, mm.
    ///
    /// Grooves whole leads apart are one, unless the lead changes.
    fn behind(&self, one: &Groove, other: &Groove) -> f64 {
        let Thread { lead, change, .. } = self.thread;
        let by = other.phase - one.phase;
        if change == 0.0 { by - lead * (by / lead).round() } else { by }
    }

    /// How far along the thread two passes are apart beyond what lies within the shallower one's groove, and both lengths; mm.
    fn apart(&self, one: Groove, other: Groove) -> [f64; 3] {
        let off = self.behind(&one, &other).abs();
        let most = (other.depth - one.depth).abs() * self.flank;
        [off - most, off, most]
    }

    /// Notes a pass; `alarm` makes the alarm of one that is deeper than all before and in the groove of none. One that is no
    /// deeper may be another start. Returns the number of its start, and how deep it goes at once, mm, where the tool stands in `metal`
    /// from here to there along the thread: how much deeper than the passes before in its groove, and where none has been, or for the
    /// first, `deep`.
    fn take(
        &mut self,
        pass: Groove,
        (deep, metal): (f64, [f64; 2]),
        alarm: impl FnOnce(Cause) -> Alarm,
    ) -> (usize, f64) {
        let numbered = self.starts.iter().enumerate();
        let before = numbered.flat_map(|(at, start)| start.passes.iter().map(move |&groove| (at, groove)));
        let nearest = before
            .clone()
            .map(|(at, groove)| (at, self.apart(groove, pass)))
            .min_by(|(_, [one, ..]), (_, [other, ..])| one.total_cmp(other));
        let deepest = before.map(|(_, groove)| groove.depth).fold(f64::MIN, f64::max);
        let at = match nearest {
            Some((at, [beyond, ..])) if beyond <= OFF_GROOVE || pass.depth > deepest + TOUCH => {
                // The first pass of a groove is shallow and leaves much room: each of them is to lie within this one.
                let found = self.starts[at].passes.iter().map(|&groove| self.apart(groove, pass));
                let farthest = found.max_by(|[one, ..], [other, ..]| one.total_cmp(other));
                let [beyond, off, most] = farthest.unwrap_or_default();
                let start = &mut self.starts[at];
                if beyond > OFF_GROOVE && start.off.is_none() {
                    start.off = Some(alarm(Cause::OffGroove { off, most }));
                }
                at
            }
            _ => {
                self.starts.push(Start { passes: Vec::new(), off: None });
                self.starts.len() - 1
            }
        };
        (at, self.add(at, pass, (deep, metal)))
    }

    /// Adds a pass to a start, or a block of one; returns how deep it goes at once, mm, as [`Self::take`] does.
    ///
    /// # Derivation
    /// At the same angle of the spindle a pass that begins farther along the thread, as with the infeed along a flank, is farther along by
    /// as much: there its depth is compared, in its pull-out as well, which begins and ends in one place for all passes. A
    /// pass that goes farther along the thread than those before it meets the full depth there, however deep they are beside it. Passes
    /// end a little apart: what a lead of length, or half the metal where that is less, has above a depth does not count.
    fn add(&mut self, at: usize, pass: Groove, (deep, [low, high]): (f64, [f64; 2])) -> f64 {
        let before = self.starts[at].passes.iter().filter(|groove| groove.pass != pass.pass);
        let before: Vec<_> = before.map(|groove| (groove, self.behind(groove, &pass))).collect();
        // No more than the metal that it meets, where that is told here.
        let most = if deep > 0.0 { deep } else { f64::INFINITY };
        let more = |part: f64| {
            let along = low + (high - low) * part;
            let reached = before.iter().filter_map(|(groove, by)| groove.at(along - by)).reduce(f64::max);
            let here = pass.at(along).unwrap_or(pass.depth);
            reached.map_or(deep, |reached| (here - reached).min(most))
        };
        let mut each: Vec<f64> = (0..LOOKS).map(|look| more((f64::from(look) + 0.5) / f64::from(LOOKS))).collect();
        each.sort_by(|one, other| other.total_cmp(one));
        let share = if high > low { (self.thread.lead / (high - low)).min(0.5) } else { 0.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and half of a small number"
        )]
        let passed_over = (f64::from(LOOKS) * share).floor() as usize;
        self.starts[at].passes.push(pass);
        each.get(passed_over).copied().unwrap_or(deep)
    }

    /// The alarms of starts whose deepest pass does not take in all the others.
    fn off_groove(&self) -> impl Iterator<Item = Alarm> + '_ {
        self.starts.iter().filter_map(|start| {
            let deepest = start.passes.iter().copied().max_by(|one, other| one.depth.total_cmp(&other.depth))?;
            start.off.filter(|_| start.passes.iter().any(|&pass| self.apart(pass, deepest)[0] > OFF_GROOVE))
        })
    }
}

/// A thread by where it lies, with what each tool has cut of it.
#[derive(Clone, Debug)]
struct Known {
    /// Where its passes went along z, and along r.
    z: [f64; 2],
    r: [f64; 2],
    lead: f64,
    cuts: Vec<CutThread>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Threads {
    known: Vec<Known>,
    /// Revolutions of the spindle up to the end of the last block, since the angle 0 at which its pass would have begun.
    turned: f64,
    /// The number of the last pass.
    pass: usize,
    /// The thread that it has met metal in.
    home: Option<Home>,
}

/// Which of the threads a pass belongs to: the numbers of the thread, the cut, and the start.
#[derive(Clone, Copy, Debug)]
struct Home {
    known: usize,
    cut: usize,
    start: usize,
}

impl Threads {
    /// Counts the revolutions of a block; returns those before it. A pass begins at its own angle, and its further blocks go on.
    pub fn turn(&mut self, thread: &Thread, turns: f64, begins: bool) -> f64 {
        let before = if begins { thread.angle / 360.0 } else { self.turned };
        if begins {
            self.pass += 1;
            self.home = None;
        }
        self.turned = before + turns;
        before
    }

    /// How much a new pass is compared with.
    pub fn passes(&self) -> usize {
        let cuts = self.known.iter().flat_map(|known| &known.cuts);
        self.known.len() + cuts.flat_map(|cut| &cut.starts).map(|start| start.passes.len()).sum::<usize>()
    }

    /// Notes a pass in metal, and raises the alarms of another lead or spindle speed than in the passes before. Returns how deep it goes
    /// at once, mm on the radius, and whether it is the first block of its pass that is in metal; `None` for what does not say it.
    pub fn judge(&mut self, pass: &ThreadPass<'_>, tally: &mut Tally) -> Option<(f64, bool)> {
        let ([from, to], lead) = (pass.way, pass.thread.lead);
        let [z, r] = [0, 1].map(|axis| [from[axis].min(to[axis]), from[axis].max(to[axis])]);
        let meets = |one: [f64; 2], two: [f64; 2], apart: f64| one[0] < two[1] + apart && two[0] < one[1] + apart;
        let near = |known: &Known| {
            // Along the thread they must share more than a lead, so that a run-out does not count.
            let along = if z[1] - z[0] >= r[1] - r[0] { (-lead, APART) } else { (APART, -lead) };
            meets(known.z, z, along.0) && meets(known.r, r, along.1)
        };
        // A further block of a pass, as its pull-out, is of the thread that the pass has begun, wherever it goes.
        let home = self.home.filter(|&Home { known, cut, .. }| {
            let known = &self.known[known];
            (known.lead - lead).abs() <= 1e-6 && known.cuts[cut].goes_on(pass)
        });
        let at = home.map(|home| home.known).or_else(|| self.known.iter().position(near)).unwrap_or_else(|| {
            self.known.push(Known { z, r, lead, cuts: Vec::new() });
            self.known.len() - 1
        });
        let known = &mut self.known[at];
        if (known.lead - lead).abs() > 1e-6 {
            tally.raise(Cause::LeadDiffers { lead, before: known.lead }, from, None);
            return None;
        }
        // A run-out is no place of the thread where another would be the same.
        if home.is_none() || (z[1] - z[0]).max(r[1] - r[0]) > lead + TOUCH {
            for (held, new) in [(&mut known.z, z), (&mut known.r, r)] {
                *held = [held[0].min(new[0]), held[1].max(new[1])];
            }
        }
        let (cut, start, depth) = known.take(pass, self.pass, home, tally)?;
        self.home = Some(Home { known: at, cut, start });
        Some((depth, home.is_none()))
    }

    /// The alarms of deeper passes off the groove of the passes before, which can be reported only when the program has ended:
    /// with an infeed along either flank in turn, a pass is off the one before and the last one takes in both.
    pub fn off_groove(&self) -> Vec<Alarm> {
        self.known.iter().flat_map(|known| &known.cuts).flat_map(CutThread::off_groove).collect()
    }
}

impl Known {
    /// Notes a pass, whose number is given, and where it has begun in metal. Returns the numbers of its cut and its start, and how deep it
    /// goes at once, mm.
    fn take(
        &mut self,
        pass: &ThreadPass<'_>,
        number: usize,
        home: Option<Home>,
        tally: &mut Tally,
    ) -> Option<(usize, usize, f64)> {
        let &ThreadPass { thread, way: [from, to], turned, place, tool, deep, metal, .. } = pass;
        let axis = usize::from((to[1] - from[1]).abs() > (to[0] - from[0]).abs());
        let axis = home.map_or(axis, |home| self.cuts[home.cut].axis);
        let across = 1 - axis;
        let forward = to[axis] > from[axis];
        let speeds = [from, to].map(|at| tally.turning.at(at[1] + tally.shift[1]));
        let same = |cut: &CutThread| cut.place == place && cut.forward == forward && cut.axis == axis;
        let number_of_cut =
            home.map(|home| home.cut).or_else(|| self.cuts.iter().position(same)).unwrap_or_else(|| {
                let flank = match tool.cutter {
                    Cutter::Threader { angle, .. } => tan(angle.to_radians() / 2.0),
                    _ => 0.0,
                };
                let (speed, along, starts) = (speeds[0], to[axis], Vec::new());
                self.cuts.push(CutThread { place, forward, axis, thread, speed, told: false, along, flank, starts });
                self.cuts.len() - 1
            });
        let cut = &mut self.cuts[number_of_cut];
        let before = cut.speed;
        let differs = |speed: &f64| (speed - before).abs() > SAME_SPEED * before;
        if let Some(speed) = speeds.into_iter().find(differs)
            && !cut.told
        {
            cut.told = true;
            tally.raise(Cause::ThreadSpeed { speed, before }, from, None);
        }
        let into = tool.tip.vector()[across];
        if into == 0.0 {
            return None;
        }
        let mut ends = [from, to].map(|end| [end[axis], into.signum() * end[across]]);
        ends.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let met = (deep, metal.map(|place| place[axis]));
        if let Some(Home { start, .. }) = home
            && let Some(&first) = cut.starts[start].passes.last()
        {
            let depth = cut.add(start, Groove { ends, ..first }, met);
            return Some((number_of_cut, start, depth));
        }
        let part = (cut.along - from[axis]) / (to[axis] - from[axis]);
        let depth = into.signum() * (from[across] + (to[across] - from[across]) * part);
        let turned = thread.lead * turned;
        let phase = from[axis] + if forward { -turned } else { turned };
        let groove = Groove { pass: number, phase, depth, ends };
        let (start, depth) = cut.take(groove, met, |cause| tally.alarm(cause, from, None));
        Some((number_of_cut, start, depth))
    }
}
