//! The scene file: the types that JSON, NFF and OBJ are read into and that the log's header holds.
//!
//! Unknown keys are errors, enums are externally tagged and nothing is flattened, so that a mistake can
//! be named with its path and line. What is read here has the right form; whether it makes sense is
//! asked by [`Scene::new`](crate::scene::Scene::new).

#[cfg(feature = "schema")]
use std::borrow::Cow;
use std::fmt;

#[cfg(feature = "schema")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde::{Serialize, Serializer};
use smol_str::SmolStr;

use crate::geometry::Sides;
pub use crate::scene::faces::{Face, FaceList, Points};

/// A whole scene.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// What the scene shows, for titles.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// The eye, the window and its division into pixels.
    pub camera: CameraFile,
    /// The colour of a ray that hits nothing.
    #[serde(default)]
    pub background: [f64; 3],
    /// The ambient light in red, green and blue: it reaches every surface from all directions.
    #[serde(default)]
    pub ambient: [f64; 3],
    /// The point lights, in the order in which their terms are summed.
    #[serde(default)]
    pub lights: Vec<LightFile>,
    /// The materials by name.
    #[serde(default)]
    pub materials: Materials,
    /// The objects. Of two at equal t the first one wins.
    pub objects: Vec<ObjectFile>,
    /// The largest depth of a ray; an eye ray has depth 1.
    #[serde(default = "default_depth")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = 100)))]
    pub max_depth: u32,
    /// The scene's own set of slabs for bounding volumes: their directions, [A, B, C] in space, or all
    /// [A, B] in the plane of x and y.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<Vec<f64>>"))]
    pub slabs: Option<Vec<Vec<f64>>>,
}

/// The depth of the published statistics.
fn default_depth() -> u32 {
    5
}

/// The eye and the window: exactly one of `look_at` and `window`.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{"required": ["look_at"]}, {"required": ["window"]}])))]
pub struct CameraFile {
    /// A window straight ahead.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "LookAt"))]
    pub look_at: Option<LookAt>,
    /// An arbitrary window, as the slides have it.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Window"))]
    pub window: Option<Window>,
    /// Width and height of the picture in pixels.
    #[cfg_attr(feature = "schema", schemars(inner(range(min = 1))))]
    pub pixels: [u32; 2],
}

/// A window at distance 1 in front of the eye, across the line of sight.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LookAt {
    /// The centre of projection: the eye.
    pub cop: [f64; 3],
    /// The point in the middle of the picture.
    pub target: [f64; 3],
    /// The direction that is up in the picture; need not be perpendicular to the line of sight.
    pub up: [f64; 3],
    /// The vertical angle that the window's full height spans.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180)))]
    pub fov_degrees: f64,
}

/// A window anywhere: off-axis and tilted if so wanted.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// The centre of projection: the eye.
    pub cop: [f64; 3],
    /// The window's lower left corner.
    pub corner: [f64; 3],
    /// From the lower left corner to the lower right one.
    pub right: [f64; 3],
    /// From the lower left corner to the upper left one.
    pub up: [f64; 3],
}

/// A point light: exactly one of `colour` and `power`.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{"required": ["colour"]}, {"required": ["power"]}])))]
pub struct LightFile {
    /// Its name in the log; `light-N` if absent.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Where it stands, in world coordinates.
    pub position: [f64; 3],
    /// Its intensity, the same at every distance.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "[f64; 3]", inner(range(min = 0))))]
    pub colour: Option<[f64; 3]>,
    /// Φ in watts, sent out alike in all directions.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "f64", extend("exclusiveMinimum" = 0)))]
    pub power: Option<f64>,
}

/// What a surface does with light. Coefficients that are absent are 0, the index 1.
#[doc(alias = "BRDF")]
#[doc(alias = "BSDF")]
#[derive(Clone, Copy, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// The colour of ambient and diffuse light, 0 to 1 each.
    #[cfg_attr(feature = "schema", schemars(inner(range(min = 0))))]
    pub colour: [f64; 3],
    /// The weight of the diffuse term.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub diffuse: f64,
    /// The weight of the specular term.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub specular: f64,
    /// The exponent of the specular term.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub shininess: f64,
    /// The weight of the reflected ray.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub reflection: f64,
    /// The weight of the refracted ray; above 0 the object is not opaque.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub transmission: f64,
    /// The index of refraction inside. Outside of every object it is 1; what lies in another object is
    /// not distinguished.
    #[serde(default = "default_index")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub index: f64,
}

/// Vacuum.
fn default_index() -> f64 {
    1.0
}

