//! A finished sheet as SVG: the one place that knows the crate `svg`, and how numbers are written in a drawing.
//!
//! A drawing stands alone, in light and dark, and inside a page: there it takes the page's colours from
//! `--fg` and `--bg`, as mdBook's themes have them. Programs that know no variables take the plain colours,
//! which each element has as well. Every id and class begins with the drawing's own name, so that many
//! drawings fit into one page; no line is empty, which would end a block of HTML in Markdown.

use glam::{DVec2, DVec3};
use svg::Document;
use svg::node::element::{Description, Element, Group, Style, Title};
use svg::node::{Blob, Node, Text as Letters};

use crate::explain::{printable, shown};
use crate::figure::sheet::crop;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::labels::place_labels;
use crate::figure::sheet::look::{Colour, Dash, FAINT, Fill, Look};
use crate::figure::sheet::text::Run;
use crate::figure::sheet::{Anchor, Form, Mark, Sheet, Since, Words};

/// For whom a drawing is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rendition {
    /// Shades of grey, for print.
    pub grayscale: bool,
    /// No variables and no style sheet: plain colours on white, the same in any program.
    pub standalone: bool,
    /// The title above the drawing.
    pub titled: bool,
    /// Nothing that comes later.
    pub up_to: Option<UpTo>,
}

/// How far a drawing goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UpTo {
    /// Up to a step of the trace.
    Step(u32),
    /// Up to a stage of the figure's argument, from 1.
    Stage(u32),
}

impl UpTo {
    /// Is something there that is drawn since then?
    pub(in crate::figure) fn holds(self, since: Since) -> bool {
        match self {
            Self::Step(last) => since.step.is_none_or(|step| step <= last),
            Self::Stage(last) => since.stage.is_none_or(|stage| stage.0 < last),
        }
    }
}

/// The variables of all colours with their values on a dark page, as a style sheet has them.
pub(crate) fn dark_colours() -> String {
    dark(&Colour::ALL)
}

fn dark(colours: &[Colour]) -> String {
    let rule = |colour: &Colour| format!("{}: {}", colour.variable(), hexadecimal(colour.dark()));
    colours.iter().map(rule).collect::<Vec<_>>().join("; ")
}

/// A drawing.
pub(in crate::figure) struct Canvas<'a> {
    id: &'a str,
    rendition: Rendition,
}

