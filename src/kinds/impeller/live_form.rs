//! The live form of the impeller: its closed limits, and the blades in plan.

use crate::gcode::control::{MILLING, RotaryMode};
use crate::gcode::program::Style;
use crate::gcode::word::Distance;
use crate::kind::live_form::{LiveCurve, LiveForm, LiveLook, LiveRow, LiveView, Wrong, holds, says};
use crate::kinds::live_form::{feed_needed, mill_codes, retract};
use crate::table::{Formula, Unit};
use crate::text::t;

/// True where the part is cut clear: then the published limits decide nothing, and no formula tells whether the tools pass.
const CLEAR: &str = "OR(TRIM(method)=\"canal\",TRIM(method)=\"clear\")";
/// True where the part has splitters.
pub(super) const SPLITTERS: &str = "OR(TRIM(splitters)=\"yes\",TRIM(splitters)=\"sí\",TRIM(splitters)=\"si\")";

/// The points of one face of a blade in the view, less one.
const STEPS: usize = 8;
/// So many blades are drawn at most.
const BLADES: usize = 24;
/// The points of a circle, less one.
const CIRCLE: usize = 60;
/// Where a splitter is drawn from, as a point of the face.
const SPLITTER: usize = 3;

/// Inputs, limits and view of the form's sheet, as formulas that the workbook recomputes.
#[must_use]
pub fn live() -> LiveForm {
    LiveForm {
        inputs: &[
            "torus_R",
            "meridian_r",
            "intervals_n",
            "blades_N",
            "thickness_e",
            "depth_a_p",
            "tool_diameter_d_t",
            "spindle_height_R_B",
            "height_H",
            "safety_d_s",
        ],
        unsound: vec![
            Wrong::new(
                "meridian_r>=torus_R*(1-0.000001)",
                t("R debe ser mayor que r", "R must be larger than r"),
                "meridian_r",
            ),
            Wrong::new(
                "depth_a_p>=torus_R-meridian_r",
                t("a_p debe ser menor que R − r", "a_p must be less than R − r"),
                "depth_a_p",
            ),
        ],
        undecided: Some((
            CLEAR,
            t(
                "method = canal: rodete check comprueba si pasan las fresas",
                "method = clear: rodete check checks whether the tools pass",
            ),
        )),
        rows: rows(),
        view: view(),
    }
}

fn rows() -> Vec<LiveRow> {
    let row = LiveRow::length;
    let told = t("regla publicada; con canal, rodete check", "published rule; for clear, rodete check");
    let published = |wrong: &str| format!("AND(NOT({CLEAR}),{wrong})");
    vec![
        row("L", "live_L", t("Longitud de pivote", "Pivot length"), "spindle_height_R_B+height_H").wrong(
            "live_L<=MAX(torus_R,meridian_r)",
            t("L debe ser mayor que R", "L must be larger than R"),
            "height_H",
        ),
        row("k", "live_k", t("√(R² − r²)", "√(R² − r²)"), "SQRT((torus_R-meridian_r)*(torus_R+meridian_r))"),
        row(
            "α = β",
            "live_alpha",
            t("Inclinación del álabe", "Inclination of the blade"),
            "DEGREES(ASIN(meridian_r/torus_R))",
        )
        .unit(Unit::Degree),
        row("R·π/2", "live_length", t("Longitud de la fibra media", "Length of the mean line"), "torus_R*PI()/2"),
        row(
            "w",
            "live_w",
            t("Semiancho de álabe y herramienta", "Half width of blade and tool"),
            "(thickness_e+tool_diameter_d_t)/2",
        ),
        row("d", "live_d", t("Separación mínima entre álabes", "Minimum gap between blades"), "tool_diameter_d_t*4/3")
            .undecided(CLEAR, told.clone()),
        row(
            "gap",
            "live_gap",
            t("Separación en el cubo", "Gap at the hub"),
            "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-thickness_e",
        )
        .wrong(
            published("live_gap<live_d"),
            t("la separación es demasiado estrecha para la herramienta", "the gap is too narrow for the tool"),
            "tool_diameter_d_t",
        )
        .wrong(
            format!("AND({CLEAR},TRIM(cut_partly)<>\"yes\",TRIM(cut_partly)<>\"sí\",TRIM(cut_partly)<>\"si\",live_gap<tool_diameter_d_t)"),
            t("la separación es más estrecha que la herramienta", "the gap is narrower than the tool"),
            "tool_diameter_d_t",
        )
        .wrong(
            format!("AND({CLEAR},live_gap*blades_N+thickness_e*(blades_N-1)<tool_diameter_d_t)"),
            t("ni un álabe cabe en el cubo con la herramienta", "not one blade fits on the hub with the tool"),
            "tool_diameter_d_t",
        )
        .undecided(CLEAR, t("por el paralelo; la real es menor", "along the parallel; the true gap is smaller")),
        row(
            "N_max",
            "live_N_max",
            t("Número máximo de álabes", "Maximum number of blades"),
            "INT(2*PI()*(torus_R-meridian_r-depth_a_p)/(thickness_e+live_d))",
        )
        .unit(Unit::Count)
        .wrong(published("blades_N>live_N_max"), t("N es demasiado grande", "N is too large"), "blades_N")
        .undecided(CLEAR, told.clone()),
        row(
            "e_max",
            "live_e_max",
            t("Espesor máximo del álabe", "Maximum blade thickness"),
            "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-live_d",
        )
        .wrong(published("thickness_e>live_e_max"), t("e es demasiado grande", "e is too large"), "thickness_e")
        .undecided(CLEAR, told.clone()),
        row(
            "2·r − d_t",
            "live_room",
            t("Sitio de la herramienta en el hueco", "Room of the tool in the hollow"),
            "2*meridian_r-tool_diameter_d_t",
        )
        .wrong(
            "live_room<0",
            t("la herramienta es más ancha que el hueco", "the tool is wider than the hollow"),
            "tool_diameter_d_t",
        ),
        row(
            "d_s + d_t/2",
            "live_reach",
            t("Del final de la fibra al punto seguro", "From the end of the mean line to the safe point"),
            "safety_d_s+tool_diameter_d_t/2",
        )
        .wrong(
            published("live_reach<=live_w*live_k/torus_R"),
            t("d_s es demasiado pequeña", "d_s is too small"),
            "safety_d_s",
        )
        .undecided(CLEAR, told),
        row("360°/N", "live_pitch", t("Giro entre álabes", "Turn between blades"), "360/blades_N").unit(Unit::Degree),
        row(
            "Z_r",
            "live_Z_r",
            t("Altura de retirada", "Retract height"),
            "ROUNDUP((SQRT(live_L^2+torus_R^2)-live_L+safety_d_s)*1000,0)/1000",
        ),
    ]
    .into_iter()
    .chain(machine())
    .chain(program())
    .chain([mill_codes(), retract()])
    .chain(clear())
    .chain(blank())
    .collect()
}

