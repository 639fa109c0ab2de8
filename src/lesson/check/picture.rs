//! A picture with both: what is expected, and the same with the line of the log in its place.

use std::fmt::Write as _;

use crate::figure::{FigureKind, FigureSpec, Rendition, Traced, Width, draw};
use crate::lesson::check::checked::Divergence;
use crate::lesson::check::value::{Fields, Value};
use crate::lesson::{LessonError, own_figure, wrong_figure};
use crate::scene::Loaded;
use crate::trace::{Kind, LogNames, Record, Transport};

/// Draws the step that a log has wrong, as expected and as the log has it, as one SVG.
///
/// Where the log's numbers contradict each other so that they cannot be drawn, the picture has what is expected alone.
///
/// # Errors
/// A scene that makes no sense, or of which there is no figure of the step.
pub fn picture(loaded: Loaded, file: &str, divergence: &Divergence) -> Result<String, LessonError> {
    let kind = figure_of(divergence.kind);
    // the rays of a pixel can always be drawn
    picture_of(kind, loaded.clone(), file, divergence)
        .or_else(|_| picture_of(FigureKind::Rays, loaded, file, divergence))
}

fn picture_of(
    kind: FigureKind,
    loaded: Loaded,
    file: &str,
    divergence: &Divergence,
) -> Result<String, LessonError> {
    let (mut spec, traced) = own_figure(loaded, kind, divergence.pixel, file)?;
    spec.ray = divergence
        .ray_number
        .filter(|_| spec.transport != Transport::Backward || divergence.ray_number == Some(0));
    if matches!(kind, FigureKind::Sphere | FigureKind::Polygon) {
        spec.object = Some(divergence.subject.clone());
    }
    let drawn = |traced: &[Traced], id: &str| {
        let rendition = Rendition {
            standalone: true,
            ..Rendition::default()
        };
        draw(&spec, traced, id, Width::Book, rendition).map(|drawn| drawn.svg)
    };
    let expected = drawn(&traced, "expected").map_err(|error| wrong_figure(file, error))?;
    let yours =
        with_line(&spec, &traced, divergence).and_then(|traced| drawn(&traced, "yours").ok());
    let mut panels = vec![("expected", expected)];
    panels.extend(
        yours
            .filter(|yours| !is_same(yours, &panels[0].1))
            .map(|svg| ("yours", svg)),
    );
    Ok(stacked(&panels))
}

/// The kind of figure that shows a step.
fn figure_of(kind: Kind) -> FigureKind {
    match kind {
        Kind::SphereTest => FigureKind::Sphere,
        Kind::PlaneTest | Kind::PolygonTest => FigureKind::Polygon,
        Kind::Cell
        | Kind::GridEnter
        | Kind::GridExit
        | Kind::Listed
        | Kind::Mailbox
        | Kind::HitOutsideCell => FigureKind::Grid,
        Kind::LightTerm => FigureKind::Shading,
        Kind::Pixel => FigureKind::Window,
        _ => FigureKind::Rays,
    }
}

/// The trace with the log's fields in place of those of the event; `None` if that is no event.
fn with_line(spec: &FigureSpec, traced: &[Traced], divergence: &Divergence) -> Option<Vec<Traced>> {
    let [first, ..] = traced else {
        return None;
    };
    let names = LogNames::new(&first.scene);
    let ray = spec.ray.or(divergence.ray_number);
    let is_it = |record: &Record| {
        let fields = Fields::of(record, &names);
        record.event.kind() == divergence.kind
            && record.pixel == Some(divergence.pixel)
            && record.ray == ray
            && (divergence.subject.is_empty()
                || ["object", "light"]
                    .iter()
                    .any(|key| fields.text(key) == Some(&divergence.subject)))
    };
    let place = first.records.iter().position(is_it)?;
    let mut log = Vec::new();
    first.write(&mut log).ok()?;
    let text = String::from_utf8(log).ok()?;
    let step = first.records[place].step;
    let lines = text.lines().map(|line| {
        let fields: Fields = serde_json::from_str(line).unwrap_or_default();
        let is_line = fields.text("kind") == Some(divergence.kind.name())
            && fields.number("step") == Some(f64::from(step))
            && fields.list("pixel") == Some(&divergence.pixel.map(f64::from));
        if is_line {
            merged(&fields, divergence)
        } else {
            line.to_owned()
        }
    });
    let log: String = lines.map(|line| line + "\n").collect();
    Traced::read("yours", log.as_bytes()).ok()
}

