//! How lines and areas look: few colours, each with a meaning, and never a colour alone.
//!
//! Every look has a width and a pattern of its own, so that a figure can be read in print without colours and by
//! whoever sees no difference between two of them. In a page the colours come from CSS variables; the plain
//! colours beside them have a contrast of 3 or more against the grounds of mdBook's five themes, which a test
//! computes, and letters take the page's own ink.

/// What a colour says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Lines and letters as in the text around.
    Ink,
    /// The ground.
    Paper,
    /// Looked at on the way: a cell, a node, a slab.
    Visited,
    /// Tested and refused.
    Rejected,
    /// The answer: the root that counts, the nearest hit, the interval that is left. Nothing else.
    Answer,
    /// Light on its way from a lamp, and where it arrives.
    Light,
    /// Never looked at.
    Culled,
}

impl Colour {
    pub(in crate::figure) const ALL: [Self; 7] = [
        Self::Ink,
        Self::Paper,
        Self::Visited,
        Self::Rejected,
        Self::Answer,
        Self::Light,
        Self::Culled,
    ];

    /// Those that are neither ink nor ground.
    pub(in crate::figure) const ACCENTS: [Self; 5] = [
        Self::Visited,
        Self::Rejected,
        Self::Answer,
        Self::Light,
        Self::Culled,
    ];

    /// Ends the name of a class.
    pub(in crate::figure) fn name(self) -> &'static str {
        match self {
            Self::Ink => "ink",
            Self::Paper => "paper",
            Self::Visited => "visited",
            Self::Rejected => "rejected",
            Self::Answer => "answer",
            Self::Light => "light",
            Self::Culled => "culled",
        }
    }

    /// The CSS variable that a page may set; those of ink and ground are mdBook's.
    pub(in crate::figure) fn variable(self) -> &'static str {
        match self {
            Self::Ink => "--fg",
            Self::Paper => "--bg",
            Self::Visited => "--raystep-visited",
            Self::Rejected => "--raystep-rejected",
            Self::Answer => "--raystep-answer",
            Self::Light => "--raystep-light",
            Self::Culled => "--raystep-culled",
        }
    }

    /// The colour where there are no variables: blue, vermilion, bluish green, amber and grey, of which the first three
    /// differ for all colour vision, and the fourth by its pattern.
    pub fn plain(self) -> [u8; 3] {
        match self {
            Self::Ink => [0x22, 0x22, 0x22],
            Self::Paper => [0xff, 0xff, 0xff],
            Self::Visited => [0x2f, 0x7f, 0xc1],
            Self::Rejected => [0xc0, 0x5f, 0x14],
            Self::Answer => [0x0f, 0x88, 0x68],
            Self::Light => [0x94, 0x71, 0x00],
            Self::Culled => [0x7b, 0x7b, 0x7b],
        }
    }

    /// The colour on a dark ground: the same hue, lighter.
    pub(in crate::figure) fn dark(self) -> [u8; 3] {
        match self {
            Self::Ink => [0xdd, 0xdd, 0xdd],
            Self::Paper => [0x1b, 0x1e, 0x22],
            Self::Visited => [0x66, 0xae, 0xea],
            Self::Rejected => [0xec, 0x8d, 0x4f],
            Self::Answer => [0x3d, 0xc4, 0x9b],
            Self::Light => [0xd4, 0xae, 0x3a],
            Self::Culled => [0x93, 0x93, 0x93],
        }
    }

    /// The shade for print without colours.
    pub(in crate::figure) fn grey(self) -> [u8; 3] {
        let shade = match self {
            Self::Ink | Self::Answer => 0x00,
            Self::Paper => 0xff,
            Self::Visited => 0x55,
            Self::Rejected => 0x66,
            Self::Light => 0x48,
            Self::Culled => 0x80,
        };
        [shade; 3]
    }
}

/// The pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Dash {
    Solid,
    Dashed,
    Dotted,
    /// A dash, a dot.
    Alternating,
    /// A dash, two dots.
    TwoDots,
    /// Dashes that are long, with narrow gaps.
    Long,
}

/// What an area is filled with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Fill {
    /// Nothing.
    Empty,
    /// A breath of the colour, through which lines and letters are seen.
    Faint,
    /// The colour itself.
    Full,
}

