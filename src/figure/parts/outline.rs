//! How a shape looks in an orthographic view: its outline, the edges that are seen and those behind it.
//!
//! Nothing is hidden by something else: in a line drawing of a ray tracer what is behind matters too. Areas are faint
//! so that all of it is seen.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::figure::parts::turn::at_angle;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Form, Sheet};
use crate::figure::view::{Projection, Space};
use crate::geometry::{AxisBox, Cone, OrientedEllipsoid};
use crate::scene::Shape;

/// A shape in a projection, not yet on a sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct Outline {
    /// What is around all of it.
    pub(in crate::figure) rim: Rim,
    /// Edges inside the rim that are seen.
    pub(in crate::figure) edges: Vec<Vec<DVec2>>,
    /// Edges that lie behind the shape itself.
    pub(in crate::figure) hidden: Vec<Vec<DVec2>>,
}

/// A closed line.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) enum Rim {
    /// From point to point.
    Points(Vec<DVec2>),
    /// An ellipse by two half axes at right angles.
    Ellipse { center: DVec2, axes: [DVec2; 2] },
}

impl Default for Rim {
    fn default() -> Self {
        Self::Points(Vec::new())
    }
}

impl Rim {
    /// Points on it, for what needs corners: many on an ellipse.
    pub(in crate::figure) fn points(&self) -> Vec<DVec2> {
        match self {
            Self::Points(points) => points.clone(),
            Self::Ellipse { center, axes } => around(*center, *axes),
        }
    }

    /// What it encloses: ½·|Σ pᵢ × pᵢ₊₁| (the shoelace formula), or π·|a × b|.
    pub(in crate::figure) fn area(&self) -> f64 {
        match self {
            Self::Points(points) => {
                let next = points.iter().cycle().skip(1);
                let twice: f64 = points.iter().zip(next).map(|(p, q)| p.perp_dot(*q)).sum();
                0.5 * twice.abs()
            }
            Self::Ellipse { axes: [a, b], .. } => std::f64::consts::PI * a.perp_dot(*b).abs(),
        }
    }
}

impl Outline {
    /// The outline of a shape.
    pub(in crate::figure) fn of(shape: &Shape, projection: &Projection) -> Self {
        match shape {
            Shape::Sphere(sphere) => Self {
                rim: Rim::Ellipse {
                    center: projection.of(sphere.center),
                    axes: [DVec2::X, DVec2::Y].map(|axis| sphere.radius * axis),
                },
                ..Self::default()
            }
            .with_equator(sphere.center, DVec3::splat(sphere.radius), projection),
            Shape::Ellipsoid(egg) => {
                let half_axes = DVec3::AXES.map(|axis| axis * egg.radii);
                Self::of_half_axes(egg.center, half_axes, projection)
                    .with_equator(egg.center, egg.radii, projection)
            }
            Shape::Box(solid) => Self::of_box(solid, projection),
            Shape::Cone(cone) => Self::of_cone(cone, projection),
            Shape::Polygon(polygon) => Self {
                rim: Rim::Points(polygon.vertices().map(|p| projection.of(p)).collect()),
                ..Self::default()
            },
        }
    }

    /// With the level great circle of a ball, where it is seen in space: its front half, and the one behind. A point of it
    /// lies in front where its normal points towards who looks.
    fn with_equator(mut self, center: DVec3, radii: DVec3, projection: &Projection) -> Self {
        /// Straight pieces of half a great circle.
        const HALF: u32 = 24;
        if !projection.in_space {
            return self;
        }
        let towards = projection.towards();
        // (x/a, z/c) = (cos, sin): the normal is (cos/a, 0, sin/c), and ends of the front half have none towards who looks
        let start = libm::atan2(-towards.x / radii.x, towards.z / radii.z);
        let half = |from: f64| {
            let angle = |i: u32| from + f64::from(i) / f64::from(HALF) * TAU / 2.0;
            let at = |angle: f64| DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
            let points = (0..=HALF).map(|i| center + radii * at(angle(i)));
            points.map(|point| projection.of(point)).collect()
        };
        self.edges.push(half(start));
        self.hidden.push(half(start + TAU / 2.0));
        self
    }

