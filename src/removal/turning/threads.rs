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
    /// It does not go on from another block of the thread.
    pub begins: bool,
    /// How deep the metal is that it meets, mm.
    pub deep: f64,
    /// From where to where the tool stands in metal: the least and the greatest `[z, r]`.
    pub metal: [[f64; 2]; 2],
}

/// Where a pass lies; mm.
#[derive(Clone, Copy, Debug)]
struct Groove {
    /// Where along the thread it would be at the spindle's angle 0.
    phase: f64,
    /// How far it goes in the direction in which the tip points.
    depth: f64,
    /// From where to where it goes along the thread.
    over: [f64; 2],
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
    /// How far along the thread two passes are apart beyond what lies within the shallower one's groove, and both lengths; mm.
    ///
    /// Grooves whole leads apart are one, unless the lead changes.
    fn apart(&self, one: Groove, other: Groove) -> [f64; 3] {
        let Thread { lead, change, .. } = self.thread;
        let by = other.phase - one.phase;
        let off = if change == 0.0 { by - lead * (by / lead).round() } else { by }.abs();
        let most = (other.depth - one.depth).abs() * self.flank;
        [off - most, off, most]
    }

    /// Notes a pass; `alarm` makes the alarm of one that is deeper than all before and in the groove of none. One that is no
    /// deeper may be another start. Returns how much deeper it is than the passes before in its groove, mm, where the tool stands in
    /// `metal` from here to there along the thread, and where no pass before has been it is `deep`; `None` for the first.
    fn take(
        &mut self,
        pass: Groove,
        (deep, metal): (f64, [f64; 2]),
        alarm: impl FnOnce(Cause) -> Alarm,
    ) -> Option<f64> {
        let numbered = self.starts.iter().enumerate();
        let before = numbered.flat_map(|(at, start)| start.passes.iter().map(move |&groove| (at, groove)));
        let nearest = before
            .clone()
            .map(|(at, groove)| (at, self.apart(groove, pass)))
            .min_by(|(_, [one, ..]), (_, [other, ..])| one.total_cmp(other));
        let deepest = before.map(|(_, groove)| groove.depth).fold(f64::MIN, f64::max);
        match nearest {
            Some((at, [beyond, ..])) if beyond <= OFF_GROOVE || pass.depth > deepest + TOUCH => {
                // The first pass of a groove is shallow and leaves much room: each of them is to lie within this one.
                let found = self.starts[at].passes.iter().map(|&groove| self.apart(groove, pass));
                let farthest = found.max_by(|[one, ..], [other, ..]| one.total_cmp(other));
                let [beyond, off, most] = farthest.unwrap_or_default();
                let start = &mut self.starts[at];
                let more = deeper(pass, &start.passes, metal, self.thread.lead).unwrap_or(deep);
                start.passes.push(pass);
                if beyond > OFF_GROOVE && start.off.is_none() {
                    start.off = Some(alarm(Cause::OffGroove { off, most }));
                }
                Some(more)
            }
            _ => {
                self.starts.push(Start { passes: vec![pass], off: None });
                None
            }
        }
    }

    /// The alarms of starts whose deepest pass does not take in all the others.
    fn off_groove(&self) -> impl Iterator<Item = Alarm> + '_ {
        self.starts.iter().filter_map(|start| {
            let deepest = start.passes.iter().copied().max_by(|one, other| one.depth.total_cmp(&other.depth))?;
            start.off.filter(|_| start.passes.iter().any(|&pass| self.apart(pass, deepest)[0] > OFF_GROOVE))
        })
    }
}

/// How much deeper a pass is than those before it over more than a lead of the metal that it meets, mm; `None` where none of them has
/// been there.
///
/// # Derivation
/// A pass that goes farther along the thread than those before it meets the full depth there, however deep they are beside it. Passes end
/// a little apart, as where the tool is pulled out: a lead of length decides, or half the metal where that is less. From the deepest of the
/// passes before on, what each has been over is taken off the metal; the one that leaves no more than that is the one to compare with.
fn deeper(pass: Groove, before: &[Groove], [low, high]: [f64; 2], lead: f64) -> Option<f64> {
    let mut left = vec![[low, high]];
    let mut before: Vec<&Groove> = before.iter().collect();
    before.sort_by(|one, two| two.depth.total_cmp(&one.depth));
    for groove in before {
        let [from, to] = groove.over;
        left = (left.iter())
            .flat_map(|&[low, high]| [[low, high.min(from)], [low.max(to), high]])
            .filter(|[low, high]| high > low)
            .collect();
        if left.iter().map(|[low, high]| high - low).sum::<f64>() <= lead.min((high - low) / 2.0) {
            return Some(pass.depth - groove.depth);
        }
    }
    None
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
}

