//! The same events through the crate `tracing`, as one would write them with it.
//!
//! Its JSON subscriber is set to do as little as it can: no time, no level, no target, one flat object
//! a line, a buffer before the file. `tracing` has no lists: each number of a list has a key of its own.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use raystep::geometry::{
    Axis, DecidedBy, EdgeTest, PlaneTest, PlaneVerdict, PolygonTest, QuadraticTest, Refraction,
    Root, RootVerdict, Roots,
};
use raystep::scene::PrimitiveId;
use raystep::trace::{
    LightTerm, Nearest, PixelColour, PixelSample, Purpose, RayEnd, RayStart, RayVerdict, Shade,
    Visibility,
};
use raystep::{Event, Record, Scene};
use tracing::{Dispatch, info};
use tracing_subscriber::fmt::{MakeWriter, Subscriber};

use super::{PIECE, Part};

/// A subscriber that writes into a file.
pub(super) struct Subscribed {
    dispatch: Dispatch,
    out: Shared,
}

/// The file, shared with the subscriber, which hands it to each line.
#[derive(Clone)]
struct Shared(Arc<Mutex<BufWriter<File>>>);

impl Shared {
    fn lock(&self) -> MutexGuard<'_, BufWriter<File>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.lock().write(bytes)
    }

    // the buffer is for the end to empty
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl<'a> MakeWriter<'a> for Shared {
    type Writer = Self;
    fn make_writer(&'a self) -> Self {
        self.clone()
    }
}

impl Subscribed {
    pub(super) fn new() -> io::Result<Self> {
        let out = Shared(Arc::new(Mutex::new(new_file()?)));
        let subscriber = Subscriber::builder()
            .json()
            .flatten_event(true)
            .with_current_span(false)
            .with_span_list(false)
            .with_level(false)
            .with_target(false)
            .without_time()
            .with_writer(out.clone());
        Ok(Self {
            dispatch: Dispatch::new(subscriber.finish()),
            out,
        })
    }

    /// Takes a new file.
    pub(super) fn empty(&self) -> io::Result<()> {
        *self.out.lock() = new_file()?;
        Ok(())
    }

    /// Writes all events into the file.
    pub(super) fn write(&self, parts: &[Part]) -> io::Result<()> {
        tracing::dispatcher::with_default(&self.dispatch, || {
            for part in parts {
                for record in &part.records {
                    write(record, &part.scene);
                }
            }
        });
        self.out.lock().flush()
    }
}

fn new_file() -> io::Result<BufWriter<File>> {
    Ok(BufWriter::with_capacity(PIECE, tempfile::tempfile()?))
}

/// An event with the fields that every line has.
macro_rules! line {
    ($record:ident, $($fields:tt)+) => {
        info!(
            kind = $record.event.kind().name(),
            step = $record.step,
            pixel_x = $record.pixel.map_or(0, |[x, _]| x),
            pixel_y = $record.pixel.map_or(0, |[_, y]| y),
            ray = $record.ray,
            $($fields)+
        )
    };
}

