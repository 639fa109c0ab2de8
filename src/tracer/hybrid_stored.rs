//! Hybrid ray tracing with storage on surfaces: photons from the lamps are stored where they meet diffuse surfaces,
//! and what a ray from the eye meets shows the light that is stored around it.
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
use crate::trace::{Event, Gathered, LightOptions, Nearby, Recorder, Stored};
use crate::tracer::flat_face::{Patch, along, on_plane};
use crate::tracer::illumination_map::IlluminationMap;
use crate::tracer::surface::Surface;
use crate::tracer::walk::Watcher;

/// A photon that was stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoredPhoton {
    /// Where.
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
    pub(super) fn new(
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
    pub(super) fn gather<R: Recorder>(
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

/// Stores the photons of the path that is followed.
pub(super) struct Storing<'a> {
    pub(super) scene: &'a Scene,
    pub(super) path: u32,
    pub(super) photons: Vec<(Patch, StoredPhoton)>,
}

impl Watcher for Storing<'_> {
    fn met<R: Recorder>(
        &mut self,
        surface: &Surface<'_>,
        number: u32,
        power: DVec3,
        recorder: &mut R,
    ) {
        if surface.albedo() == DVec3::ZERO {
            return;
        }
        let photon = StoredPhoton {
            point: surface.point,
            normal: surface.across,
            power,
            path: self.path,
            surface: number,
        };
        recorder.note(|| {
            Event::Stored(Stored {
                object: surface.object,
                point: photon.point,
                normal: photon.normal,
                power,
            })
        });
        self.photons.push((Patch::of(self.scene, surface), photon));
    }
}

/// How much memory a photon takes while it is stored: in the order of the paths, and in the tree.
pub(super) fn bytes_per_photon() -> f64 {
    (size_of::<(Patch, StoredPhoton)>() + size_of::<StoredPhoton>() + 1) as f64
}
