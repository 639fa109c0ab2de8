//! The normal on both sides of a surface: where rays hit a sphere from outside and from inside, and a polygon from its front
//! and from its back. The sign of Δ·N of the surface's own normal says which side it is; on the back N is turned round.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::Ray;
use crate::scene::Shape;
use crate::trace::{Event, Item, Purpose, RayTree, Shade};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 380.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Eye],
    more: &[],
};

/// A hit, and the ray that made it.
struct Met {
    ray: Ray,
    purpose: Purpose,
    shade: Shade,
    is_sphere: bool,
    name: String,
}

impl Met {
    /// The surface's own normal: outwards, or (A, B, C).
    fn own(&self) -> DVec3 {
        if self.shade.back {
            -self.shade.normal
        } else {
            self.shade.normal
        }
    }

    fn cosine(&self) -> f64 {
        self.ray.direction.dot(self.own())
    }

    fn side(&self) -> &'static str {
        match (self.is_sphere, self.shade.back) {
            (true, false) => "from outside",
            (true, true) => "from inside",
            (false, false) => "from the front",
            (false, true) => "from the back",
        }
    }

    /// What happens to the normal.
    fn so(&self) -> &'static str {
        if self.shade.back {
            "N is turned"
        } else {
            "N as it is"
        }
    }

    fn sentence(&self) -> String {
        let sign = if self.shade.back { "above" } else { "below" };
        format!(
            "The ray hits {} {}: Δ·{} = {} is {sign} 0, so {}.",
            self.name,
            self.side(),
            self.letters(),
            quantity(self.cosine()),
            self.so()
        )
    }

    fn letters(&self) -> &'static str {
        if self.is_sphere {
            "(p − c)/r"
        } else {
            "(A, B, C)"
        }
    }

    /// From which side the ray comes, and below it the sign that says so.
    fn rows(&self, number: usize, width: Width) -> [Text; 2] {
        let sign = if self.shade.back { " > 0" } else { " < 0" };
        let product = match (width, self.is_sphere) {
            (Width::Slide, _) => Text::default(),
            (Width::Book, true) => formula("Δ·(p - c)/r = "),
            (Width::Book, false) => formula("Δ·(A, B, C) = "),
        };
        let sign = product + quantity(self.cosine()) + sign + ": " + formula("N");
        [
            format!("{number}  {}", self.side()).into(),
            sign + self.so().trim_start_matches('N'),
        ]
    }
}

/// The surface's own normal where it is turned, and N.
const OWN: Look = Look::REJECTED.outline().wide(1.25);
const NORMAL: Look = Look::ANSWER.outline();

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let mut all = Vec::new();
    for pixel in figure.pixels() {
        all.extend(met_in(figure, pixel)?);
    }
    if all.is_empty() {
        figure.pixel()?;
        return Err(FigureError::new(
            "pixels",
            "the rays of these pixels hit no object",
            "name pixels that show an object",
        ));
    }
    let hits = match all.len() {
        1 => "A ray hits a surface.".into(),
        count => format!("Rays hit surfaces at {count} points."),
    };
    let rays = sheet.stage(Part::Ray, None, hits);
    let stages: Vec<StageId> = all
        .iter()
        .map(|met| sheet.stage(Part::Normal, None, met.sentence()))
        .collect();
    let turned = all.iter().position(|met| met.shade.back);
    let first = stages.first().copied();
    let entries = [
        (first, NORMAL, formula("N")),
        (
            turned.map(|at| stages[at]),
            OWN,
            Text::from("the surface's own normal, where ") + formula("N") + " is turned",
        ),
    ];
    let shown = if turned.is_some() { 2 } else { 1 };
    let body = sheet.staged_legend(body, &entries[..shown]);
    let share = match sheet.width {
        Width::Book => 0.55,
        Width::Slide => 0.52,
    };
    let [left, right] = body.split(share, 1.5 * sheet.letters);
    let points = scenery::points_of(figure);
    // the arrows of normals stand out
    let space = figure.space(left.wider(-1.5 * sheet.letters), points);
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    scenery::camera_and_lights(figure, sheet, &space);
    let mut rest = right;
    let rows = all.iter().zip(&stages);
    for (place, (met, stage)) in rows.enumerate() {
        sheet.at(rays, |sheet| ray(sheet, &space, met));
        sheet.at(*stage, |sheet| normals(sheet, &space, met, place + 1));
        let rows = met.rows(place + 1, sheet.width);
        rest = sheet.at(*stage, |sheet| sheet.lines(rest, &rows));
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    let sentences: Vec<String> = all.iter().map(Met::sentence).collect();
    Ok(sentences.join(" "))
}

