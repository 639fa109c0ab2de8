//! Slabs as pairs of lines with their names and normals.

use glam::{DVec2, DVec3};

use crate::figure::kinds::slabs::argument::Shown;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::named_lines::{NamedLine, nearest_on, with_names};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::view::Space;

/// The two planes of each slab as lines with the names of their D, and its normal.
pub(in crate::figure::kinds) fn planes(
    sheet: &mut Sheet,
    (space, room): (&Space, Frame),
    all: &[Slab],
    slabs: &[Shown],
    (name, normals): (impl Fn(&Slab, &'static str) -> Text, bool),
) {
    let middle = bound::middle(all);
    let mut of = Vec::new();
    let mut lines = Vec::new();
    for shown in slabs {
        for (d, name) in [(shown.slab.d_min, "D_min"), (shown.slab.d_max, "D_max")] {
            if let Some(line) = shown.slab.line(space, room, d, middle) {
                of.push((*shown, name));
                lines.push(line);
            }
        }
    }
    let rim = bound::outline(all, &space.projection).rim.points();
    let rim: Vec<DVec2> = rim.iter().map(|at| space.place_flat(*at)).collect();
    let lines = with_names(&lines, &rim, sheet.letters);
    for ((shown, d), line) in of.iter().zip(&lines) {
        let [from, to] = line.ends;
        shown.draw(sheet, |sheet| {
            sheet.line(shown.look(), from, to);
            sheet.label(space.frame, to, line.towards, name(&shown.slab, d));
        });
    }
    if !normals {
        return;
    }
    for (place, (shown, d)) in of.iter().enumerate() {
        if *d != "D_min" {
            continue;
        }
        let along = space.direction(shown.slab.normal);
        let from = foot(&lines, place, along, sheet.letters);
        let to = from + ARROW * sheet.letters * along;
        shown.draw(sheet, |sheet| {
            sheet.arrow(Look::RAY.wide(1.5), from, to);
            sheet.label(space.frame, to, along, formula(&shown.slab.name()));
        });
    }
}

/// How far a plane is from the origin, along the normal of its slab: −D_min.
pub(super) fn distance(sheet: &mut Sheet, space: &Space, shown: &Shown) {
    let slab = &shown.slab;
    let ends = [DVec3::ZERO, -slab.d_min * slab.normal].map(|at| space.place(at));
    if !ends.iter().all(|at| space.frame.contains(*at)) {
        return;
    }
    shown.draw(sheet, |sheet| {
        sheet.arrow(Look::THIN, ends[0], ends[1]);
        let across = (ends[1] - ends[0]).perp();
        let text = formula("-D_min = ") + quantity(-slab.d_min);
        sheet.label(space.frame, ends[0].midpoint(ends[1]), across, text);
    });
}

/// Length of a normal's arrow in sizes of letters.
const ARROW: f64 = 2.4;

/// Where on its line a normal has most room: from other lines, and from their names.
fn foot(lines: &[NamedLine], place: usize, along: DVec2, letters: f64) -> DVec2 {
    /// Places that are tried, from the end without a name.
    const PLACES: [f64; 12] = [
        0.06, 0.14, 0.22, 0.3, 0.38, 0.46, 0.54, 0.62, 0.7, 0.78, 0.86, 0.94,
    ];
    /// What is so far away in sizes of letters does not disturb.
    const ENOUGH: f64 = 2.5;
    let [start, end] = lines[place].ends;
    let room = |from: DVec2| {
        let name = from + (ARROW + 1.2) * letters * along;
        let others = lines.iter().enumerate().filter(|(i, _)| *i != place);
        let to_lines = others.map(|(_, line)| {
            let [a, b] = line.ends;
            let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| from.lerp(name, share));
            let far = points.into_iter();
            let far = far.map(|at| at.distance(nearest_on(a, b, at)));
            far.fold(f64::INFINITY, f64::min)
        });
        // a name as "n₀ D_min" is five letters wide and reaches half of it from its middle
        let to_names = lines.iter().map(|line| {
            let at = nearest_on(from, name, line.name);
            at.distance(line.name) - 2.5 * letters
        });
        to_lines.chain(to_names).fold(ENOUGH * letters, f64::min)
    };
    let feet = PLACES.map(|share| start.lerp(end, share));
    // the first of those that are equal
    let best = feet.into_iter().rev();
    let best = best.max_by(|a, b| room(*a).total_cmp(&room(*b)));
    best.unwrap_or(start)
}
