//! The limits, angles and lengths that follow from a design, each with its formula in the workbook.

use std::f64::consts::FRAC_PI_2;

use crate::gcode::program::Program;
use crate::gcode::word::NumberFormat;
use crate::geometry::villarceau::Villarceau;
use crate::kind::Proved;
use crate::kinds::impeller::Model;
use crate::kinds::impeller::blade_count::{N_max, e_max, hub_circumference, least_gap};
use crate::kinds::impeller::clear;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::gap::Limits;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::splitter::Splitter;
use crate::machine::axis::Axis;
use crate::table::{Quantity, Unit};
use crate::text::t;

/// Derived limits, angles and lengths, in the order in which they are shown.
pub(super) fn quantities(design: &Design, model: &Model, programs: &[Proved]) -> Vec<Quantity> {
    let mut list = Vec::from(lengths(design));
    list.extend(published_limits(design));
    list.extend([true_gap(&model.limits), lean_of_end(model), pitch(design), end_of_turning(design)]);
    list.extend(true_limits(&model.limits));
    if let (Some(plan), Some(asked)) = (&model.clear, &design.clear) {
        list.extend(clear::tables::quantities(design, asked, plan));
    }
    list.extend(model.splitter.as_ref().map(crossings).into_iter().flatten());
    list.extend(retract_height(programs));
    list
}

/// The machine's pivot, and the blade's circle, line and width.
fn lengths(design: &Design) -> [Quantity; 5] {
    let (torus, mm) = (design.torus, Unit::Millimetre);
    let circle = Villarceau::new(torus);
    [
        worded(
            "L",
            "Longitud de pivote, del eje B al centro del toro",
            "Pivot length, from the B axis to the torus centre",
            design.machine.L,
            mm,
            ["R_B + H", "R_B + H"],
        )
        .by("derived_L", "spindle_height_R_B+height_H"),
        worded("k", "Semieje √(R² − r²)", "Semi-axis √(R² − r²)", circle.k, mm, ["TFG, ec. (6)", "thesis, eq. (6)"])
            .by("derived_k", "SQRT((torus_R-meridian_r)*(torus_R+meridian_r))"),
        worded(
            "alpha",
            "Ángulo α del círculo de Villarceau",
            "Angle α of the Villarceau circle",
            circle.alpha().to_degrees(),
            Unit::Degree,
            ["sen α = r/R", "sin α = r/R"],
        )
        .by("derived_alpha", "DEGREES(ASIN(meridian_r/torus_R))"),
        worded(
            "length",
            "Longitud de la fibra media",
            "Length of the mean line",
            torus.R * FRAC_PI_2,
            mm,
            ["|dX/dv| = R: R·π/2", "|dX/dv| = R: R·π/2"],
        )
        .by("derived_length", "torus_R*PI()/2"),
        worded(
            "w",
            "Semiancho de álabe y herramienta",
            "Half width of blade and tool",
            design.w(),
            mm,
            ["(e + d_t)/2, TFG, ecs. (20) y (21)", "(e + d_t)/2, thesis, eqs (20) and (21)"],
        )
        .by("derived_w", "(thickness_e+tool_diameter_d_t)/2"),
    ]
}

/// How many blades, and how thick, by the published rule, with the gap that it is about.
fn published_limits(design: &Design) -> [Quantity; 4] {
    let (torus, a_p, e, d_t) = (design.torus, design.a_p, design.e, design.d_t);
    let mm = Unit::Millimetre;
    let gap = hub_circumference(torus, a_p) / f64::from(design.N) - e;
    [
        worded(
            "d",
            "Separación mínima entre álabes, según lo publicado",
            "Minimum gap between blades, as published",
            least_gap(d_t),
            mm,
            ["4/3·d_t, TFG, sección 4.2.2", "4/3·d_t, thesis, section 4.2.2"],
        )
        .by("derived_d", "tool_diameter_d_t*4/3"),
        worded(
            "gap",
            "Separación entre álabes en el cubo, medida por el paralelo",
            "Gap between blades at the hub, along the parallel",
            gap,
            mm,
            ["2π(R − r − a_p)/N − e", "2π(R − r − a_p)/N − e"],
        )
        .by("derived_gap", "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-thickness_e"),
        worded(
            "N_max",
            "Número máximo de álabes, según lo publicado",
            "Maximum number of blades, as published",
            N_max(torus, a_p, e, d_t),
            Unit::Count,
            ["TFG, ec. (34)", "thesis, eq. (34)"],
        )
        .by("derived_N_max", "INT(2*PI()*(torus_R-meridian_r-depth_a_p)/(thickness_e+derived_d))"),
        worded(
            "e_max",
            "Espesor máximo del álabe, según lo publicado",
            "Maximum blade thickness, as published",
            e_max(torus, a_p, design.N, d_t),
            mm,
            ["TFG, ec. (35)", "thesis, eq. (35)"],
        )
        .by("derived_e_max", "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-derived_d"),
    ]
}

/// The gap in space, where the published one follows a parallel.
fn true_gap(limits: &Limits) -> Quantity {
    worded(
        "gap_true",
        "Separación real: mayor herramienta que pasa entre los álabes",
        "True gap: largest tool that passes between the blades",
        limits.gap.width,
        Unit::Millimetre,
        [
            "el doble de lo que el eje de la fresa se aparta de las caras en el paso más estrecho",
            "twice the distance of the tool axis from the faces at the narrowest place",
        ],
    )
}

