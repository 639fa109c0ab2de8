//! The fields of the events of light on its way, in the order of the log line.

use glam::DVec3;

use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::kinds::object_field;
use crate::trace::{Alternative, Arrival, Connection, Gathered, Nearby, PathStart, Photon, Stored};

/// A quantity that follows from others in the line, and stands in it for those who look for it alone.
fn derived<V: Visitor>(
    key: &'static str,
    meaning: &'static str,
    value: DVec3,
    why: &'static str,
    v: &mut V,
) {
    let mut found = value;
    v.field(key, meaning, &mut found);
    if found != value {
        v.fail(why);
    }
}

impl Fields for PathStart {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("paths", "how many paths there are", &mut self.paths);
        let mut light = Some(self.light);
        v.light("where it begins", &mut light, true);
        self.light = light.unwrap_or_default();
        v.field(
            "power",
            "what the photon carries, in watts",
            &mut self.power,
        );
    }
}

impl Fields for Photon {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "what was met", v);
        v.field("point", "where", &mut self.point);
        v.field("power", "what arrives, in watts", &mut self.power);
        v.field(
            "chance",
            "the number in 0..1 that decides",
            &mut self.chance,
        );
        v.field(
            "reflection",
            "the chance to be mirrored",
            &mut self.reflection,
        );
        v.field(
            "transmission",
            "the chance to be refracted",
            &mut self.transmission,
        );
        v.field(
            "diffuse",
            "the chance of each channel to go on diffusely",
            &mut self.diffuse,
        );
        v.field("fate", "what became of it", &mut self.fate);
        let leaving = self.leaving();
        let why = "\"leaving\" does not follow from the chance and the fate";
        derived("leaving", "what goes on, in watts", leaving, why, v);
    }
}

impl Fields for Arrival {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "at_pixel",
            "the pixel where its line passes the window",
            &mut self.pixel,
        );
        v.field("window", "where it passes the window", &mut self.window);
        v.field(
            "aperture",
            "where it passes the aperture",
            &mut self.aperture,
        );
        v.field("power", "what it carries, in watts", &mut self.power);
        v.field("geometry", "G = cos^2 theta / d^2", &mut self.geometry);
        v.field("radiance", "what it adds to the pixel", &mut self.radiance);
    }
}

impl Fields for Stored {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "the surface", v);
        v.field("point", "where", &mut self.point);
        v.field(
            "normal",
            "the unit normal on the side that it came from",
            &mut self.normal,
        );
        v.field("power", "what it carries, in watts", &mut self.power);
    }
}

impl Fields for Nearby {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("from_path", "the path that it came on", &mut self.path);
        v.field(
            "surface",
            "the number of the surface on that path, from 1",
            &mut self.surface,
        );
        v.field("point", "where it is stored", &mut self.point);
        v.field("power", "what it carries, in watts", &mut self.power);
        v.field("distance", "how far away it is", &mut self.distance);
    }
}

impl Fields for Gathered {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        object_field(&mut self.object, "the surface", v);
        v.field("point", "the point", &mut self.point);
        v.field("count", "how many photons count", &mut self.count);
        v.optional(
            "radius",
            "how far away the k-th photon is; absent: a cell of a map, or nothing is stored",
            &mut self.radius,
        );
        v.field("area", "what of the surface they lie on", &mut self.area);
        v.field("irradiance", "E: power by area", &mut self.irradiance);
        v.field(
            "radiance",
            "L: what the surface sends to the eye",
            &mut self.radiance,
        );
    }
}

impl Fields for Alternative {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field(
            "edge",
            "the number of the edge, from 1 at the light",
            &mut self.edge,
        );
        v.field("geometry", "G of its two ends", &mut self.geometry);
        v.field(
            "densities",
            "phi at both ends, towards the light first",
            &mut self.densities,
        );
        v.field("share", "1 / (G phi phi')", &mut self.share);
        v.field("chosen", "is it the connection", &mut self.chosen);
    }
}

impl Fields for Connection {
    fn fields<V: Visitor>(&mut self, v: &mut V) {
        v.field("from_path", "the path of light", &mut self.path);
        let mut light_vertex = u32::from(self.light_vertex);
        let mut eye_vertex = u32::from(self.eye_vertex);
        v.field(
            "light_vertex",
            "its vertex: 0 is the light",
            &mut light_vertex,
        );
        v.field(
            "eye_vertex",
            "the vertex of the path from the eye: 0 is the eye",
            &mut eye_vertex,
        );
        match (u16::try_from(light_vertex), u16::try_from(eye_vertex)) {
            (Ok(light), Ok(eye)) => (self.light_vertex, self.eye_vertex) = (light, eye),
            _ => v.fail("no path has so many vertices"),
        }
        v.optional(
            "at_pixel",
            "the pixel, if the vertex is the eye itself",
            &mut self.pixel,
        );
        v.field("from", "the vertex of the path of light", &mut self.from);
        v.field("to", "the vertex of the path from the eye", &mut self.to);
        v.field("cosines", "cos theta at both ends", &mut self.cosines);
        let geometry = self.geometry();
        let mut found = geometry;
        v.field("geometry", "G = cos theta cos theta' / d^2", &mut found);
        if found != geometry {
            v.fail("\"geometry\" does not follow from the points and cosines");
        }
        v.field("visible", "does nothing stand between", &mut self.visible);
        v.field("weight", "by the balance heuristic", &mut self.weight);
        v.field(
            "contribution",
            "what it brings to the pixel; times the number of pixels unless eye_vertex is 0",
            &mut self.contribution,
        );
    }
}
