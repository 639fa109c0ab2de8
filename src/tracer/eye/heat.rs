//! What each pixel cost: the counts of its eye rays, for a heat map.

use crate::trace::{Event, NodeVerdict, Purpose, RayVerdict, Recorder, Through};

/// What one eye ray cost, with all rays that it spawned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Heat {
    /// Objects tested: a polygon counts once, by its plane.
    pub tests: u64,
    /// Bounds tested and nodes entered.
    pub nodes: u64,
    /// Cells of the grid visited.
    pub cells: u64,
    /// The largest depth of a ray that was traced: 1 for the eye ray, one more for each surface that
    /// spawned a ray, shadow rays included.
    pub depth: u32,
}

/// What of it is shown?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeatOf {
    /// The number of object tests of the pixel's rays
    Tests,
    /// The number of bound tests and of nodes entered
    Nodes,
    /// The number of grid cells visited
    Cells,
    /// The depth of the tree of rays: 1 for the eye ray alone; shadow rays count
    Depth,
}

impl HeatOf {
    /// What the numbers of the map are.
    pub fn title(self) -> &'static str {
        match self {
            Self::Tests => "object tests per pixel",
            Self::Nodes => "bound tests and nodes entered per pixel",
            Self::Cells => "cells visited per pixel",
            Self::Depth => "depth of the ray tree per pixel",
        }
    }

    fn value(self, heat: &Heat) -> f64 {
        match self {
            Self::Tests => heat.tests as f64,
            Self::Nodes => heat.nodes as f64,
            Self::Cells => heat.cells as f64,
            Self::Depth => f64::from(heat.depth),
        }
    }
}

/// The eye rays of a scan line, from left to right. A recorder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HeatLine {
    /// One for each eye ray.
    pub heats: Vec<Heat>,
    /// Depths of the rays that have started and not ended.
    open: Vec<u32>,
}

impl HeatLine {
    /// The value of a pixel from its own eye rays, which are all of the line: their mean. `None` if there is none.
    pub fn of_pixel(&self, of: HeatOf) -> Option<f64> {
        let sum: f64 = self.heats.iter().map(|heat| of.value(heat)).sum();
        (!self.heats.is_empty()).then(|| sum / self.heats.len() as f64)
    }
}

impl Recorder for HeatLine {
    const ENABLED: bool = true;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        let event = event();
        if let Event::Ray(start) = &event {
            if start.purpose == Purpose::Eye {
                self.heats.push(Heat::default());
            }
            return self.open.push(start.depth);
        }
        let Some(heat) = self.heats.last_mut() else {
            return;
        };
        match &event {
            Event::RayEnd(end) => {
                let depth = self.open.pop().unwrap_or_default();
                // beyond the limit it was not traced
                if end.verdict != RayVerdict::DepthLimit {
                    heat.depth = heat.depth.max(depth);
                }
            }
            Event::BoundTest(_) => heat.nodes += 1,
            Event::Node(visit) => {
                heat.nodes += u64::from(visit.verdict == NodeVerdict::Entered);
            }
            Event::Cell(_) => heat.cells += 1,
            _ => heat.tests += u64::from(event.object_tested().0),
        }
    }
}

