//! Where labels go: beside what they name, across no line, over no other words.
//!
//! Each label tries places around its point, near ones and those in the direction it asks for first, and takes the
//! first that is free. One that had to go far gets a leader: a thin line back to its point. The labels are placed
//! in the order in which they were made, on the finished drawing, so that a figure's steps do not move them.

use std::f64::consts::TAU;

use glam::DVec2;

use crate::figure::parts::turn::at_angle;
use crate::figure::sheet::buckets::Buckets;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Fill, Look};
use crate::figure::sheet::text::Text;
use crate::figure::sheet::{Anchor, Form, Label, Mark, Sheet, Width, Words};

/// What labels keep away from.
struct Obstacles {
    lines: Buckets,
    /// Below this radius a circle is a dot.
    dot: f64,
    /// Words, and pictures.
    frames: Vec<Frame>,
}

/// A place that a label may take.
struct Candidate {
    frame: Frame,
    leader: Option<[DVec2; 2]>,
    /// How far it is from the best place.
    cost: f64,
}

/// Directions that are tried.
const DIRECTIONS: u32 = 16;
/// By how much a place with a corner at the point is worse than one with a side there.
const CORNER: f64 = 0.5;
/// How often it is tried further away.
const RINGS: u32 = 14;
/// Between the parts of a label, in sizes of its letters.
const HAIR: f64 = 0.06;
/// A leader across more lines leads nowhere.
const LOST: usize = 8;
/// The number of names of objects that are a crowd.
const CROWD: usize = 20;
/// Between words, in sizes of their letters: beside each other they must not read as one.
const AIR: DVec2 = DVec2::new(0.7, 0.14);
/// A circle of a smaller radius, in sizes of letters, is a dot.
const DOT: f64 = 0.36;

/// Places all labels of a sheet: they become words, and leaders become marks.
pub(in crate::figure) fn place_labels(sheet: &mut Sheet) {
    let mut obstacles = Obstacles::of(sheet);
    let labels = std::mem::take(&mut sheet.labels);
    // among many names a leader says no more than which of them it could be
    let crowded = CROWD < labels.iter().filter(|label| label.optional).count();
    let is_slide = sheet.width == Width::Slide;
    for label in labels {
        let Some(place) = best_place(&label, &obstacles, (crowded, is_slide)) else {
            continue;
        };
        obstacles.frames.push(place.frame);
        if let Some([from, to]) = place.leader {
            obstacles.lines.add([from, to]);
            sheet.since(label.since, |sheet| {
                sheet.path(Look::THIN.wide(0.75), vec![from, to]);
            });
        }
        let whole = whole(&label).frame(Anchor::Middle, DVec2::ZERO, label.size);
        let y = place.frame.min.y - whole.min.y;
        let mut words = |since, x, anchor, text| {
            sheet.words.push(Words {
                since,
                place: DVec2::new(x, y),
                anchor,
                size: label.size,
                text,
            });
        };
        if label.later.is_empty() {
            let middle = place.frame.middle().x;
            words(label.since, middle, Anchor::Middle, label.text);
            continue;
        }
        // the first two parts begin where they meet, whatever the width of a page's letters
        let mut meet = place.frame.min.x + label.text.width() * label.size;
        words(label.since, meet, Anchor::End, label.text);
        // a hair between letters whose widths are only known about
        meet += HAIR * label.size;
        for (later, more) in label.later {
            let width = more.width() * label.size;
            words(later, meet, Anchor::Start, more);
            meet += width;
        }
    }
}

/// All that a label says in the end.
fn whole(label: &Label) -> Text {
    let parts = label.later.iter();
    parts.fold(label.text.clone(), |text, (_, more)| text + more)
}

/// The best place for a label; none for one of a crowd of names that has no free place beside its object.
fn best_place(
    label: &Label,
    obstacles: &Obstacles,
    (crowded, is_slide): (bool, bool),
) -> Option<Candidate> {
    let mut candidates = candidates(label);
    let may_go = crowded && label.optional;
    if may_go {
        candidates.retain(|of| of.leader.is_none());
    }
    // within the lines of its area it stands nearer to them
    let air = if label.anywhere { 1.5 } else { 3.0 };
    let free = |of: &&Candidate| {
        label.within.holds(of.frame)
            && obstacles.covered(of, label.size) == 0.0
            && obstacles.crossings(of, air) == 0
            && obstacles.leader_crossings(of) == 0
    };
    if let Some(place) = candidates.iter().position(|of| free(&of)) {
        return candidates.into_iter().nth(place);
    }
    if may_go {
        return None;
    }
    // no room: rather across a line than over other words, rather near than far
    let trouble = |of: &Candidate| {
        let outside = if label.within.holds(of.frame) {
            0.0
        } else {
            1e6
        };
        outside
            + 1e3 * obstacles.covered(of, label.size)
            + 40.0 * obstacles.crossings(of, air) as f64
            + 5.0 * obstacles.leader_crossings(of) as f64
            + of.cost
    };
    let troubles: Vec<f64> = candidates.iter().map(trouble).collect();
    let best = (0..troubles.len()).min_by(|&a, &b| troubles[a].total_cmp(&troubles[b]))?;
    let place = candidates.into_iter().nth(best)?;
    // on a slide, which has little room, a name whose leader runs across the drawing would be read as another's
    let is_lost = is_slide && label.optional && LOST < obstacles.leader_crossings(&place);
    (!is_lost).then_some(place)
}

