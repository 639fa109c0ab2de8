//! The photons of a path, stored where they land.

use glam::DVec3;

use crate::scene::Scene;
use crate::trace::{Event, Recorder, Stored};
use crate::tracer::light::flat_face::Patch;
use crate::tracer::light::hybrid_stored::StoredPhoton;
use crate::tracer::light::walk::Watcher;
use crate::tracer::surface::Surface;

/// Stores the photons of the path that is followed.
pub(in crate::tracer) struct Storing<'a> {
    pub(in crate::tracer) scene: &'a Scene,
    pub(in crate::tracer) path: u32,
    pub(in crate::tracer) photons: Vec<(Patch, StoredPhoton)>,
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
