//! What comes into a chapter in the place of a directive.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use std::time::Duration;

use crate::book::directive::{Asks, Directive};
use crate::book::html::{one_line, prose};
use crate::book::stepper::Asked;
use crate::book::value::value;
use crate::book::words::{unknown_option, whole_log, whole_number};
use crate::explain::render::{escaped, html};
use crate::explain::{Unfold, WorkedOptions, worked_solution};
use crate::figure::FigureSpec;
use crate::figure::{Rendition, Traced, UpTo, Width};
use crate::lesson::{
    FigureName, Lesson, LessonError, Library, NotCompared, compare, compare_transports,
    light_of_lamps,
};
use crate::page::{Stepper, shared, stepper};
use crate::scene::{LoadError, nearest_name, quoted};
use crate::trace::{Kind, Kinds};
use crate::tracer::{MAX_RAYS, Stopped};

/// Follows directives; what a figure is drawn from is traced once for all that name it.
pub(super) struct Expander<'a> {
    library: &'a Library,
    /// The folder of the lessons as it is written in commands.
    lessons: Option<String>,
    traced: HashMap<FigureName, Arc<Vec<Traced>>>,
    /// The ids that were given, in all chapters: a book may have them all on one page.
    ids: HashSet<String>,
    /// The chapter, as a part of ids.
    chapter: String,
    /// Has the chapter the script of its steppers?
    has_script: bool,
}

/// A figure that a directive names.
struct Named<'a> {
    name: FigureName,
    lesson: &'a Lesson,
    spec: &'a FigureSpec,
    traced: Arc<Vec<Traced>>,
}

impl<'a> Expander<'a> {
    pub(super) fn new(library: &'a Library, lessons: Option<String>) -> Self {
        Self {
            library,
            lessons,
            traced: HashMap::new(),
            ids: HashSet::new(),
            chapter: String::new(),
            has_script: false,
        }
    }

    /// The directives that follow are those of another chapter; its name is a word.
    pub(super) fn begin_chapter(&mut self, chapter: String) {
        self.chapter = chapter;
        self.has_script = false;
    }

    /// What stands in the place of the directive.
    ///
    /// # Errors
    /// What is wrong, and what to do about it.
    pub(super) fn expand(&mut self, directive: &Directive) -> Result<String, String> {
        if !directive.ends {
            return Err("it has no end\n  close it with }} on the same line".into());
        }
        let asks = asks(&directive.word)?;
        let (name, words) = directive
            .words
            .split_first()
            .ok_or("no figure is named\n  as in {{#raystep 12-grid/walk}}")?;
        let named = self.named(name)?;
        if asks == Asks::Value {
            return in_prose(&named, words);
        }
        let alone = directive
            .alone
            .as_ref()
            .ok_or("this directive expands to a block\n  put it on a line of its own")?;
        let html = match asks {
            Asks::Figure => match words.split_first() {
                Some((first, words)) if first == "stepper" => {
                    self.stepper(&named, words, &alone.begins)?
                }
                _ => self.figure(&named, words)?,
            },
            Asks::Log => log(&named, words)?,
            Asks::Compare => table(&named, words)?,
            Asks::Value => return Ok(String::new()),
        };
        Ok(format!("{html}{}", alone.ends))
    }

