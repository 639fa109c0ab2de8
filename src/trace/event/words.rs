//! The words of the log for each value of an enum.

use crate::geometry::{Axis, DecidedBy, Fate};
use crate::structure::{Across, Share, SlabOutcome, VolumeKind};
use crate::trace::event::fields::{QuotedWord, Word};
use crate::trace::event::kinds::{Parallel, RootCount, ToPlane};
use crate::trace::{
    AlignedPart, BoundOutcome, NodeOutcome, Outcome, PhotonFate, Purpose, QueueAction, Visibility,
    WalkEnd,
};

/// A word between its quotation marks.
const fn quoted(word: &str) -> QuotedWord {
    QuotedWord::EMPTY
        .with(word.as_bytes())
        .expect("longer than any word")
}

/// Gives each value of an enum its word.
macro_rules! words {
    ($type:ident { $($value:ident = $word:literal),+ $(,)? }) => {
        impl Word for $type {
            const WORDS: &'static [(Self, &'static str)] = &[$(($type::$value, $word)),+];

            #[inline]
            fn quoted(self) -> &'static QuotedWord {
                match self {
                    $($type::$value => const { &quoted(concat!("\"", $word, "\"")) }),+
                }
            }
        }
    };
}

words!(RootCount { None = "none", Graze = "graze", Two = "two", Linear = "linear" });
words!(Parallel { No = "no", Inside = "inside", Outside = "outside" });
words!(ToPlane { Meets = "no", Beside = "beside", Within = "in" });
words!(Axis { X = "x", Y = "y", Z = "z" });
words!(DecidedBy { Point = "point", Ray = "ray" });
words!(Fate {
    Chosen = "chosen",
    Behind = "behind",
    BelowEpsilon = "below_epsilon",
    BeyondNearest = "beyond_nearest",
    BackFace = "back_face",
    FrontFace = "front_face",
    BeyondEnds = "beyond_ends",
});
words!(Purpose {
    Eye = "eye",
    Shadow = "shadow",
    Reflected = "reflected",
    Refracted = "refracted",
    Scattered = "scattered",
    Light = "light",
    Connection = "connection",
});
words!(Outcome {
    Hit = "hit",
    Miss = "miss",
    Blocked = "blocked",
    ReachesLight = "reaches_light",
    DepthLimit = "depth_limit",
    Absorbed = "absorbed",
    CutOff = "cut_off",
    Connects = "connects",
});
words!(PhotonFate {
    Mirrored = "mirrored",
    Refracted = "refracted",
    Diffused = "diffused",
    Absorbed = "absorbed",
});
words!(Visibility {
    Visible = "visible",
    Shadowed = "shadowed",
    FacesAway = "faces_away",
    NotTested = "not_tested",
});
words!(VolumeKind { Sphere = "sphere", Ellipsoid = "ellipsoid", Box = "box", Slabs = "slabs" });
words!(BoundOutcome { Hit = "hit", Missed = "missed", Behind = "behind", Beyond = "beyond" });
words!(SlabOutcome {
    GoesOn = "goes_on",
    Null = "null",
    ParallelInside = "parallel_inside",
    ParallelOutside = "parallel_outside",
});
words!(NodeOutcome { Entered = "entered", Rejected = "rejected", Pruned = "pruned" });
words!(QueueAction { Push = "push", Pop = "pop", Stop = "stop" });
words!(Share { Whole = "whole", Part = "part" });
words!(Across {
    None = "none",
    X = "x",
    Y = "y",
    Z = "z",
    XY = "xy",
    XZ = "xz",
    YZ = "yz",
    XYZ = "xyz",
});
words!(WalkEnd { Left = "left", HitInCell = "hit_in_cell", Outside = "outside" });
words!(AlignedPart {
    Center = "center",
    HalfAxis = "half_axis",
    Vertex = "vertex",
    Base = "base",
    Apex = "apex",
});
