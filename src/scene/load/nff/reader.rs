//! An NFF file while it is read.

use std::collections::HashMap;

use smol_str::SmolStr;

use crate::scene::file::SceneFile;
use crate::scene::load::error::LoadError;
use crate::scene::load::loaded::Table;
use crate::scene::load::words::Words;

/// The scene so far.
pub(super) struct Reader<'a> {
    pub(super) words: Words<'a>,
    /// Lights without a colour wait for the number of lights.
    pub(super) scene: SceneFile,
    /// The name of the material that holds.
    pub(super) material: Option<SmolStr>,
    /// How many objects there are of each kind.
    pub(super) kinds: HashMap<&'static str, usize>,
    /// Where each part begins.
    pub(super) lines: Table,
}

impl Reader<'_> {
    /// Notes the line of what a file has once.
    pub(super) fn once(&mut self, path: &str, what: &str, line: usize) -> Result<(), LoadError> {
        if let Some((_, first)) = self.lines.others.iter().find(|(known, _)| known == path) {
            let what = format!("{what} is given twice, first in line {first}");
            return Err(self.words.error(line, what, "remove one of them"));
        }
        self.lines.others.push((path.into(), line));
        Ok(())
    }
}
