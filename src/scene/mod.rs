//! What is there before a ray is cast: camera, objects, materials and lights.

mod camera;
mod check;
mod faces;
mod fault;
pub mod file;
mod light;
pub(crate) mod load;
mod object;
mod printable;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
pub(crate) mod scene;
mod shapes;
#[cfg(test)]
pub(crate) mod small_scene;

pub use camera::{Camera, WindowCrossing};
pub use fault::{DEEPEST, Fault, LARGEST, MOST_PIXELS, SMALLEST, SceneFault};
pub use file::{Material, Materials, SceneFile};
pub use light::{Emission, Light, PhongTerm};
pub(crate) use load::Files;
pub(crate) use load::LoadError;
#[cfg(test)]
pub(crate) use load::files::NoFiles;
pub(crate) use load::load_bytes;
pub use load::{
    IsOutside, LARGEST_FILE, LONGEST_LINE, Loaded, Place, ReadEnd, SchemaOf, read_up_to,
};
pub(crate) use load::{gibibytes, line_of, parse_json, text_of};
pub use object::{Normals, Object, Primitive, PrimitiveId, Shape};
pub use printable::printable;
pub(crate) use printable::quoted;
pub(crate) use scene::Scene;
pub use scene::nearest_name;
