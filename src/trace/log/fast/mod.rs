//! What exists for speed alone in writing and reading a line.

pub(in crate::trace) mod line_scanner;
pub(in crate::trace) mod number_texts;
pub(in crate::trace) mod scanner;
pub(in crate::trace) mod short_text;
pub(in crate::trace) mod small_numbers;
