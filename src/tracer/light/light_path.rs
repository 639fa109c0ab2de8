//! Paths of light: photons from the lamps, of which each carries the same power.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::strategy::Strategy;
use crate::trace::{Event, PathStart, Purpose, RayStart, Recorder};
use crate::tracer::epsilon::start_epsilon;
use crate::tracer::light::chance::Chance;
use crate::tracer::light::lamps::Lamps;
use crate::tracer::light::walk::Watcher;
use crate::tracer::tracer::Tracer;

/// How a path of light begins.
pub(in crate::tracer) struct LightStart {
    /// The light's position.
    pub(in crate::tracer) position: DVec3,
    /// What the photon carries.
    pub(in crate::tracer) power: DVec3,
}

impl<S: Strategy> Tracer<'_, S> {
    /// Follows one path of light: from a light in a random direction, and on from surface to surface. A scene
    /// without lights has none.
    pub(in crate::tracer) fn follow_light<R: Recorder>(
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::small_scene::one_pixel;
    use crate::strategy::Exhaustive;
    use crate::trace::Settings;
    use crate::trace::{Off, Recording, Transport};
    use crate::tracer::light::lamps::MOST_SURFACES;
    use crate::tracer::light::walk::NoWatcher;

    fn settings(paths: u64, bounces: Option<u32>) -> Settings {
        let mut settings = Settings {
            transport: Transport::Forward,
            ..Settings::default()
        };
        settings.light.paths = paths;
        settings.light.bounces = bounces;
        settings
    }

    /// A lamp without a power, one of 1 watt, one of 3 and another without.
    fn four_lamps() -> Scene {
        one_pixel(
            r#""lights":[{"position":[1,0,0],"colour":[1,1,1]},{"position":[2,0,0],"power":1},
            {"position":[0,-4,0],"power":3},{"position":[0,0,5],"colour":[1,1,1]}],"objects":[]"#,
        )
    }

    #[test]
    fn each_photon_carries_the_same_share_of_the_power_of_all_lights() {
        let lamps = Lamps::new(&four_lamps(), &settings(8, None));
        assert_eq!(lamps.up_to, [0.0, 1.0, 4.0, 4.0]);
        assert_eq!((lamps.photon, lamps.paths), (0.5, 8));
        // without a path there is nothing to divide by
        assert_eq!(Lamps::new(&four_lamps(), &settings(0, None)).photon, 4.0);
    }

    #[test]
    fn a_path_meets_as_many_surfaces_as_are_asked_for_up_to_the_most() {
        let most = |bounces| Lamps::new(&four_lamps(), &settings(8, bounces)).most;
        assert_eq!(
            [None, Some(3), Some(20_000)].map(most),
            [MOST_SURFACES, 3, MOST_SURFACES]
        );
    }

    #[test]
    fn a_light_is_chosen_in_proportion_to_its_power_and_one_without_power_never() {
        let lamps = Lamps::new(&four_lamps(), &settings(8, None));
        let mut chance = Chance::of_light(1, 0);
        let mut counts = [0; 4];
        for _ in 0..4000 {
            counts[lamps.choose(&mut chance)] += 1;
        }
        assert_eq!((counts[0], counts[3]), (0, 0));
        // 3000 ± 5·√(4000·¾·¼)
        assert!((2863..=3137).contains(&counts[2]), "{counts:?}");
        let only = one_pixel(r#""lights":[{"position":[2,0,0],"power":1}],"objects":[]"#);
        assert_eq!(Lamps::new(&only, &settings(8, None)).choose(&mut chance), 0);
    }

    #[test]
    fn a_path_begins_at_its_light_a_billionth_of_its_coordinate_away() {
        let scene = four_lamps();
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::Forward);
        let lamps = Lamps::new(&scene, &settings(8, None));
        let positions = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, -4.0, 0.0]].map(DVec3::from);
        for path in 0..8 {
            let mut recording = Recording::new(Vec::new());
            let followed = tracer.follow_light(&lamps, path, &mut NoWatcher, &mut recording);
            let ControlFlow::Continue(Some(begun)) = followed else {
                panic!("nobody has enough");
            };
            assert_eq!(begun.power, DVec3::splat(0.5));
            let records = recording.into_sink();
            let [Event::Path(of), Event::Ray(ray), Event::RayEnd(_)] =
                [0, 1, 2].map(|at: usize| records[at].event)
            else {
                panic!("{records:?}");
            };
            assert_eq!((of.path, of.paths, of.power), (path, 8, DVec3::splat(0.5)));
            let position = positions[of.light as usize];
            assert_eq!((begun.position, ray.ray.origin), (position, position));
            assert_eq!(
                (ray.light, ray.depth, ray.purpose),
                (Some(of.light), 1, Purpose::Light)
            );
            let epsilon = 1e-9 * position.abs().max_element();
            assert!((ray.range.min - epsilon).abs() <= 1e-24 && ray.range.max == f64::INFINITY);
            assert!((ray.ray.direction.length() - 1.0).abs() <= 1e-15);
        }
        let dark = one_pixel(r#""objects":[]"#);
        let tracer = Tracer::new(&dark, &strategy, Transport::Forward);
        let lamps = Lamps::new(&dark, &settings(8, None));
        let followed = tracer.follow_light(&lamps, 0, &mut NoWatcher, &mut Off);
        assert!(matches!(followed, ControlFlow::Continue(None)));
    }

    #[test]
    fn of_two_lights_either_is_chosen() {
        let two = one_pixel(
            r#""lights":[{"position":[2,0,0],"power":1},{"position":[0,-4,0],"power":1}],"objects":[]"#,
        );
        let lamps = Lamps::new(&two, &settings(8, None));
        let mut chance = Chance::of_light(1, 0);
        let second = (0..1000).filter(|_| lamps.choose(&mut chance) == 1).count();
        // 500 ± 5·√250
        assert!((421..=579).contains(&second), "{second}");
    }
}
