//! The page of questions: its blocks of code, by what they are for.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::cli::run::{Folder, RAYSTEP};

/// What the page has between ``` and ```.
#[derive(Debug)]
pub(super) struct Page {
    /// Makes the logs.
    pub(super) logs: String,
    /// Makes the view of all logs.
    pub(super) view: String,
    /// Reads the logs.
    pub(super) frames: String,
    /// One of each for every question.
    pub(super) jq: Vec<String>,
    pub(super) sql: Vec<String>,
    pub(super) python: Vec<String>,
}

impl Page {
    #[track_caller]
    pub(super) fn read() -> Self {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/questions/README.md");
        let text = fs::read_to_string(page).unwrap();
        let (mut jq, mut sql, mut python) = (Vec::new(), Vec::new(), Vec::new());
        // ```, a language, a line break and the code, up to the next ```
        for block in text.split("```").skip(1).step_by(2) {
            let (language, code) = block.split_once('\n').unwrap();
            let blocks = match language {
                "sh" => &mut jq,
                "sql" => &mut sql,
                "python" => &mut python,
                _ => panic!("a block in {language:?}"),
            };
            blocks.push(code.to_owned());
        }
        let questions = text.lines().filter(|line| {
            let title = line.strip_prefix("## ");
            title.is_some_and(|title| title.starts_with(|c: char| c.is_ascii_digit()))
        });
        let page = Self {
            logs: jq.remove(0),
            view: sql.remove(0),
            frames: python.remove(0),
            jq,
            sql,
            python,
        };
        let count = questions.count();
        assert_eq!(
            [page.jq.len(), page.sql.len(), page.python.len()],
            [count; 3],
            "a block of each for every question"
        );
        page
    }

    /// Makes the logs in a folder, as the page does in that of the project.
    #[track_caller]
    pub(super) fn make_logs(&self, folder: &Folder) {
        for line in self.logs.lines() {
            let mut words = line.split_whitespace();
            assert_eq!(words.next(), Some("raystep"), "{line}");
            let (words, output): (Vec<&str>, &str) = {
                let all: Vec<&str> = words.collect();
                let [before @ .., "-o", output] = &all[..] else {
                    panic!("no output: {line}");
                };
                (before.to_vec(), output)
            };
            let ran = Command::new(RAYSTEP)
                .current_dir(env!("CARGO_MANIFEST_DIR"))
                .args(words)
                .arg("-o")
                .arg(folder.path(output))
                .output()
                .unwrap();
            assert!(ran.status.success(), "{line}: {ran:?}");
        }
    }
}
