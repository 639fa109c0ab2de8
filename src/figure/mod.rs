//! From events to drawings: the figures of a lecture, each from a trace alone.
//!
//! A [`FigureSpec`] says what is drawn; [`draw`] makes it from [`Traced`], which is a log in memory. A kind of figure
//! draws marks and words on a sheet; labels are placed at the end, and `canvas` writes the SVG.

mod cost_chart;
mod draw;
mod drawn_up_to;
mod error;
mod heat_map;
mod kind;
mod kinds;
mod near;
mod parts;
#[cfg(test)]
mod read_back;
pub(crate) mod sheet;
mod sketch;
pub(crate) mod spec;
mod subject;
pub(crate) mod traced;
mod view;

pub use cost_chart::cost_chart;
pub use draw::{Drawn, DrawnStage, draw, strokes};
pub use drawn_up_to::{DrawnUpTo, Far};
pub use error::FigureError;
pub use heat_map::{Raster, heat_map, heat_overlay, heat_scale};
pub(crate) use near::around_rays;
pub(crate) use sheet::Width;
pub(crate) use sheet::canvas::Rendition;
pub use sheet::canvas::UpTo;
pub(crate) use sheet::canvas::dark_colours;
pub use sheet::font::text_width;
pub use sheet::look::Colour;
pub use sheet::strokes::{Stroke, StrokeForm, StrokeWords, Strokes};
pub use sketch::{SketchForm, SketchMark, Whose, sketch};
pub(crate) use spec::FigureSpec;
pub use spec::{DroppedAxis, FigureKind, Fineness, Layer};
pub(crate) use traced::Traced;
pub use view::View;
