//! Volumes around objects: slabs, boxes, spheres, ellipsoids, and where a ray is inside them.

mod extent;
mod least_ellipsoid;
mod object_bounds;
mod principal_axes;
mod ray_slabs;
mod slab_bound;
mod slab_set;
mod slab_step;
mod smallest_sphere;
mod volume;
mod volume_ray;

pub use extent::extent;
pub(in crate::structure) use extent::{ROUNDING, box_around, box_with_room};
pub use ray_slabs::{RaySlabs, room};
pub use slab_bound::SlabBound;
pub use slab_set::{SlabChoice, SlabSet};
pub use slab_step::{SlabStep, SlabVerdict};
pub use volume::{Volume, VolumeKind};
pub use volume_ray::VolumeRay;
pub(crate) use volume_ray::{inside_ellipsoid, inside_sphere};