/// The axes' travels.
fn machine() -> Vec<LiveRow> {
    let travel = |symbol, name, meaning, [low, high]: [&'static str; 2]| {
        LiveRow::length(symbol, name, meaning, format!("IF(COUNT({low},{high})=2,{high}-{low},\"\")")).wrong(
            format!("AND(COUNT({low},{high})=2,{low}>={high})"),
            t("el mínimo no es menor que el máximo", "the minimum is not below the maximum"),
            low,
        )
    };
    vec![
        travel("ΔB", "live_travel_B", t("Recorrido en B", "Travel in B"), ["B_min", "B_max"]).unit(Unit::Degree),
        travel("ΔX", "live_travel_X", t("Recorrido en X", "Travel in X"), ["X_min", "X_max"]),
        travel("ΔY", "live_travel_Y", t("Recorrido en Y", "Travel in Y"), ["Y_min", "Y_max"]),
        travel("ΔZ", "live_travel_Z", t("Recorrido en Z", "Travel in Z"), ["Z_min", "Z_max"]),
    ]
}

/// True as a formula where the control is one that is delivered with rollover axes.
fn delivered_rolling() -> String {
    let named: Vec<String> = MILLING
        .into_iter()
        .filter(|control| control.rotary.delivered.rolls_over())
        .map(|control| says("dialect", control.name))
        .collect();
    format!("OR({})", if named.is_empty() { "FALSE".into() } else { named.join(",") })
}

/// What the style of the programs asks for.
fn program() -> Vec<LiveRow> {
    let given = |symbol, name, meaning, input: &'static str| {
        LiveRow::length(symbol, name, meaning, format!("IF(ISNUMBER({input}),{input},\"\")")).always().wrong(
            format!("AND({},NOT(ISNUMBER({input})))", holds("style", Style::Full)),
            t("style = completo lo necesita", "style = full needs it"),
            input,
        )
    };
    vec![
        given("F", "live_F", t("Avance", "Feed"), "feed_F").unit(Unit::MillimetrePerMinute).wrong(
            "AND(COUNT(feed_F,feed_limit_F_max)=2,feed_F>feed_limit_F_max)",
            t("pasa de F_max", "above F_max"),
            "feed_F",
        ),
        given("S", "live_S", t("Giro del husillo", "Spindle speed"), "speed_S").unit(Unit::RevolutionPerMinute),
        feed_needed(
            LiveRow::length("style", "live_style", t("Estilo de los programas", "Style of the programs"), "style&\"\"")
                .always()
                .unit(Unit::None)
                .wrong(
                    format!("AND({CLEAR},{})", holds("style", Style::Annex)),
                    t("canal necesita style = completo", "clear needs style = full"),
                    "style",
                ),
        )
        // Left empty, the axes count as those of the control do.
        .wrong(
            format!(
                "AND({},{},OR({},AND(LEN(TRIM(rotary_axes))=0,{})))",
                holds("style", Style::Full),
                holds("distance", Distance::Absolute),
                holds("rotary_axes", RotaryMode::Rollover),
                delivered_rolling()
            ),
            t("con G90 y ejes rollover B y C darían la vuelta", "G90 with rollover axes turns B and C the long way"),
            "distance",
        ),
    ]
}

