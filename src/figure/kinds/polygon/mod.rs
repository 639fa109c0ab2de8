//! A ray and a polygon, projected along an axis (Fig. 15.57): in space, and in true shape with the half-line from p′
//! and the edges that it crosses.
//!
//! With `drop` the projection is along another axis than the test's, which makes it smaller: its area is that of the
//! polygon times |A|, |B| or |C|. A ray parallel to the plane is drawn with the distance that it keeps.

mod argument;
mod beside_plane;
mod in_space;
mod tested;
mod true_shape;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::polygon::argument::Argument;
use crate::figure::kinds::polygon::tested::{Tested, verdict};
use crate::figure::parts::axes;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::{DroppedAxis, Layer};
use crate::figure::subject::Figure;
use crate::geometry::Axis;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 350.0,
    usual: &[Layer::Projection],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let tested = Tested::find(figure)?;
    let name = scenery::name_of(figure.scene, tested.id);
    let Some((test, _)) = tested.point else {
        return Ok(beside_plane::draw(figure, sheet, body, &tested, &name));
    };
    let chosen = test.dropped;
    let along = figure.spec.drop.map_or(chosen, axis_of);
    let argument = Argument::new(sheet, &tested, &name, along);
    let mut left = body;
    if figure.shows(Layer::Projection) {
        // the drawing in space comes first; the letters of a slide need a wider column beside it
        let share = match sheet.width {
            Width::Book => 0.56,
            Width::Slide => 0.5,
        };
        let [space, flat] = body.split(share, 2.0 * sheet.letters);
        if along == chosen {
            true_shape::draw(sheet, flat, &tested, &argument);
        } else {
            true_shape::draw_two(sheet, flat, &tested, along, &argument);
        }
        left = space;
    }
    in_space::draw(figure, sheet, left, &tested, along, &argument);

    let compared = if along == chosen {
        String::new()
    } else {
        let normal = tested.plane.0.plane.normal;
        let [other, own] = [along, chosen].map(|axis| quantity(axis.of(normal).abs()));
        format!(
            " If {} is dropped instead, the projection has {other} of the polygon's area, not {own}.",
            axes::letter(along)
        )
    };
    Ok(format!(
        "The ray hits the plane of {name} in p. Of A, B and C, {} has the largest absolute value, {}, so the test \
         drops {}. {}.{compared}",
        axes::coefficient(chosen),
        quantity(test.coefficient.abs()),
        axes::letter(chosen),
        verdict(&test)
    ))
}

fn axis_of(dropped: DroppedAxis) -> Axis {
    match dropped {
        DroppedAxis::X => Axis::X,
        DroppedAxis::Y => Axis::Y,
        DroppedAxis::Z => Axis::Z,
    }
}
