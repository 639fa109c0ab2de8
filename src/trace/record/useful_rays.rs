//! Which of the rays that were cast brought light into the picture? A recorder that keeps sums alone.
//!
//! A ray contributes if light came along it that counts in the picture:
//! - a ray from the eye, reflected or refracted, if it brings back a colour;
//! - a ray to a light, if the light adds something;
//! - a leg of a path of light, if the eye saw the path, or gathered a photon of it, or a line was drawn from it,
//!   there or further on;
//! - a leg of a path from the eye, if a line there or further on added something; and that line.

use std::collections::HashMap;

use glam::DVec3;

use crate::trace::{Event, Purpose, RayVerdict, Recorder};

/// How many rays were cast, and how many of them contributed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UsefulRays {
    /// Rays that were traced.
    pub cast: u64,
    /// Those that contributed, but for the legs of paths.
    useful: u64,
    /// For each path of light how many of its legs contributed.
    legs: HashMap<u32, u32>,
    /// The path of light that is followed, and how many legs it has so far.
    path: Option<(u32, u32)>,
    /// How many legs of the path from the eye that is followed contributed.
    eye_legs: u32,
    /// Photons that were found and not gathered yet: their path and surface.
    nearby: Vec<(u32, u32)>,
    /// Purposes of the rays that have started and not ended.
    open: Vec<Purpose>,
}

impl UsefulRays {
    /// The rays that contributed.
    pub fn contributed(&self) -> u64 {
        let legs: u64 = self.legs.values().map(|&legs| u64::from(legs)).sum();
        self.useful + legs + u64::from(self.eye_legs)
    }

    /// The share of the rays that brought nothing; `None` if none was cast.
    pub fn wasted(&self) -> Option<f64> {
        (0 < self.cast).then(|| 1.0 - self.contributed() as f64 / self.cast as f64)
    }

    /// Adds what another part of the trace cast.
    pub fn add(&mut self, other: &Self) {
        self.cast += other.cast;
        self.useful += other.useful + u64::from(other.eye_legs);
        for (&path, &legs) in &other.legs {
            self.uses(path, legs);
        }
    }

    /// The number of the first legs of a path that contributed.
    fn uses(&mut self, path: u32, legs: u32) {
        let known = self.legs.entry(path).or_default();
        *known = legs.max(*known);
    }

    fn ended(&mut self, verdict: RayVerdict, colour: Option<DVec3>) {
        let purpose = self.open.pop();
        if verdict == RayVerdict::DepthLimit {
            return;
        }
        self.cast += 1;
        let brings = colour.is_some_and(|colour| colour != DVec3::ZERO);
        let from_eye = matches!(
            purpose,
            Some(Purpose::Eye | Purpose::Reflected | Purpose::Refracted)
        );
        self.useful += u64::from(from_eye && brings);
    }
}

impl Recorder for UsefulRays {
    const ENABLED: bool = true;

