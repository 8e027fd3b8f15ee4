//! What there is to say of a clear cut: refusals, and remarks for a person.

use crate::finding::{Figures, Finding, Key, Limit, Place, Raise, Said, Size};
use crate::kind::Shown;
use crate::kinds::impeller::clear::asked::ClearCells;
use crate::kinds::impeller::clear::cut::{DoesNotFit, Job, Which};
use crate::kinds::impeller::clear::fields;
use crate::kinds::impeller::clear::largest::{Largest as LargestTool, largest};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::programs::title;
use crate::kinds::impeller::clear::rules::*;
use crate::kinds::impeller::clear::tables::tool_name;
use crate::kinds::impeller::clear::told::{By, Dropped, NoSplitter, PlanResults, ToolTold, Unfinished};
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::parameters::{self as form, NUMBERS};
use crate::kinds::impeller::part::{HUB, RIM};
use crate::limits::CLEAR_BLOCKS;
use crate::number::shown;
use crate::parameter::{FieldKind, at};
use crate::text::{Language, Text, all_of, t};

/// The least that must be left of ε beside the rounding, mm.
const LEFT: f64 = 0.001;
/// What part of the blade's thickness the tolerance may be: both faces may be entered by it.
const THINNED: f64 = 4.0;
/// Below this change of the feed nothing is said.
const UNSAID: f64 = 0.02;

/// A finding with its value and the limit that the value misses.
fn missed(found: Finding, value: impl Said, limit: impl Said, held: fn(f64) -> Limit) -> Finding {
    let [one, most] = [value.datum(), limit.datum()].map(|datum| datum.number());
    let figures = Figures { found: one.map(|value| [value; 2]), limit: most.map(held) };
    found.with(value.said(Language::En), limit.said(Language::En)).comparing(figures)
}

/// What is valid alone but not together.
pub(in crate::kinds::impeller) fn contradictions(design: &Design, asked: &ClearCells) -> Vec<Finding> {
    let mut findings = Vec::new();
    if design.style == Style::Annex {
        findings.push(ClearNeedsFull {}.at(at([fields::METHOD.key(), form::STYLE.key()])));
    }
    let (d_f, T_f, D_f) = asked.given;
    if let Some(d_f) = d_f {
        for (symbol, missing) in [(fields::T_F.key(), T_f.is_none()), (fields::OFFSET_F.key(), D_f.is_none())] {
            if missing {
                findings.push(FinishingToolIncomplete { symbol }.at(at([symbol, fields::D_F.key()])));
            }
        }
        if T_f == Some(design.T) {
            findings.push(OneNumberForTwoTools { T: design.T }.at(at([fields::T_F.key(), form::T.key()])));
        }
        if d_f > design.d_t {
            let (finish, rough) = (Size::mm(d_f), Size::mm(design.d_t));
            let told = FinishingWiderThanRoughing { finish, rough };
            findings.push(missed(told.at(at([fields::D_F.key(), form::D_T.key()])), finish, rough, Limit::AtMost));
        }
    }
    let corners = [
        (fields::CORNER.key(), form::D_T.key(), asked.cut.rough),
        (fields::CORNER_F.key(), fields::D_F.key(), asked.cut.finish),
    ];
    for (symbol, diameter, tool) in corners.into_iter().take(if d_f.is_some() { 2 } else { 1 }) {
        if tool.flat_radius() < 0.0 {
            let (r_c, half) = (Size::mm(tool.r_c), Size::mm(tool.a()));
            let place = at([symbol, diameter]);
            findings.push(missed(CornerBeyondRadius { symbol, r_c, half }.at(place), r_c, half, Limit::AtMost));
        }
    }
    if design.number(Which::Finish) > NUMBERS {
        let (number, most) = (design.program, NUMBERS);
        findings.push(missed(
            NoNumberLeft { number, most }.at(at([form::NUMBER.key()])),
            number,
            most - 1,
            Limit::AtMost,
        ));
    }
    let least = design.machine.rounding(design.torus.R) + LEFT;
    if asked.tolerance < least {
        let least = Size::mm((least * 1000.0).ceil() / 1000.0);
        let tol = Size::length(asked.tolerance, 4);
        findings.push(missed(
            ToleranceBelowResolution { tol, least }.at(at([form::TOL.key()])),
            tol,
            least,
            Limit::AtLeast,
        ));
    }
    if asked.tolerance > design.e / THINNED {
        let (tol, most) = (Size::length(asked.tolerance, 4), Size::length(design.e / THINNED, 4));
        findings.push(missed(
            ToleranceThinsBlade { tol, most }.at(at([form::TOL.key(), form::E.key()])),
            tol,
            most,
            Limit::AtMost,
        ));
    }
    if asked.cut.s >= design.a_p {
        let (s, a_p) = (Size::mm(asked.cut.s), Size::mm(design.a_p));
        findings.push(missed(
            AllowanceUsesUpDepth { s, a_p }.at(at([fields::ALLOWANCE.key(), form::A_P.key()])),
            s,
            a_p,
            Limit::AtMost,
        ));
    }
    findings
}

