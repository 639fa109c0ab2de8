//! `raystep figure`: one figure of a lesson, from its scene or from a saved log, as SVG, PNG or PDF; its stages as files, or
//! as pages of one PDF.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use raystep::figure::{Drawn, DrawnStage, FigureKind, UpTo, draw};
use raystep::lesson::{Lesson, LessonError, own_figure, wrong_figure};
use raystep::scene::{Loaded, printable};
use raystep::trace::LogError;
use raystep::{FigureName, FigureSpec, Folder, Library, Rendition, Traced, Width};

use crate::cli::Error;
use crate::cli::args::{Drawing, FigureArgs, Reading, Subject, WidthName};
use crate::cli::input::{Input, name_of, needs_scene, open};
use crate::cli::output::{Output, is_standard, refuse_ending};
use crate::cli::raster;
use crate::cli::same_file::Taken;
use crate::cli::word::word;

impl Drawing {
    /// The lessons.
    pub(crate) fn library(&self) -> Result<Library, LessonError> {
        Library::open(&Folder::new(&self.lessons).allow_outside(self.allow_outside))
    }

    /// For what it is drawn, and how it is written.
    pub(crate) fn rendition(&self) -> (Width, Rendition) {
        let width = match self.width {
            WidthName::Book => Width::Book,
            WidthName::Slide => Width::Slide,
        };
        let rendition = Rendition {
            grayscale: self.grayscale,
            standalone: self.standalone,
            titled: self.titled,
            up_to: None,
        };
        (width, rendition)
    }
}

/// What the ids of a figure in a file of its own begin with.
pub(crate) fn id_of(name: &FigureName) -> String {
    let lesson = name.lesson.chars();
    let lesson: String = lesson
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' })
        .collect();
    format!("raystep-{lesson}-{}", name.figure)
}

/// What the figure is drawn from.
enum Source<'a> {
    Log(&'a Path),
    Scene(Box<Loaded>),
}

/// Draws the figure.
pub(crate) fn run(args: &FigureArgs) -> Result<(), Error> {
    match (&args.subject, &args.scene, args.kind) {
        (Subject::Pixel(pixel), Some(scene), Some(kind)) => of_scene(args, scene, kind, *pixel),
        (Subject::Figure(name), None, _) => of_lesson(args, name),
        (Subject::Figure(name), Some(_), _) => Err(Error::Subject {
            what: format!("{name} is a figure of a lesson, and --scene draws a pixel of a scene"),
            fix: "name the pixel, as in --scene my.json 80,60 --kind grid",
        }),
        (Subject::Pixel([x, y]), _, _) => Err(Error::Subject {
            what: format!("{x},{y} is a pixel, but of which scene is not said"),
            fix: "add --scene FILE and --kind, or name a figure of a lesson, as in 12-grid/walk",
        }),
    }
}

/// A figure of a lesson, from its scene or from a log.
fn of_lesson(args: &FigureArgs, name: &FigureName) -> Result<(), Error> {
    let library = args.drawing.library()?;
    let (lesson, spec) = library.find(name)?;
    let mut taken = Taken::nothing();
    for lesson in &library.lessons {
        taken.read(lesson.path());
    }
    let source = match &args.log {
        Some(log) => {
            taken.read(log);
            Source::Log(log)
        }
        None => {
            let loaded = lesson.load(&name.figure, spec)?;
            for file in &loaded.files {
                taken.read(file);
            }
            Source::Scene(Box::new(loaded))
        }
    };
    if let Some(path) = &args.write_log {
        taken.refuse(path)?;
        taken.write(path, "which --write-log writes");
    }
    if !args.steps && !args.stages {
        taken.refuse(&args.output)?;
    }
    // an ending that names no format is refused before anything is traced
    let format = Format::of(args)?;
    let traced = match source {
        Source::Log(log) => read_log(log)?,
        Source::Scene(loaded) => lesson.trace_loaded(&name.figure, spec, *loaded)?,
    };
    let draw = |how| Ok(drawn(lesson, spec, name, &traced, how)?);
    write(args, format, &taken, &traced, draw)
}

/// A figure of a scene that no lesson knows.
fn of_scene(
    args: &FigureArgs,
    scene: &Path,
    kind: FigureKind,
    pixel: [u64; 2],
) -> Result<(), Error> {
    let reading = Reading {
        allow_outside: args.drawing.allow_outside,
    };
    let loaded = match open(scene, &reading)? {
        Input::Scene(loaded) => *loaded,
        Input::Log(_) => return Err(needs_scene(scene, "such a figure traces")),
    };
    let taken = Taken::by_reading(scene, &loaded.files);
    if !args.steps && !args.stages {
        taken.refuse(&args.output)?;
    }
    let format = Format::of(args)?;
    let pixels = loaded.scene.camera.pixels;
    let outside = Error::PixelOutside { pixel, pixels };
    let [Ok(x), Ok(y)] = pixel.map(u32::try_from) else {
        return Err(outside);
    };
    if pixels[0] <= x || pixels[1] <= y {
        return Err(outside);
    }
    let file = name_of(scene);
    let (spec, traced) = own_figure(loaded, kind, [x, y], &file)?;
    let id = format!("raystep-{}", word(kind));
    let draw = |(width, rendition)| {
        let drawn = draw(&spec, &traced, &id, width, rendition);
        drawn.map_err(|error| Error::from(wrong_figure(&file, error)))
    };
    write(args, format, &taken, &traced, draw)
}

