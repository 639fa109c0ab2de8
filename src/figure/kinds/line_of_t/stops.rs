//! The ray that is drawn, on two scales of t, and the points of it that have a name.

use glam::DVec3;

use crate::figure::error::FigureError;
use crate::figure::subject::Figure;
use crate::geometry::Ray;
use crate::trace::{Event, RayEnd, RayStart};

/// The ray twice, and what it hits.
pub(super) struct Line {
    /// With Δ from the COP to the window.
    pub(super) to_window: Ray,
    pub(super) window_step: u32,
    /// With |Δ| = 1.
    pub(super) unit: RayStart,
    pub(super) unit_step: u32,
    pub(super) end: RayEnd,
    pub(super) end_step: u32,
}

/// Which point it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    BehindCop,
    Cop,
    PixelCentre,
    Hit,
}

/// A point of the line with its t on both scales.
pub(super) struct Stop {
    pub(super) place: Place,
    pub(super) t: [f64; 2],
    pub(super) point: DVec3,
}

impl Line {
    pub(super) fn find(figure: &Figure) -> Result<Self, FigureError> {
        let drawn = figure.ray()?;
        let steps = drawn.node.ends_at;
        let records = figure.records()?;
        let sample = records.iter().find_map(|record| match &record.event {
            Event::Pixel(sample) => Some((sample, record.step)),
            _ => None,
        });
        let step = |end: Option<usize>| end.map(|at| records[at].step);
        match (sample, drawn.node.start, drawn.node.end, steps.map(step)) {
            (
                Some((sample, window_step)),
                Some(unit),
                Some(end),
                [Some(unit_step), Some(end_step)],
            ) if unit.window_t.is_some() => Ok(Self {
                to_window: Ray::through(unit.ray.origin, sample.point),
                window_step,
                unit,
                unit_step,
                end,
                end_step,
            }),
            _ => Err(FigureError::new(
                "ray",
                "this kind of figure draws an eye ray, and this ray is not one",
                "omit \"ray\", or name an eye ray",
            )),
        }
    }

    /// The t of the window where |Δ| = 1.
    pub(super) fn window_t(&self) -> f64 {
        self.unit.window_t.unwrap_or(1.0)
    }

    /// Behind the COP, the COP, the window, the hit: in the order in which the line passes them.
    pub(super) fn stops(&self) -> Vec<Stop> {
        let window_t = self.window_t();
        let stop = |t: f64, place| Stop {
            place,
            t: [t, t * window_t],
            point: self.to_window.at(t),
        };
        let mut stops = vec![
            stop(-1.0, Place::BehindCop),
            stop(0.0, Place::Cop),
            stop(1.0, Place::PixelCentre),
        ];
        if let Some(t) = self.end.t {
            stops.push(Stop {
                place: Place::Hit,
                t: [t / window_t, t],
                point: self.unit.ray.at(t),
            });
        }
        stops
    }
}

impl Stop {
    /// What it is called; the point behind the COP has no name.
    pub(super) fn name(&self) -> &'static str {
        match self.place {
            Place::BehindCop => "",
            Place::Cop => "COP",
            Place::PixelCentre => "pixel centre",
            Place::Hit => "hit",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stop_has_its_t_on_both_scales() {
        // Δ = (2, 1, −2) of length 3; the hit at a distance of 9
        let to_window = Ray::through(DVec3::new(1.0, 0.0, 6.0), DVec3::new(3.0, 1.0, 4.0));
        let (unit, window_t) = to_window.normalised().unwrap();
        let line = Line {
            to_window,
            window_step: 0,
            unit: RayStart {
                ray: unit,
                window_t: Some(window_t),
                ..RayStart::default()
            },
            unit_step: 1,
            end: RayEnd {
                t: Some(9.0),
                ..RayEnd::default()
            },
            end_step: 2,
        };
        let stops = line.stops();
        let expected = [
            ([-1.0, -3.0], [-1.0, -1.0, 8.0]),
            ([0.0, 0.0], [1.0, 0.0, 6.0]),
            ([1.0, 3.0], [3.0, 1.0, 4.0]),
            ([3.0, 9.0], [7.0, 3.0, 0.0]),
        ];
        assert_eq!(stops.len(), expected.len());
        for (stop, (t, point)) in stops.iter().zip(expected) {
            assert_eq!(stop.t, t, "{:?}", stop.place);
            let off = (stop.point - DVec3::from(point)).length();
            assert!(off < 1e-12, "{:?}: {}", stop.place, stop.point);
        }
    }
}
