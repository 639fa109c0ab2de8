//! `{{#raystep-question LESSON/NAME}}`, `{{#raystep-questions}}` and `{{#raystep-answers}}`: a question of a lesson, answered on
//! the page; all questions; all answers.

use std::collections::HashMap;
use std::fmt::Write;

use crate::book::html::prose;
use crate::book::inline_code::code;
use crate::book::places::{Places, answer_id, figure_id, link, question_id};
use crate::book::run::for_shell;
use crate::book::same_trace::place_of;
use crate::explain::render::escaped;
use crate::lesson::question::{Asked, Form};
use crate::lesson::{Lesson, Library};
use crate::page::{LineFace, Quiz, QuizData, quiz, told};
use crate::scene::{nearest_name, quoted};

/// Asks questions; each is traced once for all that show it.
pub(super) struct Questions<'a> {
    library: &'a Library,
    /// The folder of the lessons as it is written in commands.
    lessons: String,
    asked: HashMap<String, Asked>,
}

impl<'a> Questions<'a> {
    pub(super) fn new(library: &'a Library, lessons: String) -> Self {
        Self {
            library,
            lessons,
            asked: HashMap::new(),
        }
    }

    /// The question of a name such as `04-sphere/roots`.
    fn asked(&mut self, name: &str) -> Result<&Asked, String> {
        if !self.asked.contains_key(name) {
            let (lesson, question) = name.split_once('/').ok_or_else(|| {
                format!(
                    "{} is no question\n  name lesson and question, as in 04-sphere/roots",
                    quoted(name)
                )
            })?;
            let asked = self.library.ask(lesson, question);
            self.asked
                .insert(name.into(), asked.map_err(|error| error.to_string())?);
        }
        self.asked
            .get(name)
            .ok_or_else(|| "the question is lost".into())
    }

    /// A question as a chapter shows it.
    ///
    /// # Errors
    /// There is no such question, or it cannot be asked.
    pub(super) fn question(
        &mut self,
        name: &str,
        id: &str,
        chapter: &str,
        places: &Places,
    ) -> Result<String, String> {
        let mut look = self.look(name)?;
        let asked = self.asked(name)?;
        if let Some(figure) = &asked.figure
            && let Some(shown) = places.of_figure(figure)
        {
            let id = format!("{}_figure", figure_id(shown, figure));
            let to = link(chapter, shown, &id);
            // writing into a String does not fail
            let _ = write!(look, " or <a href=\"{}\">the figure</a>", escaped(&to));
        }
        look.push('.');
        if let Some(answers) = places.answers() {
            let to = link(chapter, answers, &answer_id(name));
            let _ = write!(look, " <a href=\"{}\">All answers</a>", escaped(&to));
        }
        Ok(shown(asked, name, id, &look, quiz))
    }

    /// An answer in the appendix, with a link to its question.
    fn answer(&mut self, name: &str, chapter: &str, places: &Places) -> Result<String, String> {
        let look = format!("{}.", self.look(name)?);
        let asked = self.asked(name)?;
        let title = match places.of_question(name) {
            Some(place) => {
                let to = link(chapter, place, &question_id(name));
                format!("<a href=\"{}\">{}</a>", escaped(&to), escaped(name))
            }
            None => escaped(name),
        };
        Ok(format!(
            "<dt id=\"{}\">{title}: {}</dt><dd>{}</dd>",
            answer_id(name),
            escaped(&asked.text),
            shown(asked, name, "", &look, told)
        ))
    }

    /// The command that leads to the step of a question.
    fn look(&mut self, name: &str) -> Result<String, String> {
        let lessons = self.lessons.clone();
        let place = &self.asked(name)?.place;
        let [x, y] = place.pixel;
        let scene = for_shell(&format!("{lessons}/{}/{}", place.lesson, place.scene));
        let command = format!("raystep step {scene} {x},{y} --at {}", place.step);
        Ok(format!(
            "Look at <span class=\"raystep-look\">the step</span>: {}",
            code(&command)
        ))
    }

