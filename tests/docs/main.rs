//! The pages that people read: their commands are run, their links followed, their licences and reference pages held
//! against what they speak of.

#![allow(clippy::unwrap_used, clippy::disallowed_methods, missing_docs)]

mod commands;
mod json;
mod licences;
mod links;
mod markdown;
mod pages;
mod words;
