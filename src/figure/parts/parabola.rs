//! The parabola y = a·t² + b·t + c of equation (iii), whose zeros are where a ray hits a surface.

use glam::DVec2;

use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::geometry::{QuadraticTest, Root, RootVerdict, Roots};

/// The vertex: t = -b/2a, y = -(b² - 4ac)/4a, which is 0 where the discriminant is 0 but for rounding. a is not 0.
///
/// There the line of a ray is nearest to the center of a sphere.
pub(in crate::figure) fn vertex(test: &QuadraticTest) -> DVec2 {
    let y = match test.roots {
        Roots::Graze(_) => 0.0,
        _ => -0.25 * test.discriminant / test.a,
    };
    DVec2::new(-0.5 * test.b / test.a, y)
}

/// The roots with their names.
pub(in crate::figure) fn roots(test: &QuadraticTest) -> Vec<(&'static str, Root)> {
    let names: &[&str] = match test.roots {
        Roots::Two { .. } => &["t₁", "t₂"],
        _ => &["t"],
    };
    names.iter().copied().zip(test.roots.iter()).collect()
}

/// A root on a line: a point if it is the hit, else a cross.
pub(in crate::figure) fn mark_root(sheet: &mut Sheet, root: Root, at: DVec2) {
    if root.verdict == RootVerdict::Chosen {
        sheet.dot(Look::ANSWER, at);
    } else {
        sheet.cross(Look::REJECTED, at);
    }
}

/// Draws the parabola with its axes, zeros and vertex. At least so far on both sides of its vertex it is seen.
pub(in crate::figure) fn draw(
    sheet: &mut Sheet,
    frame: Frame,
    test: &QuadraticTest,
    apart: f64,
    numbers: bool,
) {
    // the heads of the axes and the letters at them stand in the margin
    let graph = Graph::new(frame.wider(-1.2 * sheet.letters), test, apart);
    graph.axes(sheet);
    graph.curve(sheet);
    let vertex = graph.place(graph.vertex);
    let foot = graph.place(DVec2::new(graph.vertex.x, 0.0));
    if !matches!(test.roots, Roots::Graze(_)) {
        sheet.line(Look::HELP, foot, vertex);
        sheet.ring(Look::THIN, vertex);
    }
    for (name, root) in roots(test) {
        let at = graph.place(DVec2::new(root.t, 0.0));
        mark_root(sheet, root, at);
        let outwards = DVec2::new(at.x - vertex.x, 24.0 * sheet.unit());
        sheet.label(frame, at, outwards, name);
    }
    let text = if numbers {
        format!(
            "vertex ({}, {})",
            quantity(graph.vertex.x),
            quantity(graph.vertex.y)
        )
    } else {
        "vertex".into()
    };
    // outside of the axis and the curve
    let away = if graph.vertex.y <= 0.0 {
        DVec2::Y
    } else {
        DVec2::NEG_Y
    };
    sheet.label(frame, vertex, away, text);
}

/// Where t and y are on the sheet.
struct Graph {
    frame: Frame,
    /// The smallest and the largest t, and y.
    t: [f64; 2],
    y: [f64; 2],
    a: f64,
    vertex: DVec2,
}

impl Graph {
    fn new(frame: Frame, test: &QuadraticTest, apart: f64) -> Self {
        /// Of the distance from the vertex to the zeros: they are inside, and the bend is seen.
        const BEYOND: f64 = 1.35;
        let QuadraticTest {
            a, discriminant, ..
        } = *test;
        let vertex = vertex(test);
        let wide = BEYOND * (0.5 * discriminant.abs().sqrt() / a).max(apart);
        let height = a * wide * wide;
        let (low, top) = (vertex.y.min(0.0), (vertex.y + height).max(0.5 * height));
        // room for letters below
        let below = 0.16 * (top - low);
        Self {
            frame,
            t: [(vertex.x - wide).min(0.0), (vertex.x + wide).max(0.0)],
            y: [low - below, top],
            a,
            vertex,
        }
    }

