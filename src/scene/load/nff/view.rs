//! The view of an NFF file: the eye, the window and its division into pixels.

use crate::scene::file::{CameraFile, LookAt};
use crate::scene::load::error::LoadError;
use crate::scene::load::nff::reader::Reader;
use crate::scene::load::words::{Entity, Word};

pub(super) const VIEW: &str = "a view is written v, then from x y z, at x y z, up x y z, angle a, hither h and \
                    resolution w h";
impl Reader<'_> {
    /// The keys may come in any order; all but `hither` must be there.
    pub(super) fn view(&mut self, entity: Entity) -> Result<(), LoadError> {
        self.once("camera", entity.what, entity.line)?;
        let (mut from, mut at, mut up) = (None, None, None);
        let (mut angle, mut resolution) = (None, None);
        while let Some((key, path)) = self.words.peek().and_then(key_and_path) {
            self.words.next();
            self.once(
                &format!("camera.{path}"),
                &format!("{:?}", key.text),
                key.line,
            )?;
            let words = &mut self.words;
            let of = Entity::new(entity.what, entity.form, key.line);
            match key.text {
                "from" => from = Some(words.numbers(&of)?),
                "at" => at = Some(words.numbers(&of)?),
                "up" => up = Some(words.numbers(&of)?),
                "angle" => angle = Some(words.numbers(&of)?),
                "resolution" => {
                    let width = words.whole(&Entity { later: 1, ..of })?;
                    resolution = Some([width, words.whole(&of)?]);
                }
                _ => {
                    let [_hither] = words.numbers(&of)?;
                }
            }
        }
        let lacks = |key: &str| {
            let what = format!("the view has no {key:?}");
            self.words.error(entity.line, what, VIEW)
        };
        let [fov_degrees] = angle.ok_or_else(|| lacks("angle"))?;
        self.scene.camera = CameraFile {
            look_at: Some(LookAt {
                cop: from.ok_or_else(|| lacks("from"))?,
                target: at.ok_or_else(|| lacks("at"))?,
                up: up.ok_or_else(|| lacks("up"))?,
                fov_degrees,
            }),
            window: None,
            pixels: resolution.ok_or_else(|| lacks("resolution"))?,
        };
        Ok(())
    }
}

/// A key of a view, and the path of what it gives.
pub(super) fn key_and_path(word: Word<'_>) -> Option<(Word<'_>, &'static str)> {
    let path = match word.text {
        "from" => "look_at.cop",
        "at" => "look_at.target",
        "up" => "look_at.up",
        "angle" => "look_at.fov_degrees",
        "resolution" => "pixels",
        "hither" => "hither",
        _ => return None,
    };
    Some((word, path))
}

#[cfg(test)]
pub(super) mod tests {
    use crate::scene::load::nff::read_nff;

    pub(in crate::scene::load::nff) const VIEW_TEXT: &str =
        "v\nfrom 0 0 6 # the eye\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 4\n";

    #[test]
    fn a_view_needs_all_keys_but_hither_in_any_order() {
        let keys: Vec<&str> = VIEW_TEXT.lines().skip(1).collect();
        for left_out in 0..keys.len() {
            let mut some = keys.clone();
            let name = some.remove(left_out).split(' ').next().unwrap();
            some.reverse();
            let read = read_nff("a.nff", &format!("\nv {}", some.join("\n")));
            let message = read.err().map(|e| e.to_string()).unwrap_or_default();
            let expected = format!("a.nff, line 2: the view has no {name:?}\n  a view is");
            let told = message.starts_with(&expected);
            assert_eq!(told, name != "hither", "{message}");
        }
        let message = read_nff("a.nff", "# nothing").unwrap_err().to_string();
        let expected = "a.nff: the file has no view\n  a view is written v";
        assert!(message.starts_with(expected), "{message}");
    }
}
