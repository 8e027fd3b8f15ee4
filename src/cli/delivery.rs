//! The files of an outcome: results, programs, drawings, and of a turning its solid and its viewer.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};

use super::drawings;
use super::plan::Item;
use super::rules::LeftFromEarlier;
use super::verdict::Verdict;
use super::view::headed;
use crate::escape::{printable, printable_path};
use crate::finding::{Finding, Place, Raise, Refusal};
use crate::gcode::program::Program;
use crate::kind::{Kind, Outcome};
use crate::parameter::Form;
use crate::removal::turning::mesh;
use crate::report::{Attachment, Content, Role};
use crate::scene::Scene;
use crate::store::{self, Set};
use crate::text::{Language, Text, t};
use crate::view;
use crate::workbook::results::{self, Tables};

/// The ending of the results.
pub(super) const RESULTS: &str = "-results.xlsx";
/// The ending of the report.
pub(super) const REPORT: &str = "-report.pdf";
/// The ending of the set-up sheet.
pub(super) const SETUP: &str = "-setup.pdf";
/// The ending of the viewer.
const VIEWER: &str = "-viewer.html";

/// What it is.
const VIEWED: Text = t("Visor de la simulación, para el navegador", "Viewer of the simulation, for a browser");

/// Endings of every file that may be delivered; one that is not of this set may be left from an earlier one.
pub(super) fn endings(kinds: &[&dyn Kind]) -> BTreeSet<String> {
    let forms = || kinds.iter().map(|kind| kind.form());
    let programs = forms().flat_map(|form| form.programs).map(|key| format!("-{key}.nc"));
    let solids = forms().flat_map(|form| form.solids).map(|(key, _)| solid_ending(key));
    let own = [RESULTS, REPORT, SETUP, VIEWER].into_iter().map(str::to_owned);
    own.chain(programs).chain(solids).chain(drawings::endings(kinds)).collect()
}

/// The ending of a body's file.
fn solid_ending(key: &str) -> String {
    format!("-{key}.stl")
}

/// The name of a program's file.
pub(super) fn program_name(item: &Item, program: &Program) -> OsString {
    store::file_name(&item.stem, &format!("-{}.nc", program.key))
}

/// What is delivered, and under which names.
pub(super) struct Delivery<'a> {
    /// The names.
    pub(super) item: &'a Item,
    /// What came of it.
    pub(super) outcome: &'a Outcome,
    /// The language of sheets and drawings.
    pub(super) language: Language,
    /// What the results hold.
    pub(super) tables: Tables,
    /// What typst sets, report, set-up sheet and templates, is asked for.
    pub(super) printed: bool,
    /// The viewer goes with it.
    pub(super) viewer: bool,
    /// The viewer's page refreshes itself.
    pub(super) live: bool,
    /// The results go into a workbook, when all else is known: here they are left out.
    pub(super) into: bool,
}

/// What the report lists without carrying it: the results, the bodies, and of a turning its viewer.
pub(super) fn attachments<'a>(item: &Item, form: &Form, set: &'a Set<'_>) -> Vec<Attachment<'a>> {
    let results = t("Libro de resultados", "Results workbook");
    let sheets = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
    let solids = form.solids.iter().map(|(key, name)| (solid_ending(key), "model/stl", name.clone()));
    std::iter::once((RESULTS.to_owned(), sheets, results))
        .chain(solids)
        .chain([(VIEWER.to_owned(), "text/html", VIEWED)])
        .filter_map(|(ending, mime, description)| {
            let name = store::file_name(&item.stem, &ending);
            Some(Attachment {
                role: Role::Beside,
                mime,
                description,
                content: Content::File(set.draft(&name)?),
                name: printable(&name.to_string_lossy()),
            })
        })
        .collect()
}

