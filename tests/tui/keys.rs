//! What keys do.

use raystep::StrategyName;
use raystep::step::{Command, Cursor, KEYS, Shift, StepLog, commands};
use raystep::tui::{App, Effect, Kept, Titles};

use super::{Example, app, press, screen};

const SIZE: [u16; 2] = [80, 24];

#[test]
fn each_key_of_the_table_does_what_its_word_does() {
    let example = Example::new(StrategyName::Grid);
    let log = example.log();
    // from a step in the middle most moves lead somewhere
    let start = Cursor::at(&log, log.leaf(20));
    let mut moved = 0;
    for key in KEYS {
        let mut app = App::new(&log, start, Kept::new(false), Titles::default());
        let effect = app.press(key.key);
        if ["/", "g"].contains(&key.key) {
            // a line is typed first
            assert_eq!((effect, app.here()), (None, start.here), "{key:?}");
            continue;
        }
        let command = commands(key.words[0]).unwrap().remove(0);
        let expected = match command {
            Command::Save => Some(Effect::Save),
            Command::Address => Some(Effect::Address),
            Command::Strategy => Some(Effect::Strategy),
            Command::Pixel(shift) => Some(Effect::Pixel(shift)),
            Command::Quit => Some(Effect::Quit),
            _ => None,
        };
        assert_eq!(effect, expected, "{key:?}");
        if let Command::Move(by) = command {
            // from a single event there is no way in
            let expected = start.moved(&log, by).unwrap_or(start);
            assert_eq!(app.here(), expected.here, "{key:?}");
            moved += usize::from(expected != start);
        }
    }
    assert_eq!(moved, 7);
    let mut app = App::new(&log, start, Kept::new(false), Titles::default());
    assert_eq!(app.press("Shift+→"), Some(Effect::Pixel(Shift::Right)));
    assert_eq!(app.press("Ctrl+C"), Some(Effect::Interrupt));
}

#[test]
fn a_filter_a_step_and_a_command_are_typed_letter_by_letter() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    let typed = |app: &mut App, text: &str| {
        for letter in text.chars() {
            let key = if letter == ' ' {
                "Space".into()
            } else {
                letter.to_string()
            };
            press(app, &[&key]);
        }
    };
    typed(&mut app, "/rejectex");
    assert!(screen(&mut app, SIZE).contains("filter: /rejectex_"));
    press(&mut app, &["Backspace"]);
    typed(&mut app, "d");
    press(&mut app, &["Enter"]);
    // B, C and the floor on the eye ray, all four on the shadow ray
    let shown = screen(&mut app, SIZE);
    assert!(shown.contains("7 steps are named by the filter"), "{shown}");
    assert!(
        shown.lines().next().unwrap().contains("filtered"),
        "{shown}"
    );
    press(&mut app, &["n"]);
    assert!(screen(&mut app, SIZE).contains("B: ellipsoid: rejected, no root"));
    // a step by its number, and one that is not there
    typed(&mut app, "g3");
    press(&mut app, &["Enter"]);
    assert_eq!(app.here(), log.leaf(3));
    typed(&mut app, "g999");
    press(&mut app, &["Enter"]);
    assert!(screen(&mut app, SIZE).contains("there is no step 999: the last one is 16"));
    // left without anything done
    typed(&mut app, "g1");
    press(&mut app, &["Esc"]);
    assert_eq!(app.here(), log.leaf(3));
    // who set a value that is named
    typed(&mut app, "g6");
    press(&mut app, &["Enter"]);
    typed(&mut app, "Wt");
    press(&mut app, &["Enter"]);
    assert!(screen(&mut app, SIZE).contains("nearest hit: A at t = 5.00028, set by"));
    // several commands by their words, of which one has a value
    typed(&mut app, ":g 6 w t");
    press(&mut app, &["Enter"]);
    let shown = screen(&mut app, SIZE);
    assert!(shown.contains("A: sphere: hit"), "{shown}");
    assert!(
        shown.contains("nearest hit: A at t = 5.00028, set by"),
        "{shown}"
    );
    // letters that no key has
    press(&mut app, &["z"]);
    assert!(screen(&mut app, SIZE).contains("there is no command \"z\""));
}

#[test]
fn commands_behind_one_for_others_are_done_in_the_next_log() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut first = app(&log, false);
    for key in [
        ":", "i", "n", "t", "o", "Space", "x", "Space", "d", "o", "w", "n",
    ] {
        assert_eq!(first.press(key), None);
    }
    assert_eq!(first.press("Enter"), Some(Effect::Strategy));
    let other = Example::new(StrategyName::Grid);
    let other_log: StepLog = other.log();
    let here = raystep::step::same_place(&log, first.here(), &other_log).unwrap();
    let at = Cursor::at(&other_log, here);
    let mut second = App::new(&other_log, at, first.keep(), Titles::default());
    assert_eq!(second.here(), here);
    assert_eq!(second.go_on(), None);
    assert_eq!(
        second.here(),
        at.moved(&other_log, raystep::step::Move::Over)
            .unwrap()
            .here
    );
}

#[test]
fn before_the_answer_nothing_on_the_screen_tells_it() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    for size in [SIZE, [200, 60]] {
        let mut app = app(&log, true);
        press(&mut app, &["→", "↓", "→", "↓"]);
        let asked = screen(&mut app, size);
        assert!(asked.contains("Which root"), "{asked}");
        for told in [
            "✓",
            "A: sphere: hit",
            "nearest hit: A at",
            "discriminant 3.997",
            "rejected",
            "missed",
        ] {
            assert!(!asked.contains(told), "{told}\n{asked}");
        }
        // nor does the state, nor the drawing
        press(&mut app, &["v"]);
        assert!(screen(&mut app, size).contains("answer the question, or skip it"));
        press(&mut app, &["s", "a"]);
        let answered = screen(&mut app, size);
        assert!(answered.contains("✓ A: sphere: hit"), "{answered}");
        let verdict = ["right: a", "wrong: a; "]
            .iter()
            .any(|of| answered.contains(of));
        assert!(verdict, "{answered}");
        // what follows is still to be asked
        assert!(!answered.contains("✗"), "{answered}");
        press(&mut app, &["p"]);
        assert!(screen(&mut app, size).contains("✗ B: ellipsoid: rejected"));
    }
}

#[test]
fn lines_over_the_screen_are_turned_and_closed() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    press(&mut app, &["?"]);
    let mut seen = String::new();
    for _ in 0..KEYS.len() {
        let shown = screen(&mut app, SIZE);
        seen.push_str(&shown);
        if !shown.contains("more lines") {
            break;
        }
        press(&mut app, &["↓"]);
    }
    let seen: String = seen.split_whitespace().collect();
    for key in KEYS {
        let does: String = key.does.split_whitespace().collect();
        assert!(seen.contains(&does), "{key:?}");
    }
    // any other key closes them and does what it does
    press(&mut app, &["→"]);
    assert!(screen(&mut app, SIZE).contains(" window point"));
    assert_ne!(Some(app.here()), log.sections().next());
    press(&mut app, &["v", "PgDn", "End", "Home", "Esc"]);
    assert!(screen(&mut app, SIZE).contains(" working ─"));
}