/// A line with the fields of the log's line in place of its own.
fn merged(own: &Fields, divergence: &Divergence) -> String {
    const PLACE: [&str; 5] = ["kind", "step", "pixel", "ray", "parent"];
    let json = |(key, json): &(String, String)| {
        format!("{}:{json}", serde_json::Value::from(key.as_str()))
    };
    let theirs: Vec<String> = divergence.fields.iter().map(json).collect();
    let theirs: Fields =
        serde_json::from_str(&format!("{{{}}}", theirs.join(","))).unwrap_or_default();
    let mut fields = own.clone();
    for (key, value) in &mut fields.0 {
        if let (false, Some(yours)) = (PLACE.contains(&key.as_str()), theirs.get(key)) {
            *value = yours.clone();
        }
    }
    if matches!(
        divergence.kind,
        Kind::SphereTest | Kind::EllipsoidTest | Kind::ConeTest
    ) {
        with_roots(&mut fields, &theirs);
    }
    let members = fields
        .0
        .iter()
        .map(|(key, value)| json(&(key.clone(), value.json())));
    format!("{{{}}}", members.collect::<Vec<String>>().join(","))
}

/// The roots that follow from the log's numbers, with the verdicts that fit its t: an event says each of them.
fn with_roots(fields: &mut Fields, theirs: &Fields) {
    const FOLLOWING: [&str; 8] = [
        "roots",
        "near",
        "near_verdict",
        "far",
        "far_verdict",
        "verdict",
        "why",
        "t",
    ];
    let number = |key: &str| fields.number(key).unwrap_or(f64::NAN);
    let [a, b, discriminant] = ["a", "b", "discriminant"].map(number);
    fields
        .0
        .retain(|(key, _)| !FOLLOWING.contains(&key.as_str()));
    let mut put = |key: &str, value: Value| fields.0.push((key.into(), value));
    let word = |word: &str| Value::Text(word.into());
    if discriminant < 0.0 || discriminant.is_nan() {
        put("roots", word("none"));
        put("verdict", word("rejected"));
        put("why", word("no_root"));
        return;
    }
    let root = |key: &str, sign: f64| {
        let follows = (sign * discriminant.sqrt() - b) / (2.0 * a);
        theirs.number(key).unwrap_or(follows)
    };
    let [near, far] = [root("near", -1.0), root("far", 1.0)];
    let t = theirs.number("t");
    let takes_far = t.is_some_and(|t| (t - far).abs() < (t - near).abs());
    let of = |root: f64, is_taken: bool, seen: &str| match (t, is_taken) {
        (Some(_), true) => word("chosen"),
        _ if root < 0.0 => word("behind"),
        _ => word(seen),
    };
    let other = if t.is_some() {
        "beyond_nearest"
    } else {
        "back_face"
    };
    put("roots", word("two"));
    put("near", Value::Number(near));
    put("near_verdict", of(near, !takes_far, "front_face"));
    put("far", Value::Number(far));
    put("far_verdict", of(far, takes_far, other));
    match (t, near < 0.0, far < 0.0) {
        (Some(_), _, _) => {
            put("verdict", word("hit"));
            put("t", Value::Number(if takes_far { far } else { near }));
        }
        (None, true, true) => {
            put("verdict", word("rejected"));
            put("why", word("behind"));
        }
        (None, is_behind, _) => {
            put("verdict", word("rejected"));
            put(
                "why",
                word(if is_behind { "back_face" } else { "front_face" }),
            );
        }
    }
}

/// Do both drawings show the same but for their ids?
fn is_same(yours: &str, expected: &str) -> bool {
    yours.replace("yours", "") == expected.replace("expected", "")
}

/// Drawings below each other, each with its title.
fn stacked(panels: &[(&str, String)]) -> String {
    const TITLE: f64 = 26.0;
    let mut top = 0.0;
    let mut body = String::new();
    let mut width: f64 = 0.0;
    for (title, svg) in panels {
        let size = |name: &str| -> f64 {
            let start = svg
                .find(&format!(" {name}=\""))
                .map_or(0, |at| at + name.len() + 3);
            let end = svg[start..].find('"').map_or(start, |at| start + at);
            svg[start..end].parse().unwrap_or(400.0)
        };
        let inner = svg.replacen("<svg ", &format!("<svg y=\"{}\" ", top + TITLE), 1);
        let baseline = top + 0.7 * TITLE;
        let _ = write!(
            body,
            "<text x=\"14\" y=\"{baseline}\" font-size=\"15\" font-weight=\"bold\">{title}</text>\n{inner}\n"
        );
        top += TITLE + size("height");
        width = width.max(size("width"));
    }
    format!(
        "<svg font-family=\"sans-serif\" height=\"{top}\" viewBox=\"0 0 {width} {top}\" width=\"{width}\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <rect fill=\"#ffffff\" height=\"{top}\" width=\"{width}\"/>\n{body}</svg>\n"
    )
}