    /// The outline of an ellipsoid that is turned in any way.
    pub(in crate::figure) fn of_ellipsoid(
        egg: &OrientedEllipsoid,
        projection: &Projection,
    ) -> Self {
        let radii = egg.radii.to_array();
        let half_axes = [0, 1, 2].map(|i| radii[i] * egg.axes[i]);
        Self::of_half_axes(egg.center, half_axes, projection)
    }

    /// The shadow of an ellipsoid with half axes vᵢ is the ellipse whose matrix is Σ wᵢ·wᵢᵀ, with wᵢ the projections
    /// of the vᵢ: its half axes are the eigenvectors, as long as the roots of the eigenvalues.
    pub(in crate::figure) fn of_half_axes(
        center: DVec3,
        half_axes: [DVec3; 3],
        projection: &Projection,
    ) -> Self {
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for axis in half_axes {
            let w = projection.of(axis);
            xx += w.x * w.x;
            xy += w.x * w.y;
            yy += w.y * w.y;
        }
        let mean = f64::midpoint(xx, yy);
        let apart = libm::hypot(0.5 * (xx - yy), xy);
        let [long, short] = [mean + apart, mean - apart].map(|of| of.max(0.0).sqrt());
        let angle = 0.5 * libm::atan2(2.0 * xy, xx - yy);
        let along = at_angle(angle);
        Self {
            rim: Rim::Ellipse {
                center: projection.of(center),
                axes: [long * along, short * along.perp()],
            },
            ..Self::default()
        }
    }

    /// A box: of its twelve edges three meet in the corner that is furthest away.
    pub(in crate::figure) fn of_box(solid: &AxisBox, projection: &Projection) -> Self {
        let towards = projection.towards();
        let at = |high: [bool; 3]| {
            let [x, y, z] = [0, 1, 2].map(|i| solid.along(i)[usize::from(high[i])]);
            projection.of(DVec3::new(x, y, z))
        };
        let far = [0, 1, 2].map(|i| towards[i] < 0.0);
        // along an axis nothing is behind anything that is not covered by it
        let flat = towards.to_array().iter().any(|part| part.abs() < 1e-9);
        let mut outline = Self::default();
        let mut corners = Vec::with_capacity(8);
        for bits in 0..8_u8 {
            let from = [0, 1, 2].map(|i| bits & (1 << i) != 0);
            corners.push(at(from));
            for axis in 0..3 {
                if from[axis] {
                    continue;
                }
                let mut to = from;
                to[axis] = true;
                let edge = vec![at(from), at(to)];
                if flat {
                    continue;
                }
                if from == far || to == far {
                    outline.hidden.push(edge);
                } else {
                    outline.edges.push(edge);
                }
            }
        }
        outline.rim = Rim::Points(hull(corners));
        outline
    }

    /// A cone or cylinder without its ends: around both end circles. Of the end that is turned away only the rim is
    /// seen.
    fn of_cone(cone: &Cone, projection: &Projection) -> Self {
        let (one, other) = cone.axis().any_orthonormal_pair();
        let circle = |center: DVec3, radius: f64| -> Vec<DVec2> {
            if radius == 0.0 {
                return vec![projection.of(center)];
            }
            let on_rim = |angle: f64| radius * (libm::cos(angle) * one + libm::sin(angle) * other);
            turns()
                .map(|angle| projection.of(center + on_rim(angle)))
                .collect()
        };
        let [base_radius, apex_radius] = cone.radii();
        let base = circle(cone.base(), base_radius);
        let apex = circle(cone.apex(), apex_radius);
        let mut outline = Self {
            rim: Rim::Points(hull(base.iter().chain(&apex).copied().collect())),
            ..Self::default()
        };
        let towards = cone.axis().dot(projection.towards());
        for (mut circle, outwards) in [(base, -towards), (apex, towards)] {
            circle.extend(circle.first().copied());
            match circle.len() {
                ..=2 => {}
                _ if outwards < 0.0 => outline.hidden.push(circle),
                _ => outline.edges.push(circle),
            }
        }
        outline
    }
}

