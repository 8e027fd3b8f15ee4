//! Parameters that the control itself keeps: position, modes, offsets.

use crate::gcode::code::G;
use crate::gcode::in_force::{Compensation, Spindle};
use crate::gcode::interpreter::Reader;
use crate::gcode::motion::{FeedMode, Plane};
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;

/// The first of the parameters that hold the position.
const POSITION: usize = 5420;
/// The tool in the spindle, then its offsets and its diameter.
const TOOL: usize = 5400;

/// Names that the control itself keeps and that depend on the machine and its operator, or are not followed here.
pub(super) const OF_THE_MACHINE: [&str; 13] = [
    "_vmajor",
    "_vminor",
    "_lathe_diameter_mode",
    "_lathe_radius_mode",
    "_mist",
    "_flood",
    "_speed_override",
    "_feed_override",
    "_adaptive_feed",
    "_feed_hold",
    "_current_pocket",
    "_selected_pocket",
    "_remap_level",
];

fn flag(on: bool) -> f64 {
    if on { 1.0 } else { 0.0 }
}

impl Reader<'_, '_> {
    /// A length of an axis in a unit; angles as they are.
    pub(super) fn in_unit(axis: Axis, value: f64, unit: LengthUnit) -> f64 {
        if axis.rotary() { value } else { unit.from_mm(value) }
    }

    /// Nine parameters as a pose in mm and degrees.
    pub(super) fn pose_of(&self, first: u32) -> Pose {
        let unit = self.memory.setting.unit;
        let mut pose = Pose::default();
        for (number, axis) in (first as usize..).zip(Axis::ALL) {
            let held = self.memory.parameters.get(number);
            pose.set(axis, if axis.rotary() { held } else { unit.to_mm(held) });
        }
        pose
    }

    /// Keeps a pose in nine parameters.
    pub(super) fn keep_pose(&mut self, first: u32, pose: &Pose) {
        let unit = self.memory.setting.unit;
        for (number, axis) in (first as usize..).zip(Axis::ALL) {
            self.memory.parameters.set(number, Self::in_unit(axis, pose.get(axis), unit));
        }
    }

    /// A numbered parameter that the control keeps.
    pub(super) fn system_number(&self, number: usize) -> Option<f64> {
        match number {
            POSITION..5429 => {
                let axis = *Axis::ALL.get(number - POSITION)?;
                Some(Self::in_unit(axis, self.state.at.get(axis), self.state.modal.unit))
            }
            TOOL => Some(f64::from(self.state.modal.tool)),
            5401..=5409 => {
                let axis = *Axis::ALL.get(number - TOOL - 1)?;
                let offset = self.memory.tools.get(&self.state.modal.tool).map_or(0.0, |tool| tool.offset.get(axis));
                Some(Self::in_unit(axis, offset, self.memory.setting.unit))
            }
            5410 => {
                let diameter = self.memory.tools.get(&self.state.modal.tool).map_or(0.0, |tool| tool.diameter);
                Some(self.memory.setting.unit.from_mm(diameter))
            }
            // The last two tell what the tool changer has reported.
            5411..=5413 | 5600..=5601 => Some(0.0),
            _ => None,
        }
    }

    /// A named parameter that the control keeps.
    pub(super) fn system_name(&self, name: &str) -> Option<f64> {
        let modal = &self.state.modal;
        let position = |axis: &str, pose: &Pose, unit| {
            let axis = Axis::ALL
                .into_iter()
                .find(|one| axis.len() == 1 && axis.starts_with(one.letter().to_ascii_lowercase()))?;
            Some(Self::in_unit(axis, pose.get(axis), unit))
        };
        if let Some(axis) = name.strip_prefix("_abs_") {
            return position(axis, &self.state.frame.to_machine(&self.state.at), modal.unit);
        }
        if let Some(axis) = name.strip_prefix('_')
            && let Some(found) = position(axis, &self.state.at, modal.unit)
        {
            return Some(found);
        }
        Some(match name {
            #[expect(clippy::cast_precision_loss, reason = "a line number")]
            "_line" => self.block.spot.line as f64,
            "_plane" => match modal.plane {
                Plane::XY => 170.0,
                Plane::ZX => 180.0,
                Plane::YZ => 190.0,
            },
            "_metric" => flag(modal.unit == LengthUnit::Millimetre),
            "_imperial" => flag(modal.unit == LengthUnit::Inch),
            "_absolute" => flag(!modal.incremental),
            "_incremental" => flag(modal.incremental),
            "_inverse_time" => flag(modal.feed_mode == FeedMode::InverseTime),
            "_units_per_minute" => flag(modal.feed_mode == FeedMode::PerMinute),
            "_units_per_rev" => flag(modal.feed_mode == FeedMode::PerRevolution),
            "_coord_system" => match modal.system {
                system @ 1..=6 => f64::from(530 + u16::from(system) * 10),
                system => f64::from(584 + u16::from(system)),
            },
            "_tool_offset" => flag(self.state.frame.tool != Pose::default()),
            "_retract_r_plane" => flag(!self.returns_initial()),
            "_retract_old_z" => flag(self.returns_initial()),
            "_spindle_rpm_mode" => flag(!modal.constant_surface_speed),
            "_spindle_css_mode" => flag(modal.constant_surface_speed),
            "_ijk_absolute_mode" => flag(modal.centre_absolute),
            "_ccomp" => match modal.compensation {
                Compensation::Off => 400.0,
                Compensation::Left => 410.0,
                Compensation::Right => 420.0,
            },
            "_motion_mode" => match modal.motion {
                G::Rapid => 0.0,
                G::Linear => 10.0,
                G::Arc(true) => 20.0,
                G::Arc(false) => 30.0,
                G::Cycle(cycle) => cycle.number() * 10.0,
                _ => 800.0,
            },
            "_spindle_on" => flag(modal.spindle != Spindle::Stopped),
            "_spindle_cw" => flag(modal.spindle == Spindle::Clockwise),
            // The F word as it was given, whatever unit has come since.
            "_feed" => modal.feed_word,
            // The control runs the program; only its preview reads 0.
            "_task" => 1.0,
            "_rpm" => modal.speed,
            "_current_tool" => f64::from(modal.tool),
            "_selected_tool" => modal.selected.map_or(-1.0, f64::from),
            #[expect(clippy::cast_precision_loss, reason = "at most some tens")]
            "_call_level" => self.memory.flow.frames.len() as f64,
            _ => return None,
        })
    }
}
