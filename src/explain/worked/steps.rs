//! The events of one ray, put together into the steps that a solution writes one by one.

use glam::DVec3;

use crate::explain::number::without_rounding;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::geometry::{
    AlignedRay, BoxTest, EdgeTest, PlaneTest, PolygonTest, QuadraticTest, Ray, Refraction,
};
use crate::scene::PrimitiveId;
use crate::structure::{BareGrid, SlabStep};
use crate::trace::{
    Arrival, Bounded, Event, Gathered, Item, LightTerm, Nearby, Nearest, Photon, RayEnd, RaySlab,
    RayStart, Shade, Stored,
};

/// What is known of a ray while its steps are written.
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
    /// The event that holds the point it met: its shade, or what chance decided there.
    pub(super) arrival: Option<Extent>,
    /// The point it met was introduced.
    pub(super) arrived: bool,
    /// Are the slabs of bounds worked out one by one?
    pub(super) slabs_in_full: bool,
    /// S and T of the ray and each slab.
    pub(super) slab_rays: Vec<RaySlab>,
    /// The step of the search that was written last.
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
        self.aligned.map_or(point, |aligned| {
            without_rounding(aligned.frame.point(point))
        })
    }
}

/// One step of a ray's working, and the events that it was put together from.
#[derive(Clone, Debug)]
pub(super) struct Told {
    pub(super) step: Step,
    /// From its first event to its last; of a spawned ray, all its events.
    pub(super) extent: Extent,
}

/// An event's working, and which event that is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noted<T> {
    pub(super) working: T,
    pub(super) extent: Extent,
}

/// What a step of a ray's working is.
#[derive(Clone, Debug)]
pub(super) enum Step {
    /// An object was tested; its hit became the nearest or did not.
    Test {
        object: PrimitiveId,
        test: Test,
        nearest: Option<Noted<Nearest>>,
    },
    /// A ray was spawned.
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
        nearby: Vec<Noted<Nearby>>,
        gathered: Option<Noted<Gathered>>,
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
    /// A plane, and if it was hit where it counts, its edges and the verdict. In a filtered log any of
    /// the three may be missing.
    Polygon {
        plane: Option<Noted<PlaneTest>>,
        edges: Vec<Noted<EdgeTest>>,
        inside: Option<Noted<PolygonTest>>,
    },
}

impl Test {
    /// The event that decided about a polygon, which has several.
    pub(super) fn decided(&self) -> Option<Extent> {
        match self {
            Self::Sphere(_) | Self::Ellipsoid(_) | Self::Cone(_) | Self::Box(_) => None,
            Self::Polygon { inside, .. } => inside.map(|inside| inside.extent),
        }
    }

    /// t of the hit.
    pub(super) fn hit(&self) -> Option<f64> {
        match self {
            Self::Sphere(test) | Self::Ellipsoid(test) | Self::Cone(test) => test.roots.chosen(),
            Self::Box(test) => test.roots.chosen(),
            Self::Polygon { plane, inside, .. } => {
                let inside = inside.is_some_and(|test| test.working.inside);
                plane
                    .and_then(|plane| plane.working.chosen())
                    .filter(|_| inside)
            }
        }
    }
}

/// The steps of a ray's items.
pub(super) fn steps(context: &Context, items: &[Item]) -> Vec<Told> {
    let mut steps: Vec<Told> = Vec::new();
    for item in items {
        match *item {
            Item::Ray(place) => steps.push(Told {
                step: Step::Ray(place),
                extent: context.of_ray(place),
            }),
            Item::Event(at) => add(&context.records[at].event, context.at(at), &mut steps),
        }
    }
    steps
}

/// S and T of the ray and each slab.
pub(super) fn slab_rays(steps: &[Told]) -> Vec<RaySlab> {
    let line = |told: &Told| match told.step {
        Step::Search(Event::SlabRay(line)) => Some(line),
        _ => None,
    };
    steps.iter().filter_map(line).collect()
}

fn add(event: &Event, extent: Extent, steps: &mut Vec<Told>) {
    let test = |object: PrimitiveId, test| Step::Test {
        object,
        test,
        nearest: None,
    };
    let step = match *event {
        Event::SphereTest { object, test: t } => test(object, Test::Sphere(t)),
        Event::EllipsoidTest { object, test: t } => test(object, Test::Ellipsoid(t)),
        Event::ConeTest { object, test: t } => test(object, Test::Cone(t)),
        Event::BoxTest { object, test: t } => test(object, Test::Box(t)),
        Event::PlaneTest { object, test: t } => test(
            object,
            Test::Polygon {
                plane: Some(Noted::new(t, extent)),
                edges: Vec::new(),
                inside: None,
            },
        ),
        Event::Edge { object, edge } => {
            return polygon_of(object, extent, steps, |edges, _| {
                edges.push(Noted::new(edge, extent));
            });
        }
        Event::PolygonTest { object, test } => {
            return polygon_of(object, extent, steps, |_, inside| {
                *inside = Some(Noted::new(test, extent));
            });
        }
        Event::Nearest(hit) => match steps.last_mut() {
            Some(Told {
                step: Step::Test { nearest, .. },
                extent: whole,
            }) => {
                *nearest = Some(Noted::new(hit, extent));
                whole.last = extent.last;
                return;
            }
            // a z sort finds the nearest after all tests
            _ => Step::Nearest(hit),
        },
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
        Event::Nearby(photon) => {
            return gather(extent, steps, |nearby, _| {
                nearby.push(Noted::new(photon, extent));
            });
        }
        Event::Gathered(found) => {
            return gather(extent, steps, |_, gathered| {
                *gathered = Some(Noted::new(found, extent));
            });
        }
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
    steps.push(Told { step, extent });
}

impl<T> Noted<T> {
    fn new(working: T, extent: Extent) -> Self {
        Self { working, extent }
    }
}

/// Fills in one more of the nearest photons, or what was gathered from them.
fn gather(
    extent: Extent,
    steps: &mut Vec<Told>,
    fill: impl FnOnce(&mut Vec<Noted<Nearby>>, &mut Option<Noted<Gathered>>),
) {
    let open = matches!(
        steps.last(),
        Some(Told {
            step: Step::Gathered { gathered: None, .. },
            ..
        })
    );
    if !open {
        let step = Step::Gathered {
            nearby: Vec::new(),
            gathered: None,
        };
        steps.push(Told { step, extent });
    }
    if let Some(Told {
        step: Step::Gathered { nearby, gathered },
        extent: whole,
    }) = steps.last_mut()
    {
        whole.last = extent.last;
        fill(nearby, gathered);
    }
}

/// Fills in what follows a polygon's plane; in a filtered log the plane may be missing.
fn polygon_of(
    of: PrimitiveId,
    extent: Extent,
    steps: &mut Vec<Told>,
    fill: impl FnOnce(&mut Vec<Noted<EdgeTest>>, &mut Option<Noted<PolygonTest>>),
) {
    let open = matches!(
        steps.last().map(|told| &told.step),
        Some(Step::Test { object, test: Test::Polygon { inside: None, .. }, .. }) if *object == of
    );
    if !open {
        let step = Step::Test {
            object: of,
            test: Test::Polygon {
                plane: None,
                edges: Vec::new(),
                inside: None,
            },
            nearest: None,
        };
        steps.push(Told { step, extent });
    }
    if let Some(Told {
        step:
            Step::Test {
                test: Test::Polygon { edges, inside, .. },
                ..
            },
        extent: whole,
    }) = steps.last_mut()
    {
        whole.last = extent.last;
        fill(edges, inside);
    }
}
