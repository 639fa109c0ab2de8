//! Puts the files of the lessons into the program: WebAssembly has no file system.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

fn main() {
    let root = env::var("CARGO_MANIFEST_DIR").unwrap();
    let lessons = Path::new(&root)
        .join("../../lessons")
        .canonicalize()
        .unwrap();
    println!("cargo::rerun-if-changed={}", lessons.display());
    let mut files = Vec::new();
    for lesson in fs::read_dir(&lessons).unwrap() {
        for file in fs::read_dir(lesson.unwrap().path()).unwrap() {
            files.push(file.unwrap().path());
        }
    }
    files.sort();
    let mut text = String::from("pub const FILES: &[(&str, &[u8])] = &[\n");
    for file in files.iter().filter(|file| file.is_file()) {
        let name = file.strip_prefix(&lessons).unwrap();
        let name = name.to_str().unwrap().replace('\\', "/");
        writeln!(
            text,
            "({name:?}, include_bytes!({:?})),",
            file.display().to_string()
        )
        .unwrap();
    }
    text.push_str("];\n");
    fs::write(
        Path::new(&env::var("OUT_DIR").unwrap()).join("files.rs"),
        text,
    )
    .unwrap();
}
