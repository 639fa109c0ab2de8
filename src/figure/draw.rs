//! From a specification and its trace to a drawing.

use crate::figure::error::FigureError;
use crate::figure::kinds::kind;
use crate::figure::near::near;
use crate::figure::parts::picture;
use crate::figure::sheet::canvas::{Canvas, Rendition, UpTo};
use crate::figure::sheet::stage::Stage;
use crate::figure::sheet::strokes::Strokes;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::{FigureKind, FigureSpec, Layer};
use crate::figure::subject::Figure;
use crate::figure::traced::Traced;

/// A figure as it came out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// The drawing as a whole SVG document.
    pub svg: String,
    /// What it shows, in words made from the events: what is read out in its place.
    pub description: String,
    /// The steps of the trace that make something in it, rising.
    pub steps: Vec<u32>,
    /// The stages of its argument, in their order.
    pub stages: Vec<DrawnStage>,
}

/// A stage of a figure's argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrawnStage {
    /// Its name: a named part of a derivation, or a word that the figure alone has.
    pub name: String,
    /// What it says.
    pub sentence: String,
    /// The last step of the trace that it needs.
    pub step: Option<u32>,
}

/// Draws a figure from its trace alone. The id begins all ids and classes in it: a word of letters, digits and `-`.
///
/// # Errors
/// A specification that asks for what the trace or the kind of figure does not have.
pub fn draw(
    spec: &FigureSpec,
    traced: &[Traced],
    id: &str,
    width: Width,
    rendition: Rendition,
) -> Result<Drawn, FigureError> {
    let (figure, sheet, description) = laid_out(spec, traced, width, rendition.titled)?;
    let marks = sheet.marks.iter().map(|mark| mark.since.step);
    let words = sheet.words.iter().map(|of| of.since.step);
    let labels = sheet.labels.iter().map(|of| of.since.step);
    let mut steps: Vec<u32> = marks.chain(words).chain(labels).flatten().collect();
    steps.sort_unstable();
    steps.dedup();
    let rendition = Rendition {
        up_to: rendition.up_to.or(spec.step.map(UpTo::Step)),
        ..rendition
    };
    if let Some(UpTo::Stage(stage)) = rendition.up_to
        && !(1..=sheet.stages.len()).contains(&(stage as usize))
    {
        let last = sheet.stages.len();
        let fix = match last {
            0 => "draw it without one".into(),
            _ => format!("its stages are 1 to {last}"),
        };
        let what = format!("the figure has no stage {stage}");
        return Err(FigureError::new("stage", what, fix));
    }
    let stages: Vec<DrawnStage> = sheet.stages.iter().map(DrawnStage::of).collect();
    let description = match rendition.up_to {
        Some(up_to) if !stages.is_empty() && !is_all(&stages, &steps, up_to) => {
            story(&stages, up_to)
        }
        _ => description,
    };
    // before the first stage is done, and where no ray is cast, there is the title alone
    let description = match description {
        nothing if nothing.is_empty() => figure.title(),
        description => description,
    };
    Ok(Drawn {
        svg: Canvas::write(sheet, id, [&figure.title(), &description], rendition),
        description,
        steps,
        stages,
    })
}

/// The same drawing as lines, points and words, for a face that draws by itself.
///
/// # Errors
/// A specification that asks for what the trace or the kind of figure does not have.
pub fn strokes(spec: &FigureSpec, traced: &[Traced]) -> Result<Strokes, FigureError> {
    let (_, sheet, _) = laid_out(spec, traced, Width::Book, false)?;
    Ok(Strokes::of(sheet))
}

