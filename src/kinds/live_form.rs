//! What the live forms of several kinds say alike.

use crate::gcode::code::G;
use crate::gcode::control::{Control, MILLING};
use crate::gcode::program::Style;
use crate::kind::live_form::{LiveRow, holds, parted, says};
use crate::table::Unit;
use crate::text::{Text, t};

/// The controls that do not move at feed without F.
fn needing_feed() -> impl Iterator<Item = &'static Control> {
    MILLING.into_iter().filter(|control| control.feed.missing.refused())
}

/// The row of the style, with the limit that programs as they are published have no feed: not every control moves without one.
pub(crate) fn feed_needed(style: LiveRow) -> LiveRow {
    needing_feed().fold(style, |row, control| {
        row.wrong(
            format!("AND({},{})", holds("style", Style::Annex), says("dialect", control.name)),
            Text::new(
                format!("anexo no lleva avance, y {} lo necesita", control.name),
                format!("annex has no feed, and {} needs one", control.name),
            ),
            "style",
        )
    })
}

/// The codes of a cell as a formula: in capitals, one blank between them, without zeros before the numbers of those with a letter.
/// Code 0 is the letter alone there.
fn bare(cell: &str, letter: char) -> String {
    // A number has four figures at most.
    (0..3).fold(format!("UPPER(TRIM({}))", parted(cell)), |text, _| {
        format!("SUBSTITUTE({text},\"{letter}0\",\"{letter}\")")
    })
}

/// The same with a blank on both sides of each code.
fn spaced(cell: &str, letter: char) -> String {
    format!("\" \"&SUBSTITUTE({},\" \",\"  \")&\" \"", bare(cell, letter))
}

/// True as a formula where one of some M codes stands in a cell.
fn has(cell: &str, numbers: &[u32]) -> String {
    let codes = spaced(cell, 'M');
    let one = |number: &u32| format!("ISNUMBER(FIND(\" M{number} \",{codes}))");
    format!("OR({})", numbers.iter().map(one).collect::<Vec<_>>().join(","))
}

/// True as a formula where an M code of a cell, but for some numbers as they stand behind the bare letter, stands in another as well.
fn share(cell: &str, other: &str, except: &[&str]) -> String {
    // A code takes three signs with its blank, and a cell has 200.
    let word = format!("TRIM(MID(SUBSTITUTE({},\" \",REPT(\" \",200)),200*ROW($A$1:$A$70)-199,200))", bare(cell, 'M'));
    let but: String = except.iter().map(|number| format!("*({word}<>\"M{number}\")")).collect();
    // Two blanks, as about no word, stand in an empty cell alone.
    format!(
        "AND(LEN(TRIM({other}))>0,SUMPRODUCT(1*ISNUMBER(FIND(\" \"&{word}&\" \",\" \"&{}&\" \")){but})>0)",
        bare(other, 'M')
    )
}

