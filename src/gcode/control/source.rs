//! Where what stands of a control comes from.

use crate::text::{Text, t};

/// A source of a control, or the lack of one. A page is named where it has been read, and never else.
#[derive(Clone, Debug)]
pub enum Source {
    /// A manual of the maker: its name, pages where they are known, and what of it stands here.
    Manual(Text),
    /// A work of others, as a table of codes or a simulator: its name, and what of it stands here.
    Published(Text),
    /// No page was at hand: of which behaviour, and what is taken in its place.
    NotFound(Text),
}

impl Source {
    /// The source as the page of the controls tells it.
    #[must_use]
    pub fn told(&self) -> Text {
        let (kind, text) = match self {
            Self::Manual(text) => return text.clone(),
            Self::Published(text) => (t("no del fabricante", "not the maker's"), text),
            Self::NotFound(text) => (t("sin página a mano", "no page at hand"), text),
        };
        Text::new(format!("{}: {}", kind.es, text.es), format!("{}: {}", kind.en, text.en))
    }
}
