//! The digits of small whole numbers, worked out beforehand: steps, pixels, rays and faces are short.

use crate::trace::log::fast::short_text::ShortText;

/// How many numbers have their digits here: all of up to three. They take 4 kB, an eighth of a first-level cache.
const COUNT: usize = 1000;

/// The digits of each number.
static DIGITS: [ShortText<3>; COUNT] = {
    let mut all = [ShortText::EMPTY; COUNT];
    let mut number = 0;
    while number < COUNT {
        let [hundreds, tens, ones] = [
            b'0' + (number / 100) as u8,
            b'0' + (number / 10 % 10) as u8,
            b'0' + (number % 10) as u8,
        ];
        let digits: &[u8] = match number {
            0..10 => &[ones],
            10..100 => &[tens, ones],
            _ => &[hundreds, tens, ones],
        };
        all[number] = ShortText::EMPTY.with(digits).expect("three digits");
        number += 1;
    }
    all
};

/// Appends a whole number.
#[inline]
pub(super) fn append_whole(number: u32, line: &mut Vec<u8>) {
    let Some(digits) = DIGITS.get(number as usize) else {
        line.extend_from_slice(itoa::Buffer::new().format(number).as_bytes());
        return;
    };
    digits.append_to(line);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_number_is_written_as_it_is_displayed() {
        for number in (0..=10_010).chain([99_999, 100_000, u32::MAX]) {
            let mut line = b"x".to_vec();
            append_whole(number, &mut line);
            assert_eq!(line, format!("x{number}").as_bytes());
        }
    }
}
