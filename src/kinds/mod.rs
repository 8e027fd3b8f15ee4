//! The workbook kinds, a folder each: form, design, model, programs, proof, tables, figures and scene.

pub mod impeller;
pub mod lathe;
mod live_form;
pub mod pipe;
pub mod rules;

use crate::finding::rules::SchemaWithoutKind;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::kind::method::Of;
use crate::kind::{Kind, Outcome, Provenance, Wants};
use crate::parameter::field::Fields;
use crate::parameter::{Form, Values};

/// The kinds that the command `rodete` knows, the usual one first. The lathe follows programs that are written already, and
/// so has no method.
pub static KINDS: &[&dyn Kind] = &[
    &Of::<impeller::Impeller>::new(),
    &Of::<pipe::insert::Insert>::new(),
    &Of::<pipe::hole::Hole>::new(),
    &lathe::Lathe,
];

/// Computes a filled-in form of one of the [`KINDS`].
///
/// # Errors
/// A refusal with every contradiction between values.
pub fn run(form: &'static Form, values: Values, source: Provenance) -> Result<Outcome, Refusal> {
    match KINDS.iter().find(|kind| kind.form().schema == form.schema) {
        Some(kind) => kind.run(Fields::of(form, values)?, Vec::new(), source, Wants::default()),
        None => Err(SchemaWithoutKind { schema: form.schema }.refused(Exit::Fault, Place::File)),
    }
}
