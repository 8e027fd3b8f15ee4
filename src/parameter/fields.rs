//! The values of a form, each as the type of its field.
//!
//! [`Fields::of`] is the only way from the values of a workbook to what a design is made of. It proves that every value that
//! the form requires is there, and that each is of its field's type; [`Fields::get`] then gives it as that type.

use std::collections::BTreeSet;

use crate::finding::{CellPlace, Exit, Finding, Key, Place, Raise, Refusal};
use crate::parameter::field::{Field, Presence, Typed};
use crate::parameter::list::{List, Row};
use crate::parameter::rules::{Missing, Mistyped};
use crate::parameter::{Form, Parameter, Value, Values, at};
use crate::text::Language;

/// The values of a form, all that it requires among them, each of its field's type.
#[derive(Clone, Debug)]
pub struct Fields {
    form: &'static Form,
    values: Values,
}

impl Fields {
    /// The values of a form.
    ///
    /// # Errors
    /// What is missing and what is of another type: a workbook's schema has told both before.
    pub fn of(form: &'static Form, values: Values) -> Result<Self, Refusal> {
        let mut findings = Vec::new();
        for (sheet, parameter) in form.parameters() {
            let mut sections = sheet.sections.iter().flat_map(|section| section.parameters);
            let absent = sheet.optional && !sections.any(|one| values.values.contains_key(one.key));
            let value = values.values.get(parameter.key);
            findings.extend(unproved(parameter, value, !absent).map(|place| values.locate(place)));
        }
        for rows in &values.lists {
            let columns = form.lists.iter().filter(|list| list.key == rows.list).flat_map(|list| list.columns);
            for (parameter, row) in columns.flat_map(|column| rows.rows.iter().map(move |row| (column, row))) {
                findings.extend(unproved(parameter, row.values.get(parameter.key), true));
            }
        }
        if findings.is_empty() { Ok(Self { form, values }) } else { Err(Refusal { exit: Exit::Refused, findings }) }
    }

    /// The value of a field.
    ///
    /// # Panics
    /// Where the field is of another form: a slip of the source, which no input can make.
    #[must_use]
    pub fn get<T: Typed, P: Presence>(&self, field: &Field<T, P>) -> P::Of<T> {
        let own = self.form.parameters().any(|(_, own)| std::ptr::addr_eq(own, &field.row));
        taken(field, self.values.values.get(field.row.key), own)
    }

    /// The rows of a list's first sheet; none where it is not there.
    pub fn rows(&self, list: &str) -> impl Iterator<Item = Entry<'_>> {
        self.sheets(list).take(1).flat_map(|(_, rows)| rows)
    }

    /// The sheets of a list by their names, each with its rows.
    pub fn sheets(&self, list: &str) -> impl Iterator<Item = (&str, impl Iterator<Item = Entry<'_>>)> {
        let described = self.form.lists.iter().find(|described| described.key == list);
        let of = |list: &'static List| {
            self.values.lists.iter().filter(|rows| rows.list == list.key).map(move |one| (list, one))
        };
        described
            .into_iter()
            .flat_map(of)
            .map(|(list, one)| (one.sheet.as_str(), one.rows.iter().map(move |row| Entry { list, row })))
    }

    /// The language of the workbook.
    #[must_use]
    pub const fn language(&self) -> Language {
        self.values.language
    }

    /// The finding with its parameters turned into the cells they came from: of one whose cell is empty, that which gives it.
    #[must_use]
    pub fn locate(&self, mut finding: Finding) -> Finding {
        if let Place::Parameters(keys) = &mut finding.place {
            let named: BTreeSet<Key> = keys.iter().copied().collect();
            for key in keys.iter_mut().filter(|key| !self.values.values.contains_key(key.name())) {
                // What names both speaks of the empty cell itself.
                let giver = self.form.parameter(key.name()).and_then(|row| row.given_by);
                let giver = giver.filter(|giver| !named.contains(*giver));
                let giver = giver.and_then(|giver| self.form.parameter(giver));
                *key = giver.filter(|giver| self.values.values.contains_key(giver.key)).map_or(*key, Parameter::key);
            }
            let mut seen = BTreeSet::new();
            keys.retain(|key| seen.insert(*key));
        }
        self.values.locate(finding)
    }

    /// The form that the values fill in.
    #[must_use]
    pub const fn form(&self) -> &'static Form {
        self.form
    }

    /// The values as the workbook holds them.
    #[must_use]
    pub const fn values(&self) -> &Values {
        &self.values
    }
}

/// A row of a list.
#[derive(Clone, Copy, Debug)]
pub struct Entry<'a> {
    list: &'static List,
    row: &'a Row,
}

impl Entry<'_> {
    /// The value of a column.
    ///
    /// # Panics
    /// Where the column is of another list: a slip of the source, which no input can make.
    #[must_use]
    pub fn get<T: Typed, P: Presence>(&self, field: &Field<T, P>) -> P::Of<T> {
        let own = self.list.columns.iter().any(|own| std::ptr::addr_eq(*own, &field.row));
        taken(field, self.row.values.get(field.row.key), own)
    }

    /// The cell of a column; none where the sheet has no such column.
    #[must_use]
    pub fn cell(&self, column: &Parameter) -> Vec<CellPlace> {
        self.row.cell(column.key)
    }
}

/// The value of a field that is of this form, or of one that is not.
fn taken<T: Typed, P: Presence>(field: &Field<T, P>, value: Option<&Value>, own: bool) -> P::Of<T> {
    match P::of(value.and_then(T::typed), field.usual.as_ref()).filter(|_| own) {
        Some(value) => value,
        None => panic!("{} is no field of this form", field.row.key),
    }
}