/// The row of the machine codes of a form with `end_codes` and with lists of codes that stand before the end.
pub(crate) fn machine_codes(lists: &[&'static str]) -> LiveRow {
    let end = spaced("end_codes", 'M');
    let row = LiveRow::length("M", "live_codes", t("Códigos al terminar", "Codes at the end"), "end_codes&\"\"")
        .always()
        .unit(Unit::None)
        .wrong(
            format!("AND(LEN(TRIM(end_codes))>0,RIGHT({end},4)<>\" M2 \",RIGHT({end},5)<>\" M30 \")"),
            t("el último código debe ser M2 o M30", "the last code must be M2 or M30"),
            "end_codes",
        );
    lists.iter().fold(row, |row, list| {
        let words = t("M2 y M30 terminan ahí el programa", "M2 and M30 end the program there");
        row.wrong(has(list, &[2, 30]), words, list)
    })
}

/// The row of the codes of a mill's form: its spindle is started by `start_codes`.
pub(crate) fn mill_codes() -> LiveRow {
    machine_codes(&["start_codes", "coolant"])
        .wrong(
            format!(
                "OR({},AND({},{}))",
                has("start_codes", &[5, 19]),
                has("start_codes", &[3]),
                has("start_codes", &[4])
            ),
            t("del husillo, solo M3 o M4, una vez", "of the spindle, M3 or M4 alone, once"),
            "start_codes",
        )
        .wrong(
            has("coolant", &[3, 4, 5, 19]),
            t("M3, M4, M5 y M19 mueven el husillo", "M3, M4, M5 and M19 are of the spindle"),
            "coolant",
        )
}

/// The rows of the codes of a torch's form, with what it has besides `torch_on`, `torch_off` and `end_codes`.
pub(crate) fn torch_codes(others: &[&'static str]) -> Vec<LiveRow> {
    let lists: Vec<&'static str> = ["torch_on", "torch_off"].into_iter().chain(others.iter().copied()).collect();
    let twice = |row: LiveRow, one: &'static str, other: &str| {
        let words = Text::new(format!("un código está también en {other}"), format!("a code stands in {other}, too"));
        row.wrong(share(one, other, &[]), words, one)
    };
    let of = |symbol, name, meaning, [on, off]: [&'static str; 2]| {
        let formula = format!("IF(LEN(TRIM({on}&{off}))=0,\"\",{on}&\" / \"&{off})");
        LiveRow::length(symbol, name, meaning, formula).always().unit(Unit::None)
    };
    let torch = of("torch", "live_torch", t("Antorcha: sí / no", "Torch: on / off"), ["torch_on", "torch_off"]);
    // Stops are no switches, and beside M3 or M4 the other codes are for something else.
    let by_spindle = has("torch_on", &[3, 4]);
    let starts = share("torch_on", "end_codes", &["", "1", "2", "30"]);
    let torch = twice(torch, "torch_on", "torch_off")
        .wrong(has("torch_on", &[5]), t("M5 apaga la antorcha", "M5 turns the torch off"), "torch_on")
        .wrong(
            has("torch_off", &[3, 4]),
            t("M3 y M4 encienden la antorcha", "M3 and M4 turn the torch on"),
            "torch_off",
        )
        .wrong(
            format!("OR({},AND(NOT({by_spindle}),{starts}))", has("end_codes", &[3, 4])),
            t("un código enciende la antorcha", "a code turns the torch on"),
            "end_codes",
        );
    let mut rows = vec![machine_codes(&lists), torch];
    if !others.is_empty() {
        let shown = t("Ningún código está en dos listas", "No code stands in two lists");
        let row = LiveRow::length("M", "live_lists", shown, "\"\"").always().unit(Unit::None);
        let pairs =
            lists.iter().enumerate().flat_map(|(at, one)| lists[at + 1..].iter().map(move |other| (*one, *other)));
        let row =
            pairs.filter(|(_, other)| *other != "torch_off").fold(row, |row, (one, other)| twice(row, one, other));
        rows.push(row);
    }
    rows
}

/// The row of the block that takes a mill's tool away.
pub(crate) fn retract() -> LiveRow {
    let block = spaced("retract", 'G');
    let counted = |word: &str| format!("(LEN({block})-LEN(SUBSTITUTE({block},\"{word}\",\"\")))/{}", word.len());
    let admits = |control: &Control, number: usize| {
        matches!(control.codes.get(10 * number), Some(G::Rapid | G::MachineCoordinates | G::Absolute))
    };
    let written = |number: usize| counted(&if number == 0 { " G ".to_owned() } else { format!(" G{number} ") });
    let numbers: Vec<usize> =
        (0..1000).filter(|&number| MILLING.iter().any(|control| admits(control, number))).collect();
    let known: Vec<String> = numbers.iter().map(|&number| written(number)).collect();
    // What another control admits.
    let foreign = MILLING.iter().flat_map(|control| {
        let others = numbers.iter().filter(|&&number| !admits(control, number));
        others.map(|&number| format!("AND({},{}>0)", says("dialect", control.name), written(number)))
    });
    let outside: Vec<String> =
        std::iter::once(format!("{}>{}", counted(" G"), known.join("+"))).chain(foreign).collect();
    let axis = |letter: char| format!("ISNUMBER(FIND(\" {letter}\",{block}))");
    let moves = format!("OR({},{},{})", axis('X'), axis('Y'), axis('Z'));
    let row = LiveRow::length(
        "retract",
        "live_retract",
        t("Retirada de la herramienta", "Retracting the tool"),
        "retract&\"\"",
    )
    .always()
    .unit(Unit::None)
    .wrong(
        format!("OR({})", outside.join(",")),
        t("lleva un código G que no va ahí", "a G code there does not belong there"),
        "retract",
    )
    .wrong(
        has("retract", &[2, 30]),
        t("M2 y M30 terminan ahí el programa", "M2 and M30 end the program there"),
        "retract",
    )
    .wrong(
        format!("AND({moves},NOT({}))", axis('Z')),
        t("mueve ejes, pero no Z", "it moves axes, but not Z"),
        "retract",
    );
    let by_machine: Vec<String> = MILLING
        .into_iter()
        .filter(|control| control.codes.has(G::MachineCoordinates))
        .map(|control| says("dialect", control.name))
        .collect();
    if by_machine.is_empty() {
        return row;
    }
    let machine = format!("ISNUMBER(FIND(\" G53 \",{block}))");
    let missing = format!("AND(OR({}),{moves},NOT({machine}))", by_machine.join(","));
    row.wrong(missing, t("falta G53", "G53 is missing"), "retract")
}

#[cfg(test)]
mod tests {
    use super::{feed_needed, needing_feed};
    use crate::kind::live_form::LiveRow;
    use crate::kinds::KINDS;
    use crate::parameter::{FieldKind, Parameter};
    use crate::text::t;

    /// AND and OR compute all that they hold, so a text in a cell must not come to arithmetic inside them: only a branch of IF, or N,
    /// keeps it out.
    #[test]
    fn no_formula_computes_with_the_text_of_a_cell_that_is_no_input() {
        let mut seen = 0;
        for kind in KINDS {
            let Some(form) = kind.live() else { continue };
            let own = kind.form().parameters().map(|(_, one)| one).filter(|one| !form.inputs.contains(&one.name));
            let numbers: Vec<&Parameter> =
                own.filter(|one| matches!(one.kind, FieldKind::Real { .. } | FieldKind::Whole { .. })).collect();
            let rows = form
                .rows
                .iter()
                .flat_map(|row| std::iter::once(&row.formula).chain(row.wrong.iter().map(|wrong| &wrong.when)));
            let all = rows.chain(form.unsound.iter().map(|one| &one.when)).chain(form.view.columns.iter().flatten());
            for formula in all {
                for name in numbers.iter().map(|one| one.name) {
                    let letter = |one: char| one.is_alphanumeric() || one == '_';
                    let around = |(at, _)| (&formula[..at], &formula[at + name.len()..]);
                    let own =
                        |(before, behind): &(&str, &str)| !before.ends_with(letter) && !behind.starts_with(letter);
                    let mut places = formula.match_indices(name).map(around).filter(own).peekable();
                    seen += usize::from(places.peek().is_some());
                    let sign = |one: char| "+-*/^".contains(one);
                    let computed = places.any(|(before, behind)| before.ends_with(sign) || behind.starts_with(sign));
                    let kept = [format!("IF(ISNUMBER({name})"), "IF(COUNT(".to_owned()];
                    let kept = kept.iter().any(|guard| formula.contains(guard));
                    assert!(!computed || kept, "{}: {name}: {formula}", kind.form().kind);
                }
            }
        }
        assert!(seen > 10, "{seen} formulas");
    }

    #[test]
    fn the_words_name_the_control_that_needs_a_feed() {
        let row = feed_needed(LiveRow::length("style", "live_style", t("a", "a"), "style&\"\""));
        assert!(needing_feed().count() > 0 && row.wrong.len() == needing_feed().count());
        for (wrong, control) in row.wrong.iter().zip(needing_feed()) {
            assert!([&wrong.words.es, &wrong.words.en].iter().all(|words| words.contains(control.name)), "{wrong:?}");
        }
    }
}
