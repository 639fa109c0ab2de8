//! A mistake at work: the simple ray tracer with the wrong function, also where that belongs to bounds or to a grid.
//!
//! [`Wrong`] is a set of parts by itself. Here a function of bounds or of a grid gets the search that it is a step of
//! ([`Structure`]), and a mistake can be watched: what the wrong function returns is kept where the right one returns
//! something else.

use std::cell::{Cell, RefCell};

use glam::DVec3;

use crate::geometry::{Axis, Polygon, Ray, Refraction, Sides, Sphere, TRange};
use crate::mistake::Wrong;
use crate::mistake::searched::{Searched, Structure};
use crate::mistake::spoil::{Pair, differ, pair, t_or_none, words};
use crate::scene::{Camera, Light, Material, Normals, PhongTerm, Primitive, Scene, Shape};
use crate::strategy::Hit;
use crate::structure::GridError;
use crate::trace::{Spoilt, SpoiltValue};
use crate::tracer::Surface;
use crate::tracer::simple::{self, Own, Parts};

/// The simple ray tracer with one wrong function, or with none and the same structure.
pub(super) struct AtWork {
    wrong: Option<Wrong>,
    structure: Option<Structure>,
    /// Is what differs kept?
    is_watched: bool,
    /// What the first call spoilt that differs.
    spoilt: RefCell<Vec<Spoilt>>,
    /// Objects tested and cells visited.
    counts: Cell<[u64; 2]>,
}

impl AtWork {
    /// With a mistake, watched or not.
    ///
    /// # Errors
    /// A scene that is too large for a grid.
    pub(super) fn new(scene: &Scene, wrong: Wrong, is_watched: bool) -> Result<Self, GridError> {
        Ok(Self {
            wrong: Some(wrong),
            structure: Structure::of(scene, &wrong)?,
            is_watched,
            spoilt: RefCell::default(),
            counts: Cell::default(),
        })
    }

    /// Without it, and with the structure that its function belongs to.
    ///
    /// # Errors
    /// A scene that is too large for a grid.
    pub(super) fn without(scene: &Scene, wrong: Wrong) -> Result<Self, GridError> {
        let with = Self::new(scene, wrong, false)?;
        Ok(Self {
            wrong: None,
            ..with
        })
    }

    /// What was spoilt first.
    pub(super) fn into_spoilt(self) -> Vec<Spoilt> {
        self.spoilt.into_inner()
    }

    /// Objects tested and cells visited, of all rays so far.
    pub(super) fn counts(&self) -> [u64; 2] {
        self.counts.get()
    }

    /// Keeps those quantities that differ, unless others were kept before.
    fn note(&self, of: impl FnOnce() -> Vec<Pair>) {
        if !self.is_watched || !self.spoilt.borrow().is_empty() {
            return;
        }
        let differing = of()
            .into_iter()
            .filter(|(_, [right, wrong])| differ(right, wrong));
        let spoilt = differing.map(|(quantity, [right, wrong])| Spoilt {
            quantity: quantity.into(),
            right,
            wrong,
        });
        self.spoilt.borrow_mut().extend(spoilt);
    }

