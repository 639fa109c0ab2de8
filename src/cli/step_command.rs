//! The commands that lead to the step of a question, and to its figure.

use std::path::Path;

use raystep::lesson::question::Asked;
use raystep::{Settings, StrategyName, Through};

use crate::cli::typed::quoted;
use crate::cli::word::word;

/// `raystep step lessons/04-sphere/roots.json 38,15 --strategy exhaustive --at 2`
pub(crate) fn step_command(asked: &Asked, folder: &Path) -> String {
    let place = &asked.place;
    let scene = folder.join(&place.lesson).join(&place.scene);
    let [x, y] = place.pixel;
    let step = place.step.to_string();
    let mut words = vec!["raystep".into(), "step".into(), scene.display().to_string()];
    words.push(format!("{x},{y}"));
    words.extend(options(&asked.traced.settings));
    if step.starts_with("#building") {
        words.push("--building".into());
    }
    words.extend(["--at".into(), step]);
    let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    words.join(" ")
}

/// `raystep figure 04-sphere/graze -o graze.svg`
pub(crate) fn figure_command(figure: &str, folder: &Path) -> String {
    let file = figure.rsplit('/').next().unwrap_or(figure);
    let mut words = vec!["raystep".into(), "figure".into(), figure.to_owned()];
    if folder != Path::new("lessons") {
        let folder = if folder == Path::new("") {
            "."
        } else {
            &folder.to_string_lossy()
        };
        words.extend(["--lessons".into(), folder.into()]);
    }
    words.extend(["-o".into(), format!("{file}.svg")]);
    let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    words.join(" ")
}

/// The options that make these settings.
fn options(of: &Settings) -> Vec<String> {
    let usual = Settings::default();
    let (structure, usual_structure) = (of.structure, usual.structure);
    let mut options = Vec::new();
    let mut add = |name: &str, value: String| options.extend([format!("--{name}"), value]);
    add("strategy", word(of.strategy).into());
    if of.transport != usual.transport {
        add("transport", word(of.transport).into());
    }
    if of.through != Through::Centres {
        add("through", word(of.through).into());
    }
    let is_tree = matches!(of.strategy, StrategyName::Hierarchy | StrategyName::Heap);
    if structure.volume != usual_structure.volume && of.strategy == StrategyName::Bounds {
        add("volume", word(structure.volume).into());
    }
    if structure.slabs != usual_structure.slabs && (is_tree || of.strategy == StrategyName::Bounds)
    {
        add("slabs", word(structure.slabs).into());
    }
    if structure.build != usual_structure.build && is_tree {
        add("build", word(structure.build).into());
    }
    let (grid, usual_grid) = (structure.grid, usual_structure.grid);
    if let Some([i, j, k]) = grid.resolution {
        add("grid", format!("{i},{j},{k}"));
    }
    let (light, usual_light) = (of.light, usual.light);
    if light.seed != usual_light.seed {
        add("seed", light.seed.to_string());
    }
    for (name, value, usual) in [
        ("paths", light.paths, usual_light.paths),
        ("samples", light.samples.into(), usual_light.samples.into()),
        ("nearest", light.nearest.into(), usual_light.nearest.into()),
    ] {
        if value != usual {
            add(name, value.to_string());
        }
    }
    if let Some(bounces) = light.bounces {
        add("bounces", bounces.to_string());
    }
    if let Some(radius) = light.aperture {
        add("aperture", radius.to_string());
    }
    if let Some(map) = light.map {
        add("map", map.to_string());
    }
    if grid.mailboxes != usual_grid.mailboxes {
        options.push("--no-mailboxes".into());
    }
    options
}
