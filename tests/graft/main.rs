//! Sheets put into an engineer's own workbook: five hard books, again and again, after other programs, and what is refused.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

mod again;
mod command;
#[path = "../common/mod.rs"]
mod common;
mod corpus;
mod form_elsewhere;
mod guard;
mod hard_books;
mod killed;
mod libreoffice;
mod made;
mod names;
