//! Lines over the whole screen.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::Line;
use ratatui::widgets::{Clear, Paragraph};

use crate::tui::app::Sheet;
use crate::tui::look::Look;
use crate::tui::view::part::framed;
use crate::tui::view::text::page;

/// Draws the lines from the first visible one on.
pub(super) fn draw(sheet: &Sheet, look: Look, area: Rect, frame: &mut Frame<'_>) {
    frame.render_widget(Clear, area);
    let inside = framed(&sheet.title, look, area, frame);
    let mut lines = page(
        &sheet.lines[sheet.top..],
        look,
        usize::from(inside.width),
        sheet.hanging,
    );
    let height = usize::from(inside.height);
    if height < lines.len() {
        let hidden = lines.len() + 1 - height.max(1);
        lines.truncate(height.saturating_sub(1));
        lines.push(Line::styled(
            format!("… {hidden} more lines: ↓ or PgDn"),
            Look::faint(),
        ));
    }
    frame.render_widget(Paragraph::new(lines), inside);
}
