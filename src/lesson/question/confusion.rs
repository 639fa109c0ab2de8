//! What students confuse: twenty things, the most frequent first, each with the mistakes that come of it.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

macro_rules! confusions {
    ($($(#[doc = $what:literal])+ $name:ident: [$($mistake:literal),*],)+) => {
        /// What students confuse.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(JsonSchema))]
        #[serde(rename_all = "kebab-case")]
        pub enum Confusion { $($(#[doc = $what])+ $name),+ }

        impl Confusion {
            /// All of them, the most frequent first.
            pub const ALL: &[Self] = &[$(Self::$name),+];

            /// The names of the mistakes that come of it.
            pub fn mistakes(self) -> &'static [&'static str] {
                match self { $(Self::$name => &[$($mistake),*]),+ }
            }

            /// What it is about, in a few words.
            pub fn title(self) -> &'static str {
                match self { $(Self::$name => concat!($($what),+).trim_ascii()),+ }
            }
        }
    };
}

confusions! {
    /// The factors 2 and 4 in b² − 4ac, the form with half of b, and the sign of o − c.
    QuadraticFactors: ["half b in the full formula", "c − o without the turned sign"],
    /// Shadow acne and ε: why it is needed, how large it is, in what it is measured.
    ShadowEpsilon: ["no ε", "ε in t of an unnormalised ray", "offset to the wrong side", "ε not scaled"],
    /// Refraction: which index is which on the way out, which side the normal is on, total reflection.
    RefractionSide: ["ratio never inverted", "normal not turned", "root of a negative number"],
    /// Which root counts; the eye inside the sphere; both roots behind.
    WhichRoot: ["first root always", "largest root", "inside is a miss"],
    /// Axes, handedness, a picture that is upside down or mirrored.
    PictureAxes: ["row from below", "u and v swapped", "w turned"],
    /// The shade: the directions of L and V, terms that are cut off at 0, the ambient term.
    ShadingTerms: ["L from light to point", "only the sum clamped", "ambient in the loop", "R made of V"],
    /// Point in polygon: a vertex or an edge that counts twice, the coordinate that is dropped.
    PointInPolygon: ["vertex twice", "axis of the smallest coefficient", "≤ at both ends"],
    /// The walk through a grid: negative directions, the first plane, where it ends.
    GridWalk: ["next plane always +1", "steps the largest t", "no end test", "two axes at once"],
    /// The normal: to which side, from which point, of which length.
    Normal: ["p instead of p − c", "not divided by r", "cross product turned"],
    /// The slab: a parallel ray, 0·∞, near and far for a negative direction.
    SlabInterval: ["divides by zero", "no swap", "running interval thrown away"],
    /// The shadow ray: from where, one for each light, a blocker beyond the light.
    ShadowRay: ["any hit counts", "from the eye", "first light only"],
    /// What t measures: a distance, or parts of a direction that has no unit length.
    WhatTMeasures: ["t kept after normalising", "ε not scaled"],
    /// The hierarchy: the first hit is not the nearest; both children; their order.
    FirstHitInTree: ["stops at the first leaf", "last hit wins", "one child only"],
    /// The eye ray: half a pixel, the corner or the centre.
    PixelCentre: ["no ½", "n − 1", "aspect twice"],
    /// The reflection: its sign, unit vectors, towards the surface or away.
    ReflectionSign: ["plus 2", "N not unit", "D turned"],
    /// The recursion: when it stops, what adds up, a picture that is too bright or black.
    RecursionEnd: ["no weight", "background at the limit"],
    /// A box that is hit is not an object that is hit; an origin inside; the t of a box.
    BoundHit: ["near < 0 is a miss", "t of the box taken as the hit"],
    /// The plane: behind the eye, parallel beside it or in it.
    PlaneCases: ["no parallel case", "negative t kept", "sign of D"],
    /// The ends of ranges: > or ≥, a graze, closed or open.
    RangeEnds: ["graze is two hits"],
    /// Balls at the rim of a wide picture look like eggs, and the code is right.
    EggsAtTheRim: [],
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mistake::mistake;

    #[test]
    fn each_of_the_twenty_has_mistakes_but_the_last_which_is_none() {
        assert_eq!(Confusion::ALL.len(), 20);
        for of in Confusion::ALL {
            assert_eq!(of.mistakes().is_empty(), *of == Confusion::EggsAtTheRim);
            for name in of.mistakes() {
                assert!(mistake(name).is_some(), "{name}");
            }
            assert!(of.title().ends_with('.'), "{}", of.title());
        }
    }
}