/// A tool that does not pass.
pub(in crate::kinds::impeller) fn does_not_fit(why: &DoesNotFit) -> Finding {
    // One that the form does not take is none.
    let taken = |d: &f64| matches!(form::D_T.row.kind, FieldKind::Real { min, .. } if *d >= min);
    let passes = why.largest.filter(taken);
    let largest = passes.map_or_else(
        || t("no se ha encontrado ninguna que quepa", "none was found that fits"),
        |d| {
            Text::new(
                format!("la mayor que pasa es de {} mm", shown(d, 2)),
                format!("the largest that passes is {} mm", shown(d, 2)),
            )
        },
    );
    let alone = match why.uncut {
        None => t("sin demasía (s_w = 0) pasaría", "without an allowance (s_w = 0) it would pass"),
        Some(share) => {
            // Its upright lanes alone; along the faces it would reach somewhat more.
            let share = shown((share * 1000.0).ceil() / 10.0, 1);
            Text::new(
                format!("aun sin demasía dejaría sin cortar hasta un {share} % de los canales"),
                format!("even without an allowance it would leave up to {share} % of the channels uncut"),
            )
        }
    };
    let key = match why.tool {
        Which::Rough => form::D_T.key(),
        Which::Finish => fields::D_F.key(),
    };
    let d = Size::mm(why.d);
    let told = ToolDoesNotFit { tool: tool_name(why.tool), d, largest, alone };
    let limit = passes.map(|d| Size::length(d, 2)).map(|passes| passes.said(Language::En).into_owned());
    let told = told.at(at([key, form::N.key(), form::E.key()])).with(d.said(Language::En), limit.unwrap_or_default());
    told.comparing(Figures::of(why.d, passes.map(Limit::AtMost)))
}

/// A program with more blocks than any may have.
pub(in crate::kinds::impeller) fn too_long(program: Text, blocks: u64) -> Option<Finding> {
    let told = TooManyClearBlocks { program, blocks, most: CLEAR_BLOCKS };
    (blocks > CLEAR_BLOCKS).then(|| {
        missed(
            told.at(at([
                form::TOL.key(),
                fields::SCALLOP.key(),
                fields::STEP.key(),
                fields::FEED_CHANGE.key(),
                form::D_T.key(),
                fields::D_F.key(),
                fields::LEVEL.key(),
            ])),
            blocks,
            CLEAR_BLOCKS,
            Limit::AtMost,
        )
    })
}

/// What of the finishing tool stands in the form without its diameter.
fn not_read(asked: &ClearCells) -> Option<Finding> {
    let (d_f, T_f, D_f) = asked.given;
    let cells = [
        (fields::CORNER_F.key(), asked.given_corner.is_some_and(|r_cf| r_cf != asked.cut.rough.r_c)),
        (fields::T_F.key(), T_f.is_some()),
        (fields::OFFSET_F.key(), D_f.is_some()),
    ];
    let filled: Vec<Key> =
        cells.into_iter().filter(|(_, filled)| *filled && d_f.is_none()).map(|(key, _)| key).collect();
    if filled.is_empty() {
        return None;
    }
    let cells = all_of(filled.iter().map(|key| Text::same(key.symbol())));
    let told = FinishingCellsNotRead { cells, r_c: Size::mm(asked.cut.rough.r_c) };
    Some(told.at(Place::Parameters([fields::D_F.key()].into_iter().chain(filled).collect())))
}

