//! The tree of steps: each with the sign of what became of it, and its title.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;

use crate::step::{headline, subject};
use crate::tui::app::App;
use crate::tui::look::Look;
use crate::tui::rows::{Row, rows};
use crate::tui::sign::Sign;
use crate::tui::view::part::framed;
use crate::tui::view::text::{cut, width};

/// Draws the rows around the step where the reader stands.
pub(super) fn draw(app: &App<'_, '_>, look: Look, area: Rect, frame: &mut Frame<'_>) {
    let inside = framed("steps", look, area, frame);
    let rows = rows(app.log(), app.here(), usize::from(inside.height));
    let room = usize::from(inside.width);
    let lines: Vec<Line> = rows.iter().map(|row| line(app, look, row, room)).collect();
    frame.render_widget(Paragraph::new(lines), inside);
}

fn line(app: &App<'_, '_>, look: Look, row: &Row, room: usize) -> Line<'static> {
    /// Deeper steps are no further to the right.
    const DEEPEST: usize = 8;
    let log = app.log();
    let step = log.step(row.step);
    // what was not seen yet would answer questions
    let is_seen = app.reader.is_seen(row.step);
    let (sign, title) = if is_seen {
        (Sign::of(step.became), headline(log, row.step))
    } else if step.is_fold() {
        let others = step.folded - 1;
        let title = format!("{} and {others} more", subject(log, row.step));
        (Sign::Neither, title)
    } else {
        (Sign::Neither, subject(log, row.step))
    };
    let mark = match (row.is_open, step.is_leaf(), look.is_ascii) {
        (true, _, false) => '▾',
        (true, _, true) => 'v',
        (false, true, _) => ' ',
        (false, false, false) => '▸',
        (false, false, true) => '>',
    };
    let indent = " ".repeat(row.depth.min(DEEPEST));
    let letter = if is_seen {
        sign.letter(look.is_ascii)
    } else {
        ' '
    };
    let start = format!("{indent}{mark}");
    let title = cut(&title, room.saturating_sub(width(&start) + 2));
    let style = if row.step == app.here() {
        Look::reversed()
    } else if step.parent == Some(app.here()) {
        // → leads there
        Look::faint()
    } else {
        Style::new()
    };
    // the ground reaches to the edge of the column
    let rest = room.saturating_sub(width(&start) + 2 + width(&title));
    Line::from(vec![
        Span::styled(start, style),
        Span::styled(letter.to_string(), style.patch(look.sign(sign))),
        Span::styled(format!(" {title}{}", " ".repeat(rest)), style),
    ])
}
