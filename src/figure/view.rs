//! How a scene is seen in a figure: an orthographic projection, fitted into a frame.

use glam::{DVec2, DVec3};
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::figure::sheet::frame::Frame;
use crate::geometry::{Inside, Ray};
use crate::scene::Camera;

/// From where a scene is seen. No view foreshortens by distance: equal lengths that are parallel stay equal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum View {
    /// From above: x to the right, z downwards.
    #[default]
    Top,
    /// From the front: x to the right, y upwards.
    Front,
    /// From the right: z to the left, y upwards.
    Side,
    /// Along the view plane: the window is a line, the line of sight goes to the right.
    Along,
    /// From above the front's right corner: x, y and z are all to be seen.
    Axonometric,
}

/// An orthographic projection along a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Projection {
    /// The direction that goes to the right, of unit length.
    across: DVec3,
    /// The direction that goes upwards, of unit length and perpendicular to it.
    up: DVec3,
    /// Does it show a space, in which a ball is more than a circle?
    pub(super) in_space: bool,
}

impl View {
    pub(super) fn projection(self, camera: &Camera) -> Projection {
        match self {
            Self::Top => Projection::new(DVec3::X, DVec3::NEG_Z),
            Self::Front => Projection::new(DVec3::X, DVec3::Y),
            Self::Side => Projection::new(DVec3::NEG_Z, DVec3::Y),
            Self::Along => {
                let normal = camera.right.cross(camera.up);
                // the window's normal points to one of its sides: to the right goes what lies beyond it
                let sight = normal * camera.to_corner.dot(normal).signum();
                Projection::new(sight, camera.up)
            }
            Self::Axonometric => {
                // turned by 32° and seen from 24° above: no two of the axes cover each other, nor a cube's corners
                let (turn, above) = (32f64.to_radians(), 24f64.to_radians());
                let [turn_sin, turn_cos] = [libm::sin(turn), libm::cos(turn)];
                let [above_sin, above_cos] = [libm::sin(above), libm::cos(above)];
                let across = DVec3::new(turn_cos, 0.0, -turn_sin);
                let towards = DVec3::new(turn_sin * above_cos, above_sin, turn_cos * above_cos);
                Projection {
                    in_space: true,
                    ..Projection::new(across, towards.cross(across))
                }
            }
        }
    }
}

impl Projection {
    /// With these directions to the right and, as far as it is perpendicular to that, upwards.
    pub(super) fn new(across: DVec3, up: DVec3) -> Self {
        let across = across.normalize_or(DVec3::X);
        let up = up.reject_from_normalized(across).normalize_or(DVec3::Y);
        Self {
            across,
            up,
            in_space: false,
        }
    }

    /// The projection of a point: to the right, and upwards.
    pub(super) fn of(&self, point: DVec3) -> DVec2 {
        DVec2::new(self.across.dot(point), self.up.dot(point))
    }

    /// The direction towards who looks.
    pub(super) fn towards(&self) -> DVec3 {
        self.across.cross(self.up)
    }
}

/// The space of a scene as a sheet shows it: a projection fitted into a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Space {
    pub(super) projection: Projection,
    pub(super) frame: Frame,
    /// Units of the sheet for one of the scene.
    pub(super) scale: f64,
    /// What lies in the middle of the frame.
    center: DVec2,
}

impl Space {
    /// Shows all these points, as large as the frame allows; its room around them is a share of the frame.
    pub(super) fn fitted(
        projection: Projection,
        frame: Frame,
        points: impl IntoIterator<Item = DVec3>,
    ) -> Self {
        let flat = points.into_iter().map(|point| projection.of(point));
        Self::fitted_flat(projection, frame, flat)
    }

    /// The same for points that are projected already, up being positive.
    pub(super) fn fitted_flat(
        projection: Projection,
        frame: Frame,
        points: impl IntoIterator<Item = DVec2>,
    ) -> Self {
        /// Of the frame, around what is shown.
        const ROOM: f64 = 0.04;
        let around = Frame::around(points).unwrap_or_default();
        let size = around.size();
        let room = (1.0 - 2.0 * ROOM) * frame.size();
        // a single point, or points on one line, have no size in one direction or in both
        let scale = (room / size).min_element();
        let scale = if scale.is_finite() { scale } else { 1.0 };
        Self {
            projection,
            frame,
            scale,
            center: around.middle(),
        }
    }

