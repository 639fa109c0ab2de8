//! The events of one ray, put together into the steps that a solution tells one by one.

use glam::DVec3;

use crate::explain::worked::aligned::shown;
use crate::geometry::{
    AlignedRay, BoxTest, EdgeTest, PlaneTest, PolygonTest, QuadraticTest, Ray, Refraction,
};
use crate::scene::PrimitiveId;
use crate::structure::{BareGrid, SlabStep};
use crate::trace::{
    Arrival, Bounded, Event, Gathered, Item, LightTerm, Nearby, Nearest, Photon, RayEnd, RaySlab,
    RayStart, Record, Shade, Stored,
};

/// What is known of a ray while its steps are told.
pub(super) struct Course {
    /// Its place in the tree of rays.
    pub(super) place: usize,
    /// Its start; a ray of a filtered log may have none.
    pub(super) start: Option<RayStart>,
    /// The frame in which its tests are worked out, if that is not the world.
    pub(super) aligned: Option<AlignedRay>,
    /// t of the nearest hit so far.
    pub(super) nearest: Option<f64>,
    /// Which object that is.
    pub(super) nearest_object: Option<PrimitiveId>,
    /// The shade of the point it met.
    pub(super) shade: Option<Shade>,
    /// What chance decided about it there, on a path.
    pub(super) photon: Option<Photon>,
    /// N where it met a surface, on the side that it came from.
    pub(super) normal: Option<DVec3>,
    /// Its end.
    pub(super) end: Option<RayEnd>,
    /// The point it met was introduced.
    pub(super) arrived: bool,
    /// Are the slabs of bounds worked out one by one?
    pub(super) slabs_in_full: bool,
    /// S and T of the ray and each slab.
    pub(super) slab_rays: Vec<RaySlab>,
    /// The step of the search that was told last.
    pub(super) last: Option<Event>,
    /// The grid that it passes through, without room for rounding; `None` if it is in its box by that room alone.
    pub(super) grid: Option<BareGrid>,
    /// The slabs of the bound that is tested, without room for rounding.
    pub(super) slabs: Vec<(Bounded, SlabStep)>,
}

impl Course {
    /// The ray as its tests see it: along z, if it was aligned.
    pub(super) fn ray(&self) -> Option<Ray> {
        let world = || self.start.map(|start| start.ray);
        self.aligned
            .map(|aligned| aligned.in_frame())
            .or_else(world)
    }

    /// A point of an object as its test sees it.
    pub(super) fn place(&self, point: DVec3) -> DVec3 {
        self.aligned
            .map_or(point, |aligned| shown(aligned.frame.point(point)))
    }
}

/// One step of a ray's working.
#[derive(Clone, Debug)]
pub(super) enum Step {
    /// An object was tested; its hit became the nearest or did not.
    Test {
        object: PrimitiveId,
        test: Test,
        nearest: Option<Nearest>,
    },
    /// A ray was sent on.
    Ray(usize),
    Light(LightTerm),
    Refraction(Refraction),
    Shade(Shade),
    /// A step of the search: a bound, a node, a cell, an alignment.
    Search(Event),
    /// What chance decided about a photon.
    Photon(Photon),
    /// A photon was stored.
    Stored(Stored),
    /// A photon passes into the eye.
    Arrival(Arrival),
    /// Light was gathered from the nearest photons; in a filtered log either may be missing.
    Gathered {
        nearby: Vec<Nearby>,
        gathered: Option<Gathered>,
    },
    /// A hit became the nearest apart from its test.
    Nearest(Nearest),
}

/// The working of one object's test.
#[derive(Clone, Debug)]
pub(super) enum Test {
    Sphere(QuadraticTest),
    Ellipsoid(QuadraticTest),
    Cone(QuadraticTest),
    Box(BoxTest),
    /// A plane, and if it was met where it counts, its edges and the verdict. In a filtered log any of
    /// the three may be missing.
    Polygon {
        plane: Option<PlaneTest>,
        edges: Vec<EdgeTest>,
        inside: Option<PolygonTest>,
    },
}

impl Test {
    /// t of the hit.
    pub(super) fn hit(&self) -> Option<f64> {
        match self {
            Self::Sphere(test) | Self::Ellipsoid(test) | Self::Cone(test) => test.roots.chosen(),
            Self::Box(test) => test.roots.chosen(),
            Self::Polygon { plane, inside, .. } => {
                let inside = inside.as_ref().is_some_and(|test| test.inside);
                plane
                    .as_ref()
                    .and_then(PlaneTest::chosen)
                    .filter(|_| inside)
            }
        }
    }
}

