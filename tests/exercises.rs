//! The exercises: each solution is right, each stub is not written, and each mistake is caught by its name.

mod alternatives;
mod by_hand;
mod solved;
mod stubs;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use raystep::explain::Part;
use raystep::lesson::exercise::{
    Attempt, CaseSaid, Commands, Exercise, MOST_LINES, Outcome, See, Seeds, Silent, exercises,
    message,
};
use raystep::mistake::{mistake, mistakes};
use raystep::{Chosen, Settings, StrategyName, Tracer, load, record_pixel};

fn lessons() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")
}

fn folders() -> Vec<PathBuf> {
    let entries = fs::read_dir(lessons())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut folders: Vec<_> = entries
        // a folder without exercises, such as the gallery of mistakes, is no lesson of the course
        .filter(|path| path.join("lesson.json").exists() && path.join("exercise.rs").exists())
        .collect();
    folders.sort();
    folders
}

fn told(of: &dyn Exercise, outcome: &Outcome) -> Vec<String> {
    let commands = Commands {
        picture: Some("p.svg".into()),
        ..Commands::default()
    };
    message(of.about(), outcome, &commands)
}

#[test]
fn there_are_at_least_32_and_each_lesson_has_one() {
    let all = exercises();
    assert!(32 <= all.len(), "{}", all.len());
    let of_lessons: BTreeSet<u8> = all.iter().map(|of| of.about().lesson).collect();
    assert_eq!(of_lessons, (1..=12).collect());
    let ids: BTreeSet<String> = all.iter().map(|of| of.about().id()).collect();
    assert_eq!(ids.len(), all.len());
    let order: Vec<u8> = all.iter().map(|of| of.about().lesson).collect();
    assert!(order.is_sorted(), "{order:?}");
}

#[test]
fn what_a_check_compares_belongs_to_the_parts_of_its_exercise_or_of_what_it_uses() {
    for of in exercises() {
        let about = of.about();
        let compared = of.compared();
        assert!(!compared.is_empty(), "{}", about.id());
        for part in compared {
            let is_told = about.parts.contains(&part) || about.uses.contains(&part);
            assert!(is_told, "{}: {part}", about.id());
        }
    }
}

#[test]
fn the_message_of_each_state_says_what_to_do_next() {
    let all = exercises();
    let of = all.iter().find(|of| of.about().name == "walk").unwrap();
    let commands = Commands {
        see: "SEE".into(),
        hint: "HINT".into(),
        file: "FILE".into(),
        picture: None,
    };
    let lines = |outcome: &Outcome| message(of.about(), outcome, &commands);
    let head = "l12_walk  lesson 12: the walk through the grid, to the nearest object";
    let expected = [
        format!("○ {head}: not written"),
        "  write it: FILE".into(),
        "  see it:   SEE".into(),
        "  hint:     HINT".into(),
    ];
    assert_eq!(lines(&Outcome::NotWritten), expected);
    let broken = Outcome::Broken {
        what: "it panicked at 12-grid/exercise.rs:7:\n  index out of bounds".into(),
        case: Some(CaseSaid {
            number: 3,
            note: "aslant".into(),
            given: "o, Δ".into(),
        }),
        place: Some("cell (4, 0, 0)".into()),
    };
    let expected = [
        format!("◐ {head}: broken"),
        "  case 3: aslant".into(),
        "    o, Δ".into(),
        "  ✗ it panicked at 12-grid/exercise.rs:7: index out of bounds".into(),
        "  last visited: cell (4, 0, 0)".into(),
        "  see it:   SEE".into(),
        "  hint:     HINT".into(),
    ];
    assert_eq!(lines(&broken), expected);
    let right = lines(&Outcome::Right { cases: 40 });
    assert!(right[1].contains(of.about().take_away) && right[2].contains(of.about().next));
}

#[test]
fn the_crate_s_own_functions_are_right() {
    for of in exercises() {
        let outcome = of.check_own();
        assert!(
            matches!(outcome, Outcome::Right { cases } if 5 <= cases),
            "{}: {outcome:#?}",
            of.about().id()
        );
    }
}

fn ids(attempts: &[Box<dyn Attempt>]) -> Vec<String> {
    attempts
        .iter()
        .map(|attempt| attempt.about().id())
        .collect()
}

