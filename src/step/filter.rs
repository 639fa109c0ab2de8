//! What a reader looks for: `rejected`, `kind=cell object=A`, a word of a title.
//!
//! A condition `key=value` is about the line of the log: its key, and its value as it stands there or as it is shown. A word
//! alone is a value of the line, such as a verdict, a kind or a name, or a part of a step's title.

use std::fmt;

use crate::explain::shown;
use crate::scene::{Scene, nearest_name};
use crate::step::cursor::place;
use crate::step::headline::headline;
use crate::step::tree::StepLog;
use crate::trace::{Kind, LogNames, Record, StrategyName, has_text, value_of};

/// Conditions that all must hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filter {
    /// The kind of event that leads the step; absent: any.
    kind: Option<Kind>,
    conditions: Vec<Condition>,
}

#[derive(Clone, Debug, PartialEq)]
enum Condition {
    /// A key of the line with its value.
    Field(String, String),
    /// A value of the line, or a part of the title, small and large letters alike.
    Word {
        /// As a value stands in the line.
        quoted: String,
        /// In small letters.
        small: String,
    },
}

impl Condition {
    fn word(word: &str) -> Self {
        Self::Word {
            quoted: serde_json::Value::from(word).to_string(),
            small: word.to_lowercase(),
        }
    }
}

/// Why something is no filter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FilterError {
    /// Nothing is asked for.
    Empty,
    /// There is no kind of this name; the name that is most like it.
    Kind(String, Option<String>),
    /// A key or a value is missing.
    Form(String),
}

impl std::error::Error for FilterError {}

impl fmt::Display for FilterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(
                f,
                "say what to look for, as in /rejected or /kind=cell object=A"
            ),
            Self::Kind(name, Some(near)) => {
                write!(f, "there is no kind {name:?}; did you mean {near}?")
            }
            Self::Kind(name, None) => {
                let names = Kind::ALL.map(Kind::name).join(", ");
                write!(f, "there is no kind {name:?}; the kinds are {names}")
            }
            Self::Form(text) => write!(
                f,
                "{text:?} is no condition: give key=value, as in object=A, or a word"
            ),
        }
    }
}

impl Filter {
    /// A filter from its words, of which one in quotation marks may have spaces.
    ///
    /// # Errors
    /// No words, a kind that does not exist, a condition without key or value.
    pub fn new(words: &[String]) -> Result<Self, FilterError> {
        let mut filter = Self::default();
        for word in words {
            match word.split_once('=') {
                None => filter.conditions.push(Condition::word(word)),
                Some(("kind", name)) => {
                    let wrong = || {
                        let near = nearest_name(name, Kind::ALL.map(Kind::name).into_iter());
                        FilterError::Kind(name.into(), near)
                    };
                    filter.kind = Some(Kind::named(name).ok_or_else(wrong)?);
                }
                Some((key, value)) if key.is_empty() || value.is_empty() => {
                    return Err(FilterError::Form(word.clone()));
                }
                Some((key, value)) => filter
                    .conditions
                    .push(Condition::Field(key.into(), value.into())),
            }
        }
        if filter == Self::default() {
            return Err(FilterError::Empty);
        }
        Ok(filter)
    }

    /// The steps that it names, in the order of the log.
    ///
    /// With a kind they are the steps that such an event leads, if each other condition holds for one of the step's events on
    /// the same ray: the cells that list A. Without one, they are the events for which all conditions hold, or the tests that
    /// those are terms of.
    pub fn targets(&self, log: &StepLog) -> Vec<usize> {
        let mut held = Held::new(log);
        let mut targets: Vec<usize> = Vec::new();
        for (event, record) in log.records.iter().enumerate() {
            let step = match self.kind {
                None if self.holds(event, &mut held) => log.landing(event),
                Some(kind) if record.event.kind() == kind => {
                    let step = log.led_by(event);
                    if !self.holds_in(step, &mut held) {
                        continue;
                    }
                    step
                }
                _ => continue,
            };
            if targets.last() != Some(&step) {
                targets.push(step);
            }
        }
        targets.sort_by_cached_key(|&step| place(log, step));
        targets.dedup();
        targets
    }

    fn holds(&self, event: usize, held: &mut Held) -> bool {
        let step = |log: &StepLog| log.led_by(event);
        let mut conditions = self.conditions.iter();
        conditions.all(|condition| held.holds(event, step, condition))
    }

    /// Why it names no step, where that has a reason that the log does not show by itself: the object that it asks for is in no
    /// leaf and no cell that a ray came to.
    pub fn why_none(&self, log: &StepLog) -> Option<String> {
        let asked = self
            .conditions
            .iter()
            .find_map(|condition| match condition {
                Condition::Field(key, name) if key == "object" => Some(name),
                _ => None,
            })?;
        let known = log.scene.objects.iter().map(|object| &*object.name);
        if !known.clone().any(|name| name == asked) {
            let near = nearest_name(asked, known);
            let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
            return Some(format!("the scene has no object {asked:?}{near}"));
        }
        let alone = Self {
            kind: None,
            conditions: vec![Condition::Field("object".into(), asked.clone())],
        };
        if !alone.targets(log).is_empty() {
            return None;
        }
        match log.settings.strategy {
            StrategyName::Hierarchy | StrategyName::Heap => Some(format!(
                "no ray of this pixel enters the leaf that holds {asked:?}: its bound or one around it is missed, or begins \
                 beyond a hit that is nearer; /kind=node outcome=rejected and /kind=node outcome=pruned find such nodes"
            )),
            StrategyName::Grid => Some(format!(
                "no ray of this pixel visits a cell that lists {asked:?}; /kind=cell finds the cells that are visited"
            )),
            _ => None,
        }
    }

