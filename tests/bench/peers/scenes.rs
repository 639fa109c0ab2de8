//! What is raced over: spheres or a triangle mesh in the unit cube, and rays through it.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::Ray;

/// Numbers that are the same in each run (G. Marsaglia's xorshift, 2003).
struct Random(u64);

impl Random {
    /// From 0 up to 1.
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    /// A direction of unit length, each as likely as the others.
    fn direction(&mut self) -> DVec3 {
        loop {
            let p = 2.0 * self.point() - 1.0;
            let length = p.length();
            if (0.1..=1.0).contains(&length) {
                return p / length;
            }
        }
    }
}

/// The objects, before anything is built over them.
pub(crate) enum Objects {
    /// Center and radius of each.
    Spheres(Vec<(DVec3, f64)>),
    /// Vertices, and three of their places for each triangle.
    Mesh(Vec<DVec3>, Vec<[u32; 3]>),
}

/// Spheres anywhere in the unit cube, each with a quarter of their mean distance as its radius.
pub(crate) fn spheres(count: usize) -> Objects {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let radius = 0.25 / (count as f64).cbrt();
    Objects::Spheres((0..count).map(|_| (random.point(), radius)).collect())
}

/// A closed, wavy ring of about so many triangles.
pub(crate) fn mesh(count: usize) -> Objects {
    let across = ((count as f64 / 2.0).sqrt().round() as usize).max(3);
    let angle = |place: usize| TAU * place as f64 / across as f64;
    let point = |row: usize, column: usize| {
        let (u, v) = (angle(row), angle(column));
        let tube = 0.12 + 0.02 * (7.0 * u).sin() * (5.0 * v).cos();
        let around = 0.33 + tube * v.cos();
        DVec3::new(around * u.cos(), around * u.sin(), tube * v.sin()) + 0.5
    };
    let number = |row: usize, column: usize| ((row % across) * across + column % across) as u32;
    let places = || (0..across).flat_map(|row| (0..across).map(move |column| (row, column)));
    let faces = places().flat_map(|(row, column)| {
        let [a, b] = [number(row, column), number(row + 1, column)];
        let [c, d] = [number(row + 1, column + 1), number(row, column + 1)];
        [[a, b, c], [a, c, d]]
    });
    let vertices = places().map(|(row, column)| point(row, column));
    Objects::Mesh(vertices.collect(), faces.collect())
}

/// The same objects as a scene of raystep, to the bit.
pub(crate) fn scene(objects: &Objects) -> Scene {
    let (name, text) = text_of(objects);
    let loaded = raystep::load_bytes(name, text.as_bytes(), &raystep::NoFiles).expect("valid text");
    drop(text);
    loaded.build().expect("a valid scene")
}

/// The same objects as a file, spheres in NFF and a mesh in OBJ: its name and its text, in which a number is written
/// so that it is read back unchanged.
pub(crate) fn text_of(objects: &Objects) -> (&'static str, String) {
    let mut text = String::new();
    let name = match objects {
        Objects::Spheres(spheres) => {
            text.push_str(
                "v\nfrom 0 0 -3\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\n",
            );
            text.push_str("f 1 1 1 1 0 0 0 1\n");
            for (DVec3 { x, y, z }, radius) in spheres {
                let _ = writeln!(text, "s {x} {y} {z} {radius}");
            }
            "spheres.nff"
        }
        Objects::Mesh(vertices, faces) => {
            for DVec3 { x, y, z } in vertices {
                let _ = writeln!(text, "v {x} {y} {z}");
            }
            for [a, b, c] in faces {
                let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
            }
            "mesh.obj"
        }
    };
    (name, text)
}

/// The rays of an eye before the cube, side × side of them.
pub(crate) fn coherent(side: usize) -> Vec<Ray> {
    let eye = DVec3::new(0.5, 0.5, -1.2);
    let at = |place: usize| (place as f64 + 0.5) / side as f64;
    let places = (0..side).flat_map(|y| (0..side).map(move |x| (x, y)));
    places
        .map(|(x, y)| {
            let to = DVec3::new(at(x), at(y), 0.0);
            Ray::new(eye, (to - eye).normalize())
        })
        .collect()
}

/// Rays from anywhere in the cube in any direction.
pub(crate) fn incoherent(count: usize) -> Vec<Ray> {
    let mut random = Random(0x0123_4567_89ab_cdef);
    (0..count)
        .map(|_| Ray::new(random.point(), random.direction()))
        .collect()
}
