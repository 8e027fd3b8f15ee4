//! What rodete can find, one row each: a code, how grave it is, its sentence, the reason, the remedy and an example that
//! raises it.
//!
//! A code is one letter for the room and four digits, and is never given again. What makes two findings the same is their
//! rule, what they carry and their place; the sentence follows from these.

use std::borrow::Cow;

use crate::finding::{Datum, Exit, Finding, Grade, Place, Refusal, Said};
use crate::text::{Language, Text};

/// A row: what rodete can find under one code.
#[derive(Debug)]
pub struct Rule {
    /// The code, as `L0131`.
    pub code: &'static str,
    /// The row's name in the code, as `DepthOfCut`.
    pub ident: &'static str,
    /// The gravest that it is reported as.
    pub grade: Grade,
    /// True where only code can be to blame, rodete's or that of a kind: its stop ends the command with [`Exit::Fault`].
    pub fault: bool,
    /// The numbers under which it is reported as an alarm, each of a family's.
    pub alarm: &'static [(AlarmFamily, u16)],
    /// The sentence, with what it carries in braces.
    pub what: Text,
    /// What to do about it, with what it carries in braces; empty where there is nothing to do.
    pub remedy: Text,
    /// Why it matters.
    pub why: Text,
    /// What raises it.
    pub example: Example,
    /// The names of what it carries.
    pub fields: &'static [&'static str],
}

/// Whose numbers an alarm has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlarmFamily {
    /// Rodete's own, of a turning program followed over its stock: 101.
    Lathe,
    /// Fanuc's of the program and the setting: PS0064.
    Fanuc,
}

impl AlarmFamily {
    /// An alarm as it is shown.
    #[must_use]
    pub fn shown(self, number: u16) -> String {
        match self {
            Self::Lathe => number.to_string(),
            Self::Fanuc => format!("PS{number:04}"),
        }
    }
}

/// An input that raises a rule.
#[derive(Clone, Debug)]
pub enum Example {
    /// A turning program, followed over its stock.
    Turning {
        /// The control that it is written for.
        control: &'static str,
        /// The stock, as `simulate --stock` takes it.
        stock: &'static str,
        /// The program, its blocks parted by `|`.
        program: &'static str,
        /// Parameters of the lathe workbook that differ from the example's, by symbol.
        machine: &'static [(&'static str, &'static str)],
    },
    /// A program that a workbook writes, judged with a text in it replaced.
    Slip {
        /// The kind, with `--case NAME` where another than its usual case is taken.
        kind: &'static str,
        /// Parameters that differ from it, by symbol; an empty text empties the cell.
        cells: &'static [(&'static str, &'static str)],
        /// The program's key.
        program: &'static str,
        /// What is replaced, where it first stands; empty where the cells alone raise the rule.
        from: &'static str,
        /// What stands there instead.
        to: &'static str,
    },
    /// A new workbook of a kind in English, with other cells.
    Workbook {
        /// The kind, with `--case NAME` where another than its usual case is taken: what stands behind `rodete new`.
        kind: &'static str,
        /// What is typed, as a spreadsheet takes it (`'12` is a text, `` empties the cell), and where: the value of a symbol,
        /// `SYMBOL:unit`, `SYMBOL:symbol`, or a cell as `DATA!D7`.
        cells: &'static [(&'static str, &'static str)],
    },
    /// A command, and the files that it finds: each with its name and its lines, joined with `|`.
    Command {
        /// The name of each file, and its lines joined with `|`.
        files: &'static [(&'static str, &'static str)],
        /// The words behind `rodete`.
        words: &'static [&'static str],
    },
    /// A file or folder that no text shows.
    Made {
        /// By what the test knows it.
        key: &'static str,
        /// What it is.
        how: Text,
    },
    /// A program as a control reads it, by itself.
    Program {
        /// The control that it is written for.
        control: &'static str,
        /// Its blocks, parted by `|`.
        program: &'static str,
        /// Where it is reported: the line, or `LINE:COLUMN`.
        at: &'static str,
        /// How it is read beside that: options of `verify`, each with its value; of a file, with the file's text.
        given: &'static [(&'static str, &'static str)],
    },
    /// A program that is too much of one text.
    Repeated {
        /// The control that it is written for.
        control: &'static str,
        /// The text, with `|` where a block ends.
        word: &'static str,
        /// How often it is repeated.
        times: u32,
    },
    /// Only a fault in rodete itself raises it, and none is known; why.
    Never(Text),
}

