//! What a lesson says about a figure: which scene, which pixel, which strategy, from where it is seen, what is shown.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::figure::view::View;
use crate::structure::{StructureOptions, VolumeKind};
use crate::trace::{LightOptions, StrategyName, Through, Transport};

/// A figure of a lesson. The same name serves the command line, the book and the tests.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FigureSpec {
    /// The kind of figure, which says what is drawn.
    pub kind: FigureKind,
    /// The scene, by its file beside the lesson.
    pub scene: String,
    /// What the figure is called, for who hears it; usually its kind and where its trace comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// What stands below it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub caption: String,
    /// The pixel whose trace is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pixel: Option<[u32; 2]>,
    /// Several pixels, for the kinds that draw more than one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pixels: Vec<[u32; 2]>,
    /// The ray that is drawn, by its number in the pixel's trace; usually the eye ray, 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ray: Option<u32>,
    /// The object that is drawn, by its name; usually the first that the ray is tested against.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// The mistake that the figure shows, by its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<String>,
    /// Which objects each ray is tested against.
    #[serde(default)]
    pub strategy: StrategyName,
    /// Several strategies on the same rays, for the kinds that compare them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub strategies: Vec<StrategyName>,
    /// Several bounding volumes around the same objects, for the kind that compares them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub volumes: Vec<VolumeKind>,
    /// Several resolutions of the grid, for the kind that compares them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub resolutions: Vec<[u32; 3]>,
    /// What is chosen about the strategy's structure.
    #[serde(default)]
    pub structure: StructureOptions,
    /// Which rays are cast.
    #[serde(default)]
    pub transport: Transport,
    /// Several kinds of ray tracing on the same scene, for the kinds that compare them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub transports: Vec<Transport>,
    /// How light is followed from the lamps, where the transport does.
    #[serde(default)]
    pub light: LightOptions,
    /// This number of the first paths of light is shown, whether they lead to the eye or not, beside those that lead to the
    /// pixels that are drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub paths: Option<u32>,
    /// Where the eye rays pass a pixel.
    #[serde(default)]
    pub through: Through,
    /// The size of the picture in pixels, in place of the scene's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub size: Option<[u32; 2]>,
    /// Every n-th pixel both ways is traced, for the kind that shows what a whole picture costs; usually every one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub every: Option<u32>,
    /// How fine the picture is, if the figure shows one; usually so that it is at least 256 pixels wide.
    #[serde(default, skip_serializing_if = "Fineness::is_usual")]
    pub picture: Fineness,
    /// From where the scene is seen.
    #[serde(default)]
    pub view: View,
    /// The part of the scene that is to be seen, by two opposite corners; usually all that is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame: Option<[[f64; 3]; 2]>,
    /// What is shown of what the kind can show; usually what it shows by itself.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub show: Vec<Layer>,
    /// The axis along which a polygon is projected, in place of the one that the test chose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drop: Option<DroppedAxis>,
    /// The last step of the trace that is shown; usually all are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<u32>,
}

/// How fine the picture in a figure is: its pixels are smaller than the scene's, and each is the mean of several eye rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Fineness {
    /// How many of its pixels lie along each side of one of the scene's pixels; usually as many as make it 256 wide.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub finer: Option<u32>,
    /// How many eye rays there are along each side of one of its pixels; usually 2, which is 4 in all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<u32>,
}

impl Fineness {
    fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

impl FigureSpec {
    /// Of how many pixels along each side one is traced.
    pub(crate) fn every(&self) -> u32 {
        self.every.unwrap_or(1).max(1)
    }

    /// Does the figure show the picture of the scene?
    pub(crate) fn shows_picture(&self) -> bool {
        let shows_pixels = self.show.is_empty() || self.show.contains(&Layer::Pixels);
        let on_window = self.kind == FigureKind::Pinhole && shows_pixels;
        let is_picture = matches!(self.kind, FigureKind::Picture | FigureKind::Rim);
        is_picture || self.show.contains(&Layer::Image) || on_window
    }

