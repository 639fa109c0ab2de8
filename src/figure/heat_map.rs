//! Heat maps: a number for each pixel as a colour, with a legend.

use font8x8::legacy::BASIC_LEGACY;

/// A picture in 8 bits a channel, red, green and blue, row by row from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    /// Width and height of the picture in pixels, the legend included.
    pub pixels: [u32; 2],
    /// Three bytes for each pixel.
    pub bytes: Vec<u8>,
}

pub(super) type Rgb = [u8; 3];

/// The colours from the smallest number to the largest, in equal steps: viridis, by S. van der Walt and
/// N. Smith (matplotlib 1.5, 2015, CC0), at 0, ⅛, … 1. Its lightness grows all along, so that it reads the
/// same in grey and with any colour vision.
const SCALE: [Rgb; 9] = [
    [68, 1, 84],
    [71, 45, 123],
    [59, 82, 139],
    [44, 114, 142],
    [33, 145, 140],
    [40, 174, 128],
    [94, 201, 98],
    [173, 220, 48],
    [253, 231, 37],
];

const PAPER: Rgb = [255; 3];
const INK: Rgb = [0; 3];

/// Side of a letter of the font in units of the legend.
const LETTER: usize = 8;

/// Units around and between the parts of the legend: half a letter where they belong together.
const GAP: usize = LETTER / 2;

/// Height of the bar of colours, in units: a letter and a half, so that its colours can be distinguished.
const BAR: usize = 12;

/// The legend's width in units: the longest title has 39 letters.
const LEGEND_WIDTH: usize = 40 * LETTER;

/// The legend's height in units: title, bar, ticks, numbers, and gaps.
const LEGEND_HEIGHT: usize = LETTER + BAR + GAP + LETTER + 4 * GAP;

/// Draws one value for each pixel, from the smallest in dark blue to the largest in yellow, in equal steps,
/// and below it a legend with a title of up to 39 letters and the numbers.
///
/// The longer side of a small picture is enlarged by a whole factor to at least the legend's width, so that
/// each pixel is a square. If all values are equal, all are dark blue and the legend says so.
pub fn heat_map(pixels: [u32; 2], values: &[f64], title: &str) -> Raster {
    let [width, height] = pixels.map(|side| side as usize);
    let factor = LEGEND_WIDTH.div_ceil(width.max(height).max(1)).max(1);
    let map_width = width * factor;
    // letters grow with the picture
    let unit = (map_width / LEGEND_WIDTH).max(1);
    let mut sheet = Sheet::blank(
        map_width.max(LEGEND_WIDTH * unit),
        height * factor + LEGEND_HEIGHT * unit,
    );
    let scale = Range::of(values);
    for (place, &value) in values.iter().enumerate() {
        let corner = [place % width * factor, place / width * factor];
        sheet.fill(corner, [factor; 2], colour(scale.share(value)));
    }
    sheet.legend([0, height * factor], unit, &scale, title);
    sheet.raster()
}

/// The same colours with one pixel for each value and no legend, red, green, blue and how opaque it is, and the smallest and
/// the largest value. A pixel without a value is clear.
pub fn heat_overlay(values: &[Option<f64>]) -> (Vec<u8>, [f64; 2]) {
    let known: Vec<f64> = values.iter().copied().flatten().collect();
    let scale = Range::of(&known);
    let bytes = values.iter().flat_map(|value| match value {
        Some(value) => {
            let [r, g, b] = colour(scale.share(*value));
            [r, g, b, u8::MAX]
        }
        None => [0; 4],
    });
    (bytes.collect(), [scale.min, scale.max])
}

/// The colours of a heat map from the smallest value to the largest, in equal steps.
pub fn heat_scale() -> [[u8; 3]; 9] {
    SCALE
}

/// The colour at a share of the scale, from 0 to 1; between two of [`SCALE`] in proportion.
pub(super) fn colour(share: f64) -> Rgb {
    let place = share.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let below = (place as usize).min(SCALE.len() - 2);
    let rest = place - below as f64;
    std::array::from_fn(|channel| {
        let [from, to] = [SCALE[below], SCALE[below + 1]].map(|rgb| f64::from(rgb[channel]));
        (from + rest * (to - from)).round() as u8
    })
}

/// From the smallest value to the largest.
struct Range {
    min: f64,
    max: f64,
}

impl Range {
    fn of(values: &[f64]) -> Self {
        let first = values.first().copied().unwrap_or(0.0);
        Self {
            min: values.iter().copied().fold(first, f64::min),
            max: values.iter().copied().fold(first, f64::max),
        }
    }

    /// Where a value lies, from 0 to 1; 0 if all are equal.
    fn share(&self, value: f64) -> f64 {
        if self.max <= self.min {
            return 0.0;
        }
        (value - self.min) / (self.max - self.min)
    }
}

/// A count or the mean of four, without zeros at its end: the middle of two such has up to three decimals.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// What is drawn on.
struct Sheet {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

impl Sheet {
    fn blank(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            bytes: PAPER.repeat(width * height),
        }
    }

    fn raster(self) -> Raster {
        Raster {
            pixels: [self.width as u32, self.height as u32],
            bytes: self.bytes,
        }
    }

