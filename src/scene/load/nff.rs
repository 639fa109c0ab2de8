//! NFF, the Neutral File Format of the Standard Procedural Databases (Eric Haines, 1988).
//!
//! An entity is a letter and its numbers, which any white space separates; the material `f` holds for
//! all objects that follow it. The angle spans the window's full height, and Ks is also the weight of
//! the reflected ray. The near plane `hither` is read and not used: a ray begins at the eye.

mod reader;
mod view;

use std::collections::HashMap;

use smol_str::format_smolstr;

use crate::scene::file::{
    CameraFile, LightFile, Material, Materials, ObjectFile, PolygonFile, SceneFile, ShapeFile,
    SidesFile,
};
use crate::scene::load::error::LoadError;
use crate::scene::load::loaded::{Lines, Loaded, Source, Table};
use crate::scene::load::nff::reader::Reader;
use crate::scene::load::nff::view::{VIEW, key_and_path};
use crate::scene::load::words::{Entity, Word, Words, stem};
use crate::scene::quoted;

/// Reads a scene.
///
/// # Errors
/// What is not NFF, with its line.
pub(super) fn read_nff(file: &str, text: &str) -> Result<Loaded, LoadError> {
    let mut reader = Reader {
        words: Words::new(file, text),
        scene: SceneFile {
            name: stem(file).into(),
            camera: CameraFile {
                look_at: None,
                window: None,
                pixels: [0, 0],
            },
            background: [0.0; 3],
            ambient: [0.0; 3],
            lights: Vec::new(),
            materials: Materials::default(),
            objects: Vec::new(),
            max_depth: 5,
            slabs: None,
        },
        material: None,
        kinds: HashMap::new(),
        lines: Table::default(),
    };
    while let Some(word) = reader.words.next() {
        reader.entity(word)?;
    }
    if reader.scene.camera.look_at.is_none() {
        return Err(reader.words.error(None, "the file has no view", VIEW));
    }
    // lights without a colour have √n/(2n) each, which is customary
    let n = reader.scene.lights.len() as f64;
    for light in &mut reader.scene.lights {
        light.colour.get_or_insert([n.sqrt() / (2.0 * n); 3]);
    }
    Ok(Loaded {
        scene: reader.scene,
        notes: Vec::new(),
        files: Vec::new(),
        source: Source {
            file: file.into(),
            lines: Lines::Table(reader.lines),
        },
    })
}

const BACKGROUND: &str = "a background is written b r g b";
const LIGHT: &str = "a light is written l x y z, or l x y z r g b with its colour";
const MATERIAL: &str = "a material is written f r g b Kd Ks shine T index";
const SPHERE: &str = "a sphere is written s x y z r";
const POLYGON: &str = "a polygon is written p n, then n times x y z";
const SMOOTH: &str = "a polygon with normals is written pp n, then n times x y z nx ny nz";
const CONE: &str = "a cone is written c, then bx by bz br and ax ay az ar";

