//! The picture and the heat map of a page.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

use glam::DVec3;
use raystep::explain::grouped;
use raystep::figure::heat_overlay;
use raystep::page::HeatOverlay;
use raystep::tracer::{HeatLine, HeatOf, heat_values, render_heat};
use raystep::{
    Chosen, Counts, Record, Recorder, StrategyName, StructureOptions, Tracer, Transport,
    render_picture,
};

use crate::cli::Error;
use crate::cli::input::Ready;
use crate::cli::light::light_pass;
use crate::cli::notes::note;
use crate::cli::progress::bar;
use crate::cli::usual::FEW;

/// What a page shows of the picture.
#[derive(Debug, Default)]
pub(crate) struct Shown {
    /// Red, green, blue and how opaque it is, of each pixel.
    pub(crate) picture: Option<Vec<u8>>,
    pub(crate) heat: Option<HeatOverlay>,
    /// What is to be said of it.
    pub(crate) notes: Vec<String>,
}

/// Traces the picture, with what each of its pixels costs. Beyond a number of objects both are traced by the hierarchy.
pub(crate) fn of_scene<'a>(
    file: &Path,
    ready: &'a Ready,
    strategy: &Chosen<'a>,
) -> Result<Shown, Error> {
    let started = Instant::now();
    let objects = ready.scene.primitives.len();
    let is_other = FEW < objects && ready.settings.strategy != StrategyName::Hierarchy;
    let hierarchy;
    let mut notes = Vec::new();
    let strategy = if is_other {
        let built = Chosen::new(
            &ready.scene,
            StrategyName::Hierarchy,
            &StructureOptions::default(),
        );
        hierarchy = built.map_err(|fault| Error::Structure { fault })?;
        notes.push(format!(
            "The picture and the heat map are traced by the hierarchy: the scene has {} objects.",
            grouped(objects as u64)
        ));
        &hierarchy
    } else {
        strategy
    };
    let light = light_pass(file, ready, strategy, None, None, None)?;
    let tracer = Tracer::new(&ready.scene, strategy, ready.settings.transport)
        .with_light(light.as_ref())
        .with_max_rays(ready.max_rays);
    let through = ready.settings.through;
    let bar = bar(u64::from(ready.scene.camera.pixels[1]));
    let done = |lines: usize| bar.set_position(lines as u64);
    let traced = if has_heat(ready.settings.transport) {
        render_heat(&tracer, through, &mut Counts::default(), &done)
            .map(|(picture, lines)| (picture, Some(lines)))
    } else {
        render_picture(&tracer, through, None, &done).map(|picture| (picture, None))
    };
    bar.finish_and_clear();
    let (picture, lines) = traced.map_err(|stopped| ready.stopped(stopped))?;
    let heat = lines.map(|lines| {
        let values = heat_values(&lines, HeatOf::Tests, through);
        overlay(&values.into_iter().map(Some).collect::<Vec<_>>())
    });
    let rgb = picture.bytes();
    let (rgb, _) = rgb.as_chunks();
    let opaque = rgb.iter().flat_map(|&[r, g, b]| [r, g, b, u8::MAX]);
    note(&format!(
        "the picture and the heat map took {:.1} s",
        started.elapsed().as_secs_f64()
    ));
    Ok(Shown {
        picture: Some(opaque.collect()),
        heat,
        notes,
    })
}

/// Is a cost one of a single pixel? A ray to the eye, or a connecting line, belongs to none.
fn has_heat(transport: Transport) -> bool {
    !matches!(transport, Transport::Forward | Transport::HybridConnected)
}

/// The heat map of values, one for each pixel of the picture.
fn overlay(values: &[Option<f64>]) -> HeatOverlay {
    let (colours, range) = heat_overlay(values);
    HeatOverlay {
        colours,
        range,
        title: HeatOf::Tests.title().into(),
    }
}

/// The object tests of a log's pixels, one record after the other.
#[derive(Debug, Default)]
pub(crate) struct LogHeat {
    known: BTreeMap<[u32; 2], f64>,
    /// The pixel that is read, and the tests of its eye rays so far.
    open: Option<([u32; 2], HeatLine)>,
}

impl LogHeat {
    /// One more record of the log.
    pub(crate) fn add(&mut self, record: &Record) {
        let pixel = record.pixel;
        if self.open.as_ref().map(|(pixel, _)| *pixel) != pixel {
            self.end();
            self.open = pixel.map(|pixel| (pixel, HeatLine::default()));
        }
        if let Some((_, line)) = &mut self.open {
            line.note(|| record.event);
        }
    }

    /// The pixel that was read has no more records.
    fn end(&mut self) {
        let open = self.open.take();
        let value = open.and_then(|(pixel, line)| Some((pixel, line.of_pixel(HeatOf::Tests)?)));
        self.known.extend(value);
    }

    /// The heat map; `None` if the log has no test of an object.
    fn overlay(mut self, [width, height]: [u32; 2]) -> Option<HeatOverlay> {
        self.end();
        let columns = |y| (0..width).map(move |x| [x, y]);
        let pixels = (0..height).flat_map(columns);
        let values: Vec<Option<f64>> = pixels
            .map(|pixel| self.known.get(&pixel).copied())
            .collect();
        let is_tested = values.iter().flatten().any(|tests| 0.0 < *tests);
        is_tested.then(|| overlay(&values))
    }
}

/// The picture and the heat map as far as a log has their pixels.
pub(crate) fn of_log(
    size: [u32; 2],
    transport: Transport,
    colours: &[([u32; 2], DVec3)],
    heat: LogHeat,
) -> Shown {
    let [width, height] = size;
    let heat = Some(heat).filter(|_| has_heat(transport));
    let all = width as usize * height as usize;
    let mut picture = vec![0; 4 * all];
    let mut known = vec![false; all];
    for ([x, y], colour) in colours {
        let place = *y as usize * width as usize + *x as usize;
        let Some(pixel) = picture.get_mut(4 * place..4 * place + 4) else {
            continue;
        };
        let [r, g, b] = colour.to_array().map(|of| (of * 255.0).round() as u8);
        pixel.copy_from_slice(&[r, g, b, u8::MAX]);
        known[place] = true;
    }
    let known = known.into_iter().filter(|known| *known).count();
    let notes = if known == all {
        Vec::new()
    } else {
        vec![format!(
            "The log has {} of the {} pixels of the picture.",
            grouped(known as u64),
            grouped(all as u64)
        )]
    };
    Shown {
        picture: Some(picture),
        heat: heat.and_then(|heat| heat.overlay(size)),
        notes,
    }
}
