//! The normal of a sphere at a hit, with its working.

use glam::DVec2;

use crate::explain::MINUS;
use crate::figure::error::FigureError;
use crate::figure::kinds::sphere::argument::Argument;
use crate::figure::kinds::sphere::solved::Solved;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;

/// The normal at the hit, as it was computed for the shade.
pub(super) fn draw(sheet: &mut Sheet, space: &Space, solved: &Solved, argument: &Argument) {
    let Some((shade, _)) = solved.shade else {
        return;
    };
    let (at, along) = (space.place(shade.point), space.direction(shade.normal));
    let tip = at + space.scale * along;
    sheet.at(argument.normal, |sheet| {
        sheet.arrow(Look::ANSWER.outline(), at, tip);
        sheet.label(space.frame, tip, along, formula("N"));
    });
}

/// N = (p − center)/r with its numbers.
pub(super) fn working(figure: &Figure, solved: &Solved) -> Result<Vec<Text>, FigureError> {
    let (shade, _) = solved.shade.ok_or_else(|| {
        FigureError::new(
            "show",
            format!(
                "{} is not shaded by this ray, so it has no normal there",
                scenery::name_of(figure.scene, solved.id)
            ),
            "name a pixel in which it is the nearest object, or omit normals",
        )
    })?;
    let turned = if shade.back { "−" } else { "" };
    let mut lines = vec![formula("N = ") + turned + formula("((x - a)/r, (y - b)/r, (z - c)/r)")];
    if figure.shows(Layer::Numbers) {
        let (p, center) = (shade.point.to_array(), solved.sphere.center.to_array());
        let r = quantity(solved.sphere.radius);
        let parts = [0, 1, 2].map(|i| {
            let sign = if center[i] < 0.0 { '+' } else { MINUS };
            format!("{} {sign} {}", quantity(p[i]), quantity(center[i].abs()))
        });
        lines.push(formula("N = ") + turned + format!("({})/{r}", parts.join(", ")));
        lines.push(formula("N = ") + coordinates(shade.normal));
        lines.push(formula("|N| = 1"));
    }
    Ok(lines)
}

/// Where a block of lines stands in a frame: in a corner that the sphere and the ray leave free, the lower ones first.
pub(super) fn free_corner(
    sheet: &Sheet,
    frame: Frame,
    space: &Space,
    solved: &Solved,
    lines: &[Text],
) -> Option<Frame> {
    let widths = lines.iter().map(|line| sheet.width_of(line));
    let size = DVec2::new(
        widths.fold(0.0, f64::max),
        lines.len() as f64 * sheet.line_height(),
    );
    let middle = space.place(solved.sphere.center);
    let radius = space.scale * solved.sphere.radius + sheet.letters;
    let ends = [0.0, solved.nearest()].map(|t| space.place(solved.ray.at(t)));
    let [a, b, c, d] = frame.corners();
    let corners = [
        (d, DVec2::new(0.0, -1.0)),
        (c, DVec2::NEG_ONE),
        (a, DVec2::ZERO),
        (b, DVec2::new(-1.0, 0.0)),
    ];
    corners.into_iter().find_map(|(corner, back)| {
        let min = corner + back * size;
        let block = Frame {
            min,
            max: min + size,
        };
        let is_free = radius < block.nearest(middle).distance(middle)
            && block.wider(2.0 * sheet.letters).cut_line(ends).is_none();
        is_free.then_some(block)
    })
}

/// Writes the lines from the upper left of a frame down.
pub(super) fn write(sheet: &mut Sheet, block: Frame, lines: Vec<Text>, argument: &Argument) {
    let height = sheet.line_height();
    sheet.at(argument.normal, |sheet| {
        for (number, line) in lines.into_iter().enumerate() {
            let down = DVec2::new(0.0, (number as f64 + 0.5) * height);
            sheet.text(Anchor::Start, block.min + down, line);
        }
    });
}
