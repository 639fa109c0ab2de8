//! Russian roulette at a surface: what becomes of a photon, or of a path from the eye, which is treated in the same way.
//!
//! One random number ξ decides for all channels: below the reflection the photon is mirrored, below reflection +
//! transmission refracted, and below the sum of these and a channel's colour·diffuse that channel is reflected
//! diffusely. What continues keeps what it carries.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::explain::worked::vertex;
use crate::trace::{Kind, Photon, PhotonVerdict, Purpose, RayNode, RayStart, Stored};

/// The channels of a colour.
const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// Russian roulette at a surface.
pub(super) fn photon(context: &Context, photon: &Photon, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::Photon) {
        return;
    }
    let d = Digits::USUAL;
    let carries = Carries::along(course.start);
    let chance = d.number(photon.chance);
    let text = format!(": ξ = {chance}; {} arrives", carries.amount(photon.power));
    page.headed(Part::Roulette, text);
    page.indented(|page| {
        let material = context.scene.material_of(photon.object);
        let (reflection, transmission) = (photon.reflection, photon.transmission);
        if photon.transmission == 0.0 && 0.0 < material.transmission {
            page.plain(format!(
                "total internal reflection: the reflection gets the transmission too, {} + {} = {}",
                d.number(material.reflection),
                d.number(material.transmission),
                d.number(reflection)
            ));
        }
        if 0.0 < reflection {
            let text = format!("reflection: {}", below(photon.chance, reflection));
            page.plain(text);
        }
        let limit = reflection + transmission;
        if photon.verdict != PhotonVerdict::Mirrored && 0.0 < transmission {
            page.plain(format!(
                "reflection + transmission = {} + {} = {}: {}",
                d.number(reflection),
                d.number(transmission),
                d.number(limit),
                below(photon.chance, limit)
            ));
        }
        if matches!(
            photon.verdict,
            PhotonVerdict::Diffused | PhotonVerdict::Absorbed
        ) {
            let before = match (reflection, transmission) {
                (_, t) if 0.0 < t => "reflection + transmission + colour·diffuse",
                (r, _) if 0.0 < r => "reflection + colour·diffuse",
                _ => "colour·diffuse",
            };
            let sum = if limit == 0.0 {
                d.vector(photon.diffuse)
            } else {
                let [first, second] = [DVec3::splat(limit), photon.diffuse];
                let sum = d.vector(first + second);
                format!("{} + {} = {sum}", d.vector(first), d.vector(second))
            };
            page.plain(format!(
                "{before} = {sum}; a channel continues if ξ is less: {}",
                channels(photon)
            ));
        }
        let (tone, verdict) = match photon.verdict {
            PhotonVerdict::Mirrored => (Tone::Found, "continues in the mirror direction"),
            PhotonVerdict::Refracted => (Tone::Found, "continues through the surface"),
            PhotonVerdict::Diffused => (Tone::Found, "continues in a random direction"),
            PhotonVerdict::Absorbed => (Tone::Refused, "continues, so the path ends here"),
        };
        let leaving = photon.leaving();
        let on = match photon.verdict {
            PhotonVerdict::Absorbed => "nothing".into(),
            _ => carries.amount(leaving),
        };
        let absorbed = photon.power - leaving;
        let absorbed = if absorbed == DVec3::ZERO {
            String::new()
        } else {
            match carries {
                Carries::Power => format!("; {} is absorbed", carries.amount(absorbed)),
                Carries::Weight => format!("; {} of it is absorbed", d.vector(absorbed)),
            }
        };
        page.line(tone, format!("→ {on} {verdict}{absorbed}"));
    });
}

/// A photon is stored where it hits a diffuse surface.
pub(super) fn stored(context: &Context, stored: &Stored, page: &mut Pen) {
    if !context.shows(Kind::Stored) {
        return;
    }
    let d = Digits::USUAL;
    let text = format!(
        ": {} on {} at {}, on the side of the normal {}",
        Carries::Power.amount(stored.power),
        context.name(stored.object),
        d.vector(stored.point),
        d.vector(stored.normal)
    );
    page.result(Tone::Found, Part::Stored, text);
}

