//! What can be wrong with a scene that has the right form: what, where, and what to do about it.

use std::fmt;

use crate::geometry::{PolygonError, SlabSetError};
use crate::scene::printable;

/// The largest magnitude of a coordinate, radius or coefficient: products of six of them, the most
/// that any test multiplies, stay within f64.
pub const LARGEST: f64 = 1e50;
/// The smallest radius or length, for the same reason.
pub const SMALLEST: f64 = 1e-50;
/// The largest picture: its colours take 24 bytes a pixel, 2.4 GB.
pub const MOST_PIXELS: u64 = 100_000_000;
/// The deepest ray tree: 2^depth rays may come of one eye ray, and each takes a stack frame.
pub const DEEPEST: u32 = 100;

/// A mistake, and the path of the value that is wrong: `objects[0].shape.sphere.radius`.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFault {
    /// Keys and indices from the top of the scene file.
    pub path: String,
    /// What is wrong there.
    pub fault: Fault,
}

/// A mistake in a scene.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "each variant's text is its documentation")]
pub enum Fault {
    TooLarge {
        value: f64,
    },
    NotPositive {
        what: &'static str,
        value: f64,
    },
    Negative {
        what: &'static str,
        value: f64,
    },
    BoxWithoutVolume {
        axis: char,
        min: f64,
        max: f64,
    },
    BadCone,
    SlabDirection {
        in_plane: bool,
    },
    Slabs(SlabSetError),
    Polygon(PolygonError),
    UnknownMaterial {
        name: String,
        nearest: Option<String>,
    },
    EmptyName,
    SameName {
        name: String,
        first: String,
    },
    OneOf {
        first: &'static str,
        second: &'static str,
        both: bool,
    },
    FieldOfView {
        degrees: f64,
    },
    LooksNowhere,
    UpAlongSight,
    WindowWithoutArea,
    CopOnWindow,
    Pixels {
        width: u32,
        height: u32,
    },
    Depth {
        depth: u32,
    },
    MeshNotLoaded {
        file: String,
    },
}

impl Fault {
    /// This fault at a place.
    pub(crate) fn at(self, path: impl fmt::Display) -> SceneFault {
        SceneFault {
            path: path.to_string(),
            fault: self,
        }
    }

    /// What to do about it.
    pub fn fix(&self) -> String {
        match self {
            Self::TooLarge { .. } => {
                format!("keep every number within ±{LARGEST:e}, so that products stay finite")
            }
            Self::NotPositive { .. } => format!("give a value of at least {SMALLEST:e}"),
            Self::Negative { .. } => "give a value of 0 or more".into(),
            Self::BoxWithoutVolume { .. } => {
                "make each coordinate of max larger than that of min".into()
            }
            Self::BadCone => {
                "give two different points and radii of 0 or more, one of them above 0".into()
            }
            Self::SlabDirection { .. } => {
                "give every direction as [A, B, C], or all of a plane as [A, B]".into()
            }
            Self::Slabs(error) => error.fix(),
            Self::Polygon(PolygonError::NotPlanar { .. }) => {
                "divide it into triangles, or correct the vertex".into()
            }
            Self::Polygon(_) => "list the corners in order around the polygon".into(),
            Self::UnknownMaterial {
                nearest: Some(name),
                ..
            } => {
                format!("did you mean {name:?}?")
            }
            Self::UnknownMaterial { nearest: None, .. } => "add it to \"materials\"".into(),
            Self::EmptyName => "give it a name: the log and the worked solution use it".into(),
            Self::SameName { .. } => {
                "rename one of them: the log identifies objects by their names".into()
            }
            Self::OneOf {
                first,
                second,
                both: true,
            } => {
                format!("remove {first:?} or {second:?}")
            }
            Self::OneOf {
                first,
                second,
                both: false,
            } => format!("add {first:?} or {second:?}"),
            Self::FieldOfView { .. } => "give an angle above 0 and below 180 degrees".into(),
            Self::LooksNowhere => "move the target or the centre of projection".into(),
            Self::UpAlongSight => "choose another direction for \"up\"".into(),
            Self::WindowWithoutArea => {
                "give two edges, right and up, that are neither zero nor parallel".into()
            }
            Self::CopOnWindow => "move the centre of projection off the window's plane".into(),
            Self::Pixels { .. } => format!(
                "give a width and a height of at least 1, and at most {MOST_PIXELS} pixels in all"
            ),
            Self::Depth { .. } => format!("give a depth from 1 (eye rays only) to {DEEPEST}"),
            Self::MeshNotLoaded { .. } => {
                "give the faces themselves, or load it from a file".into()
            }
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { value } => write!(f, "{value:e} is too large"),
            Self::NotPositive { what, value } => {
                write!(f, "{what} is {}, and must be above 0", plain(*value))
            }
            Self::Negative { what, value } => {
                write!(f, "{what} is {}, and must not be negative", plain(*value))
            }
            Self::BoxWithoutVolume { axis, min, max } => {
                write!(
                    f,
                    "the box has no extent in {axis}: min is {min}, max is {max}"
                )
            }
            Self::BadCone => f.write_str("the cone has no height or no radius"),
            Self::SlabDirection { in_plane } => {
                let numbers = if *in_plane {
                    "2 numbers, as the first"
                } else {
                    "3 numbers"
                };
                write!(f, "a direction of slabs has {numbers}")
            }
            Self::Slabs(error) => error.fmt(f),
            Self::Polygon(error) => error.fmt(f),
            Self::UnknownMaterial { name, .. } => write!(f, "there is no material {name:?}"),
            Self::EmptyName => f.write_str("the name is empty"),
            Self::SameName { name, first } => write!(f, "{first} is called {name:?} already"),
            Self::OneOf {
                first,
                second,
                both,
            } => {
                let count = if *both { "both are" } else { "neither is" };
                write!(
                    f,
                    "exactly one of {first:?} and {second:?} is needed, and {count} there"
                )
            }
            Self::FieldOfView { degrees } => write!(f, "the field of view is {degrees} degrees"),
            Self::LooksNowhere => f.write_str("the target is the centre of projection itself"),
            Self::UpAlongSight => {
                f.write_str("\"up\" has no length or lies along the line of sight")
            }
            Self::WindowWithoutArea => f.write_str("the window has no area"),
            Self::CopOnWindow => f.write_str("the centre of projection lies on the window's plane"),
            Self::Pixels { width, height } => {
                write!(f, "a picture of {width} × {height} pixels cannot be made")
            }
            Self::Depth { depth } => write!(f, "the depth limit is {depth}"),
            Self::MeshNotLoaded { file } => write!(f, "the mesh file {file:?} is not loaded"),
        }
    }
}

/// A number as one writes it: in powers of ten where it would be mostly zeros.
fn plain(value: f64) -> String {
    let usual = value == 0.0 || (1e-6..1e9).contains(&value.abs());
    if usual {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

impl fmt::Display for SceneFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}: {}; {}",
            printable(&self.path),
            self.fault,
            self.fault.fix()
        )
    }
}

impl std::error::Error for SceneFault {}
