//! The lines of a pixel against its events.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::geometry::Ray;
use crate::lesson::check::agreeing::Colour;
use crate::lesson::check::checked::{Checked, Divergence, Quantity};
use crate::lesson::check::error::CheckError;
use crate::lesson::check::fields::{self, How, WrongType};
use crate::lesson::check::foreign::{ForeignPixel, ForeignRay};
use crate::lesson::check::line::Line;
use crate::lesson::check::on_ray::OnRay;
use crate::lesson::check::options::{COLOUR, CheckOptions};
use crate::lesson::check::pairing::{OFFSET, event_of, in_words, match_rays, subject};
use crate::lesson::check::reference::{Expected, ExpectedPixel, ExpectedRay, Reference};
use crate::lesson::check::suspects::{self, Situation, Suspects};
use crate::lesson::check::value::{Fields, Value};
use crate::lesson::check::way::Way;
use crate::trace::{Kind, Purpose};

/// How many times further beside its point a ray of a bent mirror may hit.
const AMPLIFIED: f64 = 30.0;

/// A line with the event that it is.
struct Compared<'a> {
    line: &'a Line,
    expected: Expected,
    quantities: Vec<Quantity>,
    ray: Option<usize>,
    /// The contexts of its ray, and the one of them that fits best.
    on: Option<(Range<usize>, usize)>,
}

impl Compared<'_> {
    fn is_different(&self) -> bool {
        self.quantities.iter().any(|of| !of.is_same)
    }

    /// The first quantity that differs.
    fn key(&self) -> &str {
        let wrong = self.quantities.iter().find(|of| !of.is_same);
        wrong.map_or("", |of| &of.key)
    }

    /// Do the rays that start where this one ends start elsewhere?
    fn moves_the_hit(&self) -> bool {
        match self.line.kind {
            Kind::Ray | Kind::Nearest => true,
            Kind::RayEnd => self.key() != "colour",
            Kind::Shade => self.is_of_surface(),
            _ => false,
        }
    }

    /// Is it the point or the normal, from which all that follows is computed?
    fn is_of_surface(&self) -> bool {
        self.line.kind == Kind::Shade && ["object", "point", "normal", "back"].contains(&self.key())
    }

    /// The step at which the quantity is worked out: a point and its normal before the rays from there.
    fn comes_at(&self, expected: &ExpectedPixel) -> (u32, bool) {
        let own = (self.expected.step, false);
        let Some(ray) = self.ray.filter(|_| self.is_of_surface()) else {
            return own;
        };
        let events = expected.rays[ray].events.iter();
        let nearest = events
            .filter(|of| of.kind() == Kind::Nearest)
            .map(|of| of.step);
        nearest.max().map_or(own, |step| (step, true))
    }
}

/// One pixel that is compared.
struct Comparing<'a, 's> {
    reference: &'a Reference<'a, 's>,
    expected: &'a ExpectedPixel,
    options: &'a CheckOptions,
    checked: &'a mut Checked,
    name: &'a str,
    /// How far numbers may differ because the log's rays start beside their points, by the ray's place.
    slack: Vec<f64>,
}

/// Compares the lines of a pixel with its events.
pub(super) fn compare(
    reference: &Reference<'_, '_>,
    expected: &ExpectedPixel,
    pixel: &ForeignPixel,
    options: &CheckOptions,
    (name, checked): (&str, &mut Checked),
) -> Result<(), CheckError> {
    checked.pixels += 1;
    let asked = |kind: &&Kind| options.only.is_none_or(|only| only.contains(**kind));
    checked.expected.extend(expected.kinds.iter().filter(asked));
    let mut comparing = Comparing {
        reference,
        expected,
        options,
        checked,
        name,
        slack: vec![0.0; expected.rays.len()],
    };
    let mut contexts = Vec::new();
    let mut is_wrong = vec![false; expected.rays.len()];
    let mut matched: Vec<(usize, &ForeignRay)> = Vec::new();
    for (place, foreign) in match_rays(expected, &pixel.rays)
        .into_iter()
        .zip(&pixel.rays)
    {
        match place {
            Some(place) => matched.push((place, foreign)),
            None => comparing.beyond(&foreign.lines),
        }
    }
    // a ray comes before those that start where it ends
    matched.sort_by_key(|(place, _)| *place);
    for (place, foreign) in &matched {
        comparing.allow(*place, foreign);
    }
    let mut different = comparing.own(pixel)?;
    for (place, foreign) in matched {
        let parent = expected.rays[place].parent;
        if parent.is_some_and(|parent| is_wrong[parent]) {
            is_wrong[place] = true;
            continue;
        }
        let first = contexts.len();
        contexts.extend(comparing.contexts(&expected.rays[place], foreign));
        let found = comparing.ray(place, foreign, (first, &contexts[first..]))?;
        is_wrong[place] = found
            .iter()
            .any(|of| of.is_different() && of.moves_the_hit());
        different.extend(found);
    }
    different.sort_by_key(|of| of.comes_at(expected));
    for of in different {
        comparing.tell(&of, pixel, &contexts);
    }
    Ok(())
}