/// Draws a figure as far as the options say, and writes it.
fn write(
    args: &FigureArgs,
    format: Format,
    taken: &Taken,
    traced: &[Traced],
    drawn: impl Fn((Width, Rendition)) -> Result<Drawn, Error>,
) -> Result<(), Error> {
    let (width, mut rendition) = args.drawing.rendition();
    // the programs that make PNG and PDF know no variables
    rendition.standalone |= format != Format::Svg;
    let draw = |up_to| drawn((width, Rendition { up_to, ..rendition }));
    let step = args.step.map(UpTo::Step);
    let stage = args.stage.map(UpTo::Stage);
    let whole = draw(step.or(stage))?;
    let mut drawings = Vec::new();
    if args.steps {
        // a figure without stages is one
        let ends: Vec<Option<UpTo>> = match whole.stages.len() {
            0 => vec![None],
            last => (1..=last as u32)
                .map(|stage| Some(UpTo::Stage(stage)))
                .collect(),
        };
        let svgs: Result<Vec<String>, Error> =
            ends.into_iter().map(|end| Ok(draw(end)?.svg)).collect();
        let svgs = svgs?;
        if format == Format::Pdf {
            taken.refuse(&args.output)?;
            drawings.push((args.output.clone(), raster::pdf(&svgs)?));
        } else {
            let files = numbered(&args.output, svgs.len())?;
            for (file, svg) in files.into_iter().zip(svgs) {
                taken.refuse(&file)?;
                drawings.push((file, format.bytes(svg)?));
            }
        }
    } else if !args.stages {
        drawings.push((args.output.clone(), format.bytes(whole.svg.clone())?));
    }

    // nothing is written before all is drawn and every name is known to be free
    if let Some(path) = &args.write_log {
        let mut log = Output::create(path, &Taken::nothing())?;
        for traced in traced {
            traced.write(&mut log).map_err(|error| log.failed(error))?;
        }
        log.finish()?;
    }
    for (file, drawing) in drawings {
        Output::create(&file, taken)?.write_whole(&drawing)?;
    }
    if args.stages {
        Output::standard().write_whole(list_of_stages(&whole.stages).as_bytes())?;
    }
    Ok(())
}

/// A line for each stage: its number, its name and what it says.
fn list_of_stages(stages: &[DrawnStage]) -> String {
    let widest = stages.iter().map(|stage| stage.name.chars().count()).max();
    let widest = widest.unwrap_or(0);
    let line = |(place, stage): (usize, &DrawnStage)| {
        let name = printable(&stage.name);
        let sentence = printable(&stage.sentence);
        format!("{:>2}  {name:<widest$}  {sentence}\n", place + 1)
    };
    stages.iter().enumerate().map(line).collect()
}

/// Draws a figure of a lesson into a file of its own.
pub(crate) fn drawn(
    lesson: &Lesson,
    spec: &FigureSpec,
    name: &FigureName,
    traced: &[Traced],
    how: (Width, Rendition),
) -> Result<Drawn, LessonError> {
    lesson.draw(&name.figure, spec, traced, &id_of(name), how)
}

fn read_log(path: &Path) -> Result<Vec<Traced>, Error> {
    let file = path.display().to_string();
    let log = File::open(path).map_err(|source| LogError::Read {
        file: file.clone(),
        source,
    })?;
    Ok(Traced::read(&file, BufReader::new(log))?)
}

/// What a drawing is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
    Pdf,
}

impl Format {
    /// The one that is asked for, or that of the file's ending.
    fn of(args: &FigureArgs) -> Result<Self, Error> {
        let ending = args.output.extension();
        let ends = |with: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(with));
        if args.png || (!args.pdf && ends("png")) {
            return Ok(Self::Png);
        }
        if args.pdf || ends("pdf") {
            return Ok(Self::Pdf);
        }
        refuse_ending(&args.output, "a figure", &["svg", "png", "pdf"])?;
        Ok(Self::Svg)
    }

    /// A drawing as a file of its own.
    fn bytes(self, svg: String) -> Result<Vec<u8>, Error> {
        match self {
            Self::Svg => Ok(svg.into_bytes()),
            Self::Png => raster::png(&svg),
            Self::Pdf => raster::pdf(&[svg]),
        }
    }
}

/// `F-1.svg`, `F-2.svg`, … with as many digits as the last needs.
fn numbered(output: &Path, count: usize) -> Result<Vec<PathBuf>, Error> {
    if is_standard(output) {
        return Err(Error::Target {
            file: "standard output".into(),
            what: "--steps writes several files".into(),
            fix: "name the files with -o F.svg: they become F-1.svg, F-2.svg and so on".into(),
        });
    }
    let digits = count.to_string().len();
    let stem = output.file_stem().unwrap_or_default().to_string_lossy();
    let ending = output.extension().map_or(String::new(), |ending| {
        format!(".{}", ending.to_string_lossy())
    });
    let name = |i: usize| output.with_file_name(format!("{stem}-{i:0digits$}{ending}"));
    Ok((1..=count).map(name).collect())
}
