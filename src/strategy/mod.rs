//! Which objects is a ray tested against? Each strategy gives the same answer at another cost.
//!
//! A file for each strategy says it as the slides do, and notes each step: that is what runs whenever somebody follows.
//! Where nobody does, [`Chosen`] takes another driver over the same structures and the same geometry: all that exists
//! for speed alone is in `fast`.

mod bounds;
pub(crate) mod by_name;
mod by_slabs;
mod chosen;
mod exhaustive;
mod fast;
mod grid;
mod heap;
mod hierarchy;
mod nearest;
mod node_bounds;
#[cfg(test)]
mod noted;
mod object_test;
mod slab_rays;
mod transformed;
mod turn;
mod z_aligned;

pub use bounds::BoundedObjects;
pub(crate) use by_name::Chosen;
pub use exhaustive::Exhaustive;
pub use grid::UniformGrid;
pub(crate) use grid::is_passed;
pub use heap::HeapOrdered;
pub use hierarchy::DepthFirst;
pub use nearest::{AnyHit, Hit, NearestSoFar, Search};
pub use object_test::test_primitive;
pub use z_aligned::ZAligned;

use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::trace::Recorder;

/// A way to find what a ray hits.
///
/// Every strategy finds the same object at the same t, bit for bit, as the exhaustive one; of two
/// objects at equal t the one that comes first in the scene. So nothing is left out at equality.
///
/// Two cases are excepted, for t is rounded: a hit within 4 ulp of the end of the range may count or not, and of
/// two hits within 10⁻¹² of t of each other either may be the nearest. [`ZAligned`] computes in another frame: it
/// finds the same object, at a t within 10⁻⁹ of it.
pub trait Strategy: Sync {
    /// Offers every hit that can matter to the search, until that has enough: then `Break`.
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()>;

    /// Notes how the structure was built; nothing if there is none.
    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        let _ = recorder;
    }

    /// How much memory the structure takes, in bytes.
    fn bytes(&self) -> usize {
        0
    }

    /// The nearest hit in the range.
    #[inline]
    fn nearest<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit> {
        let mut nearest = NearestSoFar::new(range);
        let _ = self.search(ray, &mut nearest, recorder);
        nearest.hit()
    }

    /// Any hit in the range: the first that is found, which ends the search. For shadow rays.
    #[inline]
    fn any<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit> {
        let mut any = AnyHit::new(range);
        let _ = self.search(ray, &mut any, recorder);
        any.hit()
    }
}
