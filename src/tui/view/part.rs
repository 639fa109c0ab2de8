//! A part of the screen.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Borders};

use crate::tui::look::Look;

/// The line above a part, with its title; gives back the room below it.
pub(super) fn framed(title: &str, look: Look, area: Rect, frame: &mut Frame<'_>) -> Rect {
    let block = Block::new()
        .borders(Borders::TOP)
        .border_style(Look::faint())
        .border_set(look.lines())
        .title(format!(" {title} "));
    let inside = block.inner(area);
    frame.render_widget(block, area);
    // a blank column to what stands at the left
    Rect {
        width: inside.width.saturating_sub(1),
        ..inside
    }
}
