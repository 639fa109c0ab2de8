//! A course of one's own: begun with one command, and built at once.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use mdbook_driver::MDBook;
use mdbook_driver::config::Config;

fn raystep(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_raystep");
    Command::new(program).args(arguments).output().unwrap()
}

fn told(out: &Output) -> String {
    String::from_utf8(out.stderr.clone()).unwrap()
}

/// A new course in a folder of its own.
fn course() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().join("my course");
    let out = raystep(&["init", dir.to_str().unwrap()]);
    assert!(out.status.success(), "{}", told(&out));
    (folder, dir)
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Builds a book as an installed mdBook does.
fn build(dir: &Path) -> Result<(), String> {
    let mut config = Config::from_disk(dir.join("book.toml")).unwrap();
    let command = format!("'{}' mdbook", env!("CARGO_BIN_EXE_raystep"));
    config.set("preprocessor.raystep.command", command).unwrap();
    let built = MDBook::load_with_config(dir, config).and_then(|book| book.build());
    built.map_err(|error| format!("{error:#}"))
}

#[test]
fn a_new_course_uses_each_directive_and_builds_at_once() {
    let (folder, dir) = course();
    assert_eq!(names(folder.path()), ["my course"]);
    assert_eq!(
        names(&dir),
        [
            ".github",
            ".gitignore",
            "book.toml",
            "lessons",
            "map.json",
            "scroll.js",
            "src",
            "style.css"
        ]
    );
    let chapter = fs::read_to_string(dir.join("src/ball.md")).unwrap();
    for directive in [
        "raystep",
        "raystep-log",
        "raystep-blanks",
        "raystep-value",
        "raystep-compare",
        "raystep-code",
        "raystep-run",
        "raystep-question",
        "raystep-questions",
        "raystep-answers",
        "raystep-map",
        "raystep-mistakes",
    ] {
        let used = [
            format!("{{{{#{directive} "),
            format!("{{{{#{directive}}}}}"),
        ];
        assert!(
            used.iter().any(|used| chapter.contains(used)),
            "{directive}"
        );
    }
    build(&dir).unwrap();
    let page = fs::read_to_string(dir.join("book/ball.html")).unwrap();
    // the ball of radius 1 lies 5 before the eye, and the ray passes the middle of the picture within half a pixel
    assert!(page.contains("two real roots"), "{page}");
    assert_eq!(page.matches("class=\"raystep-quiz\"").count(), 3, "{page}");
    assert!(!page.contains("{{#"), "{page}");
    // a reader's command is the one that ran; a word with a hyphen is not broken
    let scene = "<span style=\"white-space: nowrap\">lessons/01-ball/scene.json</span>";
    let command = format!("$ raystep pixel {scene} 80,60");
    assert!(page.contains(&command), "{page}");
}

