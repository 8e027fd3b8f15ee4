//! What is valid alone but not together: the checks of one parameter of the impeller against another.

use crate::finding::figures::count;
use crate::finding::{Bare, Figures, Finding, Limit, Raise, Size, Typed};
use crate::gcode::machine_codes::{CodesPlace, refused_codes, refused_retract, refused_spindle};
use crate::gcode::word::Distance;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade_count::{N_max, e_max, hub_circumference, least_gap};
use crate::kinds::impeller::blank::BlankTurning;
use crate::kinds::impeller::clear::remarks;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::rules::{
    AbsoluteOnRollover, BladeTooThick, CutThroughHub, EndInsideStock, FeedBeyondMachine, NoBladeFits, NoThicknessFits,
    PivotInside, RetractOutside, RetractSideways, RetractTooLow, SafePointsInside, StepBeyondMeridian, StockTooShort,
    TooManyBlades, TooManyBlocks, ToolBeyondHollow, TorusCloses, TravelReversed,
};
use crate::kinds::rules::{AnnexCarriesNoFeed, FullStyleNeeds};
use crate::limits::PROGRAM_BLOCKS;
use crate::machine::axis::Axis;
use crate::machine::travel::{AxisTravel, excess};
use crate::number::shown;
use crate::parameter::at;
use crate::text::many;

impl Design {
    /// What is valid alone but not together. All findings are stops.
    #[must_use]
    pub(super) fn contradictions(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        self.check_geometry(&mut findings);
        match &self.clear {
            None => self.check_published(&mut findings),
            Some(asked) => {
                self.check_hub(&mut findings);
                findings.extend(remarks::contradictions(self, asked));
            }
        }
        self.check_machine(&mut findings);
        self.check_program(&mut findings);
        self.blank.check(self.torus, &mut findings);
        findings
    }

    fn check_geometry(&self, findings: &mut Vec<Finding>) {
        let Torus { R, r } = self.torus;
        let tool = Size::mm(self.d_t);
        // Relative tolerance: below it the blade's angle α is 90° within the printed digits and the hub vanishes.
        if r >= R * (1.0 - 1e-6) {
            // They may differ beyond the digits of a length.
            let [typed, of] = [r, R].map(|value| Typed { value, unit: "mm" });
            let told = TorusCloses { r: typed, R: of };
            findings.push(
                told.at(at([form::R.key(), form::MERIDIAN_R.key()])).with(mm(r), mm(R)).measuring(r, Limit::AtMost(R)),
            );
            return;
        }
        if self.a_p >= R - r {
            let told = CutThroughHub { a_p: Size::mm(self.a_p), room: Size::mm(R - r) };
            let place = at([form::A_P.key(), form::R.key(), form::MERIDIAN_R.key()]);
            findings.push(told.at(place).with(mm(self.a_p), mm(R - r)).measuring(self.a_p, Limit::AtMost(R - r)));
            return;
        }
        if self.d_t > 2.0 * r {
            let told = ToolBeyondHollow { tool, r: Size::mm(r) };
            findings.push(
                told.at(at([form::D_T.key(), form::MERIDIAN_R.key()]))
                    .with(mm(self.d_t), mm(2.0 * r))
                    .measuring(self.d_t, Limit::AtMost(2.0 * r)),
            );
        }
    }

    /// A blade and the tool beside it need more than the whole hub: no search for a gap is needed.
    fn check_hub(&self, findings: &mut Vec<Finding>) {
        let around = hub_circumference(self.torus, self.a_p);
        if around > 0.0 && around < self.e + self.d_t {
            let gap = Size::mm((around - self.e).max(0.0));
            findings.push(self.no_blade_fits(around, gap, self.d_t));
        }
    }

    /// Blade and gap need more than there is all round.
    fn no_blade_fits(&self, around: f64, gap: Size, least: f64) -> Finding {
        let [e, tool, need, hub, least] = [self.e, self.d_t, self.e + least, around, least].map(Size::mm);
        let told = NoBladeFits { e, tool, need, hub, gap, least };
        told.at(at([form::N.key(), form::E.key(), form::D_T.key()]))
            .with(mm(need.value), mm(around))
            .measuring(need.value, Limit::AtMost(around))
    }

