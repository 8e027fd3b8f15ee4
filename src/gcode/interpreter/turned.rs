//! What the cuts of a lathe need: a spindle that is started, a tool with its offset, a thread that the axis can follow.
//!
//! A control asks for none of it, and cuts: each is a caution.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::Size;
use crate::gcode::code::M;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::Thread;
use crate::gcode::rules::turned::{
    CutsWithoutOffset, NoOffsetAnywhere, PassFarDeeper, SpindleNeverStarts, ThreadAtSurfaceSpeed, ThreadBeyondRapid,
    ThreadWithoutSpeedLimit,
};
use crate::gcode::turning::pace::{greatest, peak, revolutions};
use crate::limits::EXAMPLE_RAPID;
use crate::machine::axis::{Axis, Pose};
use crate::text::t;

/// What a lathe's program has said of its spindle and its tools, and where it cut.
#[derive(Debug, Default)]
pub(super) struct TurnedSeen {
    /// A code has started a spindle, or may have: one of the machine's builder may start that of a live tool.
    pub(super) started: bool,
    /// A T has put an offset into force.
    pub(super) offset: bool,
    /// The first cut.
    cut: Option<Spot>,
    /// The first cut under each T whose offset is 0, with that word and the one that has the tool's own offset.
    without: BTreeMap<u32, (Spot, [String; 2])>,
    /// The first pass of the G92 in force, where no other has come yet.
    first_pass: Option<Spot>,
    /// The places of the turret whose thread has been told to be too fast.
    fast: BTreeSet<u32>,
}

impl Reader<'_, '_> {
    /// Sees the code of the spindle in the block in hand.
    pub(super) fn see_start_of_spindle(&mut self, code: Option<M>) {
        self.memory.seen.turned.started |= matches!(code, Some(M::Spindle(_))) || self.in_doubt(doubt::SPINDLE);
    }

    /// Sees a cut of a lathe.
    pub(super) fn see_turned(&mut self) {
        let spot = self.block.spot;
        self.memory.seen.turned.started |= self.in_doubt(doubt::SPINDLE);
        self.memory.seen.turned.cut.get_or_insert(spot);
        let modal = &self.state.modal;
        if modal.selected.is_some()
            && modal.offset == 0
            && !self.in_doubt(doubt::TOOL)
            && let Some(words) = self.memory.control.tool.without_offset(modal.tool)
        {
            self.memory.seen.turned.without.entry(modal.tool).or_insert((spot, words));
        }
    }

    /// Sees a pass of a thread.
    pub(super) fn see_thread(&mut self, thread: &Thread, to: &Pose) {
        self.see_turned();
        if self.in_doubt(doubt::SPEED | doubt::SPINDLE | doubt::FEED) {
            return;
        }
        let spot = self.block.spot;
        if self.state.modal.constant_surface_speed {
            self.memory.remarks.row(&ThreadAtSurfaceSpeed {}, spot, None);
        }
        // The spindle of a machine that is not known has a limit that is not known.
        let modal = &self.state.modal;
        let machine = self.memory.setting.greatest_speed;
        let unlimited = modal.constant_surface_speed && greatest(&modal.in_force(), machine).is_none();
        let seconds = self.thread_seconds(to, thread).filter(|&seconds| seconds > 0.0);
        if self.pace().is_none() || seconds.is_none() && !unlimited {
            return;
        }
        let by = |axis: Axis| (to.get(axis) - self.state.at.get(axis)).abs();
        let distance = by(Axis::X).max(by(Axis::Z));
        let peak = peak(distance, thread);
        let known = self.memory.setting.rapid;
        let [x, z] = known.unwrap_or(EXAMPLE_RAPID);
        let fast = [(Axis::X, x), (Axis::Z, z)].into_iter().filter_map(|(axis, rapid)| {
            let feed = seconds.map_or(f64::INFINITY, |seconds| by(axis) * 60.0 / seconds * peak);
            (by(axis) > 0.0 && feed > rapid * (1.0 + 1e-9)).then_some((axis, feed, rapid))
        });
        // The axis that allows the least speed.
        let beyond = fast.max_by(|(one, _, x), (other, _, z)| (by(*one) * z).total_cmp(&(by(*other) * x)));
        if let Some((axis, feed, rapid)) = beyond
            && self.memory.seen.turned.fast.insert(self.state.modal.tool)
        {
            let whose = match known {
                Some(_) => t("del libro de torno", "of the lathe workbook"),
                None => t("de la máquina de ejemplo", "of the example machine"),
            };
            let turns = revolutions(distance, thread).filter(|_| unlimited);
            let speed = turns.map(|turns| Size::rpm(rapid * turns / (by(axis) * peak)));
            let [feed, rapid] = [feed, rapid].map(|rate| Size::feed(rate, 0));
            let axis = axis.letter();
            match speed {
                Some(speed) => {
                    let row = ThreadWithoutSpeedLimit { speed, axis, rapid, whose };
                    self.memory.remarks.row(&row, spot, None);
                }
                None => self.memory.remarks.row(&ThreadBeyondRapid { feed, axis, rapid, whose }, spot, None),
            }
        }
    }

