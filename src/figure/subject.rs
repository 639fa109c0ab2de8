//! What a figure is drawn from: its specification, its trace, and the ray or the pixel that it shows.

use glam::DVec3;
use serde::Serialize;

use crate::figure::error::FigureError;
use crate::figure::sheet::frame::Frame;
use crate::figure::spec::{FigureKind, FigureSpec, Layer};
use crate::figure::traced::{Section, Traced};
use crate::figure::view::{Projection, Space};
use crate::scene::{PrimitiveId, Scene};
use crate::trace::{Event, RayNode, RayTree, Record};

/// What a kind of figure draws from.
pub(super) struct Figure<'a> {
    pub(super) spec: &'a FigureSpec,
    /// One trace for each strategy.
    pub(super) traced: &'a [Traced],
    /// The first of them.
    pub(super) first: &'a Traced,
    pub(super) scene: &'a Scene,
    /// The primitives that are drawn: all of a small scene, of a large one those near the rays.
    pub(super) near: Vec<PrimitiveId>,
    /// What its kind shows if nothing is said.
    pub(super) usual: &'static [Layer],
}

impl<'a> Figure<'a> {
    /// The title that the specification gives, or what is drawn of which scene.
    pub(super) fn title(&self) -> String {
        if !self.spec.title.is_empty() {
            return self.spec.title.clone();
        }
        if let Some(mistake) = &self.spec.mistake {
            return format!("Mistake: {mistake}");
        }
        let of = match self.scene.name.as_str() {
            "" => "the scene",
            name => name,
        };
        let pixels = self.pixels();
        let pixels: Vec<String> = pixels.iter().map(|[x, y]| format!("({x}, {y})")).collect();
        let kind = self.spec.kind.name();
        match pixels.len() {
            0 => format!("{kind} of {of}"),
            1 => format!("{kind} of {of}, pixel {}", pixels[0]),
            _ => format!("{kind} of {of}, pixels {}", pixels.join(", ")),
        }
    }

    /// Is this part shown?
    pub(super) fn shows(&self, layer: Layer) -> bool {
        let chosen = self.spec.show.iter().any(|of| *of != Layer::Image);
        let layers = if chosen {
            self.spec.show.as_slice()
        } else {
            self.usual
        };
        layers.contains(&layer)
    }

    /// The pixels that are drawn.
    pub(super) fn pixels(&self) -> Vec<[u32; 2]> {
        self.spec.traced_pixels()
    }

    /// The pixel that is drawn.
    ///
    /// # Errors
    /// The specification names none.
    pub(super) fn pixel(&self) -> Result<[u32; 2], FigureError> {
        self.pixels().first().copied().ok_or_else(|| {
            FigureError::new(
                "pixel",
                "this kind of figure draws the trace of a pixel, and none is named",
                "add \"pixel\": [x, y]",
            )
        })
    }

