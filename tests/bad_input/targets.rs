//! Outputs that cannot be written: refused before any work, or removed when the work fails.

use snapbox::{assert_data_eq, str};

use crate::cli::run::Folder;

/// Longer than any test: a target that cannot be written is told before this is traced.
const LONG: &str = "--pixels 10000,10000";

/// What the command says to these words, which leave only these files.
#[track_caller]
fn refuses(folder: &Folder, words: &str) -> String {
    let before = folder.names();
    let message = folder.run(words).refused();
    assert_eq!(folder.names(), before, "a file was left behind");
    message
}

#[test]
fn a_folder_that_is_missing_is_told_before_tracing() {
    let folder = Folder::with_scene();
    let words = format!("render scene.json {LONG} -o none/out.png");
    assert_data_eq!(
        refuses(&folder, &words),
        str![[r#"
error: none/out.png: there is no folder none
  create it first, or choose another one

"#]]
    );
}

#[test]
fn a_folder_is_no_target() {
    let folder = Folder::with_scene();
    std::fs::create_dir(folder.path("pictures")).unwrap();
    let words = format!("render scene.json {LONG} -o pictures");
    assert_data_eq!(
        refuses(&folder, &words),
        str![[r#"
error: pictures: this is a folder
  name a file inside it

"#]]
    );
}

#[test]
fn a_folder_that_is_meant_and_missing_is_no_file() {
    let folder = Folder::with_scene();
    let words = format!("trace scene.json {LONG} -o pictures/");
    assert_data_eq!(
        refuses(&folder, &words),
        str![[r#"
error: pictures/: there is no such folder
  create it first, and name a file inside it

"#]]
    );
}

#[test]
fn a_file_is_no_folder() {
    let folder = Folder::with_scene();
    let words = format!("trace scene.json {LONG} -o scene.json/out.jsonl");
    assert_data_eq!(
        refuses(&folder, &words),
        str![[r#"
error: scene.json/out.jsonl: cannot be written: Not a directory (os error 20)
  check the permissions, or choose another folder

"#]]
    );
}

#[cfg(unix)]
#[test]
fn a_loop_of_links_is_told() {
    let folder = Folder::with_scene();
    std::os::unix::fs::symlink("out.png", folder.path("out.png")).unwrap();
    let words = format!("render scene.json {LONG} -o out.png");
    assert_data_eq!(
        refuses(&folder, &words),
        str![[r#"
error: out.png: cannot be written: Too many levels of symbolic links (os error 40)
  check the permissions, or choose another folder

"#]]
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told() {
    let folder = Folder::with_scene();
    assert_data_eq!(
        refuses(&folder, "render scene.json --pixels 8,8 -o /dev/full"),
        str![[r#"
error: /dev/full: cannot be written: No space left on device (os error 28)
  free some space there, or choose another folder

"#]]
    );
    for words in [
        "trace scene.json --pixels 8,8 -o /dev/full",
        "convert scene.json /dev/full",
    ] {
        assert!(refuses(&folder, words).contains("No space left"), "{words}");
    }
    // as standard output
    for words in [
        "pixel scene.json 80,60",
        "pixel scene.json 80,60 --format json",
        "trace scene.json --pixels 8,8",
        "schema trace",
        "completions zsh",
    ] {
        let full = std::fs::File::options()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let output = folder.command(words).stdout(full).output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{words}");
        let start = "error: standard output: cannot be written: No space left on device";
        assert!(stderr.starts_with(start), "{words}: {stderr}");
    }
}

/// A limit on the size of files fails in the middle of the temporary file, as a full disk does.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_leaves_no_file_and_keeps_the_old_one() {
    const LIMIT: &str = "ulimit -f 1; trap '' XFSZ; exec $RAYSTEP";
    let folder = Folder::with_scene();
    let message = folder.shell(&format!(
        "{LIMIT} trace scene.json --pixels 8,8 -o out.jsonl"
    ));
    assert_data_eq!(
        message.refused(),
        str![[r#"
error: out.jsonl: cannot be written: File too large (os error 27)
  raise the limit ('ulimit -f' shows it), or narrow what is written

"#]]
    );
    assert_eq!(folder.names(), ["scene.json"]);

    let folder = folder.with("out.jsonl", "old").with("out.png", "old");
    for words in [
        "trace scene.json --pixels 8,8 -o out.jsonl",
        "render scene.json -o out.png",
        "convert scene.json out.png",
    ] {
        let message = folder.shell(&format!("{LIMIT} {words}")).refused();
        assert!(message.contains("File too large"), "{words}: {message}");
        assert_eq!(folder.names(), ["out.jsonl", "out.png", "scene.json"]);
    }
    assert_eq!(folder.read("out.jsonl"), b"old");
    assert_eq!(folder.read("out.png"), b"old");
}