#[test]
fn nothing_is_written_over_what_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.txt");
    fs::write(&file, "mine").unwrap();
    let out = raystep(&["init", folder.path().to_str().unwrap()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(
        told(&out).contains("is there already, and not empty"),
        "{}",
        told(&out)
    );
    assert_eq!(names(folder.path()), ["mine.txt"]);
    // an empty folder will do
    fs::remove_file(&file).unwrap();
    let out = raystep(&["init", folder.path().to_str().unwrap()]);
    assert!(out.status.success(), "{}", told(&out));
    assert!(folder.path().join("book.toml").is_file());
    // a file is no folder
    fs::write(folder.path().join("file"), "").unwrap();
    let out = raystep(&["init", folder.path().join("file").to_str().unwrap()]);
    assert_eq!(out.status.code(), Some(2), "{}", told(&out));
}

#[test]
fn a_folder_without_a_book_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let out = raystep(&["book", "build", folder.path().to_str().unwrap()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(
        told(&out).contains("there is no book.toml in "),
        "{}",
        told(&out)
    );
}

#[cfg(not(feature = "course"))]
#[test]
fn without_its_feature_the_command_tells_how_to_build_a_book() {
    let (_folder, dir) = course();
    let out = raystep(&["book", "build", dir.to_str().unwrap()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(told(&out).contains("--features course"), "{}", told(&out));
    assert!(told(&out).contains("mdbook build "), "{}", told(&out));
}

#[cfg(feature = "course")]
mod with_course {
    use super::*;

    use raystep::book::PrintPage;

    #[test]
    fn the_command_builds_the_same_pages_as_mdbook() {
        let (folder, dir) = course();
        build(&dir).unwrap();
        let out = folder.path().join("out");
        let built = raystep(&[
            "book",
            "build",
            dir.to_str().unwrap(),
            "-o",
            out.to_str().unwrap(),
        ]);
        assert!(built.status.success(), "{}", told(&built));
        let lines = told(&built);
        assert_eq!(lines.lines().count(), 1, "{lines}");
        assert!(lines.starts_with("note: the book is in "), "{lines}");
        let read = |folder: &Path, file: &str| fs::read_to_string(folder.join(file)).unwrap();
        for page in ["index.html", "ball.html"] {
            assert_eq!(read(&out, page), read(&dir.join("book"), page), "{page}");
        }
        // the page for print alone is lighter, with its drawings beside it
        let light = PrintPage::of(&read(&dir.join("book"), "print.html"));
        assert_eq!(read(&out, "print.html"), light.html);
        assert!(!light.drawings.is_empty());
        for (file, drawing) in &light.drawings {
            assert_eq!(read(&out, file), *drawing, "{file}");
        }
        assert_eq!(names(folder.path()), ["my course", "out"]);
        // an older build is replaced
        fs::write(out.join("old.html"), "").unwrap();
        let built = raystep(&[
            "book",
            "build",
            dir.to_str().unwrap(),
            "-o",
            out.to_str().unwrap(),
        ]);
        assert!(built.status.success(), "{}", told(&built));
        assert!(!out.join("old.html").exists());
    }

    /// The preprocessor looked for the lessons in the folder of the book, whose name it had from elsewhere.
    #[test]
    fn a_book_is_found_by_its_name_and_by_the_folder_that_one_is_in() {
        let (folder, dir) = course();
        for (here, arguments) in [
            (folder.path(), &["book", "build", "my course"][..]),
            (&*dir, &["book", "build"][..]),
        ] {
            let mut command = Command::new(env!("CARGO_BIN_EXE_raystep"));
            let built = command.args(arguments).current_dir(here).output().unwrap();
            assert!(built.status.success(), "{}", told(&built));
            assert!(dir.join("book/ball.html").is_file());
            fs::remove_dir_all(dir.join("book")).unwrap();
        }
    }

    #[test]
    fn a_book_that_cannot_be_built_leaves_what_is_there() {
        let (folder, dir) = course();
        let out = folder.path().join("out");
        let build = || {
            raystep(&[
                "book",
                "build",
                dir.to_str().unwrap(),
                "-o",
                out.to_str().unwrap(),
            ])
        };
        assert!(build().status.success());
        let before = fs::read_to_string(out.join("ball.html")).unwrap();
        let chapter = fs::read_to_string(dir.join("src/ball.md")).unwrap();
        fs::write(
            dir.join("src/ball.md"),
            chapter.replace("01-ball/hit", "01-ball/hti"),
        )
        .unwrap();
        let failed = build();
        assert_eq!(failed.status.code(), Some(2));
        assert!(
            told(&failed).contains("ball.md, line "),
            "{}",
            told(&failed)
        );
        assert_eq!(fs::read_to_string(out.join("ball.html")).unwrap(), before);
        assert_eq!(names(folder.path()), ["my course", "out"]);
        // a chapter that is not there
        fs::write(dir.join("src/SUMMARY.md"), "- [None](none.md)\n").unwrap();
        assert_eq!(build().status.code(), Some(2));
        assert!(!dir.join("src/none.md").exists());
        // a folder that is no book
        fs::write(folder.path().join("my course/src/x.txt"), "").unwrap();
        let src = dir.join("src");
        let refused = raystep(&[
            "book",
            "build",
            dir.to_str().unwrap(),
            "-o",
            src.to_str().unwrap(),
        ]);
        assert!(told(&refused).contains("not empty"), "{}", told(&refused));
        assert!(src.join("x.txt").is_file());
    }
}
