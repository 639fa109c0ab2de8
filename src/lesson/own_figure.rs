//! A figure of a scene that no lesson knows: what it shows, and from where, is chosen by the scene and the ray.

use glam::DVec3;

use crate::figure::{FigureError, FigureKind, FigureSpec, Traced, View, around_rays};
use crate::lesson::{LessonError, trace_figure};
use crate::scene::{Loaded, Place, Shape};
use crate::structure::{SlabChoice, VolumeKind};
use crate::trace::{Event, StrategyName, Transport};

/// Traces a scene for a figure of that kind and pixel, and says what the figure shows.
///
/// The strategy is the one that the kind draws. Kinds that look at a plane look at the one in which the eye ray is longest.
/// Where the scene is larger than what happens to the ray, the figure shows the part around it.
///
/// # Errors
/// A scene that makes no sense, or of which there is no such figure.
pub fn own_figure(
    loaded: Loaded,
    kind: FigureKind,
    pixel: [u32; 2],
    file: &str,
) -> Result<(FigureSpec, Vec<Traced>), LessonError> {
    let mut spec = FigureSpec::new(kind, file);
    spec.pixel = Some(pixel);
    choose(&mut spec, loaded.scene.slabs.is_some());
    if kind == FigureKind::Heat {
        // a map of every pixel, for each strategy
        spec.pixel = None;
        spec.size = Some(small(loaded.scene.camera.pixels));
    }
    let traced = trace_figure(loaded, file, &spec, |error| wrong_figure(file, error))?;
    if let Some(first) = traced.first() {
        spec.object = hit(kind, first);
        let with_window = usize::from(kind == FigureKind::Window);
        let around = around_rays(first).map(|around| around[with_window]);
        if let Some((direction, corners)) = around {
            spec.view = view(kind, direction);
            spec.frame = has_frame(kind).then_some(corners.map(|corner| corner.to_array()));
        }
    }
    Ok((spec, traced))
}

/// A figure that a scene does not have.
pub fn wrong_figure(file: &str, error: FigureError) -> LessonError {
    let place = Place {
        file: file.into(),
        line: None,
        path: String::new(),
    };
    LessonError::Figure {
        place: Box::new(place),
        error,
    }
}

/// The size of a picture that is at most 128 pixels wide or high.
fn small([width, height]: [u32; 2]) -> [u32; 2] {
    const MOST: u32 = 128;
    let by = width.max(height).div_ceil(MOST);
    [width, height].map(|side| side.div_ceil(by.max(1)))
}

/// The object that the eye ray hits, where the kind draws one object and can draw this one.
fn hit(kind: FigureKind, traced: &Traced) -> Option<String> {
    let end = traced
        .records
        .iter()
        .find_map(|record| match &record.event {
            Event::RayEnd(end) if record.ray == Some(0) => Some(end),
            _ => None,
        })?;
    let id = end.object?;
    let is_drawn = matches!(
        (kind, &traced.scene.primitive(id).shape),
        (FigureKind::Sphere, Shape::Sphere(_))
            | (FigureKind::Polygon, Shape::Polygon(_))
            | (
                FigureKind::Volumes | FigureKind::Slabs | FigureKind::Intervals,
                _
            )
    );
    is_drawn.then(|| traced.scene.object_of(id).name.to_string())
}

/// What the kind draws: its strategies, its structure, its transport.
fn choose(spec: &mut FigureSpec, has_slabs: bool) {
    use FigureKind as Kind;
    spec.strategy = match spec.kind {
        Kind::Hierarchy | Kind::Merge => StrategyName::Hierarchy,
        Kind::Heap => StrategyName::Heap,
        Kind::Grid | Kind::Steps | Kind::Partition => StrategyName::Grid,
        Kind::Slabs | Kind::Intervals | Kind::Volumes => StrategyName::Bounds,
        Kind::Alignment => StrategyName::ZAligned,
        _ => StrategyName::Exhaustive,
    };
    match spec.kind {
        Kind::Slabs | Kind::Intervals => {
            spec.structure.volume = VolumeKind::Slabs;
            spec.structure.slabs = if has_slabs {
                SlabChoice::Scene
            } else {
                SlabChoice::Axes
            };
        }
        Kind::Volumes => {
            spec.volumes = vec![
                VolumeKind::Sphere,
                VolumeKind::Ellipsoid,
                VolumeKind::Box,
                VolumeKind::Slabs,
            ];
        }
        Kind::Costs => {
            spec.strategies = vec![
                StrategyName::Exhaustive,
                StrategyName::Bounds,
                StrategyName::Hierarchy,
                StrategyName::Heap,
                StrategyName::Grid,
                StrategyName::ZAligned,
            ];
        }
        Kind::Heat => {
            spec.strategies = vec![
                StrategyName::Exhaustive,
                StrategyName::Hierarchy,
                StrategyName::Grid,
            ];
        }
        _ => {}
    }
    spec.transport = match spec.kind {
        Kind::Paths | Kind::Gather | Kind::Irradiance => Transport::HybridStored,
        Kind::Connections => Transport::HybridConnected,
        // the rays that the others leave out would only be in the way
        Kind::Rays | Kind::Shading | Kind::Picture => Transport::default(),
        _ => Transport::Backward,
    };
}

/// From where such a figure is best seen: in space, or across the axis along which the ray moves least.
pub(super) fn view(kind: FigureKind, direction: DVec3) -> View {
    use FigureKind as Kind;
    match kind {
        Kind::Pinhole | Kind::Window | Kind::Polygon | Kind::Partition => View::Axonometric,
        _ => {
            let [x, y, z] = direction.abs().to_array();
            if y <= x && y <= z {
                View::Top
            } else if z <= x {
                View::Front
            } else {
                View::Side
            }
        }
    }
}

/// Does the kind show the whole scene if no part of it is named?
pub(super) fn has_frame(kind: FigureKind) -> bool {
    use FigureKind as Kind;
    matches!(
        kind,
        Kind::Window | Kind::Rays | Kind::Paths | Kind::Grid | Kind::Hierarchy | Kind::Connections
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_of_every_pixel_has_at_most_128_a_side() {
        for (pixels, expected) in [
            ([512, 512], [128, 128]),
            ([100, 60], [100, 60]),
            ([129, 3], [65, 2]),
        ] {
            assert_eq!(small(pixels), expected);
        }
    }

    #[test]
    fn a_plane_figure_is_seen_across_the_axis_along_which_the_ray_moves_least() {
        let of = |x, y, z| view(FigureKind::Grid, DVec3::new(x, y, z));
        assert_eq!(of(1.0, -0.25, 0.5), View::Top);
        assert_eq!(of(1.0, -0.5, 0.25), View::Front);
        assert_eq!(of(0.25, -0.5, 1.0), View::Side);
    }
}
