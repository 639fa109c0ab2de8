//! Bounds of slabs as a figure shows them (Fig. 15.58): planes seen from their edge, and the intersection of all.
//!
//! The events say D_min and D_max of what a ray was tested against. What a search left out is had from the
//! structure, built again from the scene in the log.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::parts::axes;
use crate::figure::parts::outline::{Outline, Rim, hull};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::traced::Traced;
use crate::figure::view::{Projection, Space};
use crate::geometry::{Axis, AxisBox, MOST_SLABS};
use crate::structure::{Hierarchy, SlabBound, SlabChoice, SlabSet, Volume, VolumeKind};
use crate::trace::{Bounded, RaySlab, SlabTest, StrategyName};

/// A slab with its planes A·x + B·y + C·z + D = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::figure) struct Slab {
    /// Its place in the set, from 0.
    pub(in crate::figure) number: u32,
    /// (A, B, C), of unit length.
    pub(in crate::figure) normal: DVec3,
    /// D of the plane that is furthest along the normal (erratum 5).
    pub(in crate::figure) d_min: f64,
    /// D of the plane that is furthest back.
    pub(in crate::figure) d_max: f64,
}

impl Slab {
    /// As it was tested.
    pub(in crate::figure) fn of(test: &SlabTest, line: &RaySlab) -> Self {
        let step = &test.step;
        Self {
            number: step.slab,
            normal: line.normal,
            d_min: step.d_min,
            d_max: step.d_max,
        }
    }

    /// What its normal is called: n₀ for the first, as the log counts them.
    pub(in crate::figure) fn name(&self) -> String {
        let digits = self.number.to_string();
        let subscript = |digit: char| match digit.to_digit(10) {
            Some(digit) => char::from_u32('₀' as u32 + digit).unwrap_or(' '),
            None => ' ',
        };
        format!("n{}", digits.chars().map(subscript).collect::<String>())
    }

    /// The same as the slides set it, with its axis where the normal points out of the drawing.
    pub(in crate::figure) fn title(&self, projection: &Projection) -> Text {
        let name = formula(&self.name());
        if self.is_on_edge(projection) {
            return name;
        }
        let mut axes = [Axis::X, Axis::Y, Axis::Z].into_iter();
        match axes.find(|axis| axis.of(self.normal).abs() == 1.0) {
            Some(axis) => name + " (" + formula(axes::letter(axis)) + ")",
            None => name,
        }
    }

    /// Are its planes seen from their edge?
    pub(in crate::figure) fn is_on_edge(&self, projection: &Projection) -> bool {
        /// Of unit vectors, for rounding.
        const PERPENDICULAR: f64 = 1e-9;
        self.normal.dot(projection.towards()).abs() <= PERPENDICULAR
    }

    /// The line that the plane of this D is seen as, cut at a frame: from the right of the normal to its left, who
    /// looks along it. Near `around` it is sure to be found.
    pub(in crate::figure) fn line(
        &self,
        space: &Space,
        frame: Frame,
        d: f64,
        around: DVec3,
    ) -> Option<[DVec2; 2]> {
        let normal = space.projection.of(self.normal).normalize_or_zero();
        let around_flat = space.projection.of(around);
        let foot = around_flat - (normal.dot(around_flat) + d) * normal;
        let away = space.place_flat(foot).distance(space.frame.middle());
        let reach = (space.frame.size().length() + away) / space.scale;
        let along = reach * normal.perp();
        frame.cut_line([foot - along, foot + along].map(|end| space.place_flat(end)))
    }
}

/// The slabs of a bound, in the order of the set.
pub(in crate::figure) fn slabs<const N: usize>(
    set: &SlabSet<N>,
    bound: &SlabBound<N>,
) -> Vec<Slab> {
    let numbered = (0..).zip(set.directions());
    let planes = bound.d_min.iter().zip(&bound.d_max);
    numbered
        .zip(planes)
        .map(|((number, &normal), (&d_min, &d_max))| Slab {
            number,
            normal,
            d_min,
            d_max,
        })
        .collect()
}

/// The corners of what all slabs have in common: where three planes meet, and no slab leaves the point out.
pub(in crate::figure) fn corners(slabs: &[Slab]) -> Vec<DVec3> {
    /// Three normals in one plane, as the set of slabs has it.
    const INDEPENDENT: f64 = 1e-9;
    let mut found = Vec::new();
    for (k, c) in slabs.iter().enumerate() {
        for (j, b) in slabs[..k].iter().enumerate() {
            for a in &slabs[..j] {
                let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| p.normal.cross(q.normal));
                let volume = a.normal.dot(bc);
                if volume.abs() <= INDEPENDENT {
                    continue;
                }
                for bits in 0..8 {
                    let d = |slab: &Slab, bit: u32| {
                        if bits >> bit & 1 == 0 {
                            slab.d_min
                        } else {
                            slab.d_max
                        }
                    };
                    // Cramer's rule for n·p = −D
                    let p = -(d(a, 0) * bc + d(b, 1) * ca + d(c, 2) * ab) / volume;
                    if slabs.iter().all(|slab| holds(slab, p)) {
                        found.push(p);
                    }
                }
            }
        }
    }
    found
}

