//! `raystep step`: commands in, steps as plain text out.

use std::io::Write;
use std::process::Stdio;

use raystep::step::KEYS;

use super::run::{Folder, Ran, SCENE};

/// Runs with these lines on standard input.
fn with_lines(folder: &Folder, words: &str, lines: &str) -> Ran {
    let mut command = folder.command(words);
    command.stdin(Stdio::piped());
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(lines.as_bytes()).unwrap();
    drop(input);
    child.wait_with_output().unwrap().into()
}

#[track_caller]
fn text(ran: Ran) -> String {
    String::from_utf8(ran.well()).unwrap()
}

/// The titles of the steps that were shown: the first line of each paragraph.
fn titles(text: &str) -> Vec<&str> {
    let place = |line: &str| {
        let level = ["section, ", "ray, ", "place, ", "test, ", "term, "];
        level.iter().any(|level| line.starts_with(level)) && line.contains(" of ")
    };
    let lines: Vec<&str> = text.lines().collect();
    let pairs = lines.windows(2).filter(|pair| place(pair[1]));
    pairs.map(|pair| pair[0]).collect()
}

#[test]
fn a_script_walks_into_the_pixel_and_asks_who_set_t() {
    let folder = Folder::with_scene();
    let mut command = folder.command("step scene.json 80,60 --script");
    let ran: Ran = command
        .arg("into over into over over w t out y q into")
        .output()
        .unwrap()
        .into();
    let text = text(ran);
    assert_eq!(
        titles(&text),
        [
            "Pixel (80, 60)",
            "window point",
            "Ray 0: eye ray, depth 1: hit",
            "start of ray 0",
            "A: sphere: hit",
            "B: ellipsoid: rejected, no root",
            "A: sphere: hit",
            "Ray 0: eye ray, depth 1: hit",
        ]
    );
    assert!(text.contains("\ntest, steps 2 to 3 of "), "{text}");
    assert!(text.contains("\n  discriminant: b² − 4ac = "), "{text}");
    assert!(
        text.contains("\nchanged: ray 0, nearest hit: none → A at t = 5.00028\n"),
        "{text}"
    );
    assert!(
        text.contains("\nnearest hit: A at t = 5.00028, set by step 3\n"),
        "{text}"
    );
    assert!(
        text.ends_with("\nraystep step scene.json 80,60 --strategy exhaustive --at 1\n"),
        "{text}"
    );
    // no escape, no drawing character
    let is_drawn = |c: char| c == '\u{1b}' || ('\u{2500}'..='\u{25ff}').contains(&c);
    assert!(!text.contains(is_drawn), "{text}");
}

#[test]
fn lines_of_standard_input_do_what_a_script_does_and_a_wrong_one_is_told() {
    let folder = Folder::with_scene();
    let ran = with_lines(
        &folder,
        "step scene.json 80,60 --plain",
        "into over\ninto\n\nover over w t\nout\ny\n",
    );
    let typed = text(ran);
    let mut command = folder.command("step scene.json 80,60 --script");
    let script = command
        .arg("into over into over over w t out y")
        .output()
        .unwrap();
    assert_eq!(typed, text(script.into()));

    let ran = with_lines(
        &folder,
        "step scene.json 80,60",
        "itno\n/kind=cel\ng 999\ng x\nout\nback\ninto\n",
    );
    let text = text(ran);
    for told in [
        "there is no command \"itno\"; did you mean into? The command ? lists all",
        "there is no kind \"cel\"; did you mean cell?",
        "there is no step 999: the last one is ",
        "\"x\" is no step: give its number in the log",
        "nothing is around this step",
        "this is the first step",
        "window point",
    ] {
        assert!(text.contains(told), "{told}\n{text}");
    }
}

#[test]
fn a_script_or_an_address_that_makes_no_sense_is_refused_before_anything_is_printed() {
    let folder = Folder::with_scene();
    let refused = |words: &[&str]| {
        let mut command = folder.command("step scene.json 80,60");
        let ran: Ran = command.args(words).output().unwrap().into();
        ran.refused()
    };
    let told = refused(&["--script", "into itno"]);
    assert!(
        told.contains("--script: there is no command \"itno\"; did you mean into?"),
        "{told}"
    );
    let told = refused(&["--at", "999"]);
    assert!(
        told.contains("--at: there is no step 999: the last one is "),
        "{told}"
    );
    let told = refused(&["--at", "#81,60:3"]);
    assert!(told.contains("there is no step #81,60:3"), "{told}");
    let told = refused(&["--at", "here"]);
    assert!(told.contains("#path17:37"), "{told}");
    let told = refused(&["--stats=json"]);
    assert!(told.contains("--stats"), "{told}");
    let told = folder.run("step scene.json 160,0").refused();
    assert!(told.contains("the picture has no pixel 160,0"), "{told}");
}

