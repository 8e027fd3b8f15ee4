//! The live forms of every kind, computed by LibreOffice: derived values as the engine's, limits told by their words.

use crate::common;
use crate::common::workbook::{Parts, written};
use crate::libreoffice::libreoffice;
use crate::live::{Book, cell_of, number, place_of, range, recalculated, with_on};

use calamine::Data;
use rodete::finding::Finding;
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::kinds::lathe::setup::Given;
use rodete::parameter::Value;
use rodete::parameter::field::Fields;
use rodete::table::Entry;
use rodete::text::Language;
use rodete::workbook::Filled;

/// What LibreOffice keeps of a number in its file.
const TOLERANCE: f64 = 1e-12;

pub fn kind_of(kind: &str) -> &'static dyn Kind {
    *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind")
}

pub fn form(kind: &str, case: &str, language: Language) -> Vec<u8> {
    let kind = kind_of(kind);
    written(kind, kind.cases().iter().find(|one| one.name == case).expect("a case"), language)
}

pub const fn sheet(language: Language) -> &'static str {
    match language {
        Language::Es => "DATOS",
        Language::En => "DATA",
    }
}

/// Number, text or nothing in the cell of an input.
pub fn typed(value: &str) -> String {
    if value.is_empty() {
        ">".to_owned()
    } else if value.parse::<f64>().is_ok() {
        format!("><v>{value}</v>")
    } else {
        format!(" t=\"inlineStr\"><is><t>{value}</t></is>")
    }
}

#[test]
fn every_form_of_a_sound_case_says_that_its_limits_hold_and_shows_what_the_engine_derives() {
    if !libreoffice() {
        return;
    }
    /// The symbols of derived values with the names of their cells in the forms.
    const SAME: [(&str, &str, &str); 13] = [
        ("pipe-insert", "r", "live_branch_r"),
        ("pipe-insert", "R", "live_header_R"),
        ("pipe-insert", "r_dev", "live_r_dev"),
        ("pipe-insert", "W", "live_W"),
        ("pipe-insert", "e_max", "live_e_max"),
        ("pipe-hole", "R_o", "live_R_o"),
        ("pipe-hole", "r", "live_hole_r"),
        ("pipe-hole", "h_s", "live_h_s"),
        ("pipe-hole", "sigma_0", "live_sigma_0"),
        ("impeller", "L", "live_L"),
        ("impeller", "k", "live_k"),
        ("impeller", "w", "live_w"),
        ("impeller", "N_max", "live_N_max"),
    ];
    let mut compared = 0;
    for language in Language::ALL {
        let folder = tempfile::tempdir().expect("a folder");
        let cases: Vec<_> = common::alternating(Language::En).filter(|(.., one)| *one == language).collect();
        let forms: Vec<(String, Vec<u8>)> = cases
            .iter()
            .enumerate()
            .map(|(at, (kind, case, language))| (format!("form-{at}"), written(*kind, case, *language)))
            .collect();
        let books = recalculated(folder.path(), language == Language::Es, &forms);
        for (((kind, case, _), (_, form)), mut book) in cases.into_iter().zip(&forms).zip(books) {
            let data = range(&mut book, sheet(language));
            let told = data.get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
            assert!(told.contains("rodete check") && !told.contains("valid"), "{}: {told}", case.name);
            assert!(
                !data
                    .used_cells()
                    .any(|(.., cell)| ["celdas rojas", "red cells"].iter().any(|red| cell.to_string().contains(red)))
            );
            let outcome = common::shipped(kind, case, language);
            for (of, symbol, name) in SAME.iter().filter(|(of, ..)| *of == kind.form().kind) {
                let value = outcome.quantities.iter().find(|one| one.symbol == *symbol).expect("a quantity").value;
                let there = number(data.get_value(place_of(&cell_of(form, name)))).expect("a number");
                assert!((there - value).abs() <= TOLERANCE * value.abs().max(1.0), "{of} {symbol}: {value}, {there}");
                compared += 1;
            }
            // What the formulas ask of all inputs is out of sight.
            let answers = data.used_cells().any(|(.., cell)| cell.to_string().starts_with("live_"));
            assert!(!answers, "{}: a name of a cell", case.name);
            // Every point of the view is a number within it, and something is drawn.
            let plan = range(&mut book, "Plan");
            let points: Vec<f64> = plan.used_cells().filter_map(|(.., cell)| number_or_none(cell)).collect();
            assert!(points.len() > 100, "{}: {} points", case.name, points.len());
            assert!(!plan.used_cells().any(|(.., cell)| matches!(cell, Data::Error(_))), "{}: an error", case.name);
        }
    }
    assert!(compared >= 30, "{compared} values only");
}

