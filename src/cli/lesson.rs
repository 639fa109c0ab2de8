//! `raystep lesson`: the course's exercises written out, handed out, listed, shown, hinted at and checked.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use raystep::explain::Part;
use raystep::lesson::exercise::{About, Exercise, Report, exercises};
use raystep::lesson::worksheet::worksheet;
use raystep::lesson::{Dependency, course_files, grading_files, handout_files};

use crate::cli::Error;
use crate::cli::args::{LessonArgs, LessonVerb, ReportFormat};
use crate::cli::course;
use crate::cli::new_folder;
use crate::cli::notes::note;
use crate::cli::output::Output;
use crate::cli::quiz::Quiz;
use crate::cli::same_file::Taken;

/// Does what is asked for.
pub(crate) fn run(args: &LessonArgs) -> Result<ExitCode, Error> {
    match &args.verb {
        LessonVerb::Start { dir, raystep } => start(dir, raystep.as_deref())?,
        LessonVerb::Export {
            dir,
            secret,
            raystep,
        } => export(dir, secret.as_deref(), raystep.as_deref())?,
        LessonVerb::List => print(&list()?)?,
        LessonVerb::Show { lesson } => print(&show(*lesson)?)?,
        LessonVerb::Hint {
            lesson,
            exercise,
            depth,
        } => print(&hint(find(*lesson, exercise)?, *depth))?,
        LessonVerb::Quiz {
            lesson,
            only,
            script,
            lessons,
        } => {
            let quiz = Quiz {
                lesson: *lesson,
                only,
                script: script.as_deref(),
                lessons: lessons.as_ref(),
            };
            quiz.run()?;
        }
        LessonVerb::Worksheet {
            lesson,
            seed,
            answers,
            out,
            lessons,
        } => sheet(*lesson, *seed, *answers, out, lessons.as_ref())?,
        LessonVerb::Check {
            lesson,
            exercise,
            format,
            limit,
        } => return check(*lesson, exercise.as_deref(), *format, *limit),
    }
    Ok(ExitCode::SUCCESS)
}

fn print(text: &str) -> Result<(), Error> {
    Output::standard().write_whole(text.as_bytes())
}

/// Writes the course into a new folder.
fn start(dir: &Path, raystep: Option<&str>) -> Result<(), Error> {
    new_folder::refuse_taken(dir)?;
    new_folder::write(dir, &course_files(&dependency(raystep)?))?;
    print(&format!(
        "The course is in {}. Start with lesson 1:\n  cd {}\n  raystep lesson show 01\n  cargo test -p lessons l01\n",
        dir.display(),
        dir.display()
    ))
}

/// Writes what a lecturer hands out, or with a secret the folder in which the hand-in is checked.
fn export(dir: &Path, secret: Option<&str>, raystep: Option<&str>) -> Result<(), Error> {
    new_folder::refuse_taken(dir)?;
    let dependency = dependency(raystep)?;
    let Some(secret) = secret else {
        new_folder::write(dir, &handout_files(&dependency))?;
        return print(&format!(
            "{} is ready to be handed out: it has no solutions. Its README.md says what students do.\n\
             The folder in which you check the hand-in, with other cases:\n  raystep lesson export GRADING --secret SEED\n",
            dir.display()
        ));
    };
    if secret.trim().is_empty() {
        return Err(Error::Exercise {
            what: "the secret is empty".into(),
            fix: "give a long one that nobody guesses, such as 20 random letters".into(),
        });
    }
    new_folder::write(dir, &grading_files(&dependency, secret))?;
    if secret.chars().count() < LEAST_SECRET {
        note("this secret is short: who tries all of its length finds it, and with it the cases");
    }
    print(&format!(
        "{} checks the hand-in, with cases made from the secret alone. Keep it to yourself; its README.md says how.\n",
        dir.display()
    ))
}