    /// Where a point of the scene is on the sheet.
    pub(super) fn place(&self, point: DVec3) -> DVec2 {
        self.place_flat(self.projection.of(point))
    }

    /// Where a projected point is on the sheet.
    pub(super) fn place_flat(&self, point: DVec2) -> DVec2 {
        let from_center = self.scale * (point - self.center);
        self.frame.middle() + DVec2::new(from_center.x, -from_center.y)
    }

    /// A direction of the scene on the sheet.
    pub(super) fn direction(&self, direction: DVec3) -> DVec2 {
        let flat = self.projection.of(direction);
        DVec2::new(flat.x, -flat.y)
    }

    /// The t at which a ray leaves the frame; `None` if it never is in it, or is seen from its end.
    pub(super) fn leaves(&self, ray: &Ray) -> Option<f64> {
        let from = self.place(ray.origin);
        let along = self.direction(ray.direction) * self.scale;
        // less than a thousandth of a unit of the sheet on the way of one of the scene: it stands still
        let stands_still = along.abs().cmple(DVec2::splat(1e-3 * self.scale));
        let along = DVec2::select(stands_still, DVec2::ZERO, along);
        let ahead = Inside {
            near: 0.0,
            far: f64::INFINITY,
        };
        let [_, last] = self.frame.inside(from, along, ahead).ends()?;
        last.is_finite().then_some(last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::SceneFile;

    fn camera() -> Camera {
        // a window at z = 5, 2 × 2, seen from (0, 1, 6)
        let file: SceneFile = serde_json::from_str(
            r#"{"camera":{"window":{"cop":[0,1,6],"corner":[-1,0,5],"right":[2,0,0],"up":[0,2,0]},
                "pixels":[2,2]},"objects":[],"materials":{}}"#,
        )
        .unwrap();
        Camera::new(&file.camera).unwrap()
    }

    #[track_caller]
    fn seen(view: View, point: [f64; 3], at: [f64; 2]) {
        let found = view.projection(&camera()).of(point.into());
        assert!(
            (found - DVec2::from(at)).length() < 1e-12,
            "{view:?}: {found}"
        );
    }

    #[test]
    fn each_view_shows_the_axes_that_its_name_says() {
        seen(View::Top, [1.0, 2.0, 3.0], [1.0, -3.0]);
        seen(View::Front, [1.0, 2.0, 3.0], [1.0, 2.0]);
        seen(View::Side, [1.0, 2.0, 3.0], [-3.0, 2.0]);
        // sight goes along −z
        seen(View::Along, [1.0, 2.0, 3.0], [-3.0, 2.0]);
    }

    #[test]
    fn from_the_corner_x_goes_right_y_up_and_z_down_to_the_left() {
        let projection = View::Axonometric.projection(&camera());
        let [x, y, z] = DVec3::AXES.map(|axis| projection.of(axis));
        assert!(0.0 < x.x && 0.0 < y.y && z.x < 0.0 && z.y < 0.0);
        assert!(y.x.abs() < 1e-12);
    }

    #[test]
    fn what_is_shown_fills_the_frame_and_keeps_its_proportions() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(200.0, 100.0),
        };
        let projection = View::Front.projection(&camera());
        let space = Space::fitted(projection, frame, [DVec3::ZERO, DVec3::new(4.0, 2.0, 0.0)]);
        // 8 % of room: 184 for 4 units, 92 for 2
        assert!((space.scale - 46.0).abs() < 1e-9);
        let at = space.place(DVec3::new(2.0, 2.0, 7.0));
        assert!((at - DVec2::new(100.0, 4.0)).length() < 1e-9, "{at}");
    }

    #[test]
    fn a_ray_is_followed_to_the_edge_of_the_frame() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(100.0, 100.0),
        };
        let projection = View::Front.projection(&camera());
        let space = Space::fitted(projection, frame, [DVec3::ZERO, DVec3::ONE]);
        // 92 units for 1: the edge is 4 beyond (1, 1)
        let ray = Ray::new(DVec3::new(0.0, 0.5, 0.0), DVec3::X);
        let t = space.leaves(&ray).unwrap();
        assert!((t - 96.0 / 92.0).abs() < 1e-12, "{t}");
        assert_eq!(space.leaves(&Ray::new(DVec3::ZERO, DVec3::Z)), None);
    }
}
