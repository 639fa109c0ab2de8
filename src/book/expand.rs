//! What comes into a chapter in the place of a directive.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::book::Project;
use crate::book::asks::Asks;
use crate::book::code::code;
use crate::book::costs::table;
use crate::book::directive::Directive;
use crate::book::formula::in_latex;
use crate::book::html::{one_line, prose, with_indices};
use crate::book::inline_code::code as code_of;
use crate::book::map::map;
use crate::book::mistakes;
use crate::book::places::{Places, figure_id, question_id};
use crate::book::question::{Listed, Questions};
use crate::book::run::{Commands, for_shell, run};
use crate::book::stepper::Asked;
use crate::book::value::value;
use crate::book::words::{unknown_option, whole_number};
use crate::book::worked::{log, with_blanks};
use crate::explain::render::escaped;
use crate::figure::FigureSpec;
use crate::figure::{Rendition, Traced, UpTo, Width};
use crate::lesson::{FigureName, Lesson, LessonError, Library};
use crate::page::{Stepper, shared, stepper};
use crate::scene::{LoadError, nearest_name, quoted};

/// Where lessons are looked for if nothing is said, here and on the command line.
pub(super) const LESSONS: &str = "lessons";

/// Follows directives; what a figure is drawn from is traced once for all that name it.
pub(super) struct Expander<'a> {
    library: &'a Library,
    project: &'a Project,
    commands: &'a dyn Commands,
    places: Places,
    questions: Questions<'a>,
    /// The folder of the lessons as it is written in commands.
    lessons: Option<String>,
    traced: HashMap<FigureName, Arc<Vec<Traced>>>,
    /// The ids that were given, in all chapters: a book may have them all on one page.
    ids: HashSet<String>,
    /// The chapter's file.
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
    pub(super) fn new(
        library: &'a Library,
        project: &'a Project,
        commands: &'a dyn Commands,
        places: Places,
    ) -> Self {
        let lessons = project.lessons_word(LESSONS);
        let folder = lessons.clone().unwrap_or_else(|| LESSONS.into());
        Self {
            questions: Questions::new(library, folder),
            library,
            project,
            commands,
            places,
            lessons,
            traced: HashMap::new(),
            ids: HashSet::new(),
            chapter: String::new(),
            has_script: false,
        }
    }

    /// The directives that follow are those of another chapter.
    pub(super) fn begin_chapter(&mut self, chapter: String) {
        self.chapter = chapter;
        self.has_script = false;
    }

    /// What stands in the place of the directive.
    ///
    /// # Errors
    /// What is wrong, and what to do about it.
    pub(super) fn expand(&mut self, directive: &Directive) -> Result<String, String> {
        let asks = of(directive)?;
        if asks == Asks::Value {
            return Ok(prose(&self.value(directive)?));
        }
        let alone = directive
            .alone
            .as_ref()
            .ok_or("this directive expands to a block\n  put it on a line of its own")?;
        let html = match asks {
            Asks::Figure | Asks::Log | Asks::Blanks | Asks::Compare | Asks::Value => {
                let (named, words) = self.figure_of(directive)?;
                let pixel = named.spec.traced_pixels().first().copied();
                match asks {
                    Asks::Log => log(first(&named)?, pixel, words)?,
                    Asks::Blanks => with_blanks(first(&named)?, pixel, words)?,
                    Asks::Compare => table(first(&named)?, pixel, words)?,
                    _ => match words.split_first() {
                        Some((first, words)) if first == "stepper" => {
                            self.stepper(&named, words, &alone.begins)?
                        }
                        _ => self.figure(&named, words)?,
                    },
                }
            }
            Asks::Code => code(&directive.rest, self.project)?,
            Asks::Run => run(&directive.rest, self.commands, self.project)?,
            Asks::Map => map(
                &directive.words,
                &self.chapter,
                self.project,
                self.library,
                &self.places,
            )?,
            Asks::Question => {
                let [name] = &directive.words[..] else {
                    return Err(
                        "one question is named\n  as in {{#raystep-question 04-sphere/roots}}"
                            .into(),
                    );
                };
                let question = self.question(name)?;
                self.with_script(question, &alone.begins)
            }
            Asks::Questions => {
                let mut blocks = Vec::new();
                for of in self.questions.listed(&directive.words)? {
                    blocks.push(match of {
                        Listed::Heading(heading) => heading,
                        Listed::Question(name) => self.question(&name)?,
                    });
                }
                self.blocks(blocks, &alone.begins)
            }
            Asks::Answers => {
                let blocks = self.questions.answers(&self.chapter, &self.places)?;
                self.blocks(blocks, &alone.begins)
            }
            Asks::Mistakes => mistakes::table(&directive.words, self.library)?,
        };
        Ok(format!("{html}{}", alone.ends))
    }

    /// What stands in the place of a directive inside of a formula.
    ///
    /// # Errors
    /// What is wrong, and what to do about it.
    pub(super) fn expand_in_formula(&mut self, directive: &Directive) -> Result<String, String> {
        if of(directive)? != Asks::Value {
            return Err("a formula holds no block\n  only raystep-value may stand in it".into());
        }
        in_latex(&self.value(directive)?)
    }

    /// A value of a figure's trace.
    fn value(&mut self, directive: &Directive) -> Result<String, String> {
        let (named, words) = self.figure_of(directive)?;
        let [path] = words else {
            return Err(
                "exactly one path names a value\n  as in {{#raystep-value 12-grid/walk cell.count}}"
                    .into(),
            );
        };
        let pixel = named.spec.traced_pixels().first().copied();
        value(first(&named)?, pixel, path)
    }

    /// The figure that a directive names, and the words behind its name.
    fn figure_of<'d>(
        &mut self,
        directive: &'d Directive,
    ) -> Result<(Named<'a>, &'d [String]), String> {
        let (name, words) = directive
            .words
            .split_first()
            .ok_or("no figure is named\n  as in {{#raystep 12-grid/walk}}")?;
        Ok((self.named(name)?, words))
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
        let mut is_puzzle = false;
        for word in words {
            match word.split_once('=') {
                None if word == "puzzle" => is_puzzle = true,
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
                _ => {
                    let known = ["step=N", "stage=N", "puzzle", "stepper"];
                    return Err(unknown_option(word, &known));
                }
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
        // title and caption would tell the answer, and so would what a whole drawing is said to show
        let (svg, words) = if is_puzzle {
            (untold(&svg, up_to.is_none()), "")
        } else {
            (svg, named.spec.caption.as_str())
        };
        let mut caption = self.caption(words, &command);
        let traced = named.traced.first();
        if let Some(mistake) = traced.and_then(|of| of.of_pixels.mistake.as_ref())
            && !is_puzzle
        {
            let lessons = self.lessons.as_deref().unwrap_or(LESSONS);
            let scene = format!("{lessons}/{}/{}", named.lesson.name, named.spec.scene);
            let leads = mistakes::leads(mistake, &scene, self.library, &self.places, &self.chapter);
            caption = format!("{caption}<br>{leads}");
        }
        Ok(format!(
            "<figure class=\"raystep\" id=\"{id}_figure\">{svg}<figcaption>{caption}</figcaption></figure>"
        ))
    }

    /// The figure with its steps. In the first stepper of a chapter its lines begin with the script of all.
    fn stepper(&mut self, named: &Named, words: &[String], begins: &str) -> Result<String, String> {
        let asked = Asked::new(words)?;
        let (steps, until) = asked.steps(named.spec, first(named)?)?;
        let id = self.id(&named.name);
        let command = format!("raystep figure {}", named.name);
        let figure = stepper(&Stepper {
            svg: &drawing(named, &id, None)?,
            id: &format!("{id}_figure"),
            caption: &self.caption(&named.spec.caption, &command),
            steps: &steps,
            until: until.as_ref(),
            predicts: asked.predicts,
        });
        Ok(self.with_script(figure, begins))
    }

    /// A question.
    fn question(&mut self, name: &str) -> Result<String, String> {
        let id = self.free(question_id(name));
        self.questions
            .question(name, &id, &self.chapter, &self.places)
    }

    /// Blocks and headings, with empty lines between them.
    fn blocks(&mut self, blocks: Vec<String>, begins: &str) -> String {
        let gap = format!("\n{}\n{begins}", begins.trim_end());
        let all: Vec<String> = self.script(begins).into_iter().chain(blocks).collect();
        all.join(&gap)
    }

    /// HTML, with the script and the style of the chapter before it if they do not stand there yet.
    fn with_script(&mut self, html: String, begins: &str) -> String {
        match self.script(begins) {
            Some(script) => format!("{script}\n{begins}{html}"),
            None => html,
        }
    }

    /// The script and the style of the chapter, once.
    fn script(&mut self, begins: &str) -> Option<String> {
        let has_script = std::mem::replace(&mut self.has_script, true);
        (!has_script).then(|| shared().replace('\n', &format!("\n{begins}")))
    }

    /// What stands below a figure: its caption, and the command that draws it.
    fn caption(&self, words: &str, command: &str) -> String {
        let lessons = self.lessons.as_ref();
        let lessons = lessons.map_or(String::new(), |lessons| {
            format!(" --lessons {}", for_shell(lessons))
        });
        let command = code_of(&format!("{command}{lessons}"));
        match words {
            "" => command,
            _ => format!("{} {command}", with_indices(&escaped(words))),
        }
    }

    /// The chapter and the figure, and a number if that was given before.
    fn id(&mut self, name: &FigureName) -> String {
        self.free(figure_id(&self.chapter, &name.to_string()))
    }

    /// An id that no place of the book has yet.
    fn free(&mut self, id: String) -> String {
        // no word has a _, so that no number and no part of a drawing makes the id of another figure
        let numbered = (2..).map(|number| format!("{id}_{number}"));
        let mut all = std::iter::once(id.clone()).chain(numbered);
        let free = all.find(|id| !self.ids.contains(id)).unwrap_or(id);
        self.ids.insert(free.clone());
        free
    }
}

/// A drawing without its title and, if it is whole, without its description.
fn untold(svg: &str, is_whole: bool) -> String {
    let mut told = vec![("title", "A puzzle")];
    if is_whole {
        told.push((
            "desc",
            "The answer of the puzzle says what this figure shows.",
        ));
    }
    told.into_iter().fold(svg.to_owned(), |svg, (tag, words)| {
        let inner = svg.find(&format!("<{tag} ")).and_then(|at| {
            let start = at + svg[at..].find('>')? + 1;
            let end = start + svg[start..].find(&format!("</{tag}>"))?;
            Some(start..end)
        });
        match inner {
            Some(inner) => format!("{}{words}{}", &svg[..inner.start], &svg[inner.end..]),
            None => svg,
        }
    })
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

/// What a directive asks for, if it is whole.
fn of(directive: &Directive) -> Result<Asks, String> {
    if !directive.ends {
        return Err("it has no end\n  close it with }} on the same line".into());
    }
    Asks::named(&directive.word)
}
