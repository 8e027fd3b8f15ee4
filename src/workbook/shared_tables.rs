//! The tables of a workbook that calamine copies into memory whole: shared texts and cell formats.

use quick_xml::events::Event;

use crate::escape::excerpt;
use crate::finding::Refusal;

use super::limits;
use super::package::Package;
use super::rules::package::*;
use super::xml::{self, attribute, damaged, limit, raw};

/// Walks a part that describes the workbook; false where it is missing. No attribute may have more than `attribute` bytes.
pub fn structure(
    package: &mut Package<'_>,
    part: &str,
    attribute: usize,
    mut visit: impl FnMut(usize, &Event<'_>) -> Result<(), Refusal>,
) -> Result<bool, Refusal> {
    let Some(bytes) = package.part(part, limits::STRUCTURE)? else {
        return Ok(false);
    };
    let text = xml::text(part, bytes)?;
    xml::walk(part, &text, |depth, event| {
        if let Event::Start(start) = event
            && let Some(long) = start.attributes().flatten().find(|one| one.value.len() > attribute)
        {
            let (name, most) = (excerpt(long.key.as_ref(), 40), attribute);
            return Err(limit(part, &AttributeTooLong { attribute: name, most }));
        }
        visit(depth, event)
    })?;
    Ok(true)
}

/// Counts the shared texts; without a part there are none.
///
/// # Errors
/// [`Exit::Limit`](crate::finding::Exit::Limit) where more are announced than the part can hold or more stand in it than [`limits::STRINGS`];
/// [`Exit::Unreadable`](crate::finding::Exit::Unreadable) for a damaged part.
pub fn strings(package: &mut Package<'_>, part: &str) -> Result<usize, Refusal> {
    let Some(bytes) = package.part(part, limits::PART)? else {
        return Ok(0);
    };
    let text = xml::text(part, bytes)?;
    // Five bytes, `<si/>`, are the shortest text.
    let room = text.len() / 5;
    let mut count = 0_usize;
    let mut depth_of_text = None;
    xml::walk(part, &text, |depth, event| {
        match event {
            Event::Start(start) if start.local_name().as_ref() == "sst" => {
                let declared = raw(start, "uniqueCount").and_then(|value| value.trim().parse::<u128>().ok());
                let room = room.min(limits::STRINGS);
                if declared.is_some_and(|declared| u128::try_from(room).is_ok_and(|room| declared > room)) {
                    return Err(limit(part, &TextsAnnounced {}));
                }
            }
            Event::Start(start) if start.local_name().as_ref() == "si" => {
                if depth != 2 || depth_of_text.is_some() {
                    return Err(damaged(part, &TextsDamaged {}));
                }
                depth_of_text = Some(depth);
                count += 1;
                if count > limits::STRINGS {
                    return Err(limit(part, &TooManyTexts { most: limits::STRINGS }));
                }
            }
            Event::End(_) if depth_of_text == Some(depth) => depth_of_text = None,
            _ => {}
        }
        Ok(())
    })?;
    Ok(count)
}

/// Looks at the cell formats, which calamine copies into memory one by one.
///
/// # Errors
/// [`Exit::Limit`](crate::finding::Exit::Limit) for more of them, or for longer ones, than [`limits`] allows; [`Exit::Unreadable`](crate::finding::Exit::Unreadable) for a damaged part.
pub fn styles(package: &mut Package<'_>, part: &str) -> Result<(), Refusal> {
    let mut formats = 0_usize;
    let mut within = false;
    structure(package, part, limits::FORMAT_ATTRIBUTE, |_, event| {
        if matches!(event, Event::End(end) if end.local_name().as_ref() == "cellXfs") {
            within = false;
        }
        let Event::Start(start) = event else { return Ok(()) };
        match start.local_name().as_ref() {
            "cellXfs" => within = true,
            "xf" if within => {
                formats += 1;
                if formats > limits::FORMATS {
                    return Err(limit(part, &TooManyFormats { most: limits::FORMATS }));
                }
            }
            "numFmt" => {
                let code = attribute(start, "formatCode").unwrap_or_default();
                if code.matches('[').count() > limits::BRACKETS {
                    return Err(limit(part, &TooManyBrackets {}));
                }
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(())
}
