//! The scene as the tracer sees it: checked, and with everything constant computed in advance.

use std::collections::HashMap;
use std::fmt;

use glam::DVec3;

use crate::geometry::{Sides, slab_directions};
use crate::scene::check::{checked_colour, checked_point, checked_positive, checked_weight};
use crate::scene::fault::{DEEPEST, Fault, SceneFault};
use crate::scene::file::{
    CameraFile, FaceList, LightFile, Material, Materials, MeshFile, ObjectFile, SceneFile,
    ShapeFile,
};
use crate::scene::shapes::{shape_file, shapes};
use crate::scene::{Camera, Emission, Light, Object, Primitive, PrimitiveId, Shape};

/// Everything that is there before a ray is cast. Made by [`Scene::new`] and not changed after.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What the scene shows.
    pub name: String,
    /// The eye and the window.
    pub camera: Camera,
    /// The camera as the file has it.
    camera_file: CameraFile,
    /// The colour of a ray that hits nothing.
    pub background: DVec3,
    /// The ambient light in red, green and blue: it reaches every surface from all directions.
    pub ambient: DVec3,
    /// The point lights, in the order in which their terms are summed.
    pub lights: Vec<Light>,
    /// The materials with their names.
    pub materials: Materials,
    /// The objects, in the order of the file.
    pub objects: Vec<Object>,
    /// What the objects consist of, in the same order.
    pub primitives: Vec<Primitive>,
    /// The largest depth of a ray; an eye ray has depth 1.
    pub max_depth: u32,
    /// The scene's own set of slabs: their directions (A, B, C).
    pub slabs: Option<Vec<DVec3>>,
}

impl Scene {
    /// The scene that a file describes.
    ///
    /// # Errors
    /// The first value that makes no sense, with its path.
    pub fn new(file: SceneFile) -> Result<Self, SceneFault> {
        if file.max_depth < 1 || DEEPEST < file.max_depth {
            let depth = file.max_depth;
            return Err(Fault::Depth { depth }.at("max_depth"));
        }
        let mut scene = Self {
            name: file.name,
            camera: Camera::new(&file.camera)?,
            camera_file: file.camera,
            background: checked_colour("background", file.background)?,
            ambient: checked_colour("ambient", file.ambient)?,
            lights: lights(file.lights)?,
            materials: materials(file.materials)?,
            objects: Vec::with_capacity(file.objects.len()),
            primitives: Vec::with_capacity(file.objects.iter().map(primitive_count).sum()),
            max_depth: file.max_depth,
            slabs: file.slabs.map(slabs).transpose()?,
        };
        let names = file.objects.iter().map(|object| object.name.as_str());
        let wrong_name = wrong_name("objects", names);

        // the last is taken first from a list, and gives back its memory while the scene grows
        let mut waiting = file.objects;
        waiting.reverse();
        while let Some(object) = waiting.pop() {
            let i = scene.objects.len();
            if let Some((_, fault)) = wrong_name.as_ref().filter(|(wrong, _)| *wrong == i) {
                return Err(fault.clone());
            }
            scene.add(format_args!("objects[{i}]"), object)?;
            // an eighth at a time, so that a list that moves when it shrinks moves seldom
            if waiting.len() <= waiting.capacity() / 8 * 7 {
                waiting.shrink_to_fit();
            }
        }
        Ok(scene)
    }

    /// The same scene with opaque objects showing only their front, as the published statistics have
    /// it. Transmitting objects keep both sides, and so does what the file itself restricts.
    #[must_use]
    pub fn one_sided(mut self) -> Self {
        for primitive in &mut self.primitives {
            let object = &self.objects[primitive.object as usize];
            let opaque = self.materials.0[object.material as usize].1.transmission == 0.0;
            if opaque && primitive.sides == Sides::Both {
                primitive.sides = Sides::Front;
            }
        }
        self
    }

    /// The primitive with a number that the scene gave out.
    #[inline]
    pub fn primitive(&self, id: PrimitiveId) -> &Primitive {
        &self.primitives[id.0 as usize]
    }

    /// The object that a primitive belongs to.
    pub fn object_of(&self, id: PrimitiveId) -> &Object {
        &self.objects[self.primitive(id).object as usize]
    }

