//! The quantities of the state, their values, and which an event changed.

use glam::DVec3;

use crate::scene::PrimitiveId;

/// A quantity of the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// The rays that have started and not ended, the innermost last.
    Rays,
    /// What is carried: the power of a photon in watts, or the weight of a path from the eye.
    Carried,
    /// What arrives at the eye, or a connecting line brings.
    Contribution,
    /// The colour that the eye ray returns; the last one, where the pixel has several.
    EyeColour,
    /// The colour of the pixel, before it is cut to 0..1.
    PixelColour,
    /// The nearest hit so far, with its t.
    Nearest,
    /// The largest near of the slabs of the bound that is tested.
    MaxNear,
    /// The smallest far of the slabs of the bound that is tested.
    MinFar,
    /// The crossings of the polygon that is tested.
    Crossings,
    /// The node that is visited.
    Node,
    /// The cell that is visited, with the t at which the ray enters and leaves it.
    Cell,
    /// The nodes that wait: the heap, or the stack of a depth-first traversal.
    Waiting,
    /// The objects whose mailbox has the number of this ray.
    Mailboxes,
    /// The term of a light that is visible; 0 of one that is not.
    Light(u32),
    /// The light that was gathered from photons.
    Gathered,
    /// ambient·colour.
    Ambient,
    /// The sum over the visible lights.
    LightSum,
    /// The weight of the reflected ray.
    Reflection,
    /// The weight of the refracted ray.
    Transmission,
    /// The colour that the reflected ray returns.
    Reflected,
    /// The colour that the refracted ray returns.
    Refracted,
}

/// The value of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A hit: which object, and at which t.
    Hit(PrimitiveId, f64),
    /// A number.
    Number(f64),
    /// How many.
    Count(u32),
    /// A node of the hierarchy; the root is 0.
    Node(u32),
    /// A cell, and the t at which the ray enters and leaves it; ∞ if it never does.
    Cell([u32; 3], [f64; 2]),
    /// Nodes, each with the t at which the ray enters its bound.
    Nodes(Vec<(u32, f64)>),
    /// Objects, in the order of the scene.
    Objects(Vec<PrimitiveId>),
    /// Rays by their numbers.
    Rays(Vec<u32>),
    /// A colour, a power or a weight: red, green and blue.
    Colour(DVec3),
}

/// A value, and which event set it last.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// The value.
    pub value: Value,
    /// The place of the event among the records.
    pub by: usize,
}

/// Which quantities an event changed, a bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::step) struct Changed(u32);

impl Changed {
    pub(in crate::step) fn of(quantities: &[Quantity]) -> Self {
        let bits = quantities.iter().map(|quantity| quantity.bit());
        Self(bits.fold(0, |all, bit| all | bit))
    }

    #[must_use]
    pub(in crate::step) fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Is something changed beside these?
    pub(in crate::step) fn beside(self, these: Self) -> bool {
        self.0 & !these.0 != 0
    }
}

impl Quantity {
    fn bit(self) -> u32 {
        let place = match self {
            Self::Rays => 0,
            Self::Carried => 1,
            Self::Contribution => 2,
            Self::EyeColour => 3,
            Self::PixelColour => 4,
            Self::Nearest => 5,
            Self::MaxNear => 6,
            Self::MinFar => 7,
            Self::Crossings => 8,
            Self::Node => 9,
            Self::Cell => 10,
            Self::Waiting => 11,
            Self::Mailboxes => 12,
            Self::Light(_) => 13,
            Self::Gathered => 14,
            Self::Ambient => 15,
            Self::LightSum => 16,
            Self::Reflection => 17,
            Self::Transmission => 18,
            Self::Reflected => 19,
            Self::Refracted => 20,
        };
        1 << place
    }
}
