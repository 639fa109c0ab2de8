//! Words between their quotation marks, put together while compiling.

use crate::trace::event::fields::Word;
use crate::trace::log::fast::short_text::ShortText;

/// No enum has more words.
const MOST: usize = 16;

/// A word and its quotation marks, as a line takes them.
type QuotedWord = ShortText<23>;

/// The words of an enum as a line takes them.
pub(super) trait Quoted: Word {
    /// By the place of the value.
    const QUOTED: &'static [QuotedWord; MOST] = &{
        let mut all = [ShortText::EMPTY; MOST];
        let mut at = 0;
        while at < Self::WORDS.len() {
            let word = Self::WORDS[at].1.as_bytes();
            let quoted = ShortText::EMPTY.with(b"\"").expect("room");
            let quoted = quoted.with(word).expect("longer than any word");
            all[at] = quoted.with(b"\"").expect("longer than any word");
            at += 1;
        }
        all
    };
}

impl<W: Word> Quoted for W {}
