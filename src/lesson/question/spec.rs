//! What a lesson says about a question: where its trace comes from, which step it is about, how it is answered.

use std::collections::BTreeMap;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::lesson::question::confusion::Confusion;
use crate::lesson::question::program::ProgramName;
use crate::structure::StructureOptions;
use crate::trace::{LightOptions, StrategyName, Through, Transport};

/// A question of a lesson. The same name serves the command line, the book and the worksheets.
///
/// Texts may hold expressions in braces, `{b^2 - 4*a*c}`: over the fields of the step that the question is about, of other
/// steps by the names in `with`, and of the scene, `scene.objects.A.shape.sphere.radius`. `count.cell` is how many steps of a
/// kind the pixel has. Expressions have + - * / ^, = != < <= > >=, and, or, not, words in single quotes, lists in brackets, and the functions
/// sqrt, abs, min, max, floor, round, sin, cos, tan, asin and acos in degrees, dot, cross, length, unit, and has. `{t:3}` shows three digits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct QuestionSpec {
    /// Its name in the lesson: small letters, digits and -.
    pub name: String,
    /// The question, with the numbers that decide it.
    pub text: String,
    /// The folder of another lesson whose scene it is about; usually its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lesson: Option<String>,
    /// The scene, by its file in the folder of the lesson.
    pub scene: String,
    /// The pixel that is traced.
    pub pixel: [u32; 2],
    /// Which objects each ray is tested against.
    #[serde(default)]
    pub strategy: StrategyName,
    /// What is chosen about the strategy's structure.
    #[serde(default)]
    pub structure: StructureOptions,
    /// Which rays are cast.
    #[serde(default)]
    pub transport: Transport,
    /// How light is followed from the lamps, where the transport does.
    #[serde(default)]
    pub light: LightOptions,
    /// Where the eye rays pass a pixel.
    #[serde(default)]
    pub through: Through,
    /// Values of the scene that are changed, by their JSON pointers, as in `/objects/0/shape/sphere/radius`. The changed scene is
    /// traced too; its steps have the same names after `after`, as in `after.t`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub change: BTreeMap<String, Value>,
    /// A second strategy by which the same pixel is traced: its steps have the same names after `after`, too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_strategy: Option<StrategyName>,
    /// The step that it is about: the fields of its event stand for themselves in expressions, as in `discriminant`.
    pub at: Selector,
    /// Other steps by names: their fields follow the name, as in `start.origin`.
    #[serde(default, rename = "with", skip_serializing_if = "BTreeMap::is_empty")]
    pub others: BTreeMap<String, Selector>,
    /// Expressions by names.
    #[serde(default, rename = "let", skip_serializing_if = "BTreeMap::is_empty")]
    pub names: BTreeMap<String, String>,
    /// The figure that is shown with it, as in `04-sphere/two-roots`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub figure: Option<String>,
    /// What students confuse here.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub confusions: Vec<Confusion>,
    /// How it is answered.
    pub ask: Ask,
    /// Lines of the working that are shown after the answer, before those of the step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub working: Vec<String>,
    /// What a worksheet may vary; absent: nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vary: Option<Vary>,
}

/// What a worksheet may vary.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Vary {
    /// The pixels among which one is chosen: the first and the last column and row; absent: the pixel stays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pixels: Option<[[u32; 2]; 2]>,
    /// Numbers of the scene by their JSON pointers, each with its smallest value, its largest and the step between values.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub numbers: BTreeMap<String, [f64; 3]>,
}

/// Which step of a trace: it must be one alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Selector {
    /// The kind of its event, as the log has it.
    pub kind: String,
    /// The object, by its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub object: Option<String>,
    /// The number of the ray.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ray: Option<u32>,
    /// The number of the path of light; usually the steps of the pixel and of the building.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<u32>,
    /// An expression over the event's own fields that must hold.
    #[serde(default, rename = "where", skip_serializing_if = "Option::is_none")]
    pub holds: Option<String>,
    /// Which of several such events, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nth: Option<usize>,
}

