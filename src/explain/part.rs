//! The named parts of each derivation: one table.
//!
//! A line of a worked solution says which part it is, and the first line of a part begins with the name that stands
//! here. Figures, exercises and the messages of a check use the same names.

use std::fmt;

/// The table: one row for each part, in the order of the derivations.
macro_rules! parts {
    ($($(#[doc = $sentence:literal])+ $part:ident = $id:literal, $name:literal;)+) => {
        /// A named part of a derivation.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Part {
            $($(#[doc = $sentence])+ $part,)+
        }

        impl Part {
            /// All parts, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$part),+];

            /// The name for programs: lower-case words with `-` between them.
            pub const fn id(self) -> &'static str {
                match self {
                    $(Self::$part => $id,)+
                }
            }

            /// The short name that people read, with which the part begins in a text: a word, or the symbols that it
            /// computes.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$part => $name,)+
                }
            }

            /// What the part is, in one sentence.
            pub const fn sentence(self) -> &'static str {
                match self {
                    $(Self::$part => concat!($($sentence),+).trim_ascii_start(),)+
                }
            }
        }
    };
}

parts! {
    /// The steps that put the objects into a structure before the first ray.
    Building = "building", "building";

    /// The point at which the pixel's ray passes the window: P = corner + (x/width)·right + (1 − y/height)·up.
    WindowPoint = "window-point", "window point";
    /// The unit vector Δ along the ray, and where it comes from.
    Direction = "direction", "direction";
    /// Equation (i), (x, y, z) = o + t·Δ, with the t that count.
    Ray = "ray", "ray";

    /// The ray as the object sees it: from its centre, divided by its radii, or split along its axis.
    Frame = "frame", "frame";
    /// The coefficients of a·t² + b·t + c = 0, equation (iii).
    Coefficients = "coefficients", "a, b, c";
    /// b² − 4ac: its sign says whether there are two roots, one or none.
    Discriminant = "discriminant", "discriminant";
    /// The t at which the ray hits the surface as if it had no ends.
    Roots = "roots", "roots";
    /// The height of each root over the base of a cone, which ends at its apex.
    Height = "height", "height";
    /// The smallest root that counts is the hit; each other root has its reason.
    Choice = "choice", "root that counts";

    /// The plane A·x + B·y + C·z + D = 0 of the polygon, equation (iv).
    Plane = "plane", "plane";
    /// The t at which the ray hits the plane, equation (v).
    PlaneT = "plane-t", "t";
    /// The point p = o + t·Δ in the plane.
    PlanePoint = "plane-point", "p";
    /// The axis of the largest coefficient, whose coordinate is dropped.
    Axis = "axis", "axis";
    /// The point p′ without the dropped coordinate, in the outline without it.
    Projection = "projection", "p′";
    /// The edges that cross the half-line from p′: an odd number of them means inside.
    Crossings = "crossings", "crossings";
    /// Whether p lies inside the polygon.
    InsideOut = "inside-out", "inside or outside";

    /// S = A·x₀ + B·y₀ + C·z₀ and T = −1/(A·Δx + B·Δy + C·Δz) of the ray and a slab.
    SlabRay = "slab-ray", "S, T";
    /// The t at which the ray enters a slab and leaves it.
    NearFar = "near-far", "near, far";
    /// The t inside all slabs: from the largest near to the smallest far.
    Interval = "interval", "interval";
    /// Whether the ray hits a bounding volume, so that what is inside it is tested.
    Bound = "bound", "bounding volume";
    /// Whether a node of the hierarchy is entered, rejected or pruned.
    Node = "node", "node";
    /// The heap (priority queue) of the nodes that wait, the nearest first.
    Heap = "heap", "heap";

    /// The box of the grid, and the cell in which the ray starts.
    Grid = "grid", "grid";
    /// The cell that the ray is in, from its t in to its t out.
    Cell = "cell", "cell";
    /// The t of the next plane along each axis: the smallest says where the ray leaves the cell.
    NextPlanes = "next-planes", "next planes";
    /// Whether the ray was tested against the object in an earlier cell.
    Mailbox = "mailbox", "mailbox";
    /// A hit beyond the cell's end is kept, and later cells may have a nearer one.
    HitOutside = "hit-outside", "hit outside the cell";
    /// Why the traversal of the cells ends.
    WalkEnd = "walk-end", "end of the traversal";

    /// The frame in which the ray is the z axis.
    Alignment = "alignment", "aligned frame";
    /// A point of an object in that frame.
    AlignedPoint = "aligned-point", "aligned point";
    /// The hits in the order of their z, which is t.
    ZSort = "z-sort", "z sort";
    /// Whether a hit is nearer than all before it.
    Nearest = "nearest", "nearest hit";

    /// The point that the ray hits, with its material and the ε of the rays that start there.
    Point = "point", "point";
    /// The unit normal N at that point, on the ray's side.
    Normal = "normal", "normal";
    /// Whether light reaches the point: nothing is in between, and the surface faces the light.
    Visibility = "visibility", "visibility";
    /// The unit vector L to the light, and N·L.
    ToLight = "to-light", "L, N·L";
    /// light·colour·diffuse·(N·L), or colour·diffuse/π·E where the light has a power.
    Diffuse = "diffuse", "diffuse";
    /// E = Φ·(N·L)/(4π·r²): the power that arrives on a square unit.
    Irradiance = "irradiance", "irradiance";
    /// light·specular·max(0, R·V)^shininess.
    Specular = "specular", "specular";
    /// ambient·colour: the light that comes from everywhere.
    Ambient = "ambient", "ambient";
    /// The sum of the diffuse and the specular terms.
    LightSum = "light-sum", "sum over the visible lights";
    /// Snell's law n₁·sin θ₁ = n₂·sin θ₂, with the two cosines.
    Snell = "snell", "Snell's law";
    /// The direction T of the refracted ray; none under total internal reflection.
    Transmitted = "transmitted", "T";
    /// The colour that the ray returns.
    RayColour = "ray-colour", "colour of the ray";
    /// The colour of the pixel, from the colours of its rays.
    PixelColour = "pixel-colour", "colour of the pixel";

    /// A part of a path, from one surface to the next.
    Leg = "leg", "leg";
    /// Russian roulette: one random number decides how a path goes on.
    Roulette = "roulette", "Russian roulette";
    /// A photon that stays on a diffuse surface.
    Stored = "stored", "stored photon";
    /// G = cos²θ/d² between window and aperture, and the light that arrives there.
    Arrival = "arrival", "arrival";
    /// The stored photons nearest to the point, and the light that they bring.
    Gathered = "gathered", "gathered light";
    /// The part of the surface on which the gathered photons lie.
    Area = "area", "area";
    /// G = cos θ·cos θ′/d²: how much of what leaves one vertex arrives at the other.
    GeometryTerm = "geometry-term", "geometry term";
    /// The balance heuristic: the share of this connection among all that could have made the path.
    Weight = "weight", "weight";
    /// What the connection adds to the pixel.
    Contribution = "contribution", "contribution";
}

