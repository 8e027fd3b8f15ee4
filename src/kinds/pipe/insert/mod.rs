//! The branch pipe cut to fit a header at any angle, concentric or eccentric.
//!
//! The template is equation 9 of the published source (see [`crate::geometry::pipe_pair`]) on a development of a chosen
//! radius; the cut runs half the kerf beside it on the side of the waste, as arcs through triples on a flat sheet or as
//! short straight moves on the turning pipe.
//!
//! # Which side
//! The template is wrapped round the branch with its printed face outwards, its y towards the header. For someone who sees
//! the branch lean to the right (θ < 90°), an e > 0 has the branch's axis pass in front of the header's. On the turning pipe
//! A counts how the torch goes round it by the right hand about +X, as ISO 841 has it, and X grows towards the header: that
//! is the same side.
//!
//! # References
//! Martínez, Ledesma, Vega: "Creación de códigos G para las trayectorias de corte de tuberías con plasma", Universidad de
//! Guanajuato; equations 1 to 19, tables 1 and 2, figure 15. Slips of the source are named where they matter.

pub mod arcs;
pub mod bounds;
pub mod cases;
pub mod contradictions;
pub mod cut;
pub mod design;
pub mod figures;
mod form_sketch;
mod lead_in;
mod live_form;
mod measures;
pub mod outline;
pub mod parameters;
pub mod program;
pub mod proof;
mod quantities;
pub mod rules;
pub mod tables;

use std::f64::consts::TAU;

use crate::figure::Figure;
use crate::finding::{Finding, Grade, Raise, Rule, Said, Size};
use crate::gcode::control::Control;
use crate::gcode::header::Origin;
use crate::gcode::interpreter::Setting;
use crate::gcode::program::{Program, Style};
use crate::gcode::rules::modes::{CutsBeforeSpindle, CutsWithoutSpeed, NoFeed, SpindleStopped};
use crate::gcode::rules::words::DecimalsTooMany;
use crate::gcode::word::Distance;
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Measure, Suggested};
use crate::kind::method::{Method, Unproved};
use crate::kind::{Chapters, Chart, Drawing, Proved, Series, Shown, Wants, out_of_format};
use crate::kinds;
use crate::kinds::pipe::dimensions::or_eccentricity;
use crate::kinds::pipe::form::{D_BRANCH, D_HEADER, DIALECT, E, THETA, TORCH_ON};
use crate::kinds::pipe::insert::bounds::{Rest, Worst};
use crate::kinds::pipe::insert::cut::{Cut, cut};
use crate::kinds::pipe::insert::design::{Contact, Design, Mode, Typed};
use crate::kinds::pipe::insert::figures::{figures, template};
use crate::kinds::pipe::insert::parameters::{
    CONTACT, EXPERT_BRANCH_R, F, FORM, KERF, LEAD_IN, MODE, R_DEV, SHEET, STYLE, Surface, Z,
};
use crate::kinds::pipe::insert::program::{beyond_f_word, distance, full, published, runs};
use crate::kinds::pipe::insert::proof::{Curve, Moves};
use crate::kinds::pipe::insert::quantities::quantities;
use crate::kinds::pipe::insert::rules::{
    AnnexAsPublished, AnnexWithoutKerf, CurveBehindEdge, CurveFarBehindEdge, DecimalsAsPublished, GapsOfEnvelope,
    KerfOnOutside, OutsideForInside, PipeByIncrements, PipeOnLinearAxis, RadiusTyped, TemplateNotRound,
    WallInsideHeader, WallOverhangs,
};
use crate::kinds::pipe::rates::faster_than_rapid;
use crate::kinds::pipe::rules::{KerfZero, NoLeadIn};
use crate::kinds::pipe::{self, account, scene, sizes};
use crate::machine::rapids::Rapids;
use crate::number::grid::OutOfFormat;
use crate::number::shown;
use crate::parameter::field::Fields;
use crate::parameter::{Case, FieldKind, Form, at};
use crate::proof::due::Due;
use crate::proof::step::{Judge, Plan};
use crate::scene::part::Part;
use crate::table::{Quantity, Table};
use crate::text::{Language, Text, t};

