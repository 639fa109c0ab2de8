//! What the colours of a map mean: a bar with numbers below it.

use glam::DVec2;

use crate::figure::heat_map::colour;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::Text;
use crate::figure::sheet::{Anchor, Sheet};

/// Draws the colours of a scale, numbers at their shares of it, from the smallest on, and below what they count.
///
/// It needs two and a half lines of letters below the bar.
pub(in crate::figure) fn draw(
    sheet: &mut Sheet,
    bar: Frame,
    numbers: &[(f64, String)],
    what: impl Into<Text>,
) {
    let line = sheet.line_height();
    let at = |share: f64| bar.min.x + share * bar.size().x;
    let colours = (0..Image::LEAST_WIDTH).map(|place| {
        let middle = f64::from(place) + 0.5;
        Some(colour(middle / f64::from(Image::LEAST_WIDTH)))
    });
    sheet.image(bar, Image::new([Image::LEAST_WIDTH, 1], colours.collect()));
    sheet.rectangle(Look::THIN, bar);
    let last = numbers.len().saturating_sub(1);
    for (place, (share, number)) in numbers.iter().enumerate() {
        let x = at(*share);
        let [top, bottom] = [0.0, 0.25 * line].map(|down| DVec2::new(x, bar.max.y + down));
        sheet.line(Look::THIN, top, bottom);
        let anchor = match place {
            0 => Anchor::Start,
            _ if place == last => Anchor::End,
            _ => Anchor::Middle,
        };
        let below = bottom + DVec2::new(0.0, 0.5 * line);
        sheet.text(anchor, below, number.as_str());
    }
    let middle = DVec2::new(bar.middle().x, bar.max.y + 1.75 * line);
    sheet.text(Anchor::Middle, middle, what);
}
