//! A path of light, leg by leg, from its events.

use std::collections::BTreeMap;

use crate::figure::traced::Section;
use crate::trace::{Arrival, Event, Nearby, PathStart, Purpose, RayEnd, RayStart, Record, Stored};

/// A path of light.
#[derive(Clone, Debug)]
pub(in crate::figure) struct LightPath<'a> {
    pub(in crate::figure) start: &'a PathStart,
    pub(in crate::figure) legs: Vec<Leg<'a>>,
}

/// A stretch of it, from where it starts to where it hits something.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Leg<'a> {
    pub(in crate::figure) start: &'a RayStart,
    pub(in crate::figure) end: &'a RayEnd,
    /// The step at which it ends.
    pub(in crate::figure) step: u32,
    /// Where it passes the eye.
    pub(in crate::figure) arrival: Option<&'a Arrival>,
    /// The photon that is stored at its end.
    pub(in crate::figure) stored: Option<&'a Stored>,
}

/// What a leg of a path is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Use {
    /// It leads to the eye, or to a photon that was gathered.
    Seen,
    /// It leads to a photon that is stored and that nobody has gathered.
    Stored,
    /// Nothing comes of it.
    Wasted,
}

impl<'a> LightPath<'a> {
    /// The path of a section; `None` if its start was not recorded.
    pub(in crate::figure) fn of(section: &Section<'a>) -> Option<Self> {
        let start = section
            .records
            .iter()
            .find_map(|record| match &record.event {
                Event::Path(start) => Some(start),
                _ => None,
            })?;
        let mut legs = Vec::new();
        let mut ray = None;
        let mut arrival = None;
        let mut stored = None;
        for record in section.records {
            match &record.event {
                Event::Ray(start) => {
                    ray = (start.purpose == Purpose::Light).then_some(start);
                    (arrival, stored) = (None, None);
                }
                Event::Arrival(of) => arrival = Some(of),
                Event::Stored(of) => stored = Some(of),
                Event::RayEnd(end) => legs.extend(ray.take().map(|start| Leg {
                    start,
                    end,
                    step: section.step(record),
                    arrival,
                    stored,
                })),
                _ => {}
            }
        }
        Some(Self { start, legs })
    }

    /// What each leg is good for, if of the photons up to this surface of the path, from 1, something was gathered.
    pub(in crate::figure) fn uses(&self, gathered: Option<u32>) -> Vec<Use> {
        let arrives = self.legs.iter().rposition(|leg| leg.arrival.is_some());
        let seen = arrives.map_or(0, |last| last + 1);
        let seen = seen.max(gathered.unwrap_or(0) as usize);
        let stored = self.legs.iter().rposition(|leg| leg.stored.is_some());
        let stored = stored.map_or(0, |last| last + 1);
        let of = |place: usize| {
            if place < seen {
                Use::Seen
            } else if place < stored {
                Use::Stored
            } else {
                Use::Wasted
            }
        };
        (0..self.legs.len()).map(of).collect()
    }
}

/// The last surface of each path, from 1, of which a photon was gathered in these records.
pub(in crate::figure) fn gathered_from<'a>(
    records: impl IntoIterator<Item = &'a Record>,
) -> BTreeMap<u32, u32> {
    let mut surfaces = BTreeMap::new();
    for record in records {
        if let Event::Nearby(Nearby { path, surface, .. }) = record.event {
            let last = surfaces.entry(path).or_insert(surface);
            *last = surface.max(*last);
        }
    }
    surfaces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::RayVerdict;

    const START: RayStart = RayStart {
        purpose: Purpose::Light,
        ..RAY
    };
    const RAY: RayStart = RayStart {
        ray: crate::geometry::Ray {
            origin: glam::DVec3::ZERO,
            direction: glam::DVec3::Z,
        },
        range: crate::geometry::TRange::FORWARD,
        purpose: Purpose::Connection,
        depth: 1,
        window_t: None,
        light: None,
    };
    const END: RayEnd = RayEnd {
        verdict: RayVerdict::Hit,
        object: None,
        t: Some(1.0),
        colour: None,
        tests: 0,
        hits: 0,
    };

    /// Three legs, of which the first two leave photons, and a line to the eye.
    fn path() -> Vec<Record> {
        let stored = Event::Stored(Stored::default());
        let events = [
            Event::Path(PathStart::default()),
            Event::Ray(START),
            stored,
            Event::RayEnd(END),
            Event::Ray(START),
            stored,
            Event::RayEnd(END),
            Event::Ray(START),
            Event::RayEnd(END),
            Event::Ray(RAY),
            Event::RayEnd(END),
        ];
        let record = |(step, event)| Record {
            pixel: None,
            path: Some(0),
            step,
            ray: None,
            parent: None,
            event,
        };
        (0..).zip(events).map(record).collect()
    }

    #[test]
    fn a_path_has_the_legs_of_light_and_not_the_lines_to_the_eye() {
        let records = path();
        let path = LightPath::of(&Section::first(&records)).unwrap();
        let steps: Vec<u32> = path.legs.iter().map(|leg| leg.step).collect();
        assert_eq!(steps, [3, 6, 8]);
        let stored: Vec<bool> = path.legs.iter().map(|leg| leg.stored.is_some()).collect();
        assert_eq!(stored, [true, true, false]);
    }

    #[test]
    fn a_leg_is_seen_if_it_leads_to_what_was_gathered_and_wasted_if_it_leads_nowhere() {
        use Use::{Seen, Stored, Wasted};
        let records = path();
        let path = LightPath::of(&Section::first(&records)).unwrap();
        assert_eq!(path.uses(None), [Stored, Stored, Wasted]);
        assert_eq!(path.uses(Some(1)), [Seen, Stored, Wasted]);
        assert_eq!(path.uses(Some(2)), [Seen, Seen, Wasted]);
    }

    #[test]
    fn an_arrival_makes_all_legs_before_it_seen() {
        let mut records = path();
        records[2].event = Event::Photon(crate::trace::Photon::default());
        records[5].event = Event::Arrival(Arrival::default());
        let path = LightPath::of(&Section::first(&records)).unwrap();
        assert_eq!(path.uses(None), [Use::Seen, Use::Seen, Use::Wasted]);
    }
}
