//! What the live cells of both pipe workbooks share: the standard's sizes, looked up in a form as they are chosen. As in the form's
//! values, `3` and `40`, texts or numbers, are the size `3 in` and the schedule `Sch 40`.

use crate::kind::live_form::{LiveRow, Wrong};
use crate::kinds::pipe::size::SIZES;
use crate::table::Formula;
use crate::text::{Text, t};

/// The names of the cells of a pipe's size, and of what they come to.
pub(super) struct Names {
    size: &'static str,
    schedule: &'static str,
    diameter: &'static str,
    wall: &'static str,
    live: [&'static str; 2],
    /// The cell of the hidden sheet with the row of the size among [`sizes`], 0 for none.
    found: &'static str,
}

pub(super) const BRANCH: Names = Names {
    size: "branch_size",
    schedule: "branch_schedule",
    diameter: "branch_diameter_D",
    wall: "branch_wall_t",
    live: ["live_branch_D", "live_branch_t"],
    found: "Plan!$D$1",
};
pub(super) const HEADER: Names = Names {
    size: "header_size",
    schedule: "header_schedule",
    diameter: "header_diameter_D",
    wall: "header_wall_t",
    live: ["live_header_D", "live_header_t"],
    found: "Plan!$D$2",
};

impl Names {
    /// The key of the size that is chosen, as a formula in small letters: without the unit of its label.
    fn size_key(&self) -> String {
        format!("SUBSTITUTE(LOWER(TRIM({})),\" in\",\"\")", self.size)
    }

    /// The key of the schedule that is chosen, as a formula: without the word of its label.
    fn schedule_key(&self) -> String {
        format!("SUBSTITUTE(LOWER(TRIM({})),\"sch \",\"\")", self.schedule)
    }
}

/// The formula of the outside diameter of a pipe: the one that is typed, else that of the nominal size it was built with. Of another
/// size it is not known: #N/A, not a figure of before.
pub(super) fn diameter(pipe: &Names, D: f64) -> String {
    let of = |one: &&super::size::Size| same(one.outside, D);
    let named = SIZES.iter().filter(of).map(|one| format!("{}=\"{}\"", pipe.size_key(), one.nps));
    typed_or(pipe.diameter, named.collect(), D)
}

/// The same of the wall, by nominal size and schedule.
pub(super) fn thickness(pipe: &Names, [D, t]: [f64; 2]) -> String {
    let of = SIZES.iter().filter(|one| same(one.outside, D)).flat_map(|one| {
        let walls = one.walls.iter().filter(|(_, wall)| same(*wall, t));
        walls.map(|(schedule, _)| {
            let (size, key) = (pipe.size_key(), pipe.schedule_key());
            format!("AND({size}=\"{}\",{key}=\"{}\")", one.nps, schedule.to_lowercase())
        })
    });
    typed_or(pipe.wall, of.collect(), t)
}

fn typed_or(name: &str, named: Vec<String>, value: f64) -> String {
    let otherwise = match named.as_slice() {
        [] => "NA()".to_owned(),
        [one] => format!("IF({one},{value},NA())"),
        more => format!("IF(OR({}),{value},NA())", more.join(",")),
    };
    format!("IF(ISNUMBER({name}),{name},{otherwise})")
}

fn same(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9
}

/// Columns A to C of the hidden sheet: size and schedule by their keys, outside diameter, wall.
pub(super) fn sizes() -> [Vec<Formula>; 3] {
    let [mut words, mut diameters, mut walls] = [Vec::new(), Vec::new(), Vec::new()];
    for size in SIZES {
        for (schedule, wall) in size.walls {
            words.push(format!("\"{} / {}\"", size.nps, schedule.to_lowercase()).into());
            diameters.push(size.outside.to_string().into());
            walls.push(wall.to_string().into());
        }
    }
    [words, diameters, walls]
}

/// The first cells of column D: where branch and header stand among the sizes.
pub(super) fn found() -> Vec<Formula> {
    let found = |pipe: &Names| {
        let row = format!("MATCH({}&\" / \"&{},$A$1:$A${},0)", pipe.size_key(), pipe.schedule_key(), count());
        format!("IF(ISNUMBER({row}),{row},0)").into()
    };
    vec![found(&BRANCH), found(&HEADER)]
}

fn count() -> usize {
    SIZES.iter().map(|size| size.walls.len()).sum()
}

/// Diameter and wall of both pipes, with what is wrong with them.
pub(super) fn rows() -> Vec<LiveRow> {
    static MEANINGS: [[Text; 2]; 2] = [
        [
            t("Diámetro exterior del injerto", "Outside diameter of the branch"),
            t("Pared del injerto", "Wall of the branch"),
        ],
        [
            t("Diámetro exterior del tubo base", "Outside diameter of the header"),
            t("Pared del tubo base", "Wall of the header"),
        ],
    ];
    let [branch, header] = &MEANINGS;
    let mut rows = pipe(&BRANCH, ["D_branch", "t_branch"], branch);
    rows.extend(pipe(&HEADER, ["D_header", "t_header"], header));
    rows
}

/// A wall that leaves no bore: nothing is computed with it.
pub(super) fn thick(pipe: &Names) -> Wrong {
    let [D, thick] = pipe.live;
    let words = t("debe ser menor que el radio", "must be less than the radius");
    Wrong::new(format!("IF(ISNUMBER({D}),{thick}>={D}/2,FALSE)"), words, pipe.wall)
}

fn pipe(pipe: &Names, symbols: [&'static str; 2], meanings: &[Text; 2]) -> Vec<LiveRow> {
    let Names { size, schedule, diameter, wall, live: [D, own_t], found } = *pipe;
    let value = |column: char, typed: &str| {
        format!(
            "IF({found}>0,INDEX(Plan!${column}$1:${column}${},{found}),IF(AND(LEN(TRIM({size}))=0,LEN(TRIM({schedule}))=0,ISNUMBER({diameter}),ISNUMBER({wall})),{typed},\"\"))",
            count()
        )
    };
    let named = format!("AND(LEN(TRIM({size}))>0,LEN(TRIM({schedule}))>0)");
    let other = |typed: &str, own: &str| format!("IF(ISNUMBER({typed}),ABS({typed}-{own})>0.000000001,FALSE)");
    let [of_D, of_t] = meanings.clone();
    let Wrong { when, words, input } = thick(pipe);
    vec![
        LiveRow::length(symbols[0], D, of_D, value('B', diameter))
            .always()
            .wrong(
                format!("AND({named},{found}=0)"),
                t("la norma no tiene esa cédula en ese tamaño", "the standard has no such schedule in this size"),
                schedule,
            )
            .wrong(
                format!("AND(NOT({named}),NOT(ISNUMBER({D})))"),
                t("faltan tamaño y cédula, o D y t", "size and schedule are missing, or D and t"),
                size,
            )
            .wrong(
                format!("IF({found}>0,OR({},{}),FALSE)", other(diameter, D), other(wall, own_t)),
                t("D o t no es la del tamaño", "D or t is not that of the size"),
                diameter,
            ),
        LiveRow::length(symbols[1], own_t, of_t, value('C', wall)).always().wrong(when, words, input),
    ]
}
