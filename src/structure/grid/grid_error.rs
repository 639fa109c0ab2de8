//! Why a grid cannot be built.

use std::fmt;

/// The most cells of a grid: their lists' places take 256 MB.
pub const MOST_CELLS: u32 = 64 << 20;

/// The most cells along one axis that may be asked for.
///
/// A ray along the axis steps through a whole row of cells, and each is an event of the log: a picture of 160 × 120
/// pixels has 80 million of them with 4096 cells in a row. Woo's rule may give more, where it is the objects that
/// are many.
pub const MOST_CELLS_ALONG: u32 = 1 << 12;

/// The most entries of all lists together: they take 1 GB.
pub(crate) const MOST_ENTRIES: u32 = 256 << 20;

/// Why a grid cannot be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GridError {
    /// The density is not a number above 0.
    Density {
        /// What it is.
        density: f64,
    },
    /// No cell along an axis.
    NoCells {
        /// Cells along x, y and z.
        resolution: [u32; 3],
    },
    /// More than [`MOST_CELLS`].
    TooManyCells {
        /// How many there would be.
        cells: f64,
    },
    /// More than [`MOST_CELLS_ALONG`] an axis.
    TooManyAlong {
        /// Along which axis: 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// How many there would be.
        cells: u32,
    },
    /// Cells so thin that their planes would lie on top of each other.
    TooThin {
        /// Along which axis: 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// How many cells there may be along it.
        most: u32,
    },
    /// The lists would take too much memory.
    TooManyEntries {
        /// Cells along x, y and z.
        resolution: [u32; 3],
    },
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Density { density } => write!(
                f,
                "the density of a grid is its number of cells for each object, and {density} is not a number above 0\n  \
                 give a number above 0, such as 3"
            ),
            Self::NoCells {
                resolution: [x, y, z],
            } => write!(
                f,
                "a grid of {x} × {y} × {z} has no cells\n  give at least 1 along each axis"
            ),
            Self::TooManyCells { cells } => write!(
                f,
                "a grid of {} cells takes too much memory; at most {MOST_CELLS} are allowed\n  \
                 give a smaller resolution or density",
                // whole numbers up to 2⁵³
                if cells <= 9e15 {
                    format!("{cells}")
                } else {
                    format!("{cells:.0e}")
                }
            ),
            Self::TooManyAlong { axis, cells } => write!(
                f,
                "a ray along {} would step through {cells} cells\n  \
                 give at most {MOST_CELLS_ALONG} along each axis",
                ["x", "y", "z"][axis.min(2)]
            ),
            Self::TooThin { axis, most } => write!(
                f,
                "the scene is too thin along {} for this many cells\n  give at most {most} along that axis",
                ["x", "y", "z"][axis.min(2)]
            ),
            Self::TooManyEntries {
                resolution: [x, y, z],
            } => write!(
                f,
                "the lists of a grid of {x} × {y} × {z} cells would hold more than {MOST_ENTRIES} objects in \
                 all\n  give a smaller resolution or density"
            ),
        }
    }
}

impl std::error::Error for GridError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_error_says_what_is_wrong_and_what_to_give_instead() {
        let text = |error: GridError| error.to_string();
        assert_eq!(
            text(GridError::Density { density: -1.0 }),
            "the density of a grid is its number of cells for each object, and -1 is not a number above 0\n  give a number above 0, such as 3"
        );
        assert_eq!(
            text(GridError::TooManyAlong {
                axis: 2,
                cells: 5000
            }),
            "a ray along z would step through 5000 cells\n  give at most 4096 along each axis"
        );
        assert_eq!(
            text(GridError::TooThin { axis: 0, most: 7 }),
            "the scene is too thin along x for this many cells\n  give at most 7 along that axis"
        );
    }

    #[test]
    fn a_number_of_cells_is_written_out_as_long_as_it_is_whole() {
        let begins = |cells: f64, with: &str| {
            let text = GridError::TooManyCells { cells }.to_string();
            assert!(
                text.starts_with(&format!("a grid of {with} cells takes")),
                "{text}"
            );
        };
        begins(1e9, "1000000000");
        begins(9e15, "9000000000000000");
        begins(2e16, "2e16");
    }
}