impl Canvas<'_> {
    /// Writes a sheet. The id is a word of letters, digits and `-`; title and description say what is drawn
    /// to who does not see it.
    pub(in crate::figure) fn write(
        mut sheet: Sheet,
        id: &str,
        [title, description]: [&str; 2],
        rendition: Rendition,
    ) -> String {
        place_labels(&mut sheet);
        let canvas = Canvas { id, rendition };
        let [title_id, description_id] =
            ["title", "description"].map(|part| format!("{id}_{part}"));
        let shown = crop::shown(&sheet);
        let [left, top] = shown.min.to_array().map(number);
        let [width, height] = shown.size().to_array().map(number);
        let mut document = Document::new()
            .set("id", id)
            .set("role", "img")
            .set("aria-labelledby", format!("{title_id} {description_id}"))
            .set("width", width.as_str())
            .set("height", height.as_str())
            .set("viewBox", format!("{left} {top} {width} {height}"))
            .set(
                "font-family",
                "\"Open Sans\", Arial, Helvetica, \"DejaVu Sans\", sans-serif",
            )
            .set("font-size", number(sheet.letters))
            .set("stroke-linejoin", "round")
            .set("stroke-linecap", "butt")
            .add(Title::new(allowed(title)).set("id", title_id))
            .add(
                Description::new()
                    .set("id", description_id)
                    .add(Letters::new(allowed(description))),
            );
        if !rendition.standalone {
            document.assign("style", "max-width: 100%; height: auto");
        }
        if !rendition.standalone && !rendition.grayscale {
            document.append(Style::new(canvas.rules()));
        }
        document.append(canvas.paper(shown));
        for group in canvas.groups(&sheet) {
            document.append(group);
        }
        format!("{document}\n")
    }

    /// What gives the elements the page's colours.
    fn rules(&self) -> String {
        let id = self.id;
        let rules = Colour::ALL.map(|colour| {
            let (name, variable) = (colour.name(), colour.variable());
            let plain = hexadecimal(colour.plain());
            format!(
                ".{id}_{name}-line {{ stroke: var({variable}, {plain}) }} \
                 .{id}_{name}-area {{ fill: var({variable}, {plain}) }}"
            )
        });
        // who knows variables knows @supports; others keep the attributes. The accents have lighter variants in the dark
        // themes of mdBook, which weigh nothing, so that any rule of a page comes before them; a file that stands alone
        // follows its reader's scheme
        format!(
            "@supports (fill: var(--fg)) {{ {} }} \
             :where(.coal, .navy, .ayu) {{ {} }} \
             @media (prefers-color-scheme: dark) {{ svg:root {{ {} }} }}",
            rules.join(" "),
            dark(&Colour::ACCENTS),
            dark_colours(),
        )
    }

    fn paper(&self, shown: Frame) -> Element {
        let mut element = rectangle(shown);
        self.fill(&mut element, Colour::Paper);
        element
    }

    /// What is there from the beginning, then one group for each stage and each step that makes something.
    fn groups(&self, sheet: &Sheet) -> Vec<Group> {
        let marks = sheet.marks.iter().map(|mark| mark.since);
        let mut all: Vec<Since> = marks.chain(sheet.words.iter().map(|of| of.since)).collect();
        // without a stage or a step comes first
        all.sort_unstable();
        all.dedup();
        let shown = |since: &Since| self.rendition.up_to.is_none_or(|last| last.holds(*since));
        let group = |since: Since| {
            let mut group = Group::new();
            if let Some(stage) = since.stage {
                group.assign("data-stage", stage.0 + 1);
            }
            if let Some(step) = since.step {
                group.assign("data-step", step);
            }
            for mark in sheet.marks.iter().filter(|mark| mark.since == since) {
                if mark.look.in_front
                    && let Some(gap) = self.gap(mark, sheet.unit())
                {
                    group.append(gap);
                }
                group.append(self.mark(mark));
            }
            for words in sheet.words.iter().filter(|words| words.since == since) {
                group.append(self.words(words, sheet.letters));
            }
            group
        };
        all.into_iter().filter(shown).map(group).collect()
    }

    /// The ground under a straight line that passes in front; what it begins and ends at keeps its lines.
    fn gap(&self, mark: &Mark, unit: f64) -> Option<Element> {
        /// So much is free on each side, in units of a book's sheet.
        const SIDE: f64 = 2.25;
        /// So much before its ends.
        const END: f64 = 7.0;
        let Form::Path { points, .. } = &mark.form else {
            return None;
        };
        let [from, to] = points[..] else { return None };
        let end = END * unit * (to - from).normalize_or_zero();
        if (to - from).length() <= 2.0 * END * unit {
            return None;
        }
        let look = Look {
            width: mark.look.width + 2.0 * SIDE * unit,
            ..Look::PAPER_LINE
        };
        let form = Form::Path {
            points: vec![from + end, to - end],
            closed: false,
        };
        Some(self.mark(&Mark {
            look,
            form,
            ..*mark
        }))
    }

    fn mark(&self, mark: &Mark) -> Element {
        let mut element = match &mark.form {
            Form::Path { points, closed } => path(points, *closed),
            Form::Ellipse {
                center,
                radii,
                turn,
            } => ellipse(*center, *radii, *turn),
            Form::Rectangle(frame) => rectangle(*frame),
            Form::Image { corners, image } => {
                return image_element(*corners, &image.data_uri(self.rendition.grayscale));
            }
            Form::OnPicture {
                points,
                closed,
                is_white,
                width,
            } => {
                let mut element = path(points, *closed);
                element.assign("fill", "none");
                element.assign("stroke", if *is_white { "#ffffff" } else { "#000000" });
                element.assign("stroke-width", number(*width));
                return element;
            }
        };
        self.look(&mut element, mark.look);
        element
    }

    fn words(&self, words: &Words, usual: f64) -> Blob {
        /// Half the height of a capital in sizes of the letter.
        const HALF_CAPITAL: f64 = 0.36;
        let mut element = Element::new("text");
        element.assign("x", number(words.place.x));
        element.assign("y", number(words.place.y + HALF_CAPITAL * words.size));
        match words.anchor {
            Anchor::Start => {}
            Anchor::Middle => element.assign("text-anchor", "middle"),
            Anchor::End => element.assign("text-anchor", "end"),
        }
        if words.size != usual {
            element.assign("font-size", number(words.size));
        }
        self.fill(&mut element, Colour::Ink);
        // the crate puts line breaks around the elements inside, and a line break in a text is a blank
        let empty = element.to_string();
        let start = empty.strip_suffix("/>").unwrap_or(&empty);
        Blob::new(format!(
            "{start}>{}</text>",
            runs(&words.text.runs, words.size)
        ))
    }

    fn look(&self, element: &mut Element, look: Look) {
        if look.fill == Fill::Empty {
            element.assign("fill", "none");
        } else {
            self.fill(element, look.colour);
        }
        if look.fill == Fill::Faint {
            element.assign("fill-opacity", number(FAINT));
        }
        if look.width <= 0.0 {
            return;
        }
        self.class(element, look.colour, "line");
        let stroke = hexadecimal(self.colour(look.colour));
        element.assign("stroke", stroke);
        element.assign("stroke-width", number(look.width));
        let pattern = |lengths: &[f64]| {
            let lengths: Vec<String> = lengths.iter().map(|&of| number(of)).collect();
            lengths.join(" ")
        };
        // in widths of the line, and not finer than can be seen
        let w = look.width.max(1.25);
        let dashes = match look.dash {
            Dash::Solid => return,
            Dash::Dashed => pattern(&[4.0 * w, 3.0 * w]),
            Dash::Dotted => pattern(&[w, 2.0 * w]),
            Dash::Alternating => pattern(&[5.0 * w, 2.0 * w, w, 2.0 * w]),
            Dash::TwoDots => pattern(&[5.0 * w, 2.0 * w, w, 1.5 * w, w, 2.0 * w]),
            Dash::Long => pattern(&[9.0 * w, 2.0 * w]),
        };
        element.assign("stroke-dasharray", dashes);
    }

    fn fill(&self, element: &mut Element, colour: Colour) {
        self.class(element, colour, "area");
        element.assign("fill", hexadecimal(self.colour(colour)));
    }

    /// Adds the class by which a page gives the element its own colour.
    fn class(&self, element: &mut Element, colour: Colour, what: &str) {
        if self.rendition.standalone || self.rendition.grayscale {
            return;
        }
        let class = format!("{}_{}-{what}", self.id, colour.name());
        let both = match element.get_attributes().get("class") {
            Some(first) => format!("{first} {class}"),
            None => class,
        };
        element.assign("class", both);
    }

    fn colour(&self, colour: Colour) -> [u8; 3] {
        if self.rendition.grayscale {
            colour.grey()
        } else {
            colour.plain()
        }
    }
}

