//! Logs: the same bytes always, filtered again, explained again.
#![allow(
    clippy::needless_raw_string_hashes,
    reason = "snapbox writes the snapshots so"
)]

use super::SMALL;
use super::run::Folder;

#[test]
fn a_log_is_the_same_twice_and_on_any_number_of_threads() {
    let folder = Folder::with_scene();
    let log = |threads: &str| {
        folder
            .run(&format!("trace scene.json {SMALL} {threads}"))
            .well()
    };
    let first = log("");
    for threads in ["", "--threads 1", "--threads 2"] {
        assert!(log(threads) == first, "{threads}");
    }
    folder
        .run(&format!("trace scene.json {SMALL} -o out.jsonl"))
        .well();
    assert!(folder.read("out.jsonl") == first);
}

#[test]
fn a_log_that_is_filtered_by_nothing_is_the_same_log() {
    let folder = Folder::with_scene();
    folder
        .run(&format!("trace scene.json {SMALL} --one-sided -o a.jsonl"))
        .well();
    folder.run("trace a.jsonl -o b.jsonl").well();
    assert!(folder.read("a.jsonl") == folder.read("b.jsonl"));
}

#[test]
fn filtering_a_log_gives_what_filtering_the_trace_gives() {
    let folder = Folder::with_scene();
    folder
        .run(&format!("trace scene.json {SMALL} -o whole.jsonl"))
        .well();
    for narrow in [
        "--region 3,4-20,15",
        "--only ray,sphere_test",
        "--only sphere_test,ray --region 16,12",
    ] {
        folder
            .run(&format!("trace scene.json {SMALL} {narrow} -o a.jsonl"))
            .well();
        folder
            .run(&format!("trace whole.jsonl {narrow} -o b.jsonl"))
            .well();
        assert!(folder.read("a.jsonl") == folder.read("b.jsonl"), "{narrow}");
    }
}

#[test]
fn filtering_twice_keeps_what_both_want() {
    let folder = Folder::with_scene();
    let trace = |words: &str| folder.run(&format!("trace {words}")).well();
    trace(&format!(
        "scene.json {SMALL} --region 3,4-20,15 --only ray,shade -o a.jsonl"
    ));
    let twice = trace("a.jsonl --region 10,10-31,23 --only shade,nearest");
    let once = trace(&format!(
        "scene.json {SMALL} --region 10,10-20,15 --only shade"
    ));
    assert!(twice == once);
}

#[test]
fn a_pixel_of_a_log_is_explained_as_the_scene_is() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 70,50-81,61 -o a.jsonl")
        .well();
    folder
        .run("trace scene.json --pixels 16,12 -o b.jsonl")
        .well();
    for options in [
        "",
        "--all",
        "--only sphere_test",
        "--ray 0",
        "--format json",
    ] {
        let scene = folder.run(&format!("pixel scene.json --pixels 16,12 8,6 {options}"));
        let log = folder.run(&format!("pixel b.jsonl 8,6 {options}"));
        assert_eq!(
            String::from_utf8(scene.well()),
            String::from_utf8(log.well())
        );
    }
    assert_eq!(folder.run("pixel a.jsonl 80,60").code, Some(0));
}

#[cfg(unix)]
#[test]
fn a_log_is_read_from_a_pipe() {
    let folder = Folder::with_scene();
    let direct = folder
        .run(&format!("pixel scene.json {SMALL} 16,12"))
        .well();
    let line =
        format!("$RAYSTEP trace scene.json {SMALL} | $RAYSTEP trace - | $RAYSTEP pixel - 16,12");
    assert!(folder.shell(&line).well() == direct);
}

#[test]
fn what_a_log_does_not_hold_is_told() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 3,4-20,15 --only ray,shade -o a.jsonl")
        .well();
    let refused = |words: &str| folder.run(words).refused();
    snapbox::assert_data_eq!(
        refused("pixel a.jsonl 30,30"),
        snapbox::str![[r#"
error: a.jsonl: this log has only the pixels 3,4-20,15, and 30,30 is not one of them
  choose one of them, or trace the scene again

"#]]
    );
    snapbox::assert_data_eq!(
        refused("pixel a.jsonl 5,5 --only nearest"),
        snapbox::str![[r#"
error: a.jsonl: this log has only ray, shade
  choose --only among them, or trace the scene again

"#]]
    );
    snapbox::assert_data_eq!(
        refused("trace a.jsonl --only nearest"),
        snapbox::str![[r#"
error: a.jsonl: this log has only ray, shade
  choose among them, or trace the scene again

"#]]
    );
    snapbox::assert_data_eq!(
        refused("trace a.jsonl --region 30,30-31,31"),
        snapbox::str![[r#"
error: a.jsonl: this log has only the pixels 3,4-20,15, none of them in 30,30-31,31
  choose among them, or trace the scene again

"#]]
    );
    snapbox::assert_data_eq!(
        refused("trace a.jsonl -o b.jsonl --stats=json"),
        snapbox::str![[r#"
error: a.jsonl: --stats counts all kinds, and this log has only ray, shade
  count a log that was made without --only

"#]]
    );
    snapbox::assert_data_eq!(
        refused("pixel a.jsonl 5,5 --pixels 8,8 --one-sided"),
        snapbox::str![[r#"
error: a.jsonl: this is a log, and --pixels and --one-sided ask for new rays, which need the scene
  give the scene; 'raystep convert' extracts it from the log

"#]]
    );
    snapbox::assert_data_eq!(
        refused("render a.jsonl -o a.png"),
        snapbox::str![[r#"
error: a.jsonl: this is a log, and a picture needs new rays, which need the scene
  give the scene; 'raystep convert' extracts it from the log

"#]]
    );
    assert_eq!(folder.names(), ["a.jsonl", "scene.json"]);
}

#[test]
fn a_damaged_log_is_told_by_line_and_leaves_no_file() {
    let folder = Folder::with_scene();
    let log = folder.run("trace scene.json --region 80,60").well();
    let cut = &log[..log.len() - 10];
    let folder = folder.with("cut.jsonl", cut);
    snapbox::assert_data_eq!(
        folder.run("trace cut.jsonl -o out.jsonl").refused(),
        snapbox::str![[r#"
error: cut.jsonl, line 22: the line has no end: the log was cut off here
  the log is damaged: make it again with 'raystep trace'

"#]]
    );
    assert_eq!(folder.names(), ["cut.jsonl", "scene.json"]);
}

#[test]
fn a_pixel_lit_by_paths_of_light_is_told_the_same_from_a_log_and_from_a_log_of_that_log() {
    let folder = Folder::empty().with("scene.json", crate::worked_solution::light::GLASS);
    for transport in [
        "forward --paths 3000 --aperture 0.4",
        "hybrid-stored --paths 500 --nearest 9",
        "hybrid-connected --samples 2",
    ] {
        let run = |words: String| folder.run(&words).well();
        let told = run(format!("pixel scene.json 2,3 --transport {transport}"));
        run(format!(
            "trace scene.json --transport {transport} -o whole.jsonl"
        ));
        run("trace whole.jsonl --region 2,3 -o pixel.jsonl".into());
        for log in ["whole.jsonl", "pixel.jsonl"] {
            assert!(run(format!("pixel {log} 2,3")) == told, "{log} {transport}");
        }
        // a trace of the pixel alone keeps no path that did not lead to it
        run(format!(
            "trace scene.json --transport {transport} --region 2,3 -o traced.jsonl"
        ));
        assert!(run("pixel traced.jsonl 2,3".into()) == told, "{transport}");
    }
}