/// What is wrong with a value that a form has not read.
fn unproved(parameter: &'static Parameter, value: Option<&Value>, asked: bool) -> Option<Finding> {
    let (place, symbol) = (at([parameter.key()]), parameter.key());
    match value {
        None => (parameter.required && asked).then(|| Missing { symbol }.at(place)),
        Some(value) => (!(parameter.admits)(value)).then(|| Mistyped { symbol }.at(place)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::field::{Optional, Required, Usual, WithSheet, choices};
    use crate::parameter::list::{Naming, Rows};
    use crate::parameter::{Section, Sheet};
    use crate::table::Unit;
    use crate::text::{Text, t};

    const NONE: Text = t("", "");

    choices! {
        enum Side {
            In = "in" ("dentro", "inside"),
            Out = "out" ("fuera", "outside"),
        }
    }

    static R: Field<f64, Required> = Field::real("R", "R", Unit::Millimetre, [1.0, 9.0], NONE, NONE);
    static EPS: Field<f64, Usual> = Field::real_or(0.5, "eps", "eps", Unit::Millimetre, [0.1, 1.0], NONE, NONE);
    static BORE: Field<f64, Optional> = Field::real("bore", "bore", Unit::Millimetre, [1.0, 9.0], NONE, NONE);
    static SIDE: Field<Side, Required> = Field::choice("way", "way", NONE, NONE);
    static PART: Field<String, Required> = Field::line("part", "part", 9, NONE, NONE);
    static SLOT: Field<u32, WithSheet> = Field::whole("slots/N", "slots_N", Unit::Count, [1, 9], NONE, NONE);
    static X: Field<f64, Required> = Field::real("list/X", "", Unit::Millimetre, [0.0, 9.0], NONE, NONE);
    /// As `R`, of no form.
    static ALIEN: Field<f64, Required> = Field::real("R", "R", Unit::Millimetre, [1.0, 9.0], NONE, NONE);
    static ALIEN_BORE: Field<f64, Optional> = Field::real("bore", "bore", Unit::Millimetre, [1.0, 9.0], NONE, NONE);

    static FORM: Form = Form {
        kind: "ring",
        schema: "ring 1",
        earlier: &[],
        part: &PART,
        material: None,
        programs: &[],
        drawings: &[],
        solids: &[],
        viewer: false,
        sheets: &[
            Sheet {
                name: t("DATOS", "DATA"),
                title: NONE,
                optional: false,
                sections: &[Section {
                    title: NONE,
                    parameters: &[&R.row, &EPS.row, &BORE.row, &SIDE.row],
                    optional: false,
                }],
            },
            Sheet {
                name: t("RANURAS", "SLOTS"),
                title: NONE,
                optional: true,
                sections: &[Section { title: NONE, parameters: &[&SLOT.row], optional: false }],
            },
        ],
        lists: &[List {
            key: "list",
            is_program: false,
            naming: Naming::One(t("LISTA", "LIST")),
            title: NONE,
            note: NONE,
            optional: true,
            columns: &[&X.row],
            widths: &[9.0],
            most: 9,
        }],
    };

    fn values(given: &[(&'static str, Value)]) -> Values {
        let x = [("list/X", Value::Real(3.0))].into_iter().collect();
        let rows = vec![Row { values: x, ..Row::default() }];
        let lists = vec![Rows { list: "list", rows, ..Rows::default() }];
        Values { values: given.iter().cloned().collect(), lists, ..Values::default() }
    }

    fn fields() -> Fields {
        Fields::of(&FORM, values(&[("R", Value::Real(2.0)), ("way", Value::Choice("out"))])).expect("fields")
    }

    #[test]
    fn a_field_gives_its_type_and_an_empty_cell_what_its_presence_says() {
        let fields = fields();
        assert_eq!((fields.get(&R), fields.get(&EPS), fields.get(&BORE)), (2.0, 0.5, None));
        assert_eq!((fields.get(&SIDE), fields.get(&SLOT)), (Side::Out, None));
        assert_eq!(fields.rows("list").map(|row| row.get(&X)).collect::<Vec<_>>(), [3.0]);
        assert_eq!(
            [SIDE.row.required, EPS.row.required, BORE.row.required, SLOT.row.required],
            [true, false, false, true]
        );
    }

    #[test]
    fn what_is_missing_or_of_another_type_is_told_with_its_key() {
        let told = |given: &[(&'static str, Value)]| -> Vec<(&'static str, Place)> {
            let refusal = Fields::of(&FORM, values(given)).expect_err("no fields");
            refusal.findings.into_iter().map(|one| (one.rule().code, one.place)).collect()
        };
        assert_eq!(told(&[]), [("P0001", at([R.key()])), ("P0001", at([SIDE.key()]))]);
        assert_eq!(
            told(&[("R", Value::Whole(2)), ("eps", Value::Real(f64::NAN)), ("way", Value::Choice("up"))]),
            [("P0002", at([R.key()])), ("P0002", at([EPS.key()])), ("P0002", at([SIDE.key()]))]
        );
    }

    #[test]
    #[should_panic(expected = "R is no field of this form")]
    fn a_field_of_another_form_is_caught_though_its_key_is_one_of_this_form() {
        let _ = fields().get(&ALIEN);
    }

    #[test]
    #[should_panic(expected = "bore is no field of this form")]
    fn an_optional_field_of_another_form_is_caught_and_not_taken_for_an_empty_cell() {
        let _ = fields().get(&ALIEN_BORE);
    }

    #[test]
    #[should_panic(expected = "R is no field of this form")]
    fn a_field_that_is_no_column_of_a_list_is_caught() {
        let fields = fields();
        let _ = fields.rows("list").map(|row| row.get(&R)).sum::<f64>();
    }
}
