//! What a book shows of its project: formulas, source by item, and commands with what they print.

use std::fs;

use crate::book::TestBook;

const SOURCE: &str = "/// The discriminant of a quadratic.\n///\n/// D = b² − 4ac\n#[must_use]\npub fn discriminant(a: f64, b: f64, c: f64) -> f64 {\n    b * b - 4.0 * a * c\n}\n\n# [test]\nfn it() {}\n";

/// A book with one chapter and a source file in its project.
fn book(chapter: &str) -> TestBook {
    let book = TestBook::new(chapter, "A");
    let path = |file: &str| book.0.path().join(file);
    fs::write(path("course/root.rs"), SOURCE).unwrap();
    fs::write(
        path("course/root.py"),
        "# ANCHOR: d\ndef d(b):  # {{#raystep x/y}}\n    return b\n# ANCHOR_END: d\n",
    )
    .unwrap();
    fs::write(path("src/below/two.md"), "# Two\n").unwrap();
    book
}

#[test]
fn formulas_come_out_as_mathml_and_hold_numbers_of_a_trace() {
    let book = book(
        "# One\n\nLet $a_1 * b_1$ cost \\$5.\n\n\
         $$ b^2 - 4ac = {{#raystep-value 01-ball/hit sphere_test[0].discriminant}} $$\n\n\
         > - $$\\frac{1}{2}\n>   + |x| * 3 * 4$$ *then*\n\n`$code$`\n\n| $|x|$ | $y$ |\n|---|---|\n| 1 | 2 |\n",
    );
    book.build().unwrap();
    let page = book.page("one.html");
    assert_eq!(page.matches("<math").count(), 5, "{page}");
    assert_eq!(
        page.matches("<span class=\"raystep-formula\" tabindex=\"0\"><math display=\"block\">")
            .count(),
        2,
        "{page}"
    );
    // the ball's discriminant is 100 − 96
    assert!(page.contains("<mn>4</mn>"), "{page}");
    assert!(page.contains("cost $5."), "{page}");
    assert!(page.contains("<code>$code$</code>"), "{page}");
    assert!(page.contains("</math></span> <em>then</em>"), "{page}");
    // no mark of Markdown inside of a formula, and none of the rest is left
    for math in page.split("<math").skip(1) {
        let math = math.split("</math>").next().unwrap();
        assert!(!math.contains("<em>") && !math.contains('\n'), "{math}");
    }
    assert!(
        !page.contains("<td>b</td>") && page.contains("<th>"),
        "{page}"
    );
}

#[test]
fn source_is_shown_by_item_and_nothing_in_it_is_followed() {
    let book = book(
        "# One\n\n{{#raystep-code course/root.rs:discriminant}}\n\n\
         - {{#raystep-code course/root.rs:discriminant doc}}\n- next\n\n\
         {{#raystep-code course/root.py:d}}\n\n{{#raystep-code course/01-ball/lesson.json:/figures/hit/pixel}}\n",
    );
    book.build().unwrap();
    let page = book.page("one.html");
    let shown: Vec<&str> = page
        .split("<figure class=\"raystep-code\">")
        .skip(1)
        .collect();
    assert_eq!(shown.len(), 4, "{page}");
    let code = |shown: &str| {
        shown
            .split("</code>")
            .next()
            .unwrap()
            .trim_start()
            .to_owned()
    };
    assert_eq!(
        code(shown[0]),
        "<pre><code class=\"language-rust ignore\">#[must_use]\npub fn discriminant(a: f64, b: f64, c: f64) -&gt; f64 {\n    b * b - 4.0 * a * c\n}"
    );
    assert!(code(shown[1]).contains("/// The discriminant of a quadratic.\n///\n"));
    assert!(
        shown[1].contains("</figure>\n</li>") || shown[1].contains("</figure></li>"),
        "{}",
        shown[1]
    );
    assert!(
        code(shown[2]).ends_with("def d(b):  # {{#raystep x/y}}\n    return b"),
        "{}",
        shown[2]
    );
    assert!(
        code(shown[3]).ends_with("\"pixel\": [4, 4]"),
        "{}",
        shown[3]
    );
    assert!(shown[0].contains("<figcaption><code>course/root.rs</code></figcaption>"));
    // no button that asks another host to run it
    assert!(!page.contains("class=\"playground\""));
}

