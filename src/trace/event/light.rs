//! The events of light on its way from the lamps: paths, photons, what is stored, gathered and connected.

use glam::DVec3;

use crate::scene::PrimitiveId;
use crate::trace::PhotonFate;

/// A light sends out a photon.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PathStart {
    /// Which path, from 0.
    pub path: u32,
    /// How many paths there are.
    pub paths: u32,
    /// The light, chosen with a chance in proportion to its power.
    pub light: u32,
    /// What the photon carries, in watts: the power of all lights over the number of paths.
    pub power: DVec3,
}

/// A photon meets a surface, and chance decides (Russian roulette).
///
/// One number ξ in 0..1 decides for all three channels of the colour: below `reflection` the photon is
/// mirrored, below `reflection + transmission` refracted, below `reflection + transmission + diffuse` of a channel
/// that channel goes on diffusely, and above it is absorbed. What goes on keeps its power, so that no energy is
/// made or lost: at every surface arriving = leaving + absorbed.
///
/// A path from the eye meets surfaces in the same way, and carries a weight in place of a power.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Photon {
    /// What was met.
    pub object: PrimitiveId,
    /// Where.
    pub point: DVec3,
    /// What arrives: watts, or the weight of a path from the eye.
    pub power: DVec3,
    /// ξ, in 0..1.
    pub chance: f64,
    /// The chance to be mirrored.
    pub reflection: f64,
    /// The chance to be refracted; 0 where total internal reflection adds it to `reflection`.
    pub transmission: f64,
    /// colour·diffuse: the chance of each channel to go on diffusely.
    pub diffuse: DVec3,
    /// What became of it.
    pub fate: PhotonFate,
}

impl Photon {
    /// What of the power goes on. Absorbed is what arrives less this.
    pub fn leaving(&self) -> DVec3 {
        match self.fate {
            PhotonFate::Mirrored | PhotonFate::Refracted => self.power,
            PhotonFate::Absorbed => DVec3::ZERO,
            PhotonFate::Diffused => {
                let limit = self.reflection + self.transmission;
                let goes_on = |channel: usize| {
                    let survives = self.chance < limit + self.diffuse[channel];
                    if survives { self.power[channel] } else { 0.0 }
                };
                DVec3::new(goes_on(0), goes_on(1), goes_on(2))
            }
        }
    }
}

/// A photon passes the window into the eye.
///
/// The eye takes nothing away from it: it would cast a shadow otherwise, as the eye of no other transport does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arrival {
    /// The pixel where its line passes the window.
    pub pixel: [u32; 2],
    /// Where it passes the window.
    pub window: DVec3,
    /// Where it passes the aperture.
    pub aperture: DVec3,
    /// What it carries, in watts.
    pub power: DVec3,
    /// G = cos²θ / d² between the two points, whose planes are parallel.
    pub geometry: f64,
    /// power / (G · area of the aperture · area of the pixel): what it adds to the pixel, in watts per
    /// steradian and square unit.
    pub radiance: DVec3,
}

/// A photon is stored where it meets a diffuse surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stored {
    /// The surface.
    pub object: PrimitiveId,
    /// Where.
    pub point: DVec3,
    /// The unit normal on the side that it came from.
    pub normal: DVec3,
    /// What it carries, in watts.
    pub power: DVec3,
}

/// A stored photon is one of the nearest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nearby {
    /// The path that it came on.
    pub path: u32,
    /// The number of the surface on that path, from 1.
    pub surface: u32,
    /// Where it is stored.
    pub point: DVec3,
    /// What it carries, in watts.
    pub power: DVec3,
    /// How far from the point it is.
    pub distance: f64,
}

/// Light was gathered at a point that a ray from the eye has met.
///
/// E = Σ power / area over the k − 1 nearest photons, with the area of the disc up to the k-th, πr² where the
/// surface has no edge nearby; or over the cell of a map. L = colour·diffuse/π · E.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gathered {
    /// The surface.
    pub object: PrimitiveId,
    /// The point.
    pub point: DVec3,
    /// How many photons count: k − 1 of k, or those of the cell.
    pub count: u32,
    /// r: how far away the k-th photon is; `None` for the cell of a map, or where nothing is stored.
    pub radius: Option<f64>,
    /// What of the surface they lie on, in square units.
    pub area: f64,
    /// E: power by area.
    pub irradiance: DVec3,
    /// L: what the surface sends to the eye.
    pub radiance: DVec3,
}

/// An edge of a path that could have been the connecting line: it was, or other vertices could have made the
/// same path.
///
/// share = 1 / (G · φ · φ'): the smaller the geometry term and the densities of the vertices at its ends, the
/// likelier is the path to come about with this edge as its connection. The weight of a connection is its
/// share over the sum of all shares (balance heuristic: Veach and Guibas 1995).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alternative {
    /// The number of the edge, from 1 at the light.
    pub edge: u32,
    /// G of its two ends.
    pub geometry: f64,
    /// φ at its end towards the light and towards the eye: per steradian, 1/(4π) at the light,
    /// albedo/π at a diffuse surface; at the eye per square unit of the window, d²/(A·cos θ).
    pub densities: [f64; 2],
    /// 1 / (G·φ·φ').
    pub share: f64,
    /// This edge is the connection.
    pub chosen: bool,
}

/// A vertex of a path of light was connected to one of a path from the eye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Connection {
    /// The path of light.
    pub path: u32,
    /// Its vertex: 0 is the light, then the surfaces.
    pub light_vertex: u16,
    /// The vertex of the path from the eye: 0 is the eye, then the surfaces.
    pub eye_vertex: u16,
    /// The pixel, if the vertex is the eye itself.
    pub pixel: Option<[u32; 2]>,
    /// The vertex of the path of light.
    pub from: DVec3,
    /// The vertex of the path from the eye.
    pub to: DVec3,
    /// cos θ at both ends; 1 at a light and at the eye, which have no normal.
    pub cosines: [f64; 2],
    /// Nothing stands between.
    pub visible: bool,
    /// By the balance heuristic, in 0..1; 0 if something stands between.
    pub weight: f64,
    /// What it brings: to the pixel, if the vertex is the eye; otherwise times the number of the picture's pixels,
    /// for a pixel is connected to its own share of the paths alone.
    pub contribution: DVec3,
}

impl Connection {
    /// G = cos θ · cos θ' / d²
    pub fn geometry(&self) -> f64 {
        geometry_term(self.from, self.to, self.cosines)
    }
}

/// G = cos θ · cos θ' / d²: how much of what leaves one small surface reaches the other.
///
/// The cosines are those between the line and the surfaces' normals, 1 for a point without a normal. Two points in
/// one place have no line between them: 0.
pub fn geometry_term(from: DVec3, to: DVec3, [cos_from, cos_to]: [f64; 2]) -> f64 {
    let distance_squared = from.distance_squared(to);
    if distance_squared == 0.0 {
        return 0.0;
    }
    cos_from * cos_to / distance_squared
}
