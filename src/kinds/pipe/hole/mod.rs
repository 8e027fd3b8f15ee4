//! The bevelled hole in the header, and the height of the torch that cuts it.
//!
//! # References
//! Patent of Shandong University, published 2017: height control of a plasma torch cutting a header hole with a welding
//! groove. Its displayed formulas are lost; the height is derived in [`height`], the curve in [`station`].

pub mod bounds;
pub mod cases;
pub mod cut;
pub mod design;
pub mod figures;
mod form_sketch;
pub mod height;
mod live_form;
mod measures;
pub mod parameters;
pub mod program;
pub mod proof;
pub mod rules;
pub mod station;
pub mod tables;

use crate::figure::Figure;
use crate::finding::{Finding, Grade, Limit, Place, Raise, Rule, Said, Size};
use crate::gcode::control::Control;
use crate::gcode::header::Origin;
use crate::gcode::lines::write_block;
use crate::gcode::program::Program;
use crate::gcode::rules::modes::{CutsBeforeSpindle, CutsWithoutSpeed, NoFeed, SpindleStopped};
use crate::gcode::word::{Distance, NumberFormat};
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Measure, Suggested};
use crate::kind::method::{Method, Unproved};
use crate::kind::{Chapters, Chart, Drawing, Proved, Series, Shown, Wants, out_of_format};
use crate::kinds;
use crate::kinds::pipe::form::{D_HEADER, DIALECT, E, THETA};
use crate::kinds::pipe::hole::bounds::too_high;
use crate::kinds::pipe::hole::cut::{Cut, NoWay, TooHigh, UPRIGHT, cut};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::figures::{figures, template};
use crate::kinds::pipe::hole::parameters::{D_MAX, FORM, G0, GAMMA, H, HOLD_OFF, HOLD_ON, KERF, LEAD_IN, M, Z_S};
use crate::kinds::pipe::hole::program::{distance, full, hold};
use crate::kinds::pipe::hole::proof::Curve;
use crate::kinds::pipe::hole::rules::{
    HeightNotHeld, HoleByIncrements, HoleOnLinearAxes, LandCutApart, TorchLiesDown, TorchSwings, TorchTooHigh,
    TurnsAboutTip,
};
use crate::kinds::pipe::hole::station::Station;
use crate::kinds::pipe::live_form::{BRANCH, HEADER, diameter, thickness};
use crate::kinds::pipe::rates::faster_than_rapid;
use crate::kinds::pipe::rules::{KerfZero, NoLeadIn};
use crate::kinds::pipe::{self, account, derived, scene, sizes, time};
use crate::machine::rapids::Rapids;
use crate::number::grid::OutOfFormat;
use crate::number::root::halved;
use crate::parameter::field::Fields;
use crate::parameter::{Case, FieldKind, Form, at};
use crate::proof::account::Account;
use crate::proof::due::Due;
use crate::proof::step::{Judge, Plan};
use crate::scene::part::Part;
use crate::table::{Quantity, Table, Unit};
use crate::text::{Language, Text, t};

/// Halvings after which the greatest eccentricity is known to a tenth of a millimetre.
const HALVINGS: u8 = 16;

/// The workbook kind `pipe-hole`; it has no values, all of it is in its traits.
#[derive(Debug)]
pub enum Hole {}

/// The cut, and the places of the curve that the tables list.
#[derive(Debug)]
pub struct Model {
    cut: Cut,
    stations: Vec<Station>,
}

impl Method for Hole {
    type Design = Design;
    type Model = Model;
    type Memo = Curve;

