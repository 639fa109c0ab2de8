//! Pure mathematics that returns its working.
//!
//! Each test answers where a ray hits a surface, and returns every intermediate quantity in a
//! small struct: that struct is the result and, one layer up, the payload of a trace event. Nothing
//! here does I/O, records or panics on finite input.

mod aligned;
mod alignment;
mod r#box;
mod clip;
mod cone;
mod corners;
mod disc_in_polygon;
mod ellipsoid;
mod exact_sign;
mod extremes;
mod inside;
mod oriented_ellipsoid;
mod plane;
mod point_in_polygon;
mod polygon;
mod polygon_in_rectangle;
mod quadratic;
mod ray;
mod reflection;
mod refraction;
mod root;
mod slab;
mod slab_directions;
mod smooth_normal;
mod sphere;
mod twofold;

pub use aligned::AlignedSlab;
pub use alignment::{AlignedRay, Alignment};
pub use r#box::{AxisBox, BoxTest};
pub(crate) use clip::{clip, clip_to_rectangle};
pub use cone::Cone;
pub use disc_in_polygon::disc_in_polygon;
pub use ellipsoid::Ellipsoid;
pub(crate) use exact_sign::sign_of_sum;
pub(crate) use extremes::{larger, smaller};
pub use inside::Inside;
pub use oriented_ellipsoid::OrientedEllipsoid;
pub(crate) use plane::FLAT;
pub use plane::{Axis, Plane, PlaneTest, PlaneVerdict};
pub(crate) use point_in_polygon::clear_crossings;
pub use point_in_polygon::{DecidedBy, EdgeTest, PolygonTest};
pub(crate) use polygon::OUTLINE_ROUNDING;
pub use polygon::{Polygon, PolygonError};
pub use polygon_in_rectangle::polygon_in_rectangle;
pub use quadratic::{GRAZE, QuadraticTest};
pub(crate) use quadratic::{Quadratic, RealRoots};
pub use ray::{Ray, TRange};
pub use reflection::reflect;
pub use refraction::{Refraction, refract};
pub use root::{Root, RootVerdict, Roots, Sides};
pub(crate) use root::{hidden_side, verdict_of};
pub use slab::{PARALLEL, SlabInterval, SlabRay};
pub use slab_directions::{MOST_SLABS, SlabSetError, slab_directions};
pub use smooth_normal::{interpolated_normal, mean_value_weights};
pub(crate) use sphere::DISCRIMINANT_CANCELS;
pub use sphere::Sphere;
