//! The fields of the events of the search, in the order of the log line.

use crate::geometry::{Alignment, SlabInterval};
use crate::structure::{AssignStep, MergeStep, SlabOutcome, SlabStep};
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::kinds::{object_field, slab_interval};
use crate::trace::event::search::{
    Aligned, BoundTest, Bounded, CellVisit, GridEnter, GridExit, HitOutsideCell, NodeVisit,
    QueueStep, SlabTest, ZSort,
};
use crate::trace::event::verdict::{of_bound, of_slab, verdict_fields};
use crate::trace::{BoundOutcome, Why};

/// What a volume is around: either key is there.
fn bounded<V: Visitor>(of: &mut Bounded, v: &mut V) {
    let (mut object, mut node) = match *of {
        Bounded::Object(object) => (Some(object), None),
        Bounded::Node(node) => (None, Some(node)),
    };
    v.whole_object(
        "object",
        "the object that the volume is around",
        &mut object,
    );
    v.optional("node", "the node that the volume is around", &mut node);
    *of = match (object, node) {
        (Some(object), None) => Bounded::Object(object),
        (None, Some(node)) => Bounded::Node(node),
        _ => return v.fail("a volume is around either an \"object\" or a \"node\""),
    };
}

/// Two ends of a stretch of a ray, both there or neither.
fn stretch<V: Visitor>(
    inside: &mut Option<[f64; 2]>,
    keys: [&'static str; 2],
    meanings: [&'static str; 2],
    v: &mut V,
) {
    let (mut near, mut far) = inside.map(|[near, far]| (near, far)).unzip();
    v.optional(keys[0], meanings[0], &mut near);
    v.optional(keys[1], meanings[1], &mut far);
    *inside = match (near, far) {
        (Some(near), Some(far)) => Some([near, far]),
        (None, None) => None,
        _ => return v.fail("a stretch of the ray has two ends"),
    };
}

/// A quantity that has no bound where its key is absent.
fn unbounded<V: Visitor>(
    key: &'static str,
    meaning: &'static str,
    value: &mut f64,
    at: f64,
    v: &mut V,
) {
    let mut finite = value.is_finite().then_some(*value);
    v.optional(key, meaning, &mut finite);
    *value = finite.unwrap_or(at);
}

impl Fields for MergeStep {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("node", "the node whose bound it becomes", &mut self.node);
        v.field("first", "the volume so far, a node", &mut self.first);
        v.field("second", "the child that is joined to it", &mut self.second);
        v.field("slab", "which direction of the set, from 0", &mut self.slab);
        v.field("first_d_min", "D_min so far", &mut self.d_min[0]);
        v.field("second_d_min", "D_min of the child", &mut self.d_min[1]);
        v.field("first_d_max", "D_max so far", &mut self.d_max[0]);
        v.field("second_d_max", "D_max of the child", &mut self.d_max[1]);
        let (d_min, d_max) = self.joined();
        let (mut low, mut high) = (d_min, d_max);
        v.field("d_min", "the smaller D_min", &mut low);
        v.field("d_max", "the larger D_max", &mut high);
        // a reader fills the parts first, so that the joined values follow from them
        let (d_min, d_max) = self.joined();
        if low != d_min || high != d_max {
            v.fail("\"d_min\" and \"d_max\" are not those of both volumes");
        }
    }
}

impl Fields for AssignStep {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "the object", v);
        v.field("cell", "[i, j, k] of the cell", &mut self.cell);
        v.field("share", "does all of it lie in the cell", &mut self.share);
    }
}

impl Fields for BoundTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        bounded(&mut self.of, v);
        v.field("volume", "the form of the volume", &mut self.volume);
        let meanings = ["where the ray enters it", "where the ray leaves it"];
        stretch(&mut self.inside, ["near", "far"], meanings, v);
        let mut why = of_bound(self.outcome);
        verdict_fields(&mut why, v);
        self.outcome = match why {
            None => BoundOutcome::Hit,
            Some(Why::Missed) => BoundOutcome::Missed,
            Some(Why::Behind) => BoundOutcome::Behind,
            Some(Why::BeyondNearest) => BoundOutcome::Beyond,
            Some(_) => return v.fail("a bound is rejected as missed, behind or beyond_nearest"),
        };
    }
}

impl Fields for SlabTest {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        bounded(&mut self.of, v);
        self.step.fields(v);
    }
}

