//! The fast way to read a line: straight through, in the order in which the writer writes it.
//!
//! A line that is written in any other way, or is damaged, is left to
//! [`line_reader`](crate::trace::log::line_reader), which reads all JSON and says what is wrong.

use crate::scene::PrimitiveId;
use crate::trace::event::fields::{Field, Fields, ValueReader, Visitor, Word};
use crate::trace::log::fast::scanner::Scanner;
use crate::trace::log::name_table::NameTable;
use crate::trace::{Kind, Record};

/// Fills in the record that a line holds, if each of its bytes is where the writer puts it.
///
/// Else it gives `None`, and what the record holds means nothing.
#[inline]
pub(in crate::trace::log) fn scan_event(
    line: &[u8],
    names: &NameTable,
    record: &mut Record,
) -> Option<()> {
    let mut scanner = Scanner::new(std::str::from_utf8(line).ok()?);
    if !scanner.take("{\"kind\":") {
        return None;
    }
    *record = Record::blank(Kind::named(scanner.plain_text()?)?);
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
            .value(|line| T::read(&mut line.scanner).ok())
            .unwrap_or_default();
    }

    #[inline]
    fn optional<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut Option<T>) {
        *value = None;
        if self.scanner.take_key(key) {
            *value = self.value(|line| T::read(&mut line.scanner).ok());
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

/// What is wrong with a value is left to the reader of all JSON.
impl ValueReader for Scanner<'_> {
    type Wrong = ();

    #[inline]
    fn number(&mut self) -> Result<f64, ()> {
        self.next_number().ok_or(())
    }

    #[inline]
    fn whole(&mut self) -> Result<u32, ()> {
        self.whole_number().ok_or(())
    }

    #[inline]
    fn flag(&mut self) -> Result<bool, ()> {
        if self.take("true") {
            return Ok(true);
        }
        if self.take("false") {
            Ok(false)
        } else {
            Err(())
        }
    }

    #[inline]
    fn word<W: Word>(&mut self) -> Result<W, ()> {
        let text = self.plain_text().ok_or(())?;
        let found = W::WORDS.iter().find(|(_, word, _)| *word == text);
        found.map(|(value, ..)| *value).ok_or(())
    }

    #[inline]
    fn list<T: Field, const N: usize>(&mut self) -> Result<[T; N], ()> {
        let mut items = [T::default(); N];
        for (i, item) in items.iter_mut().enumerate() {
            if !self.take(if i == 0 { "[" } else { "," }) {
                return Err(());
            }
            *item = T::read(self)?;
        }
        if self.take("]") { Ok(items) } else { Err(()) }
    }

    fn wrong(&mut self, _: &'static str) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::trace::log::fast::samples::{records, scene};
    use crate::trace::log::line_reader::read_event;
    use crate::trace::{LogNames, write_event};

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
        let mut record = Record::blank(Kind::Ray);
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
