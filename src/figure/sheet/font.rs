//! How wide a line of letters is.
//!
//! The widths are those of DejaVu Sans (version 2.37), one of the widest fonts for screens: in Open Sans, Arial or
//! Helvetica the same letters are narrower, and what has room here has room there.

/// How wide a text is, in sizes of its letters. A letter that the table does not have counts as the widest that a
/// script has, a full square and a half.
pub fn text_width(text: &str) -> f64 {
    text.chars().map(advance).sum()
}

/// How far one letter moves on, in sizes of the letter.
fn advance(letter: char) -> f64 {
    /// A full square and a half, in units.
    const UNKNOWN: u16 = 3 * 1024;
    let within = |table: &[u16], first: char| {
        let place = u32::from(letter).checked_sub(u32::from(first))?;
        table.get(place as usize).copied()
    };
    let units = within(&ASCII, ' ')
        .or_else(|| within(&LATIN, '\u{a0}'))
        .or_else(|| within(&GREEK, 'Α'))
        .or_else(|| {
            let found = OTHERS.binary_search_by_key(&letter, |(of, _)| *of).ok()?;
            Some(OTHERS[found].1)
        });
    f64::from(units.unwrap_or(UNKNOWN)) / UNITS
}

/// Units of the font in one size of the letter.
const UNITS: f64 = 2048.0;

/// From the space to `~`.
const ASCII: [u16; 95] = [
    651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716, 651, 739, 651, 690, 1303,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690, 690, 1716, 1716, 1716, 1087, 2048,
    1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532, 1612, 1235,
    1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799, 690, 799, 1716, 1024, 1024,
    1255, 1300, 1126, 1300, 1260, 721, 1300, 1298, 569, 569, 1186, 569, 1995, 1298, 1253, 1300,
    1300, 842, 1067, 803, 1298, 1212, 1675, 1212, 1212, 1075, 1303, 690, 1303, 1716,
];
/// From the space that does not break to `ÿ`.
const LATIN: [u16; 96] = [
    651, 821, 1303, 1303, 1303, 1303, 690, 1024, 1024, 2048, 965, 1253, 1716, 739, 2048, 1024,
    1024, 1716, 821, 821, 1024, 1303, 1303, 651, 1024, 821, 965, 1253, 1985, 1985, 1985, 1087,
    1401, 1401, 1401, 1401, 1401, 1401, 1995, 1430, 1294, 1294, 1294, 1294, 604, 604, 604, 604,
    1587, 1532, 1612, 1612, 1612, 1612, 1612, 1716, 1612, 1499, 1499, 1499, 1499, 1251, 1239, 1290,
    1255, 1255, 1255, 1255, 1255, 1255, 2011, 1126, 1260, 1260, 1260, 1260, 569, 569, 569, 569,
    1253, 1298, 1253, 1253, 1253, 1253, 1253, 1716, 1253, 1298, 1298, 1298, 1298, 1212, 1300, 1212,
];
/// From `Α` to `ω`.
const GREEK: [u16; 57] = [
    1401, 1405, 1141, 1401, 1294, 1403, 1540, 1612, 604, 1343, 1401, 1767, 1532, 1294, 1612, 1540,
    1235, 0, 1294, 1251, 1251, 1612, 1403, 1612, 1565, 604, 1251, 1350, 1107, 1298, 693, 1185,
    1350, 1307, 1212, 1253, 1107, 1114, 1298, 1253, 693, 1207, 1212, 1303, 1144, 1142, 1253, 1233,
    1300, 1202, 1298, 1233, 1185, 1351, 1183, 1351, 1715,
];
/// Signs of formulas and typography, in the order of their code points.
const OTHERS: [(char, u16); 72] = [
    ('Σ', 1294),
    ('ᵢ', 366),
    ('‐', 739),
    ('–', 1024),
    ('—', 2048),
    ('‘', 651),
    ('’', 651),
    ('“', 1061),
    ('”', 1061),
    ('…', 2048),
    ('′', 465),
    ('″', 765),
    ('⁰', 821),
    ('⁴', 821),
    ('⁵', 821),
    ('⁶', 821),
    ('⁷', 821),
    ('⁸', 821),
    ('⁹', 821),
    ('₀', 821),
    ('₁', 821),
    ('₂', 821),
    ('₃', 821),
    ('₄', 821),
    ('₅', 821),
    ('₆', 821),
    ('₇', 821),
    ('₈', 821),
    ('₉', 821),
    ('ₓ', 909),
    ('ₖ', 872),
    ('ₙ', 816),
    ('←', 1716),
    ('↑', 1716),
    ('→', 1716),
    ('↓', 1716),
    ('↔', 1716),
    ('⇒', 1716),
    ('∅', 1784),
    ('∈', 1784),
    ('∑', 1380),
    ('−', 1716),
    ('√', 1305),
    ('∞', 1706),
    ('∠', 1836),
    ('∥', 1024),
    ('∩', 1499),
    ('∪', 1499),
    ('≈', 1716),
    ('≠', 1716),
    ('≡', 1716),
    ('≤', 1716),
    ('≥', 1716),
    ('⊥', 1784),
    ('⋅', 651),
    ('⌀', 1233),
    ('■', 1935),
    ('□', 1935),
    ('▪', 1388),
    ('▫', 1388),
    ('▲', 1575),
    ('△', 1575),
    ('▼', 1575),
    ('▽', 1575),
    ('◆', 1575),
    ('◇', 1575),
    ('○', 1787),
    ('●', 1787),
    ('✓', 1716),
    ('✕', 1716),
    ('✗', 1716),
    ('ⱼ', 358),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_as_wide_as_in_the_font() {
        // i, W, 0, ω and √ in DejaVu Sans: 569, 2025, 1303, 1715 and 1305 units of 2048
        for (text, units) in [
            ("i", 569.0),
            ("W", 2025.0),
            ("0", 1303.0),
            ("ω", 1715.0),
            ("√", 1305.0),
        ] {
            assert_eq!(text_width(text), units / 2048.0, "{text}");
        }
        assert_eq!(text_width("iW"), (569.0 + 2025.0) / 2048.0);
        assert_eq!(text_width(""), 0.0);
    }

    #[test]
    fn a_letter_of_another_script_has_room() {
        assert_eq!(text_width("界"), 1.5);
    }

    #[test]
    fn the_table_of_others_is_sorted_for_the_search() {
        assert!(OTHERS.is_sorted_by_key(|(letter, _)| *letter));
    }
}