    /// The first pass of a G92.
    pub(super) fn see_first_pass(&mut self) {
        self.memory.seen.turned.first_pass = Some(self.block.spot);
    }

    /// A pass of G92 behind another of the same thread, from `start` to the two radii, mm. A whole thread is less deep than its lead; a
    /// first pass that is deeper than the next by more is no thread of its own, which has more passes than one.
    pub(super) fn remark_far_deeper(&mut self, start: f64, [before, now]: [f64; 2], lead: f64) {
        let by = (now - start).abs() - (before - start).abs();
        let first = self.memory.seen.turned.first_pass.take();
        let (spot, than) = if by > 0.0 {
            (Some(self.block.spot), t("la anterior", "the one before"))
        } else {
            (first, t("la siguiente", "the next"))
        };
        if let Some(spot) = spot.filter(|_| by.abs() > lead) {
            let row = PassFarDeeper { by: Size::mm(by.abs()), than, lead: Size::mm(lead) };
            self.memory.remarks.row(&row, spot, None);
        }
    }

    /// The program has ended, as a whole or not: what nothing in it does is known of a whole one alone.
    pub(super) fn end_turned(&mut self, speed: bool, whole: bool) {
        if let Some(spot) = self.memory.seen.turned.cut.take().filter(|_| whole)
            && speed
            && !self.memory.seen.turned.started
        {
            self.memory.remarks.row(&SpindleNeverStarts {}, spot, None);
        }
        let mut without: Vec<_> = std::mem::take(&mut self.memory.seen.turned.without).into_values().collect();
        let some = self.memory.seen.turned.offset;
        if !some {
            without.sort_by_key(|(spot, _)| spot.line);
            without.truncate(1);
        }
        for (spot, [word, like]) in without {
            if some || !whole {
                self.memory.remarks.row(&CutsWithoutOffset { word, like }, spot, None);
            } else {
                self.memory.remarks.row(&NoOffsetAnywhere { word, like }, spot, None);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FAGOR_8055_T, FANUC_LATHE_A};
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// The codes G0530 to G0599 of what is remarked of a program for a lathe.
    fn remarked(control: &'static Control, blocks: &str, rapid: Option<[f64; 2]>) -> Vec<&'static str> {
        let program = format!("{}\nM30\n", blocks.replace('|', "\n"));
        let mut setting = Setting::new(control);
        setting.rapid = rapid;
        let mut interpreter = Interpreter::over(program.as_bytes(), setting);
        assert!(interpreter.by_ref().all(|motion| motion.is_ok()), "{blocks}");
        let codes = interpreter.remarks().into_iter().map(|finding| finding.code());
        codes.filter(|code| ("G0530".."G0600").contains(code) && *code != "G0534").collect()
    }

    fn fanuc(blocks: &str) -> Vec<&'static str> {
        remarked(&FANUC_LATHE_A, &format!("G21 G99 G97|{blocks}"), None)
    }

    #[test]
    fn a_lathe_that_cuts_starts_its_spindle() {
        for (blocks, told) in [
            ("S800|T0101|G0 X48. Z2.|G1 Z-20. F.2", &["G0583"][..]),
            ("S800|T0101|G98 G0 X48. Z2.|G1 Z-20. F200.|M5", &["G0583"]),
            ("S800|T0404|G0 X49. Z6.|G32 Z-20. F2.", &["G0583"]),
            ("S800 M4|T0101|G0 X48. Z2.|G1 Z-20. F.2", &[]),
            // A bar is drawn out behind M5, not before any M3.
            ("S800 M3|T0101|G98 G0 X48. Z2.|G1 Z-20. F200.|M5|G0 X0. Z2.|G1 Z0. F200.|M3|G0 X48.|G1 Z-20.", &[]),
            ("S800|T0101|G98 G0 X48. Z2.|G1 Z-20. F100.|G0 X60.|M3|G0 X46. Z2.|G1 Z-20.", &["G0530"]),
            ("S800 M43|T0101|G98 G0 X48. Z2.|G1 Z-20. F100.|G0 X60.|M3|G0 X46. Z2.|G1 Z-20.", &[]),
            // A code of the builder may start a live tool; without S the program speaks of no spindle.
            ("S800 M43|T0101|G98 G0 X48. Z2.|G1 X40. F200.", &[]),
            ("T0101|G98 G0 X48. Z2.|G1 Z-20. F200.", &[]),
            ("S800|T0101|G0 X48. Z2.", &[]),
            // A feed per revolution waits for ever.
            ("S800|T0101|G0 X48. Z2.|G1 Z-20. F.2|G0 X60.|M3|G0 X46.|G1 Z-20.", &["G0530"]),
            ("S800|T0404|G0 X49. Z6.|G32 Z-20. F2.|M3|G32 Z-40.", &["G0530"]),
            ("S800 M3|T0101|G0 X48. Z2.|G1 Z-20. F.2|M5|M3|G1 Z-30.", &[]),
            ("S800 M43|T0101|G0 X48. Z2.|G1 Z-20. F.2|M3|G1 Z-30.", &[]),
        ] {
            assert_eq!(fanuc(blocks), told, "{blocks}");
        }
        assert_eq!(remarked(&FAGOR_8055_T, "G71 G90 G95 S800|T1 D1|G0 X48 Z2|G1 Z-20 F0.2", None), ["G0583"]);
        let before = "G71 G90 G94 F100 S800|T1 D1|G0 X48 Z2|G1 Z-20|G0 X60|M3|G0 X46 Z2|G1 Z-20";
        assert_eq!(remarked(&FAGOR_8055_T, before, None), ["G0530"]);
    }

    /// The codes of what is remarked of a program that ends as it stands, refused or not.
    fn ended(blocks: &str) -> Vec<&'static str> {
        let program = format!("G21 G99 G97|{blocks}").replace('|', "\n");
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&FANUC_LATHE_A));
        interpreter.by_ref().for_each(drop);
        let codes = interpreter.remarks().into_iter().map(|finding| finding.code());
        codes.filter(|code| ("G0530".."G0600").contains(code) && *code != "G0534").collect()
    }

    #[test]
    fn what_is_judged_at_the_end_is_judged_at_any() {
        for (blocks, told) in [
            ("T0200|S800|G0 X48. Z2.|G1 Z-20. F.2|M99", &["G0583", "G0585"][..]),
            ("T0200|S800|G0 X48. Z2.|G1 Z-20. F.2|M99 P10", &["G0583", "G0585"]),
            ("T0101|M3|G0 X48. Z2.|G1 Z-20. F.2|M99", &["G0538"]),
            ("T0101|S800 M3|G0 X48. Z2.|G1 Z-20. F.2|T0200|G1 Z-21.|M99", &["G0584"]),
            ("T0101|S800 M3|G0 X48. Z2.|G1 Z-20. F.2|M99", &[]),
            ("T0200|S800|G0 X48. Z2.|G1 Z-20. F.2", &["G0583", "G0585"]),
            // What would have come behind a call of nothing may start the spindle, and give offsets.
            ("T0200|S800|G0 X48. Z2.|G1 Z-20. F.2|M98 P5|M30", &["G0530", "G0584"]),
            ("T0200|S800|G98|G0 X48. Z2.|G1 Z-20. F200.|M98 P5|M30", &["G0530", "G0584"]),
            ("T0101|M3|G0 X48. Z2.|G1 Z-20. F.2|M98 P5|M30", &["G0538"]),
            ("T0200|S800|G0 X48. Z2.|G1 Z-20. F.2|M98 P5|M30\nO0005|G1 Z-21.", &["G0530", "G0584"]),
        ] {
            let mut found = ended(blocks);
            found.sort_unstable();
            assert_eq!(found, told, "{blocks}");
        }
    }

    #[test]
    fn f_in_a_block_in_rapid_is_told_towards_the_part_and_in_a_bore() {
        for (blocks, told) in [
            ("G0 X50. Z2.|X30. F.2", &["G0570"][..]),
            ("G0 X-50. Z2.|X-30. F.2", &["G0570"]),
            ("G0 X-30. Z2.|X-60. F.2", &[]),
            ("G0 X10. Z2.|X-60. F.2", &["G0570"]),
            ("G0 X20. Z2.|Z-20.|X30. F.1", &["G0570"]),
            ("G0 X-20. Z2.|Z-20.|X-30. F.1", &["G0570"]),
            ("G0 X20. Z2.|Z-20.|G0 X30. F.1", &[]),
            ("G0 X20. Z2.|Z-20.|X30. Z1. F.1", &[]),
            ("G0 X20. Z2.|X30. F.1", &[]),
        ] {
            assert_eq!(fanuc(&format!("S800 M3|T0101|{blocks}")), told, "{blocks}");
        }
    }

    #[test]
    fn a_cut_under_a_t_without_an_offset_is_told() {
        for (blocks, told) in [
            ("T0200|G0 X54. Z6.|G1 X40. F.1", &["G0585"][..]),
            ("T0200|G0 X54. Z6.|G1 X40. F.1|T0300|G1 X39.", &["G0585"]),
            ("T0101|G0 X54. Z6.|G1 X50. F.1|T0200|G1 X40.", &["G0584"]),
            ("T0101|G0 X54. Z6.|T0100|G1 X40. F.1", &["G0584"]),
            ("T0101|G0 X54. Z6.|T0|G1 X40. F.1", &["G0584"]),
            ("T0200|G0 X54. Z6.|G92 X49. Z-9. F2.", &["G0585"]),
            // The offset is taken back for the turret to index.
            ("T0101|G0 X54. Z6.|G1 X40. F.1|G0 X100. Z100. T0100|T0202|G1 X40.", &[]),
            ("G0 X54. Z6.|G1 X40. F.1", &[]),
        ] {
            assert_eq!(fanuc(&format!("S800 M3|{blocks}")), told, "{blocks}");
        }
        assert!(remarked(&FAGOR_8055_T, "G71 G90 G95 S800 M3|T1 D0|G0 X48 Z2|G1 Z-20 F0.2", None).is_empty());
    }

    #[test]
    fn a_thread_has_a_speed_that_it_can_be_cut_at() {
        for (blocks, told) in [
            ("S800 M3|G0 X49. Z6.|G32 Z-20. F2.", &[][..]),
            ("S800 M3|G0 X49. Z6.|G32 Z-20. F12.5", &[]),
            ("S800 M3|G0 X49. Z6.|G32 Z-20. F12.6", &["G0580"]),
            ("S800 M3|G0 X49. Z6.|G32 X20. F12.", &["G0580"]),
            // The lead grows to 18.65 mm, and falls from 14 mm.
            ("S800 M3|G0 X49. Z6.|G34 Z-80. F2. K2.", &["G0580"]),
            ("S800 M3|G0 X49. Z6.|G34 Z-80. F14. K-1.", &["G0580"]),
            ("S800 M3|G0 X49. Z6.|G34 Z-80. F2. K.5", &[]),
            ("S800 M3|G0 X54. Z6.|G92 X49.5 Z-20. F200.|X49.", &["G0580"]),
            ("S800 M3|G0 X54. Z6.|G76 P010060 Q100 R.05|G76 X47.4 Z-40. P1200 Q300 F20.", &["G0580"]),
            ("S0 M3|G0 X49. Z6.|G32 Z-20. F2.", &["G0538"]),
            ("M3|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.", &["G0538"]),
            ("M3|G0 X49. Z6.|G34 Z-20. F2. K.01", &["G0538"]),
            ("M3|G0 X54. Z6.|G76 P010060 Q100 R.05|G76 X47.4 Z-20. P1200 Q300 F2.", &["G0538"]),
            ("G50 S2000|G96 S200 M3|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.", &["G0581"]),
            ("G50 S2000|G96 S200 M3|G0 X54. Z6.|G76 P010060 Q100 R.05|G76 X47.4 Z-20. P1200 Q300 F2.", &["G0581"]),
            ("G50 S2000|G96 S200 M3|G0 X49. Z6.|G32 Z-20. F2.", &["G0581"]),
            ("G50 S2000|G96 S200 M3|G0 X49. Z6.|G97 S800|G32 Z-20. F2.", &[]),
            // Nothing that is known limits the spindle: what it would come to without a limit is no fact.
            ("G96 S3100 M3|G0 X30. Z6.|G92 X25.3 Z-20. F2.|X24.9", &["G0581", "G0591"]),
            ("G96 S60 M3|G0 X30. Z6.|G92 X25.3 Z-20. F2.|X24.9", &["G0581"]),
            ("G50 S20000|G96 S3100 M3|G0 X30. Z6.|G92 X25.3 Z-20. F2.|X24.9", &["G0581", "G0580"]),
        ] {
            assert_eq!(fanuc(&format!("T0404|{blocks}")), told, "{blocks}");
        }
        // The machine of a workbook says what it can.
        let thread = "G21 G97 S800 M3|T0404|G0 X49. Z6.|G32 Z-20. F20.";
        assert!(remarked(&FANUC_LATHE_A, thread, Some([8000.0, 20_000.0])).is_empty());
        assert_eq!(remarked(&FANUC_LATHE_A, thread, Some([8000.0, 15_000.0])), ["G0580"]);
    }

    #[test]
    fn a_pass_of_a_thread_is_not_deeper_by_a_lead_than_the_one_before() {
        for (passes, told) in [
            ("G92 X49.5 Z-20. F2.|X49.|X48.", &[][..]),
            ("G92 X49.5 Z-20. F2.|X49.|X45.01", &[]),
            ("G92 X49.5 Z-20. F2.|X49.|X4.8", &["G0586"]),
            ("G92 X49.5 Z-20. F2.|X49.|X440.", &["G0586"]),
            // The first one alone is too deep.
            ("G92 X4.95 Z-20. F2.|X49.|X48.5", &["G0586"]),
            ("G92 X47. Z-20. F2.|X49.|X48.5", &[]),
            // Another thread.
            ("G92 X29.5 Z-20. F2.|X29.|X49.5 Z-30.|X49.", &[]),
            ("G92 X49.5 Z-20. F2.|X49.|G0 X30.|G92 X20. Z-5. F2.|X19.", &[]),
        ] {
            assert_eq!(fanuc(&format!("S800 M3|T0404|G0 X54. Z6.|{passes}")), told, "{passes}");
        }
    }

    #[test]
    fn a_contour_without_a_cut_is_told_once() {
        let cycle = |contour: &str| {
            let blocks = "S800 M3|T0101|G0 X52. Z2.|G71 U1.5 R.5|G71 P10 Q20 U.6 W.1 F.25";
            fanuc(&format!("{blocks}|{contour}|G70 P10 Q20 F.1"))
        };
        assert_eq!(cycle("N10 G0 X30.|Z-20.|X40. Z-25.|Z-40.|N20 X52."), ["G0582"]);
        assert!(cycle("N10 G0 X30.|G1 Z-20.|X40. Z-25.|Z-40.|N20 X52.").is_empty());
        // A block of it in rapid along the part: G71 and G70 tell it once.
        assert_eq!(cycle("N10 G0 X30.|Z0.|Z-20.|G1 X40. Z-25.|Z-40.|N20 X52."), ["G0587"]);
        assert_eq!(cycle("N10 G0 X30.|G1 Z-20.|G0 Z-25.|G1 X40. Z-30.|N20 X52."), ["G0587"]);
        assert!(cycle("N10 G0 X30.|Z0.|G1 Z-20.|X40. Z-25.|Z-40.|N20 G0 X52.").is_empty());
    }
}
