//! Why light cannot be followed through a scene.

use std::fmt;

use crate::scene::printable;

/// A setting of the light that can be wrong. Its name is its key in a lesson or in the head of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSetting {
    /// How many paths of light there are.
    Paths,
    /// How many paths there are for each pixel.
    Samples,
    /// The radius of the eye.
    Aperture,
    /// How many surfaces a path hits at most.
    Bounces,
    /// How many photons are gathered.
    Nearest,
    /// How many cells an illumination map has along its longer side.
    Map,
    /// Which kind of ray tracing.
    Transport,
}

impl LightSetting {
    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paths => "paths",
            Self::Samples => "samples",
            Self::Aperture => "aperture",
            Self::Bounces => "bounces",
            Self::Nearest => "nearest",
            Self::Map => "map",
            Self::Transport => "transport",
        }
    }
}

/// Why light cannot be followed.
#[derive(Clone, Debug, PartialEq)]
pub enum LightError {
    /// There is no light at all.
    NoLights,
    /// A light says a colour, not what it sends out.
    NoPower {
        /// Its place in the scene.
        number: usize,
        /// Its name.
        light: String,
    },
    /// A surface would send on more than arrives.
    Albedo {
        /// The material.
        material: String,
        /// What it would send on of one channel.
        sum: f64,
    },
    /// A light stands in matter that it cannot leave and that nothing shows from inside.
    Inside {
        /// The light.
        light: String,
        /// The object.
        object: String,
    },
    /// No path is to be followed.
    NoPaths {
        /// The setting that says so.
        setting: LightSetting,
    },
    /// More paths than there can be, or than there is memory for.
    TooMany {
        /// How many.
        paths: u64,
        /// The setting that says so.
        setting: LightSetting,
        /// How much memory they would take; 0 where nothing is stored.
        bytes: f64,
        /// The most that this setting may ask for.
        most: u64,
    },
    /// Nothing absorbs the light, and none of it gets out: it would become more and more.
    Endless {
        /// How many surfaces a path has hit when it was given up.
        surfaces: u32,
    },
    /// Maps with more cells than there is memory for.
    TooManyCells {
        /// Along the longer side of a face.
        cells: u32,
        /// Sides of flat faces.
        sides: u64,
        /// How much memory they would take.
        bytes: f64,
        /// How many there may be.
        most: u32,
    },
    /// A number out of its range.
    OutOfRange {
        /// The setting.
        setting: LightSetting,
        /// What it must be.
        must: &'static str,
    },
}

impl LightError {
    /// What is wrong. `name` says how a setting is written where the message is read: as a key, or as an option.
    pub fn what(&self, name: impl Fn(LightSetting) -> String) -> String {
        match self {
            Self::NoLights => {
                "the scene has no lights, and this kind of ray tracing starts at the lights".into()
            }
            Self::NoPower { number, light } => format!(
                "lights[{number}], {light:?}, has a colour but no power, so the light that it emits is not known"
            ),
            Self::Albedo { material, sum } => format!(
                "materials.{} reflects and transmits {sum} times the incoming light: energy would grow at every bounce",
                printable(material)
            ),
            Self::Inside { light, object } => format!(
                "the light {light:?} is inside {object:?}, which is opaque and whose inside is not visible"
            ),
            Self::NoPaths { setting } => {
                format!("{} 0: no light would be followed", name(*setting))
            }
            Self::TooMany { paths, bytes, .. } if 0.0 < *bytes => format!(
                "the photons of {paths} paths of light would take about {} of memory",
                Bytes(*bytes)
            ),
            Self::TooMany { paths, .. } => {
                format!("{paths} paths of light are too many: their numbers have 32 bits")
            }
            Self::Endless { surfaces } => format!(
                "a path of light hit {surfaces} surfaces and did not end: the surfaces absorb almost nothing, and the path cannot leave"
            ),
            Self::TooManyCells {
                cells,
                sides,
                bytes,
                ..
            } => format!(
                "maps with {cells} cells along the longer side, on {sides} sides of flat faces, would take up to {} of \
                 memory",
                Bytes(*bytes)
            ),
            Self::OutOfRange { setting, must } => format!("{} must be {must}", name(*setting)),
        }
    }
}

impl fmt::Display for LightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what(|setting| setting.name().into()))
    }
}

impl std::error::Error for LightError {}

impl LightError {
    /// What to do about it, with the settings named as in files.
    pub fn fix(&self) -> String {
        self.fix_with(|setting| setting.name().into())
    }

    /// What to do about it, with the settings named as the message's reader writes them.
    pub fn fix_with(&self, name: impl Fn(LightSetting) -> String) -> String {
        match self {
            Self::NoLights => {
                "give the scene a light, such as { \"position\": [0, 4, 0], \"power\": 100 }".into()
            }
            Self::NoPower { number, .. } => format!(
                "replace lights[{number}].colour by \"power\", in watts, or choose {} hybrid-light",
                name(LightSetting::Transport)
            ),
            Self::Albedo { material, .. } => format!(
                "lower diffuse, reflection or transmission of materials.{}, so that for each channel \
                 colour·diffuse + reflection + transmission is at most 1",
                printable(material)
            ),
            Self::Inside { object, .. } => format!(
                "move the light, or give {object:?} \"sides\": \"back\" to show it from inside"
            ),
            Self::NoPaths { setting } => format!("give {} a number of at least 1", name(*setting)),
            Self::TooMany { setting, most, .. } => {
                format!("give {} a number of at most {most}", name(*setting))
            }
            Self::Endless { .. } => format!(
                "lower the albedo of a material, or end the paths with {0}, such as {0} 20",
                name(LightSetting::Bounces)
            ),
            Self::TooManyCells { most, .. } => {
                format!(
                    "give {} a number of at most {most}",
                    name(LightSetting::Map)
                )
            }
            Self::OutOfRange { setting, .. } => format!("change {}", name(*setting)),
        }
    }
}

/// An amount of memory, roughly.
struct Bytes(f64);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let units = [(1e15, "PB"), (1e12, "TB"), (1e9, "GB"), (1e6, "MB")];
        let unit = units.into_iter().find(|(size, _)| *size <= self.0);
        let (size, unit) = unit.unwrap_or((1e3, "kB"));
        write!(f, "{:.0} {unit}", self.0 / size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_amount_of_memory_is_told_in_the_largest_unit_of_which_there_is_one() {
        let told = |bytes: f64| Bytes(bytes).to_string();
        assert_eq!(told(4e5), "400 kB");
        assert_eq!(told(1e6), "1 MB");
        assert_eq!(told(2.4e9), "2 GB");
        assert_eq!(told(9e12), "9 TB");
        assert_eq!(told(3e15), "3 PB");
    }

    #[test]
    fn memory_is_told_where_some_is_taken() {
        let error = |bytes| LightError::TooMany {
            paths: 5,
            setting: LightSetting::Paths,
            bytes,
            most: 3,
        };
        assert_eq!(
            error(0.0).to_string(),
            "5 paths of light are too many: their numbers have 32 bits"
        );
        assert_eq!(
            error(2e9).to_string(),
            "the photons of 5 paths of light would take about 2 GB of memory"
        );
        assert_eq!(error(0.0).fix(), "give paths a number of at most 3");
        let option = |setting: LightSetting| format!("--{}", setting.name());
        assert_eq!(
            error(0.0).fix_with(option),
            "give --paths a number of at most 3"
        );
    }
}
