//! Built from the bottom up: two volumes that lie together are joined, again and again, until one is left.
//!
//! Slides: "bounding volume hierarchies organize the objects bottom-up". Which two lie together is told by
//! the area of the box around both: the smaller, the better. Joining the best pair of all each time takes
//! time that grows with the square of the number of objects. Here every volume looks for its best partner
//! among its neighbours along a curve through space (G. Morton's), and all that have found each other are
//! joined at once (B. Walter et al. 2008; D. Meister and J. Bittner 2018). Up to [`NEIGHBOURS`] objects that
//! is every pair.

use glam::DVec3;

use crate::scene::Scene;
use crate::structure::build::solid::Solid;
use crate::structure::build::tree::Tree;
use crate::structure::hierarchy::Topology;

/// How far along the curve a partner is looked for, to either side: the paper finds no gain beyond some
/// tens.
const NEIGHBOURS: usize = 16;

/// A volume that waits for a partner.
#[derive(Clone, Copy)]
struct Cluster {
    node: u32,
    solid: Solid,
}

/// The hierarchy of pairs.
pub(in crate::structure) fn bottom_up<const N: usize>(scene: &Scene) -> Topology<N> {
    let solids: Vec<Solid> = scene
        .primitives
        .iter()
        .map(|primitive| Solid::of(&primitive.shape))
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
fn along_the_curve(solids: &[Solid]) -> Vec<u32> {
    /// Bits for each coordinate: three times as many fit into 64.
    const BITS: u32 = 21;
    let centers = || solids.iter().map(Solid::doubled_center);
    let low = centers().fold(DVec3::INFINITY, DVec3::min);
    let high = centers().fold(DVec3::NEG_INFINITY, DVec3::max);
    let steps = f64::from((1_u32 << BITS) - 1);
    // all centers in one plane: that coordinate says nothing
    let scale = (high - low)
        .to_array()
        .map(|side| if 0.0 < side { steps / side } else { 0.0 });
    let code = |center: DVec3| {
        let place = (center - low) * DVec3::from(scale);
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
}
