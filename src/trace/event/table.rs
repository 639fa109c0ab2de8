//! The table of events: what can happen to a ray, and what a line of the log says of it.
//!
//! One paragraph for each kind, in the order in which they happen on a ray; [`declare`](crate::trace::event::declare) says how
//! one is written. `Event`, `Kind`, the structs of events, the writer, the reader and the schema follow from it. A new
//! kind is a paragraph here and its words in `explain`.

use glam::{DVec2, DVec3};

use crate::geometry::{
    Alignment, AxisBox, BoxTest, EdgeTest, PlaneTest, PolygonTest, QuadraticTest, Ray, Refraction,
    TRange,
};
use crate::scene::{PhongTerm, PrimitiveId};
use crate::structure::{AssignStep, CellStep, MergeStep, SlabStep, VolumeKind};
use crate::trace::event::columns::{Column, derived, light, light_if_any, replaced, unbounded};
use crate::trace::event::declare::{events, fields, payload, variant};
use crate::trace::event::fields::{Fields, Visitor};
use crate::trace::event::place::KindPlace;
use crate::trace::event::search::{BoundVerdict, Bounded, Stretch};
use crate::trace::event::words::{
    AlignedPart, NodeVerdict, PhotonVerdict, Purpose, QueueAction, RayVerdict, Visibility, WalkEnd,
};

