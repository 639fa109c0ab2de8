//! The digits of small whole numbers, worked out beforehand: steps, pixels, rays and faces are short.

/// How many numbers have their digits here: all of up to three. They take 4 kB, an eighth of a first-level cache.
const COUNT: usize = 1000;

/// The digits of each number, from the first on, and in the last byte how many there are.
static DIGITS: [[u8; 4]; COUNT] = {
    let mut all = [[0; 4]; COUNT];
    let mut number = 0;
    while number < COUNT {
        let [hundreds, tens, ones] = [
            b'0' + (number / 100) as u8,
            b'0' + (number / 10 % 10) as u8,
            b'0' + (number % 10) as u8,
        ];
        all[number] = match number {
            0..10 => [ones, 0, 0, 1],
            10..100 => [tens, ones, 0, 2],
            _ => [hundreds, tens, ones, 3],
        };
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
    // a copy of a fixed length is one instruction, of any other a call
    let end = line.len() + usize::from(digits[3]);
    line.extend_from_slice(digits);
    line.truncate(end);
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
