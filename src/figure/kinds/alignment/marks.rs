//! Names beside the ray, and the marks of its hits.

use glam::DVec2;

use crate::figure::parts::outline::Rim;
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::view::Space;

/// A name in an outline, beside the ray where that passes its middle.
pub(super) fn name_beside(
    sheet: &mut Sheet,
    space: &Space,
    rim: &Rim,
    name: &str,
    [from, to]: [DVec2; 2],
) {
    /// Between the middle of a name and the ray, in sizes of letters.
    const AWAY: f64 = 0.95;
    let Some(middle) = scenery::middle_of(space, rim) else {
        return;
    };
    let across = (to - from).perp().normalize_or_zero();
    let side = across.dot(middle - from);
    let missing = AWAY * sheet.letters - side.abs();
    let aside = 1f64.copysign(side) * missing.max(0.0) * across;
    scenery::name_around(sheet, space, (rim, middle + aside), name);
}

/// The nearest hit is a point, the others are rings.
pub(super) fn mark(sheet: &mut Sheet, is_nearest: bool, at: DVec2) {
    if is_nearest {
        sheet.dot(Look::ANSWER, at);
    } else {
        sheet.ring(Look::THIN.wide(1.5), at);
    }
}
