//! The file: page, style, scripts and scene.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use crate::scene::Scene;
use crate::text::Language;

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("style.css");
/// In this order: each script uses the earlier ones.
const SCRIPTS: [&str; 11] = [
    include_str!("words.js"),
    include_str!("scene.js"),
    include_str!("metal.js"),
    include_str!("camera.js"),
    include_str!("bodies.js"),
    include_str!("gl.js"),
    include_str!("flat.js"),
    include_str!("list.js"),
    include_str!("panel.js"),
    include_str!("pointer.js"),
    include_str!("main.js"),
];

/// The last script of a page that refreshes itself.
const REFRESH: &str = include_str!("refresh.js");

/// JSON for a script element: `<` is escaped, so no text can end the element.
struct Inside;

impl Formatter for Inside {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        let mut parts = fragment.split('<');
        writer.write_all(parts.next().unwrap_or_default().as_bytes())?;
        parts.try_for_each(|part| {
            writer.write_all(b"\\u003c")?;
            writer.write_all(part.as_bytes())
        })
    }
}

/// Writes the file that shows a scene.
///
/// # Errors
/// Passes on the error of `out`.
pub fn write(scene: &Scene, out: &mut dyn Write) -> io::Result<()> {
    written(scene, &[], out)
}

/// Writes the file that shows a scene, and loads itself again every few seconds while nobody uses it: whoever writes it anew
/// is seen in the browser.
///
/// # Errors
/// Passes on the error of `out`.
pub fn write_live(scene: &Scene, out: &mut dyn Write) -> io::Result<()> {
    written(scene, &[REFRESH], out)
}

fn written(scene: &Scene, more: &[&str], out: &mut dyn Write) -> io::Result<()> {
    let language = if scene.language == Language::Es { "es" } else { "en" };
    // Each mark appears once in the page, in this order.
    let mut rest = PAGE;
    for mark in ["{{language}}", "{{title}}", "{{style}}", "{{scene}}", "{{script}}"] {
        let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
        out.write_all(before.as_bytes())?;
        rest = after;
        match mark {
            "{{language}}" => out.write_all(language.as_bytes())?,
            "{{title}}" => out.write_all(element_text(&scene.title).as_bytes())?,
            "{{style}}" => out.write_all(STYLE.as_bytes())?,
            "{{scene}}" => scene.serialize(&mut Serializer::with_formatter(&mut *out, Inside))?,
            _ => SCRIPTS.iter().chain(more).try_for_each(|script| out.write_all(script.as_bytes()))?,
        }
    }
    out.write_all(rest.as_bytes())
}

/// The file that shows a scene.
#[must_use]
pub fn html(scene: &Scene) -> String {
    let mut bytes = Vec::new();
    // A Vec takes every write.
    let _ = write(scene, &mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

fn element_text(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::LINUXCNC;
    use crate::machine::chain::Chain;
    use crate::scene::program::Program;
    use crate::text::Text;

    fn scene(title: &str, block: &str) -> Scene {
        Scene {
            title: title.to_owned(),
            language: Language::En,
            meshes: Vec::new(),
            curves: Vec::new(),
            programs: vec![Program::new(Text::same("p"), &LINUXCNC, Chain::Milling, block)],
        }
    }

    #[test]
    fn no_text_of_a_user_ends_an_element() {
        let page = html(&scene("</title><script>alert(1)", "(</script><script>alert(2)</script>\u{2028}{{script}})"));
        let plain = html(&scene("a", "b"));
        for mark in ["<script", "</script", "</title", "<!--"] {
            assert_eq!(page.matches(mark).count(), plain.matches(mark).count(), "{mark}");
        }
        assert!(page.contains("&lt;script&gt;alert(1)") && page.contains("\\u003cscript>alert(2)"));
    }

    #[test]
    fn the_page_is_whole_and_names_no_other_place() {
        let page = html(&scene("a", "b"));
        assert!(!page.contains("{{") && page.ends_with("</html>\n"));
        assert!(
            page.contains("default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:")
        );
        for outside in ["http:", "https:", "//cdn", "@import", "url("] {
            assert!(!page.contains(outside), "{outside}");
        }
        assert_eq!(page, html(&scene("a", "b")));
    }

    #[test]
    fn only_a_live_page_loads_itself_again() {
        let (scene, mut live) = (scene("a", "b"), Vec::new());
        write_live(&scene, &mut live).unwrap();
        let live = String::from_utf8(live).unwrap();
        assert!(live.contains("location.reload()") && live.ends_with("</html>\n"));
        assert_eq!(live.replace(REFRESH, ""), html(&scene));
        assert!(!html(&scene).contains("location.reload()"));
    }

    #[test]
    fn every_script_is_short_enough_to_be_read() {
        for script in SCRIPTS.iter().chain([&PAGE, &STYLE, &REFRESH]) {
            assert!(script.lines().count() <= 600, "{}", script.lines().next().unwrap_or_default());
        }
    }
}
