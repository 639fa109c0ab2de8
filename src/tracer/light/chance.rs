//! Chance: the random numbers of a path.
//!
//! Each path has a stream of numbers of its own, which depends on the seed and on the path's number alone. So a path
//! can be followed again at any time, and the threads that follow them share nothing.

use glam::DVec3;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// The numbers of one path.
#[derive(Debug)]
pub(in crate::tracer) struct Chance(ChaCha8Rng);

impl Chance {
    /// The numbers of a path of light.
    pub(in crate::tracer) fn of_light(seed: u64, path: u32) -> Self {
        Self::stream(seed, 2 * u64::from(path))
    }

    /// The numbers of a path from the eye.
    pub(in crate::tracer) fn of_eye(seed: u64, path: u32) -> Self {
        Self::stream(seed, 2 * u64::from(path) + 1)
    }

    fn stream(seed: u64, stream: u64) -> Self {
        let mut numbers = ChaCha8Rng::seed_from_u64(seed);
        numbers.set_stream(stream);
        Self(numbers)
    }

    /// ξ: every number in 0..1 is as likely, 1 is none of them.
    pub(in crate::tracer) fn number(&mut self) -> f64 {
        self.0.random()
    }

    /// A unit direction; every one is as likely: a density of 1/(4π) per steradian.
    ///
    /// G. Marsaglia, *Choosing a point from the surface of a sphere* (1972). Without sine and cosine, which differ
    /// in their last bits from one system to another.
    pub(in crate::tracer) fn direction(&mut self) -> DVec3 {
        loop {
            let [x, y] = [self.number(), self.number()].map(|number| 2.0 * number - 1.0);
            let squares = x * x + y * y;
            if squares < 1.0 {
                let root = 2.0 * (1.0 - squares).sqrt();
                return DVec3::new(x * root, y * root, 1.0 - 2.0 * squares);
            }
        }
    }

    /// A unit direction on the side of a unit normal, the likelier the closer to it (Lambert): a density of
    /// cos θ/π per steradian.
    ///
    /// The sphere of radius 1 that touches the surface from above is seen from the point under those densities.
    pub(in crate::tracer) fn around(&mut self, normal: DVec3) -> DVec3 {
        (normal + self.direction()).normalize_or(normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means of 100 000 numbers of variance up to 1/3 are off by less than 5 · √(1/3 / 100 000).
    const FIVE_DEVIATIONS: f64 = 0.0092;

    const COUNT: u32 = 100_000;

    fn mean(mut of: impl FnMut() -> DVec3) -> DVec3 {
        (0..COUNT).map(|_| of()).sum::<DVec3>() / f64::from(COUNT)
    }

    #[test]
    fn directions_have_unit_length_no_preference_and_a_third_of_a_square_along_each_axis() {
        let mut chance = Chance::of_light(7, 0);
        let middle = mean(|| chance.direction());
        assert!(middle.length() <= 2.0 * FIVE_DEVIATIONS, "{middle}");
        let squares = mean(|| {
            let direction = chance.direction();
            assert!((direction.length() - 1.0).abs() <= 1e-15);
            direction * direction
        });
        let off = squares - DVec3::splat(1.0 / 3.0);
        assert!(off.abs().max_element() <= FIVE_DEVIATIONS, "{squares}");
    }

    #[test]
    fn around_a_normal_the_mean_cosine_is_two_thirds() {
        // ∫ cos θ · cos θ/π dω = 2/3
        let normal = DVec3::new(0.6, 0.0, -0.8);
        let mut chance = Chance::of_eye(7, 3);
        let middle = mean(|| {
            let direction = chance.around(normal);
            assert!(0.0 <= direction.dot(normal));
            direction
        });
        assert!(
            (middle - normal * 2.0 / 3.0).length() <= 2.0 * FIVE_DEVIATIONS,
            "{middle}"
        );
    }

    #[test]
    fn a_path_has_the_same_numbers_every_time_and_no_other_path_has_them() {
        let first = |mut chance: Chance| chance.number();
        let all = [
            Chance::of_light(1, 0),
            Chance::of_eye(1, 0),
            Chance::of_light(1, 1),
            Chance::of_light(2, 0),
        ]
        .map(first);
        assert_eq!(all[2], first(Chance::of_light(1, 1)));
        for (i, number) in all.iter().enumerate() {
            assert!(!all[..i].contains(number), "{all:?}");
        }
    }

    #[test]
    fn no_path_of_light_has_the_numbers_of_another_or_of_a_path_from_the_eye() {
        let mut firsts: Vec<u64> = (0..100)
            .flat_map(|path| [Chance::of_light(1, path), Chance::of_eye(1, path)])
            .map(|mut chance| chance.number().to_bits())
            .collect();
        firsts.sort_unstable();
        firsts.dedup();
        assert_eq!(firsts.len(), 200);
    }
}
