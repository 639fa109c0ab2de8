//! The first half of the transports that follow light: all paths of light, over threads, and what they leave.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use glam::DVec3;

use crate::parallel;
use crate::scene::Scene;
use crate::strategy::Strategy;
use crate::trace::{Event, LightOptions, Recorder, Region, Settings, Through, Transport};
use crate::tracer::eye::pixel::trace_pixel;
use crate::tracer::light::flat_face::Patch;
use crate::tracer::light::forward::Eye;
use crate::tracer::light::hybrid_stored::{StoredLight, StoredPhoton};
use crate::tracer::light::lamps::Lamps;
use crate::tracer::light::light_pass::{LightPass, place};
use crate::tracer::light::storing::Storing;
use crate::tracer::stopped::Stopped;
use crate::tracer::tracer::Tracer;

/// How many paths a thread follows at a time.
pub(in crate::tracer) const PIECE: u64 = 1024;

/// How many pieces are followed before their yield is put together: memory stays small, and the sums are made in
/// the order of the paths on any number of threads.
const PIECES: u64 = 64;

/// What some paths have left.
#[derive(Default)]
struct Yield {
    seen: Vec<Seen>,
    stored: Vec<(Patch, StoredPhoton)>,
}

/// A pixel has seen a path.
struct Seen {
    path: u32,
    pixel: [u32; 2],
    radiance: DVec3,
}

impl LightPass {
    /// Follows all paths of light, on the threads of the current pool; `None` if the transport follows none.
    ///
    /// Of the pixels in `region` it is remembered which paths they saw. `heard` is given what the recorders have
    /// heard, piece by piece in the order of the paths; `done` hears how many paths have been followed.
    ///
    /// # Errors
    /// A recorder that has enough.
    pub fn new<S: Strategy, R: Recorder + Default + Send>(
        scene: &Scene,
        strategy: &S,
        settings: &Settings,
        region: Option<Region>,
        mut heard: impl FnMut(R),
        done: impl Fn(u64),
    ) -> Result<Option<Self>, Stopped> {
        if !settings.transport.follows_light() {
            return Ok(None);
        }
        let tracer = Tracer::new(scene, strategy, settings.transport);
        let lamps = Lamps::new(scene, settings);
        let pixels = scene.camera.pixels;
        let mut seen = match settings.transport {
            Transport::Forward | Transport::HybridConnected => {
                vec![DVec3::ZERO; pixels[0] as usize * pixels[1] as usize]
            }
            _ => Vec::new(),
        };
        let mut stored = Vec::new();
        let mut reached = BTreeSet::new();

        let piece = |number: u64| {
            let mut left = Yield::default();
            let mut recorder = R::default();
            let first = number * PIECE;
            for path in first..(first + PIECE).min(lamps.paths) {
                let followed =
                    left.add(&tracer, &lamps, &settings.light, path as u32, &mut recorder);
                Stopped::unless_whole(followed, &recorder)?;
            }
            Ok((left, recorder))
        };
        let pieces = lamps.paths.div_ceil(PIECE);
        for first in (0..pieces).step_by(PIECES as usize) {
            let last = (first + PIECES).min(pieces);
            let together =
                parallel::map((last - first) as usize, |place| piece(first + place as u64));
            for traced in together {
                let (left, recorder) = traced?;
                for Seen {
                    path,
                    pixel,
                    radiance,
                } in left.seen
                {
                    seen[place(pixel, pixels)] += radiance;
                    if region.is_some_and(|region| region.contains(pixel)) {
                        reached.insert(path);
                    }
                }
                stored.extend(left.stored);
                heard(recorder);
            }
            done((last * PIECE).min(lamps.paths));
        }
        Ok(Some(Self {
            options: settings.light,
            lamps,
            pixels,
            seen,
            stored: StoredLight::new(scene, &settings.light, stored),
            reached,
        }))
    }
}

/// The paths of light that led to the colours of a region, in order: those that its pixels saw, those that their
/// gathered photons came on, and those that its own paths were connected to.
///
/// The light pass must have been made with the same region.
///
/// # Errors
/// A pixel that takes more rays than the tracer allows.
pub fn paths_behind<S: Strategy>(
    tracer: &Tracer<'_, S>,
    region: Region,
    through: Through,
) -> Result<BTreeSet<u32>, Stopped> {
    let Some(light) = tracer.light else {
        return Ok(BTreeSet::new());
    };
    let mut paths = light.reached.clone();
    if tracer.transport == Transport::Forward {
        return Ok(paths);
    }
    for y in region.from[1]..=region.to[1] {
        for x in region.from[0]..=region.to[0] {
            let mut behind = PathsBehind { paths: &mut paths };
            trace_pixel(tracer, [x, y], through, &mut behind)?;
        }
    }
    Ok(paths)
}

/// Hears which paths of light a pixel's colour comes from. A recorder.
struct PathsBehind<'a> {
    paths: &'a mut BTreeSet<u32>,
}

