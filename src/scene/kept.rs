//! A program followed to its end, and what of it is kept to be shown.

use super::program::Program;
use super::rules::TooManyMotions;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::gcode::interpreter::{Interpreter, Refused, findings};
use crate::limits::{SHOWN_MOTIONS, SHOWN_REMARKS};
use crate::text::{Text, t};

/// Follows a program to its end and keeps what it does. What it says wrong is given back, with the worst of it.
///
/// # Errors
/// Exit 7 for more motions than [`SHOWN_MOTIONS`].
pub fn following(program: &mut Program, text: &mut Interpreter<'_>) -> Result<(Exit, Vec<Finding>), Refusal> {
    let (mut faults, mut total, mut exit): (Vec<Refused>, usize, Exit) = (Vec::new(), 0, Exit::Done);
    text.keep_stood();
    let mut moved = false;
    loop {
        let item = text.next();
        for stood in text.stood() {
            // Where the machine stands before its first motion a program alone does not say.
            let motion = item.as_ref().and_then(|item| item.as_ref().ok());
            let at = if moved || program.known { Some(&stood.at) } else { motion.map(|motion| &motion.to) };
            if let Some(at) = at
                && program.motions() < SHOWN_MOTIONS
            {
                program.stand(stood.line, &stood.control, at);
            }
        }
        let Some(item) = item else { break };
        moved |= item.is_ok();
        match item {
            Ok(motion) if program.motions() < SHOWN_MOTIONS => program.push(&motion, text.in_force()),
            Ok(_) => return Err(too_many(&program.title)),
            Err(fault) => {
                total += 1;
                if exit != Exit::Limit {
                    exit = fault.exit;
                }
                if faults.len() < SHOWN_REMARKS || fault.exit == Exit::Limit {
                    faults.push(*fault);
                }
            }
        }
    }
    let found = findings(faults, total, text.remarks());
    if program.turns_unseen() {
        program.notes.push(t(
            "Los ejes giratorios no se aplican: se dibujan X, Y y Z tal como están escritos; con el libro se ve la pieza",
            "Rotary axes are not applied: X, Y and Z are drawn as they are written; with the workbook the part is shown",
        ));
    }
    Ok((exit, found))
}

pub(crate) fn too_many(title: &Text) -> Refusal {
    TooManyMotions { title: title.clone(), most: SHOWN_MOTIONS }.refused(Exit::Limit, Place::File)
}
