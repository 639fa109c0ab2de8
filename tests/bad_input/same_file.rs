//! An output that is one of the inputs was replaced without a word; now it is refused, and both are named.

use snapbox::{assert_data_eq, str};

use crate::cli::run::{Folder, SCENE};

/// A triangle across the line of sight, from a file of its own.
const MESH: &str = r#"{
  "camera": { "look_at": { "cop": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 }, "pixels": [4, 4] },
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 1 } },
  "objects": [ { "name": "T", "material": "red", "shape": { "mesh": { "file": "mesh.obj" } } } ]
}"#;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

const LESSON: &str = r#"{ "title": "t", "figures": {
  "hit": { "kind": "rays", "scene": "scene.json", "pixel": [4, 4], "caption": "c" } } }"#;

/// A folder with a scene, a mesh, and a lesson of one figure, and links to each.
fn folder() -> Folder {
    let folder = Folder::with_scene()
        .with("mesh.json", MESH)
        .with("mesh.obj", TRIANGLE);
    std::fs::create_dir_all(folder.path("lessons/01-ball")).unwrap();
    folder
        .with(
            "lessons/01-ball/scene.json",
            SCENE.replace("[160, 120]", "[9, 9]"),
        )
        .with("lessons/01-ball/lesson.json", LESSON)
}

/// What the command says to these words, which change none of the files.
#[track_caller]
fn refuses(folder: &Folder, line: &str) -> String {
    let all = || {
        let mut names = folder.names();
        let lesson = std::fs::read_dir(folder.path("lessons/01-ball")).unwrap();
        names.extend(lesson.map(|entry| {
            format!(
                "lessons/01-ball/{}",
                entry.unwrap().file_name().to_str().unwrap()
            )
        }));
        let content = |name: String| {
            let bytes = std::fs::read(folder.path(&name)).unwrap_or_default();
            (name, bytes)
        };
        names.into_iter().map(content).collect::<Vec<_>>()
    };
    let before = all();
    let message = folder.run(line).refused();
    assert!(all() == before, "a file was changed: {line}");
    message
}

