//! Bounding volumes around single objects: sphere, ellipsoid, rectangular solid, slabs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which volume is put around an object?
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum VolumeKind {
    /// The smallest sphere.
    Sphere,
    /// The ellipsoid of least volume, turned as it fits best.
    Ellipsoid,
    /// The rectangular solid along the axes.
    #[default]
    Box,
    /// The intersection of slabs.
    Slabs,
}