fn number_or_none(cell: &Data) -> Option<f64> {
    if let Data::Float(value) = cell { Some(*value) } else { None }
}

/// A kind and its case, what is typed into its form, the words that tell it in English and Spanish, and the code of the stop with
/// which `rodete check` rejects it.
type Broken = (&'static str, &'static str, &'static [(&'static str, &'static str)], [&'static str; 2], &'static str);

const BROKEN: [Broken; 65] = [
    ("impeller", "full", &[("B_min", "120")], ["the minimum is not below", "el mínimo no es menor"], "P1010"),
    ("impeller", "full", &[("Y_min", "10"), ("Y_max", "5")], ["the minimum is not", "el mínimo no es"], "P1010"),
    ("impeller", "full", &[("blank_length_L_b", "10")], ["L_b must be larger", "L_b debe ser mayor"], "P1014"),
    ("impeller", "full", &[("blank_end_X_e", "40")], ["is inside the stock", "está dentro del bruto"], "P1015"),
    ("impeller", "full", &[("blank_step_C", "15.5")], ["must not exceed r", "no puede pasar de r"], "P1016"),
    ("impeller", "full", &[("feed_F", "")], ["full needs it", "style = completo lo necesita"], "P0101"),
    ("impeller", "full", &[("speed_S", "")], ["full needs it", "style = completo lo necesita"], "P0101"),
    ("impeller", "full", &[("feed_limit_F_max", "100")], ["above F_max", "pasa de F_max"], "P1011"),
    ("impeller", "full", &[("distance", "G90")], ["G90 with rollover", "G90 y ejes rollover"], "P1012"),
    ("impeller", "full", &[("distance", "G90"), ("rotary_axes", "")], ["G90 with", "con G90"], "P1012"),
    ("impeller", "full", &[("splitters", "")], ["no numbers: 1 (splitters)", "no son números: 1 (splitters)"], "W0403"),
    ("impeller", "full", &[("part", "")], ["no numbers: 1 (part)", "no son números: 1 (part)"], "W0403"),
    ("impeller", "full", &[("method", "bogus")], ["): not one of the list", "): no es de la lista"], "W0414"),
    ("impeller", "full", &[("start_codes", "M3 hello")], ["): codes", "): códigos"], "W0416"),
    ("impeller", "full", &[("start_codes", "M3M4")], ["): codes", "): códigos"], "W0416"),
    ("impeller", "full", &[("end_codes", "M30 G12345")], ["): codes", "): códigos"], "W0416"),
    ("impeller", "full", &[("retract", "G1 X")], ["): one block", "): un bloque"], "W0417"),
    ("impeller", "full", &[("end_codes", "M9")], ["must be M2 or M30", "debe ser M2 o M30"], "C1005"),
    ("impeller", "full", &[("end_codes", "M30 M9")], ["must be M2 or M30", "debe ser M2 o M30"], "C1005"),
    ("impeller", "full", &[("start_codes", "M3 M030")], ["end the program there", "terminan ahí"], "C1004"),
    ("impeller", "full", &[("start_codes", "M3 M4")], ["M3 or M4 alone", "solo M3 o M4"], "C1009"),
    ("impeller", "full", &[("coolant", "M8 M05")], ["are of the spindle", "mueven el husillo"], "C1009"),
    ("impeller", "full", &[("retract", "G1 G53 Z0")], ["does not belong there", "no va ahí"], "C1006"),
    (
        "impeller",
        "full",
        &[("dialect", "fagor-8070"), ("retract", "G0 G53 Z0")],
        ["does not belong there", "no va ahí"],
        "C1006",
    ),
    ("impeller", "full", &[("retract", "G0 G53 X0")], ["axes, but not Z", "ejes, pero no Z"], "C1007"),
    ("impeller", "full", &[("retract", "G0 Z100")], ["G53 is missing", "falta G53"], "C1008"),
    ("pipe-insert", "square", &[("end_codes", "M5")], ["must be M2 or M30", "debe ser M2 o M30"], "C1005"),
    ("pipe-insert", "square", &[("end_codes", "M03 M30")], ["turns the torch on", "enciende la antorcha"], "P2008"),
    ("pipe-insert", "square", &[("torch_on", "M3 M5")], ["stands in torch_off", "en torch_off"], "P200"),
    (
        "pipe-insert",
        "square",
        &[("torch_on", "M3 M5"), ("torch_off", "M9")],
        ["turns the torch off", "apaga la antorcha"],
        "P2007",
    ),
    ("pipe-insert", "square", &[("torch_off", "M4")], ["M3 and M4 turn", "M3 y M4 encienden"], "P2007"),
    (
        "pipe-insert",
        "square",
        &[("torch_on", "M3 M07"), ("torch_off", "M5 M7")],
        ["stands in torch_off", "en torch_off"],
        "P2006",
    ),
    ("pipe-hole", "", &[("hold_on", "M62"), ("hold_off", "M062")], ["stands in hold_off", "en hold_off"], "P2006"),
    (
        "pipe-hole",
        "",
        &[("torch_on", "M64"), ("end_codes", "M64 M30")],
        ["turns the torch on", "enciende la antorcha"],
        "P2008",
    ),
    ("impeller", "clear", &[("finish_diameter_d_f", "7")], ["larger than that for", "mayor que la de"], "P1"),
    ("impeller", "clear", &[("style", "annex")], ["clear needs style", "canal necesita style"], "P1"),
    ("lathe", "shaft", &[("body_BX_min", "5"), ("body_BX_max", "1")], ["is not below", "no es menor"], "P4005"),
    ("lathe", "shaft", &[("body_BX_min", "5")], ["all four sizes", "sus cuatro medidas"], "P4006"),
    ("lathe", "shaft", &[("turret", "")], ["no numbers: 1 (turret)", "no son números: 1 (turret)"], "W0403"),
    ("lathe", "shaft", &[("dialect", "x")], ["): not one of the list", "): no es de la lista"], "W0414"),
    ("lathe", "shaft", &[("hole_R", "60")], ["): not one of the list", "): no es de la lista"], "W0414"),
    (
        "pipe-insert",
        "square",
        &[("kerf", "20"), ("branch_size", "1/2 in"), ("branch_schedule", "Sch 40")],
        ["larger than the inside radius", "mayor que el radio interior"],
        "P2116",
    ),
    ("pipe-hole", "", &[("hold_on", "M10")], ["hold_on needs", "con hold_on va"], "P3008"),
    ("pipe-insert", "square", &[("contact", "")], ["no numbers: 1 (contact)", "no son números: 1 (contact)"], "W0403"),
    ("impeller", "", &[("thickness_e", "11")], ["narrower than the tool", "más estrecha que la herramienta"], "P1206"),
    ("impeller", "tfg-2021", &[("torus_R", "x")], ["no numbers: 1", "no son números: 1"], "W0"),
    ("pipe-hole", "", &[("groove_gamma", ""), ("height_d0", "x")], ["no numbers: 2", "no son números: 2"], "W0"),
    ("lathe", "shaft", &[("stock_D", "")], ["no numbers: 1", "no son números: 1"], "W0"),
    ("lathe", "shaft", &[("stock_D", "x"), ("held_L4", "x")], ["no numbers: 2", "no son números: 2"], "W0"),
    ("pipe-insert", "square", &[("branch_schedule", "")], ["are missing", "faltan"], "P2003"),
    (
        "pipe-insert",
        "square",
        &[("branch_size", "1/8 in"), ("branch_schedule", "Sch 160")],
        ["no such schedule", "no tiene esa cédula"],
        "P2001",
    ),
    ("pipe-insert", "square", &[("branch_diameter_D", "90")], ["not that of the size", "no es la del tamaño"], "P2002"),
    (
        "pipe-insert",
        "square",
        &[("header_size", "2 in")],
        ["larger than the header", "mayor que el tubo base"],
        "P2101",
    ),
    (
        "pipe-insert",
        "square",
        &[("expert_branch_r", "38")],
        ["the envelope takes no r", "la envolvente no lleva r"],
        "P2114",
    ),
    ("pipe-insert", "square", &[("eccentricity_e", "30")], ["the branch overhangs", "el injerto sobresale"], "P2102"),
    ("pipe-insert", "square", &[("feed_F", "")], ["full needs F", "style = completo necesita F"], "P0101"),
    ("pipe-insert", "square", &[("style", "annex")], ["on flat sheet", "en chapa plana"], "P2104"),
    ("pipe-hole", "", &[("land_h", "90")], ["less than the wall", "menor que la pared"], "P3001"),
    ("pipe-hole", "", &[("branch_size", "6 in")], ["does not fit", "no cabe"], "P3002"),
    (
        "pipe-hole",
        "",
        &[("least_gap_g0", "50"), ("greatest_height_D_max", "500")],
        ["less than d0", "menor que d0"],
        "P3003",
    ),
    (
        "pipe-hole",
        "",
        &[("nozzle_r_g", "100"), ("torch_body_radius", "90")],
        ["thinner than the tip", "más fino que la punta"],
        "P3004",
    ),
    ("pipe-hole", "", &[("kerf", "1")], ["finer than the beam", "más fino que el chorro"], "P3006"),
    ("pipe-hole", "", &[("lead_in", "200")], ["reaches past", "pasa del eje"], "P3007"),
    (
        "pipe-hole",
        "",
        &[("groove_gamma", "45"), ("greatest_height_D_max", "8")],
        ["γ is too large", "γ es demasiado grande"],
        "P3009",
    ),
    ("lathe", "shaft", &[("held_L4", "400"), ("stock_L", "300")], ["less than L", "menor que L"], ""),
];

