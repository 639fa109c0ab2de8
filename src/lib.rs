//! raystep is a ray tracer that shows its working.
//!
//! It traces a scene as a lecture on ray tracing describes it and records every step: each ray, each
//! coefficient and root of a sphere test, each rejected parallel plane, each edge of a polygon, each term
//! of the shade. From that record, and from nothing else, it prints a worked solution.
//!
//! # In reading order
//!
//! 1. [`geometry`]: the ray (i), the sphere (ii) (iii), the plane (iv) (v) and the polygon (Fig. 15.57), each
//!    test a pure function that returns its working;
//! 2. [`scene`]: the camera with its window, objects, materials and lights, and the file they come from;
//! 3. [`structure`]: what is built over a scene before any ray: slabs (Fig. 15.58), hierarchies, the grid
//!    (Fig. 15.61);
//! 4. [`trace`]: what can happen to a ray, who records it, and the log as JSON Lines;
//! 5. [`strategy`]: which objects a ray is tested against: every one (Fig. 15.56), or only those that a
//!    structure leaves;
//! 6. [`tracer`]: what a hit leads to: shadow rays, reflection, refraction; pixels and pictures;
//! 7. [`explain`]: from events to words, and what each strategy costs;
//! 8. [`figure`]: from events to the figures of a lecture; bars of costs and heat maps;
//! 9. [`lesson`]: the course's data, and the traces that its figures are drawn from;
//! 10. [`book`]: the preprocessor for mdBook.
//!
//! Equations and figures are numbered as in the course's slides, after Foley, van Dam, Feiner and Hughes,
//! *Computer Graphics: Principles and Practice*, §15.10.
//!
//! # Example
//!
//! ```
//! use std::path::Path;
//!
//! use raystep::explain::render;
//! use raystep::{Exhaustive, Recording, Settings, Through, Tracer, Transport, WorkedOptions};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = raystep::load(Path::new("lessons/04-sphere/scene.json"))?.build()?;
//! let strategy = Exhaustive::new(&scene);
//! let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
//!
//! let mut recording = Recording::new(Vec::new());
//! raystep::trace_pixel(&tracer, [80, 60], Through::Centres, &mut recording)?;
//! let records = recording.into_sink();
//!
//! let options = WorkedOptions::default();
//! let page = raystep::worked_solution(&scene, &Settings::default(), &records, &options);
//! let text = render::plain(&page, render::no_hint);
//! assert!(text.contains("t = (-b ± √3.9973506)/2a"));
//! # Ok(())
//! # }
//! ```

#[cfg(feature = "book")]
pub mod book;
pub mod explain;
pub mod figure;
#[cfg(feature = "files")]
pub mod files;
pub mod geometry;
pub mod lesson;
mod parallel;
pub mod scene;
pub mod strategy;
pub mod structure;
pub mod trace;
pub mod tracer;

#[cfg(feature = "book")]
pub use book::{BookError, BookMistake, BookOptions, Preprocessed, preprocess};
pub use explain::{
    Compared, Comparison, Cost, CrowdedCell, DERIVATIONS, Derivation, ErrorOf, Fold, InAdvance,
    Line, Page, Part, Section, StepAddress, StepRange, Tone, TransportComparison, TransportCost,
    Unfold, WorkedOptions, counts_json, counts_text, grouped, in_advance, in_advance_json,
    in_advance_text, pixel_json, strategies_to_compare, strategy_title, worked_solution,
};
pub use figure::{
    Drawn, DroppedAxis, FigureError, FigureKind, FigureSpec, Layer, OF_EVERY_PIXEL, Raster,
    Rendition, Traced, View, Width, cost_chart, draw, heat_map, text_width,
};
#[cfg(feature = "files")]
pub use files::{Folder, load, open_lessons};
pub use geometry::{
    AlignedRay, AlignedSlab, Alignment, Axis, AxisBox, BoxTest, Cone, DecidedBy, EdgeTest,
    Ellipsoid, GRAZE, Inside, MOST_SLABS, OrientedEllipsoid, Plane, PlaneTest, PlaneVerdict,
    Polygon, PolygonError, PolygonTest, QuadraticTest, Ray, Refraction, Root, RootVerdict, Roots,
    Sides, SlabInterval, SlabRay, SlabSetError, Sphere, TRange, disc_in_polygon,
    interpolated_normal, mean_value_weights, polygon_in_rectangle, reflect, refract,
    slab_directions,
};
#[cfg(feature = "schema")]
pub use lesson::lesson_schema;
pub use lesson::{
    FigureName, Lesson, LessonError, LessonFile, Library, NotCompared, compare, compare_transports,
    light_of_lamps, scan_lines_to_compare, trace_figure,
};
pub use scene::{
    Camera, Emission, Fault, Files, IsOutside, LARGEST_FILE, LONGEST_LINE, Light, LoadError,
    Loaded, Material, Materials, NoFiles, Normals, Object, PhongTerm, Place, Primitive,
    PrimitiveId, ReadEnd, Scene, SceneFault, SceneFile, Shape, WindowCrossing, load_bytes,
    nearest_name, printable, read_up_to,
};
pub use strategy::{
    AnyHit, BoundedObjects, Chosen, DepthFirst, Exhaustive, HeapOrdered, Hit, NearestSoFar, Search,
    Strategy, UniformGrid, ZAligned, test_primitive,
};
pub use structure::{
    Across, AssignStep, Build, CellStep, Grid, GridError, GridOptions, GridWalk, Hierarchy, Link,
    Lists, MOST_CELLS, MOST_CELLS_ALONG, MergeStep, Neighbour, Node, Placed, PointTree, RaySlabs,
    Share, SlabBound, SlabChoice, SlabSet, SlabStep, SlabVerdict, StructureError, StructureOptions,
    Volume, VolumeKind, VolumeRay, extent,
};
pub use trace::{
    Aligned, AlignedPart, Alternative, Arrival, BoundTest, BoundVerdict, Bounded, Budget,
    CellVisit, Connection, Counts, Event, Filter, Gathered, GridEnter, GridExit, HitOutsideCell,
    Item, Kind, Kinds, LightCount, LightOptions, LightTerm, LineSink, LogError, LogNames,
    LogReader, Nearby, Nearest, NodeVerdict, NodeVisit, Off, PathSieve, PathStart, Photon,
    PhotonVerdict, PixelColour, PixelSample, Purpose, QueueAction, QueueStep, RayCount, RayEnd,
    RayNode, RaySlab, RayStart, RayTree, RayVerdict, Record, Recorder, Recording, Region, Settings,
    Shade, Sink, SlabTest, Stored, StrategyName, TestCount, Through, Transport, UsefulRays,
    Verdict, Visibility, WalkEnd, Why, ZSort, begins_log, geometry_term, write_log_head,
};
#[cfg(feature = "schema")]
pub use trace::{scene_schema, trace_schema};
pub use tracer::{
    ChosenTracer, EPSILON, Heat, HeatLine, HeatOf, LightError, LightPass, LightSetting, LogOptions,
    LogStopped, LoggedPaths, MAX_RAYS, MOST_SURFACES, Picture, Stopped, StoredLight, StoredPhoton,
    Surface, Tracer, check_light, check_light_of, eye_samples, follow_light, heat_values,
    paths_behind, paths_behind_region, record_log, record_pixel, render, render_heat,
    render_picture, simple, start_epsilon, trace_pixel, write_log,
};
