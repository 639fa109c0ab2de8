//! Hybrid ray tracing with storage on surfaces: photons from the lamps are stored where they hit diffuse surfaces,
//! and what a ray from the eye hits shows the light that is stored around it.
//!
//! H. W. Jensen (1996), photon by photon: the irradiance at a point follows from its k nearest photons,
//!
//! E = Σ power / (π·r²) over the k − 1 nearest, with r the distance of the k-th
//!
//! The k-th itself is left out: the disc was chosen so that it ends there, and counting it would give k/(k − 1)
//! times too much on average. Near the edge of a flat face the disc's area is what it shares with the face. J. Arvo
//! (1986), cell by cell: the power that fell on a cell over its area.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use glam::DVec3;

use crate::geometry::disc_in_polygon;
use crate::scene::Scene;
use crate::structure::{Placed, PointTree};
use crate::trace::{Event, Gathered, LightOptions, Nearby, Recorder};
use crate::tracer::light::flat_face::{Patch, along, on_plane};
use crate::tracer::light::illumination_map::IlluminationMap;
use crate::tracer::surface::Surface;

/// A photon that was stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoredPhoton {
    /// The point on the surface, in world coordinates.
    pub point: DVec3,
    /// The unit normal of the surface, on the side that it came from.
    pub normal: DVec3,
    /// What it carries, in watts.
    pub power: DVec3,
    /// The path that it came on.
    pub path: u32,
    /// The number of the surface on that path, from 1.
    pub surface: u32,
}

impl Placed for StoredPhoton {
    fn place(&self) -> DVec3 {
        self.point
    }
}

/// On a curved surface, photons count that lie where it faces at most 60° away: what is behind an edge of a mesh
/// is lit otherwise.
const FACES_ALIKE: f64 = 0.5;

/// The light that is stored on the surfaces of a scene.
#[doc(alias = "photon map")]
#[doc(alias = "photon mapping")]
#[derive(Clone, Debug)]
pub struct StoredLight {
    nearest: usize,
    patches: BTreeMap<Patch, StoredOn>,
}

/// The light that is stored on one of them.
#[derive(Clone, Debug)]
enum StoredOn {
    Photons {
        tree: PointTree<StoredPhoton>,
        /// Of a flat face its corners.
        corners: Vec<DVec3>,
    },
    Map(IlluminationMap),
}

impl StoredLight {
    /// Stores photons; with a map on flat faces, if one is wanted.
    pub(in crate::tracer) fn new(
        scene: &Scene,
        options: &LightOptions,
        photons: Vec<(Patch, StoredPhoton)>,
    ) -> Self {
        let mut by_patch: BTreeMap<Patch, Vec<StoredPhoton>> = BTreeMap::new();
        for (patch, photon) in photons {
            by_patch.entry(patch).or_default().push(photon);
        }
        let store = |(patch, photons): (Patch, Vec<StoredPhoton>)| {
            let corners = patch.corners(scene);
            let stored = match (options.map, photons.first()) {
                (Some(cells), Some(first)) if !corners.is_empty() => {
                    let mut map = IlluminationMap::new(&corners, first.normal, cells);
                    for photon in &photons {
                        map.add(photon.point, photon.power);
                    }
                    StoredOn::Map(map)
                }
                _ => StoredOn::Photons {
                    tree: PointTree::new(photons),
                    corners,
                },
            };
            (patch, stored)
        };
        Self {
            nearest: options.nearest as usize,
            patches: by_patch.into_iter().map(store).collect(),
        }
    }

    /// The photons that are stored one by one, surface by surface.
    pub fn photons(&self) -> impl Iterator<Item = &StoredPhoton> {
        self.patches.values().flat_map(|stored| match stored {
            StoredOn::Photons { tree, .. } => tree.items(),
            StoredOn::Map(_) => &[],
        })
    }