/// The stops behind which there is no curve to draw.
const UNDRAWN: [&str; 7] = ["W0", "P2001", "P2003", "P2101", "P2102", "P3001", "P3002"];

#[test]
fn a_form_says_what_is_wrong_where_the_engine_rejects_it() {
    if !libreoffice() {
        return;
    }
    for language in Language::ALL {
        let folder = tempfile::tempdir().expect("a folder");
        let books: Vec<(String, Vec<u8>)> = BROKEN
            .iter()
            .enumerate()
            .map(|(number, (kind, case, changes, ..))| {
                let case = if case.is_empty() { kind_of(kind).cases()[0].name } else { case };
                let bytes = form(kind, case, language);
                let change = |bytes: Vec<u8>, (name, value): &(&str, &str)| {
                    let cell = cell_of(&bytes, name);
                    with_on(&bytes, sheet(language), &cell, &typed(value))
                };
                (format!("broken-{number}"), changes.iter().fold(bytes, change))
            })
            .collect();
        // Within the time that one call of LibreOffice has.
        let some = books.chunks(24).flat_map(|some| recalculated(folder.path(), language == Language::Es, some));
        let computed: Vec<Book> = some.collect();
        for (((kind, _, changes, words, code), (_, bytes)), mut book) in BROKEN.iter().zip(&books).zip(computed) {
            let data = range(&mut book, sheet(language));
            let told = data.get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
            assert!(!told.contains("rodete check"), "{kind} {changes:?}: {told}");
            let wanted = words[usize::from(language == Language::Es)];
            // The line in sight tells it, or another fault and how many more there are.
            assert!(told.contains(wanted) || told.contains(" (+"), "{kind} {changes:?}: {wanted} is not in: {told}");
            let seen = data.used_cells().any(|(.., cell)| cell.to_string().contains(wanted));
            assert!(seen, "{kind} {changes:?}: {wanted} is nowhere");
            let nothing = data.used_cells().any(|(.., cell)| {
                ["Nothing to draw: see", "Nada que dibujar: vea"].iter().any(|told| cell.to_string().starts_with(told))
            });
            assert_eq!(nothing, UNDRAWN.contains(code), "{kind} {changes:?}");
            let plan = range(&mut book, "Plan");
            let wrong = |cell: &Data| matches!(cell, Data::Error(_)) || cell.to_string().starts_with('#');
            let ranges = range(&mut book, "Ranges");
            let mut all = data.used_cells().chain(plan.used_cells()).chain(ranges.used_cells());
            let wrong = all.find(|(.., cell)| wrong(cell));
            assert_eq!(wrong, None, "{kind} {changes:?}: an error in a cell");
            // The engine says the same.
            let read = rodete::workbook::read(bytes, &[kind_of(kind).form()]);
            let run = |filled: Filled| rodete::kinds::run(filled.form, filled.values, common::source());
            let findings = match read.and_then(run) {
                Err(refusal) => refusal.findings,
                Ok(outcome) => outcome.findings,
            };
            let codes: Vec<&str> = findings.iter().map(Finding::code).collect();
            assert!(codes.iter().any(|one| one.starts_with(code)) || code.is_empty(), "{kind} {changes:?}: {codes:?}");
        }
    }
}