    /// The material of a primitive.
    pub fn material_of(&self, id: PrimitiveId) -> &Material {
        &self.materials.0[self.object_of(id).material as usize].1
    }

    /// The primitive's name: that of its object, and the number of the face in a mesh, from 0.
    pub fn name_of(&self, id: PrimitiveId) -> (&str, Option<u32>) {
        let object = self.object_of(id);
        let face = object.is_mesh.then(|| id.0 - object.first.0);
        (&object.name, face)
    }

    /// The scene as a file again, without its objects.
    pub fn head(&self) -> SceneFile {
        SceneFile {
            name: self.name.clone(),
            camera: self.camera_file.clone(),
            background: self.background.into(),
            ambient: self.ambient.into(),
            lights: self.lights.iter().map(light_file).collect(),
            materials: self.materials.clone(),
            objects: Vec::new(),
            max_depth: self.max_depth,
            slabs: self
                .slabs
                .as_ref()
                .map(|slabs| slabs.iter().map(|n| n.to_array().into()).collect()),
        }
    }

    /// One object as a file again, its mesh inlined.
    pub fn object_file(&self, object: &Object) -> ObjectFile {
        let first = object.first.0 as usize;
        let primitives = &self.primitives[first..first + object.count as usize];
        let shape = if object.is_mesh {
            let mut faces = FaceList::default();
            for primitive in primitives {
                if let Shape::Polygon(polygon) = &primitive.shape {
                    let vertices: Vec<_> = polygon.vertices().collect();
                    faces.push(&vertices, polygon.normals());
                }
            }
            ShapeFile::Mesh(MeshFile {
                file: None,
                faces: Some(faces),
            })
        } else {
            shape_file(&primitives[0].shape)
        };
        ObjectFile {
            name: object.name.clone(),
            material: self.materials.0[object.material as usize].0.as_str().into(),
            shape,
            sides: object.sides.into(),
        }
    }

    fn add(&mut self, path: fmt::Arguments<'_>, file: ObjectFile) -> Result<(), SceneFault> {
        let material = self.material_named(path, &file.material)?;
        let first = PrimitiveId(self.primitives.len() as u32);
        let is_mesh = matches!(file.shape, ShapeFile::Mesh(_));
        let sides = file.sides.into();
        let object = self.objects.len() as u32;
        let mut add = |shape| {
            self.primitives.push(Primitive {
                shape,
                object,
                sides,
            });
        };
        shapes(format_args!("{path}.shape"), file.shape, &mut add)?;
        self.objects.push(Object {
            name: file.name,
            material,
            sides,
            first,
            count: self.primitives.len() as u32 - first.0,
            is_mesh,
        });
        Ok(())
    }

    fn material_named(&self, path: fmt::Arguments<'_>, name: &str) -> Result<u32, SceneFault> {
        let known = || self.materials.0.iter().map(|(known, _)| known.as_str());
        if let Some(index) = known().position(|known| known == name) {
            return Ok(index as u32);
        }
        let fault = Fault::UnknownMaterial {
            name: name.into(),
            nearest: nearest_name(name, known()),
        };
        Err(fault.at(format_args!("{path}.material")))
    }
}

/// The known name most like one that is not known, if any is like it at all.
pub fn nearest_name<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    /// Below this similarity (Jaro-Winkler, 0 to 1) a guess would only confuse.
    const LIKE: f64 = 0.7;
    /// What one slip counts, two letters that changed places included, of which Jaro-Winkler sees none in
    /// words of three letters.
    const SLIP: f64 = 0.8;
    /// Nobody misspells a longer name, in characters; to compare it takes time that grows with its length.
    const LONGEST: usize = 256;
    let length = name.chars().count();
    if LONGEST < length {
        return None;
    }
    let likeness = |candidate: &str| {
        let is_slip = 3 <= length && strsim::damerau_levenshtein(name, candidate) == 1;
        let slip = if is_slip { SLIP } else { 0.0 };
        strsim::jaro_winkler(name, candidate).max(slip)
    };
    known
        .map(|candidate| (likeness(candidate), candidate))
        .filter(|(likeness, _)| LIKE <= *likeness)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate.into())
}