    /// What the published method asks for beside: its own limits of blades and thickness, and safe points outside its passes.
    fn check_published(&self, findings: &mut Vec<Finding>) {
        let Torus { R, r } = self.torus;
        // Told already, and the limits would mean nothing.
        if r >= R * (1.0 - 1e-6) || self.a_p >= R - r {
            return;
        }
        let (N, e, tool) = (self.N, Size::mm(self.e), Size::mm(self.d_t));
        let (most, thickest) =
            (N_max(self.torus, self.a_p, self.e, self.d_t), e_max(self.torus, self.a_p, self.N, self.d_t));
        let around = hub_circumference(self.torus, self.a_p);
        let gap = Size::mm((around / f64::from(N) - self.e).max(0.0));
        let least = Size::mm(least_gap(self.d_t));
        let place = at([form::N.key(), form::E.key(), form::D_T.key()]);
        if f64::from(N) > most && most < 1.0 {
            findings.push(self.no_blade_fits(around, gap, least_gap(self.d_t)));
        } else if f64::from(N) > most {
            let told = TooManyBlades { N, most: Size::number(most, 0), e, tool, gap, least };
            findings
                .push(told.at(place).with(N.to_string(), shown(most, 0)).measuring(f64::from(N), Limit::AtMost(most)));
        }
        let place = at([form::E.key(), form::N.key(), form::D_T.key()]);
        // With the tool alone the turn is used up: there is no greatest thickness to name.
        if self.e > thickest && thickest <= 0.0 {
            let told = NoThicknessFits { N, e, room: Size::mm(around / f64::from(N)), least };
            findings.push(told.at(place).with(mm(self.e), "").comparing(Figures::of(self.e, None)));
        } else if self.e > thickest {
            let blades = many(N, ["álabe", "álabes"], ["blade", "blades"]);
            let told = BladeTooThick { e, most: Size::mm(thickest), blades, N };
            findings.push(told.at(place).with(mm(self.e), mm(thickest)).measuring(self.e, Limit::AtMost(thickest)));
        }
        // w·cos β, with β = asin(r/R) at both ends: the reverse's first point lies that far outside the mean line's.
        let across = self.w() * ((R - r) * (R + r)).sqrt() / R;
        let reach = self.d_s + self.d_t / 2.0;
        if reach <= across {
            let least = across - self.d_t / 2.0;
            let told = SafePointsInside { d_s: Size::mm(self.d_s), least: Size::mm(least) };
            let place = at([form::D_S.key(), form::D_T.key(), form::E.key()]);
            findings.push(told.at(place).with(mm(self.d_s), mm(least)).measuring(self.d_s, Limit::AtLeast(least)));
        }
    }

    fn check_machine(&self, findings: &mut Vec<Finding>) {
        let L = self.machine.L;
        // The part reaches from the origin down to −r, and its rim stands R away from the axis.
        let least = self.torus.R.max(self.torus.r);
        if L <= least {
            let told = PivotInside { L: Size::mm(L), least: Size::mm(least) };
            findings.push(
                told.at(at([form::R_B.key(), form::H.key(), form::R.key()]))
                    .with(mm(L), mm(least))
                    .measuring(L, Limit::AtLeast(least)),
            );
        }
        for AxisTravel { axis, ends, keys } in self.travel {
            if let [Some(low), Some(high)] = ends
                && low >= high
            {
                let unit = if axis.rotary() { "°" } else { "mm" };
                let bare = |value| Bare(Size { value, unit, decimals: 3 });
                let told = TravelReversed { axis: axis.letter(), low: bare(low), high: bare(high) };
                findings
                    .push(told.at(at(keys)).with(shown(low, 3), shown(high, 3)).measuring(low, Limit::AtMost(high)));
            }
        }
        if let (Some(F), Some(F_max)) = (self.F, self.F_max)
            && F > F_max
        {
            let feed = |value| Size::feed(value, 3);
            let told = FeedBeyondMachine { F: feed(F), F_max: feed(F_max) };
            findings.push(
                told.at(at([form::F.key(), form::F_MAX.key()]))
                    .with(shown(F, 3), shown(F_max, 3))
                    .measuring(F, Limit::AtMost(F_max)),
            );
        }
    }

