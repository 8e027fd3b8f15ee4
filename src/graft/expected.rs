//! Reading back what was written, before anybody gets it.

use std::collections::BTreeSet;
use std::io::Cursor;

use calamine::{Reader, Xlsx};

use crate::finding::answer::quoted;
use crate::finding::{Exit, Refusal};
use crate::text::{Text, t};
use crate::workbook::gate;

use super::host::{refused, unfit};
use super::parts::{ContentTypes, Parts};
use super::rules::BookTooLarge;

/// What the workbook must be.
#[derive(Debug)]
pub struct ExpectedBook<'s, 'h> {
    /// The workbook as it was.
    pub host: &'s mut Parts<'h>,
    /// The workbook that the sheets come from.
    pub donor: &'s [u8],
    /// The parts that may differ or be gone.
    pub edited: BTreeSet<String>,
    /// All sheets in order.
    pub sheets: &'s [String],
    /// The sheets that were put in.
    pub placed: &'s [&'s str],
    /// The parts that were put in.
    pub added: &'s [&'s str],
}

impl ExpectedBook<'_, '_> {
    /// Judges a workbook.
    ///
    /// # Errors
    /// For a workbook that could not be read again, and for one that is not as it should be.
    pub fn judge(self, bytes: &[u8]) -> Result<(), Refusal> {
        let gated = gate(bytes).map_err(|refusal| match refusal.exit {
            Exit::Limit => Refusal { exit: Exit::Limit, ..refused(&BookTooLarge {}) },
            _ => unfit(refusal.reason()),
        })?;
        let names: Vec<&String> = gated.sheets.iter().map(|one| &one.name).collect();
        if names != self.sheets.iter().collect::<Vec<_>>() {
            return Err(unfit(t("la lista de hojas", "the list of sheets")));
        }
        // The reader does not follow targets through folders.
        let plain = if gated.plain.is_empty() { None } else { Some(gated.package.with(&gated.plain)?) };
        let mut parts = Parts::new(gated.package);
        // ECMA-376 part 2: every part has a content type.
        let types = ContentTypes::of(&mut parts)?;
        if let Some(part) = self.added.iter().find(|part| types.of_part(part).is_none()) {
            return Err(unfit(Text::same(*part)));
        }
        let kept: Vec<String> =
            self.host.all().filter(|part| !self.edited.contains(*part)).map(str::to_owned).collect();
        for part in kept {
            if self.host.bytes(&part)? != parts.bytes(&part)? {
                return Err(unfit(Text::same(part)));
            }
        }
        self.values(plain.as_deref().unwrap_or(bytes))
    }

    /// Compares the values of the sheets that were put in with those that they have in the donor.
    fn values(&self, bytes: &[u8]) -> Result<(), Refusal> {
        let open = |bytes| {
            Xlsx::new(Cursor::new(bytes)).map_err(|error: calamine::XlsxError| unfit(quoted(error.to_string())))
        };
        let (mut donor, mut book) = (open(self.donor)?, open(bytes)?);
        for sheet in self.placed {
            let (Ok(was), Ok(is)) = (donor.worksheet_range(sheet), book.worksheet_range(sheet)) else {
                return Err(unfit(Text::same(*sheet)));
            };
            if was != is {
                return Err(unfit(Text::same(*sheet)));
            }
        }
        Ok(())
    }
}
