//! Values on the command line: pairs and triples of numbers, kinds of event; and what no number may be.

use std::ffi::OsString;

use raystep::scene::nearest_name;
use raystep::trace::Kind;

use crate::cli::Error;

/// No number of this command is negative, and `-1,2` would look like an option: it is refused before
/// the options are read.
pub(crate) fn refuse_negative(arguments: &[OsString]) -> Result<(), Error> {
    let words = arguments.iter().map(|word| word.to_string_lossy());
    let pairs = words.clone().zip(words.skip(1));
    for (before, word) in pairs.take_while(|(_, word)| word != "--") {
        // also as --ray=-1
        let (option, value) = match word.split_once('=') {
            Some((option, value)) if option.starts_with("--") => (option, value),
            _ => (&*before, &*word),
        };
        let digits = value.strip_prefix('-').unwrap_or_default();
        let is_negative = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        // these have a message of their own for all that is none
        if is_negative && !["--density", "--aperture"].contains(&option) {
            let argument = word.into_owned();
            return Err(Error::Negative { argument });
        }
    }
    Ok(())
}

/// `X,Y`; whether the picture has such a pixel is asked later.
pub(super) fn pixel(text: &str) -> Result<[u64; 2], String> {
    pair(text).ok_or_else(|| "give column and row, as in 80,60".into())
}

/// `W,H`.
pub(super) fn pixels(text: &str) -> Result<[u32; 2], String> {
    pair(text).ok_or_else(|| "give width and height, as in 160,120".into())
}

/// `NX,NY,NZ`.
pub(super) fn cells(text: &str) -> Result<[u32; 3], String> {
    let numbers: Vec<u32> = text
        .split(',')
        .map_while(|number| number.trim().parse().ok())
        .collect();
    match (numbers.try_into(), text.matches(',').count()) {
        (Ok(cells), 2) => Ok(cells),
        _ => Err("give the cells along x, y and z, as in 46,46,3".into()),
    }
}

/// Cells for each object.
pub(super) fn density(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(density) if 0.0 < density && density < f64::INFINITY => Ok(density),
        _ => Err("give a number of cells for each object above 0, such as 3".into()),
    }
}

/// A radius that may be 0.
pub(super) fn radius(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(radius) if (0.0..f64::INFINITY).contains(&radius) => Ok(radius),
        _ => Err("give a radius of 0 or more, such as 0.05".into()),
    }
}

/// How far two numbers may differ.
pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(tolerance) if (0.0..1.0).contains(&tolerance) => Ok(tolerance),
        _ => Err("give a number from 0 to below 1, such as 1e-5".into()),
    }
}

pub(super) fn pair<T: std::str::FromStr>(text: &str) -> Option<[T; 2]> {
    let (first, second) = text.split_once(',')?;
    Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
}

/// A kind of event, by its name in the log.
pub(super) fn kind(name: &str) -> Result<Kind, String> {
    Kind::named(name).ok_or_else(|| {
        let names = Kind::ALL.map(Kind::name);
        match nearest_name(name, names.into_iter()) {
            Some(near) => format!("there is no such kind; did you mean {near}?"),
            None => format!("there is no such kind; the kinds are {}", names.join(", ")),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn negative_numbers_are_told_from_options_and_files() {
        let refused = |words: &[&str]| {
            let words: Vec<OsString> = words.iter().map(OsString::from).collect();
            refuse_negative(&words).is_err()
        };
        for words in [
            ["raystep", "-1,2"],
            ["raystep", "--ray=-1"],
            ["raystep", "-.5"],
            ["--ray", "-1"],
        ] {
            assert!(refused(&words), "{words:?}");
        }
        for words in [
            ["raystep", "-"],
            ["raystep", "--ray=1"],
            ["raystep", "-o"],
            ["raystep", "--density=-1"],
            ["--density", "-1"],
        ] {
            assert!(!refused(&words), "{words:?}");
        }
        assert!(!refused(&["raystep", "--", "-1.json"]));
    }
}
