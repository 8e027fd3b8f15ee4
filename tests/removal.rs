//! Turning on a lathe: what the tool takes away, against closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod removal {
    mod exact;
    mod lathe;
    mod volumes;
}
