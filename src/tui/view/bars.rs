//! The bars at the upper and the lower edge: what is shown, what was said, and the keys.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

use crate::scene::printable;
use crate::tui::app::App;
use crate::tui::look::Look;
use crate::tui::view::text::{self, wrapped};

/// The scene, the pixel, the strategy, and how one reads.
pub(super) fn title(app: &App<'_, '_>, area: Rect, frame: &mut Frame<'_>) {
    let titles = &app.titles;
    let [x, y] = titles.pixel;
    let mut text = format!(
        " {}  pixel {x},{y}  {}",
        printable(&titles.scene),
        titles.strategy
    );
    if app.reader.predicts() {
        text.push_str("  predicting");
    }
    if app.reader.filter().is_some() {
        text.push_str("  filtered");
    }
    let line = Line::from(text::cut(&text, usize::from(area.width)));
    frame.render_widget(Paragraph::new(line).style(Look::reversed()), area);
}

/// What was said, in lines; or the line that is typed.
pub(super) fn said(app: &App<'_, '_>, width: u16) -> Vec<String> {
    let width = usize::from(width);
    if let Some(prompt) = &app.prompt {
        let text = format!("{}{}_", prompt.label, printable(&prompt.text));
        return wrapped(&text, width, 0);
    }
    let said = app.said.iter();
    said.flat_map(|text| wrapped(&printable(text), width, 2))
        .collect()
}

pub(super) fn draw_said(said: Vec<String>, area: Rect, frame: &mut Frame<'_>) {
    let lines: Vec<Line> = said.into_iter().map(Line::from).collect();
    frame.render_widget(Paragraph::new(lines).style(Look::strong()), area);
}

/// The keys that are of use now, the most useful first.
pub(super) fn keys(app: &App<'_, '_>, area: Rect, frame: &mut Frame<'_>) {
    let keys: &[[&str; 2]] = if app.prompt.is_some() {
        &[["Enter", "do it"], ["Esc", "leave it"]]
    } else if app.sheet.is_some() {
        &[["↓ ↑", "lines"], ["PgDn PgUp", "pages"], ["Esc", "back"]]
    } else if app.reader.asked().is_some() {
        &[
            ["a b c d", "answer"],
            ["Esc", "skip"],
            ["↓", "go on"],
            ["p", "no questions"],
            ["?", "all keys"],
            ["q", "end"],
        ]
    } else {
        &[
            ["↓ ↑", "step"],
            ["→ ←", "in, out"],
            ["n N", "target"],
            ["w", "who set it"],
            ["?", "all keys"],
            ["q", "end"],
            ["Space", "event"],
            ["/", "filter"],
            ["p", "predict"],
            ["Tab", "drawing"],
            ["g", "go to"],
            ["s", "save"],
            ["x", "strategy"],
        ]
    };
    let mut text = String::new();
    for [key, does] in keys {
        let more = format!(" {key} {does} ");
        if usize::from(area.width) < text::width(&text) + text::width(&more) {
            break;
        }
        text.push_str(&more);
    }
    frame.render_widget(Paragraph::new(text).style(Look::reversed()), area);
}
