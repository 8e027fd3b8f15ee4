//! An XML part as a tree whose elements know where they stand in its text.
//!
//! Edits are made at these places: what is not edited keeps its bytes, its prefixes, quotes and blanks.

use std::ops::Range;

use quick_xml::Reader;
use quick_xml::escape::{escape, resolve_xml_entity, unescape};
use quick_xml::events::{BytesStart, Event};

use crate::finding::Refusal;
use crate::workbook::xml;

/// An element of a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Element {
    /// Its name as it is written, with its prefix.
    pub name: String,
    /// Its attributes in order: names as written, values with their entities resolved.
    pub attributes: Vec<(String, String)>,
    /// Where it stands, from the first byte of its start tag to the last of its end tag.
    pub outer: Range<usize>,
    /// Where its contents stand; `None` where one tag is all of it.
    pub inner: Option<Range<usize>>,
    /// The elements in it.
    pub children: Vec<Self>,
    /// The texts in it, those of its children left out.
    pub text: String,
}

/// A name without its prefix.
pub fn local(name: &str) -> &str {
    name.rsplit_once(':').map_or(name, |(_, local)| local)
}

impl Element {
    /// Its name without a prefix.
    pub fn local(&self) -> &str {
        local(&self.name)
    }

    /// Its prefix with the colon; empty where it has none.
    pub fn prefix(&self) -> &str {
        self.name.rfind(':').and_then(|colon| self.name.get(..=colon)).unwrap_or_default()
    }

    /// The value of an attribute as it is named in the part.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(one, _)| one == name).map(|(_, value)| value.as_str())
    }

    /// True where an attribute says so; the format writes `1`, `true` and `on`.
    pub fn says(&self, name: &str) -> bool {
        self.attribute(name).is_some_and(|value| matches!(value.trim(), "1" | "true" | "on"))
    }

    /// Gives an attribute another value, or adds it.
    pub fn set(&mut self, name: &str, value: &str) {
        match self.attributes.iter_mut().find(|(one, _)| one == name) {
            Some((_, old)) => value.clone_into(old),
            None => self.attributes.push((name.to_owned(), value.to_owned())),
        }
    }

    /// The first child of a name without prefix.
    pub fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|one| one.local() == name)
    }

    /// The children of a child.
    pub fn listed(&self, name: &str) -> &[Self] {
        self.child(name).map_or(&[], |one| &one.children)
    }

    /// The start tag with other attributes; `closed`: one tag is all of the element.
    pub fn tag(&self, closed: bool) -> String {
        let mut tag = format!("<{}", self.name);
        for (name, value) in &self.attributes {
            tag.push_str(&format!(" {name}=\"{}\"", escape(value)));
        }
        tag.push_str(if closed { "/>" } else { ">" });
        tag
    }

    /// The element written anew, all names with this prefix.
    pub fn written(&self, prefix: &str) -> String {
        let mut bare = self.clone();
        bare.name = format!("{prefix}{}", self.local());
        bare.attributes.retain(|(name, _)| !name.contains(':') && name != "xmlns");
        if self.children.is_empty() && self.text.trim().is_empty() {
            return bare.tag(true);
        }
        let children: String = self.children.iter().map(|one| one.written(prefix)).collect();
        let text = if self.children.is_empty() { escape(&self.text).into_owned() } else { String::new() };
        format!("{}{text}{children}</{}>", bare.tag(false), bare.name)
    }

    /// What it says, whatever prefixes, order of attributes and blanks it is written with.
    pub fn canonical(&self) -> String {
        let mut attributes: Vec<_> =
            self.attributes.iter().filter(|(name, _)| !name.contains(':') && name != "xmlns").collect();
        attributes.sort();
        let children: Vec<String> = self.children.iter().map(Self::canonical).collect();
        format!("{}{attributes:?}{:?}{children:?}", self.local(), self.text.trim())
    }
}

/// The root element of a part, which is well formed.
///
/// # Errors
/// As [`xml::text`] and [`xml::walk`].
pub fn parse(part: &str, bytes: Vec<u8>) -> Result<(String, Element), Refusal> {
    let text = xml::text(part, bytes)?;
    xml::walk(part, &text, |_, _| Ok(()))?;
    let root = tree(&text);
    Ok((text, root))
}