#[test]
fn every_solution_is_right_and_every_stub_is_not_written() {
    let all: Vec<String> = exercises().iter().map(|of| of.about().id()).collect();
    let (solved, stubs) = (solved::attempts::attempts(), stubs::attempts::attempts());
    assert_eq!((ids(&solved), ids(&stubs)), (all.clone(), all));
    for (solved, stub) in solved.iter().zip(&stubs) {
        let outcome = solved.check(&Silent);
        assert!(
            matches!(outcome, Outcome::Right { .. }),
            "{}: {outcome:#?}",
            solved.about().id()
        );
        let outcome = stub.check(&Silent);
        assert!(
            matches!(outcome, Outcome::NotWritten),
            "{}: {outcome:#?}",
            stub.about().id()
        );
    }
}

/// The cases of a secret are made when nobody looks: none of them may lie where rounding decides.
#[test]
fn every_solution_and_every_other_right_function_is_right_with_the_cases_of_any_secret() {
    for secret in 0..20 {
        let seeds = Seeds::of_secret(&format!("secret {secret}"));
        let right = solved::attempts::attempts().into_iter();
        for attempt in right.chain(alternatives::right()) {
            let outcome = attempt.check_with(&seeds, &Silent);
            assert!(
                matches!(outcome, Outcome::Right { cases } if 4 <= cases),
                "{secret}: {}: {outcome:#?}",
                attempt.about().id()
            );
        }
    }
}

#[test]
fn right_functions_that_are_written_another_way_are_right() {
    let mut lessons = BTreeSet::new();
    for attempt in alternatives::right() {
        let outcome = attempt.check(&Silent);
        assert!(
            matches!(outcome, Outcome::Right { .. }),
            "{}: {outcome:#?}",
            attempt.about().id()
        );
        lessons.insert(attempt.about().lesson);
    }
    assert_eq!(lessons, (1..=12).collect(), "one for each lesson");
}

#[test]
fn where_another_form_is_right_the_message_says_which_is_meant_and_accuses_nobody() {
    for attempt in alternatives::other_forms() {
        let Outcome::Wrong(found) = attempt.check(&Silent) else {
            panic!("{}: another form was not seen", attempt.about().id());
        };
        assert!(
            found.form.is_some() && found.mistake.is_none(),
            "{found:#?}"
        );
    }
}

#[test]
fn a_wrong_function_that_is_no_known_mistake_is_wrong_without_a_name() {
    for attempt in alternatives::unnamed() {
        let Outcome::Wrong(found) = attempt.check(&Silent) else {
            panic!("{}", attempt.about().id());
        };
        assert_eq!(
            found.mistake.map(|of| of.name),
            None,
            "{}",
            attempt.about().id()
        );
    }
}

#[test]
fn each_mistake_that_an_exercise_can_make_is_caught_with_its_quantity_and_its_name() {
    let mut seen = BTreeSet::new();
    let mut found = Vec::new();
    for of in exercises() {
        let id = of.about().id();
        let mut can_make: Vec<&str> = Vec::new();
        for mistake in mistakes() {
            match of.check_mistake(mistake) {
                Some(Outcome::Wrong(wrong)) => {
                    assert_eq!(
                        wrong.mistake.map(|of| of.name),
                        Some(mistake.name),
                        "{id}: {wrong:#?}"
                    );
                    let label = &wrong.lines.last().unwrap().label;
                    found.push(format!("{id}: {}: {label}", mistake.name));
                    let lines = told(of, &Outcome::Wrong(wrong.clone()));
                    assert!(lines.len() <= MOST_LINES, "{lines:#?}");
                    assert!(
                        lines.iter().any(|line| line.contains(mistake.sentence)),
                        "{lines:#?}"
                    );
                    assert!(wrong.picture.contains("expected"), "{id}");
                    seen.insert(mistake.name);
                    can_make.push(mistake.name);
                }
                Some(other) => panic!("{id}: {:?}: {other:?}", mistake.name),
                None => {}
            }
        }
        for name in of.about().mistakes {
            assert!(
                mistake(name).is_some() && can_make.contains(name),
                "{id}: {name}"
            );
        }
    }
    let missing: Vec<&str> = mistakes()
        .map(|of| of.name)
        .filter(|name| !seen.contains(name))
        .collect();
    assert!(missing.is_empty(), "no exercise catches {missing:?}");
    let expected = fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/mistakes-caught.txt"),
    );
    let expected = expected.unwrap();
    assert_eq!(
        found,
        expected.lines().collect::<Vec<_>>(),
        "\n{}\n",
        found.join("\n")
    );
}