    /// Searches the structure, if the mistake has one.
    fn searched(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Nearest> {
        let structure = self.structure.as_ref()?;
        let Searched {
            hit,
            tests,
            cells,
            spoilt,
        } = structure.search(scene, ray, range, self.wrong.as_ref());
        let [tests_before, cells_before] = self.counts.get();
        self.counts
            .set([tests_before + tests, cells_before + cells]);
        self.note(|| spoilt);
        Some(Nearest(hit))
    }
}

/// What the search of a structure found, if anything.
struct Nearest(Option<Hit>);

impl Parts for AtWork {
    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        let right = Own.window_point(camera, x, y);
        let Some(Wrong::WindowPoint(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(camera, x, y);
        self.note(|| vec![pair("P − COP", [&right, &wrong], |of| *of)]);
        wrong
    }

    /// The simple ray tracer asks for no t of the window; a student's may.
    fn eye_ray(&self, camera: &Camera, to_window: DVec3) -> Ray {
        let (ray, t) = camera.ray_through(to_window);
        if let Some(Wrong::Normalised(wrong)) = self.wrong
            && let Some((_, wrong)) = wrong(&Ray::new(camera.cop, to_window))
        {
            self.note(|| vec![pair("t of the window", [&t, &wrong], |t| *t)]);
        }
        ray
    }

    fn nearest(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        if let Some(Nearest(hit)) = self.searched(scene, ray, range) {
            return hit;
        }
        let Some(Wrong::Nearest(wrong)) = self.wrong else {
            return simple::closest(scene, self, ray, range);
        };
        let wrong = wrong(scene, ray, range);
        self.note(|| {
            let right = Own.nearest(scene, ray, range);
            let name = |hit: &Option<Hit>| {
                let object = hit.map(|hit| scene.object_of(hit.object).name.to_string());
                SpoiltValue::Words(object.unwrap_or_else(|| "no object".into()))
            };
            let both = [&right, &wrong];
            vec![
                pair("nearest object", both, name),
                pair("nearest t", both, |hit| t_or_none(hit.map(|hit| hit.t))),
            ]
        });
        wrong
    }

    fn hit(&self, primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
        let Some(Wrong::Hit(wrong)) = self.wrong else {
            return simple::hit(self, primitive, ray, range);
        };
        let wrong = wrong(primitive, ray, range);
        self.note(|| {
            let right = Own.hit(primitive, ray, range);
            vec![pair("t of the hit", [&right, &wrong], |t| t_or_none(*t))]
        });
        wrong
    }

    fn root(&self, sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        let right = sphere.test(ray, range, sides);
        match self.wrong {
            Some(Wrong::Root(wrong)) => {
                let wrong = wrong(sphere, ray, range, sides);
                self.note(|| {
                    vec![pair(
                        "t of the root",
                        [&right.roots.chosen(), &wrong],
                        |t| t_or_none(*t),
                    )]
                });
                wrong
            }
            Some(Wrong::SphereTest(wrong)) => {
                let wrong = wrong(sphere, ray, range, sides);
                let both = [&right, &wrong];
                self.note(|| {
                    vec![
                        pair("b", both, |of| of.b),
                        pair("number of roots", both, |of| of.roots.iter().count() as f64),
                        pair("t of the root", both, |of| t_or_none(of.roots.chosen())),
                    ]
                });
                wrong.roots.chosen()
            }
            _ => right.roots.chosen(),
        }
    }

    fn plane_t(&self, polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        let right = Own.plane_t(polygon, ray, range, sides);
        let Some(Wrong::PlaneT(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(polygon, ray, range, sides);
        self.note(|| vec![pair("t of the plane", [&right, &wrong], |t| t_or_none(*t))]);
        wrong
    }

    fn inside(&self, polygon: &Polygon, ray: &Ray, t: f64) -> bool {
        let right = Own.inside(polygon, ray, t);
        let verdict = |is: &bool| words(*is, ["inside", "outside"]);
        match self.wrong {
            Some(Wrong::Inside(wrong)) => {
                let wrong = wrong(polygon, ray, t);
                self.note(|| vec![pair("p′", [&right, &wrong], verdict)]);
                wrong
            }
            Some(Wrong::DroppedAxis(axis)) => {
                let own = Wrong::DroppedAxis(axis);
                let wrong = own.inside(polygon, ray, t);
                if right != wrong {
                    self.note(|| {
                        let normal = polygon.plane().normal;
                        let axes = [polygon.dropped(), axis(normal)];
                        let name = |axis: &Axis| match axis {
                            Axis::X => "x",
                            Axis::Y => "y",
                            Axis::Z => "z",
                        };
                        vec![
                            pair("dropped axis", [&axes[0], &axes[1]], name),
                            pair("p′", [&right, &wrong], verdict),
                        ]
                    });
                }
                wrong
            }
            _ => right,
        }
    }

    fn normals(&self, shape: &Shape, point: DVec3) -> Normals {
        let right = Own.normals(shape, point);
        let Some(Wrong::Normals(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(shape, point);
        self.note(|| vec![pair("N", [&right, &wrong], |of| of.shading)]);
        wrong
    }

    fn leaves_from(&self, surface: &Surface<'_>) -> (DVec3, f64) {
        let right = Own.leaves_from(surface);
        let Some(Wrong::LeavesFrom(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(surface);
        let both = [&right, &wrong];
        self.note(|| {
            vec![
                pair("start of the ray", both, |(start, _)| *start),
                pair("start above the surface", both, |(start, _)| {
                    (*start - surface.point).dot(surface.across)
                }),
                pair("smallest t", both, |(_, epsilon)| *epsilon),
            ]
        });
        wrong
    }

    fn blocked(&self, scene: &Scene, ray: &Ray, range: TRange) -> bool {
        if let Some(Nearest(hit)) = self.searched(scene, ray, range) {
            return hit.is_some();
        }
        let Some(Wrong::Blocked(wrong)) = self.wrong else {
            return simple::blocked(scene, self, ray, range);
        };
        let wrong = wrong(scene, ray, range);
        self.note(|| {
            let right = Own.blocked(scene, ray, range);
            vec![pair("light", [&right, &wrong], |is| {
                words(*is, ["blocked", "visible"])
            })]
        });
        wrong
    }

    fn light_term(
        &self,
        light: &Light,
        material: &Material,
        point: DVec3,
        normal: DVec3,
        to_viewer: DVec3,
    ) -> PhongTerm {
        let right = Own.light_term(light, material, point, normal, to_viewer);
        let Some(Wrong::LightTerm(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(light, material, point, normal, to_viewer);
        let both = [&right, &wrong];
        self.note(|| {
            vec![
                pair("L", both, |of| of.to_light),
                pair("N·L", both, |of| of.n_dot_l),
                pair("R·V", both, |of| of.r_dot_v),
                pair("diffuse term", both, |of| of.diffuse),
                pair("specular term", both, |of| of.specular),
            ]
        });
        wrong
    }

    fn reflect(&self, direction: DVec3, normal: DVec3) -> DVec3 {
        let right = Own.reflect(direction, normal);
        let Some(Wrong::Reflect(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(direction, normal);
        self.note(|| vec![pair("R", [&right, &wrong], |of| *of)]);
        wrong
    }

    fn refract(&self, direction: DVec3, normal: DVec3, from: f64, to: f64) -> Refraction {
        let right = Own.refract(direction, normal, from, to);
        let Some(Wrong::Refract(wrong)) = self.wrong else {
            return right;
        };
        let wrong = wrong(direction, normal, from, to);
        let both = [&right, &wrong];
        self.note(|| {
            let refracted = |of: &Refraction| {
                let none = || "total internal reflection".into();
                of.direction.map_or_else(none, SpoiltValue::from)
            };
            vec![
                pair("n₁/n₂", both, |of| of.index_from / of.index_to),
                pair("cos θ₁", both, |of| of.cos_incident),
                pair("refracted direction", both, refracted),
            ]
        });
        wrong
    }

    fn shade(&self, scene: &Scene, surface: &Surface<'_>) -> DVec3 {
        match self.wrong {
            Some(Wrong::Shade(wrong)) => {
                let wrong = wrong(scene, &Wrong::Shade(wrong), surface);
                self.note(|| {
                    let right = Own.shade(scene, surface);
                    vec![pair("I", [&right, &wrong], |of| *of)]
                });
                wrong
            }
            Some(Wrong::StartEpsilon(wrong)) => {
                // t is not known here, and in a scene around the origin no larger than the coordinates
                let reach = scene.primitive(surface.object).shape.reach();
                let epsilon = wrong(surface.point, 0.0, reach);
                self.note(|| vec![pair("ε", [&surface.epsilon, &epsilon], |of| *of)]);
                let surface = Surface {
                    epsilon,
                    ..*surface
                };
                simple::shade(scene, self, &surface)
            }
            _ => simple::shade(scene, self, surface),
        }
    }
}
