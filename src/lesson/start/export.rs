//! The course as a lecturer hands it out: without solutions, with a workflow that checks each exercise; and the folder in
//! which the lecturer checks what comes back, with cases made from a secret.
//!
//! What is handed out does not depend on the secret, so nothing in it helps to guess the cases of the hand-in.

use std::borrow::Cow;
use std::fmt::Write;

use crate::lesson::exercise::{Exercise, exercises};
use crate::lesson::start::course::{CourseFile, Dependency, course_files};

/// The folder that students get, with their paths from it.
pub fn handout_files(dependency: &Dependency) -> Vec<CourseFile> {
    let mut files = without_solutions(dependency, None);
    files.push(owned("README.md", HANDOUT.into()));
    files.push(owned(".github/workflows/classroom.yml", workflow()));
    files
}

/// The folder in which a lecturer checks what was handed in, with the cases of a secret alone.
pub fn grading_files(dependency: &Dependency, secret: &str) -> Vec<CourseFile> {
    let mut files = without_solutions(dependency, Some(secret));
    files.push(owned("README.md", GRADING.into()));
    files
}

/// What students read.
const HANDOUT: &str = include_str!("handout.md");

/// What the lecturer reads.
const GRADING: &str = include_str!("grading.md");

fn owned(path: &'static str, text: String) -> CourseFile {
    (path, Cow::Owned(text.into_bytes()))
}

fn without_solutions(dependency: &Dependency, secret: Option<&str>) -> Vec<CourseFile> {
    let files = course_files(dependency).into_iter();
    let kept = files.filter(|(path, _)| !tells_the_solution(path));
    let changed = kept.map(|(path, bytes)| {
        let change: fn(&str) -> String = match path {
            "run/Cargo.toml" => package_without_solutions,
            "run/lib.rs" => modules_without_solutions,
            "any-language/README.md" => page_without_samples,
            _ => return (path, bytes),
        };
        let text = String::from_utf8_lossy(&bytes);
        (path, Cow::Owned(change(&text).into_bytes()))
    });
    let mut files: Vec<CourseFile> = changed.collect();
    let of_cases = files
        .iter_mut()
        .filter(|(path, _)| *path == "run/hand_in.rs");
    for (_, bytes) in of_cases {
        *bytes = Cow::Owned(cases(secret).into_bytes());
    }
    files
}

/// A solution, what only the solutions need, or a whole ray tracer in another language.
fn tells_the_solution(path: &str) -> bool {
    path.ends_with("/solution.rs")
        || path == "run/hostile.rs"
        || path.starts_with("any-language/tracer.")
}

/// Which cases the checks have.
fn cases(secret: Option<&str>) -> String {
    let secret = match secret {
        Some(secret) => format!("Some({secret:?})"),
        None => "None".into(),
    };
    format!(
        "//! Which cases the checks have.\n\n\
         /// What the cases are made from; absent where the cases are those of the public course.\n\
         pub(crate) const SECRET: Option<&str> = {secret};\n\n\
         /// Is there a lecturer who has other cases?\n\
         pub(crate) const HAS_OTHERS: bool = true;\n"
    )
}

/// The package of the checks without the feature that takes the solutions in place of the exercises.
fn package_without_solutions(text: &str) -> String {
    // paragraphs, which are apart by an empty line
    let kept = text
        .split("\n\n")
        .filter(|part| !part.contains("solutions"));
    kept.collect::<Vec<_>>().join("\n\n")
}

/// The list of modules, each with the exercise alone.
fn modules_without_solutions(text: &str) -> String {
    let mut out = String::new();
    let mut attribute = String::new();
    for line in text.lines() {
        if attribute.is_empty() && !line.starts_with("#[cfg_attr(") {
            let _ = writeln!(out, "{line}");
            continue;
        }
        attribute.push_str(line.trim());
        if !attribute.ends_with(")]") {
            continue;
        }
        let attribute = std::mem::take(&mut attribute);
        let path = attribute
            .split('"')
            .find(|word| word.ends_with("/exercise.rs"));
        if let Some(path) = path {
            let _ = writeln!(out, "#[path = {path:?}]");
        }
    }
    out
}

/// The page about other languages, without its samples.
fn page_without_samples(text: &str) -> String {
    let end = text.find("\n## Samples").unwrap_or(text.len());
    text[..end].to_owned()
}

/// The workflow of GitHub Classroom, but for its steps, and one of them.
const WORKFLOW: &str = include_str!("classroom.yml.txt");
const STEP: &str = include_str!("classroom-step.yml.txt");

/// The workflow of GitHub Classroom: a command for each exercise, and a report of all.
fn workflow() -> String {
    let ids: Vec<String> = exercises()
        .into_iter()
        .map(|of| Exercise::about(of).id())
        .collect();
    let steps: String = ids.iter().map(|id| STEP.replace("{id}", id)).collect();
    let results = ids.iter().map(|id| {
        let name = id.to_uppercase();
        format!("          {name}_RESULTS: ${{{{ steps.{id}.outputs.result }}}}\n")
    });
    WORKFLOW
        .replace("{steps}\n", &steps)
        .replace("{results}\n", &results.collect::<String>())
        .replace("{runners}", &ids.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_attribute_of_one_or_several_lines_becomes_the_path_of_the_exercise() {
        let text = "#[cfg_attr(feature = \"solutions\", path = \"../a/solution.rs\")]\n\
                    #[cfg_attr(not(feature = \"solutions\"), path = \"../a/exercise.rs\")]\n\
                    #[allow(unused)]\npub mod a;\n\
                    #[cfg_attr(\n    feature = \"solutions\",\n    path = \"../b/solution.rs\"\n)]\n\
                    #[cfg_attr(\n    not(feature = \"solutions\"),\n    path = \"../b/exercise.rs\"\n)]\npub mod b;\n";
        assert_eq!(
            modules_without_solutions(text),
            "#[path = \"../a/exercise.rs\"]\n#[allow(unused)]\npub mod a;\n#[path = \"../b/exercise.rs\"]\npub mod b;\n"
        );
    }

    #[test]
    fn a_secret_is_quoted_as_rust_reads_it() {
        assert!(
            cases(Some("a \"b\" \\")).contains(r#"SECRET: Option<&str> = Some("a \"b\" \\");"#)
        );
        assert!(cases(None).contains("SECRET: Option<&str> = None;"));
    }
}
