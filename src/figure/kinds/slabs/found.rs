//! The tests of one bound's slabs in a trace.

use crate::figure::error::FigureError;
use crate::figure::parts::bound::Slab;
use crate::figure::parts::scenery;
use crate::figure::subject::Figure;
use crate::geometry::{SlabInterval, SlabRay};
use crate::scene::PrimitiveId;
use crate::trace::{BoundTest, Bounded, Event, RaySlab, Record, SlabTest};

/// The tests of one bound's slabs, as they are in the trace, and the step at which the bound was decided.
pub(in crate::figure::kinds) struct SlabTests<'a> {
    pub(in crate::figure::kinds) of: Bounded,
    /// Without the room for rounding with which they are decided.
    pub(in crate::figure::kinds) tests: Vec<(u32, SlabTest)>,
    /// S and T of the ray and each slab.
    lines: Vec<&'a RaySlab>,
    pub(in crate::figure::kinds) decided: Option<(u32, &'a BoundTest)>,
}

/// A slab with S and T of a ray.
pub(in crate::figure::kinds) struct SlabRow {
    pub(in crate::figure::kinds) slab: Slab,
    pub(in crate::figure::kinds) line: SlabRay,
    pub(in crate::figure::kinds) interval: SlabInterval,
}

impl<'a> SlabTests<'a> {
    /// Those of the object that the specification names, or else of the first bound on the ray.
    ///
    /// # Errors
    /// The ray was tested against no such slabs.
    pub(in crate::figure::kinds) fn find(
        figure: &Figure,
        events: &[&'a Record],
    ) -> Result<Self, FigureError> {
        let wanted = figure.object()?.map(|id| {
            let object = figure.scene.primitive(id).object;
            Bounded::Object(object)
        });
        let found = events.iter().find_map(|record| match &record.event {
            Event::SlabTest(test) if wanted.is_none_or(|of| of == test.of) => Some(test.of),
            _ => None,
        });
        let of = found.ok_or_else(|| {
            FigureError::new(
                "structure",
                "no slab was tested on this ray",
                "add \"strategy\": \"bounds\" with \"structure\": { \"volume\": \"slabs\", \"slabs\": \"scene\" }",
            )
        })?;
        let mut tests: Vec<(u32, SlabTest)> = Vec::new();
        let mut lines: Vec<&RaySlab> = Vec::new();
        let mut decided = None;
        for record in events {
            match &record.event {
                Event::SlabRay(line) => lines.push(line),
                Event::SlabTest(test) if test.of == of => {
                    let line = lines.iter().find(|line| line.slab == test.step.slab);
                    let before = tests.last().map(|(_, test)| &test.step);
                    let bare = |line: &&RaySlab| test.step.without_room(&line.line(), before);
                    let step = line.map_or(test.step, bare);
                    tests.push((record.step, SlabTest { of, step }));
                }
                Event::BoundTest(test) if test.of == of => decided = Some((record.step, test)),
                _ => {}
            }
        }
        Ok(Self {
            of,
            tests,
            lines,
            decided,
        })
    }

    /// The test of a slab, by its place among them.
    pub(in crate::figure::kinds) fn of_slab(&self, slab: &Slab) -> Option<usize> {
        let mut tests = self.tests.iter();
        tests.position(|(_, test)| test.step.slab == slab.number)
    }

    /// The slabs that were tested, each with S and T of the ray and where the ray is inside it.
    pub(in crate::figure::kinds) fn rows(&self) -> impl Iterator<Item = SlabRow> {
        self.tests.iter().filter_map(|(_, test)| {
            let mut lines = self.lines.iter();
            let line = lines.find(|line| line.slab == test.step.slab)?;
            Some(SlabRow {
                slab: Slab::of(test, line),
                line: line.line(),
                interval: test.step.interval,
            })
        })
    }

    /// The slabs that were tested, each with its step.
    pub(in crate::figure::kinds) fn slabs(&self) -> impl Iterator<Item = (u32, Slab)> {
        self.tests.iter().filter_map(|(step, test)| {
            let mut lines = self.lines.iter();
            let line = lines.find(|line| line.slab == test.step.slab)?;
            Some((*step, Slab::of(test, line)))
        })
    }

    /// What is in the bound: an object's faces, or of a node of a hierarchy the whole scene.
    pub(in crate::figure::kinds) fn objects(&self, figure: &Figure) -> Vec<PrimitiveId> {
        let ids = (0..figure.scene.primitives.len() as u32).map(PrimitiveId);
        let is_inside = |id: &PrimitiveId| match self.of {
            Bounded::Object(object) => figure.scene.primitive(*id).object == object,
            Bounded::Node(_) => true,
        };
        ids.filter(is_inside).collect()
    }
}

/// What a bound is around.
pub(in crate::figure::kinds) fn bounded(figure: &Figure, of: Bounded) -> String {
    match of {
        Bounded::Object(object) => {
            let object = figure.scene.objects.get(object as usize);
            object.map_or(String::new(), |object| scenery::short(&object.name))
        }
        Bounded::Node(node) => format!("node {node}"),
    }
}
