//! Which strategy is used where `--strategy` chooses none.

use std::fmt::Write as _;

use serde_json::Value;

use super::run::Folder;

const VIEW: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 6\n\
                    l 3 4 9\nf 1 .5 .5 .8 .2 9 0 0\n";

/// So many spheres in rows of 40, seen from the front.
fn spheres(count: usize) -> String {
    let mut text = String::from(VIEW);
    for i in 0..count {
        let (x, y) = (0.2 * (i % 40) as f64 - 4.0, 0.2 * (i / 40) as f64 - 3.0);
        writeln!(text, "s {x} {y} {} 0.12", -0.3 * (i % 7) as f64).unwrap();
    }
    text
}

/// A fan of so many triangles in z = 0.
fn fan(triangles: usize) -> String {
    let mut text = String::from("v 0 0 0\n");
    for i in 0..=triangles {
        let angle = 6.0 * i as f64 / triangles as f64;
        writeln!(text, "v {} {} 0", angle.cos(), angle.sin()).unwrap();
    }
    for i in 0..triangles {
        writeln!(text, "f 1 {} {}", i + 2, i + 3).unwrap();
    }
    text
}

/// The settings in the head of a log.
fn settings(log: &[u8]) -> Value {
    let first = log.split(|&byte| byte == b'\n').next().unwrap();
    let mut head: Value = serde_json::from_slice(first).unwrap();
    head["settings"].take()
}

#[test]
fn a_picture_is_made_with_the_hierarchy_and_is_that_of_every_strategy() {
    let folder = Folder::empty().with("s.nff", spheres(300));
    let picture = |options: &str| folder.run(&format!("render s.nff -o - {options}")).well();
    let usual = picture("");
    for strategy in ["exhaustive", "hierarchy", "grid"] {
        assert!(
            picture(&format!("--strategy {strategy}")) == usual,
            "{strategy}"
        );
    }
    // options of a hierarchy belong to it
    assert!(picture("--build surface-area --slabs seven") == usual);

    let report = |options: &str| {
        let ran = folder.run(&format!("render s.nff -o a.png --stats {options}"));
        ran.stderr.lines().next().unwrap().to_owned()
    };
    assert_eq!(
        report(""),
        "strategy: hierarchy, bottom-up (chosen by raystep; --strategy chooses another)"
    );
    assert_eq!(
        report("--strategy hierarchy"),
        "strategy: hierarchy, bottom-up"
    );
    assert_eq!(report("--strategy exhaustive"), "strategy: exhaustive");
    let json = folder.run("render s.nff -o a.png --stats=json").well();
    let json: Value = serde_json::from_slice(&json).unwrap();
    assert_eq!(json["strategy"], "hierarchy, bottom-up");
    assert!(
        0 < json["search"]["nodes_entered"].as_u64().unwrap(),
        "{json}"
    );
}

#[test]
fn a_heat_map_shows_the_cost_of_the_simple_ray_tracer_unless_told_otherwise() {
    let folder = Folder::empty().with("s.nff", spheres(60));
    let map = |options: &str| {
        let words = format!("render s.nff --heatmap tests -o - {options}");
        folder.run(&words).well()
    };
    assert!(map("") == map("--strategy exhaustive"));
    assert!(map("") != map("--strategy hierarchy"));
}

#[test]
fn a_pixel_is_traced_against_each_of_a_thousand_objects_and_beyond_by_the_hierarchy() {
    // an eye ray into the corner and no other: one test for each object
    let tests = |folder: &Folder, name: &str, options: &str| {
        let words = format!("trace {name} --region 0,0 --only sphere_test,plane_test {options}");
        let ran = folder.run(&words);
        let strategy = settings(&ran.stdout)["strategy"]
            .as_str()
            .unwrap()
            .to_owned();
        let lines = ran.stdout.split(|&byte| byte == b'\n');
        let tests = lines.filter(|line| {
            line.starts_with(b"{\"kind\":\"sphere_test\"")
                || line.starts_with(b"{\"kind\":\"plane_test\"")
        });
        (strategy, tests.count(), ran.stderr)
    };
    let note = "note: the scene has 1 001 objects (each face of a mesh is one), so the strategy is \
                hierarchy; --strategy exhaustive tests all of them\n";
    for (name, make) in [("s.nff", spheres as fn(usize) -> String), ("m.obj", fan)] {
        let few = Folder::empty().with(name, make(1000));
        let (strategy, count, told) = tests(&few, name, "--transport backward");
        assert_eq!(
            (&*strategy, count, &*told),
            ("exhaustive", 1000, ""),
            "{name}"
        );

        let many = Folder::empty().with(name, make(1001));
        let (strategy, count, told) = tests(&many, name, "--transport backward");
        assert_eq!((&*strategy, &*told), ("hierarchy", note), "{name}");
        assert!(count < 100, "{name}: {count}");
        let (.., told) = tests(&many, name, "--transport backward --quiet");
        assert_eq!(told, "");
        let (strategy, count, told) =
            tests(&many, name, "--transport backward --strategy exhaustive");
        assert_eq!(
            (&*strategy, count, &*told),
            ("exhaustive", 1001, ""),
            "{name}"
        );
    }
}

#[test]
fn a_log_says_which_strategy_was_chosen_and_is_explained_as_the_scene_is() {
    let folder = Folder::empty().with("s.nff", spheres(1001));
    folder
        .run("trace s.nff --region 4,3 -o a.jsonl --quiet")
        .well();
    assert_eq!(settings(&folder.read("a.jsonl"))["strategy"], "hierarchy");
    let scene = folder.run("pixel s.nff 4,3 --quiet").well();
    // from the log nothing is chosen, and nothing noted
    let log = folder.run("pixel a.jsonl 4,3").well();
    assert!(scene == log);
    let ran = folder.run("pixel s.nff 4,3 --stats");
    assert!(
        ran.stderr
            .contains("\nstrategy: hierarchy, bottom-up (chosen"),
        "{}",
        ran.stderr
    );
    let ran = folder.run("pixel a.jsonl 4,3 --stats");
    assert!(
        ran.stderr.starts_with("strategy: hierarchy, bottom-up\n"),
        "{}",
        ran.stderr
    );
}

#[test]
fn an_option_of_another_strategy_is_refused_with_the_one_that_is_used() {
    // what went wrong: "has no effect with --strategy exhaustive", and nobody had written that
    let folder = Folder::with_scene();
    for (words, chosen) in [
        (
            "render scene.json -o a.png --density 3",
            "hierarchy, the default of --strategy",
        ),
        (
            "render scene.json -o a.png --heatmap tests --density 3",
            "exhaustive, the default of --strategy",
        ),
        (
            "pixel scene.json 3,3 --density 3",
            "exhaustive, the default of --strategy",
        ),
        (
            "pixel scene.json 3,3 --density 3 --strategy exhaustive",
            "--strategy exhaustive",
        ),
        (
            "pixel scene.json 3,3 --density 3 --strategy bounds",
            "--strategy bounds and box, the default of --volume",
        ),
        (
            "pixel scene.json 3,3 --density 3 --strategy bounds --volume box",
            "--strategy bounds --volume box",
        ),
    ] {
        let expected = format!(
            "error: --density has no effect with {chosen}\n  omit it, or use --strategy grid\n"
        );
        assert_eq!(folder.run(words).refused(), expected, "{words}");
    }
}
