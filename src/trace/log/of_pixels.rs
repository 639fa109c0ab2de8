//! What the log of a figure holds of every pixel, on lines between the objects and the events: the picture, how many tests
//! each pixel took, and what a mistake makes of the picture.
//!
//! An event for each pixel of a picture of 256 × 192 would take 5 MB; the picture as PNG takes 30 kB.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::trace::log::png_bytes::Channels;
use crate::trace::log::png_bytes::{decoded_rgb, encoded};

/// A picture: its pixels are smaller than the scene's, and each is the mean of several samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoggedPicture {
    /// Its width and height in pixels.
    pub pixels: [u32; 2],
    /// How many eye rays each of its pixels is the mean of.
    pub samples: u32,
    /// Red, green and blue of each pixel, row by row from the top left.
    pub rgb: Vec<u8>,
}

/// How many tests the pixels of a row took, from left to right: those of all rays of the pixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TestsOfRow {
    /// Objects tested: a polygon counts once, by its plane.
    pub objects: Vec<u64>,
    /// Bounds tested and nodes entered.
    pub nodes: Vec<u64>,
    /// Cells of the grid visited.
    pub cells: Vec<u64>,
}

/// What a mistake spoils in the picture of a scene: the simple ray tracer with one wrong function.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedMistake {
    /// The name of the mistake.
    pub name: String,
    /// The first pixel that shows it, row by row from the top left: its column and row.
    pub pixel: [u32; 2],
    /// Quantities of that pixel's rays and of the picture that differ.
    pub spoilt: Vec<Spoilt>,
    /// The picture with the mistake; absent if it is the right one.
    pub picture: Option<LoggedPicture>,
}

/// A quantity as it should be, and as a mistake makes it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Spoilt {
    /// Its name.
    pub quantity: String,
    /// The right value.
    pub right: SpoiltValue,
    /// The value with the mistake.
    pub wrong: SpoiltValue,
}

/// The value of a quantity: JSON has no infinite number, so that is a word.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum SpoiltValue {
    /// A finite number.
    Number(f64),
    /// A point, a direction or a colour.
    Vector([f64; 3]),
    /// Anything else: "blocked", "∞".
    Words(String),
}

impl From<f64> for SpoiltValue {
    fn from(of: f64) -> Self {
        if of.is_finite() {
            Self::Number(of)
        } else if of.is_nan() {
            Self::Words("no number".into())
        } else if of < 0.0 {
            Self::Words("−∞".into())
        } else {
            Self::Words("∞".into())
        }
    }
}

impl From<DVec3> for SpoiltValue {
    fn from(of: DVec3) -> Self {
        if of.is_finite() {
            Self::Vector(of.to_array())
        } else {
            Self::Words("no numbers".into())
        }
    }
}

impl From<&str> for SpoiltValue {
    fn from(of: &str) -> Self {
        Self::Words(of.into())
    }
}

/// What the rays of a picture took, all pixels together, or every n-th both ways.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Totals {
    /// Every n-th column and row was traced, from the first on; 1: all.
    pub every: u32,
    /// How many pixels were traced.
    pub pixels: u64,
    /// Objects tested: a polygon counts once, by its plane.
    pub objects: u64,
    /// Bounds tested and nodes entered.
    pub nodes: u64,
    /// Cells of the grid visited.
    pub cells: u64,
    /// Rays cast, those of paths of light among them.
    pub cast: u64,
    /// Rays that brought light into the picture.
    pub contributed: u64,
    /// Paths of light that were followed.
    pub paths: u64,
    /// Paths of light that reached the eye.
    pub arrived: u64,
}

/// What a log holds of every pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OfPixels {
    /// The picture, if the figure shows one.
    pub picture: Option<LoggedPicture>,
    /// A row of the scene's pixels after the other, from the top, if the figure shows what they cost; else none.
    pub tests: Vec<TestsOfRow>,
    /// What a mistake makes of it, if the figure shows one.
    pub mistake: Option<LoggedMistake>,
    /// What the rays of the picture took, if the figure shows it.
    pub totals: Option<Totals>,
}

/// A line that holds the picture.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct PictureLine {
    /// `picture`.
    kind: String,
    /// Its width and height in pixels: a whole multiple of the camera's.
    pixels: [u32; 2],
    /// How many eye rays each of its pixels is the mean of.
    samples: u32,
    /// The picture as PNG, 8 bits a channel, without gamma, in base64.
    png: String,
}