#[test]
fn at_opens_the_innermost_step_that_holds_the_event() {
    let folder = Folder::with_scene();
    let text = text(folder.run("step scene.json 80,60 --at #80,60:3 --script q"));
    assert_eq!(titles(&text), ["nearest hit: A"]);
    assert!(text.contains("\n→ nearest hit so far\n"), "{text}");
}

#[test]
fn a_saved_log_says_the_same_and_x_says_that_it_needs_a_scene() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --strategy grid --region 79,60-80,60 -o part.jsonl")
        .well();
    let script = "into over into n n n w out 3 over 4 back 1 v";
    let of = |words: &str| {
        let mut command = folder.command(words);
        text(command.args(["--script", script]).output().unwrap().into())
    };
    let from_scene = of("step scene.json 80,60 --strategy grid");
    assert_eq!(from_scene, of("step part.jsonl 80,60"));

    let ran = with_lines(
        &folder,
        "step part.jsonl 80,60",
        "x\npixel-left\npixel-left\ny\n",
    );
    let text = text(ran);
    assert!(
        text.contains("this is a log, and another strategy asks for new rays"),
        "{text}"
    );
    assert!(titles(&text).contains(&"Pixel (79, 60)"), "{text}");
    assert!(
        text.contains("this log has only the pixels 79,60-80,60"),
        "{text}"
    );
    assert!(
        text.ends_with("\nraystep step part.jsonl 79,60 --at 0\n"),
        "{text}"
    );
    let told = folder
        .run("step part.jsonl 80,60 --strategy heap")
        .refused();
    assert!(told.contains("--strategy asks for new rays"), "{told}");
}

#[test]
fn a_damaged_log_names_its_line() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 80,60 -o part.jsonl")
        .well();
    let log = String::from_utf8(folder.read("part.jsonl")).unwrap();
    let at = log
        .lines()
        .position(|line| line.contains("\"sphere_test\""))
        .unwrap();
    let damaged = log.replacen("\"discriminant\":", "\"discriminant\":x", 1);
    let folder = folder.with("damaged.jsonl", damaged);
    let told = folder.run("step damaged.jsonl 80,60").refused();
    assert!(
        told.contains(&format!("damaged.jsonl:{}", at + 1))
            || told.contains(&format!("line {}", at + 1)),
        "{told}"
    );
}

/// Six times `x` is the way round: the test of A on ray 0 with each strategy, and then the first again.
#[test]
fn x_takes_the_same_test_on_the_same_ray_to_the_next_strategy() {
    let folder = Folder::with_scene();
    let ran = with_lines(
        &folder,
        "step scene.json 80,60 --at 2",
        "out\nx\nx\nx\nx\nx\nx\ny\n",
    );
    let text = text(ran);
    let told: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("pixel 80,60, strategy "))
        .collect();
    assert_eq!(told.len(), 6, "{text}");
    assert_eq!(titles(&text)[1..], ["A: sphere: hit"; 7], "{text}");
    assert!(text.ends_with("--strategy exhaustive --at 2\n"), "{text}");
}

#[test]
fn a_pixel_beside_keeps_the_ray_and_the_picture_ends_at_its_edge() {
    let folder = Folder::with_scene();
    let ran = with_lines(
        &folder,
        "step scene.json 158,60 --at 1",
        "out\nshift+right\npixel-right\nShift+←\ny\n",
    );
    let text = text(ran);
    assert!(text.contains("\nthe picture ends here\n"), "{text}");
    let titles = titles(&text);
    assert_eq!(titles.len(), 4, "{text}");
    let is_ray = |title: &&str| title.starts_with("Ray 0: eye ray, depth 1");
    assert!(titles[1..].iter().all(is_ray), "{text}");
    assert!(
        text.contains("raystep step scene.json 158,60 --strategy exhaustive --at 1"),
        "{text}"
    );
}

