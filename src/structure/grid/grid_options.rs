//! How a grid is built.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// By what an object is put into a cell's list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Lists {
    /// A cell lists an object whose shape reaches into the cell.
    #[default]
    Objects,
    /// A cell lists an object whose bounding box reaches into the cell.
    Boxes,
}

/// How a grid is built.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct GridOptions {
    /// Cells along x, y and z; absent: by Woo's rule.
    #[serde(skip_serializing_if = "Option::is_none")]
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
