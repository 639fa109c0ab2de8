//! Balls at the rim of a wide picture look like eggs: the picture with the parts that a narrower view angle shows, and from
//! above the eye, the window and the cones in which the balls are seen.
//!
//! The cone around a ball that is seen with half the angle α, at the angle φ to the line of sight, cuts the window in an
//! ellipse whose axes are as cos α : √(cos²φ − sin²α). It is widest where φ is largest; from the COP it looks like a circle.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::picture;
use crate::figure::parts::scenery;
use crate::figure::parts::turn::at_angle;
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::Text;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::scene::{Camera, Shape};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 520.0,
    usual: &[],
    more: &[],
};

/// A ball as the eye sees it.
struct Seen {
    name: String,
    /// Towards its center, and how far it is.
    towards: DVec3,
    distance: f64,
    radius: f64,
    /// φ, from the line of sight, and α, half of the angle that it fills.
    angle: f64,
    half: f64,
}

impl Seen {
    /// The long axis of its image, over the short one.
    fn stretch(&self) -> f64 {
        let [cos, sin] = [libm::cos(self.angle), libm::sin(self.half)];
        libm::cos(self.half) / (cos * cos - sin * sin).max(0.0).sqrt()
    }

    fn said(&self) -> String {
        format!("{} : 1", brief(self.stretch()))
    }
}

/// The eye, looking straight at the window.
struct Eye {
    sight: DVec3,
    across: DVec3,
    /// From the COP to the window, along the line of sight.
    distance: f64,
    /// Half of the view angle, to the left and to the right.
    half: f64,
}

