//! The fixed set of directions of slabs that all bounds of a structure share (Fig. 15.58).
//!
//! "Each slab is represented by equation (iv), where A, B and C are constant, and D is either D_min or
//! D_max." So A, B and C are kept here once for all bounds.

use glam::DVec3;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::{MOST_SLABS, SlabSetError, slab_directions};

/// Which set of slabs is taken?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum SlabChoice {
    /// The three axes: a box.
    #[default]
    Axes,
    /// The three axes and the four diagonals of a cube: the seven of Kay and Kajiya's paper.
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
    /// use raystep::geometry::SlabSetError;
    /// use raystep::structure::SlabSet;
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
        let units = slab_directions(directions)?;
        let mut set = Self {
            directions: [DVec3::ZERO; MOST_SLABS],
            len: units.len(),
            axes_first: false,
        };
        set.directions[..units.len()].copy_from_slice(&units);
        Ok(set)
    }
}

impl<const N: usize> SlabSet<N> {
    /// (A, B, C) of each slab, of unit length.
    pub fn directions(&self) -> &[DVec3] {
        &self.directions[..self.len]
    }

    /// Are the first three directions x, y and z?
    pub(in crate::structure) fn begins_with_axes(&self) -> bool {
        self.axes_first
    }

    /// A·x + B·y + C·z for each direction, and 0 for those that the set does not have.
    #[inline]
    pub(crate) fn products(&self, v: DVec3) -> [f64; N] {
        let coordinates = v.to_array();
        let mut products = [0.0; N];
        for slab in 0..N {
            products[slab] = if self.axes_first && slab < coordinates.len() {
                coordinates[slab]
            } else {
                self.directions[slab].dot(v)
            };
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

    #[test]
    fn products_are_those_of_each_direction_and_0_for_those_that_are_not_there() {
        let v = DVec3::new(2.0, 3.0, 5.0);
        assert_eq!(SlabSet::AXES.products(v), [2.0, 3.0, 5.0]);
        let seven = SlabSet::SEVEN
            .products(v)
            .map(|product| product * 3.0_f64.sqrt());
        let root = 3.0_f64.sqrt();
        let expected = [2.0 * root, 3.0 * root, 5.0 * root, 10.0, 6.0, 0.0, 4.0];
        for (found, expected) in seven.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() <= 1e-14,
                "{found}, expected {expected}"
            );
        }
        let own = [
            DVec3::new(3.0, 4.0, 0.0),
            DVec3::new(4.0, -3.0, 0.0),
            DVec3::Z,
        ];
        let own = SlabSet::of(&own).unwrap();
        let products = own.products(v);
        // (6 + 12)/5, (8 − 9)/5
        for (found, expected) in products.into_iter().zip([3.6, -0.2, 5.0]) {
            assert!(
                (found - expected).abs() <= 1e-15,
                "{found}, expected {expected}"
            );
        }
        assert_eq!(products[3..], [0.0; MOST_SLABS - 3]);
    }

    #[test]
    fn the_fixed_sets_begin_with_the_axes_and_have_all_their_directions() {
        assert_eq!(SlabSet::AXES.directions(), DVec3::AXES);
        assert_eq!(SlabSet::SEVEN.directions().len(), 7);
        assert_eq!(SlabSet::SEVEN.directions()[..3], DVec3::AXES);
        assert!(SlabSet::SEVEN.begins_with_axes() && SlabSet::AXES.begins_with_axes());
        let own = SlabSet::of(&DVec3::AXES).unwrap();
        assert!(!own.begins_with_axes());
        assert_eq!(own.directions().len(), 3);
        assert_eq!(own.padded()[3..], [DVec3::ZERO; MOST_SLABS - 3]);
    }
}
