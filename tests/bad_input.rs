//! Bad input goes through the command: one message, exit 2, no file left, existing files kept.
#![allow(
    clippy::needless_raw_string_hashes,
    reason = "snapbox writes the snapshots so"
)]

mod arguments;
mod endless;
mod lessons;
pub(crate) mod light;
mod limits;
mod nff_and_obj;
mod options;
mod same_file;
mod scenes;
mod structures;
mod targets;

use crate::cli::run::{Folder, SCENE};

/// What the command says when it is to render a file that holds this.
#[track_caller]
fn refuses(name: &str, content: impl AsRef<[u8]>) -> String {
    let folder = Folder::empty().with(name, content);
    refuses_in(&folder, &format!("render {name}"))
}

/// What the command says to these words, with an output that does not exist and with one that does.
#[track_caller]
fn refuses_in(folder: &Folder, words: &str) -> String {
    let before = folder.names();
    let message = folder.run(&format!("{words} -o out.png")).refused();
    assert_eq!(folder.names(), before, "a file was left behind");

    std::fs::write(folder.path("out.png"), "old").unwrap();
    let again = folder.run(&format!("{words} -o out.png")).refused();
    assert_eq!(again, message);
    assert_eq!(
        folder.read("out.png"),
        b"old",
        "the existing file was touched"
    );
    assert_eq!(
        folder.names().len(),
        before.len() + 1,
        "a file was left behind"
    );
    std::fs::remove_file(folder.path("out.png")).unwrap();
    message
}

/// What the command says to the scene of the design with one thing changed.
#[track_caller]
fn refuses_with(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "the scene has no {from}");
    refuses("scene.json", SCENE.replacen(from, to, 1))
}
