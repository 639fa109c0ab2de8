//! Pipes, links, permissions and signals, as Unix has them.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::process::Stdio;

use super::run::Folder;

/// Runs the command with a standard output that nobody reads.
#[track_caller]
fn into_closed_pipe(folder: &Folder, words: &str) {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = folder.command(words);
    let output = command.stdout(writer).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), &*stderr), (Some(0), ""), "{words}");
}

#[test]
fn a_closed_pipe_is_no_error_and_nothing_is_said() {
    let folder = Folder::with_scene();
    for words in [
        "schema trace",
        "schema scene",
        "completions bash",
        "--help",
        "trace scene.json --pixels 64,48",
        "render scene.json --pixels 64,48 -o -",
        "render scene.json --pixels 8,8 -o out.png --stats=json",
        "convert scene.json -",
        "pixel scene.json 80,60",
        "pixel scene.json 80,60 --format json",
        "step scene.json 80,60",
        "step scene.json 80,60 --script leaf",
    ] {
        into_closed_pipe(&folder, words);
    }
}

#[test]
fn a_pipe_that_is_closed_after_its_first_byte_is_no_error() {
    let folder = Folder::with_scene();
    for words in ["schema trace", "trace scene.json --pixels 64,48"] {
        let line = format!("$RAYSTEP {words} | head -c 1; echo ${{PIPESTATUS[0]}}");
        assert_eq!(folder.shell(&line).well(), b"{0\n", "{words}");
    }
}

#[test]
fn a_link_stays_a_link_and_its_target_is_replaced() {
    let folder = Folder::with_scene().with("real.png", "old");
    symlink("real.png", folder.path("link.png")).unwrap();
    symlink("new.png", folder.path("dangling.png")).unwrap();
    for [link, real] in [["link.png", "real.png"], ["dangling.png", "new.png"]] {
        folder
            .run(&format!("render scene.json --pixels 8,8 -o {link}"))
            .well();
        assert!(
            fs::symlink_metadata(folder.path(link))
                .unwrap()
                .is_symlink()
        );
        assert!(folder.read(real).starts_with(b"\x89PNG"), "{real}");
    }
}

#[test]
fn new_files_have_the_usual_permissions_and_old_ones_keep_theirs() {
    let folder = Folder::with_scene().with("old.png", "old");
    fs::set_permissions(folder.path("old.png"), PermissionsExt::from_mode(0o604)).unwrap();
    folder
        .shell("umask 027; $RAYSTEP render scene.json --pixels 8,8 -o new.png")
        .well();
    folder
        .shell("umask 027; $RAYSTEP render scene.json --pixels 8,8 -o old.png")
        .well();
    let mode = |name: &str| {
        fs::metadata(folder.path(name))
            .unwrap()
            .permissions()
            .mode()
    };
    assert_eq!(mode("new.png") & 0o777, 0o640);
    assert_eq!(mode("old.png") & 0o777, 0o604);
}

#[test]
fn standard_output_has_a_name_among_the_devices() {
    let folder = Folder::with_scene();
    let dash = folder.run("convert scene.json -").well();
    assert!(folder.run("convert scene.json /dev/stdout").well() == dash);
    let appended = folder.shell("echo first > f; $RAYSTEP convert scene.json /dev/stdout >> f");
    appended.well();
    assert!(folder.read("f").starts_with(b"first\n{"));
}

/// SIGTERM and SIGHUP ended as if they were Ctrl-C, with 130.
#[cfg(target_os = "linux")]
#[test]
fn a_command_that_a_signal_ends_leaves_no_file_and_tells_which_signal_it_was() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        // signals that the test's own caller ignores would be ignored below, too
        let (folder, mut child) = long_trace("env --default-signal=INT,TERM,HUP");
        kill(signal, &child);
        assert_eq!(child.wait().unwrap().code(), Some(code), "{signal}");
        assert_eq!(folder.names(), ["out.jsonl", "scene.json"], "{signal}");
        assert_eq!(folder.read("out.jsonl"), b"old", "{signal}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_that_was_ignored_stays_ignored() {
    let (folder, mut child) = long_trace("env --default-signal=TERM --ignore-signal=HUP");
    kill("HUP", &child);
    kill("TERM", &child);
    assert_eq!(child.wait().unwrap().code(), Some(143));
    assert_eq!(folder.names(), ["out.jsonl", "scene.json"]);
}

/// A trace that takes hours, with its temporary file there already.
#[cfg(target_os = "linux")]
fn long_trace(env: &str) -> (Folder, std::process::Child) {
    use std::time::{Duration, Instant};
    let folder = Folder::with_scene().with("out.jsonl", "old");
    let mut words = env.split(' ');
    let mut command = std::process::Command::new(words.next().unwrap());
    command.args(words).arg(super::run::RAYSTEP);
    command.args("trace scene.json --pixels 8000,8000 -o out.jsonl".split(' '));
    command.args(["--budget", "1000000000000"]);
    command
        .current_dir(folder.path(""))
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let child = command.spawn().unwrap();

    let patience = Instant::now() + Duration::from_mins(1);
    while folder.names().len() < 3 {
        assert!(Instant::now() < patience, "no temporary file in a minute");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(folder.read("out.jsonl"), b"old");
    (folder, child)
}

#[cfg(target_os = "linux")]
fn kill(signal: &str, child: &std::process::Child) {
    let killed = std::process::Command::new("bash")
        .args(["-c", &format!("kill -{signal} {}", child.id())])
        .status();
    assert!(killed.unwrap().success());
}
