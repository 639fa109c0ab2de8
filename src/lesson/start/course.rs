//! The course written out, ready to run: what `start` writes.
//!
//! The folders of the lessons are embedded as they are. What checks the exercises has a Cargo.toml, and a folder with one is no
//! part of the published package; so its files stand here a second time, as templates. A test holds both equal.

use std::borrow::Cow;
use std::path::PathBuf;

use crate::lesson::start::embedded::Embedded;
use crate::lesson::{LessonError, Library};

/// Where the student's crate gets the core from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Dependency {
    /// From a folder.
    Path(String),
    /// From the registry, in a version.
    Version(String),
    /// From a Git repository with this address.
    Git(String),
}

/// A file with its path from the folder of the course.
pub type CourseFile = (&'static str, Cow<'static, [u8]>);

impl Dependency {
    /// The line in Cargo.toml.
    fn line(&self) -> String {
        let (key, value) = match self {
            Self::Path(path) => ("path", path),
            Self::Version(version) => ("version", version),
            Self::Git(address) => ("git", address),
        };
        // a path may hold quotes and backslashes
        let quoted = serde_json::Value::from(value.as_str());
        format!("raystep = {{ {key} = {quoted}, default-features = false }}")
    }
}

/// The workspace around the student's crate.
const WORKSPACE: &str = "[workspace]\nmembers = [\"run\"]\nresolver = \"3\"\n";

/// The files of the course, with their paths from its folder.
pub fn course_files(dependency: &Dependency) -> Vec<CourseFile> {
    let package = PACKAGE.replace("{raystep}", &dependency.line());
    let mut files: Vec<(&str, Cow<'_, [u8]>)> = vec![
        ("Cargo.toml", Cow::Borrowed(WORKSPACE.as_bytes())),
        (".gitignore", Cow::Borrowed(b"/target\n")),
        ("run/Cargo.toml", Cow::Owned(package.into_bytes())),
    ];
    let embedded = RUN.iter().chain(LESSONS);
    files.extend(embedded.map(|(path, bytes)| (*path, Cow::Borrowed(*bytes))));
    files
}

/// The lessons as they are written out, without a file system.
///
/// # Errors
/// A lesson with a mistake: none has one.
pub fn course() -> Result<Library, LessonError> {
    Library::open(&Embedded {
        files: LESSONS,
        folder: PathBuf::new(),
    })
}

/// The Cargo.toml of the student's crate, but for the line that says where the core comes from.
const PACKAGE: &str = include_str!("Cargo.toml.txt");

/// What checks the exercises.
const RUN: &[(&str, &[u8])] = &[
    ("run/attempts.rs", include_bytes!("attempts.rs.txt")),
    ("run/check.rs", include_bytes!("check.rs.txt")),
    ("run/child.rs", include_bytes!("child.rs.txt")),
    ("run/files.rs", include_bytes!("files.rs.txt")),
    ("run/hand_in.rs", include_bytes!("hand_in.rs.txt")),
    ("run/hostile.rs", include_bytes!("hostile.rs.txt")),
    ("run/lib.rs", include_bytes!("lib.rs.txt")),
    ("run/limits.rs", include_bytes!("limits.rs.txt")),
    ("run/parts.rs", include_bytes!("parts.rs.txt")),
    ("run/picture.rs", include_bytes!("picture.rs.txt")),
    ("run/run.rs", include_bytes!("run.rs.txt")),
    ("run/scene.json", include_bytes!("scene.json")),
];

macro_rules! lessons {
    ($($path:literal,)+) => {
        /// The folders of the lessons.
        const LESSONS: &[(&str, &[u8])] = &[
            $(($path, include_bytes!(concat!("../../../lessons/", $path))),)+
        ];
    };
}

