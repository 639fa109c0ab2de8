//! The fields of every kind of event, in the order of the log line.

use crate::geometry::{
    BoxTest, EdgeTest, PlaneTest, PlaneVerdict, PolygonTest, QuadraticTest, Refraction, Root,
    Roots, SlabInterval,
};
use crate::scene::{PhongTerm, PrimitiveId};
use crate::trace::Why;
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::verdict::{derived_verdict, of_box, of_plane, of_polygon, why_no_hit};
use crate::trace::event::words::{Parallel, RootCount, ToPlane};
use crate::trace::{Event, LightTerm, Nearest, PixelColour, PixelSample, RayEnd, RayStart, Shade};

impl Fields for Event {
    #[inline]
    fn fields<V: Visitor>(&mut self, visitor: &mut V) {
        match self {
            Self::Pixel(sample) => sample.fields(visitor),
            Self::PixelColour(colour) => colour.fields(visitor),
            Self::Ray(start) => start.fields(visitor),
            Self::RayEnd(end) => end.fields(visitor),
            Self::SphereTest { object, test }
            | Self::EllipsoidTest { object, test }
            | Self::ConeTest { object, test } => tested(object, test, visitor),
            Self::BoxTest { object, test } => tested(object, test, visitor),
            Self::PlaneTest { object, test } => tested(object, test, visitor),
            Self::Edge { object, edge } => tested(object, edge, visitor),
            Self::PolygonTest { object, test } => tested(object, test, visitor),
            Self::Nearest(nearest) => nearest.fields(visitor),
            Self::LightTerm(light) => light.fields(visitor),
            Self::Shade(shade) => shade.fields(visitor),
            Self::Refraction(refraction) => refraction.fields(visitor),
            Self::Merge(step) => step.fields(visitor),
            Self::Assign(step) => step.fields(visitor),
            Self::BoundTest(step) => step.fields(visitor),
            Self::SlabTest(step) => step.fields(visitor),
            Self::Node(step) => step.fields(visitor),
            Self::Queue(step) => step.fields(visitor),
            Self::GridEnter(step) => step.fields(visitor),
            Self::Cell(step) => step.fields(visitor),
            Self::HitOutsideCell(step) => step.fields(visitor),
            Self::GridExit(step) => step.fields(visitor),
            Self::Align(step) => step.fields(visitor),
            Self::Aligned(step) => step.fields(visitor),
            Self::ZSort(step) => step.fields(visitor),
            Self::Path(step) => step.fields(visitor),
            Self::Photon(step) => step.fields(visitor),
            Self::Arrival(step) => step.fields(visitor),
            Self::Stored(step) => step.fields(visitor),
            Self::Nearby(step) => step.fields(visitor),
            Self::Gathered(step) => step.fields(visitor),
            Self::Alternative(step) => step.fields(visitor),
            Self::Connection(step) => step.fields(visitor),
            Self::Listed { object } | Self::Mailbox { object } => {
                object_field(object, "the object", visitor);
            }
        }
    }
}

/// The object that a test is of, and the working.
#[inline]
fn tested<V: Visitor>(object: &mut PrimitiveId, test: &mut impl Fields, v: &mut V) {
    object_field(object, "the object tested", v);
    test.fields(v);
}

pub(in crate::trace) fn object_field<V: Visitor>(
    object: &mut PrimitiveId,
    meaning: &'static str,
    v: &mut V,
) {
    let mut some = Some(*object);
    v.object(["object", "face"], meaning, &mut some, true);
    *object = some.unwrap_or_default();
}

impl Fields for PixelSample {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "sample",
            "which of the pixel's eye rays, from 0",
            &mut self.sample,
        );
        v.field(
            "samples",
            "how many eye rays the pixel has",
            &mut self.samples,
        );
        v.field(
            "place",
            "in pixels from the window's top left corner",
            &mut self.place,
        );
        v.field("point", "the point on the window", &mut self.point);
    }
}

