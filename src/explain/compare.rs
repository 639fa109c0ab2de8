//! What each strategy costs on the same rays: a table, JSON, CSV.
//!
//! Slides, on the cost of the simple ray tracer: 1024 × 1024 pixels and 100 objects ask for 104 857 600
//! intersection calculations (erratum 9). Every other strategy is measured against that.

use std::time::Duration;

use serde_json::{Value, json};

use crate::explain::counts::tests_of;
use crate::explain::table::csv_row;
use crate::explain::variants::strategy_title;
use crate::explain::{CrowdedCell, counts_json, grouped, in_advance, in_advance_json, printable};
use crate::scene::Scene;
use crate::structure::StructureError;
use crate::trace::{Counts, Settings, StrategyName};

/// Strategies over the same rays of a scene.
#[derive(Clone, Debug)]
pub struct Comparison<'a> {
    /// The scene whose rays all strategies trace.
    pub scene: &'a Scene,
    /// The pixel whose rays were traced; `None`: those of the picture.
    pub pixel: Option<[u32; 2]>,
    /// Each strategy with its variant, the exhaustive one first.
    pub compared: Vec<Compared>,
}

/// A strategy with its variant.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The strategy and its structure, with the settings of the rays.
    pub settings: Settings,
    /// What it cost, or why its structure cannot be built.
    pub cost: Result<Cost, StructureError>,
}

/// What a strategy cost.
#[derive(Clone, Debug, Default)]
pub struct Cost {
    /// Rays, tests and what the search took.
    pub counts: Counts,
    /// The memory of the structure.
    pub bytes: usize,
    /// The fullest cell of the grid, if it lists most objects.
    pub crowded: Option<CrowdedCell>,
    /// How long the structure took to build.
    pub building: Duration,
    /// How long the rays took, counting included.
    pub tracing: Duration,
}

impl Compared {
    /// The strategy and what makes the variant, as in `hierarchy, insertion`.
    pub fn name(&self) -> String {
        strategy_title(&self.settings)
    }
}

impl Cost {
    /// Bounds tested, nodes entered and cells visited: what it took to find the objects to test.
    pub fn searched(&self) -> u64 {
        let search = &self.counts.search;
        search.bounds.tests + search.entered + search.cells
    }

    /// Object tests and what it took to find these objects: what strategies are ordered by. The same comparison
    /// gives the same number, which a time does not.
    pub fn total(&self) -> u64 {
        self.counts.objects_tested() + self.searched()
    }
}

/// The columns after the name: the title in the table, the key in CSV.
const COLUMNS: [(&str, &str); 15] = [
    ("rays", "rays"),
    ("bound tests", "bound_tests"),
    ("nodes", "nodes"),
    ("cells", "cells"),
    ("object tests", "object_tests"),
    ("sphere", "sphere"),
    ("ellipsoid", "ellipsoid"),
    ("cone", "cone"),
    ("box", "box"),
    ("plane", "plane"),
    ("polygon", "polygon"),
    ("per ray", "tests_per_ray"),
    ("share %", "share_percent"),
    ("build s", "build_seconds"),
    ("bytes", "bytes"),
];

/// Where the columns of the kinds of test begin, in the order of [`Counts::TESTS`].
const KINDS: usize = 5;

