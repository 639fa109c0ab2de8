//! Objects side by side in the order in which a search comes to them.
//!
//! The objects of a leaf, or of a cell, stand anywhere in the scene: each of them would be read from a place of
//! its own in memory, which in a large scene takes longer than its test. So what the test of a sphere reads is
//! copied in the order of the leaves, where the next one is at hand. A copy takes 40 bytes; other shapes are larger,
//! and looked up in the scene.

use std::ops::{ControlFlow, Range};

use crate::geometry::{Ray, Sides, Sphere, TRange};
use crate::scene::{Primitive, PrimitiveId, Scene, Shape};
use crate::strategy::object_test::test_sphere;
use crate::strategy::test_primitive;
use crate::trace::Recorder;

/// The objects of all leaves, or of all cells, one leaf after the other.
#[derive(Clone, Debug)]
pub(super) struct LeafOrder<'a> {
    scene: &'a Scene,
    /// Empty in a scene without spheres: its objects are found by their ids alone.
    copies: Vec<Listed>,
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

impl<'a> LeafOrder<'a> {
    /// The objects of a scene in this order.
    pub(super) fn new(scene: &'a Scene, order: &[PrimitiveId]) -> Self {
        let is_sphere = |object: &Primitive| matches!(object.shape, Shape::Sphere(_));
        let copies = if scene.primitives.iter().any(is_sphere) {
            order.iter().map(|&id| Listed::new(scene, id)).collect()
        } else {
            Vec::new()
        };
        Self { scene, copies }
    }

    /// The scene that the objects are from.
    #[inline]
    pub(super) fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Visits the objects in these places of `order`, which is the order that was given at first.
    #[inline]
    pub(super) fn visit(
        &self,
        order: &[PrimitiveId],
        places: Range<usize>,
        mut visit: impl FnMut(&Listed) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.copies.is_empty() {
            for &id in &order[places] {
                visit(&Listed::InScene { id })?;
            }
            return ControlFlow::Continue(());
        }
        for object in &self.copies[places] {
            visit(object)?;
        }
        ControlFlow::Continue(())
    }

    /// How much memory the copies take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.copies.as_slice())
    }
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
    ///
    /// Asked only where nobody follows: what is recorded is the whole test.
    #[inline]
    pub(super) fn is_clearly_missed(&self, ray: &Ray) -> bool {
        match self {
            Self::Sphere { sphere, .. } => sphere.is_clearly_missed(ray),
            Self::InScene { .. } => false,
        }
    }

    /// Where does the ray meet the object, if it does so in the range? As [`test_primitive`] says.
    #[inline]
    pub(super) fn test<R: Recorder>(
        &self,
        scene: &Scene,
        ray: &Ray,
        range: TRange,
        recorder: &mut R,
    ) -> Option<f64> {
        match self {
            Self::Sphere { id, sides, sphere } => {
                test_sphere(*id, sphere, *sides, ray, range, recorder)
            }
            Self::InScene { id } => test_primitive(*id, scene.primitive(*id), ray, range, recorder),
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