/// The workbook kind `pipe-insert`; it has no values, all of it is in its traits.
#[derive(Debug)]
pub enum Insert {}

/// The cut, and its moves as they are planned.
#[derive(Debug)]
pub struct Model {
    /// The cut beside the curve; `None` in the published style, which follows the curve itself.
    cut: Option<Cut>,
    moves: Moves,
    /// How the wall stands to the header.
    rest: Rest,
}

/// The decimals of the published program's dimensions.
const PUBLISHED_DECIMALS: usize = 6;

impl Method for Insert {
    type Design = Design;
    type Model = Model;
    type Memo = Curve;

    const FORM: &'static Form = &FORM;
    const CASES: &'static [Case] = &cases::CASES;
    const RULES: &'static [&'static [&'static Rule]] =
        &[kinds::rules::RULES, pipe::rules::RULES, rules::RULES, proof::rules::RULES];
    // A torch does not turn, and the published program has no feed; of its six decimals a caution of its own speaks.
    const ANSWERED: &'static [&'static Rule] =
        &[NoFeed::RULE, CutsBeforeSpindle::RULE, CutsWithoutSpeed::RULE, SpindleStopped::RULE, DecimalsTooMany::RULE];
    const CHAPTERS: &'static Chapters = &Chapters {
        labels: include_str!("../../../../report-templates/pipe-insert/labels.typ"),
        method: [
            include_str!("../../../../report-templates/pipe-insert/method-es.typ"),
            include_str!("../../../../report-templates/pipe-insert/method-en.typ"),
        ],
        setup: include_str!("../../../../report-templates/pipe-insert/setup.typ"),
        further: &[("equations.typ", include_str!("../../../../report-templates/pipe-insert/equations.typ"))],
    };
    const PROVED: Text = t(
        "Leída del programa, movimiento a movimiento, y comparada con la curva exacta y los dos tubos",
        "Read back from the program, motion by motion, and compared with the exact curve and both pipes",
    );
    const MEASURES: &'static [Measure] = measures::MEASURES;
    const SUGGESTED: &'static Suggested = &measures::SUGGESTED;

    fn sketch() -> Option<Figure> {
        Some(form_sketch::sketch())
    }

    fn live() -> Option<LiveForm> {
        Some(live_form::live())
    }

    fn design(fields: &Fields) -> Result<Design, Vec<Finding>> {
        Design::new(fields)
    }

    fn control(design: &Design) -> &'static Control {
        design.post.control
    }

    fn style(design: &Design) -> Option<Style> {
        Some(design.style)
    }

    fn model(design: &Design) -> Result<Model, Vec<Finding>> {
        let cut = match design.style {
            Style::Annex => None,
            Style::Full => {
                let cut = cut(design).map_err(no_room)?;
                if let Some(told) = beyond_f_word(design, &cut) {
                    return Err(vec![told]);
                }
                Some(cut)
            }
        };
        Ok(Model { moves: Moves::new(design, cut.as_ref()), cut, rest: design.template().rest() })
    }

    fn tables(design: &Design, Model { cut, .. }: &Model) -> Vec<Table> {
        let way = cut.as_ref().map(|cut| tables::way(design, cut));
        [tables::template(design), tables::seat(design), tables::arcs(design)].into_iter().chain(way).collect()
    }

    fn programs(
        design: &Design,
        Model { cut, rest, .. }: &Model,
        origin: &Origin<'_>,
    ) -> Result<Unproved, Vec<Finding>> {
        let program = match cut {
            None => published(design),
            Some(cut) => full(design, cut, origin),
        };
        let mut findings = remarks(design, rest);
        if let (Some(cut), Some(speed)) = (cut, design.F) {
            findings.extend(faster_than_rapid(&design.rapids, &runs(design, cut, speed)));
        }
        Ok(Unproved { programs: vec![program.map_err(no_room)?], findings })
    }

    fn memo(_: &Design, _: &Model, _: Wants) -> Curve {
        Curve::new()
    }

    fn fewer(design: &Design, _: &Program) -> Text {
        match design.mode {
            Mode::Flat => t("un N menor", "a smaller N"),
            Mode::Rotary => t("una arc_tolerance mayor", "a larger arc_tolerance"),
        }
    }

    fn setting(design: &Design, program: &Program) -> Setting {
        proof::setting(design, program)
    }

    fn plan<'a>(design: &'a Design, model: &'a Model, _: &'a Program) -> Plan<'a> {
        model.moves.plan(design.mode)
    }

    fn rapids(design: &Design, _: &Program) -> Rapids {
        design.rapids
    }

    fn judges<'a>(
        design: &'a Design,
        model: &'a Model,
        curve: &'a mut Curve,
        _: &'a Program,
    ) -> Vec<Box<dyn Judge + 'a>> {
        proof::judges(design, &model.moves, curve)
    }

    fn due(design: &Design, _: &Program) -> Vec<Due> {
        proof::due(design)
    }

    fn quantities(design: &Design, model: &Model, programs: &[Proved]) -> Vec<Quantity> {
        quantities(design, &model.rest, &account(programs))
    }

    fn part(design: &Design, _: &Model) -> Option<Part> {
        Some(scene::insert(design))
    }

    fn setup(design: &Design, _: &Model) -> Vec<(&'static str, Shown)> {
        sizes(design.branch, design.header)
    }

    fn charts(_: &Design, _: &Model) -> Vec<Chart> {
        vec![Chart {
            table: "template",
            title: t("Plantilla", "Template"),
            axes: [t("x (mm)", "x (mm)"), t("y (mm)", "y (mm)")],
            equal: false,
            when: None,
            series: vec![Series { name: t("curva", "curve"), x: ("template", "x"), y: ("template", "y") }],
        }]
    }

    fn drawings(design: &Design, _: &Model) -> Vec<Drawing> {
        vec![Drawing {
            key: "template",
            title: t("Plantilla del injerto", "Template of the branch"),
            figure: template(design),
            arcs: Vec::new(),
            paper: Some(design.paper),
        }]
    }

    fn figures(design: &Design, Model { cut, .. }: &Model, curve: &Curve) -> Vec<Figure> {
        figures(design, cut.as_ref(), curve)
    }
}