    /// Does each condition hold for an event of the step that is on its ray?
    fn holds_in(&self, step: usize, held: &mut Held) -> bool {
        let of = held.log.step(step);
        let ray = |record: &Record| (record.path, record.ray);
        let own = ray(&held.log.records[of.lead]);
        self.conditions.iter().all(|condition| {
            let mut events = of.events.clone();
            events.any(|event| {
                let is_own = ray(&held.log.records[event]) == own;
                is_own && held.holds(event, |_| step, condition)
            })
        })
    }
}

/// What is said of the targets that a filter names, or, without one, of those that are of interest by themselves.
pub(in crate::step) fn told_of(
    log: &StepLog,
    filter: Option<&Filter>,
    targets: &[usize],
) -> Vec<String> {
    let what = match filter {
        Some(_) => "named by the filter",
        None => "of interest",
    };
    let mut told = vec![match targets.len() {
        0 => format!("no step is {what}"),
        1 => format!("1 step is {what}"),
        many => format!("{many} steps are {what}"),
    }];
    if let Some(filter) = filter.filter(|_| targets.is_empty()) {
        told.extend(filter.why_none(log));
    }
    told
}

impl StepLog<'_> {
    /// The largest step that an event leads.
    pub(crate) fn led_by(&self, event: usize) -> usize {
        let leaf = self.leaf(event);
        let above = self.above(leaf).take_while(|&above| {
            let step = self.step(above);
            step.lead == event && !step.is_fold() && step.parent.is_some()
        });
        above.last().unwrap_or(leaf)
    }
}

/// Looks at the values of the log's lines, which are not written for it.
struct Held<'a, 'l> {
    log: &'a StepLog<'l>,
    names: LogNames,
    value: Vec<u8>,
}

impl<'a, 'l> Held<'a, 'l> {
    fn new(log: &'a StepLog<'l>) -> Self {
        let scene: &Scene = log.scene;
        Self {
            log,
            names: LogNames::new(scene),
            value: Vec::new(),
        }
    }

    /// Does a condition hold for an event, or for the title of its step?
    fn holds(
        &mut self,
        event: usize,
        step: impl Fn(&StepLog) -> usize,
        condition: &Condition,
    ) -> bool {
        let record = &self.log.records[event];
        match condition {
            Condition::Field(key, value) => {
                value_of(record, &self.names, key, &mut self.value)
                    && str::from_utf8(&self.value).is_ok_and(|found| is_value(found, value))
            }
            Condition::Word { quoted, small } => {
                has_text(record, &self.names, quoted) || {
                    let title = headline(self.log, step(self.log));
                    title.to_lowercase().contains(small)
                }
            }
        }
    }
}

/// Is a value of the line what was asked for: as it stands, as a name, as a list without brackets, or as the number that is
/// shown?
fn is_value(found: &str, asked: &str) -> bool {
    /// Significant digits, as in the worked solution.
    const DIGITS: u32 = 6;
    if found == asked {
        return true;
    }
    if found.starts_with('"') {
        let quoted = serde_json::Value::from(asked).to_string();
        return found == quoted;
    }
    if let Some(list) = found.strip_prefix('[') {
        return list.strip_suffix(']') == Some(asked);
    }
    match (found.parse::<f64>(), asked.replace('−', "-").parse::<f64>()) {
        (Ok(found), Ok(asked)) => shown(found, DIGITS) == shown(asked, DIGITS),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_asked_for_as_it_stands_or_as_it_is_shown() {
        assert!(is_value("7.9200001", "7.92"));
        assert!(!is_value("7.9200001", "7.93"));
        assert!(is_value("-2.5", "−2.5"));
        assert!(is_value("[1,0,2]", "1,0,2") && is_value("[1,0,2]", "[1,0,2]"));
        assert!(is_value(r#""a \"b\"""#, "a \"b\""));
        assert!(!is_value("\"hit\"", "hi"));
    }

    #[test]
    fn a_filter_that_says_nothing_or_names_no_kind_is_refused() {
        let filter = |words: &[&str]| {
            let words: Vec<String> = words.iter().map(|word| (*word).into()).collect();
            Filter::new(&words)
        };
        assert_eq!(filter(&[]), Err(FilterError::Empty));
        let near = Some("sphere_test".into());
        let expected = FilterError::Kind("sphere_tests".into(), near);
        assert_eq!(filter(&["kind=sphere_tests"]), Err(expected));
        assert_eq!(
            filter(&["object="]),
            Err(FilterError::Form("object=".into()))
        );
        assert!(filter(&["kind=cell", "object=A", "Rejected"]).is_ok());
    }
}