/// The tools of the clear cut.
fn clear() -> Vec<LiveRow> {
    // AND computes all that it holds: the guard keeps no formula from a text.
    let finishing = |wrong: &str| format!("AND({CLEAR},ISNUMBER(finish_diameter_d_f),{wrong})");
    vec![
        LiveRow::length(
            "d_f",
            "live_finishing",
            t("Fresa de acabado", "Finishing tool"),
            "IF(ISNUMBER(finish_diameter_d_f),finish_diameter_d_f,\"\")",
        )
        .wrong(
            finishing("finish_diameter_d_f>tool_diameter_d_t"),
            t("mayor que la de desbaste", "larger than that for roughing"),
            "finish_diameter_d_f",
        )
        .wrong(finishing("NOT(ISNUMBER(finish_tool_T_f))"), t("falta T_f", "T_f is missing"), "finish_tool_T_f")
        .wrong(finishing("NOT(ISNUMBER(finish_offset_D_f))"), t("falta D_f", "D_f is missing"), "finish_offset_D_f")
        .wrong(
            finishing("finish_tool_T_f=tool_T"),
            t("T_f es también la de desbaste", "T_f is the roughing tool's, too"),
            "finish_tool_T_f",
        )
        .wrong(
            finishing("N(finish_corner_radius_r_cf)>N(finish_diameter_d_f)/2"),
            t("r_cf es mayor que el radio de la fresa", "r_cf is larger than the tool's radius"),
            "finish_corner_radius_r_cf",
        ),
        LiveRow::length(
            "s_w",
            "live_allowance",
            t("Demasía para el acabado", "Allowance for finishing"),
            "IF(ISNUMBER(allowance_s_w),allowance_s_w,\"\")",
        )
        .wrong(
            format!("AND({CLEAR},ISNUMBER(allowance_s_w),allowance_s_w>=depth_a_p)"),
            t("debe ser menor que a_p", "must be less than a_p"),
            "allowance_s_w",
        )
        .wrong(
            format!("AND({CLEAR},ISNUMBER(corner_radius_r_c),corner_radius_r_c>tool_diameter_d_t/2)"),
            t("r_c es mayor que el radio de la fresa", "r_c is larger than the tool's radius"),
            "corner_radius_r_c",
        ),
    ]
}

/// The blank against the torus.
fn blank() -> Vec<LiveRow> {
    vec![
        LiveRow::length(
            "L_b − r",
            "live_stock",
            t("Lo que sobra de largo al bruto", "Length of the stock beyond the torus"),
            "IF(ISNUMBER(blank_length_L_b),blank_length_L_b-meridian_r,\"\")",
        )
        .wrong(
            "AND(ISNUMBER(blank_length_L_b),blank_length_L_b<=meridian_r)",
            t("L_b debe ser mayor que r", "L_b must be larger than r"),
            "blank_length_L_b",
        ),
        LiveRow::length(
            "X_e − 2R",
            "live_end",
            t("Del bruto a la posición final, en diámetro", "From the stock to the end position, as a diameter"),
            "IF(ISNUMBER(blank_end_X_e),blank_end_X_e-2*torus_R,\"\")",
        )
        .wrong(
            "AND(ISNUMBER(blank_end_X_e),blank_end_X_e<=2*torus_R)",
            t("la posición final está dentro del bruto", "the end position is inside the stock"),
            "blank_end_X_e",
        ),
        LiveRow::length(
            "C",
            "live_step",
            t("Paso del torneado, en Z", "Step of the turning, along Z"),
            "IF(ISNUMBER(blank_step_C),blank_step_C,\"\")",
        )
        .wrong(
            "AND(ISNUMBER(blank_step_C),blank_step_C>meridian_r)",
            t("no puede pasar de r", "must not exceed r"),
            "blank_step_C",
        ),
    ]
}

/// A cell of the hidden sheet: its column's letter, and its row from 0.
fn cell(letter: char, row: usize) -> String {
    format!("${letter}${}", row + 1)
}

/// x and y, as formulas, of the blade's point in a row of the hidden sheet, turned about the axis by an angle in radians.
fn turned(point: usize, angle: &str) -> [Formula; 2] {
    let (x, y) = (cell('D', point), cell('E', point));
    [format!("{x}*COS({angle})-{y}*SIN({angle})").into(), format!("{x}*SIN({angle})+{y}*COS({angle})").into()]
}

