//! What each kind of ray tracing costs and brings: a table, JSON, CSV.
//!
//! Slides, "Type of Ray Tracing Algorithm": forward tracing computes much that is never seen. Here that is a number.

use std::time::Duration;

use serde_json::{Value, json};

use crate::explain::table::{aligned, csv_row, wrapped};
use crate::explain::{counts_json, grouped, printable};
use crate::scene::Scene;
use crate::trace::{Counts, Settings, Transport, UsefulRays};

/// The five kinds of ray tracing over the same scene.
#[derive(Clone, Debug)]
pub struct TransportComparison<'a> {
    /// The scene whose light all kinds of ray tracing compute.
    pub scene: &'a Scene,
    /// Each kind, in the order of the slides.
    pub compared: Vec<TransportCost>,
}

/// What one kind cost, and the error of its light.
#[derive(Clone, Debug)]
pub struct TransportCost {
    /// The kind of ray tracing, with its options.
    pub settings: Settings,
    /// The counts of rays and tests, and where the light went.
    pub counts: Counts,
    /// The numbers of rays that were cast and that contributed.
    pub rays: UsefulRays,
    /// The error of the light that hits one surface, against its closed form; `None` where the closed form is 0.
    pub error: Option<ErrorOf>,
    /// The time of the picture, counting included.
    pub time: Duration,
}

/// How far a picture is from its closed form, as shares of the closed form's mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorOf {
    /// The difference of the means, as a share: the error of the picture as a whole.
    pub mean: f64,
    /// The root of the mean square difference of a channel of a pixel, as a share: noise and blur as well.
    pub root_mean_square: f64,
}

impl ErrorOf {
    /// The error of numbers against the expected ones.
    pub fn between(found: &[f64], expected: &[f64]) -> Option<Self> {
        let count = expected.len() as f64;
        let sum: f64 = expected.iter().sum();
        if sum == 0.0 {
            return None;
        }
        let mean = sum / count;
        let off = found
            .iter()
            .zip(expected)
            .map(|(found, expected)| found - expected);
        let square: f64 = off.clone().map(|off| off * off).sum();
        Some(Self {
            mean: off.sum::<f64>() / sum,
            root_mean_square: (square / count).sqrt() / mean,
        })
    }
}

/// The columns after the name: the title in the table, the key in CSV.
const COLUMNS: [(&str, &str); 6] = [
    ("rays", "rays"),
    ("contributed", "contributed"),
    ("waste %", "waste_percent"),
    ("mean error %", "mean_error_percent"),
    ("RMS error %", "rms_error_percent"),
    ("seconds", "seconds"),
];

impl TransportCost {
    fn name(&self) -> &'static str {
        match self.settings.transport {
            Transport::Backward => "backward",
            Transport::HybridLight => "hybrid-light",
            Transport::Forward => "forward",
            Transport::HybridStored => "hybrid-stored",
            Transport::HybridConnected => "hybrid-connected",
        }
    }

    /// One cell for each of [`COLUMNS`].
    fn cells(&self) -> [String; COLUMNS.len()] {
        let percent = |share: f64| {
            let text = format!("{:.2}", 100.0 * share);
            // rounded to nothing, a number has no sign
            if text == "-0.00" { "0.00".into() } else { text }
        };
        let of_error = |part: fn(&ErrorOf) -> f64| {
            self.error
                .as_ref()
                .map(|error| percent(part(error)))
                .unwrap_or_default()
        };
        [
            self.rays.cast.to_string(),
            self.rays.contributed().to_string(),
            self.rays.wasted().map(percent).unwrap_or_default(),
            of_error(|error| error.mean),
            of_error(|error| error.root_mean_square),
            format!("{:.3}", self.time.as_secs_f64()),
        ]
    }

    fn json(&self) -> Value {
        let mut entry = json!({
            "transport": self.settings.transport,
            "rays": self.rays.cast,
            "contributed": self.rays.contributed(),
            "seconds": self.time.as_secs_f64(),
            "counts": counts_json(&self.counts),
        });
        if self.settings.transport.follows_light() {
            entry["light"] = json!(self.settings.light);
        }
        if let Some(wasted) = self.rays.wasted() {
            entry["waste"] = wasted.into();
        }
        if let Some(error) = self.error {
            entry["mean_error"] = error.mean.into();
            entry["rms_error"] = error.root_mean_square.into();
        }
        entry
    }
}

