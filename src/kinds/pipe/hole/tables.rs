//! The tables of a hole: the curve, the torch's height, its pose and its axes.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::kinds::pipe::hole::cut::{Cut, machine_axes};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::height::Rule;
use crate::kinds::pipe::hole::program::{AXES, follows};
use crate::kinds::pipe::hole::station::Station;
use crate::kinds::pipe::way_title;
use crate::machine::torch::TorchAxes;
use crate::table::{Column, Index, Law, Print, Table, Unit};
use crate::text::{Text, t};

const MM: Unit = Unit::Millimetre;
const DEGREE: Unit = Unit::Degree;

/// The places of the tables: N, once round; those where the torch's axis does not leave the header are left out.
#[must_use]
pub fn stations(design: &Design) -> Vec<Station> {
    let groove = design.groove();
    (0..=design.N).filter_map(|j| groove.at(TAU * f64::from(j) / f64::from(design.N))).collect()
}

fn numbers(symbol: &'static str, unit: Unit, law: Law, values: impl Iterator<Item = f64>) -> Column {
    Column::numbers(symbol, unit, law, values.collect::<Vec<_>>())
}

fn rule(rule: Rule) -> Text {
    match rule {
        Rule::Wanted => t("d0", "d0"),
        Rule::Tip => t("punta", "tip"),
        Rule::Shoulder => t("hombro", "shoulder"),
    }
}

