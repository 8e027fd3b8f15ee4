//! Numbered and named parameters.

use std::collections::BTreeMap;

/// One more than the greatest parameter number.
pub(super) const COUNT: usize = 5602;
/// How many parameters belong to each call of a subprogram.
pub(super) const LOCAL: usize = 30;

/// The parameters of a program.
#[derive(Debug)]
pub(super) struct Parameters {
    values: Vec<f64>,
    known: Vec<bool>,
    globals: BTreeMap<String, f64>,
    locals: Vec<BTreeMap<String, f64>>,
    /// How often a parameter has got another value.
    changes: u64,
}

impl Parameters {
    pub(super) fn new() -> Self {
        Self {
            values: vec![0.0; COUNT],
            known: vec![false; COUNT],
            globals: BTreeMap::new(),
            locals: vec![BTreeMap::new()],
            changes: 0,
        }
    }

    /// The value of a numbered parameter, 0 where it was never set.
    pub(super) fn get(&self, number: usize) -> f64 {
        self.values.get(number).copied().unwrap_or(0.0)
    }

    /// True where a numbered parameter has been set.
    pub(super) fn known(&self, number: usize) -> bool {
        self.known.get(number).copied().unwrap_or(false)
    }

    /// How often the program has given a parameter another value; a call's arguments do not count.
    pub(super) const fn changes(&self) -> u64 {
        self.changes
    }

    /// Sets a numbered parameter.
    pub(super) fn set(&mut self, number: usize, value: f64) {
        self.changes += u64::from(self.get(number).to_bits() != value.to_bits());
        self.put(number, value);
    }

    /// What a numbered parameter holds is not known any more.
    pub(super) fn forget(&mut self, number: usize) {
        if let Some(known) = self.known.get_mut(number) {
            *known = false;
        }
    }

    fn put(&mut self, number: usize, value: f64) {
        if let (Some(slot), Some(known)) = (self.values.get_mut(number), self.known.get_mut(number)) {
            *slot = value;
            *known = true;
        }
    }

    /// A named parameter: global if its name begins with `_`, else of the call in hand.
    pub(super) fn named(&self, name: &str) -> Option<f64> {
        let names = if name.starts_with('_') { &self.globals } else { self.locals.last()? };
        names.get(name).copied()
    }

    /// Sets a named parameter.
    pub(super) fn set_named(&mut self, name: String, value: f64) {
        let names = if name.starts_with('_') { Some(&mut self.globals) } else { self.locals.last_mut() };
        if let Some(names) = names {
            self.changes += u64::from(names.insert(name, value).map(f64::to_bits) != Some(value.to_bits()));
        }
    }

    /// Begins a call with its arguments as #1, #2, …; gives the caller's #1 to #30 back.
    pub(super) fn enter(&mut self, arguments: &[f64]) -> Vec<(f64, bool)> {
        let saved = (1..=LOCAL).map(|number| (self.get(number), self.known(number))).collect();
        for number in 1..=LOCAL {
            self.put(number, arguments.get(number - 1).copied().unwrap_or(0.0));
        }
        self.locals.push(BTreeMap::new());
        saved
    }

    /// Ends a call: the caller's #1 to #30 and names are in force again.
    pub(super) fn leave(&mut self, saved: &[(f64, bool)]) {
        for (number, &(value, known)) in (1..=LOCAL).zip(saved) {
            self.put(number, value);
            self.known[number] = known;
        }
        if self.locals.len() > 1 {
            self.locals.pop();
        }
    }
}

/// True where a program may not set a parameter: tool and position as the control keeps them.
pub(super) const fn read_only(number: usize) -> bool {
    matches!(number, 5400..=5413 | 5420..=5428)
}