/// How far the blade's end leans.
fn lean_of_end(model: &Model) -> Quantity {
    let beta = worded(
        "beta",
        "Inclinación β del extremo del álabe",
        "Inclination β of the blade's end",
        model.passes.entry.beta.to_degrees(),
        Unit::Degree,
        ["TFG, ec. (23) corregida", "thesis, eq. (23) corrected"],
    );
    // A clear cut has no annex of the published paths that it could be taken from.
    let formula = if model.clear.is_some() { "DEGREES(ASIN(meridian_r/torus_R))" } else { "[annex-8.β first]" };
    beta.by("derived_beta", formula)
}

fn pitch(design: &Design) -> Quantity {
    worded(
        "pitch",
        "Giro entre álabes",
        "Turn between blades",
        360.0 / f64::from(design.N),
        Unit::Degree,
        ["TFG, ec. (22)", "thesis, eq. (22)"],
    )
    .by("derived_pitch", "360/blades_N")
}

fn end_of_turning(design: &Design) -> Quantity {
    worded(
        "X_e",
        "X final del torneado, en diámetro",
        "End X of the turning, on the diameter",
        design.blank.X_e,
        Unit::Millimetre,
        ["la de la hoja; vacía: 2·R + 30", "as in the form; empty: 2·R + 30"],
    )
    .by("derived_X_e", "IF(ISBLANK(blank_end_X_e),2*torus_R+30,blank_end_X_e)")
}

/// How many blades, and how thick, where the true gap keeps the published rule. A limit that does not exist is left out; the
/// caution about the gap says so.
fn true_limits(limits: &Limits) -> impl Iterator<Item = Quantity> {
    let blades = limits.N_max.map(|N| {
        worded(
            "N_max_true",
            "Número máximo de álabes si la separación real cumple la regla publicada",
            "Maximum number of blades whose true gap keeps the published rule",
            f64::from(N),
            Unit::Count,
            ["separación real ≥ 4/3·d_t", "true gap ≥ 4/3·d_t"],
        )
    });
    let thickness = limits.e_max.map(|e| {
        worded(
            "e_max_true",
            "Espesor máximo del álabe si la separación real cumple la regla publicada",
            "Maximum blade thickness whose true gap keeps the published rule",
            e,
            Unit::Millimetre,
            ["separación real ≥ 4/3·d_t", "true gap ≥ 4/3·d_t"],
        )
    });
    blades.into_iter().chain(thickness)
}

/// Z to which the first blade program retracts, as it was proved.
fn retract_height(programs: &[Proved]) -> Option<Quantity> {
    let first = |program: &Program| matches!(Operation::of(program), Some(Operation::Blade | Operation::Rough));
    let program = programs.iter().find(|program| program.format == NumberFormat::Fixed && first(program))?;
    Some(
        worded(
            "Z_r",
            "Altura de retirada",
            "Retract height",
            program.start.get(Axis::Z).value(),
            Unit::Millimetre,
            ["√(L² + R²) − L + d_s", "√(L² + R²) − L + d_s"],
        )
        .by("derived_Z_r", "ROUNDUP((SQRT(derived_L^2+torus_R^2)-derived_L+safety_d_s)*1000,0)/1000"),
    )
}

pub(in crate::kinds::impeller) fn worded(
    symbol: &'static str,
    es: &'static str,
    en: &'static str,
    value: f64,
    unit: Unit,
    source: [&'static str; 2],
) -> Quantity {
    Quantity { symbol, meaning: t(es, en), value, unit, source: t(source[0], source[1]), cell: None }
}

/// Where a splitter's paths cross its neighbours', and from where on its offset is full.
#[expect(clippy::cast_precision_loss, reason = "counts of points")]
fn crossings(splitter: &Splitter) -> Vec<Quantity> {
    let Splitter { out, back, .. } = splitter;
    let section = ["TFG, sección 4.3", "thesis, section 4.3"];
    let room = ["donde la herramienta libra al vecino", "where the tool clears the neighbour"];
    match splitter.fade {
        Fade::Published => vec![
            worded(
                "crossing",
                "Índice del cruce con el álabe vecino",
                "Index of the crossing with the neighbour",
                back.crossing,
                Unit::One,
                section,
            ),
            worded(
                "m",
                "Punto desde el que el intermedio tiene todo su espesor",
                "Point from which the splitter has its full thickness",
                back.m as f64,
                Unit::Count,
                section,
            )
            .named("derived_m"),
        ],
        Fade::EachSide => vec![
            worded(
                "crossing_1",
                "Índice del cruce con el álabe vecino, a la ida",
                "Index of the crossing with the neighbour, out",
                out.crossing,
                Unit::One,
                section,
            ),
            worded(
                "m_1",
                "Punto desde el que la ida lleva toda su separación",
                "Point from which the way out has its full offset",
                out.m as f64,
                Unit::Count,
                room,
            )
            .named("derived_m_1"),
            worded(
                "crossing_2",
                "Índice del cruce con el álabe vecino, a la vuelta",
                "Index of the crossing with the neighbour, back",
                back.crossing,
                Unit::One,
                section,
            ),
            worded(
                "m_2",
                "Punto desde el que la vuelta lleva toda su separación",
                "Point from which the way back has its full offset",
                back.m as f64,
                Unit::Count,
                room,
            )
            .named("derived_m_2"),
        ],
    }
}
