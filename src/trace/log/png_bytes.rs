//! Small pictures as PNG in memory: 8 bits a channel, packed as tightly as it goes, the same bytes on every system.

use std::io::Cursor;

use png::{BitDepth, ColorType, Compression, Decoder, Encoder, Filter, Limits};

/// What the bytes of a pixel are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Channels {
    /// A shade of grey.
    Grey,
    /// A shade of grey, and how opaque it is.
    GreyAlpha,
    /// Red, green and blue.
    Rgb,
    /// Red, green and blue, and how opaque it is.
    RgbAlpha,
}

impl Channels {
    /// How many bytes a pixel has.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Grey => 1,
            Self::GreyAlpha => 2,
            Self::Rgb => 3,
            Self::RgbAlpha => 4,
        }
    }

    const fn of_png(self) -> ColorType {
        match self {
            Self::Grey => ColorType::Grayscale,
            Self::GreyAlpha => ColorType::GrayscaleAlpha,
            Self::Rgb => ColorType::Rgb,
            Self::RgbAlpha => ColorType::Rgba,
        }
    }
}

/// A picture as PNG. There are as many bytes as width · height · channels, and at least one pixel.
pub(crate) fn encoded([width, height]: [u32; 2], channels: Channels, bytes: &[u8]) -> Vec<u8> {
    let mut png = Vec::new();
    let mut encoder = Encoder::new(&mut png, width, height);
    encoder.set_color(channels.of_png());
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::Adaptive);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(bytes)?;
        writer.finish()
    });
    // a list takes all bytes, and the callers' pictures have pixels
    debug_assert!(written.is_ok(), "{written:?}");
    png
}

/// Red, green and blue of each pixel of a PNG of that size.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn decoded_rgb(png: &[u8], pixels: [u32; 2]) -> Result<Vec<u8>, String> {
    let no_png = |error: png::DecodingError| format!("it is no PNG: {error}");
    let [width, height] = pixels;
    let bytes = [width, height].map(|side| side as usize);
    let bytes = bytes[0].saturating_mul(bytes[1]).saturating_mul(3);
    // the decoder keeps a few rows beside the picture
    let limits = Limits {
        bytes: bytes.saturating_mul(2).saturating_add(1 << 20),
    };
    let mut reader = Decoder::new_with_limits(Cursor::new(png), limits)
        .read_info()
        .map_err(no_png)?;
    let found = reader.info();
    if (found.width, found.height) != (width, height) {
        return Err(format!(
            "the PNG has {} × {} pixels, not {width} × {height}",
            found.width, found.height
        ));
    }
    if (found.color_type, found.bit_depth) != (ColorType::Rgb, BitDepth::Eight) {
        return Err("the PNG does not have 8 bits of red, green and blue".into());
    }
    let mut rgb = vec![0; bytes];
    reader.next_frame(&mut rgb).map_err(no_png)?;
    Ok(rgb)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_comes_back_from_its_png() {
        let rgb: Vec<u8> = (0..3 * 5 * 4).map(|byte| byte * 4).collect();
        let png = encoded([5, 4], Channels::Rgb, &rgb);
        // ISO/IEC 15948: the signature, then the width and the height in the first chunk
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        assert_eq!(&png[12..24], b"IHDR\0\0\0\x05\0\0\0\x04");
        assert_eq!(decoded_rgb(&png, [5, 4]), Ok(rgb));
    }

    #[test]
    fn what_is_no_such_picture_is_refused() {
        let png = encoded([2, 1], Channels::Grey, &[0, 255]);
        let error = decoded_rgb(&png, [2, 1]).unwrap_err();
        assert!(error.contains("8 bits of red"), "{error}");
        let png = encoded([2, 1], Channels::Rgb, &[1, 2, 3, 4, 5, 6]);
        let error = decoded_rgb(&png, [1, 2]).unwrap_err();
        assert_eq!(error, "the PNG has 2 × 1 pixels, not 1 × 2");
        let error = decoded_rgb(&png[..png.len() - 20], [2, 1]).unwrap_err();
        assert!(error.starts_with("it is no PNG"), "{error}");
    }
}