/// The tools, and the cells of their stick-outs.
fn stick_outs() -> [(Which, Key); 2] {
    [(Which::Rough, fields::STICK_OUT.key()), (Which::Finish, fields::STICK_OUT_F.key())]
}

/// What stops a plan that was made.
pub(in crate::kinds::impeller) fn stops(design: &Design, asked: &ClearCells, plan: &Plan) -> Vec<Finding> {
    let mut findings = Vec::new();
    if let Some(NoSplitter { largest }) = plan.told.no_splitter {
        let largest = Largest(largest.map(|d| Size::length(d, 2)));
        let d = Size::mm(asked.cut.finish.d);
        let told = NoRoomForClearSplitter { d, s: Size::mm(asked.cut.s), largest };
        let place = at([
            form::SPLITTERS.key(),
            if asked.given.0.is_some() { fields::D_F.key() } else { form::D_T.key() },
            fields::ALLOWANCE.key(),
            form::N.key(),
            form::E.key(),
        ]);
        let limit = largest.0.map(|_| largest.said(Language::En).into_owned()).unwrap_or_default();
        let figures = Figures::of(d.value, largest.0.map(|largest| Limit::AtMost(largest.value)));
        findings.push(told.at(place).with(d.said(Language::En), limit).comparing(figures));
    }
    for (which, key) in stick_outs() {
        let holder = fields::HOLDER.key();
        let cells = if asked.given.0.is_some() {
            vec![key, holder]
        } else {
            stick_outs().into_iter().map(|(_, key)| key).chain([holder]).collect()
        };
        findings.extend(too_long(title(which), plan.all_blocks(which) as u64));
        let Some(stage) = asked.cut.stage(which) else { continue };
        let Some(found) = plan.holder_clearance(&Job::of(design), &asked.cut, which) else { continue };
        if found < 0.0 {
            let (enough, d_s) = (enough(of(plan, which).stick_out), Size::mm(design.d_s));
            let clearance = Size::mm((-found * 1000.0).ceil() / 1000.0);
            let (tool, from, place) = (tool_name(which), Size::mm(stage.from), Place::Parameters(cells));
            findings.push(if found.is_finite() {
                let told = HolderHitsBlank { tool, clearance, enough, d_s }.at(place);
                told.with(format!("-{}", clearance.said(Language::En)), "≥ 0 mm").measuring(found, Limit::AtLeast(0.0))
            } else {
                // Below this a holder of any diameter hits the blank; what is enough keeps d_s away from it.
                let least = at_most(of(plan, which).stick_out - design.d_s);
                missed(StickOutTooShort { tool, from, least, enough, d_s }.at(place), from, least, Limit::AtLeast)
            });
        }
    }
    findings
}

const fn of(plan: &Plan, which: Which) -> &ToolTold {
    plan.told.tool(which)
}

/// A length that is enough: rounded up to a tenth.
fn tenths(stick_out: f64) -> f64 {
    (stick_out * 10.0).ceil() / 10.0
}

/// The same, to be said.
pub(in crate::kinds::impeller) fn enough(stick_out: f64) -> Size {
    Size::length(tenths(stick_out), 1)
}

