//! Short texts, which a line takes with a single copy.
//!
//! A copy of a fixed length is a few instructions, of any other length a call. So a short text is copied with all
//! the room that it has, and what is behind its end is cut off again.

/// A text of up to `ROOM` bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortText<const ROOM: usize> {
    bytes: [u8; ROOM],
    length: u8,
}

impl<const ROOM: usize> ShortText<ROOM> {
    /// Nothing.
    pub(super) const EMPTY: Self = Self {
        bytes: [0; ROOM],
        length: 0,
    };

    /// The text with another behind it; `None` if there is no room for both.
    #[inline]
    pub(super) const fn with(mut self, more: &[u8]) -> Option<Self> {
        let start = self.length as usize;
        let end = start + more.len();
        if ROOM < end {
            return None;
        }
        let (_, free) = self.bytes.split_at_mut(start);
        let (place, _) = free.split_at_mut(more.len());
        place.copy_from_slice(more);
        self.length = end as u8;
        Some(self)
    }

    /// Appends the text.
    #[inline]
    pub(super) fn append_to(&self, line: &mut Vec<u8>) {
        let end = line.len() + usize::from(self.length);
        line.extend_from_slice(&self.bytes);
        line.truncate(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_appended_up_to_its_end() {
        let text = ShortText::<5>::EMPTY.with(b"ab").unwrap();
        let mut line = b"x".to_vec();
        for text in [
            ShortText::EMPTY,
            text,
            text.with(b"").unwrap(),
            text.with(b"cde").unwrap(),
        ] {
            text.append_to(&mut line);
        }
        assert_eq!(line, b"xabababcde");
    }

    #[test]
    fn a_text_that_is_too_long_is_none() {
        let full = ShortText::<3>::EMPTY.with(b"abc").unwrap();
        assert!(full.with(b"").is_some());
        assert!(full.with(b"d").is_none());
    }
}
