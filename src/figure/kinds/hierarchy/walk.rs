//! A ray through a hierarchy, as its figure draws it.

use crate::figure::parts::tree::Tree;
use crate::figure::parts::visits::Visits;
use crate::figure::subject::DrawnRay;
use crate::geometry::MOST_SLABS;
use crate::structure::Hierarchy;

/// What is drawn.
pub(super) struct Walk<'a> {
    pub(super) ray: DrawnRay<'a>,
    pub(super) hierarchy: Hierarchy<MOST_SLABS>,
    pub(super) tree: Tree,
    pub(super) visits: Visits,
}
