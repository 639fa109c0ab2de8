//! The stages of the argument that a ray hits a sphere or misses it.

use crate::explain::Part;
use crate::figure::kinds::sphere::solved::Solved;
use crate::figure::parts::parabola;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::stage::StageId;
use crate::geometry::{Root, RootVerdict};

/// The stages, in their order. Those that a figure does not show are the one that it shows next.
pub(super) struct Argument {
    pub(super) ray: StageId,
    pub(super) coefficients: StageId,
    pub(super) discriminant: StageId,
    pub(super) roots: StageId,
    pub(super) choice: StageId,
    pub(super) normal: StageId,
}

/// Which of the stages a figure has between the ray and the hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shown {
    /// The equation and its roots.
    pub(super) equation: bool,
    /// The normal at the hit.
    pub(super) normal: bool,
}

impl Argument {
    pub(super) fn new(sheet: &mut Sheet, solved: &Solved, name: &str, shown: Shown) -> Self {
        let step = solved.step;
        let ray = sheet.stage(
            Part::Ray,
            solved.starts,
            format!(
                "The ray R starts at (x₀, y₀, z₀), and the sphere {name} has the centre (a, b, c) and the radius r."
            ),
        );
        let mut before = None;
        if shown.equation {
            let coefficients = sheet.stage(
                Part::Coefficients,
                step,
                format!(
                    "R meets the sphere where {} is 0, which is equation (iii).",
                    solved.function(true)
                ),
            );
            let discriminant = sheet.stage(Part::Discriminant, step, of_discriminant(solved));
            let roots = of_roots(solved).map(|told| sheet.stage(Part::Roots, step, told));
            before = Some((coefficients, discriminant, roots));
        }
        let choice = sheet.stage(Part::Choice, step, of_choice(solved, name));
        let (coefficients, discriminant, roots) = before.unwrap_or((choice, choice, None));
        let normal = match solved.shade.filter(|_| shown.normal) {
            Some((shade, step)) => sheet.stage(
                Part::Normal,
                step,
                format!(
                    "The normal N is the vector from the centre to the hit, divided by r: {}, of length 1.",
                    coordinates(shade.normal)
                ),
            ),
            None => choice,
        };
        Self {
            ray,
            coefficients,
            discriminant,
            roots: roots.unwrap_or(choice),
            choice,
            normal,
        }
    }
}

fn of_discriminant(solved: &Solved) -> String {
    let so = match parabola::roots(&solved.test).len() {
        0 => "no root",
        1 => "one root",
        _ => "two roots",
    };
    if solved.starts_inside() {
        return format!(
            "R starts inside the sphere, so c is below 0, the discriminant is {}, and there are two roots.",
            parabola::discriminant(&solved.test)
        );
    }
    format!(
        "R passes the centre at a distance d {} r, so the discriminant is {} and there {} {so}.",
        solved.compared(),
        parabola::discriminant(&solved.test),
        if so == "two roots" { "are" } else { "is" }
    )
}

/// Where the roots are; nothing if there are none.
fn of_roots(solved: &Solved) -> Option<String> {
    let roots = parabola::roots(&solved.test);
    let told = |(name, root): &(&str, Root)| format!("{name} = {}", quantity(root.t));
    let told: Vec<String> = roots.iter().map(told).collect();
    match told.as_slice() {
        [] => None,
        [one] => Some(format!("f touches the axis at {one}.")),
        several => Some(format!("f is 0 at {}.", several.join(" and "))),
    }
}

/// Which root counts, and why the others do not.
fn of_choice(solved: &Solved, name: &str) -> String {
    let mut roots = parabola::roots(&solved.test);
    if roots.is_empty() {
        return format!("Without a root R misses {name}.");
    }
    // the hit first
    roots.sort_by_key(|(_, root)| root.verdict != RootVerdict::Chosen);
    let told = |(name, root): &(&str, Root)| {
        let t = quantity(root.t);
        format!("{name} = {t} is {}", solved.why(*root))
    };
    let told: Vec<String> = roots.iter().map(told).collect();
    let so = match solved.test.roots.chosen() {
        Some(_) => String::new(),
        None => ": no hit".into(),
    };
    format!("{}{so}.", told.join("; "))
}
