//! The sign of a right angle: a small square at the foot, as space shows it.

use glam::DVec3;

use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::view::Space;

/// Draws the two sides of the square that do not lie on the directions.
pub(in crate::figure) fn draw(sheet: &mut Sheet, space: &Space, at: DVec3, directions: [DVec3; 2]) {
    /// The side of the square in sizes of letters.
    const SIDE: f64 = 0.7;
    let side = SIDE * sheet.letters / space.scale;
    let [a, b] = directions.map(|of| side * of.normalize_or_zero());
    let points = [at + a, at + a + b, at + b].map(|point| space.place(point));
    sheet.path(Look::THIN, points.into());
}
