//! A mesh without a scene around it: a camera that sees it whole, a light, a grey material.

use glam::DVec3;

use crate::scene::file::{
    CameraFile, FaceList, LightFile, LookAt, Material, Materials, MeshFile, ObjectFile, SceneFile,
    ShapeFile, SidesFile,
};
use crate::scene::load::error::LoadError;
use crate::scene::load::loaded::{Lines, Loaded, Source, Table};
use crate::scene::load::obj::{Faces, read_obj};
use crate::scene::load::words::stem;

/// Reads a mesh as a scene of its own: grey, and seen whole from the right, the front and above.
///
/// # Errors
/// As [`read_obj`].
pub(in crate::scene::load) fn read_obj_scene(file: &str, text: &str) -> Result<Loaded, LoadError> {
    let Faces { faces, notes } = read_obj(file, text)?;
    let name = match stem(file) {
        "" => "mesh",
        stem => stem,
    };
    let (camera, light) = framed(&faces);
    let material = Material {
        colour: [0.8; 3],
        diffuse: 0.8,
        specular: 0.2,
        shininess: 20.0,
        reflection: 0.0,
        transmission: 0.0,
        index: 1.0,
    };
    let object = ObjectFile {
        name: name.into(),
        material: "grey".into(),
        shape: ShapeFile::Mesh(MeshFile {
            file: None,
            faces: Some(faces),
        }),
        sides: SidesFile::Both,
    };
    Ok(Loaded {
        scene: SceneFile {
            name: name.into(),
            camera,
            background: [0.7, 0.85, 1.0],
            ambient: [0.1; 3],
            lights: vec![light],
            materials: Materials(vec![("grey".into(), material)]),
            objects: vec![object],
            max_depth: 5,
            slabs: None,
        },
        notes,
        files: Vec::new(),
        source: Source {
            file: file.into(),
            // the faces have been checked with their lines, and the rest stands in no line
            lines: Lines::Table(Table::default()),
        },
    })
}

/// A camera that sees the sphere around the faces' bounding box touch the picture's upper and lower
/// edge, and a light beside it.
fn framed(faces: &FaceList) -> (CameraFile, LightFile) {
    const FOV_DEGREES: f64 = 40.0;
    let vertices = || faces.iter().flat_map(|face| face.vertices);
    let points = || vertices().map(|&vertex| DVec3::from(vertex));
    let low = points().reduce(DVec3::min).unwrap_or_default();
    let high = points().reduce(DVec3::max).unwrap_or_default();

    let center = 0.5 * (low + high);
    let radius = 0.5 * (high - low).length();
    // the tangent from the eye makes a right angle with the radius: sin(fov/2) = radius/distance
    let distance = radius / libm::sin((0.5 * FOV_DEGREES).to_radians());
    let slanted = DVec3::new(1.0, 0.8, 1.6).normalize();
    let cop = center + distance * slanted;
    let right = DVec3::Y.cross(slanted).normalize();

    let camera = CameraFile {
        look_at: Some(LookAt {
            cop: cop.into(),
            target: center.into(),
            up: DVec3::Y.into(),
            fov_degrees: FOV_DEGREES,
        }),
        window: None,
        pixels: [320, 240],
    };
    let light = LightFile {
        name: "light-1".into(),
        position: (cop + radius * (right + DVec3::Y)).into(),
        colour: Some([1.0; 3]),
        power: None,
    };
    (camera, light)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;

    #[test]
    fn a_mesh_alone_is_seen_whole() {
        let text = "v 2 0 0\nv -2 0 0\nv 0 4 1\nv 0 0 -4\nf 1 2 3\nf 2 3 4";
        let scene = read_obj_scene("x/bird.obj", text).unwrap().build().unwrap();
        assert_eq!((scene.name.as_str(), scene.primitives.len()), ("bird", 2));
        let Camera {
            cop,
            to_corner,
            right,
            up,
            ..
        } = scene.camera;
        let sight = to_corner + 0.5 * (right + up);
        // half the diagonal of 4 × 4 × 5 around (0, 2, −1.5) is √57/2, and seen at 20° it is sin 20° away
        let center = DVec3::new(0.0, 2.0, -1.5);
        let distance = 0.5 * 57.0f64.sqrt() / 20.0f64.to_radians().sin();
        assert!(
            (cop + distance * sight - center).length() <= 1e-12,
            "{cop} {sight}"
        );
        assert!(
            (up.length() - 2.0 * 20.0f64.to_radians().tan()).abs() <= 1e-12,
            "{up}"
        );
    }
}
