//! The command `rodete`.

use std::process::ExitCode;

#[expect(clippy::disallowed_methods, reason = "the door to the command line")]
fn main() -> ExitCode {
    rodete::cli::run(std::env::args_os(), rodete::kinds::KINDS)
}