#[test]
fn the_signature_stands_in_the_exercise_and_the_stub_is_the_solution_without_its_regions() {
    let mut checked = 0;
    for folder in folders() {
        let [exercise, solution] = ["exercise.rs", "solution.rs"]
            .map(|file| fs::read_to_string(folder.join(file)).unwrap());
        let mut stub = String::new();
        let mut skips = false;
        for line in solution.lines() {
            match line.trim() {
                "// BEGIN SOLUTION" => {
                    assert!(!skips);
                    skips = true;
                    stub += &line.replace("// BEGIN SOLUTION", "todo!()");
                    stub.push('\n');
                }
                "// END SOLUTION" => skips = false,
                _ if skips => {}
                _ => {
                    stub += line;
                    stub.push('\n');
                }
            }
        }
        assert!(!skips);
        assert_eq!(exercise, stub, "{}", folder.display());
        let number: u8 = folder.file_name().unwrap().to_str().unwrap()[..2]
            .parse()
            .unwrap();
        // signatures may be broken into lines
        let flat: String = exercise.split_whitespace().collect::<Vec<_>>().join(" ");
        let flat = flat.replace("( ", "(").replace(", )", ")");
        for about in exercises()
            .iter()
            .map(|of| of.about())
            .filter(|about| about.lesson == number)
        {
            assert!(
                flat.contains(about.signature),
                "{}: {}",
                about.id(),
                about.signature
            );
            // the stub's head names the parts that the function works out
            let head: String = exercise
                .lines()
                .take_while(|line| line.starts_with("//!"))
                .collect();
            for part in about.parts {
                assert!(
                    head.contains(part.name()),
                    "{}: {} is not in the head",
                    about.id(),
                    part.name()
                );
            }
            checked += 1;
        }
    }
    assert_eq!(checked, exercises().len());
}

#[test]
fn an_exercise_uses_only_what_earlier_ones_taught() {
    let mut taught: BTreeSet<Part> = BTreeSet::new();
    for of in exercises() {
        let about = of.about();
        for part in about.uses {
            assert!(taught.contains(part), "{} uses {part}", about.id());
        }
        assert!(!about.parts.is_empty());
        taught.extend(about.parts);
    }
}

#[test]
fn the_step_of_each_exercise_is_of_the_kind_that_it_computes() {
    let mut wrong = Vec::new();
    for of in exercises() {
        let about = of.about();
        let (scene, pixel, strategy, step, kind) = match about.see {
            See::Step {
                scene,
                pixel,
                strategy,
                at,
                kind,
            } => (scene, pixel, strategy, at, kind),
            See::Figure(name) => {
                let (lesson, figure) = name.split_once('/').unwrap();
                let text = fs::read_to_string(lessons().join(lesson).join("lesson.json")).unwrap();
                let file: serde_json::Value = serde_json::from_str(&text).unwrap();
                assert!(
                    file["figures"].get(figure).is_some(),
                    "{}: {name}",
                    about.id()
                );
                continue;
            }
        };
        let scene = load(&lessons().join(scene)).unwrap().build().unwrap();
        let strategy: StrategyName = match strategy {
            "" => StrategyName::Exhaustive,
            name => serde_json::from_value(name.into()).unwrap(),
        };
        let settings = Settings {
            strategy,
            ..Settings::default()
        };
        let chosen = Chosen::new(&scene, settings.strategy, &settings.structure).unwrap();
        let tracer = Tracer::new(&scene, &chosen, settings.transport);
        let records = record_pixel(&tracer, pixel, settings.through, false, 1_000_000).unwrap();
        let at = records
            .iter()
            .find(|record| record.step == step && record.pixel.is_some());
        if at.is_none_or(|record| record.event.kind() != kind) {
            let of_kind = records.iter().filter(|record| record.event.kind() == kind);
            let steps: Vec<u32> = of_kind.map(|record| record.step).collect();
            wrong.push(format!(
                "{} {}: {} is at {steps:?}",
                about.id(),
                step,
                kind.name()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn hints_go_from_a_nudge_to_the_line() {
    for of in exercises() {
        let about = of.about();
        assert_eq!(
            about.hints.iter().collect::<BTreeSet<_>>().len(),
            3,
            "{}",
            about.id()
        );
        for text in about
            .hints
            .iter()
            .chain([&about.take_away, &about.next, &about.title])
        {
            assert!(
                !text.is_empty() && text.len() < 300,
                "{}: {text}",
                about.id()
            );
        }
    }
}
