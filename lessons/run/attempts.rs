//! All exercises, each with your function.

use raystep::lesson::exercise::{Attempt, course};

use super::{l01, l02, l03, l04, l05, l06, l07, l08, l09, l10, l11, l12};

/// In the order of the course.
pub fn attempts() -> Vec<Box<dyn Attempt>> {
    vec![
        course::WINDOW_POINT.with(l01::window_point),
        course::EYE_RAY.with(l01::eye_ray),
        course::NEAREST.with(l02::nearest),
        course::POINT_AT_T.with(l03::point_at_t),
        course::NORMALISED.with(l03::normalised),
        course::COEFFICIENTS.with(l04::coefficients),
        course::ROOTS.with(l04::roots),
        course::ROOT_THAT_COUNTS.with(l04::root_that_counts),
        course::NORMALS.with(l05::normals),
        course::LIGHT_TERM.with(l05::light_term),
        course::EPSILON.with(l05::epsilon),
        course::BLOCKED.with(l05::blocked),
        course::SHADE.with(l05::shade),
        course::PLANE_T.with(l06::plane_t),
        course::DROPPED_AXIS.with(l06::dropped_axis),
        course::CROSSINGS.with(l06::crossings),
        course::INSIDE.with(l06::inside),
        course::REFLECT.with(l07::reflect),
        course::REFRACT.with(l07::refract),
        course::CHILDREN.with(l07::children),
        course::DIFFUSE_DIRECTION.with(l08::diffuse_direction),
        course::IRRADIANCE.with(l08::irradiance),
        course::GEOMETRY_TERM.with(l08::geometry_term),
        course::COST.with(l09::cost),
        course::ALIGN.with(l09::align),
        course::Z_SORT.with(l09::z_sort),
        course::SPHERE_AROUND.with(l10::sphere_around),
        course::SLAB_OF.with(l10::slab_of),
        course::SLAB_RAY.with(l10::slab_ray),
        course::SLAB_INTERVAL.with(l10::slab_interval),
        course::INTERVAL.with(l10::interval),
        course::BOUND_VERDICT.with(l10::bound_verdict),
        course::UNION.with(l10::union),
        course::HIER_TRAVERSE.with(l11::hier_traverse),
        course::HEAP.with(l11::heap),
        course::SPLIT_COST.with(l11::split_cost),
        course::OBJECT_TO_CELLS.with(l12::object_to_cells),
        course::CELL_OF.with(l12::cell_of),
        course::FIRST_PLANES.with(l12::first_planes),
        course::NEXT_CELL.with(l12::next_cell),
        course::WALK_ENDS.with(l12::walk_ends),
        course::WALK.with(l12::walk),
    ]
}