/// The hits of a pixel's rays, in their order.
fn met_in(figure: &Figure, pixel: [u32; 2]) -> Result<Vec<Met>, FigureError> {
    let records = figure.records_of(pixel)?;
    let tree = RayTree::new(records);
    let met = tree.rays.iter().filter_map(|node| {
        let start = node.start?;
        let shade = node.items.iter().find_map(|item| match item {
            Item::Event(at) => match records[*at].event {
                Event::Shade(shade) => Some(shade),
                _ => None,
            },
            Item::Ray(_) => None,
        })?;
        let shape = &figure.scene.primitive(shade.object).shape;
        Some(Met {
            ray: start.ray,
            purpose: start.purpose,
            shade,
            is_sphere: matches!(shape, Shape::Sphere(_)),
            name: scenery::name_of(figure.scene, shade.object),
        })
    });
    Ok(met.collect())
}

/// The ray up to its hit.
fn ray(sheet: &mut Sheet, space: &Space, met: &Met) {
    let (from, at) = (space.place(met.ray.origin), space.place(met.shade.point));
    let look = match met.purpose {
        Purpose::Refracted => Look::REFRACTED_RAY,
        Purpose::Reflected => Look::REFLECTED_RAY,
        _ => Look::RAY,
    };
    sheet.arrow(look, from, from.lerp(at, 0.6));
    sheet.line(look, from.lerp(at, 0.6), at);
    sheet.dot(Look::RAY, at);
}

/// The number of a hit, and the normals there.
fn normals(sheet: &mut Sheet, space: &Space, met: &Met, number: usize) {
    /// How long a normal is, in letters.
    const LENGTH: f64 = 3.0;
    let (from, at) = (space.place(met.ray.origin), space.place(met.shade.point));
    let length = LENGTH * sheet.letters;
    let [normal, own] = [met.shade.normal, met.own()].map(|of| space.direction(of));
    if met.shade.back {
        sheet.arrow(OWN, at, at + length * own);
    }
    sheet.arrow(NORMAL, at, at + length * normal);
    sheet.label(space.frame, at + length * normal, normal, formula("N"));
    // off the ray, on the side where nothing is drawn
    let along = (at - from).normalize_or_zero();
    sheet.label(space.frame, at, along.perp() - normal, number.to_string());
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack};

    #[test]
    fn a_polygon_that_shows_its_back_has_its_normal_turned_towards_the_eye() {
        // both stand across the ray, which comes along x: one is seen from its front, then its like in the opposite order
        let spec = || json!({"kind": "sides", "view": "front"});
        let pane = |vertices: [[f64; 3]; 4]| json!([{ "name": "P", "material": "m", "shape": { "polygon": { "vertices": vertices } } }]);
        let corners = [
            [0.0, -1.0, -1.0],
            [0.0, -1.0, 1.0],
            [0.0, 1.0, 1.0],
            [0.0, 1.0, -1.0],
        ];
        let mut turned = corners;
        turned.reverse();
        let mut told = Vec::new();
        for vertices in [corners, turned] {
            let (drawn, _) = ReadBack::of_ray_along_x(&pane(vertices), spec());
            // N goes to the left on both: its tip is the first point of its head
            let heads = drawn.paths("answer");
            let tip = heads.iter().find(|points| points.len() == 3).unwrap()[0];
            let at = drawn
                .dots("ink")
                .into_iter()
                .map(|dot| dot.x)
                .fold(0.0, f64::max);
            assert!((at - tip.x - 42.0).abs() < DRAWN, "{tip} {at}");
            let has_own = !drawn.paths("rejected").is_empty();
            told.push((has_own, drawn.texts().join(" ")));
        }
        told.sort_by_key(|(has_own, _)| *has_own);
        let [(false, front), (true, back)] = &told[..] else {
            panic!("{told:?}");
        };
        assert!(
            front.contains("from the front") && front.contains("−1 < 0"),
            "{front}"
        );
        assert!(
            back.contains("from the back") && back.contains("1 > 0"),
            "{back}"
        );
    }
}
