//! An item of a Rust source by its name: `Sphere`, `Sphere::test`, `<Sphere as Display>::fmt`, `impl Display for Sphere`.
//!
//! The scanner knows tokens, matching brackets and the words that begin items. A crate that parses all of Rust would do
//! more than is asked for, and would be compiled by everybody who builds the command.

use std::ops::Range;

use crate::book::code::text::{dedented, others};
use crate::book::code::tokens::{Is, Token, tokens};
use crate::scene::quoted;

/// An item of a source.
#[derive(Clone, Debug)]
struct Item {
    /// The names by which it can be asked for.
    names: Vec<String>,
    /// Where it stands, with its attributes and its doc comment.
    range: Range<usize>,
}

/// The text of an item, with its attributes, and with its doc comment if that is wanted.
///
/// # Errors
/// There is no such item, or several.
pub(super) fn item(text: &str, name: &str, with_docs: bool) -> Result<String, String> {
    let wanted = spaced(name);
    let all = items(text);
    let found: Vec<&Item> = all
        .iter()
        .filter(|item| item.names.contains(&wanted))
        .collect();
    let line_of = |item: &Item| text[..item.range.start].matches('\n').count() + 1;
    match found[..] {
        [item] => Ok(shown(text, item, with_docs)),
        [] => {
            let names: Vec<String> = all
                .iter()
                .filter_map(|item| item.names.first().cloned())
                .collect();
            Err(format!(
                "there is no item {}\n  {}",
                quoted(&wanted),
                others(&wanted, &names)
            ))
        }
        _ => {
            let places = found.iter().map(|item| {
                let more = item.names.last().map_or("", String::as_str);
                format!("line {} ({more})", line_of(item))
            });
            Err(format!(
                "there are {} items {}: {}\n  name one as it is written in brackets",
                found.len(),
                quoted(&wanted),
                places.collect::<Vec<_>>().join(", ")
            ))
        }
    }
}

fn shown(text: &str, item: &Item, with_docs: bool) -> String {
    let line = text[..item.range.start].rfind('\n').map_or(0, |at| at + 1);
    let before = &text[line..item.range.start];
    let indentation = if before.trim().is_empty() {
        before.len()
    } else {
        0
    };
    let source = &text[item.range.clone()];
    let all = tokens(source);
    // those before the item, not those of its parts
    let (mut without, mut copied, mut at) = (String::new(), 0, 0);
    while let Some(next) = decoration(&all, at) {
        let Token { is, range } = &all[at];
        if *is == Is::Doc && !with_docs {
            without.push_str(&source[copied..range.start]);
            copied = source.len() - source[range.end..].trim_start().len();
        }
        at = next;
    }
    without.push_str(&source[copied..]);
    dedented(&without, indentation)
}

/// The place behind the doc comment or the attribute that stands here, if one does.
fn decoration(all: &[Token], at: usize) -> Option<usize> {
    match all.get(at)?.is {
        Is::Doc => Some(at + 1),
        Is::Mark(b'#') if mark(all, at + 1) == Some(b'[') => Some(closed(all, at + 1)),
        _ => None,
    }
}

/// All items of a source, those in modules, traits and impls too.
fn items(text: &str) -> Vec<Item> {
    let all = tokens(text);
    let mut found = Vec::new();
    Scan { text, all: &all }.items(0..all.len(), "", &[], &mut found);
    found
}

struct Scan<'a> {
    text: &'a str,
    all: &'a [Token],
}

impl<'a> Scan<'a> {
    /// The items between two tokens; their names begin with those of what is around them.
    fn items(&self, range: Range<usize>, module: &str, of: &[String], found: &mut Vec<Item>) {
        let mut at = range.start;
        while at < range.end {
            // an attribute of what is around
            if mark(self.all, at) == Some(b'#') && mark(self.all, at + 1) == Some(b'!') {
                at = closed(self.all, at + 2);
                continue;
            }
            let start = at;
            while let Some(next) = decoration(self.all, at) {
                at = next;
            }
            at = self
                .item(start, at.max(start), module, of, found)
                .max(at + 1);
        }
    }