/// 26¹² is more than anybody tries; of digits there are fewer.
const LEAST_SECRET: usize = 12;

/// Where the exercises get raystep from: what looks like a version is one, and what looks like an address.
fn dependency(raystep: Option<&str>) -> Result<Dependency, Error> {
    let Some(raystep) = raystep else {
        return Ok(Dependency::Version(env!("CARGO_PKG_VERSION").into()));
    };
    if raystep.starts_with(|c: char| c.is_ascii_digit() || "^~=<>*".contains(c)) {
        return Ok(Dependency::Version(raystep.into()));
    }
    if raystep.contains("://") || raystep.starts_with("git@") {
        return Ok(Dependency::Git(raystep.into()));
    }
    let folder = Path::new(raystep);
    let is_source = folder.join("Cargo.toml").is_file();
    let absolute = folder.canonicalize().ok().filter(|_| is_source);
    let absolute = absolute.ok_or_else(|| Error::Exercise {
        what: format!("--raystep {raystep}: there is no Cargo.toml in this folder"),
        fix: "give the folder of raystep's source, the address of a Git repository, or a version such as 0.2.0".into(),
    })?;
    Ok(Dependency::Path(absolute.display().to_string()))
}

fn abouts() -> impl Iterator<Item = &'static About> {
    exercises().into_iter().map(Exercise::about)
}

fn find(lesson: u8, name: &str) -> Result<&'static About, Error> {
    let of_lesson = of_lesson(lesson)?;
    let found = of_lesson
        .iter()
        .find(|about| about.name == name || about.id() == name);
    found.copied().ok_or_else(|| Error::Exercise {
        what: format!("lesson {lesson} has no exercise called {name}"),
        fix: format!("its exercises are {}", names(&of_lesson)),
    })
}

fn of_lesson(lesson: u8) -> Result<Vec<&'static About>, Error> {
    let found: Vec<_> = abouts().filter(|about| about.lesson == lesson).collect();
    if found.is_empty() {
        let last = abouts().map(|about| about.lesson).max().unwrap_or(0);
        return Err(Error::Exercise {
            what: format!("there is no lesson {lesson}"),
            fix: format!("the lessons are 1 to {last}"),
        });
    }
    Ok(found)
}

fn names(abouts: &[&About]) -> String {
    let names: Vec<&str> = abouts.iter().map(|about| about.name).collect();
    names.join(", ")
}

/// The folder in which the checks of this course write.
fn written() -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    target.join("lessons")
}

/// What the last check of an exercise said.
fn mark(about: &About) -> char {
    let file = written().join(format!("{}.json", about.id()));
    let report = fs::read_to_string(file)
        .ok()
        .and_then(|text| Report::parse(&text));
    match report.as_ref().map_or("not written", Report::state) {
        "right" => '●',
        "not written" => '○',
        _ => '◐',
    }
}

fn list() -> Result<String, Error> {
    let mut text = String::new();
    let widest = abouts().map(|about| about.name.chars().count()).max();
    let widest = widest.unwrap_or(0);
    for about in abouts() {
        let _ = writeln!(
            text,
            "{} {:02} {:<widest$}  {}",
            mark(about),
            about.lesson,
            about.name,
            about.title
        );
    }
    let right = abouts().filter(|about| mark(about) == '●').count();
    let _ = writeln!(
        text,
        "\n{right} of {} right when they were last checked",
        abouts().count()
    );
    let mut lessons = raystep::lesson::course()?.lessons;
    lessons.retain(|of| !of.content.questions.is_empty());
    let questions: usize = lessons.iter().map(|of| of.content.questions.len()).sum();
    let _ = writeln!(
        text,
        "{questions} questions in {} lessons: raystep lesson quiz 01",
        lessons.len()
    );
    Ok(text)
}