    fn named(&mut self, name: &str) -> Result<Named<'a>, String> {
        let name: FigureName = name.parse().map_err(|why: String| {
            let known = self.library.figures();
            let known: Vec<String> = known.iter().map(ToString::to_string).collect();
            match nearest_name(name, known.iter().map(String::as_str)) {
                Some(near) => format!("{} is not a figure\n  did you mean {near}?", quoted(name)),
                None => format!("{} is not a figure\n  {why}", quoted(name)),
            }
        })?;
        let (lesson, spec) = self
            .library
            .find(&name)
            .map_err(|error| error.to_string())?;
        let traced = match self.traced.get(&name) {
            Some(traced) => Arc::clone(traced),
            None => {
                let traced = lesson.trace(&name.figure, spec);
                let traced = Arc::new(traced.map_err(|error| told(&error))?);
                self.traced.insert(name.clone(), Arc::clone(&traced));
                traced
            }
        };
        Ok(Named {
            name,
            lesson,
            spec,
            traced,
        })
    }

    fn figure(&mut self, named: &Named, words: &[String]) -> Result<String, String> {
        let mut up_to = None;
        for word in words {
            match word.split_once('=') {
                Some((key @ ("step" | "stage"), _)) if up_to.is_some() => {
                    return Err(format!(
                        "{key} comes after another end of the drawing\n  give one step=N, or one stage=N"
                    ));
                }
                Some(("step", number)) => {
                    up_to = Some(UpTo::Step(whole_number("step", number)?));
                }
                Some(("stage", number)) => {
                    up_to = Some(UpTo::Stage(whole_number("stage", number)?));
                }
                _ => return Err(unknown_option(word, &["step=N", "stage=N", "stepper"])),
            }
        }
        let mut command = format!("raystep figure {}", named.name);
        match up_to {
            Some(UpTo::Step(step)) => command = format!("{command} --step {step}"),
            Some(UpTo::Stage(stage)) => command = format!("{command} --stage {stage}"),
            None => {}
        }
        let id = self.id(&named.name);
        let svg = drawing(named, &id, up_to)?;
        let caption = self.caption(named.spec, &command);
        Ok(format!(
            "<figure class=\"raystep\" id=\"{id}_figure\">{svg}<figcaption>{caption}</figcaption></figure>"
        ))
    }

    /// The figure with its steps. In the first stepper of a chapter its lines begin with the script of all.
    fn stepper(&mut self, named: &Named, words: &[String], begins: &str) -> Result<String, String> {
        let asked = Asked::new(words)?;
        let steps = asked.steps(named.spec, first(named)?)?;
        let id = self.id(&named.name);
        let command = format!("raystep figure {}", named.name);
        let figure = stepper(&Stepper {
            svg: &drawing(named, &id, None)?,
            id: &format!("{id}_figure"),
            caption: &self.caption(named.spec, &command),
            steps: &steps,
            predicts: asked.predicts,
        });
        if std::mem::replace(&mut self.has_script, true) {
            return Ok(figure);
        }
        let next_line = format!("\n{begins}");
        Ok(format!(
            "{}{next_line}{figure}",
            shared().replace('\n', &next_line)
        ))
    }

    /// What stands below a figure: its caption, and the command that draws it.
    fn caption(&self, spec: &FigureSpec, command: &str) -> String {
        let lessons = self.lessons.as_ref();
        let lessons = lessons.map_or(String::new(), |lessons| {
            format!(" --lessons {}", for_shell(lessons))
        });
        format!(
            "{} <code>{}</code>",
            escaped(&spec.caption),
            escaped(&format!("{command}{lessons}"))
        )
    }

    /// The chapter and the figure, and a number if that was given before.
    fn id(&mut self, name: &FigureName) -> String {
        let id = word(&format!(
            "raystep-{}-{}-{}",
            self.chapter, name.lesson, name.figure
        ));
        // no word has a _, so that no number and no part of a drawing makes the id of another figure
        let numbered = (2..).map(|number| format!("{id}_{number}"));
        let mut all = std::iter::once(id.clone()).chain(numbered);
        let free = all.find(|id| !self.ids.contains(id)).unwrap_or(id);
        self.ids.insert(free.clone());
        free
    }
}

/// The drawing of a figure, on one line.
fn drawing(named: &Named, id: &str, up_to: Option<UpTo>) -> Result<String, String> {
    let Named {
        name,
        lesson,
        spec,
        traced,
    } = named;
    let rendition = Rendition {
        up_to,
        ..Rendition::default()
    };
    let drawn = lesson.draw(&name.figure, spec, traced, id, (Width::Book, rendition));
    let drawn = drawn.map_err(|error| error.to_string())?;
    Ok(one_line(&drawn.svg))
}

/// What is wrong with a lesson; files outside of its folder are allowed in `book.toml`.
fn told(error: &LessonError) -> String {
    match error {
        LessonError::Load(LoadError::Outside { .. }) => {
            format!("{error}: \"allow-outside\" = true in [preprocessor.raystep] of book.toml")
        }
        other => other.to_string(),
    }
}

fn first<'a>(named: &'a Named) -> Result<&'a Traced, String> {
    let first = named.traced.first();
    first.ok_or_else(|| "this figure has no trace\n  name another figure".into())
}

/// A value in running text.
fn in_prose(named: &Named, words: &[String]) -> Result<String, String> {
    let [path] = words else {
        return Err(
            "exactly one path names a value\n  as in {{#raystep-value 12-grid/walk cell.count}}"
                .into(),
        );
    };
    let first = first(named)?;
    let value = value(first, named.spec.traced_pixels().first().copied(), path)?;
    Ok(prose(&value))
}

/// The directive that a word means.
fn asks(word: &str) -> Result<Asks, String> {
    if let Some(asks) = Asks::ALL.into_iter().find(|asks| asks.name() == word) {
        return Ok(asks);
    }
    let names = Asks::ALL.map(Asks::name);
    let fix = match nearest_name(word, names.into_iter()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("there are {}", names.join(", ")),
    };
    Err(format!("there is no directive {}\n  {fix}", quoted(word)))
}

/// A path as a shell reads it.
fn for_shell(path: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._/-".contains(c);
    if path.chars().all(plain) {
        return path.into();
    }
    format!("'{}'", path.replace('\'', "'\\''"))
}