    /// The item whose first word stands at `at`; `start` is where its doc comments and attributes begin.
    fn item(
        &self,
        start: usize,
        mut at: usize,
        module: &str,
        of: &[String],
        found: &mut Vec<Item>,
    ) -> usize {
        // pub, pub(crate), unsafe, async, const fn, extern "C" fn, default
        loop {
            let next = self.word(at + 1);
            match self.word(at) {
                "pub" if mark(self.all, at + 1) == Some(b'(') => at = closed(self.all, at + 1),
                "pub" | "unsafe" | "async" | "default" | "safe" => at += 1,
                "const" if matches!(next, "fn" | "unsafe" | "async" | "extern") => at += 1,
                "extern"
                    if self
                        .all
                        .get(at + 1)
                        .is_some_and(|token| token.is == Is::Text) =>
                {
                    at += 2;
                }
                "extern" if next == "fn" => at += 1,
                _ => break,
            }
        }
        let name = self.word(at + 1);
        match self.word(at) {
            "fn" | "struct" | "enum" | "union" | "trait" if !name.is_empty() => {
                let (end, body) = self.to_block(at);
                let names = Self::names(module, of, name);
                if self.word(at) == "trait" {
                    let around = [format!("{module}{name}")];
                    self.members(body, module, &around, found);
                }
                self.push(names, start, end, found);
                end
            }
            "mod" if !name.is_empty() => {
                let (end, body) = self.to_block(at);
                let inner = format!("{module}{name}::");
                self.members(body, &inner, &[], found);
                self.push(vec![format!("{module}{name}")], start, end, found);
                end
            }
            "impl" => {
                let (end, body) = self.to_block(at);
                let head_end = body.as_ref().map_or(end, |body| body.start - 1);
                let head = Head::read(self, at + 1..head_end);
                self.members(body, module, &head.prefixes(module), found);
                self.push(vec![head.name(module)], start, end, found);
                end
            }
            "const" | "static" | "type" => {
                let end = self.to_semicolon(at);
                let name = if name == "mut" {
                    self.word(at + 2)
                } else {
                    name
                };
                self.push(Self::names(module, of, name), start, end, found);
                end
            }
            "use" | "extern" | "let" => self.to_semicolon(at),
            "macro_rules" => {
                let name = self.word(at + 2);
                let end = self.to_call_end(at + 3);
                self.push(vec![format!("{module}{name}")], start, end, found);
                end
            }
            "" => at,
            // a call of a macro
            _ if mark(self.all, at + 1) == Some(b'!') => self.to_call_end(at + 2),
            _ => at,
        }
    }

    fn members(
        &self,
        body: Option<Range<usize>>,
        module: &str,
        of: &[String],
        found: &mut Vec<Item>,
    ) {
        if let Some(body) = body {
            self.items(body, module, of, found);
        }
    }

    /// The names of an item in an impl or a trait, or else in a module.
    fn names(module: &str, of: &[String], name: &str) -> Vec<String> {
        if of.is_empty() {
            return vec![format!("{module}{name}")];
        }
        of.iter()
            .map(|around| format!("{around}::{name}"))
            .collect()
    }

    fn push(&self, names: Vec<String>, start: usize, end: usize, found: &mut Vec<Item>) {
        let last = &self.all[end.clamp(start + 1, self.all.len()) - 1];
        found.push(Item {
            names,
            range: self.all[start].range.start..last.range.end,
        });
    }

