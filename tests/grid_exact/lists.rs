//! Which cells list an object.

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::scene::PrimitiveId;
use raystep::structure::{AssignStep, Grid, GridError, GridOptions, Lists, Share};

use crate::grid_exact::{scene, sphere};

fn grid(shapes: &[String], resolution: [u32; 3], lists: Lists) -> Grid {
    let options = GridOptions {
        resolution: Some(resolution),
        lists,
        ..GridOptions::default()
    };
    Grid::new(&scene(shapes), &options).unwrap()
}

/// How many of a grid's cells list the first object.
fn listing(grid: &Grid) -> usize {
    let [nx, ny, nz] = grid.resolution();
    let cells =
        (0..nx).flat_map(move |i| (0..ny).flat_map(move |j| (0..nz).map(move |k| [i, j, k])));
    let lists = |cell: &[u32; 3]| grid.cell_objects(*cell).contains(&PrimitiveId(0));
    cells.filter(lists).count()
}

#[test]
fn a_sphere_is_in_the_corners_of_its_box_by_its_box_alone() {
    // radius 2 in 4 × 4 × 4 cells with sides of 1: the closest point of a corner cell is (1, 1, 1), at √3 < 2;
    // with 8 cells, sides ½, it is (1½, 1½, 1½) at 2.6, and (1½, 1½, 0) at 2.12
    let ball = [sphere([0.0; 3], 2.0)];
    assert_eq!(listing(&grid(&ball, [4; 3], Lists::Boxes)), 64);
    assert_eq!(listing(&grid(&ball, [4; 3], Lists::Objects)), 64);
    assert_eq!(listing(&grid(&ball, [8; 3], Lists::Boxes)), 512);
    // in an octant the cells (a, b, c)·½, a, b, c from 0 to 3, with a² + b² + c² ≤ 16: all 64 but those
    // with two 3s (3·3 + 1 = 10), and (3, 2, 2), 17, in 3 orders
    assert_eq!(
        listing(&grid(&ball, [8; 3], Lists::Objects)),
        8 * (64 - 10 - 3)
    );
}

#[test]
fn a_cell_inside_a_sphere_lists_it() {
    let grid = grid(&[sphere([0.0; 3], 2.0)], [9; 3], Lists::Objects);
    assert_eq!(grid.cell_objects([4; 3]), [PrimitiveId(0)]);
    assert_eq!(grid.cell_objects([0; 3]), []);
    assert_eq!(grid.cell_objects([9, 0, 0]), []);
}

#[test]
fn a_triangle_is_in_the_cells_on_its_side_of_the_diagonal() {
    // half of a square of 4 × 4 cells: 4 on the diagonal, 6 beneath, and the 3 corners on the diagonal itself
    // touch 6 cells more
    let triangle = [r#""polygon": {"vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]}"#.to_string()];
    assert_eq!(listing(&grid(&triangle, [4, 4, 1], Lists::Boxes)), 16);
    assert_eq!(listing(&grid(&triangle, [4, 4, 1], Lists::Objects)), 13);
}

#[test]
fn objects_are_assigned_one_after_the_other_wholly_or_in_part() {
    let shapes = [sphere([1.0, 1.0, 1.0], 1.0), sphere([3.0, 1.0, 1.0], 0.5)];
    // x from 0 to 3.5: a plane at 1.75 between two cells
    let options = GridOptions {
        resolution: Some([2, 1, 1]),
        ..GridOptions::default()
    };
    let scene = scene(&shapes);
    let grid = Grid::new(&scene, &options).unwrap();
    let step = |object, i, share| AssignStep {
        object: PrimitiveId(object),
        cell: [i, 0, 0],
        share,
    };
    let found: Vec<_> = grid.assignments(&scene).collect();
    let expected = [
        step(0, 0, Share::Part),
        step(0, 1, Share::Part),
        step(1, 1, Share::Whole),
    ];
    assert_eq!(found, expected);
    assert_eq!(grid.lists_total(), 3);
    assert_eq!(
        grid.cell_objects([1, 0, 0]),
        [PrimitiveId(0), PrimitiveId(1)]
    );
}

#[test]
fn a_scene_without_objects_has_a_grid_without_cells() {
    let empty = Grid::new(&scene(&[]), &GridOptions::default()).unwrap();
    assert_eq!(empty.resolution(), [0; 3]);
    let ray = Ray::new(DVec3::ZERO, DVec3::X);
    assert_eq!(empty.walk(&ray, TRange::FORWARD).count(), 0);
    assert_eq!(empty.inside(&ray), None);
}

#[test]
fn objects_in_one_point_and_flat_scenes_have_a_grid() {
    let ball = sphere([1.0, 2.0, 3.0], 1e-9);
    let options = GridOptions::default();
    let grid = Grid::new(&scene(&vec![ball; 50]), &options).unwrap();
    assert!(0 < grid.lists_total());
    let square = r#""polygon": {"vertices": [[0, 0, 5], [4, 0, 5], [4, 4, 5], [0, 4, 5]]}"#;
    let flat = Grid::new(&scene(&vec![square.to_string(); 12]), &options).unwrap();
    // 12 objects, 3 cells for each: 6 × 6
    assert_eq!(flat.resolution(), [6, 6, 1]);
}

#[test]
fn a_grid_that_cannot_be_built_is_an_error_that_says_what_to_do() {
    let error = |resolution| {
        let options = GridOptions {
            resolution: Some(resolution),
            ..GridOptions::default()
        };
        Grid::new(&scene(&[sphere([0.0; 3], 1.0)]), &options).unwrap_err()
    };
    let many = error([1000; 3]);
    assert_eq!(many, GridError::TooManyCells { cells: 1e9 });
    assert!(many.to_string().contains("smaller resolution"), "{many}");
    assert!(matches!(error([5, 0, 5]), GridError::NoCells { .. }));

    let density = GridOptions {
        density: -1.0,
        ..GridOptions::default()
    };
    assert!(Grid::new(&scene(&[]), &density).is_err());

    // more than 2²⁸ entries: 20 boxes, each in all of 250³ cells
    let wide = vec![r#""box": {"min": [0, 0, 0], "max": [1, 1, 1]}"#.to_string(); 20];
    let options = GridOptions {
        resolution: Some([250; 3]),
        ..GridOptions::default()
    };
    let error = Grid::new(&scene(&wide), &options).unwrap_err();
    assert!(matches!(error, GridError::TooManyEntries { .. }), "{error}");
}
