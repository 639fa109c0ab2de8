//! Colours and signs of the terminal: those of the figures, as far as the terminal has them.
//!
//! Nothing is said by a colour alone. The ground is the terminal's own, light or dark: the figures' colours have a contrast of 3 or
//! more against both.

use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::border;

use crate::figure::Colour;
use crate::tui::sign::Sign;

/// How many colours the terminal has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colours {
    /// None: bold, dim and reversed letters alone.
    #[default]
    None,
    /// The sixteen of its own palette.
    Sixteen,
    /// 256, of which 216 are a cube of red, green and blue.
    Many,
    /// All.
    All,
}

/// How the terminal looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Look {
    /// Its colours.
    pub colours: Colours,
    /// Are signs and lines drawn with the letters of ASCII alone? Words are not changed.
    pub is_ascii: bool,
}

impl Look {
    /// The colour of a figure's line or point.
    pub(super) fn figure(self, colour: Colour) -> Color {
        let sixteen = match colour {
            Colour::Ink | Colour::Paper => return Color::Reset,
            Colour::Visited => Color::Blue,
            Colour::Rejected => Color::Red,
            Colour::Answer => Color::Green,
            Colour::Light => Color::Yellow,
            Colour::Culled => Color::DarkGray,
        };
        match self.colours {
            Colours::None => Color::Reset,
            Colours::Sixteen => sixteen,
            Colours::Many | Colours::All => self.rgb(colour.plain()),
        }
    }

    /// A colour of a picture; the ground where there are none.
    pub(super) fn rgb(self, [r, g, b]: [u8; 3]) -> Color {
        match self.colours {
            Colours::None | Colours::Sixteen => Color::Reset,
            Colours::Many => Color::Indexed(in_cube([r, g, b])),
            Colours::All => Color::Rgb(r, g, b),
        }
    }

    /// What lines between parts are drawn with.
    pub(super) fn lines(self) -> border::Set<'static> {
        const ASCII: border::Set = border::Set {
            top_left: "+",
            top_right: "+",
            bottom_left: "+",
            bottom_right: "+",
            vertical_left: "|",
            vertical_right: "|",
            horizontal_top: "-",
            horizontal_bottom: "-",
        };
        if self.is_ascii { ASCII } else { border::PLAIN }
    }

    /// A sign.
    pub(super) fn sign(self, sign: Sign) -> Style {
        match sign {
            Sign::Yes => Style::new().fg(self.figure(Colour::Answer)),
            Sign::No => Style::new().fg(self.figure(Colour::Rejected)),
            Sign::Neither => Style::new(),
        }
    }

    /// What is of less weight.
    pub(super) fn faint() -> Style {
        Style::new().add_modifier(Modifier::DIM)
    }

    /// What is of more weight.
    pub(super) fn strong() -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// Where the reader stands, and bars.
    pub(super) fn reversed() -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }
}

/// The nearest of the 216 colours that xterm has from number 16 on: the steps of each channel are 0, 95, 135, 175, 215, 255.
fn in_cube(rgb: [u8; 3]) -> u8 {
    const STEPS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    let nearest = |value: u8| {
        let away = |step: &u8| step.abs_diff(value);
        let places = (0..6u8).zip(STEPS);
        places
            .min_by_key(|(_, step)| away(step))
            .map_or(0, |(place, _)| place)
    };
    let [r, g, b] = rgb.map(nearest);
    16 + 36 * r + 6 * g + b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_of_the_cube_is_the_nearest_one() {
        for (rgb, expected) in [
            ([0, 0, 0], 16),
            ([255, 255, 255], 231),
            ([255, 0, 0], 196),
            // (95, 135, 175)
            ([100, 130, 180], 67),
        ] {
            assert_eq!(in_cube(rgb), expected, "{rgb:?}");
        }
    }

    #[test]
    fn without_colours_there_are_none() {
        let look = Look::default();
        for colour in [Colour::Answer, Colour::Rejected, Colour::Light] {
            assert_eq!(look.figure(colour), Color::Reset);
        }
        assert_eq!(look.rgb([9, 9, 9]), Color::Reset);
    }
}