impl Comparison<'_> {
    /// The object tests of the exhaustive strategy, against which the others are measured.
    fn exhaustive(&self) -> Option<u64> {
        let costs = self.compared.iter().filter_map(|compared| {
            let is_it = compared.settings.strategy == StrategyName::Exhaustive;
            compared.cost.as_ref().ok().filter(|_| is_it)
        });
        costs.map(|cost| cost.counts.objects_tested()).next()
    }

    /// The share of the exhaustive count in percent; `None` if that is 0.
    pub(super) fn share(&self, cost: &Cost) -> Option<f64> {
        let all = self.exhaustive().filter(|all| 0 < *all)?;
        Some(cost.counts.objects_tested() as f64 / all as f64 * 100.0)
    }

    /// One cell for each of [`COLUMNS`].
    fn cells(&self, cost: &Cost) -> [String; COLUMNS.len()] {
        let counts = &cost.counts;
        let search = &counts.search;
        let [sphere, ellipsoid, cone, solid, plane, polygon] =
            counts.tests.map(|count| count.tests.to_string());
        [
            counts.traced().to_string(),
            search.bounds.tests.to_string(),
            search.entered.to_string(),
            search.cells.to_string(),
            counts.objects_tested().to_string(),
            sphere,
            ellipsoid,
            cone,
            solid,
            plane,
            polygon,
            format!("{:.2}", per_ray(counts)),
            self.share(cost)
                .map(|share| format!("{share:.2}"))
                .unwrap_or_default(),
            format!("{:.6}", cost.building.as_secs_f64()),
            cost.bytes.to_string(),
        ]
    }

    /// The columns of which the table shows something: a kind of test that was not made is left out.
    pub(super) fn columns(&self) -> Vec<usize> {
        let occurs = |column: &usize| {
            let kind = column.checked_sub(KINDS);
            let Some(&kind) = kind.and_then(|kind| Counts::TESTS.get(kind)) else {
                return true;
            };
            let mut costs = self.compared.iter().flat_map(|compared| &compared.cost);
            costs.any(|cost| 0 < tests_of(&cost.counts, kind))
        };
        (0..COLUMNS.len()).filter(occurs).collect()
    }

    /// What was traced: the scene, its size, the picture or the pixel.
    pub fn title(&self) -> String {
        let scene = self.scene;
        let [width, height] = scene.camera.pixels;
        let name = match scene.name.as_str() {
            "" => String::new(),
            name => format!("{}: ", printable(name)),
        };
        let objects = match scene.primitives.len() {
            1 => "1 object".into(),
            count => format!("{} objects", grouped(count as u64)),
        };
        match self.pixel {
            None => format!("{name}{objects}, {width} × {height} pixels"),
            Some([x, y]) => format!("{name}{objects}, pixel {x},{y} of {width} × {height}"),
        }
    }

    /// The table as rows of cells, the titles first; a strategy that could not be built has a cell that says why.
    ///
    /// Without times: the same comparison gives the same cells.
    pub fn rows(&self) -> Vec<Vec<String>> {
        let mut columns = self.columns();
        columns.retain(|&column| COLUMNS[column].1 != "build_seconds");
        self.table(&columns, self.compared.iter())
    }

    /// The columns over these strategies, in this order.
    pub(super) fn table<'b>(
        &self,
        columns: &[usize],
        compared: impl Iterator<Item = &'b Compared>,
    ) -> Vec<Vec<String>> {
        let mut table = vec![vec!["strategy".to_owned()]];
        table[0].extend(columns.iter().map(|&column| COLUMNS[column].0.into()));
        for compared in compared {
            let mut row = vec![compared.name()];
            match &compared.cost {
                Ok(cost) => {
                    let cells = self.cells(cost);
                    row.extend(columns.iter().map(|&column| cells[column].clone()));
                }
                Err(why) => row.push(format!("not built: {}", in_one_line(why))),
            }
            table.push(row);
        }
        table
    }

    /// Everything as JSON, with the full counts of each strategy.
    pub fn json(&self) -> Value {
        let strategies = self.compared.iter().map(|compared| {
            let Settings {
                strategy,
                structure,
                ..
            } = &compared.settings;
            let mut entry = json!({
                "name": compared.name(),
                "strategy": strategy,
                "structure": structure,
            });
            match &compared.cost {
                Ok(cost) => {
                    let counts = &cost.counts;
                    entry["rays"] = counts.traced().into();
                    entry["bound_tests"] = counts.search.bounds.tests.into();
                    entry["nodes"] = counts.search.entered.into();
                    entry["cells"] = counts.search.cells.into();
                    entry["object_tests"] = counts.objects_tested().into();
                    entry["tests_per_ray"] = per_ray(counts).into();
                    if let Some(share) = self.share(cost) {
                        entry["share_percent"] = share.into();
                    }
                    entry["bytes"] = cost.bytes.into();
                    if let Some(crowded) = &cost.crowded {
                        entry["crowded_cell"] = crowded.json();
                    }
                    entry["seconds"] = json!({
                        "building": cost.building.as_secs_f64(),
                        "tracing": cost.tracing.as_secs_f64(),
                    });
                    entry["counts"] = counts_json(counts);
                    let list = in_advance(self.scene, &compared.settings, counts);
                    entry["in_advance"] = in_advance_json(&list);
                }
                Err(why) => entry["error"] = in_one_line(why).into(),
            }
            entry
        });
        let strategies: Vec<Value> = strategies.collect();
        let mut document = json!({
            "scene": self.scene.name,
            "objects": self.scene.primitives.len(),
            "pixels": self.scene.camera.pixels,
            "max_depth": self.scene.max_depth,
            "strategies": strategies,
        });
        if let Some(pixel) = self.pixel {
            document["pixel"] = json!(pixel);
        }
        if let Some(first) = self.compared.first() {
            document["transport"] = json!(first.settings.transport);
            document["through"] = json!(first.settings.through);
            document["one_sided"] = first.settings.one_sided.into();
        }
        document
    }

    /// A row for each strategy under a row of keys; the same columns for every scene (RFC 4180).
    pub fn csv(&self) -> String {
        let row = |name: &str, cells: [String; COLUMNS.len()], error: &str| {
            let cells = cells.iter().map(String::as_str);
            csv_row(std::iter::once(name).chain(cells).chain([error]))
        };
        let mut text = row("strategy", COLUMNS.map(|(_, key)| key.into()), "error");
        for compared in &self.compared {
            let name = compared.name();
            text += &match &compared.cost {
                Ok(cost) => row(&name, self.cells(cost), ""),
                Err(why) => {
                    let none = [const { String::new() }; COLUMNS.len()];
                    row(&name, none, &in_one_line(why))
                }
            };
        }
        text
    }
}

/// How many objects a ray was tested against, on average.
pub(super) fn per_ray(counts: &Counts) -> f64 {
    // a picture without rays does not exist; 0 would still be right for it
    counts.objects_tested() as f64 / counts.traced().max(1) as f64
}

/// What is wrong and what to do about it, which stand on two lines elsewhere.
pub(super) fn in_one_line(why: &StructureError) -> String {
    why.to_string().replace("\n  ", "; ")
}
