//! What the steps of the layers below have in a line: their fields, in the order of the line.

use crate::geometry::{
    Alignment, AxisBox, BoxTest, EdgeTest, PlaneTest, PlaneVerdict, PolygonTest, QuadraticTest,
    Ray, Refraction, Root, Roots, SlabInterval, TRange,
};
use crate::scene::PhongTerm;
use crate::structure::{AssignStep, CellStep, MergeStep, SlabStep, SlabVerdict};
use crate::trace::event::columns::{Column, derived, unbounded, unbounded_below};
use crate::trace::event::declare::fields;
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::verdict::{Judged, of_box, of_plane, of_polygon, of_quadratic, of_slab};
use crate::trace::event::words::{Parallel, RootCount, ToPlane, Why};

fields! { Ray {
    /// (x0, y0, z0): the point at which the ray starts, in world coordinates.
    origin,
    /// (dx, dy, dz), of unit length.
    direction,
} }

fields! { TRange {
    /// The smallest t that counts (epsilon).
    t_min: min,
    /// The largest t that counts; absent: no limit.
    t_max: max = by unbounded,
} }

fields! { AxisBox {
    /// The smallest coordinates of the grid's box.
    min,
    /// The largest coordinates of the grid's box.
    max,
} }

fields! { QuadraticTest {
    /// The coefficient of t^2.
    a,
    /// The coefficient of t, with its factor 2.
    b,
    /// The constant term; negative if the ray starts inside.
    c,
    /// b^2 - 4ac.
    discriminant,
    flat roots,
    verdict => of_quadratic,
    /// t of the hit; absent: there is none.
    t => hit_of_quadratic,
} }

fn hit_of_quadratic(test: &QuadraticTest) -> Option<f64> {
    test.roots.chosen()
}

impl Fields for Roots {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let (mut count, mut near, mut far) = match *self {
            Self::None => (RootCount::None, None, None),
            Self::Graze(root) => (RootCount::Graze, Some(root), None),
            Self::Two { near, far } => (RootCount::Two, Some(near), Some(far)),
            Self::Linear(root) => (RootCount::Linear, Some(root), None),
        };
        v.field("roots", "How many real roots there are.", &mut count);
        optional_root(&mut near, ["near", "near_verdict"], v);
        optional_root(&mut far, ["far", "far_verdict"], v);
        *self = match (count, near, far) {
            (RootCount::None, None, None) => Self::None,
            (RootCount::Graze, Some(root), None) => Self::Graze(root),
            (RootCount::Two, Some(near), Some(far)) => Self::Two { near, far },
            (RootCount::Linear, Some(root), None) => Self::Linear(root),
            _ => return v.fail("\"roots\" does not fit \"near\" and \"far\""),
        };
    }
}