lessons! {
    "01-pinhole/balls.json",
    "01-pinhole/eggs.json",
    "01-pinhole/exercise.rs",
    "01-pinhole/grid.json",
    "01-pinhole/lesson.json",
    "01-pinhole/rim.json",
    "01-pinhole/solution.rs",
    "01-pinhole/tilted.json",
    "01-pinhole/tree.json",
    "02-simple-tracer/exercise.rs",
    "02-simple-tracer/lesson.json",
    "02-simple-tracer/scene.json",
    "02-simple-tracer/solution.rs",
    "03-ray/exercise.rs",
    "03-ray/lesson.json",
    "03-ray/scene.json",
    "03-ray/solution.rs",
    "04-sphere/cases.json",
    "04-sphere/exercise.rs",
    "04-sphere/inside.json",
    "04-sphere/lesson.json",
    "04-sphere/normal.json",
    "04-sphere/roots.json",
    "04-sphere/scene.json",
    "04-sphere/solution.rs",
    "04-sphere/stretched.json",
    "05-shading/acne.json",
    "05-shading/exercise.rs",
    "05-shading/lesson.json",
    "05-shading/lights.json",
    "05-shading/scene.json",
    "05-shading/sides.json",
    "05-shading/solution.rs",
    "05-shading/terms.json",
    "06-polygon/concave.json",
    "06-polygon/corner.json",
    "06-polygon/exercise.rs",
    "06-polygon/lesson.json",
    "06-polygon/parallel.json",
    "06-polygon/planes.json",
    "06-polygon/scene.json",
    "06-polygon/solution.rs",
    "07-reflection-refraction/balls.json",
    "07-reflection-refraction/exercise.rs",
    "07-reflection-refraction/glass.json",
    "07-reflection-refraction/lesson.json",
    "07-reflection-refraction/mirror.json",
    "07-reflection-refraction/solution.rs",
    "07-reflection-refraction/total.json",
    "07-reflection-refraction/water.json",
    "08-transport/ball.json",
    "08-transport/caustic.json",
    "08-transport/exercise.rs",
    "08-transport/lesson.json",
    "08-transport/map.json",
    "08-transport/powered.json",
    "08-transport/scene.json",
    "08-transport/solution.rs",
    "09-cost/exercise.rs",
    "09-cost/lesson.json",
    "09-cost/scene.json",
    "09-cost/solution.rs",
    "10-bounds/alignment.json",
    "10-bounds/exercise.rs",
    "10-bounds/lesson.json",
    "10-bounds/past.json",
    "10-bounds/shape.obj",
    "10-bounds/slabs.json",
    "10-bounds/solution.rs",
    "10-bounds/starts-inside.json",
    "10-bounds/two.json",
    "10-bounds/volumes.json",
    "11-hierarchy/crowd.json",
    "11-hierarchy/exercise.rs",
    "11-hierarchy/lesson.json",
    "11-hierarchy/rods.json",
    "11-hierarchy/scene.json",
    "11-hierarchy/solution.rs",
    "12-grid/box.json",
    "12-grid/exercise.rs",
    "12-grid/later-cell.json",
    "12-grid/lesson.json",
    "12-grid/mailbox.json",
    "12-grid/many.json",
    "12-grid/scene.json",
    "12-grid/skipped.json",
    "12-grid/solution.rs",
    "12-grid/stadium.json",
    "12-grid/steps-back.json",
    "12-grid/steps.json",
    "any-language/README.md",
    "any-language/scene.json",
    "any-language/tracer.cpp",
    "any-language/tracer.py",
    "gallery/backlit.json",
    "gallery/ball.json",
    "gallery/cloud.json",
    "gallery/far.json",
    "gallery/grid.json",
    "gallery/lesson.json",
    "gallery/mirrors.json",
    "gallery/rows.json",
    "gallery/scene.json",
    "gallery/sun.json",
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::{Path, PathBuf};

    use super::*;

    fn lessons() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")
    }

    fn below(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                below(&path, found);
            } else {
                let relative = path.strip_prefix(lessons()).unwrap();
                found.insert(relative.to_str().unwrap().replace('\\', "/"));
            }
        }
    }

    #[test]
    fn each_file_of_the_course_is_written_as_it_is() {
        let mut expected = BTreeSet::new();
        below(&lessons(), &mut expected);
        expected.extend(["Cargo.toml".to_owned(), ".gitignore".to_owned()]);
        let files = course_files(&Dependency::Path("../..".into()));
        let mut written: BTreeSet<String> =
            files.iter().map(|(path, _)| path.to_string()).collect();
        if !lessons().join("run").exists() {
            // the published package
            written.retain(|path| !path.starts_with("run/"));
        }
        assert_eq!(written, expected);
        for (path, bytes) in files {
            if let Ok(there) = fs::read(lessons().join(path)) {
                assert!(
                    there == *bytes,
                    "src/lesson/start: copy lessons/{path} again"
                );
            }
        }
    }

    #[test]
    fn a_path_is_quoted_and_a_version_is_one() {
        let line = |of: Dependency| of.line();
        assert_eq!(
            line(Dependency::Version("0.1.0".into())),
            r#"raystep = { version = "0.1.0", default-features = false }"#
        );
        assert_eq!(
            line(Dependency::Git("https://example.org/raystep".into())),
            r#"raystep = { git = "https://example.org/raystep", default-features = false }"#
        );
        assert_eq!(
            line(Dependency::Path(r#"C:\a "b""#.into())),
            r#"raystep = { path = "C:\\a \"b\"", default-features = false }"#
        );
    }
}
