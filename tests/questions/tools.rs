//! The tools that ask: where they are, and what they answer.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::page::Page;
use super::{Rows, Shape};
use crate::cli::run::Folder;

/// A tool that reads logs.
#[derive(Clone, Copy, Debug)]
pub(super) enum Tool {
    Jq,
    DuckDb,
    Pandas,
}

/// A tool that is there.
pub(super) struct Installed {
    tool: Tool,
    program: PathBuf,
}

/// Asks the questions in files 1.sql, 2.sql, …, after `view.sql`.
const ASK_DUCKDB: &str = r#"
import duckdb, itertools, json, os
connection = duckdb.connect()
connection.execute(open("view.sql").read())
for number in itertools.takewhile(lambda n: os.path.exists(f"{n}.sql"), itertools.count(1)):
    print(json.dumps(connection.execute(open(f"{number}.sql").read()).fetchall()))
"#;

/// The same for 1.py, 2.py, …, after `frames.py`.
const ASK_PANDAS: &str = r#"
import itertools, json, os
names = {}
exec(open("frames.py").read(), names)
for number in itertools.takewhile(lambda n: os.path.exists(f"{n}.py"), itertools.count(1)):
    exec(open(f"{number}.py").read(), names)
    answer = names["answer"].astype(object)
    print(json.dumps(answer.where(answer.notna(), None).values.tolist()))
"#;

/// The columns and the kinds that the view finds in each of some files.
const SHAPES: &str = r#"
import duckdb, json, sys
view = open("view.sql").read()
for file in sys.argv[1:]:
    connection = duckdb.connect()
    connection.execute(view.replace("*.jsonl", file))
    columns = [row[0] for row in connection.execute("DESCRIBE log").fetchall()]
    kinds = connection.execute("SELECT kind, count(*) FROM log GROUP BY kind").fetchall()
    print(json.dumps([[c for c in columns if c not in ("filename", "file")], dict(kinds)]))
"#;

impl Tool {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Jq => "jq",
            Self::DuckDb => "duckdb",
            Self::Pandas => "pandas",
        }
    }

    /// The tool, or a line that says that it is skipped.
    pub(super) fn installed(self) -> Option<Installed> {
        // what .ci/run makes, then what the system has
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/questions/bin/python");
        let pythons = [own, "python3".into()];
        let (programs, arguments): (&[PathBuf], Vec<String>) = match self {
            Self::Jq => (&["jq".into()], vec!["--version".into()]),
            _ => (
                &pythons,
                vec!["-c".into(), format!("import {}", self.name())],
            ),
        };
        let works = |program: &&PathBuf| {
            let mut command = Command::new(program);
            let silent = command.stdout(Stdio::null()).stderr(Stdio::null());
            silent
                .args(&arguments)
                .status()
                .is_ok_and(|status| status.success())
        };
        let found = programs.iter().find(works).cloned();
        if found.is_none() {
            // not by a macro, whose lines cargo hides where a test passes
            let skipped = format!("skipped: {} is not installed\n", self.name());
            io::stderr().write_all(skipped.as_bytes()).unwrap();
        }
        found.map(|program| Installed {
            tool: self,
            program,
        })
    }
}

impl Installed {
    pub(super) fn name(&self) -> &'static str {
        self.tool.name()
    }

    /// The answers to all questions of the page, in its order.
    #[track_caller]
    pub(super) fn ask(&self, folder: &Folder, page: &Page) -> Vec<Rows> {
        let (before, script, blocks, ending) = match self.tool {
            Tool::Jq => {
                let ask = |command: &String| {
                    let mut shell = Command::new("sh");
                    lines(shell.current_dir(folder.path("")).args(["-c", command]))
                };
                return page.jq.iter().map(ask).collect();
            }
            Tool::DuckDb => (("view.sql", &page.view), ASK_DUCKDB, &page.sql, "sql"),
            Tool::Pandas => (("frames.py", &page.frames), ASK_PANDAS, &page.python, "py"),
        };
        fs::write(folder.path(before.0), before.1).unwrap();
        for (i, block) in blocks.iter().enumerate() {
            fs::write(folder.path(&format!("{}.{ending}", i + 1)), block).unwrap();
        }
        let mut python = Command::new(&self.program);
        lines(python.current_dir(folder.path("")).args(["-c", script]))
    }

    /// The shapes of some files.
    #[track_caller]
    pub(super) fn shapes<'a>(
        &self,
        folder: &Folder,
        page: &Page,
        files: impl Iterator<Item = &'a String>,
    ) -> Vec<Shape> {
        fs::write(folder.path("view.sql"), &page.view).unwrap();
        let mut python = Command::new(&self.program);
        lines(
            python
                .current_dir(folder.path(""))
                .args(["-c", SHAPES])
                .args(files),
        )
    }
}

/// What a command prints, a line of JSON each.
#[track_caller]
fn lines<T: serde::de::DeserializeOwned>(command: &mut Command) -> Vec<T> {
    let ran = command.output().unwrap();
    let error = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{command:?}\n{error}");
    let printed = String::from_utf8(ran.stdout).unwrap();
    let read = |line| serde_json::from_str(line);
    printed.lines().map(|line| read(line).unwrap()).collect()
}
