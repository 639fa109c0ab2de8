//! The bound of two bounds (Fig. 15.58(b)): of each pair of planes the minimum D_min and the maximum D_max.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::named_lines::with_names;
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::MOST_SLABS;
use crate::scene::PrimitiveId;
use crate::structure::{Hierarchy, Link, MergeStep, range};
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Slabs,
        Layer::Volumes,
        Layer::Numbers,
    ],
    more: &[],
};

/// The bound of both.
const BOTH: Look = Look::VISITED.wide(3.0);
/// A bound that goes into it.
const ONE: Look = Look {
    dash: Dash::Dashed,
    ..Look::THIN.wide(1.25)
};

/// Two bounds and how they were joined.
struct Joined {
    /// Slab by slab, with the step of the building.
    steps: Vec<(u32, MergeStep)>,
    /// The slabs of both bounds, and of the one around them.
    bounds: [Vec<Slab>; 3],
    /// What the two are called.
    names: [String; 2],
    /// The objects in them.
    objects: Vec<PrimitiveId>,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let joined = Joined::find(figure)?;
    let projection = figure.projection();
    let drawing = if figure.shows(Layer::Numbers) {
        let table = Table::new(sheet, body, &joined, &projection);
        let gap = 2.0 * sheet.letters;
        /// Of the width at most.
        const SHARE: f64 = 0.58;
        let rest = 1.0 - table.width() / (body.size().x - gap);
        let [left, right] = body.split(rest.clamp(0.0, SHARE), gap);
        table.draw(sheet, right);
        left
    } else {
        body
    };
    let [first, second, both] = &joined.bounds;
    let middle = bound::middle(both);
    /// So much more than the bound is shown, so that its planes are seen to go on.
    const AROUND: f64 = 1.3;
    let shown = bound::corners(both).into_iter();
    let space = figure.space(drawing, shown.map(|p| middle + AROUND * (p - middle)));
    if figure.shows(Layer::Objects) {
        scenery::some_objects(figure, sheet, &space, &joined.objects, Look::OBJECT);
    }
    if figure.shows(Layer::Volumes) {
        for slabs in [first, second] {
            let around = bound::outline(slabs, &space.projection);
            outline::rim(sheet, &space, &around.rim, ONE);
        }
    }
    // names stand at the ends of the lines
    let room = space.frame.wider(-1.75 * sheet.letters);
    if figure.shows(Layer::Slabs) {
        planes(sheet, &space, room, &joined);
    }
    if figure.shows(Layer::Volumes) {
        sheet.step(joined.steps.last().map(|(step, _)| *step), |sheet| {
            let around = bound::outline(both, &space.projection);
            outline::rim(sheet, &space, &around.rim, BOTH);
        });
    }
    if figure.shows(Layer::Names) {
        for (slabs, name) in [first, second].into_iter().zip(&joined.names) {
            let at = space.place(bound::middle(slabs));
            sheet.label(space.frame, at, DVec2::X, name.as_str());
        }
    }
    Ok(in_words(&joined, &projection))
}

/// The planes of the bound of both, with the names of their normals.
fn planes(sheet: &mut Sheet, space: &Space, room: Frame, joined: &Joined) {
    let both = &joined.bounds[2];
    let middle = bound::middle(both);
    let mut named = Vec::new();
    let mut lines = Vec::new();
    for (slab, (step, _)) in both.iter().zip(&joined.steps) {
        if !slab.is_on_edge(&space.projection) {
            continue;
        }
        for d in [slab.d_min, slab.d_max] {
            if let Some(line) = slab.line(space, room, d, middle) {
                named.push((*step, slab.name()));
                lines.push(line);
            }
        }
    }
    let rim = bound::outline(both, &space.projection).rim.points();
    let rim: Vec<DVec2> = rim.iter().map(|at| space.place_flat(*at)).collect();
    let lines = with_names(&lines, &rim, sheet.letters);
    for ((step, name), line) in named.into_iter().zip(lines) {
        let [from, to] = line.ends;
        sheet.step(step, |sheet| {
            sheet.line(Look::VISITED.outline().wide(1.0), from, to);
            sheet.label(space.frame, to, line.towards, name);
        });
    }
}