impl Reader<'_> {
    fn entity(&mut self, word: Word<'_>) -> Result<(), LoadError> {
        let line = word.line;
        let of = |what, form| Entity::new(what, form, line);
        if ["s", "p", "pp", "c"].contains(&word.text) && self.material.is_none() {
            let fix = format!("put an f line before it; {MATERIAL}");
            return Err(self
                .words
                .error(line, "an object comes before any material", fix));
        }
        match word.text {
            "v" => self.view(of("the view", VIEW)),
            "b" => self.background(of("the background", BACKGROUND)),
            "l" => self.light(of("the light", LIGHT)),
            "f" => self.material(of("the material", MATERIAL)),
            "s" => self.sphere(of("the sphere", SPHERE)),
            "p" => self.polygon(of("the polygon", POLYGON), false),
            "pp" => self.polygon(of("the polygon", SMOOTH), true),
            "c" => self.cone(of("the cone", CONE)),
            _ => Err(self.no_entity(word)),
        }
    }

    fn no_entity(&self, word: Word<'_>) -> LoadError {
        let name = quoted(word.text);
        let (what, fix) = match self.words.before() {
            Some(of) if looks_like_number(word) => (
                format!(
                    "{name} is one number too many for {} in line {}",
                    of.what, of.line
                ),
                of.form,
            ),
            _ if key_and_path(word).is_some() => (format!("{name} is outside a view"), VIEW),
            _ => (
                format!("{name} is not an entity of NFF"),
                "begin an entity with v, b, l, f, s, p, pp or c, and a comment with #",
            ),
        };
        self.words.error(word.line, what, fix)
    }

    fn background(&mut self, entity: Entity) -> Result<(), LoadError> {
        self.once("background", entity.what, entity.line)?;
        self.scene.background = self.words.numbers(&entity)?;
        Ok(())
    }

    fn light(&mut self, entity: Entity) -> Result<(), LoadError> {
        let position = self.words.numbers(&entity)?;
        let colour = match self.words.peek() {
            Some(word) if word.line == entity.line && looks_like_number(word) => {
                Some(self.words.numbers(&entity)?)
            }
            _ => None,
        };
        let path = format!("lights[{}]", self.scene.lights.len());
        self.lines.others.push((path, entity.line));
        self.scene.lights.push(LightFile {
            name: format!("light-{}", self.scene.lights.len() + 1),
            position,
            colour,
            power: None,
        });
        Ok(())
    }

    fn material(&mut self, entity: Entity) -> Result<(), LoadError> {
        let [red, green, blue, diffuse, specular, shininess, transmission] =
            self.words.numbers(&entity)?;
        let [given] = match self.words.peek() {
            Some(word) if looks_like_number(word) => self.words.numbers(&entity)?,
            _ => [1.0],
        };
        if given == 0.0 && 0.0 < transmission {
            let what = format!("the material transmits (T is {transmission}) with the index 0");
            let fix = "give the index of refraction, such as 1.5 for glass, or make T 0";
            return Err(self.words.error(entity.line, what, fix));
        }
        let index = if given == 0.0 { 1.0 } else { given };
        let material = Material {
            colour: [red, green, blue],
            diffuse,
            specular,
            shininess,
            reflection: specular,
            transmission,
            index,
        };
        let materials = &mut self.scene.materials.0;
        let name = if let Some((name, _)) = materials.iter().find(|(_, known)| *known == material) {
            name.clone()
        } else {
            let name = format!("material-{}", materials.len() + 1);
            let path = format!("materials.{name}");
            self.lines.others.push((path, entity.line));
            materials.push((name.clone(), material));
            name
        };
        self.material = Some(name.into());
        Ok(())
    }

    fn sphere(&mut self, entity: Entity) -> Result<(), LoadError> {
        let [x, y, z, radius] = self.words.numbers(&entity)?;
        let shape = ShapeFile::Sphere {
            center: [x, y, z],
            radius: radius.abs(),
        };
        self.add("sphere", entity.line, shape, radius < 0.0);
        Ok(())
    }

    fn cone(&mut self, entity: Entity) -> Result<(), LoadError> {
        let [bx, by, bz, base_radius, ax, ay, az, apex_radius] = self.words.numbers(&entity)?;
        let radii: [f64; 2] = [base_radius, apex_radius];
        let inside = radii.iter().any(|&radius| radius < 0.0);
        // a tip of −0 is negative too
        if inside && radii.iter().any(|radius| radius.is_sign_positive()) {
            let what =
                format!("one radius of the cone is negative: {base_radius} and {apex_radius}");
            let fix =
                "make both negative (the radius of a tip -0) to show only the inside, or neither";
            return Err(self.words.error(entity.line, what, fix));
        }
        let shape = ShapeFile::Cone {
            base: [bx, by, bz],
            base_radius: base_radius.abs(),
            apex: [ax, ay, az],
            apex_radius: apex_radius.abs(),
        };
        self.add("cone", entity.line, shape, inside);
        Ok(())
    }

    /// The lists grow as vertices are read: the count may be anything.
    fn polygon(&mut self, mut entity: Entity, smooth: bool) -> Result<(), LoadError> {
        let count: u64 = self.words.whole(&entity)?;
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        let width: u64 = if smooth { 6 } else { 3 };
        for left in (0..count).rev() {
            entity.later = left.saturating_mul(width);
            if smooth {
                let [x, y, z, nx, ny, nz] = self.words.numbers(&entity)?;
                vertices.push([x, y, z]);
                normals.push([nx, ny, nz]);
            } else {
                vertices.push(self.words.numbers(&entity)?);
            }
        }
        let shape = ShapeFile::Polygon(PolygonFile {
            vertices: vertices.into(),
            normals: smooth.then(|| normals.into()),
        });
        self.add("polygon", entity.line, shape, false);
        Ok(())
    }

    /// Adds an object with the material that holds here.
    fn add(&mut self, kind: &'static str, line: usize, shape: ShapeFile, inside: bool) {
        use SidesFile::{Back, Both};
        let count = self.kinds.entry(kind).or_insert(0);
        *count += 1;
        self.lines.objects.push(line);
        self.scene.objects.push(ObjectFile {
            name: format_smolstr!("{kind}-{count}"),
            material: self.material.clone().unwrap_or_default(),
            shape,
            sides: if inside { Back } else { Both },
        });
    }
}

