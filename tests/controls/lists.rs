//! The lists of controls say one thing: what is of the class of mills and written for is chosen in the workbooks of mills, and
//! every lathe in those of lathes.

use std::collections::BTreeSet;

use rodete::gcode::code::G;
use rodete::gcode::comment::LONGEST;
use rodete::gcode::control::{
    ALL, AcrossWord, CODE_LIMIT, Class, Control, Corners, Drilling, Increments, MILLING, RadiusRule, TURNING, Turns,
};
use rodete::gcode::word::NumberFormat;
use rodete::kinds::KINDS;
use rodete::parameter::FieldKind;

/// Fails where a list does not name the controls of `ALL` that it should, and names those.
fn holds(list: &str, names: impl IntoIterator<Item = &'static str>, wanted: &[&'static Control], which: &str) {
    let names: Vec<_> = names.into_iter().collect();
    let listed: BTreeSet<_> = names.iter().copied().collect();
    let wanted: BTreeSet<_> = wanted.iter().map(|control| control.name).collect();
    let [missing, beyond] = [&wanted - &listed, &listed - &wanted];
    assert!(missing.is_empty(), "put {missing:?} into {list}: {which} in control::ALL");
    assert!(beyond.is_empty(), "take {beyond:?} out of {list}, or put it into control::ALL: {which}");
    assert_eq!(names.len(), listed.len(), "{list} names a control twice: {names:?}");
}

#[test]
fn every_list_of_controls_names_those_of_all_that_belong_to_it() {
    let names: BTreeSet<_> = ALL.iter().map(|control| control.name).collect();
    assert_eq!(names.len(), ALL.len(), "two controls of control::ALL have one name");
    let mills: Vec<_> = ALL.into_iter().filter(|control| !control.turns() && control.written.is_some()).collect();
    let lathes: Vec<_> = ALL.into_iter().filter(|control| control.turns()).collect();
    let [written, turned] = ["every mill with `written`", "every control of the class `Lathe`"];
    holds("control::MILLING", MILLING.map(|control| control.name), &mills, written);
    holds("control::TURNING", TURNING.map(|control| control.name), &lathes, turned);
    for form in KINDS.iter().map(|kind| kind.form()) {
        let dialect = form.parameter("dialect").unwrap_or_else(|| panic!("{}: no cell of the control", form.kind));
        let FieldKind::Choice(list) = dialect.kind else { panic!("{}: no list of controls", form.kind) };
        let turns = list.iter().any(|choice| Control::named(choice.key).is_some_and(Control::turns));
        let (wanted, which) = if turns { (&lathes, turned) } else { (&mills, written) };
        holds(&format!("the list of {}", form.kind), list.iter().map(|choice| choice.key), wanted, which);
    }
}

/// The form names no control: its hint says the codes of those that have an output for it.
#[test]
fn the_hints_of_the_height_control_say_the_codes_of_every_control_that_has_them() {
    let form = KINDS.iter().map(|kind| kind.form()).find(|form| form.kind == "pipe-hole").expect("the form");
    let mut seen = 0;
    for (key, on) in [("hold_on", true), ("hold_off", false)] {
        let note = &form.parameter(key).expect("a cell").note;
        for words in MILLING.iter().filter_map(|control| control.written?.height.words(on)) {
            let mut block = String::new();
            words.iter().for_each(|word| word.write(NumberFormat::Fixed, &mut block));
            assert!(note.es.contains(&block) && note.en.contains(&block), "{key}: {block}: {note:?}");
            seen += 1;
        }
    }
    assert!(seen >= 2, "some control has an output: {seen}");
}

#[test]
fn a_turning_cycle_by_letters_is_called_by_the_number_that_findings_name() {
    let mut seen = 0;
    for (control, tenths) in ALL.into_iter().flat_map(|control| (0..CODE_LIMIT).map(move |tenths| (control, tenths))) {
        let Some(cycle) = control.codes.get(tenths).and_then(G::by_letters) else { continue };
        assert_eq!(usize::from(cycle.number()) * 10, tenths, "{}: {cycle:?}", control.name);
        assert!(control.codes.turn_by(cycle));
        seen += 1;
    }
    assert_eq!(seen, 9);
}

/// The fields whose value is followed for one class of machine alone, with that class.
fn of_one_class(control: &Control) -> Vec<(&'static str, Class)> {
    let corners = match control.corners {
        Corners::None => None,
        // They lie between X and Z.
        Corners::Drawing => Some(Class::Lathe),
    };
    let drilling = match control.drilling {
        Drilling::None => None,
        Drilling::Rs274 => Some(Class::Mill),
        Drilling::Lathe => Some(Class::Lathe),
    };
    let radius = match control.radius {
        RadiusRule::None => None,
        RadiusRule::Cutter => Some(Class::Mill),
        RadiusRule::Nose(_) => Some(Class::Lathe),
    };
    let increments = match control.axes.increments {
        Increments::ByMode => None,
        Increments::ByLetters => Some(Class::Lathe),
    };
    // Sheets and reports of a lathe say diameters.
    let x = match control.axes.x {
        AcrossWord::Radius => Some(Class::Mill),
        AcrossWord::Diameter => Some(Class::Lathe),
    };
    let turns = match control.spindle.turns {
        Turns::Tool => Some(Class::Mill),
        Turns::Part => Some(Class::Lathe),
    };
    [
        ("corners", corners),
        ("drilling", drilling),
        ("radius", radius),
        ("axes.increments", increments),
        ("axes.x", x),
        ("spindle.turns", turns),
    ]
    .into_iter()
    .filter_map(|(field, class)| Some((field, class?)))
    .collect()
}

#[test]
fn the_fields_of_every_control_agree_with_one_another() {
    let mut wrong = Vec::new();
    for control in ALL {
        for (field, class) in of_one_class(control).into_iter().filter(|(_, class)| *class != control.class) {
            wrong.push(format!("{}: its value of `{field}` is followed for the class {class:?} alone", control.name));
        }
        if control.written.is_none() {
            continue;
        }
        let (text, lexis) = (&control.text, &control.lexis);
        if !control.turns() && !b"ABCXYZ".iter().all(|letter| lexis.letters.has(letter - b'A')) {
            wrong.push(format!("{}: a kind writes X, Y, Z, A, B or C, which `lexis.letters` lacks", control.name));
        }
        if !control.turns() && !control.arcs.letters.has(b'R' - b'A') {
            wrong.push(format!("{}: arcs are written by R, which `arcs.letters` lacks", control.name));
        }
        if text.greatest_number > lexis.greatest_number {
            wrong.push(format!("{}: `text.greatest_number` is more than `lexis.greatest_number`", control.name));
        }
        // A comment stands between two signs at most.
        if lexis.longest_line < LONGEST + 2 {
            wrong.push(format!("{}: a comment of {LONGEST} characters is beyond `lexis.longest_line`", control.name));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
