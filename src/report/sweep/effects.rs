//! What each input does, as a chapter: the tolerance that it must keep, then its effect on each objective.

use super::{Chapter, Heading, Setter, Table};
use crate::kind::measure::Measure;
use crate::report::number;
use crate::sweep::objective::Objective;
use crate::sweep::sensitivity::{Effect, Slope};
use crate::text::{Text, t};

impl Setter<'_> {
    /// What each input does, and the tolerance that it must keep.
    pub(super) fn inputs(&mut self) -> Chapter {
        let effects = self.results.effects;
        let explained = self.results.explained();
        let mut chapter = Chapter {
            title: self.words.text(&t("Qué hace cada entrada", "What each input does")),
            paragraphs: explained.iter().map(|one| self.words.text(one)).collect(),
            ..Chapter::default()
        };
        let symbol = self.heading(&t("entrada", "input"), "", false);
        let mut tables: Vec<(Vec<Heading>, Vec<Vec<String>>)> = Vec::new();
        let around = [
            t("valor", "value"),
            t("puede bajar", "may go down"),
            t("puede subir", "may go up"),
            t("desde", "from"),
            t("hasta", "to"),
        ]
        .map(|name| self.heading(&name, "", true));
        let unit = self.heading(&t("unidad", "unit"), "", false);
        let row = |one: &Effect| {
            let short = |value: f64| number::trimmed(value, 4);
            let mut room = |side: usize| match &one.room {
                Ok(both) if one.open[side] => format!("≥ {}", short(both[side])),
                Ok(both) => short(both[side]),
                Err(none) => self.words.text(&none.words()),
            };
            let end = |side: usize| one.ends.map(|ends| short(ends[side])).unwrap_or_default();
            let here = one.value.map(|value| number::trimmed(value, 6)).unwrap_or_default();
            vec![one.unit.to_owned(), here, room(0), room(1), end(0), end(1)]
        };
        tables.push((std::iter::once(unit).chain(around).collect(), effects.iter().map(row).collect()));
        for (at, Objective { measure, .. }) in self.results.plan.objectives.iter().enumerate() {
            tables.push(self.effect(measure, at));
        }
        for (columns, rows) in tables {
            // What no row has is left out: with too few groups there are no indices.
            let told: Vec<bool> = (0..columns.len())
                .map(|at| rows.iter().any(|row| row.get(at).is_some_and(|one| !one.is_empty())))
                .collect();
            let columns = std::iter::once(symbol.clone()).chain(kept(columns, &told)).collect();
            let rows = effects
                .iter()
                .zip(rows)
                .map(|(one, row)| std::iter::once(self.words.line(&one.symbol)).chain(kept(row, &told)).collect());
            chapter.tables.push(Table { columns, rows: rows.collect(), note: String::new() });
        }
        chapter
    }

    /// What each input does to an objective.
    fn effect(&mut self, measure: &Measure, at: usize) -> (Vec<Heading>, Vec<Vec<String>>) {
        let (key, decimals) = (measure.key, number::usable(measure.unit));
        let named = |name: Text| Text::new(format!("{key} {}", name.es), format!("{key} {}", name.en));
        let unit = measure.unit.label();
        let around =
            [t("por unidad", "per unit"), t("(desde)", "(from)"), t("(hasta)", "(to)")].map(|name| (name, unit));
        let (triples, indexed) = (self.results.triples.is_some(), self.results.indexed());
        let over: Vec<(Text, &str)> = match (triples, indexed) {
            (false, _) => vec![(t("parte", "share"), "%")],
            (true, false) => Vec::new(),
            (true, true) => {
                [t("sola", "alone"), t("±", "±"), t("total", "total"), t("±", "±")].map(|name| (name, "%")).into()
            }
        };
        let columns =
            around.into_iter().chain(over).map(|(name, unit)| self.heading(&named(name), unit, true)).collect();
        let row = |one: &Effect| {
            let short = |value: Option<f64>| value.map(|value| number::trimmed(value, decimals)).unwrap_or_default();
            let slope = match one.slopes.get(at) {
                Some(Slope::Known(slope)) => number::trimmed(*slope, 4),
                Some(Slope::Rounding) => Slope::ROUNDING.to_owned(),
                Some(Slope::Unknown) | None => String::new(),
            };
            let part = |value: f64| number::fixed(100.0 * value, 1);
            let [low, high] = one.changes.get(at).copied().unwrap_or_default();
            let mut row = vec![slope, short(low), short(high)];
            if indexed {
                let index = one.indices.get(at).copied().flatten();
                let parts = index.map(|one| [one.first, one.off[0], one.total, one.off[1]].map(part));
                row.extend(parts.unwrap_or_default());
            } else if !triples {
                row.push(one.shares.get(at).copied().flatten().map(part).unwrap_or_default());
            }
            row
        };
        (columns, self.results.effects.iter().map(row).collect())
    }
}

/// Those of some cells that are told.
fn kept<T>(cells: Vec<T>, told: &[bool]) -> impl Iterator<Item = T> {
    cells.into_iter().zip(told).filter(|(_, told)| **told).map(|(cell, _)| cell)
}
