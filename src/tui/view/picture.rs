//! The small picture: two pixels in each letter, and the one that is stepped through marked.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::tui::app::App;
use crate::tui::look::{Colours, Look};
use crate::tui::view::part::framed;

/// Shades from dark to light, where there are no colours.
const SHADES: [char; 8] = [' ', '.', ':', '-', '=', '+', '*', '#'];

/// How many rows it takes, with its title; `None` if there is none.
pub(super) fn height(app: &App<'_, '_>) -> Option<u16> {
    let picture = app.picture()?;
    Some(picture.size[1].div_ceil(2) as u16 + 1)
}

/// Draws it.
pub(super) fn draw(app: &App<'_, '_>, look: Look, area: Rect, frame: &mut Frame<'_>) {
    let Some(picture) = app.picture() else { return };
    let [x, y] = app.titles.pixel;
    let inside = framed(&format!("pixel {x},{y}"), look, area, frame);
    let [width, height] = picture.size;
    let pixels = app.log().scene.camera.pixels;
    let of = |place: u32, side: u32, pixels: u32| {
        let share = (f64::from(place) + 0.5) / f64::from(pixels);
        ((share * f64::from(side)) as u32).min(side.saturating_sub(1))
    };
    let marked = [of(x, width, pixels[0]), of(y, height, pixels[1])];
    let colour = |x: u32, y: u32| {
        let place = (y * width + x) as usize;
        picture.rgb.get(place).copied().filter(|_| y < height)
    };
    let has_colours = matches!(look.colours, Colours::Many | Colours::All) && !look.is_ascii;
    let buffer = frame.buffer_mut();
    for row in 0..height.div_ceil(2).min(u32::from(inside.height)) {
        for x in 0..width.min(u32::from(inside.width)) {
            let halves = [colour(x, 2 * row), colour(x, 2 * row + 1)];
            let place = (inside.x + x as u16, inside.y + row as u16);
            let Some(cell) = buffer.cell_mut(place) else {
                continue;
            };
            let is_marked = marked[0] == x && marked[1] / 2 == row;
            if has_colours {
                let style = Style::new();
                let style = halves[0].map_or(style, |rgb| style.fg(look.rgb(rgb)));
                let style = halves[1].map_or(style, |rgb| style.bg(look.rgb(rgb)));
                cell.set_char('▀').set_style(style);
            } else {
                let light = halves
                    .iter()
                    .flatten()
                    .map(|rgb| brightness(*rgb))
                    .sum::<f64>();
                let light = light / halves.iter().flatten().count().max(1) as f64;
                let shade = (light * SHADES.len() as f64) as usize;
                cell.set_char(SHADES[shade.min(SHADES.len() - 1)]);
            }
            if is_marked {
                // black on white or white on black, by what is there
                let is_light =
                    halves[marked[1] as usize % 2].is_some_and(|of| 0.5 <= brightness(of));
                let mark = match (has_colours, look.is_ascii) {
                    (_, true) => '@',
                    (_, false) => '◆',
                };
                cell.set_char(mark);
                if has_colours {
                    let ink = if is_light { [0; 3] } else { [255; 3] };
                    let ground = halves[marked[1] as usize % 2].unwrap_or_default();
                    cell.set_style(Style::new().fg(look.rgb(ink)).bg(look.rgb(ground)));
                } else {
                    cell.set_style(Look::reversed());
                }
            }
        }
    }
}

/// From 0 to 1, as the eye weighs the channels (Rec. 709).
fn brightness([r, g, b]: [u8; 3]) -> f64 {
    (0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)) / 255.0
}
