//! The page with all chapters holds what goes to paper, and nothing else: a course has some hundred drawings and steppers, and
//! with them all in one file it is no page that a browser opens gladly.
//!
//! - Drawings become files beside the page.
//! - Scripts, and the data that they read, are left out: on paper nothing is pressed.
//! - A style that several chapters bring stays once.
//! - An answer that is folded away, and stands in the appendix, becomes the link to it. Others are unfolded.

use std::collections::BTreeSet;
use std::ops::Range;

/// Where drawings go, seen from the page.
const FOLDER: &str = "print";

/// The page with all chapters, and the drawings that it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintPage {
    /// The page.
    pub html: String,
    /// The drawings, SVG: each with its path from the folder of the page.
    pub drawings: Vec<(String, String)>,
}

impl PrintPage {
    /// The page for paper, from the one that mdBook writes as `print.html`. A page without `<main>` stays as it is.
    #[must_use]
    pub fn of(page: &str) -> Self {
        let mut light = Self {
            html: page.into(),
            drawings: Vec::new(),
        };
        let Some(main) = elements(page, "main").into_iter().next() else {
            return light;
        };
        // a script may speak of elements, and a drawing has a style of its own
        let html = replaced(&page[main.clone()], "script", |_| Some(String::new()));
        let html = replaced(&html, "svg", |svg| light.drawing(svg));
        let html = replaced(&html, "details", unfolded);
        let mut styles = BTreeSet::new();
        let html = replaced(&html, "style", |style| {
            (!styles.insert(style.to_owned())).then(String::new)
        });
        light.html.replace_range(main, &html);
        light
    }

    /// A drawing of raystep becomes a file, and this shows it.
    fn drawing(&mut self, svg: &str) -> Option<String> {
        let tag = &svg[..svg.find('>')?];
        let id = attribute(tag, "id").filter(|id| id.starts_with("raystep-"))?;
        let (width, height) = (attribute(tag, "width")?, attribute(tag, "height")?);
        let words = ["title", "desc"].map(|name| text_of(svg, name));
        let [title, description] = words.map(Option::unwrap_or_default);
        let path = format!("{FOLDER}/{id}.svg");
        self.drawings.push((path.clone(), with_capitals(svg)));
        Some(format!(
            "<img id=\"{id}\" src=\"{path}\" alt=\"{title}. {description}\" width=\"{width}\" height=\"{height}\" \
             style=\"max-width: 100%; height: auto\">"
        ))
    }
}

/// An answer that stands in the appendix too becomes the link to it; what stands nowhere else is unfolded.
fn unfolded(details: &str) -> Option<String> {
    // what an author folds away may speak of an answer too
    let is_answer = details.starts_with("<details><summary>Answer</summary>");
    let link = details.rfind("<a href=\"#raystep-answer-");
    let Some(link) = link.filter(|_| is_answer) else {
        return Some(details.replacen("<details>", "<details open>", 1));
    };
    let target = details[link..].split('"').nth(1)?;
    Some(format!("<p><a href=\"{target}\">Answer</a></p>"))
}

/// SVG within HTML may have its attributes in small letters; as a file it may not.
fn with_capitals(svg: &str) -> String {
    /// Those of raystep's drawings that have capitals.
    const NAMES: [&str; 2] = ["viewBox", "preserveAspectRatio"];
    NAMES.iter().fold(svg.to_owned(), |svg, name| {
        svg.replace(
            &format!(" {}=\"", name.to_lowercase()),
            &format!(" {name}=\""),
        )
    })
}

/// What an attribute of a tag says, as it is written.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
    rest.split('"').next()
}

/// The text of the first element of this name, for an attribute.
fn text_of(svg: &str, name: &str) -> Option<String> {
    let element = elements(svg, name).into_iter().next()?;
    let inside = svg[element].split_once('>')?.1.rsplit_once("</")?.0;
    Some(inside.replace('"', "&quot;"))
}

/// The elements of this name, from the first letter of their tag to the last of their end: the outermost.
fn elements(html: &str, name: &str) -> Vec<Range<usize>> {
    let [open, close] = [format!("<{name}"), format!("</{name}>")];
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(begin) = html[from..].find(&open).map(|at| from + at) {
        let behind = begin + open.len();
        from = behind;
        let is_it = html[behind..].starts_with(|of: char| of == '>' || of.is_ascii_whitespace());
        if !is_it {
            continue;
        }
        let Some(end) = html[behind..]
            .find(&close)
            .map(|at| behind + at + close.len())
        else {
            break;
        };
        found.push(begin..end);
        from = end;
    }
    found
}

/// Elements of this name with something else in their place; `None` leaves one as it is.
fn replaced(html: &str, name: &str, mut with: impl FnMut(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(html.len());
    let mut from = 0;
    for element in elements(html, name) {
        out.push_str(&html[from..element.start]);
        let old = &html[element.clone()];
        out.push_str(&with(old).unwrap_or_else(|| old.into()));
        from = element.end;
    }
    out.push_str(&html[from..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_become_files_and_what_is_pressed_is_left_out() {
        let drawing = "<svg id=\"raystep-a-b\" viewbox=\"0 0 4 3\" width=\"4\" height=\"3\"> <title id=\"t\">A \"ball\"</title> \
                       <desc>The ray &lt; the ball.</desc> <style>.x { fill: red }</style> </svg>";
        let page = format!(
            "<style>.site {{}}</style><script>a()</script><main><style>.s {{}}</style><p>1</p>{drawing}\
             <style>.s {{}}</style><svg viewBox=\"0 0 1 1\"></svg>\
             <script>b(\"<svg>\")</script><details><summary>Answer</summary><p>d</p>\
             <a href=\"#raystep-answer-a-b\">All answers</a></details><details>see <a href=\"#raystep-answer-a-b\">d</a></details></main><script>print()</script>"
        );
        let light = PrintPage::of(&page);
        assert_eq!(
            light.html,
            "<style>.site {}</style><script>a()</script><main><style>.s {}</style><p>1</p>\
             <img id=\"raystep-a-b\" src=\"print/raystep-a-b.svg\" alt=\"A &quot;ball&quot;. The ray &lt; the ball.\" \
             width=\"4\" height=\"3\" style=\"max-width: 100%; height: auto\">\
             <svg viewBox=\"0 0 1 1\"></svg>\
             <p><a href=\"#raystep-answer-a-b\">Answer</a></p><details open>see <a href=\"#raystep-answer-a-b\">d</a></details></main><script>print()</script>"
        );
        let [(file, svg)] = light.drawings.as_slice() else {
            panic!("{:?}", light.drawings);
        };
        assert_eq!(file, "print/raystep-a-b.svg");
        assert_eq!(*svg, drawing.replace("viewbox", "viewBox"));
    }

    #[test]
    fn a_page_without_chapters_stays_as_it_is() {
        let page = "<p>no main</p><svg id=\"raystep-x\"></svg>";
        assert_eq!(PrintPage::of(page).html, page);
        assert_eq!(elements("<mainly></mainly><main>", "main"), []);
    }
}
