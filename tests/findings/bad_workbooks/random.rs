//! Whatever is done to a workbook at random, reading it ends in values or in a refusal.

use std::sync::LazyLock;

use proptest::prelude::*;
use rodete::finding::Grade;
use rodete::kinds::KINDS;
use rodete::kinds::impeller::cases::CASES;
use rodete::text::Language;

use super::workbook::{Parts, impeller, written};

static SOUND: LazyLock<Parts> = LazyLock::new(Parts::sound);
static WRITTEN: LazyLock<Vec<u8>> = LazyLock::new(|| written(KINDS[0], &CASES[0], Language::Es));
static PARTS: LazyLock<Parts> = LazyLock::new(|| Parts::of(&WRITTEN));

/// Reads the bytes; a refusal must have a reason.
fn ends(bytes: &[u8]) -> Result<(), TestCaseError> {
    if let Err(refusal) = impeller(bytes) {
        prop_assert!(refusal.findings.iter().any(|finding| finding.grade == Grade::Stop));
        prop_assert!(refusal.exit as u8 >= 3);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn flipped_bytes_and_a_cut_of_the_package(
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::weighted(0.3, any::<prop::sample::Index>()),
    ) {
        let mut bytes = WRITTEN.clone();
        for (index, flip) in flips {
            let at = index.index(bytes.len());
            bytes[at] ^= flip;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        ends(&bytes)?;
    }

    /// Past the checksums: the parts themselves are changed and packed anew.
    #[test]
    fn changed_parts(
        edits in prop::collection::vec(
            (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0_usize..12, prop::sample::select(vec![
                "", "<", ">", "\"", "&", "&#0;", "&#x110000;", "</c>", "<c>", "<v>", "<f>", "9999999999", "-", "inf", "XFD1048577",
                "t=\"s\" ", "t=\"n\" ", "t=\"e\" ", "r=\"A1\" ", "<row>", "<!--", "]]>", "\u{0}", "_xD800_", "[", "s=\"77\" ",
            ])),
            1..6,
        ),
    ) {
        let mut parts = PARTS.clone();
        for (part, place, removed, inserted) in edits {
            let part = part.index(parts.0.len());
            let content = &mut parts.0[part].1;
            let at = place.index(content.len() + 1);
            let end = (at + removed).min(content.len());
            content.splice(at..end, inserted.bytes());
        }
        ends(&parts.stored())?;
    }

    /// Values of every shape in the value cells.
    #[test]
    fn changed_values(
        key in prop::sample::select(vec!["schema", "R", "n", "splitters", "part", "start_codes", "B_max", "X_min"]),
        kind in prop::sample::select(vec!["", "t=\"n\"", "t=\"s\"", "t=\"b\"", "t=\"e\"", "t=\"str\"", "t=\"d\"", "t=\"inlineStr\"", "s=\"9\""]),
        value in "[-+0-9.,eE xX#/!NA \u{2212}\u{ff10}-\u{ff19}\u{0}-\u{1f}]{0,12}",
    ) {
        let parts = SOUND.clone().value(key, kind, &format!("<v>{}</v>", value.replace(['<', '&'], "")));
        ends(&parts.stored())?;
    }
}
