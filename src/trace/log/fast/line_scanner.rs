//! The fast way to read a line: straight through, in the order in which the writer writes it.
//!
//! A line that is written in any other way, or is damaged, is left to
//! [`line_reader`](crate::trace::log::line_reader), which reads all JSON and says what is wrong.

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Fields, Visitor};
use crate::trace::log::fast::scanner::Scanner;
use crate::trace::log::line_reader::blank;
use crate::trace::log::name_table::NameTable;
use crate::trace::{Kind, Record};

/// Fills in the record that a line holds, if each of its bytes is where the writer puts it.
///
/// Else it gives `None`, and what the record holds means nothing.
#[inline]
pub(in crate::trace) fn scan_event(
    line: &[u8],
    names: &NameTable,
    record: &mut Record,
) -> Option<()> {
    let mut scanner = Scanner::new(std::str::from_utf8(line).ok()?);
    if !scanner.take("{\"kind\":") {
        return None;
    }
    *record = blank(Kind::named(scanner.plain_text()?)?);
    let mut scan = LineScanner {
        names,
        scanner,
        failed: false,
    };
    record.fields(&mut scan);
    let is_whole = !scan.failed && scan.scanner.take("}") && scan.scanner.is_at_end();
    is_whole.then_some(())
}

/// Takes field after field; once one is not as expected, nothing more counts.
struct LineScanner<'a> {
    names: &'a NameTable,
    scanner: Scanner<'a>,
    failed: bool,
}

impl LineScanner<'_> {
    /// The value after a key that is there.
    #[inline]
    fn value<T>(&mut self, scan: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        let value = scan(self);
        self.failed |= value.is_none();
        value
    }
}