impl Fields for SlabStep {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("slab", "which direction of the set, from 0", &mut self.slab);
        v.field("normal", "[A, B, C]", &mut self.normal);
        v.field("s", "S = A x0 + B y0 + C z0", &mut self.s);
        let meaning = "T = -1/(A dx + B dy + C dz); absent: the ray is parallel";
        // the sign of an infinite T says nothing
        let mut t_scale = self.t_scale.is_finite().then_some(self.t_scale);
        v.optional("t_scale", meaning, &mut t_scale);
        self.t_scale = t_scale.unwrap_or(f64::INFINITY);
        v.field(
            "d_min",
            "D of the plane furthest along the normal",
            &mut self.d_min,
        );
        v.field("d_max", "D of the plane furthest back", &mut self.d_max);
        slab_interval(&mut self.interval, ["parallel", "near", "far"], v);
        let meaning = "the largest near up to this slab; absent: none";
        unbounded(
            "max_near",
            meaning,
            &mut self.max_near,
            f64::NEG_INFINITY,
            v,
        );
        let meaning = "the smallest far up to this slab; absent: none";
        unbounded("min_far", meaning, &mut self.min_far, f64::INFINITY, v);
        let mut why = of_slab(self.outcome);
        verdict_fields(&mut why, v);
        let is_parallel = !matches!(self.interval, SlabInterval::Between { .. });
        self.outcome = match why {
            None if is_parallel => SlabOutcome::ParallelInside,
            None => SlabOutcome::GoesOn,
            Some(Why::Empty) => SlabOutcome::Null,
            Some(Why::Parallel) if is_parallel => SlabOutcome::ParallelOutside,
            Some(_) => {
                return v.fail(
                    "a slab is rejected as empty, or as parallel if the ray is parallel to it",
                );
            }
        };
    }
}

impl Fields for NodeVisit {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "node",
            "the number of the node; the root is 0",
            &mut self.node,
        );
        v.field("depth", "how deep it lies; the root at 0", &mut self.depth);
        v.field(
            "children",
            "how many nodes are directly below it",
            &mut self.children,
        );
        v.field(
            "objects",
            "how many objects are, in a leaf",
            &mut self.objects,
        );
        v.optional("near", "where the ray enters its bound", &mut self.near);
        v.field("outcome", "what became of the node", &mut self.outcome);
    }
}

impl Fields for QueueStep {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "action",
            "into the heap, out of it, or the end",
            &mut self.action,
        );
        v.field("node", "the number of the node", &mut self.node);
        v.field(
            "key",
            "the estimated distance: where its bound is entered",
            &mut self.key,
        );
        v.field("size", "how many nodes wait afterwards", &mut self.size);
    }
}

impl Fields for GridEnter {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "min",
            "the smallest coordinates of the scene's box",
            &mut self.min,
        );
        v.field("max", "the largest", &mut self.max);
        v.field("resolution", "cells along x, y and z", &mut self.resolution);
        let meanings = [
            "where the ray enters the box",
            "where the ray leaves the box",
        ];
        stretch(&mut self.inside, ["near", "far"], meanings, v);
        v.optional(
            "cell",
            "the first cell; absent: none is pierced",
            &mut self.cell,
        );
    }
}

impl Fields for CellVisit {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        let step = &mut self.step;
        v.field("cell", "[i, j, k]", &mut step.cell);
        v.field("t_in", "where the ray enters the cell", &mut step.t_in);
        unbounded(
            "t_out",
            "where it leaves the cell",
            &mut step.t_out,
            f64::INFINITY,
            v,
        );
        let [x, y, z] = &mut step.next;
        let meaning = "t of the next plane across this axis; absent: none";
        unbounded("next_x", meaning, x, f64::INFINITY, v);
        unbounded("next_y", meaning, y, f64::INFINITY, v);
        unbounded("next_z", meaning, z, f64::INFINITY, v);
        v.field(
            "across",
            "across which planes it leaves the cell",
            &mut step.across,
        );
        v.field(
            "listed",
            "how many objects are on the cell's list",
            &mut self.listed,
        );
    }
}

impl Fields for HitOutsideCell {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "what was hit", v);
        v.field("t", "where", &mut self.t);
        v.field("t_out", "where the ray leaves the cell", &mut self.t_out);
    }
}

impl Fields for GridExit {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("end", "why the walk ended", &mut self.end);
        v.field("cells", "how many cells were visited", &mut self.cells);
    }
}

impl Fields for Alignment {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "origin",
            "o: the ray's origin, which comes to 0",
            &mut self.origin,
        );
        v.field("x", "the first row of the rotation", &mut self.x);
        v.field("y", "the second row", &mut self.y);
        v.field("z", "the third row: the ray's direction", &mut self.z);
    }
}

impl Fields for Aligned {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "the object", v);
        v.field("part", "what the point is of it", &mut self.part);
        v.field("index", "which of several, from 0", &mut self.index);
        v.field("from", "the point before", &mut self.from);
        v.field("to", "the point after", &mut self.to);
    }
}

impl Fields for ZSort {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "place",
            "its place among the hits, from 0: the nearest",
            &mut self.place,
        );
        object_field(&mut self.object, "what was hit", v);
        v.field("z", "where: its z, which is t", &mut self.z);
    }
}
