//! The digits of numbers, remembered.
//!
//! To find the shortest digits that read back as the same number takes longer than all else in a
//! line. Half the numbers of a log have been there before: the coefficients of each plane, the
//! projected ends of each edge, the origin of a ray, the root that is the hit.

use crate::trace::log::fast::short_text::ShortText;

/// How many numbers are remembered: a power of two, and with 32 bytes each half of what a second-level
/// cache holds. A quarter of them would forget the planes of a thousand polygons from ray to ray.
const REMEMBERED: usize = 1 << 12;

/// The longest text that is remembered: with the bits and the length it takes 32 bytes.
const LONGEST: usize = 23;

/// Writes numbers, and knows the texts of some.
///
/// [`NumberTexts::default`] remembers none and takes no memory.
#[derive(Clone, Debug, Default)]
pub(super) struct NumberTexts {
    known: Vec<Known>,
    /// The bits of the number that was last formed for each place: whoever comes again is remembered. So the
    /// half that comes once takes no place from the others.
    formed: Vec<u64>,
}

/// A number by its bits, and its text.
#[derive(Clone, Copy, Debug)]
struct Known {
    bits: u64,
    text: ShortText<LONGEST>,
}

impl NumberTexts {
    /// Knows none yet and will remember them.
    pub(super) fn remembering() -> Self {
        // not a number: never asked for
        let bits = f64::NAN.to_bits();
        let text = ShortText::EMPTY;
        Self {
            known: vec![Known { bits, text }; REMEMBERED],
            formed: vec![bits; REMEMBERED],
        }
    }

    /// Appends a finite number: the shortest digits that read back as it, and `.0` after a whole one.
    #[inline]
    pub(super) fn append(&mut self, value: f64, line: &mut Vec<u8>) {
        // every fourth number is one digit: a normal's 0.0, a unit direction's a = 1.0
        let digit = value.abs() as u8;
        if digit < 10 && f64::from(digit) == value.abs() {
            if value.is_sign_negative() {
                line.push(b'-');
            }
            line.extend_from_slice(&[b'0' + digit, b'.', b'0']);
            return;
        }
        let bits = value.to_bits();
        match self.known.get(place(bits)) {
            Some(known) if known.bits == bits => known.text.append_to(line),
            _ => self.form(value, line),
        }
    }

    /// Appends a number that is not known; the second time it is remembered in the place of another.
    #[inline(never)]
    fn form(&mut self, value: f64, line: &mut Vec<u8>) {
        let mut buffer = zmij::Buffer::new();
        let digits = buffer.format_finite(value).as_bytes();
        line.extend_from_slice(digits);
        let bits = value.to_bits();
        let place = place(bits);
        let Some(formed) = self.formed.get_mut(place) else {
            return;
        };
        if *formed != bits {
            *formed = bits;
        } else if let Some(text) = ShortText::EMPTY.with(digits) {
            self.known[place] = Known { bits, text };
        }
    }
}

/// Where a number is remembered: the upper bits of a product with 2⁶⁴/φ, which depend on all of its bits
/// (Knuth, The Art of Computer Programming, volume 3, section 6.4).
#[inline]
fn place(bits: u64) -> usize {
    let product = bits.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (product >> (u64::BITS - REMEMBERED.ilog2())) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_has_the_text_of_serde_json_whether_known_or_not() {
        let mut values = vec![
            0.0,
            -0.0,
            1.0,
            -1.0,
            9.0,
            10.0,
            255.0,
            256.0,
            0.1,
            -0.5,
            1e15,
            1e16,
            1e22,
            1e-5,
            1e-7,
            5e-324,
            -f64::MIN_POSITIVE,
            f64::MAX,
            f64::MIN,
            0.1 + 0.2,
            1.0 / 3.0,
        ];
        // more than are remembered, so that some lose their place
        values.extend((1..2 * REMEMBERED as u32).map(|i| f64::from(i).sqrt()));
        let mut remembers = NumberTexts::remembering();
        let mut forgets = NumberTexts::default();
        for value in [values.clone(), values].concat() {
            let expected = serde_json::to_vec(&value).unwrap();
            for texts in [&mut remembers, &mut forgets] {
                for _ in 0..2 {
                    let mut line = Vec::new();
                    texts.append(value, &mut line);
                    assert_eq!(line, expected, "{value}");
                }
            }
        }
    }
}
