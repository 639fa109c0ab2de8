//! The stages of the argument that a z sort finds the closest object on a ray that is the z axis.

use crate::explain::Part;
use crate::figure::kinds::alignment::laid::Laid;
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::stage::StageId;
use crate::figure::subject::Figure;
use glam::DVec3;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) ray: StageId,
    pub(super) frame: StageId,
    pub(super) points: StageId,
    pub(super) sort: StageId,
    pub(super) nearest: StageId,
}

impl Argument {
    pub(super) fn new(figure: &Figure, sheet: &mut Sheet, laid: &Laid) -> Self {
        let points = laid.points.iter().map(|(_, step)| *step);
        let points = points.max().unwrap_or(laid.step);
        let sorted = laid.sorted.iter().map(|(_, step)| *step);
        let sorted = sorted.max().unwrap_or(points).max(points);
        let hits = laid.sorted.iter().map(|(hit, _)| {
            let name = scenery::name_of(figure.scene, hit.object);
            format!("{name} at {}", quantity(hit.z))
        });
        let hits: Vec<String> = hits.collect();
        let (sort, nearest) = match laid.sorted.first() {
            None => (
                "No object is hit at x = y = 0.".into(),
                "The ray hits nothing.".into(),
            ),
            Some((hit, _)) => (
                format!(
                    "All hits are at x = y = 0, and they are sorted by z: {}.",
                    hits.join(", ")
                ),
                format!(
                    "The smallest z is that of {}, the closest object, and M⁻¹ turns its point back into {}.",
                    scenery::name_of(figure.scene, hit.object),
                    coordinates(laid.frame.back(DVec3::new(0.0, 0.0, hit.z)))
                ),
            ),
        };
        Self {
            ray: sheet.stage(
                Part::Ray,
                laid.starts,
                format!("The ray starts at {}.", coordinates(laid.ray.origin)),
            ),
            frame: sheet.stage(
                Part::Alignment,
                laid.step,
                "M moves that point into the origin and turns the ray into the z axis.",
            ),
            points: sheet.stage(
                Part::AlignedPoint,
                points,
                "The points of the objects are transformed in the same way.",
            ),
            sort: sheet.stage(Part::ZSort, sorted, sort),
            nearest: sheet.stage(Part::Nearest, sorted, nearest),
        }
    }
}