/// The places around a point, the best first.
fn candidates(label: &Label) -> Vec<Candidate> {
    let size = label.size;
    let letters = whole(label).frame(Anchor::Start, DVec2::ZERO, size);
    let half = 0.5 * letters.size();
    if label.anywhere {
        // off the area's edges, or near them where something large leaves no more room
        let margins = [0.25, 0.08].into_iter();
        let places = margins.flat_map(|of| places_in(label.within.wider(-of * size), half));
        return places.collect();
    }
    let towards = label.towards.try_normalize().unwrap_or(DVec2::NEG_Y);
    let mut found = Vec::new();
    for ring in 0..RINGS {
        // the first ring clears a dot; each further one is most of a letter further out
        let distance = (0.55 + 0.8 * f64::from(ring)) * size;
        for direction in 0..DIRECTIONS {
            let turn = f64::from(direction) / f64::from(DIRECTIONS) * TAU;
            let along = towards.rotate(at_angle(turn));
            let middle = label.of + (distance + touching(half, along)) * along;
            found.push(place_at(label, middle, half, (ring, turn)));
            // with a corner in that direction: a wide label then begins or ends beside its point
            let middle = label.of + distance * along + half * along.signum();
            let mut place = place_at(label, middle, half, (ring, turn));
            place.cost += CORNER;
            found.push(place);
        }
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// A label around a point on a ring, turned by an angle from where it asks to be.
fn place_at(label: &Label, middle: DVec2, half: DVec2, (ring, turn): (u32, f64)) -> Candidate {
    let size = label.size;
    let frame = Frame {
        min: middle - half,
        max: middle + half,
    };
    // what comes later is not there yet: a leader must not end where nothing stands
    let first = Frame {
        min: frame.min,
        max: DVec2::new(frame.min.x + label.text.width() * size, frame.max.y),
    };
    let nearest = first.nearest(label.of);
    let is_far = 1.3 * size < nearest.distance(label.of) && !holds(&label.named, frame);
    let leader = is_far.then(|| {
        let back = (label.of - nearest).normalize_or_zero();
        [label.of - 0.35 * size * back, nearest + 0.15 * size * back]
    });
    // half a turn is as bad as three rings
    let turned = turn.min(TAU - turn) / TAU * 6.0;
    Candidate {
        frame,
        leader,
        cost: f64::from(ring) + turned,
    }
}

/// The places in an area for a rectangle of that half size: its corners, then those between them, from the upper
/// left.
fn places_in(area: Frame, half: DVec2) -> Vec<Candidate> {
    /// Places beside each other, an odd number so that one is in the middle.
    const PLACES: u32 = 5;
    let last = PLACES - 1;
    let mut found = Vec::new();
    for row in 0..PLACES {
        for column in 0..PLACES {
            let share = DVec2::new(f64::from(column), f64::from(row)) / f64::from(last);
            let middle = area.min + half + share * (area.size() - 2.0 * half);
            let frame = Frame {
                min: middle - half,
                max: middle + half,
            };
            let is_corner = row % last == 0 && column % last == 0;
            let between = if is_corner { 0 } else { 2 * PLACES };
            found.push(Candidate {
                frame,
                leader: None,
                cost: f64::from(row + column + between),
            });
        }
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// Does a polygon hold all corners of a frame?
fn holds(polygon: &[DVec2], frame: Frame) -> bool {
    let Frame { min, max } = frame;
    let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
    corners.into_iter().all(|corner| {
        // as many edges cross the half-line to the right of a point in it as make an odd number
        let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        let crossed = edges.filter(|(a, b)| {
            let is_crossed = (a.y <= corner.y) != (b.y <= corner.y);
            is_crossed && corner.x < a.x + (corner.y - a.y) / (b.y - a.y) * (b.x - a.x)
        });
        crossed.count() % 2 == 1
    })
}

/// How far the middle of a rectangle is from a point that it touches, seen along a direction.
fn touching(half: DVec2, along: DVec2) -> f64 {
    let [x, y] = [half.x / along.x.abs(), half.y / along.y.abs()];
    x.min(y)
}

impl Obstacles {
    fn of(sheet: &Sheet) -> Self {
        let mut obstacles = Self {
            lines: Buckets::new(sheet.size),
            dot: DOT * sheet.letters,
            frames: sheet.words.iter().map(Words::frame).collect(),
        };
        for mark in &sheet.marks {
            obstacles.add(mark);
        }
        obstacles
    }

    fn add(&mut self, mark: &Mark) {
        let is_seen = 0.0 < mark.look.width || mark.look.fill == Fill::Full;
        match &mark.form {
            Form::Image { corners, .. } => {
                let [corner, right, below] = *corners;
                let around = [corner, right, below, right + below - corner];
                self.frames.extend(Frame::around(around));
            }
            Form::OnPicture { points, .. } => {
                for pair in points.windows(2) {
                    self.lines.add([pair[0], pair[1]]);
                }
            }
            _ if !is_seen => {}
            Form::Rectangle(frame) => {
                let [a, b, c, d] = frame.corners();
                for line in [[a, b], [b, c], [c, d], [d, a]] {
                    self.lines.add(line);
                }
            }
            Form::Path { points, closed } => {
                for pair in points.windows(2) {
                    self.lines.add([pair[0], pair[1]]);
                }
                if let ([first, .., last], true) = (points.as_slice(), closed) {
                    self.lines.add([*last, *first]);
                }
            }
            Form::Ellipse {
                center,
                radii,
                turn,
            } => {
                // a dot is as much in the way as the two lines of a cross
                if radii.max_element() < self.dot {
                    let DVec2 { x, y } = *radii;
                    for arm in [DVec2::new(x, y), DVec2::new(x, -y)] {
                        self.lines.add([*center - arm, *center + arm]);
                    }
                    return;
                }
                /// With this number of straight pieces it is within a hundredth of its radius.
                const PIECES: u32 = 24;
                let rotation = at_angle(turn.to_radians());
                let at = |piece: u32| {
                    let angle = f64::from(piece) / f64::from(PIECES) * TAU;
                    *center + rotation.rotate(*radii * at_angle(angle))
                };
                for piece in 0..PIECES {
                    self.lines.add([at(piece), at(piece + 1)]);
                }
            }
        }
    }

    /// How much of other words a label with letters of this size would cover.
    fn covered(&self, of: &Candidate, size: f64) -> f64 {
        let frame = of.frame.wider_by(AIR * size);
        let covered: f64 = self
            .frames
            .iter()
            .map(|other| frame.shared_area(*other))
            .sum();
        let by_leader =
            |other: &&Frame| of.leader.is_some_and(|line| other.cut_line(line).is_some());
        covered + self.frames.iter().filter(by_leader).count() as f64
    }

    /// How many lines a label would cross, or come as near to as this.
    fn crossings(&self, of: &Candidate, air: f64) -> usize {
        self.lines.crossing(of.frame.wider(air))
    }

    /// How many lines its leader would cross.
    fn leader_crossings(&self, of: &Candidate) -> usize {
        of.leader.map_or(0, |line| self.lines.crossing_line(line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet() -> Sheet {
        Sheet::new(Width::Book, 400.0)
    }

    #[test]
    fn a_label_stands_where_it_asks_to_if_nothing_is_there() {
        let mut sheet = sheet();
        let body = sheet.body();
        sheet.label(body, DVec2::new(300.0, 200.0), DVec2::X, "p");
        place_labels(&mut sheet);
        let words = &sheet.words[0];
        assert!(300.0 < words.frame().min.x, "{words:?}");
        assert!((words.frame().middle().y - 200.0).abs() < 1e-9, "{words:?}");
        assert!(sheet.marks.is_empty(), "no leader");
    }

    #[test]
    fn a_label_goes_where_no_line_is() {
        let mut sheet = sheet();
        let body = sheet.body();
        let at = DVec2::new(300.0, 200.0);
        sheet.line(
            Look::RAY,
            DVec2::new(100.0, 200.0),
            DVec2::new(500.0, 200.0),
        );
        sheet.label(body, at, DVec2::X, "a long label");
        place_labels(&mut sheet);
        let frame = sheet.words[0].frame();
        assert!(frame.max.y < 200.0 || 200.0 < frame.min.y, "{frame:?}");
    }

    #[test]
    fn fifty_labels_of_one_point_do_not_overlap() {
        let mut sheet = sheet();
        let body = sheet.body();
        for i in 0..50 {
            sheet.label(body, DVec2::new(380.0, 200.0), DVec2::X, format!("p{i}"));
        }
        place_labels(&mut sheet);
        for (i, a) in sheet.words.iter().enumerate() {
            for b in &sheet.words[..i] {
                assert_eq!(a.frame().shared_area(b.frame()), 0.0, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn a_label_that_goes_on_keeps_its_place() {
        let mut sheet = sheet();
        let body = sheet.body();
        let stages = ["first", "second"].map(|name| sheet.stage(name, None, name));
        sheet.at(stages[0], |sheet| {
            let (at, more) = (DVec2::new(300.0, 200.0), (stages[1], ", the hit"));
            sheet.label_that_goes_on(body, at, DVec2::X, "t = 3", more);
        });
        place_labels(&mut sheet);
        let [first, second] = sheet.words.as_slice() else {
            panic!("{:?}", sheet.words);
        };
        let since = [first, second].map(|words| words.since.stage);
        assert_eq!(since, [Some(stages[0]), Some(stages[1])]);
        let between = second.frame().min.x - first.frame().max.x;
        assert!((0.0..0.1 * first.size).contains(&between), "{between}");
        assert_eq!(first.place.y, second.place.y);
        // both are to the right of the point
        assert!(300.0 < first.frame().min.x, "{first:?}");
    }

    #[test]
    fn two_labels_on_a_line_do_not_read_as_one() {
        let mut sheet = sheet();
        let body = sheet.body();
        for (x, name) in [(300.0, "COP"), (312.0, "n")] {
            sheet.label(body, DVec2::new(x, 200.0), DVec2::NEG_Y, name);
        }
        place_labels(&mut sheet);
        let [cop, n] = [0, 1].map(|at| sheet.words[at].frame());
        let is_beside = cop.min.y < n.max.y && n.min.y < cop.max.y;
        let gap = (n.min.x - cop.max.x).max(cop.min.x - n.max.x);
        assert!(!is_beside || AIR.x * 14.0 <= gap + 1e-9, "{cop:?} {n:?}");
    }

    /// Squares around a point, so close that no word stands between them.
    fn fenced(width: Width) -> (Sheet, DVec2) {
        let mut sheet = Sheet::new(width, 400.0);
        let middle = 0.5 * sheet.size;
        for fence in 1..=20 {
            let half = DVec2::splat(0.25 * f64::from(fence) * sheet.letters);
            let (min, max) = (middle - half, middle + half);
            sheet.rectangle(Look::THIN, Frame { min, max });
        }
        (sheet, middle)
    }

    #[test]
    fn a_name_whose_leader_runs_across_a_slide_is_left_out() {
        let names = |width| {
            let (mut sheet, at) = fenced(width);
            let body = sheet.body();
            sheet.name(body, at, DVec2::X, ("A", Vec::new()));
            place_labels(&mut sheet);
            sheet.words.len()
        };
        assert_eq!([Width::Book, Width::Slide].map(names), [1, 0]);
    }

    #[test]
    fn a_leader_ends_at_the_part_of_a_label_that_is_there() {
        let (mut sheet, at) = fenced(Width::Book);
        let body = sheet.body();
        let stages = ["first", "second"].map(|name| sheet.stage(name, None, name));
        sheet.at(stages[0], |sheet| {
            let more = (stages[1], ", behind the origin of the ray");
            sheet.label_that_goes_on(body, at, DVec2::NEG_X, "t = 3", more);
        });
        let lines = sheet.marks.len();
        place_labels(&mut sheet);
        let Form::Path { points, .. } = &sheet.marks[lines].form else {
            panic!("{:?}", sheet.marks);
        };
        let first = sheet.words[0].frame();
        let end = points[1];
        let off = first.nearest(end).distance(end);
        assert!(off < 0.5 * sheet.letters, "{end} {first:?}");
    }

    #[test]
    fn a_label_in_a_corner_stays_on_the_sheet() {
        let mut sheet = sheet();
        let body = sheet.body();
        sheet.label(body, body.min, DVec2::NEG_ONE, "corner");
        place_labels(&mut sheet);
        assert!(body.holds(sheet.words[0].frame()));
    }

    #[test]
    fn a_label_of_an_area_takes_a_corner_that_is_free() {
        let mut sheet = sheet();
        let (min, max) = (DVec2::new(100.0, 100.0), DVec2::new(180.0, 180.0));
        let area = Frame { min, max };
        sheet.rectangle(Look::THIN, area);
        // through the upper left corner and the lower right one
        sheet.line(Look::RAY, min, max);
        sheet.label_in(area, "7");
        place_labels(&mut sheet);
        let frame = sheet.words[0].frame();
        assert!(area.holds(frame), "{frame:?}");
        assert!(
            140.0 < frame.min.x && frame.max.y < 140.0,
            "not in the upper right: {frame:?}"
        );
    }
}
