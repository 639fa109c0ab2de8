//! Which strategies are compared, with which variants, and what each is called.

use crate::scene::Scene;
use crate::structure::{Build, SlabChoice, VolumeKind};
use crate::trace::{Settings, StrategyName};

/// Returns the name of a strategy and what makes its variant, as in `hierarchy, insertion`.
pub fn strategy_title(settings: &Settings) -> String {
    let structure = &settings.structure;
    let build = match structure.build {
        Build::BottomUp => "bottom-up",
        Build::Insertion => "insertion",
        Build::SurfaceArea => "surface-area",
    };
    let slabs = match structure.slabs {
        SlabChoice::Axes => "",
        SlabChoice::Seven => ", 7 slabs",
        SlabChoice::Scene => ", own slabs",
    };
    match settings.strategy {
        StrategyName::Exhaustive => "exhaustive".into(),
        StrategyName::Bounds => match structure.volume {
            VolumeKind::Sphere => "bounds, sphere".into(),
            VolumeKind::Ellipsoid => "bounds, ellipsoid".into(),
            VolumeKind::Box => "bounds, box".into(),
            VolumeKind::Slabs if slabs.is_empty() => "bounds, 3 slabs".into(),
            VolumeKind::Slabs => format!("bounds{slabs}"),
        },
        StrategyName::Hierarchy => format!("hierarchy, {build}{slabs}"),
        StrategyName::Heap => format!("heap, {build}{slabs}"),
        StrategyName::Grid if structure.grid.mailboxes => "grid, mailboxes".into(),
        StrategyName::Grid => "grid, no mailboxes".into(),
        StrategyName::ZAligned => "z-aligned".into(),
    }
}

/// All strategies with their variants, over the rays of these settings; the scene's own slabs where it has
/// some.
pub fn strategies_to_compare(scene: &Scene, settings: &Settings) -> Vec<Settings> {
    let usual = |strategy| Settings {
        strategy,
        ..settings.clone()
    };
    let mut list = vec![usual(StrategyName::Exhaustive)];
    for volume in [
        VolumeKind::Sphere,
        VolumeKind::Ellipsoid,
        VolumeKind::Box,
        VolumeKind::Slabs,
    ] {
        let mut bounds = usual(StrategyName::Bounds);
        bounds.structure.volume = volume;
        if volume == VolumeKind::Slabs {
            bounds.structure.slabs = SlabChoice::Seven;
        }
        list.push(bounds);
    }
    let own = scene.slabs.as_ref().map(|_| SlabChoice::Scene);
    let variants = [
        (Build::BottomUp, SlabChoice::Axes),
        (Build::Insertion, SlabChoice::Axes),
        (Build::SurfaceArea, SlabChoice::Axes),
        (Build::BottomUp, SlabChoice::Seven),
    ];
    let own = own.map(|slabs| (Build::BottomUp, slabs));
    for (build, slabs) in variants.into_iter().chain(own) {
        let mut hierarchy = usual(StrategyName::Hierarchy);
        hierarchy.structure.build = build;
        hierarchy.structure.slabs = slabs;
        list.push(hierarchy);
    }
    list.push(usual(StrategyName::Heap));
    for mailboxes in [true, false] {
        let mut grid = usual(StrategyName::Grid);
        grid.structure.grid.mailboxes = mailboxes;
        list.push(grid);
    }
    list.push(usual(StrategyName::ZAligned));
    list
}