/// The formulas by which a cell turns green.
fn green(parts: &Parts, cell: (u32, u32)) -> Vec<String> {
    let styles = parts.text("xl/styles.xml");
    let greens: Vec<usize> = styles
        .split("<dxf>")
        .skip(1)
        .enumerate()
        .filter(|(_, one)| one.contains("FF1E5B22"))
        .map(|(at, _)| at)
        .collect();
    assert!(!greens.is_empty(), "no green");
    let sheet = parts.text("xl/worksheets/sheet1.xml");
    let formulas = sheet.split("<conditionalFormatting sqref=\"").skip(1).filter_map(|one| {
        let (range, rest) = one.split_once('"')?;
        let (first, last) = range.split_once(':').unwrap_or((range, range));
        let ((top, left), (bottom, right)) = (place_of(first), place_of(last));
        let inside = (top..=bottom).contains(&cell.0) && (left..=right).contains(&cell.1);
        Some(rest.split("<cfRule").skip(1).filter(move |_| inside).collect::<Vec<_>>())
    });
    let of = |rule: &str| {
        let dxf = rule.split("dxfId=\"").nth(1)?.split('"').next()?.parse::<usize>().ok()?;
        let formula = rule.split("<formula>").nth(1)?.split("</formula>").next()?;
        greens.contains(&dxf).then(|| formula.to_owned())
    };
    formulas.flatten().filter_map(of).collect()
}