    /// The word at a place; empty where there is none.
    fn word(&self, at: usize) -> &'a str {
        match self.all.get(at) {
            Some(Token {
                is: Is::Word,
                range,
            }) => &self.text[range.clone()],
            _ => "",
        }
    }

    /// The end of an item that ends with a block or a semicolon, and what stands in its block.
    fn to_block(&self, mut at: usize) -> (usize, Option<Range<usize>>) {
        while at < self.all.len() {
            match mark(self.all, at) {
                Some(b'{') => {
                    let end = closed(self.all, at);
                    return (end, Some(at + 1..end - 1));
                }
                Some(b'(' | b'[') => at = closed(self.all, at),
                Some(b';') => return (at + 1, None),
                _ => at += 1,
            }
        }
        (at, None)
    }

    fn to_semicolon(&self, mut at: usize) -> usize {
        while at < self.all.len() {
            match mark(self.all, at) {
                Some(b'{' | b'(' | b'[') => at = closed(self.all, at),
                Some(b';') => return at + 1,
                _ => at += 1,
            }
        }
        at
    }

    /// The end of a macro's brackets, and of the semicolon behind them.
    fn to_call_end(&self, mut at: usize) -> usize {
        while at < self.all.len() && !matches!(mark(self.all, at), Some(b'{' | b'(' | b'[')) {
            at += 1;
        }
        let end = closed(self.all, at);
        end + usize::from(mark(self.all, end) == Some(b';'))
    }
}

/// What an impl is of.
struct Head {
    of: String,
    of_trait: Option<String>,
}

impl Head {
    /// Reads `<T> Trait<X> for Type<T> where …`.
    fn read(scan: &Scan, range: Range<usize>) -> Self {
        let mut at = range.start;
        if mark(scan.all, at) == Some(b'<') {
            at = angles(scan.all, at, range.end);
        }
        let (mut of_trait, mut name) = (None, String::new());
        while at < range.end {
            match (scan.word(at), mark(scan.all, at)) {
                (_, Some(b'<')) => {
                    at = angles(scan.all, at, range.end);
                    continue;
                }
                ("for", _) => of_trait = Some(std::mem::take(&mut name)),
                ("where", _) => break,
                // the last name of a path
                (word, _) if !word.is_empty() && !word.starts_with('\'') => name = word.into(),
                _ => {}
            }
            at += 1;
        }
        Self { of: name, of_trait }
    }

    /// With what the names of its items begin.
    fn prefixes(&self, module: &str) -> Vec<String> {
        let plain = format!("{module}{}", self.of);
        let full = self.of_trait.as_ref();
        let full = full.map(|of_trait| format!("<{module}{} as {of_trait}>", self.of));
        std::iter::once(plain).chain(full).collect()
    }

    fn name(&self, module: &str) -> String {
        match &self.of_trait {
            Some(of_trait) => format!("{module}impl {of_trait} for {}", self.of),
            None => format!("{module}impl {}", self.of),
        }
    }
}

fn mark(all: &[Token], at: usize) -> Option<u8> {
    match all.get(at)?.is {
        Is::Mark(mark) => Some(mark),
        _ => None,
    }
}

