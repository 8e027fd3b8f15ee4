//! Turning on a lathe: what the tool takes away, against closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod removal {
    mod alarms;
    mod exact;
    mod judged;
    mod lathe;
    mod part;
    mod tools;
    mod volumes;
}
