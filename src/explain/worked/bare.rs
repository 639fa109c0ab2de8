//! Bounds as they are around their objects: without the room for rounding with which they are decided.
//!
//! What a log holds of a bound is what decided. A reader sees the bound itself, from D_min and D_max in the log, or
//! from the volume built again from the scene in it.

use crate::explain::worked::context::Context;
use crate::explain::worked::steps::Course;
use crate::geometry::{Inside, MOST_SLABS, Ray};
use crate::structure::{
    Hierarchy, RaySlabs, SlabChoice, SlabSet, SlabStep, Volume, VolumeKind, VolumeRay,
};
use crate::trace::{BoundTest, Bounded, Event, SlabTest, StrategyName};

impl Course {
    /// Adds a step of the search to what is known of the bound that is tested.
    pub(super) fn follow_slabs(&mut self, event: &Event) {
        let Event::SlabTest(SlabTest { of, step }) = event else {
            return;
        };
        let goes_on = self.slabs.first().is_some_and(|(bound, _)| bound == of) && 0 < step.slab;
        if !goes_on {
            self.slabs.clear();
        }
        let before = self.slabs.last().map(|(_, step)| step);
        let line = self.slab_rays.iter().find(|line| line.slab == step.slab);
        // without S and T, in a log that somebody filtered, what decided is all there is
        let bare = line.map_or(*step, |line| step.without_room(&line.line(), before));
        self.slabs.push((*of, bare));
    }

    /// The last slab of a bound that was tested, without room.
    pub(super) fn bare_slab(&self, test: &SlabTest) -> SlabStep {
        match self.slabs.last() {
            Some((of, step)) if *of == test.of && step.slab == test.step.slab => *step,
            _ => test.step,
        }
    }
}

/// Where the ray is inside a volume, without its room; `None` if it passes by.
pub(super) fn bare_inside(
    context: &Context,
    test: &BoundTest,
    course: &Course,
) -> Option<[f64; 2]> {
    let slabs = course.slabs.iter().filter(|(of, _)| *of == test.of);
    let mut slabs = slabs.map(|(_, step)| step.inside());
    let inside = if let Some(first) = slabs.next() {
        // one that it misses is enough
        slabs.fold(first, Option::and)
    } else if let Some(start) = course.start
        && let Some(set) = slab_set(context)
    {
        built_again(context, test, &start.ray, &set)
    } else {
        return test.inside;
    };
    inside.and_then(|inside| inside.ends())
}

/// The same where the log has no slabs of it: from the volume itself.
fn built_again(
    context: &Context,
    test: &BoundTest,
    ray: &Ray,
    set: &SlabSet<MOST_SLABS>,
) -> Option<Inside> {
    match test.of {
        Bounded::Object(object) => {
            context.scene.objects.get(object as usize)?;
            let volume = Volume::around(context.scene, object as usize, test.volume, set);
            volume.inside(&VolumeRay::new(ray, set, 0.0), set)
        }
        Bounded::Node(node) => {
            let build = context.settings.structure.build;
            let built = || Hierarchy::new(context.scene, set, build);
            let node = context
                .again
                .hierarchy
                .get_or_init(built)
                .nodes()
                .get(node as usize)?;
            node.bound.inside(&RaySlabs::new(ray, set, 0.0), set)
        }
    }
}

/// The directions of the slabs that the log's strategy has.
fn slab_set(context: &Context) -> Option<SlabSet<MOST_SLABS>> {
    let options = &context.settings.structure;
    let is_box =
        context.settings.strategy == StrategyName::Bounds && options.volume != VolumeKind::Slabs;
    let directions = match options.slabs {
        _ if is_box => SlabSet::AXES.directions(),
        SlabChoice::Axes => SlabSet::AXES.directions(),
        SlabChoice::Seven => SlabSet::SEVEN.directions(),
        SlabChoice::Scene => context.scene.slabs.as_deref()?,
    };
    SlabSet::of(directions).ok()
}
