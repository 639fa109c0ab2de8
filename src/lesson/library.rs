//! The lessons of a folder, and their figures and questions by name: `12-grid/walk`.

use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

use crate::figure::{Drawn, FigureError, FigureSpec, Rendition, Traced, Width, draw};
use crate::lesson::question::{Asked, Fault, QuestionSpec, ask};
use crate::lesson::{LessonError, LessonFile, trace_figure};
use crate::scene::{
    Files, LoadError, Loaded, Place, SchemaOf, line_of, load_bytes, nearest_name, parse_json,
    text_of,
};

/// A figure's name: its lesson and its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FigureName {
    /// The folder of the lesson.
    pub lesson: String,
    /// The name of the figure in its lesson.
    pub figure: String,
}

impl FromStr for FigureName {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('/') {
            Some((lesson, figure)) if !lesson.is_empty() && is_word(figure) => Ok(Self {
                lesson: lesson.into(),
                figure: figure.into(),
            }),
            _ => Err("give a lesson and one of its figures, as in 12-grid/walk".into()),
        }
    }
}

impl fmt::Display for FigureName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.lesson, self.figure)
    }
}

/// Can it be part of a file's name and of an id?
fn is_word(name: &str) -> bool {
    let known = |c: char| c.is_ascii_alphanumeric() || c == '-';
    !name.is_empty() && name.chars().all(known)
}

/// A lesson that was read.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// The name of its folder.
    pub name: String,
    path: PathBuf,
    folder: Arc<dyn Files>,
    /// Its file as it was given, and the text, to find the line of a mistake.
    file: String,
    text: String,
    /// What the file says.
    pub content: LessonFile,
}

/// The lessons of a folder.
#[derive(Clone, Debug)]
pub struct Library {
    /// In the order of their names.
    pub lessons: Vec<Lesson>,
}

impl Library {
    /// Reads every lesson of a folder: the folders in it that have a `lesson.json`. The scenes of a lesson lie in its
    /// own folder.
    ///
    /// # Errors
    /// A folder that cannot be read or has no lesson, or a lesson with a mistake.
    pub fn open(folder: &dyn Files) -> Result<Self, LessonError> {
        let failed = |source| LessonError::Folder {
            folder: folder.name(),
            source,
        };
        let mut names = folder.folders().map_err(|source| failed(Some(source)))?;
        names.sort();
        let mut lessons = Vec::new();
        for name in names {
            lessons.extend(Lesson::read(folder, name)?);
        }
        if lessons.is_empty() {
            return Err(failed(None));
        }
        Ok(Self { lessons })
    }

    /// The names of all figures, lesson after lesson.
    pub fn figures(&self) -> Vec<FigureName> {
        let of_lesson = |lesson: &Lesson| {
            let lesson_name = lesson.name.clone();
            let names = lesson.content.figures.keys().cloned();
            let named = names.map(move |figure| FigureName {
                lesson: lesson_name.clone(),
                figure,
            });
            named.collect::<Vec<_>>()
        };
        self.lessons.iter().flat_map(of_lesson).collect()
    }

    /// A figure by its name.
    ///
    /// # Errors
    /// There is none of this name; one that is like it is named.
    pub fn find(&self, name: &FigureName) -> Result<(&Lesson, &FigureSpec), LessonError> {
        let lesson = self.lessons.iter().find(|of| of.name == name.lesson);
        let found = lesson.and_then(|of| Some((of, of.content.figures.get(&name.figure)?)));
        if let Some(found) = found {
            return Ok(found);
        }
        // within a lesson that is there the figure's own name is compared, or else all of both would look alike
        let mut known = self.figures();
        let near = match lesson {
            Some(_) => {
                known.retain(|of| of.lesson == name.lesson);
                let names = known.iter().map(|of| of.figure.as_str());
                let near = nearest_name(&name.figure, names);
                near.map(|figure| format!("{}/{figure}", name.lesson))
            }
            None => {
                let names: Vec<String> = known.iter().map(ToString::to_string).collect();
                nearest_name(&name.to_string(), names.iter().map(String::as_str))
            }
        };
        Err(LessonError::Unknown {
            near,
            name: name.to_string(),
            what: "figure",
            known: known.iter().map(ToString::to_string).collect(),
        })
    }

