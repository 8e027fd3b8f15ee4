//! The tables of the annexes, the splitter and the calibration, with their charts.

use std::sync::Arc;

use nalgebra::Vector3;

use crate::kinds::impeller::blade::{Blade, Vectors};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::safety::{End, SafeEnd, safe_end};
use crate::kinds::impeller::splitter::{Side, Splitter};
use crate::kinds::impeller::tool_path::tool_path;
use crate::machine::calibration::{Axis, Slots, nearest};
use crate::table::{Column, Formula, Index, Law, Print, Table, Unit};
use crate::text::{Text, t};

const MM: Unit = Unit::Millimetre;
const RAD: Unit = Unit::Radian;

/// What the passes of one blade are made of.
#[derive(Clone, Debug)]
pub struct ToolPaths {
    /// The path along the obverse, machine coordinates, mm.
    pub obverse: Vectors,
    /// The path along the reverse.
    pub reverse: Vectors,
    /// The safe points at B = 90°.
    pub entry: SafeEnd,
    /// The safe points at B = 0°.
    pub exit: SafeEnd,
}

impl ToolPaths {
    /// The passes of one blade with their safe points.
    #[must_use]
    pub fn new(design: &Design, blade: &Blade) -> Self {
        let (w, a_p) = (design.w(), design.a_p);
        let (obverse, reverse) = (tool_path(blade, w, a_p), tool_path(blade, -w, a_p));
        let last = blade.points() - 1;
        let safe = |end, i: usize| safe_end(end, &obverse[i], &reverse[i], design.d_s, design.d_t, w);
        let (entry, exit) = (safe(End::Entry, 0), safe(End::Exit, last));
        Self { obverse, reverse, entry, exit }
    }
}

/// The rows of a table of the blade's points follow n.
const POINTS: Index = Index::Intervals { name: "intervals_n", times: 1, more: 0 };

fn annex(key: &'static str, name: Text, title: Text, source: Text, columns: Vec<Column>) -> Table {
    Table { key, name, title, source, index: POINTS, print: Print::Short, columns }
}