impl Joined {
    /// The first two bounds below the node that is above the object of the specification, or below the root.
    fn find(figure: &Figure) -> Result<Self, FigureError> {
        let hierarchy = bound::hierarchy(figure.first)?;
        let node = match figure.object()? {
            None => 0,
            Some(object) => parent_of_leaf(&hierarchy, object),
        };
        let nodes = hierarchy.nodes().len();
        let known = |merge: &MergeStep| (merge.first.max(merge.second) as usize) < nodes;
        let merges = figure
            .first
            .building()
            .filter_map(|record| match record.event {
                Event::Merge(merge) if merge.node == node && known(&merge) => {
                    Some((record.step, merge))
                }
                _ => None,
            });
        let merges: Vec<(u32, MergeStep)> = merges.collect();
        let pair = merges.first().map(|(_, merge)| (merge.first, merge.second));
        let Some((first, second)) = pair else {
            return Err(FigureError::new(
                "scene",
                "no two bounds were joined while the hierarchy was built",
                "draw a scene with two or more objects",
            ));
        };
        let mut steps = merges;
        steps.retain(|(_, merge)| (merge.first, merge.second) == (first, second));
        let directions = hierarchy.set().directions();
        let slab = |merge: &MergeStep, d_min: f64, d_max: f64| {
            let normal = directions.get(merge.slab as usize);
            Slab {
                number: merge.slab,
                normal: normal.copied().unwrap_or(DVec3::X),
                d_min,
                d_max,
            }
        };
        let of = |part: usize| -> Vec<Slab> {
            let slabs = steps.iter().map(|(_, merge)| match part {
                2 => {
                    let (d_min, d_max) = merge.joined();
                    slab(merge, d_min, d_max)
                }
                _ => slab(merge, merge.d_min[part], merge.d_max[part]),
            });
            slabs.collect()
        };
        let mut objects = Vec::new();
        for child in [first, second] {
            objects_below(&hierarchy, child, &mut objects);
        }
        Ok(Self {
            bounds: [of(0), of(1), of(2)],
            names: [first, second].map(|node| name(figure, &hierarchy, node)),
            objects,
            steps,
        })
    }
}

/// The node whose child is the leaf of an object; the root if there is none.
fn parent_of_leaf(hierarchy: &Hierarchy<MOST_SLABS>, object: PrimitiveId) -> u32 {
    let nodes = hierarchy.nodes();
    let holds = |link: Link| match link {
        Link::Objects { first, count } => hierarchy.order()[range(first, count)].contains(&object),
        Link::Children { .. } => false,
    };
    let is_parent = |link: Link| match link {
        Link::Children { first, count } => nodes[range(first, count)]
            .iter()
            .any(|child| holds(child.link)),
        Link::Objects { .. } => false,
    };
    let found = (0..).zip(nodes).find(|(_, node)| is_parent(node.link));
    found.map_or(0, |(number, _)| number)
}

/// All objects at the leaves below a node.
fn objects_below(hierarchy: &Hierarchy<MOST_SLABS>, node: u32, found: &mut Vec<PrimitiveId>) {
    match hierarchy.nodes()[node as usize].link {
        Link::Objects { first, count } => found.extend(&hierarchy.order()[range(first, count)]),
        Link::Children { first, count } => {
            for child in first..first + count {
                objects_below(hierarchy, child, found);
            }
        }
    }
}

/// What a bound is called: the object in it, or its number.
fn name(figure: &Figure, hierarchy: &Hierarchy<MOST_SLABS>, node: u32) -> String {
    match hierarchy.nodes()[node as usize].link {
        Link::Objects { first, count: 1 } => {
            let object = hierarchy.order()[first as usize];
            scenery::name_of(figure.scene, object)
        }
        _ => format!("node {node}"),
    }
}

/// D_min and D_max of both bounds for each slab; what the bound of both takes is in a frame.
struct Table {
    /// The slab's name, then D_min of both bounds and D_max of both.
    rows: Vec<(u32, [Cell; 5])>,
    head: [String; 5],
    /// How wide each column is, and the gap before it.
    columns: [f64; 5],
    gap: f64,
}

/// A text, and whether the bound of both takes it.
#[derive(Clone, Debug, Default)]
struct Cell {
    text: String,
    is_taken: bool,
}

/// What stands above the columns of both bounds.
const HEADS: [&str; 2] = ["minimum D_min", "maximum D_max"];

