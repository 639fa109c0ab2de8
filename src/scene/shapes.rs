//! Shapes from the file into primitives, each checked, and back.

use std::fmt;

use glam::DVec3;

use crate::geometry::{AxisBox, Cone, Ellipsoid, Polygon, Sphere};
use crate::scene::Shape;
use crate::scene::check::{checked, checked_point, checked_positive, checked_weight};
use crate::scene::fault::{Fault, SceneFault};
use crate::scene::file::{MeshFile, PolygonFile, ShapeFile};

/// The primitives of a shape, one after the other.
pub(super) fn shapes(
    path: fmt::Arguments<'_>,
    file: ShapeFile,
    add: &mut impl FnMut(Shape),
) -> Result<(), SceneFault> {
    match file {
        ShapeFile::Sphere { center, radius } => {
            let center = checked_point(format_args!("{path}.sphere.center"), center)?;
            let at = format_args!("{path}.sphere.radius");
            let radius = checked_positive(at, "the radius", radius)?;
            add(Shape::Sphere(Sphere { center, radius }));
        }
        ShapeFile::Ellipsoid { center, radii } => {
            let center = checked_point(format_args!("{path}.ellipsoid.center"), center)?;
            for (i, &radius) in radii.iter().enumerate() {
                let at = format_args!("{path}.ellipsoid.radii[{i}]");
                checked_positive(at, "the radius", radius)?;
            }
            let radii = radii.into();
            add(Shape::Ellipsoid(Ellipsoid { center, radii }));
        }
        ShapeFile::Box { min, max } => {
            let path = format_args!("{path}.box");
            let low = checked_point(format_args!("{path}.min"), min)?;
            let high = checked_point(format_args!("{path}.max"), max)?;
            for (axis, (min, max)) in ['x', 'y', 'z'].into_iter().zip(min.into_iter().zip(max)) {
                if max <= min {
                    return Err(Fault::BoxWithoutVolume { axis, min, max }.at(path));
                }
            }
            add(Shape::Box(AxisBox {
                min: low,
                max: high,
            }));
        }
        ShapeFile::Cone {
            base,
            base_radius,
            apex,
            apex_radius,
        } => {
            let path = format_args!("{path}.cone");
            let base = checked_point(format_args!("{path}.base"), base)?;
            let apex = checked_point(format_args!("{path}.apex"), apex)?;
            let radius = |key: &str, value| {
                checked_weight(format_args!("{path}.{key}"), "the radius", value)
            };
            let base_radius = radius("base_radius", base_radius)?;
            let apex_radius = radius("apex_radius", apex_radius)?;
            let cone = Cone::new(base, base_radius, apex, apex_radius);
            add(Shape::Cone(cone.ok_or_else(|| Fault::BadCone.at(path))?));
        }
        ShapeFile::Polygon(file) => {
            let normals = file.normals.as_deref();
            let polygon = polygon(&file.vertices, normals, format_args!("{path}.polygon"))?;
            add(Shape::Polygon(polygon));
        }
        ShapeFile::Mesh(MeshFile {
            file: None,
            faces: Some(faces),
        }) => {
            for (i, face) in faces.iter().enumerate() {
                let at = format_args!("{path}.mesh.faces[{i}]");
                add(Shape::Polygon(polygon(face.vertices, face.normals, at)?));
            }
        }
        ShapeFile::Mesh(MeshFile {
            file: Some(file),
            faces: None,
        }) => return Err(Fault::MeshNotLoaded { file }.at(format_args!("{path}.mesh"))),
        ShapeFile::Mesh(MeshFile { file, .. }) => {
            let both = file.is_some();
            let (first, second) = ("file", "faces");
            return Err(Fault::OneOf {
                first,
                second,
                both,
            }
            .at(format_args!("{path}.mesh")));
        }
    }
    Ok(())
}

/// A polygon, checked; `at` is where it stands, for the error.
fn polygon(
    vertices: &[[f64; 3]],
    normals: Option<&[[f64; 3]]>,
    at: fmt::Arguments<'_>,
) -> Result<Polygon, SceneFault> {
    let points = |list: &[[f64; 3]]| -> Result<Vec<DVec3>, SceneFault> {
        for &value in list.as_flattened() {
            checked("", value).map_err(|wrong| wrong.fault.at(at))?;
        }
        Ok(list.iter().map(|&point| point.into()).collect())
    };
    let vertices = points(vertices)?;
    let normals = normals.map(points).transpose()?;
    Polygon::new(vertices, normals).map_err(|error| Fault::Polygon(error).at(at))
}

/// A shape as a file has it.
pub(super) fn shape_file(shape: &Shape) -> ShapeFile {
    match shape {
        Shape::Sphere(Sphere { center, radius }) => ShapeFile::Sphere {
            center: (*center).into(),
            radius: *radius,
        },
        Shape::Ellipsoid(Ellipsoid { center, radii }) => ShapeFile::Ellipsoid {
            center: (*center).into(),
            radii: (*radii).into(),
        },
        Shape::Box(AxisBox { min, max }) => ShapeFile::Box {
            min: (*min).into(),
            max: (*max).into(),
        },
        Shape::Cone(cone) => ShapeFile::Cone {
            base: cone.base().into(),
            base_radius: cone.radii()[0],
            apex: cone.apex().into(),
            apex_radius: cone.radii()[1],
        },
        Shape::Polygon(polygon) => ShapeFile::Polygon(polygon_file(polygon)),
    }
}

/// A polygon as a file has it.
fn polygon_file(polygon: &Polygon) -> PolygonFile {
    let vertices: Vec<_> = polygon.vertices().map(Into::into).collect();
    let normals = polygon.normals();
    PolygonFile {
        vertices: vertices.into(),
        normals: normals.map(|normals| normals.iter().map(|&n| n.into()).collect()),
    }
}
