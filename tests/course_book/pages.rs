//! The pages of a built book: where their links lead, and how large they are.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// All files of a book, and of its pages the ids and the links.
pub(super) struct Pages {
    /// Each file with its size, by its path from the book's root.
    files: BTreeMap<String, u64>,
    pages: BTreeMap<String, Page>,
}

struct Page {
    ids: Vec<String>,
    /// Each with its element and its attribute.
    links: Vec<(String, String, String)>,
}

impl Pages {
    pub(super) fn read(root: &Path) -> Self {
        let mut files = BTreeMap::new();
        list(root, "", &mut files);
        let html = files.keys().filter(|file| {
            Path::new(file)
                .extension()
                .is_some_and(|ending| ending == "html")
        });
        let pages = html.map(|file| {
            (
                file.clone(),
                page(&fs::read_to_string(root.join(file)).unwrap()),
            )
        });
        let pages = pages.collect();
        Self { files, pages }
    }

    pub(super) fn count(&self) -> usize {
        self.pages.len()
    }

    pub(super) fn sizes(&self) -> impl Iterator<Item = (&str, u64)> {
        let pages = self
            .files
            .iter()
            .filter(|(file, _)| self.pages.contains_key(*file));
        pages.map(|(file, size)| (file.as_str(), *size))
    }

    pub(super) fn size_of_all(&self) -> u64 {
        self.files.values().sum()
    }

    /// Links that lead nowhere, ids that come twice, and what another host is asked for.
    pub(super) fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        for (file, page) in &self.pages {
            let mut known = BTreeSet::new();
            for id in &page.ids {
                if !known.insert(id) {
                    faults.push(format!("{file}: the id {id} comes twice"));
                }
            }
            // it lies at every address, and names its files from the root of the host
            if file == "404.html" {
                continue;
            }
            for (element, attribute, link) in &page.links {
                if let Some(fault) = self.fault(file, element, attribute, link) {
                    faults.push(format!("{file}: <{element} {attribute}={link:?}>: {fault}"));
                }
            }
        }
        faults
    }

    fn fault(&self, file: &str, element: &str, attribute: &str, link: &str) -> Option<String> {
        if link.starts_with("data:") || link.starts_with("mailto:") {
            return None;
        }
        if link.contains("://") || link.starts_with("//") {
            // a reader may follow a link; a page asks for nothing
            let is_link = element == "a" && attribute == "href";
            return (!is_link).then(|| "another host is asked".into());
        }
        let (path, fragment) = link.split_once('#').unwrap_or((link, ""));
        let path = path.split('?').next().unwrap_or_default();
        let target = if path.is_empty() {
            file.into()
        } else {
            joined(file, path)
        };
        let target = if target.is_empty() || target.ends_with('/') {
            format!("{target}index.html")
        } else {
            target
        };
        if !self.files.contains_key(&target) {
            return Some(format!("there is no {target}"));
        }
        let of_page = self.pages.get(&target);
        let has = |page: &Page| page.ids.iter().any(|id| *id == decoded(fragment));
        (!fragment.is_empty() && !of_page.is_some_and(has))
            .then(|| format!("{target} has no such id"))
    }
}

/// A path from the folder of a file, from the root.
fn joined(file: &str, path: &str) -> String {
    let mut parts: Vec<&str> = file.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    decoded(&parts.join("/"))
}

/// An address without its escapes.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let Some((&byte, behind)) = rest.split_first() {
        let code = behind
            .get(..2)
            .and_then(|digits| std::str::from_utf8(digits).ok());
        match code.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(code) if byte == b'%' => {
                bytes.push(code);
                rest = &behind[2..];
            }
            _ => {
                bytes.push(byte);
                rest = behind;
            }
        }
    }
    String::from_utf8(bytes).unwrap()
}

fn list(root: &Path, below: &str, files: &mut BTreeMap<String, u64>) {
    for entry in fs::read_dir(root.join(below)).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let path = if below.is_empty() {
            name
        } else {
            format!("{below}/{name}")
        };
        if entry.path().is_dir() {
            list(root, &path, files);
        } else {
            files.insert(path, entry.metadata().unwrap().len());
        }
    }
}

/// The ids and the links of a page.
fn page(html: &str) -> Page {
    let (mut ids, mut links) = (Vec::new(), Vec::new());
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        if let Some(comment) = rest.strip_prefix("!--") {
            rest = comment.split_once("-->").map_or("", |(_, behind)| behind);
            continue;
        }
        let end = tag_end(rest);
        let tag = &rest[..end];
        rest = &rest[end..];
        let name: String = tag
            .chars()
            .take_while(|c| c.is_alphanumeric() || *c == '-')
            .collect();
        for (attribute, value) in attributes(&tag[name.len()..]) {
            match attribute.as_str() {
                "id" => ids.push(value),
                "href" | "src" | "xlink:href" | "srcset" | "poster" => {
                    links.push((name.clone(), attribute, value));
                }
                _ => {}
            }
        }
        // what is in a script or a style is no markup
        if name == "script" || name == "style" {
            let close = format!("</{name}");
            rest = rest.find(&close).map_or("", |at| &rest[at..]);
        }
    }
    Page { ids, links }
}

/// Where a tag ends, outside of the values of its attributes.
fn tag_end(rest: &str) -> usize {
    let mut quote = None;
    for (at, c) in rest.char_indices() {
        match (quote, c) {
            (None, '>') => return at,
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if c == open => quote = None,
            _ => {}
        }
    }
    rest.len()
}

fn attributes(tag: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut rest = tag;
    while let Some((before, behind)) = rest.split_once('=') {
        let name = before
            .split_whitespace()
            .next_back()
            .unwrap_or_default()
            .to_owned();
        let behind = behind.trim_start();
        let (value, next) = match behind.chars().next() {
            Some(quote @ ('"' | '\'')) => {
                behind[1..].split_once(quote).unwrap_or((&behind[1..], ""))
            }
            _ => behind
                .split_once(char::is_whitespace)
                .unwrap_or((behind, "")),
        };
        found.push((name, value.replace("&amp;", "&")));
        rest = next;
    }
    found
}