/// The number of points of a smooth ellipse: its straight pieces stay within a thousandth of it.
const POINTS: u32 = 72;

fn turns() -> impl Iterator<Item = f64> {
    (0..POINTS).map(|i| f64::from(i) / f64::from(POINTS) * TAU)
}

fn around(center: DVec2, [a, b]: [DVec2; 2]) -> Vec<DVec2> {
    turns()
        .map(|angle| center + libm::cos(angle) * a + libm::sin(angle) * b)
        .collect()
}

/// The convex polygon around points, after Andrew: the lower chain, then the upper one.
pub(in crate::figure) fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for p in points {
            while let [.., a, b] = *chain.as_slice() {
                if 0.0 < (b - a).perp_dot(p - b) {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        // the last point begins the other chain
        chain.pop();
        chain
    };
    let mut around = chain(&mut points.iter().copied());
    around.extend(chain(&mut points.iter().rev().copied()));
    around
}

/// Draws an outline in a space, cut at its frame.
pub(in crate::figure) fn draw(sheet: &mut Sheet, space: &Space, outline: &Outline, look: Look) {
    /// Of the width of the rim: inner edges are lighter.
    const EDGE: f64 = 0.64;
    rim(sheet, space, &outline.rim, look);
    let line = look.outline().wide(EDGE * look.width);
    for edge in &outline.edges {
        line_on(sheet, space, line, edge);
    }
    for edge in &outline.hidden {
        line_on(
            sheet,
            space,
            Look {
                colour: look.colour,
                ..Look::HIDDEN
            },
            edge,
        );
    }
}

/// Draws a closed line in a space, cut at its frame.
pub(in crate::figure) fn rim(sheet: &mut Sheet, space: &Space, rim: &Rim, look: Look) {
    let points: Vec<DVec2> = rim
        .points()
        .into_iter()
        .map(|point| space.place_flat(point))
        .collect();
    if points.iter().all(|point| space.frame.contains(*point)) {
        if let Rim::Ellipse { center, axes } = rim {
            let center = space.place_flat(*center);
            let radii = DVec2::new(axes[0].length(), axes[1].length()) * space.scale;
            // up is the other way on the sheet
            let turn = -libm::atan2(axes[0].y, axes[0].x).to_degrees();
            sheet.mark(
                look,
                Form::Ellipse {
                    center,
                    radii,
                    turn,
                },
            );
        } else {
            sheet.polygon(look, points);
        }
        return;
    }
    sheet.polygon(look.inside(), space.frame.cut_polygon(&points));
    let mut closed = points;
    closed.extend(closed.first().copied());
    cut_line(sheet, space, look.outline(), &closed);
}

/// Draws a line of projected points, cut at the frame.
pub(in crate::figure) fn line_on(sheet: &mut Sheet, space: &Space, look: Look, points: &[DVec2]) {
    let points: Vec<DVec2> = points
        .iter()
        .map(|point| space.place_flat(*point))
        .collect();
    cut_line(sheet, space, look, &points);
}

/// Draws the pieces of a line that lie in the frame, each as long as it goes on.
fn cut_line(sheet: &mut Sheet, space: &Space, look: Look, points: &[DVec2]) {
    let mut piece: Vec<DVec2> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = space.frame.cut_line([pair[0], pair[1]]) else {
            continue;
        };
        if piece.last() != Some(&from) {
            sheet.path(look, std::mem::take(&mut piece));
            piece.push(from);
        }
        piece.push(to);
    }
    sheet.path(look, piece);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Ellipsoid, Sphere};

    fn front() -> Projection {
        Projection::new(DVec3::X, DVec3::Y)
    }

    fn slanted() -> Projection {
        // along (1, 1, 1)
        Projection::new(DVec3::new(1.0, 0.0, -1.0), DVec3::new(-1.0, 2.0, -1.0))
    }

    #[test]
    fn a_sphere_is_a_circle_from_everywhere() {
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::new(1.0, 2.0, 3.0),
            radius: 2.0,
        });
        for projection in [front(), slanted()] {
            let Rim::Ellipse { center, axes } = Outline::of(&sphere, &projection).rim else {
                panic!("no ellipse");
            };
            assert_eq!(center, projection.of(DVec3::new(1.0, 2.0, 3.0)));
            assert_eq!(axes.map(DVec2::length), [2.0, 2.0]);
        }
    }

    #[test]
    fn an_ellipsoid_seen_along_the_diagonal_is_the_ellipse_of_its_projected_axes() {
        let egg = Shape::Ellipsoid(Ellipsoid {
            center: DVec3::ZERO,
            radii: DVec3::new(1.0, 2.0, 3.0),
        });
        let Rim::Ellipse { axes, .. } = Outline::of(&egg, &slanted()).rim else {
            panic!("no ellipse");
        };
        // across = (1, 0, −1)/√2, up = (−1, 2, −1)/√6: w₁ = (1/√2, −1/√6), w₂ = (0, 4/√6), w₃ = (−3/√2, −3/√6);
        // xx = 1/2 + 9/2 = 5, yy = 1/6 + 16/6 + 9/6 = 13/3, xy = −1/√12 + 9/√12 = 8/√12
        // λ = 14/3 ± √(1/9 + 16/3) = 14/3 ± 7/3
        let lengths = axes.map(DVec2::length);
        assert!((lengths[0] - 7f64.sqrt()).abs() < 1e-12, "{lengths:?}");
        assert!(
            (lengths[1] - (7f64 / 3.0).sqrt()).abs() < 1e-12,
            "{lengths:?}"
        );
    }

    fn unit() -> AxisBox {
        AxisBox {
            min: DVec3::ZERO,
            max: DVec3::ONE,
        }
    }

    #[test]
    fn a_box_shows_nine_edges_and_hides_three() {
        let outline = Outline::of_box(&unit(), &slanted());
        assert_eq!((outline.edges.len(), outline.hidden.len()), (9, 3));
        // the hidden ones meet in the origin, which is furthest from who looks along (1, 1, 1)
        for edge in &outline.hidden {
            assert!(edge.contains(&DVec2::ZERO), "{edge:?}");
        }
        assert_eq!(outline.rim.points().len(), 6);
        let flat = Outline::of_box(&unit(), &front());
        assert_eq!(flat.rim.points().len(), 4);
    }

    #[test]
    fn a_rim_encloses_an_area() {
        let p = DVec2::new;
        // a trapezoid of the sides 4 and 2 and the height 3, clockwise
        let corners = vec![p(1.0, 1.0), p(1.0, 4.0), p(3.0, 4.0), p(5.0, 1.0)];
        assert_eq!(Rim::Points(corners).area(), 9.0);
        let ellipse = Rim::Ellipse {
            center: p(7.0, 7.0),
            axes: [p(0.0, 3.0), p(-2.0, 0.0)],
        };
        assert!((ellipse.area() - 6.0 * std::f64::consts::PI).abs() < 1e-12);
        assert_eq!(Rim::default().area(), 0.0);
    }

    #[test]
    fn the_hull_leaves_out_what_is_inside_or_on_an_edge() {
        let p = DVec2::new;
        let around = hull(vec![
            p(0.0, 0.0),
            p(2.0, 0.0),
            p(1.0, 0.0),
            p(1.0, 1.0),
            p(2.0, 2.0),
            p(0.0, 2.0),
        ]);
        assert_eq!(around, [p(0.0, 0.0), p(2.0, 0.0), p(2.0, 2.0), p(0.0, 2.0)]);
    }
}