impl Fields for PixelColour {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("raw", "the mean over the pixel's eye rays", &mut self.raw);
        v.field(
            "clamped",
            "cut to 0..1: what the picture shows",
            &mut self.clamped,
        );
        let rgb = self.rgb().map(u32::from);
        let mut found = rgb;
        v.field(
            "rgb",
            "255 times clamped, rounded: the values of the picture's file",
            &mut found,
        );
        if found != rgb {
            v.fail("\"rgb\" is not 255 times \"clamped\"");
        }
    }
}

impl Fields for RayStart {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("purpose", "what the ray is cast for", &mut self.purpose);
        v.field("origin", "(x0, y0, z0)", &mut self.ray.origin);
        v.field("direction", "the unit direction", &mut self.ray.direction);
        v.field(
            "t_min",
            "the smallest t that counts (epsilon)",
            &mut self.range.min,
        );
        let mut max = self.range.max.is_finite().then_some(self.range.max);
        v.optional(
            "t_max",
            "the largest t that counts; absent: no limit",
            &mut max,
        );
        self.range.max = max.unwrap_or(f64::INFINITY);
        v.field("depth", "1 for an eye ray", &mut self.depth);
        v.optional(
            "t_window",
            "where an eye ray passes the window",
            &mut self.window_t,
        );
        v.light(
            "the light that a shadow ray is cast to, or a path comes from",
            &mut self.light,
            false,
        );
    }
}

impl Fields for RayEnd {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("outcome", "how the ray ended", &mut self.outcome);
        v.object(["object", "face"], "what it met", &mut self.object, false);
        v.optional("t", "where it met it", &mut self.t);
        v.optional(
            "colour",
            "what it brings back; shadow rays bring none",
            &mut self.colour,
        );
        v.field(
            "tests",
            "how many objects it was tested against",
            &mut self.tests,
        );
        v.field("hits", "how many of those it met", &mut self.hits);
    }
}

impl Fields for QuadraticTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("a", "the coefficient of t^2", &mut self.a);
        v.field("b", "the coefficient of t", &mut self.b);
        v.field("c", "the constant term", &mut self.c);
        v.field("discriminant", "b^2 - 4ac", &mut self.discriminant);
        self.roots.fields(v);
        derived_verdict(why_no_hit(&self.roots, Why::NoRoot), v);
        chosen_root(&self.roots, v);
    }
}

impl Fields for Roots {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let (mut count, mut near, mut far) = match *self {
            Self::None => (RootCount::None, None, None),
            Self::Graze(root) => (RootCount::Graze, Some(root), None),
            Self::Two { near, far } => (RootCount::Two, Some(near), Some(far)),
            Self::Linear(root) => (RootCount::Linear, Some(root), None),
        };
        v.field("roots", "how many real roots there are", &mut count);
        optional_root(&mut near, ["near", "near_fate"], v);
        optional_root(&mut far, ["far", "far_fate"], v);
        *self = match (count, near, far) {
            (RootCount::None, None, None) => Self::None,
            (RootCount::Graze, Some(root), None) => Self::Graze(root),
            (RootCount::Two, Some(near), Some(far)) => Self::Two { near, far },
            (RootCount::Linear, Some(root), None) => Self::Linear(root),
            _ => return v.fail("\"roots\" does not fit \"near\" and \"far\""),
        };
    }
}

fn chosen_root<V: Visitor>(roots: &Roots, v: &mut V) {
    chosen(roots.chosen(), "the chosen root; absent: no hit", v);
}

/// t of the hit: follows from the roots, and stands in the line for those who look for hits alone.
fn chosen<V: Visitor>(hit: Option<f64>, meaning: &'static str, v: &mut V) {
    let mut t = hit;
    v.optional("t", meaning, &mut t);
    if t != hit {
        v.fail("\"t\" is not the chosen root");
    }
}

