//! From what the app holds to a frame: where each part stands.

mod bars;
mod drawing;
mod part;
mod picture;
mod sheet;
mod state;
mod text;
mod tree;
mod working;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};

use crate::tui::app::App;
use crate::tui::look::Look;

/// Draws a frame.
pub fn draw(app: &App<'_, '_>, look: Look, frame: &mut Frame<'_>) {
    let area = frame.area();
    if area.width == 0 || area.height == 0 {
        return;
    }
    let said = bars::said(app, area.width);
    let below = said.len().min(usize::from(area.height / 3)) as u16;
    let [title, body, said_area, keys] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Min(1),
        Constraint::Length(below),
        Constraint::Length(1),
    ])
    .areas(area);
    bars::title(app, title, frame);
    match &app.sheet {
        Some(sheet) => sheet::draw(sheet, look, body, frame),
        None => parts(app, look, body, frame),
    }
    bars::draw_said(said, said_area, frame);
    bars::keys(app, keys, frame);
}

/// The tree at the left; the working over the state; the drawing at the right, or in the place of both.
fn parts(app: &App<'_, '_>, look: Look, body: Rect, frame: &mut Frame<'_>) {
    let is_wide = crate::tui::app::WIDE <= body.width;
    let [tree, right] = Layout::horizontal([
        Constraint::Percentage(if is_wide { 27 } else { 42 }),
        Constraint::Min(1),
    ])
    .areas(body);
    tree_and_picture(app, look, tree, frame, is_wide);
    if is_wide {
        let [middle, drawing] =
            Layout::horizontal([Constraint::Percentage(48), Constraint::Min(1)]).areas(right);
        words(app, look, middle, frame);
        drawing::draw(app, look, drawing, frame);
    } else if app.shows_drawing {
        drawing::draw(app, look, right, frame);
    } else {
        words(app, look, right, frame);
    }
}

/// The tree; below it the small picture, where there is room for both or the reader has just gone to another pixel.
fn tree_and_picture(
    app: &App<'_, '_>,
    look: Look,
    area: Rect,
    frame: &mut Frame<'_>,
    is_wide: bool,
) {
    /// So many rows of the tree stay beside a picture.
    const ROWS: u16 = 8;
    let wanted = app.shows_picture || is_wide;
    let height = picture::height(app).filter(|_| wanted);
    let height = height.filter(|height| height + ROWS <= area.height);
    let [tree, picture] =
        Layout::vertical([Constraint::Min(1), Constraint::Length(height.unwrap_or(0))]).areas(area);
    tree::draw(app, look, tree, frame);
    if height.is_some() {
        picture::draw(app, look, picture, frame);
    }
}

/// The working, and below it the state.
fn words(app: &App<'_, '_>, look: Look, area: Rect, frame: &mut Frame<'_>) {
    let room = usize::from(area.width).saturating_sub(1);
    let working = working::lines(app, look, room);
    let state = state::lines(app, room);
    // each with its title; the state gets a third, and what the working leaves
    let rest = usize::from(area.height).saturating_sub(working.len() + 1);
    let most = rest.max(usize::from(area.height / 3));
    let height = (state.len() + 1).min(most).max(2) as u16;
    let [upper, lower] =
        Layout::vertical([Constraint::Min(1), Constraint::Length(height)]).areas(area);
    working::draw(app, working, look, upper, frame);
    state::draw(app, state, look, lower, frame);
}
