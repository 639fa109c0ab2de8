//! What follows from the events of light: what of a photon goes on, and how two points face each other.

use glam::DVec3;

use crate::trace::event::table::{Connection, Photon};
use crate::trace::event::words::PhotonVerdict;

impl Photon {
    /// What of the power goes on. Absorbed is what arrives less this.
    pub fn leaving(&self) -> DVec3 {
        match self.verdict {
            PhotonVerdict::Mirrored | PhotonVerdict::Refracted => self.power,
            PhotonVerdict::Absorbed => DVec3::ZERO,
            PhotonVerdict::Diffused => {
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
#[doc(alias = "geometry factor")]
pub fn geometry_term(from: DVec3, to: DVec3, [cos_from, cos_to]: [f64; 2]) -> f64 {
    let distance_squared = from.distance_squared(to);
    if distance_squared == 0.0 {
        return 0.0;
    }
    cos_from * cos_to / distance_squared
}
