//! Numbered and named parameters.

use std::collections::BTreeMap;

/// One more than the greatest parameter number.
pub(super) const COUNT: usize = 5602;
/// How many parameters belong to each call of a subprogram.
pub(super) const LOCAL: usize = 30;

/// What a call of a subprogram with arguments has of its own: #1 to #30.
#[derive(Debug, Default)]
struct Own {
    values: [f64; LOCAL],
    known: [bool; LOCAL],
}

/// The parameters of a program.
#[derive(Debug)]
pub(super) struct Parameters {
    values: Vec<f64>,
    known: Vec<bool>,
    globals: BTreeMap<String, f64>,
    /// Those of the program, and of each call in it; those in force last.
    own: Vec<Own>,
    /// The names of the program, and of each call in it; those in force last.
    names: Vec<BTreeMap<String, f64>>,
    /// How often a parameter has got another value.
    changes: u64,
}

impl Parameters {
    pub(super) fn new() -> Self {
        Self {
            values: vec![0.0; COUNT],
            known: vec![false; COUNT],
            globals: BTreeMap::new(),
            own: vec![Own::default()],
            names: vec![BTreeMap::new()],
            changes: 0,
        }
    }

    /// Where a number stands: among those of the call in hand, or among all others.
    fn place(&self, number: usize) -> (&[f64], &[bool], usize) {
        match (number, self.own.last()) {
            (1..=LOCAL, Some(own)) => (&own.values, &own.known, number - 1),
            _ => (&self.values, &self.known, number),
        }
    }

    fn place_mut(&mut self, number: usize) -> Option<(&mut f64, &mut bool)> {
        let (values, known, at) = match (number, self.own.last_mut()) {
            (1..=LOCAL, Some(own)) => (&mut own.values[..], &mut own.known[..], number - 1),
            _ => (&mut self.values[..], &mut self.known[..], number),
        };
        values.get_mut(at).zip(known.get_mut(at))
    }

    /// The value of a numbered parameter, 0 where it was never set.
    pub(super) fn get(&self, number: usize) -> f64 {
        let (values, _, at) = self.place(number);
        values.get(at).copied().unwrap_or(0.0)
    }

    /// True where a numbered parameter has been set.
    pub(super) fn known(&self, number: usize) -> bool {
        let (_, known, at) = self.place(number);
        known.get(at).copied().unwrap_or(false)
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
        if let Some((_, known)) = self.place_mut(number) {
            *known = false;
        }
    }

    fn put(&mut self, number: usize, value: f64) {
        if let Some((slot, known)) = self.place_mut(number) {
            (*slot, *known) = (value, true);
        }
    }

    /// A named parameter: global if its name begins with `_`, else of the call in hand.
    pub(super) fn named(&self, name: &str) -> Option<f64> {
        let names = if name.starts_with('_') { &self.globals } else { self.names.last()? };
        names.get(name).copied()
    }

    /// Sets a named parameter.
    pub(super) fn set_named(&mut self, name: String, value: f64) {
        let names = if name.starts_with('_') { Some(&mut self.globals) } else { self.names.last_mut() };
        if let Some(names) = names {
            self.changes += u64::from(names.insert(name, value).map(f64::to_bits) != Some(value.to_bits()));
        }
    }

    /// Begins a call with its arguments as #1, #2, …; those that it does not give are 0.
    pub(super) fn enter(&mut self, arguments: &[f64]) {
        let values = std::array::from_fn(|at| arguments.get(at).copied().unwrap_or(0.0));
        self.own.push(Own { values, known: [true; LOCAL] });
    }

    /// Begins a call's names.
    pub(super) fn enter_names(&mut self) {
        self.names.push(BTreeMap::new());
    }

    /// Ends a call's names: the caller's are in force again.
    pub(super) fn leave_names(&mut self) {
        if self.names.len() > 1 {
            self.names.pop();
        }
    }

    /// What a name holds is not known any more.
    pub(super) fn forget_named(&mut self, name: &str) {
        self.globals.remove(name);
    }

    /// Ends a call with arguments: the caller's #1 to #30 are in force again.
    pub(super) fn leave(&mut self) {
        if self.own.len() > 1 {
            self.own.pop();
        }
    }
}

/// True where a program may not set a parameter: tool and position as the control keeps them.
pub(super) const fn read_only(number: usize) -> bool {
    matches!(number, 5400..=5413 | 5420..=5428)
}
