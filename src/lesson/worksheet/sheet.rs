//! Which questions a sheet has, each with numbers of its own and traced anew.

use std::collections::BTreeMap;

use crate::figure::{FigureKind, Rendition, UpTo, Width};
use crate::lesson::exercise::Seeded;
use crate::lesson::library::{FigureName, Library};
use crate::lesson::question::{Asked, Form, QuestionSpec, edited};
use crate::lesson::worksheet::skeleton::skeleton;
use crate::lesson::worksheet::vary::{Varied, can_vary, draw, moved};
use crate::lesson::{Lesson, LessonError};

/// A sheet of questions.
#[derive(Clone, Debug)]
pub struct Worksheet {
    /// The folder of the lesson.
    pub lesson: String,
    /// Its title.
    pub title: String,
    /// What the numbers were drawn with.
    pub seed: u64,
    /// The questions.
    pub items: Vec<Item>,
}

/// A question of a sheet.
#[derive(Clone, Debug)]
pub struct Item {
    /// The question with its answer.
    pub asked: Asked,
    /// Has it other numbers than the lesson's?
    pub is_varied: bool,
    /// Its figure, once it is drawn: what is given, and with what follows from it.
    pub figure: Option<[Figure; 2]>,
    /// Where it comes from.
    spec: QuestionSpec,
    varied: Varied,
}

/// A figure of a sheet.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The drawing.
    pub svg: String,
    /// What is seen, in words.
    pub description: String,
}

/// How many questions a sheet has at most: two pages.
const QUESTIONS: usize = 8;

/// How often numbers are drawn for a question before it keeps its own.
const TRIES: usize = 16;

/// A sheet of a lesson: the same seed gives the same sheet.
///
/// # Errors
/// A question that cannot be asked as the lesson says, or a lesson without questions that can.
pub fn worksheet(library: &Library, lesson: &Lesson, seed: u64) -> Result<Worksheet, LessonError> {
    let mut random = Seeded::of(&lesson.name, seed);
    let questions = &lesson.content.questions;
    let mut order: Vec<usize> = (0..questions.len()).collect();
    for place in (1..order.len()).rev() {
        order.swap(place, random.below(place as u32 + 1) as usize);
    }
    let mut items: Vec<(usize, Item)> = Vec::new();
    let mut others = Vec::new();
    for place in order {
        if items.len() == QUESTIONS {
            break;
        }
        let spec = &questions[place];
        match varied(library, lesson, spec, &mut random)? {
            Some(item) => items.push((place, item)),
            None => others.push(place),
        }
    }
    for place in others.into_iter().take(QUESTIONS - items.len()) {
        items.push((place, own(library, lesson, &questions[place])?));
    }
    // in the order of the lesson, which goes from the simple to the rest
    items.sort_by_key(|(place, _)| *place);
    // a neighbour's letters say nothing, also where a question has few other numbers
    for (_, item) in &mut items {
        shuffle(&mut item.asked.form, &mut random);
    }
    Ok(Worksheet {
        lesson: lesson.name.clone(),
        title: lesson.content.title.clone(),
        seed,
        items: items.into_iter().map(|(_, item)| item).collect(),
    })
}

/// Other letters for the choices. Of an order the letters are named by their places, so it stays as it is.
fn shuffle(form: &mut Form, random: &mut Seeded) {
    if let Form::Choice(choices) | Form::Several(choices) | Form::Place(choices) = form {
        for place in (1..choices.len()).rev() {
            choices.swap(place, random.below(place as u32 + 1) as usize);
        }
    }
}

impl Worksheet {
    /// Draws the figures of the questions, each with its own numbers.
    ///
    /// # Errors
    /// A figure that the lesson does not have.
    pub fn draw(&mut self, library: &Library) -> Result<(), LessonError> {
        for item in &mut self.items {
            item.figure = figure(library, &item.spec, &item.varied, &item.asked)?;
        }
        Ok(())
    }
}

/// The question with the lesson's own numbers.
fn own(library: &Library, lesson: &Lesson, spec: &QuestionSpec) -> Result<Item, LessonError> {
    let values = BTreeMap::new();
    let asked = library.ask_varied(lesson, spec, &values)?;
    Ok(Item {
        asked,
        is_varied: false,
        figure: None,
        spec: spec.clone(),
        varied: Varied {
            spec: spec.clone(),
            values,
        },
    })
}

