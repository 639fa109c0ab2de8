//! Random numbers that are the same on every run and every machine.

use glam::DVec3;

/// SplitMix64 (Steele, Lea and Flood 2014): one addition and one hash of 64 bits per number.
pub(crate) struct Seeded(u64);

impl Seeded {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to just below 1, in steps of 2⁻⁵³.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5 * f64::EPSILON)
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// 10^x with x from `low` to `high`: every order of magnitude alike.
    pub(crate) fn power(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.within(low, high))
    }

    /// −1 or 1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// From 0 to just below `count`.
    pub(crate) fn index(&mut self, count: usize) -> usize {
        (((self.bits() >> 32) * count as u64) >> 32) as usize
    }

    /// A whole number from `low` to `high`, both included.
    pub(crate) fn whole(&mut self, low: i32, high: i32) -> i32 {
        low + self.within(0.0, f64::from(high - low + 1)) as i32
    }

    /// Each coordinate from −size to size.
    pub(crate) fn point(&mut self, size: f64) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.within(-size, size)))
    }

    /// Unit length, all directions alike.
    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.point(1.0);
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }

    /// Unit length, at right angles to `axis`.
    pub(crate) fn across(&mut self, axis: DVec3) -> DVec3 {
        loop {
            let v = self.direction().cross(axis);
            if 0.01 * axis.length_squared() <= v.length_squared() {
                return v.normalize();
            }
        }
    }
}