    fn note(&mut self, event: impl FnOnce() -> Event) {
        match event() {
            Event::Path(start) => self.path = Some((start.path, 0)),
            Event::Pixel(_) => {
                self.path = None;
                self.useful += u64::from(std::mem::take(&mut self.eye_legs));
            }
            Event::Ray(start) => {
                self.open.push(start.purpose);
                if let (Purpose::Light, Some((_, legs))) = (start.purpose, &mut self.path) {
                    *legs += 1;
                }
            }
            Event::RayEnd(end) => self.ended(end.verdict, end.colour),
            Event::LightTerm(light) => {
                let adds = light.term.diffuse + light.term.specular != DVec3::ZERO;
                let by_ray = light.visibility == crate::trace::Visibility::Visible;
                self.useful += u64::from(by_ray && adds);
            }
            Event::Arrival(_) => {
                if let Some((path, legs)) = self.path {
                    self.uses(path, legs);
                }
            }
            Event::Nearby(photon) => self.nearby.push((photon.path, photon.surface)),
            Event::Gathered(gathered) => {
                // the k-th photon says how large the disc is, and adds nothing
                let mut found = std::mem::take(&mut self.nearby);
                found.truncate(gathered.count as usize);
                for (path, surface) in found {
                    self.uses(path, surface);
                }
            }
            Event::Connection(line) if line.contribution != DVec3::ZERO => {
                self.useful += 1;
                self.uses(line.path, u32::from(line.light_vertex));
                self.eye_legs = self.eye_legs.max(u32::from(line.eye_vertex));
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{
        Arrival, Connection, Gathered, LightTerm, Nearby, PathStart, PixelSample, RayEnd, RayStart,
    };

    fn ray(purpose: Purpose) -> Event {
        Event::Ray(RayStart {
            purpose,
            ..RayStart::default()
        })
    }

    fn end(colour: Option<DVec3>) -> Event {
        Event::RayEnd(RayEnd {
            verdict: RayVerdict::Hit,
            colour,
            ..RayEnd::default()
        })
    }

    #[track_caller]
    fn check(events: &[Event], cast: u64, contributed: u64) -> UsefulRays {
        let mut rays = UsefulRays::default();
        for event in events {
            rays.note(|| *event);
        }
        assert_eq!((rays.cast, rays.contributed()), (cast, contributed));
        rays
    }

    fn path(path: u32) -> Event {
        Event::Path(PathStart {
            path,
            ..PathStart::default()
        })
    }

    #[test]
    fn rays_from_the_eye_contribute_if_they_bring_a_colour_and_rays_to_a_light_if_it_adds() {
        let lit = |adds: f64| {
            let mut light = LightTerm::default();
            light.term.diffuse = DVec3::splat(adds);
            Event::LightTerm(light)
        };
        let events = [
            Event::Pixel(PixelSample::default()),
            ray(Purpose::Eye),
            ray(Purpose::Shadow),
            end(None),
            lit(0.5),
            ray(Purpose::Shadow),
            end(None),
            lit(0.0),
            ray(Purpose::Reflected),
            end(Some(DVec3::ZERO)),
            end(Some(DVec3::ONE)),
        ];
        // the eye ray and the first ray to a light
        check(&events, 4, 2);
    }

    #[test]
    fn of_a_path_that_the_eye_sees_the_legs_up_to_there_contribute() {
        let leg = [ray(Purpose::Light), end(None)];
        let seen = [
            ray(Purpose::Light),
            Event::Arrival(Arrival::default()),
            end(None),
        ];
        let events = [&[path(0)][..], &leg, &seen, &leg, &[path(1)], &leg].concat();
        check(&events, 4, 2);
    }

    #[test]
    fn of_the_photons_that_are_found_all_but_the_last_are_gathered() {
        let nearby = |path, surface| {
            Event::Nearby(Nearby {
                path,
                surface,
                ..Nearby::default()
            })
        };
        let gathered = Event::Gathered(Gathered {
            count: 2,
            ..Gathered::default()
        });
        // path 4 is used up to its third surface, path 7 only by the photon that does not count
        let events = [nearby(4, 3), nearby(4, 1), nearby(7, 2), gathered];
        check(&events, 0, 3);
    }

    #[test]
    fn a_line_uses_the_legs_to_both_its_ends_and_none_of_them_twice() {
        let line = |light_vertex, eye_vertex, adds: f64| {
            Event::Connection(Connection {
                path: 5,
                light_vertex,
                eye_vertex,
                contribution: DVec3::splat(adds),
                ..Connection::default()
            })
        };
        let pixel = Event::Pixel(PixelSample::default());
        let events = [pixel, line(0, 1, 1.0), line(2, 1, 1.0), line(3, 2, 0.0)];
        // two lines, two legs of light, one from the eye
        let mut all = check(&events, 0, 5);
        // another part that uses the same path up to its first surface
        let other = check(&[pixel, line(1, 1, 1.0)], 0, 3);
        all.add(&other);
        assert_eq!(all.contributed(), 7);
    }
}
