//! The live form of the branch: its sizes, its closed limits, and the template on the development.

use crate::gcode::program::Style;
use crate::kind::live_form::{LiveCurve, LiveForm, LiveLook, LiveRow, LiveView, holds};
use crate::kinds::live_form::{feed_needed, torch_codes};
use crate::kinds::pipe::insert::enveloped;
use crate::kinds::pipe::insert::parameters::Mode;
use crate::kinds::pipe::live_form::{BRANCH, found, rows as pipes, sizes, thick};
use crate::table::{Formula, Unit};
use crate::text::t;

/// The points of the curve, less one.
const STEPS: usize = 120;
/// How high the view is for its width.
const HEIGHT: f64 = 0.55;

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
            "offset_Z",
            "divisions_N",
        ],
        unsound: vec![thick(&BRANCH)],
        undecided: None,
        rows: rows(),
        view: view(),
    }
}

/// A radius of the branch: the one that is typed, else that of a surface, in the words of either language.
fn radius(typed: &str, choice: &str) -> String {
    let inside = format!("OR(TRIM({choice})=\"inside\",TRIM({choice})=\"interior\",{})", enveloped(choice));
    let mean = format!("OR(TRIM({choice})=\"mean\",TRIM({choice})=\"media\")");
    format!("IF(ISNUMBER({typed}),{typed},live_branch_D/2-IF({inside},live_branch_t,IF({mean},live_branch_t/2,0)))")
}

fn rows() -> Vec<LiveRow> {
    let mut rows = pipes();
    rows.extend([
        LiveRow::length(
            "r",
            "live_branch_r",
            t("Radio de la curva del injerto", "Radius of the branch's curve"),
            radius("expert_branch_r", "contact"),
        )
        .wrong(
            format!("AND(OR({}),ISNUMBER(expert_branch_r))", enveloped("contact")),
            t("la envolvente no lleva r", "the envelope takes no r"),
            "expert_branch_r",
        )
        .wrong(
            "live_branch_r>live_header_R",
            t("el injerto es mayor que el tubo base", "the branch is larger than the header"),
            "branch_size",
        ),
        LiveRow::length(
            "R",
            "live_header_R",
            t("Radio del tubo base", "Radius of the header"),
            "IF(ISNUMBER(expert_header_R),expert_header_R,live_header_D/2)",
        ),
        LiveRow::length(
            "e_max",
            "live_e_max",
            t("Excentricidad máxima: R − r", "Maximum eccentricity: R − r"),
            "live_header_R-live_branch_r",
        )
        .wrong(
            "AND(live_e_max>=0,ABS(eccentricity_e)-live_e_max>0.000000001*live_header_R)",
            t("e es demasiado grande, el injerto sobresale", "e is too large, the branch overhangs"),
            "eccentricity_e",
        ),
        LiveRow::length(
            "r_dev",
            "live_r_dev",
            t("Radio del desarrollo", "Radius of the development"),
            radius("expert_sheet_r_dev", "sheet"),
        ),
        LiveRow::length("W", "live_W", t("Longitud del desarrollo", "Length of the development"), "2*PI()*live_r_dev"),
        LiveRow::length(
            "W/N",
            "live_division",
            t("Ancho de una división", "Width of one division"),
            "live_W/divisions_N",
        ),
        LiveRow::length(
            "y(180°)",
            "live_y_180",
            t("y de la curva en φ = 180°", "y of the curve at φ = 180°"),
            format!(
                "IF(OR({}),live_branch_D-live_branch_t,2*live_branch_r)/TAN(RADIANS(angle_theta))+offset_Z",
                enveloped("contact")
            ),
        ),
        LiveRow::length("F", "live_F", t("Velocidad de corte", "Cutting speed"), "IF(ISNUMBER(feed_F),feed_F,\"\")")
            .unit(Unit::MillimetrePerMinute)
            .wrong(
                format!("AND({},NOT(ISNUMBER(feed_F)))", holds("style", Style::Full)),
                t("style = completo necesita F", "style = full needs F"),
                "feed_F",
            ),
        feed_needed(
            LiveRow::length("style", "live_style", t("Estilo del programa", "Style of the program"), "style&\"\"")
                .unit(Unit::None)
                .wrong(
                    format!("AND({},{})", holds("style", Style::Annex), holds("mode", Mode::Rotary)),
                    t("anexo es en chapa plana", "annex is on flat sheet"),
                    "style",
                ),
        ),
        LiveRow::length("kerf", "live_kerf", t("Ancho de corte", "Kerf"), "IF(ISNUMBER(kerf),kerf,\"\")").wrong(
            format!(
                "AND({},{},ISNUMBER(kerf),kerf>live_branch_D/2-live_branch_t)",
                holds("style", Style::Full),
                holds("mode", Mode::Rotary)
            ),
            t("mayor que el radio interior del injerto", "larger than the inside radius of the branch"),
            "kerf",
        ),
    ]);
    rows.extend(torch_codes(&[]));
    rows
}

