//! What a mistake does to a picture: the right one, the wrong one, and the quantity that differs where it shows first.

use std::fmt;

use crate::mistake::Mistake;
use crate::mistake::at_work::AtWork;
use crate::scene::Scene;
use crate::structure::GridError;
use crate::trace::{LoggedMistake, LoggedPicture, Spoilt};
use crate::tracer::Picture;
use crate::tracer::simple::{Parts, picture, pixel};

/// Why a mistake cannot be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum NotShown {
    /// The scene is too large for a grid.
    Grid(GridError),
    /// No quantity of any ray differs.
    Nothing,
}

impl fmt::Display for NotShown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Grid(error) => error.fmt(f),
            Self::Nothing => write!(f, "the mistake changes nothing in this scene"),
        }
    }
}

impl std::error::Error for NotShown {}

/// The right picture of a scene by the simple ray tracer, and what a mistake makes of it.
///
/// Pixels differ if their colours do in 8 bits a channel. The marked pixel is the first that differs, row by row from the top
/// left; or, where the pictures are equal, the first on one of whose rays a quantity differs. A function of bounds or of a
/// grid is put into a search with those; the object tests and the cells of the whole picture then count as quantities.
///
/// # Errors
/// A scene that is too large, or in which nothing differs.
pub fn shown(scene: &Scene, mistake: &Mistake) -> Result<(LoggedPicture, LoggedMistake), NotShown> {
    let with = |is_watched| AtWork::new(scene, mistake.wrong, is_watched).map_err(NotShown::Grid);
    let (without, unwatched) = (
        AtWork::without(scene, mistake.wrong).map_err(NotShown::Grid)?,
        with(false)?,
    );
    let [right, wrong] = [logged(scene, &without), logged(scene, &unwatched)];
    let watched = |pixel_at: [u32; 2]| -> Result<Vec<Spoilt>, NotShown> {
        let watched = with(true)?;
        pixel(scene, &watched, pixel_at);
        Ok(watched.into_spoilt())
    };
    let [width, height] = scene.camera.pixels;
    let pixels = || (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let colours = |of: &LoggedPicture| of.rgb.as_chunks::<3>().0.to_vec();
    let (of_right, of_wrong) = (colours(&right), colours(&wrong));
    let differs = pixels()
        .zip(of_right.iter().zip(&of_wrong))
        .find(|(_, (right, wrong))| right != wrong);
    let (first, mut spoilt) = match differs {
        Some((first, _)) => (first, watched(first)?),
        None => {
            let mut found = Err(NotShown::Nothing);
            for at in pixels() {
                let spoilt = watched(at)?;
                if !spoilt.is_empty() {
                    found = Ok((at, spoilt));
                    break;
                }
            }
            found?
        }
    };
    // the simple ray tracer looks for the nearest hit of a shadow ray too, so this is more than a strategy with shadow rays takes
    let counts = without.counts().into_iter().zip(unwatched.counts());
    let names = ["object tests to nearest hits", "cells to nearest hits"];
    let of_picture = names.into_iter().zip(counts);
    spoilt.extend(of_picture.filter(|(_, (right, wrong))| right != wrong).map(
        |(quantity, (right, wrong))| Spoilt {
            quantity: quantity.into(),
            right: (right as f64).into(),
            wrong: (wrong as f64).into(),
        },
    ));
    let is_seen = differs.is_some();
    let mistake = LoggedMistake {
        name: mistake.name.into(),
        pixel: first,
        spoilt,
        picture: is_seen.then_some(wrong),
    };
    Ok((right, mistake))
}

/// The picture in 8 bits a channel; what is no number is black.
fn logged(scene: &Scene, parts: &impl Parts) -> LoggedPicture {
    let picture: Picture = picture(scene, parts);
    LoggedPicture {
        pixels: picture.pixels,
        samples: 1,
        rgb: picture.bytes(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mistake::{mistake, mistakes};
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::tracer::simple::Own;

    /// Its only pixel looks along −z.
    fn inside_a_ball() -> Scene {
        one_pixel(&format!(
            r#""ambient":[1,1,1],"background":[0,0,0],"materials":{{"m":{{"colour":[1,0.5,0]}}}},
            "objects":[{}]"#,
            object("ball", "m", &sphere([0.0, 0.0, 0.0], 2.0))
        ))
    }

    fn spoilt_of(scene: &Scene, name: &str) -> Vec<Spoilt> {
        shown(scene, mistake(name).unwrap()).unwrap().1.spoilt
    }

    #[test]
    fn from_the_middle_of_a_ball_of_radius_2_the_first_root_is_minus_2() {
        let scene = inside_a_ball();
        let spoilt = Spoilt {
            quantity: "t of the root".into(),
            right: 2.0.into(),
            wrong: (-2.0).into(),
        };
        assert_eq!(spoilt_of(&scene, "first root always"), [spoilt]);
        let (right, of) = shown(&scene, mistake("inside is a miss").unwrap()).unwrap();
        // ambient·colour, and the background
        assert_eq!(right.rgb, [255, 128, 0]);
        assert_eq!(of.picture.map(|of| of.rgb), Some(vec![0, 0, 0]));
        assert_eq!(of.pixel, [0, 0]);
    }

    #[test]
    fn what_changes_nothing_is_not_shown() {
        let scene = inside_a_ball();
        let found = shown(&scene, mistake("plus 2").unwrap());
        assert_eq!(found.unwrap_err(), NotShown::Nothing);
    }

    #[test]
    fn with_the_right_functions_bounds_and_grid_find_what_testing_every_object_finds() {
        // balls behind each other, and a floor through many cells
        let balls = (0..12).map(|i| {
            let x = f64::from(i % 4) - 1.5;
            let z = -4.0 - 1.5 * f64::from(i / 4);
            object(&format!("b{i}"), "m", &sphere([x, 0.3, z], 0.6))
        });
        let balls: Vec<String> = balls.collect();
        let file = format!(
            r#"{{"camera":{{"look_at":{{"cop":[0.2,0.8,2],"target":[0,0,-5],"up":[0,1,0],"fov_degrees":50}},"pixels":[20,15]}},
            "ambient":[0.2,0.2,0.2],"background":[0,0,0],
            "lights":[{{"name":"l","position":[3,6,1],"colour":[1,1,1]}}],
            "materials":{{"m":{{"colour":[1,0.5,0],"diffuse":0.8,"reflection":0.3}}}},
            "objects":[{}]}}"#,
            balls.join(",")
        );
        let file: crate::scene::SceneFile = serde_json::from_str(&file).unwrap();
        let scene = Scene::new(file).unwrap();
        let expected = picture(&scene, &Own).bytes();
        let structured = mistakes().filter(|of| !of.wrong.is_part());
        for of in structured {
            let without = AtWork::without(&scene, of.wrong).unwrap();
            assert!(picture(&scene, &without).bytes() == expected, "{}", of.name);
        }
    }
}
