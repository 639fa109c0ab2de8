//! Built from the bottom up: two volumes that lie together are joined, again and again, until one is left.
//!
//! Slides: "bounding volume hierarchies organize the objects bottom-up". Which two lie together is decided by
//! the area of the box around both: the smaller, the better. Joining the best pair of all each time takes
//! time that grows with the square of the number of objects. Here every volume looks for its best partner
//! among its neighbours along a curve through space (G. Morton's), and all that have found each other are
//! joined at once (B. Walter et al. 2008; D. Meister and J. Bittner 2018). Up to [`NEIGHBOURS`] objects that
//! is every pair.

use glam::DVec3;

use crate::geometry::AxisBox;
use crate::scene::Scene;
use crate::structure::bounds::box_with_room;
use crate::structure::hierarchy::node::Topology;
use crate::structure::hierarchy::tree::Tree;

/// How far along the curve a partner is looked for, to either side: the paper finds no gain beyond some
/// tens.
const NEIGHBOURS: usize = 16;

/// A volume that waits for a partner.
#[derive(Clone, Copy)]
struct Cluster {
    node: u32,
    solid: AxisBox,
}

/// The hierarchy of pairs.
pub(in crate::structure) fn bottom_up<const N: usize>(scene: &Scene) -> Topology<N> {
    let solids: Vec<AxisBox> = scene
        .primitives
        .iter()
        .map(|primitive| box_with_room(&primitive.shape))
        .collect();
    let mut tree = Tree::of(solids.len());
    let cluster = |object: u32| Cluster {
        node: object,
        solid: solids[object as usize],
    };
    let order = along_the_curve(&solids);
    let mut waiting: Vec<Cluster> = order.into_iter().map(cluster).collect();
    drop(solids);
    let mut partners = Vec::with_capacity(waiting.len());
    while 1 < waiting.len() {
        partners.clear();
        partners.extend((0..waiting.len()).map(|at| partner(&waiting, at)));
        join(&mut waiting, &partners, &mut tree);
    }
    match waiting.pop() {
        Some(root) => tree.laid_out(root.node),
        None => Topology::default(),
    }
}

/// Joins every two volumes that are each other's best partner; the pair with the smallest area always is.
fn join(waiting: &mut Vec<Cluster>, partners: &[usize], tree: &mut Tree<[u32; 2]>) {
    // those that are left move up: what stands further on is read before it is written over
    let mut left = 0;
    for (at, &with) in partners.iter().enumerate() {
        let is_pair = partners[with] == at;
        if is_pair && with < at {
            continue;
        }
        let mut cluster = waiting[at];
        if is_pair {
            let other = waiting[with];
            cluster = Cluster {
                node: tree.join([cluster.node, other.node]),
                solid: cluster.solid.union(&other.solid),
            };
        }
        waiting[left] = cluster;
        left += 1;
    }
    waiting.truncate(left);
}

/// The neighbour with which the box is smallest. Of equals the one whose two places, the lower before the
/// higher, come first: so two of all the equals choose each other, and no round is without a pair.
fn partner(waiting: &[Cluster], at: usize) -> usize {
    let from = at.saturating_sub(NEIGHBOURS);
    let to = (at + NEIGHBOURS + 1).min(waiting.len());
    let area = |with: usize| waiting[at].solid.union(&waiting[with].solid).half_area();
    let places = |with: usize| (at.min(with), at.max(with));
    (from..to)
        .filter(|&with| with != at)
        .map(|with| (area(with), with))
        .min_by(|a, b| a.0.total_cmp(&b.0).then(places(a.1).cmp(&places(b.1))))
        .map_or(at, |(_, with)| with)
}

/// The objects in the order of Morton's curve, which runs through space so that neighbours along it are
/// near each other: the bits of x, y and z by turns.
fn along_the_curve(solids: &[AxisBox]) -> Vec<u32> {
    /// Bits for each coordinate: three times as many fit into 64.
    const BITS: u32 = 21;
    let centers = || solids.iter().map(AxisBox::doubled_center);
    let around = AxisBox::around(centers());
    let steps = f64::from((1_u32 << BITS) - 1);
    // all centers in one plane: that coordinate says nothing
    let scale = around
        .size()
        .to_array()
        .map(|side| if 0.0 < side { steps / side } else { 0.0 });
    let code = |center: DVec3| {
        let place = (center - around.min) * DVec3::from(scale);
        let [x, y, z] = place.to_array().map(|p| spread(p as u64));
        x | y << 1 | z << 2
    };
    let mut keyed: Vec<(u64, u32)> = centers().map(code).zip(0..).collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, object)| object).collect()
}