/// The direction in which a path continues from the surface before.
pub(super) fn direction_of_leg(context: &Context, place: usize) -> Option<String> {
    let d = Digits::USUAL;
    let direction = context.tree.rays[place].start?.ray.direction;
    let (before, photon) = vertex::leg_before(context, place)?;
    let incoming = before.start?.ray.direction;
    let normal = vertex::normal_towards(context, &photon, -incoming);
    Some(match photon.verdict {
        PhotonVerdict::Mirrored => format!(
            "Δ = Δ′ − 2(Δ′·N)N = {} − 2·{}·{} = {}, with Δ′ the incoming direction",
            d.vector(incoming),
            d.factor(incoming.dot(normal)),
            d.vector(normal),
            d.vector(direction)
        ),
        PhotonVerdict::Refracted => format!("Δ = T = {}", d.vector(direction)),
        PhotonVerdict::Diffused | PhotonVerdict::Absorbed => format!(
            "Δ = {}: a random direction around N = {}, pdf cos θ/π per steradian",
            d.vector(direction),
            d.vector(normal)
        ),
    })
}

/// What is carried along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Carries {
    /// Watts.
    Power,
    /// The factor by which a path from the eye multiplies the light that it finds.
    Weight,
}

impl Carries {
    fn along(start: Option<RayStart>) -> Self {
        match start {
            Some(start) if start.purpose != Purpose::Light => Self::Weight,
            _ => Self::Power,
        }
    }

    /// `(0.5, 0, 0) W` or `weight β (1, 1, 1)`.
    pub(super) fn amount(self, carried: DVec3) -> String {
        let vector = Digits::USUAL.vector(carried);
        match self {
            Self::Power => format!("{vector} W"),
            Self::Weight => format!("weight β {vector}"),
        }
    }
}

/// `ξ < 0.1` or `ξ ≥ 0.1`, with a number in place of ξ.
fn below(chance: f64, limit: f64) -> String {
    let usual = Digits::USUAL;
    let d = if usual.number(chance) == usual.number(limit) {
        Digits::for_difference(limit, chance - limit)
    } else {
        usual
    };
    let sign = if chance < limit { "<" } else { "≥" };
    format!("{} {sign} {}", d.number(chance), d.number(limit))
}

/// Which channels are reflected diffusely: `red and green continue, blue does not`.
pub(super) fn channels(photon: &Photon) -> String {
    let limit = photon.reflection + photon.transmission;
    let is_below = |channel: usize| photon.chance < limit + photon.diffuse[channel];
    let of = |wanted: bool| -> Vec<&str> {
        (0..3)
            .filter(|&channel| is_below(channel) == wanted)
            .map(|channel| CHANNELS[channel])
            .collect()
    };
    let (on, ends) = (of(true), of(false));
    let goes_on = if on.len() == 1 {
        "continues"
    } else {
        "continue"
    };
    let does = if ends.len() == 1 { "does" } else { "do" };
    match (on.as_slice(), ends.as_slice()) {
        ([], _) => "no channel continues".into(),
        (_, []) => "all channels continue".into(),
        _ => format!(
            "{} {goes_on}, {} {does} not",
            on.join(" and "),
            ends.join(" and ")
        ),
    }
}

/// The power that leaves the scene with a leg of a path of light that hits no surface. It is written below its ray.
pub(super) fn leaves_with(context: &Context, ray: &RayNode) -> Option<String> {
    let path = context.records.first()?.path?;
    let start = ray.start.filter(|start| start.purpose == Purpose::Light)?;
    let power = context
        .paths
        .get(&path)?
        .carried_after(start.depth.checked_sub(1)?)?;
    Some(format!(
        ", {} leaves the scene",
        Carries::Power.amount(power)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channels_continue_where_the_random_number_is_below_their_sum() {
        let photon = |chance| Photon {
            chance,
            reflection: 0.1,
            diffuse: DVec3::new(0.8, 0.4, 0.2),
            verdict: PhotonVerdict::Diffused,
            ..Photon::default()
        };
        for (chance, words) in [
            (0.2, "all channels continue"),
            (0.4, "red and green continue, blue does not"),
            (0.5, "red continues, green and blue do not"),
            (0.95, "no channel continues"),
        ] {
            assert_eq!(channels(&photon(chance)), words);
        }
    }

    #[test]
    fn chance_close_to_a_limit_is_told_with_the_digits_that_decide() {
        assert_eq!(below(0.25, 0.5), "0.25 < 0.5");
        assert_eq!(below(0.500_000_04, 0.5), "0.50000004 ≥ 0.5");
    }
}
