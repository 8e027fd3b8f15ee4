//! Judging programs: what a control would do with their text, held against the design.
//!
//! [`crate::kinds::impeller::proof::verify`] is the whole: each program is read back from its text once, motion by motion, and every judge
//! sees each motion in turn ([`step`]), so that a program of any length takes no memory. A judge answers with
//! [`check::Check`]s: the rows of the table of the verification, and the findings of those that failed.
//!
//! | judge | question |
//! |---|---|
//! | [`agreement`] | does the text say what was planned, point by point |
//! | [`closure`] | does the program end where it began |
//! | [`travel`] | do the axes stay within their travel |
//! | [`turning`] | does C run on without a jump |
//! | [`rollover`] | does it make the same motions whatever the rotary axes of the machine are |
//! | [`feed`] | is no axis, and the tip, faster than it may be |
//! | [`crate::kinds::impeller::proof::tip_path`] | how far does the tip leave its path between the blocks, and how fine must the steps be |
//! | [`crate::kinds::impeller::proof::floor`] | how much deeper than the floor does the tool's rim cut |
//! | [`crate::kinds::impeller::proof::flanks`] | does the tool keep clear of the other blades |
//! | [`crate::kinds::impeller::proof::stock`] | does it keep clear of the stock where it does not cut |
//! | [`text`] | are characters, numbers and lines such as the control takes them |
//! | [`arcs`] | how well do the radii of an arc agree |
//! | [`crate::kinds::impeller::proof::blank`] | does the turning program leave the torus, cut at the speeds and feeds asked for, and nowhere at rapid |

pub mod account;
pub mod agreement;
pub mod arcs;
pub mod check;
pub mod closure;
pub mod enclosed;
pub mod feed;
pub mod rollover;
pub mod step;
pub mod text;
pub mod track;
pub mod travel;
pub mod turning;
pub mod verification;
