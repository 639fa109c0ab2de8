//! The fixed set of directions of slabs that all bounds of a structure share (Fig. 15.58).
//!
//! "Each slab is represented by equation (iv), where A, B and C are constant, and D is either D_min or
//! D_max." So A, B and C are kept here once for all bounds.

use std::fmt;

use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The most directions that a set may have. T. Kay and J. Kajiya (1986) found no gain beyond some ten.
pub const MOST_SLABS: usize = 16;

/// Which set of slabs is taken?
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum SlabChoice {
    /// The three axes: a box.
    #[default]
    Axes,
    /// The axes and the four diagonals of a cube: the seven of Kay and Kajiya's paper.
    Seven,
    /// The set in the scene file.
    Scene,
}

/// A set of N directions, or of up to N: the rest of the list is then zero, and a slab across nothing
/// holds everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabSet<const N: usize> {
    /// (A, B, C) of each slab, of unit length.
    directions: [DVec3; N],
    len: usize,
    /// Are the first three x, y and z? Then a product with them is a coordinate.
    axes_first: bool,
}

/// Why a list of directions is no set of slabs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlabSetError {
    /// A direction is zero or not finite.
    NoDirection {
        /// Its place in the list, from 0.
        slab: usize,
    },
    /// Two directions are parallel: one slab would stand in the other's way.
    Parallel {
        /// The first of the two, from 0.
        first: usize,
        /// The second.
        second: usize,
    },
    /// All lie in one plane: what they enclose goes on for ever across it.
    Unbounded {
        /// How many of them are independent.
        independent: usize,
    },
    /// More than [`MOST_SLABS`].
    TooMany {
        /// How many there are.
        count: usize,
    },
}

impl fmt::Display for SlabSetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoDirection { slab } => {
                write!(
                    f,
                    "slabs[{slab}] of the scene is zero\n  give it a direction [A, B, C], or leave it out"
                )
            }
            Self::Parallel { first, second } => write!(
                f,
                "slabs[{first}] and slabs[{second}] of the scene are parallel\n  leave one of them out"
            ),
            Self::Unbounded { independent } => write!(
                f,
                "the slabs of the scene do not bound: they have {independent} of the 3 independent directions \
                 that it takes\n  {}",
                match independent {
                    0 => "give three directions [A, B, C] that lie in no plane",
                    1 => "add two directions that lie in no plane with the first",
                    _ => "add a direction across the plane of the others",
                }
            ),
            Self::TooMany { count } => {
                write!(
                    f,
                    "the slabs of the scene have {count} directions\n  leave some out; {MOST_SLABS} are the most"
                )
            }
        }
    }
}

impl std::error::Error for SlabSetError {}

impl SlabSet<3> {
    /// x, y and z: three slabs make a box.
    pub const AXES: Self = Self {
        directions: DVec3::AXES,
        len: 3,
        axes_first: true,
    };
}

impl SlabSet<7> {
    /// The axes and the four diagonals of a cube, in the order of the paper (Kay and Kajiya 1986).
    pub const SEVEN: Self = {
        /// 1/√3: a diagonal of length 1.
        const D: f64 = 0.577_350_269_189_625_8;
        Self {
            directions: [
                DVec3::X,
                DVec3::Y,
                DVec3::Z,
                DVec3::new(D, D, D),
                DVec3::new(-D, D, D),
                DVec3::new(-D, -D, D),
                DVec3::new(D, -D, D),
            ],
            len: 7,
            axes_first: true,
        }
    };
}

