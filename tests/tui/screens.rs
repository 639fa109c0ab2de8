//! What the screens show, in every size.

use ratatui::style::{Color, Modifier};
use raystep::lesson::Thumbnail;
use raystep::step::StepLog;
use raystep::tui::{Colours, Look};
use raystep::{Scene, Settings, StrategyName};

use super::{Example, app, buffer, press, rows, screen};

/// All on one screen of 80 × 24: where one is, the tree with signs, the working, the state, the keys.
#[test]
fn eighty_columns_and_twenty_four_rows_suffice() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    press(&mut app, &["→", "↓", "→", "↓", "↓"]);
    let shown = screen(&mut app, [80, 24]);
    snapbox::assert_data_eq!(
        shown,
        snapbox::str![[r#"
 scene.json  pixel 80,60  exhaustive
 steps ─────────────────────────── working ─────────────────────────────────────
▾· Pixel (80, 60)                 B: ellipsoid: rejected, no root
  · window point                  test, step 4 of 16, ray 0
 ▾✓ Ray 0: eye ray, depth 1: hit  B: ellipsoid, centre (2, 1, 0), radii (1,
   · start of ray 0                 0.5, 0.5)
  ▸✓ A: sphere: hit                 frame: space divided by the radii: there
   ✗ B: ellipsoid: rejected, no …     the ellipsoid is the unit sphere, and t
   ✗ C: box: rejected, empty          is the same
   ✗ floor: polygon: rejected, b…   o − centre → (o − centre)/radii = (−2, 0,
  ▸✓ Ray 1: shadow ray to light …     12)
   ✓ light "lamp": visible          Δ → Δ/radii = (0.0030330574, −0.0060661148,
   · shade of A                       −1.9999816)
   ✓ end of ray 0: hit              a, b, c of a·t² + b·t + c = 0 … (iii)
  · colour of the pixel             a = Δ·Δ = 0.0030330574² + (−0.0060661148)²
                                      + (−1.9999816)² = 3.9999724
                                    b = 2·Δ·(o − centre) = 2·[0.0030330574·(−2)
                                      + (−0.0060661148)·0 + (−1.9999816)·12] =
                                      −48.011691
                                  … 10 more lines: Enter shows all
                                   state ───────────────────────────────────────
                                  ray 0, nearest hit: A at t = 5.00028, set by
                                    step 3
 ↓ ↑ step  → ← in, out  n N target  w who set it  ? all keys  q end
"#]]
    );
}

#[test]
fn the_drawing_stands_beside_the_working_from_110_columns_and_behind_tab_below() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    press(&mut app, &["→", "↓", "→", "↓"]);
    let is_drawn = |shown: &str| shown.contains(" drawing up to here ");
    let is_told = |shown: &str| shown.contains(" working ");
    let narrow = screen(&mut app, [109, 40]);
    assert!(!is_drawn(&narrow) && is_told(&narrow), "{narrow}");
    let wide = screen(&mut app, [110, 40]);
    assert!(is_drawn(&wide) && is_told(&wide), "{wide}");
    let wide = screen(&mut app, [160, 45]);
    // the sphere with its two roots, and points on them
    for mark in ["●", "○", "t₁ = 5", "the hit"] {
        assert!(wide.contains(mark), "{mark}\n{wide}");
    }
    let dots = wide
        .chars()
        .filter(|c| ('\u{2801}'..='\u{28ff}').contains(c));
    assert!(60 < dots.count(), "{wide}");
    // back to a small terminal, where it is behind Tab
    let narrow = screen(&mut app, [80, 24]);
    assert!(!is_drawn(&narrow), "{narrow}");
    press(&mut app, &["Tab"]);
    let narrow = screen(&mut app, [80, 24]);
    assert!(is_drawn(&narrow) && !is_told(&narrow), "{narrow}");
    press(&mut app, &["Tab"]);
    assert!(is_told(&screen(&mut app, [80, 24])));
}

/// At the start of the eye ray there is no shadow ray yet, at its end there is.
#[test]
fn the_drawing_ends_with_the_step() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    let size = [200, 60];
    press(&mut app, &["→", "↓", "→"]);
    // the drawing begins behind 54 columns of the tree and 70 of the working
    let drawn = |app: &mut _| rows(&buffer(app, size, Look::default()), 125).join("\n");
    let before = drawn(&mut app);
    assert!(!before.contains("shadow ray"), "{before}");
    press(&mut app, &["End"]);
    press(&mut app, &["←"]);
    let after = drawn(&mut app);
    assert!(
        after.contains("shadow ray") && after.contains("lamp"),
        "{after}"
    );
}

#[test]
fn every_screen_is_drawn_in_every_size() {
    let screens: [&[&str]; 9] = [
        &[],
        &["→", "↓", "→", "↓"],
        &["Tab", "n", "n"],
        &["End", "v"],
        &["?", "PgDn"],
        &["n", "Enter"],
        &["/", "r", "e", "j"],
        &["p", "n", "n", "n"],
        &["z"],
    ];
    let mut drawn = 0;
    for strategy in crate::step::STRATEGIES {
        let example = Example::new(strategy);
        let log = example.log();
        for keys in screens {
            for size in [
                [80, 24],
                [200, 60],
                [110, 30],
                [40, 12],
                [12, 4],
                [3, 2],
                [1, 1],
            ] {
                let mut app = app(&log, false);
                app.set_picture(Some(Thumbnail {
                    size: [32, 24],
                    rgb: vec![[200, 100, 50]; 32 * 24],
                }));
                press(&mut app, keys);
                for look in [
                    Look::default(),
                    Look {
                        colours: Colours::All,
                        is_ascii: true,
                    },
                ] {
                    let buffer = buffer(&mut app, size, look);
                    let all = rows(&buffer, 0).concat();
                    assert!(!all.contains(char::is_control), "{all:?}");
                    drawn += 1;
                }
            }
        }
    }
    assert_eq!(drawn, 6 * 9 * 7 * 2);
}

