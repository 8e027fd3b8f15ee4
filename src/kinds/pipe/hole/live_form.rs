//! The live form of the hole: its sizes, its closed limits, and the template of the hole on the header's outside.
//!
//! # Derivation
//! As in [`bounds`](super::bounds): with n out of the header, o out of the branch, c = n·o and s = √(1 − c²) the torch stands
//! along a = (o − c n)/s · (s sin γ − c cos γ) + n (s cos γ + c sin γ).

use crate::kind::live_form::{LiveCurve, LiveForm, LiveLook, LiveRow, LiveView};
use crate::kinds::live_form::torch_codes;
use crate::kinds::pipe::live_form::{HEADER, found, rows as pipes, sizes, thick};
use crate::table::{Formula, Unit};
use crate::text::t;

/// The points of the curve, less one.
const STEPS: usize = 96;

/// Inputs, limits and template of the form's sheet, as formulas that the workbook recomputes.
#[must_use]
pub fn live() -> LiveForm {
    LiveForm {
        inputs: &[
            "live_branch_D",
            "live_branch_t",
            "live_header_D",
            "live_header_t",
            "angle_theta",
            "eccentricity_e",
            "groove_gamma",
            "root_gap_b",
            "land_h",
            "nozzle_r_g",
            "torch_body_radius",
            "taper_Psi",
            "beam_m",
            "height_d0",
            "least_gap_g0",
            "greatest_height_D_max",
            "lead_in",
        ],
        unsound: vec![thick(&HEADER)],
        undecided: None,
        rows: rows(),
        view: view(),
    }
}

fn rows() -> Vec<LiveRow> {
    let mut rows = pipes();
    rows.extend([
        LiveRow::length(
            "R_o",
            "live_R_o",
            t("Radio exterior del tubo", "Outside radius of the header"),
            "live_header_D/2",
        ),
        LiveRow::length(
            "R_i + h",
            "live_root_R",
            t("Radio de la raíz en el tubo", "Radius of the root in the header"),
            "live_header_D/2-live_header_t+land_h",
        )
        .wrong(
            "land_h>=live_header_t",
            t("h debe ser menor que la pared", "h must be less than the wall"),
            "land_h",
        ),
        LiveRow::length(
            "r",
            "live_hole_r",
            t("Radio del injerto con su holgura", "Radius of the branch with its gap"),
            "live_branch_D/2+root_gap_b",
        )
        .wrong(
            "live_hole_r>=live_root_R",
            t("el injerto no cabe en el tubo base", "the branch does not fit into the header"),
            "branch_size",
        ),
        LiveRow::length(
            "e_max",
            "live_e_max",
            t("Excentricidad: menor que R_i + h − r", "Eccentricity: less than R_i + h − r"),
            "live_root_R-live_hole_r",
        )
        .wrong(
            "AND(live_e_max>0,ABS(eccentricity_e)>=live_e_max)",
            t("e es demasiado grande", "e is too large"),
            "eccentricity_e",
        ),
        LiveRow::length(
            "h_s",
            "live_h_s",
            t("De la punta al hombro de la antorcha", "From the torch's tip to its shoulder"),
            "(torch_body_radius-nozzle_r_g)/TAN(RADIANS(taper_Psi))",
        )
        .wrong(
            "torch_body_radius<nozzle_r_g",
            t("el cuerpo es más fino que la punta", "the body is thinner than the tip"),
            "torch_body_radius",
        ),
        LiveRow::length(
            "σ_0",
            "live_sigma_0",
            t("Ángulo por debajo del cual manda la punta", "Angle below which the tip sets the height"),
            "DEGREES(ASIN(MIN(1,least_gap_g0/SQRT(height_d0^2+nozzle_r_g^2)))+ATAN(nozzle_r_g/height_d0))",
        )
        .unit(Unit::Degree)
        .wrong(
            "least_gap_g0>=height_d0",
            t("g0 debe ser menor que d0", "g0 must be less than d0"),
            "least_gap_g0",
        ),
        LiveRow::length(
            "D",
            "live_D_most",
            t("Altura de la antorcha, la mayor de 96", "Height of the torch, the greatest of 96"),
            format!("IF(Plan!$D$3,MAX(Plan!$Q$1:$Q${}),\"\")", STEPS + 1),
        )
        .wrong(
            "IF(ISNUMBER(live_D_most),live_D_most>greatest_height_D_max,FALSE)",
            t("D pasa de D_max, γ es demasiado grande", "D is above D_max, γ is too large"),
            "groove_gamma",
        )
        .wrong(
            "greatest_height_D_max<height_d0",
            t("D_max es menor que d0", "D_max is less than d0"),
            "greatest_height_D_max",
        ),
        LiveRow::length("kerf", "live_kerf", t("Ancho de corte", "Kerf"), "IF(ISNUMBER(kerf),kerf,2*beam_m)").wrong(
            "live_kerf<2*beam_m-0.000000001",
            t("más fino que el chorro", "finer than the beam"),
            "kerf",
        ),
        LiveRow::length(
            "r − kerf/2",
            "live_lead_in_most",
            t("La entrada debe ser menor", "The lead-in must be less"),
            "live_hole_r-live_kerf/2",
        )
        .wrong(
            "lead_in>=live_lead_in_most",
            t("la entrada pasa del eje del agujero", "the lead-in reaches past the hole's axis"),
            "lead_in",
        ),
        LiveRow::length(
            "hold",
            "live_hold",
            t("Bloqueo de la altura: sí / no", "Height held: on / off"),
            "IF(LEN(TRIM(hold_on&hold_off))=0,\"\",hold_on&\" / \"&hold_off)",
        )
        .unit(Unit::None)
        .wrong(
            "AND(LEN(TRIM(hold_on))=0,LEN(TRIM(hold_off))>0)",
            t("con hold_off va hold_on", "hold_off needs hold_on"),
            "hold_on",
        )
        .wrong(
            "AND(LEN(TRIM(hold_on))>0,LEN(TRIM(hold_off))=0)",
            t("con hold_on va hold_off", "hold_on needs hold_off"),
            "hold_off",
        ),
    ]);
    rows.extend(torch_codes(&["hold_on", "hold_off"]));
    rows
}

