//! The box with the ray along z: three slabs whose normals are turned.

use glam::DVec3;

use crate::geometry::{AlignedRay, AxisBox, BoxTest, Sides, SlabRay, TRange};

/// One slab of a box in the frame of the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignedSlab {
    /// (A′, B′, C′): an axis of the world, turned.
    pub normal: DVec3,
    /// T = −1/(C′·|Δ|) in the frame of the ray; infinite if the ray is parallel to the slab.
    pub t_scale: f64,
    /// D′ of the plane furthest along the normal.
    pub d_min: f64,
    /// D′ of the plane furthest back.
    pub d_max: f64,
}

impl AxisBox {
    /// Where does the z axis meet the transformed box?
    ///
    /// The planes of its slabs are A′·x + B′·y + C′·z + D′ = 0: at x = y = 0 that is z = −D′/C′.
    ///
    /// Degenerate cases are those of [`AxisBox::test`], and so is every bit of the roots.
    #[inline]
    pub fn test_aligned(&self, ray: &AlignedRay, range: TRange, sides: Sides) -> BoxTest {
        let slabs = self.aligned_slabs(ray).map(|slab| {
            let t_scale = slab.t_scale;
            SlabRay { s: 0.0, t_scale }.interval(slab.d_min, slab.d_max)
        });
        BoxTest::of(slabs, range, sides)
    }

    /// The slabs of the transformed box.
    ///
    /// The origin's distance from a plane is the same in both frames, D′ = S + D, and so is the cosine with
    /// its normal, C′·|Δ| = A·Δx + B·Δy + C·Δz. Both are taken from the world.
    #[inline]
    pub fn aligned_slabs(&self, ray: &AlignedRay) -> [AlignedSlab; 3] {
        let slab = |axis: DVec3, low: f64, high: f64| {
            let SlabRay { s, t_scale } = SlabRay::new(&ray.world, axis);
            AlignedSlab {
                normal: ray.frame.vector(axis),
                t_scale,
                d_min: s - high,
                d_max: s - low,
            }
        };
        [
            slab(DVec3::X, self.min.x, self.max.x),
            slab(DVec3::Y, self.min.y, self.max.y),
            slab(DVec3::Z, self.min.z, self.max.z),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;

    #[test]
    fn a_turned_slab_keeps_its_thickness_and_its_distance() {
        let solid = AxisBox {
            min: DVec3::new(3.0, -1.0, -9.0),
            max: DVec3::new(6.0, 1.0, 9.0),
        };
        let ray = AlignedRay::new(&Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8)));
        let [across_x, ..] = solid.aligned_slabs(&ray);
        // x′ = y, y′ = −0.8x + 0.6z, z′ = 0.6x + 0.8z: the axis x becomes (0, −0.8, 0.6)
        assert_eq!(across_x.normal, DVec3::new(0.0, -0.8, 0.6));
        assert_eq!((across_x.d_min, across_x.d_max), (-6.0, -3.0));
        let test = solid.test_aligned(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!(test.roots.chosen(), Some(5.0)); // 3/0.6
    }
}
