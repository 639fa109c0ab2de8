//! HTML: a `pre` with the plain text, each line in a `span` that says what it is and which steps it is about.

use std::fmt::Write as _;

use crate::explain::page::{Line, Page, Tone};
use crate::explain::render::{Hint, hint_of};

/// A style for the tones, in a page's own colours where it has some. It is no part of a fragment, which a page may hold
/// many of.
pub const STYLE: &str = "\
.raystep-log .heading { font-weight: bold; }
.raystep-log .found { color: var(--raystep-found, #1a7f37); }
.raystep-log .refused { color: var(--raystep-refused, #9a6700); }
.raystep-log .aside, .raystep-log .folded { color: var(--raystep-aside, #57606a); }
";

/// The style of a whole document, which has light and dark colours of its own, as the reader's system asks for.
const DOCUMENT_STYLE: &str = "\
:root { color-scheme: light dark; color: #1f2328; background: #ffffff; }
@media (prefers-color-scheme: dark) {
  :root { color: #e6edf3; background: #0d1117;
    --raystep-found: #56d364; --raystep-refused: #e3b341; --raystep-aside: #9198a1; }
}
pre { white-space: pre-wrap; line-height: 1.4; }
";

/// The page as a fragment of HTML, on one line. Its text is the plain text.
pub fn html(page: &Page, hint: Hint) -> String {
    // a book's highlighter would take the spans out of what it believes to be code
    let mut html = String::from("<pre class=\"raystep-log\"><code class=\"nohighlight\">");
    for (number, line) in page.lines.iter().enumerate() {
        if 0 < number {
            html.push_str(&escaped("\n"));
        }
        if line.gap {
            html.push_str(&escaped("\n"));
        }
        html.push_str(&"  ".repeat(line.indent));
        html.push_str(&opening(line));
        html.push_str(&whole_words(&escaped(&line.text)));
        html.push_str(&escaped(&hint_of(line, hint)));
        html.push_str("</span>");
    }
    html.push_str("</code></pre>");
    html
}

/// The page as a whole document, with a title and a style of its own.
pub fn html_document(page: &Page, hint: Hint) -> String {
    let title = page.lines.first().map_or("", |line| line.text.as_str());
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>{}</title>\n\
         <style>\n{STYLE}{DOCUMENT_STYLE}</style>\n</head>\n<body>\n{}\n</body>\n\
         </html>\n",
        escaped(title),
        html(page, hint)
    )
}

/// The start of a line: its tone, its ray, its part, its first and its last step.
fn opening(line: &Line) -> String {
    let class = match line.tone {
        Tone::Heading => "heading",
        Tone::Plain => "plain",
        Tone::Found => "found",
        Tone::Refused => "refused",
        Tone::Aside => "aside",
        Tone::Folded(_) => "folded",
    };
    let mut tag = format!("<span class=\"{class}\"");
    // writing into a String does not fail
    if let Some(ray) = line.ray {
        let _ = write!(tag, " data-ray=\"{ray}\"");
    }
    if let Some(part) = line.part {
        let _ = write!(tag, " data-part=\"{}\"", part.id());
    }
    if let Some(steps) = line.steps {
        let _ = write!(
            tag,
            " data-first=\"{}\" data-last=\"{}\"",
            steps.first, steps.last
        );
    }
    tag.push('>');
    tag
}

/// Text as HTML has it. A line break becomes a reference, so that a fragment stays on one line; braces, dollars,
/// backslashes and backticks too, so that no preprocessor and no reader of formulas takes a name for its own.
pub(crate) fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\n' | '{' | '}' | '$' | '\\' | '`' => {
                let _ = write!(html, "&#{};", u32::from(c));
            }
            _ => html.push(c),
        }
    }
    html
}

/// HTML in which a browser breaks no line.
pub(crate) fn whole(html: &str) -> String {
    format!("<span style=\"white-space: nowrap\">{html}</span>")
}

/// Escaped text whose words with a hyphen stay whole: a browser would break `--only`, `1e-9` and `->` behind it.
pub(crate) fn whole_words(text: &str) -> String {
    /// A longer word may be broken: on a phone a line has few letters more.
    const LONGEST: usize = 28;
    let mut out = String::with_capacity(text.len());
    for piece in text.split_inclusive(char::is_whitespace) {
        let word = piece.trim_end();
        if word.contains('-') && word.len() <= LONGEST {
            out.push_str(&whole(word));
            out.push_str(&piece[word.len()..]);
        } else {
            out.push_str(piece);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_with_a_hyphen_stay_whole_and_long_ones_do_not() {
        let long = "lessons/07-reflection-refraction/scene.json";
        let html = whole_words(&format!("step --at 5 {long} 1e-9·max"));
        let [at, number] = ["--at", "1e-9·max"].map(whole);
        assert_eq!(html, format!("step {at} 5 {long} {number}"));
        assert_eq!(whole_words("no such word\n"), "no such word\n");
    }

    /// The relative luminance of a colour `#rrggbb` (WCAG 2.2).
    fn luminance(colour: &str) -> f64 {
        let channel = |at: usize| {
            let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                ((value + 0.055) / 1.055).powf(2.4)
            }
        };
        0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
    }

    fn colours(style: &str) -> Vec<&str> {
        let starts = style.match_indices('#').map(|(at, _)| at);
        starts.map(|at| &style[at..at + 7]).collect()
    }

    #[test]
    fn letters_of_a_document_have_a_contrast_of_4_5_in_light_and_in_dark() {
        let (light, dark) = DOCUMENT_STYLE.split_once("@media").unwrap();
        let [text, background] = colours(light)[..] else {
            panic!("{light}");
        };
        let [dark_text, dark_background, ref tones @ ..] = colours(dark)[..] else {
            panic!("{dark}");
        };
        assert_eq!((colours(STYLE).len(), tones.len()), (3, 3));
        let of_light = colours(STYLE).into_iter().chain([text]);
        let of_light = of_light.map(|letters| (letters, background));
        let of_dark = tones.iter().copied().chain([dark_text]);
        let of_dark = of_dark.map(|letters| (letters, dark_background));
        for (letters, paper) in of_light.chain(of_dark) {
            let [one, other] = [letters, paper].map(luminance);
            let contrast = (one.max(other) + 0.05) / (one.min(other) + 0.05);
            assert!(4.5 <= contrast, "{letters} on {paper}: {contrast}");
        }
    }
}
