//! The test of a sphere that its figure draws.

use crate::figure::error::FigureError;
use crate::figure::parts::parabola;
use crate::figure::sheet::canvas::quantity;
use crate::figure::subject::{DrawnRay, Figure};
use crate::geometry::{QuadraticTest, Ray, Root, RootVerdict, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Event, Shade};

/// The test that is drawn.
pub(super) struct Solved {
    pub(super) id: PrimitiveId,
    pub(super) sphere: Sphere,
    pub(super) ray: Ray,
    pub(super) test: QuadraticTest,
    /// The step of the ray's start.
    pub(super) starts: Option<u32>,
    /// The step of the test.
    pub(super) step: u32,
    /// The shade where the sphere was hit, and its step.
    pub(super) shade: Option<(Shade, u32)>,
}

impl Solved {
    pub(super) fn find(figure: &Figure) -> Result<Self, FigureError> {
        let DrawnRay { node, events } = figure.ray()?;
        let asked = figure.object()?;
        let none = || {
            FigureError::new(
                "object",
                "this ray is not tested against such a sphere",
                "name a sphere that the ray is tested against, or omit \"object\" for the first one",
            )
        };
        let is_asked = |object| asked.is_none_or(|asked| asked == object);
        let found = events.iter().find_map(|record| match record.event {
            Event::SphereTest { object, test } if is_asked(object) && 0.0 < test.a => {
                Some((record.step, object, test))
            }
            _ => None,
        });
        let (step, id, test) = found.ok_or_else(none)?;
        let (Some(start), Shape::Sphere(sphere)) = (node.start, &figure.scene.primitive(id).shape)
        else {
            return Err(none());
        };
        let shade = events.iter().find_map(|record| match record.event {
            Event::Shade(shade) if shade.object == id => Some((shade, record.step)),
            _ => None,
        });
        let records = figure.records()?;
        let starts = node.ends_at[0].map(|at| records[at].step);
        Ok(Self {
            id,
            sphere: *sphere,
            ray: start.ray,
            test,
            starts,
            step,
            shade,
        })
    }

    /// r as a difference of t.
    pub(super) fn radius_in_t(&self) -> f64 {
        self.sphere.radius / self.test.a.sqrt()
    }

    /// The t at which the line of the ray is nearest to the center.
    pub(super) fn nearest(&self) -> f64 {
        parabola::vertex(&self.test).x
    }

    /// d, the distance of the line of the ray from the center: d² − r² is the least value of f.
    pub(super) fn distance(&self) -> f64 {
        let radius = self.sphere.radius;
        let least = parabola::vertex(&self.test).y + radius * radius;
        least.max(0.0).sqrt()
    }

    /// Does the ray start inside the sphere? Then c is negative, and whatever d is, it has a root on each side.
    pub(super) fn starts_inside(&self) -> bool {
        self.test.c < 0.0
    }

    /// How d compares with r.
    pub(super) fn compared(&self) -> &'static str {
        let least = parabola::vertex(&self.test).y;
        if least < 0.0 {
            "<"
        } else if 0.0 < least {
            ">"
        } else {
            "="
        }
    }

    /// What became of a root.
    pub(super) fn why(&self, root: Root) -> &'static str {
        match root.verdict {
            RootVerdict::Chosen => "the hit",
            RootVerdict::Behind => "behind the origin",
            RootVerdict::BelowEpsilon => "0 within ε",
            RootVerdict::BeyondNearest if self.test.roots.chosen().is_some() => "farther",
            RootVerdict::BeyondNearest => "beyond the nearest hit",
            RootVerdict::BackFace => "on the back",
            RootVerdict::FrontFace => "on the front",
            RootVerdict::BeyondEnds => "beyond the ends",
        }
    }

    /// f(t), equation (iii): with its numbers, or with letters.
    pub(super) fn function(&self, numbers: bool) -> String {
        if !numbers {
            return "f(t) = at² + bt + c".into();
        }
        let QuadraticTest { a, b, c, .. } = self.test;
        let mut sum = String::from("f(t) =");
        let terms = [(a, "t²"), (b, "t"), (c, "")];
        let terms = terms.into_iter().filter(|(value, _)| *value != 0.0);
        for (place, (value, variable)) in terms.enumerate() {
            sum += match (place, value < 0.0) {
                (0, false) => " ",
                (0, true) => " −",
                (_, false) => " + ",
                (_, true) => " − ",
            };
            let size = quantity(value.abs());
            // a coefficient of 1 is not written
            if size != "1" || variable.is_empty() {
                sum += &size;
            }
            sum += variable;
        }
        sum
    }
}
