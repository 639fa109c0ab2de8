//! The outline of a bounding volume around an object, built from the scene as the strategy builds it.

use glam::DVec3;

use crate::figure::error::FigureError;
use crate::figure::parts::outline::{Outline, Rim, hull};
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;
use crate::figure::view::Projection;
use crate::scene::{Scene, Shape};
use crate::structure::{SlabBound, SlabChoice, SlabSet, Volume, VolumeKind};

/// The outline of the volume around an object, by its place in the scene.
pub(in crate::figure) fn around_object(
    figure: &Figure,
    traced: &Traced,
    number: usize,
) -> Result<Outline, FigureError> {
    let options = traced.settings.structure;
    let projection = figure.projection();
    let slabs = match options.volume {
        VolumeKind::Slabs => options.slabs,
        _ => SlabChoice::Axes,
    };
    Ok(match slabs {
        SlabChoice::Axes => around(
            figure.scene,
            number,
            options.volume,
            &SlabSet::AXES,
            &projection,
        ),
        SlabChoice::Seven => around(
            figure.scene,
            number,
            options.volume,
            &SlabSet::SEVEN,
            &projection,
        ),
        SlabChoice::Scene => {
            let own = figure.scene.slabs.as_deref().unwrap_or_default();
            let set = SlabSet::of(own).map_err(|error| {
                FigureError::new(
                    "structure",
                    error.to_string(),
                    "change the scene's \"slabs\"",
                )
            })?;
            around(figure.scene, number, options.volume, &set, &projection)
        }
    })
}

pub(in crate::figure) fn around<const N: usize>(
    scene: &Scene,
    number: usize,
    kind: VolumeKind,
    set: &SlabSet<N>,
    projection: &Projection,
) -> Outline {
    match Volume::around(scene, number, kind, set) {
        Volume::Sphere(sphere) => Outline::of(&Shape::Sphere(sphere), projection),
        Volume::Ellipsoid(egg) => Outline::of_ellipsoid(&egg, projection),
        Volume::Box(bound) => Outline::of_box(&bound.as_box(), projection),
        Volume::Slabs(bound) => {
            let seen = corners(&bound, set).into_iter().map(|p| projection.of(p));
            Outline {
                rim: Rim::Points(hull(seen.collect())),
                ..Outline::default()
            }
        }
        Volume::Nothing => Outline::default(),
    }
}

/// The points in which three planes of a bound meet and which all its slabs hold: the corners of the convex
/// polyhedron, some of them several times.
///
/// Each slab n with its D_min and D_max is the two half-spaces n·p ≤ -D_min and -n·p ≤ D_max. Three planes nᵢ·p = hᵢ
/// meet in p = (h₁·n₂×n₃ + h₂·n₃×n₁ + h₃·n₁×n₂)/(n₁·n₂×n₃).
fn corners<const N: usize>(bound: &SlabBound<N>, set: &SlabSet<N>) -> Vec<DVec3> {
    /// Three directions are in one plane, or a point on a slab, within the rounding of unit vectors.
    const ROUNDING: f64 = 1e-9;
    let planes: Vec<(DVec3, f64)> = (set.directions().iter())
        .zip(bound.d_min.iter().zip(&bound.d_max))
        .flat_map(|(&n, (&d_min, &d_max))| [(n, -d_min), (-n, d_max)])
        .collect();
    let size = planes
        .iter()
        .fold(0.0_f64, |size, (_, h)| size.max(h.abs()));
    let is_held = |p: DVec3| planes.iter().all(|(n, h)| n.dot(p) <= h + ROUNDING * size);
    let mut corners = Vec::new();
    for (i, &(n1, h1)) in planes.iter().enumerate() {
        for (j, &(n2, h2)) in planes.iter().enumerate().skip(i + 1) {
            for &(n3, h3) in planes.iter().skip(j + 1) {
                let volume = n1.dot(n2.cross(n3));
                if volume.abs() <= ROUNDING {
                    continue;
                }
                let sum = h1 * n2.cross(n3) + h2 * n3.cross(n1) + h3 * n1.cross(n2);
                corners.extend(Some(sum / volume).filter(|p| is_held(*p)));
            }
        }
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_slabs_have_the_corners_of_a_box() {
        // 1 ≤ x ≤ 2, 3 ≤ y ≤ 5, -1 ≤ z ≤ 1
        let bound = SlabBound {
            d_min: [-2.0, -5.0, -1.0],
            d_max: [-1.0, -3.0, 1.0],
        };
        let corners = corners(&bound, &SlabSet::AXES);
        assert_eq!(corners.len(), 8);
        for expected in [[1.0, 3.0, -1.0], [2.0, 5.0, 1.0], [2.0, 3.0, 1.0]] {
            assert!(corners.contains(&expected.into()), "{expected:?}");
        }
    }

    #[test]
    fn diagonal_slabs_cut_the_corners_off() {
        // the octahedron |x| + |y| + |z| ≤ 1 in a cube of the side 2
        let third = 1.0 / 3.0_f64.sqrt();
        let mut bound = SlabBound {
            d_min: [-third; 7],
            d_max: [third; 7],
        };
        for slab in 0..3 {
            (bound.d_min[slab], bound.d_max[slab]) = (-1.0, 1.0);
        }
        let corners = corners(&bound, &SlabSet::SEVEN);
        assert!(!corners.is_empty());
        // its six corners, each along an axis, and no other
        for corner in corners {
            let [x, y, z] = corner.abs().to_array();
            let sum = x + y + z;
            assert!(
                (sum - 1.0).abs() < 1e-8 && (x.max(y).max(z) - 1.0).abs() < 1e-8,
                "{corner}"
            );
        }
    }
}
