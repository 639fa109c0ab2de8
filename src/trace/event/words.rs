//! The words of the log for each value of an enum, with what each means.
//!
//! `words! { enum … }` declares an enum of the trace with its words; `words! { for … }` gives words to an enum of a
//! layer below. The writer, the reader and the schema know a value by its word alone.

use crate::geometry::{Axis, DecidedBy, RootVerdict};
use crate::structure::{Across, Share, VolumeKind};
use crate::trace::event::fields::Word;

/// Gives each value of an enum its word and its meaning.
macro_rules! words {
    (
        $(#[doc = $what:literal])+
        $visible:vis enum $type:ident: $default:ident by default {
            $($(#[doc = $meaning:literal])+ $value:ident = $word:literal,)+
        }
    ) => {
        $(#[doc = $what])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $visible enum $type { $($(#[doc = $meaning])+ $value),+ }

        impl Default for $type {
            fn default() -> Self {
                Self::$default
            }
        }

        words! { for $type { $($(#[doc = $meaning])+ $value = $word,)+ } }
    };
    (for $type:ident { $($(#[doc = $meaning:literal])+ $value:ident = $word:literal,)+ }) => {
        impl Word for $type {
            const WORDS: &'static [(Self, &'static str, &'static str)] =
                &[$(($type::$value, $word, concat!($($meaning),+))),+];

            #[inline]
            fn place(self) -> usize {
                self as usize
            }
        }

        // the words stand in the order of the values
        const _: () = {
            let mut at = 0;
            while at < $type::WORDS.len() {
                assert!($type::WORDS[at].0 as usize == at);
                at += 1;
            }
        };
    };
}

/// Gives out the word of a value, for words that people read.
macro_rules! readable {
    ($($type:ident),+) => {
        $(impl $type {
            /// The word of the log.
            pub fn word(self) -> &'static str {
                Self::WORDS[self.place()].1
            }
        })+
    };
}

readable! { Purpose, RayVerdict, PhotonVerdict, Visibility, Verdict, Why, NodeVerdict, QueueAction }

words! {
    /// How many real roots an equation has.
    pub(super) enum RootCount: None by default {
        /// None: the discriminant is below 0.
        None = "none",
        /// One double root, at which the ray grazes the surface: the discriminant is 0 within its rounding.
        Graze = "graze",
        /// Two: the ray hits the surface twice.
        Two = "two",
        /// One, of a linear equation: a = 0.
        Linear = "linear",
    }
}

words! {
    /// Is a ray parallel to a slab?
    pub(super) enum Parallel: No by default {
        /// It is not: it crosses both planes of the slab.
        No = "no",
        /// It is, and it runs between the planes or in one of them: every t is inside.
        Inside = "inside",
        /// It is, and it runs outside of the slab: no t is inside.
        Outside = "outside",
    }
}

words! {
    /// Is a ray parallel to a plane?
    pub(super) enum ToPlane: Meets by default {
        /// It is not: its line hits the plane at one t.
        Meets = "no",
        /// It is, and it runs beside the plane.
        Beside = "beside",
        /// It is, and it runs in the plane.
        Within = "in",
    }
}

words! {
    for Axis {
        /// The first coordinate.
        X = "x",
        /// The second coordinate.
        Y = "y",
        /// The third coordinate.
        Z = "z",
    }
}

words! {
    for DecidedBy {
        /// The projected point p': it is further from each edge than its rounding.
        Point = "point",
        /// The ray itself, with exact arithmetic: p' lies too near to an edge.
        Ray = "ray",
    }
}

words! {
    for RootVerdict {
        /// The smallest t that counts: the hit.
        Chosen = "chosen",
        /// t <= 0: behind the origin.
        Behind = "behind",
        /// |t| < epsilon: the surface on which the ray starts.
        BelowEpsilon = "below_epsilon",
        /// Further than the nearest hit so far, than the light, or than this object's nearer root.
        BeyondNearest = "beyond_nearest",
        /// The ray hits the back of a surface of which only the front can be seen.
        BackFace = "back_face",
        /// The ray hits the front of a surface of which only the back can be seen.
        FrontFace = "front_face",
        /// On the infinite cone, but not between its base and its apex.
        BeyondEnds = "beyond_ends",
    }
}

words! {
    /// Why a ray is cast.
    pub enum Purpose: Eye by default {
        /// From the COP through the window.
        Eye = "eye",
        /// From a surface to a light: a shadow ray.
        Shadow = "shadow",
        /// From a surface in the mirror direction.
        Reflected = "reflected",
        /// Through a surface, bent by Snell's law.
        Refracted = "refracted",
        /// From a diffuse surface in a random direction.
        Scattered = "scattered",
        /// From a light, and from surface to surface: one leg of a path of light.
        Light = "light",
        /// Between a path of light and a path from the eye.
        Connection = "connection",
    }
}

words! {
    /// How a ray ended.
    pub enum RayVerdict: Miss by default {
        /// It hits an object.
        Hit = "hit",
        /// It hits no object and sees the background.
        Miss = "miss",
        /// A shadow ray hits an object before its light.
        Blocked = "blocked",
        /// A shadow ray reaches its light.
        ReachesLight = "reaches_light",
        /// It was not traced: the depth limit is reached.
        DepthLimit = "depth_limit",
        /// It hits an object, which absorbs what the ray carries.
        Absorbed = "absorbed",
        /// It hits one surface more than its path may have.
        CutOff = "cut_off",
        /// It connects its two ends: nothing stands between them.
        Connects = "connects",
    }
}

words! {
    /// What becomes of a photon at a surface.
    pub enum PhotonVerdict: Absorbed by default {
        /// It is reflected in the mirror direction.
        Mirrored = "mirrored",
        /// It passes through the surface, bent by Snell's law.
        Refracted = "refracted",
        /// It is reflected diffusely, in a random direction.
        Diffused = "diffused",
        /// The surface absorbs it: its path ends.
        Absorbed = "absorbed",
    }
}

words! {
    /// Does a light reach a point?
    pub enum Visibility: Visible by default {
        /// Its shadow ray reaches it.
        Visible = "visible",
        /// Its shadow ray is blocked.
        Shadowed = "shadowed",
        /// N.L <= 0: the surface faces away, and no shadow ray is cast.
        FacesAway = "faces_away",
        /// The transport casts no rays to lights: the light counts as visible.
        NotTested = "not_tested",
    }
}

words! {
    for VolumeKind {
        /// A bounding sphere.
        Sphere = "sphere",
        /// An ellipsoid with axes in any direction.
        Ellipsoid = "ellipsoid",
        /// A box along the axes of the world.
        Box = "box",
        /// The intersection of slabs.
        Slabs = "slabs",
    }
}

words! {
    /// What became of a test?
    pub enum Verdict: Rejected by default {
        /// The ray hits what was tested, at a t that counts. Of a slab: some t is inside this slab and all before it.
        Hit = "hit",
        /// It does not count: `why` says the reason.
        Rejected = "rejected",
    }
}

words! {
    /// Why was a test rejected? One list for all kinds of tests.
    pub enum Why: NoRoot by default {
        /// The equation has no real root: the ray passes by the surface.
        NoRoot = "no_root",
        /// The largest near is above the smallest far: no t is inside all slabs.
        Empty = "empty",
        /// The ray is parallel to the plane, or to a slab and outside of it.
        Parallel = "parallel",
        /// The ray passes by the bounding volume.
        Missed = "missed",
        /// t <= 0: what was tested lies behind the origin.
        Behind = "behind",
        /// |t| < epsilon: the surface on which the ray starts.
        BelowEpsilon = "below_epsilon",
        /// Further than the nearest hit so far, or than the light.
        BeyondNearest = "beyond_nearest",
        /// The ray hits the back of a surface of which only the front can be seen.
        BackFace = "back_face",
        /// The ray hits the front of a surface of which only the back can be seen.
        FrontFace = "front_face",
        /// On the infinite cone, but not between its base and its apex.
        BeyondEnds = "beyond_ends",
        /// The point of the plane lies outside of the polygon: an even number of crossings.
        Outside = "outside",
    }
}

words! {
    /// What became of a node?
    pub enum NodeVerdict: Rejected by default {
        /// Its children or its objects are tested.
        Entered = "entered",
        /// The ray does not hit its bound in front of the origin.
        Rejected = "rejected",
        /// Its bound begins further away than a hit that is known, or than the light: nothing in it is tested.
        Pruned = "pruned",
    }
}

words! {
    /// What is done with the heap of waiting nodes.
    pub enum QueueAction: Push by default {
        /// A node is put into the heap: it waits.
        Push = "push",
        /// The nearest waiting node is taken out of the heap.
        Pop = "pop",
        /// The nearest waiting node begins further away than the nearest hit: the search ends, and the others are not visited.
        Stop = "stop",
    }
}

words! {
    for Share {
        /// All of the object lies in the cell.
        Whole = "whole",
        /// A part of the object lies in the cell.
        Part = "part",
    }
}

words! {
    for Across {
        /// Across none: the ray ends in the cell.
        None = "none",
        /// Across a plane of x.
        X = "x",
        /// Across a plane of y.
        Y = "y",
        /// Across a plane of z.
        Z = "z",
        /// Across planes of x and y at once: through an edge.
        XY = "xy",
        /// Across planes of x and z at once: through an edge.
        XZ = "xz",
        /// Across planes of y and z at once: through an edge.
        YZ = "yz",
        /// Across three planes at once: through a corner.
        XYZ = "xyz",
    }
}

words! {
    /// Why a walk through the grid ended.
    pub enum WalkEnd: Left by default {
        /// The ray leaves the grid, or its range ends.
        Left = "left",
        /// The nearest hit lies in this cell: no later cell can hold a nearer hit.
        HitInCell = "hit_in_cell",
        /// The ray pierces no cell in its range.
        Outside = "outside",
    }
}

words! {
    /// What an aligned point is of its object.
    pub enum AlignedPart: Center by default {
        /// The center of a sphere, an ellipsoid or a box.
        Center = "center",
        /// A half axis of an ellipsoid or a box: a vector, which turns and does not move.
        HalfAxis = "half_axis",
        /// A vertex of a polygon.
        Vertex = "vertex",
        /// The center of a cone's base.
        Base = "base",
        /// The center of a cone's apex.
        Apex = "apex",
    }
}
