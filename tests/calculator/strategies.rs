//! The search of every strategy and what it built, computed again.

use raystep::structure::{Build, SlabChoice, VolumeKind};
use raystep::{Settings, StrategyName, StructureOptions};

use super::{check_line, check_with, solution};

fn with(strategy: StrategyName, structure: StructureOptions) -> Settings {
    Settings {
        strategy,
        structure,
        building: true,
        ..Settings::default()
    }
}

/// Bounds of slabs, hierarchies and the heap, on the axes and across the diagonals.
fn of_slabs() -> Vec<Settings> {
    let mut all = Vec::new();
    for slabs in [SlabChoice::Axes, SlabChoice::Seven] {
        for (strategy, build) in [
            (StrategyName::Bounds, Build::BottomUp),
            (StrategyName::Hierarchy, Build::BottomUp),
            (StrategyName::Hierarchy, Build::Insertion),
            (StrategyName::Heap, Build::SurfaceArea),
        ] {
            let structure = StructureOptions {
                volume: VolumeKind::Slabs,
                slabs,
                build,
                ..StructureOptions::default()
            };
            all.push(with(strategy, structure));
        }
    }
    all
}

#[test]
fn aligned_rays_can_be_computed_again() {
    let settings = with(StrategyName::ZAligned, StructureOptions::default());
    let check = |scene: &str, pixel, at_least| {
        check_with(&settings, scene, pixel, at_least);
    };
    for pixel in [[80, 60], [120, 60], [80, 110], [112, 56], [140, 62]] {
        check("lessons/04-sphere/scene.json", pixel, [20, 3]);
    }
    for (name, at_least) in [
        ("balls-2", [500, 10]),
        ("gears-1", [100, 5]),
        ("rings-1", [50, 5]),
        ("tetra-3", [50, 3]),
        ("tree-4", [100, 5]),
    ] {
        for pixel in [[256, 256], [200, 300]] {
            check(&format!("tests/data/nff/{name}.nff"), pixel, at_least);
        }
    }
}

#[test]
fn slabs_and_their_hierarchies_can_be_computed_again() {
    for settings in of_slabs() {
        for pixel in [[80, 60], [120, 60], [80, 110], [112, 56], [140, 62]] {
            // S, T, near and far of 3 slabs for each of two rays, at least
            check_with(
                &settings,
                "lessons/04-sphere/scene.json",
                pixel,
                [2 * 3 * 4, 1],
            );
        }
        for name in ["balls-2", "gears-1", "rings-1", "tetra-3", "tree-4"] {
            let scene = format!("tests/data/nff/{name}.nff");
            for pixel in [[256, 256], [200, 300]] {
                check_with(&settings, &scene, pixel, [50, 3]);
            }
        }
    }
}

#[test]
fn what_was_built_before_the_first_ray_can_be_computed_again() {
    // leaves of the surface-area build hold several objects, with nothing to join
    let joins_all = |settings: &Settings| settings.structure.build != Build::SurfaceArea;
    for settings in of_slabs().into_iter().filter(joins_all) {
        let scene = "lessons/04-sphere/scene.json";
        let text = solution(scene, [80, 60], &settings);
        let merges: Vec<_> = text
            .lines()
            .filter(|line| line.trim_start().starts_with("node ") && line.contains(" from "))
            .collect();
        let sums = merges.iter().map(|line| check_line(line));
        let [numbers, vectors] = sums.fold([0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
        // a tree over 4 objects joins 3 times, each time D_min and D_max of every slab; bounds join nothing
        let slabs = match settings.structure.slabs {
            SlabChoice::Seven => 7,
            _ => 3,
        };
        let joins = match settings.strategy {
            StrategyName::Bounds => 0,
            _ => 3,
        };
        assert_eq!([numbers, vectors], [2 * slabs * joins, 0], "{text}");
    }
}

#[test]
fn walks_through_a_grid_can_be_computed_again() {
    let settings = with(StrategyName::Grid, StructureOptions::default());
    for pixel in [[80, 60], [120, 60], [80, 110], [112, 56], [140, 62]] {
        check_with(&settings, "lessons/04-sphere/scene.json", pixel, [10, 1]);
    }
    for name in ["balls-2", "gears-1", "rings-1", "tetra-3", "tree-4"] {
        let scene = format!("tests/data/nff/{name}.nff");
        for pixel in [[256, 256], [200, 300]] {
            check_with(&settings, &scene, pixel, [5, 3]);
        }
    }
}
