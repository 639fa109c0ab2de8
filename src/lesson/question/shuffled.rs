//! In which order choices are shown: one that follows from the question's name, so that it is the same everywhere.

/// An order that follows from a name.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shuffle(u64);

impl Shuffle {
    pub(super) fn new(lesson: &str, name: &str) -> Self {
        Self(fnv_1a(lesson.bytes().chain([b'/']).chain(name.bytes())))
    }

    /// The places 0 to `count` − 1 in another order.
    pub(super) fn order(self, count: usize) -> Vec<usize> {
        let mut places: Vec<usize> = (0..count).collect();
        places.sort_by_key(|&place| spread(self.0.wrapping_add(place as u64)));
        places
    }

    /// The items in another order.
    pub(super) fn of<T>(self, items: Vec<T>) -> Vec<T> {
        let order = self.order(items.len());
        let mut items: Vec<Option<T>> = items.into_iter().map(Some).collect();
        order
            .into_iter()
            .filter_map(|place| items[place].take())
            .collect()
    }
}

/// A hash of some bytes: FNV-1a, 64 bits (Fowler, Noll, Vo 1991). It is the same on every machine.
pub(crate) fn fnv_1a(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// A number whose bits all depend on those of another one (the finaliser of SplitMix64, Steele, Lea, Flood 2014).
fn spread(mut bits: u64) -> u64 {
    bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_its_authors() {
        // draft-eastlake-fnv, table of test vectors
        assert_eq!(fnv_1a("".bytes()), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv_1a("a".bytes()), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv_1a("foobar".bytes()), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn every_item_is_there_once_and_the_first_comes_to_each_place() {
        let mut places = [0; 4];
        for number in 0..400 {
            let order = Shuffle::new("04-sphere", &number.to_string()).order(4);
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, [0, 1, 2, 3]);
            places[order.iter().position(|place| *place == 0).unwrap()] += 1;
        }
        // a hundred each, and some four times √75 beside it
        assert!(places.iter().all(|of| (65..135).contains(of)), "{places:?}");
    }
}
