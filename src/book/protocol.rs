//! What mdBook hands to a preprocessor, and takes back: two JSON values, `[context, book]`.
//!
//! Of the context three keys are read. A book is a tree of items; only the texts of chapters are changed, and
//! all else goes back as it came, whatever it is.

use std::path::PathBuf;

use serde::Deserialize;
use serde_json::Value;

/// The version of mdBook whose protocol this is.
pub(super) const MDBOOK_VERSION: &str = "0.5.4";

/// Where the book is, and how it is to be made.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Context {
    /// The folder of `book.toml`.
    pub(super) root: PathBuf,
    /// `book.toml`.
    #[serde(default)]
    pub(super) config: Value,
    /// The version of mdBook that calls.
    pub(super) mdbook_version: String,
}

/// A book: its `items`, and whatever else mdBook says of it.
#[derive(Clone, Debug)]
pub(super) struct Book(Value);

/// A chapter of a book, without those below it.
pub(super) struct Chapter<'a> {
    /// Its file, counted from the book's source folder; its name where it has no file.
    pub(super) file: String,
    /// Its text, in Markdown.
    pub(super) content: &'a mut String,
}

/// Reads what mdBook hands over.
///
/// # Errors
/// What is wrong with it.
pub(super) fn parse(json: &[u8]) -> Result<(Context, Book), String> {
    let (context, book): (Context, Value) =
        serde_json::from_slice(json).map_err(|error| error.to_string())?;
    let mut book = Book(book);
    // every chapter is looked at, so that later nothing is missing
    let mut faults = Vec::new();
    book.walk(&mut |chapter| {
        if let Err(fault) = chapter {
            faults.push(fault);
        }
    });
    faults.into_iter().next().map_or(Ok((context, book)), Err)
}

impl Book {
    /// Does something with each chapter, those below it after it.
    pub(super) fn for_each_chapter(&mut self, work: &mut dyn FnMut(Chapter<'_>)) {
        self.walk(&mut |chapter| {
            if let Ok(chapter) = chapter {
                work(chapter);
            }
        });
    }

    /// The book as mdBook reads it.
    pub(super) fn json(&self) -> String {
        self.0.to_string()
    }

    fn walk(&mut self, work: &mut dyn FnMut(Result<Chapter<'_>, String>)) {
        walk(&mut self.0, "items", "items", work);
    }
}

/// Visits the chapters of the list of items that a value has below a key: `"Separator"`, `{"PartTitle": …}` or
/// `{"Chapter": …}`.
fn walk(
    around: &mut Value,
    key: &str,
    path: &str,
    work: &mut dyn FnMut(Result<Chapter<'_>, String>),
) {
    let Some(Value::Array(items)) = around.get_mut(key) else {
        work(Err(format!("the book has no list {path}")));
        return;
    };
    for (i, item) in items.iter_mut().enumerate() {
        let Some(chapter) = item.get_mut("Chapter") else {
            continue;
        };
        let path = format!("{path}[{i}].Chapter");
        let file = file_of(chapter);
        match chapter.get_mut("content") {
            Some(Value::String(content)) => work(Ok(Chapter { file, content })),
            _ => work(Err(format!("{path}.content is no text"))),
        }
        walk(chapter, "sub_items", &format!("{path}.sub_items"), work);
    }
}

/// Where a chapter comes from: `source_path`, else `path`, else its name.
fn file_of(chapter: &Value) -> String {
    let text = |key| chapter.get(key).and_then(Value::as_str);
    let file = ["source_path", "path", "name"].into_iter().find_map(text);
    file.unwrap_or_default().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOOK: &str = r#"[{"root":"/b","config":{},"mdbook_version":"0.5.1","renderer":"html"},
        {"items":["Separator",{"PartTitle":"I"},{"Chapter":{"name":"A","content":"a","number":null,"path":"a.md",
        "sub_items":[{"Chapter":{"name":"B","content":"b","sub_items":[]}}],"new_key":7}}],"more":1}]"#;

    #[test]
    fn chapters_come_in_reading_order_and_all_else_goes_back_as_it_came() {
        let (context, mut book) = parse(BOOK.as_bytes()).unwrap();
        assert_eq!(context.mdbook_version, "0.5.1");
        let mut seen = Vec::new();
        book.for_each_chapter(&mut |chapter| {
            seen.push(format!("{} {}", chapter.file, chapter.content));
            chapter.content.push('!');
        });
        assert_eq!(seen, ["a.md a", "B b"]);
        let back: Value = serde_json::from_str(&book.json()).unwrap();
        let chapter = &back["items"][2]["Chapter"];
        assert_eq!(chapter["content"], "a!");
        assert_eq!(chapter["sub_items"][0]["Chapter"]["content"], "b!");
        assert_eq!((&chapter["new_key"], &back["more"]), (&7.into(), &1.into()));
    }

    #[test]
    fn a_book_without_its_parts_is_refused_with_their_path() {
        for (from, to, says) in [
            (r#""items""#, r#""sections""#, "the book has no list items"),
            (
                r#""content":"b","#,
                "",
                "items[2].Chapter.sub_items[0].Chapter.content is no text",
            ),
            (
                r#","sub_items":[]"#,
                "",
                "the book has no list items[2].Chapter.sub_items[0].Chapter.sub_items",
            ),
            (
                r#""root":"/b","#,
                "",
                "missing field `root` at line 1 column 57",
            ),
        ] {
            assert_eq!(
                parse(BOOK.replacen(from, to, 1).as_bytes()).unwrap_err(),
                says
            );
        }
    }
}