impl PartialEq for Rule {
    /// A code is one row's alone.
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

impl Rule {
    /// Its number among the alarms of a family.
    #[must_use]
    pub fn alarm_of(&self, family: AlarmFamily) -> Option<u16> {
        self.alarm.iter().find(|(of, _)| *of == family).map(|(_, number)| *number)
    }

    /// The name in JSON, as `depth-of-cut`.
    #[must_use]
    pub fn name(&self) -> String {
        let mut name = String::new();
        for letter in self.ident.chars() {
            if letter.is_ascii_uppercase() && !name.is_empty() {
                name.push('-');
            }
            name.push(letter.to_ascii_lowercase());
        }
        name
    }

    /// Its sentence without the values of one finding: an ellipsis in the place of each.
    #[must_use]
    pub fn unfilled_what(&self) -> Text {
        unfilled(&self.what)
    }

    /// The same of its remedy.
    #[must_use]
    pub fn unfilled_remedy(&self) -> Text {
        unfilled(&self.remedy)
    }
}

/// A text of a row with an ellipsis in the place of each field.
fn unfilled(text: &Text) -> Text {
    let bare = |text: &str| with_fields(text, |_| Cow::Borrowed("…"));
    Text::new(bare(&text.es), bare(&text.en))
}

impl Example {
    /// A program that a control reads with nothing else known.
    #[must_use]
    pub const fn program(control: &'static str, program: &'static str, at: &'static str) -> Self {
        Self::Program { control, program, at, given: &[] }
    }
}

/// A row with its values.
///
/// All that a row has of its own is in these two: what follows from them stands once, below, not once for each of a thousand rows.
pub trait Raise {
    /// The row whose values these are.
    fn rule(&self) -> &'static Rule;
    /// Its values, in the order of the row's fields.
    fn values(&self) -> Vec<&dyn Said>;

    /// The finding that the row makes of its values, at a place.
    fn at(&self, place: Place) -> Finding {
        raised(self.rule(), self.values(), place)
    }

    /// The refusal for this alone.
    fn refused(&self, exit: Exit, place: Place) -> Refusal {
        Refusal::new(exit, self.at(place))
    }
}

impl dyn Raise + '_ {
    /// The sentence, without a full stop.
    #[must_use]
    pub fn what(&self) -> Text {
        filled(&self.rule().what, self.rule(), &self.values())
    }

    /// What to do about it.
    #[must_use]
    pub fn remedy(&self) -> Text {
        filled(&self.rule().remedy, self.rule(), &self.values())
    }

    /// What it carries, by name.
    #[must_use]
    pub fn carries(&self) -> Vec<(&'static str, Datum)> {
        carried(self.rule(), &self.values())
    }
}

/// What a row with these values finds at a place.
#[allow(clippy::needless_pass_by_value, reason = "taken here, it is dropped here, not in each of a thousand rows")]
fn raised(rule: &'static Rule, values: Vec<&dyn Said>, place: Place) -> Finding {
    let alarm = rule.alarm_of(AlarmFamily::Lathe).map(|number| (AlarmFamily::Lathe, number));
    let [what, remedy] = [&rule.what, &rule.remedy].map(|text| filled(text, rule, &values));
    Finding { alarm, ..Finding::of(rule, carried(rule, &values), place, what, remedy) }
}

/// Values by the names of a row's fields.
fn carried(rule: &Rule, values: &[&dyn Said]) -> Vec<(&'static str, Datum)> {
    rule.fields.iter().zip(values).map(|(&field, value)| (field, value.datum())).collect()
}

