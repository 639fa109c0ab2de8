//! The tree of the nodes: what became of each, where the ray enters it, and the order of the visits.

use glam::DVec2;

use crate::figure::kinds::hierarchy::argument::Argument;
use crate::figure::kinds::hierarchy::walk::Walk;
use crate::figure::parts::scenery;
use crate::figure::parts::visits::{Verdict, met};
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;

/// Where the nodes of the tree stand.
struct Places {
    at: Vec<DVec2>,
    radius: f64,
    /// From leaf to leaf.
    column: f64,
    /// Where the drawing ends.
    right: f64,
}

impl Walk<'_> {
    /// The tree of the nodes, below the order in which they are visited.
    pub(super) fn tree(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        frame: Frame,
        argument: &Argument,
    ) {
        let frame = if figure.shows(Layer::Numbers) {
            self.order(sheet, frame)
        } else {
            frame
        };
        let places = self.places(sheet, frame);
        for number in self.tree.shown() {
            let (node, number) = (&self.tree.nodes[number], number as u32);
            self.node(sheet, &places, number);
            let visit = self.visits.nodes[number as usize];
            if let (Some((step, near)), true) = (visit.hit, figure.shows(Layer::Numbers)) {
                let text = brief(near);
                if let Some(at) = places.near(self, sheet, number, sheet.width_of(&text)) {
                    let anchor = if node.objects.is_empty() {
                        Anchor::Start
                    } else {
                        Anchor::Middle
                    };
                    sheet.event(step, |sheet| sheet.text(anchor, at, text));
                }
            }
            self.objects(figure, sheet, number, &places, argument);
        }
    }

    /// The order in which the nodes are visited, as a line of their numbers.
    fn order(&self, sheet: &mut Sheet, frame: Frame) -> Frame {
        let height = sheet.line_height();
        let gap = 0.7 * sheet.letters;
        let mut place = frame.min + DVec2::new(0.0, 0.5 * height);
        let mut add = |sheet: &mut Sheet, step: u32, text: String| {
            let width = sheet.width_of(&text);
            if frame.max.x < place.x + width {
                place = DVec2::new(frame.min.x, place.y + height);
            }
            let at = place;
            sheet.event(step, |sheet| sheet.text(Anchor::Start, at, text));
            place.x += width + gap;
            place.y
        };
        let mut last = 0.0;
        for (number, &(node, step)) in self.visits.order.iter().enumerate() {
            if number == 0 {
                add(sheet, step, "visited:".into());
            }
            last = add(sheet, step, node.to_string());
        }
        let [_, rest] = frame.split_top(last + 0.5 * height - frame.min.y);
        rest
    }

    fn places(&self, sheet: &Sheet, frame: Frame) -> Places {
        /// Wider or higher apart a tree falls to pieces: in letters.
        const MOST: DVec2 = DVec2::new(7.0, 6.0);
        // below the leaves stand their objects, and where the ray enters them
        let below = DVec2::new(0.0, 2.6 * sheet.letters);
        let frame = Frame {
            min: frame.min,
            max: frame.max - below,
        };
        let spacing = self.tree.spacing(frame, MOST * sheet.letters);
        let numbers = 0..self.tree.nodes.len();
        Places {
            at: numbers
                .map(|node| self.tree.at(node, frame, spacing))
                .collect(),
            radius: (0.95 * sheet.letters)
                .min(0.45 * spacing.x)
                .min(0.34 * spacing.y),
            column: spacing.x,
            right: frame.max.x,
        }
    }

    /// A node: first as not visited, then over that what becomes of it.
    fn node(&self, sheet: &mut Sheet, places: &Places, number: u32) {
        let visit = self.visits.nodes[number as usize];
        let at = places.at[number as usize];
        let parent = self.tree.nodes[number as usize].parent;
        let parent = parent.map(|parent| places.at[parent as usize]);
        let circle = |sheet: &mut Sheet, look: Look| {
            if let Some(parent) = parent {
                let along = (at - parent).normalize_or_zero() * places.radius;
                sheet.line(look.outline(), parent + along, at - along);
            }
            sheet.circle(look, at, places.radius);
        };
        circle(sheet, Look::CULLED);
        if let Some((step, _)) = visit.hit {
            sheet.event(step, |sheet| {
                circle(sheet, Look::PAPER_LINE);
                circle(sheet, Verdict::Waiting.look());
            });
        }
        let is_decided = !matches!(visit.verdict, Verdict::Waiting | Verdict::Unreached);
        if let (Some(step), true) = (visit.step, is_decided) {
            sheet.event(step, |sheet| {
                circle(sheet, Look::PAPER_LINE);
                circle(sheet, visit.verdict.look());
                mark(sheet, visit.verdict, parent, at, places.radius);
            });
        }
        if 0.75 * sheet.letters <= places.radius {
            sheet.text(Anchor::Middle, at, number.to_string());
        }
    }

    /// The objects of a leaf below it, those that were tested in a frame.
    fn objects(
        &self,
        figure: &Figure,
        sheet: &mut Sheet,
        node: u32,
        places: &Places,
        argument: &Argument,
    ) {
        let objects = &self.tree.nodes[node as usize].objects;
        let names = objects.iter().map(|id| scenery::name_of(figure.scene, *id));
        let text = names.collect::<Vec<_>>().join(", ");
        let width = sheet.width_of(&text);
        if !figure.shows(Layer::Names) || text.is_empty() || places.column < width {
            return;
        }
        let middle = places.name(sheet, node);
        sheet.text(Anchor::Middle, middle, text);
        let half = DVec2::new(0.5 * width + 0.4 * sheet.letters, 0.75 * sheet.letters);
        let (min, max) = (middle - half, middle + half);
        let frame = |sheet: &mut Sheet, look: Look| {
            sheet.rectangle(look.outline(), Frame { min, max });
        };
        let own = self.visits.tested();
        for test in own.filter(|test| objects.contains(&test.object)) {
            let look = if test.is_hit {
                Look::MET
            } else {
                Look::REJECTED
            };
            sheet.event(test.step, |sheet| frame(sheet, look));
        }
        let is_nearest = met(&self.ray).is_some_and(|(object, _)| objects.contains(&object));
        if is_nearest {
            sheet.at(argument.end, |sheet| {
                frame(sheet, Look::PAPER_LINE);
                frame(sheet, Look::ANSWER);
            });
        }
    }
}