#[test]
fn an_output_that_is_the_scene_is_refused() {
    let folder = folder();
    assert_data_eq!(
        refuses(&folder, "trace scene.json -o scene.json"),
        str![[r#"
error: scene.json: this is the file scene.json, which is read
  write to another file

"#]]
    );
    for words in [
        "trace scene.json -o ./scene.json",
        "trace scene.json -o lessons/../scene.json",
        "compare scene.json 4,4 --chart scene.json",
        "trace mesh.json -o mesh.obj",
        "trace mesh.json -o mesh.json",
        "trace mesh.obj -o mesh.obj",
        "compare mesh.json --chart mesh.obj",
    ] {
        let message = refuses(&folder, words);
        assert!(message.contains(", which is read"), "{words}: {message}");
    }
}

#[cfg(unix)]
#[test]
fn an_output_that_leads_to_an_input_through_a_link_is_refused_and_both_are_named() {
    use std::os::unix::fs::symlink;

    let folder = folder();
    symlink("scene.json", folder.path("picture.png")).unwrap();
    symlink("picture.png", folder.path("again.svg")).unwrap();
    std::fs::hard_link(folder.path("scene.json"), folder.path("hard.jsonl")).unwrap();
    symlink("mesh.obj", folder.path("mesh.png")).unwrap();
    for (words, output, input) in [
        (
            "render scene.json -o picture.png",
            "picture.png",
            "scene.json",
        ),
        (
            "render picture.png -o picture.png",
            "picture.png",
            "picture.png",
        ),
        ("trace scene.json -o hard.jsonl", "hard.jsonl", "scene.json"),
        (
            "compare scene.json --chart again.svg",
            "again.svg",
            "scene.json",
        ),
        ("render mesh.json -o mesh.png", "mesh.png", "mesh.obj"),
        ("convert mesh.json mesh.png", "mesh.png", "mesh.obj"),
    ] {
        let message = refuses(&folder, words);
        let says = format!("error: {output}: this is the file {input}, which is read\n");
        assert!(message.starts_with(&says), "{words}: {message}");
    }
    let message = folder.shell("$RAYSTEP trace - -o scene.json < scene.json");
    assert_data_eq!(
        message.refused(),
        str![[r#"
error: scene.json: this is the file on standard input, which is read
  write to another file

"#]]
    );
    assert_eq!(folder.read("scene.json"), SCENE.as_bytes());
}

#[test]
fn a_figure_replaces_nothing_that_it_is_drawn_from() {
    let folder = folder();
    folder
        .run("figure 01-ball/hit --write-log hit.svg -o f.svg")
        .well();
    for (words, input) in [
        (
            "-o lessons/01-ball/lesson.json",
            "lessons/01-ball/lesson.json, which is read",
        ),
        (
            "-o lessons/01-ball/scene.json",
            "lessons/01-ball/scene.json, which is read",
        ),
        (
            "--write-log lessons/01-ball/scene.json -o f.svg",
            "lessons/01-ball/scene.json, which is read",
        ),
        ("--log hit.svg -o hit.svg", "hit.svg, which is read"),
        (
            "--write-log new.svg -o new.svg",
            "new.svg, which --write-log writes",
        ),
        (
            "--write-log ./new.svg -o lessons/../new.svg",
            "./new.svg, which --write-log writes",
        ),
        (
            "--write-log f.svg -o f.svg",
            "f.svg, which --write-log writes",
        ),
        ("--write-log -", "-, which --write-log writes"),
    ] {
        let message = refuses(&folder, &format!("figure 01-ball/hit {words}"));
        let says = format!("this is the file {input}\n");
        assert!(message.contains(&says), "{words}: {message}");
    }
    // of several files too, and before the log or any of them is written: t-01.svg is the first where there are ten
    folder.run("figure 01-ball/hit --steps -o t.svg").well();
    let first = ["t-1.svg", "t-01.svg"]
        .into_iter()
        .find(|name| folder.path(name).exists());
    let first = first.unwrap().replacen('t', "s", 1);
    let message = folder
        .run(&format!(
            "figure 01-ball/hit --steps --write-log {first} -o s.svg"
        ))
        .refused();
    assert!(message.contains("which --write-log writes"), "{message}");
    let left = std::fs::read_dir(folder.path(".")).unwrap();
    let names = left.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let written: Vec<String> = names.filter(|name| name.starts_with("s-")).collect();
    assert_eq!(written, [""; 0]);
}

#[cfg(unix)]
#[test]
fn two_links_to_a_file_that_is_not_there_yet_are_one_file() {
    let folder = folder();
    std::os::unix::fs::symlink("new.svg", folder.path("a.svg")).unwrap();
    let message = refuses(&folder, "figure 01-ball/hit --write-log a.svg -o new.svg");
    assert!(message.contains("this is the file a.svg"), "{message}");
}

#[cfg(unix)]
#[test]
fn figures_replace_no_scene() {
    let folder = folder();
    std::fs::create_dir_all(folder.path("out/01-ball")).unwrap();
    let link = folder.path("out/01-ball/hit.svg");
    std::os::unix::fs::symlink(folder.path("lessons/01-ball/scene.json"), link).unwrap();
    let message = refuses(&folder, "figures --out out");
    assert!(message.contains("scene.json, which is read"), "{message}");
}

#[test]
fn a_scene_converted_onto_itself_and_a_log_filtered_onto_itself_stay_possible() {
    let folder = folder();
    folder.run("convert scene.json scene.json").well();
    folder
        .run("trace scene.json --region 80,60 -o a.jsonl")
        .well();
    let whole = folder.read("a.jsonl");
    folder.run("trace a.jsonl --only ray -o a.jsonl").well();
    let filtered = folder.read("a.jsonl");
    assert!(filtered.len() < whole.len() && filtered.starts_with(b"{\"kind\":\"trace\""));
}
