//! The command `rodete`.

use std::process::ExitCode;

#[cfg(feature = "embedded-typst")]
mod embedded_typst;

#[expect(clippy::disallowed_methods, reason = "the door to the command line")]
fn main() -> ExitCode {
    #[cfg(feature = "embedded-typst")]
    if std::env::args_os().nth(1).is_some_and(|first| first == "typst") {
        let arguments: Vec<_> = std::env::args_os().skip(2).collect();
        return embedded_typst::compile(&arguments);
    }
    rodete::cli::run(std::env::args_os(), &rodete::kinds::KINDS)
}