/// How many primitives an object will have.
fn primitive_count(object: &ObjectFile) -> usize {
    match &object.shape {
        ShapeFile::Mesh(mesh) => mesh.faces.as_ref().map_or(0, FaceList::len),
        _ => 1,
    }
}

/// The first name of a list that is empty or was there before: its place, and the mistake.
fn wrong_name<'a>(
    list: &str,
    names: impl ExactSizeIterator<Item = &'a str>,
) -> Option<(usize, SceneFault)> {
    let mut known = HashMap::with_capacity(names.len());
    for (i, name) in names.enumerate() {
        let fault = match known.insert(name, i) {
            _ if name.is_empty() => Fault::EmptyName,
            None => continue,
            Some(first) => Fault::SameName {
                name: name.into(),
                first: format!("{list}[{first}]"),
            },
        };
        return Some((i, fault.at(format!("{list}[{i}].name"))));
    }
    None
}

fn materials(file: Materials) -> Result<Materials, SceneFault> {
    for (name, material) in &file.0 {
        let path = |key: &str| format!("materials.{name}.{key}");
        checked_colour(path("colour"), material.colour)?;
        for (key, what, value) in [
            ("diffuse", "the diffuse coefficient", material.diffuse),
            ("specular", "the specular coefficient", material.specular),
            ("shininess", "the shininess", material.shininess),
            ("reflection", "the reflection", material.reflection),
            ("transmission", "the transmission", material.transmission),
        ] {
            checked_weight(path(key), what, value)?;
        }
        checked_positive(path("index"), "the index of refraction", material.index)?;
    }
    Ok(file)
}

fn lights(mut files: Vec<LightFile>) -> Result<Vec<Light>, SceneFault> {
    for (i, file) in files.iter_mut().enumerate() {
        if file.name.is_empty() {
            file.name = format!("light-{}", i + 1);
        }
    }
    let wrong_name = wrong_name("lights", files.iter().map(|file| file.name.as_str()));
    let mut lights = Vec::with_capacity(files.len());
    for (i, file) in files.into_iter().enumerate() {
        let path = format!("lights[{i}]");
        if let Some((_, fault)) = wrong_name.as_ref().filter(|(wrong, _)| *wrong == i) {
            return Err(fault.clone());
        }
        let emission = match (file.colour, file.power) {
            (Some(colour), None) => {
                Emission::Colour(checked_colour(format_args!("{path}.colour"), colour)?)
            }
            (None, Some(power)) => {
                let at = format_args!("{path}.power");
                Emission::Power(checked_positive(at, "the power", power)?)
            }
            (colour, _) => {
                let both = colour.is_some();
                let (first, second) = ("colour", "power");
                return Err(Fault::OneOf {
                    first,
                    second,
                    both,
                }
                .at(path));
            }
        };
        let position = checked_point(format_args!("{path}.position"), file.position)?;
        lights.push(Light {
            name: file.name,
            position,
            emission,
        });
    }
    Ok(lights)
}

/// The directions of slabs; those of a plane with one across it, without which they would not bound.
fn slabs(file: Vec<Vec<f64>>) -> Result<Vec<DVec3>, SceneFault> {
    let mut directions = Vec::with_capacity(file.len() + 1);
    let in_plane = file.first().is_some_and(|direction| direction.len() == 2);
    for (i, direction) in file.into_iter().enumerate() {
        let normal = match *direction.as_slice() {
            [a, b] if in_plane => [a, b, 0.0],
            [a, b, c] if !in_plane => [a, b, c],
            _ => return Err(Fault::SlabDirection { in_plane }.at(format!("slabs[{i}]"))),
        };
        directions.push(checked_point(format_args!("slabs[{i}]"), normal)?);
    }
    if in_plane {
        directions.push(DVec3::Z);
    }
    slab_directions(&directions).map_err(|error| {
        let path = error
            .slab()
            .map_or("slabs".into(), |slab| format!("slabs[{slab}]"));
        Fault::Slabs(error).at(path)
    })?;
    Ok(directions)
}

fn light_file(light: &Light) -> LightFile {
    let (colour, power) = match light.emission {
        Emission::Colour(colour) => (Some(colour.into()), None),
        Emission::Power(power) => (None, Some(power)),
    };
    LightFile {
        name: light.name.clone(),
        position: light.position.into(),
        colour,
        power,
    }
}