    /// L: what a surface sends to the eye of the light that is stored around the point.
    pub(in crate::tracer) fn gather<R: Recorder>(
        &self,
        scene: &Scene,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> DVec3 {
        let albedo = surface.albedo();
        if albedo == DVec3::ZERO {
            return DVec3::ZERO;
        }
        let mut gathered = match self.patches.get(&Patch::of(scene, surface)) {
            None => Gathered::default(),
            Some(StoredOn::Map(map)) => gather_cell(map, surface),
            Some(StoredOn::Photons { tree, corners }) => {
                self.gather_photons(tree, corners, surface, recorder)
            }
        };
        gathered.object = surface.object;
        gathered.point = surface.point;
        gathered.radiance = albedo / PI * gathered.irradiance;
        recorder.note(|| Event::Gathered(gathered));
        gathered.radiance
    }

    fn gather_photons<R: Recorder>(
        &self,
        tree: &PointTree<StoredPhoton>,
        corners: &[DVec3],
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> Gathered {
        let across = surface.across;
        let faces_alike = |photon: &StoredPhoton| FACES_ALIKE <= photon.normal.dot(across);
        let found = tree.nearest(surface.point, self.nearest, faces_alike);
        let photons = found
            .iter()
            .map(|n| (&tree.items()[n.index as usize], n.distance_squared));
        for (photon, distance_squared) in photons.clone() {
            recorder.note(|| {
                Event::Nearby(Nearby {
                    path: photon.path,
                    surface: photon.surface,
                    point: photon.point,
                    power: photon.power,
                    distance: distance_squared.sqrt(),
                })
            });
        }
        let Some(farthest) = found.last() else {
            return Gathered::default();
        };
        let radius = farthest.distance_squared.sqrt();
        let area = if corners.is_empty() {
            PI * radius * radius
        } else {
            disc_in_polygon(radius, on_plane(corners, surface.point, along(across)))
        };
        let count = found.len() - 1;
        let power: DVec3 = photons.take(count).map(|(photon, _)| photon.power).sum();
        Gathered {
            count: count as u32,
            radius: Some(radius),
            area,
            irradiance: by_area(power, area),
            ..Gathered::default()
        }
    }
}

fn gather_cell(map: &IlluminationMap, surface: &Surface<'_>) -> Gathered {
    let cell = map.look_up(surface.point);
    Gathered {
        count: cell.count,
        area: cell.area,
        irradiance: by_area(cell.power, cell.area),
        ..Gathered::default()
    }
}

/// Nothing falls on no area.
fn by_area(power: DVec3, area: f64) -> DVec3 {
    if area == 0.0 {
        DVec3::ZERO
    } else {
        power / area
    }
}

/// How much memory a photon takes while it is stored: in the order of the paths, and in the tree.
pub(in crate::tracer) fn bytes_per_photon() -> f64 {
    (size_of::<(Patch, StoredPhoton)>() + size_of::<StoredPhoton>() + 1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{object, one_pixel, polygon, sphere, wall};
    use crate::strategy::Hit;
    use crate::trace::{Off, Recording};
    use crate::tracer::light::storing::Storing;
    use crate::tracer::light::walk::Watcher;

    fn scene(shape: &str, diffuse: f64) -> Scene {
        one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,0.5,0],"diffuse":{diffuse}}}}},"objects":[{}]"#,
            object("surface", "m", shape)
        ))
    }

    /// What the eye sees straight ahead, 5 away.
    fn ahead(scene: &Scene) -> Surface<'_> {
        let ray = Ray::new(DVec3::ZERO, DVec3::NEG_Z);
        let hit = Hit {
            object: PrimitiveId(0),
            t: 5.0,
        };
        let normals = scene.primitive(hit.object).shape.normals(ray.at(hit.t));
        Surface::new(scene, &ray, 1, hit, normals)
    }

    fn photon(beside: f64, power: f64, normal: DVec3) -> StoredPhoton {
        StoredPhoton {
            point: DVec3::new(beside, 0.0, -5.0),
            normal,
            power: DVec3::splat(power),
            path: 0,
            surface: 1,
        }
    }

    /// Stores photons where the eye looks, at these distances and with these powers, and gathers that many of them.
    fn gathered(scene: &Scene, photons: &[StoredPhoton], nearest: u32) -> (DVec3, Gathered) {
        let surface = ahead(scene);
        let patch = Patch::of(scene, &surface);
        let options = LightOptions {
            nearest,
            ..LightOptions::default()
        };
        let photons = photons.iter().map(|photon| (patch, *photon)).collect();
        let stored = StoredLight::new(scene, &options, photons);
        let mut recording = Recording::new(Vec::new());
        let radiance = stored.gather(scene, &surface, &mut recording);
        let records = recording.into_sink();
        match records.last().map(|record| record.event) {
            Some(Event::Gathered(gathered)) => (radiance, gathered),
            other => panic!("{other:?}"),
        }
    }

    #[track_caller]
    fn check(found: DVec3, expected: [f64; 3]) {
        let off = (found - DVec3::from(expected)).abs().max_element();
        assert!(off <= 1e-15, "{found}, expected {expected:?}");
    }

    fn row() -> [StoredPhoton; 4] {
        [3.0, -1.0, 2.0, 7.0].map(|x| photon(x, 4.0 + x, DVec3::Z))
    }

    #[test]
    fn the_power_of_all_but_the_farthest_is_divided_by_the_disc_up_to_that() {
        let scene = scene(&wall(-5.0), 0.5);
        // of the nearest three at 1, 2 and 3 the powers 3 and 6 count, over 9π; times ρ/π = (½, ¼, 0)/π
        let (radiance, found) = gathered(&scene, &row(), 3);
        assert_eq!((found.count, found.radius), (2, Some(3.0)));
        assert!((found.area - 9.0 * PI).abs() <= 1e-13, "{}", found.area);
        check(found.irradiance, [1.0 / PI; 3]);
        check(radiance, [0.5 / PI / PI, 0.25 / PI / PI, 0.0]);
        assert_eq!(
            (found.radiance, found.point),
            (radiance, DVec3::new(0.0, 0.0, -5.0))
        );
        // of two the nearest alone
        let (_, found) = gathered(&scene, &row(), 2);
        check(found.irradiance, [3.0 / (4.0 * PI); 3]);
        // there are only four
        let (_, found) = gathered(&scene, &row(), 50);
        assert_eq!((found.count, found.radius), (3, Some(7.0)));
    }

    #[test]
    fn beside_the_edge_of_a_face_the_disc_is_what_the_face_has_of_it() {
        let half = polygon(&[
            [0.0, -90.0, -5.0],
            [90.0, -90.0, -5.0],
            [90.0, 90.0, -5.0],
            [0.0, 90.0, -5.0],
        ]);
        let (_, found) = gathered(&scene(&half, 0.5), &row(), 3);
        assert!((found.area - 4.5 * PI).abs() <= 1e-13, "{}", found.area);
        check(found.irradiance, [2.0 / PI; 3]);
    }

    #[test]
    fn on_a_curved_surface_photons_count_that_face_at_most_60_degrees_away() {
        let ball = scene(&sphere([0.0, 0.0, -7.0], 2.0), 0.5);
        let leaning = |cosine: f64| DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
        let photons = [
            photon(0.5, 1.0, leaning(0.49)),
            photon(1.0, 2.0, leaning(0.5)),
            photon(2.0, 4.0, leaning(1.0)),
        ];
        let (_, found) = gathered(&ball, &photons, 3);
        assert_eq!((found.count, found.radius), (1, Some(2.0)));
        assert!((found.area - 4.0 * PI).abs() <= 1e-14);
        check(found.irradiance, [0.5 / PI; 3]);
    }

    #[test]
    fn where_nothing_is_stored_no_light_is_seen_and_a_black_surface_is_not_asked() {
        let (radiance, found) = gathered(&scene(&wall(-5.0), 0.5), &[], 3);
        assert_eq!(
            (radiance, found.radius, found.count),
            (DVec3::ZERO, None, 0)
        );
        // a single photon is the farthest itself, and on no area nothing falls
        let (radiance, _) = gathered(&scene(&wall(-5.0), 0.5), &[photon(2.0, 1.0, DVec3::Z)], 3);
        assert_eq!(radiance, DVec3::ZERO);
        let (radiance, found) =
            gathered(&scene(&wall(-5.0), 0.5), &[photon(0.0, 1.0, DVec3::Z)], 3);
        assert_eq!((radiance, found.area), (DVec3::ZERO, 0.0));
        let black = scene(&wall(-5.0), 0.0);
        let stored = StoredLight::new(&black, &LightOptions::default(), Vec::new());
        let mut recording = Recording::new(Vec::new());
        assert_eq!(
            stored.gather(&black, &ahead(&black), &mut recording),
            DVec3::ZERO
        );
        assert!(recording.into_sink().is_empty());
    }

    #[test]
    fn a_map_divides_what_fell_on_a_cell_by_its_area_on_flat_faces_alone() {
        let options = LightOptions {
            map: Some(10),
            ..LightOptions::default()
        };
        // ten cells of 2 along a square of 20: three photons in the cell from 0 to 2, one beside
        let square = polygon(&[
            [-10.0, -10.0, -5.0],
            [10.0, -10.0, -5.0],
            [10.0, 10.0, -5.0],
            [-10.0, 10.0, -5.0],
        ]);
        let at = |x: f64, power: f64| StoredPhoton {
            point: DVec3::new(x, 0.5, -5.0),
            ..photon(x, power, DVec3::Z)
        };
        let photons = [at(0.5, 1.0), at(1.5, 2.0), at(0.5, 5.0), at(-0.5, 9.0)];
        let scene = scene(&square, 1.0);
        let mut surface = ahead(&scene);
        surface.point = DVec3::new(1.0, 1.0, -5.0);
        let patch = Patch::of(&scene, &surface);
        let stored = photons.map(|photon| (patch, photon)).to_vec();
        let stored = StoredLight::new(&scene, &options, stored);
        assert_eq!(stored.photons().count(), 0);
        // 8 watts on 4 square units; ρ/π = (1, ½, 0)/π
        check(
            stored.gather(&scene, &surface, &mut Off),
            [2.0 / PI, 1.0 / PI, 0.0],
        );

        let ball = self::scene(&sphere([0.0, 0.0, -7.0], 2.0), 0.5);
        let patch = Patch::of(&ball, &ahead(&ball));
        let stored = StoredLight::new(&ball, &options, vec![(patch, photons[0])]);
        assert_eq!(stored.photons().count(), 1);
    }

    #[test]
    fn a_photon_is_stored_where_it_meets_a_surface_that_is_not_black() {
        for (diffuse, count) in [(0.5, 1), (0.0, 0)] {
            let scene = scene(&wall(-5.0), diffuse);
            let surface = ahead(&scene);
            let mut storing = Storing {
                scene: &scene,
                path: 7,
                photons: Vec::new(),
            };
            storing.met(&surface, 3, DVec3::splat(2.0), &mut Off);
            assert_eq!(storing.photons.len(), count);
            for (patch, photon) in storing.photons {
                assert_eq!(patch, Patch::of(&scene, &surface));
                assert_eq!((photon.path, photon.surface), (7, 3));
                assert_eq!((photon.point, photon.normal), (surface.point, DVec3::Z));
                assert_eq!(photon.power, DVec3::splat(2.0));
                assert_eq!(photon.place(), photon.point);
            }
        }
    }

    #[test]
    fn a_photon_takes_169_bytes_while_it_is_stored() {
        // nine coordinates of 8 bytes and two numbers of 4; once with a patch of 8, once in the tree with an axis of 1
        let photon = 9 * 8 + 2 * 4;
        assert_eq!(bytes_per_photon(), f64::from(photon + 8 + photon + 1));
    }
}