impl SlabSet<MOST_SLABS> {
    /// A set of one's own. Directions may have any length; they are brought to 1.
    ///
    /// # Errors
    /// Directions that are zero, parallel, all in one plane, or too many.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::{SlabSet, SlabSetError};
    ///
    /// // the four of Fig. 15.58, in the plane: they need one across it
    /// let flat = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0]];
    /// let mut directions = flat.map(DVec3::from_array).to_vec();
    /// let unbounded = SlabSetError::Unbounded { independent: 2 };
    /// assert_eq!(SlabSet::of(&directions), Err(unbounded));
    /// directions.push(DVec3::Z);
    /// assert_eq!(SlabSet::of(&directions).unwrap().directions().len(), 5);
    /// ```
    pub fn of(directions: &[DVec3]) -> Result<Self, SlabSetError> {
        /// Two directions are parallel, or three in one plane, within the rounding of unit vectors.
        const INDEPENDENT: f64 = 1e-9;
        if MOST_SLABS < directions.len() {
            let count = directions.len();
            return Err(SlabSetError::TooMany { count });
        }
        let mut set = Self {
            directions: [DVec3::ZERO; MOST_SLABS],
            len: directions.len(),
            axes_first: false,
        };
        for (slab, (unit, direction)) in set.directions.iter_mut().zip(directions).enumerate() {
            let largest = direction.abs().max_element();
            // scaled first: the square of a tiny length would vanish
            *unit = (*direction / largest)
                .try_normalize()
                .ok_or(SlabSetError::NoDirection { slab })?;
        }
        let units = set.directions();
        for (second, b) in units.iter().enumerate() {
            for (first, a) in units[..second].iter().enumerate() {
                if a.cross(*b).length() <= INDEPENDENT {
                    return Err(SlabSetError::Parallel { first, second });
                }
            }
        }
        let across = match units {
            [] | [_] => DVec3::ZERO,
            [a, b, ..] => a.cross(*b),
        };
        if !units.iter().any(|n| INDEPENDENT < n.dot(across).abs()) {
            let independent = units.len().min(2);
            return Err(SlabSetError::Unbounded { independent });
        }
        Ok(set)
    }
}

impl<const N: usize> SlabSet<N> {
    /// (A, B, C) of each slab, of unit length.
    pub fn directions(&self) -> &[DVec3] {
        &self.directions[..self.len]
    }

    /// Are the first three directions x, y and z?
    pub(super) fn begins_with_axes(&self) -> bool {
        self.axes_first
    }

    /// A·x + B·y + C·z for each direction, and 0 for those that the set does not have.
    #[inline]
    pub(crate) fn products(&self, v: DVec3) -> [f64; N] {
        let mut products = [0.0; N];
        let mut first = 0;
        if self.axes_first {
            first = v.to_array().len().min(N);
            products[..first].copy_from_slice(&v.to_array()[..first]);
        }
        for (product, normal) in products[first..].iter_mut().zip(&self.directions[first..]) {
            *product = normal.dot(v);
        }
        products
    }

    /// All N, of which those beyond [`SlabSet::directions`] are zero.
    #[inline]
    pub(crate) fn padded(&self) -> &[DVec3; N] {
        &self.directions
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(list: &[[f64; 3]]) -> Result<SlabSet<MOST_SLABS>, SlabSetError> {
        let list: Vec<_> = list.iter().copied().map(DVec3::from).collect();
        SlabSet::of(&list)
    }

    #[test]
    fn fewer_than_three_independent_directions_do_not_bound() {
        let unbounded = |independent| Err(SlabSetError::Unbounded { independent });
        assert_eq!(of(&[]), unbounded(0));
        assert_eq!(of(&[[1.0, 0.0, 0.0]]), unbounded(1));
        let plane = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!(of(&plane), unbounded(2));
    }

    #[test]
    fn parallel_and_zero_directions_are_refused_by_their_place() {
        let parallel = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-3.0, 0.0, 0.0]];
        let expected = SlabSetError::Parallel {
            first: 0,
            second: 2,
        };
        assert_eq!(of(&parallel), Err(expected));
        let zero = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
        assert_eq!(of(&zero), Err(SlabSetError::NoDirection { slab: 1 }));
    }

    #[test]
    fn a_direction_of_any_length_is_brought_to_one() {
        let set = of(&[[1e-40, 0.0, 0.0], [0.0, 3.0, 4.0], [0.0, -4.0, 3.0]]).unwrap();
        assert_eq!(set.directions()[0], DVec3::X);
        assert!((set.directions()[1] - DVec3::new(0.0, 0.6, 0.8)).length() <= 1e-15);
    }
}
