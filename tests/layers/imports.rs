//! Which file imports from which: an import counts to the file that defines the item, however it was re-exported.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The modules of a crate: their files, and what these say.
pub(crate) struct Modules {
    by_path: BTreeMap<Vec<String>, Module>,
}

struct Module {
    file: String,
    /// Without its tests and without comments.
    text: String,
    /// Each re-exported name, and the path that it stands for.
    reexports: Vec<(String, Vec<String>)>,
}

impl Modules {
    /// All modules below `src/`, but for those of a program.
    pub(crate) fn of_library(src: &Path) -> Self {
        let mut by_path = BTreeMap::new();
        for path in super::sources(src) {
            let relative = path.strip_prefix(src).unwrap();
            let mut names: Vec<String> = relative
                .with_extension("")
                .iter()
                .map(|part| part.to_str().unwrap().to_owned())
                .collect();
            if names[0] == "cli" || names[0] == "main" {
                continue;
            }
            if names
                .last()
                .is_some_and(|last| last == "mod" || last == "lib")
            {
                names.pop();
            }
            let text = program(&fs::read_to_string(&path).unwrap());
            let mut reexports = Vec::new();
            for (is_public, import) in imports(&text) {
                let (alias, target) = renamed(&import);
                if is_public {
                    reexports.push((alias, absolute(&target, &names)));
                }
            }
            let file = relative.to_str().unwrap().replace('\\', "/");
            let module = Module {
                file,
                text,
                reexports,
            };
            by_path.insert(names, module);
        }
        Self { by_path }
    }

    /// Each file with the files of the same crate that it imports from.
    pub(crate) fn arrows(&self) -> BTreeMap<String, BTreeSet<String>> {
        let mut arrows = BTreeMap::new();
        for (names, module) in &self.by_path {
            let mut used = BTreeSet::new();
            for (is_public, import) in imports(&module.text) {
                if !is_public {
                    used.extend(self.file_of(&absolute(&renamed(&import).1, names)));
                }
            }
            for path in inline(&module.text) {
                used.extend(self.file_of(&absolute(&path, names)));
            }
            used.remove(&module.file);
            arrows.insert(module.file.clone(), used);
        }
        arrows
    }

    /// The file that defines what a path names; `None` for what another crate defines.
    fn file_of(&self, path: &[String]) -> Option<String> {
        // the longest module on the way
        let (first, rest) = path.split_first()?;
        if first != "crate" {
            return None;
        }
        let mut at: Vec<String> = Vec::new();
        for (i, name) in rest.iter().enumerate() {
            let mut below = at.clone();
            below.push(name.clone());
            if self.by_path.contains_key(&below) {
                at = below;
                continue;
            }
            let module = &self.by_path[&at];
            let reexport = module.reexports.iter().find(|(alias, _)| alias == name);
            // a macro is handed on from its own file
            let Some((_, target)) = reexport.filter(|(_, target)| target != path) else {
                return Some(module.file.clone());
            };
            let mut target = target.clone();
            target.extend(rest[i + 1..].iter().cloned());
            return self.file_of(&target);
        }
        Some(self.by_path[&at].file.clone())
    }
}

/// A circle of files that import from each other, if there is one.
pub(crate) fn circle(arrows: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    let mut done = BTreeSet::new();
    for start in arrows.keys() {
        let mut way = Vec::new();
        if let Some(circle) = visit(start, arrows, &mut way, &mut done) {
            return Some(circle);
        }
    }
    None
}

fn visit<'a>(
    file: &'a String,
    arrows: &'a BTreeMap<String, BTreeSet<String>>,
    way: &mut Vec<&'a String>,
    done: &mut BTreeSet<&'a String>,
) -> Option<Vec<String>> {
    if let Some(place) = way.iter().position(|on_way| *on_way == file) {
        return Some(way[place..].iter().map(|file| (*file).clone()).collect());
    }
    if done.contains(file) {
        return None;
    }
    way.push(file);
    for used in &arrows[file] {
        if let Some(circle) = visit(used, arrows, way, done) {
            return Some(circle);
        }
    }
    way.pop();
    done.insert(file);
    None
}