impl Recorder for PathsBehind<'_> {
    const ENABLED: bool = true;

    fn note(&mut self, event: impl FnOnce() -> Event) {
        match event() {
            Event::Nearby(photon) => self.paths.insert(photon.path),
            Event::Connection(connection) => self.paths.insert(connection.path),
            _ => return,
        };
    }
}

impl<S: Strategy> Tracer<'_, S> {
    /// Follows a path of light once more, with everything that happens on it.
    ///
    /// # Errors
    /// A recorder that has enough.
    pub fn trace_path<R: Recorder>(&self, path: u32, recorder: &mut R) -> Result<(), Stopped> {
        match self.light {
            Some(light) => {
                let mut left = Yield::default();
                let followed = left.add(self, &light.lamps, &light.options, path, recorder);
                Stopped::unless_whole(followed, recorder)
            }
            None => Ok(()),
        }
    }
}

impl Yield {
    /// Follows one path, and adds what it leaves.
    fn add<S: Strategy, R: Recorder>(
        &mut self,
        tracer: &Tracer<'_, S>,
        lamps: &Lamps,
        options: &LightOptions,
        path: u32,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        let camera = &tracer.scene.camera;
        match tracer.transport {
            // they follow no light
            Transport::Backward | Transport::HybridLight => {}
            Transport::Forward => {
                let mut eye = Eye::new(camera, options);
                tracer.follow_light(lamps, path, &mut eye, recorder)?;
                self.seen.extend(eye.arrivals.iter().map(|arrival| Seen {
                    path,
                    pixel: arrival.pixel,
                    radiance: arrival.radiance,
                }));
            }
            Transport::HybridStored => {
                let mut storing = Storing {
                    scene: tracer.scene,
                    path,
                    photons: std::mem::take(&mut self.stored),
                };
                tracer.follow_light(lamps, path, &mut storing, recorder)?;
                self.stored = storing.photons;
            }
            Transport::HybridConnected => {
                let lines = tracer.seen_by_the_eye(lamps, path, recorder)?;
                self.seen.extend(lines.iter().filter_map(|line| {
                    Some(Seen {
                        path,
                        pixel: line.pixel.filter(|_| line.visible)?,
                        radiance: line.contribution,
                    })
                }));
            }
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;
    use crate::scene::small_scene::{object, one_pixel, wall};
    use crate::strategy::Exhaustive;
    use crate::trace::{Counts, Off, Purpose};

    fn settings(transport: Transport, paths: u64) -> Settings {
        let mut settings = Settings {
            transport,
            ..Settings::default()
        };
        settings.light.paths = paths;
        settings
    }

    /// A white wall 5 ahead, and a lamp of 12 watts between it and the eye.
    fn lit_wall() -> Scene {
        one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,1,1],"diffuse":0.5}}}},
            "lights":[{{"position":[0,0,-3],"power":12}}],"objects":[{}]"#,
            object("wall", "m", &wall(-5.0))
        ))
    }

    #[test]
    fn a_pixel_s_place_counts_along_the_row_first() {
        assert_eq!(place([3, 2], [10, 5]), 23);
        assert_eq!(place([0, 0], [10, 5]), 0);
    }

    #[test]
    fn paths_are_followed_in_pieces_of_1024_and_64_of_them_at_a_time() {
        let scene = one_pixel(r#""lights":[{"position":[0,3,-1],"power":8}],"objects":[]"#);
        let strategy = Exhaustive::new(&scene);
        let paths = 64 * 1024 + 1;
        let done = RefCell::new(Vec::new());
        let mut heard = Vec::new();
        let pass = LightPass::new(
            &scene,
            &strategy,
            &settings(Transport::HybridStored, paths),
            None,
            |counts: Counts| heard.push(counts.of(Purpose::Light).traced),
            |paths| done.borrow_mut().push(paths),
        );
        assert!(pass.unwrap().is_some());
        assert_eq!(done.into_inner(), [65_536, 65_537]);
        assert_eq!(heard.len(), 65);
        assert!(heard[..64].iter().all(|&rays| rays == 1024));
        assert_eq!(heard[64], 1);
    }

    #[test]
    fn a_transport_that_follows_no_light_has_no_pass() {
        let scene = lit_wall();
        let strategy = Exhaustive::new(&scene);
        for transport in [Transport::Backward, Transport::HybridLight] {
            let pass = LightPass::new(
                &scene,
                &strategy,
                &settings(transport, 9),
                None,
                |_: Off| {},
                |_| {},
            );
            assert!(pass.unwrap().is_none());
        }
    }

    fn pass(scene: &Scene, settings: &Settings, region: Option<Region>) -> LightPass {
        let strategy = Exhaustive::new(scene);
        let pass = LightPass::new(scene, &strategy, settings, region, |_: Off| {}, |_| {});
        pass.unwrap().unwrap()
    }

    #[test]
    fn stored_photons_carry_their_share_and_lie_on_the_wall() {
        let scene = lit_wall();
        let light = pass(&scene, &settings(Transport::HybridStored, 2000), None);
        let photons: Vec<_> = light.stored().photons().collect();
        // half of the directions lead to the wall, which is large: 1000 ± 5·√500, and half of those that it scatters leave
        assert!((888..=1112).contains(&photons.len()), "{}", photons.len());
        for photon in &photons {
            assert_eq!((photon.power, photon.surface), (DVec3::splat(0.006), 1));
            assert!((photon.point.z + 5.0).abs() <= 1e-12);
        }
        // nothing is seen of the paths themselves
        assert_eq!(light.seen([0, 0]), DVec3::ZERO);
    }

    #[test]
    fn the_paths_behind_a_region_are_those_that_its_pixels_saw_or_gathered() {
        let scene = lit_wall();
        let strategy = Exhaustive::new(&scene);
        let whole = Region::whole([1, 1]);
        // the eye's aperture is as large as a window: many photons come in
        let mut forward = settings(Transport::Forward, 200);
        forward.light.aperture = Some(2.0);
        let light = pass(&scene, &forward, Some(whole));
        assert!(light.seen([0, 0]).cmpgt(DVec3::ZERO).all());
        let tracer = Tracer::new(&scene, &strategy, Transport::Forward).with_light(Some(&light));
        let behind = paths_behind(&tracer, whole, Through::Centres).unwrap();
        assert!(!behind.is_empty() && behind.iter().all(|&path| path < 200));
        assert!(pass(&scene, &forward, None).reached.is_empty());

        let mut stored = settings(Transport::HybridStored, 200);
        stored.light.nearest = 7;
        let light = pass(&scene, &stored, Some(whole));
        let tracer =
            Tracer::new(&scene, &strategy, Transport::HybridStored).with_light(Some(&light));
        let behind = paths_behind(&tracer, whole, Through::Centres).unwrap();
        // each path leaves one photon on the wall
        assert_eq!(behind.len(), 7);

        let mut connected = settings(Transport::HybridConnected, 0);
        connected.light.samples = 3;
        let light = pass(&scene, &connected, Some(whole));
        let tracer =
            Tracer::new(&scene, &strategy, Transport::HybridConnected).with_light(Some(&light));
        let behind = paths_behind(&tracer, whole, Through::Centres).unwrap();
        assert!(behind.into_iter().eq(0..3));
        let without = Tracer::new(&scene, &strategy, Transport::HybridConnected);
        assert!(
            paths_behind(&without, whole, Through::Centres)
                .unwrap()
                .is_empty()
        );
    }

    #[test]
    fn a_path_followed_once_more_notes_the_same_surfaces() {
        let scene = lit_wall();
        let strategy = Exhaustive::new(&scene);
        let light = pass(&scene, &settings(Transport::HybridStored, 50), None);
        let tracer =
            Tracer::new(&scene, &strategy, Transport::HybridStored).with_light(Some(&light));
        let mut stored = 0;
        for path in 0..50 {
            let mut counts = Counts::default();
            tracer.trace_path(path, &mut counts).unwrap();
            stored += counts.of(Purpose::Light).hits;
        }
        assert_eq!(stored as usize, light.stored().photons().count());
        assert!(0 < stored);
    }

    #[test]
    fn a_pixel_that_photons_come_into_sends_no_ray_and_shows_what_was_seen() {
        use crate::trace::Recording;
        let scene = crate::scene::small_scene::scene_of(&[]);
        let strategy = Exhaustive::new(&scene);
        let light = pass(&scene, &settings(Transport::Forward, 10), None);
        let tracer = Tracer::new(&scene, &strategy, Transport::Forward).with_light(Some(&light));
        let mut recording = Recording::new(Vec::new());
        let colour = trace_pixel(&tracer, [1, 0], Through::Corners, &mut recording).unwrap();
        assert_eq!(colour, light.seen([1, 0]));
        let records = recording.into_sink();
        let Event::Pixel(sample) = records[0].event else {
            panic!("{records:?}");
        };
        assert_eq!((sample.pixel, sample.samples), ([1, 0], 0));
        // the centre of the upper right pixel, half a unit from the middle of the window
        assert_eq!(sample.place.to_array(), [1.5, 0.5]);
        assert_eq!(sample.point, DVec3::new(0.5, 0.5, -1.0));
        assert_eq!(records.len(), 2);
    }

    #[test]
    fn what_the_wall_sends_through_a_large_aperture_is_seen_by_the_pixel() {
        let scene = lit_wall();
        let mut forward = settings(Transport::Forward, 200);
        forward.light.aperture = Some(2.0);
        let light = pass(&scene, &forward, None);
        assert_ne!(light.seen([0, 0]), DVec3::ZERO);
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::Forward).with_light(Some(&light));
        let shown = trace_pixel(&tracer, [0, 0], Through::Centres, &mut Off).unwrap();
        assert_eq!(shown, light.seen([0, 0]));
    }
}