impl Comparing<'_, '_> {
    fn is_asked(&self, kind: Kind) -> bool {
        self.options.only.is_none_or(|only| only.contains(kind))
    }

    fn beyond(&mut self, lines: &[Line]) {
        for line in lines {
            if self.is_asked(line.kind) {
                *self.checked.beyond.entry(line.kind).or_default() += 1;
            }
        }
    }

    /// What belongs to the pixel itself.
    fn own<'l>(&mut self, pixel: &'l ForeignPixel) -> Result<Vec<Compared<'l>>, CheckError> {
        let mut found = Vec::new();
        for line in &pixel.own {
            if !self.is_asked(line.kind) {
                continue;
            }
            let Some(expected) = self.expected.own.iter().find(|of| of.kind() == line.kind) else {
                self.beyond(std::slice::from_ref(line));
                continue;
            };
            let mut expected = expected.clone();
            if line.kind == Kind::Pixel {
                self.on_their_window(line, &mut expected.fields);
            }
            let how = self.how(line.kind, (None, None), Purpose::Eye);
            let quantities = self.quantities(line, &expected.fields, how)?;
            self.count(line, &quantities);
            if quantities.iter().any(|of| !of.is_same) {
                found.push(Compared {
                    line,
                    expected,
                    quantities,
                    ray: None,
                    on: None,
                });
            } else if line.kind == Kind::PixelColour && self.checked.divergence.is_none() {
                self.checked.agreeing.keep(|| Colour {
                    pixel: pixel.pixel,
                    yours: line.fields.clone(),
                    expected,
                });
            }
        }
        Ok(found)
    }

    /// A window at another distance has the pixel's point elsewhere on the same line from the COP.
    fn on_their_window(&self, line: &Line, expected: &mut Fields) {
        let cop = self.reference.scene.camera.cop;
        let (Some(yours), Some(point)) = (line.fields.vector("point"), expected.vector("point"))
        else {
            return;
        };
        let Some(along) = (point - cop).try_normalize() else {
            return;
        };
        let distance = (yours - cop).dot(along);
        if 0.0 < distance {
            for (key, value) in &mut expected.0 {
                if key == "point" {
                    *value = Value::List((cop + distance * along).to_array().into());
                }
            }
        }
    }

    /// A ray that starts beside its point, since it was moved by ε, hits beside it too, and so does what starts there.
    fn allow(&mut self, place: usize, foreign: &ForeignRay) {
        let own = &self.expected.rays[place];
        let before = own.parent.map_or(0.0, |parent| self.slack[parent]);
        let moved = foreign
            .start()
            .and_then(|line| line.fields.vector("origin"))
            .map_or(0.0, |origin| origin.distance(own.start.ray.origin));
        let moved = if moved <= OFFSET * own.start.ray.origin.length().max(1.0) {
            AMPLIFIED * moved
        } else {
            0.0
        };
        self.slack[place] = before.max(moved);
    }

    /// How far the numbers of a ray may differ; those of the pixel's colour if it is none.
    fn tolerance(&self, ray: Option<usize>) -> f64 {
        let slack = match ray {
            Some(ray) => self.slack[ray],
            None => self.slack.iter().copied().fold(0.0, f64::max),
        };
        self.options.tolerance + slack
    }

    fn how(&self, kind: Kind, (ray, on): (Option<usize>, Option<&OnRay>), purpose: Purpose) -> How {
        How {
            kind,
            tolerance: self.tolerance(ray),
            // all that a ray spawns is in its colour
            colour: self.tolerance(None).max(COLOUR),
            length: on.map_or(1.0, |on| on.length),
            nearest: on.and_then(|on| {
                let end = Some(on.range.max).filter(|max| max.is_finite());
                on.nearest.map(|hit| hit.t).or(end)
            }),
            is_shadow: purpose == Purpose::Shadow,
        }
    }

    fn quantities(
        &self,
        line: &Line,
        expected: &Fields,
        how: How,
    ) -> Result<Vec<Quantity>, CheckError> {
        fields::compare(&line.fields, expected, how).map_err(|wrong| self.of_type(line, &wrong))
    }

    fn of_type(&self, line: &Line, wrong: &WrongType) -> CheckError {
        let WrongType {
            key,
            yours,
            expected,
        } = wrong;
        let fix = match (yours, expected) {
            (Value::Text(_), Value::Number(_) | Value::Flag(_)) => {
                "write it without quotation marks, and leave the field out where there is none"
                    .into()
            }
            _ => format!("as in \"{key}\": {}", expected.json()),
        };
        CheckError::Line {
            file: self.name.into(),
            line: line.number,
            what: format!("\"{key}\" has {}; it is {}", yours.what(), expected.what()),
            fix,
        }
    }

    fn count(&mut self, line: &Line, quantities: &[Quantity]) {
        *self.checked.compared.entry(line.kind).or_default() += 1;
        if quantities.iter().any(|of| !of.is_same) {
            *self.checked.different.entry(line.kind).or_default() += 1;
        }
    }

    /// The rays on which the tests of a ray may have been computed: that of the scene; the log's own; and for an eye ray
    /// that is not told, the one whose t is 1 at the window.
    fn contexts(&self, expected: &ExpectedRay, foreign: &ForeignRay) -> Vec<OnRay> {
        let start = &expected.start;
        let mut rays = vec![start.ray];
        match foreign.start() {
            Some(line) => {
                let origin = line.fields.vector("origin").unwrap_or(start.ray.origin);
                let direction = line
                    .fields
                    .vector("direction")
                    .unwrap_or(start.ray.direction);
                if direction.length() != 0.0 {
                    rays.push(Ray::new(origin, direction));
                }
            }
            None => {
                let window = start.window_t.filter(|t| 0.0 < *t);
                rays.extend(window.map(|t| Ray::new(start.ray.origin, t * start.ray.direction)));
                // a shadow ray whose direction is the light's point less its own
                if start.purpose == Purpose::Shadow && start.range.max.is_finite() {
                    rays.push(Ray::new(
                        start.ray.origin,
                        start.range.max * start.ray.direction,
                    ));
                }
            }
        }
        rays.into_iter()
            .map(|ray| OnRay::new(self.reference, ray, start.range))
            .collect()
    }

    /// The lines of one ray, those that agree too.
    fn ray<'l>(
        &mut self,
        place: usize,
        foreign: &'l ForeignRay,
        (first, contexts): (usize, &[OnRay]),
    ) -> Result<Vec<Compared<'l>>, CheckError> {
        let expected = &self.expected.rays[place];
        let purpose = expected.start.purpose;
        if let Some(line) = foreign.start().filter(|line| self.is_asked(line.kind)) {
            let start = expected.events.iter().find(|of| of.kind() == Kind::Ray);
            if let Some(start) = start {
                let quantities = self.start(line, start, (place, purpose))?;
                self.count(line, &quantities);
                if quantities.iter().any(|of| !of.is_same) {
                    let different = Compared {
                        line,
                        expected: start.clone(),
                        quantities,
                        ray: Some(place),
                        on: None,
                    };
                    return Ok(vec![different]);
                }
            }
        }
        let last_nearest = foreign
            .lines
            .iter()
            .rposition(|line| line.kind == Kind::Nearest);
        let mut met: BTreeMap<(Kind, String), usize> = BTreeMap::new();
        let mut found = Vec::new();
        for (number, line) in foreign.lines.iter().enumerate() {
            let is_compared = match line.kind {
                // the start of a ray is compared before; the half-line from p′ may go either way
                Kind::Ray | Kind::Edge => false,
                // which was the nearest in between depends on the order of the tests
                Kind::Nearest => Some(number) == last_nearest && purpose != Purpose::Shadow,
                _ => true,
            };
            if !is_compared || !self.is_asked(line.kind) {
                continue;
            }
            let nth = met
                .entry((line.kind, subject(&line.fields, line.kind)))
                .or_default();
            let place_of_kind = *nth;
            *nth += 1;
            let mut best: Option<Compared<'_>> = None;
            for (at, on) in contexts.iter().enumerate() {
                let Some(event) = event_of(self.reference, line, expected, on, place_of_kind)
                else {
                    continue;
                };
                let how = self.how(line.kind, (Some(place), Some(on)), purpose);
                let quantities = self.quantities(line, &event.fields, how)?;
                let is_same = quantities.iter().all(|of| of.is_same);
                // of several the log's own ray is the last one
                let is_better = best.is_none()
                    || is_same
                    || (1e-3 < (on.length - 1.0).abs() && foreign.start().is_some());
                if is_better {
                    best = Some(Compared {
                        line,
                        expected: event,
                        quantities,
                        ray: Some(place),
                        on: Some((first..first + contexts.len(), first + at)),
                    });
                }
                if is_same {
                    break;
                }
            }
            let Some(best) = best else {
                self.beyond(std::slice::from_ref(line));
                continue;
            };
            self.count(line, &best.quantities);
            found.push(best);
        }
        Ok(found)
    }

    /// Where a ray starts and where it goes.
    fn start(
        &self,
        line: &Line,
        start: &Expected,
        (place, purpose): (usize, Purpose),
    ) -> Result<Vec<Quantity>, CheckError> {
        let how = self.how(Kind::Ray, (Some(place), None), purpose);
        let mut quantities = self.quantities(line, &start.fields, how)?;
        // what moved the point where it starts
        let parent = self.expected.rays[place].parent;
        let tolerance = parent.map_or(self.options.tolerance, |parent| {
            self.tolerance(Some(parent))
        });
        let mut allowed = tolerance;
        if let (Some(yours), Some(origin)) =
            (line.fields.vector("origin"), start.fields.vector("origin"))
        {
            let most = match purpose {
                Purpose::Eye => tolerance,
                _ => OFFSET + tolerance,
            };
            let size = origin.length().max(1.0);
            let off = yours.distance(origin);
            let is_same = off <= most * size;
            quantities
                .iter_mut()
                .filter(|of| of.key == "origin")
                .for_each(|of| of.is_same = is_same);
            if is_same {
                // seen from beside, a light lies in another direction
                allowed += 2.0 * off;
            }
        }
        if let (Some(yours), Some(direction)) = (
            line.fields.vector("direction"),
            start.fields.vector("direction"),
        ) {
            let unit = yours.normalize_or_zero();
            let is_same = unit.distance(direction) <= allowed;
            for of in quantities.iter_mut().filter(|of| of.key == "direction") {
                of.is_same = is_same;
                if !is_same && 1e-6 < (yours.length() - 1.0).abs() {
                    of.expected = format!("a multiple of {}", of.expected);
                }
            }
        }
        Ok(quantities)
    }

    /// Notes a line: the first one that differs is reported, and those after it show which mistake it can be.
    fn tell(&mut self, of: &Compared<'_>, pixel: &ForeignPixel, contexts: &[OnRay]) {
        let wrong = of.quantities.iter().position(|of| !of.is_same);
        let key = match (wrong, &self.checked.divergence) {
            (Some(wrong), _) => of.quantities[wrong].key.clone(),
            // what agrees after all must agree with the mistake too
            (None, Some(first)) => first
                .quantities
                .last()
                .map_or(String::new(), |of| of.key.clone()),
            (None, None) => return,
        };
        let situation = Situation {
            reference: self.reference,
            pixel: pixel.pixel,
            expected: &of.expected,
            rays: &self.expected.rays,
            ray: of.ray,
            on: of.on.as_ref().map(|(_, on)| &contexts[*on]),
            contexts: of
                .on
                .as_ref()
                .map_or(&[], |(all, _)| &contexts[all.clone()]),
            yours: &of.line.fields,
            key: &key,
            tolerance: self.tolerance(of.ray),
            differs: wrong.is_some(),
            is_endless: false,
            way: Way::default(),
        };
        let first = self.checked.divergence.as_ref();
        let purpose = of
            .ray
            .map(|ray| self.expected.rays[ray].start.purpose.word());
        let is_other = |first: &Divergence| {
            // rays are aimed by another function for each purpose
            let is_aimed = of.line.kind == Kind::Ray;
            first.kind != of.line.kind
                || is_aimed && purpose.is_some_and(|purpose| !first.ray.starts_with(purpose))
        };
        if first.is_some_and(is_other) {
            return;
        }
        let suspects = &mut self.checked.suspects;
        if first.is_none() || !suspects::is_on_start(&situation) {
            suspects.get_or_insert_with(Suspects::all).hear(&situation);
        }
        let before = self.checked.agreeing.take();
        if let (Kind::PixelColour, None, Some(suspects)) = (of.line.kind, first, suspects) {
            for before in &before {
                suspects.hear(&Situation {
                    pixel: before.pixel,
                    expected: &before.expected,
                    yours: &before.yours,
                    differs: false,
                    ..situation
                });
            }
        }
        if let (None, Some(wrong)) = (first, wrong) {
            let ray = of
                .ray
                .map(|place| in_words(&self.expected.rays[place], self.reference));
            self.checked.divergence = Some(Divergence {
                line: of.line.number,
                pixel: pixel.pixel,
                kind: of.line.kind,
                ray: ray.unwrap_or_default(),
                subject: subject(&of.line.fields, of.line.kind),
                quantities: of.quantities[..=wrong].to_vec(),
                step: of.expected.step,
                ray_number: of.ray.map(|ray| ray as u32),
                fields: of
                    .line
                    .fields
                    .0
                    .iter()
                    .map(|(key, value)| (key.clone(), value.json()))
                    .collect(),
                mistake: None,
            });
        }
    }
}