fn optional_root<V: Visitor>(root: &mut Option<Root>, [at, verdict]: [&'static str; 2], v: &mut V) {
    let (mut t, mut what) = (root.map(|r| r.t), root.map(|r| r.verdict));
    v.optional(at, "t of the root; absent: there is none.", &mut t);
    v.optional(verdict, "Is the root the hit, and why not?", &mut what);
    *root = match (t, what) {
        (Some(t), Some(verdict)) => Some(Root { t, verdict }),
        (None, None) => None,
        _ => return v.fail("a root has either both t and verdict or neither"),
    };
}

/// Where a ray is inside a slab: whether it is parallel, and if not, near and far.
fn slab_interval<V: Visitor>(
    slab: &mut SlabInterval,
    [kind, near, far]: [&'static str; 3],
    v: &mut V,
) {
    let (mut parallel, mut interval) = match *slab {
        SlabInterval::Between { near, far } => (Parallel::No, Some((near, far))),
        SlabInterval::ParallelInside => (Parallel::Inside, None),
        SlabInterval::ParallelOutside => (Parallel::Outside, None),
    };
    let meaning = "Is the ray parallel to the slab, and if so, inside it or outside?";
    v.field(kind, meaning, &mut parallel);
    let (mut t_near, mut t_far) = interval.unzip();
    let meaning = "t of the slab's near plane; absent: the ray is parallel to it.";
    v.optional(near, meaning, &mut t_near);
    let meaning = "t of the slab's far plane; absent: the ray is parallel to it.";
    v.optional(far, meaning, &mut t_far);
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
        Judged::derived(of_box(self), v);
        hit_t(
            self.roots.chosen(),
            "t of the hit; absent: there is none.",
            v,
        );
    }
}

/// t of a hit, which follows from the roots.
fn hit_t<V: Visitor>(t: Option<f64>, meaning: &'static str, v: &mut V) {
    derived(
        "t",
        meaning,
        t,
        "\"t\" does not follow from the rest of the line",
        v,
    );
}

impl Fields for PlaneTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let mut plane = self.plane.normal.extend(self.plane.d).to_array();
        v.field("plane", "[A, B, C, D] of equation (iv).", &mut plane);
        let [a, b, c, d] = plane;
        self.plane.normal = [a, b, c].into();
        self.plane.d = d;
        let meaning =
            "A x0 + B y0 + C z0 + D: the signed distance of the ray's origin from the plane.";
        v.field("numerator", meaning, &mut self.numerator);
        let meaning = "A dx + B dy + C dz: the cosine between the ray and the normal.";
        v.field("denominator", meaning, &mut self.denominator);
        let (mut parallel, mut root) = match self.verdict {
            PlaneVerdict::Meets(root) => (ToPlane::Meets, Some(root)),
            PlaneVerdict::ParallelBeside => (ToPlane::Beside, None),
            PlaneVerdict::ParallelWithin => (ToPlane::Within, None),
        };
        let meaning = "Is the ray parallel to the plane, and if so, beside it or in it?";
        v.field("parallel", meaning, &mut parallel);
        optional_root(&mut root, ["root", "root_verdict"], v);
        self.verdict = match (parallel, root) {
            (ToPlane::Meets, Some(root)) => PlaneVerdict::Meets(root),
            (ToPlane::Beside, None) => PlaneVerdict::ParallelBeside,
            (ToPlane::Within, None) => PlaneVerdict::ParallelWithin,
            _ => return v.fail("a ray meets a plane at a root unless it is parallel to it"),
        };
        Judged::derived(of_plane(self), v);
        let meaning = "t where the ray meets the plane; absent: it does not. The polygon_test says whether inside.";
        hit_t(self.chosen(), meaning, v);
    }
}

fields! { EdgeTest {
    /// The number of the edge's first vertex, from 0; the edge runs to the next vertex.
    edge: index,
    /// The first end point, without the dropped coordinate.
    from,
    /// The second end point, without the dropped coordinate.
    to,
    /// Do the end points lie on different sides of the line through p'?
    straddles,
    /// On which side the edge passes p', or the ray: only the sign has a meaning.
    side,
    /// Does the edge count as a crossing?
    counts,
    /// Does the projected point decide, or the ray?
    decided_by,
} }

fields! { PolygonTest {
    /// The coordinate that is dropped: that of the largest coefficient in (iv).
    dropped,
    /// The coefficient of the dropped coordinate in (iv).
    coefficient,
    /// p: the point where the ray hits the plane, in world coordinates.
    point,
    /// p': p without the dropped coordinate.
    projected,
    /// How many edges count as crossings.
    crossings,
    /// Is p inside? It is at an odd number of crossings.
    inside,
    /// Does the projected point decide, or the ray?
    decided_by,
    verdict => of_polygon,
} }

fields! { PhongTerm {
    /// L: the unit vector from the point to the light; 0 if the light stands in the point.
    to_light,
    /// The distance of the light.
    distance,
    /// N.L: the cosine of the angle of incidence; at most 0 if the surface faces away.
    n_dot_l,
    /// R.V: the cosine between the mirrored light and the viewer.
    r_dot_v,
    /// The diffuse term: light * colour * diffuse * max(0, N.L), or colour * diffuse / pi * E for a light with a power.
    diffuse,
    /// The specular term: light * specular * max(0, R.V)^shininess; 0 for a light with a power.
    specular,
} }

