//! How many cells a grid has along each axis.

use glam::DVec3;

use crate::geometry::AxisBox;
use crate::structure::grid::cell_planes::CellPlanes;
use crate::structure::{GridError, GridOptions, MOST_CELLS, MOST_CELLS_ALONG};

/// Cells along x, y and z of a grid over `objects` objects in a box: as they are given, or by Woo's rule.
///
/// # Errors
/// A density that is not above 0, no cells, too many in all or in a row, or too thin ones.
pub(in crate::structure) fn resolution(
    around: &AxisBox,
    objects: usize,
    options: &GridOptions,
) -> Result<[u32; 3], GridError> {
    let density = options.density;
    if !(0.0 < density && density.is_finite()) {
        return Err(GridError::Density { density });
    }
    let most = [0, 1, 2].map(|axis| {
        let [low, high] = around.along(axis);
        CellPlanes::most_along(low, high).max(1.0)
    });
    let along = match options.resolution {
        Some(resolution) if resolution.contains(&0) => {
            return Err(GridError::NoCells { resolution });
        }
        Some(resolution) => resolution.map(f64::from),
        None => woo(around.size(), density * objects as f64),
    };
    let cells = along.iter().product();
    if f64::from(MOST_CELLS) < cells {
        return Err(GridError::TooManyCells { cells });
    }
    for (axis, cells) in options.resolution.into_iter().flatten().enumerate() {
        if MOST_CELLS_ALONG < cells {
            return Err(GridError::TooManyAlong { axis, cells });
        }
        if most[axis] < f64::from(cells) {
            let most = most[axis] as u32;
            return Err(GridError::TooThin { axis, most });
        }
    }
    Ok([0, 1, 2].map(|axis| along[axis].min(most[axis]) as u32))
}

/// About `cells` cells that are about cubes (after A. Woo): n = side·∛(cells/V), to the nearest whole number.
///
/// Havran's and Sixta's grid over Haines's balls, 46 × 46 × 3 cells for 7382 objects in 24 × 24 × 1.33, is that
/// of a density from 0.708 to 0.755.
///
/// A scene too flat for a whole cell across it is one cell thick, and the cells are shared out among the other
/// axes: n = side·√(cells/A); likewise along a line.
fn woo(sides: DVec3, cells: f64) -> [f64; 3] {
    let mut is_flat = [false; 3];
    loop {
        let thick = || (0..3).filter(|&axis| !is_flat[axis]);
        let volume: f64 = thick().map(|axis| sides[axis]).product();
        let per_length = libm::pow(cells / volume, 1.0 / thick().count() as f64);
        let thinnest = thick().min_by(|&a, &b| sides[a].total_cmp(&sides[b]));
        match thinnest {
            Some(axis) if sides[axis] * per_length < 1.0 => is_flat[axis] = true,
            _ => {
                return [0, 1, 2].map(|axis: usize| {
                    if is_flat[axis] {
                        1.0
                    } else {
                        (sides[axis] * per_length).round().max(1.0)
                    }
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(sides: [f64; 3], objects: usize, density: f64, expected: [u32; 3]) {
        let options = GridOptions {
            density,
            ..GridOptions::default()
        };
        let around = AxisBox::around([DVec3::ZERO, DVec3::from(sides)]);
        let found = resolution(&around, objects, &options);
        assert_eq!(found, Ok(expected));
    }

    #[test]
    fn a_cube_has_the_cube_root_along_each_axis() {
        check([5.0; 3], 1000, 1.0, [10; 3]);
        check([5.0; 3], 1000, 8.0, [20; 3]);
        check([5.0; 3], 1, 0.1, [1; 3]);
    }

    #[test]
    fn cells_are_about_cubes_in_a_long_box() {
        // V = 4, ∛(4000/4) = 10
        check([4.0, 1.0, 1.0], 4000, 1.0, [40, 10, 10]);
    }

    #[test]
    fn balls_has_the_published_grid_at_three_cells_for_four_objects() {
        // V = 766.4, ∛(0.75·7382/V) = 1.933: 46.39, 46.39 and 2.57
        check([24.0, 24.0, 1.330_567], 7382, 0.75, [46, 46, 3]);
    }

    #[test]
    fn a_flat_scene_is_one_cell_thick_and_a_thin_one_a_row() {
        check([1.0, 1.0, 1e-9], 100, 1.0, [10, 10, 1]);
        check([1e-9, 1.0, 1e-9], 100, 1.0, [1, 100, 1]);
    }

    #[test]
    fn what_makes_no_sense_is_refused_before_anything_is_built() {
        let around = AxisBox::around([DVec3::ZERO, DVec3::ONE]);
        let refused = |options: GridOptions| resolution(&around, 10, &options);
        let with = |density| GridOptions {
            density,
            ..GridOptions::default()
        };
        for density in [0.0, -1.0, f64::INFINITY] {
            assert_eq!(refused(with(density)), Err(GridError::Density { density }));
        }
        assert!(refused(with(f64::NAN)).is_err());
        let of = |resolution| GridOptions {
            resolution: Some(resolution),
            ..GridOptions::default()
        };
        let none = [3, 0, 3];
        assert_eq!(
            refused(of(none)),
            Err(GridError::NoCells { resolution: none })
        );
        let many = GridError::TooManyCells { cells: 1e9 };
        assert_eq!(refused(of([1000; 3])), Err(many));
        assert!(refused(of([u32::MAX; 3])).is_err());
        let row = GridError::TooManyAlong {
            axis: 1,
            cells: 4097,
        };
        assert_eq!(refused(of([1, 4097, 1])), Err(row));
        assert_eq!(refused(of([1, 4096, 1])), Ok([1, 4096, 1]));
        assert!(refused(with(1e300)).is_err());
    }

    #[test]
    fn a_box_beside_the_origin_has_as_many_cells_as_one_in_it() {
        let options = GridOptions {
            density: 1.0,
            ..GridOptions::default()
        };
        let min = DVec3::new(100.0, -50.0, 3.0);
        let found = resolution(
            &AxisBox::around([min, min + DVec3::new(4.0, 1.0, 1.0)]),
            4000,
            &options,
        );
        assert_eq!(found, Ok([40, 10, 10]));
    }

    #[test]
    fn as_many_cells_as_there_may_be_are_allowed_and_one_more_along_a_thin_side_is_not() {
        let of = |min: f64, max: f64, resolution: [u32; 3]| {
            let options = GridOptions {
                resolution: Some(resolution),
                ..GridOptions::default()
            };
            super::resolution(
                &AxisBox::around([DVec3::splat(min), DVec3::splat(max)]),
                10,
                &options,
            )
        };
        // 2¹² · 2¹² · 2² = 64·2²⁰
        assert_eq!(of(0.0, 1.0, [4096, 4096, 4]), Ok([4096, 4096, 4]));
        assert!(of(0.0, 1.0, [4096, 4096, 5]).is_err());
        // a length of 2⁻⁴⁰ beside 1: cells are 8ε of the larger coordinate, which is 2⁻⁴⁹ and a little more
        let max = 1.0 + 0.5_f64.powi(40);
        let most = (0.5_f64.powi(40) / (8.0 * f64::EPSILON * max)).floor() as u32;
        assert_eq!(most, 511);
        assert_eq!(of(1.0, max, [1, 511, 1]), Ok([1, 511, 1]));
        let thin = GridError::TooThin { axis: 1, most: 511 };
        assert_eq!(of(1.0, max, [1, 512, 1]), Err(thin));
    }
}