/// The place behind the bracket that closes the one here.
fn closed(all: &[Token], start: usize) -> usize {
    let mut depth = 0_usize;
    for at in start..all.len() {
        match mark(all, at) {
            Some(b'{' | b'(' | b'[') => depth += 1,
            Some(b'}' | b')' | b']') => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
    }
    all.len()
}

/// The place behind the `>` that closes the `<` here; `->` closes nothing.
fn angles(all: &[Token], start: usize, end: usize) -> usize {
    let mut depth = 0_usize;
    for at in start..end {
        match mark(all, at) {
            Some(b'<') => depth += 1,
            Some(b'>') if mark(all, at.wrapping_sub(1)) != Some(b'-') => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
    }
    end
}

/// A name with one space where it has several.
fn spaced(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"//! Module doc with fn nothing() {}.
#![allow(x)]
use a::{b, c};

/// A sphere.
#[derive(Clone)]
pub struct Sphere {
    /// Its radius.
    pub r: f64,
}

pub(crate) struct Pair(u8, [u8; { 2 }]);

const BRACE: &str = "}"; // }

impl Sphere {
    /// Tests.
    #[must_use]
    /// Twice.
    pub fn test<'a, F: Fn(u8) -> u8>(&'a self, f: F) -> Option<u8> {
        // fn inner() {
        let c = '{';
        Some(f(c as u8))
    }

    const N: usize = { 3 };
}

impl<T: Into<f64>> From<T> for Sphere where T: Copy {
    fn from(t: T) -> Self { Self { r: t.into() } }
}

impl fmt::Display for Sphere {
    fn fmt(&self) {}
}

impl fmt::Debug for Sphere {
    fn fmt(&self) {}
}

trait Shape { fn area(&self) -> f64 { 0.0 } fn name(&self); }

macro_rules! table { ($a:ident) => { fn $a() {} }; }
table! { x }

pub const fn one() -> u8 { 1 }
pub unsafe extern "C" fn two() {}

mod tests {
    fn one() {}
}
"#;

    #[test]
    fn an_item_is_shown_as_it_stands_without_its_doc_comment() {
        let show = |name| item(TEXT, name, false).unwrap();
        assert_eq!(
            show("Sphere"),
            "#[derive(Clone)]\npub struct Sphere {\n    /// Its radius.\n    pub r: f64,\n}"
        );
        assert_eq!(
            show("Sphere::test"),
            "#[must_use]\npub fn test<'a, F: Fn(u8) -> u8>(&'a self, f: F) -> Option<u8> {\n    \
             // fn inner() {\n    let c = '{';\n    Some(f(c as u8))\n}"
        );
        assert_eq!(show("Pair"), "pub(crate) struct Pair(u8, [u8; { 2 }]);");
        assert_eq!(show("BRACE"), "const BRACE: &str = \"}\";");
        assert_eq!(show("Sphere::N"), "const N: usize = { 3 };");
        assert_eq!(show("one"), "pub const fn one() -> u8 { 1 }");
        assert_eq!(show("two"), "pub unsafe extern \"C\" fn two() {}");
        assert_eq!(show("tests::one"), "fn one() {}");
        assert_eq!(show("Shape::area"), "fn area(&self) -> f64 { 0.0 }");
        assert_eq!(show("Shape::name"), "fn name(&self);");
        assert_eq!(
            show("table"),
            "macro_rules! table { ($a:ident) => { fn $a() {} }; }"
        );
        assert!(
            show("impl From for Sphere").starts_with("impl<T: Into<f64>> From<T> for Sphere where")
        );
        assert!(show("impl Sphere").contains("const N"));
    }

    #[test]
    fn with_its_doc_comment_if_that_is_wanted() {
        let show = |name| item(TEXT, name, true).unwrap();
        assert!(show("Sphere").starts_with("/// A sphere.\n#[derive(Clone)]\n"));
        assert!(
            show("Sphere::test").starts_with("/// Tests.\n#[must_use]\n/// Twice.\npub fn test")
        );
    }

    #[test]
    fn an_item_that_is_missing_or_there_twice_is_told() {
        let told = item(TEXT, "Sphere::tset", false).unwrap_err();
        assert!(told.contains("did you mean Sphere::test?"), "{told}");
        let told = item(TEXT, "nothing", false).unwrap_err();
        assert!(
            told.contains("there is no item \"nothing\"\n  it has "),
            "{told}"
        );
        let told = item(TEXT, "Sphere::fmt", false).unwrap_err();
        assert!(
            told.contains("there are 2 items")
                && told.contains("line 34 (<Sphere as Display>::fmt)"),
            "{told}"
        );
        assert_eq!(
            item(TEXT, "<Sphere as Debug>::fmt", false).unwrap(),
            "fn fmt(&self) {}"
        );
    }

    #[test]
    fn broken_source_ends() {
        for text in [
            "fn",
            "impl",
            "pub(",
            "mod a {",
            "#[",
            "macro_rules!",
            "impl<T",
            "struct A",
            "}}} fn a() {}",
        ] {
            let _ = items(text);
        }
        assert_eq!(items("}}} fn a() {}").len(), 1);
    }
}