impl Places {
    /// The middle of what stands below a leaf.
    fn name(&self, sheet: &Sheet, leaf: u32) -> DVec2 {
        self.at[leaf as usize] + DVec2::new(0.0, self.radius + 1.05 * sheet.letters)
    }

    /// Where the t stands at which the ray enters a node: below the name of a leaf, at the right of another node;
    /// `None` without room for it.
    fn near(&self, walk: &Walk, sheet: &Sheet, node: u32, width: f64) -> Option<DVec2> {
        let gap = 0.3 * sheet.letters;
        let at = self.at[node as usize];
        if !walk.tree.nodes[node as usize].objects.is_empty() {
            let below = DVec2::new(0.0, 1.5 * sheet.letters);
            return (width + gap <= self.column).then(|| self.name(sheet, node) + below);
        }
        let left = at.x + self.radius + gap;
        // up to the next node of its level
        let is_beside = |other: &&DVec2| other.y == at.y && at.x < other.x;
        let next = self.at.iter().filter(is_beside);
        let next = next.map(|other| other.x).fold(f64::INFINITY, f64::min);
        let end = (next - self.radius - gap).min(self.right);
        if left + width <= end {
            return Some(DVec2::new(left, at.y));
        }
        // at its left, up to the node before and the text at the right of that
        let before = self
            .at
            .iter()
            .filter(|other| other.y == at.y && other.x < at.x);
        let before = before
            .map(|other| other.x)
            .fold(f64::NEG_INFINITY, f64::max);
        let start = at.x - self.radius - gap - width;
        (before + self.radius + 2.0 * gap + width <= start).then_some(DVec2::new(start, at.y))
    }
}

/// What a refused node has on the line to its parent: a cross, or two strokes where it was cut off.
fn mark(sheet: &mut Sheet, verdict: Verdict, parent: Option<DVec2>, at: DVec2, radius: f64) {
    let along = parent.map_or(DVec2::NEG_Y, |parent| (parent - at).normalize_or_zero());
    let look = Look {
        dash: Dash::Solid,
        ..verdict.look().outline()
    };
    let middle = parent.map_or(at + 2.0 * radius * along, |parent| at.midpoint(parent));
    match verdict {
        Verdict::Rejected => sheet.cross(look, middle),
        Verdict::Pruned => {
            let across = 0.6 * radius * along.perp();
            for place in [-0.2, 0.2] {
                let middle = middle + place * radius * along;
                sheet.line(look, middle - across, middle + across);
            }
        }
        Verdict::Entered | Verdict::Waiting | Verdict::Unreached => {}
    }
}
