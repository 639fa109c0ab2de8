//! A path from surface to surface, on which chance decides at each of them: for photons from a light, and for
//! paths from the eye.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, reflect};
use crate::strategy::{Hit, Strategy};
use crate::trace::{Event, Photon, PhotonVerdict, Purpose, RayEnd, RayStart, RayVerdict, Recorder};
use crate::tracer::light::chance::Chance;
use crate::tracer::surface::Surface;
use crate::tracer::tracer::Tracer;

/// A stretch of a path, from where it starts to where it hits something.
#[derive(Clone, Copy)]
pub(in crate::tracer) struct Leg {
    pub(in crate::tracer) ray: Ray,
    /// Where it ends; infinite if it hits nothing.
    pub(in crate::tracer) end: f64,
    /// What is carried along it.
    pub(in crate::tracer) power: DVec3,
    /// A surface has sent it on diffusely: it does not come straight from the lamp, nor by mirrors and glass alone.
    pub(in crate::tracer) is_scattered: bool,
}

/// Sees a path while it is followed.
pub(in crate::tracer) trait Watcher {
    /// A leg has been traced.
    fn leg<R: Recorder>(&mut self, leg: &Leg, recorder: &mut R) {
        let _ = (leg, recorder);
    }

    /// The path hits its `number`-th surface, counted from 1, carrying `power`.
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
    fn goes_on(&mut self, verdict: PhotonVerdict) {
        let _ = verdict;
    }
}

/// Sees nothing.
pub(in crate::tracer) struct NoWatcher;

impl Watcher for NoWatcher {}

impl<S: Strategy> Tracer<'_, S> {
    /// Follows a path until it leaves the scene, is absorbed, or has hit `most` surfaces. `Break` if the recorder has
    /// enough before.
    pub(in crate::tracer) fn walk<R: Recorder>(
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
                note_end(RayVerdict::Miss, None, recorder);
                break;
            };
            if surfaces == most {
                note_end(RayVerdict::CutOff, Some(hit), recorder);
                break;
            }

            let surface = self.surface(&start, hit);
            watcher.met(&surface, surfaces + 1, power, recorder);
            let (photon, refracted) = bounce(&surface, power, chance, recorder);
            let ends = photon.verdict == PhotonVerdict::Absorbed;
            let verdict = if ends {
                RayVerdict::Absorbed
            } else {
                RayVerdict::Hit
            };
            note_end(verdict, Some(hit), recorder);
            watcher.goes_on(photon.verdict);

            power = photon.leaving();
            let (direction, purpose) = match photon.verdict {
                PhotonVerdict::Absorbed => break,
                PhotonVerdict::Diffused => {
                    is_scattered = true;
                    (chance.around(surface.across), Purpose::Scattered)
                }
                PhotonVerdict::Mirrored => {
                    let mirrored = reflect(surface.incoming, surface.across);
                    (mirrored, Purpose::Reflected)
                }
                PhotonVerdict::Refracted => {
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
        verdict: PhotonVerdict::Diffused,
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
        photon.verdict = PhotonVerdict::Mirrored;
    } else if photon.chance < photon.reflection + photon.transmission {
        photon.verdict = PhotonVerdict::Refracted;
    } else if photon.leaving() == DVec3::ZERO {
        photon.verdict = PhotonVerdict::Absorbed;
    }
    recorder.note(|| Event::Photon(photon));
    (photon, behind)
}