    fn place(&self, at: DVec2) -> DVec2 {
        let share = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        let size = self.frame.size();
        DVec2::new(
            self.frame.min.x + share(at.x, self.t) * size.x,
            self.frame.max.y - share(at.y, self.y) * size.y,
        )
    }

    fn axes(&self, sheet: &mut Sheet) {
        let beyond = 0.6 * sheet.letters;
        let zero = self.place(DVec2::ZERO);
        let left = DVec2::new(self.frame.min.x, zero.y);
        let right = DVec2::new(self.frame.max.x + beyond, zero.y);
        sheet.arrow(Look::THIN, left, right);
        let up = DVec2::new(zero.x, self.frame.min.y - beyond);
        sheet.arrow(Look::THIN, DVec2::new(zero.x, self.frame.max.y), up);
        let letter = 0.9 * sheet.letters;
        sheet.text(Anchor::End, right + DVec2::new(0.0, letter), "t");
        sheet.text(Anchor::Start, up + DVec2::new(letter, 0.0), "y");
        let origin = zero + DVec2::new(-0.4 * letter, letter);
        sheet.text(Anchor::End, origin, "0");
    }

    /// The curve, as far as it is within the height of the graph.
    fn curve(&self, sheet: &mut Sheet) {
        /// The number of straight pieces that look smooth.
        const PIECES: u32 = 64;
        let half = ((self.y[1] - self.vertex.y) / self.a).sqrt();
        let [low, high] =
            [-half, half].map(|far| (self.vertex.x + far).clamp(self.t[0], self.t[1]));
        let at = |piece: u32| {
            let t = low + (high - low) * f64::from(piece) / f64::from(PIECES);
            let from_vertex = t - self.vertex.x;
            let y = self.vertex.y + self.a * from_vertex * from_vertex;
            self.place(DVec2::new(t, y))
        };
        sheet.path(Look::THIN.wide(1.75), (0..=PIECES).map(at).collect());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ray, Sides, Sphere, TRange};
    use glam::DVec3;

    /// A sphere at (4, 0, 1.5) of radius 1.5, seen from the origin: c = 16 for all rays.
    fn test(direction: [f64; 3]) -> QuadraticTest {
        let sphere = Sphere {
            center: DVec3::new(4.0, 0.0, 1.5),
            radius: 1.5,
        };
        let ray = Ray::new(DVec3::ZERO, direction.into());
        sphere.test(&ray, TRange::FORWARD, Sides::Both)
    }

    #[track_caller]
    fn check(direction: [f64; 3], expected: [f64; 2]) {
        let found = vertex(&test(direction));
        assert!((found - DVec2::from(expected)).length() < 1e-12, "{found}");
    }

    #[test]
    fn the_vertex_lies_below_the_axis_on_it_or_above_it() {
        // b = -2(4·0.8 + 1.5·0.6) = -8.2, b² - 4ac = 3.24
        check([0.8, 0.0, 0.6], [4.1, -0.81]);
        // b = -8, b² - 4ac = 0
        check([1.0, 0.0, 0.0], [4.0, 0.0]);
        // b = -2(4·0.96 - 1.5·0.28) = -6.84, b² - 4ac = -17.2144
        check([0.96, 0.0, -0.28], [3.42, 4.3036]);
    }

    #[test]
    fn the_graph_has_the_origin_and_all_zeros_in_it() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(300.0, 200.0),
        };
        for direction in [[0.8, 0.0, 0.6], [1.0, 0.0, 0.0], [-0.8, 0.0, -0.6]] {
            let test = test(direction);
            let graph = Graph::new(frame, &test, 1.2);
            for t in test.roots.iter().map(|root| root.t).chain([0.0]) {
                let at = graph.place(DVec2::new(t, 0.0));
                assert!(frame.contains(at), "{direction:?}: {t} at {at}");
            }
            assert!(frame.contains(graph.place(graph.vertex)), "{direction:?}");
        }
    }
}
