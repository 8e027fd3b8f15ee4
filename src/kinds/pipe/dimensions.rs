//! Outside diameter and wall of branch and header as a form gives them: by nominal size and schedule, or as measured.

use crate::finding::{Finding, Key, Raise, Said, Size as Length, Typed};
use crate::kinds::pipe::form::{
    BRANCH_SCHEDULE, BRANCH_SIZE, D_BRANCH, D_HEADER, HEADER_SCHEDULE, HEADER_SIZE, T_BRANCH, T_HEADER,
};
use crate::kinds::pipe::rules::{NoSchedule, SizeMissing, TwoSizes, WallBeyondRadius};
use crate::kinds::pipe::size::{Schedule, Size};
use crate::parameter::at;
use crate::parameter::field::{Field, Fields, Optional};
use crate::text::{Language, Text, t};

/// Outside diameter and wall of a pipe, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// D, outside diameter, mm.
    pub D: f64,
    /// t, thickness of the wall, mm.
    pub t: f64,
}

/// The fields that give a pipe's size.
#[derive(Clone, Copy, Debug)]
struct SizeFields {
    size: &'static Field<&'static Size, Optional>,
    schedule: &'static Field<Schedule, Optional>,
    D: &'static Field<f64, Optional>,
    t: &'static Field<f64, Optional>,
}

const BRANCH: SizeFields = SizeFields { size: &BRANCH_SIZE, schedule: &BRANCH_SCHEDULE, D: &D_BRANCH, t: &T_BRANCH };
const HEADER: SizeFields = SizeFields { size: &HEADER_SIZE, schedule: &HEADER_SCHEDULE, D: &D_HEADER, t: &T_HEADER };

impl Pipe {
    /// The pipe of nominal size and schedule, or of outside diameter and wall; refused where both are given and differ, neither is
    /// given whole, or the schedule does not exist in that size.
    fn of(fields: &Fields, from: SizeFields) -> Result<Self, Box<Finding>> {
        let keys = [from.size.key(), from.schedule.key(), from.D.key(), from.t.key()];
        let [size, schedule, diameter, wall] = keys;
        let typed = (fields.get(from.D), fields.get(from.t));
        let named = (fields.get(from.size), fields.get(from.schedule));
        let (found, number) = match (named, typed) {
            ((None, None), (Some(D), Some(t))) => return Ok(Self { D, t }),
            ((Some(found), Some(Schedule(number))), _) => (found, number),
            _ => return Err(Box::new(SizeMissing { size, schedule, diameter, wall }.at(at(keys)))),
        };
        let &Size { nps, outside, .. } = found;
        let Some(thick) = found.wall(number) else {
            return Err(Box::new(NoSchedule { number, nps, diameter, wall }.at(at([size, schedule]))));
        };
        let other = |typed: Option<f64>, own: f64| typed.is_some_and(|typed| (typed - own).abs() > 1e-9);
        if other(typed.0, outside) || other(typed.1, thick) {
            let (outside, thick) = (Typed { value: outside, unit: "" }, Typed { value: thick, unit: "mm" });
            let told = TwoSizes { size, nps, number, outside, thick, diameter, wall };
            return Err(Box::new(told.at(at(keys))));
        }
        Ok(Self { D: outside, t: thick })
    }

    /// Branch and header.
    ///
    /// # Errors
    /// Where size or wall of one is missing or contradicts itself, for both at once.
    pub fn both(fields: &Fields) -> Result<[Self; 2], Vec<Finding>> {
        match [BRANCH, HEADER].map(|from| Self::of(fields, from)) {
            [Ok(branch), Ok(header)] => Ok([branch, header]),
            [one, other] => Err([one.err(), other.err()].into_iter().flatten().map(|finding| *finding).collect()),
        }
    }
}

/// The stops of pipes whose wall is no less than their radius.
#[must_use]
pub(super) fn solid(branch: Pipe, header: Pipe) -> Vec<Finding> {
    let of = |pipe: Pipe, name: Text, keys: [Key; 2]| {
        let (wall, radius) = (Length::mm(pipe.t), Length::mm(pipe.D / 2.0));
        (pipe.t >= pipe.D / 2.0).then(|| WallBeyondRadius { pipe: name, wall, radius }.at(at(keys)))
    };
    let branch = of(branch, t("del injerto", "of the branch"), [D_BRANCH.key(), T_BRANCH.key()]);
    let header = of(header, t("del tubo base", "of the header"), [D_HEADER.key(), T_HEADER.key()]);
    branch.into_iter().chain(header).collect()
}

/// What a remedy adds to a smaller branch, where an eccentricity would do as well.
#[must_use]
pub(super) fn or_eccentricity(most: Option<Length>) -> Text {
    most.map_or(t("", ""), |most| {
        let [es, en] = [Language::Es, Language::En].map(|language| most.said(language));
        Text::new(format!(", o una excentricidad de {es} como mucho"), format!(", or an eccentricity of {en} at most"))
    })
}