/// The stick-outs that are enough for any holder, of the tools whose holder the form does not give; for the set-up sheet.
pub(in crate::kinds::impeller) fn enough_stick_outs(asked: &ClearCells, plan: &Plan) -> Vec<(&'static str, Shown)> {
    let open = |which: Which| asked.cut.stage(which).is_none() && plan.of(which).next().is_some();
    let two = asked.given.0.is_some();
    let of = |which: Which| tenths(of(plan, which).stick_out);
    let told = match (open(Which::Rough), open(Which::Finish)) {
        (true, true) if !two => [Some(of(Which::Rough).max(of(Which::Finish))), None],
        (rough, finish) => [rough.then(|| of(Which::Rough)), finish.then(|| of(Which::Finish))],
    };
    let shown = |(key, length): (&'static str, Option<f64>)| length.map(|length| (key, Shown::Length(length)));
    ["l_t", "l_f"].into_iter().zip(told).filter_map(shown).collect()
}

/// A length that is not more, in mm: rounded up to a hundredth.
fn at_most(value: f64) -> Size {
    Size::length((value * 100.0).ceil() / 100.0, 2)
}

/// The same, rounded up to a thousandth.
fn finely(value: f64) -> Size {
    Size::mm((value * 1000.0).ceil() / 1000.0)
}

/// What a person should know of a plan.
pub(in crate::kinds::impeller) fn remarks(job: &Job, asked: &ClearCells, plan: &Plan) -> Vec<Finding> {
    let mut findings = of_tools(asked, plan);
    findings.extend(not_read(asked));
    findings.extend(at_the_root(job, asked, &plan.told));
    findings.extend(cut_partly(&plan.told));
    findings.extend(on_the_floor(asked, &plan.told));
    findings.extend(left_out(&plan.told));
    findings
}

/// Of the tools: their holders, how far they must stick out, and how their feed changes.
fn of_tools(asked: &ClearCells, plan: &Plan) -> Vec<Finding> {
    let mut findings = Vec::new();
    // One tool for both is told of once: its greater stick-out, its greater change.
    let two = asked.given.0.is_some();
    let tools = stick_outs().into_iter().filter(|(which, _)| plan.of(*which).next().is_some());
    let told_of = tools.clone().take(if two { 2 } else { 1 });
    let greatest = |which: Which, value: fn(&ToolTold) -> f64| {
        tools.clone().filter(|(one, _)| !two || *one == which).map(|(one, _)| value(of(plan, one))).fold(0.0, f64::max)
    };
    for (which, key) in told_of {
        if let Some(stage) = asked.cut.stage(which).filter(|stage| stage.radius < asked.cut.tool(which).a()) {
            let (holder, d) = (Size::mm(2.0 * stage.radius), Size::mm(asked.cut.tool(which).d));
            let told = HolderThinnerThanTool { holder, tool: tool_name(which), d };
            findings.push(missed(told.at(at([fields::HOLDER.key(), key])), holder, d, Limit::AtLeast));
        }
        if asked.cut.stage(which).is_none() {
            let enough = enough(greatest(which, |tool| tool.stick_out));
            findings.push(StickOutThatIsEnough { tool: tool_name(which), enough }.at(at([key])));
        }
        let change = greatest(which, |tool| tool.feed_error);
        // What the form admits needs no word.
        if change > asked.cut.feed.unwrap_or(0.0).max(UNSAID) {
            let change = Size::number((change * 1000.0).ceil() / 10.0, 1);
            findings.push(FeedChangesInBlock { tool: tool_name(which), change }.at(at([fields::FEED_CHANGE.key()])));
        }
    }
    findings
}

/// How far it is from the hub to a place, in percent of the way to the rim.
fn share(v: f64) -> Size {
    Size::number(((v - HUB) / (RIM - HUB) * 100.0).clamp(0.0, 100.0), 0)
}

/// Of what is left in the corners and of the faces above them.
fn at_the_root(job: &Job, asked: &ClearCells, told: &PlanResults) -> Vec<Finding> {
    let mut findings = Vec::new();
    // Of a rounded end the radius of its corner counts, too.
    let corners = [(asked.cut.rough, fields::CORNER.key()), (asked.cut.finish, fields::CORNER_F.key())];
    let corner = corners[usize::from(asked.given.0.is_some())];
    let finishing = [fields::D_F.key()].into_iter().chain(Some(corner.1).filter(|_| corner.0.r_c > 0.0));
    let root = &told.root;
    let over = finely(root.over);
    // What goes up to the tops is no corner: it is told of the faces.
    if root.height > 0.0 && told.unfinished.is_none() {
        let (height, here, thick) = (at_most(root.height), share(root.v), at_most(root.thick));
        findings.push(RestAtTheRoot { over, height, here, thick }.at(Place::Parameters(finishing.clone().collect())));
    }
    if root.width > 0.0 {
        let (width, there) = (at_most(root.width), share(root.width_v));
        findings.push(RestBesideTheRoot { over, width, there }.at(Place::Parameters(finishing.clone().collect())));
    }
    let [rounded, flat] = told.rough_foot;
    if rounded - flat > asked.cut.s + asked.tolerance {
        let (left, flat) = (at_most(rounded), at_most(flat));
        findings.push(RoughEndLeaves { left, flat }.at(at([fields::CORNER.key(), fields::ALLOWANCE.key()])));
    }
    if let Some(Unfinished { v, left }) = told.unfinished {
        let (left, share, uncut) = (at_most(left), share(v), percent(told.uncut));
        findings.push(if asked.cut.finish.r_c > 0.0 {
            let place = at([fields::CORNER.key(), fields::CORNER_F.key(), form::A_P.key()]);
            FacesUnfinished { left, share, uncut }.at(place)
        } else {
            EndAboveDepth { left, share, uncut }.at(at([form::D_T.key(), fields::D_F.key(), form::A_P.key()]))
        });
    }
    if let Some(allowed) = asked.root {
        let tool = largest_told(largest(job, &asked.cut, allowed));
        findings.push(
            LargestForTheRoot { height: Size::mm(allowed), tool, left: at_most(root.height) }
                .at(Place::Parameters([fields::ROOT.key()].into_iter().chain(finishing).collect())),
        );
    }
    findings
}

/// What is told of the largest finishing tool for a rest.
fn largest_told(largest: LargestTool) -> Text {
    match largest {
        LargestTool::Tool(d) => {
            let d = shown(d, 2);
            Text::new(
                format!("la mayor fresa frontal es de {d} mm, de 0.05 en 0.05 mm"),
                format!("the largest flat end mill is {d} mm, in steps of 0.05 mm"),
            )
        }
        LargestTool::LeavesMore { d, left } => {
            let (d, left) = (shown(d, 2), at_most(left));
            let (es, en) = (left.said(Language::Es), left.said(Language::En));
            Text::new(
                format!(
                    "no se ha encontrado ninguna que deje tan poco: la menor que se puede usar, de {d} mm, deja hasta {es}"
                ),
                format!(
                    "none is found that leaves as little: the smallest that can be used, {d} mm, leaves up to {en}"
                ),
            )
        }
        LargestTool::NoRoom => t("no se ha encontrado ninguna que quepa", "none is found that has room"),
    }
}

/// A part as a percentage, rounded up.
fn percent(part: f64) -> Size {
    Size::number((part * 1000.0).ceil() / 10.0, 1)
}

/// Of a cut that does not begin at the hub.
fn cut_partly(told: &PlanResults) -> Vec<Finding> {
    let mut findings = Vec::new();
    if told.finish_from > 0.0 {
        let (from, uncut) = (percent(told.finish_from), percent(told.uncut));
        findings.push(CutPartly { from, uncut }.at(at([fields::PARTLY.key(), fields::D_F.key(), form::D_T.key()])));
    }
    if told.rough_from > told.finish_from {
        let from = percent(told.rough_from);
        findings.push(FinishingToolRoughs { from }.at(at([fields::PARTLY.key(), form::D_T.key()])));
    }
    findings
}

/// Of what is left on the floor.
fn on_the_floor(asked: &ClearCells, told: &PlanResults) -> Option<Finding> {
    let (most, beside, share) = (finely(told.floor.most), at_most(told.floor.beside), share(told.floor.v));
    let floor = at([fields::SCALLOP.key(), fields::D_F.key()]);
    if told.floor.most > asked.cut.scallop + asked.tolerance {
        // As the cell has it: it may be less than a thousandth.
        let wanted = Size::length(asked.cut.scallop, 6);
        Some(FloorAboveRidges { most, wanted, beside, share }.at(floor))
    } else {
        (told.floor.most > 0.0).then(|| RidgesOfTheFloor { most, beside, share }.at(floor))
    }
}

/// Of the stretches of passes that are not run.
fn left_out(told: &PlanResults) -> Vec<Finding> {
    let place = || at([form::D_T.key(), fields::D_F.key(), form::SPLITTERS.key()]);
    let passes =
        longest(told, By::Blade).map(|(count, what, [from, to])| PassesLeftOut { count, what, from, to }.at(place()));
    let ends = longest(told, By::Ends)
        .map(|(count, what, [from, to])| StretchesNotReached { count, what, from, to }.at(place()));
    passes.into_iter().chain(ends).collect()
}

/// How many stretches are not run for one cause, what the longest of them would cut, and from where to where it lies.
fn longest(told: &PlanResults, by: By) -> Option<(usize, Text, [Size; 2])> {
    let left: Vec<&Dropped> = told.dropped.iter().filter(|one| one.by == by).collect();
    let longest = left.iter().max_by(|one, two| (one.v[1] - one.v[0]).total_cmp(&(two.v[1] - two.v[0])))?;
    Some((left.len(), longest.cutting.name(), longest.v.map(share)))
}
