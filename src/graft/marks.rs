//! The marks by which sheets that were put in are known again.

use crate::escape::excerpt;
use crate::text::{Text, t};
use crate::workbook::address::cell;
use crate::workbook::names::{MARK, quoted};

use super::book::Name;
use super::sheet::Title;

/// How the one begins that says what stands in its first cell.
const TITLE: &str = "rodete_title_";
/// Characters of a title that are kept: a text in a formula has 255 at most.
const KEPT: usize = 200;

/// A mark of a workbook.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetMark {
    /// The sheet's slug.
    pub slug: String,
    /// The hidden name that leads to the sheet.
    pub name: String,
    /// The sheet and the cell that it leads to; `None` where they were deleted.
    pub place: Option<(String, String)>,
    /// What the first cell said, as a formula.
    pub title: String,
}

/// The marks among the names of a workbook.
pub fn marks(names: &[Name]) -> Vec<SheetMark> {
    let globals = || names.iter().filter(|one| one.sheet.is_none());
    globals()
        .filter_map(|one| {
            let slug = one.name.to_lowercase().strip_prefix(MARK)?.to_owned();
            let title = format!("{TITLE}{slug}");
            let title = globals().find(|one| one.name.eq_ignore_ascii_case(&title));
            Some(SheetMark {
                name: one.name.clone(),
                place: cell(&one.formula),
                title: title.map_or_else(String::new, |one| one.formula.trim_start_matches('=').to_owned()),
                slug,
            })
        })
        .collect()
}

/// The names that mark a sheet.
pub fn names(slug: &str, sheet: &str, title: &Title) -> [Name; 2] {
    let hidden = |name: String, formula| Name { name, sheet: None, hidden: true, formula };
    [hidden(format!("{MARK}{slug}"), format!("{}!$A$1", quoted(sheet))), hidden(format!("{TITLE}{slug}"), said(title))]
}

/// What stands in a first cell as a formula: the beginning of a text, 1 for the result of a formula, else 0.
pub fn said(title: &Title) -> String {
    match title {
        Title::Text(text) => {
            let kept: String = text.chars().filter(|one| !one.is_control()).take(KEPT).collect();
            format!("\"{}\"", kept.replace('"', "\"\""))
        }
        Title::Formula => "1".to_owned(),
        Title::None => "0".to_owned(),
    }
}

/// What the first cell of a sheet says, from what is kept of it.
pub fn title(said: &str) -> Text {
    match said.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(text) => {
            let text = excerpt(&text.replace("\"\"", "\""), KEPT);
            Text::new(format!("\"{text}\""), format!("\"{text}\""))
        }
        None if said == "0" => t("nada", "nothing"),
        None => t("una fórmula", "a formula"),
    }
}

/// True for a formula that names a sheet.
pub fn mentions(formula: &str, sheet: &str) -> bool {
    let bare = format!("{sheet}!");
    let plain = formula.to_lowercase();
    plain.contains(&format!("{}!", quoted(sheet)).to_lowercase())
        || plain.match_indices(&bare.to_lowercase()).any(|(at, _)| {
            let before = plain.get(..at).and_then(|before| before.chars().next_back());
            before.is_none_or(|one| !one.is_alphanumeric() && !matches!(one, '_' | '.' | '\'' | '!' | '"'))
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workbook::names::slug;

    #[test]
    fn a_mark_says_which_sheet_it_leads_to_and_what_its_first_cell_said() {
        let title = Title::Text("Annex \"1\"".to_owned());
        let made = names(&slug("annex-1"), "It's", &title);
        assert_eq!(made[0].formula, "'It''s'!$A$1");
        let found = marks(&made);
        assert_eq!(found[0].place, Some(("It's".to_owned(), "A1".to_owned())));
        assert_eq!((found[0].slug.as_str(), found[0].title.as_str()), ("annex_1", "\"Annex \"\"1\"\"\""));
    }

    #[test]
    fn a_formula_mentions_the_sheets_that_it_reads() {
        for formula in ["DATA!$A$1", "2*data!A1", "'DATA'!$C$4+1", "SUM(DATA!A1:B2)"] {
            assert!(mentions(formula, "DATA"), "{formula}");
        }
        for formula in ["MY_DATA!A1", "'MY DATA'!A1", "DATA", "'DATA 2'!A1"] {
            assert!(!mentions(formula, "DATA"), "{formula}");
        }
    }
}
