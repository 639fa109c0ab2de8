//! Round numbers along an axis.

/// The numbers 1, 2 and 5, which are about equally far apart where equal ratios are equal lengths.
const ROUND: [u128; 3] = [1, 2, 5];

/// The numbers 0, step, 2·step, … up to the first that is not below the largest count: some five of them, with a step of
/// 1, 2 or 5 times a power of ten. An axis of no count ends at 1.
pub(in crate::figure) fn linear(most: u128) -> Vec<u128> {
    /// With a step of 1, 2 or 5 there are from 3 to 6.
    const STEPS: u128 = 5;
    let most = most.max(1);
    let mut steps = powers_of_ten().flat_map(|power| ROUND.map(|round| round * power));
    let step = steps.find(|step| most <= STEPS * step).unwrap_or(most);
    (0..=most.div_ceil(step)).map(|of| of * step).collect()
}

/// The numbers 1, 2, 5, 10, 20, … from the last that is not above the smallest count up to the first that is not below the
/// largest. Counts of 0 stand with the 1.
pub(in crate::figure) fn logarithmic(least: u64, most: u64) -> Vec<u128> {
    let [least, most] = [least, most].map(|of| u128::from(of.max(1)));
    let all: Vec<u128> = powers_of_ten()
        .flat_map(|power| ROUND.map(|round| round * power))
        .collect();
    let first = all.iter().rposition(|of| *of <= least).unwrap_or(0);
    let last = all.iter().position(|of| most <= *of).unwrap_or(first);
    all[first..=last.max(first)].to_vec()
}

/// 1, 10, 100, … beyond the largest count.
fn powers_of_ten() -> impl Iterator<Item = u128> {
    (0..21).map(|power| 10u128.pow(power))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_axis_ends_at_a_round_number_near_the_largest() {
        for (most, expected) in [
            (0, vec![0, 1]),
            (1, vec![0, 1]),
            (4, vec![0, 1, 2, 3, 4]),
            (6, vec![0, 2, 4, 6]),
            (200, vec![0, 50, 100, 150, 200]),
            (201, vec![0, 50, 100, 150, 200, 250]),
            (413, vec![0, 100, 200, 300, 400, 500]),
        ] {
            assert_eq!(linear(most), expected, "{most}");
        }
        // the largest count of all is 1.8·10¹⁹
        let ticks = linear(u64::MAX.into());
        assert_eq!(ticks.last(), Some(&20_000_000_000_000_000_000));
        for most in (0..64).map(|bits| u64::MAX >> bits) {
            let most = u128::from(most);
            let ticks = linear(most);
            assert!((2..=6).contains(&ticks.len()), "{most}: {ticks:?}");
            assert!(most <= ticks[ticks.len() - 1], "{most}");
        }
    }

    #[test]
    fn a_logarithmic_axis_holds_all_counts_between_round_numbers() {
        assert_eq!(logarithmic(3, 200), [2, 5, 10, 20, 50, 100, 200]);
        assert_eq!(logarithmic(0, 6), [1, 2, 5, 10]);
        assert_eq!(logarithmic(10, 10), [10]);
        assert_eq!(logarithmic(0, 0), [1]);
        let widest = logarithmic(0, u64::MAX);
        assert_eq!(widest.last(), Some(&20_000_000_000_000_000_000));
    }
}
