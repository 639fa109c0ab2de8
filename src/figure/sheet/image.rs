//! A picture on a sheet: PNG inside the SVG, in colour or in grey.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use crate::trace::png_bytes::{Channels, encoded};

/// Red, green and blue.
type Rgb = [u8; 3];

/// A picture: the colours of its pixels, row by row from the top left; `None` where nothing is known, which is clear.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::figure) struct Image {
    pixels: [u32; 2],
    colours: Vec<Option<Rgb>>,
}

impl Image {
    /// The least width of an embedded picture in pixels: a third of a book's column, so that no browser enlarges it more than
    /// three times.
    pub(in crate::figure) const LEAST_WIDTH: u32 = 256;

    /// A picture of width × height pixels, at least one.
    pub(in crate::figure) fn new(pixels: [u32; 2], colours: Vec<Option<Rgb>>) -> Self {
        debug_assert_eq!(colours.len(), pixels[0] as usize * pixels[1] as usize);
        Self { pixels, colours }
    }

    /// A picture from its bytes, red, green and blue of each pixel.
    pub(in crate::figure) fn of_rgb(pixels: [u32; 2], rgb: &[u8]) -> Self {
        let (colours, _) = rgb.as_chunks();
        Self::new(pixels, colours.iter().copied().map(Some).collect())
    }

    /// Width by height.
    pub(in crate::figure) fn aspect(&self) -> f64 {
        f64::from(self.pixels[0]) / f64::from(self.pixels[1])
    }

    /// The same with a square of pixels for each, so that it is wide enough: its pixels stay squares with sharp edges.
    pub(in crate::figure) fn in_squares(self) -> Self {
        let [width, height] = self.pixels;
        let factor = Self::LEAST_WIDTH.div_ceil(width) as usize;
        if factor == 1 {
            return self;
        }
        let mut colours = Vec::with_capacity(self.colours.len() * factor * factor);
        for row in self.colours.chunks(width as usize) {
            let wide: Vec<Option<Rgb>> = row
                .iter()
                .flat_map(|colour| std::iter::repeat_n(*colour, factor))
                .collect();
            for _ in 0..factor {
                colours.extend_from_slice(&wide);
            }
        }
        Self::new([width, height].map(|side| side * factor as u32), colours)
    }

    /// The picture as a PNG in a URI.
    pub(in crate::figure) fn data_uri(&self, grayscale: bool) -> String {
        let has_clear = self.colours.contains(&None);
        let channels = match (grayscale, has_clear) {
            (false, false) => Channels::Rgb,
            (false, true) => Channels::RgbAlpha,
            (true, false) => Channels::Grey,
            (true, true) => Channels::GreyAlpha,
        };
        let mut bytes = Vec::with_capacity(self.colours.len() * channels.count());
        for colour in &self.colours {
            let rgb = colour.unwrap_or_default();
            if grayscale {
                bytes.push(luma(rgb));
            } else {
                bytes.extend(rgb);
            }
            if has_clear {
                bytes.push(if colour.is_some() { u8::MAX } else { 0 });
            }
        }
        let png = encoded(self.pixels, channels, &bytes);
        format!("data:image/png;base64,{}", BASE64.encode(png))
    }
}

/// How bright a colour is: its luma (ITU-R BT.601).
fn luma(rgb: Rgb) -> u8 {
    let [r, g, b] = rgb.map(f64::from);
    (0.299 * r + 0.587 * g + 0.114 * b).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Option<Rgb> = Some([255, 0, 0]);
    const BLUE: Option<Rgb> = Some([0, 0, 255]);

    #[test]
    fn a_pixel_of_a_small_picture_becomes_a_square() {
        let image = Image::new([2, 1], vec![RED, None]).in_squares();
        // 256/2 = 128 pixels for each
        assert_eq!(image.pixels, [256, 128]);
        let colour = |x: usize, y: usize| image.colours[y * 256 + x];
        assert_eq!([colour(0, 0), colour(127, 127)], [RED, RED]);
        assert_eq!([colour(128, 0), colour(255, 127)], [None, None]);
        // 100 pixels need a factor of 3; 256 and more stay
        for (width, drawn) in [(100, 300), (256, 256), (257, 257)] {
            let image = Image::new([width, 1], vec![RED; width as usize]).in_squares();
            assert_eq!(image.pixels[0], drawn);
        }
    }

    /// The pixels of a PNG in a URI, and how many bytes each has.
    fn decoded(uri: &str) -> (Vec<u8>, usize) {
        let base64 = uri.strip_prefix("data:image/png;base64,").unwrap();
        let png = BASE64.decode(base64).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(png))
            .read_info()
            .unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut bytes).unwrap();
        (bytes, reader.info().color_type.samples())
    }

    #[test]
    fn a_uri_has_the_colours_or_their_luma_and_what_is_clear() {
        let image = Image::new([2, 1], vec![RED, BLUE]);
        assert_eq!(
            decoded(&image.data_uri(false)),
            (vec![255, 0, 0, 0, 0, 255], 3)
        );
        // 0.299·255 = 76.2 and 0.114·255 = 29.1
        assert_eq!(decoded(&image.data_uri(true)), (vec![76, 29], 1));
        let image = Image::new([2, 1], vec![None, BLUE]);
        let clear = vec![0, 0, 0, 0, 0, 0, 255, 255];
        assert_eq!(decoded(&image.data_uri(false)), (clear, 4));
        assert_eq!(decoded(&image.data_uri(true)), (vec![0, 0, 29, 255], 2));
    }
}