/// Does a number begin here, be it right or wrong? No entity begins with these.
fn looks_like_number(word: Word<'_>) -> bool {
    word.text
        .starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

#[cfg(test)]
mod tests {
    use super::view::tests::VIEW_TEXT;
    use super::*;
    use crate::geometry::Sides;
    use crate::scene::Emission;

    const OBJECTS: &str = "b 0 .5 1\nl 1 2 3\nl 1 2 3 .5 .5 1\nf 1 1 1 .5 .25 3 0 0\ns 0 0 0 1\n\
                           f 1 1 1 .5 .25 3 .5 1.5 s 1 0\n0 -2\nf 1 1 1 .5 .25 3 0\n\
                           p 3 0 0 0\n1 0 0 0 1 0\npp 3\n0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n\
                           c\n0 0 0 1\n0 0 2 .5\nc 0 0 0 -1 0 0 2 -0";

    /// The message about lines that follow a view of seven lines.
    #[track_caller]
    fn refused(lines: &str, message: &str) {
        let read = read_nff("a.nff", &format!("{VIEW_TEXT}{lines}")).and_then(Loaded::build);
        let error = read.unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}\n{message}");
    }

    #[test]
    fn every_entity_becomes_its_part_of_the_scene() {
        let text = format!("{VIEW_TEXT}{OBJECTS}");
        let scene = read_nff("x/all.nff", &text).unwrap().build().unwrap();
        assert_eq!((scene.name.as_str(), scene.camera.pixels), ("all", [8, 4]));
        assert_eq!(scene.background.to_array(), [0.0, 0.5, 1.0]);
        // √2/(2·2) = √(1/8) for the first of two lights
        let lights = scene.lights.iter().map(|light| light.emission);
        let shared = Emission::Colour([0.125f64.sqrt(); 3].into());
        let given = Emission::Colour([0.5, 0.5, 1.0].into());
        assert_eq!(lights.collect::<Vec<_>>(), [shared, given]);

        let sides = |i: usize| scene.primitives[i].sides;
        let name = |i: usize| (scene.objects[i].name.as_str(), scene.objects[i].material);
        assert_eq!((name(0), sides(0)), (("sphere-1", 0), Sides::Both));
        assert_eq!((name(1), sides(1)), (("sphere-2", 1), Sides::Back));
        assert_eq!((name(2), name(3)), (("polygon-1", 0), ("polygon-2", 0)));
        assert_eq!((name(4), sides(4)), (("cone-1", 0), Sides::Both));
        assert_eq!((name(5), sides(5)), (("cone-2", 0), Sides::Back));
        let glass = scene.materials.0[1].1;
        let weights = [glass.reflection, glass.transmission, glass.index];
        assert_eq!(weights, [0.25, 0.5, 1.5]);
    }

    #[test]
    fn mistakes_are_told_with_their_line_and_what_to_do() {
        for row in [
            "8: s 0 0 0 1 => : an object comes before any material\n  put an f line before it; a mat",
            "8: f 1 1 1 1 0 0 .8 0 => : the material transmits (T is 0.8) with the index 0\n  give",
            "8: f 1 1 1 -1 0 0 0 => , at materials.material-1.diffuse: the diffuse coefficient is -1",
            "8: q 1 => : \"q\" is not an entity of NFF\n  begin an entity with v, b, l, f, s, p, pp",
            "8: up 0 0 1 => : \"up\" is given twice, first in line 4\n  remove one of them",
            "9: b 0 0 0;b 1 1 1 => : the background is given twice, first in line 8",
            "8: b 0 0 0 9 => : \"9\" is one number too many for the background in line 8\n  a backgr",
            "9: b 0 0 0;v => : the view is given twice, first in line 1",
            "9: b 0 0 0;at 0 0 0 => : \"at\" is outside a view",
            "8: l 1 2 3 1 => : the file ends inside the light that begins in line 8: 2 numbers are",
            "9: F;p 2 0 0 0 1 0 0 => , at objects[0].shape.polygon: a polygon needs at least 3 ver",
            "9: F;p -3 => : \"-3\" is not a whole number, or is too large for the polygon\n  a polygon is",
            "9: F;p 99999999999 1 2 3 4 => : the file ends inside the polygon that begins in line 9: \
             299999999993 numbers are missing\n  add the rest; a polygon",
            "9: F;pp 3 0 0 0 0 0 1 1 0 0 0 0 0 0 1 0 0 0 1 => , at objects[0].shape.polygon: the nor",
            "10: F;s 0 0 0 1;s 0 0 0 0 => , at objects[1].shape.sphere.radius: the radius is 0",
            "9: F;c 0 0 0 -1 0 0 1 2 => : one radius of the cone is negative: -1 and 2\n  make both",
        ] {
            let (line, row) = row.split_once(": ").unwrap();
            let (lines, message) = row.split_once(" => ").unwrap();
            let lines = lines.replace(';', "\n").replace('F', "f 1 1 1 1 0 0 0 0");
            refused(&lines, &format!("a.nff, line {line}{message}"));
        }
    }

    #[test]
    fn no_broken_text_makes_the_reader_panic() {
        let text = format!("{VIEW_TEXT}{OBJECTS}");
        let mut seed = 1u64;
        for round in 0..4000 {
            // with Knuth's factor; the high bits are the good ones
            const FACTOR: u64 = 6_364_136_223_846_793_005;
            seed = seed.wrapping_mul(FACTOR).wrapping_add(1);
            let at = (seed >> 33) as usize % text.len();
            let byte = b"0-.e9pcfv# \n"[(seed >> 20) as usize % 12];
            let mut bytes = text.clone().into_bytes();
            if round % 2 == 0 {
                bytes.truncate(at);
            } else {
                bytes[at] = byte;
            }
            let broken = String::from_utf8(bytes).unwrap();
            if let Ok(loaded) = read_nff("a.nff", &broken) {
                let _ = loaded.build();
            }
        }
    }
}
