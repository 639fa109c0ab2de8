//! Where a ray hits a surface: the normal, the angles to it on both sides, and what that means in words.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::parts::angle::{Angle, degrees};
use crate::figure::parts::outline::Outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::{StageId, StageName};
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Ray, Refraction, reflect};
use crate::scene::Object;
use crate::trace::{Event, Item, Purpose, RayNode, Record, Shade};

/// How long a normal is, in units of a book's sheet.
const NORMAL: f64 = 78.0;
/// The radius of an angle's arc, likewise: a label between two lines at 25° has room beyond it.
const ARC: f64 = 46.0;

/// What was recorded where a ray hit a surface.
pub(in crate::figure) struct Met<'a> {
    pub(in crate::figure) record: &'a Record,
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

    /// Where a ray hit a surface whose normal or angles are shown. A surface that spawns no ray is left alone where others
    /// do.
    pub(in crate::figure) fn shown(
        figure: &Figure,
        records: &'a [Record],
        node: &RayNode,
    ) -> Option<Self> {
        let shows = figure.shows(Layer::Normals) || figure.shows(Layer::Angles);
        let met = Self::find(records, node).filter(|_| shows)?;
        (!figure.shows(Layer::Secondary) || met.sends_on()).then_some(met)
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

impl Met<'_> {
    pub(in crate::figure) fn stage_name(&self) -> StageName {
        match self.refraction {
            Some(_) => Part::Snell.into(),
            None => Part::Normal.into(),
        }
    }

    pub(in crate::figure) fn stage_sentence(&self) -> String {
        let incident = degrees(self.cosine());
        match self.refraction {
            None => format!("The ray comes in at {incident} to the normal N."),
            Some(of) if of.direction.is_some() => format!(
                "By Snell's law {}·sin {incident} = {}·sin {}.",
                quantity(of.index_from),
                quantity(of.index_to),
                behind(of)
            ),
            Some(of) => format!(
                "{incident} is more than the critical angle {}°: total internal reflection.",
                quantity(critical_angle(of))
            ),
        }
    }

    /// Snell's law with the numbers of this surface, where a ray passes it.
    pub(in crate::figure) fn law(&self) -> Option<Law> {
        let of = self.refraction.filter(|of| of.direction.is_some())?;
        Some(Law {
            indices: [of.index_from, of.index_to],
            angles: [degrees(self.cosine()), behind(of)],
        })
    }

    /// Does the surface reflect all that comes from inside?
    pub(in crate::figure) fn is_total(&self) -> bool {
        self.refraction.is_some_and(|of| of.direction.is_none())
    }

    /// Draws the normal where the ray hit the surface, and the ray's angle to it. `named` holds what has its name already.
    pub(in crate::figure) fn draw(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        space: &Space,
        (stage, law): (StageId, Option<&Law>),
        named: &mut Vec<&'static str>,
    ) {
        let at = space.place(self.shade.point);
        sheet.at(stage, |sheet| {
            if figure.shows(Layer::Normals) {
                let along = space.direction(self.shade.normal);
                let reach = NORMAL * sheet.unit() * along;
                sheet.arrow(Look::THIN.wide(1.25), at, at + reach);
                if !named.contains(&"N") {
                    named.push("N");
                    sheet.label(space.frame, at + reach, along, formula("N"));
                }
                if self.refraction.is_some_and(|of| of.direction.is_some()) {
                    sheet.line(Look::HELP, at, at - reach);
                }
            }
            if !figure.shows(Layer::Angles) {
                return;
            }
            let incoming = [self.shade.normal, -self.direction];
            angle(
                sheet,
                space,
                self.shade.point,
                (incoming, self.cosine()),
                law,
            );
            let Some(refraction) = self.refraction else {
                return;
            };
            if refraction.direction.is_none() {
                self.beyond_critical(sheet, space, refraction);
            }
        });
    }

    /// Draws how the ray would go on without the surface.
    pub(in crate::figure) fn draw_straight(&self, sheet: &mut Sheet, space: &Space) {
        let straight = Ray::new(self.shade.point, self.direction);
        let Some(t) = space.leaves(&straight) else {
            return;
        };
        let [from, to] = [0.0, t].map(|t| space.place(straight.at(t)));
        sheet.line(Look::LINE_OF_RAY, from, to);
        let at = from.lerp(to, 0.8);
        sheet.label(space.frame, at, DVec2::new(0.5, -1.0), "straight on");
    }

    /// Draws how far a later ray runs beside the straight line, if the two are parallel.
    pub(in crate::figure) fn draw_offset(&self, sheet: &mut Sheet, space: &Space, node: &RayNode) {
        /// cos of the angle between them; rounding leaves more.
        const PARALLEL: f64 = 1.0 - 1e-9;
        /// Where along the ray.
        const PLACE: f64 = 0.25;
        let (Some(start), Some(t)) = (node.start, node.end.and_then(|end| end.t)) else {
            return;
        };
        let along = self.direction.normalize_or_zero();
        if start.ray.direction.normalize_or_zero().dot(along) < PARALLEL {
            return;
        }
        let at = start.ray.at(PLACE * t);
        let foot = self.shade.point + (at - self.shade.point).dot(along) * along;
        let [from, to] = [at, foot].map(|of| space.place(of));
        sheet.line(Look::HELP, from, to);
        let text = format!("offset {}", quantity(at.distance(foot)));
        sheet.label(space.frame, from.lerp(to, 0.5), to - from, text);
    }

    /// Where no ray leaves: the critical angle, and that the ray's angle is larger.
    fn beyond_critical(&self, sheet: &mut Sheet, space: &Space, refraction: &Refraction) {
        let at = space.place(self.shade.point);
        let critical = critical_angle(refraction);
        let normal = self.shade.normal;
        // in the plane of the ray and the normal, on the side from which the ray comes
        let aside = (-self.direction).reject_from(normal).normalize_or_zero();
        let (sin, cos) = (
            libm::sin(critical.to_radians()),
            libm::cos(critical.to_radians()),
        );
        let along = space.direction(cos * normal + sin * aside);
        let reach = at + 1.25 * NORMAL * sheet.unit() * along;
        sheet.line(Look::HELP, at, reach);
        if sheet.width == Width::Book {
            let text = format!("{}°", quantity(critical));
            sheet.label(space.frame, reach, along, text);
        }
        let text = format!(
            "{} > critical angle {}°",
            degrees(self.cosine()),
            quantity(critical)
        );
        sheet.label(space.frame, at, space.direction(-normal), text);
    }

    /// Draws the angle between the normal and a ray that is spawned here.
    pub(in crate::figure) fn angle_of_child(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        space: &Space,
        (purpose, law): (Purpose, Option<&Law>),
    ) {
        if !figure.shows(Layer::Angles) {
            return;
        }
        let (point, normal) = (self.shade.point, self.shade.normal);
        let refracted = self.refraction.and_then(|of| Some((of, of.direction?)));
        match (purpose, refracted) {
            (Purpose::Reflected, _) => {
                let between = [normal, reflect(self.direction, normal)];
                angle(sheet, space, point, (between, self.cosine()), law);
            }
            (Purpose::Refracted, Some((of, direction))) => {
                let cosine = of.cos_refracted_squared.max(0.0).sqrt();
                let between = [-normal, direction];
                angle(sheet, space, point, (between, cosine), law);
            }
            _ => {}
        }
    }
}

