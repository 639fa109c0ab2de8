//! Inputs that never end, lead elsewhere, or want to be mistaken for a message.

use snapbox::{assert_data_eq, str};

use crate::cli::figures::course;
use crate::cli::run::{Folder, SCENE};

/// A triangle across the line of sight, from a file of its own.
fn with_mesh(file: &str) -> String {
    format!(
        r#"{{
  "camera": {{ "look_at": {{ "cop": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 }}, "pixels": [4, 4] }},
  "materials": {{ "red": {{ "colour": [1, 0, 0], "diffuse": 1 }} }},
  "objects": [
    {{ "name": "T", "material": "red", "shape": {{ "mesh": {{ "file": "{file}" }} }} }} ]
}}"#
    )
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The command read /dev/zero until the memory was full.
#[cfg(target_os = "linux")]
#[test]
fn an_input_that_never_ends_is_told_with_little_memory() {
    let lesson = r#"{ "title": "t", "figures": { "f": { "kind": "rays", "scene": "/dev/zero", "pixel": [0, 0] } } }"#;
    let folder = course()
        .with("scene.json", SCENE)
        .with("zero.json", with_mesh("/dev/zero"))
        .with("lessons/01-ball/zero.json", lesson);
    std::fs::create_dir(folder.path("lessons/02-zero")).unwrap();
    std::fs::rename(
        folder.path("lessons/01-ball/zero.json"),
        folder.path("lessons/02-zero/lesson.json"),
    )
    .unwrap();
    for words in [
        "pixel /dev/zero 0,0",
        "trace /dev/zero",
        "convert /dev/zero a.json",
        "pixel - 0,0 < /dev/zero",
        "pixel zero.json 0,0 --allow-outside",
        "figure 01-ball/hit --log /dev/zero",
        "figure 02-zero/f --allow-outside",
        "mdbook < /dev/zero",
        "pixel /dev/urandom 0,0",
    ] {
        // half a gigabyte for everything; the program itself takes a tenth of it
        let message = folder
            .shell(&format!("ulimit -v 524288; exec $RAYSTEP {words}"))
            .refused();
        assert!(message.len() < 400, "{words}: {message}");
    }
    let message = folder
        .shell("{ $RAYSTEP trace scene.json --region 0,0; cat /dev/zero; } | $RAYSTEP pixel - 0,0");
    let message = message.refused();
    assert!(message.contains("has a byte 0"), "{message}");
}