/// A line that holds how many tests the pixels of a row took.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct TestsLine {
    /// `pixel_tests`.
    kind: String,
    /// The row, from 0 at the top.
    row: u32,
    /// Object tests of each pixel, from the left; a polygon counts once, by its plane.
    objects: Vec<u64>,
    /// Bounds tested and nodes entered for each pixel.
    nodes: Vec<u64>,
    /// Cells visited for each pixel.
    cells: Vec<u64>,
}

/// A line that holds what the rays of the picture took.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct TotalsLine {
    /// `totals`.
    kind: String,
    /// The numbers.
    pub(super) totals: Totals,
}

impl Totals {
    /// As a line of a log.
    pub(super) fn line(self) -> TotalsLine {
        TotalsLine {
            kind: "totals".into(),
            totals: self,
        }
    }
}

/// A line that holds what a mistake spoils.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct MistakeLine {
    /// `mistake`.
    kind: String,
    /// The name of the mistake.
    name: String,
    /// The first pixel that shows it.
    first: [u32; 2],
    /// Quantities that differ.
    spoilt: Vec<Spoilt>,
    /// The picture with the mistake, as PNG like that of the line before; absent if it is the right one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    png: Option<String>,
}

impl LoggedMistake {
    /// As a line of a log.
    pub(super) fn line(&self) -> MistakeLine {
        MistakeLine {
            kind: "mistake".into(),
            name: self.name.clone(),
            first: self.pixel,
            spoilt: self.spoilt.clone(),
            png: self.picture.as_ref().map(LoggedPicture::png),
        }
    }

    /// From a line of the log of a scene with so many pixels.
    ///
    /// # Errors
    /// A pixel that is not in the picture, or data that are no such picture.
    pub(super) fn of_line(line: MistakeLine, of_scene: [u32; 2]) -> Result<Self, String> {
        let [[x, y], [width, height]] = [line.first, of_scene];
        if width <= x || height <= y {
            return Err(format!(
                "pixel {x},{y} is not in the picture of {width} × {height} pixels"
            ));
        }
        let picture = line.png.map(|png| LoggedPicture::of_png(&png, of_scene, 1));
        Ok(Self {
            name: line.name,
            pixel: line.first,
            spoilt: line.spoilt,
            picture: picture.transpose()?,
        })
    }
}

impl LoggedPicture {
    /// As PNG in base64.
    fn png(&self) -> String {
        BASE64.encode(encoded(self.pixels, Channels::Rgb, &self.rgb))
    }

    /// From a PNG in base64.
    fn of_png(png: &str, pixels: [u32; 2], samples: u32) -> Result<Self, String> {
        let png = BASE64.decode(png);
        let png = png.map_err(|error| format!("\"png\" is not base64: {error}"))?;
        Ok(Self {
            pixels,
            samples,
            rgb: decoded_rgb(&png, pixels)?,
        })
    }

    /// As a line of a log.
    pub(super) fn line(&self) -> PictureLine {
        PictureLine {
            kind: "picture".into(),
            pixels: self.pixels,
            samples: self.samples,
            png: self.png(),
        }
    }

    /// From a line of the log of a scene with so many pixels.
    ///
    /// # Errors
    /// A size that is no multiple of the scene's, or data that are no such picture.
    pub(super) fn of_line(line: &PictureLine, of_scene: [u32; 2]) -> Result<Self, String> {
        let pixels = line.pixels;
        let [finer, rest] = [pixels[0] / of_scene[0], pixels[0] % of_scene[0]];
        if finer == 0 || rest != 0 || of_scene[1].checked_mul(finer) != Some(pixels[1]) {
            let [[w, h], [width, height]] = [pixels, of_scene];
            return Err(format!(
                "a picture of {w} × {h} pixels is no whole multiple of the camera's {width} × {height}"
            ));
        }
        if line.samples == 0 {
            return Err("a picture has at least 1 sample for each pixel".into());
        }
        Self::of_png(&line.png, pixels, line.samples)
    }
}

impl TestsOfRow {
    /// As a line of a log.
    pub(super) fn line(&self, row: usize) -> TestsLine {
        TestsLine {
            kind: "pixel_tests".into(),
            row: row as u32,
            objects: self.objects.clone(),
            nodes: self.nodes.clone(),
            cells: self.cells.clone(),
        }
    }

