//! The title of a solution: which pixel of which scene, and how it was traced.

use crate::explain::number::count;
use crate::explain::number::{Digits, grouped};
use crate::explain::page::Tone;
use crate::explain::printable;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::trace::{Settings, StrategyName, Transport};

/// Which pixel, and how it was traced.
pub(super) fn title(context: &Context, page: &mut Pen) {
    let [width, height] = context.scene.camera.pixels;
    let mut title = String::from("Pixel");
    if let Some([x, y]) = context.pixel {
        title = format!("Pixel ({x}, {y})");
    }
    if !context.scene.name.is_empty() {
        title = format!("{title} of \"{}\"", printable(&context.scene.name));
    }
    page.line(Tone::Heading, title);
    let transport = match context.settings.transport {
        Transport::Backward => "backward without shadow rays",
        Transport::HybridLight => "backward with shadow rays to the lights",
        Transport::Forward => "forward from the lights into the eye",
        Transport::HybridStored => "forward with photons stored on the surfaces, then backward",
        Transport::HybridConnected => "forward and backward with connecting lines",
    };
    let objects = context.scene.primitives.len();
    let depth = match context.settings.transport {
        // Russian roulette ends their paths
        Transport::Forward | Transport::HybridConnected => String::new(),
        _ => format!(", depth up to {}", context.scene.max_depth),
    };
    let sides = if context.settings.one_sided {
        "; of opaque surfaces only the front is visible"
    } else {
        ""
    };
    page.line(
        Tone::Aside,
        format!(
            "{width} × {height} pixels, traced {transport}, each ray tested against {}{}\
                 {depth}{sides}",
            count(objects, "object"),
            how(context.settings)
        ),
    );
    if let Some(light) = how_light_is_followed(context) {
        page.line(Tone::Aside, light);
    }
    if matches!(
        context.settings.strategy,
        StrategyName::Bounds | StrategyName::Hierarchy | StrategyName::Heap | StrategyName::Grid
    ) {
        let note = "bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit";
        page.line(Tone::Aside, note);
    }
    if let Some(only) = &context.settings.only {
        let note = format!("the log holds only: {}", only.join(", "));
        page.line(Tone::Aside, note);
    }
}

/// Seed, number of paths, and the transport's own options; `None` where no light is traced.
fn how_light_is_followed(context: &Context) -> Option<String> {
    let d = Digits::USUAL;
    let (camera, light) = (&context.scene.camera, &context.settings.light);
    let own = match context.settings.transport {
        Transport::Backward | Transport::HybridLight => return None,
        Transport::Forward => {
            let radius = d.number(light.aperture_radius(camera));
            format!("the eye is an aperture of radius {radius}")
        }
        Transport::HybridStored => match light.map {
            Some(cells) => format!(
                "stored in maps with {cells} cells along the longer side of a flat face; on curved surfaces the \
                     {} nearest photons are gathered",
                light.nearest
            ),
            None => format!("the {} nearest photons are gathered", light.nearest),
        },
        Transport::HybridConnected => format!(
            "{} for each pixel, each connected with its own path of light",
            count(light.samples as usize, "eye path")
        ),
    };
    let paths = context.settings.light_paths(camera.pixels);
    let bounces = light.bounces.map_or(String::new(), |most| {
        format!(", each with at most {}", count(most as usize, "surface"))
    });
    Some(format!(
        "{} paths of light{bounces}, seed {}; {own}",
        grouped(paths),
        light.seed
    ))
}

/// Which of the objects a ray is tested against.
fn how(settings: &Settings) -> &'static str {
    match settings.strategy {
        StrategyName::Exhaustive => "",
        StrategyName::Bounds => " whose bounding volume it hits",
        StrategyName::Hierarchy => " in a hierarchy, traversed depth first",
        StrategyName::Heap => " in a hierarchy, traversed in the order of distance",
        StrategyName::Grid => " in the cells of a grid",
        StrategyName::ZAligned => " in a frame in which it is the z axis",
    }
}
