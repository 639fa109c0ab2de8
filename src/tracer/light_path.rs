//! Paths of light: photons from the lamps, of which each carries the same power.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::scene::{Emission, Scene};
use crate::strategy::Strategy;
use crate::trace::{Event, PathStart, Purpose, RayStart, Recorder, Settings};
use crate::tracer::Tracer;
use crate::tracer::chance::Chance;
use crate::tracer::epsilon::start_epsilon;
use crate::tracer::walk::{MOST_SURFACES, Watcher};

/// The lights of a scene, as photons are sent out from them.
#[derive(Clone, Debug, Default)]
pub(super) struct Lamps {
    seed: u64,
    /// How many paths there are.
    pub(super) paths: u64,
    /// For each light the power of it and of all before, in watts.
    up_to: Vec<f64>,
    /// What a photon carries: the power of all lights over the number of paths.
    pub(super) photon: f64,
    /// How many surfaces a path may meet.
    pub(super) most: u32,
}

impl Lamps {
    /// The lights of a scene; one without a power sends out nothing.
    pub(super) fn new(scene: &Scene, settings: &Settings) -> Self {
        let paths = settings.light_paths(scene.camera.pixels);
        let mut sum = 0.0;
        let up_to: Vec<f64> = scene
            .lights
            .iter()
            .map(|light| {
                if let Emission::Power(power) = light.emission {
                    sum += power;
                }
                sum
            })
            .collect();
        let options = &settings.light;
        Self {
            seed: options.seed,
            paths,
            up_to,
            photon: sum / paths.max(1) as f64,
            most: options
                .bounces
                .map_or(MOST_SURFACES, |most| most.min(MOST_SURFACES)),
        }
    }

    /// A light, with a chance in proportion to its power.
    fn choose(&self, chance: &mut Chance) -> usize {
        if self.up_to.len() < 2 {
            return 0;
        }
        let all = self.up_to.last().copied().unwrap_or_default();
        let place = chance.number() * all;
        self.up_to
            .partition_point(|&up_to| up_to <= place)
            .min(self.up_to.len() - 1)
    }
}

/// How a path of light begins.
pub(super) struct LightStart {
    /// The light's position.
    pub(super) position: DVec3,
    /// What the photon carries.
    pub(super) power: DVec3,
}

impl<S: Strategy> Tracer<'_, S> {
    /// Follows one path of light: from a light in a direction of chance, and on from surface to surface. A scene
    /// without lights has none.
    pub(super) fn follow_light<R: Recorder>(
        &self,
        lamps: &Lamps,
        path: u32,
        watcher: &mut impl Watcher,
        recorder: &mut R,
    ) -> ControlFlow<(), Option<LightStart>> {
        let mut chance = Chance::of_light(lamps.seed, path);
        let number = lamps.choose(&mut chance);
        let Some(light) = self.scene.lights.get(number) else {
            return ControlFlow::Continue(None);
        };
        let power = DVec3::splat(lamps.photon);
        recorder.note(|| {
            Event::Path(PathStart {
                path,
                paths: lamps.paths as u32,
                light: number as u32,
                power,
            })
        });
        let start = RayStart {
            ray: Ray::new(light.position, chance.direction()),
            range: TRange {
                // a light in a surface shines away from it
                min: start_epsilon(light.position, 0.0, 0.0),
                max: f64::INFINITY,
            },
            purpose: Purpose::Light,
            depth: 1,
            window_t: None,
            light: Some(number as u32),
        };
        self.walk(start, power, lamps.most, &mut chance, watcher, recorder)?;
        ControlFlow::Continue(Some(LightStart {
            position: light.position,
            power,
        }))
    }
}