#[test]
fn without_colours_there_are_none_and_signs_say_the_same() {
    let example = Example::new(StrategyName::Hierarchy);
    let log = example.log();
    let mut app = app(&log, false);
    app.set_picture(Some(Thumbnail {
        size: [32, 24],
        rgb: vec![[200, 100, 50]; 32 * 24],
    }));
    press(&mut app, &["→", "↓", "→", "n"]);
    let plain = buffer(&mut app, [160, 50], Look::default());
    for cell in plain.content() {
        assert_eq!([cell.fg, cell.bg], [Color::Reset; 2], "{cell:?}");
    }
    // where the reader stands is reversed, in the tree alone
    let reversed = |x: u16, y: u16| plain[(x, y)].modifier.contains(Modifier::REVERSED);
    let marked = (1..45).filter(|&y| reversed(10, y)).count();
    assert_eq!(marked, 1);
    let coloured = buffer(
        &mut app,
        [160, 50],
        Look {
            colours: Colours::Many,
            is_ascii: false,
        },
    );
    let used: std::collections::BTreeSet<String> = coloured
        .content()
        .iter()
        .map(|cell| format!("{:?}", cell.fg))
        .collect();
    assert!(4 <= used.len(), "{used:?}");
    // the words are the same in both, but for the picture
    let left = |buffer| -> Vec<String> {
        let rows = rows(buffer, 0);
        rows.into_iter()
            .filter(|row| row.contains("✓") || row.contains("✗"))
            .collect()
    };
    assert_eq!(left(&plain).len(), left(&coloured).len());
    assert!(3 < left(&plain).len());
}

#[test]
fn with_letters_of_ascii_no_sign_and_no_line_is_drawn_with_others() {
    let example = Example::new(StrategyName::Hierarchy);
    let log = example.log();
    let mut app = app(&log, false);
    app.set_picture(Some(Thumbnail {
        size: [32, 24],
        rgb: vec![[200, 100, 50]; 32 * 24],
    }));
    press(&mut app, &["→", "↓", "→", "n", "n"]);
    let look = Look {
        colours: Colours::None,
        is_ascii: true,
    };
    let buffer = buffer(&mut app, [160, 50], look);
    let all = rows(&buffer, 0).join("\n");
    let is_drawn =
        |c: char| ('\u{2500}'..='\u{25ff}').contains(&c) || ('\u{2700}'..='\u{28ff}').contains(&c);
    assert!(!all.contains(is_drawn), "{all}");
    assert!(
        all.contains("+ ") && all.contains("x ") && all.contains('@'),
        "{all}"
    );
}

/// A picture of two pixels, the left one dark: pixel (80, 60) of 160 × 120 is in the right one.
#[test]
fn the_small_picture_has_two_pixels_a_letter_and_a_mark() {
    let example = Example::new(StrategyName::Exhaustive);
    let log = example.log();
    let mut app = app(&log, false);
    app.set_picture(Some(Thumbnail {
        size: [2, 2],
        rgb: vec![[0, 0, 0], [10, 20, 30], [250, 0, 0], [255, 255, 255]],
    }));
    let look = Look {
        colours: Colours::All,
        is_ascii: false,
    };
    let buffer = buffer(&mut app, [120, 40], look);
    let title = rows(&buffer, 0)
        .iter()
        .position(|row| row.starts_with(" pixel 80,60 "));
    let y = title.unwrap() as u16 + 1;
    let left = &buffer[(0, y)];
    assert_eq!(
        (left.symbol(), left.fg, left.bg),
        ("▀", Color::Rgb(0, 0, 0), Color::Rgb(250, 0, 0))
    );
    // the lower right one is white, so its mark is black
    let right = &buffer[(1, y)];
    assert_eq!(
        (right.symbol(), right.fg, right.bg),
        ("◆", Color::Rgb(0, 0, 0), Color::Rgb(255, 255, 255))
    );
}

#[test]
fn a_hostile_name_stays_text() {
    let text = crate::trace_log::EXAMPLE.replace(
        "\"name\": \"A\"",
        "\"name\": \"\\u001b[31mA\\u0007\\u202e\"",
    );
    assert_ne!(text, crate::trace_log::EXAMPLE);
    let scene: Scene = crate::trace_log::built(&text);
    let settings = Settings::default();
    let records = crate::worked_solution::ranges::traced(&scene, &settings, [80, 60]);
    let log = StepLog::new(&scene, &settings, &records);
    let mut app = app(&log, false);
    press(&mut app, &["→", "↓", "→", "↓"]);
    for size in [[80, 24], [200, 60]] {
        let shown = screen(&mut app, size);
        let is_bad = |c: char| c.is_control() && c != '\n' || c == '\u{202e}';
        assert!(!shown.contains(is_bad), "{shown:?}");
        assert!(shown.contains("[31mA"), "{shown}");
    }
}