    /// The block that takes the tool away: that it goes straight up and, in program coordinates, how far. No other judge
    /// follows it. How high machine zero is nobody knows here.
    fn check_retract(&self, findings: &mut Vec<Finding>) {
        let Some(z) = self.retract.z() else { return };
        let place = || at([form::RETRACT.key()]);
        let sideways = self.retract.sizes().map(|(axis, _)| axis).filter(|&axis| axis != 'Z');
        findings.extend(sideways.map(|axis| RetractSideways { axis }.at(place())));
        if self.retract.by_machine() {
            return;
        }
        let height = self.retract_height();
        let beyond = self.travel.iter().find(|travel| travel.axis == Axis::Z);
        if z < height {
            let told = RetractTooLow { z: Size::mm(z), height: Size::mm(height) };
            findings.push(told.at(place()).with(mm(z), mm(height)).measuring(z, Limit::AtLeast(height)));
        } else if let Some((travel, beyond)) = beyond.and_then(|of| Some((of, excess(of.ends, z)?))) {
            let told = RetractOutside { z: Size::mm(z), limit: Size::mm(beyond.limit) };
            let [low, high] = travel.keys;
            findings.push(told.at(at([form::RETRACT.key(), low, high])).with(mm(z), mm(beyond.limit)).measuring(
                z,
                if z < beyond.limit { Limit::AtLeast(beyond.limit) } else { Limit::AtMost(beyond.limit) },
            ));
        }
    }

    fn check_program(&self, findings: &mut Vec<Finding>) {
        if self.style == Style::Full {
            for (symbol, missing) in [(form::F.key(), self.F.is_none()), (form::S.key(), self.S.is_none())] {
                if missing {
                    findings.push(FullStyleNeeds { symbol }.at(at([symbol, form::STYLE.key()])));
                }
            }
        } else if self.post.control.feed.missing.refused() {
            let told = AnnexCarriesNoFeed { control: self.post.control.name };
            findings.push(told.at(at([form::STYLE.key(), form::DIALECT.key()])));
        }
        if self.style == Style::Full && self.distance == Distance::Absolute && self.counting.rolls_over() {
            let place = at([form::DISTANCE.key(), form::ROTARY.key(), form::DIALECT.key()]);
            findings.push(AbsoluteOnRollover {}.at(place));
        }
        let refused = refused_retract(self.post.control, form::RETRACT.key(), &self.retract);
        if refused.is_empty() {
            self.check_retract(findings);
        }
        findings.extend(refused);
        findings.extend(refused_spindle(form::COOLANT.key(), &self.coolant, false));
        findings.extend(refused_spindle(form::START_CODES.key(), &self.start_codes, true));
        let within = CodesPlace { last: false, tooled: true };
        findings.extend(refused_codes(self.post.control, form::COOLANT.key(), &self.coolant, within));
        findings.extend(refused_codes(self.post.control, form::START_CODES.key(), &self.start_codes, within));
        findings.extend(refused_codes(
            self.post.control,
            form::END_CODES.key(),
            &self.end_codes,
            CodesPlace { last: true, ..within },
        ));
        if self.clear.is_some() {
            return;
        }
        let passes = 2 * u64::from(self.N) * if self.splitters { 2 } else { 1 };
        let blocks = passes.saturating_mul(self.n as u64 + 1);
        if blocks > PROGRAM_BLOCKS {
            let told = TooManyBlocks { blocks, most: PROGRAM_BLOCKS };
            let place = at([form::INTERVALS_N.key(), form::N.key()]);
            findings.push(
                told.at(place)
                    .with(blocks.to_string(), PROGRAM_BLOCKS.to_string())
                    .measuring(count(blocks), Limit::AtMost(count(PROGRAM_BLOCKS))),
            );
        }
    }
}

impl BlankTurning {
    /// Holds the turning against the torus; every contradiction is a stop.
    fn check(&self, torus: Torus, findings: &mut Vec<Finding>) {
        let Torus { R, r } = torus;
        if self.L_b <= r {
            let told = StockTooShort { length: Size::mm(self.L_b), r: Size::mm(r) };
            findings.push(
                told.at(at([form::L_B.key(), form::MERIDIAN_R.key()]))
                    .with(mm(self.L_b), mm(r))
                    .measuring(self.L_b, Limit::AtLeast(r)),
            );
        }
        if self.X_e <= 2.0 * R {
            let told = EndInsideStock { X_e: Size::mm(self.X_e), diameter: Size::mm(2.0 * R) };
            findings.push(
                told.at(at([form::X_E.key(), form::R.key()]))
                    .with(mm(self.X_e), mm(2.0 * R))
                    .measuring(self.X_e, Limit::AtLeast(2.0 * R)),
            );
        }
        if self.C > r {
            let told = StepBeyondMeridian { C: Size::mm(self.C), r: Size::mm(r) };
            findings.push(
                told.at(at([form::C.key(), form::MERIDIAN_R.key()]))
                    .with(mm(self.C), mm(r))
                    .measuring(self.C, Limit::AtMost(r)),
            );
        }
    }
}

fn mm(value: f64) -> String {
    format!("{} mm", shown(value, 3))
}