/// The refusal of a position that no program may carry.
fn no_room(error: OutOfFormat) -> Vec<Finding> {
    vec![out_of_format(error, [D_BRANCH.key(), D_HEADER.key(), Z.key()])]
}

/// Whether a choice is the envelope, in the words of either language.
fn enveloped(choice: &str) -> String {
    format!("TRIM({choice})=\"envelope\",TRIM({choice})=\"envolvente\"")
}

/// A bound rounded up to 0.001 mm.
fn rounded_up(most: f64) -> f64 {
    (most.max(0.0) * 1000.0).ceil() / 1000.0
}

/// Below this the wall stands neither inside nor off the header: the grid of the program, mm.
const SEATED: f64 = 1e-3;

/// Where a bound is reached.
fn place(worst: &Worst) -> Text {
    if worst.most <= SEATED {
        return t("", "");
    }
    let phi = shown(worst.phi.to_degrees(), 1);
    Text::new(format!("en φ = {phi}°"), format!("at φ = {phi}°"))
}

/// The gap of an edge: how wide and where, or that it is closed.
fn gap_of(worst: &Worst) -> Text {
    let (width, place) = (Size::mm(rounded_up(worst.most)), place(worst));
    if place.en.is_empty() {
        return t("cerrado", "closed");
    }
    let said = |language: Language| format!("{} {}", width.said(language), place.get(language));
    Text::new(said(Language::Es), said(Language::En))
}