    /// A question by the folder of its lesson and its name.
    ///
    /// # Errors
    /// There is none of this name; one that is like it is named.
    pub fn question(
        &self,
        lesson: &str,
        name: &str,
    ) -> Result<(&Lesson, &QuestionSpec), LessonError> {
        let of = self.lessons.iter().find(|of| of.name == lesson);
        let questions = of.map_or(&[][..], |of| &of.content.questions);
        if let Some((of, question)) = of.zip(questions.iter().find(|of| of.name == name)) {
            return Ok((of, question));
        }
        let names = |of: &Lesson| {
            let questions = of.content.questions.iter();
            questions
                .map(|question| format!("{}/{}", of.name, question.name))
                .collect::<Vec<_>>()
        };
        let known: Vec<String> = match of {
            Some(of) => names(of),
            None => self.lessons.iter().flat_map(names).collect(),
        };
        let whole = format!("{lesson}/{name}");
        Err(LessonError::Unknown {
            near: nearest_name(&whole, known.iter().map(String::as_str)),
            name: whole,
            what: "question",
            known,
        })
    }

    /// Asks a question: traces what it is about, and computes its answer and its choices.
    ///
    /// # Errors
    /// There is none of this name, or it cannot be asked as the lesson says: where and why.
    pub fn ask(&self, lesson: &str, name: &str) -> Result<Asked, LessonError> {
        let (of, spec) = self.question(lesson, name)?;
        self.ask_varied(of, spec, &BTreeMap::new())
    }

    /// Asks a question of a lesson that may have been varied: with another pixel, and with other values in its scene, by
    /// their JSON pointers.
    ///
    /// # Errors
    /// It cannot be asked so: where and why.
    pub fn ask_varied(
        &self,
        lesson: &Lesson,
        spec: &QuestionSpec,
        values: &BTreeMap<String, serde_json::Value>,
    ) -> Result<Asked, LessonError> {
        let wrong = |fault: Fault| lesson.wrong_question(&spec.name, fault);
        let folder = match &spec.lesson {
            None => lesson,
            Some(name) => self
                .lessons
                .iter()
                .find(|of| of.name == *name)
                .ok_or_else(|| {
                    let what = format!("there is no lesson {name:?}");
                    wrong(Fault::new("lesson", what, "name the folder of a lesson"))
                })?,
        };
        if let Some(figure) = &spec.figure {
            let found = figure.parse().map_err(|what| LessonError::Question {
                place: Box::new(lesson.place(lesson.path_of_question(&spec.name, "figure"))),
                what: format!("{figure:?} is no figure"),
                fix: what,
            });
            self.find(&found?).map_err(|error| {
                let what = error.to_string();
                let (what, fix) = what.split_once("\n  ").unwrap_or((&what, "omit it"));
                wrong(Fault::new("figure", what, fix))
            })?;
        }
        let place = lesson.place(lesson.path_of_question(&spec.name, "scene"));
        let loaded = folder.load_scene(&spec.scene, place)?;
        ask(loaded, spec, values, &lesson.name).map_err(wrong)
    }
}

