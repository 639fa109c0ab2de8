//! `raystep init`: a course of one's own, ready to build.

use crate::cli::Error;
use crate::cli::args::InitArgs;
use crate::cli::output::Output;
use crate::cli::output_folder::OutputFolder;

/// All files of a new course. The chapter uses each directive once.
const FILES: [(&str, &str); 11] = [
    (
        ".github/workflows/pages.yml",
        include_str!("init/pages.yml"),
    ),
    (".gitignore", include_str!("init/gitignore")),
    ("book.toml", include_str!("init/book.toml")),
    ("lessons/01-ball/ball.rs", include_str!("init/ball.rs")),
    (
        "lessons/01-ball/lesson.json",
        include_str!("init/lesson.json"),
    ),
    (
        "lessons/01-ball/scene.json",
        include_str!("init/scene.json"),
    ),
    ("map.json", include_str!("init/map.json")),
    ("scroll.js", include_str!("../../book/scroll.js")),
    ("src/SUMMARY.md", include_str!("init/SUMMARY.md")),
    ("src/ball.md", include_str!("init/ball.md")),
    ("style.css", include_str!("../../book/style.css")),
];

/// Writes a new course.
pub(crate) fn run(args: &InitArgs) -> Result<(), Error> {
    let dir = &args.dir;
    let folder = OutputFolder::create(dir, |_| false)?;
    for (file, text) in FILES {
        folder.write(file, text.as_bytes())?;
    }
    folder.finish()?;
    let dir = dir.display();
    let told = format!(
        "The course is in {dir}. Build its book, and open {dir}/book/index.html:\n  raystep book build {dir}\n\
         With mdBook installed, 'mdbook build {dir}' does the same.\n"
    );
    Output::standard().write_whole(told.as_bytes())
}