impl Part {
    /// The short name at the beginning of a line: `Ambient`.
    pub fn title(self) -> String {
        let mut letters = self.name().chars();
        let first = letters.next().map(|first| first.to_uppercase().to_string());
        first.unwrap_or_default() + letters.as_str()
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What is derived, and the parts that its derivation has, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Derivation {
    /// The name for programs.
    pub id: &'static str,
    /// The parts of the derivation, in the order in which they are worked out.
    pub parts: &'static [Part],
}

/// The derivations of the course.
pub const DERIVATIONS: &[Derivation] = &[
    Derivation {
        id: "eye-ray",
        parts: &[Part::WindowPoint, Part::Direction, Part::Ray],
    },
    Derivation {
        id: "sphere",
        parts: &[
            Part::Frame,
            Part::Coefficients,
            Part::Discriminant,
            Part::Roots,
            Part::Choice,
        ],
    },
    Derivation {
        id: "cone",
        parts: &[
            Part::Frame,
            Part::Coefficients,
            Part::Discriminant,
            Part::Roots,
            Part::Height,
            Part::Choice,
        ],
    },
    Derivation {
        id: "polygon",
        parts: &[
            Part::Plane,
            Part::PlaneT,
            Part::PlanePoint,
            Part::Axis,
            Part::Projection,
            Part::Crossings,
            Part::InsideOut,
        ],
    },
    Derivation {
        id: "box",
        parts: &[Part::NearFar, Part::Interval, Part::Choice],
    },
    Derivation {
        id: "bound",
        parts: &[Part::SlabRay, Part::NearFar, Part::Interval, Part::Bound],
    },
    Derivation {
        id: "hierarchy",
        parts: &[Part::Building, Part::Bound, Part::Heap, Part::Node],
    },
    Derivation {
        id: "grid",
        parts: &[
            Part::Building,
            Part::Grid,
            Part::Cell,
            Part::NextPlanes,
            Part::Mailbox,
            Part::HitOutside,
            Part::WalkEnd,
        ],
    },
    Derivation {
        id: "alignment",
        parts: &[Part::Alignment, Part::AlignedPoint, Part::ZSort],
    },
    Derivation {
        id: "nearest",
        parts: &[Part::Nearest],
    },
    Derivation {
        id: "shade",
        parts: &[
            Part::Point,
            Part::Normal,
            Part::Visibility,
            Part::ToLight,
            Part::Diffuse,
            Part::Irradiance,
            Part::Specular,
            Part::Ambient,
            Part::LightSum,
            Part::RayColour,
            Part::PixelColour,
        ],
    },
    Derivation {
        id: "refraction",
        parts: &[Part::Snell, Part::Transmitted],
    },
    Derivation {
        id: "path",
        parts: &[Part::Leg, Part::Roulette, Part::Stored, Part::Arrival],
    },
    Derivation {
        id: "gathering",
        parts: &[Part::Gathered, Part::Area, Part::Irradiance],
    },
    Derivation {
        id: "connection",
        parts: &[Part::GeometryTerm, Part::Weight, Part::Contribution],
    },
];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn each_part_has_an_id_and_a_name_of_its_own_and_one_sentence() {
        let ids: BTreeSet<_> = Part::ALL.iter().map(|part| part.id()).collect();
        let names: BTreeSet<_> = Part::ALL.iter().map(|part| part.name()).collect();
        assert_eq!([ids.len(), names.len()], [Part::ALL.len(); 2]);
        for part in Part::ALL {
            let is_word = |c: char| c.is_ascii_lowercase() || c == '-';
            assert!(part.id().chars().all(is_word), "{part}");
            let sentence = part.sentence();
            assert!(
                sentence.ends_with('.') && !sentence.contains('\n'),
                "{part}"
            );
            assert!(!sentence.starts_with(' '), "{part}: {sentence}");
        }
        assert_eq!(Part::Ambient.title(), "Ambient");
        assert_eq!(Part::Projection.title(), "P′");
    }

    #[test]
    fn each_part_belongs_to_a_derivation() {
        let of_all: BTreeSet<Part> = DERIVATIONS
            .iter()
            .flat_map(|of| of.parts)
            .copied()
            .collect();
        let known: BTreeSet<Part> = Part::ALL.iter().copied().collect();
        assert_eq!(of_all, known);
    }
}