impl Lesson {
    /// The lesson of a folder among these; `None` if the folder has no `lesson.json`.
    fn read(lessons: &dyn Files, name: String) -> Result<Option<Self>, LessonError> {
        let inside = format!("{name}/lesson.json");
        let Ok(path) = lessons.path_of(&inside) else {
            return Ok(None);
        };
        let file = path.display().to_string();
        let bytes = match lessons.read(&path) {
            Err(LoadError::Read { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                return Ok(None);
            }
            read => read?,
        };
        let text = text_of(&file, &bytes, "a lesson is written in JSON")?.to_owned();
        let content: LessonFile = parse_json(&file, &text, SchemaOf::Lesson)?;
        let lesson = Self {
            name,
            folder: lessons.around(&path),
            path,
            file,
            text,
            content,
        };
        lesson.check_names()?;
        if let Some(wrong) = lesson.content.figures.keys().find(|name| !is_word(name)) {
            let what = format!("{wrong:?} is not a name for a figure");
            let error = FigureError::new("", what, "use letters a-z, digits and -");
            return Err(lesson.wrong(wrong, error));
        }
        Ok(Some(lesson))
    }

    /// The lesson's file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads the scene of a figure of this lesson.
    ///
    /// # Errors
    /// A scene that cannot be read, or lies outside of the lesson's folder, which is not allowed.
    pub fn load(&self, name: &str, spec: &FigureSpec) -> Result<Loaded, LessonError> {
        self.load_scene(&spec.scene, self.place(format!("figures.{name}.scene")))
    }

    /// Reads a scene of this lesson. `place` says where it is named.
    fn load_scene(&self, scene: &str, place: Place) -> Result<Loaded, LessonError> {
        let path = self.folder.path_of(scene);
        let path = path.map_err(|_| LoadError::Outside {
            place,
            name: scene.into(),
        })?;
        let bytes = self.folder.read(&path)?;
        let folder = self.folder.around(&path);
        let mut loaded = load_bytes(&path.display().to_string(), &bytes, &*folder)?;
        loaded.files.push(path);
        Ok(loaded)
    }

    /// Traces what a figure of this lesson is drawn from.
    ///
    /// # Errors
    /// A scene that cannot be read, or a specification that does not fit it.
    pub fn trace(&self, name: &str, spec: &FigureSpec) -> Result<Vec<Traced>, LessonError> {
        self.trace_loaded(name, spec, self.load(name, spec)?)
    }

    /// The same from the figure's scene.
    ///
    /// # Errors
    /// A scene that makes no sense, or a specification that does not fit it.
    pub fn trace_loaded(
        &self,
        name: &str,
        spec: &FigureSpec,
        scene: Loaded,
    ) -> Result<Vec<Traced>, LessonError> {
        let whole_name = self.whole_name(name);
        trace_figure(scene, &whole_name, spec, |error| self.wrong(name, error))
    }

    /// Draws a figure of this lesson.
    ///
    /// # Errors
    /// A specification that asks for what the trace does not have.
    pub fn draw(
        &self,
        name: &str,
        spec: &FigureSpec,
        traced: &[Traced],
        id: &str,
        (width, rendition): (Width, Rendition),
    ) -> Result<Drawn, LessonError> {
        let whole_name = self.whole_name(name);
        let mut of_others = traced.iter().filter_map(|of| of.settings.figure.as_ref());
        if let Some(other) = of_others.find(|other| **other != whole_name) {
            let error = FigureError::of_log(format!("the log is that of the figure {other}"));
            return Err(self.wrong(name, error));
        }
        draw(spec, traced, id, width, rendition).map_err(|error| self.wrong(name, error))
    }

    fn whole_name(&self, figure: &str) -> String {
        format!("{}/{figure}", self.name)
    }

    /// A mistake in the specification of a figure, with its place in the file.
    fn wrong(&self, figure: &str, error: FigureError) -> LessonError {
        let path = match error.key {
            "" => format!("figures.{figure}"),
            key => format!("figures.{figure}.{key}"),
        };
        let place = Box::new(self.place(path));
        LessonError::Figure { place, error }
    }

    /// The questions must have names, each its own.
    fn check_names(&self) -> Result<(), LessonError> {
        let names = self.content.questions.iter().map(|of| of.name.as_str());
        let mut known: Vec<&str> = Vec::new();
        for (place, name) in names.enumerate() {
            let what = if !is_word(name) {
                format!("{name:?} is not a name for a question")
            } else if known.contains(&name) {
                format!("the name {name:?} is there twice")
            } else {
                known.push(name);
                continue;
            };
            return Err(LessonError::Question {
                place: Box::new(self.place(format!("questions[{place}].name"))),
                what,
                fix: "use letters a-z, digits and -, each name once".into(),
            });
        }
        Ok(())
    }

    /// The path of a key of a question in the file.
    fn path_of_question(&self, name: &str, key: &str) -> String {
        let mut questions = self.content.questions.iter();
        let place = questions.position(|of| of.name == name).unwrap_or_default();
        match key {
            "" => format!("questions[{place}]"),
            key => format!("questions[{place}].{key}"),
        }
    }

    /// A mistake in a question, with its place in the file.
    fn wrong_question(&self, name: &str, fault: Fault) -> LessonError {
        match fault {
            Fault::Load(error) => LessonError::Load(error),
            Fault::Key { key, what, fix } => LessonError::Question {
                place: Box::new(self.place(self.path_of_question(name, &key))),
                what,
                fix,
            },
        }
    }

    /// Where a value of the file stands.
    fn place(&self, path: String) -> Place {
        Place {
            file: self.file.clone(),
            line: line_of(&self.text, &path),
            path,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_a_lesson_and_a_figure() {
        let name: FigureName = "12-grid/walk".parse().unwrap();
        assert_eq!(
            (name.lesson.as_str(), name.figure.as_str()),
            ("12-grid", "walk")
        );
        assert_eq!(name.to_string(), "12-grid/walk");
        for wrong in ["walk", "/walk", "12-grid/", "a/b/c", "a/<b>", "a/b c"] {
            assert!(wrong.parse::<FigureName>().is_err(), "{wrong}");
        }
    }
}