impl Visitor for LineScanner<'_> {
    #[inline]
    fn field<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut T) {
        if !self.scanner.take_key(key) {
            self.failed = true;
            return;
        }
        *value = self
            .value(|line| T::scan(&mut line.scanner))
            .unwrap_or_default();
    }

    #[inline]
    fn optional<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut Option<T>) {
        *value = None;
        if self.scanner.take_key(key) {
            *value = self.value(|line| T::scan(&mut line.scanner));
        }
    }

    #[inline]
    fn object(
        &mut self,
        [name_key, face_key]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        required: bool,
    ) {
        *value = None;
        if !self.scanner.take_key(name_key) {
            self.failed |= required;
            return;
        }
        *value = self.value(|line| {
            let object = line.names.objects.get(line.scanner.plain_text()?)?;
            let mut face = None;
            line.optional::<u32>(face_key, "", &mut face);
            object.primitive(face)
        });
    }

    #[inline]
    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        *value = None;
        if self.scanner.take_key(key) {
            *value = self.value(|line| {
                let object = line.names.objects.get(line.scanner.plain_text()?)?;
                Some(object.place)
            });
        }
    }

    #[inline]
    fn light(&mut self, _: &'static str, value: &mut Option<u32>, required: bool) {
        *value = None;
        if !self.scanner.take_key("light") {
            self.failed |= required;
            return;
        }
        *value = self.value(|line| {
            let name = line.scanner.plain_text()?;
            line.names.lights.get(name).copied()
        });
    }

    fn fail(&mut self, _: &'static str) {
        self.failed = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{QuadraticTest, Root, Roots};
    use crate::scene::{Loaded, Scene, load_bytes};
    use crate::trace::event::kind::KindPlace;
    use crate::trace::log::line_reader::read_event;
    use crate::trace::{Event, LogNames, write_event};
    use glam::DVec3;
    use std::path::Path;

    /// A sphere, a mesh and a light.
    fn scene() -> Scene {
        let text = r#"{
          "camera": { "look_at": { "cop": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0],
                                   "fov_degrees": 40 }, "pixels": [1, 1] },
          "lights": [ { "name": "lämp", "position": [0, 5, 5], "colour": [1, 1, 1] } ],
          "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
          "objects": [
            { "name": "ball", "material": "red",
              "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } },
            { "name": "roof", "material": "red", "shape": { "mesh": { "faces": [
              { "vertices": [[-1, 2, 1], [1, 2, 1], [1, 2, -1]] } ] } } } ]
        }"#;
        let loaded = load_bytes("scene.json", text.as_bytes(), Path::new(""));
        loaded.and_then(Loaded::build).unwrap()
    }

    /// A blank event of every kind, and some with numbers in them.
    fn records() -> Vec<Record> {
        let root = |t| Root {
            t,
            ..Root::default()
        };
        let sphere = Event::SphereTest {
            object: PrimitiveId(0),
            test: QuadraticTest {
                a: 1.0,
                b: -0.125,
                c: 1e-9,
                discriminant: 0.1 + 0.2,
                roots: Roots::Two {
                    near: root(-1.0 / 3.0),
                    far: root(-0.0),
                },
            },
        };
        let edge = Event::Edge {
            object: PrimitiveId(1),
            edge: crate::geometry::EdgeTest {
                index: 12,
                side: -1e-300,
                ..Default::default()
            },
        };
        let colour = Event::PixelColour(crate::trace::PixelColour {
            raw: DVec3::new(0.5, 10.0, 1e22),
            ..Default::default()
        });
        let mut records: Vec<Record> = Kind::ALL.map(placed).into();
        records.extend([sphere, edge, colour].map(|event| Record {
            pixel: Some([123, 4567]),
            step: 98765,
            ray: Some(3),
            event,
            ..blank(Kind::Ray)
        }));
        records
    }

    /// A blank record in a pixel, unless it is of building or of a path of light.
    fn placed(kind: Kind) -> Record {
        let (pixel, path) = match kind.place() {
            KindPlace::Building => (None, None),
            KindPlace::Path => (None, Some(0)),
            KindPlace::Pixel | KindPlace::Either => (Some([0, 0]), None),
        };
        Record {
            pixel,
            path,
            ..blank(kind)
        }
    }

    fn lines(scene: &Scene) -> Vec<Vec<u8>> {
        let names = LogNames::new(scene);
        let line = |record: &Record| {
            let mut line = Vec::new();
            write_event(record, &names, &mut line);
            line
        };
        records().iter().map(line).collect()
    }

    fn scanned(line: &[u8], names: &NameTable) -> Option<Record> {
        let mut record = blank(Kind::Ray);
        scan_event(line, names, &mut record).map(|()| record)
    }

    #[test]
    fn every_line_of_the_writer_is_read_straight_through() {
        let scene = scene();
        let table = NameTable::new(&scene);
        for line in lines(&scene) {
            let text = String::from_utf8_lossy(&line);
            let scanned = scanned(&line, &table);
            assert!(scanned.is_some(), "{text}");
            assert_eq!(scanned, read_event(&line, &table).ok(), "{text}");
        }
    }

    /// What the scanner takes, the reader of all JSON takes for the same: `Debug` tells the zeros apart.
    #[test]
    fn a_changed_line_is_never_read_as_anything_else() {
        let scene = scene();
        let table = NameTable::new(&scene);
        let mut taken = 0;
        for line in lines(&scene) {
            for at in 0..line.len() {
                for byte in *b"0159-+.eE,:\"\\[]{} tfnx\xff" {
                    let mut changed = line.clone();
                    changed[at] = byte;
                    let mut longer = line.clone();
                    longer.insert(at, byte);
                    for line in [changed, longer] {
                        let Some(scanned) = scanned(&line, &table) else {
                            continue;
                        };
                        taken += 1;
                        let read = read_event(&line, &table).ok();
                        let text = String::from_utf8_lossy(&line);
                        assert_eq!(
                            format!("{:?}", Some(scanned)),
                            format!("{read:?}"),
                            "{text}"
                        );
                    }
                }
            }
        }
        assert!(1000 < taken, "{taken}");
    }
}