/// How much of the colour a faint area has. Letters on it keep a contrast of 4.5, as a test computes.
pub(in crate::figure) const FAINT: f64 = 0.12;

/// How a line or an area looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::figure) struct Look {
    pub(in crate::figure) colour: Colour,
    /// Width of the line in units of the sheet; 0 for none.
    pub(in crate::figure) width: f64,
    pub(in crate::figure) dash: Dash,
    pub(in crate::figure) fill: Fill,
    /// Does it pass in front? What lies below then ends a little before it.
    pub(in crate::figure) in_front: bool,
}

impl Look {
    const fn line(colour: Colour, width: f64, dash: Dash) -> Self {
        Self {
            colour,
            width,
            dash,
            fill: Fill::Empty,
            in_front: false,
        }
    }

    const fn area(colour: Colour, width: f64, dash: Dash) -> Self {
        Self {
            colour,
            width,
            dash,
            fill: Fill::Faint,
            in_front: false,
        }
    }

    /// Axes, frames, ticks.
    pub(in crate::figure) const THIN: Self = Self::line(Colour::Ink, 1.0, Dash::Solid);
    /// A light line beside a dark one, where the ground may have any colour.
    pub(in crate::figure) const PAPER_LINE: Self = Self::line(Colour::Paper, 3.0, Dash::Solid);
    /// Lines that help to see: projections, distances, what lies behind.
    pub(in crate::figure) const HELP: Self = Self::line(Colour::Ink, 1.0, Dash::Dashed);
    /// An object that nothing is said about.
    pub(in crate::figure) const OBJECT: Self = Self::area(Colour::Ink, 1.25, Dash::Solid);
    /// An edge of an object that lies behind it.
    pub(in crate::figure) const HIDDEN: Self = Self::line(Colour::Ink, 1.0, Dash::Dotted);
    /// An eye ray.
    pub(in crate::figure) const RAY: Self = Self::line(Colour::Ink, 2.0, Dash::Solid);
    /// The line of a ray where the ray itself is not: behind its origin, or beyond its hit.
    pub(in crate::figure) const LINE_OF_RAY: Self = Self::line(Colour::Ink, 1.25, Dash::Dotted);
    /// A ray to a light.
    pub(in crate::figure) const SHADOW_RAY: Self = Self::line(Colour::Ink, 1.5, Dash::Dashed);
    /// A reflected ray.
    pub(in crate::figure) const REFLECTED_RAY: Self =
        Self::line(Colour::Ink, 2.0, Dash::Alternating);
    /// A refracted ray.
    pub(in crate::figure) const REFRACTED_RAY: Self = Self::line(Colour::Ink, 2.0, Dash::Long);
    /// A leg of a path of light.
    pub(in crate::figure) const LIGHT_RAY: Self = Self::line(Colour::Light, 1.75, Dash::Solid);
    /// A leg of a path of light that leads to what nobody looks at.
    pub(in crate::figure) const UNSEEN_LIGHT: Self = Self::line(Colour::Light, 1.5, Dash::Dotted);
    /// A leg of a path of light that is wasted.
    pub(in crate::figure) const WASTED_LIGHT: Self = Self::line(Colour::Culled, 0.8, Dash::Dashed);
    /// A line between a path of light and one from the eye.
    pub(in crate::figure) const CONNECTION: Self = Self::line(Colour::Visited, 1.5, Dash::TwoDots);
    /// Such a line with something between its ends.
    pub(in crate::figure) const BLOCKED_CONNECTION: Self =
        Self::line(Colour::Rejected, 1.25, Dash::Dashed);
    /// The answer.
    pub(in crate::figure) const ANSWER: Self = Self::area(Colour::Answer, 2.5, Dash::Solid);
    /// What a ray meets on its way to the answer.
    pub(in crate::figure) const MET: Self = Self::area(Colour::Ink, 2.25, Dash::Solid);
    /// What was tested and refused.
    pub(in crate::figure) const REJECTED: Self = Self::area(Colour::Rejected, 1.75, Dash::Dashed);
    /// What was looked at on the way.
    pub(in crate::figure) const VISITED: Self = Self::area(Colour::Visited, 1.5, Dash::Solid);
    /// What was never looked at.
    pub(in crate::figure) const CULLED: Self = Self::line(Colour::Culled, 1.25, Dash::Dotted);

