//! The course's book: it builds without a warning, every link leads somewhere, what it shows comes from the project, no number
//! in its prose is typed by hand, and the commands that it shows run.

#[path = "course_book/commands.rs"]
mod commands;
#[path = "course_book/pages.rs"]
mod pages;
#[path = "course_book/prose.rs"]
mod prose;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use serde_json::{Value, json};

use pages::Pages;
use raystep::book::PrintPage;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The chapters, each with its file in `book/src` and its text.
fn chapters() -> Vec<(String, String)> {
    let folder = root().join("book/src");
    let mut found: Vec<(String, String)> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "md"))
        .map(|path| {
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect();
    found.sort();
    assert!(20 < found.len(), "{} chapters", found.len());
    found
}

/// The pages of the book, built once.
fn built() -> &'static Pages {
    static BUILT: OnceLock<(tempfile::TempDir, Pages)> = OnceLock::new();
    let (_, pages) = BUILT.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let book = root().join("book");
        let mut config = Config::from_disk(book.join("book.toml")).unwrap();
        config.build.build_dir = folder.path().join("pages");
        let command = format!("'{}' mdbook", env!("CARGO_BIN_EXE_raystep"));
        config.set("preprocessor.raystep.command", command).unwrap();
        let built = MDBook::load_with_config(book, config).and_then(|book| book.build());
        built.unwrap_or_else(|error| panic!("{error:#}"));
        let root = folder.path().join("pages");
        // as `raystep book build` does
        let page = root.join("print.html");
        let light = PrintPage::of(&fs::read_to_string(&page).unwrap());
        fs::write(page, light.html).unwrap();
        for (file, drawing) in light.drawings {
            let file = root.join(file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, drawing).unwrap();
        }
        let pages = Pages::read(&root);
        (folder, pages)
    });
    pages
}

#[test]
fn every_link_of_the_book_leads_somewhere_and_nothing_comes_from_another_host() {
    let faults = built().faults();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(20 < built().count(), "{} pages", built().count());
}

#[test]
fn no_page_is_too_large() {
    /// Bytes of a page, and of all files.
    const MOST: [u64; 2] = [1_500_000, 20_000_000];
    for (page, size) in built().sizes() {
        assert!(size <= MOST[0], "{page}: {size}");
    }
    let all = built().size_of_all();
    assert!(all <= MOST[1], "{all}");
}