#[test]
fn a_command_is_run_where_the_book_is_built() {
    let book = book(
        "# One\n\n{{#raystep-run from=\"a, b, c\" to=roots pixel course/01-ball/scene.json 4,4}}\n\n\
         {{#raystep-run lines=2 trace course/01-ball/scene.json --region 4,4}}\n\n\
         {{#raystep-run exit=2 pixel course/01-ball/scene.json 99,4}}\n\n\
         {{#raystep-run from=Usage lines=1 pixel --help}}\n",
    );
    book.build().unwrap();
    let page = book.page("one.html");
    let shown: Vec<&str> = page.split("<pre class=\"raystep-run\">").skip(1).collect();
    assert_eq!(shown.len(), 4, "{page}");
    let text = |shown: &str| {
        let code = shown.split("</code>").next().unwrap();
        // without the tags: words with a hyphen are kept whole by spans
        let pieces = code.split('<').skip(1);
        let pieces = pieces.map(|piece| piece.split_once('>').unwrap().1);
        pieces.collect::<String>()
    };
    let first = text(shown[0]);
    assert!(
        first.starts_with("$ raystep pixel course/01-ball/scene.json 4,4\n… ("),
        "{first}"
    );
    assert!(first.contains("b² − 4ac = 100 − 96 = 4"), "{first}");
    assert!(first.ends_with(" more lines)"), "{first}");
    let second = text(shown[1]);
    assert_eq!(second.lines().count(), 4, "{second}");
    assert!(second.lines().nth(1).unwrap().starts_with('{'), "{second}");
    let third = text(shown[2]);
    assert!(third.contains("\nerror: "), "{third}");
    assert!(
        text(shown[3]).contains("Usage: raystep pixel"),
        "{}",
        shown[3]
    );
}

#[test]
#[expect(clippy::too_many_lines, reason = "a case for each error")]
fn what_cannot_be_shown_fails_the_build_with_chapter_and_line() {
    for (directive, says) in [
        ("Let $a = \\frca{1}$ be", "\"\\\\frca{1}\""),
        ("It costs $5.", "write \\$ for a dollar sign"),
        (
            "$x = {{#raystep 01-ball/hit}}$",
            "only raystep-value may stand in it",
        ),
        (
            "$x = {{#raystep-value 01-ball/hit sphere_tset.a}}$",
            "did you mean sphere_test?",
        ),
        ("{{#raystep-code}}", "no file is named"),
        (
            "{{#raystep-code course/root.rs:discriminent}}",
            "did you mean discriminant?",
        ),
        ("{{#raystep-code course/none.rs:a}}", "cannot be read"),
        (
            "{{#raystep-code course/../../../../../../../etc/hostname}}",
            "lies outside of the project",
        ),
        (
            "{{#raystep-code /etc/hostname}}",
            "lies outside of the project",
        ),
        ("{{#raystep-code course/root.py:e}}", "it has d"),
        (
            "{{#raystep-code course/01-ball/lesson.json:/figure}}",
            "did you mean figures?",
        ),
        ("see {{#raystep-code course/root.rs}}", "a line of its own"),
        (
            "{{#raystep-blanks 01-ball/hit blanks=0}}",
            "no line has a result",
        ),
        ("{{#raystep-blanks 01-ball/hit blank=2}}", "blanks=N"),
        (
            "{{#raystep-log 01-ball/hit blanks=2}}",
            "is not one of its options",
        ),
        ("{{#raystep-mistakes 01-bal}}", "did you mean 01-ball?"),
        ("{{#raystep-map none.json}}", "it lies beside book.toml"),
        ("{{#raystep-run}}", "no verb is named"),
        (
            "{{#raystep-run pixle course/01-ball/scene.json 4,4}}",
            "the command ends with 2",
        ),
        (
            "{{#raystep-run pixel course/01-ball/scene.json 99,4}}",
            "the command ends with 2",
        ),
        (
            "{{#raystep-run render course/01-ball/scene.json -o x.png}}",
            "render writes a picture",
        ),
        (
            "{{#raystep-run trace course/01-ball/scene.json -o x.jsonl}}",
            "--output x.jsonl writes a file",
        ),
        (
            "{{#raystep-run figure 01-ball/hit --lessons course --write-log x.jsonl}}",
            "writes a file",
        ),
        (
            "{{#raystep-run compare course/01-ball/scene.json --chart x.svg}}",
            "writes a file",
        ),
        (
            "{{#raystep-run convert course/01-ball/scene.json x.json}}",
            "writes a file",
        ),
        (
            "{{#raystep-run lesson start x}}",
            "lesson start and lesson export write files",
        ),
        (
            "{{#raystep-run pixel /etc/hostname 4,4}}",
            "is no file of the lessons or of the book",
        ),
        (
            "{{#raystep-run pixel - 4,4}}",
            "is no file of the lessons or of the book",
        ),
        (
            "{{#raystep-run pixel course/01-ball/scene.json 4,4 --allow-outside}}",
            "outside of the course",
        ),
        (
            "{{#raystep-run step course/01-ball/scene.json 4,4}}",
            "draws in the terminal",
        ),
        (
            "{{#raystep-run from=nothing pixel course/01-ball/scene.json 4,4}}",
            "no line of the output has",
        ),
    ] {
        let book = book(&format!("# One\n\ntext\n\n{directive}\n"));
        let out = book.preprocess("0.5.4");
        let told = String::from_utf8(out.stderr).unwrap();
        assert_eq!(out.status.code(), Some(2), "{directive}: {told}");
        assert!(out.stdout.is_empty(), "{directive}");
        assert!(told.contains("one.md, line 5: "), "{directive}: {told}");
        assert!(told.contains(says), "{directive}: {told}");
    }
}

