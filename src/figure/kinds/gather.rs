//! The photons nearest to a point, as they lie on its surface, and the density that follows from them (slides, "Type
//! of Ray Tracing Algorithm": hybrid with storage on surfaces; Jensen 1996).

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::light_path::LightPath;
use crate::figure::parts::outline::{self, Outline, Rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[Layer::Objects, Layer::Hits, Layer::Numbers],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let section = figure.section_of(figure.pixel()?)?;
    let gatherings = Gathering::all(&section);
    let with_disc = gatherings
        .iter()
        .find_map(|of| Some((of, of.gathered.radius?, of.disc(figure.scene)?)));
    let Some((gathering, radius, rim)) = with_disc else {
        return Err(FigureError::new(
            "pixel",
            "no photons were gathered at this pixel without a map",
            "add \"transport\": \"hybrid-stored\" without \"map\", and name a pixel that shows a diffuse surface",
        ));
    };
    let numbers = numbers(gathering);
    let body = if figure.shows(Layer::Numbers) {
        sheet.step(gathering.step, |sheet| sheet.lines(body, &numbers))
    } else {
        body
    };
    let space = figure.space(body, rim.iter().copied());
    let object = gathering.gathered.object;
    if figure.shows(Layer::Objects) {
        let shape = &figure.scene.primitive(object).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::draw(sheet, &space, &outline, Look::OBJECT);
        let name = scenery::name_of(figure.scene, object);
        sheet.label_in(space.frame, name);
    }
    sheet.within(space.frame, |sheet| {
        if figure.shows(Layer::Hits) {
            stored(figure, sheet, &space, gathering);
        }
        let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
        sheet.step(gathering.step, |sheet| {
            outline::rim(sheet, &space, &Rim::Points(rim), Look::ANSWER);
            photons(sheet, &space, gathering, radius);
        });
    });
    let object = scenery::name_of(figure.scene, object);
    Ok(format!(
        "Photons on {object} around the point p that the eye ray hits. {}.",
        numbers.join(", ")
    ))
}

/// The working of the density, in lines.
fn numbers(gathering: &Gathering) -> Vec<String> {
    let near = gathering.nearby.len();
    let counted = gathering.gathered.count;
    let mut lines = vec![format!(
        "Of the {near} nearest photons {counted} are summed: the last one is where the disc ends"
    )];
    lines.extend(gathering.working());
    lines
}

/// All photons on the surface that the shown paths have left.
fn stored(figure: &Figure, sheet: &mut Sheet, space: &Space, gathering: &Gathering) {
    let sections = figure.first.paths();
    for path in sections.iter().filter_map(LightPath::of) {
        for leg in &path.legs {
            let Some(photon) = leg.stored else {
                continue;
            };
            let is_near = |point: DVec3| gathering.nearby.iter().any(|(_, of)| of.point == point);
            if photon.object != gathering.gathered.object || is_near(photon.point) {
                continue;
            }
            sheet.step(leg.step, |sheet| {
                let radius = 2.0 * sheet.unit();
                let look = Look::THIN.inside().full();
                sheet.circle(look, space.place(photon.point), radius);
            });
        }
    }
}

/// The point, the photons around it and how far the last of them is.
fn photons(sheet: &mut Sheet, space: &Space, gathering: &Gathering, radius: f64) {
    let at = space.place(gathering.gathered.point);
    let counted = gathering.counted().len();
    for (place, (step, photon)) in gathering.nearby.iter().enumerate() {
        let to = space.place(photon.point);
        if place < counted {
            sheet.step(*step, |sheet| sheet.dot(Look::ANSWER, to));
            continue;
        }
        sheet.step(gathering.step, |sheet| {
            sheet.line(Look::HELP, at, to);
            sheet.ring(Look::REJECTED, to);
            let middle = at.lerp(to, 0.5);
            let across = (to - at).perp().normalize_or_zero();
            sheet.label(
                space.frame,
                middle,
                across,
                format!("r = {}", quantity(radius)),
            );
            let outwards = (to - at).normalize_or_zero();
            sheet.label(space.frame, to, outwards, "does not count");
        });
    }
    sheet.step(gathering.step, |sheet| {
        sheet.cross(Look::RAY, at);
        sheet.label(space.frame, at, DVec2::new(-1.0, 1.0), "p");
    });
}
