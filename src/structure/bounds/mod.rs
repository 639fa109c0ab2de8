//! Volumes around objects: slabs, boxes, spheres, ellipsoids, and where a ray is inside them.

mod extent;
pub(crate) mod extremes;
mod least_ellipsoid;
mod object_bounds;
mod principal_axes;
mod ray_slabs;
mod slab_bound;
mod slab_set;
mod slab_step;
mod smallest_sphere;
mod volume;

pub use extent::extent;
pub(in crate::structure) use extent::{ROUNDING, widened_box, widened_extent};
pub use ray_slabs::{RaySlabs, room};
pub use slab_bound::SlabBound;
pub use slab_set::{SlabChoice, SlabSet};
pub use slab_step::{Inside, SlabOutcome, SlabStep};
pub use volume::{Volume, VolumeKind, VolumeRay};
pub(crate) use volume::{inside_ellipsoid, inside_sphere};