/// Under `method = clear` the published limits decide nothing, and no formula knows whether the tools pass.
#[test]
fn the_limits_of_the_published_method_are_never_green_where_the_part_is_cut_clear() {
    if !libreoffice() {
        return;
    }
    const LIMITS: [&str; 4] = ["live_gap", "live_N_max", "live_e_max", "live_reach"];
    for language in Language::ALL {
        let folder = tempfile::tempdir().expect("a folder");
        let plain = form("impeller", "clear", language);
        let parts = Parts::of(&plain);
        let mut rules: Vec<String> = green(&parts, (0, 2));
        for name in LIMITS {
            rules.extend(green(&parts, place_of(&cell_of(&plain, name))));
        }
        assert_eq!(rules.len(), 1 + LIMITS.len(), "{rules:?}");
        // What decides on green is written over the units, so that LibreOffice computes it.
        let written = |changes: &[(&str, &str)]| {
            let first = place_of(&cell_of(&plain, "torus_R")).0;
            let asked = rules.iter().enumerate().fold(plain.clone(), |book, (at, rule)| {
                let row = first + 1 + u32::try_from(at).expect("a row");
                with_on(&book, sheet(language), &format!("D{row}"), &format!("><f>{rule}</f>"))
            });
            changes.iter().fold(asked, |book, (name, value)| {
                with_on(&book, sheet(language), &cell_of(&plain, name), &typed(value))
            })
        };
        let books = [
            ("clear".to_owned(), written(&[])),
            ("thick".to_owned(), written(&[("thickness_e", "3")])),
            ("published".to_owned(), written(&[("method", "published")])),
        ];
        let mut computed = recalculated(folder.path(), language == Language::Es, &books);
        let mut greens = |at: usize| -> Vec<bool> {
            let data = range(&mut computed[at], sheet(language));
            let first = place_of(&cell_of(&plain, "torus_R")).0;
            let of = |row: u32| match data.get_value((first + row, 3)) {
                Some(Data::Bool(green)) => *green,
                other => panic!("{other:?}"),
            };
            (0..u32::try_from(rules.len()).expect("a count")).map(of).collect()
        };
        assert_eq!(greens(0), vec![false; rules.len()], "clear");
        assert_eq!(greens(1), vec![false; rules.len()], "clear, and rejected");
        assert_eq!(greens(2), vec![true; rules.len()], "published");
    }
    let thick = common::values("clear", &[("e", Value::Real(3.0))]);
    let Err(refusal) = rodete::kinds::run(kind_of("impeller").form(), thick, common::source()) else {
        panic!("not rejected")
    };
    let codes: Vec<_> = refusal.findings.iter().map(Finding::code).collect();
    assert_eq!(codes, ["P1206"]);
}

#[test]
fn the_sizes_of_a_form_are_those_of_the_standard() {
    let parts = Parts::of(&form("pipe-hole", kind_of("pipe-hole").cases()[0].name, Language::En));
    let plan = (1..9)
        .map(|at| format!("xl/worksheets/sheet{at}.xml"))
        .filter(|part| parts.has(part))
        .map(|part| parts.text(&part))
        .find(|text| text.contains(" / 160"))
        .expect("the hidden sheet");
    for (nps, schedule) in [("3", "40"), ("48", "XS"), ("1/8", "10"), ("1-1/2", "XXS")] {
        let (outside, wall) = rodete::kinds::pipe::size::wall(nps, schedule).expect("a pipe");
        let row = plan
            .split("<row ")
            .find(|row| row.contains(&format!("\"{nps} / {}\"", schedule.to_lowercase())))
            .expect("its row");
        assert!(row.contains(&format!("<f>{outside}</f>")) && row.contains(&format!("<f>{wall}</f>")), "{row}");
    }
}