/// Is a point between the planes of a slab, or as good as on one?
fn holds(slab: &Slab, p: DVec3) -> bool {
    /// Of the coordinates, for the rounding of a corner.
    const ROUNDING: f64 = 1e-9;
    let tolerance = ROUNDING * (1.0 + p.abs().max_element());
    let place = slab.normal.dot(p);
    -slab.d_max - tolerance <= place && place <= -slab.d_min + tolerance
}

/// How the intersection of slabs is seen: a box with its edges, or else what is around all corners.
pub(in crate::figure) fn outline(slabs: &[Slab], projection: &Projection) -> Outline {
    if let [x, y, z] = slabs
        && [x.normal, y.normal, z.normal] == DVec3::AXES
    {
        let around = AxisBox {
            min: DVec3::new(-x.d_max, -y.d_max, -z.d_max),
            max: DVec3::new(-x.d_min, -y.d_min, -z.d_min),
        };
        return Outline::of_box(&around, projection);
    }
    let corners = corners(slabs);
    Outline {
        rim: Rim::Points(hull(
            corners.into_iter().map(|p| projection.of(p)).collect(),
        )),
        ..Outline::default()
    }
}

/// The middle of a bound's corners.
pub(in crate::figure) fn middle(slabs: &[Slab]) -> DVec3 {
    let corners = corners(slabs);
    corners.iter().sum::<DVec3>() / (corners.len().max(1)) as f64
}

/// The two planes of a slab, with its name at their ends: the upper ones, unless those are near the bound.
pub(in crate::figure) fn pair(
    sheet: &mut Sheet,
    space: &Space,
    room: Frame,
    slab: &Slab,
    middle: DVec3,
    look: Look,
) {
    /// A lower end that is so much farther from the bound has more room for a name.
    const FARTHER: f64 = 1.5;
    let lines = [slab.d_min, slab.d_max].map(|d| slab.line(space, room, d, middle));
    for [from, to] in lines.into_iter().flatten() {
        sheet.line(look, from, to);
        let [lower, upper] = if to.y < from.y {
            [from, to]
        } else {
            [to, from]
        };
        let center = space.place(middle);
        let far = |end: DVec2| end.distance(center);
        let (at, other) = if FARTHER * far(upper) < far(lower) {
            (lower, upper)
        } else {
            (upper, lower)
        };
        // left of the drawing there is room up to the edge of the sheet
        let within = Frame {
            min: DVec2::new(sheet.body().min.x, space.frame.min.y),
            max: space.frame.max,
        };
        sheet.label(within, at, at - other, formula(&slab.name()));
    }
}

/// The set of slabs that a trace was made with.
///
/// # Errors
/// The scene has no set, or none that bounds.
pub(in crate::figure) fn set(traced: &Traced) -> Result<SlabSet<MOST_SLABS>, FigureError> {
    let wrong =
        |what: String| FigureError::new("structure", what, "name another \"slabs\": axes or seven");
    let options = &traced.settings.structure;
    // volumes other than slabs are along the axes
    let is_box =
        traced.settings.strategy == StrategyName::Bounds && options.volume != VolumeKind::Slabs;
    let directions = match options.slabs {
        _ if is_box => DVec3::AXES.into(),
        SlabChoice::Axes => DVec3::AXES.into(),
        SlabChoice::Seven => SlabSet::SEVEN.directions().to_vec(),
        SlabChoice::Scene => {
            let own = traced.scene.slabs.clone();
            own.ok_or_else(|| wrong("the scene has no \"slabs\"".into()))?
        }
    };
    SlabSet::of(&directions).map_err(|error| wrong(error.to_string()))
}

/// The hierarchy that a trace was made with.
///
/// # Errors
/// Its strategy has none.
pub(in crate::figure) fn hierarchy(traced: &Traced) -> Result<Hierarchy<MOST_SLABS>, FigureError> {
    let strategies = [StrategyName::Hierarchy, StrategyName::Heap];
    if !strategies.contains(&traced.settings.strategy) {
        return Err(FigureError::new(
            "strategy",
            "this kind of figure draws a hierarchy, and the strategy builds no hierarchy",
            "add \"strategy\": \"hierarchy\" or \"heap\"",
        ));
    }
    let build = traced.settings.structure.build;
    Ok(Hierarchy::new(&traced.scene, &set(traced)?, build))
}

