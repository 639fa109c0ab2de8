//! One page of a picture and its pixels, in one file: `raystep inspect`.
//!
//! The page asks one function for a pixel's data (`pixelData` in `inspect.js`): now it finds the data in the page.

use std::fmt::{self, Write};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use serde::Serialize;

use crate::explain::grouped;
use crate::explain::render::escaped;
use crate::figure::{dark_colours, heat_scale};
use crate::page::json::inline_json;
use crate::page::packed::PackedPixel;
use crate::scene::printable;
use crate::step::KEYS;
use crate::trace::png_bytes::{Channels, encoded};

/// What a page holds.
#[derive(Clone, Debug)]
pub struct InspectPage {
    /// Its title: the name of the scene.
    pub title: String,
    /// How it was traced, and what else is to be said of it, a sentence each.
    pub notes: Vec<String>,
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// The picture. A pixel without a colour is clear: four bytes each.
    pub picture: Option<Vec<u8>>,
    /// The heat map.
    pub heat: Option<HeatOverlay>,
    /// The pixels whose steps it holds; not none.
    pub pixels: Vec<PackedPixel>,
    /// The step at which it begins in its first pixel, as an address; the first one without it.
    pub at: Option<String>,
    /// Are questions asked from the beginning?
    pub predicts: bool,
    /// The command that steps through a pixel of it, without the pixel: `raystep step scene.json`; and its options.
    pub command: [String; 2],
}

/// A heat map over the picture.
#[derive(Clone, Debug)]
pub struct HeatOverlay {
    /// Its colours, as many as the picture has pixels. A pixel without a value is clear: four bytes each.
    pub colours: Vec<u8>,
    /// The smallest and the largest value.
    pub range: [f64; 2],
    /// What the values are.
    pub title: String,
}

/// A page that would have more bytes than it may.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PageTooLarge {
    /// The bytes that it would have.
    pub bytes: usize,
    /// The number of its pixels.
    pub pixels: usize,
}

impl std::error::Error for PageTooLarge {}

impl fmt::Display for PageTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let megabytes = self.bytes as f64 / 1e6;
        let pixels = grouped(self.pixels as u64);
        let noun = if self.pixels == 1 { "pixel" } else { "pixels" };
        write!(f, "a page with {pixels} {noun} has {megabytes:.1} MB")
    }
}

/// What the script is told.
#[derive(Serialize)]
struct Told<'a> {
    size: [u32; 2],
    at: Option<&'a str>,
    predicts: bool,
    command: &'a [String; 2],
}

impl InspectPage {
    /// The page as HTML.
    ///
    /// # Errors
    /// It would have more bytes than `most`.
    pub fn html(&self, most: usize) -> Result<String, PageTooLarge> {
        let mut page = String::new();
        self.write(&mut page);
        if most < page.len() {
            return Err(PageTooLarge {
                bytes: page.len(),
                pixels: self.pixels.len(),
            });
        }
        Ok(page)
    }

    fn write(&self, page: &mut String) {
        let title = escaped(&printable(&self.title));
        let mut notes = String::new();
        for note in &self.notes {
            // writing into a String does not fail
            let _ = write!(notes, "<p>{}</p>", escaped(&printable(note)));
        }
        let told = inline_json(&Told {
            size: self.size,
            at: self.at.as_deref(),
            predicts: self.predicts,
            command: &self.command,
        });
        let _ = write!(
            page,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: blob:; \
             style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n\
             <title>{title}</title>\n<style>\n{}@media screen and (prefers-color-scheme: dark) {{ :root {{ {} }} }}\n</style>\n\
             </head>\n<body>\n<header><h1>{title}</h1>{notes}</header>\n<noscript><p>This page shows its steps by a script, \
             and here scripts are off.</p></noscript>\n",
            lean(STYLE),
            dark_colours(),
        );
        page.push_str("<main>\n");
        self.write_picture(page);
        page.push_str(include_str!("inspect.html"));
        page.push_str("</main>\n");
        write_keys(page);
        let _ = writeln!(
            page,
            "<script type=\"application/json\" id=\"page\">{told}</script>"
        );
        for pixel in &self.pixels {
            let [x, y] = pixel.pixel;
            let _ = write!(page, "<script type=\"text/plain\" data-pixel=\"{x},{y}\">");
            for (place, part) in pixel.parts.iter().enumerate() {
                if 0 < place {
                    page.push(' ');
                }
                page.push_str(part);
            }
            page.push_str("</script>\n");
        }
        let _ = write!(
            page,
            "<script>\n(() => {{\n\"use strict\";\n{}}})();\n</script>\n</body>\n</html>\n",
            lean(SCRIPT),
        );
    }

