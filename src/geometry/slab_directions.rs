//! Whether directions of slabs bound what lies between their planes (Fig. 15.58).

use std::fmt;

use glam::DVec3;

/// The most directions that a set of slabs may have. T. Kay and J. Kajiya (1986) found no gain beyond some ten.
pub const MOST_SLABS: usize = 16;

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

impl SlabSetError {
    /// The direction at fault, by its place in the list; `None` if it is the list as a whole.
    pub fn slab(&self) -> Option<usize> {
        match *self {
            Self::NoDirection { slab } | Self::Parallel { second: slab, .. } => Some(slab),
            Self::Unbounded { .. } | Self::TooMany { .. } => None,
        }
    }

    /// What to do about it.
    pub fn fix(&self) -> String {
        match self {
            Self::NoDirection { .. } => "give it a direction [A, B, C], or omit it".into(),
            Self::Parallel { .. } => "omit one of them".into(),
            Self::Unbounded { independent: 0 } => {
                "give three directions [A, B, C] that are not in one plane".into()
            }
            Self::Unbounded { independent: 1 } => {
                "add two directions that are not in one plane with the first".into()
            }
            Self::Unbounded { .. } => {
                "add a direction that is not in the plane of the others".into()
            }
            Self::TooMany { .. } => format!("omit some; at most {MOST_SLABS} are allowed"),
        }
    }
}

impl fmt::Display for SlabSetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoDirection { slab } => write!(f, "slabs[{slab}] is zero"),
            Self::Parallel { first, second } => {
                write!(f, "slabs[{first}] and slabs[{second}] are parallel")
            }
            Self::Unbounded { independent } => write!(
                f,
                "the slabs do not bound: they have {independent} of 3 independent directions"
            ),
            Self::TooMany { count } => write!(f, "the slabs have {count} directions"),
        }
    }
}

impl std::error::Error for SlabSetError {}

/// The directions at unit length, if slabs across them bound a volume: three of them span space.
///
/// # Errors
/// More than [`MOST_SLABS`] directions, one without a length, two that are parallel, or too few that are
/// independent.
pub fn slab_directions(directions: &[DVec3]) -> Result<Vec<DVec3>, SlabSetError> {
    /// Two directions are parallel, or three in one plane, within the rounding of unit vectors.
    const INDEPENDENT: f64 = 1e-9;
    if MOST_SLABS < directions.len() {
        let count = directions.len();
        return Err(SlabSetError::TooMany { count });
    }
    let mut units = Vec::with_capacity(directions.len());
    for (slab, direction) in directions.iter().enumerate() {
        let largest = direction.abs().max_element();
        // scaled first: the square of a tiny length would vanish
        let unit = (*direction / largest).try_normalize();
        units.push(unit.ok_or(SlabSetError::NoDirection { slab })?);
    }
    for (second, b) in units.iter().enumerate() {
        for (first, a) in units[..second].iter().enumerate() {
            if a.cross(*b).length() <= INDEPENDENT {
                return Err(SlabSetError::Parallel { first, second });
            }
        }
    }
    let across = match units.as_slice() {
        [] | [_] => DVec3::ZERO,
        [a, b, ..] => a.cross(*b),
    };
    if !units.iter().any(|n| INDEPENDENT < n.dot(across).abs()) {
        let independent = units.len().min(2);
        return Err(SlabSetError::Unbounded { independent });
    }
    Ok(units)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(list: &[[f64; 3]]) -> Result<Vec<DVec3>, SlabSetError> {
        let list: Vec<_> = list.iter().copied().map(DVec3::from).collect();
        slab_directions(&list)
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
        assert_eq!(expected.slab(), Some(2));
        let zero = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
        assert_eq!(of(&zero), Err(SlabSetError::NoDirection { slab: 1 }));
    }

    #[test]
    fn a_direction_of_any_length_is_brought_to_one() {
        let units = of(&[[1e-40, 0.0, 0.0], [0.0, 3.0, 4.0], [0.0, -4.0, 3.0]]).unwrap();
        assert_eq!(units[0], DVec3::X);
        assert!((units[1] - DVec3::new(0.0, 0.6, 0.8)).length() <= 1e-15);
    }

    #[test]
    fn sixteen_directions_are_allowed_and_seventeen_are_not() {
        // (1, k, k²): no two are parallel, no three lie in one plane
        let moment = |k: i32| [1.0, f64::from(k), f64::from(k * k)];
        let sixteen: Vec<_> = (0..16).map(moment).collect();
        assert_eq!(of(&sixteen).unwrap().len(), 16);
        let seventeen: Vec<_> = (0..17).map(moment).collect();
        assert_eq!(of(&seventeen), Err(SlabSetError::TooMany { count: 17 }));
    }

    #[test]
    fn directions_whose_squares_leave_f64_are_directions() {
        let units = of(&[[1e-300, 0.0, 0.0], [0.0, 1e300, 0.0], [0.0, 0.0, 1.0]]).unwrap();
        assert_eq!(units, DVec3::AXES);
    }

    #[test]
    fn a_billionth_from_parallel_or_from_one_plane_is_not_independent() {
        let parallel = [[1.0, 0.0, 0.0], [1.0, 1e-9, 0.0], [0.0, 0.0, 1.0]];
        let expected = SlabSetError::Parallel {
            first: 0,
            second: 1,
        };
        assert_eq!(of(&parallel), Err(expected));
        assert!(of(&[[1.0, 0.0, 0.0], [1.0, 1.1e-9, 0.0], [0.0, 0.0, 1.0]]).is_ok());
        let plane = |z: f64| of(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.6, 0.8, z]]);
        assert_eq!(plane(1e-9), Err(SlabSetError::Unbounded { independent: 2 }));
        assert!(plane(1.1e-9).is_ok() && plane(-1.1e-9).is_ok());
    }
}
