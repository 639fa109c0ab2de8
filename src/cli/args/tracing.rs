//! The options of every verb that reads or traces a scene: which objects a ray is tested against, and which rays there are.

use clap::Args as ClapArgs;
use raystep::structure::{Build, GridOptions, Lists, SlabChoice, VolumeKind};
use raystep::trace::LightOptions;
use raystep::{StrategyName, StructureOptions, Through, Transport};

use crate::cli::args::Format;
use crate::cli::args::values::{cells, density, pixels, radius};
use crate::cli::word::one_of;

/// What may be read.
#[derive(Debug, Default, ClapArgs)]
pub(crate) struct Reading {
    /// Allow mesh files outside the scene's folder
    #[arg(long)]
    pub(crate) allow_outside: bool,
}

/// How a scene is traced. A saved log has been traced, so none of these go with one, except the
/// statistics.
#[derive(Debug, Default, ClapArgs)]
#[command(next_help_heading = "Strategy")]
pub(crate) struct Tracing {
    /// Which objects each ray is tested against [default: to render hierarchy, or exhaustive for a heat map; for a
    /// pixel or a log exhaustive, or hierarchy with more than 1000 objects]
    #[arg(long, value_parser = one_of::<StrategyName>(), value_name = "NAME")]
    pub(crate) strategy: Option<StrategyName>,
    /// How the tree is built, for hierarchy and heap [default: bottom-up]
    #[arg(long, value_parser = one_of::<Build>(), value_name = "NAME")]
    pub(crate) build: Option<Build>,
    /// Volume around each object, for bounds [default: box]
    #[arg(long, value_parser = one_of::<VolumeKind>(), value_name = "NAME")]
    pub(crate) volume: Option<VolumeKind>,
    /// Directions of slabs, for hierarchy, heap, and bounds with the volume slabs [default: axes]
    #[arg(long, value_parser = one_of::<SlabChoice>(), value_name = "NAME")]
    pub(crate) slabs: Option<SlabChoice>,
    /// Cells along x, y and z, for grid [default: by the density]
    #[arg(long, value_name = "NX,NY,NZ", value_parser = cells)]
    pub(crate) grid: Option<[u32; 3]>,
    /// Cells for each object, for grid [default: 3]
    #[arg(long, value_name = "D", value_parser = density, conflicts_with = "grid")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) density: Option<f64>,
    /// How objects are assigned to cells, for grid: by their shape or by their box [default: objects]
    #[arg(long, value_parser = one_of::<Lists>(), value_name = "NAME")]
    pub(crate) lists: Option<Lists>,
    /// Test an object in every cell that lists it, for grid
    #[arg(long)]
    pub(crate) no_mailboxes: bool,
    /// Record how the structure is built, for hierarchy, heap and grid
    #[arg(long)]
    pub(crate) building: bool,
    /// Which rays there are.
    #[command(flatten)]
    pub(crate) casting: Casting,
    /// Count rays and tests: as text on standard error, or as JSON on standard output
    #[arg(help_heading = None::<&str>)]
    #[arg(long, value_enum, value_name = "FORMAT", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "text")]
    pub(crate) stats: Option<Format>,
}

impl Tracing {
    /// What was chosen about the structure.
    pub(crate) fn structure(&self) -> StructureOptions {
        let usual = StructureOptions::default();
        StructureOptions {
            volume: self.volume.unwrap_or(usual.volume),
            slabs: self.slabs.unwrap_or(usual.slabs),
            build: self.build.unwrap_or(usual.build),
            grid: GridOptions {
                resolution: self.grid,
                density: self.density.unwrap_or(usual.grid.density),
                lists: self.lists.unwrap_or(usual.grid.lists),
                mailboxes: !self.no_mailboxes,
            },
        }
    }
}

/// Which rays are cast.
#[derive(Clone, Debug, Default, ClapArgs)]
#[command(next_help_heading = "Rays")]
pub(crate) struct Casting {
    /// Which rays are cast [default: hybrid-light]
    #[arg(long, value_parser = one_of::<Transport>(), value_name = "NAME")]
    pub(crate) transport: Option<Transport>,
    /// Size of the picture; replaces the scene's
    #[arg(long, value_name = "W,H", value_parser = pixels)]
    pub(crate) pixels: Option<[u32; 2]>,
    /// Largest depth of a ray; replaces the scene's; eye rays have depth 1
    #[arg(long, value_name = "N")]
    pub(crate) max_depth: Option<u32>,
    /// The most rays of one pixel; with more the command ends with an error [default: 1000000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) max_rays: Option<u64>,
    /// Opaque objects are visible only from the front
    #[arg(long)]
    pub(crate) one_sided: bool,
    /// Where the eye rays pass a pixel [default: centres]
    #[arg(long, value_parser = one_of::<Through>(), value_name = "WHERE")]
    pub(crate) through: Option<Through>,
    /// Seed of the random numbers, for forward, hybrid-stored and hybrid-connected [default: 1]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Paths of light, for forward and hybrid-stored [default: 200000]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) paths: Option<u64>,
    /// Paths from the eye for each pixel, and the same number from the lights, for hybrid-connected [default: 4]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) samples: Option<u32>,
    /// The most surfaces that a path may hit, for forward, hybrid-stored and hybrid-connected [default: unlimited,
    /// Russian roulette ends a path]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) bounces: Option<u32>,
    /// Radius of the eye's aperture, for forward [default: 1/20 of the distance to the window]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "R", value_parser = radius, allow_hyphen_values = true)]
    pub(crate) aperture: Option<f64>,
    /// How many of the nearest photons are gathered around a point, for hybrid-stored [default: 50]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "K")]
    pub(crate) nearest: Option<u32>,
    /// Store light on flat faces in maps with this number of cells along the longer side, for hybrid-stored
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) map: Option<u32>,
}

impl Casting {
    /// What was chosen about how light is followed.
    pub(crate) fn light(&self) -> LightOptions {
        let usual = LightOptions::default();
        LightOptions {
            seed: self.seed.unwrap_or(usual.seed),
            paths: self.paths.unwrap_or(usual.paths),
            samples: self.samples.unwrap_or(usual.samples),
            bounces: self.bounces,
            aperture: self.aperture,
            nearest: self.nearest.unwrap_or(usual.nearest),
            map: self.map,
        }
    }
}