    /// A figure of a kind of a scene, with nothing said about it.
    pub fn new(kind: FigureKind, scene: impl Into<String>) -> Self {
        Self {
            kind,
            scene: scene.into(),
            title: String::new(),
            caption: String::new(),
            pixel: None,
            pixels: Vec::new(),
            ray: None,
            object: None,
            mistake: None,
            strategy: StrategyName::default(),
            strategies: Vec::new(),
            volumes: Vec::new(),
            resolutions: Vec::new(),
            structure: StructureOptions::default(),
            transport: Transport::default(),
            transports: Vec::new(),
            light: LightOptions::default(),
            paths: None,
            picture: Fineness::default(),
            through: Through::default(),
            size: None,
            every: None,
            view: View::default(),
            frame: None,
            show: Vec::new(),
            drop: None,
            step: None,
        }
    }
}

/// What a figure draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum FigureKind {
    /// The pinhole camera: the box, the hole, the inverted image, and the window before the COP (Fig. 12-1).
    Pinhole,
    /// The window as a grid of pixels, and the eye ray through one of them.
    Window,
    /// The rays of a pixel in the scene.
    Rays,
    /// Paths of light in the scene: those that lead to the eye, and those that are wasted.
    Paths,
    /// The photons nearest to a point on a flat surface, seen from above, and the density that follows from them.
    Gather,
    /// A path of light and a path from the eye, with the lines between their vertices.
    Connections,
    /// The light that falls on what each pixel sees, as it is stored there.
    Irradiance,
    /// N, L, R and V at a point, and the terms of its shade.
    Shading,
    /// The line of t: behind the COP, 0, the window, beyond.
    LineOfT,
    /// A ray and a sphere: the roots, the normal, the parabola of the quadratic.
    Sphere,
    /// A ray and a polygon, projected along an axis (Fig. 15.57).
    Polygon,
    /// A ray laid along the z axis, and the z sort.
    Alignment,
    /// Bounding volumes around an object, and what they waste.
    Volumes,
    /// An object in slabs, in 2D (Fig. 15.58(a)).
    Slabs,
    /// The bound of two bounds (Fig. 15.58(b)).
    Merge,
    /// Near and far along a ray, slab by slab.
    Intervals,
    /// The tree of a hierarchy and its nested volumes, for one ray.
    Hierarchy,
    /// The heap of waiting nodes over time.
    Heap,
    /// The scene's box cut into a regular grid (Fig. 15.61).
    Partition,
    /// A ray through a grid in 2D (Fig. 15.62).
    Grid,
    /// The steps of a walk through a grid: t per axis, and the choice.
    Steps,
    /// What each strategy costs, as bars.
    Costs,
    /// What each pixel cost.
    Heat,
    /// What a whole picture costs: its pixels times its objects, against what each strategy takes.
    Sum,
    /// The kinds of ray tracing side by side, with the rays that each casts and wastes.
    Transports,
    /// t = (S + D)·T: what is constant for the scene, for a bound and for a ray.
    SlabTerms,
    /// A hierarchy that grows bottom-up beside a grid that divides top-down.
    Building,
    /// A line-drawing algorithm beside the walk through a grid.
    LineDrawing,
    /// The same ray through grids of several resolutions.
    Grids,
    /// The picture, the traced pixels marked.
    Picture,
    /// The picture with a mistake beside the right one, and the quantity that differs.
    Mistake,
    /// The window in its own plane: its corner, its vectors, its pixels and their centres.
    PixelGrid,
    /// One ray and several spheres, the parabola of each under it.
    RootCases,
    /// The quadratic with b and with b′ = b/2: the same roots.
    Forms,
    /// An ellipsoid and its ray, and both where it is the unit sphere.
    Stretched,
    /// One ray and several planes, a panel each: ahead, behind, beside, around the ray.
    PlaneCases,
    /// The terms of the shade as bars over the angle between normal and light.
    Terms,
    /// The normal where surfaces are hit from outside and inside, from the front and the back.
    Sides,
    /// The root of a shadow ray that is the surface on which it starts, and ε.
    Epsilon,
    /// Balls at the rim of a wide picture, and the cones in which the eye sees them.
    Rim,
    /// The pseudocode of Fig. 15.56 beside the scene, line by line.
    Algorithm,
    /// The rays of a pixel beside their tree with its weights.
    RayTree,
}

/// A part of a figure that can be shown or left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Layer {
    /// The objects of the scene.
    Objects,
    /// Their names.
    Names,
    /// The eye.
    Eye,
    /// The window.
    Window,
    /// The pixels on the window.
    Pixels,
    /// The lights.
    Lights,
    /// Eye rays, or the ray that is drawn.
    Ray,
    /// Rays to lights.
    ShadowRays,
    /// Reflected and refracted rays.
    Secondary,
    /// Paths of light.
    LightPaths,
    /// Lines between a path of light and one from the eye.
    Connections,
    /// What was hit, and where.
    Hits,
    /// The normals of what was hit.
    Normals,
    /// Angles to the normals.
    Angles,
    /// Objects that were tested, and what came of it.
    Tests,
    /// Cells of the grid.
    Cells,
    /// What is on the lists of the cells.
    Lists,
    /// Bounding volumes.
    Volumes,
    /// Slabs.
    Slabs,
    /// The tree of a hierarchy.
    Tree,
    /// The parabola of a quadratic.
    Parabola,
    /// What is projected, and onto what.
    Projection,
    /// Numbers beside the lines.
    Numbers,
    /// The picture beside the figure, the traced pixel marked.
    Image,
    /// What the looks of lines mean.
    Legend,
}

/// A coordinate that is dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum DroppedAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}
