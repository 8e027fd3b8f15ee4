//! The lists of controls say one thing: what is of the class of mills and written for is chosen in the workbooks of mills, and
//! every lathe in those of lathes.

use std::collections::BTreeSet;

use rodete::gcode::control::{ALL, Control, MILLING, TURNING};
use rodete::kinds::KINDS;
use rodete::parameter::{DIALECTS, FieldKind};

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
    holds("parameter::DIALECTS", DIALECTS.iter().map(|choice| choice.key), &mills, written);
    holds("control::TURNING", TURNING.map(|control| control.name), &lathes, turned);
    for form in KINDS.iter().map(|kind| kind.form()) {
        let dialect = form.parameter("dialect").unwrap_or_else(|| panic!("{}: no cell of the control", form.kind));
        let FieldKind::Choice(list) = dialect.kind else { panic!("{}: no list of controls", form.kind) };
        let turns = list.iter().any(|choice| Control::named(choice.key).is_some_and(Control::turns));
        let (wanted, which) = if turns { (&lathes, turned) } else { (&mills, written) };
        holds(&format!("the list of {}", form.kind), list.iter().map(|choice| choice.key), wanted, which);
    }
}
