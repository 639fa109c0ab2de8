//! Figures as PNG and PDF, where the program was built with the feature `raster`.

#[cfg(not(feature = "raster"))]
use crate::cli::Error;
#[cfg(feature = "raster")]
pub(crate) use with_raster::{pdf, png};

#[cfg(feature = "raster")]
mod with_raster {
    use std::collections::HashMap;
    use std::fmt::Display;
    use std::sync::Arc;

    use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref};
    use resvg::tiny_skia::{Pixmap, Transform};
    use resvg::usvg::fontdb::{Database, Family, Query};
    use resvg::usvg::{Options, Tree};

    use crate::cli::Error;

    /// A drawing in pixels, twice as many as it has units: sharp on a projector.
    pub(crate) fn png(svg: &str) -> Result<Vec<u8>, Error> {
        const SCALE: f32 = 2.0;
        let tree = Drawings::new("PNG")?.read(svg)?;
        let failed = |why: &dyn Display| failed("PNG", why);
        let size = tree.size().to_int_size().scale_by(SCALE);
        let mut pixels = size
            .and_then(|size| Pixmap::new(size.width(), size.height()))
            .ok_or_else(|| failed(&"it has no size"))?;
        let transform = Transform::from_scale(SCALE, SCALE);
        resvg::render(&tree, transform, &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| failed(&error))
    }

    /// Drawings as the pages of one PDF, each of its own size: a point for a unit.
    pub(crate) fn pdf(svgs: &[String]) -> Result<Vec<u8>, Error> {
        let drawings = Drawings::new("PDF")?;
        let mut last = 0;
        let mut next = || {
            last += 1;
            Ref::new(last)
        };
        let (catalog, all_pages) = (next(), next());
        let pages: Vec<Ref> = svgs.iter().map(|_| next()).collect();
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(all_pages);
        pdf.pages(all_pages)
            .kids(pages.iter().copied())
            .count(i32::try_from(pages.len()).unwrap_or(i32::MAX));
        for (svg, page_id) in svgs.iter().zip(&pages) {
            let tree = drawings.read(svg)?;
            let options = svg2pdf::ConversionOptions::default();
            let drawn = svg2pdf::to_chunk(&tree, options);
            let (chunk, drawing) = drawn.map_err(|error| failed("PDF", &error))?;
            // each drawing counts its objects from 1
            let mut of_file = HashMap::new();
            let chunk = chunk.renumber(|own| *of_file.entry(own).or_insert_with(&mut next));
            let drawing = of_file[&drawing];

            let (width, height) = (tree.size().width(), tree.size().height());
            let content_id = next();
            let name = Name(b"figure");
            let mut page = pdf.page(*page_id);
            page.parent(all_pages);
            page.media_box(Rect::new(0.0, 0.0, width, height));
            page.contents(content_id);
            page.resources().x_objects().pair(name, drawing);
            page.finish();
            // a drawing is one unit wide and high
            let mut content = Content::new();
            content.transform([width, 0.0, 0.0, height, 0.0, 0.0]);
            content.x_object(name);
            pdf.stream(content_id, &content.finish());
            pdf.extend(&chunk);
        }
        Ok(pdf.finish())
    }

    /// Reads drawings, with the fonts of this machine.
    struct Drawings {
        fonts: Arc<Database>,
        format: &'static str,
    }

    impl Drawings {
        /// # Errors
        /// No font is installed: all letters would be missing.
        fn new(format: &'static str) -> Result<Self, Error> {
            let mut fonts = Database::new();
            fonts.load_system_fonts();
            let family = sans_serif(&fonts).ok_or_else(|| Error::Raster {
                what: format!(
                    "the drawing cannot be written as {format}: no font is installed for its letters"
                ),
                fix: "install one, such as DejaVu Sans; or write SVG",
            })?;
            // the last of the families that a drawing names
            fonts.set_sans_serif_family(family);
            Ok(Self {
                fonts: Arc::new(fonts),
                format,
            })
        }

        fn read(&self, svg: &str) -> Result<Tree, Error> {
            let options = Options {
                fontdb: Arc::clone(&self.fonts),
                ..Options::default()
            };
            Tree::from_str(svg, &options).map_err(|error| failed(self.format, &error))
        }
    }

    /// The family whose letters are as wide as figures reckon with, or one like it, or any that is there; the same on each run.
    fn sans_serif(fonts: &Database) -> Option<String> {
        const KNOWN: [&str; 5] = [
            "DejaVu Sans",
            "Verdana",
            "Noto Sans",
            "Liberation Sans",
            "Arial",
        ];
        let has = |family: &&str| {
            let query = Query {
                families: &[Family::Name(family)],
                ..Query::default()
            };
            fonts.query(&query).is_some()
        };
        let of_faces = fonts.faces().filter_map(|face| face.families.first());
        let any = || of_faces.map(|(name, _)| name.clone()).min();
        let known = KNOWN.into_iter().find(has).map(str::to_owned);
        known.or_else(any)
    }

    fn failed(format: &str, why: &dyn Display) -> Error {
        Error::Raster {
            what: format!("the drawing cannot be written as {format}: {why}"),
            fix: "write SVG, and convert it with another program",
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        fn drawing(width: u32, height: u32, inside: &str) -> String {
            format!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">{inside}</svg>"#
            )
        }

        #[test]
        fn a_pdf_has_a_page_for_each_drawing_of_its_own_size() {
            let red = r##"<rect width="20" height="10" fill="#ff0000"/>"##;
            let drawings = [
                drawing(20, 10, red),
                drawing(30, 40, ""),
                drawing(20, 10, red),
            ];
            let pdf = String::from_utf8_lossy(&pdf(&drawings).unwrap()).into_owned();
            assert!(pdf.starts_with("%PDF-"));
            assert!(pdf.contains("/Count 3"));
            let boxes = pdf.split("/MediaBox [").skip(1);
            let boxes: Vec<&str> = boxes.filter_map(|rest| rest.split(']').next()).collect();
            assert_eq!(boxes, ["0 0 20 10", "0 0 30 40", "0 0 20 10"]);
        }

        #[test]
        fn a_png_shows_letters_and_embedded_pictures() {
            /// The pixels, each with its four channels.
            fn pixels(svg: &str) -> Vec<[u8; 4]> {
                let png = png(svg).unwrap();
                let mut reader = ::png::Decoder::new(std::io::Cursor::new(png))
                    .read_info()
                    .unwrap();
                let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
                reader.next_frame(&mut bytes).unwrap();
                bytes.as_chunks().0.to_vec()
            }
            let is_there = |of: &[[u8; 4]]| of.iter().filter(|pixel| pixel[3] != 0).count();
            // 20 × 10 units are 40 × 20 pixels
            let empty = pixels(&drawing(20, 10, ""));
            assert_eq!((empty.len(), is_there(&empty)), (800, 0));
            let letters =
                r#"<text x="2" y="9" font-size="10" font-family="None, sans-serif">H</text>"#;
            assert!(0 < is_there(&pixels(&drawing(20, 10, letters))));

            // one green pixel, spread over all
            let mut green = Vec::new();
            let mut encoder = ::png::Encoder::new(&mut green, 1, 1);
            encoder.set_color(::png::ColorType::Rgb);
            let mut writer = encoder.write_header().unwrap();
            writer.write_image_data(&[0, 255, 0]).unwrap();
            writer.finish().unwrap();
            let base64 = base64::Engine::encode(&base64::prelude::BASE64_STANDARD, green);
            let image = format!(
                r#"<image width="20" height="10" preserveAspectRatio="none" href="data:image/png;base64,{base64}"/>"#
            );
            let shown = pixels(&drawing(20, 10, &image));
            assert!(shown.iter().all(|pixel| *pixel == [0, 255, 0, 255]));
        }
    }
}

/// A drawing in pixels.
#[cfg(not(feature = "raster"))]
pub(crate) fn png(_: &str) -> Result<Vec<u8>, Error> {
    Err(without("PNG"))
}

/// Drawings as pages.
#[cfg(not(feature = "raster"))]
pub(crate) fn pdf(_: &[String]) -> Result<Vec<u8>, Error> {
    Err(without("PDF"))
}

#[cfg(not(feature = "raster"))]
fn without(format: &str) -> Error {
    Error::Raster {
        what: format!("this raystep was built without support for {format}"),
        fix: "build it with support: cargo build --release --features raster; or write SVG",
    }
}