/// How the branch comes to rest; `overhangs` where its wall passes the side of the header.
fn seat(design: &Design, rest: &Rest, overhangs: bool) -> Option<Finding> {
    let phi = |worst: &Worst| Size::degrees(worst.phi.to_degrees(), 1);
    let contact = match design.contact {
        Contact::Envelope => {
            let [inner, outer] = rest.gaps.map(|gap| gap_of(&gap));
            let back = rounded_up(design.cut_back());
            let taken = Size::mm(back);
            let kerf = Text::new(
                format!("; el ancho de corte quita hasta {} más al interior", taken.said(Language::Es)),
                format!("; the kerf takes up to {} more off the inner edge", taken.said(Language::En)),
            );
            // In a plane the torch cuts square to the curve, and takes no more.
            let kerf = if back > 0.0 { kerf } else { t("", "") };
            let beside =
                if overhangs { t(" donde apoya en el tubo base", " where it rests on the header") } else { t("", "") };
            return Some(GapsOfEnvelope { beside, inner, outer, kerf }.at(at([CONTACT.key()])));
        }
        Contact::Inside => t("interior", "inside"),
        Contact::Outside => t("exterior", "outside"),
    };
    let [bore, outside] = design.wall().ends();
    let edge = if rest.rho <= bore + 1e-9 {
        t("el borde interior", "the inner edge")
    } else if rest.rho >= outside - 1e-9 {
        t("el borde exterior", "the outer edge")
    } else {
        t("el centro", "the middle")
    };
    let (deep, grind) = (Size::mm(rounded_up(rest.inside.most)), Size::mm(rounded_up(rest.grind.most)));
    let caution = WallInsideHeader { contact, edge, deep, phi: phi(&rest.inside), grind };
    (rest.inside.most > SEATED).then(|| caution.at(at([CONTACT.key(), THETA.key(), E.key()])))
}

/// The wall of a branch whose bore meets the header but whose outside passes its side. A branch of the header's own size ends at it.
fn wall_beside_header(design: &Design) -> Option<Finding> {
    let outside = design.branch.D / 2.0;
    let over = outside + design.e.abs() - design.R;
    let within = design.R - outside;
    let most = or_eccentricity((within >= 0.0).then(|| Size::mm((within * 1000.0 + 1e-6).floor() / 1000.0)));
    let [over_mm, r_o, e, R] = [over, outside, design.e, design.R].map(Size::mm);
    let told = WallOverhangs { over: over_mm, r_o, e, R, most };
    // The outside of a branch that rests on it is the curve's own.
    let beside = design.contact != Contact::Outside && over > SEATED / 2.0;
    beside.then(|| told.at(at([D_BRANCH.key(), D_HEADER.key(), E.key(), CONTACT.key()])))
}

/// A template for wrapping round the pipe that is not as long as it is round.
fn template_not_round(design: &Design) -> Option<Finding> {
    let round = TAU * design.branch.D / 2.0;
    let W = design.template().round();
    let sheet = match design.sheet {
        Surface::Outside => t("exterior", "outside"),
        Surface::Mean => t("media", "mean"),
        Surface::Inside => t("interior", "inside"),
    };
    let told = TemplateNotRound { sheet, W: Size::mm(W), round: Size::mm(round) };
    // A development whose radius was typed is told as such.
    let differs = design.mode == Mode::Rotary && !design.is_typed(R_DEV.key()) && (W - round).abs() > SEATED;
    differs.then(|| told.at(at([SHEET.key(), MODE.key()])))
}

