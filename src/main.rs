//! The command `rodete`.

use std::ffi::OsString;
use std::process::ExitCode;

#[cfg(feature = "embedded-typst")]
mod embedded_typst;

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    #[cfg(feature = "embedded-typst")]
    if let [first, rest @ ..] = arguments.as_slice()
        && first == "typst"
    {
        return embedded_typst::compile(rest);
    }
    let _ = arguments;
    ExitCode::SUCCESS
}