impl Delivery<'_> {
    /// The files beside the results that are delivered, as their first sheet lists them.
    fn files(&self, delivered: impl Fn(&OsStr) -> bool) -> Vec<results::File> {
        let Self { item, outcome, .. } = *self;
        let named = |ending: &str| store::file_name(&item.stem, ending);
        let typeset = [
            (SETUP, t("Hoja de preparación, para la máquina", "Set-up sheet, for the machine")),
            (REPORT, t("Informe, para leer e imprimir", "Report, to read and print")),
        ];
        let typeset = typeset.into_iter().filter(|_| self.printed).map(|(ending, what)| (named(ending), what));
        let programs = outcome.programs.iter().map(|one| (program_name(item, one), one.title.clone()));
        let solids =
            outcome.fields.form().solids.iter().filter(|(key, _)| outcome.solids.iter().any(|one| one.key == *key));
        let solids = solids.map(|(key, name)| (named(&solid_ending(key)), name.clone()));
        let viewer = self.viewer.then(|| (named(VIEWER), VIEWED));
        let drawings = drawings::named(item, outcome, self.printed);
        let all = typeset.chain(programs).chain(drawings).chain(solids).chain(viewer);
        let shown = |(name, what): (OsString, Text)| (printable(&name.to_string_lossy()), what);
        all.filter(|(name, _)| delivered(name)).map(shown).collect()
    }

    /// The files of the set, as the first sheet of the results lists them.
    pub(super) fn listed(&self, set: &Set<'_>) -> Vec<results::File> {
        self.files(|name| set.draft(name).is_some())
    }

    /// Writes the results anew where something that they list was not set after all: they list the files of the set, and
    /// those that are `still` to come.
    ///
    /// # Errors
    /// Exit 5 where the file cannot be written.
    pub(super) fn list_again(&self, still: &[&str], set: &mut Set<'_>) -> Result<(), Refusal> {
        if self.into {
            return Ok(());
        }
        let Self { item, outcome, language, .. } = *self;
        let still: Vec<OsString> = still.iter().map(|ending| store::file_name(&item.stem, ending)).collect();
        let files = self.files(|name| set.draft(name).is_some() || still.iter().any(|one| one == name));
        set.write_again(&store::file_name(&item.stem, RESULTS), |out| {
            results::write(outcome, &files, self.tables, language, out)
        })
    }

    /// Adds everything but what typst sets to the set; `scene` is what is shown in the viewer, where there is one.
    ///
    /// # Errors
    /// Exit 5 where a file cannot be written; exit 1 where a drawing cannot be drawn.
    pub(super) fn write(&self, scene: Option<Scene>, set: &mut Set<'_>) -> Result<(), Refusal> {
        let Self { item, outcome, language, tables, .. } = *self;
        let files = self.files(|_| true);
        if !self.into {
            set.write(&store::file_name(&item.stem, RESULTS), |out| {
                results::write(outcome, &files, tables, language, out)
            })?;
        }
        for program in &outcome.programs {
            set.write(&program_name(item, program), |out| program.write(out))?;
        }
        drawings::write(item, outcome, language, set)?;
        for solid in &outcome.solids {
            set.write(&store::file_name(&item.stem, &solid_ending(solid.key)), |mut out| {
                mesh::write_stl(&solid.contours, solid.tolerance, &mut out).map(|_| ())
            })?;
        }
        if let Some(scene) = scene {
            let name = item.workbook.file_name().unwrap_or_default();
            let scene = scene.titled(headed(outcome.part(), printable(&name.to_string_lossy())), language);
            let write = if self.live { view::write_live } else { view::write };
            set.write(&store::file_name(&item.stem, VIEWER), |out| write(&scene, out))?;
        }
        Ok(())
    }
}

/// A caution for each file in the folder that bears the name of an output and is not of this set: a program of an earlier
/// one must not be taken for one of this.
#[expect(clippy::disallowed_methods, reason = "the door to the files that a build names")]
pub(super) fn leftovers(item: &Item, kinds: &[&dyn Kind], verdict: &Verdict) -> Vec<Finding> {
    endings(kinds)
        .into_iter()
        .map(|ending| store::file_name(&item.stem, &ending))
        .filter(|name| !verdict.files.iter().any(|file| file.name == *name))
        .map(|name| item.folder.join(name))
        .filter(|path| path.symlink_metadata().is_ok())
        .map(|path| LeftFromEarlier { path: printable_path(&path) }.at(Place::File))
        .collect()
}
