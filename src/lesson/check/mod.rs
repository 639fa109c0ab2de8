//! The checker of foreign logs: is what a student's own ray tracer wrote what this one computes?
//!
//! A program in any language writes lines of the kinds that it has got to, any subset of kinds and fields. The lines of a pixel
//! stand together; within a pixel the order is free. The way of the data, a file each:
//!
//! ```text
//! lines of the log ─▶ line       one line: kind, pixel, ray, fields; or what is wrong with it
//!                   ▶ pixel      the lines of one pixel, put together into rays
//!                   ▶ reference  the same pixel as the crate traces it
//!                   ▶ on_ray     what every object says to a ray of the log's own
//!                   ▶ pairing    which ray of the log is which, and which line is which event
//!                   ▶ matching   the lines of a pixel against its events
//!                   ▶ fields     which quantity differs, and which may
//!                   ▶ agreeing   some colours that agree before the first one differs
//!                   ▶ suspects   the mistakes that give the student's values
//!                   ▶ way        the simple ray tracer with a mistake, as different programs write it
//!                   ▶ checked    what was compared, what was absent, the first divergence; report tells it, picture draws it
//! ```
//!
//! Nobody who is right is accused: what a ray is tested against is computed for the ray that the log itself has, so that
//! another ε, another scale of t and another order of the objects pass.

mod agreeing;
mod checked;
mod error;
mod fields;
mod foreign;
mod line;
mod matching;
mod on_ray;
mod options;
mod pairing;
mod picture;
mod reference;
mod report;
mod suspects;
mod value;
mod way;

use std::io::BufRead;

pub use checked::{Checked, Divergence, Quantity, UnknownField};
pub use error::CheckError;
pub use options::{CheckOptions, TOLERANCE};
pub use picture::picture;
pub use report::Named;

use crate::lesson::check::foreign::ForeignLog;
use crate::lesson::check::reference::Reference;
use crate::scene::Scene;
use crate::strategy::Chosen;
use crate::trace::Settings;

/// Checks a log against the scene that it was traced from.
///
/// `chosen` are the strategies whose events the log may have; the first that has an event of a kind decides. The memory is that of
/// one pixel.
///
/// # Errors
/// An input that cannot be read, or a line that makes no sense.
pub fn check_log(
    scene: &Scene,
    chosen: &[(&Settings, &Chosen<'_>)],
    name: &str,
    input: impl BufRead,
    options: &CheckOptions,
) -> Result<Checked, CheckError> {
    let reference = Reference::new(scene, chosen);
    let mut log = ForeignLog::new(name, input, scene);
    let mut checked = Checked::default();
    while let Some(pixel) = log.next_pixel()? {
        let expected = reference.pixel(pixel.pixel)?;
        matching::compare(&reference, &expected, &pixel, options, (name, &mut checked))?;
    }
    checked.finish(log.aside());
    Ok(checked)
}
