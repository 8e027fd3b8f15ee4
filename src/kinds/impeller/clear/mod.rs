//! Cutting the part that was designed: a second method, beside the published one.
//!
//! The published programs run the tool w beside the mean line, along its N: they cut into the faces, go below the floor and
//! leave ribs. Here the floor is cut by lanes whose tool stands along its own normal and is never too deep ([`lane`],
//! [`contact`], [`scallop`]), the flanks by an axis fitted to the face ([`fit`], [`flank`]), the whole channel by roughing
//! levels, floor lanes, flanks and the contour of a splitter and the way round it ([`contour`], [`round`]), in one [`plan`];
//! where lanes leave too much before a nose, the tool leans (`lean`). What goes into the full is run slower (`engagement`). Where the points lie follows from a tolerance
//! ([`placement`]). Where a cut may be made partly, its passes begin where they enter no blade (`entered`). What is left all
//! the same is told ([`told`]); where a tool does not pass there is no plan ([`cut::DoesNotFit`]).

pub mod asked;
pub mod body;
pub mod contact;
pub mod contour;
pub mod cut;
pub mod draft;
mod engagement;
mod entered;
pub mod fields;
pub mod fit;
pub mod flank;
mod floor_feet;
pub mod floor_rest;
pub mod holder;
pub mod lane;
pub mod largest;
mod lean;
pub mod link;
pub mod pass;
pub mod pieces;
pub mod placement;
pub mod plan;
pub mod poses;
pub mod programs;
pub(in crate::kinds::impeller) mod remarks;
mod rests;
pub mod root;
pub mod round;
pub mod rules;
pub mod scallop;
pub mod table;
pub mod tables;
pub mod told;
pub mod tool;
pub mod uncut;
