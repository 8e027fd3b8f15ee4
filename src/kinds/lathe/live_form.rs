//! The live form of the lathe: its closed limits, and stock, chuck, tailstock and mounted tools in plan, the turret at its
//! reference point.

use crate::gcode::control::TURNING;
use crate::kind::live_form::{LiveCurve, LiveForm, LiveLook, LiveRow, LiveView, says};
use crate::kinds::lathe::setup::MARGIN;
use crate::removal::turning::machine::{Chuck, Lathe, Tailstock};
use crate::table::{Formula, Unit};
use crate::text::{Text, t};

/// The places of a turret.
const PLACES: usize = 8;
/// How high the view is for its width.
const HEIGHT: f64 = 0.8;
/// So much of the tailstock's quill is drawn, mm.
const QUILL: f64 = 60.0;

/// The live part of the form.
#[must_use]
pub fn live() -> LiveForm {
    LiveForm {
        inputs: &["stock_D", "stock_L", "held_L4", "facing_L5", "chuck_L1", "jaws_L2", "chuck_D_c"],
        unsound: Vec::new(),
        undecided: None,
        rows: rows(),
        view: view(),
    }
}

fn rows() -> Vec<LiveRow> {
    stock().into_iter().chain(ranges()).chain(reference()).chain(turret_and_control()).collect()
}

/// The stock in the chuck, and the part zero on it.
fn stock() -> [LiveRow; 5] {
    [
        LiveRow::length("L3", "live_stick_out", t("Voladizo: L − L4", "Stick-out: L − L4"), "stock_L-held_L4").wrong(
            "held_L4>=stock_L",
            t("L4 debe ser menor que L", "L4 must be less than L"),
            "held_L4",
        ),
        LiveRow::length(
            "L3 − L5",
            "live_free",
            t("De las garras al cero pieza W1", "From the jaws to the part zero W1"),
            "live_stick_out-facing_L5",
        )
        .wrong(
            "AND(live_stick_out>0,facing_L5>=live_stick_out)",
            t("L5 debe ser menor que el voladizo", "L5 must be less than the stick-out"),
            "facing_L5",
        ),
        LiveRow::length(
            "Z_W1",
            "live_Z_W1",
            t("Cero pieza W1 (G54), desde M", "Part zero W1 (G54), from M"),
            "chuck_L1+jaws_L2+live_stick_out-facing_L5",
        ),
        LiveRow::length(
            "L3/D",
            "live_slenderness",
            t("Con contrapunto según el voladizo, si pasa de 3", "By the stick-out, with the tailstock if above 3"),
            "live_stick_out/stock_D",
        )
        .unit(Unit::One),
        LiveRow::length(
            "(D − d)/2",
            "live_wall",
            t("Pared del bruto hueco", "Wall of a hollow stock"),
            "IF(ISNUMBER(stock_bore_d),(stock_D-stock_bore_d)/2,\"\")",
        )
        .wrong(
            "AND(ISNUMBER(stock_bore_d),stock_bore_d>=stock_D)",
            t("d debe ser menor que D", "d must be less than D"),
            "stock_bore_d",
        ),
    ]
}

/// How far the axes travel, and the turret's body reaches.
fn ranges() -> [LiveRow; 4] {
    [
        range(
            "ΔX",
            "live_travel_X",
            t("Recorrido en X, en diámetro", "Travel in X, as a diameter"),
            ["travel_X_min", "travel_X_max"],
        ),
        range("ΔZ", "live_travel_Z", t("Recorrido en Z", "Travel in Z"), ["travel_Z_min", "travel_Z_max"]),
        body(
            "ΔBX",
            "live_body_X",
            t("Cuerpo de la torreta en X, en radio", "Turret's body in X, on the radius"),
            ["body_BX_min", "body_BX_max"],
        ),
        body(
            "ΔBZ",
            "live_body_Z",
            t("Cuerpo de la torreta en Z", "Turret's body in Z"),
            ["body_BZ_min", "body_BZ_max"],
        ),
    ]
}

