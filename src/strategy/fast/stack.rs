//! The nodes that wait for their turn, without memory of their own as long as they are few.

use crate::geometry::TRange;
use crate::strategy::fast::slabs::BothPlanes;
use crate::strategy::turn::Turn;
use crate::structure::SlabBound;

/// The turn of a node, if the ray hits its bound where a hit still counts.
#[inline]
pub(super) fn turn_of<const N: usize>(
    node: u32,
    bound: &SlabBound<N>,
    ray: &BothPlanes<N>,
    range: TRange,
) -> Option<Turn> {
    let inside = ray.inside(bound);
    let near = inside.begins(range);
    inside.meets(range).then_some(Turn { near, node })
}

/// How many nodes wait without memory of their own: of the twenty levels of a tree of a million objects, not
/// every one leaves a node waiting, and places are cleared anew for each ray.
const FEW: usize = 12;

/// A stack of nodes, the next one on top.
#[derive(Debug)]
pub(super) struct Stack {
    few: [Turn; FEW],
    /// How many of the few wait.
    len: usize,
    /// What does not fit, in trees of uncommon depth.
    more: Vec<Turn>,
}

impl Stack {
    /// Nothing waits.
    #[inline]
    pub(super) fn new() -> Self {
        Self {
            few: [Turn::default(); FEW],
            len: 0,
            more: Vec::new(),
        }
    }

    /// Puts a node on top.
    #[inline]
    pub(super) fn push(&mut self, turn: Turn) {
        match self.few.get_mut(self.len) {
            Some(place) => {
                *place = turn;
                self.len += 1;
            }
            None => self.more.push(turn),
        }
    }

    /// Takes the node on top.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<Turn> {
        if self.len == FEW
            && let Some(last) = self.more.pop()
        {
            return Some(last);
        }
        self.len = self.len.checked_sub(1)?;
        Some(self.few[self.len])
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::Ray;
    use crate::structure::SlabSet;

    #[test]
    fn the_last_node_comes_first_however_many_wait() {
        let waiting = |node| Turn {
            near: f64::from(node),
            node,
        };
        let mut stack = Stack::new();
        // up to 30, back to 5, up to 20: across the limit of the few both ways
        for node in 0..30 {
            stack.push(waiting(node));
        }
        for node in (5..30).rev() {
            assert_eq!(stack.pop().map(|top| top.node), Some(node));
        }
        for node in 5..20 {
            stack.push(waiting(node));
        }
        for node in (0..20).rev() {
            assert_eq!(stack.pop().map(|top| top.node), Some(node));
        }
        assert!(stack.pop().is_none());
    }

    #[test]
    fn a_node_waits_from_where_the_ray_enters_its_bound_if_that_is_in_the_range() {
        // x from 2 to 5, y and z from −1 to 1
        let bound = SlabBound {
            d_min: [-5.0, -1.0, -1.0],
            d_max: [-2.0, 1.0, 1.0],
        };
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let planes = BothPlanes::new(&ray, &SlabSet::AXES, 0.0);
        let met = |min, max| turn_of(7, &bound, &planes, TRange { min, max });
        let near = |min, max| met(min, max).map(|waiting| waiting.near);
        assert_eq!(met(0.0, 9.0).map(|waiting| waiting.node), Some(7));
        assert_eq!(near(0.0, 9.0), Some(2.0));
        assert_eq!(near(3.0, 9.0), Some(3.0));
        // equality counts at both ends
        assert_eq!(near(0.0, 2.0), Some(2.0));
        assert_eq!(near(5.0, 9.0), Some(5.0));
        assert_eq!((near(0.0, 1.9), near(5.1, 9.0)), (None, None));
    }
}
