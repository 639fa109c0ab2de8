//! The terminal: keys in, frames out. It is restored when the screen is dropped, on a panic, and by whoever ends the program.

use std::io::{self, Stdout};
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

use ratatui::Terminal;
use ratatui::backend::CrosstermBackend;
use ratatui::crossterm::cursor::Show;
use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use ratatui::crossterm::execute;
use ratatui::crossterm::terminal::{
    EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};

use crate::tui::app::{App, Effect};
use crate::tui::look::Look;
use crate::tui::view;

/// Is the terminal ours?
static IS_OPEN: AtomicBool = AtomicBool::new(false);

/// The terminal while it shows steps.
#[derive(Debug)]
pub struct Screen {
    terminal: Terminal<CrosstermBackend<Stdout>>,
    look: Look,
}

impl Screen {
    /// Takes the terminal: letters come one by one, and what was on it comes back in the end.
    ///
    /// # Errors
    /// The terminal does not do this.
    pub fn open(look: Look) -> io::Result<Self> {
        static HOOK: Once = Once::new();
        HOOK.call_once(|| {
            let before = std::panic::take_hook();
            std::panic::set_hook(Box::new(move |panic| {
                restore();
                before(panic);
            }));
        });
        IS_OPEN.store(true, Ordering::SeqCst);
        let opened = enable_raw_mode()
            .and_then(|()| execute!(io::stdout(), EnterAlternateScreen))
            .and_then(|()| Terminal::new(CrosstermBackend::new(io::stdout())));
        match opened {
            Ok(terminal) => Ok(Self { terminal, look }),
            Err(error) => {
                restore();
                Err(error)
            }
        }
    }

    /// Shows a log and does what keys say, up to the first thing that others must do.
    ///
    /// # Errors
    /// The terminal is gone.
    pub fn next(&mut self, app: &mut App<'_, '_>) -> io::Result<Effect> {
        loop {
            if let Some(effect) = app.go_on() {
                return Ok(effect);
            }
            self.show(app)?;
            let key = match event::read()? {
                Event::Key(key) if key.kind != KeyEventKind::Release => name(key),
                // a new size is asked for before each frame
                _ => None,
            };
            if let Some(effect) = key.and_then(|key| app.press(&key)) {
                return Ok(effect);
            }
        }
    }

    /// Draws a frame.
    ///
    /// # Errors
    /// The terminal is gone.
    pub fn show(&mut self, app: &mut App<'_, '_>) -> io::Result<()> {
        let size = self.terminal.size()?;
        app.resize([size.width, size.height]);
        let look = self.look;
        self.terminal.draw(|frame| view::draw(app, look, frame))?;
        Ok(())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        restore();
    }
}

/// Gives the terminal back as it was, if it was taken; once.
pub fn restore() {
    if IS_OPEN.swap(false, Ordering::SeqCst) {
        // if this fails, the terminal is gone
        let _ = execute!(io::stdout(), LeaveAlternateScreen, Show);
        let _ = disable_raw_mode();
    }
}

