//! A hierarchy that grows bottom-up beside a grid that divides top-down (slides, "Spatial Partitioning"): the first joins
//! objects, then volumes, until one is left; the second begins with one box around all and cuts it.

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::bound;
use crate::figure::parts::outline;
use crate::figure::parts::plan::{EMPTY, Lattice, depth_axis};
use crate::figure::parts::scenery;
use crate::figure::parts::walk::Walk;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::{StageId, parts};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::subject::{DrawnRay, Figure, records_in};
use crate::figure::traced::Traced;
use crate::figure::view::Space;
use crate::structure::AssignStep;
use crate::trace::{Event, StrategyName};
use glam::DVec2;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[],
    more: &[],
};

/// The cuts: one box, across one axis, across the other, and the lists.
const CUTS: usize = 4;

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let of = |strategy: StrategyName| {
        let mut traced = figure.traced.iter();
        traced.find(|of| of.settings.strategy == strategy)
    };
    let (Some(grown), Some(cut)) = (of(StrategyName::Hierarchy), of(StrategyName::Grid)) else {
        return Err(FigureError::new(
            "strategies",
            "this kind of figure compares a hierarchy with a grid",
            "add \"strategies\": [\"hierarchy\", \"grid\"]",
        ));
    };
    let depth = depth_axis(figure)?;
    let merged = merged(grown);
    let ray = DrawnRay::find(records_in(cut, figure.pixel()?)?, 0)?;
    let walk = Walk::of(&ray, figure.scene)?;
    let lattice = Lattice::of(&walk.grid);
    let [a, b] = [(depth + 1) % 3, (depth + 2) % 3];
    let names = ["x", "y", "z"];
    let n = lattice.resolution;
    let cells: u32 = n.iter().product();

    let objects = figure.scene.objects.len();
    let there = sheet.stage("objects", None, format!("{objects} objects."));
    let of_cuts = [
        "Top-down: all objects lie in one box.".to_owned(),
        format!("It is cut into {} along {}.", n[a], names[a]),
        format!("And into {} along {}: {cells} cells.", n[b], names[b]),
        "Each object is put on the list of every cell that it is in.".to_owned(),
    ];
    let groups = parts(merged.len(), CUTS);
    let mut joined = 0;
    let mut stages: Vec<StageId> = Vec::new();
    let mut told = Vec::new();
    for (place, of_cut) in of_cuts.iter().enumerate() {
        let of_group = groups.get(place).cloned().unwrap_or(joined..joined);
        joined = of_group.end;
        let left = match merged.len() - joined {
            0 => "one volume is around all".to_owned(),
            _ if joined == 1 => "1 pair is joined".to_owned(),
            _ => format!("{joined} pairs are joined"),
        };
        let sentence = format!("Bottom-up: {left}. {of_cut}");
        stages.push(sheet.stage(format!("step {}", place + 1), None, sentence.as_str()));
        told.push(sentence);
    }

    let entries = [
        (
            Some(stages[0]),
            Look::VISITED.outline(),
            "volume, numbered as built",
        ),
        (Some(stages[3]), EMPTY, "cell with a list"),
    ];
    let body = sheet.staged_legend(body, &entries);
    let heads = ["bottom-up: a hierarchy", "top-down: a grid"];
    let panels = body.split(0.5, 2.0 * sheet.letters);
    for (place, (panel, head)) in panels.into_iter().zip(heads).enumerate() {
        let [above, panel] = panel.split_top(1.3 * sheet.line_height());
        let at = DVec2::new(above.middle().x, above.min.y + 0.5 * sheet.line_height());
        sheet.text(Anchor::Middle, at, head);
        let space = figure.space(panel.wider(-4.0 * sheet.unit()), lattice.box_corners());
        if place == 1 {
            sheet.at(stages[3], |sheet| {
                for cell in listed(cut) {
                    if let Some(area) = lattice.area(cell, &space) {
                        sheet.rectangle(EMPTY, area);
                    }
                }
            });
        }
        sheet.at(there, |sheet| {
            scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
            scenery::names(figure, sheet, &space);
        });
        if place == 0 {
            volumes(sheet, &space, grown, (&merged, &groups, &stages))?;
        } else {
            cuts(sheet, &space, &lattice, [a, b], &stages);
        }
    }
    Ok(format!("{objects} objects. {}", told.join(" ")))
}

/// The nodes in the order in which their volumes are made.
fn merged(traced: &Traced) -> Vec<u32> {
    let mut nodes: Vec<u32> = Vec::new();
    for record in traced.building() {
        if let Event::Merge(merge) = record.event
            && !nodes.contains(&merge.node)
        {
            nodes.push(merge.node);
        }
    }
    nodes
}

/// The cells with a list that is not empty.
fn listed(traced: &Traced) -> Vec<[u32; 3]> {
    let mut cells: Vec<[u32; 3]> = traced
        .building()
        .filter_map(|record| match record.event {
            Event::Assign(AssignStep { cell, .. }) => Some(cell),
            _ => None,
        })
        .collect();
    cells.sort_unstable();
    cells.dedup();
    cells
}

/// The volumes, each a little outside of those in it, with its number.
fn volumes(
    sheet: &mut Sheet,
    space: &Space,
    traced: &Traced,
    (merged, groups, stages): (&[u32], &[std::ops::Range<usize>], &[StageId]),
) -> Result<(), FigureError> {
    /// Between a volume and those in it, in units of a book's sheet.
    const LEVEL: f64 = 2.0;
    let hierarchy = bound::hierarchy(traced)?;
    for (place, &node) in merged.iter().enumerate() {
        let Some(of) = hierarchy.nodes().get(node as usize) else {
            continue;
        };
        let slabs = bound::slabs(hierarchy.set(), &of.bound);
        let outline = bound::outline(&slabs, &space.projection);
        let points = outline.rim.points().into_iter();
        let Some(around) = Frame::around(points.map(|point| space.place_flat(point))) else {
            continue;
        };
        let around = around.wider(LEVEL * sheet.unit() * place as f64 / merged.len() as f64);
        let group = groups.iter().position(|of| of.contains(&place));
        sheet.at(stages[group.unwrap_or(0)], |sheet| {
            sheet.rectangle(Look::VISITED.outline(), around);
            sheet.label_in(around, (place + 1).to_string());
        });
    }
    Ok(())
}

/// The box, then the planes across each axis.
fn cuts(
    sheet: &mut Sheet,
    space: &Space,
    lattice: &Lattice,
    [a, b]: [usize; 2],
    stages: &[StageId],
) {
    let n = lattice.resolution;
    let whole = lattice.whole(&space.projection);
    sheet.at(stages[0], |sheet| {
        outline::rim(sheet, space, &whole.rim, Look::VISITED.outline().wide(2.5));
    });
    for (stage, (across, along)) in [(1, (a, b)), (2, (b, a))] {
        sheet.at(stages[stage], |sheet| {
            for place in 1..n[across] {
                let end = |to: u32| {
                    let mut at = [0; 3];
                    (at[across], at[along]) = (place, to);
                    space.projection.of(lattice.corner(at))
                };
                let line = [end(0), end(n[along])];
                outline::line_on(sheet, space, Look::VISITED.outline(), &line);
            }
        });
    }
}
