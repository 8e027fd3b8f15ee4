//! What is valid alone but not together: the checks of one parameter of the branch against another.

use crate::finding::{Finding, Limit, Raise, Size};
use crate::gcode::machine_codes::{CodesPlace, refused_codes};
use crate::gcode::program::Style;
use crate::kinds::pipe::dimensions::solid;
use crate::kinds::pipe::form::{D_BRANCH, D_HEADER, DIALECT, E, END_CODES, THETA, TORCH_OFF, TORCH_ON};
use crate::kinds::pipe::insert::cut::{finest, half_step};
use crate::kinds::pipe::insert::design::{Contact, Design, Mode};
use crate::kinds::pipe::insert::parameters::{
    ARC_TOLERANCE, CONTACT, EXPERT_BRANCH_R, F, KERF, LEAD_IN, MODE, OVERCUT, R, STYLE,
};
use crate::kinds::pipe::insert::rules::{
    AnnexIsFlat, BranchLarger, BranchOverhangs, FinerThanAngle, KerfBeyondBore, KerfBeyondGap, LeadInCutsPart,
    RadiusOfEnvelope,
};
use crate::kinds::pipe::rules::OvercutPastTurn;
use crate::kinds::pipe::switching::{on_at_end, opposed};
use crate::kinds::rules::{AnnexCarriesNoFeed, FullStyleNeeds};
use crate::parameter::at;

impl Design {
    /// What stands against lead-in, overcut and tolerance on a turning pipe.
    fn way_beside_the_curve(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let most = self.outline().longest_lead_in(self.lead_in);
        if most < self.lead_in {
            let (lead, most) = (Size::mm(self.lead_in), Size::mm(most));
            findings.push(LeadInCutsPart { lead, most }.at(at([LEAD_IN.key()])));
        }
        let (finest, tolerance) = (finest(self.outline().radius), self.arc_tolerance);
        if tolerance < finest {
            let moved = Size::mm(half_step(self.outline().radius));
            let told = FinerThanAngle { tolerance: Size::mm(tolerance), moved, finest: Size::mm(finest) };
            findings.push(told.at(at([ARC_TOLERANCE.key(), D_BRANCH.key()])));
        }
        // The overcut is counted along the torch's path, which the rise and fall of the curve make longer than the pipe is round.
        let round = self.outline().path_round();
        if self.overcut > round {
            let told = OvercutPastTurn { overcut: Size::mm(self.overcut), round: Size::mm(round) };
            findings.push(told.at(at([OVERCUT.key()])).measuring(self.overcut, Limit::AtMost(round)));
        }
        findings
    }

    /// What is valid alone but not together. All findings are stops.
    #[must_use]
    pub(super) fn contradictions(&self) -> Vec<Finding> {
        let mut findings = solid(self.branch, self.header);
        let (r, e, over) = (Size::mm(self.r), Size::mm(self.e), self.pair().overhang());
        if self.contact == Contact::Envelope && self.is_typed(EXPERT_BRANCH_R.key()) {
            findings.push(RadiusOfEnvelope { r }.at(at([EXPERT_BRANCH_R.key(), CONTACT.key()])));
        } else if self.r > self.R {
            let place = at([EXPERT_BRANCH_R.key(), R.key(), D_BRANCH.key(), D_HEADER.key()]);
            findings.push(BranchLarger { r, R: Size::mm(self.R) }.at(place));
        } else if over > 1e-9 * self.R {
            // Where the wall can stay on the header too, as far as that: the curve alone is not the whole seat.
            let outside = self.R - self.branch.D / 2.0;
            let whole = self.contact != Contact::Outside && outside >= 0.0;
            let most = if whole { outside.min(self.R - self.r) } else { self.R - self.r };
            let (over, most) = (Size::mm(over), Size::mm((most * 1000.0 + 1e-6).floor() / 1000.0));
            let told = BranchOverhangs { over, r, e, R: Size::mm(self.R), most };
            let told = told.at(at([E.key(), D_BRANCH.key(), D_HEADER.key()]));
            findings.push(told.measuring(self.e.abs(), Limit::AtMost(most.value)));
        } else if self.style == Style::Full
            && let Some((least, phi)) = self.outline().tighter_than(self.kerf / 2.0)
        {
            let (kerf, gap) = (Size::mm(self.kerf), Size::mm(2.0 * least));
            findings.push(
                KerfBeyondGap { kerf, phi: Size::degrees(phi.to_degrees(), 1), gap }.at(at([KERF.key(), THETA.key()])),
            );
        }
        if findings.is_empty() && self.style == Style::Full && self.mode == Mode::Rotary {
            findings.extend(self.way_beside_the_curve());
        }
        // Half a kerf w takes ρ asin(w/ρ) along the wall; up to w = ρ/2 that is w to a twentieth.
        let bore = self.branch.D / 2.0 - self.branch.t;
        if self.style == Style::Full && self.mode == Mode::Rotary && bore > 0.0 && self.kerf > bore + 1e-9 {
            let (kerf, bore) = (Size::mm(self.kerf), Size::mm(bore));
            findings.push(KerfBeyondBore { kerf, bore }.at(at([KERF.key(), D_BRANCH.key()])));
        }
        let missing = self.post.control.feed.missing.refused();
        match self.style {
            Style::Full if self.F.is_none() => {
                findings.push(FullStyleNeeds { symbol: F.key() }.at(at([F.key(), STYLE.key()])));
            }
            Style::Annex if self.mode == Mode::Rotary => {
                findings.push(AnnexIsFlat {}.at(at([STYLE.key(), MODE.key()])));
            }
            Style::Annex if missing => {
                let told = AnnexCarriesNoFeed { control: self.post.control.name };
                findings.push(told.at(at([STYLE.key(), DIALECT.key()])));
            }
            _ => {}
        }
        let within = CodesPlace { last: false, tooled: false };
        findings.extend(refused_codes(self.post.control, TORCH_ON.key(), &self.torch_on, within));
        findings.extend(refused_codes(self.post.control, TORCH_OFF.key(), &self.torch_off, within));
        findings.extend(opposed(&[(TORCH_ON.key(), &self.torch_on), (TORCH_OFF.key(), &self.torch_off)]));
        findings.extend(refused_codes(
            self.post.control,
            END_CODES.key(),
            &self.end_codes,
            CodesPlace { last: true, ..within },
        ));
        findings.extend(on_at_end(&self.torch_on, &self.end_codes));
        findings
    }
}