fn note_end<R: Recorder>(verdict: RayVerdict, hit: Option<Hit>, recorder: &mut R) {
    recorder.note(|| {
        Event::RayEnd(RayEnd {
            verdict,
            object: hit.map(|hit| hit.object),
            t: hit.map(|hit| hit.t),
            ..RayEnd::default()
        })
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::TRange;
    use crate::scene::Scene;
    use crate::scene::small_scene::{object, one_pixel, polygon, wall};
    use crate::strategy::Exhaustive;
    use crate::trace::{Recording, Transport};

    /// Keeps what it sees of a path.
    #[derive(Default)]
    struct Seen {
        legs: Vec<Leg>,
        met: Vec<(u32, DVec3)>,
        verdicts: Vec<PhotonVerdict>,
    }

    impl Watcher for Seen {
        fn leg<R: Recorder>(&mut self, leg: &Leg, _: &mut R) {
            self.legs.push(*leg);
        }

        fn met<R: Recorder>(&mut self, _: &Surface<'_>, number: u32, power: DVec3, _: &mut R) {
            self.met.push((number, power));
        }

        fn goes_on(&mut self, verdict: PhotonVerdict) {
            self.verdicts.push(verdict);
        }
    }

    /// A wall 5 ahead of this material, and if there is another, one 5 behind of that.
    fn scene(ahead: &str, behind: Option<&str>) -> Scene {
        let mut objects = vec![object("ahead", "ahead", &wall(-5.0))];
        objects.extend(behind.map(|_| object("behind", "behind", &wall(5.0))));
        let behind = behind.unwrap_or(r#"{"colour":[1,1,1]}"#);
        one_pixel(&format!(
            r#""materials":{{"ahead":{ahead},"behind":{behind}}},"objects":[{}]"#,
            objects.join(",")
        ))
    }

    /// Follows a path from the origin along (0.6, 0, −0.8), with a power of 8, and gives what was seen and noted.
    fn walked(scene: &Scene, purpose: Purpose, most: u32) -> (Seen, Vec<Event>) {
        let strategy = Exhaustive::new(scene);
        let tracer = Tracer::new(scene, &strategy, Transport::HybridConnected);
        let start = RayStart {
            ray: Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, -0.8)),
            range: TRange::FORWARD,
            purpose,
            depth: 1,
            window_t: None,
            light: None,
        };
        let (mut seen, mut chance) = (Seen::default(), Chance::of_light(1, 0));
        let mut recording = Recording::new(Vec::new());
        let power = DVec3::splat(8.0);
        let end = tracer.walk(start, power, most, &mut chance, &mut seen, &mut recording);
        assert!(end.is_continue());
        let records = recording.into_sink();
        (
            seen,
            records.into_iter().map(|record| record.event).collect(),
        )
    }

    fn verdicts(events: &[Event]) -> Vec<RayVerdict> {
        let ends = events.iter().filter_map(|event| match event {
            Event::RayEnd(end) => Some(end.verdict),
            _ => None,
        });
        ends.collect()
    }

    fn purposes(events: &[Event]) -> Vec<Purpose> {
        let starts = events.iter().filter_map(|event| match event {
            Event::Ray(start) => Some(start.purpose),
            _ => None,
        });
        starts.collect()
    }

    const MIRROR: &str = r#"{"colour":[1,1,1],"reflection":1}"#;
    const WHITE: &str = r#"{"colour":[1,1,1],"diffuse":1}"#;
    const BLACK: &str = r#"{"colour":[0,0,0],"diffuse":1}"#;
    const GLASS: &str = r#"{"colour":[0,0,0],"transmission":1,"index":2}"#;

    #[test]
    fn a_mirror_sends_all_on_in_the_mirror_direction_and_scatters_nothing() {
        let (seen, events) = walked(&scene(MIRROR, None), Purpose::Eye, 9);
        let [first, second] = seen.legs[..] else {
            panic!("{:?}", verdicts(&events));
        };
        assert!((first.end - 6.25).abs() <= 1e-14 && second.end == f64::INFINITY);
        assert!((second.ray.direction - DVec3::new(0.6, 0.0, 0.8)).length() <= 1e-15);
        assert_eq!(
            (first.power, second.power),
            (DVec3::splat(8.0), DVec3::splat(8.0))
        );
        assert!(!first.is_scattered && !second.is_scattered);
        assert_eq!(seen.met, [(1, DVec3::splat(8.0))]);
        assert_eq!(seen.verdicts, [PhotonVerdict::Mirrored]);
        assert_eq!(verdicts(&events), [RayVerdict::Hit, RayVerdict::Miss]);
        assert_eq!(purposes(&events), [Purpose::Eye, Purpose::Reflected]);
        // what lets nothing through bends nothing
        let bends = |event: &Event| matches!(event, Event::Refraction(_));
        assert!(!events.iter().any(bends));
        // a photon from a lamp stays one
        let (_, events) = walked(&scene(MIRROR, None), Purpose::Light, 9);
        assert_eq!(purposes(&events), [Purpose::Light, Purpose::Light]);
    }

    #[test]
    fn a_white_wall_scatters_all_to_its_own_side_and_a_black_one_ends_the_path() {
        let (seen, events) = walked(&scene(WHITE, None), Purpose::Eye, 9);
        let [first, second] = seen.legs[..] else {
            panic!("{:?}", verdicts(&events));
        };
        assert!(!first.is_scattered && second.is_scattered);
        assert!(0.0 < second.ray.direction.z);
        assert_eq!(second.power, DVec3::splat(8.0));
        assert_eq!(purposes(&events), [Purpose::Eye, Purpose::Scattered]);
        let (seen, events) = walked(&scene(BLACK, None), Purpose::Eye, 9);
        assert_eq!((seen.legs.len(), seen.met.len()), (1, 1));
        assert_eq!(seen.verdicts, [PhotonVerdict::Absorbed]);
        assert_eq!(verdicts(&events), [RayVerdict::Absorbed]);
    }

    #[test]
    fn glass_changes_the_radiance_of_a_path_from_the_eye_and_not_the_power_of_a_photon() {
        // into glass of index 2: sin 0.6/2, and (1/2)² of the radiance
        for (purpose, power) in [(Purpose::Eye, 2.0), (Purpose::Light, 8.0)] {
            let (seen, _) = walked(&scene(GLASS, None), purpose, 9);
            let second = seen.legs[1];
            assert_eq!(second.power, DVec3::splat(power));
            assert!((second.ray.direction.x - 0.3).abs() <= 1e-15);
            assert!(second.ray.direction.z < 0.0 && !second.is_scattered);
            assert_eq!(seen.verdicts, [PhotonVerdict::Refracted]);
        }
    }

    #[test]
    fn light_that_cannot_leave_glass_is_mirrored() {
        // from the back of a pane of glass, where sin θ = 0.6 would become 1.2
        let pane = [
            [-9.0, 9.0, -5.0],
            [9.0, 9.0, -5.0],
            [9.0, -9.0, -5.0],
            [-9.0, -9.0, -5.0],
        ];
        let scene = one_pixel(&format!(
            r#""materials":{{"glass":{GLASS}}},"objects":[{}]"#,
            object("pane", "glass", &polygon(&pane))
        ));
        let (seen, events) = walked(&scene, Purpose::Eye, 9);
        assert_eq!(seen.verdicts, [PhotonVerdict::Mirrored]);
        assert!((seen.legs[1].ray.direction - DVec3::new(0.6, 0.0, 0.8)).length() <= 1e-15);
        let photon = events.iter().find_map(|event| match event {
            Event::Photon(photon) => Some((photon.reflection, photon.transmission)),
            _ => None,
        });
        assert_eq!(photon, Some((1.0, 0.0)));
    }

    #[test]
    fn a_path_is_cut_off_at_the_surface_after_the_last_that_it_may_meet() {
        let between = scene(MIRROR, Some(MIRROR));
        for most in [0, 1, 3] {
            let (seen, events) = walked(&between, Purpose::Eye, most);
            assert_eq!(seen.legs.len(), most as usize + 1);
            let numbers: Vec<_> = seen.met.iter().map(|met| met.0).collect();
            assert!(numbers.into_iter().eq(1..=most));
            assert_eq!(verdicts(&events).last(), Some(&RayVerdict::CutOff));
        }
    }

    #[test]
    fn chance_decides_in_proportion_to_the_coefficients() {
        // ¼ mirrored, ¼ refracted; of the channels 0.3, 0.15 and 0 scattered, by one number for all
        let scene = scene(
            r#"{"colour":[1,0.5,0],"diffuse":0.3,"reflection":0.25,"transmission":0.25}"#,
            None,
        );
        let ray = Ray::new(DVec3::ZERO, -DVec3::Z);
        let hit = Hit {
            object: crate::scene::PrimitiveId(0),
            t: 5.0,
        };
        let normals = scene.primitive(hit.object).shape.normals(ray.at(5.0));
        let surface = Surface::new(&scene, &ray, 1, hit, normals);
        let mut chance = Chance::of_light(1, 0);
        const COUNT: u32 = 4000;
        let (mut counts, mut both) = ([0_u32; 4], 0_u32);
        for _ in 0..COUNT {
            let (photon, _) = bounce(&surface, DVec3::ONE, &mut chance, &mut crate::trace::Off);
            let verdict = match photon.verdict {
                PhotonVerdict::Mirrored => 0,
                PhotonVerdict::Refracted => 1,
                PhotonVerdict::Diffused => 2,
                PhotonVerdict::Absorbed => 3,
            };
            counts[verdict] += 1;
            both +=
                u32::from(photon.verdict == PhotonVerdict::Diffused && photon.leaving().y == 1.0);
            assert_eq!(photon.diffuse, DVec3::new(0.3, 0.15, 0.0));
        }
        let [mirrored, refracted, scattered, absorbed] = counts;
        for (found, share) in [
            (mirrored, 0.25),
            (refracted, 0.25),
            (scattered, 0.3),
            (absorbed, 0.2),
            (both, 0.15),
        ] {
            // five deviations of the mean of that number of samples
            let deviation = (share * (1.0 - share) / f64::from(COUNT)).sqrt();
            let off = f64::from(found) / f64::from(COUNT) - share;
            assert!(off.abs() <= 5.0 * deviation, "{counts:?} {both}");
        }
    }
}
