//! What the transports that follow light from the lamps depend on.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::Camera;

/// The radius of the aperture where none is given, as a share of the way from the COP to the window's centre: wide
/// enough for a few photons in a million, narrow enough for a picture.
const APERTURE: f64 = 1.0 / 20.0;

/// How light is followed from the lamps. Each transport looks at some of these.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct LightOptions {
    /// The seed of the random numbers: the same seed gives the same paths.
    pub seed: u64,
    /// How many paths of light there are, for forward and hybrid-stored.
    pub paths: u64,
    /// How many paths from the eye each pixel has, and of light as many, for hybrid-connected.
    pub samples: u32,
    /// How many surfaces a path may hit; absent: Russian roulette ends a path, at the latest after 10 000.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounces: Option<u32>,
    /// The radius of the eye's aperture, for forward; absent: a twentieth of the way from the COP to the window's
    /// centre.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub aperture: Option<f64>,
    /// How many of the nearest photons are gathered, for hybrid-stored.
    pub nearest: u32,
    /// Light is stored in maps with this number of cells along the longer side of a flat surface, for hybrid-stored;
    /// absent: photon by photon.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<u32>,
}

impl LightOptions {
    /// The radius of the eye's aperture.
    pub fn aperture_radius(&self, camera: &Camera) -> f64 {
        self.aperture.unwrap_or_else(|| {
            let center = camera.to_corner + 0.5 * (camera.right + camera.up);
            APERTURE * center.length()
        })
    }
}

impl Default for LightOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            paths: 200_000,
            samples: 4,
            bounces: None,
            aperture: None,
            nearest: 50,
            map: None,
        }
    }
}
