//! Pipes: their sizes as standards give them, what cuts a branch to fit a header, and the hole in the header.

pub mod dimensions;
mod form;
mod form_sketch;
pub mod hole;
pub mod insert;
mod live_form;
pub mod rates;
pub mod rules;
pub mod scene;
pub mod size;
mod sketch;
mod switching;

use crate::gcode::control::RotaryMode;
use crate::gcode::word::Distance;
use crate::kind::{Proved, Shown};
use crate::kinds::pipe::dimensions::Pipe;
use crate::proof::account::Account;
use crate::table::{Quantity, Unit};
use crate::text::{Text, t};

/// How a program turns its rotary axes: where those of the control are rollover as delivered, the number of an absolute word
/// would be an angle from 0 to 360 and its sign the direction. Increments are the same motions on either axis.
const fn counted(rotary: RotaryMode) -> Distance {
    match rotary {
        RotaryMode::Rollover => Distance::Incremental,
        RotaryMode::Linear => Distance::Absolute,
    }
}

/// Both pipes as they are measured before the start, whatever standard they come from, for the set-up sheet.
fn sizes(branch: Pipe, header: Pipe) -> Vec<(&'static str, Shown)> {
    let of = |[D, t]: [&'static str; 2], pipe: Pipe| [(D, Shown::Length(pipe.D)), (t, Shown::Length(pipe.t))];
    [of(["D_branch", "t_branch"], branch), of(["D_header", "t_header"], header)].into_iter().flatten().collect()
}

/// What the table of the torch's way is called; `kerf` in mm, 0 where nothing is compensated.
const fn way_title(kerf: f64) -> Text {
    if kerf > 0.0 {
        t(
            "Trayectoria de la antorcha, con el ancho de corte compensado",
            "Path of the torch, with the kerf compensated",
        )
    } else {
        t("Trayectoria de la antorcha, sin compensar el ancho de corte", "Path of the torch, the kerf not compensated")
    }
}

/// What the head of a program says of the kerf in mm, in Spanish and English. With 0 the torch goes along the curve itself.
fn kerf_in_header(kerf: f64) -> [String; 2] {
    if kerf > 0.0 {
        [format!("ANCHO DE CORTE {kerf:.3} COMPENSADO"), format!("KERF {kerf:.3} COMPENSATED")]
    } else {
        ["ANCHO DE CORTE SIN COMPENSAR".to_owned(), "KERF NOT COMPENSATED".to_owned()]
    }
}

/// What the program of a pipe comes to.
fn account(programs: &[Proved]) -> Account {
    programs.last().map(|program| program.account.clone()).unwrap_or_default()
}

/// A derived value that has no cell of its own yet.
const fn derived(symbol: &'static str, meaning: Text, value: f64, unit: Unit, source: Text) -> Quantity {
    Quantity { symbol, meaning, value, unit, source, cell: None }
}

/// How long the torch takes, where every motion has its time.
fn time(account: &Account) -> Option<Quantity> {
    let meaning = t("Duración con antorcha, con la espera", "Time with the torch, delay included");
    let known = !account.untimed && account.seconds > 0.0;
    known.then(|| derived("t_c", meaning, account.seconds, Unit::Second, t("programa leído", "program read back")))
}