/// How a question is answered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Ask {
    /// By a number.
    Number(Number),
    /// By one of several numbers, those of mistakes among them.
    Value(Number),
    /// By one of several choices.
    Choice(Choices),
    /// By those of several choices that are true.
    Several(Choices),
    /// By one of the cells, nodes or objects of a figure.
    Place(Choices),
    /// By an order: of events as they happen.
    Order(Order),
    /// By the order of the lines of a program, among lines of its mistakes.
    Program(Program),
    /// By the quantities that are taken out of worked lines.
    Blank(Blank),
    /// By the log's own reason why a test was rejected.
    Reason(Reason),
    /// By the choices of the question that the step asks.
    Step(Step),
    /// By a pixel that shows that something may happen, or by the answer that none does.
    Counterexample(Counterexample),
}

/// A number that is asked for, with wrong ones.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Number {
    /// The expression whose value is right.
    pub answer: String,
    /// Another expression that must have the same value: the answer by another route.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub confirm: Option<String>,
    /// The unit, as in `pixels`; usually none.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub unit: String,
    /// How far an answer may be from it; usually half a percent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Why it is right.
    pub reason: String,
    /// Wrong numbers.
    #[serde(default)]
    pub wrong: Vec<WrongNumber>,
}

/// A wrong number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WrongNumber {
    /// The expression whose value it is; with a mistake usually the answer's, over what the wrong function returns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// The mistake that leads to it, by its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<String>,
    /// Why it is wrong; with a mistake the mistake's sentence follows.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
}

/// Choices: those that are listed here, or one for each of several steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Choices {
    /// The choices.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<ChoiceSpec>,
    /// The steps of which each is a choice. Its fields follow the name `it`, as in `it.cell`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub each: Option<Each>,
}

/// A choice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ChoiceSpec {
    /// What is chosen.
    pub text: String,
    /// The expression that is true if the choice is right.
    pub when: String,
    /// Why it is right or wrong.
    pub reason: String,
    /// The mistake that leads to it, by its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<String>,
}

/// Steps of which each is a choice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Each {
    /// Which steps.
    pub of: Selector,
    /// What is chosen, as in `cell {it.cell}`. Of several steps with the same words the first counts.
    pub text: String,
    /// The expression that is true if the choice is right.
    pub when: String,
    /// Why a right one is right.
    pub reason: String,
    /// Why a wrong one is wrong.
    pub otherwise: String,
}

/// An order of events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Order {
    /// The steps, in the order of the log.
    pub of: Selector,
    /// What is put in order, as in `cell {it.cell}`. Of several steps with the same words the first counts.
    pub text: String,
    /// Why it comes where it does.
    pub reason: String,
    /// Other steps, which are no part of the order: usually none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub among: Option<Among>,
}

/// Steps that are no part of an order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Among {
    /// The steps.
    pub of: Selector,
    /// Why it is no part of the order.
    pub reason: String,
}

/// A program whose lines are put in order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Which program.
    pub name: ProgramName,
}

/// Worked lines with quantities taken out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Blank {
    /// The expressions whose values are taken out, in the order in which they stand in the lines.
    pub take: Vec<String>,
    /// The lines; absent: those of the worked solution of the step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lines: Vec<String>,
    /// Why these are the values.
    pub reason: String,
}

/// Why a test was rejected.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Reason {}

/// The step's own question.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// What it is about, where a step has several questions: `dropped-axis`, `plane-t`, `inside` and so on; absent: the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub asks: Option<String>,
}

/// A pixel that shows that something may happen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Counterexample {
    /// The steps, by names: every way to choose one of each is tried, in every pixel of the picture.
    pub of: BTreeMap<String, Selector>,
    /// The expression over their fields that must hold, as in `child.t_near < parent.t_near`.
    pub when: String,
    /// Why a pixel shows it.
    pub reason: String,
    /// Why a pixel does not show it.
    pub otherwise: String,
    /// Why no pixel shows it, or what is wrong with this answer.
    pub none: String,
}