/// The low 21 bits of a number, two zeros between each two of them.
fn spread(bits: u64) -> u64 {
    let mut x = bits & 0x1f_ffff;
    x = (x | x << 32) & 0x001f_0000_0000_ffff;
    x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreading_puts_two_zeros_between_each_two_bits() {
        assert_eq!(spread(0b1011), 0b001_000_001_001);
        assert_eq!(spread(0x1f_ffff), 0x1249_2492_4924_9249);
    }

    /// A cube with sides of 1 in a row along x.
    fn cube(x: f64) -> AxisBox {
        AxisBox {
            min: DVec3::new(x, 0.0, 0.0),
            max: DVec3::new(x + 1.0, 1.0, 1.0),
        }
    }

    fn clusters(places: &[f64]) -> Vec<Cluster> {
        let of = |(&x, node)| Cluster {
            node,
            solid: cube(x),
        };
        places.iter().zip(0..).map(of).collect()
    }

    fn partners(places: &[f64]) -> Vec<usize> {
        let waiting = clusters(places);
        (0..waiting.len()).map(|at| partner(&waiting, at)).collect()
    }

    #[test]
    fn the_partner_is_the_one_with_which_the_box_is_smallest() {
        // widths with the neighbours: 2 or 6; 2 or 5; 5 or 2; 6 or 2
        assert_eq!(partners(&[0.0, 1.0, 5.0, 6.0]), [1, 0, 3, 2]);
        assert_eq!(partners(&[0.0, 1.0, 2.5]), [1, 0, 1]);
        assert_eq!(partners(&[0.0]), [0]);
    }

    #[test]
    fn of_equal_boxes_the_pair_that_comes_first_is_taken() {
        assert_eq!(partners(&[0.0, 1.0, 2.0, 3.0]), [1, 0, 1, 2]);
        assert_eq!(partners(&[4.0, 4.0, 4.0]), [1, 0, 0]);
    }

    #[test]
    fn partners_are_looked_for_among_the_sixteen_to_either_side() {
        // all a hundred apart, but for two in one place
        let far = |equal: usize| {
            let mut places: Vec<f64> = (0..40).map(|i| 100.0 * f64::from(i)).collect();
            places[20 + equal] = places[20];
            let found = partners(&places);
            [found[20], found[20 + equal]]
        };
        assert_eq!(far(16), [36, 20]);
        let [from_20, from_37] = far(17);
        assert!(from_20 != 37 && from_37 != 20, "{from_20} {from_37}");
    }

    #[test]
    fn each_round_joins_those_that_have_found_each_other_and_keeps_the_others() {
        let mut waiting = clusters(&[0.0, 1.0, 2.5, 7.0, 8.0]);
        let mut tree = Tree::of(5);
        let partners: Vec<usize> = (0..5).map(|at| partner(&waiting, at)).collect();
        assert_eq!(partners, [1, 0, 1, 4, 3]);
        join(&mut waiting, &partners, &mut tree);
        let nodes: Vec<u32> = waiting.iter().map(|cluster| cluster.node).collect();
        assert_eq!(nodes, [5, 2, 6]);
        assert_eq!(tree.children(5), Some(&[0, 1]));
        assert_eq!(tree.children(6), Some(&[3, 4]));
        assert_eq!(waiting[0].solid, cube(0.0).union(&cube(1.0)));
        assert_eq!(waiting[2].solid, cube(7.0).union(&cube(8.0)));
    }

    #[test]
    fn the_curve_takes_the_corners_of_a_cube_x_first_then_y_then_z() {
        let at = |x: f64, y: f64, z: f64| AxisBox {
            min: DVec3::new(x, y, z),
            max: DVec3::new(x, y, z),
        };
        // (1, 1, 1), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 0), shifted: places 7, 4, 1, 2, 0 on the curve
        let solids = [
            at(11.0, 6.0, 4.0),
            at(10.0, 5.0, 4.0),
            at(11.0, 5.0, 3.0),
            at(10.0, 6.0, 3.0),
            at(10.0, 5.0, 3.0),
        ];
        assert_eq!(along_the_curve(&solids), [4, 2, 3, 1, 0]);
        // in one plane the third coordinate says nothing; finer steps of x count below a step of y of the whole height
        let flat = [
            at(8.0, 1.0, 2.0),
            at(1.0, 0.0, 2.0),
            at(0.0, 1.0, 2.0),
            at(4.0, 0.0, 2.0),
        ];
        assert_eq!(along_the_curve(&flat), [1, 3, 2, 0]);
    }

    #[test]
    fn places_on_the_curve_are_shares_of_the_extent_wherever_the_objects_lie() {
        let at = |x: f64, y: f64| AxisBox {
            min: DVec3::new(x, y, 0.0),
            max: DVec3::new(x, y, 0.0),
        };
        // all of the width counts for more than less than half of the height
        let solids = [
            at(108.0, 0.0),
            at(100.0, 0.4),
            at(100.0, 0.0),
            at(100.0, 1.0),
        ];
        assert_eq!(along_the_curve(&solids), [2, 1, 0, 3]);
    }
}
