//! A path from surface to surface, on which chance decides at each of them: for photons from a light, and for
//! paths from the eye.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, reflect};
use crate::strategy::{Hit, Strategy};
use crate::trace::{Event, Outcome, Photon, PhotonFate, Purpose, RayEnd, RayStart, Recorder};
use crate::tracer::Tracer;
use crate::tracer::chance::Chance;
use crate::tracer::surface::Surface;

/// How many surfaces a path may meet at most. A photon between surfaces that absorb nothing would go on for ever;
/// where they absorb a thousandth, one in 20 000 is still on its way here.
pub const MOST_SURFACES: u32 = 10_000;

/// A stretch of a path, from where it starts to where it meets something.
#[derive(Clone, Copy)]
pub(super) struct Leg {
    pub(super) ray: Ray,
    /// Where it ends; infinite if it meets nothing.
    pub(super) end: f64,
    /// What is carried along it.
    pub(super) power: DVec3,
    /// A surface has sent it on diffusely: it does not come straight from the lamp, nor by mirrors and glass alone.
    pub(super) is_scattered: bool,
}

/// Sees a path while it is followed.
pub(super) trait Watcher {
    /// A leg has been traced.
    fn leg<R: Recorder>(&mut self, leg: &Leg, recorder: &mut R) {
        let _ = (leg, recorder);
    }

    /// A surface is met, the so-manieth of the path from 1, by what is carried there.
    fn met<R: Recorder>(
        &mut self,
        surface: &Surface<'_>,
        number: u32,
        power: DVec3,
        recorder: &mut R,
    ) {
        let _ = (surface, number, power, recorder);
    }

    /// Chance has decided how the path goes on from there.
    fn goes_on(&mut self, fate: PhotonFate) {
        let _ = fate;
    }
}

/// Sees nothing.
pub(super) struct NoWatcher;

impl Watcher for NoWatcher {}

impl<S: Strategy> Tracer<'_, S> {
    /// Follows a path until it leaves the scene, is absorbed, or has met `most` surfaces. `Break` if the recorder has
    /// enough before.
    pub(super) fn walk<R: Recorder>(
        &self,
        mut start: RayStart,
        mut power: DVec3,
        most: u32,
        chance: &mut Chance,
        watcher: &mut impl Watcher,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let mut is_scattered = false;
        for surfaces in 0..=most {
            recorder.next_ray()?;
            recorder.note(|| Event::Ray(start));
            let hit = self.strategy.nearest(&start.ray, start.range, recorder);
            let leg = Leg {
                ray: start.ray,
                end: hit.map_or(f64::INFINITY, |hit| hit.t),
                power,
                is_scattered,
            };
            watcher.leg(&leg, recorder);
            let Some(hit) = hit else {
                note_end(Outcome::Miss, None, recorder);
                break;
            };
            if surfaces == most {
                note_end(Outcome::CutOff, Some(hit), recorder);
                break;
            }

            let surface = self.surface(&start, hit);
            watcher.met(&surface, surfaces + 1, power, recorder);
            let (photon, refracted) = bounce(&surface, power, chance, recorder);
            let ends = photon.fate == PhotonFate::Absorbed;
            let outcome = if ends {
                Outcome::Absorbed
            } else {
                Outcome::Hit
            };
            note_end(outcome, Some(hit), recorder);
            watcher.goes_on(photon.fate);

            power = photon.leaving();
            let (direction, purpose) = match photon.fate {
                PhotonFate::Absorbed => break,
                PhotonFate::Diffused => {
                    is_scattered = true;
                    (chance.around(surface.across), Purpose::Scattered)
                }
                PhotonFate::Mirrored => {
                    let mirrored = reflect(surface.incoming, surface.across);
                    (mirrored, Purpose::Reflected)
                }
                PhotonFate::Refracted => {
                    // what a photon carries is power; what is seen along a ray from the eye is radiance
                    if start.purpose != Purpose::Light {
                        power *= refracted.factor;
                    }
                    (refracted.direction, Purpose::Refracted)
                }
            };
            let purpose = match start.purpose {
                Purpose::Light => Purpose::Light,
                _ => purpose,
            };
            start = surface.sends(direction, purpose);
        }
        ControlFlow::Continue(())
    }
}

/// How a path goes on behind a surface, if it does.
#[derive(Default)]
struct Refracted {
    direction: DVec3,
    /// What it does to radiance.
    factor: f64,
}

/// Chance decides what becomes of a photon at a surface: one number for all channels.
fn bounce<R: Recorder>(
    surface: &Surface<'_>,
    power: DVec3,
    chance: &mut Chance,
    recorder: &mut R,
) -> (Photon, Refracted) {
    let material = surface.material;
    let mut photon = Photon {
        object: surface.object,
        point: surface.point,
        power,
        chance: chance.number(),
        reflection: material.reflection,
        transmission: material.transmission,
        diffuse: surface.albedo(),
        fate: PhotonFate::Diffused,
    };
    let mut behind = Refracted::default();
    if 0.0 < photon.transmission {
        let refraction = surface.refraction(surface.across, recorder);
        match refraction.direction {
            Some(direction) => {
                behind = Refracted {
                    direction,
                    factor: refraction.radiance_factor(),
                };
            }
            // a photon that cannot pass is mirrored
            None => photon.reflection += std::mem::take(&mut photon.transmission),
        }
    }
    if photon.chance < photon.reflection {
        photon.fate = PhotonFate::Mirrored;
    } else if photon.chance < photon.reflection + photon.transmission {
        photon.fate = PhotonFate::Refracted;
    } else if photon.leaving() == DVec3::ZERO {
        photon.fate = PhotonFate::Absorbed;
    }
    recorder.note(|| Event::Photon(photon));
    (photon, behind)
}

fn note_end<R: Recorder>(outcome: Outcome, hit: Option<Hit>, recorder: &mut R) {
    recorder.note(|| {
        Event::RayEnd(RayEnd {
            outcome,
            object: hit.map(|hit| hit.object),
            t: hit.map(|hit| hit.t),
            ..RayEnd::default()
        })
    });
}