    /// The same without its area.
    pub(in crate::figure) const fn outline(self) -> Self {
        Self {
            fill: Fill::Empty,
            ..self
        }
    }

    /// The area alone.
    pub(in crate::figure) const fn inside(self) -> Self {
        Self { width: 0.0, ..self }
    }

    /// Filled with its colour.
    pub(in crate::figure) const fn full(self) -> Self {
        Self {
            fill: Fill::Full,
            dash: Dash::Solid,
            ..self
        }
    }

    /// In front of what was drawn before.
    pub(in crate::figure) const fn in_front(self) -> Self {
        Self {
            in_front: true,
            ..self
        }
    }

    /// With a line of another width.
    pub(in crate::figure) const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }
}

/// mdBook's themes: the grounds and inks of light, rust, coal, navy and ayu (mdBook 0.5, `variables.css`).
#[cfg(test)]
const THEMES: [(&str, [u8; 3], [u8; 3], Shades); 7] = [
    (
        "light",
        [0xff, 0xff, 0xff],
        [0x00, 0x00, 0x00],
        Colour::plain,
    ),
    (
        "rust",
        [0xe1, 0xe1, 0xdb],
        [0x26, 0x26, 0x25],
        Colour::plain,
    ),
    ("coal", [0x13, 0x15, 0x16], [0x98, 0xa3, 0xad], Colour::dark),
    ("navy", [0x16, 0x19, 0x23], [0xbc, 0xbd, 0xd0], Colour::dark),
    ("ayu", [0x0f, 0x14, 0x19], [0xc5, 0xc5, 0xc5], Colour::dark),
    (
        "alone",
        [0xff, 0xff, 0xff],
        [0x22, 0x22, 0x22],
        Colour::plain,
    ),
    (
        "alone, dark",
        [0x1b, 0x1e, 0x22],
        [0xdd, 0xdd, 0xdd],
        Colour::dark,
    ),
];

/// Which shade a colour has in a theme.
#[cfg(test)]
type Shades = fn(Colour) -> [u8; 3];

#[cfg(test)]
mod tests {
    use super::*;

    /// The contrast of two colours: (L₁ + 0.05)/(L₂ + 0.05) with their relative luminances (WCAG 2.2).
    fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
        let luminance = |rgb: [f64; 3]| {
            let [r, g, b] = rgb.map(|channel| {
                let value = channel / 255.0;
                if value <= 0.04045 {
                    value / 12.92
                } else {
                    ((value + 0.055) / 1.055).powf(2.4)
                }
            });
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    fn mixed(ground: [f64; 3], colour: [f64; 3], share: f64) -> [f64; 3] {
        std::array::from_fn(|i| ground[i] + share * (colour[i] - ground[i]))
    }

    const LINES: [Colour; 5] = [
        Colour::Visited,
        Colour::Rejected,
        Colour::Answer,
        Colour::Light,
        Colour::Culled,
    ];

    #[test]
    fn black_on_white_has_a_contrast_of_21() {
        assert!((contrast([0.0; 3], [255.0; 3]) - 21.0).abs() < 1e-12);
    }

    #[test]
    fn lines_have_a_contrast_of_3_in_every_theme() {
        for (theme, ground, ink, shade) in THEMES {
            let ground = ground.map(f64::from);
            let found = contrast(ground, ink.map(f64::from));
            assert!(4.5 <= found, "{theme}: ink {found}");
            for colour in LINES {
                let found = contrast(ground, shade(colour).map(f64::from));
                assert!(3.0 <= found, "{theme}: {colour:?} {found}");
            }
        }
        for colour in LINES {
            let found = contrast([255.0; 3], colour.grey().map(f64::from));
            assert!(3.0 <= found, "in print: {colour:?} {found}");
        }
    }

    #[test]
    fn letters_on_faint_areas_have_a_contrast_of_4_5_in_every_theme() {
        for (theme, ground, ink, shade) in THEMES {
            let (ground, ink) = (ground.map(f64::from), ink.map(f64::from));
            let colours = LINES.map(|colour| shade(colour).map(f64::from));
            for colour in colours.into_iter().chain([ink]) {
                // two areas above each other
                let once = mixed(ground, colour, FAINT);
                let twice = mixed(once, colour, FAINT);
                let found = contrast(twice, ink);
                assert!(4.5 <= found, "{theme}: {colour:?} {found}");
            }
        }
    }
}
