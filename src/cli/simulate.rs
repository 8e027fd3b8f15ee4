//! The command `simulate`: a turning program followed over its stock.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::args::Simulate;
use super::delivery::{self, Delivery};
use super::locale::spoken;
use super::plan::{self, Item};
use super::terminal::Terminal;
use super::turning::{Followed, TurningRequest, follow};
use super::verdict::{Verdict, code, status};
use super::{finding, interrupt, json, quantity, reading, refused, show};
use crate::escape::printable_path;
use crate::finding::{Exit, Place, Refusal};
use crate::kind::{Kind, Wants};
use crate::kinds::lathe::Raised;
use crate::kinds::lathe::quantities::SET_UP;
use crate::store::{self, Existing, Folder, Set};
use crate::table::{Quantity, Unit};
use crate::workbook::results::Tables;
use crate::workbook::{self, Input};

/// Follows the program and says what it comes to.
pub(super) fn run(arguments: &Simulate, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    interrupt::listen(spoken(arguments.lang, None));
    let mut followed = None;
    let verdict = reading::verdict(&arguments.program, |verdict| {
        followed = Some(simulate(arguments, kinds, verdict)?);
        Ok(())
    });
    let language = spoken(arguments.lang, verdict.language);
    if verdict.exit == Exit::CommandLine && followed.is_none() {
        return refused(&Refusal { exit: verdict.exit, findings: verdict.findings }, language, terminal);
    }
    if arguments.json {
        terminal.out(&json::laid_out(&document(arguments, &verdict, followed.as_ref())));
        return verdict.exit;
    }
    let (name, width) = (printable_path(&arguments.program), terminal.width);
    if let Some(followed) = &followed {
        terminal.out(&format!("{name}: {}, {}\n", followed.control.name, followed.stock));
        // Behind a rejected block nothing was measured: a 0 would say that there is no alarm.
        let known = |one: &Quantity| followed.whole || SET_UP.contains(&one.symbol);
        terminal.out(&quantity::table_of(&verdict.quantities, known, language, width));
    }
    let beside = arguments.tools.as_deref().map(printable_path);
    let names = finding::Names { input: &name, workbook: beside.as_ref().unwrap_or(&name) };
    finding::faults(&verdict.findings, names, language, terminal);
    finding::notes(&verdict.findings, names, language, terminal);
    terminal.out(&show::files(&verdict));
    verdict.exit
}

fn simulate(arguments: &Simulate, kinds: &[&dyn Kind], verdict: &mut Verdict) -> Result<Followed, Refusal> {
    let path = &arguments.program;
    let bytes = workbook::open_as(Input::Program, path)?;
    let folder = arguments.output.as_deref().map(Folder::open).transpose()?;
    verdict.findings.extend(folder.iter().filter_map(Folder::settled).cloned());
    verdict.findings.extend(reading::settled(arguments.tools.as_deref().map(plan::beside))?);
    let wanted = TurningRequest {
        program: path,
        bytes: &bytes,
        control: arguments.dialect,
        decimal_point: arguments.decimal_point,
        hole_plane: arguments.hole_r,
        block_delete: arguments.block_delete,
        stock: arguments.stock,
        tailstock: arguments.tailstock,
        tools: arguments.tools.as_deref(),
        language: spoken(arguments.lang, None),
    };
    let mut followed = follow(&wanted, verdict, Wants { scene: folder.is_some(), ..Wants::default() })?;
    let language = spoken(arguments.lang, verdict.language);
    if let (Some(folder), Some(output)) = (&folder, &arguments.output) {
        let inputs: Vec<&Path> = std::iter::once(path).chain(&arguments.tools).map(PathBuf::as_path).collect();
        let mut set = Set::new(folder, &inputs, Existing::Replace);
        let item = Item { workbook: path.clone(), stem: store::stem(path), folder: output.clone() };
        let scene = followed.outcome.scene.take().transpose()?;
        let viewer = scene.is_some();
        let (outcome, tables, printed) = (&followed.outcome, Tables::Live, false);
        Delivery { item: &item, outcome, language, tables, printed, viewer, live: false, into: false }
            .write(scene, &mut set)?;
        verdict.files = set.commit()?;
        verdict.folder = Some(output.clone());
        verdict.findings.extend(delivery::leftovers(&item, kinds, verdict));
    }
    Ok(followed)
}

/// An alarm as every finding, and its figures: X is a diameter, and `file` that of the subprogram where `line` stands in one.
fn alarm(Raised { alarm, place, .. }: &Raised) -> Map<String, Value> {
    let file = match place {
        Place::Subprogram { file, .. } => Some(file),
        _ => None,
    };
    let [x, z] = alarm.place;
    let finding = alarm.finding().placed(place.clone());
    let figures = json!({
        "number": alarm.cause.number(),
        "text": alarm.cause.text(),
        "file": file,
        "line": alarm.line,
        "block": alarm.n,
        "x_mm": x,
        "z_mm": z,
        "depth_mm": alarm.depth,
    });
    [json!(finding), figures].into_iter().filter_map(|part| part.as_object().cloned()).flatten().collect()
}

fn document(arguments: &Simulate, verdict: &Verdict, followed: Option<&Followed>) -> Value {
    let totals: Map<String, Value> = verdict
        .quantities
        .iter()
        .filter_map(|one| {
            let name = match one.symbol {
                "V_r" => "removed_volume_mm3",
                "V_t" => "parted_volume_mm3",
                "V" => "part_volume_mm3",
                "t" => "time_s",
                "t_c" => "cutting_time_s",
                "t_G0" => "rapid_time_s",
                "a_p" => "greatest_depth_mm",
                "V_c" => "greatest_cutting_speed_m_min",
                "Q" => "greatest_removal_rate_cm3_min",
                "alarms" => "alarms",
                "stops" => "stops",
                "δ_2" => "other_library_apart_mm",
                "dev_plus" => "deviation_plus_mm",
                "dev_minus" => "deviation_minus_mm",
                _ => return None,
            };
            // Behind a rejected block nothing was measured, as in the printed table.
            let known = followed.is_some_and(|followed| followed.whole);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
            let value = if one.unit == Unit::Count { json!(one.value as u64) } else { json!(one.value) };
            let value = if known { value } else { Value::Null };
            Some((name.to_owned(), value))
        })
        .collect();
    let alarms: Vec<_> = followed.iter().flat_map(|one| &one.alarms).map(alarm).collect();
    let motions = followed.and_then(|followed| followed.outcome.table("blocks")).map(crate::table::Table::rows);
    json!({
        "schema": json::SCHEMA,
        "rodete": env!("CARGO_PKG_VERSION"),
        "command": "simulate",
        "exit": code(verdict.exit),
        "status": status(verdict.exit),
        "program": arguments.program.to_string_lossy(),
        "sha256": verdict.sha256,
        "dialect": followed.map(|followed| followed.control.name),
        "stock": followed.map(|followed| followed.stock.clone()),
        "motions": motions,
        "totals": totals,
        "alarms": alarms,
        "findings": verdict.findings,
        "files": json::files(&verdict.files),
    })
}
