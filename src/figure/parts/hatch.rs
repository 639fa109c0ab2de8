//! Hatching: an area that is marked by lines, where its colour alone would not be seen.

use glam::DVec2;

use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;

/// Hatches what lies in an odd number of closed lines: between a line and another inside it.
pub(in crate::figure) fn between(sheet: &mut Sheet, look: Look, rims: &[Vec<DVec2>]) {
    /// From one line to the next, in sizes of letters.
    const APART: f64 = 0.55;
    for [from, to] in lines(rims, APART * sheet.letters) {
        sheet.line(look, from, to);
    }
}

/// The pieces of slanted lines, y - x = k·apart, that lie inside.
fn lines(rims: &[Vec<DVec2>], apart: f64) -> Vec<[DVec2; 2]> {
    let level = |p: DVec2| (p.y - p.x) / apart;
    let levels = rims.iter().flatten().map(|p| level(*p));
    let (low, high) = levels.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), of| {
        (low.min(of), high.max(of))
    });
    let mut pieces = Vec::new();
    let mut at = low.ceil();
    while at <= high {
        let mut crossings: Vec<DVec2> = Vec::new();
        for rim in rims {
            let next = rim.iter().cycle().skip(1);
            for (&p, &q) in rim.iter().zip(next) {
                let (a, b) = (level(p) - at, level(q) - at);
                // an end on the line belongs to one side, so that the count is right there too
                if (a < 0.0) != (b < 0.0) {
                    crossings.push(p.lerp(q, a / (a - b)));
                }
            }
        }
        crossings.sort_by(|p, q| p.x.total_cmp(&q.x));
        let pairs = crossings.chunks_exact(2);
        pieces.extend(pairs.map(|pair| [pair[0], pair[1]]));
        at += 1.0;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64) -> Vec<DVec2> {
        let p = DVec2::new;
        vec![p(low, low), p(high, low), p(high, high), p(low, high)]
    }

    #[test]
    fn a_line_is_left_out_where_there_is_a_hole() {
        // the diagonal y = x runs through both squares; the next lines, y = x ± 8, touch corners alone
        let pieces = lines(&[square(0.0, 8.0), square(2.0, 5.0)], 8.0);
        let diagonal: Vec<[f64; 2]> = pieces
            .iter()
            .filter(|[a, b]| a.y == a.x && a != b)
            .map(|[a, b]| [a.x, b.x])
            .collect();
        assert_eq!(diagonal, [[0.0, 2.0], [5.0, 8.0]]);
    }

    #[test]
    fn nothing_is_hatched_in_nothing() {
        assert!(lines(&[], 1.0).is_empty());
        assert!(lines(&[Vec::new()], 1.0).is_empty());
    }
}