/// The question with other numbers; `None` if no draw makes a question that makes sense.
fn varied(
    library: &Library,
    lesson: &Lesson,
    spec: &QuestionSpec,
    random: &mut Seeded,
) -> Result<Option<Item>, LessonError> {
    if !can_vary(spec) {
        return Ok(None);
    }
    let own = library.ask_varied(lesson, spec, &BTreeMap::new())?;
    let skeleton_of_own = skeleton(&own.traced);
    for _ in 0..TRIES {
        let varied = draw(spec, own.traced.file(), random);
        // the engine refuses a step that is not there, an answer beside a tolerance, choices that are equal
        let Ok(asked) = library.ask_varied(lesson, &varied.spec, &varied.values) else {
            continue;
        };
        // where the lesson does not say what may vary, nothing but numbers may
        let is_sound = spec.vary.is_some()
            || (has_same_right(&asked, &own) && skeleton(&asked.traced) == skeleton_of_own);
        if is_sound
            && shows_other_numbers(&asked, &own)
            && is_no_shorter(&asked, &own)
            && is_clear(&asked)
        {
            let (varied, asked) = match spec.vary {
                Some(_) => moved_too(library, lesson, (varied, asked), random),
                None => (varied, asked),
            };
            return Ok(Some(Item {
                asked,
                is_varied: true,
                figure: None,
                spec: spec.clone(),
                varied,
            }));
        }
    }
    Ok(None)
}

/// Is there as much to put in order as in the lesson, or at least three things?
fn is_no_shorter(asked: &Asked, own: &Asked) -> bool {
    match (&asked.form, &own.form) {
        (Form::Order(asked), Form::Order(own)) => own.order.len().min(3) <= asked.order.len(),
        _ => true,
    }
}

/// A question whose pixel varies has few others: its scene moves a little too, if its trace keeps its skeleton.
fn moved_too(
    library: &Library,
    lesson: &Lesson,
    (varied, asked): (Varied, Asked),
    random: &mut Seeded,
) -> (Varied, Asked) {
    let before = skeleton(&asked.traced);
    for _ in 0..TRIES {
        let mut more = varied.clone();
        for (pointer, value) in moved(asked.traced.file(), random) {
            more.values.entry(pointer).or_insert(value);
        }
        if let Ok(other) = library.ask_varied(lesson, &more.spec, &more.values)
            && has_same_right(&other, &asked)
            && is_clear(&other)
            && skeleton(&other.traced) == before
        {
            return (more, other);
        }
    }
    (varied, asked)
}

/// Is no wrong number so near to the right one that an answer may be taken for both?
fn is_clear(asked: &Asked) -> bool {
    let Form::Number(of) = &asked.form else {
        return true;
    };
    let apart = |(value, _): &(f64, _)| 2.0 * of.tolerance < (value - of.answer).abs();
    of.wrong.iter().all(apart)
}

/// Are the same choices right? Their reasons are then the ones that the lesson's author has written for it.
fn has_same_right(asked: &Asked, own: &Asked) -> bool {
    let right = |of: &Asked| -> Vec<bool> {
        let choices = of.form.choices().iter();
        choices.map(|choice| choice.right).collect()
    };
    right(asked) == right(own)
}

/// Does who looks at the question see other numbers than in the lesson?
fn shows_other_numbers(asked: &Asked, own: &Asked) -> bool {
    let texts = |of: &Asked| -> Vec<String> {
        let choices = of.form.choices().iter().map(|choice| choice.text.clone());
        choices.chain([of.text.clone()]).collect()
    };
    asked.place.pixel != own.place.pixel || texts(asked) != texts(own)
}

/// The figure of a question, drawn of its own numbers; `None` if it has none, or one of something else.
fn figure(
    library: &Library,
    spec: &QuestionSpec,
    varied: &Varied,
    asked: &Asked,
) -> Result<Option<[Figure; 2]>, LessonError> {
    let Some(name) = &spec.figure else {
        return Ok(None);
    };
    let Ok(name) = name.parse::<FigureName>() else {
        return Ok(None);
    };
    let (lesson, figure) = library.find(&name)?;
    let is_changed = varied.spec.pixel != spec.pixel || !varied.values.is_empty();
    let is_of_question = figure.scene == spec.scene
        && lesson.name == asked.place.lesson
        && figure.pixel == Some(spec.pixel)
        && figure.strategy == spec.strategy;
    // a heap is a table: of what is given it has the heading alone
    if (is_changed && !is_of_question) || figure.kind == FigureKind::Heap {
        return Ok(None);
    }
    let mut figure = figure.clone();
    if is_changed {
        figure.pixel = Some(varied.spec.pixel);
        figure.frame = None;
    }
    let loaded = lesson.load(&name.figure, &figure)?;
    let Ok(loaded) = edited(&loaded, &varied.values) else {
        return Ok(None);
    };
    let Ok(traced) = lesson.trace_loaded(&name.figure, &figure, loaded) else {
        return Ok(None);
    };
    let id = format!("sheet-{}", asked.name);
    let drawn = |up_to: Option<UpTo>| {
        let rendition = Rendition {
            grayscale: false,
            standalone: true,
            titled: false,
            up_to,
        };
        lesson.draw(
            &name.figure,
            &figure,
            &traced,
            &id,
            (Width::Book, rendition),
        )
    };
    // what a figure of the lesson cannot draw of other numbers is left out
    let Ok(whole) = drawn(None) else {
        return Ok(None);
    };
    let given = if whole.stages.is_empty() {
        return Ok(None);
    } else {
        drawn(Some(UpTo::Stage(1)))?
    };
    Ok(Some([given, whole].map(|drawn| Figure {
        svg: drawn.svg,
        description: drawn.description,
    })))
}
