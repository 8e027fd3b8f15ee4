//! One XML part of the package: that it is UTF-8, well formed and without a document type, and what stands in it.

use std::borrow::Cow;

use quick_xml::Reader;
use quick_xml::escape::{resolve_xml_entity, unescape};
use quick_xml::events::{BytesStart, Event};

use crate::escape::{excerpt, printable};
use crate::finding::{Exit, Place, Raise, Refusal};

use super::limits;
use super::rules::package::*;

/// The refusal of a part that cannot be read.
pub fn damaged(part: &str, row: &impl Raise) -> Refusal {
    row.refused(Exit::Unreadable, Place::Part(part.to_owned()))
}

/// The refusal of a part that exceeds a limit.
pub fn limit(part: &str, row: &impl Raise) -> Refusal {
    row.refused(Exit::Limit, Place::Part(part.to_owned()))
}

/// The text of a part.
///
/// # Errors
/// Refuses UTF-16 with [`Exit::Refused`] (calamine would take such a sheet for an empty one), anything else that is not
/// UTF-8 with [`Exit::Unreadable`].
pub fn text(part: &str, bytes: Vec<u8>) -> Result<String, Refusal> {
    let name = printable(part);
    if matches!(bytes.as_slice(), [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [b'<', 0, ..] | [0, b'<', ..]) {
        return Err(PartUtf16 { part: name }.refused(Exit::Refused, Place::Part(part.to_owned())));
    }
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        damaged(part, &PartNotUtf8 { part: name, byte })
    })
}

/// Reads a part to its end and shows every event to `visit`, together with its depth: the root element's start and end
/// have depth 1, the texts inside it too. Empty elements come as a start and an end.
///
/// # Errors
/// Refuses with [`Exit::Unreadable`] a part that is not well formed, that ends early, that declares a document type or
/// another encoding, or that uses an entity of its own; with [`Exit::Limit`] one of more depth or more attributes than
/// [`limits`] allows; and whatever `visit` refuses.
pub fn walk<'a>(
    part: &str,
    text: &'a str,
    mut visit: impl FnMut(usize, &Event<'a>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let name = printable(part);
    let mut reader = Reader::from_str(text);
    reader.config_mut().expand_empty_elements = true;
    let mut depth = 0_usize;
    let mut rooted = false;
    let ill_formed =
        |byte: u64, why: &str| damaged(part, &PartIllFormed { part: name.clone(), byte, reason: excerpt(why, 120) });
    // Not of XML, whose readers disagree on them: to calamine a form feed parts two attributes, to this walk it is of a name.
    let control = |byte: &u8| *byte < b' ' && !b"\t\n\r".contains(byte);
    if let Some((at, byte)) = text.as_bytes().iter().enumerate().find(|(_, byte)| control(byte)) {
        return Err(ill_formed(u64::try_from(at).unwrap_or(u64::MAX), &format!("U+{byte:04X}")));
    }
    loop {
        let event = match reader.read_event() {
            Ok(event) => event,
            Err(error) => return Err(ill_formed(reader.error_position(), &error.to_string())),
        };
        match &event {
            Event::Start(start) => {
                depth += 1;
                rooted = true;
                if depth > limits::DEPTH {
                    return Err(limit(part, &PartTooDeep { part: name, most: limits::DEPTH }));
                }
                for (count, attribute) in start.attributes().enumerate() {
                    if count >= limits::ATTRIBUTES {
                        return Err(limit(part, &TooManyAttributes { part: name, most: limits::ATTRIBUTES }));
                    }
                    let checked = attribute.map_err(|error| error.to_string());
                    let checked = checked.and_then(|one| match unescape(&one.value) {
                        Ok(_) => Ok(()),
                        Err(error) => Err(error.to_string()),
                    });
                    checked.map_err(|why| ill_formed(reader.buffer_position(), &why))?;
                }
                visit(depth, &event)?;
            }
            Event::End(_) => {
                visit(depth, &event)?;
                depth = depth.saturating_sub(1);
            }
            Event::DocType(_) => {
                return Err(damaged(part, &DocumentType { part: name }));
            }
            Event::Decl(declaration) => {
                if let Some(encoding) = declaration.encoding() {
                    let encoding = encoding.unwrap_or_default();
                    if !["utf-8", "utf8", "us-ascii"].iter().any(|one| encoding.eq_ignore_ascii_case(one)) {
                        let encoding = excerpt(&encoding, 40);
                        return Err(damaged(part, &OtherEncoding { part: name, encoding }));
                    }
                }
            }
            Event::GeneralRef(reference) => {
                let known = resolve_xml_entity(reference).is_some()
                    || reference.resolve_char_ref().is_ok_and(|character| character.is_some());
                if !known {
                    let entity = excerpt(reference, 40);
                    return Err(ill_formed(reader.buffer_position(), &format!("&{entity};")));
                }
                visit(depth, &event)?;
            }
            Event::Eof => {
                return if depth == 0 && rooted { Ok(()) } else { Err(damaged(part, &PartCutOff { part: name })) };
            }
            _ => visit(depth, &event)?,
        }
    }
}

/// An attribute as it stands in the part, its entities not resolved: this is how calamine compares it.
pub fn raw<'a>(start: &'a BytesStart<'_>, name: &str) -> Option<Cow<'a, str>> {
    start.attributes().flatten().find(|attribute| attribute.key.as_ref() == name).map(|attribute| attribute.value)
}

/// An attribute with its entities resolved.
pub fn attribute(start: &BytesStart<'_>, name: &str) -> Option<String> {
    raw(start, name).and_then(|value| unescape(&value).ok().map(Cow::into_owned))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal_of(text: &str) -> String {
        match walk("xl/p.xml", text, |_, _| Ok(())) {
            Ok(()) => String::new(),
            Err(refusal) => refusal.findings.into_iter().map(|finding| finding.what.en.into_owned()).collect(),
        }
    }

    #[test]
    fn a_well_formed_part_passes_with_its_depths() {
        let mut seen = Vec::new();
        let walked = walk("p", "<a><b c='&lt;'/>x &amp; &#65;</a>", |depth, event| {
            match event {
                Event::Start(start) => seen.push((depth, start.local_name().as_ref().to_owned())),
                Event::Text(text) => seen.push((depth, text.to_string())),
                _ => {}
            }
            Ok(())
        });
        assert!(walked.is_ok());
        let named = |depth, name: &str| (depth, name.to_owned());
        assert_eq!(seen, [named(1, "a"), named(2, "b"), named(1, "x "), named(1, " ")]);
    }

    #[test]
    fn what_is_not_well_formed_is_refused_with_its_place() {
        assert!(refusal_of("<a><b></a>").contains("not well formed at byte"));
        assert!(refusal_of("<a b='1' b='2'/>").contains("not well formed"));
        assert!(refusal_of("<a b='&x;'/>").contains("not well formed"));
        assert!(refusal_of("<a b='1' \u{c}c='2'/>").contains("not well formed at byte 9 (U+000C)"));
        assert!(refusal_of("<a>\u{0}</a>").contains("U+0000"));
        assert!(refusal_of("<a>&xxe;</a>").contains("&xxe;"));
        assert!(refusal_of("<a>").contains("cut off"));
        assert!(refusal_of("").contains("cut off"));
        assert!(refusal_of("<!DOCTYPE a [<!ENTITY x 'y'>]><a/>").contains("document type"));
        assert!(refusal_of("<?xml version='1.0' encoding='ISO-8859-1'?><a/>").contains("ISO-8859-1"));
    }
}