#[test]
fn empty_standard_input_is_called_that() {
    let folder = Folder::empty();
    for words in ["pixel - 0,0", "trace -", "convert - a.json"] {
        assert_data_eq!(
            folder.run(words).refused(),
            str![[r#"
error: standard input is empty
  give it a scene or a log, as in: raystep trace scene.json | raystep pixel - 80,60

"#]]
        );
    }
    let message = folder.run("mdbook").refused();
    assert!(message.contains("standard input is empty\n"), "{message}");
}

#[test]
fn a_mesh_outside_of_the_scenes_folder_is_refused_unless_it_is_allowed() {
    let folder = Folder::empty().with("mesh.obj", TRIANGLE);
    std::fs::create_dir(folder.path("scene")).unwrap();
    let folder = folder
        .with("scene/out.json", with_mesh("../mesh.obj"))
        .with("scene/in.json", with_mesh("../scene/mesh.obj"))
        .with("scene/mesh.obj", TRIANGLE)
        .with("scene/secret.json", with_mesh("/etc/hostname"));
    assert_data_eq!(
        folder.run("pixel scene/out.json 1,1").refused(),
        str![[r#"
error: scene/out.json, line 5, at objects[0].shape.mesh.file: the file "../mesh.obj" is outside the folder of the file that names it
  move it there, or allow files outside of it with --allow-outside

"#]]
    );
    for words in [
        "render scene/out.json -o a.png",
        "trace scene/out.json",
        "compare scene/out.json",
        "convert scene/out.json a.json",
        "convert scene/secret.json a.json",
    ] {
        let message = folder.run(words).refused();
        assert!(message.contains("is outside"), "{words}: {message}");
    }
    let inside = folder.run("pixel scene/in.json 1,1").well();
    let allowed = folder
        .run("pixel scene/out.json 1,1 --allow-outside")
        .well();
    assert!(allowed == inside);
    folder
        .run("convert --allow-outside scene/out.json a.json")
        .well();
}

#[test]
fn a_lessons_scene_outside_of_its_folder_is_refused_unless_it_is_allowed() {
    let lesson = |scene: &str| {
        format!(
            "{{ \"title\": \"t\", \"figures\": {{ \"f\": {{ \"kind\": \"rays\",\n\"scene\": \"{scene}\", \"pixel\": [4, 4] }} }} }}"
        )
    };
    let folder = course();
    std::fs::create_dir(folder.path("lessons/02-other")).unwrap();
    let folder = folder.with(
        "lessons/02-other/lesson.json",
        lesson("../01-ball/scene.json"),
    );
    assert_data_eq!(
        folder.run("figure 02-other/f -o f.svg").refused(),
        str![[r#"
error: lessons/02-other/lesson.json, line 2, at figures.f.scene: the file "../01-ball/scene.json" is outside the folder of the file that names it
  move it there, or allow files outside of it with --allow-outside

"#]]
    );
    assert!(folder.run("figures").refused().contains("is outside"));
    folder
        .run("figure 02-other/f -o f.svg --allow-outside")
        .well();
}

/// A key with a line break in it began a line of its own, which looked like a message of the program.
#[test]
fn names_and_keys_stay_on_their_line_in_every_message() {
    let forged = "x\\nnote: all is lost\\u001b[2J\\u2028y";
    let scene = |from: &str, to: &str| {
        assert!(SCENE.contains(from), "the scene has no {from}");
        SCENE.replacen(from, to, 1)
    };
    let folder = Folder::empty()
        .with("key.json", format!("{{ \"{forged}\": 1 }}"))
        .with(
            "unknown.json",
            scene("\"red\",  ", &format!("\"{forged}\",  ")),
        )
        .with(
            "material.json",
            scene(
                "\"red\":   {",
                &format!(
                    "\"{forged}\": {{ \"diffuse\": -1, \"colour\": [0, 0, 0] }}, \"red\":   {{"
                ),
            ),
        )
        .with("mesh.json", with_mesh(forged))
        .with("outside.json", with_mesh(&format!("../{forged}")))
        .with(
            "log.jsonl",
            format!("{{\"kind\":\"trace\",\"version\":1,\"{forged}\":1}}\n"),
        )
        .with("scene.json", SCENE)
        .with("a\nnote: b.json", "{}")
        .with("c\nnote: d.nff", "x");
    for file in [
        "key.json",
        "unknown.json",
        "material.json",
        "mesh.json",
        "outside.json",
        "log.jsonl",
        "a\nnote: b.json",
        "c\nnote: d.nff",
        "none\nnote: e",
    ] {
        let mut command = folder.command("pixel");
        let message: crate::cli::run::Ran = command.args([file, "0,0"]).output().unwrap().into();
        stays(&message.refused(), file);
    }
    for (words, last) in [
        (&["render", "scene.json", "-o"][..], "no\nnote: x/a.png"),
        (
            &["render", "scene.json", "-o", "a.png", "--seed"],
            "1\nnote: x",
        ),
        (&["pixel", "scene.json"], "1\nnote: x"),
        (&["figures", "--lessons"], "a\nnote: b"),
    ] {
        let mut command = folder.command("");
        let message: crate::cli::run::Ran = command.args(words).arg(last).output().unwrap().into();
        stays(&message.refused(), last);
    }
}

/// No line of a message begins as a note does, and nothing in it controls the terminal.
#[track_caller]
fn stays(message: &str, of: &str) {
    let forged = message.lines().any(|line| line.starts_with("note:"));
    assert!(!forged, "{of}: {message}");
    assert!(
        !message.contains(['\u{1b}', '\u{2028}', '\r']),
        "{of}: {message:?}"
    );
}

#[test]
fn a_file_that_ends_in_another_format_is_not_written() {
    let folder = course().with("scene.json", SCENE);
    let before = folder.names();
    assert_data_eq!(
        folder.run("render scene.json -o x.jpg").refused(),
        str![[r#"
error: x.jpg: a picture is not written as .jpg
  name a file that ends in .png

"#]]
    );
    for (words, ends) in [
        ("render scene.json -o x.png.bak", ".png"),
        ("compare scene.json --chart x.png", ".svg"),
        ("figure 01-ball/hit -o x.jpeg", ".svg or .png or .pdf"),
    ] {
        let message = folder.run(words).refused();
        let ends = format!("  name a file that ends in {ends}\n");
        assert!(message.ends_with(&ends), "{words}: {message}");
    }
    assert_eq!(folder.names(), before);
    folder.run("render scene.json --pixels 8,8 -o x.PNG").well();
    folder.run("render scene.json --pixels 8,8 -o x").well();
}

/// 65535 threads were started, which took longer than anybody waits.
#[test]
fn so_many_threads_are_refused() {
    let folder = Folder::with_scene();
    for words in [
        "render scene.json -o a.png",
        "trace scene.json",
        "compare scene.json",
    ] {
        let message = folder.run(&format!("{words} --threads 65535")).refused();
        assert!(message.contains("65535 is not in 1..=1024"), "{message}");
    }
}