    /// The events of the pixel that is drawn.
    ///
    /// # Errors
    /// There is none, or nothing was recorded about it.
    pub(super) fn records(&self) -> Result<&'a [Record], FigureError> {
        self.records_of(self.pixel()?)
    }

    /// The events of one of the pixels that are drawn.
    ///
    /// # Errors
    /// Nothing was recorded about it.
    pub(super) fn records_of(&self, pixel: [u32; 2]) -> Result<&'a [Record], FigureError> {
        records_in(self.first, pixel)
    }

    /// The same, with their steps after those of the paths of light.
    ///
    /// # Errors
    /// Nothing was recorded about it.
    pub(super) fn section_of(&self, pixel: [u32; 2]) -> Result<Section<'a>, FigureError> {
        Ok(self.first.after_paths(self.records_of(pixel)?))
    }

    /// The ray that is drawn, with the events on it.
    ///
    /// # Errors
    /// The pixel has no such ray.
    pub(super) fn ray(&self) -> Result<DrawnRay<'a>, FigureError> {
        DrawnRay::find(self.records()?, self.spec.ray.unwrap_or(0))
    }

    /// The steps at which a ray of the pixel starts and ends.
    ///
    /// # Errors
    /// Nothing was recorded about the pixel.
    pub(super) fn steps_of(&self, ray: &DrawnRay) -> Result<[Option<u32>; 2], FigureError> {
        let records = self.records()?;
        Ok(ray.node.ends_at.map(|at| Some(records.get(at?)?.step)))
    }

    /// The projection that the specification asks for.
    pub(super) fn projection(&self) -> Projection {
        self.spec.view.projection(&self.scene.camera)
    }

    /// The space in a frame that shows what the specification names, or else these points.
    pub(super) fn space(&self, frame: Frame, points: impl IntoIterator<Item = DVec3>) -> Space {
        let projection = self.projection();
        match self.spec.frame {
            Some(corners) if projection.in_space => {
                let [a, b] = corners.map(DVec3::from);
                let corner = |bits: u8| {
                    DVec3::from_array(
                        [0, 1, 2].map(|axis| [a, b][usize::from(bits >> axis & 1)][axis]),
                    )
                };
                Space::fitted(projection, frame, (0..8).map(corner))
            }
            Some(corners) => Space::fitted(projection, frame, corners.map(DVec3::from)),
            None => Space::fitted(projection, frame, points),
        }
    }

    /// The first primitive of the object that the specification names.
    ///
    /// # Errors
    /// The scene has no such object.
    pub(super) fn object(&self) -> Result<Option<PrimitiveId>, FigureError> {
        let Some(name) = &self.spec.object else {
            return Ok(None);
        };
        let objects = &self.scene.objects;
        if let Some(object) = objects.iter().find(|object| object.name == *name) {
            return Ok(Some(object.first));
        }
        let known = objects.iter().map(|object| object.name.as_str());
        let near = crate::scene::nearest_name(name, known);
        let fix = near.map_or("name one of its objects".into(), |near| {
            format!("did you mean {near:?}?")
        });
        let what = format!("the scene has no object {name:?}");
        Err(FigureError::new("object", what, fix))
    }
}

/// The events of a pixel in one of the traces.
///
/// # Errors
/// Nothing was recorded about it.
pub(super) fn records_in(traced: &Traced, pixel: [u32; 2]) -> Result<&[Record], FigureError> {
    let records = traced.pixel(pixel);
    let begins = |record: &Record| matches!(record.event, Event::Pixel(_));
    if records.first().is_some_and(begins) {
        return Ok(records);
    }
    let [x, y] = pixel;
    Err(FigureError::new(
        "pixel",
        format!("the log has no events of pixel {x},{y}"),
        "trace the figure again, or name a pixel that the log holds",
    ))
}

impl FigureSpec {
    /// The pixels whose whole trace the figure draws.
    pub fn traced_pixels(&self) -> Vec<[u32; 2]> {
        self.pixel
            .into_iter()
            .chain(self.pixels.iter().copied())
            .collect()
    }
}

/// The name that a lesson file has for a value.
fn name_in_file(value: impl Serialize) -> String {
    let json = serde_json::to_value(value).unwrap_or_default();
    json.as_str().unwrap_or_default().into()
}

impl Layer {
    pub(super) fn name(self) -> String {
        name_in_file(self)
    }
}

impl FigureKind {
    fn name(self) -> String {
        name_in_file(self)
    }
}

/// A ray of a pixel, and what happened on it.
pub(super) struct DrawnRay<'a> {
    /// Its start, its end.
    pub(super) node: RayNode,
    /// What happened on it, without its own start and end, and the rays that it spawned.
    pub(super) events: Vec<&'a Record>,
}

impl<'a> DrawnRay<'a> {
    pub(super) fn find(records: &'a [Record], id: u32) -> Result<Self, FigureError> {
        let tree = RayTree::new(records);
        let Some(place) = tree.find(id) else {
            let last = tree.rays.len().saturating_sub(1);
            return Err(FigureError::new(
                "ray",
                format!("the pixel has no ray {id}"),
                format!("its rays are 0 to {last}"),
            ));
        };
        let events = records.iter().filter(|record| {
            record.ray == Some(id) && !matches!(record.event, Event::Ray(_) | Event::RayEnd(_))
        });
        Ok(Self {
            node: tree.rays[place].clone(),
            events: events.collect(),
        })
    }
}
