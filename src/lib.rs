//! raystep: a ray tracer that shows its working.

pub mod geometry;
pub mod scene;
pub mod strategy;
pub mod trace;
pub mod tracer;

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
pub use strategy::{Exhaustive, Hit, NearestSoFar, Strategy, test_primitive};
pub use trace::{
    Budget, Counts, Event, Filter, Item, Kind, Kinds, LightTerm, LineSink, LogError, LogNames,
    LogReader, Nearest, Off, Outcome, PixelColour, PixelSample, Purpose, RayCount, RayEnd, RayNode,
    RayStart, RayTree, Record, Recorder, Recording, Region, Settings, Shade, Sink, StrategyName,
    TestCount, Through, Transport, Visibility, begins_log, scene_schema, trace_schema,
    write_log_head,
};
pub use tracer::{
    EPSILON, LogOptions, LogStopped, Picture, Tracer, eye_samples, render, start_epsilon,
    trace_pixel, write_log,
};