/// A branch and a hole that are neither square nor centred: what the forms draw is what the engine computes.
#[test]
fn the_views_of_the_pipes_are_the_curves_of_the_engine() {
    if !libreoffice() {
        return;
    }
    let changes = [
        ("theta", "angle_theta", Value::Real(61.5)),
        ("e", "eccentricity_e", Value::Real(7.25)),
        ("kerf", "kerf", Value::Real(2.0)),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let books: Vec<(String, Vec<u8>)> = ["pipe-insert", "pipe-hole"]
        .into_iter()
        .map(|kind| {
            let bytes = form(kind, kind_of(kind).cases()[0].name, Language::En);
            let change = |bytes: Vec<u8>, (_, name, value): &(&str, &str, Value)| {
                let Value::Real(value) = value else { panic!("{name}") };
                with_on(&bytes, "DATA", &cell_of(&bytes, name), &typed(&value.to_string()))
            };
            (kind.to_owned(), changes.iter().fold(bytes, change))
        })
        .collect();
    let own = |points: u32| -> Vec<(&'static str, Value)> {
        let changes = changes.iter().map(|(key, _, value)| (*key, value.clone()));
        changes.chain([("N", Value::Whole(points))]).collect()
    };
    let mut computed = recalculated(folder.path(), false, &books);
    let column = |book: &mut Book, column: u32, count: usize| -> Vec<f64> {
        let plan = range(book, "Plan");
        (0..u32::try_from(count).expect("a row"))
            .map(|row| number(plan.get_value((row, column))).expect("a number"))
            .collect()
    };
    let of = |kind: &str, points: u32| {
        let kind = kind_of(kind);
        common::outcome_of(kind, &kind.cases()[0], Language::En, &own(points))
    };
    let values = |outcome: &rodete::kind::Outcome, table: &str, symbol: &str| -> Vec<f64> {
        let column = outcome.table(table).and_then(|table| table.column(symbol)).expect("a column");
        let value = |row| match column.values.get(row) {
            Entry::Number(value) => value,
            Entry::Text(_) => panic!("{symbol}"),
        };
        (0..column.values.len()).map(value).collect()
    };
    let close = |one: &[f64], other: &[f64], what: &str| {
        assert_eq!(one.len(), other.len(), "{what}");
        for (one, other) in one.iter().zip(other) {
            assert!((one - other).abs() <= 1e-11 * other.abs().max(1.0), "{what}: {one}, {other}");
        }
    };
    // The y of the branch's curve stands in column F.
    let branch = of("pipe-insert", 120);
    close(&column(&mut computed[0], 5, 121), &values(&branch, "template", "y"), "y");
    // The height of the torch stands in column Q, the foot of its axis is reached without the kerf: the same angle, to less than
    // a tenth of a millimetre.
    let hole = of("pipe-hole", 96);
    let (drawn, told) = (column(&mut computed[1], 16, 97), values(&hole, "height", "D"));
    for (drawn, told) in drawn.iter().zip(&told) {
        assert!((drawn - told).abs() < 0.1, "{drawn}, {told}");
    }
    // The root stands in columns F, G and H.
    for (at, symbol) in [(7, "x"), (5, "y"), (6, "z")] {
        close(&column(&mut computed[1], at, 97), &values(&hole, "curve", symbol), symbol);
    }
    // The direction of the torch stands in columns K to M.
    for (at, symbol) in [(10, "a_x"), (11, "a_y"), (12, "a_z")] {
        close(&column(&mut computed[1], at, 97), &values(&hole, "pose", symbol), symbol);
    }
}

/// The turret at its reference point and the tips of its tools, for both sides of the axis: as the simulation has them.
#[test]
fn the_plan_of_a_lathe_has_turret_and_tools_where_the_simulation_has_them() {
    if !libreoffice() {
        return;
    }
    let cases: [&[(&str, &str)]; 3] = [
        &[],
        &[("turret", "rear"), ("stock_L", "260"), ("travel_Z_max", "455")],
        &[("reference_R_X", "310"), ("reference_R_Z", "620"), ("held_L4", "25.5"), ("facing_L5", "2.5")],
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let books: Vec<(String, Vec<u8>)> = cases
        .iter()
        .enumerate()
        .map(|(at, changes)| {
            let change = |bytes: Vec<u8>, (name, value): &(&str, &str)| {
                with_on(&bytes, "DATA", &cell_of(&bytes, name), &typed(value))
            };
            (format!("lathe-{at}"), changes.iter().fold(form("lathe", "shaft", Language::En), change))
        })
        .collect();
    for ((_, bytes), mut book) in books.iter().zip(recalculated(folder.path(), false, &books)) {
        let filled = rodete::workbook::read(bytes, &[kind_of("lathe").form()]).expect("a sound form");
        let fields = Fields::of(filled.form, filled.values).expect("all that the form requires");
        let given = Given::of(&fields).expect("a lathe");
        let [x, z] = given.reference();
        let data = range(&mut book, "DATA");
        let shown = |name: &str| number(data.get_value(place_of(&cell_of(bytes, name)))).expect("a number");
        let lathe = &given.setup.lathe;
        for (name, value) in [
            ("live_stick_out", given.setup.stock.overhang),
            ("live_Z_W1", given.setup.stock.zero(lathe)),
            ("live_reference_X", 2.0 * x),
            ("live_reference_Z", z),
            ("live_tools", f64::from(u32::try_from(given.setup.turret.tools.len()).expect("a count"))),
        ] {
            assert!((shown(name) - value).abs() < 1e-9, "{name}: {value}, {}", shown(name));
        }
        // Eight points a place in columns P and Q; the fourth and the fifth are the corners at the tip.
        let plan = range(&mut book, "Plan");
        let side = if lathe.turret_behind { 1.0 } else { -1.0 };
        for (place, tool) in &given.setup.turret.tools {
            let point = |corner: u32, column: u32| {
                number(plan.get_value((8 * (place - 1) + corner, column))).expect("a number")
            };
            let tip = [15, 16].map(|column| f64::midpoint(point(3, column), point(4, column)));
            let wanted = [z - tool.overhang[1], side * (x - tool.overhang[0])];
            assert!(
                tip.iter().zip(wanted).all(|(one, other)| (one - other).abs() < 1e-9),
                "{place}: {tip:?}, {wanted:?}"
            );
        }
    }
}

/// A text in a cell, blanks and all.
pub fn text(text: &str) -> String {
    format!(" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is>")
}

/// The code of the stop with which `rodete check` rejects a form; none where it takes it.
fn rejected(bytes: &[u8], kind: &str) -> Option<&'static str> {
    let read = rodete::workbook::read(bytes, &[kind_of(kind).form()]);
    let run = |filled: Filled| rodete::kinds::run(filled.form, filled.values, common::source());
    match read.and_then(run) {
        Err(refusal) => Some(refusal.findings.first().map_or("", Finding::code)),
        Ok(_) => None,
    }
}

/// Words as a number, as a text, with blanks about them, in capitals: the form and `check` take the same ones.
#[test]
fn a_form_takes_the_words_that_check_takes_and_no_others() {
    if !libreoffice() {
        return;
    }
    let number = |number: &str| format!("><v>{number}</v>");
    let sizes = |names: [&'static str; 2], size: String, schedule: String| {
        names.into_iter().zip([size, schedule]).collect::<Vec<_>>()
    };
    let (branch, header) = (["branch_size", "branch_schedule"], ["header_size", "header_schedule"]);
    let cases = vec![
        ("pipe-insert", "square", sizes(branch, number("3"), number("40")), true),
        ("pipe-insert", "square", sizes(header, number("4"), number("40")), true),
        ("pipe-hole", "set-in", sizes(branch, number("3"), number("40")), true),
        ("pipe-hole", "set-in", sizes(header, text("6"), number("40")), true),
        ("pipe-insert", "square", sizes(branch, text("3"), text("40")), true),
        ("pipe-insert", "square", sizes(branch, text(" 3 in "), text(" sch 40")), true),
        ("pipe-insert", "square", sizes(branch, text("3 IN"), text("xs ")), true),
        ("pipe-insert", "square", sizes(branch, text(" 3  in"), text("Sch 40")), false),
        ("pipe-insert", "square", sizes(branch, text("3in"), text("Sch 40")), false),
        ("pipe-insert", "square", sizes(branch, number("3"), number("41")), false),
        ("pipe-insert", "square", sizes(branch, number("0.5"), number("40")), false),
        ("pipe-insert", "square", vec![("style", text(" full ")), ("feed_F", ">".to_owned())], false),
        ("impeller", "clear", vec![("method", text(" clear"))], true),
        ("impeller", "clear", vec![("start_codes", text("M3\nm11 M13"))], true),
        ("impeller", "clear", vec![("end_codes", text("M9 m02"))], true),
        ("impeller", "clear", vec![("retract", text("g00 g53\nz0 M9"))], true),
        ("impeller", "clear", vec![("retract", text("G0 G53 G90 Z0"))], true),
        ("impeller", "clear", vec![("title_date", text("31/12/26"))], true),
        ("pipe-insert", "square", vec![("torch_on", text("M3 M7")), ("end_codes", text("M7 M30"))], true),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let books: Vec<(String, Vec<u8>)> = cases
        .iter()
        .enumerate()
        .map(|(at, (kind, case, changes, _))| {
            let change =
                |bytes: Vec<u8>, (name, inner): &(&str, String)| with_on(&bytes, "DATA", &cell_of(&bytes, name), inner);
            (format!("words-{at}"), changes.iter().fold(form(kind, case, Language::En), change))
        })
        .collect();
    for ((kind, _, changes, taken), ((_, bytes), mut book)) in
        cases.iter().zip(books.iter().zip(recalculated(folder.path(), false, &books)))
    {
        let told = range(&mut book, "DATA").get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
        assert_eq!(rejected(bytes, kind).is_none(), *taken, "{kind} {changes:?}: {:?}", rejected(bytes, kind));
        assert_eq!(told.contains("rodete check"), *taken, "{kind} {changes:?}: {told}");
        assert_eq!(told.starts_with("method = clear:"), *kind == "impeller", "{changes:?}: {told}");
    }
}

/// What one wrong number is called, and what a number of a list is.
#[test]
fn a_form_names_the_number_that_is_outside_its_range() {
    if !libreoffice() {
        return;
    }
    const CASES: [(&str, &str, &str, &str); 8] = [
        ("impeller", "blades_N", "0", "N (#): outside the allowed range (whole number, 1 to 60)"),
        ("impeller", "blades_N", "3.5", "N (#): outside the allowed range (whole number, 1 to 60)"),
        ("impeller", "thickness_e", "-1", "e (#): outside the allowed range ("),
        ("impeller", "depth_a_p", "20", "a_p (#): a_p must be less than R − r"),
        ("impeller", "safety_d_s", "0.1", "d_s (#): d_s is too small"),
        ("impeller", "height_H", "0", "H (#): "),
        ("lathe", "TOOLS", "9", "TOOLS, T: outside the allowed range (whole number, 1 to 8)"),
        ("lathe", "TOOLS", "1.5", "TOOLS, T: outside the allowed range (whole number, 1 to 8)"),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let books: Vec<(String, Vec<u8>)> = CASES
        .iter()
        .enumerate()
        .map(|(at, (kind, name, value, _))| {
            let case = if *kind == "lathe" { "shaft" } else { "tfg-2021" };
            let bytes = form(kind, case, Language::En);
            let changed = match *name {
                "TOOLS" => with_on(&bytes, name, "A6", &typed(value)),
                _ => with_on(&bytes, "DATA", &cell_of(&bytes, name), &typed(value)),
            };
            (format!("named-{at}"), changed)
        })
        .collect();
    let computed = recalculated(folder.path(), false, &books);
    for ((kind, name, value, words), ((_, bytes), mut book)) in CASES.iter().zip(books.iter().zip(computed)) {
        let said = range(&mut book, "DATA").get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
        // With the cell where it is typed.
        let words = if words.contains('#') { words.replace('#', &cell_of(bytes, name)) } else { (*words).to_owned() };
        assert!(said.starts_with(&words), "{kind} {name} = {value}: {said}");
    }
    let parts = Parts::of(&books[3].1);
    let cell = cell_of(&books[3].1, "depth_a_p");
    let rule = "IF(live_given,depth_a_p&gt;=torus_R-meridian_r,FALSE)";
    let ruled = parts.text("xl/worksheets/sheet1.xml");
    let of = ruled.split("<conditionalFormatting sqref=\"").filter(|one| one.contains(rule));
    assert!(of.clone().count() == 1 && of.clone().all(|one| one.starts_with(&cell)), "the culprit turns red");
}
