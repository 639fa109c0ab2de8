//! The command does what its help says: files, threads, pipes.

pub(crate) mod run;
pub(crate) mod strategies;

mod export;
pub(crate) mod figures;
pub(crate) mod inspect;
mod lesson;
mod logs;
mod manners;
mod own_figure;
#[cfg(unix)]
mod pipes;
mod quiz;
mod step;
mod usual_strategy;

use raystep::trace::Kind;
use raystep::{NoFiles, Scene, load_bytes};
use run::{Folder, SCENE};
use serde_json::Value;

/// Small enough to trace in a moment, large enough for every thread to get some.
const SMALL: &str = "--pixels 32,24";

const NFF: [(&str, &str); 2] = [
    ("two-balls.nff", include_str!("cli/two-balls.nff")),
    ("all-shapes.nff", include_str!("cli/all-shapes.nff")),
];

fn scene_of(file: &str, text: &[u8]) -> Scene {
    let loaded = load_bytes(file, text, &NoFiles).unwrap();
    loaded.build().unwrap()
}

#[test]
fn a_picture_is_the_same_twice_and_on_any_number_of_threads() {
    let folder = Folder::with_scene();
    let png = |threads: &str| {
        let words = format!("render scene.json {SMALL} -o out.png {threads}");
        folder.run(&words).well();
        folder.read("out.png")
    };
    let first = png("");
    assert!(first.starts_with(b"\x89PNG\r\n"));
    for threads in ["", "--threads 1", "--threads 2"] {
        assert!(png(threads) == first, "{threads}");
    }
}

#[test]
fn a_picture_has_the_size_and_the_colours_that_were_traced() {
    let folder = Folder::with_scene();
    let bytes = folder.run("render scene.json --pixels 7,5 -o -").well();
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (7, 5));
    assert_eq!(
        (info.color_type, info.bit_depth),
        (png::ColorType::Rgb, png::BitDepth::Eight)
    );
    // the corner shows the background 0.6, 0.8, 1.0
    assert_eq!(pixels[..3], [153, 204, 255]);
}

#[test]
fn counting_changes_no_picture() {
    let folder = Folder::with_scene();
    folder
        .run("render scene.json --pixels 32,24 -o a.png")
        .well();
    let counted = folder.run("render scene.json --pixels 32,24 -o b.png --stats");
    assert_eq!(counted.code, Some(0));
    assert!(counted.stderr.contains("eye"), "{}", counted.stderr);
    assert!(folder.read("a.png") == folder.read("b.png"));
}

#[test]
fn counts_in_json_add_up() {
    let folder = Folder::with_scene();
    for verb in ["render", "trace"] {
        let json = folder.run(&format!("{verb} scene.json {SMALL} -o out --stats=json"));
        let json: Value = serde_json::from_slice(&json.well()).unwrap();
        let mut sums = 0;
        let tests = json["tests"].as_object().unwrap();
        for (kind, count) in tests {
            let number = |key: &str| count[key].as_u64().unwrap();
            assert_eq!(number("tests"), number("hits") + number("misses"), "{kind}");
            sums += number("tests");
        }
        assert!(0 < sums, "{verb}");
        assert!(json["seconds"]["tracing"].is_number(), "{json}");
    }
}

#[test]
fn counts_of_a_log_are_those_of_its_trace() {
    let folder = Folder::with_scene();
    let mut traced = folder.run("trace scene.json --pixels 32,24 -o a.jsonl --stats=json");
    let mut read = folder.run("trace a.jsonl -o b.jsonl --stats=json");
    let [traced, read] = [&mut traced, &mut read].map(|ran| {
        let mut json: Value = serde_json::from_slice(&ran.stdout).unwrap();
        json["seconds"].take();
        json
    });
    assert_eq!(traced, read);
}

#[test]
fn a_converted_scene_gives_the_same_picture() {
    for (name, text) in NFF {
        let folder = Folder::empty().with(name, text);
        folder.run(&format!("convert {name} out.json")).well();
        for [file, picture] in [[name, "a.png"], ["out.json", "b.png"]] {
            folder.run(&format!("render {file} -o {picture}")).well();
        }
        assert!(folder.read("a.png") == folder.read("b.png"), "{name}");
        let [before, after] = [
            scene_of(name, text.as_bytes()),
            scene_of("out.json", &folder.read("out.json")),
        ];
        assert_eq!(before, after, "{name}");
    }
}

#[test]
fn glass_of_nff_without_a_specular_share_spawns_no_reflected_ray() {
    // Ks, the fifth number, is also the weight of the reflected ray: 0 is what the file says
    let rays = |specular: &str, purpose: &str| {
        let text = format!(
            "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 30\nhither 1\nresolution 9 9\n\
             l 3 4 9\nf 1 1 1 .1 {specular} 9 .8 1.5\ns 0 0 0 1\n"
        );
        let folder = Folder::empty().with("s.nff", text);
        let json = folder.run("render s.nff -o a.png --stats=json").well();
        let json: Value = serde_json::from_slice(&json).unwrap();
        json["rays"][purpose]["traced"].as_u64().unwrap()
    };
    assert_eq!(rays("0", "reflected"), 0);
    assert!(0 < rays("0", "refracted"));
    assert!(0 < rays("0.2", "reflected"));
}