    const FORM: &'static Form = &FORM;
    const CASES: &'static [Case] = &cases::CASES;
    const RULES: &'static [&'static [&'static Rule]] =
        &[kinds::rules::RULES, pipe::rules::RULES, rules::RULES, proof::rules::RULES];
    // A torch does not turn, and the feed has its judge.
    const ANSWERED: &'static [&'static Rule] =
        &[NoFeed::RULE, CutsBeforeSpindle::RULE, CutsWithoutSpeed::RULE, SpindleStopped::RULE];
    const CHAPTERS: &'static Chapters = &Chapters {
        labels: include_str!("../../../../report-templates/pipe-hole/labels.typ"),
        method: [
            include_str!("../../../../report-templates/pipe-hole/method-es.typ"),
            include_str!("../../../../report-templates/pipe-hole/method-en.typ"),
        ],
        setup: include_str!("../../../../report-templates/pipe-hole/setup.typ"),
        further: &[("equations.typ", include_str!("../../../../report-templates/pipe-hole/equations.typ"))],
    };
    const PROVED: Text = t(
        "Leída del programa, posición a posición, y comparada con la raíz exacta, el injerto y el tubo",
        "Read back from the program, position by position, and compared with the exact root, the branch and the pipe",
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

    fn model(design: &Design) -> Result<Model, Vec<Finding>> {
        if let Some(place) = too_high(design) {
            return Err(vec![height_refused(design, &place)]);
        }
        match cut(design) {
            Ok(cut) => Ok(Model { cut, stations: tables::stations(design) }),
            Err(NoWay::Format(error)) => Err(no_room(error)),
            Err(NoWay::LiesDown) => {
                let nowhere = TooHigh { alpha: 0.0, sigma_o: None, D: f64::INFINITY };
                Err(vec![height_refused(design, &nowhere)])
            }
            Err(NoWay::Swings { alpha, tilt }) => {
                let degrees = |angle: f64| Size::degrees(angle.to_degrees(), 2);
                let told = TorchSwings {
                    alpha: degrees(alpha),
                    tilt: degrees(tilt),
                    most: degrees(UPRIGHT / 2.0),
                    kerf: Size::mm(design.kerf),
                };
                Err(vec![told.at(at([KERF.key(), M.key(), GAMMA.key()]))])
            }
        }
    }

    fn tables(design: &Design, Model { cut, stations }: &Model) -> Vec<Table> {
        vec![
            tables::curve(stations),
            tables::height(stations),
            tables::pose(stations, design.kerf / 2.0),
            tables::way(cut, design.kerf),
        ]
    }

    fn programs(design: &Design, Model { cut, .. }: &Model, origin: &Origin<'_>) -> Result<Unproved, Vec<Finding>> {
        let held = cut.pierce_held || cut.legs.iter().any(|leg| leg.held);
        let mut findings = remarks(design, held);
        findings.extend(faster_than_rapid(&design.rapids, &cut.runs()));
        Ok(Unproved { programs: vec![full(design, cut, origin).map_err(no_room)?], findings })
    }

    fn memo(_: &Design, _: &Model, _: Wants) -> Curve {
        Curve::new()
    }

    fn fewer(_: &Design, _: &Program) -> Text {
        t("una arc_tolerance mayor", "a larger arc_tolerance")
    }

    fn plan<'a>(design: &'a Design, model: &'a Model, _: &'a Program) -> Plan<'a> {
        proof::plan(design, &model.cut)
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
        proof::judges(design, &model.cut, curve)
    }

    fn due(design: &Design, _: &Program) -> Vec<Due> {
        proof::due(design)
    }

    fn quantities(design: &Design, model: &Model, programs: &[Proved]) -> Vec<Quantity> {
        quantities(design, &model.stations, &account(programs))
    }

    fn part(design: &Design, _: &Model) -> Option<Part> {
        Some(scene::hole(design))
    }

    fn setup(design: &Design, _: &Model) -> Vec<(&'static str, Shown)> {
        let codes = |on| {
            let mut block = String::new();
            write_block(design.post.control, &mut hold(design, on)?, NumberFormat::Fixed, &mut block);
            Some(Shown::Words(block))
        };
        let holds = [("hold-on", codes(true)), ("hold-off", codes(false))];
        let holds = holds.into_iter().filter_map(|(key, codes)| Some((key, codes?)));
        let kerf = ("kerf", Shown::Length(design.kerf));
        sizes(design.branch, design.header).into_iter().chain([kerf]).chain(holds).collect()
    }

    fn charts(_: &Design, _: &Model) -> Vec<Chart> {
        let series = |name, y| Series { name, x: ("height", "α"), y: ("height", y) };
        vec![
            Chart {
                table: "height",
                title: t("Ángulo de la antorcha", "Angle of the torch"),
                axes: [t("α (°)", "α (°)"), t("ángulo (°)", "angle (°)")],
                equal: false,
                when: None,
                series: vec![series(Text::same("σ"), "σ"), series(Text::same("σ_o"), "σ_o")],
            },
            Chart {
                table: "height",
                title: t("Altura y distancia", "Height and distance"),
                axes: [t("α (°)", "α (°)"), t("mm", "mm")],
                equal: false,
                when: None,
                series: vec![series(Text::same("D"), "D"), series(Text::same("g"), "g")],
            },
        ]
    }

    fn drawings(design: &Design, _: &Model) -> Vec<Drawing> {
        vec![Drawing {
            key: "template",
            title: t("Plantilla del agujero", "Template of the hole"),
            figure: template(design),
            arcs: Vec::new(),
            paper: Some(design.paper),
        }]
    }

    fn figures(design: &Design, _: &Model, curve: &Curve) -> Vec<Figure> {
        let mut along = curve.clone();
        along.sort_by(|one, other| one[0].total_cmp(&other[0]));
        figures(design, &along)
    }
}

