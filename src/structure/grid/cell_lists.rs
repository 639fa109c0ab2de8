//! The lists of a grid's cells, all in one array.

use std::ops::Range;

use crate::scene::PrimitiveId;
use crate::structure::grid::grid_error::MOST_ENTRIES;

/// Which objects each cell lists: cell c those from `starts[c]` up to `starts[c + 1]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct CellLists {
    starts: Vec<u32>,
    objects: Vec<PrimitiveId>,
}

impl CellLists {
    /// The lists of these numbers of cells and objects, where `cells_of(object, put)` puts the object into its cells.
    ///
    /// Each object is asked twice: the entries are counted before there is room for them. `None` if there are
    /// more than [`MOST_ENTRIES`]. The objects of a cell are in the order of the scene.
    pub(in crate::structure) fn filled(
        cells: usize,
        objects: usize,
        cells_of: impl FnMut(usize, &mut dyn FnMut(usize)),
    ) -> Option<Self> {
        Self::filled_up_to(MOST_ENTRIES, cells, objects, cells_of)
    }

    /// The same with at most so many entries.
    fn filled_up_to(
        most: u32,
        cells: usize,
        objects: usize,
        mut cells_of: impl FnMut(usize, &mut dyn FnMut(usize)),
    ) -> Option<Self> {
        let mut starts = vec![0; cells + 1];
        let mut total: u64 = 0;
        for object in 0..objects {
            cells_of(object, &mut |cell| {
                starts[cell] += 1;
                total += 1;
            });
            if u64::from(most) < total {
                return None;
            }
        }
        // where each list ends …
        let mut end = 0;
        for start in &mut starts {
            end += *start;
            *start = end;
        }
        // … is where it starts, once it is filled from the last object to the first
        let mut entries = vec![PrimitiveId(0); total as usize];
        for object in (0..objects).rev() {
            cells_of(object, &mut |cell| {
                starts[cell] -= 1;
                entries[starts[cell] as usize] = PrimitiveId(object as u32);
            });
        }
        Some(Self {
            starts,
            objects: entries,
        })
    }

    /// Where the objects that a cell lists stand among all.
    #[inline]
    pub(crate) fn range(&self, cell: usize) -> Range<usize> {
        self.starts[cell] as usize..self.starts[cell + 1] as usize
    }

    /// The objects that a cell lists.
    pub(in crate::structure) fn of(&self, cell: usize) -> &[PrimitiveId] {
        &self.objects[self.range(cell)]
    }

    /// The objects of all lists, one after the other.
    pub(crate) fn objects(&self) -> &[PrimitiveId] {
        &self.objects
    }

    /// How many entries there are.
    pub(in crate::structure) fn total(&self) -> usize {
        self.objects.len()
    }

    /// Bytes of memory.
    pub(in crate::structure) fn bytes(&self) -> usize {
        size_of_val(self.starts.as_slice()) + size_of_val(self.objects.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By object: 0 in the cells 0 and 2, 1 in 2, 2 in 2 and 1: five entries.
    fn put_three(object: usize, put: &mut dyn FnMut(usize)) {
        let cells: [&[usize]; 3] = [&[0, 2], &[2], &[2, 1]];
        for &cell in cells[object] {
            put(cell);
        }
    }

    #[test]
    fn each_cell_lists_its_objects_in_the_order_of_the_scene() {
        let lists = CellLists::filled(4, 3, put_three).unwrap();
        let of = |cell| lists.of(cell).iter().map(|id| id.0).collect::<Vec<_>>();
        assert_eq!(
            [0, 1, 2, 3].map(of),
            [vec![0], vec![2], vec![0, 1, 2], vec![]]
        );
        assert_eq!(lists.range(2), 2..5);
        assert_eq!(lists.total(), 5);
        assert_eq!(lists.objects().len(), 5);
        // five starts and five entries of 4 bytes
        assert_eq!(lists.bytes(), 40);
    }

    #[test]
    fn lists_have_as_many_entries_as_are_allowed_and_not_one_more() {
        let total = |most| {
            let lists = CellLists::filled_up_to(most, 4, 3, put_three);
            lists.map(|lists| lists.total())
        };
        assert_eq!([6, 5, 4, 1].map(total), [Some(5), Some(5), None, None]);
    }
}
