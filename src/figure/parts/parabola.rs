//! The parabola f(t) = a·t² + b·t + c of equation (iii), whose zeros are where a ray hits a surface.

use glam::DVec2;

use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::geometry::{QuadraticTest, Root, RootVerdict, Roots};

/// The vertex: t = -b/2a, f(t) = -(b² - 4ac)/4a, which is 0 where the discriminant is 0 but for rounding. a is not 0.
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
        Roots::Graze(_) => &["t₁ = t₂"],
        _ => &["t"],
    };
    names.iter().copied().zip(test.roots.iter()).collect()
}

/// b² − 4ac as a text says it: 0 where it is 0 but for rounding.
pub(in crate::figure) fn discriminant(test: &QuadraticTest) -> String {
    quantity(match test.roots {
        Roots::Graze(_) => 0.0,
        _ => test.discriminant,
    })
}

/// A root on a line: a point if it is the hit, else a cross.
pub(in crate::figure) fn mark_root(sheet: &mut Sheet, root: Root, at: DVec2) {
    if root.verdict == RootVerdict::Chosen {
        sheet.dot(Look::ANSWER, at);
    } else {
        sheet.cross(Look::REJECTED, at);
    }
}

/// When the parts of the drawing come.
pub(in crate::figure) struct Stages {
    /// The axes, with the equation.
    pub(in crate::figure) axes: StageId,
    /// The curve and its vertex.
    pub(in crate::figure) curve: StageId,
    /// The zeros.
    pub(in crate::figure) roots: StageId,
    /// Which of them counts.
    pub(in crate::figure) verdict: StageId,
}

/// What the axes depend on: for all rays from one origin it is the same, so that their drawings have one scale.
#[derive(Clone, Copy, Debug)]
pub(in crate::figure) struct Extent {
    /// From the ray's origin to the center, in t.
    pub(in crate::figure) distance: f64,
    /// The radius, in t.
    pub(in crate::figure) radius: f64,
}

/// Draws the parabola with its axes, zeros and vertex.
pub(in crate::figure) fn draw(
    sheet: &mut Sheet,
    frame: Frame,
    test: &QuadraticTest,
    extent: Extent,
    stages: &Stages,
    numbers: bool,
) {
    // the heads of the axes and the letters at them stand in the margin
    let graph = Graph::new(frame.wider(-1.2 * sheet.letters), test, extent);
    sheet.at(stages.axes, |sheet| graph.axes(sheet, frame));
    let vertex = graph.place(graph.vertex);
    let foot = graph.place(DVec2::new(graph.vertex.x, 0.0));
    sheet.at(stages.curve, |sheet| {
        graph.curve(sheet);
        // where it touches the axis it is the zero
        if matches!(test.roots, Roots::Graze(_)) {
            return;
        }
        sheet.line(Look::HELP, foot, vertex);
        sheet.ring(Look::THIN, vertex);
        // a slide has room for the zeros alone
        if sheet.width == Width::Slide {
            return;
        }
        let text = if numbers {
            let [t, value] = graph.vertex.to_array().map(quantity);
            format!("vertex ({t}, {value})")
        } else {
            "vertex".into()
        };
        // outside of the axis and the curve, or in its bend
        let away = if graph.vertex.y <= 0.0 {
            DVec2::Y
        } else {
            DVec2::NEG_Y
        };
        sheet.label(frame, vertex, away, text);
    });
    for (name, root) in roots(test) {
        let at = graph.place(DVec2::new(root.t, 0.0));
        sheet.at(stages.roots, |sheet| {
            sheet.small_dot(Look::RAY, at);
            // outside of the curve, or below its vertex
            let outwards = DVec2::new((at.x - vertex.x).signum(), 1.0);
            let text = if numbers && sheet.width == Width::Book {
                formula(&format!("{name} = ")) + quantity(root.t)
            } else {
                formula(name)
            };
            sheet.label(frame, at, outwards, text);
        });
        sheet.at(stages.verdict, |sheet| mark_root(sheet, root, at));
    }
}

/// Where t and f(t) are on the sheet.
struct Graph {
    frame: Frame,
    /// The smallest and the largest t, and f(t).
    t: [f64; 2],
    y: [f64; 2],
    a: f64,
    vertex: DVec2,
    /// f(0), which is c.
    at_origin: f64,
}