/// Sizes in columns A to C, single cells in D; from E on one place of the cut a row: α, the root, the torch's direction, where
/// its axis leaves the header, its height; then the edge scaled, and the two lines through the branch's foot.
fn view() -> LiveView {
    let mut columns = Vec::from(sizes());
    columns.push(single_cells());
    columns.extend(places_of_the_cut());
    let line = |ends: [&str; 2]| -> Vec<Formula> { ends.map(|end| format!("IF($D$3,{end},0)").into()).to_vec() };
    columns.extend([each("$O#*$D$5"), each("$P#*$D$5"), line(["-1.1", "1.1"]), line(["0", "0"])]);
    LiveView {
        title: t("Plantilla sobre el exterior del tubo", "Template on the pipe's outside"),
        height: 1.0,
        drawn: "Plan!$D$3",
        columns,
        curves: vec![
            LiveCurve { columns: [19, 20], look: LiveLook::Dashed },
            LiveCurve { columns: [20, 19], look: LiveLook::Faint },
            LiveCurve { columns: [17, 18], look: LiveLook::Part },
        ],
    }
}

/// The cells of column D.
fn single_cells() -> Vec<Formula> {
    let mut single = found();
    let all = |column: char| format!("${column}$1:${column}${}", STEPS + 1);
    single.extend::<[Formula; 3]>([
        // D3: whether there is a hole.
        "IF(live_ok,AND(live_hole_r+ABS(eccentricity_e)<live_root_R,live_root_R<=live_R_o),FALSE)".into(),
        // D4: how far the edge reaches from the foot of the branch's axis. D5: the scale.
        format!("MAX({0},-MIN({0}),{1},-MIN({1}))", all('O'), all('P')).into(),
        "IF($D$4>0,1/$D$4,0)".into(),
    ]);
    single
}

/// A formula in each row of the cut, whose number stands for `#`; 0 where there is no hole.
fn each(formula: &str) -> Vec<Formula> {
    (1..=STEPS + 1).map(|row| format!("IF($D$3,{},0)", formula.replace('#', &row.to_string())).into()).collect()
}

/// Columns E to Q.
fn places_of_the_cut() -> [Vec<Formula>; 13] {
    let (theta, gamma) = ("RADIANS(angle_theta)", "RADIANS(groove_gamma)");
    let alpha: Vec<Formula> = (0..=STEPS).map(|at| format!("2*PI()*{at}/{STEPS}").into()).collect();
    // F, G, H: the root. Seen from the header's end, e > 0 stands at y = −e.
    let y = each("live_hole_r*SIN($E#)-eccentricity_e");
    let z = each("SQRT(MAX(0,live_root_R^2-$F#^2))");
    let x = each(&format!(
        "($G#+live_hole_r*COS($E#)*COS({theta}))/SIN({theta})*COS({theta})+live_hole_r*COS($E#)*SIN({theta})"
    ));
    // I, J: c and s. K to M: the torch's direction.
    let c = each(&format!("($F#*SIN($E#)-$G#*COS($E#)*COS({theta}))/live_root_R"));
    let s = each("SQRT(1-$I#^2)");
    let out = format!("($J#*SIN({gamma})-$I#*COS({gamma}))/$J#");
    let up = format!("($J#*COS({gamma})+$I#*SIN({gamma}))");
    let a_x = each(&format!("COS($E#)*SIN({theta})*{out}"));
    let a_y = each(&format!("(SIN($E#)-$I#*$F#/live_root_R)*{out}+$F#/live_root_R*{up}"));
    let a_z = each(&format!("(-COS($E#)*COS({theta})-$I#*$G#/live_root_R)*{out}+$G#/live_root_R*{up}"));
    // N: the way along it to the outside. O, P: the edge on the development. There the axis rises by λ·(a_y² + a_z²) + b.
    let b = "($F#*$L#+$G#*$M#)";
    let root = format!("SQRT(MAX(0,{b}^2-($L#^2+$M#^2)*(live_root_R^2-live_R_o^2)))");
    let along = each(&format!("({root}-{b})/($L#^2+$M#^2)"));
    let edge_x = each("$H#+$N#*$K#");
    let edge_y = each("live_R_o*ATAN2($G#+$N#*$M#,$F#+$N#*$L#)");
    // Q: the height, by the sine of the torch's angle to the outside.
    let sine = format!("MAX(0.000001,MIN(1,{root}/live_R_o))");
    let cosine = format!("SQRT(1-{sine}^2)");
    let height = each(&format!(
        "MAX(height_d0,(least_gap_g0+nozzle_r_g*{cosine})/{sine},(least_gap_g0+torch_body_radius*{cosine})/{sine}-live_h_s)"
    ));
    [alpha, y, z, x, c, s, a_x, a_y, a_z, along, edge_x, edge_y, height]
}
