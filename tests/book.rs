//! A book of two chapters, made with mdBook itself and this program as its preprocessor.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use mdbook_driver::MDBook;
use raystep::book::NoCommands;
use roxmltree::Document;
use serde_json::{Value, json};

/// A ball of radius 1 whose centre lies 5 before the eye: the middle ray meets it at t = 4 and t = 6, and
/// with a = 1, b = −10 and c = 24 its discriminant is 100 − 96 = 4.
const SCENE: &str = r#"{
  "name": "one ball",
  "camera": { "look_at": { "cop": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0], "fov_degrees": 40 },
              "pixels": [9, 9] },
  "materials": { "red": { "colour": [0.8, 0.2, 0.2], "diffuse": 0.7 } },
  "objects": [ { "name": NAME, "material": "red", "shape": { "sphere": { "center": [0, 0, -5], "radius": 1 } } } ]
}"#;

const LESSON: &str = r#"{ "title": "A ball", "figures": { "hit": {
  "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "caption": "Rays & <balls>",
  "show": ["objects", "names", "eye", "ray", "hits", "image"] } } }"#;

const FIRST: &str = r"# One

The discriminant is {{#raystep-value 01-ball/hit sphere_test[0].discriminant}}, in {{#raystep-value 01-ball/hit sphere_test.count}} test.

{{#raystep 01-ball/hit}}
Text follows *at once*.

- item
- {{#raystep 01-ball/hit}}
- last *item*

> {{#raystep-log 01-ball/hit only=sphere_test}}
> after *the log*

`{{#raystep 01-ball/hit}}` and \{{#raystep 01-ball/hit}}

```text
{{#raystep 01-ball/hit}}
```
";

const SECOND: &str = "# Two\n\n{{#raystep-compare 01-ball/hit}}\n\n{{#raystep 01-ball/hit}}\n";

/// A book in a folder of its own.
pub(crate) struct TestBook(pub(crate) tempfile::TempDir);

impl TestBook {
    pub(crate) fn new(first: &str, object: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let write = |file: &str, text: &str| {
            let path = folder.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        let command = format!("{} mdbook", env!("CARGO_BIN_EXE_raystep"));
        write(
            "book.toml",
            &format!(
                "[book]\ntitle = \"test\"\n[preprocessor.raystep]\ncommand = '{command}'\n\
                 lessons = \"course\"\nbefore = [\"links\"]\n"
            ),
        );
        let name = Value::from(object).to_string();
        write("course/01-ball/scene.json", &SCENE.replace("NAME", &name));
        write("course/01-ball/lesson.json", LESSON);
        write(
            "src/SUMMARY.md",
            "# Summary\n\n- [One](one.md)\n  - [Two](below/two.md)\n",
        );
        write("src/one.md", first);
        write("src/below/two.md", SECOND);
        Self(folder)
    }

    pub(crate) fn build(&self) -> Result<(), String> {
        let book = MDBook::load(self.0.path()).unwrap();
        book.build().map_err(|error| format!("{error:#}"))
    }

    pub(crate) fn page(&self, file: &str) -> String {
        fs::read_to_string(self.0.path().join("book").join(file)).unwrap()
    }

    /// All files of the book's source.
    fn source(&self) -> Vec<(PathBuf, String)> {
        let mut found = Vec::new();
        for folder in ["src", "src/below", "course/01-ball"] {
            for entry in fs::read_dir(self.0.path().join(folder)).unwrap() {
                let path = entry.unwrap().path();
                if path.is_file() {
                    found.push((path.clone(), fs::read_to_string(path).unwrap()));
                }
            }
        }
        found.sort();
        found
    }

    /// Hands the first chapter to the preprocessor as mdBook does.
    pub(crate) fn preprocess(&self, version: &str) -> Output {
        let content = fs::read_to_string(self.0.path().join("src/one.md")).unwrap();
        let chapter = json!({ "Chapter": {
            "name": "One", "content": content, "number": [1], "sub_items": [],
            "path": "one.md", "source_path": "one.md", "parent_names": [] } });
        let context = json!({
            "root": self.0.path(), "renderer": "html", "mdbook_version": version,
            "config": { "preprocessor": { "raystep": { "lessons": "course", "before": ["links"] } } } });
        mdbook_verb(&json!([context, { "items": [chapter] }]).to_string())
    }
}

fn mdbook_verb(input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_raystep"))
        .arg("mdbook")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(input.as_bytes())
        .unwrap();
    child.wait_with_output().unwrap()
}

/// The drawings of a page, each of which must be XML.
fn drawings(page: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = page;
    while let Some(start) = rest.find("<svg aria-labelledby") {
        let end = start + rest[start..].find("</svg>").unwrap() + "</svg>".len();
        let svg = &rest[start..end];
        Document::parse(svg).unwrap_or_else(|error| panic!("{error}: {svg}"));
        found.push(svg.to_owned());
        rest = &rest[end..];
    }
    found
}

#[test]
fn the_kinds_of_ray_tracing_are_compared_where_a_book_asks_for_it() {
    let first = "# One\n\n{{#raystep-compare 01-ball/hit transports}}\n";
    let book = TestBook::new(first, "A");
    let scene = SCENE.replace("NAME", "\"A\"").replace(
        "\"materials\"",
        "\"lights\": [{ \"position\": [0, 0, 0], \"power\": 9 }], \"materials\"",
    );
    fs::write(book.0.path().join("course/01-ball/scene.json"), scene).unwrap();
    let out = String::from_utf8(book.preprocess("0.5.4").stdout).unwrap();
    assert!(out.contains("<td>backward</td>"), "{out}");
    assert!(out.contains("<td>hybrid-connected</td>"), "{out}");
    assert!(out.contains(">waste %</th>"), "{out}");
    assert!(!out.contains("seconds"), "{out}");
}

#[test]
fn a_book_with_all_four_directives_is_built() {
    let book = TestBook::new(FIRST, "A");
    let before = book.source();
    book.build().unwrap();
    assert_eq!(
        book.source(),
        before,
        "the source of a book is not written to"
    );

    let one = book.page("one.html");
    assert!(one.contains("The discriminant is 4, in 1 test."), "{one}");
    assert!(
        one.contains("b² − 4ac = 100 − 96 = 4 &gt; 0: two real roots"),
        "{one}"
    );
    // words with a hyphen are not broken
    let whole = |word: &str| format!("<span style=\"white-space: nowrap\">{word}</span>");
    let command = format!(
        "<code>raystep figure {} {} course</code>",
        whole("01-ball/hit"),
        whole("--lessons")
    );
    let caption = format!("<figcaption>Rays &amp; &lt;balls&gt; {command}");
    assert!(one.contains(&caption), "{one}");
    // what follows a block is Markdown again, and code is left alone
    assert!(one.contains("Text follows <em>at once</em>."), "{one}");
    assert!(
        one.contains("last <em>item</em>") && one.contains("after <em>the log</em>"),
        "{one}"
    );
    assert_eq!(one.matches("{{#raystep 01-ball/hit}}").count(), 2, "{one}");
    let inline = format!("<code>{{{{#raystep {}</code>", whole("01-ball/hit}}"));
    assert_eq!(one.matches(&inline).count(), 1, "{one}");
    let item = one.split("<li>").nth(2).unwrap();
    assert!(
        item.contains("<figure") && item.find("</figure>") < item.find("</li>"),
        "{one}"
    );
    let quote = one.split("<blockquote>").nth(1).unwrap();
    assert!(quote.find("</pre>") < quote.find("</blockquote>"), "{one}");

    let two = book.page("below/two.html");
    assert!(
        two.contains("<table class=\"raystep-compare\">") && two.contains(">exhaustive</td>"),
        "{two}"
    );

    assert_eq!((drawings(&one).len(), drawings(&two).len()), (2, 1));
    let print = book.page("print.html");
    assert_eq!(drawings(&print).len(), 3);
    let ids = |page: &str| {
        let ids = page
            .split(" id=\"")
            .skip(1)
            .map(|rest| rest.split('"').next().unwrap().to_owned());
        ids.filter(|id| id.contains("raystep")).collect::<Vec<_>>()
    };
    for page in [&one, &two, &print] {
        let mut all = ids(page);
        let count = all.len();
        assert!(0 < count);
        all.sort();
        all.dedup();
        assert_eq!(all.len(), count, "an id comes twice");
    }
}

#[test]
fn a_broken_directive_fails_the_build_with_chapter_and_line() {
    for (directive, says) in [
        ("{{#raystep 01-ball/hti}}", "did you mean 01-ball/hit?"),
        ("{{#raystep 1-ball/hit}}", "did you mean 01-ball/hit?"),
        ("{{#raystep hit}}", "as in 12-grid/walk"),
        ("{{#raystep}}", "no figure is named"),
        (
            "{{#raystep-vlaue 01-ball/hit t}}",
            "did you mean raystep-value?",
        ),
        ("{{#raystep-value 01-ball/hit}}", "one path"),
        (
            "{{#raystep-value 01-ball/hit sphere_tset[0].a}}",
            "did you mean sphere_test?",
        ),
        (
            "{{#raystep-value 01-ball/hit sphere_test[7].a}}",
            "the indices are 0 to 0",
        ),
        (
            "{{#raystep-value 01-ball/hit sphere_test}}",
            "sphere_test.count",
        ),
        ("{{#raystep 01-ball/hit stpe=3}}", "step=N"),
        ("{{#raystep 01-ball/hit step=x}}", "is not a whole number"),
        (
            "{{#raystep-log 01-ball/hit only=sphere}}",
            "did you mean sphere_test?",
        ),
        ("{{#raystep-log 01-ball/hit ray=9}}", "its rays are 0 to 0"),
        ("{{#raystep-compare 01-ball/hit all}}", "picture"),
        (
            "{{#raystep-compare 01-ball/hit transports}}",
            "the scene has no lights",
        ),
        (
            "{{#raystep 01-ball/hit stepper level=tset}}",
            "did you mean test?",
        ),
        (
            "{{#raystep 01-ball/hit stepper from=99}}",
            "there is no step 99: the last one is ",
        ),
        ("{{#raystep 01-ball/hit stepper from=x}}", "is no step"),
        (
            "{{#raystep 01-ball/hit stepper from=3 to=2}}",
            "from is behind to",
        ),
        (
            "{{#raystep 01-ball/hit stepper from=#0,0:2}}",
            "its pixels are 4,4",
        ),
        (
            "{{#raystep 01-ball/hit stepper to=#path2:2}}",
            "no such section",
        ),
        (
            "{{#raystep 01-ball/hit stepper step=3}}",
            "predict, level=LEVEL",
        ),
        ("{{#raystep 01-ball/hit", "it has no end"),
        ("see {{#raystep 01-ball/hit}}", "a line of its own"),
    ] {
        let first = format!("# One\n\ntext\n\n{directive}\n");
        let book = TestBook::new(&first, "A");
        let out = book.preprocess("0.5.4");
        let told = String::from_utf8(out.stderr).unwrap();
        assert_eq!(out.status.code(), Some(2), "{directive}: {told}");
        assert!(out.stdout.is_empty(), "{directive}");
        assert!(told.contains("one.md, line 5: "), "{directive}: {told}");
        assert!(told.contains(says), "{directive}: {told}");
    }
    let book = TestBook::new("{{#raystep 01-ball/hti}}\n", "A");
    book.build().unwrap_err();
    assert!(!Path::new(&book.0.path().join("book/one.html")).exists());
}

#[test]
fn every_broken_directive_is_told_at_once() {
    let book = TestBook::new("{{#raystep a/b}}\n\n{{#raystep c/d}}\n", "A");
    let told = String::from_utf8(book.preprocess("0.5.4").stderr).unwrap();
    assert!(
        told.contains("one.md, line 1: ") && told.contains("one.md, line 3: "),
        "{told}"
    );
}

/// A directive without an end before another one on its line made the program panic.
#[test]
fn a_directive_without_an_end_before_another_one_is_told_and_the_other_one_followed() {
    let first = "# One\n\nSee {{#raystep-value 01-ball/hit sphere_test.count and \
                 {{#raystep-value 01-ball/hit sphere_test[0].t_in}} cells.\n";
    let out = TestBook::new(first, "A").preprocess("0.5.4");
    let told = String::from_utf8(out.stderr).unwrap();
    assert_eq!(out.status.code(), Some(2), "{told}");
    assert_eq!(
        told,
        "error: one.md, line 3: {{#raystep-value 01-ball/hit sphere_test.count and : it has no end\n  \
         close it with }} on the same line\n\
         one.md, line 3: {{#raystep-value 01-ball/hit sphere_test[0].t_in}}: in sphere_test[0] there is no \
         \"t_in\"\n  did you mean t?\n"
    );
}

#[test]
fn names_that_look_like_markup_come_out_as_text() {
    let long = "n".repeat(300);
    for name in [
        "</svg><script>alert(1)</script>",
        "{{#include /etc/hostname}}",
        "a\u{1}b\u{7f}\u{202e}c\u{200f}",
        "\u{5d0}\u{5d1}\u{5d2} `*_[x](y)",
        &long,
    ] {
        let book = TestBook::new(FIRST, name);
        book.build().unwrap();
        let one = book.page("one.html");
        assert!(!one.contains("<script>alert"), "{name}");
        assert!(!one.contains(['\u{1}', '\u{202e}', '\u{200f}']), "{name:?}");
        assert_eq!(drawings(&one).len(), 2, "{name}");
        if name.starts_with("{{") {
            assert!(one.contains("{{#include /etc/hostname}}: sphere"), "{one}");
        }
    }
}

#[test]
fn another_version_of_mdbook_is_told_and_stops_nothing() {
    let book = TestBook::new(FIRST, "A");
    let told = |version| {
        let out = book.preprocess(version);
        assert!(out.status.success());
        String::from_utf8(out.stderr).unwrap()
    };
    assert_eq!(told("0.5.9"), "");
    assert!(told("0.4.52").contains("called by 0.4.52"));
}

#[test]
fn html_is_supported_and_nothing_else() {
    for (renderer, code) in [("html", 0), ("markdown", 1)] {
        let status = Command::new(env!("CARGO_BIN_EXE_raystep"))
            .args(["mdbook", "supports", renderer])
            .status();
        assert_eq!(status.unwrap().code(), Some(code), "{renderer}");
    }
}

#[test]
fn input_that_is_not_mdbooks_is_refused() {
    for input in ["", "{}", "[1, 2]", "[{}, {\"items\": []}]"] {
        let out = mdbook_verb(input);
        let told = String::from_utf8(out.stderr).unwrap();
        assert_eq!(out.status.code(), Some(2), "{input}");
        assert!(
            told.contains("cannot be read") && told.contains("mdbook build"),
            "{told}"
        );
    }
}

#[test]
fn a_note_tells_how_to_keep_what_is_escaped() {
    let context = json!({
        "root": "/", "renderer": "html", "mdbook_version": "0.5.4",
        "config": { "preprocessor": { "raystep": {} } } });
    let chapter = json!({ "Chapter": {
        "name": "One", "content": "\\{{#raystep a/b}}", "number": null, "sub_items": [],
        "path": "one.md", "source_path": "one.md", "parent_names": [] } });
    let out = mdbook_verb(&json!([context, { "items": [chapter] }]).to_string());
    let told = String::from_utf8(out.stderr).unwrap();
    assert!(
        out.status.success() && told.contains("before = [\"links\"]"),
        "{told}"
    );
}

/// What a step says as the plain face prints it, from the data of a page.
pub(crate) fn plain_words(step: &Value) -> String {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let mut told = format!("\n{}\n{}\n", text(&step["title"]), text(&step["place"]));
    for line in step["lines"].as_array().unwrap() {
        if line["gap"] == true {
            told.push('\n');
        }
        let indent = line["indent"].as_u64().unwrap() as usize;
        told.extend(["  ".repeat(indent), text(&line["text"]), "\n".into()]);
    }
    let facts = step["facts"].as_array().unwrap().iter();
    told + &facts.map(|fact| text(fact) + "\n").collect::<String>()
}

/// What the steps of a stepper say as the plain face prints them: from its data, and from its list.
fn told(figure: &str) -> (Vec<String>, Vec<String>) {
    let document = Document::parse(figure).unwrap_or_else(|error| panic!("{error}: {figure}"));
    let of_class = |class: &'static str| {
        let nodes = document.descendants();
        nodes.filter(move |node| node.attribute("class") == Some(class))
    };
    let data = document
        .descendants()
        .find(|node| node.attribute("type") == Some("application/json"));
    let data: Value = serde_json::from_str(data.unwrap().text().unwrap()).unwrap();
    let of_data = data["steps"].as_array().unwrap().iter().map(plain_words);
    let of_list = of_class("raystep-words").map(|words| {
        let mut told = String::from("\n");
        for part in words
            .descendants()
            .filter(|part| matches!(part.tag_name().name(), "p" | "div") && is_leaf(part))
        {
            let class = part.attribute("class").unwrap_or_default();
            if class.ends_with(" gap") {
                told.push('\n');
            }
            let indent = part.attribute("style").unwrap_or("--indent: 0");
            let indent: usize = indent.strip_prefix("--indent: ").unwrap().parse().unwrap();
            told.extend(["  ".repeat(indent), text_of(part), "\n".into()]);
        }
        told
    });
    (of_data.collect(), of_list.collect())
}

/// Has an element no blocks in it, and a text? A word that is not broken is a span in it.
fn is_leaf(part: &roxmltree::Node) -> bool {
    let mut blocks = part.descendants().skip(1);
    !text_of(*part).is_empty() && !blocks.any(|of| matches!(of.tag_name().name(), "p" | "div"))
}

fn text_of(part: roxmltree::Node) -> String {
    let texts = part.descendants().filter(roxmltree::Node::is_text);
    texts.filter_map(|node| node.text()).collect()
}

/// The steppers of a chapter, one a line.
fn steppers(content: &str) -> Vec<&str> {
    let lines = content.lines();
    lines
        .filter(|line| line.starts_with("<div class=\"raystep-stepper\""))
        .collect()
}

#[test]
fn the_stepper_of_a_book_says_the_words_of_the_plain_face_in_all_lessons() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    let library = raystep::open_lessons(&root.join("lessons")).unwrap();
    let expand = |content: &str| {
        let chapter = json!({ "Chapter": { "name": "One", "content": content, "path": "one.md", "sub_items": [] } });
        let context = json!({ "root": root, "mdbook_version": "0.5.4", "config": {} });
        let input = json!([context, { "items": [chapter] }]).to_string();
        let followed = raystep::preprocess(input.as_bytes(), &NoCommands)
            .map_err(|error| error.to_string())
            .map(|followed| serde_json::from_str::<Value>(&followed.book).unwrap());
        followed.map(|book| {
            let content = &book["items"][0]["Chapter"]["content"];
            content.as_str().unwrap().to_owned()
        })
    };
    let (mut figures, mut steps) = (0, 0);
    for name in library.figures() {
        let (lesson, spec) = library.find(&name).unwrap();
        let Some([x, y]) = spec.traced_pixels().first().copied() else {
            continue;
        };
        let directive = |level: &str| format!("{{{{#raystep {name} stepper level={level}}}}}\n\n");
        let levels = ["test", "term"];
        let both = levels.map(directive).concat();
        let (content, levels) = match expand(&both) {
            Ok(content) => (content, &levels[..]),
            Err(error) => {
                assert!(error.contains("too many for a stepper"), "{error}");
                let Ok(content) = expand(&directive("test")) else {
                    continue;
                };
                (content, &levels[..1])
            }
        };
        let log = folder.path().join("log.jsonl");
        let mut lines = Vec::new();
        let traced = lesson.trace(&name.figure, spec).unwrap();
        traced[0].write(&mut lines).unwrap();
        fs::write(&log, lines).unwrap();
        let found = steppers(&content);
        assert_eq!(found.len(), levels.len(), "{name}");
        for (figure, key) in found.into_iter().zip(["4", "5"]) {
            let (of_data, of_list) = told(figure);
            assert_eq!(of_data, of_list, "{name}");
            let over = " over".repeat(of_data.len() - 1);
            let plain = Command::new(env!("CARGO_BIN_EXE_raystep"))
                .args([
                    "step",
                    log.to_str().unwrap(),
                    &format!("{x},{y}"),
                    "--script",
                ])
                .arg(format!("{key} first{over}"))
                .output()
                .unwrap();
            let plain = String::from_utf8(plain.stdout).unwrap();
            let all = of_data.concat();
            assert!(
                plain.ends_with(&all),
                "{name}, {key}\n{plain}\n--- book ---\n{all}"
            );
            steps += of_data.len();
        }
        figures += 1;
    }
    assert!(
        30 <= figures && 1500 < steps,
        "{figures} figures, {steps} steps"
    );
}

#[test]
fn the_script_of_the_steppers_stands_once_in_each_chapter() {
    let first =
        "{{#raystep 01-ball/hit stepper}}\n\n> {{#raystep 01-ball/hit stepper predict}}\n> text\n";
    let book = TestBook::new(first, "A");
    fs::write(
        book.0.path().join("src/below/two.md"),
        "> - {{#raystep 01-ball/hit stepper}}\n>   *text*\n",
    )
    .unwrap();
    book.build().unwrap();
    let [one, two] = ["one.html", "below/two.html"].map(|file| book.page(file));
    for (page, steppers) in [(&one, 2), (&two, 1)] {
        assert_eq!(page.matches("class Stepper").count(), 1);
        assert_eq!(page.matches(".raystep-panel {").count(), 1);
        assert_eq!(page.matches("type=\"application/json\"").count(), steppers);
    }
    assert_eq!(one.matches(" data-predict").count(), 1);
    let quote = two.split("<blockquote>").nth(1).unwrap();
    let quote = quote.split("</blockquote>").next().unwrap();
    assert!(
        quote.contains("</figure>") && quote.contains("<em>text</em>"),
        "{two}"
    );
}

#[test]
fn a_stepper_begins_and_ends_where_it_is_told() {
    let titles = |words: &str| {
        let first = format!("{{{{#raystep 01-ball/hit stepper {words}}}}}\n");
        let out = TestBook::new(&first, "A").preprocess("0.5.4");
        let book: Value = serde_json::from_slice(&out.stdout).unwrap();
        let content = book["items"][0]["Chapter"]["content"].as_str().unwrap();
        let (told, _) = told(steppers(content)[0]);
        let titles = told
            .iter()
            .map(|told| told.lines().nth(1).unwrap().to_owned());
        titles.collect::<Vec<_>>()
    };
    let sphere = "A: sphere: hit";
    let nearest = "nearest hit: A";
    // step 0 is the window point, 1 the start of the ray, 2 the test, and 3 what it leads to
    assert_eq!(titles("level=term from=2 to=3"), [sphere, nearest]);
    assert_eq!(titles("level=test from=#4,4:2 to=2"), [sphere]);
    assert_eq!(titles("level=section"), ["Pixel (4, 4)"]);
    assert_eq!(
        titles("level=term to=1"),
        ["window point", "start of ray 0"]
    );
    let tests = titles("");
    assert_eq!(tests[..3], ["window point", "start of ray 0", sphere]);
    assert_eq!(tests.last().unwrap(), "colour of the pixel");
}