/// One value for each pixel, row by row from the top left, from the scan lines of a picture.
///
/// Through the corners a pixel is the mean of its four eye rays, as its colour is.
pub fn heat_values(lines: &[HeatLine], of: HeatOf, through: Through) -> Vec<f64> {
    let value = |line: &HeatLine, x: usize| of.value(&line.heats[x]);
    match through {
        Through::Centres => {
            let heats = lines.iter().flat_map(|line| &line.heats);
            heats.map(|heat| of.value(heat)).collect()
        }
        Through::Corners => lines
            .windows(2)
            .flat_map(|pair| {
                let [above, below] = [&pair[0], &pair[1]];
                // one more eye ray than there are pixels
                let width = above.heats.len().saturating_sub(1);
                (0..width).map(move |x| {
                    let upper = value(above, x) + value(above, x + 1);
                    (upper + value(below, x) + value(below, x + 1)) / 4.0
                })
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn through_the_corners_a_pixel_is_the_mean_of_its_four_eye_rays() {
        let line = |tests: [u64; 3]| HeatLine {
            heats: tests
                .map(|tests| Heat {
                    tests,
                    ..Heat::default()
                })
                .into(),
            open: Vec::new(),
        };
        let lines = [line([0, 1, 2]), line([4, 8, 16])];
        // (0 + 1 + 4 + 8)/4 and (1 + 2 + 8 + 16)/4
        let means = heat_values(&lines, HeatOf::Tests, Through::Corners);
        assert_eq!(means, [3.25, 6.75]);
        let own = heat_values(&lines, HeatOf::Tests, Through::Centres);
        assert_eq!(own, [0.0, 1.0, 2.0, 4.0, 8.0, 16.0]);
        assert_eq!(lines[1].of_pixel(HeatOf::Tests), Some(28.0 / 3.0));
        assert_eq!(HeatLine::default().of_pixel(HeatOf::Tests), None);
    }

    use crate::geometry::Ray;
    use crate::scene::Scene;
    use crate::scene::small_scene::{cube_at, object, one_pixel, scene_of, wall};
    use crate::strategy::{Chosen, Strategy};
    use crate::structure::{Build, StructureOptions};
    use crate::trace::{RayStart, StrategyName, Transport};
    use crate::tracer::{Tracer, trace_pixel};
    use glam::DVec3;

    /// What a ray along x costs among two pairs of cubes far apart.
    fn heat_of(name: StrategyName) -> Heat {
        let scene = scene_of(&[0.0, 1.0, 8.0, 9.0].map(cube_at));
        let mut options = StructureOptions {
            build: Build::SurfaceArea,
            ..StructureOptions::default()
        };
        options.grid.resolution = Some([10, 1, 1]);
        let strategy = Chosen::new(&scene, name, &options).unwrap();
        let ray = Ray::new(DVec3::new(-1.0, 0.5, 0.5), DVec3::X);
        let mut line = HeatLine::default();
        let start = RayStart {
            ray,
            depth: 1,
            ..RayStart::default()
        };
        line.note(|| Event::Ray(start));
        let _ = strategy.nearest(&ray, crate::geometry::TRange::FORWARD, &mut line);
        line.heats[0]
    }

    #[test]
    fn heat_counts_object_tests_bounds_with_entered_nodes_and_cells() {
        let counts = |name| {
            let heat = heat_of(name);
            [heat.tests, heat.nodes, heat.cells]
        };
        assert_eq!(counts(StrategyName::Exhaustive), [4, 0, 0]);
        // four volumes, of which the first alone is hit before its hit
        assert_eq!(counts(StrategyName::Bounds), [1, 4, 0]);
        // three bounds and two nodes that are entered, with two objects in the leaf
        assert_eq!(counts(StrategyName::Hierarchy), [2, 5, 0]);
        // the grid is wider than the row, and so its first plane lies a little before the second cube
        assert_eq!(counts(StrategyName::Grid), [1, 0, 1]);
    }

    #[test]
    fn depth_is_that_of_the_deepest_ray_that_was_traced() {
        let depth = |max_depth: u32, reflection: f64, lights: &str| {
            let scene: Scene = one_pixel(&format!(
                r#""max_depth":{max_depth},"materials":{{"m":{{"colour":[1,1,1],"reflection":{reflection}}}}},
                "lights":[{lights}],"objects":[{},{}]"#,
                object("ahead", "m", &wall(-5.0)),
                object("behind", "m", &wall(5.0))
            ));
            let strategy = crate::strategy::Exhaustive::new(&scene);
            let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
            let mut line = HeatLine::default();
            let _ = trace_pixel(&tracer, [0, 0], Through::Centres, &mut line);
            assert!(line.open.is_empty());
            line.heats[0].depth
        };
        assert_eq!(depth(4, 0.0, ""), 1);
        // the fifth is noted and not traced
        assert_eq!(depth(4, 0.5, ""), 4);
        let lamp = r#"{"position":[0,3,-1],"colour":[1,1,1]}"#;
        assert_eq!(depth(4, 0.0, lamp), 2);
    }

    #[test]
    fn each_quantity_is_shown_for_itself() {
        let heat = Heat {
            tests: 1,
            nodes: 2,
            cells: 3,
            depth: 4,
        };
        let values =
            [HeatOf::Tests, HeatOf::Nodes, HeatOf::Cells, HeatOf::Depth].map(|of| of.value(&heat));
        assert_eq!(values, [1.0, 2.0, 3.0, 4.0]);
    }

    #[test]
    fn a_map_is_titled_by_what_it_counts() {
        let titles =
            [HeatOf::Tests, HeatOf::Nodes, HeatOf::Cells, HeatOf::Depth].map(HeatOf::title);
        for (title, word) in titles.into_iter().zip(["tests", "nodes", "cells", "depth"]) {
            assert!(title.contains(word), "{title}");
        }
    }
}
