//! Where a ray hits a surface: the normal, the angles to it on both sides, and what that means in words.

use glam::DVec3;

use crate::figure::parts::angle::{Angle, degrees};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Refraction, reflect};
use crate::trace::{Event, Item, RayNode, Record, Shade};

/// How long a normal is, in units of a book's sheet.
const NORMAL: f64 = 78.0;
/// The radius of an angle's arc, likewise: a label between two lines at 25° has room beyond it.
const ARC: f64 = 46.0;

/// What was recorded where a ray hit a surface.
struct Met<'a> {
    record: &'a Record,
    shade: &'a Shade,
    /// If light passes the surface.
    refraction: Option<&'a Refraction>,
    /// Δ of the ray.
    direction: DVec3,
}

impl<'a> Met<'a> {
    fn find(records: &'a [Record], node: &RayNode) -> Option<Self> {
        let mut found = None;
        let mut refraction = None;
        for item in &node.items {
            let Item::Event(at) = item else {
                continue;
            };
            match &records[*at].event {
                Event::Refraction(of) => refraction = Some(of),
                Event::Shade(shade) => found = Some((&records[*at], shade)),
                _ => {}
            }
        }
        let (record, shade) = found?;
        Some(Self {
            record,
            shade,
            refraction,
            direction: node.start?.ray.direction,
        })
    }

    /// Is a ray spawned here?
    fn sends_on(&self) -> bool {
        0.0 < self.shade.reflection || 0.0 < self.shade.transmission
    }

    /// cos θ₁ between the ray and the normal.
    fn cosine(&self) -> f64 {
        self.refraction.map_or_else(
            || -self.direction.dot(self.shade.normal),
            |refraction| refraction.cos_incident,
        )
    }
}

/// Draws the normal where a ray hit a surface, and the angles to it. A surface that spawns no ray is left alone
/// where others do.
pub(in crate::figure) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    records: &[Record],
    node: &RayNode,
) {
    let Some(met) = Met::find(records, node) else {
        return;
    };
    if figure.shows(Layer::Secondary) && !met.sends_on() {
        return;
    }
    sheet.step(met.record.step, |sheet| {
        let at = space.place(met.shade.point);
        if figure.shows(Layer::Normals) {
            let along = space.direction(met.shade.normal);
            let reach = NORMAL * sheet.unit() * along;
            sheet.arrow(Look::THIN.wide(1.25), at, at + reach);
            sheet.label(space.frame, at + reach, along, "N");
            if met.refraction.is_some_and(|of| of.direction.is_some()) {
                sheet.line(Look::HELP, at, at - reach);
            }
        }
        if figure.shows(Layer::Angles) {
            angles(sheet, space, &met);
        }
    });
}

fn angles(sheet: &mut Sheet, space: &Space, met: &Met) {
    let at = space.place(met.shade.point);
    let normal = met.shade.normal;
    let mut angle = |between: [DVec3; 2], cosine: f64| {
        let angle = Angle {
            at,
            between: between.map(|of| space.direction(of)),
            radius: ARC,
        };
        angle.draw(sheet, space.frame, degrees(cosine));
    };
    angle([normal, -met.direction], met.cosine());
    if 0.0 < met.shade.reflection {
        angle([normal, reflect(met.direction, normal)], met.cosine());
    }
    if let Some(refraction) = met.refraction
        && let Some(direction) = refraction.direction
    {
        let cosine = refraction.cos_refracted_squared.max(0.0).sqrt();
        angle([-normal, direction], cosine);
    } else if let Some(refraction) = met.refraction {
        let text = format!(
            "{} > critical angle {}°",
            degrees(met.cosine()),
            quantity(critical_angle(refraction)),
        );
        sheet.label(space.frame, at, space.direction(-normal), text);
    }
}

/// In degrees: there sin θ₁ = n₂/n₁, and θ₂ is a right angle.
fn critical_angle(refraction: &Refraction) -> f64 {
    libm::asin(refraction.index_to / refraction.index_from).to_degrees()
}

/// What the surface does to the ray, if it spawns one.
pub(in crate::figure) fn in_words(records: &[Record], node: &RayNode) -> Option<String> {
    let met = Met::find(records, node)?;
    let incident = degrees(met.cosine());
    let Some(refraction) = met.refraction else {
        let is_mirror = 0.0 < met.shade.reflection;
        return is_mirror.then(|| {
            format!(
                "The ray comes in at {incident} to the normal N and is reflected at {incident}."
            )
        });
    };
    let (from, to) = (refraction.index_from, refraction.index_to);
    let indices = format!("from index {} to {}", quantity(from), quantity(to));
    Some(if refraction.direction.is_some() {
        let behind = degrees(refraction.cos_refracted_squared.max(0.0).sqrt());
        format!("The ray goes {indices}: {incident} to the normal N before, {behind} after.")
    } else {
        let critical = quantity(critical_angle(refraction));
        format!(
            "The ray would go {indices}, but {incident} to the normal N is beyond the critical angle of {critical}°: \
             total internal reflection."
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::refract;

    #[test]
    fn the_critical_angle_of_glass_is_41_81_degrees() {
        // sin θ = 2/3; from 60° inside nothing leaves
        let direction = DVec3::new(3f64.sqrt() / 2.0, -0.5, 0.0);
        let refraction = refract(direction, DVec3::Y, 1.5, 1.0);
        assert_eq!(refraction.direction, None);
        assert_eq!(quantity(critical_angle(&refraction)), "41.81");
    }
}
