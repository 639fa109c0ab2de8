//! Objects side by side in the order in which a search comes to them.
//!
//! The objects of a leaf, or of a cell, stand anywhere in the scene: each of them would be read from a place of
//! its own in memory, which in a large scene takes longer than its test. So what the test of a sphere reads is
//! copied in the order of the leaves, where the next one is at hand. A copy takes 40 bytes. Of a triangle, what
//! settles most of its tests is copied, in 64 bytes, for the leaves of a hierarchy alone: each object is in one
//! leaf, but in many cells. Other shapes are larger, and looked up in the scene.

use std::ops::{ControlFlow, Range};

use crate::geometry::{Ray, Sides, Sphere, TRange};
use crate::scene::{Primitive, PrimitiveId, Scene, Shape};
use crate::strategy::fast::object_test::hit;
use crate::strategy::fast::rounded_triangle::{RoundedTest, RoundedTriangle};
use crate::strategy::fast::sphere;
use crate::strategy::{Search, test_primitive};
use crate::trace::Off;

/// The objects of all leaves, or of all cells, one leaf after the other.
#[derive(Clone, Debug)]
pub(in crate::strategy) struct LeafOrder {
    /// Empty in a scene without spheres: its objects are found by their ids alone.
    copies: Vec<Listed>,
    /// Empty for a grid, and in a scene of which half or less are polygons.
    triangles: Vec<RoundedTriangle>,
}

/// An object, or which one it is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Listed {
    /// A sphere, with all that its test reads.
    Sphere {
        id: PrimitiveId,
        sides: Sides,
        sphere: Sphere,
    },
    /// Another shape, in its place in the scene.
    InScene { id: PrimitiveId },
}

impl LeafOrder {
    /// The objects of a scene in the order of a hierarchy's leaves.
    pub(super) fn of_leaves(scene: &Scene, order: &[PrimitiveId]) -> Self {
        let is_polygon = |object: &&Primitive| matches!(object.shape, Shape::Polygon(_));
        let polygons = scene.primitives.iter().filter(is_polygon).count();
        if 2 * polygons <= scene.primitives.len() {
            return Self::of_cells(scene, order);
        }
        Self {
            copies: Vec::new(),
            triangles: order.iter().map(|&id| rounded(scene, id)).collect(),
        }
    }

    /// The objects of a scene in the order of a grid's lists.
    pub(super) fn of_cells(scene: &Scene, order: &[PrimitiveId]) -> Self {
        let is_sphere = |object: &Primitive| matches!(object.shape, Shape::Sphere(_));
        let copies = if scene.primitives.iter().any(is_sphere) {
            order.iter().map(|&id| Listed::new(scene, id)).collect()
        } else {
            Vec::new()
        };
        Self {
            copies,
            triangles: Vec::new(),
        }
    }

    /// Tests the objects in these places of `order`, which is the order that was given at first, and offers
    /// their hits.
    #[inline]
    pub(super) fn test(
        &self,
        scene: &Scene,
        order: &[PrimitiveId],
        places: Range<usize>,
        ray: &Ray,
        search: &mut impl Search,
    ) -> ControlFlow<()> {
        if !self.triangles.is_empty() {
            return self.test_triangles(scene, order, places, ray, search);
        }
        self.visit(order, places, ray, |object| {
            match object.test(scene, ray, search.range()) {
                Some(t) => search.offer(object.id(), t, &mut Off),
                None => ControlFlow::Continue(()),
            }
        })
    }

    /// The same by the copies of triangles.
    #[inline]
    fn test_triangles(
        &self,
        scene: &Scene,
        order: &[PrimitiveId],
        places: Range<usize>,
        ray: &Ray,
        search: &mut impl Search,
    ) -> ControlFlow<()> {
        for place in places {
            let tested = match self.triangles[place].test(ray, search.range()) {
                RoundedTest::Missed => continue,
                RoundedTest::Hit(t) => Some(t),
                RoundedTest::Unsettled => whole_test(scene, order[place], ray, search.range()),
            };
            if let Some(t) = tested {
                search.offer(order[place], t, &mut Off)?;
            }
        }
        ControlFlow::Continue(())
    }

    /// Visits the objects in these places of `order`, which is the order that was given at first, but for those that
    /// are clearly missed: nothing else that could be asked of them costs less.
    #[inline]
    pub(super) fn visit(
        &self,
        order: &[PrimitiveId],
        places: Range<usize>,
        ray: &Ray,
        mut visit: impl FnMut(&Listed) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.copies.is_empty() {
            for &id in &order[places] {
                visit(&Listed::InScene { id })?;
            }
        } else {
            for copy in &self.copies[places] {
                if !copy.is_clearly_missed(ray) {
                    visit(copy)?;
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// How much memory the copies take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.copies.as_slice()) + size_of_val(self.triangles.as_slice())
    }
}

/// The copy of a triangle, or what stands in the place of another shape.
fn rounded(scene: &Scene, id: PrimitiveId) -> RoundedTriangle {
    let Primitive { shape, sides, .. } = scene.primitive(id);
    let copy = match shape {
        Shape::Polygon(polygon) => RoundedTriangle::new(polygon, *sides),
        _ => None,
    };
    copy.unwrap_or(RoundedTriangle::UNSETTLED)
}

/// The test of the object itself: apart, for it is long and seldom asked.
#[cold]
#[inline(never)]
fn whole_test(scene: &Scene, id: PrimitiveId, ray: &Ray, range: TRange) -> Option<f64> {
    test_primitive(id, scene.primitive(id), ray, range, &mut Off)
}

impl Listed {
    fn new(scene: &Scene, id: PrimitiveId) -> Self {
        let Primitive { shape, sides, .. } = scene.primitive(id);
        match shape {
            Shape::Sphere(sphere) => Self::Sphere {
                id,
                sides: *sides,
                sphere: *sphere,
            },
            _ => Self::InScene { id },
        }
    }

    /// Which object it is.
    #[inline]
    pub(super) fn id(&self) -> PrimitiveId {
        match self {
            Self::Sphere { id, .. } | Self::InScene { id } => *id,
        }
    }

    /// Do a few products settle that the ray misses the object? `false` says nothing.
    #[inline]
    fn is_clearly_missed(&self, ray: &Ray) -> bool {
        match self {
            Self::Sphere { sphere: of, .. } => sphere::is_clearly_missed(of, ray),
            Self::InScene { .. } => false,
        }
    }

    /// Where does the ray meet the object, if it does so in the range? As [`test_primitive`] says.
    #[inline]
    pub(super) fn test(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<f64> {
        match self {
            Self::Sphere {
                sides, sphere: of, ..
            } => sphere::hit(of, ray, range, *sides),
            Self::InScene { id } => hit(*id, scene.primitive(*id), ray, range),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_of_a_sphere_takes_40_bytes() {
        // four numbers of 8 bytes, the id, the sides, and which kind it is
        assert_eq!(size_of::<Listed>(), 40);
    }
}
