//! Where the motions come from that the judges see.

use crate::finding::Finding;
use crate::gcode::dialect::FeedLaw;
use crate::gcode::motion::{Feed, FeedMode, Kind, Motion};
use crate::gcode::program::{self, Part, Program};
use crate::machine::axis::Pose;

/// The motions of a program, one after another.
///
/// A program that begins wherever the machine stands may be counted from any point; [`super::step`] puts it where the
/// plan starts.
pub fn read_back(program: &Program) -> impl Iterator<Item = Result<Motion, Box<Finding>>> + '_ {
    let header = program.parts.iter().filter(|part| matches!(part, Part::Opening(_) | Part::Comment(_))).count();
    program.moves().map(move |each| {
        let kind = match (&each.path.feed, each.path.rapid) {
            (_, true) => Kind::Rapid,
            (program::Feed::Each { words, .. }, false) => {
                let mode = match program.dialect.feed {
                    FeedLaw::Resultant => FeedMode::PerMinute,
                    FeedLaw::Seconds => FeedMode::Seconds,
                    FeedLaw::InverseTime => FeedMode::InverseTime,
                };
                Kind::Feed(Feed { mode, value: words.get(each.step).map_or(0.0, |word| word.value()) })
            }
            (program::Feed::None, false) => Kind::Feed(Feed::default()),
        };
        let number = u32::try_from(each.line.saturating_sub(header)).ok();
        let to = Pose::from(each.to);
        Ok(Motion {
            line: each.line,
            n: program.block_step.zip(number).and_then(|(step, number)| step.checked_mul(number)),
            kind,
            from: Pose::from(each.from),
            to,
            machine: to,
            seconds: each.path.seconds(each.step),
        })
    })
}
