//! Numbers for cases: the same ones each time.

use glam::DVec3;

use crate::lesson::exercise::keyed_hash::keyed_hash;

/// Where the numbers of seeded cases come from: they are the same for everybody, or those of a lecturer's secret.
///
/// Each exercise has a stream of its own. Of a secret it begins with a keyed hash, so the cases of one exercise say nothing of
/// those of another; only whoever can guess the secret can compute them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seeds(Option<[u64; 2]>);

impl Seeds {
    /// Those of the public course.
    pub const PUBLIC: Self = Self(None);

    /// Those of a secret: any text.
    pub fn of_secret(secret: &str) -> Self {
        // two keys that nobody needs to hide, for two halves of a key
        Self(Some(
            [1, 2].map(|half| keyed_hash([half, 0], secret.as_bytes())),
        ))
    }

    /// Are these the ones of a secret?
    pub fn are_secret(&self) -> bool {
        self.0.is_some()
    }

    /// The numbers of an exercise.
    pub(super) fn stream(&self, exercise: u64) -> Seeded {
        Seeded::new(match self.0 {
            None => exercise,
            Some(key) => keyed_hash(key, &exercise.to_le_bytes()),
        })
    }
}

/// A stream of numbers, after G. Steele, D. Lea and C. Flood, *Fast splittable pseudorandom number generators* (2014).
#[derive(Clone, Debug)]
pub(in crate::lesson) struct Seeded(u64);

impl Seeded {
    pub(in crate::lesson) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A stream of its own for each name and each number.
    pub(in crate::lesson) fn of(name: &str, number: u64) -> Self {
        Self(keyed_hash([number, 0], name.as_bytes()))
    }

    /// In [0, 1).
    pub(in crate::lesson) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        // 53 bits
        (z >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(in crate::lesson) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.number()
    }

    /// A whole number below another.
    pub(in crate::lesson) fn below(&mut self, end: u32) -> u32 {
        (self.number() * f64::from(end)) as u32
    }

    /// Each coordinate in [−size, size).
    pub(in crate::lesson) fn point(&mut self, size: f64) -> DVec3 {
        DVec3::new(
            self.within(-size, size),
            self.within(-size, size),
            self.within(-size, size),
        )
    }

    /// A unit vector.
    pub(in crate::lesson) fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point(1.0);
            let length = point.length();
            if 0.1 < length && length <= 1.0 {
                return point / length;
            }
        }
    }
}