#[test]
fn a_converted_scene_is_converted_to_itself_in_place() {
    let folder = Folder::with_scene();
    folder.run("convert scene.json out.json").well();
    let first = folder.read("out.json");
    folder.run("convert out.json out.json").well();
    assert!(folder.read("out.json") == first);
    assert_eq!(
        scene_of("a.json", SCENE.as_bytes()),
        scene_of("b.json", &first)
    );
    // one object to a line
    let text = String::from_utf8(first).unwrap();
    let objects = text.lines().filter(|line| line.contains("\"shape\""));
    assert_eq!(objects.count(), 4, "{text}");
}

#[test]
fn the_scene_is_taken_out_of_a_log() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 3,3 -o a.jsonl")
        .well();
    let scene = folder.run("convert a.jsonl -").well();
    assert_eq!(scene_of("a.json", SCENE.as_bytes()), scene_of("-", &scene));
}

#[test]
fn a_mesh_file_is_found_beside_the_scene() {
    let folder = Folder::empty().with("roof.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let sphere = r#"{ "sphere": { "center": [0, 1, 0], "radius": 1 } }"#;
    let scene = SCENE.replace(sphere, r#"{ "mesh": { "file": "roof.obj" } }"#);
    assert_ne!(scene, SCENE);
    let folder = folder.with("scene.json", scene);
    let json = folder.run("convert scene.json -").well();
    let json = String::from_utf8(json).unwrap();
    assert!(
        json.contains(r#""vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"#),
        "{json}"
    );
}

#[test]
fn schemas_are_json() {
    let folder = Folder::empty();
    for of in ["scene", "trace"] {
        let schema = folder.run(&format!("schema {of}")).well();
        let schema: Value = serde_json::from_slice(&schema).unwrap();
        assert_eq!(
            schema["$schema"],
            "https://json-schema.org/draft/2020-12/schema"
        );
    }
}

#[test]
fn completions_know_every_verb() {
    let folder = Folder::empty();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = folder.run(&format!("completions {shell}")).well();
        let script = String::from_utf8(script).unwrap();
        for verb in [
            "pixel",
            "trace",
            "render",
            "convert",
            "schema",
            "completions",
        ] {
            assert!(script.contains(verb), "{shell}: {verb}");
        }
    }
}

#[test]
fn every_verb_has_an_example_in_its_help() {
    let folder = Folder::empty();
    for verb in [
        "pixel",
        "trace",
        "render",
        "convert",
        "schema",
        "completions",
    ] {
        let help = String::from_utf8(folder.run(&format!("{verb} --help")).well()).unwrap();
        assert!(help.contains(&format!("  raystep {verb} ")), "{help}");
    }
}

#[test]
fn a_pixel_is_explained_in_markdown_and_html() {
    let folder = Folder::with_scene();
    let markdown = folder
        .run("pixel scene.json 80,60 --format markdown")
        .well();
    let markdown = String::from_utf8(markdown).unwrap();
    assert!(markdown.starts_with("- **Pixel (80, 60) of"), "{markdown}");
    let html = folder.run("pixel scene.json 80,60 --format html").well();
    let html = String::from_utf8(html).unwrap();
    assert!(html.starts_with("<!DOCTYPE html>"), "{html}");
    assert!(html.contains("data-part=\"discriminant\""), "{html}");
}

/// Only the command knows its options: the page says what is left out, the command how to see it.
#[test]
fn the_command_says_which_option_shows_what_is_left_out() {
    let folder = Folder::with_scene();
    let text = folder.run("pixel scene.json 80,60 --ray 0").well();
    let text = String::from_utf8(text).unwrap();
    assert!(text.contains(" (--ray 1)\n"), "{text}");
    let built = folder
        .run("pixel scene.json 80,60 --strategy grid --grid 8,8,8 --building")
        .well();
    let built = String::from_utf8(built).unwrap();
    assert!(built.contains("more steps (--all shows them)\n"), "{built}");
}

#[test]
fn a_pixel_is_explained_without_colour_into_a_pipe() {
    let folder = Folder::with_scene();
    let text = String::from_utf8(folder.run("pixel scene.json 80,60").well()).unwrap();
    assert!(!text.trim().is_empty());
    assert!(!text.contains('\u{1b}'), "{text}");
    let json = folder.run("pixel scene.json 80,60 --format json").well();
    assert!(serde_json::from_slice::<Value>(&json).unwrap().is_object());
}

#[test]
fn scenes_are_read_from_standard_input_whatever_their_format() {
    for (name, text) in [("scene.json", SCENE), NFF[0]] {
        let folder = Folder::empty().with(name, text);
        let from_file = folder.run(&format!("render {name} -o -")).well();
        let mut command = folder.command("render - -o -");
        command.stdin(std::fs::File::open(folder.path(name)).unwrap());
        let from_pipe = command.output().unwrap();
        assert!(from_pipe.stdout == from_file, "{name}");
    }
}

#[test]
fn every_kind_can_be_asked_for() {
    let folder = Folder::with_scene();
    let all = Kind::ALL.map(Kind::name).join(",");
    let ran = folder
        .run(&format!("trace scene.json --region 80,60 --only {all}"))
        .well();
    let first = ran.split(|&byte| byte == b'\n').next().unwrap();
    let header: Value = serde_json::from_slice(first).unwrap();
    assert_eq!(
        header["settings"]["only"].as_array().unwrap().len(),
        Kind::ALL.len()
    );
}
