//! Which options about a structure there are, and which strategies look at each.

use raystep::structure::VolumeKind;
use raystep::{StrategyName, StructureOptions};

use crate::cli::Error;
use crate::cli::args::Tracing;
use crate::cli::word::{choice, word};

/// An option about the structure of a strategy.
pub(crate) struct StructureOption {
    /// As it is written.
    pub(crate) name: &'static str,
    /// Was it written?
    pub(crate) is_given: fn(&Tracing) -> bool,
    /// Who looks at it.
    users: &'static [User],
}

/// A strategy that looks at an option; with bounds perhaps around volumes of one kind alone.
type User = (StrategyName, Option<VolumeKind>);

const BOUNDS: User = (StrategyName::Bounds, None);
const BOUNDS_OF_SLABS: User = (StrategyName::Bounds, Some(VolumeKind::Slabs));
const HIERARCHY: User = (StrategyName::Hierarchy, None);
const HEAP: User = (StrategyName::Heap, None);
const GRID: User = (StrategyName::Grid, None);

/// All of them, in the order of the help.
pub(crate) const STRUCTURE_OPTIONS: [StructureOption; 8] = [
    StructureOption {
        name: "--volume",
        is_given: |tracing| tracing.volume.is_some(),
        users: &[BOUNDS],
    },
    StructureOption {
        name: "--slabs",
        is_given: |tracing| tracing.slabs.is_some(),
        users: &[HIERARCHY, HEAP, BOUNDS_OF_SLABS],
    },
    StructureOption {
        name: "--build",
        is_given: |tracing| tracing.build.is_some(),
        users: &[HIERARCHY, HEAP],
    },
    StructureOption {
        name: "--grid",
        is_given: |tracing| tracing.grid.is_some(),
        users: &[GRID],
    },
    StructureOption {
        name: "--density",
        is_given: |tracing| tracing.density.is_some(),
        users: &[GRID],
    },
    StructureOption {
        name: "--lists",
        is_given: |tracing| tracing.lists.is_some(),
        users: &[GRID],
    },
    StructureOption {
        name: "--no-mailboxes",
        is_given: |tracing| tracing.no_mailboxes,
        users: &[GRID],
    },
    StructureOption {
        name: "--building",
        is_given: |tracing| tracing.building,
        users: &[HIERARCHY, HEAP, GRID],
    },
];

/// Refuses the first option that the strategy would not look at: whoever gives it expects it to do something.
pub(crate) fn refuse_unused(
    tracing: &Tracing,
    strategy: StrategyName,
    structure: &StructureOptions,
) -> Result<(), Error> {
    let uses = |&(name, volume): &User| {
        name == strategy && volume.is_none_or(|volume| volume == structure.volume)
    };
    let given = STRUCTURE_OPTIONS
        .iter()
        .filter(|option| (option.is_given)(tracing));
    match given
        .into_iter()
        .find(|option| !option.users.iter().any(uses))
    {
        None => Ok(()),
        Some(unused) => Err(Error::Unused {
            option: unused.name,
            chosen: chosen(tracing, strategy, structure),
            users: unused.users.iter().map(|&user| words(user)).collect(),
        }),
    }
}

/// The strategy, and the kind of volume where it has one: as they were written, or as defaults.
fn chosen(tracing: &Tracing, strategy: StrategyName, structure: &StructureOptions) -> String {
    let mut chosen = choice("--strategy", tracing.strategy, strategy);
    if strategy == StrategyName::Bounds {
        let between = if tracing.volume.is_some() {
            " "
        } else {
            " and "
        };
        chosen += between;
        chosen += &choice("--volume", tracing.volume, structure.volume);
    }
    chosen
}

/// The options that choose it.
fn words((strategy, volume): User) -> String {
    let strategy = format!("--strategy {}", word(strategy));
    match volume {
        Some(volume) => format!("{strategy} --volume {}", word(volume)),
        None => strategy,
    }
}