/// A text of a row with its values, each said in the language of the text.
fn filled(text: &Text, rule: &Rule, values: &[&dyn Said]) -> Text {
    let value = |name: &str| rule.fields.iter().position(|&field| field == name).and_then(|at| values.get(at));
    let said = |language| {
        with_fields(text.get(language), |name| value(name).map_or(Cow::Borrowed(""), |value| value.said(language)))
    };
    Text::new(said(Language::Es), said(Language::En))
}

/// A text with something in the place of each name in braces.
pub(super) fn with_fields<'a>(text: &str, mut said: impl FnMut(&str) -> Cow<'a, str>) -> String {
    let (mut whole, mut rest) = (String::new(), text);
    while let Some((before, (name, after))) =
        rest.split_once('{').and_then(|(before, tail)| Some((before, tail.split_once('}')?)))
    {
        whole.push_str(before);
        whole.push_str(&said(name));
        rest = after;
    }
    whole + rest
}

/// The rows of a room: a type for each, and a list of them all.
///
/// `{name}` in a sentence or a remedy is a field of the row; a name that is none does not compile. Every field's type is
/// [`Said`](crate::finding::Said).
///
/// `remedy fault` in the place of `remedy` makes it the row of a fault in code. Where no words follow, the remedy is
/// [`FAULT`](crate::finding::FAULT).
#[macro_export]
macro_rules! rules {
    (@fault) => { false };
    (@fault fault) => { true };
    (@remedy fault) => { $crate::finding::FAULT };
    (@remedy $(fault)? $es:literal, $en:literal) => { $crate::text::t($es, $en) };
    (
        $(#[$about:meta])*
        $list:ident;
        $(
            $code:literal $name:ident $grade:ident $(alarm $($family:ident $number:literal),+)? { $($field:ident: $type:ty),* $(,)? }
            es $es:literal
            en $en:literal
            remedy $($fault:ident)? $($remedy_es:literal, $remedy_en:literal)?;
            why $why_es:literal, $why_en:literal;
            example $example:expr;
        )*
    ) => {
        $(
            #[doc = concat!("`` ", $en, " ``")]
            #[derive(Clone, Debug, PartialEq)]
            #[allow(missing_docs, reason = "the sentence says what the fields are")]
            pub struct $name {
                $(pub $field: $type),*
            }

            impl $name {
                /// The row.
                pub const RULE: &'static $crate::finding::Rule = &$crate::finding::Rule {
                    code: $code,
                    ident: stringify!($name),
                    grade: $crate::finding::Grade::$grade,
                    fault: $crate::finding::rule::rules!(@fault $($fault)?),
                    alarm: &[$($(($crate::finding::AlarmFamily::$family, $number)),+)?],
                    what: $crate::text::t($es, $en),
                    remedy: $crate::finding::rule::rules!(@remedy $($fault)? $($remedy_es, $remedy_en)?),
                    why: $crate::text::t($why_es, $why_en),
                    example: $example,
                    fields: &[$(stringify!($field)),*],
                };
            }

            impl $crate::finding::Raise for $name {
                fn rule(&self) -> &'static $crate::finding::Rule {
                    Self::RULE
                }

                fn values(&self) -> Vec<&dyn $crate::finding::Said> {
                    vec![$(&self.$field),*]
                }
            }

            const _: () = {
                // Nobody calls it: a name in braces that is no field does not compile.
                #[allow(dead_code, unused_variables, non_snake_case, clippy::too_many_arguments)]
                fn named($($field: &str),*) {
                    let _ = (format_args!($es), format_args!($en));
                    $(let _ = (format_args!($remedy_es), format_args!($remedy_en));)?
                }
            };
        )*

        $(#[$about])*
        pub const $list: &[&$crate::finding::Rule] = &[$($name::RULE),*];
    };
}

