//! Every column of every table says how its values come about.

use rodete::table::{Cells, Law};
use rodete::text::Language;

use crate::common::{cases, outcome_of};

#[test]
fn every_column_of_every_case_has_a_law_with_words_or_none_at_all() {
    for (kind, case, _) in cases().filter(|(.., language)| *language == Language::En) {
        let outcome = outcome_of(kind, case, Language::En, &[]);
        let columns =
            || outcome.tables.iter().flat_map(|table| table.columns.iter().map(move |column| (table, column)));
        for (table, column) in columns() {
            let of = format!("{kind:?} {}: {} of {}", case.name, column.symbol.en, table.key);
            // A formula and no heap of words: it is shown where the heading is selected.
            let said = |told: &str| !told.trim().is_empty() && told.trim() == told && told.chars().count() <= 255;
            assert!(column.law.told().is_none_or(said), "{of}");
            // Words are chosen, not computed.
            assert!(!matches!(column.values, Cells::Texts(_)) || column.law == Law::None, "{of}");
        }
        assert!(columns().any(|(_, column)| column.law.told().is_some()), "{kind:?} {}", case.name);
    }
}

#[test]
fn the_annexes_of_an_impeller_are_formulas_all_through() {
    let outcome = crate::common::outcome("full", &[]);
    let annexes = outcome.tables.iter().filter(|table| table.key.starts_with("annex-"));
    let columns = annexes.clone().flat_map(|table| &table.columns);
    let unsaid = columns.filter(|column| !matches!(column.values, Cells::Texts(_)) && column.law == Law::None);
    assert_eq!((annexes.count(), unsaid.count()), (8, 0));
}