    /// The answers of all questions that a book has, by lesson; each piece is a block on one line, or a heading.
    ///
    /// # Errors
    /// A question that cannot be asked.
    pub(super) fn answers(
        &mut self,
        chapter: &str,
        places: &Places,
    ) -> Result<Vec<String>, String> {
        let mut blocks = Vec::new();
        let library = self.library;
        for lesson in &library.lessons {
            let names = names(lesson);
            let names: Vec<String> = names
                .into_iter()
                .filter(|name| places.of_question(name).is_some())
                .collect();
            if names.is_empty() {
                continue;
            }
            let answers: Result<String, String> = names
                .iter()
                .map(|name| self.answer(name, chapter, places))
                .collect();
            blocks.push(heading(lesson));
            blocks.push(format!("<dl class=\"raystep-answers\">{}</dl>", answers?));
        }
        if blocks.is_empty() {
            return Err(
                "the book has no questions\n  ask one with {{#raystep-question LESSON/NAME}}"
                    .into(),
            );
        }
        Ok(blocks)
    }

    /// All questions by lesson, or those of one: headings, and names of questions.
    ///
    /// # Errors
    /// There is no such lesson, or no question.
    pub(super) fn listed(&self, words: &[String]) -> Result<Vec<Listed>, String> {
        let names_of = || self.library.lessons.iter().map(|of| of.name.as_str());
        let wanted = match words {
            [] => None,
            [lesson] if names_of().any(|name| name == lesson) => Some(lesson),
            [lesson] => {
                return Err(match nearest_name(lesson, names_of()) {
                    Some(near) => format!(
                        "there is no lesson {}\n  did you mean {near}?",
                        quoted(lesson)
                    ),
                    None => format!("there is no lesson {}", quoted(lesson)),
                });
            }
            _ => {
                return Err(
                    "one lesson may be named\n  as in {{#raystep-questions 04-sphere}}".into(),
                );
            }
        };
        let mut listed = Vec::new();
        for lesson in &self.library.lessons {
            if wanted.is_some_and(|wanted| *wanted != lesson.name) {
                continue;
            }
            let names = names(lesson);
            if wanted.is_none() && !names.is_empty() {
                listed.push(Listed::Heading(heading(lesson)));
            }
            listed.extend(names.into_iter().map(Listed::Question));
        }
        if listed.is_empty() {
            return Err("there are no questions\n  write \"questions\" in a lesson.json".into());
        }
        Ok(listed)
    }
}

/// A piece of a list of questions.
pub(super) enum Listed {
    /// The title of a lesson, in Markdown.
    Heading(String),
    /// A question by its name.
    Question(String),
}

/// The names of a lesson's questions, in their order.
pub(super) fn names(lesson: &Lesson) -> Vec<String> {
    let questions = lesson.content.questions.iter();
    questions
        .map(|of| format!("{}/{}", lesson.name, of.name))
        .collect()
}

/// The title of a lesson as a heading; what could be a mark in it stays text.
fn heading(lesson: &Lesson) -> String {
    format!("## {}", prose(&lesson.content.title))
}

/// A question in the shape of a page.
fn shown(asked: &Asked, name: &str, id: &str, look: &str, face: fn(&Quiz) -> String) -> String {
    let reasons = asked.reasons();
    let lines = match &asked.form {
        Form::Blank(blank) => &blank.lines[..],
        _ => &[],
    };
    face(&Quiz {
        id,
        text: &asked.text,
        lines,
        choices: asked
            .form
            .choices()
            .iter()
            .map(|of| of.text.as_str())
            .collect(),
        reasons: &reasons,
        working: asked.working.iter().cloned().map(LineFace::from).collect(),
        look,
        data: data(asked, name),
    })
}

fn data(asked: &Asked, name: &str) -> QuizData {
    let right = || {
        let choices = asked.form.choices().iter().enumerate();
        choices
            .filter(|(_, of)| of.right)
            .map(|(place, _)| place)
            .collect()
    };
    let data = QuizData {
        name: name.into(),
        answer: asked.answer_text(),
        place: place_of(
            &asked.traced.scene,
            &asked.traced.records,
            asked.place.event,
        ),
        ..QuizData::default()
    };
    match &asked.form {
        Form::Choice(_) | Form::Place(_) => QuizData {
            form: "one",
            right: right(),
            ..data
        },
        Form::Several(_) => QuizData {
            form: "several",
            right: right(),
            ..data
        },
        Form::Order(order) => QuizData {
            form: "order",
            right: right(),
            before: order.before.clone(),
            ..data
        },
        Form::Number(number) => QuizData {
            form: "number",
            answers: vec![(number.answer, number.tolerance)],
            unit: (!number.unit.is_empty()).then(|| number.unit.clone()),
            ..data
        },
        Form::Blank(blank) => QuizData {
            form: "blanks",
            answers: blank.answers.clone(),
            ..data
        },
    }
}