impl TransportComparison<'_> {
    /// What was traced.
    pub fn title(&self) -> String {
        let [width, height] = self.scene.camera.pixels;
        let name = match self.scene.name.as_str() {
            "" => String::new(),
            name => format!("{}: ", printable(name)),
        };
        format!("{name}the light of its lamps, {width} × {height} pixels")
    }

    /// The table as rows of cells, the titles first, without times: the same comparison gives the same cells.
    pub fn rows(&self) -> Vec<Vec<String>> {
        let mut rows = self.table();
        for row in &mut rows {
            row.pop();
        }
        rows
    }

    /// The table without times, what its columns mean, and where forward tracing's paths have gone: 80 columns.
    pub fn text(&self) -> String {
        self.text_of(&self.rows())
    }

    /// The same with the times.
    pub fn wide_text(&self) -> String {
        self.text_of(&self.table())
    }

    fn table(&self) -> Vec<Vec<String>> {
        let mut titles = vec!["transport".to_owned()];
        titles.extend(COLUMNS.map(|(title, _)| title.into()));
        let mut table = vec![titles];
        for cost in &self.compared {
            let mut row = vec![cost.name().to_owned()];
            row.extend(cost.cells());
            table.push(row);
        }
        table
    }

    fn text_of(&self, table: &[Vec<String>]) -> String {
        let mut text = wrapped(&self.title(), "", "  ");
        text.push('\n');
        text += &aligned(table);
        text.push('\n');
        for line in [
            "contributed: rays that carry light into the picture; waste: all other rays",
            "error: of the light that hits one surface, against hybrid-light's closed form at the pixels' centres, \
             Σ colour·diffuse/π · Φ·cos θ/(4π·r²)",
        ] {
            text += &wrapped(line, "", "  ");
        }
        let forward = self
            .compared
            .iter()
            .find(|cost| cost.settings.transport == Transport::Forward);
        if let Some(cost) = forward {
            text += &in_words(&cost.counts);
        }
        text
    }

    /// Everything as JSON, with the full counts of each.
    pub fn json(&self) -> Value {
        let [width, height] = self.scene.camera.pixels;
        json!({
            "scene": self.scene.name,
            "pixels": [width, height],
            "transports": self.compared.iter().map(TransportCost::json).collect::<Vec<_>>(),
        })
    }

    /// A row for each under a row of keys (RFC 4180).
    pub fn csv(&self) -> String {
        let row = |name: &str, cells: [String; COLUMNS.len()]| {
            csv_row(std::iter::once(name).chain(cells.iter().map(String::as_str)))
        };
        let mut text = row("transport", COLUMNS.map(|(_, key)| key.into()));
        for cost in &self.compared {
            text += &row(cost.name(), cost.cells());
        }
        text
    }
}

/// Where the paths of forward tracing went.
fn in_words(counts: &Counts) -> String {
    let light = &counts.light;
    let [paths, hit, left, reached] =
        [light.paths, light.hit, light.left, light.reached_eye].map(grouped);
    let wasted = light.wasted().unwrap_or_default();
    let sentence = format!(
        "forward: of {paths} paths of light {hit} hit a surface, {left} left the scene and {reached} reached the eye; \
         {:.3} % were wasted",
        100.0 * wasted
    );
    format!("\n{}", wrapped(&sentence, "", "  "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_shares_of_the_mean_of_what_is_expected() {
        // mean 2; differences 1, −1, 2: their mean ⅔, their mean square 2
        let error = ErrorOf::between(&[2.0, 1.0, 5.0], &[1.0, 2.0, 3.0]).unwrap();
        assert!((error.mean - 1.0 / 3.0).abs() <= 1e-15);
        assert!((error.root_mean_square - 2.0_f64.sqrt() / 2.0).abs() <= 1e-15);
        assert_eq!(ErrorOf::between(&[1.0], &[0.0]), None);
    }
}