/// Three columns of vectors, each computed by its formula.
fn vectors(
    symbols: [&'static str; 3],
    unit: Unit,
    law: Law,
    values: &Vectors,
    formulas: [impl Into<Formula>; 3],
) -> Vec<Column> {
    Column::vectors(symbols, unit, law, values).into_iter().zip(formulas).map(|(one, by)| one.by(by)).collect()
}

/// B and C at the end of a path.
fn turns(blade: &Blade) -> [Column; 2] {
    [
        Column::numbers("B", RAD, Law::Told("B = 3π/2 − v"), Arc::clone(&blade.B)).by("[annex-4.B]"),
        Column::numbers("C", RAD, Law::Told("C = u − 2π"), Arc::clone(&blade.C)).by("[annex-4.C]"),
    ]
}

/// The formulas of a path at w·`fraction` across the blade, on the side of a sign, and at the depth a_p.
fn offset(side: char, fraction: &str) -> [String; 3] {
    let other = if side == '+' { '-' } else { '+' };
    [
        format!("[annex-5.x]{side}derived_w{fraction}*derived_k/torus_R"),
        format!("[annex-5.y]{other}derived_w{fraction}*meridian_r/torus_R"),
        "[annex-5.z]-depth_a_p".to_owned(),
    ]
}

const XYZ: [&str; 3] = ["x", "y", "z"];

/// Annexes 1 to 8, in order: the tables of the published passes, as the thesis prints them.
#[must_use]
pub fn annexes(blade: &Blade, passes: &ToolPaths) -> Vec<Table> {
    vec![
        angles(blade),
        mean_line(blade),
        darboux_frame(blade),
        rotary_angles(blade),
        transformed(blade),
        obverse(blade, passes),
        reverse(blade, passes),
        safety(passes),
    ]
}

fn angles(blade: &Blade) -> Table {
    annex(
        "annex-1",
        t("Anexo 1", "Annex 1"),
        t("Discretización de los ángulos v y u", "Discretisation of the angles v and u"),
        t("Anexo 1, ecuación (6) corregida", "Annex 1, equation (6) corrected"),
        vec![
            Column::numbers("v", RAD, Law::Told("v = π + i·h, h = (π/2)/n"), Arc::clone(&blade.v))
                .by("PI()+PI()/2/intervals_n*IF([i]=intervals_n,intervals_n-end_backoff_eps_v,[i])"),
            Column::numbers(
                "u",
                RAD,
                Law::Told("u = atan2(−(r + R·cos v), k·sin v), k = √(R² − r²)"),
                Arc::clone(&blade.u),
            )
            // Turned by π/2, so that the cut of the arctangent is never met.
            .by("PI()/2+ATAN2(-(meridian_r+torus_R*COS([v])),-derived_k*SIN([v]))"),
        ],
    )
}

fn mean_line(blade: &Blade) -> Table {
    annex(
        "annex-2",
        t("Anexo 2", "Annex 2"),
        t("Geometría de la fibra media de un álabe", "Mean line of a blade"),
        t("Anexo 2, ecuación (4)", "Annex 2, equation (4)"),
        vectors(
            XYZ,
            MM,
            Law::Told("P = (ρ·cos u, ρ·sin u, r·sin v), ρ = R + r·cos v"),
            &blade.P,
            [
                "(torus_R+meridian_r*COS([annex-1.v]))*COS([annex-1.u])",
                "(torus_R+meridian_r*COS([annex-1.v]))*SIN([annex-1.u])",
                "meridian_r*SIN([annex-1.v])",
            ],
        ),
    )
}

fn darboux_frame(blade: &Blade) -> Table {
    let frame = [
        vectors(
            ["N_x", "N_y", "N_z"],
            Unit::One,
            Law::Told("N = −(cos v·cos u, cos v·sin u, sin v)"),
            &blade.N,
            ["-COS([annex-1.v])*COS([annex-1.u])", "-COS([annex-1.v])*SIN([annex-1.u])", "-SIN([annex-1.v])"],
        ),
        vectors(
            ["t_x", "t_y", "t_z"],
            Unit::One,
            Law::Told("t = (X_u·k/ρ + X_v)/R"),
            &blade.t,
            [
                "(-derived_k*SIN([annex-1.u])-meridian_r*SIN([annex-1.v])*COS([annex-1.u]))/torus_R",
                "(derived_k*COS([annex-1.u])-meridian_r*SIN([annex-1.v])*SIN([annex-1.u]))/torus_R",
                "meridian_r*COS([annex-1.v])/torus_R",
            ],
        ),
        vectors(
            ["b_x", "b_y", "b_z"],
            Unit::One,
            Law::Told("b = t × N"),
            &blade.b,
            ["[t_y]*[N_z]-[t_z]*[N_y]", "[t_z]*[N_x]-[t_x]*[N_z]", "[t_x]*[N_y]-[t_y]*[N_x]"],
        ),
    ];
    annex(
        "annex-3",
        t("Anexo 3", "Annex 3"),
        t("Triedro de Darboux", "Darboux frame"),
        t("Anexo 3, sección 2.2.3", "Annex 3, section 2.2.3"),
        frame.into_iter().flatten().collect(),
    )
}

fn rotary_angles(blade: &Blade) -> Table {
    annex(
        "annex-4",
        t("Anexo 4", "Annex 4"),
        t("Ángulos de giro C y B", "Rotary angles C and B"),
        t("Anexo 4, ecuaciones (7) y (14) corregidas", "Annex 4, equations (7) and (14) corrected"),
        vec![
            Column::numbers("C", RAD, Law::Told("C = u − 2π"), Arc::clone(&blade.C)).by("[annex-1.u]-2*PI()"),
            Column::numbers("B", RAD, Law::Told("B = 3π/2 − v"), Arc::clone(&blade.B)).by("PI()+PI()/2-[annex-1.v]"),
        ],
    )
}

fn transformed(blade: &Blade) -> Table {
    annex(
        "annex-5",
        t("Anexo 5", "Annex 5"),
        t("Geometría de un álabe transformada", "Blade in machine coordinates"),
        t(
            "Anexo 5, ecuación (16) corregida con la longitud de pivote",
            "Annex 5, equation (16) corrected with the pivot length",
        ),
        vectors(
            XYZ,
            MM,
            Law::Told("P″ = M2(B)·(M1(−C)·P + L·k̂) − L·k̂"),
            &blade.machine,
            [
                "([annex-2.x]*COS([annex-4.C])+[annex-2.y]*SIN([annex-4.C]))*COS([annex-4.B])-([annex-2.z]+derived_L)*SIN([annex-4.B])",
                "[annex-2.y]*COS([annex-4.C])-[annex-2.x]*SIN([annex-4.C])",
                "([annex-2.x]*COS([annex-4.C])+[annex-2.y]*SIN([annex-4.C]))*SIN([annex-4.B])+([annex-2.z]+derived_L)*COS([annex-4.B])-derived_L",
            ],
        ),
    )
}

fn obverse(blade: &Blade, passes: &ToolPaths) -> Table {
    annex(
        "annex-6",
        t("Anexo 6", "Annex 6"),
        t("Trayectoria de la herramienta, anverso", "Tool path along the obverse"),
        t("Anexo 6, ecuación (20) corregida", "Annex 6, equation (20) corrected"),
        path(blade, Law::Told("P″ + w·b″ − a_p·N″, w = (e + d_t)/2"), &passes.obverse, '+'),
    )
}

fn reverse(blade: &Blade, passes: &ToolPaths) -> Table {
    annex(
        "annex-7",
        t("Anexo 7", "Annex 7"),
        t("Trayectoria de la herramienta, reverso", "Tool path along the reverse"),
        t("Anexo 7, ecuación (21) corregida", "Annex 7, equation (21) corrected"),
        path(blade, Law::Told("P″ − w·b″ − a_p·N″, w = (e + d_t)/2"), &passes.reverse, '-'),
    )
}

/// The columns of a path `side` (+ or −) of the blade: X, Y, Z in mm, B and C in radians.
fn path(blade: &Blade, law: Law, points: &Vectors, side: char) -> Vec<Column> {
    let mut columns = vectors(XYZ, MM, law, points, offset(side, ""));
    columns.extend(turns(blade));
    columns
}

/// The ends of the paths in the rows of annex 8, of which every other is the reverse's.
const ENDS: [&str; 4] = ["first", "first", "last", "last"];

/// A coordinate of the path at each end, and what is added to it.
fn at_ends(axis: &str, and: &str) -> [String; 4] {
    let mut annex = [6, 7].into_iter().cycle();
    ENDS.map(|end| format!("[annex-{}.{axis} {end}]{and}", annex.next().unwrap_or(6)))
}

fn safety(passes: &ToolPaths) -> Table {
    let rows: [(&SafeEnd, bool); 4] =
        [(&passes.entry, true), (&passes.entry, false), (&passes.exit, true), (&passes.exit, false)];
    let column = |symbol, unit, law, value: fn(&SafeEnd, bool) -> f64| {
        Column::numbers(symbol, unit, law, rows.iter().map(|&(end, obverse)| value(end, obverse)).collect::<Vec<_>>())
    };
    Table {
        key: "annex-8",
        name: t("Anexo 8", "Annex 8"),
        title: t("Distancia de seguridad", "Safety distances"),
        source: t("Anexo 8, ecuaciones (23) a (32) corregidas", "Annex 8, equations (23) to (32) corrected"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::texts(
                t("extremo", "end"),
                Law::None,
                vec![t("entrada", "entry"), t("entrada", "entry"), t("salida", "exit"), t("salida", "exit")],
            ),
            Column::texts(
                t("pasada", "side"),
                Law::None,
                vec![
                    t("anverso", "obverse"),
                    t("reverso", "reverse"),
                    t("anverso", "obverse"),
                    t("reverso", "reverse"),
                ],
            ),
            column("β", Unit::Degree, Law::Told("tan β = (y_r − y_a)/(x_a − x_r)"), |end, _| {
                end.beta.to_degrees()
            })
            .by_each(ENDS.map(|end| {
                format!("DEGREES(ATAN2([annex-6.x {end}]-[annex-7.x {end}],[annex-7.y {end}]-[annex-6.y {end}]))")
            })),
            column("Δx", MM, Law::Told("∓(d_s + d_t/2 ± w·cos β)"), |end, obverse| {
                if obverse { end.step_obverse[0] } else { end.step_reverse[0] }
            })
            .by_each([["-", "+"], ["-", "-"], ["", "-"], ["", "+"]].map(|[sign, across]| {
                format!("{sign}(safety_d_s+tool_diameter_d_t/2{across}derived_w*COS(RADIANS([β])))")
            })),
            column(
                "Δy",
                MM,
                Law::Told("Δx/tan β"),
                |end, obverse| if obverse { end.step_obverse[1] } else { end.step_reverse[1] },
            )
            .by("[Δx]/TAN(RADIANS([β]))"),
            column("x", MM, Law::Told("x + Δx"), |end, obverse| if obverse { end.obverse.x } else { end.reverse.x })
                .by_each(at_ends("x", "+[Δx]")),
            column("y", MM, Law::Told("y + Δy"), |end, obverse| if obverse { end.obverse.y } else { end.reverse.y })
                .by_each(at_ends("y", "+[Δy]")),
            column("z", MM, Law::Told("z"), |end, obverse| if obverse { end.obverse.z } else { end.reverse.z })
                .by_each(at_ends("z", "")),
        ],
    }
}

/// The paths in plan whose crossing limits the splitter, and the splitter's own paths.
#[must_use]
pub fn splitter(design: &Design, blade: &Blade, splitter: &Splitter) -> [Table; 2] {
    [intersection(design, blade, splitter), splitter_paths(blade, splitter)]
}

/// The paths in plan whose crossing limits the splitter.
fn intersection(design: &Design, blade: &Blade, splitter: &Splitter) -> Table {
    let [own, neighbour] = crate::kinds::impeller::splitter::plan_paths(blade, design.N, design.w(), design.a_p);
    let plan = |points: &[nalgebra::Vector2<f64>]| -> Vectors {
        points.iter().map(|point| Vector3::new(point.x, point.y, 0.0)).collect()
    };
    let take_two = |symbols: [&'static str; 3], law, points: &Vectors, [x, y]: [String; 2]| {
        vectors(symbols, MM, law, points, [x, y, String::new()]).into_iter().take(2).collect::<Vec<_>>()
    };
    let beside = |axis: char, side: char| {
        format!("[annex-2.{axis}]{side}derived_w*[annex-3.b_{axis}]-depth_a_p*[annex-3.N_{axis}]")
    };
    let (x, y) = (beside('x', '-'), beside('y', '-'));
    let turned = [
        format!("({x})*COS(-PI()/blades_N)-({y})*SIN(-PI()/blades_N)"),
        format!("({x})*SIN(-PI()/blades_N)+({y})*COS(-PI()/blades_N)"),
    ];
    let straight = ['x', 'y'].map(|axis| beside(axis, '+'));
    let mut columns = take_two(["x_own", "y_own", ""], Law::Told("P + w·b − a_p·N"), &plan(&own), straight);
    columns.extend(take_two(
        ["x_neighbour", "y_neighbour", ""],
        Law::Told("Rz(−π/N)·(P − w·b − a_p·N)"),
        &plan(&neighbour),
        turned,
    ));
    let in_spanish = ["x_propia", "y_propia", "x_vecina", "y_vecina"].into_iter().zip(columns);
    let columns = in_spanish
        .map(|(es, mut column)| {
            column.symbol.es = es.into();
            column
        })
        .collect();
    Table {
        key: "intersection",
        name: t("Intersección", "Intersection"),
        title: t("Cruce con el álabe vecino", "Crossing with the neighbouring blade"),
        source: crossing_source(splitter),
        index: POINTS,
        print: Print::Short,
        columns,
    }
}

/// The splitter's own paths.
fn splitter_paths(blade: &Blade, splitter: &Splitter) -> Table {
    let fraction = |symbol, law, side: &Side, m| {
        let formula = format!("MIN(1,(([i]+1)/({m}+1))^5)");
        // m is searched for.
        Column::numbers(symbol, Unit::One, law, side.fraction.clone()).by(formula).in_part()
    };
    let Splitter { out, back, .. } = splitter;
    let (mut columns, paths, fractions) = match splitter.fade {
        Fade::Published => (
            vec![fraction("f", Law::Told("f_j = ((j+1)/(m+1))⁵, j ≤ m"), out, "derived_m")],
            ["P″ − w·f·b″ − a_p·N″", "P″ + w·f·b″ − a_p·N″"],
            ["*[f]"; 2],
        ),
        Fade::EachSide => (
            vec![
                fraction("f_1", Law::Told("f_1 = ((j+1)/(m_1+1))⁵, j ≤ m_1"), out, "derived_m_1"),
                fraction("f_2", Law::Told("f_2 = ((j+1)/(m_2+1))⁵, j ≤ m_2"), back, "derived_m_2"),
            ],
            ["P″ − w·f_1·b″ − a_p·N″", "P″ + w·f_2·b″ − a_p·N″"],
            ["*[f_1]", "*[f_2]"],
        ),
    };
    let path = |symbols, at: usize, side: &Side, sign| {
        let columns = vectors(symbols, MM, Law::Told(paths[at]), &side.path, offset(sign, fractions[at]));
        columns.into_iter().map(Column::in_part)
    };
    columns.extend(path(["x_1", "y_1", "z_1"], 0, out, '-'));
    columns.extend(path(["x_2", "y_2", "z_2"], 1, back, '+'));
    columns.extend(turns(blade));
    Table {
        key: "splitter",
        name: t("Álabe intermedio", "Splitter"),
        title: t(
            "Trayectorias del álabe intermedio, ida (1) y vuelta (2)",
            "Tool paths of the splitter blade, out (1) and back (2)",
        ),
        source: t("Anexo 10, sección 4.3", "Annex 10, section 4.3"),
        index: POINTS,
        print: Print::Short,
        columns,
    }
}

/// Where the paths cross, and from which points on the offset is full.
fn crossing_source(splitter: &Splitter) -> Text {
    let Splitter { out, back, .. } = splitter;
    let at = format!("({:.3}, {:.3}) mm", splitter.crossing.at.x, splitter.crossing.at.y);
    let [es, en] = ["Sección 4.3 y ecuación (36), en planta", "Section 4.3 and equation (36), in plan"];
    match splitter.fade {
        Fade::Published => Text::new(
            format!("{es}. Índice del cruce {:.2}, en {at}; m = {}", back.crossing, back.m),
            format!("{en}. Index of the crossing {:.2}, at {at}; m = {}", back.crossing, back.m),
        ),
        Fade::EachSide => Text::new(
            format!(
                "{es}. Índices de los cruces {:.2} (ida) y {:.2} (vuelta), en {at}; m_1 = {}, m_2 = {}",
                out.crossing, back.crossing, out.m, back.m
            ),
            format!(
                "{en}. Indices of the crossings {:.2} (out) and {:.2} (back), at {at}; m_1 = {}, m_2 = {}",
                out.crossing, back.crossing, out.m, back.m
            ),
        ),
    }
}

/// The turning of the blank: the cycle's parameters.
#[must_use]
pub fn blank(design: &Design) -> Table {
    let (R, r) = (design.torus.R, design.torus.r);
    let rows: [(&'static str, Text, f64); 8] = [
        ("X", t("inicio del perfil, en diámetro: 2·R", "start of the profile, on the diameter: 2·R"), 2.0 * R),
        ("Z", t("inicio del perfil: −r", "start of the profile: −r"), -r),
        (
            "Q",
            t("final del perfil, en diámetro: 2·(R − r)", "end of the profile, on the diameter: 2·(R − r)"),
            2.0 * (R - r),
        ),
        ("R", t("final del perfil en Z", "end of the profile in Z"), 0.0),
        ("C", t("paso, en Z", "step, along Z"), design.blank.C),
        (
            "I",
            t("centro del arco en X desde el inicio, en radios", "arc centre in X from the start, on the radius"),
            0.0,
        ),
        ("K", t("centro del arco en Z desde el inicio: r", "arc centre in Z from the start: r"), r),
        ("L_b", t("longitud del bruto", "length of the stock"), design.blank.L_b),
    ];
    Table {
        key: "blank",
        name: t("Torno", "Blank"),
        title: t("Torneado del bruto: ciclo fijo G85", "Turning of the blank: canned cycle G85"),
        source: t("Sección 4.1 corregida (Z = −r)", "Section 4.1 corrected (Z = −r)"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::texts(t("parámetro", "parameter"), Law::None, rows.iter().map(|row| t(row.0, row.0)).collect()),
            Column::texts(t("significado", "meaning"), Law::None, rows.iter().map(|row| row.1.clone()).collect()),
            Column::numbers("value", MM, Law::None, rows.iter().map(|row| row.2).collect::<Vec<_>>())
                .named(t("valor", "value")),
        ],
    }
}

/// The blade in plan and in the meridian plane, for the charts.
#[must_use]
pub fn views(blade: &Blade) -> Table {
    let formulas = ["[annex-2.x]", "[annex-2.y]", "[annex-2.z]"];
    let mut columns = vectors(["x", "y", "z"], MM, Law::Told("P"), &blade.P, formulas);
    let rho: Vec<f64> = blade.v.iter().map(|&v| blade.circle.torus.rho(v)).collect();
    let rho = Column::numbers("ρ", MM, Law::Told("ρ = R + r·cos v"), rho);
    columns.insert(2, rho.by("torus_R+meridian_r*COS([annex-1.v])"));
    Table {
        key: "views",
        name: t("Vistas", "Views"),
        title: t("El álabe en planta y en el meridiano", "The blade in plan and in the meridian plane"),
        source: t("De los Anexos 1 y 2", "From annexes 1 and 2"),
        index: POINTS,
        print: Print::No,
        columns,
    }
}

/// The calibration: exact and small-angle R_B and B side by side, both roots of each.
///
/// `None` where the quadratic has no real root.
#[must_use]
pub fn calibration(slots: &Slots, nominal: f64) -> Option<(Table, Axis)> {
    let exact = slots.exact()?;
    let chosen = nearest(exact, nominal);
    let mut rows: Vec<(Text, bool, Axis)> = Vec::new();
    let mut add = |label: Text, solutions: [Axis; 2]| {
        let best = nearest(solutions, nominal);
        for solution in solutions {
            rows.push((label.clone(), solution == best, solution));
        }
    };
    add(t("exacta", "exact"), exact);
    if let Some(small) = slots.small_angle() {
        add(t("ángulo pequeño", "small angle"), small);
    }
    let number = |symbol, unit, law, value: fn(&(Text, bool, Axis)) -> f64| {
        Column::numbers(symbol, unit, law, rows.iter().map(value).collect::<Vec<_>>())
    };
    let table = Table {
        key: "calibration",
        // Not "Calibration" in English: the form has a sheet of that name, and case does not part two sheets.
        name: t("Calibración", "Calibration results"),
        title: t(
            "Calibración del eje B: forma exacta y de ángulo pequeño",
            "Calibration of the B axis: exact and small-angle form",
        ),
        source: t("Sección 5.2, ecuaciones (37) a (39) corregidas", "Section 5.2, equations (37) to (39) corrected"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::texts(t("forma", "form"), Law::None, rows.iter().map(|row| row.0.clone()).collect()),
            number("R_B", MM, Law::Told("2R_B² + 2(a+b)R_B + a² + b² − x0² − z0² = 0"), |row| row.2.R_B),
            number("B", RAD, Law::Told("−x0 = D·cos B − E·sin B, −z0 = D·sin B + E·cos B"), |row| row.2.B),
            number("B", Unit::Degree, Law::None, |row| row.2.B.to_degrees()).named(t("B (°)", "B (°)")),
            Column::texts(
                t("elegida", "chosen"),
                Law::None,
                rows.iter().map(|row| if row.1 { t("sí", "yes") } else { t("no", "no") }).collect(),
            ),
        ],
    };
    Some((table, chosen))
}
