//! Objects side by side in the order in which a search visits them.
//!
//! The objects of a leaf, or of a cell, stand anywhere in the scene: each of them would be read from a place of
//! its own in memory, which in a large scene takes longer than its test. So what the test of a sphere reads is
//! copied in the order of the leaves, where the next one is at hand. A copy takes 40 bytes. Of a triangle, what
//! settles most of its tests is copied, in 64 bytes, for the leaves of a hierarchy alone: each object is in one
//! leaf, but in many cells. Other shapes are larger, and looked up in the scene.

use std::ops::{ControlFlow, Range};

use crate::geometry::{Ray, Sides, Sphere, TRange};
use crate::scene::{Primitive, PrimitiveId, Scene, Shape};
use crate::strategy::fast::object_test::{hit, test};
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

    /// As [`LeafOrder::test`], for those objects of which `is_asked` says so. Most objects of a
    /// cell have been tested in another one: so it is asked in place, where [`LeafOrder::visit`] would call a function.
    #[inline]
    pub(super) fn test_some(
        &self,
        scene: &Scene,
        order: &[PrimitiveId],
        places: Range<usize>,
        ray: &Ray,
        search: &mut impl Search,
        mut is_asked: impl FnMut(PrimitiveId) -> bool,
    ) -> ControlFlow<()> {
        if self.copies.is_empty() {
            for &id in &order[places] {
                if is_asked(id) {
                    test(id, scene.primitive(id), ray, search)?;
                }
            }
        } else {
            for copy in &self.copies[places] {
                if !copy.is_clearly_missed(ray)
                    && is_asked(copy.id())
                    && let Some(t) = copy.test(scene, ray, search.range())
                {
                    search.offer(copy.id(), t, &mut Off)?;
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// Visits the objects in these places of `order`, which is the order that was given at first, but for those that
    /// are clearly missed: nothing else that could be asked of them costs less.
    #[inline]
    fn visit(
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

    /// Where does the ray hit the object, if it does so in the range? As [`test_primitive`] says.
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

    use glam::DVec3;

    use crate::scene::small_scene::{cube_at, polygon, scene_of, sphere};
    use crate::strategy::NearestSoFar;

    /// A triangle across x, before the point (x, 0, 0).
    fn across(x: f64) -> String {
        polygon(&[[x, -1.0, -1.0], [x, 2.0, -1.0], [x, -1.0, 2.0]])
    }

    fn ids(scene: &Scene) -> Vec<PrimitiveId> {
        (0..scene.primitives.len() as u32)
            .map(PrimitiveId)
            .collect()
    }

    #[test]
    fn spheres_are_copied_and_triangles_where_most_objects_are_polygons() {
        let of = |shapes: &[String]| {
            let scene = scene_of(shapes);
            let order = ids(&scene);
            let leaves = LeafOrder::of_leaves(&scene, &order).bytes();
            [leaves, LeafOrder::of_cells(&scene, &order).bytes()]
        };
        let ball = || sphere([5.0, 0.0, 0.0], 1.0);
        // of 40 bytes each with a sphere among them, of 64 with more triangles than others
        assert_eq!(of(&[ball(), cube_at(3.0)]), [80, 80]);
        assert_eq!(of(&[ball(), across(3.0)]), [80, 80]);
        assert_eq!(of(&[ball(), across(3.0), across(4.0)]), [192, 120]);
        assert_eq!(of(&[across(3.0), across(4.0)]), [128, 0]);
        assert_eq!(of(&[cube_at(3.0)]), [0, 0]);
    }

    #[test]
    fn the_hits_of_a_leaf_are_those_of_its_objects_in_whatever_way_they_are_kept() {
        // along x: the triangles at 4 and 3, the sphere from 6 to 8, the cube from 9 on
        let all = [
            across(4.0),
            across(3.0),
            sphere([7.0, 0.0, 0.0], 1.0),
            cube_at(9.0),
        ];
        let many = [&all[..], &[across(12.0)]].concat();
        for shapes in [&all[..], &all[..2], &all[2..], &all[3..], &many] {
            let scene = scene_of(shapes);
            let order = ids(&scene);
            let ray = Ray::new(DVec3::new(0.0, 0.25, 0.25), DVec3::X);
            let kept = [
                LeafOrder::of_leaves(&scene, &order),
                LeafOrder::of_cells(&scene, &order),
            ];
            for kept in kept {
                for places in [0..shapes.len(), 0..1, 1..shapes.len()] {
                    let mut found = NearestSoFar::new(TRange::FORWARD);
                    let _ = kept.test(&scene, &order, places.clone(), &ray, &mut found);
                    let mut plain = NearestSoFar::new(TRange::FORWARD);
                    for place in places {
                        let (id, primitive) = (order[place], &scene.primitives[place]);
                        let _ = plain.test(id, primitive, &ray, &mut Off);
                    }
                    assert_eq!(found.hit(), plain.hit());
                }
            }
        }
        let scene = scene_of(&many);
        let order = ids(&scene);
        let mut found = NearestSoFar::new(TRange::FORWARD);
        let ray = Ray::new(DVec3::new(0.0, 0.25, 0.25), DVec3::X);
        let kept = LeafOrder::of_leaves(&scene, &order);
        let _ = kept.test(&scene, &order, 0..5, &ray, &mut found);
        let hit = found.hit().unwrap();
        assert_eq!((hit.object, hit.t), (PrimitiveId(1), 3.0));
    }

    #[test]
    fn spheres_that_are_clearly_missed_are_left_out() {
        let scene = scene_of(&[
            sphere([5.0, 9.0, 0.0], 1.0),
            sphere([5.0, 0.0, 0.0], 1.0),
            cube_at(90.0),
        ]);
        let order = ids(&scene);
        let kept = LeafOrder::of_cells(&scene, &order);
        let mut visited = Vec::new();
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let _ = kept.visit(&order, 0..3, &ray, |object| {
            visited.push(object.id().0);
            ControlFlow::Continue(())
        });
        assert_eq!(visited, [1, 2]);
        visited.clear();
        let mut search = NearestSoFar::new(TRange::FORWARD);
        let _ = kept.test_some(&scene, &order, 0..3, &ray, &mut search, |object| {
            visited.push(object.0);
            false
        });
        assert_eq!(visited, [1, 2]);
    }

    #[test]
    fn what_the_copy_of_a_triangle_cannot_settle_is_asked_of_the_polygon_itself() {
        // quadrilaterals have no copy; and the edge of a triangle is for the polygon to say
        let square = polygon(&[
            [6.0, -1.0, -1.0],
            [6.0, 2.0, -1.0],
            [6.0, 2.0, 2.0],
            [6.0, -1.0, 2.0],
        ]);
        let scene = scene_of(&[square, across(9.0)]);
        let order = ids(&scene);
        let kept = LeafOrder::of_leaves(&scene, &order);
        let hit = |y: f64, z: f64, places: Range<usize>| {
            let ray = Ray::new(DVec3::new(0.0, y, z), DVec3::X);
            let mut found = NearestSoFar::new(TRange::FORWARD);
            let _ = kept.test(&scene, &order, places, &ray, &mut found);
            found.hit().map(|hit| (hit.object.0, hit.t))
        };
        assert_eq!(hit(1.5, 1.5, 0..2), Some((0, 6.0)));
        assert_eq!(hit(2.5, 1.5, 0..2), None);
        // 10⁻¹³ before the slanted edge of the triangle: too near for the copy, and inside
        let inside = 0.5 - 1e-13;
        assert_eq!(hit(inside, inside, 1..2), Some((1, 9.0)));
    }
}
