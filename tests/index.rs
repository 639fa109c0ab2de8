//! The index of subjects in ARCHITECTURE.md: each cell of it names something that exists.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::layers::sources;

/// Rows of subjects that have no figure yet.
const WITHOUT_FIGURE: usize = 0;

/// A row: where the slides have the subject, and where the project has it.
pub(crate) struct Row {
    pub(crate) slide: String,
    pub(crate) subject: String,
    file: String,
    item: String,
    test: String,
    pub(crate) figure: Option<String>,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The words of a cell without the marks of code around them.
fn bare(cell: &str) -> String {
    cell.trim().trim_matches('`').to_owned()
}

/// The rows of the table under the heading "Index of subjects".
pub(crate) fn rows() -> Vec<Row> {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let (_, after) = text.split_once("## Index of subjects").unwrap();
    let table = after.lines().skip_while(|line| !line.starts_with('|'));
    let lines = table.take_while(|line| line.starts_with('|')).skip(2);
    let row = |line: &str| {
        let cells: Vec<String> = line.trim_matches('|').split('|').map(bare).collect();
        let [slide, subject, file, item, test, figure]: [String; 6] = cells
            .try_into()
            .unwrap_or_else(|_| panic!("six cells: {line}"));
        assert!(!slide.is_empty(), "{line}");
        Row {
            slide,
            subject,
            file,
            item,
            test,
            figure: (figure != "–").then_some(figure),
        }
    };
    lines.map(row).collect()
}

/// Is a word of this kind defined under this name: `fn at`, `struct Ray`?
fn defines(text: &str, item: &str) -> bool {
    let name = item.rsplit("::").next().unwrap();
    ["fn", "struct", "enum", "trait", "const", "type"]
        .iter()
        .any(|kind| {
            let start = format!("{kind} {name}");
            text.match_indices(&start).any(|(at, _)| {
                let next = text[at + start.len()..].chars().next();
                !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
            })
        })
}

#[test]
fn there_are_at_least_thirty_subjects_and_each_has_one_row() {
    let rows = rows();
    assert!(30 <= rows.len(), "{}", rows.len());
    for (at, row) in rows.iter().enumerate() {
        let twice = rows[..at].iter().any(|other| other.subject == row.subject);
        assert!(!twice, "{} stands twice", row.subject);
    }
}

#[test]
fn each_file_of_the_index_defines_the_item() {
    for Row {
        subject,
        file,
        item,
        ..
    } in rows()
    {
        let text = fs::read_to_string(root().join("src").join(&file));
        let text = text.unwrap_or_else(|error| panic!("{subject}: src/{file}: {error}"));
        assert!(
            defines(&text, &item),
            "{subject}: src/{file} defines no {item}"
        );
    }
}

#[test]
fn each_test_of_the_index_is_a_test() {
    let all: Vec<PathBuf> = ["src", "tests"]
        .iter()
        .flat_map(|folder| sources(&root().join(folder)))
        .collect();
    let texts: Vec<String> = all
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    for Row { subject, test, .. } in rows() {
        let is_test = |text: &String| {
            let lines: Vec<&str> = text.lines().map(str::trim).collect();
            lines
                .windows(2)
                .any(|pair| pair[0] == "#[test]" && pair[1].starts_with(&format!("fn {test}(")))
        };
        assert!(
            texts.iter().any(is_test),
            "{subject}: no test is called {test}"
        );
    }
}

#[test]
fn each_figure_of_the_index_is_in_its_lesson() {
    let mut without = 0;
    for Row {
        subject, figure, ..
    } in rows()
    {
        let Some(figure) = figure else {
            without += 1;
            continue;
        };
        let (lesson, name) = figure.split_once('/').unwrap();
        let path = root().join("lessons").join(lesson).join("lesson.json");
        let text = fs::read_to_string(&path);
        let text = text.unwrap_or_else(|error| panic!("{subject}: {}: {error}", path.display()));
        let lesson: Value = serde_json::from_str(&text).unwrap();
        assert!(
            lesson["figures"].get(name).is_some(),
            "{subject}: no figure {figure}"
        );
    }
    assert_eq!(without, WITHOUT_FIGURE, "subjects without a figure");
}

/// What students search for: the field's words beside the slides' own.
const FIELD_WORDS: [&str; 24] = [
    "AABB",
    "BRDF",
    "BVH",
    "DDA",
    "HIER_traverse",
    "Phong reflection model",
    "Russian roulette",
    "SAH",
    "Snell law",
    "Whitted ray tracing",
    "bidirectional path tracing",
    "bounding volume",
    "bounding volume hierarchy",
    "light tracing",
    "path tracing",
    "pdf",
    "photon map",
    "photon mapping",
    "pinhole camera",
    "ray casting",
    "shadow acne",
    "shadow ray",
    "traversal",
    "uniform grid",
];

#[test]
fn each_word_of_the_field_finds_an_item_in_the_documentation() {
    let files = sources(&root().join("src"));
    let texts: Vec<String> = files
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    for word in FIELD_WORDS {
        let alias = format!("#[doc(alias = \"{word}\")]");
        assert!(
            texts.iter().any(|text| text.contains(&alias)),
            "no item has the alias {word}"
        );
    }
}
