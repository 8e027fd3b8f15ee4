//! The command `rodete`.

fn main() {}
