//! The weight of a connecting line among all ways in which the same path can come about.
//!
//! The balance heuristic (E. Veach and L. Guibas 1995): each way counts in proportion to its density. A path of n
//! edges can come about with each of them as the line; light has made the vertices before it, the eye those behind it.
//! The pdf is the product of φ of all vertices that emit or reflect, and of G of all edges but the line, for a line is
//! drawn, not sampled. So all densities share all factors but those of their own line,
//!
//! w = share / Σ shares,  share = 1 / (G · φ · φ')
//!
//! with φ = 1/(4π) at the light, ρ/π at a diffuse surface, d²/(A·cos θ) at the eye with A the window's area. A mirror
//! or glass reflects or refracts in one direction: no line to it ever has that direction, so that its edges cannot be the line.
//! Through glass, n² of radiance is left out of the densities: the weights still add up to one.

use std::f64::consts::PI;

use glam::DVec3;

use crate::scene::Camera;
use crate::trace::{Alternative, Event, Recorder, geometry_term};
use crate::tracer::light::path_vertex::Vertex;

/// The two paths that are to be connected, each from its end on.
pub(in crate::tracer) struct Paths<'a> {
    pub(in crate::tracer) camera: &'a Camera,
    pub(in crate::tracer) number: u32,
    pub(in crate::tracer) light: &'a [Vertex],
    pub(in crate::tracer) eye: &'a [Vertex],
}

