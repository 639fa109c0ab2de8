//! What of a trace is kept: by kind, by region, up to a budget.

use std::fmt;
use std::ops::ControlFlow;
use std::str::FromStr;

use crate::trace::{Kind, Record, Sink};

/// A set of kinds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kinds(u64);

impl Kinds {
    /// Every kind.
    pub const ALL: Self = Self(u64::MAX);

    /// These kinds with those that they [need](Kind::needs), and no other.
    pub fn of(kinds: &[Kind]) -> Self {
        let with_needed = kinds.iter().flat_map(|&kind| [Some(kind), kind.needs()]);
        let bits = with_needed.flatten().map(Self::bit);
        Self(bits.fold(0, |set, bit| set | bit))
    }

    /// Is the kind in the set?
    #[inline]
    pub const fn contains(self, kind: Kind) -> bool {
        self.0 & Self::bit(kind) != 0
    }

    const fn bit(kind: Kind) -> u64 {
        1 << kind as u32
    }
}

/// A rectangle of pixels, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The first column and row.
    pub from: [u32; 2],
    /// The last column and row.
    pub to: [u32; 2],
}

impl Region {
    /// The whole picture of a size, neither side of which is 0.
    pub fn whole(pixels: [u32; 2]) -> Self {
        Self {
            from: [0, 0],
            to: pixels.map(|side| side.saturating_sub(1)),
        }
    }

    /// One pixel.
    pub fn pixel(pixel: [u32; 2]) -> Self {
        Self {
            from: pixel,
            to: pixel,
        }
    }

    /// The smallest region with all these pixels; `None` without any.
    pub fn around(pixels: &[[u32; 2]]) -> Option<Self> {
        let pixel = |&pixel| Self::pixel(pixel);
        pixels.iter().map(pixel).reduce(|all, of| Self {
            from: [0, 1].map(|i| all.from[i].min(of.from[i])),
            to: [0, 1].map(|i| all.to[i].max(of.to[i])),
        })
    }

    /// Does the pixel lie in it?
    #[inline]
    pub fn contains(&self, [x, y]: [u32; 2]) -> bool {
        let [left, top] = self.from;
        let [right, bottom] = self.to;
        left <= x && x <= right && top <= y && y <= bottom
    }
}

/// `X,Y` for one pixel or `X0,Y0-X1,Y1` for a rectangle.
impl FromStr for Region {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let corner = |part: &str| -> Option<[u32; 2]> {
            let (x, y) = part.split_once(',')?;
            Some([x.trim().parse().ok()?, y.trim().parse().ok()?])
        };
        let parsed = match text.split_once('-') {
            None => corner(text).map(Self::pixel),
            Some((from, to)) => corner(from)
                .zip(corner(to))
                .map(|(from, to)| Self { from, to }),
        };
        match parsed {
            Some(region) if (0..2).all(|i| region.from[i] <= region.to[i]) => Ok(region),
            Some(_) => Err("the second corner is above or left of the first".into()),
            None => Err("give X,Y or X0,Y0-X1,Y1, counted from 0,0 at the top left".into()),
        }
    }
}

impl fmt::Display for Region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x0, y0], [x1, y1]) = (self.from, self.to);
        write!(f, "{x0},{y0}-{x1},{y1}")
    }
}

/// Lets through some kinds and one region.
#[derive(Clone, Debug)]
pub struct Filter<S> {
    /// The kinds to let through.
    pub kinds: Kinds,
    /// The pixels to let through.
    pub region: Option<Region>,
    /// The sink that receives the records that pass.
    pub sink: S,
}

impl<S: Sink> Sink for Filter<S> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        let inside = self
            .region
            .zip(record.pixel)
            .is_none_or(|(region, pixel)| region.contains(pixel));
        if inside && self.kinds.contains(record.event.kind()) {
            return self.sink.record(record);
        }
        ControlFlow::Continue(())
    }
}

/// Lets through a number of records; one more stops it.
#[derive(Clone, Debug)]
pub struct Budget<S> {
    /// How many more may pass.
    pub left: u64,
    /// The sink that receives the records that pass.
    pub sink: S,
}

impl<S: Sink> Sink for Budget<S> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        match self.left.checked_sub(1) {
            Some(left) => {
                self.left = left;
                self.sink.record(record)
            }
            None => ControlFlow::Break(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(kind: Kind, pixel: [u32; 2]) -> Record {
        Record {
            pixel: Some(pixel),
            path: None,
            step: 0,
            ray: None,
            parent: None,
            event: kind.blank(),
        }
    }

    #[test]
    fn a_filter_lets_through_its_kinds_in_its_region() {
        let mut filter = Filter {
            kinds: Kinds::of(&[Kind::Ray, Kind::Shade]),
            region: Some("1,1-2,3".parse().unwrap()),
            sink: Vec::new(),
        };
        for (kind, pixel) in [
            (Kind::Ray, [1, 1]),
            (Kind::RayEnd, [1, 1]),
            (Kind::Shade, [2, 3]),
            (Kind::Shade, [3, 3]),
            (Kind::Ray, [1, 0]),
        ] {
            assert!(filter.record(&record(kind, pixel)).is_continue());
        }
        let kept: Vec<_> = filter
            .sink
            .iter()
            .map(|r| (r.event.kind(), r.pixel))
            .collect();
        assert_eq!(
            kept,
            [(Kind::Ray, Some([1, 1])), (Kind::Shade, Some([2, 3]))]
        );
    }

    #[test]
    fn a_budget_lets_through_its_number_and_stops_at_one_more() {
        let mut budget = Budget {
            left: 2,
            sink: Vec::new(),
        };
        let mut passes = |x| budget.record(&record(Kind::Ray, [x, 0])).is_continue();
        assert_eq!([passes(0), passes(1), passes(2)], [true, true, false]);
        assert_eq!(budget.sink.len(), 2);
    }

    #[test]
    fn regions_are_read_as_they_are_printed() {
        let region: Region = "3,4-10,12".parse().unwrap();
        assert_eq!(region.to_string().parse(), Ok(region));
        assert_eq!("7,8".parse(), Ok(Region::pixel([7, 8])));
        for bad in ["", "3", "3,", "3,4-", "-1,2", "5,5-4,6", "a,b"] {
            assert!(bad.parse::<Region>().is_err(), "{bad}");
        }
    }

    #[test]
    fn a_region_around_pixels_reaches_from_the_least_to_the_largest() {
        let around = Region::around(&[[4, 7], [9, 2], [5, 5]]);
        let (from, to) = ([4, 2], [9, 7]);
        assert_eq!(around, Some(Region { from, to }));
        assert_eq!(Region::around(&[]), None);
    }
}
