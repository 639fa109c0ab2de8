//! How the structure was built, if that was recorded.

use std::cell::OnceCell;

use crate::explain::number::count;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::leaves::Leaves;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::{cells, nodes};
use crate::trace::Event;

/// The number of steps that are shown, unless all are asked for: more lines than a screen has would hide the pixel.
const SHOWN: usize = 24;

/// The steps of the building, in the order in which they were taken.
pub(super) fn building(context: &Context, page: &mut Pen) {
    let built: Vec<(Event, Extent)> = context
        .records
        .iter()
        .enumerate()
        .map(|(at, record)| (record.event, context.at(at)))
        .filter(|(event, _)| context.shows(event.kind()))
        .collect();
    if built.is_empty() {
        return;
    }
    let most = if context.options.all {
        built.len()
    } else {
        SHOWN
    };
    let shown = most.min(built.len());
    let (shown, hidden) = built.split_at(shown);
    page.gap();
    if page.writes(context.at(0)) {
        page.titled(Part::Building, ", before the first ray");
    }
    page.of_part(Part::Building, |page| {
        page.indented(|page| {
            let leaves = OnceCell::new();
            for (event, extent) in shown {
                page.telling(*extent, |page| match event {
                    Event::Merge(step) => {
                        let leaves = leaves.get_or_init(|| Leaves::of(context));
                        nodes::merge(context, step, leaves, page);
                    }
                    Event::Assign(step) => cells::assign(context, step, page),
                    // a section of the building holds no others
                    _ => {}
                });
            }
            if let Some(extent) = Extent::around(hidden.iter().map(|(_, extent)| *extent)) {
                let text = format!("… {}", count(hidden.len(), "more step"));
                page.telling(extent, |page| page.folded(hidden.len(), text));
            }
        });
    });
}