fn optional_root<V: Visitor>(root: &mut Option<Root>, [at, fate]: [&'static str; 2], v: &mut V) {
    let (mut t, mut what) = (root.map(|r| r.t), root.map(|r| r.fate));
    v.optional(at, "t of the root", &mut t);
    v.optional(fate, "whether the root is the hit, and why not", &mut what);
    *root = match (t, what) {
        (Some(t), Some(fate)) => Some(Root { t, fate }),
        (None, None) => None,
        _ => return v.fail("a root has either both t and fate or neither"),
    };
}

/// Where a ray is inside a slab: whether it is parallel, and if not, near and far.
pub(in crate::trace) fn slab_interval<V: Visitor>(
    slab: &mut SlabInterval,
    [kind, near, far]: [&'static str; 3],
    v: &mut V,
) {
    let (mut parallel, mut interval) = match *slab {
        SlabInterval::Between { near, far } => (Parallel::No, Some((near, far))),
        SlabInterval::ParallelInside => (Parallel::Inside, None),
        SlabInterval::ParallelOutside => (Parallel::Outside, None),
    };
    v.field(
        kind,
        "is the ray parallel to the slab, inside it or outside",
        &mut parallel,
    );
    let (mut t_near, mut t_far) = interval.unzip();
    v.optional(near, "t of the slab's near plane", &mut t_near);
    v.optional(far, "t of the slab's far plane", &mut t_far);
    interval = t_near.zip(t_far);
    *slab = match (parallel, interval) {
        (Parallel::No, Some((near, far))) => SlabInterval::Between { near, far },
        (Parallel::Inside, None) => SlabInterval::ParallelInside,
        (Parallel::Outside, None) => SlabInterval::ParallelOutside,
        _ => return v.fail("a slab has near and far unless the ray is parallel to it"),
    };
}

impl Fields for BoxTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        const KEYS: [[&str; 3]; 3] = [
            ["x_parallel", "x_near", "x_far"],
            ["y_parallel", "y_near", "y_far"],
            ["z_parallel", "z_near", "z_far"],
        ];
        for (slab, keys) in self.slabs.iter_mut().zip(KEYS) {
            slab_interval(slab, keys, v);
        }
        self.roots.fields(v);
        derived_verdict(of_box(self), v);
        chosen_root(&self.roots, v);
    }
}

impl Fields for PlaneTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let mut plane = self.plane.normal.extend(self.plane.d).to_array();
        v.field("plane", "[A, B, C, D] of equation (iv)", &mut plane);
        let [a, b, c, d] = plane;
        self.plane.normal = [a, b, c].into();
        self.plane.d = d;
        v.field("numerator", "A x0 + B y0 + C z0 + D", &mut self.numerator);
        v.field("denominator", "A dx + B dy + C dz", &mut self.denominator);
        let (mut parallel, mut root) = match self.verdict {
            PlaneVerdict::Meets(root) => (ToPlane::Meets, Some(root)),
            PlaneVerdict::ParallelBeside => (ToPlane::Beside, None),
            PlaneVerdict::ParallelWithin => (ToPlane::Within, None),
        };
        v.field(
            "parallel",
            "is the ray parallel to the plane: beside it or in it",
            &mut parallel,
        );
        optional_root(&mut root, ["root", "fate"], v);
        self.verdict = match (parallel, root) {
            (ToPlane::Meets, Some(root)) => PlaneVerdict::Meets(root),
            (ToPlane::Beside, None) => PlaneVerdict::ParallelBeside,
            (ToPlane::Within, None) => PlaneVerdict::ParallelWithin,
            _ => return v.fail("a plane is met at a root unless the ray is parallel to it"),
        };
        derived_verdict(of_plane(self), v);
        let met = "where the plane is met, if that counts; polygon_test says whether inside";
        chosen(self.chosen(), met, v);
    }
}