    /// Fills a rectangle, of which a part may lie outside.
    fn fill(&mut self, [left, top]: [usize; 2], [width, height]: [usize; 2], colour: Rgb) {
        let right = (left + width).min(self.width);
        for y in top..(top + height).min(self.height) {
            let row = (y * self.width + left.min(right)) * 3..(y * self.width + right) * 3;
            for pixel in self.bytes[row].chunks_exact_mut(3) {
                pixel.copy_from_slice(&colour);
            }
        }
    }

    /// Letters of 8 × 8 units; one that the font does not have is a question mark.
    fn write(&mut self, [left, top]: [usize; 2], unit: usize, text: &str) {
        for (place, letter) in text.chars().enumerate() {
            let known = BASIC_LEGACY.get(letter as usize);
            let glyph = known.unwrap_or(&BASIC_LEGACY[usize::from(b'?')]);
            let left = left + place * LETTER * unit;
            for (row, bits) in glyph.iter().enumerate() {
                // the lowest bit is the leftmost
                for column in (0..LETTER).filter(|column| (bits >> column) & 1 == 1) {
                    let corner = [left + column * unit, top + row * unit];
                    self.fill(corner, [unit; 2], INK);
                }
            }
        }
    }

    /// Title, bar, ticks and numbers, from the top down.
    fn legend(&mut self, [left, top]: [usize; 2], unit: usize, scale: &Range, title: &str) {
        let left = left + GAP * unit;
        let mut top = top + GAP * unit;
        self.write([left, top], unit, title);
        top += (LETTER + GAP) * unit;

        let width = (LEGEND_WIDTH - 2 * GAP) * unit;
        for x in 0..width {
            let share = x as f64 / (width - 1) as f64;
            let shown = scale.min + share * (scale.max - scale.min);
            let colour = colour(scale.share(shown));
            self.fill([left + x, top], [1, BAR * unit], colour);
        }
        top += BAR * unit;

        let middle = f64::midpoint(scale.min, scale.max);
        let labels = if scale.max <= scale.min {
            vec![(0.5, format!("{} everywhere", number(scale.min)))]
        } else {
            let ends = [(0.0, scale.min), (0.5, middle), (1.0, scale.max)];
            ends.map(|(share, value)| (share, number(value))).into()
        };
        for (share, label) in labels {
            // at its place the tick and the text have the same share of themselves to the left
            let at = |own: usize| left + (share * (width - own) as f64) as usize;
            self.fill([at(unit), top], [unit, GAP * unit], INK);
            let letters = label.chars().count() * LETTER * unit;
            self.write(
                [at(letters.min(width)), top + (GAP + 2) * unit],
                unit,
                &label,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of an sRGB colour (IEC 61966-2-1).
    fn luminance(rgb: Rgb) -> f64 {
        let [r, g, b] = rgb.map(|byte| {
            let value = f64::from(byte) / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                ((value + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn a_larger_number_is_lighter() {
        // in finer steps than these the rounding to bytes shows
        let shades: Vec<f64> = (0..=64)
            .map(|i| luminance(colour(f64::from(i) / 64.0)))
            .collect();
        assert!(shades.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn the_ends_and_the_middle_are_those_of_the_scale() {
        assert_eq!(colour(0.0), [68, 1, 84]);
        assert_eq!(colour(0.5), [33, 145, 140]);
        assert_eq!(colour(1.0), [253, 231, 37]);
        // half way between the first two: (68 + 71)/2 = 69.5, (1 + 45)/2 = 23, (84 + 123)/2 = 103.5
        assert_eq!(colour(1.0 / 16.0), [70, 23, 104]);
    }

    #[test]
    fn counts_and_means_are_written_without_needless_zeros() {
        assert_eq!(number(12.0), "12");
        assert_eq!(number(0.0), "0");
        assert_eq!(number(2.5), "2.5");
        assert_eq!(number(0.125), "0.125");
        assert_eq!(number(1000.0), "1000");
    }

    #[test]
    fn the_shape_of_a_picture_and_its_values_decide_nothing_else() {
        for [width, height] in [[1, 1], [2, 1], [1, 900], [900, 1], [16, 12], [700, 500]] {
            let values = vec![3.0; (width * height) as usize];
            let map = heat_map([width, height], &values, "object tests per pixel");
            let [w, h] = map.pixels;
            assert_eq!(map.bytes.len(), (w * h * 3) as usize);
            assert_eq!(map.bytes[..3], [68, 1, 84]);
            assert!(width <= w && height < h);
        }
    }

    #[test]
    fn a_letter_stands_as_the_font_has_it() {
        let mut sheet = Sheet::blank(LETTER, LETTER);
        sheet.write([0, 0], 1, "I");
        let row = |y: usize| -> String {
            let line = sheet.bytes[y * LETTER * 3..].chunks_exact(3).take(LETTER);
            line.map(|rgb| if rgb[0] == 0 { '#' } else { '.' })
                .collect()
        };
        // a capital I with serifs, upright and not mirrored
        assert_eq!(
            [row(0), row(1), row(6)],
            [".####...", "..##....", ".####..."]
        );
    }
}