impl Graph {
    fn new(frame: Frame, test: &QuadraticTest, extent: Extent) -> Self {
        /// So many radii beyond the center a curve that matters has risen.
        const BEYOND: f64 = 2.0;
        /// The top is at so many squares of the radius: a curve that opens at a height of one of them shows its bend.
        const TOP: f64 = 3.0;
        /// With the origin that many radii away from the curve, the curve would be a line: the axis then begins later.
        const FAR: f64 = 12.0;
        let Extent { distance, radius } = extent;
        let vertex = vertex(test);
        let square = test.a * radius * radius;
        // a ray that turns its back to the center has its vertex at a negative t
        let center = distance.copysign(vertex.x);
        let [low, high] = [
            (center - BEYOND * radius).min(vertex.x - radius),
            (center + BEYOND * radius).max(vertex.x + radius),
        ];
        let has_origin = low < FAR * radius && -FAR * radius < high;
        let t = if has_origin {
            [low.min(0.0), high.max(0.0)]
        } else {
            [low, high]
        };
        // room for letters below
        const BELOW: f64 = 1.6;
        Self {
            frame,
            t,
            y: [-BELOW * square, (TOP * square).max(1.5 * vertex.y)],
            a: test.a,
            vertex,
            at_origin: test.c,
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

    fn axes(&self, sheet: &mut Sheet, around: Frame) {
        let beyond = 0.6 * sheet.letters;
        let letter = 0.9 * sheet.letters;
        // the y axis stands at 0, or where the other axis begins
        let [low, high] = self.t;
        let has_origin = low <= 0.0 && 0.0 <= high;
        let zero = self.place(DVec2::new(if has_origin { 0.0 } else { low }, 0.0));
        let left = DVec2::new(self.frame.min.x, zero.y);
        let right = DVec2::new(self.frame.max.x + beyond, zero.y);
        sheet.arrow(Look::THIN, left, right);
        let up = DVec2::new(zero.x, self.frame.min.y - beyond);
        sheet.arrow(Look::THIN, DVec2::new(zero.x, self.frame.max.y), up);
        sheet.text(Anchor::End, right - DVec2::new(0.0, letter), formula("t"));
        let beside = up + DVec2::new(0.6 * letter, 0.2 * letter);
        sheet.text(Anchor::Start, beside, formula("f(t)"));
        if has_origin {
            // on the side where no zero is
            let side = if self.vertex.x < 0.0 || self.at_origin < 0.0 {
                1.0
            } else {
                -1.0
            };
            sheet.label(around, zero, DVec2::new(side, 1.0), "0");
        } else {
            // the axis has a gap before it begins
            let gap = DVec2::new(1.2 * sheet.letters, 0.0);
            sheet.line(Look::HIDDEN, left - gap, left);
        }
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
        // the center is √(4² + 1.5²) away
        let extent = Extent {
            distance: 18.25_f64.sqrt(),
            radius: 1.5,
        };
        for direction in [[0.8, 0.0, 0.6], [1.0, 0.0, 0.0], [-0.8, 0.0, -0.6]] {
            let test = test(direction);
            let graph = Graph::new(frame, &test, extent);
            for t in test.roots.iter().map(|root| root.t).chain([0.0]) {
                let at = graph.place(DVec2::new(t, 0.0));
                assert!(frame.contains(at), "{direction:?}: {t} at {at}");
            }
            assert!(frame.contains(graph.place(graph.vertex)), "{direction:?}");
        }
    }

    #[test]
    fn all_rays_from_one_origin_have_one_scale() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(300.0, 200.0),
        };
        let extent = Extent {
            distance: 18.25_f64.sqrt(),
            radius: 1.5,
        };
        let graph = |direction| Graph::new(frame, &test(direction), extent);
        let [two, one, none] = [[0.8, 0.0, 0.6], [1.0, 0.0, 0.0], [0.96, 0.0, -0.28]].map(graph);
        // three cases, and the parabola slides up
        assert_eq!((two.t, two.y), (one.t, one.y));
        assert_eq!((two.t, two.y), (none.t, none.y));
    }

    #[test]
    fn a_sphere_far_away_is_drawn_without_the_origin() {
        // at a distance of 1000 with the radius 1: from 998 to 1002
        let sphere = Sphere {
            center: DVec3::new(1000.0, 0.0, 0.0),
            radius: 1.0,
        };
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let test = sphere.test(&ray, TRange::FORWARD, Sides::Both);
        let extent = Extent {
            distance: 1000.0,
            radius: 1.0,
        };
        let graph = Graph::new(Frame::default(), &test, extent);
        assert_eq!(graph.t, [998.0, 1002.0]);
    }
}
