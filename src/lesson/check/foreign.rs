//! A foreign log, pixel by pixel.

use std::collections::{BTreeMap, BTreeSet};
use std::io::BufRead;

use crate::lesson::check::checked::UnknownField;
use crate::lesson::check::error::CheckError;
use crate::lesson::check::line::{Known, Line, Read};
use crate::scene::{LONGEST_LINE, ReadEnd, Scene, gibibytes, read_up_to};
use crate::trace::{Kind, Purpose};

/// The lines of one pixel.
#[derive(Debug)]
pub(super) struct ForeignPixel {
    pub(super) pixel: [u32; 2],
    /// What belongs to no ray: the pixel's point and its colour.
    pub(super) own: Vec<Line>,
    pub(super) rays: Vec<ForeignRay>,
}

/// The lines of one ray.
#[derive(Debug)]
pub(super) struct ForeignRay {
    pub(super) purpose: Option<Purpose>,
    /// The number that the log has for it, and for the ray before.
    pub(super) number: Option<u64>,
    pub(super) parent: Option<u64>,
    pub(super) lines: Vec<Line>,
}

impl ForeignRay {
    /// The line with which it starts, if it has one.
    pub(super) fn start(&self) -> Option<&Line> {
        self.lines.iter().find(|line| line.kind == Kind::Ray)
    }
}

/// The log that is read.
pub(super) struct ForeignLog<'a, R> {
    name: String,
    input: R,
    known: Known<'a>,
    number: u64,
    text: Vec<u8>,
    /// The first line of the next pixel.
    next: Option<Line>,
    /// Those whose lines are read.
    done: BTreeSet<[u32; 2]>,
    ignored: BTreeMap<String, u64>,
    unknown: BTreeMap<(Kind, String), UnknownField>,
}

/// The most unknown keys that are reported for one log.
const MOST_UNKNOWN: usize = 20;

impl<'a, R: BufRead> ForeignLog<'a, R> {
    pub(super) fn new(name: &str, input: R, scene: &'a Scene) -> Self {
        Self {
            name: name.into(),
            input,
            known: Known::of(scene),
            number: 0,
            text: Vec::new(),
            next: None,
            done: BTreeSet::new(),
            ignored: BTreeMap::new(),
            unknown: BTreeMap::new(),
        }
    }

    /// How many lines there were of each kind that is not compared; and the fields that no line of their kind has.
    pub(super) fn aside(self) -> (BTreeMap<String, u64>, Vec<UnknownField>) {
        let mut unknown: Vec<UnknownField> = self.unknown.into_values().collect();
        unknown.sort_by_key(|of| of.line);
        (self.ignored, unknown)
    }

    fn note_unknown(&mut self, line: &Line) {
        for key in &line.unknown {
            let place = (line.kind, key.clone());
            if let Some(known) = self.unknown.get_mut(&place) {
                known.lines += 1;
            } else if self.unknown.len() < MOST_UNKNOWN {
                let found = UnknownField {
                    kind: line.kind,
                    key: key.clone(),
                    line: line.number,
                    lines: 1,
                    near: self.known.nearest_key(line.kind, key),
                };
                self.unknown.insert(place, found);
            }
        }
    }

    /// The lines of the next pixel; `None` at the end.
    pub(super) fn next_pixel(&mut self) -> Result<Option<ForeignPixel>, CheckError> {
        let first = match self.next.take() {
            Some(line) => line,
            None => match self.next_line(None)? {
                Some(line) => line,
                None => return Ok(None),
            },
        };
        let pixel = first.pixel;
        if !self.done.insert(pixel) {
            let [x, y] = pixel;
            return Err(CheckError::Line {
                file: self.name.clone(),
                line: first.number,
                what: format!("pixel {x},{y} comes again, after lines of another pixel"),
                fix: "write all lines of a pixel one after the other; sort the log by its pixels"
                    .into(),
            });
        }
        let mut lines = vec![first];
        while let Some(line) = self.next_line(Some(pixel))? {
            if line.pixel != pixel {
                self.next = Some(line);
                break;
            }
            lines.push(line);
        }
        Ok(Some(in_rays(pixel, lines)))
    }