/// From one cell to another, of which the first must be the less.
fn range(symbol: &'static str, name: &'static str, meaning: Text, [least, most]: [&'static str; 2]) -> LiveRow {
    let both = format!("COUNT({least},{most})=2");
    LiveRow::length(symbol, name, meaning, format!("IF({both},{most}-{least},\"\")")).wrong(
        format!("AND({both},{least}>={most})"),
        t("el mínimo no es menor que el máximo", "the minimum is not below the maximum"),
        least,
    )
}

/// A size of the turret's body, which has all four of its cells or none.
fn body(symbol: &'static str, name: &'static str, meaning: Text, ends: [&'static str; 2]) -> LiveRow {
    ends.into_iter().fold(range(symbol, name, meaning, ends), |row, end| {
        row.wrong(
            format!("AND(COUNT(body_BX_min,body_BX_max,body_BZ_min,body_BZ_max)>0,NOT(ISNUMBER({end})))"),
            t("el cuerpo lleva sus cuatro medidas", "the body needs all four sizes"),
            end,
        )
    })
}

/// The reference point, of which both coordinates are given or none.
fn reference() -> [LiveRow; 2] {
    [
        LiveRow::length(
            "R_X",
            "live_reference_X",
            t("Punto de referencia, X en diámetro, desde M", "Reference point, X as a diameter, from M"),
            "2*Plan!$G$1",
        )
        .wrong(
            "AND(ISNUMBER(reference_R_Z),NOT(ISNUMBER(reference_R_X)))",
            t("con R_Z va R_X", "R_Z needs R_X"),
            "reference_R_X",
        ),
        LiveRow::length(
            "R_Z",
            "live_reference_Z",
            t("Punto de referencia, Z desde M", "Reference point, Z from M"),
            "Plan!$G$2",
        )
        .wrong(
            "AND(ISNUMBER(reference_R_X),NOT(ISNUMBER(reference_R_Z)))",
            t("con R_X va R_Z", "R_X needs R_Z"),
            "reference_R_Z",
        ),
    ]
}

/// The mounted tools, and how the control reads a dimension.
fn turret_and_control() -> [LiveRow; 2] {
    [
        LiveRow::length(
            "T",
            "live_tools",
            t("Herramientas montadas", "Mounted tools"),
            format!("COUNTIF(Plan!$A$1:$A${PLACES},\">0\")"),
        )
        .unit(Unit::Count)
        .wrong("Plan!$G$9>live_tools", t("un puesto está dos veces", "a place is there twice"), ""),
        LiveRow::length(
            "point",
            "live_point",
            t("Cómo lee el control X100", "How the control reads X100"),
            "decimal_point&\"\"",
        )
        .always()
        .unit(Unit::None)
        .wrong(
            format!("AND({},LEN(TRIM(decimal_point))=0)", by_setting()),
            t("este control lo necesita", "this control needs it"),
            "decimal_point",
        ),
    ]
}

/// True as a formula where a setting of the control says how it reads a dimension without a decimal point.
fn by_setting() -> String {
    let asking = TURNING.into_iter().filter(|control| control.lexis.point.by_setting());
    let asking = asking.map(|control| says("dialect", control.name));
    format!("OR({})", asking.collect::<Vec<_>>().join(","))
}

/// A point of a curve, `[z, r]`, each a formula.
type Point = [String; 2];

fn at(z: &str, r: &str) -> Point {
    [z.to_owned(), r.to_owned()]
}

/// A formula for each place of the turret, whose number stands for `#`.
fn by_place(formula: &str) -> Vec<Formula> {
    (1..=PLACES).map(|at| formula.replace('#', &at.to_string()).into()).collect()
}

/// The right and the left end of the stock, and the front of the jaws.
const RIGHT: &str = "(chuck_L1+jaws_L2+stock_L-held_L4)";
const LEFT: &str = "(chuck_L1+jaws_L2-held_L4)";
const FRONT: &str = "(chuck_L1+jaws_L2)";

/// The mounted tools in columns A to F, by their places: row of the list, Q_x, Q_z, width, length, whether it is a bar; single
/// cells in G; then the curves, in mm from machine zero M in H to Q, and scaled behind them.
fn view() -> LiveView {
    let Lathe { chuck, tailstock, .. } = Lathe::default();
    // From the stock on, G10: whether the tailstock supports it.
    let behind = format!("IF($G$10,{RIGHT}+{QUILL},{RIGHT})");
    let outlines = [
        chuck_outline(&chuck),
        stock_outline(),
        bore_and_zero(&behind),
        quill_outline(&tailstock, &behind),
        turret_outline(),
    ];
    let lines = outlines.map(|points| {
        [0, 1].map(|axis| points.iter().map(|point| format!("IF(live_ok,{},0)", point[axis]).into()).collect())
    });
    let mut columns = Vec::from(mounted_tools());
    columns.push(single_cells(&lines, &tailstock));
    columns.extend(lines.iter().flatten().cloned());
    let curves = scaled(&lines, &mut columns);
    LiveView {
        title: t("Planta: plato, bruto, torreta", "Plan view: chuck, stock, turret"),
        height: HEIGHT,
        drawn: "live_ok",
        columns,
        curves,
    }
}

/// Columns A to F.
fn mounted_tools() -> [Vec<Formula>; 6] {
    let own = |symbol: &str| by_place(&format!("IF($A#>0,N(INDEX([tools.{symbol}],$A#)),0)"));
    let kind = "INDEX([tools.type],$A#)";
    // Boring bars and drills lie along the axis, whatever the language of their type.
    let bar = format!(
        "IF($A#>0,IF(OR(LEFT({kind},5)=\"broca\",RIGHT({kind},5)=\"drill\",RIGHT({kind},8)=\"interior\",LEFT({kind},8)=\"internal\"),1,0),0)"
    );
    [
        by_place("IF(ISNUMBER(MATCH(#,[tools.T],0)),MATCH(#,[tools.T],0),0)"),
        own("Q_x"),
        own("Q_z"),
        own("b"),
        own("l"),
        by_place(&bar),
    ]
}

/// The chuck with its jaws.
fn chuck_outline(chuck: &Chuck) -> Vec<Point> {
    let jaw = format!("(stock_D/2+{})", chuck.jaw_height);
    vec![
        at("chuck_L1", "stock_D/2"),
        at(FRONT, "stock_D/2"),
        at(FRONT, &jaw),
        at("chuck_L1", &jaw),
        at("chuck_L1", "chuck_D_c/2"),
        at("0", "chuck_D_c/2"),
        at("0", "-chuck_D_c/2"),
        at("chuck_L1", "-chuck_D_c/2"),
        at("chuck_L1", &format!("-{jaw}")),
        at(FRONT, &format!("-{jaw}")),
        at(FRONT, "-stock_D/2"),
        at("chuck_L1", "-stock_D/2"),
        at("chuck_L1", "stock_D/2"),
    ]
}

fn stock_outline() -> Vec<Point> {
    vec![
        at(LEFT, "stock_D/2"),
        at(RIGHT, "stock_D/2"),
        at(RIGHT, "-stock_D/2"),
        at(LEFT, "-stock_D/2"),
        at(LEFT, "stock_D/2"),
    ]
}

/// The bore; of a solid stock its axis. Then the part zero.
fn bore_and_zero(behind: &str) -> Vec<Point> {
    vec![
        at("0", "0"),
        at(LEFT, "0"),
        at(LEFT, "N(stock_bore_d)/2"),
        at(RIGHT, "N(stock_bore_d)/2"),
        at(RIGHT, "-N(stock_bore_d)/2"),
        at(LEFT, "-N(stock_bore_d)/2"),
        at(LEFT, "0"),
        at("live_Z_W1", "0"),
        at("live_Z_W1", "0.7*stock_D"),
        at("live_Z_W1", "-0.7*stock_D"),
        at("live_Z_W1", "0"),
        at(behind, "0"),
    ]
}

/// The tailstock's quill; a point where none supports the stock.
fn quill_outline(tailstock: &Tailstock, behind: &str) -> Vec<Point> {
    let half = (tailstock.diameter / 2.0).to_string();
    let tip = format!("({RIGHT}-{})", tailstock.depth);
    let shoulder = format!("{tip}+{half}/TAN(RADIANS(30))");
    let below = format!("-{half}");
    [at(&tip, "0"), at(&shoulder, &half), at(behind, &half), at(behind, &below), at(&shoulder, &below), at(&tip, "0")]
        .into_iter()
        .map(|[z, r]| [format!("IF($G$10,{z},{RIGHT})"), format!("IF($G$10,{r},0)")])
        .collect()
}

/// From the reference point to the end of each tool's shank, round it, and back. G3: 1 for a rear turret, −1 for a front one.
fn turret_outline() -> Vec<Point> {
    let reference = || at("$G$2", "$G$3*$G$1");
    let mut points = Vec::new();
    for place in 1..=PLACES {
        let (tip_z, tip_x) = (format!("($G$2-$C${place})"), format!("($G$1-$B${place})"));
        let corner = |(along, beside): (f64, f64)| {
            let (long, wide) = (format!("{along}*$E${place}"), format!("{beside}*$D${place}/2"));
            let bar = format!("$F${place}=1");
            let z = format!("{tip_z}+IF({bar},{long},{wide})");
            let x = format!("$G$3*({tip_x}+IF({bar},{wide},{long}))");
            [format!("IF($A${place}>0,{z},$G$2)"), format!("IF($A${place}>0,{x},$G$3*$G$1)")]
        };
        points.push(reference());
        points.extend([(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, -1.0), (1.0, -1.0), (1.0, 0.0)].map(corner));
        points.push(reference());
    }
    points
}

/// The columns of the curves, H to Q.
const LETTERS: [[char; 2]; 5] = [['H', 'I'], ['J', 'K'], ['L', 'M'], ['N', 'O'], ['P', 'Q']];

/// The points of the curves, by their axes.
type Lines = [[Vec<Formula>; 2]; LETTERS.len()];

/// The cells of column G.
fn single_cells(lines: &Lines, tailstock: &Tailstock) -> Vec<Formula> {
    let free = |far: &str, [least, most]: [&str; 2], scale: &str| {
        format!("MAX(IF(ISNUMBER({least}),{least}{scale},-5000),MIN(IF(ISNUMBER({most}),{most}{scale},5000),{far}))")
    };
    let referred = "COUNT(reference_R_X,reference_R_Z)=2";
    let [far_x, far_z] = [
        format!("stock_D/2+{MARGIN}+MAX(0,$B$1:$B${PLACES})"),
        format!("chuck_L1+jaws_L2+stock_L-held_L4+{MARGIN}+MAX(0,$C$1:$C${PLACES})"),
    ];
    let [free_x, free_z] =
        [free(&far_x, ["travel_X_min", "travel_X_max"], "/2"), free(&far_z, ["travel_Z_min", "travel_Z_max"], "")];
    let all = |axis: usize| {
        let ranges =
            lines.iter().zip(LETTERS).map(|(line, letter)| format!("${0}$1:${0}${1}", letter[axis], line[axis].len()));
        ranges.collect::<Vec<_>>().join(",")
    };
    // Without sound inputs there is nothing to compute with.
    vec![
        format!("IF(live_ok,IF({referred},reference_R_X/2,{free_x}),0)").into(),
        format!("IF(live_ok,IF({referred},reference_R_Z,{free_z}),0)").into(),
        "IF(OR(TRIM(turret)=\"rear\",TRIM(turret)=\"trasera\"),1,-1)".into(),
        format!("MIN({})", all(0)).into(),
        format!("MAX({})", all(0)).into(),
        format!("MIN({})", all(1)).into(),
        format!("MAX({})", all(1)).into(),
        // G8: the scale. G9: the tools with a place.
        format!("IF($G$5>$G$4,1/MAX(($G$5-$G$4)/2,($G$7-$G$6)/2/{HEIGHT}),0)").into(),
        "COUNT([tools.T])".into(),
        format!(
            "IF(live_ok,OR(TRIM(tailstock)=\"yes\",TRIM(tailstock)=\"sí\",TRIM(tailstock)=\"si\",AND(NOT(TRIM(tailstock)=\"no\"),stock_L-held_L4>{}*stock_D)),FALSE)",
            tailstock.beyond
        )
        .into(),
    ]
}

/// The curves, whose points are put behind the other columns to the view's scale.
fn scaled(lines: &Lines, columns: &mut Vec<Vec<Formula>>) -> Vec<LiveCurve> {
    let looks = [LiveLook::Faint, LiveLook::Part, LiveLook::Dashed, LiveLook::Faint, LiveLook::Dashed];
    let mut curves = Vec::new();
    for ((line, letter), look) in lines.iter().zip(LETTERS).zip(looks) {
        for (axis, [low, high]) in [["$G$4", "$G$5"], ["$G$6", "$G$7"]].into_iter().enumerate() {
            let scaled = |row: usize| format!("(${}{row}-({low}+{high})/2)*$G$8", letter[axis]).into();
            columns.push((1..=line[axis].len()).map(scaled).collect());
        }
        curves.push(LiveCurve { columns: [columns.len() - 2, columns.len() - 1], look });
    }
    curves
}