/// One blade in columns A to E, out along one face and back along the other; then every blade as one line, which goes on to
/// the next along the hub, the splitters along the rim; then two circles.
fn view() -> LiveView {
    let ok = |formula: String| -> Formula { format!("IF(live_ok,{formula},0)").into() };
    let points = 2 * (STEPS + 1);
    let step = |point: usize| if point <= STEPS { point } else { 2 * STEPS + 1 - point };
    let of = |each: &dyn Fn(usize) -> Formula| -> Vec<Formula> { (0..points).map(each).collect() };
    let v = of(&|point| format!("PI()+PI()/2*{}/{STEPS}", step(point)).into());
    let side = of(&|point| if point <= STEPS { "1".into() } else { "-1".into() });
    let u = of(&|point| {
        let v = cell('A', point);
        ok(format!("PI()/2+ATAN2(-(meridian_r+torus_R*COS({v})),-live_k*SIN({v}))"))
    });
    let along = |point: usize, turn: [&str; 2], across: &str| {
        let (v, side, u) = (cell('A', point), cell('B', point), cell('C', point));
        let [first, second] = turn;
        let b = format!("(meridian_r*{first}({u}){across}live_k*SIN({v})*{second}({u}))/torus_R");
        (format!("(torus_R+meridian_r*COS({v}))*{second}({u})"), format!("{side}*thickness_e/2*{b}"))
    };
    let x = of(&|point| {
        let (P, b) = along(point, ["SIN", "COS"], "-");
        ok(format!("({P}+{b})/torus_R"))
    });
    let y = of(&|point| {
        let (P, b) = along(point, ["COS", "SIN"], "+");
        ok(format!("({P}-{b})/torus_R"))
    });
    let mut turns: Vec<Formula> = Vec::new();
    let (mut blades, mut splitters) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
    let put = |to: &mut [Vec<Formula>; 2], [x, y]: [Formula; 2], when: &str| {
        to[0].push(format!("IF({when},{x},0)").into());
        to[1].push(format!("IF({when},{y},0)").into());
    };
    let wanted = &format!("AND(live_ok,{SPLITTERS})");
    for k in 0..BLADES {
        turns.push(ok(format!("2*PI()/blades_N*MIN({k},blades_N-1)")));
        let turn = cell('F', k);
        for point in 0..points {
            put(&mut blades, turned(point, &turn), "live_ok");
        }
        let between = format!("({turn}+PI()/blades_N)");
        for point in (SPLITTER..=STEPS).rev().chain((STEPS + 1..points - SPLITTER).rev()) {
            put(&mut splitters, turned(point, &between), wanted);
        }
        let rim = format!("ATAN2({},{})", cell('D', STEPS), cell('E', STEPS));
        for part in 1..4 {
            // Behind the last one the line stands still.
            let on = format!("{part}/4*2*PI()/blades_N*({k}<blades_N-1)");
            let hub = |function: &str| format!("(torus_R-meridian_r)/torus_R*{function}(PI()/2+{turn}+{on})").into();
            put(&mut blades, [hub("COS"), hub("SIN")], "live_ok");
            let edge = |function: &str| format!("{function}({rim}+{between}+{on})").into();
            put(&mut splitters, [edge("COS"), edge("SIN")], wanted);
        }
    }
    let circle = |radius: &str, function: &str| -> Vec<Formula> {
        (0..=CIRCLE).map(|at| ok(format!("{radius}*{function}(2*PI()*{at}/{CIRCLE})"))).collect()
    };
    let hub = "(torus_R-meridian_r)/torus_R";
    let [blades_x, blades_y] = blades;
    let [splitters_x, splitters_y] = splitters;
    LiveView {
        title: t("Planta", "Plan view"),
        height: 1.0,
        drawn: "live_ok",
        columns: vec![
            v,
            side,
            u,
            x,
            y,
            turns,
            blades_x,
            blades_y,
            splitters_x,
            splitters_y,
            circle("1", "COS"),
            circle("1", "SIN"),
            circle(hub, "COS"),
            circle(hub, "SIN"),
        ],
        curves: vec![
            LiveCurve { columns: [10, 11], look: LiveLook::Faint },
            LiveCurve { columns: [12, 13], look: LiveLook::Faint },
            LiveCurve { columns: [8, 9], look: LiveLook::Dashed },
            LiveCurve { columns: [6, 7], look: LiveLook::Part },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{CLEAR, holds};
    use crate::kinds::impeller::clear::fields::Method;

    #[test]
    fn the_clear_cut_is_known_by_its_words() {
        assert_eq!(CLEAR, holds("method", Method::Clear));
    }
}
