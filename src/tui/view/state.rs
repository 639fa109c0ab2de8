//! The state: what the step changed, old → new, then what else is known, of the innermost ray first.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

use crate::tui::app::App;
use crate::tui::look::Look;
use crate::tui::view::part::framed;
use crate::tui::view::text::wrapped;

/// The lines of the state.
pub(super) fn lines(app: &App<'_, '_>, room: usize) -> Vec<Line<'static>> {
    let mut lines: Vec<Line> = Vec::new();
    for fact in &app.state {
        let style = if fact.is_new {
            Look::strong()
        } else {
            Look::faint()
        };
        let text = wrapped(&fact.text, room, 2).into_iter();
        lines.extend(text.map(|text| Line::styled(text, style)));
    }
    if lines.is_empty() {
        lines.push(Line::styled("nothing is known yet", Look::faint()));
    }
    lines
}

/// Draws these lines as far as there is room.
pub(super) fn draw(
    app: &App<'_, '_>,
    mut lines: Vec<Line<'static>>,
    look: Look,
    area: Rect,
    frame: &mut Frame<'_>,
) {
    let title = if app.reader.asked().is_some() {
        "state before the step"
    } else {
        "state"
    };
    let inside = framed(title, look, area, frame);
    let height = usize::from(inside.height);
    if height < lines.len() {
        lines.truncate(height.saturating_sub(1));
        lines.push(Line::styled("… v shows all", Look::faint()));
    }
    frame.render_widget(Paragraph::new(lines), inside);
}