/// The refusal of a position that no program may carry.
fn no_room(error: OutOfFormat) -> Vec<Finding> {
    vec![out_of_format(error, [D_HEADER.key(), Z_S.key()])]
}

/// The refusal of a place where the torch would have to be too high.
fn height_refused(design: &Design, place: &TooHigh) -> Finding {
    let alpha = Size::degrees(place.alpha.to_degrees(), 2);
    let joint = other_joint(design);
    let eccentric = (design.e != 0.0).then_some(E.key());
    match place.sigma_o {
        Some(sigma) => {
            let (height, most) = (Size::mm(height_taken(design, place)), Size::length(design.D_max, 6));
            let joint = listed(&joint);
            let told = TorchTooHigh { alpha, sigma: Size::degrees(sigma.to_degrees(), 2), height, most, joint };
            let keys = [GAMMA.key()].into_iter().chain(eccentric).chain([D_MAX.key(), G0.key()]);
            let told = told.at(Place::Parameters(keys.collect()));
            let told = told.with(height.said(Language::En), most.said(Language::En));
            told.measuring(height.value, Limit::AtMost(design.D_max))
        }
        None => {
            let leaning = (design.theta != 90.0).then_some(THETA.key());
            let keys = [GAMMA.key()].into_iter().chain(eccentric).chain(leaning);
            TorchLiesDown { alpha, joint: listed(&joint) }.at(Place::Parameters(keys.collect()))
        }
    }
}

/// Values one behind the other, before what else may be chosen.
fn listed(values: &[Text]) -> Text {
    let list = |language: Language| values.iter().fold(String::new(), |list, value| list + value.get(language) + ", ");
    Text::new(list(Language::Es), list(Language::En))
}

/// The height that the torch needs, rounded up until it is taken as D_max.
fn height_taken(design: &Design, place: &TooHigh) -> f64 {
    let least = (place.D * 1000.0 - 1e-6).ceil();
    let heights = (0..10_u8).map(|step| (least + f64::from(step)) / 1000.0);
    heights.clone().find(|&D_max| too_high(&Design { D_max, ..design.clone() }).is_none()).unwrap_or(least / 1000.0)
}

/// The groove angle next to the given one, in whole degrees, at which the torch goes round the hole, and the eccentricity up to
/// which it does, where there are such. On the side of an eccentric branch the pipes meet at more than 90°, and a larger groove
/// angle raises the torch there.
fn other_joint(design: &Design) -> Vec<Text> {
    let goes = |design: &Design| too_high(design).is_none() && cut(design).is_ok();
    let FieldKind::Real { min, max } = GAMMA.row.kind else { return Vec::new() };
    let near = |step: u8| [f64::from(step), -f64::from(step)].map(|by| (design.gamma + by).round());
    let mut angles = (1..=80).flat_map(near).filter(|gamma| (min..=max).contains(gamma) && *gamma != design.gamma);
    let gamma = angles.find(|&gamma| goes(&Design { gamma, ..design.clone() }));
    let with = |e: f64| goes(&Design { e: e.copysign(design.e), ..design.clone() });
    let e = (design.e != 0.0 && with(0.0)).then(|| {
        let good = halved([0.0, design.e.abs()], HALVINGS, with);
        (good * 10.0).floor() / 10.0
    });
    let e = e.filter(|&e| with(e)).map(|e| Size::mm(if e == 0.0 { 0.0 } else { e.copysign(design.e) }));
    let said = |symbol: &str, size: Size| {
        let [es, en] = [Language::Es, Language::En].map(|language| format!("{symbol} = {}", size.said(language)));
        Text::new(es, en)
    };
    let gamma = gamma.map(|gamma| said("γ", Size::degrees(gamma, 0)));
    gamma.into_iter().chain(e.map(|e| said("e", e))).collect()
}

