//! The command `rodete`.

use std::process::ExitCode;

fn main() -> ExitCode {
    rodete::cli::run(std::env::args_os())
}