/// The letters of a text, those that are set in another way inside `tspan`s.
fn runs(runs: &[Run], size: f64) -> String {
    let mut text = String::new();
    // how far below the line the last letters stand
    let mut below = 0.0;
    for run in runs {
        let letters = Letters::new(allowed(&run.letters));
        let drop = run.level.drop() - below;
        below = run.level.drop();
        let mut attributes = String::new();
        if drop != 0.0 {
            attributes = format!(" dy=\"{}\"", number(drop * size));
        }
        if run.level.size() != 1.0 {
            attributes.push_str(" font-size=\"");
            attributes.push_str(&number(run.level.size() * size));
            attributes.push('"');
        }
        if run.italic {
            attributes += " font-style=\"italic\"";
        }
        if attributes.is_empty() {
            text += &letters.to_string();
        } else {
            let set = format!("<tspan{attributes}>{letters}</tspan>");
            text.push_str(&set);
        }
    }
    text
}

fn path(points: &[DVec2], closed: bool) -> Element {
    // the crate's own path data are f32; these numbers are written here
    let mut data = String::new();
    for (place, point) in points.iter().enumerate() {
        data.push(if place == 0 { 'M' } else { 'L' });
        data.push_str(&number(point.x));
        data.push(' ');
        data.push_str(&number(point.y));
    }
    if closed {
        data.push('Z');
    }
    let mut element = Element::new("path");
    element.assign("d", data);
    element
}

fn rectangle(frame: Frame) -> Element {
    let mut element = Element::new("rect");
    place(&mut element, frame);
    element
}

