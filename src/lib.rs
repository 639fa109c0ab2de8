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
//! 7. [`mistake`]: what students write instead, each with a name and the right function's signature;
//! 8. [`explain`]: from events to words, and what each strategy costs;
//! 9. [`figure`]: from events to the figures of a lecture; bars of costs and heat maps;
//! 10. [`step`]: a log as a tree of steps, walked forwards and backwards, with the state at each;
//! 11. [`page`]: the steps of a pixel in HTML: the stepper of a book, the page of a picture;
//! 12. [`lesson`]: the course's data, the traces that its figures are drawn from, and its exercises.
//!
//! These are the core: no file system, no clock, no threads but by the feature `threads`. Above it are `files` (the file
//! system), `book` (the preprocessor for mdBook), `tui` (the stepper in a terminal) and the command `raystep` (feature `cli`). What most programs need is at
//! the root; all else is in the module of its layer, and nothing is in both.
//!
//! Equations and figures are numbered as in the course's slides, after Foley, van Dam, Feiner and Hughes,
//! *Computer Graphics: Principles and Practice*, §15.10.
//!
//! # Example
//!
//! The core alone, with `default-features = false`: a pixel of a scene, and its worked solution.
//!
//! ```
//! use raystep::explain::render;
//! use raystep::{Chosen, NoFiles, Settings, Tracer, WorkedOptions};
//! use raystep::{load_bytes, record_pixel, worked_solution};
//!
//! const SCENE: &str = r#"{
//!   "camera": {
//!     "look_at": { "cop": [0, 0, 10], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 },
//!     "pixels": [160, 120]
//!   },
//!   "materials": { "red": { "colour": [0.8, 0.2, 0.2], "diffuse": 0.7 } },
//!   "lights": [ { "name": "lamp", "position": [4, 6, 5], "colour": [1, 1, 1] } ],
//!   "objects": [
//!     { "name": "ball", "material": "red", "shape": { "sphere": { "center": [0, 0, 0], "radius": 2 } } }
//!   ]
//! }"#;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = load_bytes("ball.json", SCENE.as_bytes(), &NoFiles)?.build()?;
//! let settings = Settings::default();
//! let strategy = Chosen::new(&scene, settings.strategy, &settings.structure)?;
//! let tracer = Tracer::new(&scene, &strategy, settings.transport);
//!
//! let budget = 1_000_000;
//! let records = record_pixel(&tracer, [80, 60], settings.through, false, budget)?;
//! let page = worked_solution(&scene, &settings, &records, &WorkedOptions::default());
//! let text = render::plain(&page, render::no_hint);
//! assert!(text.contains("ball"));
//! print!("{text}");
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
pub mod mistake;
pub mod page;
mod parallel;
pub mod scene;
pub mod step;
pub mod strategy;
pub mod structure;
pub mod trace;
pub mod tracer;
#[cfg(feature = "tui")]
pub mod tui;

#[cfg(feature = "book")]
pub use book::preprocessor::preprocess;
pub use explain::page::Page;
pub use explain::worked::options::WorkedOptions;
pub use explain::worked::worked_solution;
pub use figure::sheet::canvas::Rendition;
pub use figure::sheet::sheet::Width;
pub use figure::spec::FigureSpec;
pub use figure::traced::Traced;
#[cfg(feature = "files")]
pub use files::folder::Folder;
#[cfg(feature = "files")]
pub use files::load::{load, open_lessons};
pub use lesson::library::{FigureName, Library};
pub use scene::load::error::LoadError;
pub use scene::load::files::{Files, NoFiles};
pub use scene::load::load_bytes;
pub use scene::scene::Scene;
pub use strategy::by_name::Chosen;
pub use structure::options::StructureOptions;
pub use trace::event::table::Event;
pub use trace::log::reader::LogReader;
pub use trace::log::settings::{Settings, StrategyName, Through, Transport};
pub use trace::record::counts::Counts;
pub use trace::record::recorder::{Off, Record, Recorder, Recording};
pub use tracer::entry::{ChosenTracer, record_log, record_pixel, render_picture};
pub use tracer::stopped::Stopped;
pub use tracer::tracer::Tracer;
