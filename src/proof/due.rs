//! What must be answered of a program: a key that no check answers is a stop, so that a judge left out stops the build.

use crate::proof::check::{Answer, Check};

/// A check that must be answered, by its key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Due {
    key: &'static str,
    told: bool,
}

impl Due {
    /// A key, as `closure`, whose check must be passed or find something: one for information does not answer it.
    #[must_use]
    pub const fn judged(key: &'static str) -> Self {
        Self { key, told: false }
    }

    /// A key whose check may be answered for information, because of this design nothing is compared with its value.
    #[must_use]
    pub const fn told(key: &'static str) -> Self {
        Self { key, told: true }
    }

    /// A key whose check may be answered for information where that is so, and must be judged where it is not.
    #[must_use]
    pub const fn told_where(told: bool, key: &'static str) -> Self {
        Self { key, told }
    }

    /// The key.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.key
    }

    /// True where one of the checks of a program answers it: one of this very key.
    #[must_use]
    pub fn is_answered(&self, checks: &[Check]) -> bool {
        checks.iter().any(|check| check.key() == self.key && (self.told || *check.answer() != Answer::Informs))
    }
}
