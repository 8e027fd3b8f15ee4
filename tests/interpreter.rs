//! rodete's interpreter of G-code against LinuxCNC's, `rs274`: programs by hand, programs by chance, and programs that
//! must be refused.

#[path = "interpreter/agreement.rs"]
mod agreement;
#[path = "interpreter/blank.rs"]
mod blank;
#[path = "interpreter/centre_words.rs"]
mod centre_words;
mod common;
#[path = "interpreter/corpus.rs"]
mod corpus;
#[path = "interpreter/doubt.rs"]
mod doubt;
#[path = "interpreter/expressions.rs"]
mod expressions;
#[path = "interpreter/generated.rs"]
mod generated;
#[path = "interpreter/generator.rs"]
mod generator;
#[path = "interpreter/kept.rs"]
mod kept;
#[path = "interpreter/limits.rs"]
mod limits;
#[path = "interpreter/milling.rs"]
mod milling;
#[path = "interpreter/ours.rs"]
mod ours;
#[path = "interpreter/rotary.rs"]
mod rotary;
#[path = "interpreter/soup.rs"]
mod soup;
#[path = "interpreter/source.rs"]
mod source;
