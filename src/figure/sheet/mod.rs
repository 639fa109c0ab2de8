//! The paper of a figure: marks, words and labels, where the labels go, and the SVG at the end.
//!
//! `canvas` alone names the crate `svg` and formats the numbers of a drawing.

pub(in crate::figure) mod buckets;
pub(crate) mod canvas;
mod crop;
pub(in crate::figure) mod font;
pub(in crate::figure) mod frame;
pub(in crate::figure) mod image;
mod labels;
pub(in crate::figure) mod look;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
pub(crate) mod sheet;
pub(in crate::figure) mod stage;
pub(in crate::figure) mod strokes;
pub(in crate::figure) mod text;

pub(crate) use sheet::Width;
pub(in crate::figure) use sheet::{Form, Label, Mark, Sheet, Since, Words};
pub(in crate::figure) use text::Anchor;