fn write(record: &Record, scene: &Scene) {
    let name = |id: PrimitiveId| scene.name_of(id);
    match &record.event {
        Event::Pixel(PixelSample {
            sample,
            samples,
            place,
            point,
            ..
        }) => line!(
            record,
            sample,
            samples,
            place_x = place.x,
            place_y = place.y,
            point_x = point.x,
            point_y = point.y,
            point_z = point.z,
        ),
        Event::PixelColour(PixelColour { raw, clamped }) => line!(
            record,
            raw_r = raw.x,
            raw_g = raw.y,
            raw_b = raw.z,
            clamped_r = clamped.x,
            clamped_g = clamped.y,
            clamped_b = clamped.z,
        ),
        Event::Ray(start) => ray(record, start, scene),
        Event::RayEnd(RayEnd {
            verdict,
            object,
            t,
            colour,
            tests,
            hits,
        }) => {
            let (object, face) = object.map(name).unzip();
            line!(
                record,
                outcome = verdict_word(*verdict),
                object,
                face = face.flatten(),
                t,
                colour_r = colour.map(|colour| colour.x),
                colour_g = colour.map(|colour| colour.y),
                colour_b = colour.map(|colour| colour.z),
                tests,
                hits,
            );
        }
        Event::SphereTest { object, test } | Event::ConeTest { object, test } => {
            quadratic(record, name(*object), test);
        }
        Event::PlaneTest { object, test } => plane(record, name(*object), test),
        Event::Edge { object, edge: test } => edge(record, name(*object), test),
        Event::PolygonTest { object, test } => polygon(record, name(*object), test),
        Event::Nearest(Nearest {
            object,
            t,
            replaced,
        }) => {
            let (object, face) = name(*object);
            let (replaced, replaced_face) = replaced.map(name).unzip();
            let replaced_face = replaced_face.flatten();
            line!(record, object, face, t, replaced, replaced_face);
        }
        Event::LightTerm(light) => light_term(record, light, scene),
        Event::Shade(of) => shade(record, of, name(of.object)),
        Event::Refraction(Refraction {
            index_from,
            index_to,
            cos_incident,
            cos_refracted_squared,
            direction,
        }) => line!(
            record,
            index_from,
            index_to,
            cos_incident,
            cos_refracted_squared,
            total_internal_reflection = direction.is_none(),
            direction_x = direction.map(|direction| direction.x),
            direction_y = direction.map(|direction| direction.y),
            direction_z = direction.map(|direction| direction.z),
        ),
        other => panic!("the scenes of the mix have no {:?}", other.kind()),
    }
}

fn ray(record: &Record, start: &RayStart, scene: &Scene) {
    let RayStart { ray, range, .. } = start;
    line!(
        record,
        parent = record.parent,
        purpose = purpose_word(start.purpose),
        origin_x = ray.origin.x,
        origin_y = ray.origin.y,
        origin_z = ray.origin.z,
        direction_x = ray.direction.x,
        direction_y = ray.direction.y,
        direction_z = ray.direction.z,
        t_min = range.min,
        t_max = range.max.is_finite().then_some(range.max),
        depth = start.depth,
        t_window = start.window_t,
        light = start
            .light
            .map(|light| scene.lights[light as usize].name.as_str()),
    );
}

fn quadratic(record: &Record, (object, face): (&str, Option<u32>), test: &QuadraticTest) {
    let (roots, near, far) = match test.roots {
        Roots::None => ("none", None, None),
        Roots::Graze(root) => ("graze", Some(root), None),
        Roots::Two { near, far } => ("two", Some(near), Some(far)),
        Roots::Linear(root) => ("linear", Some(root), None),
    };
    line!(
        record,
        object,
        face,
        a = test.a,
        b = test.b,
        c = test.c,
        discriminant = test.discriminant,
        roots,
        near = near.map(|root| root.t),
        near_verdict = near.map(root_verdict_word),
        far = far.map(|root| root.t),
        far_verdict = far.map(root_verdict_word),
        t = test.roots.chosen(),
    );
}

fn plane(record: &Record, (object, face): (&str, Option<u32>), test: &PlaneTest) {
    let (parallel, root) = match test.verdict {
        PlaneVerdict::Meets(root) => ("no", Some(root)),
        PlaneVerdict::ParallelBeside => ("beside", None),
        PlaneVerdict::ParallelWithin => ("in", None),
    };
    line!(
        record,
        object,
        face,
        plane_a = test.plane.normal.x,
        plane_b = test.plane.normal.y,
        plane_c = test.plane.normal.z,
        plane_d = test.plane.d,
        numerator = test.numerator,
        denominator = test.denominator,
        parallel,
        root = root.map(|root| root.t),
        root_verdict = root.map(root_verdict_word),
        t = test.chosen(),
    );
}

