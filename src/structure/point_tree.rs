//! A balanced k-d tree of points: which are the nearest to a place?
//!
//! J. L. Bentley, *Multidimensional binary search trees used for associative searching* (1975). The tree has no
//! pointers: of every stretch of the list the item in the middle divides the others along one axis.

use glam::DVec3;

/// Items that have a place each, in the order of the tree.
#[derive(Clone, Debug, Default)]
pub struct PointTree<T> {
    items: Vec<T>,
    /// For each item that divides others the axis along which it does.
    axes: Vec<u8>,
}

/// One of the nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbour {
    /// The square of its distance.
    pub distance_squared: f64,
    /// Its place in the list of [`PointTree::items`].
    pub index: u32,
}

/// Something that has a place.
pub trait Placed {
    /// Where it is.
    fn place(&self) -> DVec3;
}

impl<T: Placed> PointTree<T> {
    /// Builds the tree in O(n log n), each stretch divided across the axis along which it is longest.
    pub fn new(mut items: Vec<T>) -> Self {
        let mut axes = vec![0; items.len()];
        divide(&mut items, &mut axes);
        Self { items, axes }
    }

    /// All items, in the order of the tree.
    pub fn items(&self) -> &[T] {
        &self.items
    }

    /// The up to `most` nearest items of those that are accepted, the nearest first. Of several as far away it is
    /// not said which one counts.
    pub fn nearest(
        &self,
        place: DVec3,
        most: usize,
        accepts: impl Fn(&T) -> bool,
    ) -> Vec<Neighbour> {
        let mut search = Nearest {
            tree: self,
            place,
            most,
            accepts,
            found: Vec::with_capacity(most.min(self.items.len())),
        };
        if 0 < most {
            search.stretch(0, self.items.len());
        }
        search.found
    }
}

/// Puts the middle item of each stretch in the middle, and those below and above it to its sides.
fn divide<T: Placed>(items: &mut [T], axes: &mut [u8]) {
    if items.len() < 2 {
        return;
    }
    let first = items[0].place();
    let (low, high) = items.iter().fold((first, first), |(low, high), item| {
        (low.min(item.place()), high.max(item.place()))
    });
    let axis = (high - low).max_position();
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| a.place()[axis].total_cmp(&b.place()[axis]));
    axes[middle] = axis as u8;
    let (below, above) = items.split_at_mut(middle);
    let (axes_below, axes_above) = axes.split_at_mut(middle);
    divide(below, axes_below);
    divide(&mut above[1..], &mut axes_above[1..]);
}

/// A search on its way.
struct Nearest<'a, T, A> {
    tree: &'a PointTree<T>,
    place: DVec3,
    most: usize,
    accepts: A,
    /// Sorted by distance.
    found: Vec<Neighbour>,
}

