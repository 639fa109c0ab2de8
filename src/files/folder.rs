//! The folder of a scene or a lesson: what a file names is looked for there, and not outside of it.
//!
//! Scenes and lessons come from other people. A name such as `../../.ssh/id_rsa` or a link would make a program that
//! traces them read what they have no business with, and show a part of it in a message.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::files::read::read_file;
use crate::scene::{Files, IsOutside, LoadError};

/// A folder, and whether names in its files may lead out of it.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
    allows_outside: bool,
}

impl Folder {
    /// A folder that no name leads out of; the empty path is the current folder.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self {
            path: path.into(),
            allows_outside: false,
        }
    }

    /// The folder that a file is in.
    pub fn of(file: &Path) -> Self {
        Self::new(file.parent().unwrap_or(Path::new("")))
    }

    /// The same folder, where names may lead out of it or not.
    #[must_use]
    pub fn allow_outside(self, allows_outside: bool) -> Self {
        Self {
            allows_outside,
            ..self
        }
    }
}

impl Files for Folder {
    fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// The place behind all links decides; of a file that is not there its name.
    fn path_of(&self, name: &str) -> Result<PathBuf, IsOutside> {
        let path = self.path.join(name);
        let folder = if self.path == Path::new("") {
            Path::new(".")
        } else {
            &self.path
        };
        let is_inside = self.allows_outside
            || match (fs::canonicalize(folder), fs::canonicalize(&path)) {
                (Ok(folder), Ok(file)) => file.starts_with(folder),
                _ => stays_below(Path::new(name)),
            };
        is_inside.then_some(path).ok_or(IsOutside)
    }

    fn read(&self, path: &Path) -> Result<Vec<u8>, LoadError> {
        read_file(path)
    }

    fn around(&self, path: &Path) -> Arc<dyn Files> {
        Arc::new(Self::of(path).allow_outside(self.allows_outside))
    }

    fn folders(&self) -> io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.path)? {
            let entry = entry?;
            if entry.path().is_dir() {
                names.push(entry.file_name().to_string_lossy().into_owned());
            }
        }
        Ok(names)
    }
}

/// Does a path never climb above where it starts?
fn stays_below(name: &Path) -> bool {
    let mut depth = 0_usize;
    for part in name.components() {
        match part {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir if 0 < depth => depth -= 1,
            Component::ParentDir | Component::RootDir | Component::Prefix(_) => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_climbs_out_of_the_folder_is_outside_whether_the_file_is_there_or_not() {
        for (name, inside) in [
            ("mesh.obj", true),
            ("meshes/a.obj", true),
            ("./a/../b.obj", true),
            ("a/../../b.obj", false),
            ("../b.obj", false),
            ("/none/b.obj", false),
        ] {
            assert_eq!(stays_below(Path::new(name)), inside, "{name}");
            let folder = Folder::new("no/such/folder");
            assert_eq!(folder.path_of(name).is_ok(), inside, "{name}");
            assert!(folder.allow_outside(true).path_of(name).is_ok(), "{name}");
        }
    }

    #[test]
    fn the_place_behind_links_decides() {
        let around = tempfile::tempdir().unwrap();
        let path = around.path();
        fs::create_dir_all(path.join("scene/meshes")).unwrap();
        for file in ["a.obj", "scene/b.obj", "scene/meshes/c.obj"] {
            fs::write(path.join(file), "v 0 0 0\n").unwrap();
        }
        let folder = Folder::new(path.join("scene"));
        let absolute = path.join("scene/b.obj");
        for name in [
            "b.obj",
            "meshes/c.obj",
            "../scene/b.obj",
            absolute.to_str().unwrap(),
        ] {
            assert!(folder.path_of(name).is_ok(), "{name}");
        }
        assert_eq!(folder.path_of("../a.obj"), Err(IsOutside));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("../a.obj", path.join("scene/link.obj")).unwrap();
            assert_eq!(folder.path_of("link.obj"), Err(IsOutside));
            assert!(folder.allow_outside(true).path_of("link.obj").is_ok());
        }
    }
}