    fn write_picture(&self, page: &mut String) {
        let [width, height] = self.size;
        let style = format!("aspect-ratio: {width} / {height}");
        page.push_str("<section class=\"picture\" aria-label=\"Picture\">\n");
        let _ = write!(page, "<div class=\"layers\" style=\"{style}\">");
        if let Some(picture) = &self.picture {
            let png = encoded(self.size, Channels::RgbAlpha, picture);
            let _ = write!(
                page,
                "<img class=\"colours\" alt=\"The picture\" src=\"{}\">",
                data_uri(&png)
            );
        }
        if let Some(heat) = &self.heat {
            let png = encoded(self.size, Channels::RgbAlpha, &heat.colours);
            let _ = write!(
                page,
                "<img class=\"heat\" hidden alt=\"{}\" src=\"{}\">",
                escaped(&heat.title),
                data_uri(&png)
            );
        }
        page.push_str("<span class=\"mark\"></span></div>\n<div class=\"beside\"><div class=\"magnifier\" role=\"img\"></div><div>\n");
        page.push_str("<p class=\"which\"></p>\n");
        if let Some(heat) = &self.heat {
            let colours = heat_scale().map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}"));
            let [least, most] = heat.range.map(number);
            let _ = writeln!(
                page,
                "<label><input type=\"checkbox\" class=\"heat-on\"> Heat map: {}</label>\n\
                 <div class=\"legend\"><span>{least}</span><span class=\"bar\" \
                 style=\"background: linear-gradient(90deg, {})\"></span><span>{most}</span></div>",
                escaped(&heat.title),
                colours.join(", ")
            );
        }
        page.push_str("</div></div>\n</section>\n");
    }
}

const STYLE: &str = concat!(include_str!("core.css"), include_str!("inspect.css"));

const SCRIPT: &str = concat!(include_str!("core.js"), include_str!("inspect.js"));

/// A script or a style sheet without comments on lines of their own, indents and empty lines. No text in them goes over lines.
fn lean(text: &str) -> String {
    let mut lean = String::new();
    let lines = text.lines().map(str::trim_start);
    for line in lines.filter(|line| !line.is_empty() && !line.starts_with("//")) {
        lean.push_str(line);
        lean.push('\n');
    }
    lean
}

/// The table of all keys.
fn write_keys(page: &mut String) {
    page.push_str(
        "<dialog id=\"keys\" aria-labelledby=\"keys-title\"><h2 id=\"keys-title\">Keys</h2>\n<table>\n",
    );
    // a page has no end, and another strategy needs another page
    let has_page = |key: &&crate::step::Key| !matches!(key.words, ["q" | "x", ..]);
    for key in KEYS.iter().filter(has_page) {
        let _ = writeln!(
            page,
            "<tr><th scope=\"row\"><kbd>{}</kbd> {}</th><td>{}</td></tr>",
            escaped(key.key),
            escaped(key.argument),
            escaped(key.does)
        );
    }
    page.push_str("<tr><th scope=\"row\"><kbd>W</kbd></th><td>who set a value that is named, such as t: choose it in the list</td></tr>\n</table>\n<form method=\"dialog\"><button>Close</button></form></dialog>\n");
}

fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", BASE64.encode(png))
}

/// A count, or the mean of four.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn script_and_style_have_at_most_30_kb_and_ask_for_nothing() {
        let page = [STYLE, SCRIPT].map(lean);
        let bytes: usize = page.iter().map(String::len).sum();
        assert!(bytes <= 30_000, "{bytes}");
        for part in page {
            assert!(!part.contains("http") && !part.contains("url(") && !part.contains("fetch("));
        }
        // a text over several lines would lose its indents
        assert!(
            SCRIPT
                .lines()
                .all(|line| line.matches('`').count() % 2 == 0)
        );
    }

    #[test]
    fn comments_and_indents_are_left_out() {
        let text = "// why\nif (a) {\n  // because\n  b(); // here\n\n}\n";
        assert_eq!(lean(text), "if (a) {\nb(); // here\n}\n");
    }
}
