//! Tracing what a figure is drawn from.

use crate::figure::{FigureError, FigureKind, FigureSpec, OF_EVERY_PIXEL, Traced};
use crate::lesson::LessonError;
use crate::scene::Loaded;
use crate::strategy::{Chosen, Strategy};
use crate::structure::{StructureOptions, VolumeKind};
use crate::trace::{Kind, Kinds, Record, Recording, Settings, Sink, StrategyName};
use crate::tracer::{Tracer, trace_pixel};

/// The most pixels that a figure's picture may have: all are traced, and each is a square.
const MOST_PIXELS: u64 = 512 * 512;

/// Traces a scene as a figure asks for it, once for each of its strategies and volumes.
///
/// `name` is the figure's, as in `12-grid/walk`; `wrong` says where its specification is.
///
/// # Errors
/// A scene that makes no sense, or a specification that does not fit it.
pub fn trace_figure(
    mut loaded: Loaded,
    name: &str,
    spec: &FigureSpec,
    wrong: impl Fn(FigureError) -> LessonError,
) -> Result<Vec<Traced>, LessonError> {
    let error = |key, what: String, fix: &str| {
        wrong(FigureError {
            key,
            what,
            fix: fix.into(),
        })
    };
    if let Some(size) = spec.size {
        loaded.scene.camera.pixels = size;
    }
    let scene = loaded.build()?;
    let [width, height] = scene.camera.pixels;
    if MOST_PIXELS < u64::from(width) * u64::from(height) {
        return Err(error(
            "size",
            format!(
                "a figure's picture of {width} × {height} pixels is too large: every pixel is traced"
            ),
            "give the figure a \"size\" of at most 512 × 512 in all, such as [48, 36]",
        ));
    }
    let whole = spec.traced_pixels();
    if let Some([x, y]) = whole.iter().find(|[x, y]| width <= *x || height <= *y) {
        return Err(error(
            "pixel",
            format!("pixel {x},{y} is not in the picture of {width} × {height} pixels"),
            "count columns from 0 at the left and rows from 0 at the top",
        ));
    }

    let kept = kept(spec.kind);
    let strategies: &[StrategyName] = match spec.strategies.as_slice() {
        [] => &[spec.strategy],
        several => several,
    };
    let volumes: &[VolumeKind] = match spec.volumes.as_slice() {
        [] => &[spec.structure.volume],
        several => several,
    };
    let variants = strategies.iter().flat_map(|&strategy| {
        let with = |&volume: &VolumeKind| StructureOptions {
            volume,
            ..spec.structure
        };
        volumes.iter().map(move |volume| (strategy, with(volume)))
    });
    let trace = |(strategy, structure): (StrategyName, StructureOptions)| {
        let settings = Settings {
            strategy,
            structure,
            building: true,
            transport: spec.transport,
            light: spec.light,
            through: spec.through,
            one_sided: false,
            only: Some(kept.iter().map(|kind| kind.name().into()).collect()),
            whole: whole.clone(),
            figure: Some(name.into()),
            region: None,
        };
        let chosen = Chosen::new(&scene, strategy, &structure)
            .map_err(|fault| error("structure", fault.to_string(), "change it in the lesson"))?;
        let tracer = Tracer::new(&scene, &chosen, spec.transport);
        let mut recording = Recording::new(Keep {
            records: Vec::new(),
            whole: &whole,
            of_every: Kinds::of(kept),
        });
        chosen.note_building(&mut recording);
        for y in 0..height {
            for x in 0..width {
                trace_pixel(&tracer, [x, y], spec.through, &mut recording);
            }
        }
        let records = recording.into_sink().records;
        Ok(Traced {
            scene: scene.clone(),
            settings,
            records,
        })
    };
    variants.map(trace).collect()
}

/// What is kept of every pixel.
fn kept(kind: FigureKind) -> &'static [Kind] {
    match kind {
        FigureKind::Heat => &OF_EVERY_PIXEL,
        _ => &OF_EVERY_PIXEL[..1],
    }
}

/// Keeps every event of some pixels, and some kinds of all others.
struct Keep<'a> {
    records: Vec<Record>,
    whole: &'a [[u32; 2]],
    of_every: Kinds,
}

impl Sink for Keep<'_> {
    fn record(&mut self, record: &Record) {
        let is_whole = record.pixel.is_none_or(|pixel| self.whole.contains(&pixel));
        if is_whole || self.of_every.contains(record.event.kind()) {
            self.records.push(*record);
        }
    }
}
