//! What a hit leads to: spawned rays, shades, pixels and pictures; and the five kinds of ray tracing.
//!
//! # The five kinds
//!
//! | kind | [`Transport`](crate::trace::Transport) | file |
//! |---|---|---|
//! | backward: from the eye alone | `Backward` | `eye/backward.rs` |
//! | forward: from the lights alone | `Forward` | `light/forward.rs` |
//! | hybrid: from the eye, with rays to the lights | `HybridLight` | `eye/hybrid_light.rs` |
//! | hybrid: light stored on surfaces, then gathered | `HybridStored` | `light/hybrid_stored.rs` |
//! | hybrid: light and eye connected by lines | `HybridConnected` | `light/hybrid_connected.rs` |
//!
//! The three that follow light share its paths: `light_path.rs` (from a lamp), `walk.rs` (from surface to surface),
//! `chance.rs` (the random numbers), `light_pass.rs` (all paths, over threads).
//!
//! # Units
//!
//! - A lamp is a point with a **power** Φ in watts, in each channel of the colour; it shines in all directions alike:
//!   Φ/(4π) watts per steradian.
//! - **Irradiance** E is power by area: a lamp at distance r, at θ from the normal, gives E = Φ·cos θ/(4π·r²).
//! - **Radiance** L is power by area across the ray and solid angle, what a pixel shows: a diffuse surface of
//!   albedo ρ = colour·diffuse gives L = ρ/π · E in every direction.
//! - A mirror gives reflection · L of what it mirrors. Glass gives transmission · L; within a medium of index n
//!   radiance is n² times as much, so that a way in and out again changes nothing.
//! - ρ + reflection + transmission is at most 1 in each channel; what is left is absorbed.
//! - The three kinds that follow light show the light of the lamps and nothing else: `ambient` stands for what they
//!   compute, and a background is no lamp. `specular` and `shininess` belong to lamps that have a colour. Meshes with
//!   smooth normals are lit by the faces' own.
//!
//! # Which kind sees what
//!
//! Paths of light as P. Heckbert writes them (1990), from the light L to the eye E by diffuse (D) and by mirroring or
//! refracting (S) surfaces:
//!
//! | effect | path | backward | hybrid-light | forward | hybrid-stored | hybrid-connected |
//! |---|---|---|---|---|---|---|
//! | direct light | L D E | yes | yes | yes | yes | yes |
//! | shadow | | no | yes | yes | yes, blurred | yes |
//! | mirror image of a lit surface | L D S E | yes | yes | yes | yes | yes |
//! | indirect diffuse light | L D D E | no | no | yes | yes | yes |
//! | caustic | L S D E | no | no | yes | yes | yes |
//! | mirror image of a caustic | L S D S E | no | no | yes | yes | no |
//! | the lamp itself | L E, L S E | no | no | no | no | no |
//!
//! - *backward* sends no ray to a lamp: it takes every lamp for visible.
//! - *hybrid-light* sends one, straight: a ray through glass is blocked by it, and light that comes from another
//!   surface is left to `ambient`.
//! - *forward* sees everything that reaches the eye, and nearly nothing reaches it: an eye of aperture 0 is a point,
//!   which no photon hits. With an aperture the picture is sharp in the plane of the window and blurred elsewhere.
//! - *hybrid-stored* sees everything too; the disc of the nearest photons blurs shadows and caustics.
//! - *hybrid-connected* has nothing to connect where both ends of every line are mirrors or glass: the mirror image of
//!   a caustic. A caustic itself is found by lines from the floor to the eye.
//! - A lamp is a point without area: its own image would be a point of unlimited radiance.
//!
//! Paths of light end by chance; `bounces` ends them sooner. Where the eye's rays branch at mirrors and glass, in
//! *hybrid-stored* as in *hybrid-light*, the scene's `max_depth` ends them, and `bounces` does not count them.
//!
//! A light inside an opaque solid is a mistake if the solid shows its front alone, for then it does not face inwards.
//! One that shows both sides does, and is a room; it is worth a note if the eye is outside.
//!
//! The table is held by `tests/transports/effects.rs`.

pub(crate) mod entry;
mod epsilon;
mod eye;
mod in_order;
mod light;
mod log;
mod ray_limit;
pub mod simple;
pub(crate) mod stopped;
mod surface;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
pub(crate) mod tracer;

pub use entry::{check_light_of, follow_light, paths_behind_region, render_heat};
pub use epsilon::{EPSILON, start_epsilon};
pub use eye::{Heat, HeatLine, HeatOf, Picture, eye_samples, heat_values, render, trace_pixel};
pub use light::{
    LightError, LightPass, LightSetting, MOST_SURFACES, StoredLight, StoredPhoton, check_light,
    paths_behind,
};
pub use log::{LogOptions, LogStopped, LoggedPaths, write_log};
pub use ray_limit::MAX_RAYS;
pub(crate) use stopped::Stopped;
pub use surface::Surface;
pub(crate) use tracer::Tracer;