/// The bound around an object or a node, whether a ray looked at all its slabs or not.
///
/// # Errors
/// The strategy has no such bounds.
pub(in crate::figure) fn bound_of(traced: &Traced, of: Bounded) -> Result<Vec<Slab>, FigureError> {
    let set = set(traced)?;
    let bound = match of {
        Bounded::Object(object) if (object as usize) < traced.scene.objects.len() => {
            let kind = VolumeKind::Slabs;
            match Volume::around(&traced.scene, object as usize, kind, &set) {
                Volume::Slabs(bound) => Some(bound),
                _ => None,
            }
        }
        Bounded::Object(_) => None,
        Bounded::Node(node) => {
            let hierarchy = hierarchy(traced)?;
            hierarchy.nodes().get(node as usize).map(|node| node.bound)
        }
    };
    let bound = bound.ok_or_else(|| {
        FigureError::new(
            "structure",
            "there is no such bound",
            "trace the figure again",
        )
    })?;
    Ok(slabs(&set, &bound))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slab(number: u32, normal: [f64; 3], from: f64, to: f64) -> Slab {
        Slab {
            number,
            normal: DVec3::from(normal).normalize(),
            d_min: -to,
            d_max: -from,
        }
    }

    /// A square of side 2 around the origin, without its corners where |x + y| or |x − y| is above 1.5.
    fn octagon() -> Vec<Slab> {
        let cut = 1.5 / 2f64.sqrt();
        vec![
            slab(0, [1.0, 0.0, 0.0], -1.0, 1.0),
            slab(1, [0.0, 1.0, 0.0], -1.0, 1.0),
            slab(2, [1.0, 1.0, 0.0], -cut, cut),
            slab(3, [1.0, -1.0, 0.0], -cut, cut),
            slab(4, [0.0, 0.0, 1.0], 0.0, 3.0),
        ]
    }

    #[test]
    fn four_slabs_across_the_plane_bound_an_octagon() {
        let corners = corners(&octagon());
        assert_eq!(corners.len(), 16, "eight below, eight above");
        for corner in &corners {
            // each lies on a side of the square, half a unit from its middle
            let mut flat = [corner.x.abs(), corner.y.abs()];
            flat.sort_by(f64::total_cmp);
            assert!((flat[0] - 0.5).abs() < 1e-12 && (flat[1] - 1.0).abs() < 1e-12);
            assert!(corner.z.abs() < 1e-12 || (corner.z - 3.0).abs() < 1e-12);
        }
        let from_the_front = Projection::new(DVec3::X, DVec3::Y);
        let outline = outline(&octagon(), &from_the_front);
        assert_eq!(outline.rim.points().len(), 8);
        assert!((middle(&octagon()) - DVec3::new(0.0, 0.0, 1.5)).length() < 1e-12);
    }

    #[test]
    fn the_axes_bound_a_box_with_edges() {
        let axes = [
            slab(0, [1.0, 0.0, 0.0], 0.0, 1.0),
            slab(1, [0.0, 1.0, 0.0], 0.0, 2.0),
            slab(2, [0.0, 0.0, 1.0], 0.0, 3.0),
        ];
        let slanted = Projection::new(DVec3::new(1.0, 0.0, -1.0), DVec3::new(-1.0, 2.0, -1.0));
        assert_eq!(outline(&axes, &slanted).edges.len(), 9);
        let above = Projection::new(DVec3::X, DVec3::NEG_Z);
        let seen: Vec<bool> = axes.iter().map(|slab| slab.is_on_edge(&above)).collect();
        assert_eq!(seen, [true, false, true]);
    }

    #[test]
    fn a_plane_is_a_line_across_its_normal() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(100.0, 100.0),
        };
        let projection = Projection::new(DVec3::X, DVec3::Y);
        // 92 units for 2: x = 1 is at 96, and the line goes upwards, to the left of the normal
        let shown = [DVec3::NEG_ONE, DVec3::ONE];
        let space = Space::fitted(projection, frame, shown);
        let x = slab(0, [1.0, 0.0, 0.0], -1.0, 1.0);
        let [from, to] = x.line(&space, frame, x.d_min, DVec3::ZERO).unwrap();
        assert!((from - DVec2::new(96.0, 100.0)).length() < 1e-9, "{from}");
        assert!((to - DVec2::new(96.0, 0.0)).length() < 1e-9, "{to}");
        assert_eq!(x.line(&space, frame, -9.0, DVec3::ZERO), None);
        assert_eq!(Slab { number: 12, ..x }.name(), "n₁₂");
    }
}