/// The tree of a text that is known to be well formed.
fn tree(text: &str) -> Element {
    // The mark of the encoding is no part of the document, but it counts as bytes of the text.
    let bare = text.strip_prefix('\u{feff}').unwrap_or(text);
    let base = text.len() - bare.len();
    let mut reader = Reader::from_str(bare);
    let mut open: Vec<Element> = vec![Element::default()];
    let at = |position: u64| base + usize::try_from(position).unwrap_or_default();
    loop {
        let from = at(reader.buffer_position());
        let Ok(event) = reader.read_event() else { break };
        let to = at(reader.buffer_position());
        match event {
            Event::Start(start) => {
                open.push(Element { outer: from..from, inner: Some(to..to), ..element(&start) });
            }
            Event::Empty(start) => {
                let element = Element { outer: from..to, ..element(&start) };
                if let Some(parent) = open.last_mut() {
                    parent.children.push(element);
                }
            }
            Event::End(_) => {
                let Some(mut done) = open.pop() else { break };
                done.outer.end = to;
                if let Some(inner) = &mut done.inner {
                    inner.end = from;
                }
                let Some(parent) = open.last_mut() else { break };
                parent.children.push(done);
            }
            Event::Text(text) => add(&mut open, &text),
            Event::CData(text) => add(&mut open, &text),
            Event::GeneralRef(reference) => {
                let character = reference.resolve_char_ref().ok().flatten().map(String::from);
                let said = character.or_else(|| resolve_xml_entity(&reference).map(str::to_owned));
                add(&mut open, &said.unwrap_or_default());
            }
            Event::Eof => break,
            Event::Comment(_) | Event::PI(_) | Event::Decl(_) | Event::DocType(_) => {}
        }
    }
    open.into_iter().next().and_then(|mut document| document.children.pop()).unwrap_or_default()
}

fn add(open: &mut [Element], text: &str) {
    if let Some(element) = open.last_mut() {
        element.text.push_str(text);
    }
}

/// Name and attributes of a tag.
pub fn element(start: &BytesStart<'_>) -> Element {
    let attributes = start.attributes().flatten().map(|one| {
        let value = unescape(&one.value).map_or_else(|_| one.value.to_string(), |value| value.into_owned());
        (one.key.as_ref().to_owned(), value)
    });
    Element { name: start.name().as_ref().to_owned(), attributes: attributes.collect(), ..Element::default() }
}

/// Changes at places of a text.
#[derive(Debug, Default)]
pub struct Splices {
    edits: Vec<(Range<usize>, String)>,
}

impl Splices {
    /// Puts a text in the place of another.
    pub fn replace(&mut self, place: Range<usize>, text: impl Into<String>) {
        self.edits.push((place, text.into()));
    }

    /// Puts a text before a byte.
    pub fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(at..at, text);
    }

    /// Adds to the contents of an element, at their end.
    pub fn append(&mut self, to: &Element, text: &str) {
        match &to.inner {
            Some(inner) => self.insert(inner.end, text),
            None => self.replace(to.outer.clone(), format!("{}{text}</{}>", to.tag(false), to.name)),
        }
    }

    /// True where nothing is to be changed.
    pub const fn is_empty(&self) -> bool {
        self.edits.is_empty()
    }

    /// The text with the changes; what is put before a byte stands before what replaces it.
    pub fn apply(mut self, text: &str) -> String {
        self.edits.sort_by_key(|(place, _)| (place.start, place.end));
        let mut done = String::with_capacity(text.len() + self.edits.iter().map(|(_, new)| new.len()).sum::<usize>());
        let mut at = 0;
        for (place, new) in &self.edits {
            done.push_str(text.get(at..place.start).unwrap_or_default());
            done.push_str(new);
            at = at.max(place.end);
        }
        done.push_str(text.get(at..).unwrap_or_default());
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\u{feff}<?xml version='1.0'?><x:a xmlns:x='u'><!-- <x:b/> --><x:b c='1&lt;'/><x:d>e&amp;<![CDATA[f]]></x:d></x:a>";

    #[test]
    fn every_element_knows_its_place() {
        let (text, root) = parse("p", TEXT.as_bytes().to_vec()).expect("well formed");
        let shown = |range: &Range<usize>| text[range.clone()].to_owned();
        assert_eq!(root.prefix(), "x:");
        assert_eq!(shown(&root.children[0].outer), "<x:b c='1&lt;'/>");
        assert_eq!(root.children[0].attribute("c"), Some("1<"));
        assert_eq!(root.children[1].inner.as_ref().map(shown).as_deref(), Some("e&amp;<![CDATA[f]]>"));
        assert_eq!(root.children[1].text, "e&f");
    }

    #[test]
    fn a_splice_leaves_the_rest_as_it_is() {
        let (text, root) = parse("p", TEXT.as_bytes().to_vec()).expect("well formed");
        let mut splices = Splices::default();
        splices.append(&root, "<x:g/>");
        splices.append(&root.children[0], "<x:h/>");
        let after = splices.apply(&text);
        assert_eq!(
            after,
            TEXT.replace("</x:a>", "<x:g/></x:a>").replace("<x:b c='1&lt;'/>", "<x:b c=\"1&lt;\"><x:h/></x:b>")
        );
    }

    #[test]
    fn two_records_that_say_the_same_are_one() {
        let one = parse("p", b"<a><b c='1' d='2'/></a>".to_vec()).expect("well formed").1;
        let other = parse("p", b"<x:a xmlns:x='u'> <x:b d='2' c='1'></x:b></x:a>".to_vec()).expect("well formed").1;
        assert_eq!(one.canonical(), other.canonical());
        assert_eq!(one.written("y:"), "<y:a><y:b c=\"1\" d=\"2\"/></y:a>");
    }
}