fn edge(record: &Record, (object, face): (&str, Option<u32>), edge: &EdgeTest) {
    line!(
        record,
        object,
        face,
        edge = edge.index,
        from_x = edge.from.x,
        from_y = edge.from.y,
        to_x = edge.to.x,
        to_y = edge.to.y,
        straddles = edge.straddles,
        side = edge.side,
        counts = edge.counts,
        decided_by = decided_by_word(edge.decided_by),
    );
}

fn polygon(record: &Record, (object, face): (&str, Option<u32>), test: &PolygonTest) {
    line!(
        record,
        object,
        face,
        dropped = axis_word(test.dropped),
        coefficient = test.coefficient,
        point_x = test.point.x,
        point_y = test.point.y,
        point_z = test.point.z,
        projected_x = test.projected.x,
        projected_y = test.projected.y,
        crossings = test.crossings,
        inside = test.inside,
        decided_by = decided_by_word(test.decided_by),
    );
}

fn light_term(record: &Record, light: &LightTerm, scene: &Scene) {
    let term = &light.term;
    line!(
        record,
        light = scene.lights[light.light as usize].name.as_str(),
        visibility = visibility_word(light.visibility),
        to_light_x = term.to_light.x,
        to_light_y = term.to_light.y,
        to_light_z = term.to_light.z,
        distance = term.distance,
        n_dot_l = term.n_dot_l,
        r_dot_v = term.r_dot_v,
        diffuse_r = term.diffuse.x,
        diffuse_g = term.diffuse.y,
        diffuse_b = term.diffuse.z,
        specular_r = term.specular.x,
        specular_g = term.specular.y,
        specular_b = term.specular.z,
    );
}

fn shade(record: &Record, shade: &Shade, (object, face): (&str, Option<u32>)) {
    line!(
        record,
        object,
        face,
        point_x = shade.point.x,
        point_y = shade.point.y,
        point_z = shade.point.z,
        normal_x = shade.normal.x,
        normal_y = shade.normal.y,
        normal_z = shade.normal.z,
        back = shade.back,
        ambient_r = shade.ambient.x,
        ambient_g = shade.ambient.y,
        ambient_b = shade.ambient.z,
        direct_r = shade.direct.x,
        direct_g = shade.direct.y,
        direct_b = shade.direct.z,
        reflection = shade.reflection,
        transmission = shade.transmission,
    );
}

fn root_verdict_word(root: Root) -> &'static str {
    match root.verdict {
        RootVerdict::Chosen => "chosen",
        RootVerdict::Behind => "behind",
        RootVerdict::BelowEpsilon => "below_epsilon",
        RootVerdict::BeyondNearest => "beyond_nearest",
        RootVerdict::BackFace => "back_face",
        RootVerdict::FrontFace => "front_face",
        RootVerdict::BeyondEnds => "beyond_ends",
    }
}

fn purpose_word(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Eye => "eye",
        Purpose::Shadow => "shadow",
        Purpose::Reflected => "reflected",
        Purpose::Refracted => "refracted",
        Purpose::Scattered => "scattered",
        Purpose::Light => "light",
        Purpose::Connection => "connection",
    }
}

fn verdict_word(verdict: RayVerdict) -> &'static str {
    match verdict {
        RayVerdict::Hit => "hit",
        RayVerdict::Miss => "miss",
        RayVerdict::Blocked => "blocked",
        RayVerdict::ReachesLight => "reaches_light",
        RayVerdict::DepthLimit => "depth_limit",
        RayVerdict::Absorbed => "absorbed",
        RayVerdict::CutOff => "cut_off",
        RayVerdict::Connects => "connects",
    }
}

fn visibility_word(visibility: Visibility) -> &'static str {
    match visibility {
        Visibility::Visible => "visible",
        Visibility::Shadowed => "shadowed",
        Visibility::FacesAway => "faces_away",
        Visibility::NotTested => "not_tested",
    }
}

fn decided_by_word(decided_by: DecidedBy) -> &'static str {
    match decided_by {
        DecidedBy::Point => "point",
        DecidedBy::Ray => "ray",
    }
}

fn axis_word(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    }
}
