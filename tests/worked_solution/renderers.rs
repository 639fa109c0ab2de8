//! The same lines in every medium, and names from a scene file that are text in all of them.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use raystep::explain::render;
use raystep::explain::{Fold, Line, Part, Tone, Unfold};
use raystep::scene::printable;
use raystep::{Page, Settings, WorkedOptions, worked_solution};

use super::light::built;

/// What an unkind author may call a thing: markup of every medium, a terminal's codes, other tools' directives.
const NAMES: [&str; 14] = [
    "<script>alert(1)</script>&amp;<!--",
    "\u{1b}[31mred\u{1b}]0;title\u{7}",
    "`code` ```fence",
    "{{#include secret.md}} {{#raystep x}}",
    "$x^2$ $$y$$ \\(z\\)",
    "**bold** _it_ ~~gone~~ ==x==",
    "[link](http://evil.example) ![i](j) <http://a.b>",
    "www.evil.example https://evil.example a@b.example",
    "1. one",
    "# head | cell |",
    "- item -- --- ...",
    ":smile: [x] [^1] {#id .class}",
    "    indented",
    "\"quoted\" 'so' \u{202e}turned",
];

/// The scene with one name in all the places that have one.
fn page(name: &str) -> Page {
    let name = serde_json::to_string(name).unwrap();
    let scene = built(&format!(
        r#"{{
  "name": {name},
  "camera": {{ "window": {{ "cop": [0, 0, 0], "corner": [-1, -1, 1], "right": [2, 0, 0], "up": [0, 2, 0] }}, "pixels": [1, 1] }},
  "lights": [ {{ "name": {name}, "position": [0, 4, 0], "colour": [1, 1, 1] }} ],
  "materials": {{ {name}: {{ "colour": [0.5, 0.5, 0], "diffuse": 0.5, "reflection": 0.5 }} }},
  "objects": [ {{ "name": {name}, "material": {name}, "shape": {{ "sphere": {{ "center": [0, 0, 5], "radius": 1 }} }} }} ]
}}"#
    ));
    let records = super::records(&scene);
    let options = WorkedOptions::default();
    worked_solution(&scene, &Settings::default(), &records, &options)
}

fn hint(unfold: Unfold) -> String {
    match unfold {
        Unfold::All => "--all shows them".into(),
        Unfold::Ray(ray) => format!("--ray {ray}"),
    }
}

/// The texts of the items of a list in Markdown, each with its depth; nothing else may be in it but bold and italics.
#[track_caller]
fn items(markdown: &str) -> Vec<(usize, String)> {
    let options = Options::all() - Options::ENABLE_SMART_PUNCTUATION;
    let mut items: Vec<(usize, String)> = Vec::new();
    let mut open = Vec::new();
    for event in Parser::new_ext(markdown, options) {
        match event {
            Event::Start(Tag::Item) => {
                items.push((open.len(), String::new()));
                open.push(items.len() - 1);
            }
            Event::End(TagEnd::Item) => {
                open.pop();
            }
            Event::Text(text) => items[*open.last().expect("text in an item")].1 += &text,
            Event::Start(Tag::List(None) | Tag::Paragraph | Tag::Strong | Tag::Emphasis)
            | Event::End(
                TagEnd::List(false) | TagEnd::Paragraph | TagEnd::Strong | TagEnd::Emphasis,
            ) => {}
            other => panic!("{other:?} in\n{markdown}"),
        }
    }
    items
}

/// A line's words as Markdown keeps them: blanks at the beginning are no-break spaces, those at the end are gone.
fn in_markdown(line: &Line) -> String {
    let blanks = line.text.len() - line.text.trim_start_matches(' ').len();
    "\u{a0}".repeat(blanks) + line.text.trim_matches(' ')
}

#[test]
fn names_are_text_in_every_medium() {
    for name in NAMES {
        let page = page(name);
        let shown = printable(name);
        let plain = render::plain(&page, hint);
        // in the title, of the light, of the object, of the material
        assert!(4 <= plain.matches(&shown).count(), "{name:?} in\n{plain}");
        assert!(!plain.contains('\u{1b}') && !plain.contains('\u{202e}'));

        let ansi = render::ansi(&page, hint);
        assert_eq!(anstream::adapter::strip_str(&ansi).to_string(), plain);

        let html = render::html(&page, hint);
        let document = roxmltree::Document::parse(&html).unwrap();
        let root = document.root_element();
        let text: String = root
            .descendants()
            .filter_map(|node| node.text().filter(|_| node.is_text()))
            .collect();
        assert_eq!(text, plain.trim_end_matches('\n'), "{name:?}");
        let known = ["pre", "code", "span"];
        let elements = root.descendants().filter(roxmltree::Node::is_element);
        for element in elements {
            assert!(known.contains(&element.tag_name().name()), "{element:?}");
        }
        assert!(!html.contains(['\n', '{', '}', '$', '`', '\\']), "{html}");

        let markdown = render::markdown(&page, hint);
        let found: Vec<String> = items(&markdown).into_iter().map(|(_, text)| text).collect();
        let lines: Vec<String> = page.lines.iter().map(in_markdown).collect();
        assert_eq!(found, lines, "{name:?}");
        assert!(!markdown.contains("{{"), "{markdown}");
    }
}

