//! `completions` and `man`: what a shell and `man` know of the command line.

use clap_complete::aot::generate;
use clap_mangen::Man;

use super::args::{Arguments, Completions, Manual};
use super::fault;
use super::refused;
use super::terminal::Terminal;
use crate::finding::Exit;
use crate::kind::Kind;
use crate::text::Language;

/// Prints the script that has a shell complete the command line.
pub(super) fn completions(arguments: &Completions, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let mut script = Vec::new();
    let program = terminal.program.as_str();
    generate(arguments.shell, &mut Arguments::command(program, kinds), program, &mut script);
    terminal.out(&String::from_utf8_lossy(&script));
    Exit::Done
}

/// Prints the man page of the program or of one of its commands.
pub(super) fn man(arguments: &Manual, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let program = terminal.program.clone();
    let mut whole = Arguments::command(&program, kinds).display_name(program.as_str());
    whole.build();
    let command = match &arguments.command {
        None => whole,
        Some(name) => match whole.find_subcommand(name) {
            Some(command) => command.clone().display_name(format!("{program}-{name}")),
            None => return refused(&fault::refusal("a command without a page"), Language::En, terminal),
        },
    };
    let mut page = Vec::new();
    match Man::new(command).render(&mut page) {
        Ok(()) => {
            terminal.out(&String::from_utf8_lossy(&page));
            Exit::Done
        }
        Err(error) => refused(&fault::refusal(&error.to_string()), Language::En, terminal),
    }
}
