//! The checks that every number of a scene file passes.

use glam::DVec3;

use crate::scene::fault::{Fault, LARGEST, SMALLEST, SceneFault};

/// A number that products can be made of.
pub(super) fn checked(path: &str, value: f64) -> Result<f64, SceneFault> {
    // not `LARGEST < |value|`: NaN must fail too
    if value.abs() <= LARGEST {
        Ok(value)
    } else {
        Err(Fault::TooLarge { value }.at(path))
    }
}

/// Three of them.
pub(super) fn checked_point(path: &str, point: [f64; 3]) -> Result<DVec3, SceneFault> {
    for (i, &value) in point.iter().enumerate() {
        checked(&format!("{path}[{i}]"), value)?;
    }
    Ok(point.into())
}

/// A radius or length.
pub(super) fn checked_positive(
    path: &str,
    what: &'static str,
    value: f64,
) -> Result<f64, SceneFault> {
    if checked(path, value)? < SMALLEST {
        return Err(Fault::NotPositive { what, value }.at(path));
    }
    Ok(value)
}

/// A coefficient.
pub(super) fn checked_weight(
    path: &str,
    what: &'static str,
    value: f64,
) -> Result<f64, SceneFault> {
    if checked(path, value)? < 0.0 {
        return Err(Fault::Negative { what, value }.at(path));
    }
    Ok(value)
}

/// A colour: three weights.
pub(super) fn checked_colour(path: &str, colour: [f64; 3]) -> Result<DVec3, SceneFault> {
    for (i, &value) in colour.iter().enumerate() {
        checked_weight(&format!("{path}[{i}]"), "the colour", value)?;
    }
    Ok(colour.into())
}