/// The sheet with all marks and words on it, and what it shows in words.
fn laid_out<'a>(
    spec: &'a FigureSpec,
    traced: &'a [Traced],
    width: Width,
    titled: bool,
) -> Result<(Figure<'a>, Sheet, String), FigureError> {
    let [first, ..] = traced else {
        return Err(FigureError::of_log("the log of this figure is empty"));
    };
    is_whole(spec, traced)?;
    let kind = kind(spec.kind);
    let layers = || kind.usual.iter().chain(kind.more).chain([&Layer::Image]);
    if let Some(layer) = spec.show.iter().find(|of| !layers().any(|has| has == *of)) {
        let has: Vec<String> = layers().map(|of| of.name()).collect();
        return Err(FigureError::new(
            "show",
            format!("this kind of figure has nothing called {}", layer.name()),
            format!("choose among {}", has.join(", ")),
        ));
    }
    let figure = Figure {
        spec,
        near: near(&first.scene, &first.records),
        traced,
        usual: kind.usual,
        scene: &first.scene,
        first,
    };
    let mut sheet = Sheet::new(width, kind.height);
    let mut body = sheet.body();
    if titled {
        body = sheet.heading(body, &figure.title());
    }
    let beside = spec
        .show
        .contains(&Layer::Image)
        .then(|| picture::room_beside(&sheet, body));
    let body = beside.map_or(body, |[left, _]| left);
    let description = (kind.draw)(&figure, &mut sheet, body)?;
    if let Some([_, right]) = beside {
        // the picture shows the colour of the pixel
        sheet.at_last(|sheet| picture::beside(&figure, sheet, right))?;
    }
    Ok((figure, sheet, description))
}

impl DrawnStage {
    fn of(stage: &Stage) -> Self {
        Self {
            name: stage.name.0.clone().into_owned(),
            sentence: stage.sentence.clone(),
            step: stage.step,
        }
    }
}

/// Is the drawing up to there the whole one?
fn is_all(stages: &[DrawnStage], steps: &[u32], up_to: UpTo) -> bool {
    match up_to {
        UpTo::Stage(last) => stages.len() <= last as usize,
        UpTo::Step(last) => steps.last().is_none_or(|step| *step <= last),
    }
}

/// What the stages say up to there.
fn story(stages: &[DrawnStage], up_to: UpTo) -> String {
    let is_told = |(place, stage): &(usize, &DrawnStage)| match up_to {
        UpTo::Stage(last) => *place < last as usize,
        UpTo::Step(last) => stage.step.is_none_or(|step| step <= last),
    };
    let told = stages.iter().enumerate().filter(is_told);
    let told: Vec<&str> = told.map(|(_, stage)| stage.sentence.as_str()).collect();
    told.join(" ")
}

/// Is the log of a figure all there? It has what the figure shows up to the colour of the last pixel, once for each variant.
fn is_whole(spec: &FigureSpec, traced: &[Traced]) -> Result<(), FigureError> {
    let of_figure = |of: &&Traced| of.settings.figure.is_some();
    if !traced.iter().all(|of| of_figure(&of)) {
        // a log of another kind has what it has
        return Ok(());
    }
    let [width, height] = traced[0].scene.camera.pixels;
    // its colour closes the log
    let last = [width - 1, height - 1];
    let variants = [
        spec.strategies.len(),
        spec.volumes.len(),
        spec.resolutions.len(),
        spec.transports.len(),
    ];
    let variants: usize = variants.iter().map(|count| (*count).max(1)).product();
    let paths = spec.paths.unwrap_or(0) as usize;
    let cut = |of: &&Traced| {
        let mut pixels = spec.traced_pixels().into_iter().chain([last]);
        let has_no_tests = spec.kind == FigureKind::Heat && of.of_pixels.tests.is_empty();
        let has_no_mistake = spec.kind == FigureKind::Mistake && of.of_pixels.mistake.is_none();
        let paths = if of.settings.transport.follows_light() {
            paths
        } else {
            0
        };
        pixels.any(|pixel| !of.has_colour(pixel))
            || of.paths().len() < paths
            || has_no_tests
            || has_no_mistake
    };
    let has_picture = traced[0].of_pixels.picture.is_some() || !spec.shows_picture();
    if traced.len() == variants && has_picture && !traced.iter().any(|of| cut(&of)) {
        return Ok(());
    }
    Err(FigureError::of_log(
        "the log of this figure is not whole: its end is missing, or the lesson has changed since",
    ))
}
