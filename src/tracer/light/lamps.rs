//! The lights of a scene, as photons are emitted from them.

use crate::scene::{Emission, Scene};
use crate::trace::Settings;
use crate::tracer::light::chance::Chance;

/// How many surfaces a path may hit at most. A photon between surfaces that absorb nothing would go on for ever;
/// where they absorb a thousandth, one in 20 000 is still on its way here.
pub const MOST_SURFACES: u32 = 10_000;

/// The lights of a scene, as photons are sent out from them.
#[derive(Clone, Debug, Default)]
pub(in crate::tracer) struct Lamps {
    pub(super) seed: u64,
    /// How many paths there are.
    pub(in crate::tracer) paths: u64,
    /// For each light the power of it and of all before, in watts.
    pub(super) up_to: Vec<f64>,
    /// What a photon carries: the power of all lights over the number of paths.
    pub(in crate::tracer) photon: f64,
    /// How many surfaces a path may hit.
    pub(in crate::tracer) most: u32,
}

impl Lamps {
    /// The lights of a scene; one without a power sends out nothing.
    pub(in crate::tracer) fn new(scene: &Scene, settings: &Settings) -> Self {
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
    pub(super) fn choose(&self, chance: &mut Chance) -> usize {
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
