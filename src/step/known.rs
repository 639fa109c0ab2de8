//! All that is known after a step, in words: which rays are open, and each quantity with the step that set it.

use crate::step::address::Address;
use crate::step::quantity::Quantity;
use crate::step::state::State;
use crate::step::tree::StepLog;

/// A quantity that is known after a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The ray whose quantity it is; `None` of one beside the rays.
    pub ray: Option<u32>,
    /// The quantity.
    pub quantity: Quantity,
    /// Its value in words.
    pub value: String,
    /// The step that set it.
    pub by: Address,
}

impl Known {
    /// `ray 0, nearest hit: A at t = 7.92, set by step 37`
    pub fn text(&self, log: &StepLog) -> String {
        let ray = self.ray.map_or(String::new(), |ray| format!("ray {ray}, "));
        let name = self.quantity.name(log.scene);
        format!("{ray}{name}: {}, set by step {}", self.value, self.by)
    }
}

impl StepLog<'_> {
    /// What is known after a step: what belongs to no ray first, then ray by ray, the innermost last.
    pub fn known(&self, step: usize) -> Vec<Known> {
        self.known_in(&self.state_after(step))
    }

    /// What is known before a step.
    pub fn known_before(&self, step: usize) -> Vec<Known> {
        self.known_in(&self.state_before(self.step(step).events.start))
    }

    fn known_in(&self, state: &State) -> Vec<Known> {
        let own = state.quantities.iter().map(|held| (None, held));
        let rays = state.rays.iter().flat_map(|ray| {
            let id = Some(ray.id);
            ray.quantities.iter().map(move |held| (id, held))
        });
        let known = own.chain(rays).map(|(ray, (&quantity, held))| Known {
            ray,
            quantity,
            value: held.value.text(self.scene),
            by: Address::of(self, held.by),
        });
        known.collect()
    }

    /// What is known after a step, a line for each quantity; the open rays come first.
    pub fn view(&self, step: usize) -> Vec<String> {
        let state = self.state_after(step);
        let open: Vec<String> = state.rays.iter().map(|ray| ray.id.to_string()).collect();
        let rays = match open.as_slice() {
            [] => "no ray is open".into(),
            open => format!("open rays: {}", open.join(", ")),
        };
        let known = self.known(step);
        let known = known.iter().map(|known| known.text(self));
        std::iter::once(rays).chain(known).collect()
    }
}
