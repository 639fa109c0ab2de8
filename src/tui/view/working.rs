//! The working of the step, or its question.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

use crate::step::subject;
use crate::tui::app::App;
use crate::tui::look::Look;
use crate::tui::view::part::framed;
use crate::tui::view::text::{page, wrapped};

/// The title of the step, where it is, and its working.
pub(super) fn lines(app: &App<'_, '_>, look: Look, room: usize) -> Vec<Line<'static>> {
    let title = if app.reader.asked().is_some() {
        subject(app.log(), app.here())
    } else {
        app.told.title.clone()
    };
    let title = wrapped(&title, room, 2).into_iter();
    let mut lines: Vec<Line> = title
        .map(|text| Line::styled(text, Look::strong()))
        .collect();
    let place = wrapped(&app.told.place, room, 2).into_iter();
    lines.extend(place.map(|text| Line::styled(text, Look::faint())));
    lines.extend(page(&app.working(), look, room, 2));
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
    let is_asked = app.reader.asked().is_some();
    let title = if is_asked { "question" } else { "working" };
    let inside = framed(title, look, area, frame);
    let height = usize::from(inside.height);
    if height < lines.len() {
        let hidden = lines.len() + 1 - height.max(1);
        lines.truncate(height.saturating_sub(1));
        let more = format!("… {hidden} more lines: Enter shows all");
        lines.push(Line::styled(more, Look::faint()));
    }
    frame.render_widget(Paragraph::new(lines), inside);
}