/// Sizes in columns A to C, single cells in D; the curve in E to H: φ, y, and both coordinates scaled; then the sheet's edge
/// with both seams, and the lines of the quarters; in M the distance from the branch's axis of what touches.
fn view() -> LiveView {
    let [words, diameters, walls] = sizes();
    let mut single = found();
    let all = |column: char| format!("${column}$1:${column}${}", STEPS + 1);
    single.extend::<[Formula; 4]>([
        // D3: whether there is a curve. Else the branch is larger than the header, or passes it.
        "IF(live_ok,live_branch_r+ABS(eccentricity_e)<=live_header_R*1.000000001,FALSE)".into(),
        // D4, D5: upper and lower edge of the view.
        format!("MAX(0,{})", all('F')).into(),
        format!("MIN(0,{})", all('F')).into(),
        // D6: the scale.
        format!("IF($D$3,1/MAX(live_W/2,($D$4-$D$5)/2/{HEIGHT}),0)").into(),
    ]);
    let of = |each: &dyn Fn(usize) -> String| -> Vec<Formula> { (0..=STEPS).map(|at| each(at + 1).into()).collect() };
    let phi = of(&|row| format!("2*PI()*{}/{STEPS}", row - 1));
    let cos_of = |q: &str| format!("SQRT(MAX(0,1-(({q})/live_header_R)^2))");
    let reach = |rho: &str, row: usize| {
        let here = cos_of(&format!("{rho}*SIN($E{row})+eccentricity_e"));
        format!("(live_header_R*{here}+{rho}*COS($E{row})*COS(RADIANS(angle_theta)))/SIN(RADIANS(angle_theta))")
    };
    let touch = of(&|row| {
        let ([bore, outside], sin) =
            (["(live_branch_D/2-live_branch_t)", "(live_branch_D/2)"], format!("SIN($E{row})"));
        let c = format!("COS($E{row})*COS(RADIANS(angle_theta))");
        let (more, foot) = (
            format!("{}>{}+0.000000001", reach(outside, row), reach(bore, row)),
            format!("(live_header_R*{c}*IF({sin}<0,-1,1)/SQRT({sin}^2+({c})^2)-eccentricity_e)/{sin}"),
        );
        let touch = format!("IF(ABS({sin})<0.000000001,IF({more},{outside},{bore}),MAX({bore},MIN({outside},{foot})))");
        format!("IF($D$3,IF(OR({}),{touch},live_branch_r),0)", enveloped("contact"))
    });
    let y = of(&|row| format!("IF($D$3,{}-{}+offset_Z,0)", reach("$M$1", 1), reach(&format!("$M{row}"), row)));
    let across = |x: &str| -> Formula { format!("IF($D$3,({x}-live_W/2)*$D$6,0)").into() };
    let up = |y: &str| -> Formula { format!("IF($D$3,({y}-($D$4+$D$5)/2)*$D$6,0)").into() };
    let curve_x = (1..=STEPS + 1).map(|row| across(&format!("live_W*$E{row}/2/PI()"))).collect();
    let curve_y = (1..=STEPS + 1).map(|row| up(&format!("$F{row}"))).collect();
    let last = format!("$F${}", STEPS + 1);
    let edge: [(&str, &str); 4] = [("0", "$F$1"), ("0", "0"), ("live_W", "0"), ("live_W", &last)];
    let quarters: Vec<(String, String)> = (1..=3)
        .flat_map(|number| {
            let (x, top) = (format!("live_W*{number}/4"), format!("$F${}", number * STEPS / 4 + 1));
            [(x.clone(), "0".to_owned()), (x.clone(), top), (x, "0".to_owned())]
        })
        .collect();
    LiveView {
        title: t("Plantilla sobre el desarrollo", "Template on the development"),
        height: HEIGHT,
        drawn: "Plan!$D$3",
        columns: vec![
            words,
            diameters,
            walls,
            single,
            phi,
            y,
            curve_x,
            curve_y,
            edge.iter().map(|(x, _)| across(x)).collect(),
            edge.iter().map(|(_, y)| up(y)).collect(),
            quarters.iter().map(|(x, _)| across(x)).collect(),
            quarters.iter().map(|(_, y)| up(y)).collect(),
            touch,
        ],
        curves: vec![
            LiveCurve { columns: [10, 11], look: LiveLook::Dashed },
            LiveCurve { columns: [8, 9], look: LiveLook::Faint },
            LiveCurve { columns: [6, 7], look: LiveLook::Part },
        ],
    }
}