impl<T: Placed, A: Fn(&T) -> bool> Nearest<'_, T, A> {
    fn stretch(&mut self, from: usize, to: usize) {
        if to <= from {
            return;
        }
        let middle = from + (to - from) / 2;
        let item = &self.tree.items[middle];
        let axis = usize::from(self.tree.axes[middle]);
        let beyond = self.place[axis] - item.place()[axis];
        // the side that the place is on first
        let (near, far) = if beyond < 0.0 {
            ((from, middle), (middle + 1, to))
        } else {
            ((middle + 1, to), (from, middle))
        };
        self.stretch(near.0, near.1);
        self.offer(middle);
        // nothing on the other side is nearer than the dividing plane
        if self.found.len() < self.most || beyond * beyond <= self.farthest() {
            self.stretch(far.0, far.1);
        }
    }

    fn farthest(&self) -> f64 {
        self.found
            .last()
            .map_or(f64::INFINITY, |last| last.distance_squared)
    }

    fn offer(&mut self, index: usize) {
        let item = &self.tree.items[index];
        let distance_squared = item.place().distance_squared(self.place);
        let is_full = self.found.len() == self.most;
        if (is_full && self.farthest() <= distance_squared) || !(self.accepts)(item) {
            return;
        }
        if is_full {
            self.found.pop();
        }
        let place = self
            .found
            .partition_point(|other| other.distance_squared <= distance_squared);
        let index = index as u32;
        self.found.insert(
            place,
            Neighbour {
                distance_squared,
                index,
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Placed for DVec3 {
        fn place(&self) -> DVec3 {
            *self
        }
    }

    /// A lattice of 9 × 7 × 5 points in no order, slightly askew so that no two distances from the origin are equal.
    fn lattice() -> Vec<DVec3> {
        let mut points = Vec::new();
        for x in 0..9 {
            for y in 0..7 {
                for z in 0..5 {
                    let [x, y, z] = [x, y, z].map(f64::from);
                    points.push(DVec3::new(x + 0.01 * y, y + 0.003 * z, z + 0.007 * x));
                }
            }
        }
        // 101 and 315 have no common factor
        (0..points.len())
            .map(|i| points[i * 101 % points.len()])
            .collect()
    }

    #[test]
    fn the_nearest_are_those_that_a_sorted_list_begins_with() {
        let points = lattice();
        let tree = PointTree::new(points.clone());
        let places = [
            DVec3::ZERO,
            DVec3::new(4.4, 3.2, 1.9),
            DVec3::new(-9.0, 20.0, 2.0),
        ];
        for place in places {
            for accepts_below in [100.0, 4.0] {
                let mut sorted: Vec<f64> = points
                    .iter()
                    .filter(|point| point.x < accepts_below)
                    .map(|point| point.distance_squared(place))
                    .collect();
                sorted.sort_by(f64::total_cmp);
                for most in [1, 2, 17, 400] {
                    let found = tree.nearest(place, most, |point| point.x < accepts_below);
                    let distances: Vec<f64> = found.iter().map(|n| n.distance_squared).collect();
                    let expected = &sorted[..most.min(sorted.len())];
                    assert_eq!(distances, expected, "{place} {most}");
                }
            }
        }
    }

    #[test]
    fn no_items_or_none_wanted_find_nothing() {
        assert!(
            PointTree::<DVec3>::new(Vec::new())
                .nearest(DVec3::ZERO, 3, |_| true)
                .is_empty()
        );
        assert!(
            PointTree::new(lattice())
                .nearest(DVec3::ZERO, 0, |_| true)
                .is_empty()
        );
    }

    #[test]
    fn items_that_share_one_place_are_all_found() {
        let tree = PointTree::new(vec![DVec3::ONE; 20]);
        let found = tree.nearest(DVec3::ZERO, 30, |_| true);
        assert_eq!(found.len(), 20);
        assert!(found.iter().all(|n| n.distance_squared == 3.0));
    }

    #[test]
    fn the_items_are_all_there_each_in_the_half_that_its_divider_says() {
        let tree = PointTree::new(lattice());
        assert_eq!(tree.items().len(), 315);
        #[track_caller]
        fn check(items: &[DVec3], axes: &[u8]) {
            if items.len() < 2 {
                return;
            }
            let middle = items.len() / 2;
            let axis = usize::from(axes[middle]);
            let divider = items[middle][axis];
            assert!(items[..middle].iter().all(|item| item[axis] <= divider));
            assert!(items[middle..].iter().all(|item| divider <= item[axis]));
            // across the axis along which the stretch is longest
            let low = items.iter().copied().fold(DVec3::INFINITY, DVec3::min);
            let high = items.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
            assert_eq!((high - low).max_element(), (high - low)[axis]);
            check(&items[..middle], &axes[..middle]);
            check(&items[middle + 1..], &axes[middle + 1..]);
        }
        check(tree.items(), &tree.axes);
    }

    #[test]
    fn the_search_goes_on_beyond_what_is_not_accepted_until_it_has_enough() {
        // on a line from 0 to 9 all between the first and the last two are refused
        let tree = PointTree::new((0..10).map(|x| f64::from(x) * DVec3::X).collect());
        let accepts = |point: &DVec3| point.x < 0.5 || 7.5 < point.x;
        let squares = |most| {
            let found = tree.nearest(DVec3::ZERO, most, accepts);
            found.iter().map(|n| n.distance_squared).collect::<Vec<_>>()
        };
        assert_eq!(squares(3), [0.0, 64.0, 81.0]);
        assert_eq!(squares(2), [0.0, 64.0]);
    }
}