fn place(element: &mut Element, frame: Frame) {
    let (corner, size) = (frame.min, frame.size());
    for (attribute, value) in [
        ("x", corner.x),
        ("y", corner.y),
        ("width", size.x),
        ("height", size.y),
    ] {
        element.assign(attribute, number(value));
    }
}

/// A picture in a rectangle, or turned and slanted into a parallelogram.
fn image_element([corner, right, below]: [DVec2; 3], uri: &str) -> Element {
    let (across, down) = (right - corner, below - corner);
    let is_upright = across.y == 0.0 && down.x == 0.0 && 0.0 < across.x && 0.0 < down.y;
    let mut element = Element::new("image");
    if is_upright {
        let (min, max) = (corner, corner + across + down);
        place(&mut element, Frame { min, max });
    } else {
        // a square of one unit, which the matrix lays into the parallelogram
        element.assign("width", "1");
        element.assign("height", "1");
        let columns = [across, down, corner].map(|of| of.to_array().map(number).join(" "));
        element.assign("transform", format!("matrix({})", columns.join(" ")));
    }
    element.assign("preserveAspectRatio", "none");
    element.assign("image-rendering", "auto");
    element.assign("href", uri);
    element
}

fn ellipse(center: DVec2, radii: DVec2, turn: f64) -> Element {
    let is_circle = number(radii.x) == number(radii.y);
    let mut element = Element::new(if is_circle { "circle" } else { "ellipse" });
    let [x, y] = center.to_array().map(number);
    element.assign("cx", x.as_str());
    element.assign("cy", y.as_str());
    if is_circle {
        element.assign("r", number(radii.x));
        return element;
    }
    element.assign("rx", number(radii.x));
    element.assign("ry", number(radii.y));
    if number(turn) != "0" {
        element.assign("transform", format!("rotate({} {x} {y})", number(turn)));
    }
    element
}