    /// The next line that can be compared.
    fn next_line(&mut self, pixel: Option<[u32; 2]>) -> Result<Option<Line>, CheckError> {
        loop {
            self.number += 1;
            self.text.clear();
            let end = read_up_to(&mut self.input, b'\n', LONGEST_LINE, &mut self.text);
            let end = end.map_err(|source| CheckError::Read {
                file: self.name.clone(),
                source,
            })?;
            match end {
                ReadEnd::Input if self.text.is_empty() => return Ok(None),
                ReadEnd::Stop | ReadEnd::Input => {}
                ReadEnd::Zero => {
                    return Err(self.wrong(
                        "the line has a byte 0, which text never has".into(),
                        "write the log as UTF-8".into(),
                    ));
                }
                ReadEnd::Limit => {
                    let most = gibibytes(LONGEST_LINE);
                    return Err(self.wrong(
                        format!("the line has more than {most}"),
                        "write one object a line".into(),
                    ));
                }
            }
            let text = trimmed(&self.text, self.number == 1);
            if text.is_empty() {
                continue;
            }
            match Line::read(text, self.number, &self.known, pixel) {
                Ok(Read::Line(line)) => {
                    self.note_unknown(&line);
                    return Ok(Some(*line));
                }
                Ok(Read::Aside(kind)) => *self.ignored.entry(kind).or_default() += 1,
                Err(wrong) => return Err(self.wrong(wrong.what, wrong.fix)),
            }
        }
    }

    fn wrong(&self, what: String, fix: String) -> CheckError {
        CheckError::Line {
            file: self.name.clone(),
            line: self.number,
            what,
            fix,
        }
    }
}

/// A line without white space around it, and the first one without the mark of UTF-8.
fn trimmed(text: &[u8], is_first: bool) -> &[u8] {
    let text = match text.strip_prefix(b"\xef\xbb\xbf") {
        Some(rest) if is_first => rest,
        _ => text,
    };
    text.strip_suffix(b"\n").unwrap_or(text).trim_ascii()
}

/// Puts the lines of a pixel together into rays: by their numbers, or by their purposes.
fn in_rays(pixel: [u32; 2], lines: Vec<Line>) -> ForeignPixel {
    let mut found = ForeignPixel {
        pixel,
        own: Vec::new(),
        rays: Vec::new(),
    };
    for line in lines {
        if matches!(line.kind, Kind::Pixel | Kind::PixelColour) {
            found.own.push(line);
            continue;
        }
        let place = place_of(&found.rays, &line);
        let place = place.unwrap_or_else(|| {
            found.rays.push(ForeignRay {
                purpose: None,
                number: line.ray,
                parent: None,
                lines: Vec::new(),
            });
            found.rays.len() - 1
        });
        let ray = &mut found.rays[place];
        ray.purpose = ray.purpose.or(line.purpose);
        if line.kind == Kind::Ray {
            ray.parent = line.parent;
        }
        ray.lines.push(line);
    }
    found
}

/// The ray that a line belongs to; `None` if it is the first of one.
fn place_of(rays: &[ForeignRay], line: &Line) -> Option<usize> {
    if let Some(number) = line.ray {
        return rays.iter().position(|ray| ray.number == Some(number));
    }
    if line.kind == Kind::Ray {
        return None;
    }
    // the shade of a point belongs to the ray that hit it, not to the shadow rays from it
    let of_hit = matches!(line.kind, Kind::LightTerm | Kind::Shade | Kind::Refraction);
    // and it is often written behind them
    let purpose = line
        .purpose
        .filter(|purpose| !(of_hit && *purpose == Purpose::Shadow));
    let fits = |ray: &ForeignRay| match purpose {
        Some(purpose) => ray.purpose.is_none_or(|of| of == purpose),
        None => !(of_hit && ray.purpose == Some(Purpose::Shadow)),
    };
    // what a ray has once belongs to the ray around it, if it has one already: it is written behind the deeper ray
    let is_once = of_hit || line.kind == Kind::RayEnd;
    let has_it = |ray: &ForeignRay| {
        let mut lines = ray.lines.iter();
        lines.any(|of| of.kind == line.kind && of.fields.get("light") == line.fields.get("light"))
    };
    let without = rays.iter().rposition(|ray| fits(ray) && !has_it(ray));
    without
        .filter(|_| is_once)
        .or_else(|| rays.iter().rposition(fits))
}