/// What a person should know of the design and its program.
fn remarks(design: &Design, rest: &Rest) -> Vec<Finding> {
    let mut findings = Vec::new();
    let outside = design.branch.D / 2.0;
    let for_inside = design.is_typed(EXPERT_BRANCH_R.key())
        && design.contact == Contact::Inside
        && (design.r - outside).abs() < 1e-9;
    if for_inside {
        let (r, D, off) = (Size::mm(design.r), Size::mm(design.branch.D), Size::mm(design.r_dev - outside));
        // A development of the pipe's own outside fits round it: then only the curve is another.
        let off = match off.value.abs() < 5e-4 {
            true => t("", ""),
            false => Text::new(
                format!("; el desarrollo queda {} fuera del tubo", off.said(Language::Es)),
                format!("; the development is {} outside the pipe", off.said(Language::En)),
            ),
        };
        findings.push(OutsideForInside { r, D, off }.at(at([EXPERT_BRANCH_R.key(), D_BRANCH.key(), R_DEV.key()])));
    }
    // With the outside radius typed for the inside one, the development is told there.
    let covered = |one: &Typed| for_inside && (one.key == EXPERT_BRANCH_R.key() || one.key == R_DEV.key());
    let others = design.typed.iter().filter(|one| (one.typed - one.derived).abs() > 1e-9 && !covered(one));
    findings.extend(others.map(|one| {
        let (typed, derived) = (Size::mm(one.typed), Size::mm(one.derived));
        RadiusTyped { key: one.key, typed, derived }.at(at([one.key]))
    }));
    let beside = wall_beside_header(design);
    // Rolled to another radius than that of the pipe, a development does not seat as it was computed.
    let rolls = !design.typed.iter().any(|one| one.key == R_DEV.key() && (one.typed - one.derived).abs() > 1e-9);
    findings.extend(seat(design, rest, beside.is_some()).filter(|one| rolls || one.grade != Grade::Note));
    findings.extend(beside);
    findings.extend(template_not_round(design));
    // A jet is wider than what a corner is rounded by.
    findings.extend(kinds::rules::corners_between_blocks(design.post.control).map(|one| one.graded(Grade::Note)));
    let below = -design.template().extent()[0];
    if below > SEATED / 2.0 {
        let least = ((design.Z + below) * 1000.0 - 1e-6).ceil() / 1000.0;
        let (below, place) = (Size::mm(below), at([Z.key(), THETA.key()]));
        let beyond = matches!(Z.row.kind, FieldKind::Real { max, .. } if least > max);
        findings.push(match beyond {
            true => CurveFarBehindEdge { below }.at(place),
            false => CurveBehindEdge { below, least: Size::mm(least) }.at(place),
        });
    }
    match design.style {
        Style::Annex => {
            findings.push(AnnexAsPublished {}.at(at([STYLE.key(), F.key(), TORCH_ON.key()])));
            if design.kerf > 0.0 {
                findings.push(AnnexWithoutKerf {}.at(at([KERF.key(), STYLE.key()])));
            }
            let most = design.post.control.lexis.decimals.most(false, false).filter(|most| *most < PUBLISHED_DECIMALS);
            findings.extend(most.map(|most| DecimalsAsPublished { most }.at(at([STYLE.key(), DIALECT.key()]))));
        }
        Style::Full if design.kerf == 0.0 => findings.push(KerfZero {}.at(at([KERF.key()]))),
        Style::Full => {}
    }
    if design.style == Style::Full && design.lead_in == 0.0 {
        findings.push(NoLeadIn {}.at(at([LEAD_IN.key()])));
    }
    if design.mode == Mode::Rotary {
        if design.kerf > 0.0 {
            findings.push(KerfOnOutside { outside: Size::mm(outside) }.at(at([MODE.key()])));
        }
        findings.push(match distance(design) {
            Distance::Incremental => PipeByIncrements {}.at(at([DIALECT.key()])),
            Distance::Absolute => PipeOnLinearAxis {}.at(at([DIALECT.key()])),
        });
    }
    findings
}
