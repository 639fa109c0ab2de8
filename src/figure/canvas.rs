//! The sheet that figures are drawn on: the one place that knows the crate `svg`, and how numbers are
//! written in a drawing.
//!
//! A drawing stands alone, in light and dark, and inside a page: there it takes the page's colours from
//! `--fg` and `--bg`, as mdBook's themes have them. Programs that know no variables take the plain colours,
//! which each element has as well. Every id and class begins with the drawing's own name, so that many
//! drawings fit into one page; no line is empty, which would end a block of HTML in Markdown.

use svg::Document;
use svg::node::element::{Description, Element, Style, Title};
use svg::node::{Node, Text as Words};

/// How something is drawn: no two differ by their colour alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Look {
    /// The ground.
    Paper,
    /// Letters.
    Letters,
    /// A thin line.
    Thin,
    /// An area filled to its edge.
    Full,
    /// An area that is little more than its outline.
    Outlined,
}

/// Which point of a line of letters is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// A property with a colour: the name of the variable, and the plain colour without one.
struct Colour {
    property: &'static str,
    variable: &'static str,
    plain: &'static str,
}

/// The colour of letters and lines in a page.
const INK: [&str; 2] = ["--fg", "#222222"];
/// The ground of a page.
const GROUND: [&str; 2] = ["--bg", "#ffffff"];
/// A blue and an orange, whose contrast is 3 or more against the grounds of mdBook's five themes, and which
/// differ for all colour vision.
const FIRST: [&str; 2] = ["--raystep-first", "#2f7fc1"];
/// The orange.
const SECOND: [&str; 2] = ["--raystep-second", "#c05f14"];

impl Look {
    const ALL: [Self; 5] = [
        Self::Paper,
        Self::Letters,
        Self::Thin,
        Self::Full,
        Self::Outlined,
    ];

    fn class(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Letters => "letters",
            Self::Thin => "thin",
            Self::Full => "full",
            Self::Outlined => "outlined",
        }
    }

    fn colours(self) -> Vec<Colour> {
        let colour = |property, [variable, plain]: [&'static str; 2]| Colour {
            property,
            variable,
            plain,
        };
        match self {
            Self::Paper => vec![colour("fill", GROUND)],
            Self::Letters => vec![colour("fill", INK)],
            Self::Thin => vec![colour("stroke", INK)],
            Self::Full => vec![colour("fill", FIRST)],
            Self::Outlined => vec![colour("fill", SECOND), colour("stroke", SECOND)],
        }
    }

    /// What is no colour.
    fn others(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Paper | Self::Letters | Self::Full => &[],
            Self::Thin => &[("fill", "none"), ("stroke-width", "1")],
            Self::Outlined => &[("fill-opacity", "0.15"), ("stroke-width", "2")],
        }
    }
}

/// A drawing.
pub(super) struct Canvas {
    id: String,
    document: Document,
}

/// Size of letters, in units of which the drawing is some 760 wide: as in a page's own text.
pub(super) const LETTERS: f64 = 14.0;

/// No line of digits and small letters is wider than that for each letter (DejaVu Sans, which is wide, has
/// 0.636 of the size for a digit).
pub(super) const ADVANCE: f64 = 0.65 * LETTERS;