impl Threads {
    /// Counts the revolutions of a block; returns those before it. A pass begins at its own angle, and its further blocks go on.
    pub fn turn(&mut self, thread: &Thread, turns: f64, begins: bool) -> f64 {
        let before = if begins { thread.angle / 360.0 } else { self.turned };
        self.turned = before + turns;
        before
    }

    /// How much a new pass is compared with.
    pub fn passes(&self) -> usize {
        let cuts = self.known.iter().flat_map(|known| &known.cuts);
        self.known.len() + cuts.flat_map(|cut| &cut.starts).map(|start| start.passes.len()).sum::<usize>()
    }

    /// Notes a pass in metal, and raises the alarms of another lead or spindle speed than in the passes before. Returns how deep it goes
    /// at once, mm on the radius; `None` for what does not say it.
    pub fn judge(&mut self, pass: &ThreadPass<'_>, tally: &mut Tally) -> Option<f64> {
        let ([from, to], lead) = (pass.way, pass.thread.lead);
        let [z, r] = [0, 1].map(|axis| [from[axis].min(to[axis]), from[axis].max(to[axis])]);
        let meets = |one: [f64; 2], two: [f64; 2], apart: f64| one[0] < two[1] + apart && two[0] < one[1] + apart;
        let near = |known: &Known| {
            // Along the thread they must share more than a lead, so that a run-out does not count.
            let along = if z[1] - z[0] >= r[1] - r[0] { (-lead, APART) } else { (APART, -lead) };
            meets(known.z, z, along.0) && meets(known.r, r, along.1)
        };
        let at = self.known.iter().position(near).unwrap_or_else(|| {
            self.known.push(Known { z, r, lead, cuts: Vec::new() });
            self.known.len() - 1
        });
        let known = &mut self.known[at];
        if (known.lead - lead).abs() > 1e-6 {
            tally.raise(Cause::LeadDiffers { lead, before: known.lead }, from, None);
            return None;
        }
        for (held, new) in [(&mut known.z, z), (&mut known.r, r)] {
            *held = [held[0].min(new[0]), held[1].max(new[1])];
        }
        known.take(pass, tally)
    }

    /// The alarms of deeper passes off the groove of the passes before, which can be reported only when the program has ended:
    /// with an infeed along either flank in turn, a pass is off the one before and the last one takes in both.
    pub fn off_groove(&self) -> Vec<Alarm> {
        self.known.iter().flat_map(|known| &known.cuts).flat_map(CutThread::off_groove).collect()
    }
}

impl Known {
    fn take(&mut self, pass: &ThreadPass<'_>, tally: &mut Tally) -> Option<f64> {
        let &ThreadPass { thread, way: [from, to], turned, place, tool, begins, deep, metal } = pass;
        let along = usize::from((to[1] - from[1]).abs() > (to[0] - from[0]).abs());
        let across = 1 - along;
        let forward = to[along] > from[along];
        let speeds = [from, to].map(|at| tally.turning.at(at[1] + tally.shift[1]));
        let same = |cut: &CutThread| cut.place == place && cut.forward == forward;
        let at = self.cuts.iter().position(same).unwrap_or_else(|| {
            let flank = match tool.cutter {
                Cutter::Threader { angle, .. } => tan(angle.to_radians() / 2.0),
                _ => 0.0,
            };
            let (speed, along, starts) = (speeds[0], to[along], Vec::new());
            self.cuts.push(CutThread { place, forward, thread, speed, told: false, along, flank, starts });
            self.cuts.len() - 1
        });
        let cut = &mut self.cuts[at];
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
        let part = (cut.along - from[along]) / (to[along] - from[along]);
        let depth = into.signum() * (from[across] + (to[across] - from[across]) * part);
        let turned = thread.lead * turned;
        let phase = from[along] + if forward { -turned } else { turned };
        let over = [from[along].min(to[along]), from[along].max(to[along])];
        let met = (deep, metal.map(|place| place[along]));
        let more = cut.take(Groove { phase, depth, over }, met, |cause| tally.alarm(cause, from, None));
        // A further block of a pass has its depth from where the pass began.
        more.map_or(Some(deep), |more| begins.then_some(more))
    }
}
