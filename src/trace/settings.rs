//! How a trace was made: what the log's header says beside the scene.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::structure::StructureOptions;
use crate::trace::Region;

/// The choices that a trace depends on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Which objects each ray is tested against.
    pub strategy: StrategyName,
    /// What was chosen about its structure; absent: nothing.
    #[serde(default, skip_serializing_if = "is_default")]
    pub structure: StructureOptions,
    /// Was the building of the structure recorded?
    #[serde(default, skip_serializing_if = "is_default")]
    pub building: bool,
    /// Which rays are cast at all.
    pub transport: Transport,
    /// Where the eye rays pass a pixel.
    pub through: Through,
    /// Do opaque objects show only their front?
    pub one_sided: bool,
    /// The kinds of event that were kept; absent: all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub only: Option<Vec<String>>,
    /// The pixels of which every event was kept, whatever `only` says; absent: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub whole: Vec<[u32; 2]>,
    /// The figure that this was traced for, as in 12-grid/walk.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub figure: Option<String>,
    /// The pixels that were kept; absent: all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<Region>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            strategy: StrategyName::Exhaustive,
            structure: StructureOptions::default(),
            building: false,
            transport: Transport::HybridLight,
            through: Through::Centres,
            one_sided: false,
            only: None,
            whole: Vec::new(),
            figure: None,
            region: None,
        }
    }
}

/// Which objects a ray is tested against.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum StrategyName {
    /// Every object, as in Fig. 15.56.
    #[default]
    Exhaustive,
    /// Every object whose bounding volume is met.
    Bounds,
    /// A hierarchy of bounding volumes, walked depth first.
    Hierarchy,
    /// A hierarchy of bounding volumes, walked in the order of distance.
    Heap,
    /// The cells of a uniform grid, one after the other along the ray.
    Grid,
    /// Every object, in a frame in which the ray is the z axis.
    ZAligned,
}

/// Which kind of ray tracing, of the slides' five.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum Transport {
    /// From the eye alone; no rays to lights, so no shadows.
    Backward,
    /// From the eye, with a ray to each light from each point.
    #[default]
    HybridLight,
}

/// Where the eye rays pass a pixel.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum Through {
    /// One ray through its centre.
    #[default]
    Centres,
    /// Four rays through its corners, of which the pixel is the mean. A picture shares them:
    /// (width + 1) × (height + 1) in all.
    Corners,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
