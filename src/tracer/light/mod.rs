//! From the lamps into the scene: forward, stored on surfaces, and connected with the eye.

pub(in crate::tracer) mod all_paths;
mod balance_heuristic;
mod chance;
mod flat_face;
mod forward;
mod hybrid_connected;
mod hybrid_stored;
mod illumination_map;
mod lamps;
pub(in crate::tracer) mod light_check;
pub(in crate::tracer) mod light_error;
pub(in crate::tracer) mod light_pass;
mod light_path;
mod path_vertex;
mod storing;
mod walk;

pub use all_paths::paths_behind;
pub use hybrid_stored::{StoredLight, StoredPhoton};
pub use lamps::MOST_SURFACES;
pub use light_check::check_light;
pub use light_error::{LightError, LightSetting};
pub use light_pass::LightPass;