/// An object of the scene.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ObjectFile {
    /// Its name in the log; no two objects share one.
    #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
    pub name: SmolStr,
    /// The name of its material.
    pub material: SmolStr,
    /// The shape of the object, with its coordinates in the world.
    pub shape: ShapeFile,
    /// Which sides of its surface can be seen.
    #[serde(default, skip_serializing_if = "SidesFile::is_both")]
    pub sides: SidesFile,
}

/// Which sides of a surface can be seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum SidesFile {
    /// Both.
    #[default]
    Both,
    /// Only the side that the normal points to.
    Front,
    /// Only the other side: the inside of a solid (a negative radius in NFF).
    Back,
}

impl SidesFile {
    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "the signature serde calls"
    )]
    fn is_both(&self) -> bool {
        *self == Self::Both
    }
}

impl From<SidesFile> for Sides {
    fn from(sides: SidesFile) -> Self {
        match sides {
            SidesFile::Both => Self::Both,
            SidesFile::Front => Self::Front,
            SidesFile::Back => Self::Back,
        }
    }
}

impl From<Sides> for SidesFile {
    fn from(sides: Sides) -> Self {
        match sides {
            Sides::Both => Self::Both,
            Sides::Front => Self::Front,
            Sides::Back => Self::Back,
        }
    }
}

/// The form of an object.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum ShapeFile {
    /// All points at one distance from a center.
    Sphere {
        /// Its center.
        center: [f64; 3],
        /// Its radius.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        radius: f64,
    },
    /// A sphere stretched along the axes.
    Ellipsoid {
        /// Its center.
        center: [f64; 3],
        /// Its radii along x, y and z.
        #[cfg_attr(feature = "schema", schemars(extend("items" = {"type": "number", "exclusiveMinimum": 0})))]
        radii: [f64; 3],
    },
    /// A rectangular solid along the axes.
    Box {
        /// Its smallest coordinates.
        min: [f64; 3],
        /// Its largest coordinates.
        max: [f64; 3],
    },
    /// An open cone, frustum or cylinder.
    Cone {
        /// The middle of the base circle.
        base: [f64; 3],
        /// The radius of the base circle.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        base_radius: f64,
        /// The middle of the apex circle.
        apex: [f64; 3],
        /// The radius of the apex circle; 0 for a tip.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        apex_radius: f64,
    },
    /// A planar polygon, convex or concave.
    Polygon(PolygonFile),
    /// Many polygons under one name.
    Mesh(MeshFile),
}

/// A planar polygon.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PolygonFile {
    /// Its vertices, counter-clockwise from the front.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 3]>", length(min = 3)))]
    pub vertices: Points,
    /// One normal per vertex, for smooth shading.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 3]>"))]
    pub normals: Option<Box<[[f64; 3]]>>,
}

/// A mesh: exactly one of `file` and `faces`.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", schemars(extend("oneOf" = [{"required": ["file"]}, {"required": ["faces"]}])))]
pub struct MeshFile {
    /// A Wavefront OBJ file, relative to the scene file.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub file: Option<String>,
    /// The faces themselves.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "given"
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<PolygonFile>"))]
    pub faces: Option<FaceList>,
}

/// A key that is there has a value: null is refused.
fn given<'de, T: Deserialize<'de>, D: Deserializer<'de>>(input: D) -> Result<Option<T>, D::Error> {
    T::deserialize(input).map(Some)
}

/// Materials by name, in the order of the file. A name that comes twice is an error.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Materials(pub Vec<(String, Material)>);

impl Serialize for Materials {
    fn serialize<S: Serializer>(&self, output: S) -> Result<S::Ok, S::Error> {
        output.collect_map(self.0.iter().map(|(name, material)| (name, material)))
    }
}

impl<'de> Deserialize<'de> for Materials {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct ByName;
        impl<'de> Visitor<'de> for ByName {
            type Value = Materials;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a map of materials by name")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Materials, A::Error> {
                let mut materials: Vec<(String, Material)> = Vec::new();
                while let Some((name, material)) = map.next_entry::<String, Material>()? {
                    if materials.iter().any(|(known, _)| *known == name) {
                        let message = format!("two materials are called {name:?}: rename one");
                        return Err(serde::de::Error::custom(message));
                    }
                    materials.push((name, material));
                }
                Ok(Materials(materials))
            }
        }
        input.deserialize_map(ByName)
    }
}

#[cfg(feature = "schema")]
impl JsonSchema for Materials {
    fn schema_name() -> Cow<'static, str> {
        "Materials".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let material = generator.subschema_for::<Material>();
        json_schema!({
            "description": "Materials by name.",
            "type": "object",
            "additionalProperties": material
        })
    }
}
