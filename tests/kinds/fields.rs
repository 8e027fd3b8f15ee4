//! The fields of every form: what its limits admit becomes the field's type, and a design asks for fields of its own form
//! alone.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use rodete::kinds::KINDS;
use rodete::parameter::field::Fields;
use rodete::parameter::list::{Row, Rows};
use rodete::parameter::{FieldKind, Form, Parameter, Value, Values};
use rodete::text::Language;

use crate::common;

fn text(pattern: &str) -> impl Strategy<Value = String> + use<> {
    proptest::string::string_regex(pattern).expect("a pattern")
}

/// What the limits of a parameter admit.
fn admitted(form: &'static Form, parameter: &'static Parameter) -> BoxedStrategy<Value> {
    let line = |line: &str| Value::Line(line.to_owned());
    match &parameter.kind {
        FieldKind::Real { min, max } => prop_oneof![
            1 => Just(Value::Real(*min)),
            1 => Just(Value::Real(*max)),
            6 => (*min..=*max).prop_map(Value::Real),
        ]
        .boxed(),
        FieldKind::Whole { min, max } => (*min..=*max).prop_map(Value::Whole).boxed(),
        FieldKind::Choice(list) => (0..list.len()).prop_map(|at| Value::Choice(list[at].key)).boxed(),
        FieldKind::Line { max } => text(&format!(".{{0,{max}}}")).prop_map(Value::Line).boxed(),
        FieldKind::Date => text(".{0,40}").prop_map(Value::Line).boxed(),
        FieldKind::Codes => {
            text("([GM][0-9]{1,4} ){0,5}").prop_map(|codes| Value::Line(codes.trim().to_owned())).boxed()
        }
        FieldKind::Block => {
            "(G[0-9]{1,4} ){0,3}(Z-?[0-9]{1,4})?".prop_map(|block| Value::Line(block.trim().to_owned())).boxed()
        }
        FieldKind::Schema => Just(line(form.schema)).boxed(),
    }
}

/// Left out now and then, where it may be.
fn now_and_then<T: std::fmt::Debug + 'static>(may: bool, given: BoxedStrategy<T>) -> BoxedStrategy<Option<T>> {
    if may { proptest::option::weighted(0.7, given).boxed() } else { given.prop_map(Some).boxed() }
}

/// Values of some parameters: all that are required, and the others now and then.
fn filled(form: &'static Form, parameters: Vec<&'static Parameter>) -> BoxedStrategy<Vec<(&'static str, Value)>> {
    let each = parameters.into_iter().map(move |one| {
        let given = now_and_then(!one.required, admitted(form, one));
        given.prop_map(move |value| value.map(|value| (one.key, value)))
    });
    each.collect::<Vec<_>>().prop_map(|values| values.into_iter().flatten().collect()).boxed()
}

fn forms(form: &'static Form) -> BoxedStrategy<Values> {
    let sheets = form.sheets.iter().map(move |sheet| {
        let parameters = sheet.sections.iter().flat_map(|section| section.parameters).copied().collect();
        now_and_then(sheet.optional, filled(form, parameters)).prop_map(Option::unwrap_or_default)
    });
    let lists = form.lists.iter().map(move |list| {
        let row = filled(form, list.columns.to_vec())
            .prop_map(|values| Row { values: values.into_iter().collect(), ..Row::default() });
        proptest::collection::vec(row, 0..4).prop_map(|rows| Rows { list: list.key, rows, ..Rows::default() })
    });
    (sheets.collect::<Vec<_>>(), lists.collect::<Vec<_>>())
        .prop_map(|(sheets, lists)| Values {
            language: Language::En,
            values: sheets.into_iter().flatten().collect(),
            lists,
            ..Values::default()
        })
        .boxed()
}

#[test]
fn every_kind_asks_its_cases_for_fields_of_its_own_form_alone() {
    for (kind, case, language) in common::cases() {
        let fields = Fields::of(kind.form(), Values::of(case, language));
        let fields = fields.unwrap_or_else(|refusal| panic!("{}: {refusal:?}", case.name));
        assert_eq!(kind.design(&fields), Ok(()), "{kind:?} {}", case.name);
    }
    assert!(common::cases().count() >= 14);
}

#[test]
fn whatever_the_limits_admit_becomes_the_type_of_its_field() {
    for (form, kind) in KINDS.iter().map(|kind| (kind.form(), kind)) {
        let mut runner = TestRunner::new(Config { cases: 64, failure_persistence: None, ..Config::default() });
        runner
            .run(&forms(form), |values| {
                let fields = Fields::of(form, values).map_err(|refusal| TestCaseError::fail(format!("{refusal:?}")))?;
                // A design, or a reason why there is none; never a field that gives nothing.
                if let Err(findings) = kind.design(&fields) {
                    prop_assert!(!findings.is_empty());
                }
                Ok(())
            })
            .unwrap_or_else(|error| panic!("{}: {error}", form.kind));
    }
}

#[test]
fn every_word_of_a_list_is_one_of_its_type_and_no_other_word_is() {
    let mut words = 0;
    for form in KINDS.iter().map(|kind| kind.form()) {
        let columns = form.lists.iter().flat_map(|list| list.columns).copied();
        for parameter in form.parameters().map(|(_, parameter)| parameter).chain(columns) {
            let FieldKind::Choice(list) = parameter.kind else { continue };
            for choice in list {
                assert!((parameter.admits)(&Value::Choice(choice.key)), "{} {}", parameter.key, choice.key);
                words += 1;
            }
            for wrong in [Value::Choice("?"), Value::Real(1.0), Value::Line(list[0].key.to_owned())] {
                assert!(!(parameter.admits)(&wrong), "{} {wrong:?}", parameter.key);
            }
        }
    }
    assert!(words > 100, "{words} words");
}
