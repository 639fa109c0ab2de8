//! The lines of slabs with their names: which end of a line a name stands at, so that it is nearest to its own line.

use glam::DVec2;

/// A line with a name at its second end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::figure) struct NamedLine {
    pub(in crate::figure) ends: [DVec2; 2],
    /// Where the name stands best, seen from there.
    pub(in crate::figure) towards: DVec2,
    /// About where its middle is then.
    pub(in crate::figure) name: DVec2,
}

impl NamedLine {
    /// Where it ends and other lines are near, its name stands on the side where they are not.
    fn new([from, to]: [DVec2; 2], others: impl Iterator<Item = [DVec2; 2]>, letters: f64) -> Self {
        /// How far from the end the middle of a name is, in sizes of letters.
        const NAME: f64 = 1.1;
        /// More aside than along the line.
        const ASIDE: f64 = 1.6;
        let along = (to - from).normalize_or_zero();
        let nearest = others
            .map(|[a, b]| to - nearest_on(a, b, to))
            .min_by(|a, b| a.length().total_cmp(&b.length()))
            .filter(|away| away.length() < ENOUGH * letters);
        let away = nearest.map_or(DVec2::ZERO, DVec2::normalize_or_zero);
        let towards = (along + ASIDE * away).try_normalize().unwrap_or(along);
        Self {
            ends: [from, to],
            towards,
            name: to + NAME * letters * towards,
        }
    }
}

/// What is so far away in sizes of letters disturbs no name.
const ENOUGH: f64 = 2.5;

/// Lines of slabs around a bound with their names, each nearest to its own line.
///
/// Lines that cross near their ends end before it. The name stands at the upper end, or the right one of a level
/// line, unless the other end is further from everything else.
pub(in crate::figure) fn with_names(
    lines: &[[DVec2; 2]],
    rim: &[DVec2],
    letters: f64,
) -> Vec<NamedLine> {
    /// So much further the other end is from everything, in sizes of letters, if it is taken.
    const BETTER: f64 = 0.4;
    let shortened = (0..lines.len()).map(|i| ends_before_crossings(lines, i, rim, letters));
    let shortened: Vec<[DVec2; 2]> = shortened.collect();
    let mut named: Vec<NamedLine> = Vec::new();
    for (i, &ends) in shortened.iter().enumerate() {
        let others = || {
            (0..shortened.len())
                .filter(|&j| j != i)
                .map(|j| shortened[j])
        };
        let [start, end] = upwards(ends);
        let [usual, turned] =
            [[start, end], [end, start]].map(|ends| NamedLine::new(ends, others(), letters));
        let room = |of: &NamedLine| {
            let to_lines = others().map(|[a, b]| nearest_on(a, b, of.name));
            // half of another name
            let to_names = named
                .iter()
                .map(|other| of.name.distance(other.name) - letters);
            let to_points = to_lines.chain(rim.iter().copied());
            let to_points = to_points.map(|point| of.name.distance(point));
            to_points.chain(to_names).fold(ENOUGH * letters, f64::min)
        };
        let is_better = room(&usual) + BETTER * letters < room(&turned);
        named.push(if is_better { turned } else { usual });
    }
    named
}

/// A line without what is near the crossing with another line outside of the bound, at either end.
fn ends_before_crossings(
    lines: &[[DVec2; 2]],
    line: usize,
    rim: &[DVec2],
    letters: f64,
) -> [DVec2; 2] {
    /// A line that ends so near to a crossing, in sizes of letters, ends before it.
    const NEAR: f64 = 2.0;
    /// So far before it, in sizes of letters.
    const BEFORE: f64 = 1.6;
    /// So much is left beyond the bound, in sizes of letters.
    const LEFT: f64 = 0.8;
    let [from, to] = lines[line];
    let along = (to - from).normalize_or_zero();
    let middle = 0.5 * (from + to);
    let place = |at: DVec2| (at - middle).dot(along);
    let others = (0..lines.len()).filter(|&other| other != line);
    let crossings = others.filter_map(|other| {
        let [a, b] = lines[other];
        let across = (b - a).normalize_or_zero().perp();
        let cosine = across.dot(along);
        // almost parallel lines cross far away
        (1e-3 < cosine.abs()).then(|| across.dot(a - middle) / cosine)
    });
    let crossings: Vec<f64> = crossings.collect();
    let cut = |end: DVec2| {
        let side = place(end).signum();
        let whole = side * place(end);
        // where the bound is left: the furthest of its corners on the line
        let on_line = rim
            .iter()
            .filter(|corner| (**corner - middle).perp_dot(along).abs() < 0.1 * letters);
        let bound = on_line
            .map(|corner| side * place(*corner))
            .fold(f64::NEG_INFINITY, f64::max);
        let near = crossings.iter().map(|at| side * at).filter(|at| {
            bound < *at - BEFORE * letters - LEFT * letters && (whole - at).abs() < NEAR * letters
        });
        let last = near.map(|at| at - BEFORE * letters).fold(whole, f64::min);
        middle + side * last * along
    };
    [cut(from), cut(to)]
}

/// The point of a straight line that is nearest to another.
pub(in crate::figure) fn nearest_on(from: DVec2, to: DVec2, at: DVec2) -> DVec2 {
    let along = to - from;
    let length = along.length_squared();
    if length == 0.0 {
        return from;
    }
    from + ((at - from).dot(along) / length).clamp(0.0, 1.0) * along
}

/// The ends of a line with the upper one last; of a level line the right one.
fn upwards([a, b]: [DVec2; 2]) -> [DVec2; 2] {
    let level = (a.y - b.y).abs() < 1e-6;
    if a.y < b.y && !level || level && b.x < a.x {
        [b, a]
    } else {
        [a, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_before_a_crossing_near_their_ends() {
        let at = DVec2::new;
        // a roof: its sides leave the bound at a height of 100, meet at 200 and end at 190
        let lines = [
            [at(-200.0, 0.0), at(-10.0, -190.0)],
            [at(200.0, 0.0), at(10.0, -190.0)],
        ];
        let rim = [at(-100.0, -100.0), at(100.0, -100.0)];
        let found = with_names(&lines, &rim, 10.0);
        // 16 before the crossing
        let back = 16.0 / 2f64.sqrt();
        for (line, side) in found.iter().zip([-1.0, 1.0]) {
            let end = at(side * back, -200.0 + back);
            let is_end = line.ends.iter().any(|of| (*of - end).length() < 1e-9);
            assert!(is_end, "{line:?}");
        }
    }
}
