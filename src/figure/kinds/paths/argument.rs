//! The stages of a figure of paths of light: some paths, those that arrive one by one, what is gathered.

use std::ops::Range;

use crate::explain::{Part, grouped};
use crate::figure::kinds::paths::shown::Shown;
use crate::figure::parts::light_path::Use;
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::stage::StageId;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::trace::Transport;

/// The stages, in their order.
pub(super) struct Argument {
    /// Which of the paths appear at which stage.
    pub(super) paths: Vec<(Range<usize>, StageId)>,
    /// The ray from the eye, where photons are gathered.
    pub(super) eye: Option<StageId>,
    /// The nearest photons.
    pub(super) nearest: Option<StageId>,
    /// What comes of it.
    pub(super) end: StageId,
}

impl Argument {
    pub(super) fn new(figure: &Figure, sheet: &mut Sheet, shown: &Shown) -> Self {
        let radius = aperture(figure, shown);
        sheet.stage("the lamp and the eye", None, match radius {
            Some(radius) => format!(
                "Light leaves the lamp; it reaches the eye through a disc of radius {} around the COP.",
                quantity(radius)
            ),
            None => "Light leaves the lamp and hits the objects of the scene.".to_owned(),
        });
        let paths = groups(figure, shown)
            .into_iter()
            .map(|range| {
                let step = shown.last_step(range.clone());
                let sentence = of_paths(figure, shown, range.clone());
                (range, sheet.stage("paths of light", step, sentence))
            })
            .collect();
        let last = shown.last_step(0..shown.paths.len());
        if shown.transport != Transport::HybridStored {
            let end = sheet.stage("what arrives", last, arrives(figure, shown));
            return Self {
                paths,
                eye: None,
                nearest: None,
                end,
            };
        }
        let gathered = shown.pixels.iter().flat_map(|(_, all)| all);
        let step = gathered.clone().map(|of| of.step).max();
        let first = gathered.clone().filter_map(|of| of.nearby.first());
        let first = first.map(|(step, _)| *step).max().or(step);
        let objects = gathered.clone().map(|of| {
            let object = scenery::name_of(figure.scene, of.gathered.object);
            format!("A ray from the eye hits {object}.")
        });
        let objects: Vec<String> = objects.collect();
        let shows_ray = figure.shows(Layer::Ray);
        let eye = shows_ray.then(|| sheet.stage("eye ray", first, objects.join(" ")));
        let nearest = gathered.clone().filter_map(|of| {
            Some(format!(
                "The {} nearest photons are looked up: the last one sets the radius of the disc, r = {}.",
                of.nearby.len(),
                quantity(of.gathered.radius?)
            ))
        });
        let nearest: Vec<String> = nearest.collect();
        let nearest = sheet.stage("nearest photons", step, nearest.join(" "));
        let working = gathered.map(|of| of.working().join(" "));
        let working: Vec<String> = working.collect();
        let sum = format!(
            "The power of the others over the area of the disc is the irradiance: {}.",
            working.join("; ")
        );
        Self {
            paths,
            eye,
            nearest: Some(nearest),
            end: sheet.stage(Part::Irradiance, step, sum),
        }
    }
}

/// The radius of the eye's aperture, where light must pass it.
pub(super) fn aperture(figure: &Figure, shown: &Shown) -> Option<f64> {
    let light = &figure.first.settings.light;
    let is_forward = shown.transport == Transport::Forward;
    is_forward.then(|| light.aperture_radius(&figure.scene.camera))
}

/// Which paths come together: ten, the rest of the first ones, then those that arrive, one by one if they are few.
fn groups(figure: &Figure, shown: &Shown) -> Vec<Range<usize>> {
    const TEN: usize = 10;
    const FEW: usize = 5;
    let (first, all) = (shown.first(figure), shown.paths.len());
    let mut ends = vec![0];
    if TEN < first {
        ends.push(TEN);
    }
    if 0 < first {
        ends.push(first);
    }
    let is_single = shown.transport == Transport::Forward && all - first <= FEW;
    if is_single {
        ends.extend(first + 1..=all);
    } else if first < all {
        ends.push(all);
    }
    let mut groups: Vec<Range<usize>> = ends.windows(2).map(|pair| pair[0]..pair[1]).collect();
    groups.retain(|range| !range.is_empty());
    groups
}

/// What a group of paths is.
fn of_paths(figure: &Figure, shown: &Shown, range: Range<usize>) -> String {
    let (first, count) = (shown.first(figure), range.len());
    let of = &shown.paths[range.clone()];
    let seen = of
        .iter()
        .filter(|(_, uses)| uses.first() == Some(&Use::Seen))
        .count();
    if shown.transport == Transport::HybridStored {
        let legs = of.iter().flat_map(|(path, _)| &path.legs);
        let photons = legs.filter(|leg| leg.stored.is_some()).count();
        return if range.start < first {
            let which = if range.start == 0 {
                "The first"
            } else {
                "The next"
            };
            format!(
                "{which} {count} paths of light leave {photons} photons where they hit a surface."
            )
        } else {
            format!(
                "{count} further paths leave {photons} photons, some of which the eye ray will gather."
            )
        };
    }
    if range.end <= first {
        let which = if range.start == 0 {
            "The first"
        } else {
            "The next"
        };
        let so = match seen {
            0 => "none of them reaches the eye".to_owned(),
            1 => "one of them reaches the eye".to_owned(),
            several => format!("{several} of them reach the eye"),
        };
        return format!("{which} {count} paths of light: {so}.");
    }
    let told = of.iter().map(|(path, _)| {
        let number = grouped(u64::from(path.start.path) + 1);
        let arrivals = path.legs.iter().filter_map(|leg| leg.arrival);
        let pixels: Vec<String> = arrivals
            .map(|of| format!("({}, {})", of.pixel[0], of.pixel[1]))
            .collect();
        match pixels.len() {
            0 => format!("Path {number} leads to what the eye sees."),
            1 => format!("Path {number} reaches the eye, in pixel {}.", pixels[0]),
            _ => format!(
                "Path {number} reaches the eye, in the pixels {}.",
                pixels.join(", ")
            ),
        }
    });
    told.collect::<Vec<_>>().join(" ")
}

/// How many of the paths that are drawn arrive.
fn arrives(figure: &Figure, shown: &Shown) -> String {
    let (first, drawn) = (shown.first(figure), shown.paths.len());
    let seen = shown.count(Use::Seen);
    let sought = drawn.saturating_sub(first);
    if first == 0 || sought == 0 {
        return format!("Of the {drawn} paths drawn {seen} reach the eye.");
    }
    format!(
        "Of the first {first} of {} paths {} reach the eye; {sought} of the others were sought out, because they arrive.",
        shown.all(),
        seen - sought
    )
}