    /// From the line that must be that of this row, in a picture of such a width.
    ///
    /// # Errors
    /// Another row, or another number of pixels.
    pub(super) fn of_line(line: TestsLine, row: usize, width: u32) -> Result<Self, String> {
        if line.row as usize != row {
            return Err(format!(
                "row {row} is missing: a line is lost or in the wrong place"
            ));
        }
        let lengths = [&line.objects, &line.nodes, &line.cells].map(Vec::len);
        if let Some(found) = lengths.into_iter().find(|found| *found != width as usize) {
            return Err(format!("{found} numbers for a row of {width} pixels"));
        }
        Ok(Self {
            objects: line.objects,
            nodes: line.nodes,
            cells: line.cells,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> LoggedPicture {
        LoggedPicture {
            pixels: [2, 4],
            samples: 9,
            rgb: (0..24).collect(),
        }
    }

    #[test]
    fn a_picture_comes_back_from_its_line() {
        let line = picture().line();
        assert_eq!(LoggedPicture::of_line(&line, [1, 2]), Ok(picture()));
        assert_eq!(LoggedPicture::of_line(&line, [2, 4]), Ok(picture()));
    }

    #[test]
    fn a_picture_that_does_not_fit_its_scene_or_its_size_is_refused() {
        let refused = |change: &dyn Fn(&mut PictureLine), of_scene: [u32; 2]| {
            let mut line = picture().line();
            change(&mut line);
            LoggedPicture::of_line(&line, of_scene).unwrap_err()
        };
        let same = |_: &mut PictureLine| {};
        let multiple = "a picture of 2 × 4 pixels is no whole multiple of the camera's 2 × 2";
        assert_eq!(refused(&same, [2, 2]), multiple);
        assert!(refused(&same, [3, 4]).contains("no whole multiple"));
        assert!(refused(&|line| line.samples = 0, [1, 2]).contains("at least 1 sample"));
        assert!(refused(&|line| line.png.push('?'), [1, 2]).contains("not base64"));
        assert!(refused(&|line| line.png = "AAAA".into(), [1, 2]).contains("no PNG"));
        // the size in the line is not the picture's own
        let other = refused(&|line| line.pixels = [4, 8], [1, 2]);
        assert_eq!(other, "the PNG has 2 × 4 pixels, not 4 × 8");
    }

    #[test]
    fn a_mistake_comes_back_from_its_line_with_what_is_no_number_in_words() {
        let spoilt = |quantity: &str, right: SpoiltValue, wrong: SpoiltValue| Spoilt {
            quantity: quantity.into(),
            right,
            wrong,
        };
        let mistake = LoggedMistake {
            name: "first root always".into(),
            pixel: [1, 3],
            spoilt: vec![
                spoilt("t", 2.0.into(), f64::NEG_INFINITY.into()),
                spoilt("N", DVec3::X.into(), DVec3::NAN.into()),
                spoilt("light", "blocked".into(), f64::NAN.into()),
            ],
            picture: Some(LoggedPicture {
                samples: 1,
                ..picture()
            }),
        };
        let json = serde_json::to_string(&mistake.line()).unwrap();
        assert!(json.contains(r#""right":2.0,"wrong":"−∞""#), "{json}");
        let line: MistakeLine = serde_json::from_str(&json).unwrap();
        assert_eq!(LoggedMistake::of_line(line, [2, 4]), Ok(mistake.clone()));
        let refused = LoggedMistake::of_line(mistake.line(), [2, 3]).unwrap_err();
        assert_eq!(refused, "pixel 1,3 is not in the picture of 2 × 3 pixels");
    }

    #[test]
    fn rows_of_tests_come_in_order_and_are_as_long_as_the_picture_is_wide() {
        let row = TestsOfRow {
            objects: vec![3, 0],
            nodes: vec![1, 9],
            cells: vec![0, 0],
        };
        let line = || row.line(5);
        assert_eq!(TestsOfRow::of_line(line(), 5, 2), Ok(row.clone()));
        let error = TestsOfRow::of_line(line(), 4, 2).unwrap_err();
        assert!(error.contains("row 4 is missing"), "{error}");
        let error = TestsOfRow::of_line(line(), 5, 3).unwrap_err();
        assert_eq!(error, "2 numbers for a row of 3 pixels");
    }
}
