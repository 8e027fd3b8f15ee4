//! The program: over each hole, down, and up again.

use rodete::gcode::feed_word::FeedWord;
use rodete::gcode::header::{Header, Origin, Work};
use rodete::gcode::program::Program;
use rodete::gcode::word::Word;
use rodete::gcode::writer::Writer;
use rodete::number::grid::{Milli, OutOfFormat};
use rodete::text::t;

use crate::design::{BoltCircle, CLEAR};

pub fn program(circle: &BoltCircle, origin: &Origin<'_>) -> Result<Program, OutOfFormat> {
    let title = t("Agujeros", "Holes");
    let work = Work { part: &circle.part, material: "", number: 1 };
    let control = circle.post.control;
    let mut writer =
        Writer::new(circle.post, Header::new(control, "holes", &title, work, origin).parts).along_the_path();
    let (up, down) = (Milli::round(CLEAR)?, Milli::round(-circle.h)?);
    let way = CLEAR + circle.h;
    let F = FeedWord::lasting(writer.law(), 60.0 * way / circle.F, way)?;
    writer.safety();
    writer.block([Word::whole('S', circle.S), Word::whole('M', 3)]);
    writer.rapid([Word::size('Z', up)]);
    for hole in 0..circle.N {
        let [x, y] = circle.at(hole);
        writer.rapid([Word::size('X', Milli::round(x)?), Word::size('Y', Milli::round(y)?)]);
        writer.feed([Word::whole('G', 1), Word::size('Z', down)], F);
        writer.rapid([Word::size('Z', up)]);
    }
    writer.block([Word::whole('M', 5)]);
    writer.block([Word::whole('M', 30)]);
    Ok(writer.program("holes", title))
}
