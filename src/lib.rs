//! `rodete` (Spanish: impeller): from a workbook of design parameters to checked tables, ISO programs and a report.
//!
//! What goes in: an `.xlsx` workbook whose first sheet holds the parameters of a [form](parameter::Form), found by their
//! symbols. What comes out: every table of the method as a sheet, the ISO programs that the machine reads, and a typeset
//! report; or a refusal that lists everything found, each with its cell and the remedy. Lengths are in millimetres, angles in
//! radians inside and in degrees in programs.
//!
//! # Concepts
//! A [`form`](parameter::Form) lists the parameters of a workbook kind with their limits; checked
//! [`values`](parameter::Values) become a [`design`](kinds::impeller::design::Design); its kind among the [`kinds`] turns it into
//! [`tables`](table::Table), [`programs`](gcode::program::Program) and [`findings`](finding::Finding), all of them in
//! one [`outcome`](kind::Outcome). Sheets, JSON, program files and the report are views of the outcome.
//!
//! # Floors
//! A module imports from the groups below its own only: `docs/dev/ARCHITECTURE.md` draws them, `tests/commands/house.rs` holds
//! it. Nothing below the walls reads a clock, a file, the environment or chance: the same input gives the same bytes on every
//! machine.
//!
//! # Example
//! The published case, from its values to the first motion block of a blade:
//!
//! ```
//! use rodete::kind::Provenance;
//! use rodete::kinds;
//! use rodete::kinds::impeller::cases::CASES;
//! use rodete::kinds::impeller::parameters::FORM;
//! use rodete::parameter::Values;
//! use rodete::text::Language;
//!
//! let published = CASES.iter().find(|case| case.name == "tfg-2021").unwrap();
//! let mut values = Values { language: Language::En, ..Values::default() };
//! values.values.extend(published.values(Language::En));
//! let source = Provenance { workbook: "case.xlsx".into(), sha256: "0".repeat(64), version: "1" };
//!
//! let outcome = kinds::run(&FORM, values, source).unwrap();
//! let blade = outcome.programs.iter().find(|program| program.key == "blade").unwrap();
//! assert_eq!(blade.text().lines().nth(1), Some("N20 G1 X11.2 Y14.933 Z0 B0 C0"));
//! ```

// From the ground up: a room uses those of the groups before its own, and no other (`tests/commands/house.rs`).
pub mod escape;
pub mod number;
pub mod text;

pub mod finding;
pub mod limits;
pub mod table;

pub mod machine;
pub mod parameter;

pub mod figure;
pub mod gcode;

pub mod geometry;
pub mod proof;
pub mod scene;

pub mod removal;

pub mod kind;

pub mod kinds;
pub mod sweep;

pub mod typeset;

pub mod drawing;
pub mod report;
pub mod store;
pub mod view;
pub mod workbook;

pub mod graft;

pub mod cli;
