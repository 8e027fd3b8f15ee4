//! How the chuck holds the work: the bar of the first set-up, and the part that was turned about for the second.
//!
//! # Units
//! Millimetres.

use crate::finding::{Bare, Finding, Grade, Limit, Raise, Said, Size};
use crate::kinds::lathe::parameters as form;
use crate::kinds::lathe::rules::{BarHardlyHeld, BarInTheBody, HardlyHeld, HeldAlong, NothingInTheJaws};
use crate::number::shown;
use crate::parameter::at;
use crate::removal::turning::machine::Lathe;
use crate::removal::turning::simulation::Setup;
use crate::removal::turning::stock::Stock;
use crate::text::{Language, t};

/// The least length along which a part is held at all, mm: less is a line.
const HELD: f64 = 1.0;

/// The least length along which a part is held well, mm, and as a share of the jaws'. The more of the two. Chosen here.
const HELD_WELL: (f64, f64) = (5.0, 0.25);

/// The least length along which these jaws hold well.
fn well(jaws: f64) -> f64 {
    HELD_WELL.0.max(HELD_WELL.1 * jaws)
}

/// What is said of how the bar of the first set-up is held: a stop where nothing holds it, a caution where hardly anything does; a note
/// where there are no jaws. A tailstock keeps the bar from tilting but does not turn it, so that a stop becomes a caution.
pub(super) fn bar(stock: &Stock, lathe: &Lathe) -> Option<Finding> {
    let (L4, jaws) = (stock.length - stock.overhang, lathe.chuck.jaws);
    // What is longer than the jaws stands in the bore of the chuck's body, which holds nothing.
    let [left, right] = stock.held(lathe);
    let length = L4.min(right - left);
    let (held, least) = (Size::mm(length), well(jaws));
    if length >= least {
        return (jaws == 0.0).then(|| BarInTheBody { held }.at(at([form::L2.key(), form::L4.key()])));
    }
    let supported = stock.supported(lathe);
    let support = if supported {
        t("; el contrapunto la apoya, pero no la arrastra", "; the tailstock supports it, but does not drive it")
    } else {
        t("", "")
    };
    let grade = if length < HELD && !supported { Grade::Stop } else { Grade::Caution };
    let told = BarHardlyHeld { held, support, least: Size::mm(least) };
    let told = told.at(at([form::L4.key(), form::L2.key(), form::TAILSTOCK.key()])).graded(grade);
    let told = told.with(held.said(Language::En), format!("≥ {} mm", shown(least, 3)));
    Some(told.measuring(length, Limit::AtLeast(least)))
}

/// How the jaws hold the part that was turned about: a stop where they do not, a caution where they hardly do.
pub(super) fn turned(setup: &Setup) -> Finding {
    let Setup { lathe, stock, .. } = setup;
    let place = at([form::Z_S.key(), form::L4.key()]);
    let [left, right] = stock.held(lathe).map(|at| Bare::mm(at, 3));
    let Some(grip) = setup.part.as_deref().and_then(|part| stock.grip(lathe, part)) else {
        return NothingInTheJaws { left, right }.at(place);
    };
    let (X, length) = (Bare::mm(grip.diameter, 3), Size::mm(grip.length));
    let least = well(lathe.chuck.jaws);
    if grip.length >= least {
        return HeldAlong { X, length }.at(place);
    }
    let grade = if grip.length < HELD { Grade::Stop } else { Grade::Caution };
    let told = HardlyHeld { X, left, right }.at(place).graded(grade);
    let told = told.with(length.said(Language::En), format!("≥ {} mm", shown(least, 3)));
    told.measuring(grip.length, Limit::AtLeast(least))
}