#[test]
fn the_command_that_leads_here_has_the_options_that_were_given() {
    let folder = Folder::with_scene();
    let options = "--strategy grid --grid 3,2,3 --no-mailboxes --max-depth 2 --quiet";
    let mut command = folder.command(&format!("step scene.json 80,60 {options}"));
    let ran: Ran = command
        .args(["--script", "leaf leaf y"])
        .output()
        .unwrap()
        .into();
    let text = text(ran);
    let line = text.lines().last().unwrap();
    assert!(
        line.starts_with("raystep step scene.json 80,60 --strategy grid "),
        "{line}"
    );
    for option in ["--grid 3,2,3", "--no-mailboxes", "--max-depth 2", "--at 1"] {
        assert!(line.contains(option), "{option} in {line}");
    }
    // and it leads here
    let here = self::text(folder.run(&format!(
        "{} --script q",
        line.strip_prefix("raystep ").unwrap()
    )));
    let shown = text.rsplit("\n\n").next().unwrap();
    let shown = shown
        .strip_suffix(line.trim_end())
        .unwrap_or(shown)
        .trim_end();
    assert!(here.contains(shown.lines().next().unwrap()), "{here}");
}

#[test]
fn all_keys_are_listed_with_their_words() {
    let folder = Folder::with_scene();
    let text = text(folder.run("step scene.json 80,60 --script ?"));
    for key in KEYS {
        let line = text.lines().find(|line| {
            line.starts_with(&format!("{}, ", key.words[0]))
                || line.starts_with(&format!("{}:", key.words[0]))
                || line.starts_with(&format!("{} ", key.words[0]))
        });
        assert!(
            line.is_some_and(|line| line.contains(key.does)),
            "{key:?}\n{text}"
        );
    }
}

#[test]
fn a_hostile_name_stays_text() {
    let name = "\u{1b}[31mA\u{7}\u{202e}";
    let scene = SCENE.replace(
        "\"name\": \"A\"",
        &format!("\"name\": {}", serde_json::json!(name)),
    );
    assert_ne!(scene, SCENE);
    let folder = Folder::empty().with("scene.json", scene);
    let ran = with_lines(
        &folder,
        "step scene.json 80,60",
        "/object=\"\u{1b}[31mA\u{7}\u{202e}\"\nn\nn\nv\n\u{1b}]0;x\u{7}\n",
    );
    let text = text(ran);
    let control = |c: char| c.is_control() && c != '\n' || c == '\u{202e}';
    assert!(!text.contains(control), "{text:?}");
    assert!(
        text.contains("\n2 steps are named by the filter\n")
            || text.contains(" steps are named by the filter\n"),
        "{text}"
    );
}

#[test]
fn a_question_comes_before_the_verdict_and_its_answer_has_a_reason_for_every_choice() {
    let folder = Folder::with_scene();
    let run = |script: &str| {
        let mut command = folder.command("step scene.json 80,60 --predict --script");
        let ran: Ran = command.arg(script).output().unwrap().into();
        text(ran)
    };
    // A has two roots, of which the smaller one counts
    let asked = run("into over into over");
    let (_, question) = asked
        .split_once("\nA: sphere\ntest, steps 2 to 3 of ")
        .unwrap();
    assert!(
        question.contains("\nquestion: The roots of A are t = 5.00028 and t = "),
        "{asked}"
    );
    assert!(
        question.ends_with("\nanswer with a letter, or skip\n"),
        "{asked}"
    );
    assert!(
        !asked.contains("A: sphere: hit") && !asked.contains("nearest hit"),
        "{asked}"
    );
    let right = question
        .lines()
        .find(|line| line.ends_with(": t = 5.00028"));
    let right = right.unwrap().chars().next().unwrap();
    // each letter is told whether it is right, and then the step is shown
    for letter in ['a', 'b', 'c'] {
        let answered = run(&format!("into over into over {letter}"));
        let verdict = if letter == right {
            format!("\nright: {right}\n")
        } else {
            format!("\nwrong: {letter}; {right} is right\n")
        };
        assert!(answered.contains(&verdict), "{answered}");
        let reasons = ["a", "b", "c"].map(|of| {
            let line = answered
                .lines()
                .find(|line| line.starts_with(&format!("{of} is ")));
            line.unwrap().len()
        });
        assert!(reasons.iter().all(|length| 20 < *length), "{answered}");
        assert!(answered.contains("Mistake \"largest root\""), "{answered}");
        assert!(answered.ends_with("holds 2 steps\n"), "{answered}");
        assert!(answered.contains("\nA: sphere: hit\n"), "{answered}");
    }
    // skipped, it is shown without a verdict on anybody; gone on from, it is not shown
    let skipped = run("into over into over skip");
    assert!(skipped.contains("\nA: sphere: hit\n") && !skipped.contains("\nright: "));
    let left = run("into over into over over");
    assert!(!left.contains("\nA: sphere: hit\n"), "{left}");
    // there are three choices, and without a question a letter is told so
    assert!(run("into over into over d").contains("\nthe question has no such choice\n"));
    assert!(run("a").ends_with("\nno question waits for an answer\n"));
    // p turns them off and on, and the state would give the answer away
    let off = run("p into over into over p over v");
    assert!(off.contains("\nno more questions are asked\n"), "{off}");
    assert!(off.contains("\nA: sphere: hit\n"), "{off}");
    assert!(
        off.ends_with("\nanswer the question, or skip it\n"),
        "{off}"
    );
}

