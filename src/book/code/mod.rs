//! `{{#raystep-code PATH:ITEM}}`: source as it stands in the project, by the name of an item and not by a line, so that it
//! is what runs.

mod json;
mod marked;
mod rust;
mod text;
mod tokens;

use std::fs;
use std::path::Path;

use crate::book::Project;
use crate::explain::render::escaped;
use crate::scene::{LARGEST_FILE, quoted};

/// The source with the file's name below it, as HTML on one line.
///
/// # Errors
/// No file or no item is named, there is none of this name, or there are several.
pub(super) fn code(rest: &str, project: &Project) -> Result<String, String> {
    let rest = rest.trim();
    let (named, with_docs) = match rest.strip_suffix(" doc") {
        Some(named) => (named.trim(), true),
        None => (rest, false),
    };
    if named.is_empty() {
        return Err(
            "no file is named\n  as in {{#raystep-code lessons/04-sphere/solution.rs:roots}}"
                .into(),
        );
    }
    let (path, item) = match named.split_once(':') {
        Some((path, item)) => (path, Some(item.trim())),
        None => (named, None),
    };
    let text = read(&project.file(path)?, path)?;
    let ending = Path::new(path)
        .extension()
        .unwrap_or_default()
        .to_string_lossy();
    let language = language(&ending);
    let shown = match (item, language) {
        (None, _) => text.trim_end().to_owned(),
        (Some(item), "rust") => rust::item(&text, item, with_docs)?,
        (Some(item), "json") => json::item(&text, item)?,
        (Some(item), _) => marked::item(&text, item)?,
    };
    if with_docs && language != "rust" {
        return Err("doc is for Rust alone\n  omit it".into());
    }
    // no button that sends it to another host
    let class = if language == "rust" {
        "language-rust ignore".into()
    } else {
        format!("language-{language}")
    };
    Ok(format!(
        "<figure class=\"raystep-code\"><pre><code class=\"{class}\">{}</code></pre><figcaption><code>{}</code></figcaption></figure>",
        escaped(&shown),
        escaped(path)
    ))
}

fn read(file: &Path, path: &str) -> Result<String, String> {
    let unreadable =
        |why: String| format!("{} cannot be read: {why}\n  name a text file", quoted(path));
    let meta = fs::metadata(file).map_err(|error| unreadable(error.to_string()))?;
    if LARGEST_FILE < meta.len() {
        return Err(unreadable("it is too large".into()));
    }
    fs::read_to_string(file).map_err(|error| unreadable(error.to_string()))
}

/// The name by which a book's highlighter knows the language of a file.
fn language(ending: &str) -> &'static str {
    match ending {
        "rs" => "rust",
        "json" => "json",
        "py" => "python",
        "c" | "h" => "c",
        "cpp" | "cc" | "hpp" => "cpp",
        "js" | "mjs" => "javascript",
        "ts" => "typescript",
        "java" => "java",
        "jl" => "julia",
        "go" => "go",
        "toml" => "toml",
        "yml" | "yaml" => "yaml",
        "sh" => "bash",
        "md" => "markdown",
        "html" | "svg" | "xml" => "xml",
        "css" => "css",
        _ => "plaintext",
    }
}