/// A source without comments and without its tests.
pub(crate) fn program(text: &str) -> String {
    let starts = [
        "\n#[cfg(test)]\nmod ",
        "\n#[cfg(test)]\npub(super) mod ",
        "\n#[cfg(all(test",
    ];
    let end = starts.iter().filter_map(|start| text.find(start)).min();
    let lines = text[..end.unwrap_or(text.len())].lines();
    let code = lines.map(|line| match line.trim_start() {
        comment if comment.starts_with("//") => "",
        _ => line,
    });
    code.collect::<Vec<_>>().join("\n")
}

/// Each import of a source, with groups taken apart; whether it is a re-export comes before it.
fn imports(text: &str) -> Vec<(bool, String)> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("use ") {
        let before = &rest[..at];
        let line = &before[before.rfind('\n').map_or(0, |end| end + 1)..];
        rest = &rest[at + 4..];
        let is_public = line.trim_start().starts_with("pub");
        if !(is_public || line.trim().is_empty()) {
            continue;
        }
        let end = rest.find(';').unwrap_or(rest.len());
        let statement: String = rest[..end].split_whitespace().collect::<Vec<_>>().join(" ");
        take_apart("", &statement, &mut |import| {
            found.push((is_public, import));
        });
    }
    found
}

/// `a::{b, c::{d, e}}` is `a::b`, `a::c::d` and `a::c::e`.
fn take_apart(start: &str, tree: &str, add: &mut dyn FnMut(String)) {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        if !tree.is_empty() {
            add(format!("{start}{tree}"));
        }
        return;
    };
    let start = format!("{start}{}", &tree[..open]);
    let inside = &tree[open + 1..tree.rfind('}').unwrap()];
    let (mut depth, mut from) = (0, 0);
    for (i, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                take_apart(&start, &inside[from..i], add);
                from = i + 1;
            }
            _ => {}
        }
    }
    take_apart(&start, &inside[from..], add);
}

/// The name that an import has in its file, and its path.
fn renamed(import: &str) -> (String, Vec<String>) {
    let (path, alias) = match import.split_once(" as ") {
        Some((path, alias)) => (path, Some(alias)),
        None => (import, None),
    };
    let mut names: Vec<String> = path
        .split("::")
        .map(|name| name.trim().to_owned())
        .collect();
    if names.last().is_some_and(|last| last == "self") {
        names.pop();
    }
    let alias = alias.map_or_else(|| names.last().cloned().unwrap_or_default(), str::to_owned);
    (alias, names)
}

/// A path from the root of the crate on. A name alone may be a module below.
fn absolute(path: &[String], module: &[String]) -> Vec<String> {
    let from = |around: &[String], rest: &[String]| {
        let root = std::iter::once("crate".to_owned());
        root.chain(around.iter().cloned())
            .chain(rest.iter().cloned())
            .collect()
    };
    match path.first().map(String::as_str) {
        Some("crate") => path.to_vec(),
        Some("super") => from(&module[..module.len() - 1], &path[1..]),
        Some("self") => from(module, &path[1..]),
        Some(name) if ["std", "core"].contains(&name) || super::CRATES.contains(&name) => {
            path.to_vec()
        }
        _ => from(module, path),
    }
}

/// Paths that stand in the code itself: from `crate::` on, or from a module below this one.
fn inline(text: &str) -> Vec<Vec<String>> {
    let known = |c: char| c.is_alphanumeric() || c == '_';
    let modules = text
        .split("mod ")
        .skip(1)
        .filter_map(|rest| rest.split_once(';'));
    let mut starts: Vec<&str> = modules
        .map(|(name, _)| name)
        .filter(|name| name.chars().all(known))
        .collect();
    starts.push("crate");
    let mut paths = Vec::new();
    for start in starts {
        let start = format!("{start}::");
        for (at, _) in text.match_indices(&start) {
            let before = &text[..at];
            let statement = &before[before.rfind([';', '}']).map_or(0, |end| end + 1)..];
            if before.ends_with("(in ")
                || before.ends_with(|c: char| known(c) || c == ':')
                || statement.contains("use ")
            {
                continue;
            }
            let end = text[at..]
                .find(|c: char| !known(c) && c != ':')
                .unwrap_or(text.len() - at);
            let names = text[at..at + end].trim_end_matches(':').split("::");
            paths.push(names.map(str::to_owned).collect());
        }
    }
    paths
}