impl Paths<'_> {
    /// The weight of a connection by the balance heuristic.
    pub(in crate::tracer) fn weight<R: Recorder>(
        &self,
        light_vertex: usize,
        eye_vertex: usize,
        recorder: &mut R,
    ) -> f64 {
        // the whole path, from the light to the eye, with the line as one of its edges
        let of_light = self.light[..=light_vertex].iter();
        let of_eye = self.eye[..=eye_vertex].iter().rev();
        let vertices: Vec<&Vertex> = of_light.chain(of_eye).collect();
        let line = light_vertex + 1;
        let last = vertices.len() - 1;

        let mut shares = 0.0;
        let mut own = 0.0;
        for edge in 1..=last {
            let ends = [vertices[edge - 1], vertices[edge]];
            // at the ends of the line itself light goes on diffusely, whatever chance decided for the paths
            let is_line = edge == line;
            let bars = |end: usize| {
                let at = edge - 1 + end;
                let ends_line = at == line - 1 || at == line;
                !ends_line && ends[end].is_specular
            };
            if bars(0) || bars(1) {
                continue;
            }
            let direction = (ends[1].point - ends[0].point).normalize_or_zero();
            let cosines = [
                ends[0].cosine(direction).abs(),
                ends[1].cosine(-direction).abs(),
            ];
            let geometry = geometry_term(ends[0].point, ends[1].point, cosines);
            let at_light = if edge == 1 {
                1.0 / (4.0 * PI)
            } else {
                ends[0].density()
            };
            let at_eye = if edge == last {
                self.window_density(-direction)
            } else {
                ends[1].density()
            };
            let share = 1.0 / (geometry * at_light * at_eye);
            shares += share;
            if is_line {
                own = share;
            }
            recorder.note(|| {
                Event::Alternative(Alternative {
                    edge: edge as u32,
                    geometry,
                    densities: [at_light, at_eye],
                    share,
                    chosen: is_line,
                })
            });
        }
        own / shares
    }

    /// φ at the eye: paths from it pass the whole window alike.
    fn window_density(&self, direction: DVec3) -> f64 {
        let [width, height] = self.camera.pixels.map(f64::from);
        let area = self.camera.pixel_area() * width * height;
        let across = self.camera.window_normal();
        let cosine = direction.dot(across).abs();
        // the window's plane along this direction
        let t = self.camera.to_corner.dot(across).abs() / cosine;
        t * t / (area * cosine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::one_pixel;
    use crate::trace::{Off, Recording};

    /// The lamp at (0, 3, −1), the point (0, 0, −5) of a wall of albedo ½ that faces the eye, and the eye in the origin: 5 from the
    /// lamp to the wall at a cosine of 0.8, and 5 from there to the eye along the normal.
    fn vertices() -> [Vertex; 3] {
        let lamp = Vertex::end(DVec3::new(0.0, 3.0, -1.0), DVec3::ONE);
        let wall = Vertex {
            normal: DVec3::Z,
            albedo: DVec3::splat(0.5),
            ..Vertex::end(DVec3::new(0.0, 0.0, -5.0), DVec3::ONE)
        };
        [lamp, wall, Vertex::end(DVec3::ZERO, DVec3::ONE)]
    }

    #[track_caller]
    fn check(found: f64, expected: f64) {
        assert!(
            (found - expected).abs() <= 1e-15,
            "{found}, expected {expected}"
        );
    }

    #[test]
    fn the_weights_of_both_ways_to_connect_a_path_of_two_edges_are_5_pi_to_4() {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let [lamp, wall, eye] = vertices();
        let paths = Paths {
            camera: &camera,
            number: 0,
            light: &[lamp, wall],
            eye: &[eye, wall],
        };
        // from the lamp: G = 0.8/25, φ = 1/4π, φ' = ½/π: a share of 250π². To the eye: G = 1/25, φ = ½/π, φ' = 1/4, the window
        // being 1 away and 4 large: a share of 200π
        check(paths.weight(0, 1, &mut Off), 5.0 * PI / (4.0 + 5.0 * PI));
        check(paths.weight(1, 0, &mut Off), 4.0 / (4.0 + 5.0 * PI));

        let mut recording = Recording::new(Vec::new());
        let _ = paths.weight(1, 0, &mut recording);
        let records = recording.into_sink();
        let edges: Vec<_> = records
            .iter()
            .map(|record| match &record.event {
                Event::Alternative(edge) => (edge.edge, edge.chosen, edge.share, edge.densities),
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(edges.len(), 2);
        let [first, second] = [edges[0], edges[1]];
        assert_eq!((first.0, first.1, second.0, second.1), (1, false, 2, true));
        check(first.2 / (250.0 * PI * PI), 1.0);
        check(second.2 / (200.0 * PI), 1.0);
        check(first.3[0], 0.25 / PI);
        check(first.3[1], 0.5 / PI);
        check(second.3[0], 0.5 / PI);
        check(second.3[1], 0.25);
    }

    #[test]
    fn an_edge_at_a_mirror_is_none_that_could_be_the_line() {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let [lamp, wall, eye] = vertices();
        // between the wall and the eye the path is mirrored: the line from the lamp to the wall is the only way
        let mirror = Vertex {
            is_specular: true,
            normal: DVec3::X,
            ..Vertex::end(DVec3::new(-2.0, 0.0, -2.5), DVec3::ONE)
        };
        let paths = Paths {
            camera: &camera,
            number: 0,
            light: &[lamp],
            eye: &[eye, mirror, wall],
        };
        check(paths.weight(0, 2, &mut Off), 1.0);
        // what chance decided at the ends of the line itself does not count
        let went_on = Vertex {
            is_specular: true,
            ..wall
        };
        let paths = Paths {
            camera: &camera,
            number: 0,
            light: &[lamp, went_on],
            eye: &[eye, went_on],
        };
        check(paths.weight(0, 1, &mut Off), 5.0 * PI / (4.0 + 5.0 * PI));
        check(paths.weight(1, 0, &mut Off), 4.0 / (4.0 + 5.0 * PI));
    }

    #[test]
    fn the_window_s_density_grows_with_the_distance_along_a_slanted_line() {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let paths = Paths {
            camera: &camera,
            number: 0,
            light: &[],
            eye: &[],
        };
        // cos θ = 0.8: the window's plane is 1.25 away, 1.5625/(4·0.8)
        check(
            paths.window_density(DVec3::new(0.6, 0.0, -0.8)),
            0.488_281_25,
        );
        check(paths.window_density(DVec3::NEG_Z), 0.25);
        // the window counts, into however many pixels it is divided
        let camera = Camera {
            pixels: [4, 2],
            ..camera
        };
        let paths = Paths {
            camera: &camera,
            ..paths
        };
        check(paths.window_density(DVec3::NEG_Z), 0.25);
    }
}