#[test]
fn no_number_in_the_prose_is_typed_by_hand() {
    let mut found = Vec::new();
    for (file, text) in chapters() {
        found.extend(prose::numbers(&file, &text));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    // it finds what it looks for
    let text = "Of 12 rays 3.5 miss $4$ `5`.\n\n```sh\n6\n```\n{{#raystep a/b7}} (erratum 8, Fig. 15.56) a 3D grid\n";
    assert_eq!(
        prose::numbers("a.md", text),
        ["a.md, line 1: 12", "a.md, line 1: 3.5"]
    );
}

#[test]
fn every_command_of_the_book_and_of_the_readme_runs() {
    let mut files = chapters();
    files.push((
        "README.md".into(),
        fs::read_to_string(root().join("README.md")).unwrap(),
    ));
    let mut run = 0;
    let mut faults = Vec::new();
    for (file, text) in &files {
        let (count, of_file) = commands::run_all(root(), file, text);
        run += count;
        faults.extend(of_file);
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(20 < run, "{run} commands");
}

#[test]
fn the_map_has_a_row_for_each_row_of_the_index() {
    let text = fs::read_to_string(root().join("book/map.json")).unwrap();
    let map: Value = serde_json::from_str(&text).unwrap();
    let of_map = |row: &Value| {
        let text = |key: &str| row[key].as_str().map(str::to_owned);
        (
            text("slide").unwrap(),
            text("subject").unwrap(),
            text("figure"),
        )
    };
    let of_map: Vec<_> = map["rows"].as_array().unwrap().iter().map(of_map).collect();
    let of_index: Vec<_> = crate::index::rows()
        .into_iter()
        .map(|row| (row.slide, row.subject, row.figure))
        .collect();
    assert_eq!(of_map, of_index);
}

/// A copy of what the book is made from, to change something in.
struct Project(tempfile::TempDir);

impl Project {
    fn copy() -> Self {
        let project = Self(tempfile::tempdir().unwrap());
        for folder in ["book", "lessons", "src"] {
            copy(&root().join(folder), &project.0.path().join(folder));
        }
        project
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn change(&self, file: &str, from: &str, to: &str) {
        let text = fs::read_to_string(self.path(file)).unwrap();
        assert!(text.contains(from), "{file}: {from}");
        fs::write(self.path(file), text.replacen(from, to, 1)).unwrap();
    }

    /// What the preprocessor makes of a text.
    fn preprocess(&self, text: &str) -> Output {
        let chapter = json!({ "Chapter": {
            "name": "One", "content": text, "number": null, "sub_items": [],
            "path": "one.md", "source_path": "one.md", "parent_names": [] } });
        let context = json!({ "root": self.path("book"), "renderer": "html", "mdbook_version": "0.5.4",
            "config": { "preprocessor": { "raystep": { "lessons": "../lessons", "before": ["links"] } } } });
        let input = json!([context, { "items": [chapter] }]).to_string();
        fs::write(self.path("input.json"), input).unwrap();
        Command::new(env!("CARGO_BIN_EXE_raystep"))
            .arg("mdbook")
            .stdin(Stdio::from(
                fs::File::open(self.path("input.json")).unwrap(),
            ))
            .output()
            .unwrap()
    }

    fn shown(&self, text: &str) -> String {
        let out = self.preprocess(text);
        assert!(
            out.status.success(),
            "{}",
            String::from_utf8_lossy(&out.stderr)
        );
        let book: Value = serde_json::from_slice(&out.stdout).unwrap();
        book["items"][0]["Chapter"]["content"]
            .as_str()
            .unwrap()
            .to_owned()
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &target);
        } else {
            fs::copy(&path, target).unwrap();
        }
    }
}

/// The directives of the book that name a figure, in the order of the book.
fn directives(part: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (_, text) in chapters() {
        for piece in text.split("{{#").skip(1) {
            let directive = piece.split("}}").next().unwrap();
            if directive.contains(part) && !found.contains(&directive.to_owned()) {
                found.push(directive.to_owned());
            }
        }
    }
    found
}

#[test]
fn a_changed_number_of_a_scene_changes_all_that_the_book_shows_of_it() {
    let project = Project::copy();
    // what the book asks of the figures of one scene, and of that scene itself
    let all = directives(" 04-sphere/two-roots");
    assert!(2 <= all.len(), "{all:?}");
    let show = |directive: &str| project.shown(&format!("{{{{#{directive}}}}}\n"));
    let before: Vec<String> = all.iter().map(|of| show(of)).collect();
    let lesson = fs::read_to_string(project.path("lessons/04-sphere/lesson.json")).unwrap();
    let lesson: Value = serde_json::from_str(&lesson).unwrap();
    let scene = lesson["figures"]["two-roots"]["scene"].as_str().unwrap();
    let scene = format!("lessons/04-sphere/{scene}");
    let text = fs::read_to_string(project.path(&scene)).unwrap();
    let mut value: Value = serde_json::from_str(&text).unwrap();
    let objects = value["objects"].as_array_mut().unwrap();
    for object in objects {
        if let Some(radius) = object["shape"]["sphere"].get_mut("radius") {
            *radius = json!(radius.as_f64().unwrap() * 1.0625);
        }
    }
    fs::write(project.path(&scene), value.to_string()).unwrap();
    for (directive, before) in all.iter().zip(&before) {
        assert_ne!(&show(directive), before, "{directive}");
    }
}

#[test]
fn a_changed_pixel_of_a_figure_changes_the_figure_and_its_working() {
    let project = Project::copy();
    let all = [
        "raystep 04-sphere/two-roots",
        "raystep-log 04-sphere/two-roots",
        "raystep-code lessons/04-sphere/lesson.json:/figures/two-roots",
    ];
    let show = |directive: &str| project.shown(&format!("{{{{#{directive}}}}}\n"));
    let before = all.map(show);
    let text = fs::read_to_string(project.path("lessons/04-sphere/lesson.json")).unwrap();
    let mut lesson: Value = serde_json::from_str(&text).unwrap();
    let pixel = &mut lesson["figures"]["two-roots"]["pixel"];
    *pixel = json!([pixel[0].as_u64().unwrap() + 1, pixel[1]]);
    fs::write(
        project.path("lessons/04-sphere/lesson.json"),
        lesson.to_string(),
    )
    .unwrap();
    for (directive, before) in all.iter().zip(&before) {
        assert_ne!(&show(directive), before, "{directive}");
    }
}

#[test]
fn a_changed_function_changes_the_code_or_fails_the_build_with_chapter_and_line() {
    let project = Project::copy();
    let chapter = "# One\n\n{{#raystep-code src/tracer/simple.rs:picture}}\n";
    assert!(!directives("raystep-code src/tracer/simple.rs:picture").is_empty());
    let before = project.shown(chapter);
    project.change("src/tracer/simple.rs", "pub fn picture", "pub  fn picture");
    let after = project.shown(chapter);
    assert!(
        before.contains("pub fn picture") && after.contains("pub  fn picture"),
        "{after}"
    );
    project.change("src/tracer/simple.rs", "pub  fn picture", "pub fn image");
    let out = project.preprocess(chapter);
    let told = String::from_utf8(out.stderr).unwrap();
    assert_eq!(out.status.code(), Some(2), "{told}");
    assert!(told.contains("one.md, line 3: "), "{told}");
}

#[test]
fn below_the_picture_of_a_mistake_stand_its_step_its_exercise_and_its_question() {
    let project = Project::copy();
    let question = "{{#raystep-question 04-sphere/half-b}}\n";
    let shown = project.shown(&format!(
        "{question}\n{{{{#raystep gallery/half-b-in-the-full-formula}}}}\n"
    ));
    let (_, caption) = shown.split_once("<figcaption>").unwrap();
    let (caption, _) = caption.split_once("</figcaption>").unwrap();
    // the pixel is that of the figure's log
    let log = project.path("log.jsonl");
    let figure = Command::new(env!("CARGO_BIN_EXE_raystep"))
        .args(["figure", "gallery/half-b-in-the-full-formula", "-o"])
        .arg(project.path("figure.svg"))
        .arg("--lessons")
        .arg(project.path("lessons"))
        .arg("--write-log")
        .arg(&log)
        .status();
    assert!(figure.unwrap().success());
    let log = fs::read_to_string(log).unwrap();
    let mut lines = log
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap());
    let mistake = lines.find(|line| line["kind"] == "mistake").unwrap();
    let [x, y] = [0, 1].map(|at| mistake["first"][at].as_u64().unwrap());
    let step = format!("<code>raystep step lessons/gallery/scene.json {x},{y}</code>");
    assert!(caption.contains(&step), "{caption}");
    assert!(
        caption.contains("Exercise: <code>l04_roots</code>, <code>l04_root_that_counts</code>."),
        "{caption}"
    );
    let link = "<a href=\"#raystep-question-04-sphere-half-b\">04-sphere/half-b</a>";
    assert!(caption.contains(link), "{caption}");
    // a puzzle tells nothing of it
    let puzzle = project.shown("{{#raystep gallery/half-b-in-the-full-formula stage=2 puzzle}}\n");
    let (_, caption) = puzzle.split_once("<figcaption>").unwrap();
    let (caption, _) = caption.split_once("</figcaption>").unwrap();
    // the option is not broken at its hyphens
    let option = "<span style=\"white-space: nowrap\">--stage</span>";
    let command = "raystep figure gallery/half-b-in-the-full-formula";
    assert_eq!(caption, format!("<code>{command} {option} 2</code>"));
    assert!(puzzle.contains("_title\">A puzzle</title>"), "{puzzle}");
    // neither does the drawing, up to that stage: the mistake's own sentence comes after both pictures
    let drawn: String = puzzle.split("<text").skip(1).collect();
    assert!(!drawn.contains("factor 2"), "{drawn}");
}
