//! What is there before a ray is cast: camera, objects, materials and lights.

mod camera;
mod check;
mod faces;
mod fault;
pub mod file;
mod light;
mod load;
mod object;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
mod scene;
mod shapes;

pub use camera::{Camera, WindowCrossing};
pub use fault::{DEEPEST, Fault, LARGEST, MOST_PIXELS, SMALLEST, SceneFault};
pub use file::{Material, Materials, SceneFile};
pub use light::{Emission, Light, PhongTerm};
pub use load::{LoadError, Loaded, Place, load, load_bytes};
pub(crate) use load::{line_of, parse_json};
pub use object::{Normals, Object, Primitive, PrimitiveId, Shape};
pub use scene::{Scene, nearest_name};
