//! How a trace was made: what the log's header says beside the scene.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Serialize, Serializer};

use crate::structure::StructureOptions;
use crate::trace::{LightOptions, Region};

/// The choices that a trace depends on.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Which objects each ray is tested against.
    pub strategy: StrategyName,
    /// What was chosen about its structure; absent: nothing.
    #[serde(default)]
    pub structure: StructureOptions,
    /// Was the building of the structure recorded?
    #[serde(default)]
    pub building: bool,
    /// Which rays are cast at all.
    pub transport: Transport,
    /// How light is followed from the lamps: the seed, how many paths. A transport that follows none has none in its log.
    #[serde(default)]
    pub light: LightOptions,
    /// Where the eye rays pass a pixel.
    pub through: Through,
    /// Do opaque objects show only their front?
    pub one_sided: bool,
    /// The kinds of event that were kept; absent: all.
    #[serde(default)]
    pub only: Option<Vec<String>>,
    /// The pixels of which every event was kept, whatever `only` says; absent: none.
    #[serde(default)]
    pub whole: Vec<[u32; 2]>,
    /// The figure that this was traced for, as in 12-grid/walk.
    #[serde(default)]
    pub figure: Option<String>,
    /// The pixels that were kept; absent: all.
    #[serde(default)]
    pub region: Option<Region>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            strategy: StrategyName::Exhaustive,
            structure: StructureOptions::default(),
            building: false,
            transport: Transport::HybridLight,
            light: LightOptions::default(),
            through: Through::Centres,
            one_sided: false,
            only: None,
            whole: Vec::new(),
            figure: None,
            region: None,
        }
    }
}

impl Settings {
    /// How many paths of light there are over a picture of a size; 0 if the transport follows none.
    pub fn light_paths(&self, [width, height]: [u32; 2]) -> u64 {
        match self.transport {
            Transport::Backward | Transport::HybridLight => 0,
            Transport::Forward | Transport::HybridStored => self.light.paths,
            Transport::HybridConnected => {
                let pixels = u64::from(width) * u64::from(height);
                pixels.saturating_mul(u64::from(self.light.samples))
            }
        }
    }
}

/// Which objects a ray is tested against.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum StrategyName {
    /// Every object, as in Fig. 15.56.
    #[default]
    Exhaustive,
    /// Every object whose bounding volume the ray hits.
    Bounds,
    /// A hierarchy of bounding volumes, traversed depth first.
    Hierarchy,
    /// A hierarchy of bounding volumes, traversed nearest node first with a heap.
    Heap,
    /// The objects in the cells of a uniform grid, cell by cell along the ray.
    Grid,
    /// Every object, in a frame in which the ray is the z axis.
    ZAligned,
}

/// Which kind of ray tracing, of the slides' five.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Transport {
    /// Rays from the eye only; no shadow rays, so no shadows.
    #[doc(alias = "ray casting")]
    Backward,
    /// Rays from the eye, and a shadow ray from each point to each light.
    #[doc(alias = "Whitted ray tracing")]
    #[default]
    HybridLight,
    /// Rays from the lights only; those that pass the window into the eye make the picture.
    #[doc(alias = "light tracing")]
    #[doc(alias = "particle tracing")]
    Forward,
    /// Light is stored on the surfaces; then rays from the eye gather it (photon mapping).
    #[doc(alias = "photon mapping")]
    HybridStored,
    /// Paths from the lights and from the eye, connected by lines (bidirectional path tracing).
    #[doc(alias = "bidirectional path tracing")]
    #[doc(alias = "BDPT")]
    #[doc(alias = "path tracing")]
    HybridConnected,
}

impl Transport {
    /// The five kinds, in the order of the slides.
    pub const ALL: [Self; 5] = [
        Self::Backward,
        Self::Forward,
        Self::HybridLight,
        Self::HybridStored,
        Self::HybridConnected,
    ];

    /// Are there paths of light, from the lights on? Then the light of the lamps is all there is: no ambient
    /// light, which stands for what these paths compute, and no background.
    #[inline]
    pub const fn follows_light(self) -> bool {
        matches!(
            self,
            Self::Forward | Self::HybridStored | Self::HybridConnected
        )
    }
}

/// Where the eye rays pass a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Through {
    /// One ray through its centre.
    #[default]
    Centres,
    /// Four rays through its corners; the pixel is their mean. A picture shares them:
    /// (width + 1) × (height + 1) in all.
    Corners,
}

/// Only what matters is written: light options if light is traced, and values that differ from the default.
impl Serialize for Settings {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        /// More than there are: JSON does not need the number.
        const FIELDS: usize = 11;
        let usual = Self::default();
        let mut line = serializer.serialize_struct("Settings", FIELDS)?;
        line.serialize_field("strategy", &self.strategy)?;
        if self.structure != usual.structure {
            line.serialize_field("structure", &self.structure)?;
        }
        if self.building {
            line.serialize_field("building", &self.building)?;
        }
        line.serialize_field("transport", &self.transport)?;
        if self.transport.follows_light() {
            line.serialize_field("light", &self.light)?;
        }
        line.serialize_field("through", &self.through)?;
        line.serialize_field("one_sided", &self.one_sided)?;
        if let Some(only) = &self.only {
            line.serialize_field("only", only)?;
        }
        if !self.whole.is_empty() {
            line.serialize_field("whole", &self.whole)?;
        }
        if let Some(figure) = &self.figure {
            line.serialize_field("figure", figure)?;
        }
        if let Some(region) = &self.region {
            line.serialize_field("region", region)?;
        }
        line.end()
    }
}