impl Table {
    /// As wide as the texts; names too long for half of the frame lose their beginnings.
    fn new(sheet: &Sheet, frame: Frame, joined: &Joined, projection: &Projection) -> Self {
        let pairs = joined.steps.iter().zip(&joined.bounds[2]);
        let pairs = pairs.filter(|(_, slab)| slab.is_on_edge(projection));
        let rows = pairs.map(|((step, merge), slab)| {
            let (d_min, d_max) = merge.joined();
            let cell = |d: f64, taken: f64| Cell {
                text: quantity(d),
                is_taken: d == taken,
            };
            let name = Cell {
                text: slab.name(),
                is_taken: false,
            };
            let ([a, b], [c, d]) = (
                merge.d_min.map(|d| cell(d, d_min)),
                merge.d_max.map(|d| cell(d, d_max)),
            );
            (*step, [name, a, b, c, d])
        });
        let rows: Vec<(u32, [Cell; 5])> = rows.collect();
        let gap = 1.4 * sheet.letters;
        let widest = |column: usize| {
            let widths = rows
                .iter()
                .map(|(_, row)| sheet.width_of(&row[column].text));
            widths.fold(sheet.width_of("n"), f64::max)
        };
        let numbers: [f64; 5] = std::array::from_fn(widest);
        let most = (0.5 * frame.size().x - numbers[0]) / 4.0 - gap;
        let names = joined.names.each_ref().map(|name| {
            let room = most.max(numbers[1..].iter().copied().fold(0.0, f64::max));
            end_of_name(name, |text| sheet.width_of(text) <= room)
        });
        let [first, second] = names;
        let head = ["n".into(), first.clone(), second.clone(), first, second];
        let mut columns = std::array::from_fn(|i| numbers[i].max(sheet.width_of(&head[i])));
        for (pair, text) in [1, 3].into_iter().zip(HEADS) {
            let missing = sheet.width_of(text) - (columns[pair] + gap + columns[pair + 1]);
            for column in &mut columns[pair..pair + 2] {
                *column += 0.5 * missing.max(0.0);
            }
        }
        Self {
            rows,
            head,
            columns,
            gap,
        }
    }

    fn width(&self) -> f64 {
        // air for the last frame
        self.columns.iter().sum::<f64>() + 4.5 * self.gap
    }

    /// The right end of a column.
    fn end(&self, frame: Frame, column: usize) -> f64 {
        let columns: f64 = self.columns[..=column].iter().sum();
        frame.min.x + columns + column as f64 * self.gap
    }

    fn draw(&self, sheet: &mut Sheet, frame: Frame) {
        let line = 1.35 * sheet.line_height();
        let rows = self.rows.len() as f64 + 2.0;
        let top = frame.middle().y - 0.5 * rows * line;
        let row = |place: usize| top + (place as f64 + 0.5) * line;
        let pad = 0.35 * sheet.letters;
        for (column, text) in [2, 4].into_iter().zip(HEADS) {
            let at = DVec2::new(self.end(frame, column), row(0));
            sheet.text(Anchor::End, at, text);
        }
        for (column, text) in self.head.iter().enumerate() {
            let at = DVec2::new(self.end(frame, column), row(1));
            sheet.text(Anchor::End, at, text);
        }
        let under = top + 2.0 * line;
        let ends = [frame.min.x, self.end(frame, 4) + pad].map(|x| DVec2::new(x, under));
        sheet.line(Look::THIN, ends[0], ends[1]);
        for (place, (step, cells)) in self.rows.iter().enumerate() {
            sheet.step(*step, |sheet| {
                let y = row(place + 2);
                for (column, cell) in cells.iter().enumerate() {
                    let x = self.end(frame, column);
                    if cell.is_taken {
                        let width = sheet.width_of(&cell.text);
                        let half = DVec2::new(0.5 * width + pad, 0.75 * sheet.letters);
                        let middle = DVec2::new(x - 0.5 * width, y);
                        let (min, max) = (middle - half, middle + half);
                        sheet.rectangle(Look::VISITED, Frame { min, max });
                    }
                    sheet.text(Anchor::End, DVec2::new(x, y), cell.text.as_str());
                }
            });
        }
    }
}

/// A name, or as much of its end as fits: names that belong together differ there.
fn end_of_name(name: &str, fits: impl Fn(&str) -> bool) -> String {
    if fits(name) {
        return name.into();
    }
    let ends = name.char_indices().skip(1);
    let mut ends = ends.map(|(at, _)| format!("…{}", name[at..].trim_start()));
    ends.find(|end| fits(end)).unwrap_or_else(|| "…".into())
}

fn in_words(joined: &Joined, projection: &Projection) -> String {
    let [first, second] = &joined.names;
    let mut sentences = vec![format!(
        "The bounds of {first} and {second}, and the bound of both."
    )];
    for ((_, merge), slab) in joined.steps.iter().zip(&joined.bounds[2]) {
        if !slab.is_on_edge(projection) {
            continue;
        }
        let [a, b] = merge.d_min.map(quantity);
        let [c, d] = merge.d_max.map(quantity);
        sentences.push(format!(
            "Slab {}: D_min is the minimum of {a} and {b}, {}; D_max is the maximum of {c} and {d}, {}.",
            merge.slab,
            quantity(slab.d_min),
            quantity(slab.d_max)
        ));
    }
    sentences.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_name_keeps_its_end() {
        let fits = |most: usize| move |text: &str| text.chars().count() <= most;
        assert_eq!(end_of_name("shape face 0", fits(12)), "shape face 0");
        assert_eq!(end_of_name("shape face 0", fits(7)), "…face 0");
        assert_eq!(end_of_name("shape face 0", fits(2)), "…0");
        assert_eq!(end_of_name("shape", fits(0)), "…");
    }
}