/// Letters, digits and `-`: what an id may have.
pub(super) fn word(text: &str) -> String {
    let letters = text
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' });
    letters.collect()
}

/// The worked solution of the figure's pixel.
fn log(named: &Named, words: &[String]) -> Result<String, String> {
    const OPTIONS: [&str; 3] = ["only=KIND,KIND", "ray=N", "all"];
    let mut options = WorkedOptions::default();
    for word in words {
        match word.split_once('=') {
            Some(("only", kinds)) => options.kinds = only(kinds)?,
            Some(("ray", number)) => options.ray = Some(whole_number("ray", number)?),
            None if word == "all" => options.all = true,
            _ => return Err(unknown_option(word, &OPTIONS)),
        }
    }
    let traced = first(named)?;
    let pixel = named.spec.traced_pixels().first().copied();
    let records = traced.of_pixel(pixel);
    let has = |ray: u32| records.iter().any(|record| record.ray == Some(ray));
    if let Some(ray) = options.ray.filter(|&ray| !has(ray)) {
        let last = records.iter().filter_map(|record| record.ray).max();
        return Err(match last {
            Some(last) => format!("the pixel has no ray {ray}\n  its rays are 0 to {last}"),
            None => "this figure has no pixel with rays\n  name a figure with a \"pixel\"".into(),
        });
    }
    let settings = whole_log(traced);
    let page = worked_solution(&traced.scene, &settings, &records, &options);
    Ok(html(&page, hint))
}

/// The options of the directive that show what a page leaves out.
fn hint(unfold: Unfold) -> String {
    match unfold {
        Unfold::All => "all shows them".into(),
        Unfold::Ray(ray) => format!("ray={ray}"),
    }
}

/// Kinds of event by their names.
fn only(names: &str) -> Result<Kinds, String> {
    let mut kinds = Vec::new();
    for name in names.split(',') {
        let known = Kind::ALL.map(Kind::name);
        let kind =
            Kind::named(name).ok_or_else(|| match nearest_name(name, known.into_iter()) {
                Some(near) => format!("there is no kind {}\n  did you mean {near}?", quoted(name)),
                None => format!(
                    "there is no kind {}\n  the kinds are {}",
                    quoted(name),
                    known.join(", ")
                ),
            })?;
        kinds.push(kind);
    }
    Ok(Kinds::of(&kinds))
}

/// A tree of rays that does not end, as a mistake in a directive.
fn too_many_rays(stopped: Stopped) -> String {
    format!("{stopped}\n  lower the scene's \"max_depth\", or its reflection and transmission")
}

/// What every strategy costs on the figure's pixel, or on its picture; or what each kind of ray tracing costs and
/// brings.
fn table(named: &Named, words: &[String]) -> Result<String, String> {
    let mut pixel = named.spec.traced_pixels().first().copied();
    let mut transports = false;
    for word in words {
        match word.as_str() {
            "picture" => pixel = None,
            "transports" => transports = true,
            _ => return Err(unknown_option(word, &["picture", "transports"])),
        }
    }
    let Traced {
        scene, settings, ..
    } = first(named)?;
    // times would differ from build to build; a table of a book has none
    let no_clock = || Duration::ZERO;
    let (title, rows) = if transports {
        let scene = light_of_lamps(scene.clone());
        let comparison = compare_transports(&scene, settings, MAX_RAYS, no_clock, |_| {});
        let comparison = comparison.map_err(|error| match error {
            NotCompared::Light(fault) => format!("{fault}: {}", fault.fix()),
            NotCompared::Stopped { stopped, .. } => too_many_rays(stopped),
        })?;
        (comparison.title(), comparison.rows())
    } else {
        let comparison =
            compare(scene, settings, pixel, MAX_RAYS, no_clock, |_| {}).map_err(too_many_rays)?;
        (comparison.title(), comparison.rows())
    };
    let row = |cells: &[String], tag: &str| {
        let cells = cells.iter().enumerate().map(|(place, cell)| {
            let align = if place == 0 {
                ""
            } else {
                " style=\"text-align: right\""
            };
            format!("<{tag}{align}>{}</{tag}>", escaped(cell))
        });
        format!("<tr>{}</tr>", cells.collect::<String>())
    };
    let (head, body) = rows
        .split_first()
        .ok_or("there are no strategies to compare")?;
    let body: String = body.iter().map(|cells| row(cells, "td")).collect();
    Ok(format!(
        "<div class=\"table-wrapper\"><table class=\"raystep-compare\"><caption>{}</caption><thead>{}</thead><tbody>{body}</tbody></table></div>",
        escaped(&title),
        row(head, "th")
    ))
}
