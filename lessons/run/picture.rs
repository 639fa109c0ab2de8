//! Your own picture: the simple ray tracer with your functions, beside the reference and the difference.
//!
//! `cargo run -p lessons` draws it; `cargo run -p lessons -- gallery` draws each mistake the same way.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;

use glam::DVec3;
use lessons::attempts::attempts;
use lessons::parts::{PARTS, Yours};
use lessons::{files, run};
use raystep::mistake::mistakes;
use raystep::tracer::Picture;
use raystep::tracer::simple::{Own, Parts, picture};
use raystep::{NoFiles, Scene, load_bytes};

/// A ball of each kind, a floor, two lamps: something to see for each lesson.
const SCENE: &str = include_str!("scene.json");
/// Seconds of CPU time for each check.
const SECONDS: u64 = 10;
/// Columns between two pictures.
const GAP: usize = 2;

fn main() -> ExitCode {
    // the checks are run by this program, each in a process of its own
    if run::be_child(attempts) {
        return ExitCode::SUCCESS;
    }
    let words: Vec<String> = std::env::args().skip(1).collect();
    let drawn = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => yours(),
        ["gallery"] => gallery(),
        _ => Err("this program knows one word: gallery".into()),
    };
    match drawn {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("error: {what}");
            ExitCode::FAILURE
        }
    }
}

fn scene() -> Result<Scene, String> {
    let loaded = load_bytes("scene.json", SCENE.as_bytes(), &NoFiles);
    let loaded = loaded.map_err(|error| error.to_string())?;
    loaded.build().map_err(|error| error.to_string())
}

/// The picture with all functions that are right.
fn yours() -> Result<(), String> {
    let scene = scene()?;
    let ids = PARTS.map(str::to_owned);
    let reports = run::check(&ids, SECONDS, |_| ());
    let right = reports.iter().filter(|report| report.state() == "right");
    let mine = Yours(
        right
            .map(|report| report.text("exercise").to_owned())
            .collect(),
    );
    for report in &reports {
        let mark = match report.state() {
            "right" => '●',
            "not written" => '○',
            _ => '◐',
        };
        say(&format!("{mark} {}", report.text("exercise")));
    }
    say(&format!(
        "{} of {} parts are yours; the others are the crate's.",
        mine.0.len(),
        PARTS.len()
    ));
    let file = files::written().join("picture.png");
    show(
        &file,
        &picture(&scene, &mine),
        &picture(&scene, &Own),
        "yours",
    )
}

/// A picture with each mistake that makes one.
fn gallery() -> Result<(), String> {
    let scene = scene()?;
    let reference = picture(&scene, &Own);
    let folder = files::written().join("gallery");
    for mistake in mistakes().filter(|mistake| mistake.wrong.is_part()) {
        let name: String = mistake
            .name
            .chars()
            .map(|c| if c.is_alphanumeric() { c } else { '-' })
            .collect();
        say(&format!("\n{}: {}", mistake.name, mistake.sentence));
        let wrong = of_parts(&scene, &mistake.wrong);
        show(
            &folder.join(format!("{name}.png")),
            &wrong,
            &reference,
            "the mistake",
        )?;
    }
    Ok(())
}

fn of_parts(scene: &Scene, parts: &impl Parts) -> Picture {
    picture(scene, parts)
}

/// In the terminal and as PNG: a picture, the reference, and the difference.
fn show(file: &Path, drawn: &Picture, reference: &Picture, name: &str) -> Result<(), String> {
    let pairs = drawn.colours.iter().zip(&reference.colours);
    let difference = Picture {
        pixels: reference.pixels,
        colours: pairs.map(|(a, b)| difference(*a, *b)).collect(),
    };
    let all = [drawn, reference, &difference];
    say(&format!("{name}, the reference, and the difference:"));
    let [width, height] = reference.pixels.map(|side| side as usize);
    let images = all.map(Picture::bytes);
    if 3 * width + 2 * GAP <= columns() {
        blocks(&images, [width, height]);
    } else {
        for image in &images {
            blocks(std::slice::from_ref(image), [width, height]);
            say("");
        }
    }
    write_png(file, &images, [width, height])
        .map_err(|error| format!("{}: {error}", file.display()))?;
    let off = difference
        .colours
        .iter()
        .filter(|colour| 0.0 < colour.max_element())
        .count();
    say(&format!(
        "{off} of {} pixels differ; {}",
        width * height,
        files::typed(file)
    ));
    if off == 0 && name != "yours" {
        say("This scene does not show it: it needs a special case, which its exercise has.");
    }
    Ok(())
}

/// What differs, ten times as strong: a difference of a tenth is white.
fn difference(a: DVec3, b: DVec3) -> DVec3 {
    // what is no number differs
    let seen = |colour: DVec3| {
        if colour.is_nan() {
            DVec3::splat(2.0)
        } else {
            colour.clamp(DVec3::ZERO, DVec3::ONE)
        }
    };
    let off = (seen(a) - seen(b)).abs();
    if off.max_element() <= 1e-9 {
        DVec3::ZERO
    } else {
        10.0 * off
    }
}

/// How wide the terminal is.
fn columns() -> usize {
    let given = std::env::var("COLUMNS")
        .ok()
        .and_then(|columns| columns.parse().ok());
    given.unwrap_or(80)
}

/// Pictures side by side: a half block has the colour of the upper pixel, and behind it that of the lower one.
fn blocks(images: &[Vec<u8>], [width, height]: [usize; 2]) {
    for row in (0..height).step_by(2) {
        let mut line = String::new();
        for (place, image) in images.iter().enumerate() {
            if 0 < place {
                line += &" ".repeat(GAP);
            }
            for column in 0..width {
                let pixel = |row: usize| {
                    let at = 3 * (row * width + column);
                    image
                        .get(at..at + 3)
                        .map(|of| format!("{};{};{}", of[0], of[1], of[2]))
                };
                let upper = pixel(row).unwrap_or_default();
                line += &match pixel(row + 1) {
                    Some(lower) => format!("\u{1b}[38;2;{upper}m\u{1b}[48;2;{lower}m▀"),
                    None => format!("\u{1b}[49m\u{1b}[38;2;{upper}m▀"),
                };
            }
            line += "\u{1b}[0m";
        }
        say(&line);
    }
}

/// The pictures side by side, each pixel a square of 4.
fn write_png(
    file: &Path,
    images: &[Vec<u8>; 3],
    [width, height]: [usize; 2],
) -> Result<(), Box<dyn std::error::Error>> {
    const SIDE: usize = 4;
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    let wide = SIDE * (3 * width + 2 * GAP);
    let mut bytes = Vec::new();
    for y in 0..SIDE * height {
        for (place, image) in images.iter().enumerate() {
            if 0 < place {
                bytes.extend([255; 3].repeat(SIDE * GAP));
            }
            for x in 0..SIDE * width {
                let at = 3 * (y / SIDE * width + x / SIDE);
                bytes.extend(&image[at..at + 3]);
            }
        }
    }
    let mut encoder = png::Encoder::new(
        BufWriter::new(File::create(file)?),
        wide as u32,
        (SIDE * height) as u32,
    );
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}

/// Whoever reads no further does not want to hear that the pipe is closed.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
