//! What can be chosen about a structure.

use std::fmt;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::SlabSetError;
use crate::structure::{Build, GridError, GridOptions, SlabChoice, VolumeKind};

/// What can be chosen about the structure of a strategy; each strategy looks at its own part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct StructureOptions {
    /// The volume around each object.
    pub volume: VolumeKind,
    /// The directions of slabs.
    pub slabs: SlabChoice,
    /// How a hierarchy is built.
    pub build: Build,
    /// How a grid is built.
    pub grid: GridOptions,
}

/// Why a structure cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum StructureError {
    /// The scene file has no set of slabs.
    NoSlabs,
    /// Its directions are no set.
    Slabs(SlabSetError),
    /// There is no such grid.
    Grid(GridError),
}

impl fmt::Display for StructureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSlabs => f.write_str(
                "the scene has no \"slabs\"\n  add a list of directions [A, B, C] to it, or take the slabs \
                 axes or seven",
            ),
            Self::Slabs(error) => write!(f, "{error}\n  {}", error.fix()),
            Self::Grid(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for StructureError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_says_what_to_give_instead() {
        let text = StructureError::NoSlabs.to_string();
        assert!(
            text.contains("no \"slabs\"") && text.contains("add a list"),
            "{text}"
        );
        let text = StructureError::Slabs(SlabSetError::Unbounded { independent: 2 }).to_string();
        assert_eq!(text.lines().count(), 2, "{text}");
        let density = GridError::Density { density: 0.0 };
        assert_eq!(
            StructureError::Grid(density).to_string(),
            density.to_string()
        );
    }
}