impl Fields for Refraction {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let meaning = "n1: the index on the side that the ray comes from.";
        v.field("index_from", meaning, &mut self.index_from);
        let meaning = "n2: the index on the side that the ray goes to.";
        v.field("index_to", meaning, &mut self.index_to);
        let meaning = "cos theta1, between the ray and the normal.";
        v.field("cos_incident", meaning, &mut self.cos_incident);
        let meaning = "cos^2 theta2; negative: total internal reflection.";
        v.field(
            "cos_refracted_squared",
            meaning,
            &mut self.cos_refracted_squared,
        );
        let mut total = self.direction.is_none();
        let meaning = "Is all reflected, so that no ray passes?";
        v.field("total_internal_reflection", meaning, &mut total);
        let meaning = "The unit direction behind the surface; absent: no ray passes.";
        v.optional("direction", meaning, &mut self.direction);
        if total != self.direction.is_none() {
            v.fail("a direction is there unless all is reflected");
        }
    }
}

fields! { MergeStep {
    /// The number of the node whose bound the volume becomes.
    node,
    /// The number of the node whose volume it is so far: the first child, or from the third child on the node itself.
    first,
    /// The number of the child that is joined to it.
    second,
    /// Which direction of the set, from 0.
    slab,
    /// D_min so far.
    first_d_min: d_min[0],
    /// D_min of the child.
    second_d_min: d_min[1],
    /// D_max so far.
    first_d_max: d_max[0],
    /// D_max of the child.
    second_d_max: d_max[1],
    /// The smaller D_min.
    d_min => joined_d_min,
    /// The larger D_max.
    d_max => joined_d_max,
} }

fn joined_d_min(step: &MergeStep) -> f64 {
    step.joined().0
}

fn joined_d_max(step: &MergeStep) -> f64 {
    step.joined().1
}

fields! { AssignStep {
    /// The object.
    object,
    /// [i, j, k] of the cell.
    cell,
    /// Does all of the object lie in the cell, or a part?
    share,
} }

impl Fields for SlabStep {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "slab",
            "Which direction of the set, from 0.",
            &mut self.slab,
        );
        let meaning = "D of the plane furthest along the normal, without the room that near and far have in them.";
        v.field("d_min", meaning, &mut self.d_min);
        let meaning = "D of the plane furthest back along the normal, without room.";
        v.field("d_max", meaning, &mut self.d_max);
        slab_interval(&mut self.interval, ["parallel", "near", "far"], v);
        let meaning =
            "The largest near up to this slab; absent: the ray is parallel to all slabs so far.";
        unbounded_below(&mut self.max_near, "max_near", meaning, v);
        let meaning =
            "The smallest far up to this slab; absent: the ray is parallel to all slabs so far.";
        unbounded(&mut self.min_far, "min_far", meaning, v);
        let mut judged = Judged(of_slab(self.verdict));
        judged.fields(v);
        let is_parallel = !matches!(self.interval, SlabInterval::Between { .. });
        self.verdict = match judged.0 {
            None if is_parallel => SlabVerdict::ParallelInside,
            None => SlabVerdict::GoesOn,
            Some(Why::Empty) => SlabVerdict::Null,
            Some(Why::Parallel) if is_parallel => SlabVerdict::ParallelOutside,
            Some(_) => {
                return v.fail(
                    "a slab is rejected as empty, or as parallel if the ray is parallel to it",
                );
            }
        };
    }
}

fields! { CellStep {
    /// [i, j, k] of the cell.
    cell,
    /// t at which the ray enters the cell, or at which its range begins in it.
    t_in,
    /// t at which the ray leaves the cell; absent: never.
    t_out: t_out = by unbounded,
    /// t of the next plane across x; absent: none is hit.
    next_x: next[0] = by unbounded,
    /// t of the next plane across y; absent: none is hit.
    next_y: next[1] = by unbounded,
    /// t of the next plane across z; absent: none is hit.
    next_z: next[2] = by unbounded,
    /// Across which planes the ray leaves the cell; two or three at once through an edge or a corner.
    across,
} }

fields! { Alignment {
    /// o: the ray's origin, which becomes 0.
    origin,
    /// The first row of the rotation, of unit length.
    x,
    /// The second row of the rotation.
    y,
    /// The third row of the rotation: the ray's direction.
    z,
} }