fn hexadecimal([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number in a drawing: a hundredth of a unit is finer than any screen; what is not finite is 0.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    // + 0 turns -0 into 0
    let text = format!("{:.2}", (value * 100.0).round() / 100.0 + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// A quantity beside a mark, where room is short: three digits.
pub(in crate::figure) fn brief(value: f64) -> String {
    shown(value, 3)
}

/// A quantity in the words of a drawing: four digits, which is what a figure has room for; three and a power of ten
/// where the digits alone would be longer.
pub(in crate::figure) fn quantity(value: f64) -> String {
    /// Below, four digits have more zeros than digits before them.
    const LEAST: f64 = 1e-3;
    /// From here on four digits round to six places or more.
    const MOST: f64 = 99_995.0;
    let size = value.abs();
    if size == 0.0 || (LEAST..MOST).contains(&size) {
        return shown(value, 4);
    }
    let rounded = format!("{size:.2e}");
    let rounded = match rounded.split_once('e') {
        Some((digits, power)) => {
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            format!("{digits}e{power}")
        }
        None => rounded,
    };
    let sign = if value < 0.0 { "−" } else { "" };
    in_powers(&format!("{sign}{rounded}"))
}

/// A number with its power of ten as it is written by hand: 2.36·10⁻¹⁶ for `2.36e-16`, 10⁻⁹ for `1e-9`. Other words stay as
/// they are.
pub(in crate::figure) fn in_powers(number: &str) -> String {
    let parts = number.split_once('e');
    let parts = parts.and_then(|(digits, power)| Some((digits, power.parse::<i32>().ok()?)));
    let Some((digits, power)) = parts else {
        return number.into();
    };
    let power = power_of_ten(power);
    match digits {
        "1" => power,
        _ => format!("{digits}·{power}"),
    }
}

/// 10⁻⁹.
pub(in crate::figure) fn power_of_ten(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let letters = power.to_string();
    let raised = letters.chars().map(|letter| {
        let digit = letter.to_digit(10);
        digit.map_or('⁻', |digit| DIGITS[digit as usize])
    });
    format!("10{}", raised.collect::<String>())
}

/// A point or a vector in the words of a drawing. A coordinate that is rounding beside the largest one is 0.
pub(in crate::figure) fn coordinates(of: DVec3) -> String {
    /// Some thousand roundings of 10⁻¹⁶.
    const ROUNDING: f64 = 1e-12;
    let least = ROUNDING * of.abs().max_element();
    let shown = of
        .to_array()
        .map(|part| quantity(if part.abs() <= least { 0.0 } else { part }));
    format!("({})", shown.join(", "))
}

/// Text that is nothing but text: line breaks become spaces, what controls a terminal or turns the direction of
/// the text around it is written out, and what XML 1.0 does not have is replaced.
fn allowed(text: &str) -> String {
    let spaced = text.replace(['\t', '\n', '\r'], " ");
    printable(&spaced).replace(['\u{fffe}', '\u{ffff}'], "\u{fffd}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::sheet::Width;

    #[test]
    fn numbers_are_short_and_finite() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.001, "0"),
            (760.0, "760"),
            (0.125, "0.13"),
            (-1.5, "-1.5"),
            (f64::NAN, "0"),
            (f64::INFINITY, "0"),
        ] {
            assert_eq!(number(value), expected);
        }
    }

    #[test]
    fn beside_a_mark_a_quantity_has_three_digits() {
        for (value, expected) in [(7.713_85, "7.71"), (-0.25, "−0.25"), (12.0, "12")] {
            assert_eq!(brief(value), expected);
        }
    }

    #[test]
    fn a_quantity_has_four_digits_or_three_and_a_power_of_ten() {
        for (value, expected) in [
            (0.0, "0"),
            (1.0 / 3.0, "0.3333"),
            (-0.001_234, "−0.001234"),
            (0.000_011_85, "1.19·10⁻⁵"),
            (-8.018e-10, "−8.02·10⁻¹⁰"),
            (99_990.0, "99990"),
            (99_999.0, "10⁵"),
            (3.192e9, "3.19·10⁹"),
            (-2e-4, "−2·10⁻⁴"),
        ] {
            assert_eq!(quantity(value), expected);
        }
    }

    #[test]
    fn a_coordinate_that_is_rounding_is_zero() {
        let of = DVec3::new(7.0 + 1e-15, -1e-15, -0.5);
        assert_eq!(coordinates(of), "(7, 0, −0.5)");
        assert_eq!(coordinates(DVec3::ZERO), "(0, 0, 0)");
    }

    #[test]
    fn a_name_cannot_break_the_drawing() {
        let mut sheet = Sheet::new(Width::Book, 100.0);
        sheet.text(Anchor::Start, DVec2::ZERO, "d < e");
        let about = ["<&\"\u{1}", "b\n\nc\u{202e}"];
        let svg = Canvas::write(sheet, "a", about, Rendition::default());
        assert!(svg.contains("&lt;&amp;\"\\u{1}"), "{svg}");
        assert!(svg.contains("b  c\\u{202e}"), "{svg}");
        assert!(svg.contains(">d &lt; e</text>"), "{svg}");
    }

    #[test]
    fn a_later_step_is_left_out_and_moves_nothing() {
        let drawn = |up_to: Option<u32>| {
            let mut sheet = Sheet::new(Width::Book, 100.0);
            for step in [7, 3] {
                let place = DVec2::new(300.0, 50.0);
                let text = format!("step {step}");
                sheet.step(step, |sheet| {
                    sheet.label(sheet.body(), place, DVec2::X, text);
                });
            }
            let rendition = Rendition {
                up_to: up_to.map(UpTo::Step),
                ..Rendition::default()
            };
            Canvas::write(sheet, "a", ["", ""], rendition)
        };
        let (all, first) = (drawn(None), drawn(Some(3)));
        assert!(all.find("data-step=\"3\"") < all.find("data-step=\"7\""));
        assert!(!first.contains("step 7"));
        let line = |svg: &str| {
            let line = svg.lines().find(|line| line.contains("step 3"));
            line.map(str::to_owned)
        };
        assert_eq!(line(&all), line(&first));
    }

    #[test]
    fn what_stands_alone_has_neither_variables_nor_classes() {
        for rendition in [
            Rendition {
                standalone: true,
                ..Rendition::default()
            },
            Rendition {
                grayscale: true,
                ..Rendition::default()
            },
        ] {
            let mut sheet = Sheet::new(Width::Book, 100.0);
            sheet.rectangle(Look::ANSWER, sheet.body());
            let svg = Canvas::write(sheet, "a", ["", ""], rendition);
            assert!(!svg.contains("var(") && !svg.contains("class="), "{svg}");
        }
    }
}