impl Canvas {
    /// An empty sheet. The id is a word of letters, digits and `-`; title and description say what is drawn
    /// to who does not see it.
    pub(super) fn new(id: &str, [width, height]: [f64; 2], title: &str, description: &str) -> Self {
        let rules = Look::ALL.map(|look| {
            let set = look.colours().into_iter().map(|colour| {
                let Colour {
                    property,
                    variable,
                    plain,
                } = colour;
                format!("{property}: var({variable}, {plain})")
            });
            let set: Vec<String> = set.collect();
            format!(".{id}-{} {{ {} }}", look.class(), set.join("; "))
        });
        let rules = rules.join(" ");
        // who knows variables knows @supports; others keep the attributes. The dark colours are for a file
        // that stands alone: a page around it has colours of its own
        let style = format!(
            "@supports (fill: var(--fg)) {{ {rules} }} \
             @media (prefers-color-scheme: dark) {{ svg:root {{ --fg: #dddddd; --bg: #1b1e22 }} }}"
        );
        let [title_id, description_id] =
            ["title", "description"].map(|part| format!("{id}-{part}"));
        let document = Document::new()
            .set("id", id)
            .set("role", "img")
            .set("aria-labelledby", format!("{title_id} {description_id}"))
            .set("width", number(width))
            .set("height", number(height))
            .set(
                "viewBox",
                format!("0 0 {} {}", number(width), number(height)),
            )
            .set("style", "max-width: 100%; height: auto")
            .set("font-family", "system-ui, sans-serif")
            .set("font-size", number(LETTERS))
            .add(Title::new(allowed(title)).set("id", title_id))
            .add(
                Description::new()
                    .set("id", description_id)
                    .add(Words::new(allowed(description))),
            )
            .add(Style::new(style));
        let mut canvas = Self {
            id: id.into(),
            document,
        };
        canvas.rectangle(Look::Paper, [0.0, 0.0], [width, height]);
        canvas
    }

    /// A rectangle from its top left corner.
    pub(super) fn rectangle(&mut self, look: Look, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
        let place = [("x", x), ("y", y), ("width", width), ("height", height)];
        let element = self.element("rect", look, &place);
        self.document.append(element);
    }

    /// A straight line.
    pub(super) fn line(&mut self, look: Look, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        let place = [("x1", x1), ("y1", y1), ("x2", x2), ("y2", y2)];
        let element = self.element("line", look, &place);
        self.document.append(element);
    }

    /// A line of letters, in height around the place.
    pub(super) fn text(&mut self, anchor: Anchor, [x, y]: [f64; 2], text: &str) {
        /// Half the height of a capital in sizes of the letter.
        const HALF_CAPITAL: f64 = 0.36;
        let place = [("x", x), ("y", y + HALF_CAPITAL * LETTERS)];
        // not the crate's own element for text, which puts line breaks around the letters
        let mut element = self.element("text", Look::Letters, &place);
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => element.assign("text-anchor", "middle"),
            Anchor::End => element.assign("text-anchor", "end"),
        }
        element.append(Words::new(allowed(text)));
        self.document.append(element);
    }

    /// The drawing as a file.
    pub(super) fn into_svg(self) -> String {
        format!("{}\n", self.document)
    }

    fn element(&self, name: &str, look: Look, place: &[(&str, f64)]) -> Element {
        let mut element = Element::new(name);
        element.assign("class", self.class(look));
        for &(attribute, value) in place {
            element.assign(attribute, number(value));
        }
        for colour in look.colours() {
            element.assign(colour.property, colour.plain);
        }
        for &(attribute, value) in look.others() {
            element.assign(attribute, value);
        }
        element
    }

    fn class(&self, look: Look) -> String {
        format!("{}-{}", self.id, look.class())
    }
}

/// A number in a drawing: a hundredth of a unit is finer than any screen; what is not finite is 0.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    // + 0 turns -0 into 0
    let text = format!("{:.2}", (value * 100.0).round() / 100.0 + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// Text without the characters that XML 1.0 does not have; line breaks become spaces.
fn allowed(text: &str) -> String {
    let characters = text.chars().map(|c| match c {
        '\t' | '\n' | '\r' => ' ',
        '\0'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
        _ => c,
    });
    characters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_finite() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.001, "0"),
            (760.0, "760"),
            (0.125, "0.13"),
            (-1.5, "-1.5"),
            (f64::NAN, "0"),
            (f64::INFINITY, "0"),
        ] {
            assert_eq!(number(value), expected);
        }
    }

    #[test]
    fn a_name_cannot_break_the_drawing() {
        let mut canvas = Canvas::new("a", [9.0, 9.0], "<&\"\u{1}", "b\n\nc");
        canvas.text(Anchor::Start, [0.0, 0.0], "d < e");
        let svg = canvas.into_svg();
        assert!(svg.contains("&lt;&amp;\"\u{fffd}"), "{svg}");
        assert!(svg.contains("b  c"), "{svg}");
        assert!(svg.contains(">d &lt; e</text>"), "{svg}");
    }
}
