//! The stepper in a terminal: what its screens show and what its keys do, without a terminal.

mod keys;
mod screens;
mod words;

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use raystep::step::{Cursor, StepLog};
use raystep::tui::{App, Kept, Look, Titles, draw};
use raystep::{Record, Scene, Settings, StrategyName};

use crate::worked_solution::ranges::traced;

/// The scene of the design, a pixel of it, and how it is traced.
pub(crate) struct Example {
    scene: Scene,
    settings: Settings,
    records: Vec<Record>,
}

impl Example {
    /// Pixel (80, 60), whose ray hits A at t = 5.00028.
    fn new(strategy: StrategyName) -> Self {
        let scene = crate::trace_log::built(crate::trace_log::EXAMPLE);
        let settings = Settings {
            strategy,
            ..Settings::default()
        };
        let records = traced(&scene, &settings, [80, 60]);
        Self {
            scene,
            settings,
            records,
        }
    }

    fn log(&self) -> StepLog<'_> {
        StepLog::new(&self.scene, &self.settings, &self.records)
    }
}

/// At the first step of a log.
fn app<'a, 'l>(log: &'a StepLog<'l>, predicts: bool) -> App<'a, 'l> {
    let titles = Titles {
        scene: "scene.json".into(),
        pixel: [80, 60],
        strategy: "exhaustive".into(),
    };
    App::new(
        log,
        Cursor::at_start(log).unwrap(),
        Kept::new(predicts),
        titles,
    )
}

/// Presses keys; none asks for anything that an app cannot do alone.
#[track_caller]
fn press(app: &mut App, keys: &[&str]) {
    for key in keys {
        assert_eq!(app.press(key), None, "{key}");
    }
}

/// What a terminal of this size shows.
fn buffer(app: &mut App, size: [u16; 2], look: Look) -> Buffer {
    app.resize(size);
    let mut terminal = Terminal::new(TestBackend::new(size[0], size[1])).unwrap();
    terminal.draw(|frame| draw(app, look, frame)).unwrap();
    terminal.backend().buffer().clone()
}

/// The lines of the screen, without blanks at their ends.
fn screen(app: &mut App, size: [u16; 2]) -> String {
    let buffer = buffer(app, size, Look::default());
    rows(&buffer, 0).join("\n")
}

/// The rows of a buffer from a column on.
fn rows(buffer: &Buffer, from: u16) -> Vec<String> {
    let row = |y: u16| {
        let cells = (from..buffer.area.width).map(|x| buffer[(x, y)].symbol());
        cells.collect::<String>().trim_end().to_owned()
    };
    (0..buffer.area.height).map(row).collect()
}
