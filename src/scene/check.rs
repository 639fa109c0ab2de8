//! The checks that every number of a scene file passes.
//!
//! A path is given as something that can be displayed, such as `format_args!("{path}.center")`: it becomes text when
//! there is an error. A file has millions of numbers, and almost always no error.

use std::fmt::Display;

use glam::DVec3;

use crate::scene::fault::{Fault, LARGEST, SMALLEST, SceneFault};

/// A number that products can be made of.
pub(super) fn checked(path: impl Display, value: f64) -> Result<f64, SceneFault> {
    // not `LARGEST < |value|`: NaN must fail too
    if value.abs() <= LARGEST {
        Ok(value)
    } else {
        Err(Fault::TooLarge { value }.at(path))
    }
}

/// Three of them.
pub(super) fn checked_point(path: impl Display, point: [f64; 3]) -> Result<DVec3, SceneFault> {
    for (i, &value) in point.iter().enumerate() {
        checked(format_args!("{path}[{i}]"), value)?;
    }
    Ok(point.into())
}

/// A radius or length.
pub(super) fn checked_positive(
    path: impl Display,
    what: &'static str,
    value: f64,
) -> Result<f64, SceneFault> {
    if checked(&path, value)? < SMALLEST {
        return Err(Fault::NotPositive { what, value }.at(path));
    }
    Ok(value)
}

/// A coefficient.
pub(super) fn checked_weight(
    path: impl Display,
    what: &'static str,
    value: f64,
) -> Result<f64, SceneFault> {
    if checked(&path, value)? < 0.0 {
        return Err(Fault::Negative { what, value }.at(path));
    }
    Ok(value)
}

/// A colour: three weights.
pub(super) fn checked_colour(path: impl Display, colour: [f64; 3]) -> Result<DVec3, SceneFault> {
    for (i, &value) in colour.iter().enumerate() {
        checked_weight(format_args!("{path}[{i}]"), "the colour", value)?;
    }
    Ok(colour.into())
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::fmt;

    use super::*;

    /// A path that counts how often it becomes text.
    struct Counted(Cell<u32>);

    impl Display for Counted {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            self.0.set(self.0.get() + 1);
            f.write_str("center")
        }
    }

    #[test]
    fn a_path_becomes_text_only_when_there_is_an_error() {
        // what went wrong: three texts for each vertex of a mesh without any mistake
        let path = Counted(Cell::new(0));
        assert!(checked_point(&path, [1.0, -2.0, 3.0]).is_ok());
        assert!(checked_colour(&path, [0.0, 0.5, 1.0]).is_ok());
        assert!(checked_positive(&path, "the radius", 1.0).is_ok());
        assert_eq!(path.0.get(), 0);

        let wrong = checked_point(&path, [1.0, 1e60, f64::NAN]).unwrap_err();
        assert_eq!(wrong.path, "center[1]");
        assert_eq!(path.0.get(), 1);
    }
}