/// The workbook of a kind, or of its case behind `--case`, with other values: symbols or cells, each with what is typed there.
macro_rules! book {
    ($kind:literal $(, $cell:literal = $text:literal)*) => {
        $crate::finding::Example::Workbook { kind: $kind, cells: &[$(($cell, $text)),*] }
    };
}

pub(crate) use book;
pub use rules;

#[cfg(test)]
mod tests {
    use super::{Example, Raise};
    use crate::finding::{Datum, FAULT, Finding, Grade, Place, Size};
    use crate::text::{Text, t};

    const NONE: Example = Example::Turning { control: "", stock: "", program: "", machine: &[] };

    super::rules! {
        LIST;
        "T0001" TooDeep Stop { depth: Size, edge: Size, tool: u32, body: Text }
            es "{body} de T{tool} corta {depth}, y el filo tiene {edge}"
            en "{body} of T{tool} cuts {depth}, and the edge has {edge}"
            remedy "quite {depth}", "take {depth} off";
            why "", "";
            example NONE;
        "T0002" Bare Note {}
            es "nada"
            en "nothing"
            remedy "", "";
            why "", "";
            example NONE;
        "T0003" Broken Stop {}
            es "roto"
            en "broken"
            remedy fault;
            why "", "";
            example NONE;
        "T0004" BrokenBeside Stop { way: &'static str }
            es "roto"
            en "broken"
            remedy fault "use {way}", "take {way}";
            why "", "";
            example NONE;
    }

    #[test]
    fn a_row_says_whether_code_is_to_blame_and_its_words_do_not() {
        assert_eq!(LIST.iter().map(|rule| rule.fault).collect::<Vec<_>>(), [false, false, true, true]);
        assert_eq!(Broken::RULE.remedy, FAULT);
        assert_eq!((&BrokenBeside { way: "-x" } as &dyn Raise).remedy(), t("use -x", "take -x"));
        let found = BrokenBeside { way: "-x" }.at(Place::File);
        assert!(found.is_fault() && !found.graded(Grade::Caution).is_fault());
        assert!(!Bare {}.at(Place::File).graded(Grade::Stop).is_fault());
    }

    #[test]
    fn a_row_says_its_values_in_both_languages_and_carries_them_unrounded() {
        let row = TooDeep {
            depth: Size::mm(1.234_56),
            edge: Size::mm(f64::INFINITY),
            tool: 3,
            body: t("la placa", "the insert"),
        };
        let Finding { rule, data, grade, what, remedy, .. } = row.at(Place::File);
        assert_eq!(
            what,
            t("la placa de T3 corta 1.235 mm, y el filo tiene ∞", "the insert of T3 cuts 1.235 mm, and the edge has ∞")
        );
        assert_eq!(remedy, t("quite 1.235 mm", "take 1.235 mm off"));
        assert_eq!((grade, rule.code, rule.name().as_str()), (Grade::Stop, "T0001", "too-deep"));
        assert_eq!(data[0], ("depth", Datum::Number { value: Some(1.234_56), unit: "mm", decimals: Some(3) }));
        assert_eq!(data[1], ("edge", Datum::Number { value: None, unit: "mm", decimals: Some(3) }));
        assert_eq!(data[2], ("tool", Datum::Whole(3)));
        assert_eq!(
            LIST.iter().map(|rule| rule.fields).collect::<Vec<_>>(),
            [&["depth", "edge", "tool", "body"][..], &[], &[], &["way"]]
        );
        assert_eq!((&Bare {} as &dyn Raise).what(), t("nada", "nothing"));
    }

    #[test]
    fn a_sentence_stands_without_its_values() {
        let rule = TooDeep::RULE;
        assert_eq!(rule.unfilled_what(), t("… de T… corta …, y el filo tiene …", "… of T… cuts …, and the edge has …"));
        assert_eq!(rule.unfilled_remedy(), t("quite …", "take … off"));
        assert_eq!(super::unfilled(&t("a { b", "sin campos")), t("a { b", "sin campos"));
    }
}