/// Derived lengths, angles and times.
fn quantities(design: &Design, stations: &[Station], account: &Account) -> Vec<Quantity> {
    let mm = Unit::Millimetre;
    let most = |of: fn(&Station) -> f64| stations.iter().map(of).fold(f64::MIN, f64::max);
    let least = |of: fn(&Station) -> f64| stations.iter().map(of).fold(f64::MAX, f64::min);
    let torch = design.torch();
    let mut list = vec![
        derived("R_o", t("Radio exterior del tubo", "Outside radius of the header"), design.R_o(), mm, t("", ""))
            .by("derived_R_o", format!("{}/2", diameter(&HEADER, design.header.D))),
        derived("R_i", t("Radio interior del tubo", "Inside radius of the header"), design.R_i(), mm, t("", "")).by(
            "derived_R_i",
            format!(
                "{}/2-{}",
                diameter(&HEADER, design.header.D),
                thickness(&HEADER, [design.header.D, design.header.t])
            ),
        ),
        derived(
            "r",
            t("Radio del injerto con su holgura", "Radius of the branch with its gap"),
            design.pair().r,
            mm,
            t("D_branch/2 + b", "D_branch/2 + b"),
        )
        .by("derived_hole_r", format!("{}/2+root_gap_b", diameter(&BRANCH, design.branch.D))),
        derived(
            "h_s",
            t("De la punta al hombro de la antorcha", "From the torch's tip to its shoulder"),
            torch.shoulder(),
            mm,
            t("(R_g − r_g)/tan Ψ", "(R_g − r_g)/tan Ψ"),
        )
        .by("derived_h_s", "(torch_body_radius-nozzle_r_g)/TAN(RADIANS(taper_Psi))"),
        derived(
            "sigma_0",
            t("Ángulo por debajo del cual manda la punta", "Angle below which the tip sets the height"),
            torch.switch_angle().to_degrees(),
            Unit::Degree,
            t("asen(g0/√(d0² + r_g²)) + atan(r_g/d0)", "asin(g0/√(d0² + r_g²)) + atan(r_g/d0)"),
        )
        .by("derived_sigma_0", "DEGREES(ASIN(least_gap_g0/SQRT(height_d0^2+nozzle_r_g^2))+ATAN(nozzle_r_g/height_d0))"),
        derived(
            "sigma_min",
            t("σ mínimo de la tabla", "Minimum σ of the table"),
            least(|one| one.sigma).to_degrees(),
            Unit::Degree,
            t("", ""),
        ),
        derived(
            "D_most",
            t("Altura D máxima de la tabla", "Maximum height D of the table"),
            most(|one| one.D),
            mm,
            t("", ""),
        ),
    ];
    list.extend(time(account));
    list
}

/// What a person should know of the design and its program.
fn remarks(design: &Design, held: bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    if held && hold(design, true).is_none() {
        findings.push(HeightNotHeld {}.at(at([HOLD_ON.key(), HOLD_OFF.key(), DIALECT.key()])));
    }
    if design.lead_in == 0.0 {
        findings.push(NoLeadIn {}.at(at([LEAD_IN.key()])));
    }
    if design.kerf == 0.0 {
        findings.push(KerfZero {}.at(at([KERF.key(), M.key()])));
    }
    // Without a groove the whole edge is cut upright at once.
    if design.h > 0.0 && design.gamma > 0.0 {
        findings.push(LandCutApart {}.at(at([H.key()])));
    }
    findings.push(match distance(design) {
        Distance::Incremental => HoleByIncrements {}.at(at([DIALECT.key()])),
        Distance::Absolute => HoleOnLinearAxes {}.at(at([DIALECT.key()])),
    });
    findings.push(TurnsAboutTip {}.at(at([DIALECT.key()])));
    // A jet is wider than what a corner is rounded by.
    findings.extend(kinds::rules::corners_between_blocks(design.post.control).map(|one| one.graded(Grade::Note)));
    findings
}