events! {
    /// Two volumes are joined while a hierarchy is built (Fig. 15.58(b)).
    Merge(MergeStep) = "merge", Building;

    /// An object is put on a cell's list while a grid is built.
    Assign(AssignStep) = "assign", Building;

    /// A light emits a photon: a path of light begins.
    Path(PathStart) = "path", Path {
        /// The number of the path, from 0.
        path: u32 = apart,
        /// How many paths there are.
        paths: u32,
        /// The light, chosen with a probability in proportion to its power.
        light: u32 = by light,
        /// What the photon carries, in watts for each channel: the power of all lights over the number of paths.
        power: DVec3,
    }

    /// The eye looks through a point of the window.
    Pixel(PixelSample) = "pixel", Pixel {
        /// Column and row from the top left.
        pixel: [u32; 2] = apart,
        /// Which of the pixel's eye rays, from 0.
        sample: u32,
        /// How many eye rays the pixel has: 1 through its centre, or 4 through its corners.
        samples: u32,
        /// The point of the window in pixels from its top left corner.
        place: DVec2,
        /// The point of the window, in world coordinates.
        point: DVec3,
    }

    /// A ray starts.
    Ray(RayStart) = "ray", Either {
        /// The purpose of the ray.
        purpose: Purpose,
        /// Its origin and its unit direction.
        ray: Ray = flat,
        /// The t that count: from the first to the last.
        range: TRange = flat,
        /// 1 for an eye ray, one more for each surface behind which it was spawned.
        depth: u32,
        /// t at which an eye ray passes the window (erratum 4); absent for all other rays.
        window_t: Option<f64> as t_window,
        /// The light that a shadow ray is cast to, or that the first leg of a path comes from; absent for all other rays.
        light: Option<u32> = by light_if_any,
    }

    /// A ray is laid along the z axis.
    Align(Alignment) = "align", Either;

    /// A ray enters the grid, or misses it.
    GridEnter(GridEnter) = "grid_enter", Either {
        /// The box of the grid, in world coordinates, with padding.
        around: AxisBox = flat,
        /// How many cells there are along x, y and z.
        resolution: [u32; 3],
        /// Where the ray is inside the box; `None` if it passes by.
        inside: Stretch = flat,
        /// [i, j, k] of the first cell; absent: no cell is pierced in the ray's range.
        cell: Option<[u32; 3]>,
    }

    /// A node is put into the heap of waiting nodes, or taken out.
    Queue(QueueStep) = "queue", Either {
        /// Into the heap, out of it, or the end of the search.
        action: QueueAction,
        /// The number of the node; the root is 0.
        node: u32,
        /// The estimated distance: t at which the ray enters the node's bound.
        key: f64,
        /// How many nodes wait afterwards.
        size: u32,
    }

    /// S and T of a ray and a direction of slabs are computed, once for all bounds (Fig. 15.58(a)), and the room that all of
    /// them have. They come before the ray's tests.
    SlabRay(RaySlab) = "slab_ray", Either {
        /// Which direction of the set, from 0.
        slab: u32,
        /// (A, B, C), of unit length.
        normal: DVec3,
        /// S = A·x₀ + B·y₀ + C·z₀.
        s: f64,
        /// T = −1/(A·Δx + B·Δy + C·Δz); absent: the ray is parallel to the slab.
        t_scale: f64 = by unbounded,
        /// By how much either plane of a slab is moved outwards for rounding: a length. Near and far of the ray's
        /// `slab_test`s are t = (S - room + D_min)·T and t = (S + room + D_max)·T.
        room: f64,
    }

    /// One slab of a bound is tested (Fig. 15.58(a)): with S, T and the room of its `slab_ray`.
    SlabTest(SlabTest) = "slab_test", Either {
        /// What the bound is around.
        of: Bounded = flat,
        /// Near and far of the slab, and of all slabs so far.
        step: SlabStep = flat,
    }

    /// A bounding volume is tested. The slabs of a bound come before it.
    BoundTest(BoundTest) = "bound_test", Either {
        /// What the volume is around.
        of: Bounded = flat,
        /// The shape of the volume.
        volume: VolumeKind,
        /// Where the ray is inside the volume; `None` if it passes by.
        inside: Stretch = flat,
        /// By how much the volume is wider for rounding than what it is around: a length. `inside` has it in it.
        room: f64,
        /// What follows from where the ray is inside.
        verdict: BoundVerdict = flat,
    }

    /// A node of the hierarchy is visited or left out.
    Node(NodeVisit) = "node", Either {
        /// The number of the node; the root is 0.
        node: u32,
        /// How deep the node lies; the root lies at 0.
        depth: u32,
        /// How many nodes are directly below it; 0 for a leaf.
        children: u32,
        /// How many objects the node has; 0 unless it is a leaf.
        objects: u32,
        /// t at which the ray enters its bound; absent: it does not.
        near: Option<f64>,
        /// What became of the node.
        verdict: NodeVerdict as outcome,
    }

    /// A ray pierces a cell, whose list is looked at (Fig. 15.62).
    Cell(CellVisit) = "cell", Either {
        /// Where the ray is in the cell, and how it leaves it.
        step: CellStep = flat,
        /// How many objects are on the cell's list.
        listed: u32,
    }

    /// An object is on the list of the cell.
    Listed { object: PrimitiveId } = "listed", Either;

    /// The object was tested in an earlier cell: its mailbox holds this ray already, and the test is saved.
    Mailbox { object: PrimitiveId } = "mailbox", Either;

    /// A point of an object is brought into the frame of a ray. All points come before the object's test.
    Aligned(Aligned) = "aligned", Either {
        /// The object.
        object: PrimitiveId,
        /// What the point is of the object.
        part: AlignedPart,
        /// Which of several such points, from 0.
        index: u32,
        /// The point in world coordinates.
        from: DVec3,
        /// The point in the frame of the ray.
        to: DVec3,
    }

    /// A sphere is tested: equation (iii).
    SphereTest { object: PrimitiveId, test: QuadraticTest } = "sphere_test", Either;

    /// An ellipsoid is tested: equation (iii) in the space in which it is a unit sphere.
    EllipsoidTest { object: PrimitiveId, test: QuadraticTest } = "ellipsoid_test", Either;

    /// A cone or a cylinder is tested.
    ConeTest { object: PrimitiveId, test: QuadraticTest } = "cone_test", Either;

    /// A box is tested: three slabs.
    BoxTest { object: PrimitiveId, test: BoxTest } = "box_test", Either;

    /// The plane of a polygon is tested: equations (iv) and (v).
    PlaneTest { object: PrimitiveId, test: PlaneTest } = "plane_test", Either;

    /// An edge of a polygon counts as a crossing or not. All edges come before their `polygon_test`.
    Edge { object: PrimitiveId, edge: EdgeTest } = "edge", Either;

    /// The point where a ray hits the plane of a polygon is inside the polygon or outside (Fig. 15.57).
    PolygonTest { object: PrimitiveId, test: PolygonTest } = "polygon_test", Either;

    /// A hit is the nearest so far.
    Nearest(Nearest) = "nearest", Either {
        /// The object that is hit.
        object: PrimitiveId,
        /// t of the hit, along the ray.
        t: f64,
        /// What the nearest hit was before; absent: there was none.
        replaced: Option<PrimitiveId> = by replaced,
    }

    /// A hit lies beyond the cell whose list the object is on: it is kept, and the walk goes on (erratum 6).
    HitOutsideCell(HitOutsideCell) = "hit_outside_cell", Either {
        /// The object that is hit.
        object: PrimitiveId,
        /// t of the hit, along the ray.
        t: f64,
        /// t at which the ray leaves the cell.
        t_out: f64,
    }

    /// The walk through the grid ends.
    GridExit(GridExit) = "grid_exit", Either {
        /// Why the walk ends.
        end: WalkEnd,
        /// How many cells were visited.
        cells: u32,
    }

    /// A hit has its place in the z sort.
    ZSort(ZSort) = "z_sort", Either {
        /// Its place among the hits, from 0: the nearest.
        place: u32,
        /// The object that is hit.
        object: PrimitiveId,
        /// z of the hit in the frame of the ray, which is the ray's t.
        z: f64,
    }

    /// A photon passes the window into the eye.
    ///
    /// The eye takes nothing away from it: it would cast a shadow otherwise, which no other transport shows.
    Arrival(Arrival) = "arrival", Path {
        /// The pixel where its line passes the window.
        pixel: [u32; 2] as at_pixel,
        /// The point where it passes the window, in world coordinates.
        window: DVec3,
        /// The point where it passes the aperture, in world coordinates.
        aperture: DVec3,
        /// What it carries, in watts for each channel.
        power: DVec3,
        /// G = cos²θ / d² between the two points, whose planes are parallel.
        geometry: f64,
        /// power / (G · area of the aperture · area of the pixel): what it adds to the pixel, in watts per steradian and
        /// square unit.
        radiance: DVec3,
    }

    /// A photon is stored where it hits a diffuse surface.
    Stored(Stored) = "stored", Path {
        /// The object whose surface the path or ray is on.
        object: PrimitiveId,
        /// The point of the surface, in world coordinates.
        point: DVec3,
        /// The unit normal on the side that the photon comes from.
        normal: DVec3,
        /// What it carries, in watts for each channel.
        power: DVec3,
    }

    /// A stored photon is one of the nearest. All of them come before their `gathered`.
    Nearby(Nearby) = "nearby", Pixel {
        /// The number of the path on which it came.
        path: u32 as from_path,
        /// The number of the surface on that path, from 1.
        surface: u32,
        /// The point where it is stored, in world coordinates.
        point: DVec3,
        /// What it carries, in watts for each channel.
        power: DVec3,
        /// Its distance from the point at which light is gathered.
        distance: f64,
    }

    /// Light is gathered at a point that a ray from the eye hits.
    ///
    /// E = Σ power / area over the k − 1 nearest photons, with the area of the disc up to the k-th, πr² where the
    /// surface has no edge nearby; or over the cell of a map. L = colour·diffuse/π · E.
    Gathered(Gathered) = "gathered", Pixel {
        /// The object whose surface the path or ray is on.
        object: PrimitiveId,
        /// The point, in world coordinates.
        point: DVec3,
        /// How many photons count: k − 1 of k, or those of the cell.
        count: u32,
        /// r: the distance of the k-th photon; absent for the cell of a map, or where nothing is stored.
        radius: Option<f64>,
        /// The area of the surface on which they lie, in square units.
        area: f64,
        /// E: power by area.
        irradiance: DVec3,
        /// L: what the surface sends to the eye.
        radiance: DVec3,
    }

    /// The terms of one light are computed.
    LightTerm(LightTerm) = "light_term", Pixel {
        /// The light that the terms are of.
        light: u32 = by light,
        /// Does the light reach the point? If not, its terms do not count.
        visibility: Visibility,
        /// N·L, R·V, and the diffuse and the specular term.
        term: PhongTerm = flat,
    }

    /// Snell's law is applied.
    Refraction(Refraction) = "refraction", Either;

    /// A photon hits a surface, and a random number decides how its path goes on (Russian roulette).
    ///
    /// One number ξ in 0..1 decides for all three channels of the colour: below `reflection` the photon is mirrored, below
    /// `reflection + transmission` refracted, below `reflection + transmission + diffuse` of a channel that channel goes on
    /// diffusely, and above it is absorbed. What goes on keeps its power, so that no energy is made or lost: at every
    /// surface arriving = leaving + absorbed. A path from the eye hits surfaces in the same way, and carries a weight in
    /// place of a power.
    Photon(Photon) = "photon", Either {
        /// The object whose surface the path or ray is on.
        object: PrimitiveId,
        /// The point of the surface, in world coordinates.
        point: DVec3,
        /// What arrives: watts for each channel, or the weight of a path from the eye.
        power: DVec3,
        /// ξ: the random number in 0..1 that decides.
        chance: f64,
        /// The probability to be mirrored.
        reflection: f64,
        /// The probability to be refracted; 0 where total internal reflection adds it to `reflection`.
        transmission: f64,
        /// colour·diffuse: the probability of each channel to go on diffusely.
        diffuse: DVec3,
        /// What became of the photon.
        verdict: PhotonVerdict as outcome,
        /// What goes on, in the unit of `power`. What arrives less this is absorbed.
        leaving => Photon::leaving,
    }

    /// An edge of a path that could have been the connecting line: it is, or other vertices could have made the same
    /// path. All edges come before their `connection`.
    ///
    /// share = 1 / (G · φ · φ'): the smaller the geometry term and the densities of the vertices at its ends, the likelier
    /// does the path come about with this edge as its connection. The weight of a connection is its share over the sum
    /// of all shares (balance heuristic: Veach and Guibas 1995).
    Alternative(Alternative) = "alternative", Either {
        /// The number of the edge, from 1 at the light.
        edge: u32,
        /// G of its two ends.
        geometry: f64,
        /// φ at its end towards the light and towards the eye: per steradian, 1/(4π) at the light, albedo/π at a diffuse
        /// surface; at the eye per square unit of the window, d²/(A·cos θ).
        densities: [f64; 2],
        /// 1 / (G·φ·φ').
        share: f64,
        /// Is this edge the connection?
        chosen: bool,
    }

    /// A vertex of a path of light is connected to one of a path from the eye.
    Connection(Connection) = "connection", Either {
        /// The number of the path of light.
        path: u32 as from_path,
        /// The vertex of the path of light: 0 is the light, then the surfaces.
        light_vertex: u16,
        /// The vertex of the path from the eye: 0 is the eye, then the surfaces.
        eye_vertex: u16,
        /// The pixel, if the vertex is the eye itself; absent otherwise.
        pixel: Option<[u32; 2]> as at_pixel,
        /// The point of the vertex of the path of light, in world coordinates.
        from: DVec3,
        /// The point of the vertex of the path from the eye, in world coordinates.
        to: DVec3,
        /// cos θ at both ends; 1 at a light and at the eye, which have no normal.
        cosines: [f64; 2],
        /// G = cos θ · cos θ' / d².
        geometry => Connection::geometry,
        /// Does nothing stand between the two points?
        visible: bool,
        /// The weight by the balance heuristic, in 0..1; 0 if something stands between.
        weight: f64,
        /// What it brings: to the pixel, if `eye_vertex` is 0; otherwise times the number of the picture's pixels, since a
        /// pixel is connected to its own share of the paths alone.
        contribution: DVec3,
    }

    /// The shade of a point has all its terms except those of the rays that are spawned there.
    ///
    /// I = ambient + Σ lights + reflection·I_reflected + transmission·I_refracted.
    Shade(Shade) = "shade", Pixel {
        /// The object that is hit.
        object: PrimitiveId,
        /// The point, in world coordinates.
        point: DVec3,
        /// N: the unit normal on the side that the ray comes from.
        normal: DVec3,
        /// Does the ray hit the back of the surface, so that N is the surface's normal turned round?
        back: bool,
        /// ambient·colour.
        ambient: DVec3,
        /// Σ over the visible lights of the diffuse and the specular term.
        direct: DVec3,
        /// The weight of the reflected ray; total internal reflection adds the transmission to it.
        reflection: f64,
        /// The weight of the refracted ray.
        transmission: f64,
    }

    /// A ray ends.
    RayEnd(RayEnd) = "ray_end", Either {
        /// How the ray ends.
        verdict: RayVerdict as outcome,
        /// What it hits; absent: nothing.
        object: Option<PrimitiveId>,
        /// t of the hit; absent: there is none.
        t: Option<f64>,
        /// The colour it brings back; absent for shadow rays and legs of paths.
        colour: Option<DVec3>,
        /// How many objects it was tested against; the recording counts them.
        tests: u32,
        /// How many of those tests were hits; the recording counts them.
        hits: u32,
    }

    /// A pixel has its colour.
    PixelColour(PixelColour) = "pixel_colour", Pixel {
        /// The mean over the pixel's eye rays.
        raw: DVec3,
        /// `raw` cut to 0..1: what the picture shows.
        clamped: DVec3,
        /// 255 times `clamped`, rounded: red, green and blue in the picture's file.
        rgb => PixelColour::rgb,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_event_is_at_most_128_bytes() {
        assert!(size_of::<Event>() <= 128, "{}", size_of::<Event>());
    }

    #[test]
    fn every_kind_has_a_name_of_its_own_and_a_blank_event() {
        for kind in Kind::ALL {
            assert_eq!(Kind::named(kind.name()), Some(kind));
            assert_eq!(kind.blank().kind(), kind);
        }
    }
}