impl Fields for EdgeTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "edge",
            "the number of the edge's first vertex",
            &mut self.index,
        );
        v.field("from", "the first end point, projected", &mut self.from);
        v.field("to", "the second end point, projected", &mut self.to);
        v.field(
            "straddles",
            "do the end points lie on different sides",
            &mut self.straddles,
        );
        v.field(
            "side",
            "on which side it passes: only the sign matters",
            &mut self.side,
        );
        v.field(
            "counts",
            "does the edge count as a crossing",
            &mut self.counts,
        );
        v.field(
            "decided_by",
            "the projected point or the ray",
            &mut self.decided_by,
        );
    }
}

impl Fields for PolygonTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "dropped",
            "the coordinate that was dropped",
            &mut self.dropped,
        );
        v.field(
            "coefficient",
            "its coefficient in (iv)",
            &mut self.coefficient,
        );
        v.field("point", "p: where the ray meets the plane", &mut self.point);
        v.field(
            "projected",
            "p' : p without the dropped coordinate",
            &mut self.projected,
        );
        v.field("crossings", "how many edges count", &mut self.crossings);
        v.field("inside", "an odd number of crossings", &mut self.inside);
        v.field(
            "decided_by",
            "the projected point or the ray",
            &mut self.decided_by,
        );
        derived_verdict(of_polygon(self.inside), v);
    }
}

impl Fields for Nearest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "what is the nearest hit now", v);
        v.field("t", "where it is", &mut self.t);
        let keys = ["replaced", "replaced_face"];
        v.object(
            keys,
            "what was the nearest before",
            &mut self.replaced,
            false,
        );
    }
}

impl Fields for LightTerm {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let mut light = Some(self.light);
        v.light("the light", &mut light, true);
        self.light = light.unwrap_or_default();
        v.field(
            "visibility",
            "does the light reach the point",
            &mut self.visibility,
        );
        self.term.fields(v);
    }
}

impl Fields for PhongTerm {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "to_light",
            "L: the unit vector to the light",
            &mut self.to_light,
        );
        v.field("distance", "how far away the light is", &mut self.distance);
        v.field("n_dot_l", "N.L", &mut self.n_dot_l);
        v.field("r_dot_v", "R.V", &mut self.r_dot_v);
        v.field(
            "diffuse",
            "the diffuse term, if the light is visible",
            &mut self.diffuse,
        );
        v.field(
            "specular",
            "the specular term, if the light is visible",
            &mut self.specular,
        );
    }
}

impl Fields for Shade {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "what was hit", v);
        v.field("point", "the point", &mut self.point);
        v.field(
            "normal",
            "N: the unit normal on the ray's side",
            &mut self.normal,
        );
        v.field(
            "back",
            "is N the surface's normal turned round",
            &mut self.back,
        );
        v.field("ambient", "ambient times colour", &mut self.ambient);
        v.field(
            "direct",
            "the sum over the visible lights",
            &mut self.direct,
        );
        v.field(
            "reflection",
            "the weight of the reflected ray",
            &mut self.reflection,
        );
        v.field(
            "transmission",
            "the weight of the refracted ray",
            &mut self.transmission,
        );
    }
}

impl Fields for Refraction {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "index_from",
            "n1: the index where the ray comes from",
            &mut self.index_from,
        );
        v.field(
            "index_to",
            "n2: the index where it goes to",
            &mut self.index_to,
        );
        v.field("cos_incident", "cos theta1", &mut self.cos_incident);
        let meaning = "cos^2 theta2; negative: total internal reflection";
        v.field(
            "cos_refracted_squared",
            meaning,
            &mut self.cos_refracted_squared,
        );
        let mut total = self.direction.is_none();
        v.field("total_internal_reflection", "no ray passes", &mut total);
        v.optional(
            "direction",
            "the unit direction behind the surface",
            &mut self.direction,
        );
        if total != self.direction.is_none() {
            v.fail("a direction is there unless all is reflected");
        }
    }
}
