//! The words of the log for each value of an enum.

use crate::geometry::{Axis, DecidedBy, Fate};
use crate::trace::fields::Word;
use crate::trace::kinds::{Parallel, RootCount, ToPlane};
use crate::trace::{Outcome, Purpose, Visibility};

/// Gives each value of an enum its word.
macro_rules! words {
    ($type:ident { $($value:ident = $word:literal),+ $(,)? }) => {
        impl Word for $type {
            const WORDS: &'static [(Self, &'static str)] = &[$(($type::$value, $word)),+];
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
});
words!(Outcome {
    Hit = "hit",
    Miss = "miss",
    Blocked = "blocked",
    ReachesLight = "reaches_light",
    DepthLimit = "depth_limit",
});
words!(Visibility {
    Visible = "visible",
    Shadowed = "shadowed",
    FacesAway = "faces_away",
    NotTested = "not_tested",
});