/// The folder of a lesson, as it is named in this folder or below it.
fn folder_of(lesson: u8) -> String {
    let number = format!("{lesson:02}-");
    let found = ["", "lessons"].iter().find_map(|above| {
        let here = if above.is_empty() { "." } else { above };
        let entries = fs::read_dir(here).ok()?.flatten();
        let mut names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        let name = names.find(|name| name.starts_with(&number))?;
        Some(Path::new(above).join(name).display().to_string())
    });
    found.unwrap_or_else(|| format!("{number}…"))
}

/// How many questions a lesson of the course has.
fn questions(lesson: u8) -> Result<usize, Error> {
    let number = format!("{lesson:02}-");
    let course = raystep::lesson::course()?;
    let mut lessons = course.lessons.iter();
    let found = lessons.find(|of| of.name.starts_with(&number));
    Ok(found.map_or(0, |of| of.content.questions.len()))
}

fn show(lesson: u8) -> Result<String, Error> {
    let of_lesson = of_lesson(lesson)?;
    let mut text = format!(
        "Lesson {lesson}: write in {}/exercise.rs\n{} questions: raystep lesson quiz {lesson:02}\n",
        folder_of(lesson),
        questions(lesson)?
    );
    for about in &of_lesson {
        let parts: Vec<&str> = about.parts.iter().map(|part| Part::name(*part)).collect();
        let _ = writeln!(text, "\n{} {}: {}", mark(about), about.name, about.title);
        let _ = writeln!(text, "    {}", about.signature);
        let _ = writeln!(text, "    parts:    {}", parts.join("; "));
        let _ = writeln!(text, "    check:    cargo test -p lessons {}", about.id());
    }
    Ok(text)
}

/// The hints up to a depth.
fn hint(about: &About, depth: u8) -> String {
    let mut text = format!("{}: {}\n", about.id(), about.title);
    for hint in &about.hints[..usize::from(depth)] {
        let _ = writeln!(text, "  {hint}");
    }
    if usize::from(depth) < about.hints.len() {
        let _ = writeln!(
            text,
            "  more: raystep lesson hint {:02} {} --depth {}",
            about.lesson,
            about.name,
            depth + 1
        );
    }
    text
}

/// Writes a worksheet, or the key to it.
fn sheet(
    number: u8,
    seed: u64,
    answers: bool,
    out: &Path,
    lessons: Option<&PathBuf>,
) -> Result<(), Error> {
    let (library, _) = course::library(number, lessons)?;
    let mut sheet = worksheet(&library, course::lesson(&library, number)?, seed)?;
    sheet.draw(&library)?;
    let text = sheet.markdown(answers);
    Output::create(out, &Taken::nothing())?.write_whole(text.as_bytes())
}

/// Runs the checks of the course in this folder.
fn check(
    lesson: Option<u8>,
    exercise: Option<&str>,
    format: ReportFormat,
    limit: u16,
) -> Result<ExitCode, Error> {
    let word = match (lesson, exercise) {
        (None, _) => None,
        (Some(lesson), None) => {
            of_lesson(lesson)?;
            Some(format!("l{lesson:02}_"))
        }
        (Some(lesson), Some(name)) => Some(find(lesson, name)?.id()),
    };
    if !Path::new("Cargo.toml").is_file() {
        return Err(Error::Exercise {
            what: "there is no Cargo.toml in this folder".into(),
            fix: "change to the folder that 'raystep lesson start DIR' has written".into(),
        });
    }
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args([
        "test",
        "--quiet",
        "--package",
        "lessons",
        "--test",
        "check",
        "--",
    ]);
    command.args(word);
    command.args(["--format", format.word()]);
    command.arg("--limit").arg(limit.to_string());
    if exercise.is_some() {
        command.arg("--exact");
    }
    // cargo would say again that a test has failed
    let done = command
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .status();
    let done = done.map_err(|error| Error::Exercise {
        what: format!("cargo cannot be started: {error}"),
        fix: "install Rust (https://rustup.rs)".into(),
    })?;
    Ok(if done.success() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
