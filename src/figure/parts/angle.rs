//! An angle in a figure: the arc between two directions at a point, and how large it is.

use glam::DVec2;

use crate::figure::parts::turn::{angle_between, at_angle};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::Text;

/// An angle between two directions of a sheet.
#[derive(Clone, Copy, Debug)]
pub(in crate::figure) struct Angle {
    pub(in crate::figure) at: DVec2,
    /// From the first direction to the second, the shorter way round.
    pub(in crate::figure) between: [DVec2; 2],
    /// In units of a book's sheet.
    pub(in crate::figure) radius: f64,
}

impl Angle {
    /// Draws the arc with a label beside its middle. Nothing where a direction is seen from its end.
    pub(in crate::figure) fn draw(self, sheet: &mut Sheet, within: Frame, text: impl Into<Text>) {
        let [Some(from), Some(to)] = self.between.map(DVec2::try_normalize) else {
            return;
        };
        let radius = self.radius * sheet.unit();
        let turn = angle_between(from, to);
        let along = |share: f64| from.rotate(at_angle(share * turn));
        let points = (0..=PIECES)
            .map(|piece| self.at + radius * along(f64::from(piece) / f64::from(PIECES)));
        sheet.path(Look::THIN, points.collect());
        let middle = along(0.5);
        sheet.label(within, self.at + radius * middle, middle, text);
    }
}

/// With this number of straight pieces a quarter circle is within a thousandth of its radius.
const PIECES: u32 = 24;

/// The angle of a cosine, in degrees, as a label says it.
pub(in crate::figure) fn degrees(cosine: f64) -> String {
    format!(
        "{}°",
        quantity(libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees())
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::sheet::{Form, Width};

    #[test]
    fn an_arc_goes_the_shorter_way() {
        let mut sheet = Sheet::new(Width::Book, 400.0);
        let angle = Angle {
            at: DVec2::new(100.0, 100.0),
            // from 170° to −170°, by way of 180°
            between: [170.0, -170.0].map(|of: f64| at_angle(of.to_radians())),
            radius: 50.0,
        };
        let body = sheet.body();
        angle.draw(&mut sheet, body, "θ");
        let Form::Path { points, .. } = &sheet.marks[0].form else {
            panic!("no arc");
        };
        assert!(points.iter().all(|point| point.x < 51.0), "{points:?}");
        let middle = points[points.len() / 2];
        assert!(
            (middle - DVec2::new(50.0, 100.0)).length() < 1e-9,
            "{middle}"
        );
    }

    #[test]
    fn a_cosine_of_a_half_is_60_degrees() {
        assert_eq!(degrees(0.5), "60°");
        // rounding may leave a cosine a little above 1
        assert_eq!(degrees(1.0 + 1e-15), "0°");
    }
}
