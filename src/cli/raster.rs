//! Figures as PNG and PDF, where the program was built with the feature `raster`.

use crate::cli::Error;

/// The drawing in pixels, twice as many as it has units: sharp on a projector.
#[cfg(feature = "raster")]
pub(crate) fn png(svg: &str) -> Result<Vec<u8>, Error> {
    use resvg::tiny_skia::{Pixmap, Transform};
    use resvg::usvg::{Options, Tree};

    const SCALE: f32 = 2.0;
    let mut options = Options::default();
    options.fontdb_mut().load_system_fonts();
    let tree = Tree::from_str(svg, &options).map_err(|error| failed("PNG", &error))?;
    let size = tree.size().to_int_size().scale_by(SCALE);
    let mut pixels = size
        .and_then(|size| Pixmap::new(size.width(), size.height()))
        .ok_or_else(|| failed("PNG", &"it has no size"))?;
    let transform = Transform::from_scale(SCALE, SCALE);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed("PNG", &error))
}

/// The drawing as a page of its own size, for LaTeX.
#[cfg(feature = "raster")]
pub(crate) fn pdf(svg: &str) -> Result<Vec<u8>, Error> {
    use svg2pdf::usvg::{Options, Tree};

    let mut options = Options::default();
    options.fontdb_mut().load_system_fonts();
    let tree = Tree::from_str(svg, &options).map_err(|error| failed("PDF", &error))?;
    let conversion = svg2pdf::ConversionOptions::default();
    svg2pdf::to_pdf(&tree, conversion, svg2pdf::PageOptions::default())
        .map_err(|error| failed("PDF", &error))
}

#[cfg(feature = "raster")]
fn failed(format: &str, why: &dyn std::fmt::Display) -> Error {
    Error::Raster {
        what: format!("the drawing cannot be written as {format}: {why}"),
        fix: "write SVG, and convert it with another program",
    }
}

/// The drawing in pixels.
#[cfg(not(feature = "raster"))]
pub(crate) fn png(_: &str) -> Result<Vec<u8>, Error> {
    Err(without("PNG"))
}

/// The drawing as a page.
#[cfg(not(feature = "raster"))]
pub(crate) fn pdf(_: &str) -> Result<Vec<u8>, Error> {
    Err(without("PDF"))
}

#[cfg(not(feature = "raster"))]
fn without(format: &str) -> Error {
    Error::Raster {
        what: format!("this raystep was built without support for {format}"),
        fix: "build it with support: cargo build --release --features raster; or write SVG",
    }
}
