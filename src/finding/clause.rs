//! What is said before or behind the sentence of a row, whatever row it is: one clause each, with its fields.
//!
//! A clause is to a finding's sentence what a row is to the whole of it: a site gives values, and writes no words.

use crate::finding::{AlarmFamily, Bare, Datum, Said, Size};
use crate::text::{Language, Text};

/// A clause with its values.
pub trait Clause {
    /// The words, with the fields in braces: `{said}` is the sentence so far, `{alarm}` the number of the alarm, `{value}` the
    /// value found.
    fn words(&self) -> Text;
    /// The values that its words say, by name.
    fn values(&self) -> Vec<(&'static str, &dyn Said)>;
    /// How many of them, from the first on, the finding carries. The others stand in its place or its row already.
    fn carried(&self) -> usize;
}

impl dyn Clause + '_ {
    /// A sentence with the clause.
    #[must_use]
    pub fn said(&self, so_far: &Text, alarm: Option<(AlarmFamily, u16)>, value: &str) -> Text {
        let values = self.values();
        let alarm = alarm.map(|(family, number)| family.shown(number)).unwrap_or_default();
        let words = self.words();
        let said = |language: Language| {
            super::rule::with_fields(words.get(language), |name| match name {
                "said" => so_far.get(language).to_owned().into(),
                "alarm" => alarm.clone().into(),
                "value" => value.to_owned().into(),
                _ => {
                    values.iter().find(|(field, _)| *field == name).map_or("".into(), |(_, value)| value.said(language))
                }
            })
        };
        Text::new(said(Language::Es), said(Language::En))
    }

    /// What the finding carries of it.
    #[must_use]
    pub fn carries(&self) -> Vec<(&'static str, Datum)> {
        self.values().into_iter().take(self.carried()).map(|(name, value)| (name, value.datum())).collect()
    }
}

/// Clauses: a type for each. Fields in the first braces are carried, those in the second are only said.
macro_rules! clauses {
    ($said:ident $alarm:ident $value:ident; $(
        $(#[$about:meta])*
        $name:ident { $($field:ident: $type:ty),* } { $($told:ident: $told_type:ty),* }
            es $es:literal
            en $en:literal;
    )*) => {
        $(
            $(#[$about])*
            #[derive(Clone, Debug, PartialEq)]
            #[allow(missing_docs, reason = "the words say what the fields are")]
            pub struct $name {
                $(pub $field: $type,)*
                $(pub $told: $told_type,)*
            }

            impl Clause for $name {
                fn words(&self) -> Text {
                    $crate::text::t($es, $en)
                }

                fn values(&self) -> Vec<(&'static str, &dyn Said)> {
                    vec![$((stringify!($field), &self.$field as &dyn Said),)* $((stringify!($told), &self.$told as &dyn Said),)*]
                }

                fn carried(&self) -> usize {
                    let names: &[&str] = &[$(stringify!($field)),*];
                    names.len()
                }
            }

            const _: () = {
                // Nobody calls it: a name in braces that is no field does not compile.
                #[allow(dead_code, unused_variables, non_snake_case, clippy::too_many_arguments)]
                fn named($said: &str, $alarm: &str, $value: &str, $($field: &str,)* $($told: &str,)*) {
                    let _ = (format_args!($es), format_args!($en));
                }
            };
        )*
    };
}

clauses! {
    said alarm value;
    /// An alarm with its number, and where it is in program coordinates, X as a diameter.
    AlarmAt { X: Bare, Z: Bare } {}
        es "{alarm} {said}, X{X} Z{Z}"
        en "{alarm} {said}, X{X} Z{Z}";
    /// How deep an alarm goes, which its value says.
    Deep { deep: Size } {}
        es "{said}"
        en "{said}";
    /// An alarm of a control's own numbers.
    AlarmOfControl {} {}
        es "{alarm}: {said}"
        en "{alarm}: {said}";
    /// The cell of a limit.
    LimitIn { limit_cell: String } {}
        es "{said}; el límite está en {limit_cell}"
        en "{said}; the limit is in {limit_cell}";
    /// One alarm that may follow.
    OneFollows { following: usize } {}
        es "{said}; 1 alarma más con este corrector puede venir de ahí y no se lista aquí"
        en "{said}; 1 more alarm with this offset may follow from this and is not listed here";
    /// Several alarms that may follow.
    SeveralFollow { following: usize } {}
        es "{said}; {following} alarmas más con este corrector pueden venir de ahí y no se listan aquí"
        en "{said}; {following} more alarms with this offset may follow from this and are not listed here";
    /// The travel is left in one other motion.
    OnceMoreBeyond { more: usize } {}
        es "{said}; sale también en otro movimiento, {value} como mucho"
        en "{said}; it leaves it in another motion, too, by {value} at most";
    /// The travel is left in several other motions.
    MoreBeyond { more: usize } {}
        es "{said}; sale también en otros {more} movimientos, {value} como mucho"
        en "{said}; it leaves it in {more} other motions, too, by {value} at most";
    /// Once more on the same line.
    OnceMore { more: usize } {}
        es "{said}, y otra vez en la línea"
        en "{said}, and once more on the line";
    /// Several times more on the same line.
    More { more: usize } {}
        es "{said}, y otras {more} veces en la línea"
        en "{said}, and {more} more times on the line";
    /// The program that a finding is of.
    OfProgram {} { title: Text }
        es "«{title}»: {said}"
        en "\"{title}\": {said}";
    /// The file that a finding is of.
    OfFile {} { file: String }
        es "{file}: {said}"
        en "{file}: {said}";
    /// The block is one of the program that calls.
    InTheCaller {} {}
        es "{said} en el programa que llama"
        en "{said} in the program that calls";
}

#[cfg(test)]
mod tests {
    use super::{Clause, LimitIn, More, OfProgram};
    use crate::finding::sample::Noted;
    use crate::finding::{Datum, Place, Raise};
    use crate::text::t;

    #[test]
    fn a_clause_says_its_values_and_the_finding_carries_those_that_it_does_not_know() {
        let found = Noted { what: t("a {b}", "c") }.at(Place::File);
        let found = found.with_clause(&LimitIn { limit_cell: "DATA!C7".to_owned() }).with_clause(&More { more: 3 });
        assert_eq!(
            found.what,
            t(
                "a {b}; el límite está en DATA!C7, y otras 3 veces en la línea",
                "c; the limit is in DATA!C7, and 3 more times on the line"
            )
        );
        let carried: Vec<_> = found.data[1..].to_vec();
        assert_eq!(carried, [("limit_cell", Datum::Word("DATA!C7".to_owned())), ("more", Datum::Whole(3))]);
        let clause = OfProgram { title: t("Un álabe", "One blade") };
        assert!((&clause as &dyn Clause).carries().is_empty());
        assert_eq!(found.with_clause(&clause).data.len(), 3);
    }
}