/// What is shown follows what is in the project: a changed number, a changed source, another version of a command's output.
#[test]
fn what_is_shown_changes_with_the_scene_and_the_source() {
    let chapter = "# One\n\n$D = {{#raystep-value 01-ball/hit sphere_test[0].discriminant}}$\n\n\
                   {{#raystep-code course/root.rs:discriminant}}\n\n\
                   {{#raystep-run from=discriminant lines=1 pixel course/01-ball/scene.json 4,4}}\n";
    let book = book(chapter);
    book.build().unwrap();
    let before = book.page("one.html");
    let change = |file: &str, from: &str, to: &str| {
        let path = book.0.path().join(file);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{text}");
        fs::write(path, text.replace(from, to)).unwrap();
    };
    // radius 2: c = 25 − 4, and b² − 4ac = 100 − 84
    change(
        "course/01-ball/scene.json",
        "\"radius\": 1",
        "\"radius\": 2",
    );
    change("course/root.rs", "b * b - 4.0", "b.powi(2) - 4.0");
    book.build().unwrap();
    let after = book.page("one.html");
    assert!(
        before.contains("<mn>4</mn>") && !before.contains("100 − 84 = 16"),
        "{before}"
    );
    assert!(
        after.contains("<mn>16</mn>") && after.contains("100 − 84 = 16"),
        "{after}"
    );
    assert!(
        before.contains("b * b - 4.0") && after.contains("b.powi(2) - 4.0"),
        "{after}"
    );
    change("course/root.rs", "discriminant(", "determinant(");
    book.build().unwrap_err();
}

#[test]
fn a_worked_pixel_has_blanks_and_their_answers() {
    let book = book("# One\n\n{{#raystep-blanks 01-ball/hit only=sphere_test blanks=2}}\n");
    book.build().unwrap();
    let page = book.page("one.html");
    let shown = page.split("<div class=\"raystep-blanks\">").nth(1).unwrap();
    let (text, answers) = shown.split_once("<details>").unwrap();
    assert!(text.contains("[1]") && text.contains("[2]"), "{text}");
    let answers: Vec<&str> = answers.split("<li>").skip(1).collect();
    assert_eq!(answers.len(), 2);
    for (answer, number) in answers.iter().zip(["[1] is ", "[2] is "]) {
        assert!(answer.starts_with(number), "{answer}");
    }
}

/// The rows name what exists, and lead to the chapter that shows the figure.
#[test]
fn a_map_leads_to_the_chapter_of_each_figure() {
    let map = |row: &str| format!("{{\"rows\": [{row}]}}");
    let row = r#"{"slide": "Sphere", "subject": "roots", "figure": "01-ball/hit", "chapter": "one.md", "kind": "sphere_test", "exercise": "04/roots"}"#;
    let book = book("# One\n\n{{#raystep-map map.json}}\n\n{{#raystep-mistakes}}\n");
    fs::write(
        book.0.path().join("src/below/two.md"),
        "# Two\n\n{{#raystep 01-ball/hit}}\n",
    )
    .unwrap();
    let write = |text: &str| fs::write(book.0.path().join("map.json"), text).unwrap();
    write(&map(row));
    book.build().unwrap();
    let page = book.page("one.html");
    let id = "raystep-below-two-01-ball-hit_figure";
    assert!(
        page.contains(&format!("<a href=\"below/two.html#{id}\">01-ball/hit</a>")),
        "{page}"
    );
    assert!(
        book.page("below/two.html")
            .contains(&format!("id=\"{id}\""))
    );
    assert!(page.contains("<code>l04_roots</code>"), "{page}");
    assert!(page.contains("<td>first root always</td>"), "{page}");
    for (from, to, says) in [
        (
            "\"figure\": \"01-ball/hit\"",
            "\"figure\": \"01-ball/hti\"",
            "did you mean 01-ball/hit?",
        ),
        ("one.md", "none.md", "there is no chapter"),
        (", \"chapter\": \"one.md\"", "", "name a \"chapter\""),
        ("sphere_test", "sphere_tset", "did you mean sphere_test?"),
        ("04/roots", "04/rotos", "did you mean 04/roots?"),
        (", \"exercise\": \"04/roots\"", "", "say \"why\""),
        ("\"slide\"", "\"slides\"", "unknown field"),
    ] {
        assert!(row.contains(from), "{from}");
        write(&map(&row.replace(from, to)));
        let out = book.preprocess("0.5.4");
        let told = String::from_utf8(out.stderr).unwrap();
        assert!(
            told.contains("one.md, line 3: ") && told.contains(says),
            "{to}: {told}"
        );
    }
}