/// Three columns of vectors, each with its formula.
fn vectors(
    stations: &[Station],
    of: fn(&Station) -> Vector3<f64>,
    symbols: [&'static str; 3],
    (unit, law): (Unit, Law),
    formulas: [String; 3],
) -> impl Iterator<Item = Column> {
    let values: std::sync::Arc<[Vector3<f64>]> = stations.iter().map(of).collect();
    Column::vectors(symbols, unit, law, &values).into_iter().zip(formulas).map(|(column, formula)| column.by(formula))
}

/// N + 1 rows: the last one comes round to the first again.
const ROWS: Index = Index::Intervals { name: "divisions_N", times: 1, more: 0 };
/// α, θ and φ − γ in radians, as formulas of a row.
const ALPHA: &str = "RADIANS([curve.α])";
const THETA: &str = "RADIANS(angle_theta)";
const LEAN: &str = "RADIANS([curve.φ]-groove_gamma)";

/// In a formula: o, out of the branch.
fn out() -> [String; 3] {
    [format!("COS({ALPHA})*SIN({THETA})"), format!("SIN({ALPHA})"), format!("(-COS({ALPHA})*COS({THETA}))")]
}

/// In a formula: n, out of the header, and m, away from the hole: (o + n cos φ)/sin φ.
fn frame() -> [[String; 3]; 2] {
    let normal = ["0", "[curve.y]/(derived_R_i+land_h)", "[curve.z]/(derived_R_i+land_h)"].map(str::to_owned);
    let phi = "RADIANS([curve.φ])";
    let mut away = out();
    for (one, n) in away.iter_mut().zip(&normal) {
        *one = format!("(({one}+{n}*COS({phi}))/SIN({phi}))");
    }
    [normal, away]
}

/// The curve with the angle between the pipes.
#[must_use]
pub fn curve(stations: &[Station]) -> Table {
    let mut columns = vec![
        numbers("α", DEGREE, Law::Told("α = 360·j/N"), stations.iter().map(|one| one.alpha.to_degrees()))
            .by("360*[i]/divisions_N"),
    ];
    let root = [
        format!("([z]+derived_hole_r*COS({ALPHA})*COS({THETA}))/TAN({THETA})+derived_hole_r*COS({ALPHA})*SIN({THETA})"),
        format!("derived_hole_r*SIN({ALPHA})-eccentricity_e"),
        "SQRT((derived_R_i+land_h-[y])*(derived_R_i+land_h+[y]))".to_owned(),
    ];
    let law = Law::Told("(r_b + b) ∩ (R_i + h)");
    columns.extend(vectors(stations, |one| one.root, ["x", "y", "z"], (MM, law), root));
    let [_, out_y, out_z] = out();
    columns.push(
        numbers("φ", DEGREE, Law::Told("φ = π − ∠(n_b, n_h)"), stations.iter().map(|one| one.phi.to_degrees()))
            .by(format!("180-DEGREES(ACOS(([y]*{out_y}+[z]*{out_z})/(derived_R_i+land_h)))")),
    );
    // The beam runs half a kerf beside the root, into the waste: n cos(φ − γ) − m sin(φ − γ).
    let [normal, away] = frame();
    let kerf = "IF(ISNUMBER(kerf),kerf,2*beam_m)";
    let beam = [0, 1, 2].map(|axis| {
        let (n, m, root) = (&normal[axis], &away[axis], ["[x]", "[y]", "[z]"][axis]);
        format!("({root}+({n}*COS({LEAN})-{m}*SIN({LEAN}))*{kerf}/2)")
    });
    let [_, y, z] = &beam;
    let (a, b) = ("([pose.a_y]^2+[pose.a_z]^2)", format!("({y}*[pose.a_y]+{z}*[pose.a_z])"));
    let along = format!("(SQRT({b}^2-{a}*({y}^2+{z}^2-derived_R_o^2))-{b})/{a}");
    let face = [0, 1, 2].map(|axis| format!("{}+{along}*[pose.{}]", beam[axis], ["a_x", "a_y", "a_z"][axis]));
    let law = Law::Told("Q = P + s·a, |Q| = R_o");
    columns.extend(vectors(stations, |one| one.face, ["x_o", "y_o", "z_o"], (MM, law), face));
    Table {
        key: "curve",
        name: t("Curva", "Curve"),
        title: t(
            "Curva de la raíz, y por dónde sale el eje del chorro en el exterior",
            "Root curve, and where the axis of the beam comes out on the outside",
        ),
        source: t("Deducido aquí; φ como en la patente", "Derived here; φ as in the patent"),
        index: ROWS,
        print: Print::Short,
        columns,
    }
}

/// The torch's height.
#[must_use]
pub fn height(stations: &[Station]) -> Table {
    Table {
        key: "height",
        name: t("Altura", "Height"),
        title: t("Altura de la antorcha", "Height of the torch"),
        source: t(
            "σ = asen(sen(φ − γ)); D deducida aquí, en el plano tangente exterior, con el ángulo σ_o",
            "σ = asin(sin(φ − γ)); D derived here, in the outer tangent plane, at the angle σ_o",
        ),
        index: ROWS,
        print: Print::Short,
        columns: vec![
            numbers("α", DEGREE, Law::None, stations.iter().map(|one| one.alpha.to_degrees())).by("[curve.α]"),
            numbers("σ", DEGREE, Law::Told("σ = asin(sin(φ − γ))"), stations.iter().map(|one| one.sigma.to_degrees()))
                .by("DEGREES(ASIN(SIN(RADIANS([curve.φ]-groove_gamma))))"),
            numbers("σ_o", DEGREE, Law::None, stations.iter().map(|one| one.sigma_o.to_degrees()))
                .by("DEGREES(ASIN(MIN(1,([curve.y_o]*[pose.a_y]+[curve.z_o]*[pose.a_z])/derived_R_o)))"),
            numbers(
                "D",
                MM,
                Law::Told("max(d0, (g0 + r_g cos σ_o)/sin σ_o, (g0 + R_g cos σ_o)/sin σ_o − h_s)"),
                stations.iter().map(|one| one.D),
            )
            .by("MAX(height_d0,(least_gap_g0+nozzle_r_g*COS(RADIANS([σ_o])))/SIN(RADIANS([σ_o])),(least_gap_g0+torch_body_radius*COS(RADIANS([σ_o])))/SIN(RADIANS([σ_o]))-derived_h_s)"),
            numbers("g", MM, Law::None, stations.iter().map(|one| one.gap))
                .by("MIN([D]*SIN(RADIANS([σ_o]))-nozzle_r_g*COS(RADIANS([σ_o])),([D]+derived_h_s)*SIN(RADIANS([σ_o]))-torch_body_radius*COS(RADIANS([σ_o])))"),
            Column::texts(t("manda", "rule"), Law::None, stations.iter().map(|one| rule(one.rule)).collect()),
        ],
    }
}

/// The torch's pose and the machine's axes.
#[must_use]
pub fn pose(stations: &[Station], beside: f64) -> Table {
    // Turns go on, as in the program.
    let mut before: Option<TorchAxes> = None;
    let axes: Vec<TorchAxes> = stations
        .iter()
        .map(|one| {
            let axes = machine_axes(one, beside, before.as_ref());
            before = Some(axes);
            axes
        })
        .collect();
    let mut columns =
        vec![numbers("α", DEGREE, Law::None, stations.iter().map(|one| one.alpha.to_degrees())).by("[curve.α]")];
    let tip = [["x_o", "a_x"], ["y_o", "a_y"], ["z_o", "a_z"]]
        .map(|[face, axis]| format!("[curve.{face}]+[height.D]*[{axis}]"));
    let law = Law::Told("T = Q + D·a");
    columns.extend(vectors(stations, |one| one.pose.tip, ["x_t", "y_t", "z_t"], (MM, law), tip));
    let [normal, away] = frame();
    let axis = [0, 1, 2].map(|axis| format!("{}*COS({LEAN})+{}*SIN({LEAN})", away[axis], normal[axis]));
    let law = Law::Told("a = m cos(φ − γ) + n sin(φ − γ)");
    columns.extend(vectors(stations, |one| one.pose.axis, ["a_x", "a_y", "a_z"], (Unit::One, law), axis));
    columns.extend([
        numbers("A", DEGREE, Law::Told("A = atan2(−y_t, z_t)"), axes.iter().map(|one| one.A.to_degrees())),
        numbers("X", MM, Law::Told("X = x_t"), axes.iter().map(|one| one.X)),
        numbers("Z", MM, Law::Told("Z = √(y_t² + z_t²)"), axes.iter().map(|one| one.Z)),
        numbers("B", DEGREE, Law::Told("B = ±acos(a′_z)"), axes.iter().map(|one| one.B.to_degrees())),
        numbers("C", DEGREE, Law::Told("C = atan2(a′_y, a′_x)"), axes.iter().map(|one| one.C.to_degrees())),
    ]);
    Table {
        key: "pose",
        name: t("Postura", "Pose"),
        title: t("Posición de la antorcha y ejes de la máquina", "Position of the torch, and axes of the machine"),
        source: t("Deducido aquí; a′ es a girada con −A", "Derived here; a′ is a turned with −A"),
        index: ROWS,
        print: Print::Short,
        columns,
    }
}

/// The torch's way on the output grid, beside the root by half a kerf in mm.
#[must_use]
pub fn way(cut: &Cut, kerf: f64) -> Table {
    let places = std::iter::once(cut.pierce).chain(cut.legs.iter().map(|leg| leg.to));
    let symbols = ["A", "X", "Z", "B", "C"];
    let mut columns: Vec<Column> = AXES
        .into_iter()
        .enumerate()
        .map(|(at, axis)| {
            let unit = if axis.rotary() { DEGREE } else { MM };
            numbers(symbols[at], unit, Law::None, places.clone().map(move |place| place[at].value()))
        })
        .collect();
    let held = std::iter::once(cut.pierce_held).chain(cut.legs.iter().map(|leg| leg.held));
    columns.push(Column::texts(
        t("altura", "height"),
        Law::None,
        held.map(|held| if held { t("bloqueada", "held") } else { t("libre", "free") }).collect(),
    ));
    let words = std::iter::once(t("perforación", "pierce")).chain(cut.legs.iter().map(|leg| follows(leg.follows)));
    columns.push(Column::texts(t("sigue", "follows"), Law::None, words.collect()));
    Table {
        key: "way",
        name: t("Corte", "Cut"),
        title: way_title(kerf),
        source: t("Redondeado a 0.001; dividido según su tolerancia", "Rounded to 0.001; divided by its tolerance"),
        index: Index::Point,
        print: Print::Short,
        columns,
    }
}
