//! A workbook kind outside of rodete: holes on a pitch circle. This folder is all there is of it; `docs/dev/add-a-kind.md` is
//! its story.
//!
//! With a command behind its name this binary is what `rodete` is, for this one kind; without, it runs every command by
//! itself and looks at what comes out.

#![allow(non_snake_case, missing_docs, reason = "formula symbols; the story says what each is")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods, reason = "it tests itself")]

mod design;
#[path = "../../common/every_kind.rs"]
mod every_kind;
mod figures;
mod form;
mod program;
mod proof;
mod rules;
mod slips;
mod tried;

use std::process::ExitCode;

use rodete::figure::Figure;
use rodete::finding::{Finding, Rule};
use rodete::gcode::control::Control;
use rodete::gcode::header::Origin;
use rodete::gcode::in_force::Spindle;
use rodete::gcode::program::Program;
use rodete::gcode::rules::modes::{CutsBeforeSpindle, NoFeed, SpindleStopped};
use rodete::kind::method::{Method, Of, Unproved};
use rodete::kind::{Chapters, Proved, Wants, out_of_format};
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Form};
use rodete::proof::agreement::Agreement;
use rodete::proof::due::Due;
use rodete::proof::feed::Feeds;
use rodete::proof::step::{Judge, Plan};
use rodete::proof::three_axes::{RapidsAbove, SpindleTurns};
use rodete::table::{Column, Index, Law, Print, Quantity, Table, Unit};
use rodete::text::{Text, t};

use crate::design::{BoltCircle, CLEAR};
use crate::form::{CASES, DEPTH, FORM, PITCH};
use crate::proof::{HolesAtAngles, route};

/// The kind.
enum Kind {}

impl Method for Kind {
    type Design = BoltCircle;
    type Model = ();
    type Memo = ();

    const FORM: &'static Form = &FORM;
    const CHAPTERS: &'static Chapters = &Chapters {
        labels: include_str!("labels.typ"),
        method: [include_str!("method-es.typ"), include_str!("method-en.typ")],
        setup: include_str!("setup.typ"),
        further: &[],
    };
    const CASES: &'static [Case] = &CASES;
    const RULES: &'static [&'static [&'static Rule]] = &[rules::RULES];
    // `Feeds` asks for the feed, `SpindleTurns` for the spindle: their checks say what the interpreter would remark.
    const ANSWERED: &'static [&'static Rule] = &[NoFeed::RULE, CutsBeforeSpindle::RULE, SpindleStopped::RULE];
    const PROVED: Text = t("Leída del programa, agujero a agujero", "Read back from the program, hole by hole");

    fn design(fields: &Fields) -> Result<BoltCircle, Vec<Finding>> {
        BoltCircle::new(fields)
    }

    fn control(circle: &BoltCircle) -> &'static Control {
        circle.post.control
    }

    fn model(_: &BoltCircle) -> Result<(), Vec<Finding>> {
        Ok(())
    }

    fn tables(circle: &BoltCircle, (): &()) -> Vec<Table> {
        let holes = || 0..circle.N;
        let column = |symbol, unit, law, value: &dyn Fn(u32) -> f64| {
            Column::numbers(symbol, unit, law, holes().map(value).collect::<Vec<_>>())
        };
        vec![Table {
            key: "holes",
            name: t("AGUJEROS", "HOLES"),
            title: t("Los agujeros", "The holes"),
            source: t("A partes iguales de la vuelta", "Equal parts of a turn"),
            index: Index::Point,
            print: Print::Short,
            columns: vec![
                column("φ", Unit::Degree, Law::Told("φ = α ± 360·i/N"), &|hole| circle.angle(hole)),
                column("x", Unit::Millimetre, Law::Told("x = D/2·cos φ"), &|hole| circle.at(hole)[0]),
                column("y", Unit::Millimetre, Law::Told("y = D/2·sin φ"), &|hole| circle.at(hole)[1]),
            ],
        }]
    }

    fn programs(circle: &BoltCircle, (): &(), origin: &Origin<'_>) -> Result<Unproved, Vec<Finding>> {
        let program =
            program::program(circle, origin).map_err(|error| vec![out_of_format(error, [PITCH.key(), DEPTH.key()])])?;
        Ok(Unproved { programs: vec![program], findings: Vec::new() })
    }

    fn memo(_: &BoltCircle, (): &(), _: Wants) {}

    fn fewer(_: &BoltCircle, _: &Program) -> Text {
        t("menos agujeros", "fewer holes")
    }

    fn plan<'a>(circle: &'a BoltCircle, (): &'a (), _: &'a Program) -> Plan<'a> {
        route(circle).plan()
    }

    fn judges<'a>(circle: &'a BoltCircle, (): &(), (): &mut (), _: &Program) -> Vec<Box<dyn Judge + 'a>> {
        vec![
            Box::new(Agreement::along(&route(circle))),
            Box::new(Feeds::of_three_axes(Some(circle.F), None)),
            Box::new(RapidsAbove::the_plane(CLEAR)),
            Box::new(SpindleTurns::at(Spindle::Clockwise, circle.S)),
            Box::new(HolesAtAngles::of(circle)),
        ]
    }

    fn due(_: &BoltCircle, _: &Program) -> Vec<Due> {
        ["agreement", "feed-tip", "clearance", "spindle", "angles"].map(Due::judged).to_vec()
    }

    fn quantities(circle: &BoltCircle, (): &(), _: &[Proved]) -> Vec<Quantity> {
        let [from, to] = [circle.at(0), circle.at(1)];
        vec![Quantity {
            symbol: "c",
            meaning: t("De agujero a agujero", "From hole to hole"),
            value: (to[0] - from[0]).hypot(to[1] - from[1]),
            unit: Unit::Millimetre,
            source: t("cuerda", "chord"),
            cell: None,
        }]
    }

    fn figures(circle: &BoltCircle, (): &(), (): &()) -> Vec<Figure> {
        figures::figures(circle)
    }
}

fn main() -> ExitCode {
    let first = std::env::args().nth(1).unwrap_or_default();
    if ["new", "check", "build", "view", "verify", "explain", "typst", "help", "--version"].contains(&first.as_str()) {
        return rodete::cli::run(std::env::args_os(), &[&Of::<Kind>::new()]);
    }
    tried::tried();
    slips::every_slip_stops_the_build();
    ExitCode::SUCCESS
}