#[test]
fn s_saves_the_drawing_up_to_here_in_a_new_file_and_its_command_makes_it_again() {
    let folder = Folder::with_scene();
    let run = |words: &str, script: &str| {
        let mut command = folder.command(words);
        let ran: Ran = command.args(["--script", script]).output().unwrap().into();
        text(ran)
    };
    // the test of A, steps 2 and 3; its first root shows in step 2 and the hit in step 3
    let saved = run("step scene.json 80,60", "into over into over s");
    let name = "raystep-sphere-scene-80,60-2.svg";
    let (_, told) = saved.split_once(&format!("\nsaved as {name}\n")).unwrap();
    assert_eq!(
        told,
        "made again by: raystep step scene.json 80,60 --strategy exhaustive --at 2 --script 'out s'\n"
    );
    let again = run(
        "step scene.json 80,60 --strategy exhaustive --at 2",
        "out s",
    );
    let second = "raystep-sphere-scene-80,60-2-2.svg";
    assert!(again.contains(&format!("\nsaved as {second}\n")), "{again}");
    assert_eq!(folder.read(name), folder.read(second));
    let svg = String::from_utf8(folder.read(name)).unwrap();
    let drawing = roxmltree::Document::parse(&svg).unwrap();
    let title = drawing.descendants().find(|of| of.has_tag_name("title"));
    let title = title.unwrap().text().unwrap();
    assert!(
        title.starts_with("sphere of ") && title.ends_with(", pixel (80, 60)"),
        "{title}"
    );

    // a place in the grid, from a saved log
    folder
        .run("trace scene.json --strategy grid --region 80,60 -o part.jsonl")
        .well();
    let saved = run("step part.jsonl 80,60", "/kind=cell n s");
    assert!(
        saved.contains("\nsaved as raystep-grid-part-80,60-"),
        "{saved}"
    );
    assert!(
        saved.contains("\nmade again by: raystep step part.jsonl 80,60 --at "),
        "{saved}"
    );
    // three drawings and nothing unfinished
    assert_eq!(folder.names().len(), 2 + 3, "{:?}", folder.names());
}

#[test]
fn where_nothing_is_drawn_s_says_why_and_the_session_goes_on() {
    let folder = Folder::with_scene();
    let ran = with_lines(
        &folder,
        "step scene.json 80,60 --strategy hierarchy --building --predict",
        "s\np\ng 0\n",
    );
    let text = text(ran);
    assert_eq!(
        text.matches("no figure shows this step").count(),
        1,
        "{text}"
    );
    assert_eq!(titles(&text), ["Building", "window point"], "{text}");
    // before a question is answered the drawing would give the answer away
    let ran = with_lines(
        &folder,
        "step scene.json 80,60 --predict",
        "into over into over\ns\nskip\n",
    );
    let text = self::text(ran);
    assert!(
        text.contains("\nanswer the question, or skip it\n"),
        "{text}"
    );
    assert!(!text.contains("saved as"), "{text}");
    assert_eq!(folder.names(), ["scene.json"]);
}

#[test]
fn a_filter_that_finds_no_object_says_why() {
    let folder = Folder::with_scene();
    let told = |words: &str, filter: &str| {
        let mut command = folder.command(words);
        let ran: Ran = command.args(["--script", filter]).output().unwrap().into();
        text(ran)
    };
    let step = "step scene.json 80,60 --strategy";
    let missed = told(&format!("{step} hierarchy"), "/object=C");
    let (_, missed) = missed
        .split_once("\nno step is named by the filter\n")
        .unwrap();
    assert!(
        missed.starts_with("no ray of this pixel enters the leaf that holds \"C\": "),
        "{missed}"
    );
    let missed = told(&format!("{step} hierarchy"), "/object=Q");
    assert!(
        missed.contains("\nthe scene has no object \"Q\""),
        "{missed}"
    );
    // with every object tested there is nothing to say
    let found = told(&format!("{step} exhaustive"), "/object=C");
    assert!(!found.contains("no ray of this pixel"), "{found}");
}
