//! Rectangles on a sheet, and what of a line or a polygon lies in one.

use glam::DVec2;

use crate::geometry::{Inside, SlabInterval, clip_to_rectangle};

/// A rectangle: its upper left and its lower right corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::figure) struct Frame {
    pub(in crate::figure) min: DVec2,
    pub(in crate::figure) max: DVec2,
}

impl Frame {
    /// The smallest rectangle around points; none around no points.
    pub(in crate::figure) fn around(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        points
            .into_iter()
            .map(|point| Self {
                min: point,
                max: point,
            })
            .reduce(|a, b| Self {
                min: a.min.min(b.min),
                max: a.max.max(b.max),
            })
    }

    pub(in crate::figure) fn size(self) -> DVec2 {
        self.max - self.min
    }

    pub(in crate::figure) fn middle(self) -> DVec2 {
        0.5 * (self.min + self.max)
    }

    /// Its corners, clockwise from the upper left.
    pub(in crate::figure) fn corners(self) -> [DVec2; 4] {
        [
            self.min,
            DVec2::new(self.max.x, self.min.y),
            self.max,
            DVec2::new(self.min.x, self.max.y),
        ]
    }

    /// Larger by a margin on every side, or smaller.
    pub(in crate::figure) fn wider(self, by: f64) -> Self {
        self.wider_by(DVec2::splat(by))
    }

    /// The same with margins of their own in x and y.
    pub(in crate::figure) fn wider_by(self, by: DVec2) -> Self {
        Self {
            min: self.min - by,
            max: self.max + by,
        }
    }

    pub(in crate::figure) fn contains(self, point: DVec2) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// Does it hold the whole of another?
    pub(in crate::figure) fn holds(self, other: Self) -> bool {
        self.contains(other.min) && self.contains(other.max)
    }

    /// The area that two have in common.
    pub(in crate::figure) fn shared_area(self, other: Self) -> f64 {
        let shared = self.max.min(other.max) - self.min.max(other.min);
        shared.x.max(0.0) * shared.y.max(0.0)
    }

    /// The point of it that is nearest to another.
    pub(in crate::figure) fn nearest(self, point: DVec2) -> DVec2 {
        point.clamp(self.min, self.max)
    }

    /// A part from the left, as wide as a share, and the rest beyond a gap.
    pub(in crate::figure) fn split(self, share: f64, gap: f64) -> [Self; 2] {
        let width = (self.size().x - gap) * share;
        let left = Self {
            min: self.min,
            max: DVec2::new(self.min.x + width, self.max.y),
        };
        let right = Self {
            min: DVec2::new(self.min.x + width + gap, self.min.y),
            max: self.max,
        };
        [left, right]
    }

    /// A part from the top, as high as given, and the rest.
    pub(in crate::figure) fn split_top(self, height: f64) -> [Self; 2] {
        let middle = self.min.y + height;
        let top = Self {
            min: self.min,
            max: DVec2::new(self.max.x, middle),
        };
        let bottom = Self {
            min: DVec2::new(self.min.x, middle),
            max: self.max,
        };
        [top, bottom]
    }

    /// Which part of `of` a point is in it that moves along a straight line, by `along` while t grows by 1? After Liang and
    /// Barsky: the two strips of the sheet that make the frame are slabs.
    pub(in crate::figure) fn inside(self, from: DVec2, along: DVec2, of: Inside) -> Inside {
        let strip = |axis: usize| {
            let ends = [self.min[axis], self.max[axis]];
            SlabInterval::across_axis(from[axis], along[axis], ends)
        };
        of.and(strip(0)).and(strip(1))
    }

    /// The part of a straight line that lies in it.
    pub(in crate::figure) fn cut_line(self, [from, to]: [DVec2; 2]) -> Option<[DVec2; 2]> {
        let along = to - from;
        let whole = Inside {
            near: 0.0,
            far: 1.0,
        };
        let ends = self.inside(from, along, whole).ends()?;
        Some(ends.map(|t| from + t * along))
    }

    /// The part of a polygon that lies in it.
    pub(in crate::figure) fn cut_polygon(self, points: &[DVec2]) -> Vec<DVec2> {
        clip_to_rectangle(points, self.min, self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame {
        min: DVec2::ZERO,
        max: DVec2::new(4.0, 2.0),
    };

    fn point(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    #[test]
    fn a_line_is_cut_at_both_sides() {
        let cut = FRAME.cut_line([point(-2.0, 1.0), point(6.0, 1.0)]);
        assert_eq!(cut, Some([point(0.0, 1.0), point(4.0, 1.0)]));
        // y = x − 1, from (1, 0) to (3, 2)
        let cut = FRAME.cut_line([point(0.0, -1.0), point(4.0, 3.0)]);
        assert_eq!(cut, Some([point(1.0, 0.0), point(3.0, 2.0)]));
    }

    #[test]
    fn a_line_beside_it_is_gone() {
        assert_eq!(FRAME.cut_line([point(-1.0, 3.0), point(9.0, 3.0)]), None);
        assert_eq!(FRAME.cut_line([point(-2.0, 1.0), point(1.0, 4.0)]), None);
    }

    #[test]
    fn a_triangle_over_a_corner_keeps_its_part() {
        let cut = FRAME.cut_polygon(&[point(3.0, 1.0), point(5.0, 1.0), point(3.0, 3.0)]);
        // x + y = 6 leaves the frame at (4, 2): the square from (3, 1) to (4, 2)
        let square = [
            point(3.0, 1.0),
            point(4.0, 1.0),
            point(4.0, 2.0),
            point(3.0, 2.0),
        ];
        assert!(square.iter().all(|corner| cut.contains(corner)), "{cut:?}");
        assert!(cut.iter().all(|p| FRAME.contains(*p)), "{cut:?}");
    }

    #[test]
    fn two_frames_share_what_is_in_both() {
        let other = Frame {
            min: point(3.0, 1.0),
            max: point(9.0, 9.0),
        };
        assert_eq!(FRAME.shared_area(other), 1.0);
        assert_eq!(FRAME.shared_area(other.wider(-2.0)), 0.0);
    }
}
