//! Which objects is a ray tested against? Each strategy gives the same answer at another cost.

mod exhaustive;
mod nearest;
mod object_test;

pub use exhaustive::Exhaustive;
pub use nearest::{Hit, NearestSoFar};
pub use object_test::test_primitive;

use crate::geometry::{Ray, TRange};
use crate::trace::Recorder;

/// A way to find what a ray meets.
///
/// Every strategy finds the same object at the same t, bit for bit, as the exhaustive one; of two
/// objects at equal t the one that comes first in the scene. So nothing is left out at equality.
pub trait Strategy: Sync {
    /// The nearest hit in the range.
    fn nearest<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit>;

    /// Any hit in the range: the first that is found, which ends the search. For shadow rays.
    fn any<R: Recorder>(&self, ray: &Ray, range: TRange, recorder: &mut R) -> Option<Hit>;
}