/// Snell's law with its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct Law {
    indices: [f64; 2],
    angles: [String; 2],
}

impl Law {
    pub(in crate::figure) fn text(&self) -> Text {
        let [from, to] = self.indices.map(quantity);
        let [before, after] = &self.angles;
        formula("n₁ sin θ₁ = n₂ sin θ₂: ") + format!("{from}·sin {before} = {to}·sin {after}")
    }

    /// An angle as it is called beside its arc: on a slide, whose letters have less room, by its name in the law.
    fn called(law: Option<&Self>, sheet: &Sheet, angle: &str) -> Text {
        let angles = law.map(|law| &law.angles).into_iter().flatten();
        let place = angles.zip(["θ₁", "θ₂"]).find(|(of, _)| *of == angle);
        match (sheet.width, place) {
            (Width::Slide, Some((_, name))) => formula(name),
            _ => angle.into(),
        }
    }
}

/// The angle to the normal behind a surface.
fn behind(refraction: &Refraction) -> String {
    degrees(refraction.cos_refracted_squared.max(0.0).sqrt())
}

fn angle(
    sheet: &mut Sheet,
    space: &Space,
    at: DVec3,
    (between, cosine): ([DVec3; 2], f64),
    law: Option<&Law>,
) {
    /// On a slide the arc is smaller beside its larger letters.
    const ON_SLIDE: f64 = 0.75;
    let share = match sheet.width {
        Width::Book => 1.0,
        Width::Slide => ON_SLIDE,
    };
    let angle = Angle {
        at: space.place(at),
        between: between.map(|of| space.direction(of)),
        radius: share * ARC,
    };
    let text = Law::called(law, sheet, &degrees(cosine));
    angle.draw(sheet, space.frame, text);
}

/// The name of an object that light passes, with its index of refraction: in a corner, away from the rays inside.
pub(in crate::figure) fn name_with_index(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    object: &Object,
    index: f64,
) {
    let shape = &figure.scene.primitive(object.first).shape;
    let rim = Outline::of(shape, &space.projection).rim;
    let points = rim.points().into_iter().map(|at| space.place_flat(at));
    let text = Text::from(scenery::short(&object.name)) + ", " + formula("n = ") + quantity(index);
    if let Some(area) = Frame::around(points) {
        sheet.label_in(area, text);
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
        let behind = behind(refraction);
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
