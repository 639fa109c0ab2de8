//! Which options about light there are, and which transports look at each.

use raystep::Transport;

use crate::cli::Error;
use crate::cli::args::Casting;
use crate::cli::word::{choice, word};

/// An option about how light is followed, or how eye rays are cast.
pub(crate) struct LightOption {
    /// As it is written.
    pub(crate) name: &'static str,
    /// Was it written?
    pub(crate) is_given: fn(&Casting) -> bool,
    /// Who looks at it.
    users: &'static [Transport],
}

const FOLLOW_LIGHT: &[Transport] = &[
    Transport::Forward,
    Transport::HybridStored,
    Transport::HybridConnected,
];
const CAST_EYE_RAYS: &[Transport] = &[
    Transport::Backward,
    Transport::HybridLight,
    Transport::HybridStored,
];
const CAST_FROM_PIXELS: &[Transport] = &[
    Transport::Backward,
    Transport::HybridLight,
    Transport::HybridStored,
    Transport::HybridConnected,
];
const SHARE_PATHS: &[Transport] = &[Transport::Forward, Transport::HybridStored];
const FORWARD: &[Transport] = &[Transport::Forward];
const STORED: &[Transport] = &[Transport::HybridStored];
const CONNECTED: &[Transport] = &[Transport::HybridConnected];

/// All of them, in the order of the help.
pub(crate) const LIGHT_OPTIONS: [LightOption; 10] = [
    LightOption {
        name: "--max-depth",
        is_given: |casting| casting.max_depth.is_some(),
        users: CAST_EYE_RAYS,
    },
    LightOption {
        name: "--max-rays",
        is_given: |casting| casting.max_rays.is_some(),
        users: CAST_FROM_PIXELS,
    },
    LightOption {
        name: "--through",
        is_given: |casting| casting.through.is_some(),
        users: CAST_EYE_RAYS,
    },
    LightOption {
        name: "--seed",
        is_given: |casting| casting.seed.is_some(),
        users: FOLLOW_LIGHT,
    },
    LightOption {
        name: "--paths",
        is_given: |casting| casting.paths.is_some(),
        users: SHARE_PATHS,
    },
    LightOption {
        name: "--samples",
        is_given: |casting| casting.samples.is_some(),
        users: CONNECTED,
    },
    LightOption {
        name: "--bounces",
        is_given: |casting| casting.bounces.is_some(),
        users: FOLLOW_LIGHT,
    },
    LightOption {
        name: "--aperture",
        is_given: |casting| casting.aperture.is_some(),
        users: FORWARD,
    },
    LightOption {
        name: "--nearest",
        is_given: |casting| casting.nearest.is_some(),
        users: STORED,
    },
    LightOption {
        name: "--map",
        is_given: |casting| casting.map.is_some(),
        users: STORED,
    },
];

/// Refuses the first option that the transport would not look at: whoever gives it expects it to do something.
pub(crate) fn refuse_unused(casting: &Casting) -> Result<(), Error> {
    let transport = casting.transport.unwrap_or_default();
    let unused = LIGHT_OPTIONS
        .iter()
        .find(|option| (option.is_given)(casting) && !option.users.contains(&transport));
    match unused {
        None => Ok(()),
        Some(unused) => Err(Error::Unused {
            option: unused.name,
            chosen: choice("--transport", casting.transport, transport),
            users: unused.users.iter().map(|&user| words(user)).collect(),
        }),
    }
}

/// The option that chooses it.
fn words(transport: Transport) -> String {
    format!("--transport {}", word(transport))
}