/// The name of a key; `None` of one that has none.
fn name(key: KeyEvent) -> Option<String> {
    let is_control = key.modifiers.contains(KeyModifiers::CONTROL);
    if is_control || key.modifiers.contains(KeyModifiers::ALT) {
        let is_end = is_control && matches!(key.code, KeyCode::Char('c' | 'C'));
        return is_end.then(|| "Ctrl+C".into());
    }
    let shift = if key.modifiers.contains(KeyModifiers::SHIFT) {
        "Shift+"
    } else {
        ""
    };
    let name = match key.code {
        KeyCode::Char(' ') => "Space",
        KeyCode::Char(letter) => return Some(letter.to_string()),
        KeyCode::Up => return Some(format!("{shift}↑")),
        KeyCode::Down => return Some(format!("{shift}↓")),
        KeyCode::Left => return Some(format!("{shift}←")),
        KeyCode::Right => return Some(format!("{shift}→")),
        KeyCode::Enter => "Enter",
        KeyCode::Tab | KeyCode::BackTab => "Tab",
        KeyCode::Backspace => "Backspace",
        KeyCode::Esc => "Esc",
        KeyCode::Home => "Home",
        KeyCode::End => "End",
        KeyCode::PageUp => "PgUp",
        KeyCode::PageDown => "PgDn",
        _ => return None,
    };
    Some(name.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In the environment of a process that is to panic.
    const PANICS: &str = "RAYSTEP_TEST_PANICS";

    const MESSAGE: &str = "in the middle of a screen";

    /// What the next test starts in a terminal; by itself it only asks whether it is.
    #[test]
    fn panics_where_the_environment_asks_for_it() {
        if std::env::var_os(PANICS).is_some() {
            let _screen = Screen::open(Look::default()).unwrap();
            panic!("{MESSAGE}");
        }
    }

    /// `script` makes a terminal and writes down what comes out of it.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_panic_gives_the_terminal_back_before_it_speaks() {
        let own = std::env::current_exe().unwrap();
        let path = module_path!().split_once("::").unwrap().1;
        let inside = format!(
            "stty -g; '{}' --exact {path}::panics_where_the_environment_asks_for_it --nocapture; stty -g",
            own.display()
        );
        let script = std::process::Command::new("script")
            .args(["-qec", &inside, "/dev/null"])
            .env(PANICS, "yes")
            .env("TERM", "xterm")
            .stdin(std::process::Stdio::null())
            .output();
        let out = script.expect("script of util-linux").stdout;
        let out = String::from_utf8(out).unwrap();
        let place = |text: &str| {
            out.find(text)
                .unwrap_or_else(|| panic!("{text:?} in {out:?}"))
        };
        // the other screen is entered, left, the cursor is shown again, and then the message is read on the first one
        let order = ["\x1b[?1049h", "\x1b[?1049l", "\x1b[?25h", MESSAGE].map(place);
        assert!(order.is_sorted(), "{order:?} {out:?}");
        // lines are read as before: the settings are those from before it
        let settings = |line: &str| {
            line.contains(':')
                && line
                    .split(':')
                    .all(|of| u32::from_str_radix(of, 16).is_ok())
        };
        let lines = out.lines().map(str::trim);
        let settings: Vec<&str> = lines.filter(|line| settings(line)).collect();
        assert!(
            settings.len() == 2 && settings[0] == settings[1],
            "{settings:?} {out:?}"
        );
    }

    #[test]
    fn a_key_has_the_name_of_the_table() {
        let of = |code, modifiers| name(KeyEvent::new(code, modifiers));
        let named = |code, modifiers| of(code, modifiers).unwrap();
        assert_eq!(named(KeyCode::Right, KeyModifiers::SHIFT), "Shift+→");
        assert_eq!(named(KeyCode::Down, KeyModifiers::NONE), "↓");
        assert_eq!(named(KeyCode::Char('N'), KeyModifiers::SHIFT), "N");
        assert_eq!(named(KeyCode::Char('c'), KeyModifiers::CONTROL), "Ctrl+C");
        assert_eq!(of(KeyCode::Char('z'), KeyModifiers::CONTROL), None);
        // each key of the table that is no letter comes from some key here
        let codes = [
            KeyCode::Up,
            KeyCode::Down,
            KeyCode::Left,
            KeyCode::Right,
            KeyCode::Char(' '),
            KeyCode::Backspace,
            KeyCode::Esc,
            KeyCode::Home,
            KeyCode::End,
            KeyCode::PageUp,
            KeyCode::PageDown,
        ];
        let names: Vec<String> = codes
            .iter()
            .flat_map(|&code| [KeyModifiers::NONE, KeyModifiers::SHIFT].map(|of| named(code, of)))
            .collect();
        for key in crate::step::KEYS {
            let is_letter = key.key.chars().count() == 1 && key.key.is_ascii();
            assert!(
                is_letter || names.iter().any(|name| name == key.key),
                "{}",
                key.key
            );
        }
    }
}