/// The steps of a ray's items.
pub(super) fn steps(items: &[Item], records: &[Record]) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    for item in items {
        match *item {
            Item::Ray(place) => steps.push(Step::Ray(place)),
            Item::Event(at) => add(&records[at].event, &mut steps),
        }
    }
    steps
}

/// S and T of the ray and each slab.
pub(super) fn slab_rays(steps: &[Step]) -> Vec<RaySlab> {
    let line = |step: &Step| match step {
        Step::Search(Event::SlabRay(line)) => Some(*line),
        _ => None,
    };
    steps.iter().filter_map(line).collect()
}

fn add(event: &Event, steps: &mut Vec<Step>) {
    let quadratic = |object: PrimitiveId, test| Step::Test {
        object,
        test,
        nearest: None,
    };
    let step = match *event {
        Event::SphereTest { object, test } => quadratic(object, Test::Sphere(test)),
        Event::EllipsoidTest { object, test } => quadratic(object, Test::Ellipsoid(test)),
        Event::ConeTest { object, test } => quadratic(object, Test::Cone(test)),
        Event::BoxTest { object, test } => quadratic(object, Test::Box(test)),
        Event::PlaneTest { object, test } => Step::Test {
            object,
            test: Test::Polygon {
                plane: Some(test),
                edges: Vec::new(),
                inside: None,
            },
            nearest: None,
        },
        Event::Edge { object, edge } => {
            return polygon_of(object, steps, |edges, _| edges.push(edge));
        }
        Event::PolygonTest { object, test } => {
            return polygon_of(object, steps, |_, inside| *inside = Some(test));
        }
        Event::Nearest(hit) => {
            // a z sort finds the nearest after all tests
            match steps.last_mut() {
                Some(Step::Test { nearest, .. }) => *nearest = Some(hit),
                _ => steps.push(Step::Nearest(hit)),
            }
            return;
        }
        Event::LightTerm(light) => Step::Light(light),
        Event::Refraction(refraction) => Step::Refraction(refraction),
        Event::Shade(shade) => Step::Shade(shade),
        // those of the pixel or of the path, of the building before it, and the ray's start and end
        Event::Pixel(_)
        | Event::PixelColour(_)
        | Event::Merge(_)
        | Event::Assign(_)
        | Event::Ray(_)
        | Event::RayEnd(_)
        | Event::Path(_)
        | Event::Alternative(_)
        | Event::Connection(_) => return,
        Event::Photon(photon) => Step::Photon(photon),
        Event::Stored(stored) => Step::Stored(stored),
        Event::Arrival(arrival) => Step::Arrival(arrival),
        Event::Nearby(photon) => return gather(photon, steps),
        Event::Gathered(found) => match steps.last_mut() {
            Some(Step::Gathered { gathered, .. }) if gathered.is_none() => {
                *gathered = Some(found);
                return;
            }
            _ => Step::Gathered {
                nearby: Vec::new(),
                gathered: Some(found),
            },
        },
        Event::SlabRay(_)
        | Event::BoundTest(_)
        | Event::SlabTest(_)
        | Event::Node(_)
        | Event::Queue(_)
        | Event::GridEnter(_)
        | Event::Cell(_)
        | Event::Listed { .. }
        | Event::Mailbox { .. }
        | Event::HitOutsideCell(_)
        | Event::GridExit(_)
        | Event::Align(_)
        | Event::Aligned(_)
        | Event::ZSort(_) => Step::Search(*event),
    };
    steps.push(step);
}

/// One more of the nearest photons.
fn gather(photon: Nearby, steps: &mut Vec<Step>) {
    match steps.last_mut() {
        Some(Step::Gathered {
            nearby,
            gathered: None,
        }) => nearby.push(photon),
        _ => steps.push(Step::Gathered {
            nearby: vec![photon],
            gathered: None,
        }),
    }
}

/// Fills in what follows a polygon's plane; in a filtered log the plane may be missing.
fn polygon_of(
    of: PrimitiveId,
    steps: &mut Vec<Step>,
    fill: impl FnOnce(&mut Vec<EdgeTest>, &mut Option<PolygonTest>),
) {
    let open = matches!(
        steps.last(),
        Some(Step::Test { object, test: Test::Polygon { inside: None, .. }, .. }) if *object == of
    );
    if !open {
        steps.push(Step::Test {
            object: of,
            test: Test::Polygon {
                plane: None,
                edges: Vec::new(),
                inside: None,
            },
            nearest: None,
        });
    }
    if let Some(Step::Test {
        test: Test::Polygon { edges, inside, .. },
        ..
    }) = steps.last_mut()
    {
        fill(edges, inside);
    }
}