impl Eye {
    fn of(camera: &Camera) -> Self {
        let normal = camera.window_normal();
        let distance = camera.to_corner.dot(normal);
        Self {
            sight: normal * distance.signum(),
            across: camera.right.normalize_or_zero(),
            distance: distance.abs(),
            half: libm::atan(0.5 * camera.right.length() / distance.abs()),
        }
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let camera = &figure.scene.camera;
    let eye = Eye::of(camera);
    let balls: Vec<Seen> = figure
        .scene
        .objects
        .iter()
        .filter_map(|object| match figure.scene.primitive(object.first).shape {
            Shape::Sphere(ball) => {
                let from_eye = ball.center - camera.cop;
                let distance = from_eye.length();
                let towards = from_eye / distance;
                Some(Seen {
                    name: scenery::short(&object.name),
                    towards,
                    distance,
                    radius: ball.radius,
                    angle: libm::acos(towards.dot(eye.sight).clamp(-1.0, 1.0)),
                    half: libm::asin((ball.radius / distance).min(1.0)),
                })
            }
            _ => None,
        })
        .collect();
    let Some(image) = figure.first.picture().filter(|_| !balls.is_empty()) else {
        return Err(FigureError::new(
            "scene",
            "the scene has no sphere, or the log has no picture",
            "choose a scene with a few spheres, and trace the figure again",
        ));
    };
    let whole = (2.0 * eye.half).to_degrees();
    let shown = sheet.stage(
        "picture",
        None,
        format!(
            "A picture with a view angle of {}°: the same ball stands at {} places, all equally far from the eye.",
            brief(whole),
            balls.len()
        ),
    );
    let parts = sheet.stage(
        "view angle",
        None,
        format!(
            "Seen with {}° or {}° the eggs are outside of the picture.",
            brief(whole / 3.0),
            brief(2.0 * whole / 3.0)
        ),
    );
    let cones = sheet.stage(
        "cones",
        None,
        "From above: the eye sees each ball in a cone of the same width, and the flat window cuts the cones at the rim at a slant.",
    );
    let told = balls
        .iter()
        .map(|ball| format!("{}: {}", ball.name, ball.said()));
    let told: Vec<String> = told.collect();
    let ratios = sheet.stage(
        "eggs",
        None,
        format!(
            "Width to height of the images is {}: the program is right, and from the COP each image looks round.",
            told.join(", ")
        ),
    );

    let line = sheet.line_height();
    let aspect = image.aspect();
    let high = body.size().x / aspect;
    // a slide is lower
    let share = match sheet.width {
        Width::Book => 0.42,
        Width::Slide => 0.3,
    };
    let [above, rest] = body.split_top(high.min(share * body.size().y) + 0.4 * line);
    let placed = sheet.at(shown, |sheet| picture::draw_image(sheet, above, image));
    let rest = angles(sheet, rest, placed, &eye, parts);
    let [words, plan] = rest.split_top(1.1 * line);
    for ball in &balls {
        let x = on_picture(placed, &eye, ball);
        let at = DVec2::new(x, words.middle().y);
        sheet.at(ratios, |sheet| sheet.text(Anchor::Middle, at, ball.said()));
    }
    from_above(figure, sheet, plan, (&eye, &balls), [cones, ratios]);
    Ok(format!(
        "A picture with a view angle of {}° and a plan from above. {}. The images of balls at the rim are stretched \
         away from the middle.",
        brief(whole),
        told.join(", ")
    ))
}

/// Where the center of a ball is in the picture, from left to right.
fn on_picture(placed: Frame, eye: &Eye, ball: &Seen) -> f64 {
    let along = ball.towards.dot(eye.across) / ball.towards.dot(eye.sight);
    let share = along / libm::tan(eye.half);
    placed.middle().x + 0.5 * placed.size().x * share
}

/// Brackets under the picture: what a third, two thirds and the whole of the view angle show.
fn angles(sheet: &mut Sheet, frame: Frame, placed: Frame, eye: &Eye, stage: StageId) -> Frame {
    let line = sheet.line_height();
    let mut rest = frame;
    sheet.at(stage, |sheet| {
        for part in [1.0, 2.0, 3.0] {
            let half = part / 3.0 * eye.half;
            let share = libm::tan(half) / libm::tan(eye.half);
            let reach = 0.5 * share * placed.size().x;
            let [row, below] = rest.split_top(0.95 * line);
            rest = below;
            let middle = DVec2::new(placed.middle().x, row.middle().y);
            let text: Text = format!("{}°", brief((2.0 * half).to_degrees())).into();
            let gap = 0.5 * sheet.width_of(&text) + 0.4 * sheet.letters;
            for side in [-1.0, 1.0] {
                let end = middle + DVec2::new(side * reach, 0.0);
                let from = middle + DVec2::new(side * gap, 0.0);
                sheet.line(Look::THIN, from, end);
                let tick = DVec2::new(0.0, 0.3 * line);
                sheet.line(Look::THIN, end - tick, end + tick);
                if part < 3.0 {
                    let top = DVec2::new(end.x, placed.min.y);
                    let bottom = DVec2::new(end.x, placed.max.y);
                    sheet.on_picture(&[top, bottom], false);
                }
            }
            sheet.text(Anchor::Middle, middle, text);
        }
    });
    rest
}

/// The eye, the window, the balls and their cones from above, the line of sight upwards.
fn from_above(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    (eye, balls): (&Eye, &[Seen]),
    [cones, ratios]: [StageId; 2],
) {
    let flat = |of: DVec3| DVec2::new(of.dot(eye.across), of.dot(eye.sight));
    let reach = eye.distance * libm::tan(eye.half);
    let ends = [-reach, reach].map(|x| DVec2::new(x, eye.distance));
    let around = balls.iter().flat_map(|ball| {
        let at = ball.distance * flat(ball.towards);
        [at - ball.radius, at + ball.radius]
    });
    let points = around.chain(ends).chain([DVec2::ZERO]);
    let projection = figure.projection();
    let space = Space::fitted_flat(projection, frame.wider(-0.4 * sheet.letters), points);
    let place = |at: DVec2| space.place_flat(at);
    sheet.at(cones, |sheet| {
        let cop = place(DVec2::ZERO);
        sheet.line(
            Look::OBJECT.outline().wide(1.75),
            place(ends[0]),
            place(ends[1]),
        );
        sheet.label(frame, place(ends[1]), DVec2::X, "window");
        for ball in balls {
            let at = ball.distance * flat(ball.towards);
            sheet.circle(Look::OBJECT, place(at), space.scale * ball.radius);
            if sheet.width == Width::Book {
                sheet.text(Anchor::Middle, place(at), ball.name.as_str());
            }
            let tangent = (ball.distance * ball.distance - ball.radius * ball.radius)
                .max(0.0)
                .sqrt();
            for side in [-1.0, 1.0] {
                let along = flat(ball.towards).normalize_or_zero();
                let edge = tangent * along.rotate(at_angle(side * ball.half));
                sheet.line(Look::HELP.wide(0.75), cop, place(edge));
            }
        }
        sheet.dot(Look::RAY, cop);
        sheet.label(frame, cop, DVec2::X, "COP");
    });
    sheet.at(ratios, |sheet| {
        for ball in balls {
            let along = flat(ball.towards).normalize_or_zero();
            let on_window = |side: f64| {
                let edge = along.rotate(at_angle(side * ball.half));
                place(edge * (eye.distance / edge.y))
            };
            let [from, to] = [-1.0, 1.0].map(on_window);
            sheet.line(Look::ANSWER.outline().wide(4.0), from, to);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_image_of_a_ball_is_stretched_as_the_cut_of_its_cone_is() {
        let ball = |angle: f64, half: f64| Seen {
            name: String::new(),
            towards: DVec3::Z,
            distance: 1.0,
            radius: half.sin(),
            angle,
            half,
        };
        // straight ahead a circle
        assert!((ball(0.0, 0.1).stretch() - 1.0).abs() < 1e-12);
        // at 50° with α = 5°: from tan 45° to tan 55° the image is (tan 55° − tan 45°)/2 long; across it is
        // sin 5°/√(cos² 50° − sin² 5°)
        let (angle, half) = (50f64.to_radians(), 5f64.to_radians());
        let along = 0.5 * (55f64.to_radians().tan() - 45f64.to_radians().tan());
        let across = half.sin() / (angle.cos().powi(2) - half.sin().powi(2)).sqrt();
        let found = ball(angle, half).stretch();
        assert!(
            (found - along / across).abs() < 1e-12,
            "{found} {}",
            along / across
        );
        assert!((found - 1.5643).abs() < 1e-3, "{found}");
    }
}
