//! A ray and a sphere: the roots of equation (iii), the parabola that they are the zeros of, the normal
//! (slides, "Computing Intersection").
//!
//! The left part is exact if the ray and the center lie in the plane that the view shows.

mod argument;
mod equation;
mod in_space;
mod normal;
mod solved;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::sphere::argument::{Argument, Shown};
use crate::figure::kinds::sphere::solved::Solved;
use crate::figure::parts::{parabola, scenery};
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::geometry::Roots;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 360.0,
    usual: &[Layer::Parabola, Layer::Numbers],
    more: &[Layer::Normals],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let solved = Solved::find(figure)?;
    let name = scenery::name_of(figure.scene, solved.id);
    let shown = Shown {
        equation: figure.shows(Layer::Parabola),
        normal: figure.shows(Layer::Normals),
    };
    let argument = Argument::new(sheet, &solved, &name, shown);
    let mut left = body;
    if shown.equation {
        // the picture in space comes first; the letters of a slide need a wider column beside it
        let share = match sheet.width {
            Width::Book => 0.58,
            Width::Slide => 0.61,
        };
        let [space, plot] = body.split(share, 2.0 * sheet.letters);
        equation::draw(figure, sheet, plot, &solved, &argument);
        left = space;
    }
    let mut space = in_space::space(figure, left, &solved);
    if shown.normal {
        let working = normal::working(figure, &solved)?;
        let free = normal::free_corner(sheet, left, &space, &solved, &working);
        let block = free.unwrap_or_else(|| {
            let height = working.len() as f64 * sheet.line_height();
            let [above, below] = left.split_top(left.size().y - height);
            space = in_space::space(figure, above, &solved);
            below
        });
        normal::write(sheet, block, working, &argument);
        normal::draw(sheet, &space, &solved, &argument);
    }
    in_space::draw(figure, sheet, &space, &solved, &argument);
    Ok(in_words(figure, &solved))
}

/// The test in words.
fn in_words(figure: &Figure, solved: &Solved) -> String {
    let name = scenery::name_of(figure.scene, solved.id);
    let roots: Vec<String> = parabola::roots(&solved.test)
        .into_iter()
        .map(|(name, root)| format!("{name} = {}, {}", quantity(root.t), solved.why(root)))
        .collect();
    let discriminant = parabola::discriminant(&solved.test);
    let found = match solved.test.roots {
        Roots::None => format!(
            "The discriminant is {discriminant}: no real root, the parabola does not reach the axis, \
             and the ray misses the sphere."
        ),
        Roots::Graze(_) | Roots::Linear(_) => format!(
            "The discriminant is 0 within rounding: one root, the parabola touches the axis. {}.",
            roots.join("; ")
        ),
        Roots::Two { .. } => format!(
            "The discriminant is {discriminant}: two roots. {}.",
            roots.join("; ")
        ),
    };
    let normal = solved.shade.filter(|_| figure.shows(Layer::Normals));
    let normal = normal.map(|(shade, _)| format!(" The normal is {}.", coordinates(shade.normal)));
    let lies = if solved.starts_inside() {
        " The ray starts inside.".into()
    } else {
        let distance = quantity(solved.distance());
        format!(" The ray passes the centre at a distance of {distance}.")
    };
    format!(
        "A ray and the sphere {name}, centre {}, radius {}.{lies} {found}{}",
        coordinates(solved.sphere.center),
        quantity(solved.sphere.radius),
        normal.unwrap_or_default()
    )
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::{Ray, Sides, Sphere, TRange};
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::trace::{Event, PixelSample, RayEnd, RayStart};

    /// A ball of radius 1.5 at (4, 0, 1.5), and a ray from the origin.
    fn drawn(direction: [f64; 3]) -> ReadBack {
        let ball = Sphere {
            center: DVec3::new(4.0, 0.0, 1.5),
            radius: 1.5,
        };
        let scene = scene_of(&[sphere(ball.center.to_array(), ball.radius)]);
        let ray = Ray::new(DVec3::ZERO, direction.into());
        let test = ball.test(&ray, TRange::FORWARD, Sides::Both);
        let start = RayStart {
            ray,
            ..RayStart::default()
        };
        let object = PrimitiveId(0);
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(start)),
            (Some(0), Event::SphereTest { object, test }),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        ReadBack::of(
            json!({"kind": "sphere", "pixel": [0, 0]}),
            traced(scene, events),
        )
    }

    /// The point in space, and the one on the axis beside it.
    #[track_caller]
    fn from_left(mut points: Vec<DVec2>) -> [DVec2; 2] {
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        points.try_into().unwrap()
    }

    #[test]
    fn the_roots_lie_on_the_ray_and_on_the_axis_at_their_t() {
        // t₁ = 3.2 and t₂ = 5 by hand: 8.2/2 ∓ √3.24/2
        let drawn = drawn([0.8, 0.0, 0.6]);
        let [hit, on_axis] = from_left(drawn.dots("answer"));
        let [farther, farther_on_axis] = from_left(drawn.crosses("rejected"));
        // from above the ray falls by 3 on 4 to the right; from 3.2 to 5 it is 1.8 long
        let along = farther - hit;
        assert!((along.y / along.x - 0.75).abs() < 1e-3, "{along}");
        let origin = hit - along * 3.2 / 1.8;
        let near = |at: &DVec2| at.distance(origin) < 0.05;
        assert!(drawn.dots("ink").iter().any(near), "no origin at {origin}");
        // on the axis 0 is where the other axis crosses it, at the left end of none of the curve's points
        assert!((on_axis.y - farther_on_axis.y).abs() < 0.02);
        let zero = on_axis.x - (farther_on_axis.x - on_axis.x) * 3.2 / 1.8;
        let is_axis =
            |line: &Vec<DVec2>| line.len() == 2 && line.iter().all(|at| (at.x - zero).abs() < 0.05);
        assert!(drawn.paths("ink").iter().any(is_axis), "no axis at {zero}");
    }

    #[test]
    fn a_ray_that_misses_shows_its_distance_and_no_root() {
        let drawn = drawn([0.96, 0.0, -0.28]);
        assert!(drawn.dots("answer").is_empty() && drawn.crosses("rejected").is_empty());
        // |(4, 1.5) × (0.96, −0.28)| = 1.44 + 1.12
        let texts = drawn.texts();
        assert!(texts.contains(&"d = 2.56 > r".into()), "{texts:?}");
    }
}
