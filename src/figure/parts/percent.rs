//! Shares in percent.

use crate::figure::sheet::canvas::brief;

/// A share in percent: near 100 with enough digits to show two digits of the rest.
pub(in crate::figure) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if 99.0 < percent && percent < 100.0 {
        // of 0.004 that is left the first digit stands at the third place, and zeros at the end are cut off
        let left = 100.0 - percent;
        let digits = (1.0 - libm::log10(left).floor()).max(0.0) as usize;
        let text = format!("{percent:.digits$}");
        return text.trim_end_matches('0').trim_end_matches('.').into();
    }
    brief(percent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_near_1_keeps_two_digits_of_what_is_left() {
        for (share, text) in [
            (0.5, "50"),
            (0.999_96, "99.996"),
            (0.9912, "99.12"),
            (1.0, "100"),
            (0.0, "0"),
        ] {
            assert_eq!(percent(share), text);
        }
    }
}