#[test]
fn a_document_is_well_formed_and_says_what_each_line_is() {
    let page = page("ball");
    let html = render::html_document(&page, hint);
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..roxmltree::ParsingOptions::default()
    };
    let document = roxmltree::Document::parse_with_options(&html, options).unwrap();
    let title = document
        .descendants()
        .find(|node| node.has_tag_name("title"));
    assert_eq!(title.unwrap().text(), Some("Pixel (0, 0) of \"ball\""));
    let spans: Vec<_> = document
        .descendants()
        // words that are not broken are spans in them
        .filter(|node| node.has_tag_name("span") && node.has_attribute("class"))
        .collect();
    let text_of = |span: &roxmltree::Node| -> String {
        let texts = span.descendants().filter(roxmltree::Node::is_text);
        texts.filter_map(|node| node.text()).collect()
    };
    assert_eq!(spans.len(), page.lines.len());
    for (span, line) in spans.iter().zip(&page.lines) {
        assert_eq!(text_of(span), line.text);
        let ray = line.ray.map(|ray| ray.to_string());
        assert_eq!(span.attribute("data-ray"), ray.as_deref());
        assert_eq!(span.attribute("data-part"), line.part.map(Part::id));
        assert_eq!(span.has_attribute("data-first"), line.steps.is_some());
    }
    let discriminant = spans
        .iter()
        .find(|span| text_of(span).starts_with("discriminant: b² − 4ac"));
    let discriminant = discriminant.unwrap();
    // the pixel, the eye ray, its test
    assert_eq!(discriminant.attribute("data-first"), Some("pixel:2"));
    assert_eq!(discriminant.attribute("data-last"), Some("pixel:2"));
    assert_eq!(discriminant.attribute("data-part"), Some("discriminant"));
    assert_eq!(discriminant.attribute("data-ray"), Some("0"));
}

/// A page by hand: what each renderer makes of a gap, of levels, of tones and of a fold.
#[test]
fn each_renderer_has_the_marks_of_its_medium() {
    let line = |indent, tone, text: &str| Line {
        gap: false,
        indent,
        tone,
        ray: None,
        steps: None,
        part: None,
        text: text.into(),
    };
    let fold = Tone::Folded(Fold {
        hidden: 3,
        shown_by: Unfold::All,
    });
    let mut lines = vec![
        line(0, Tone::Heading, "Ray 0"),
        line(1, Tone::Plain, "a = 1"),
        line(3, Tone::Found, "  = b_c"),
        line(1, fold, "… 3 more"),
        line(0, Tone::Aside, "end"),
    ];
    lines[4].gap = true;
    let page = Page { lines };
    assert_eq!(
        render::plain(&page, hint),
        "Ray 0\n  a = 1\n        = b_c\n  … 3 more (--all shows them)\n\nend\n"
    );
    assert_eq!(
        render::plain(&page, render::no_hint),
        "Ray 0\n  a = 1\n        = b_c\n  … 3 more\n\nend\n"
    );
    assert_eq!(
        render::ansi(&page, hint),
        "\u{1b}[1mRay 0\u{1b}[0m\n  a = 1\n      \u{1b}[32m  = b_c\u{1b}[0m\n  \
         \u{1b}[2m… 3 more (--all shows them)\u{1b}[0m\n\n\u{1b}[2mend\u{1b}[0m\n"
    );
    assert_eq!(
        render::markdown(&page, hint),
        "- **Ray 0**\n  - a = 1\n    - \u{a0}\u{a0}\\= b\\_c\n  - *… 3 more (\\-\\-all shows them)*\n\n- *end*\n"
    );
    // a level that has no line is no level of a list
    let depths: Vec<usize> = items(&render::markdown(&page, hint))
        .iter()
        .map(|(depth, _)| *depth)
        .collect();
    assert_eq!(depths, [0, 1, 2, 1, 0]);
    assert_eq!(
        render::html(&page, hint),
        "<pre class=\"raystep-log\"><code class=\"nohighlight\"><span class=\"heading\">Ray 0</span>&#10;  \
         <span class=\"plain\">a = 1</span>&#10;      <span class=\"found\">  = b_c</span>&#10;  \
         <span class=\"folded\">… 3 more (--all shows them)</span>&#10;&#10;<span class=\"aside\">end</span></code></pre>"
    );
}
