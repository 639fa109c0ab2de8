//! raystep: a ray tracer that shows its working.

pub mod geometry;
pub mod scene;

pub use geometry::{
    Axis, AxisBox, BoxTest, Cone, DecidedBy, EdgeTest, Ellipsoid, Fate, GRAZE, Plane, PlaneTest,
    PlaneVerdict, Polygon, PolygonError, PolygonTest, QuadraticTest, Ray, Refraction, Root, Roots,
    Sides, SlabInterval, SlabRay, Sphere, TRange, interpolated_normal, mean_value_weights, reflect,
    refract,
};
pub use scene::{
    Camera, Emission, Fault, Light, LoadError, Loaded, Material, Materials, Normals, Object,
    PhongTerm, Primitive, PrimitiveId, Scene, SceneFault, SceneFile, Shape, load, load_bytes,
    nearest_name,
};
