//! The uniform grid: which objects lie in which cell.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::PrimitiveId;

/// By what an object is put into a cell's list.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum Lists {
    /// The object itself reaches into the cell.
    #[default]
    Objects,
    /// The box around the object does.
    Boxes,
}

/// How a grid is built.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GridOptions {
    /// Cells along x, y and z; absent: by Woo's rule.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resolution: Option<[u32; 3]>,
    /// Cells for each object, for Woo's rule.
    pub density: f64,
    /// By what the lists are filled.
    pub lists: Lists,
    /// Is an object in several cells tested once for each ray?
    pub mailboxes: bool,
}

impl Default for GridOptions {
    fn default() -> Self {
        Self {
            resolution: None,
            density: 3.0,
            lists: Lists::Objects,
            mailboxes: true,
        }
    }
}

/// Does an object lie in a cell as a whole?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// All of it.
    #[default]
    Whole,
    /// A part of it.
    Part,
}

/// An object put into a cell's list.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AssignStep {
    /// What.
    pub object: PrimitiveId,
    /// i, j and k.
    pub cell: [u32; 3],
    /// Wholly or in part.
    pub share: Share,
}
