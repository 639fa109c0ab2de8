//! What the search of each strategy reads like: pixels of the first lesson's scene, for a reader's eyes.
#![allow(
    clippy::needless_raw_string_hashes,
    reason = "snapbox writes the snapshots so"
)]

use raystep::{Kind, Kinds, Settings, StrategyName, WorkedOptions};

use crate::worked_solution::worked_text;
use snapbox::{assert_data_eq, str};

use crate::trace_log::{EXAMPLE, built, records};

/// These kinds of a pixel's solution; of one ray, or of the whole pixel with what was built before.
#[track_caller]
fn told(strategy: StrategyName, pixel: [u32; 2], ray: Option<u32>, kinds: &[Kind]) -> String {
    let scene = built(EXAMPLE);
    let settings = Settings {
        strategy,
        building: true,
        ..Settings::default()
    };
    let options = WorkedOptions {
        kinds: Kinds::of(kinds),
        ray,
        ..WorkedOptions::default()
    };
    worked_text(
        &scene,
        &settings,
        &records(&scene, &settings, pixel),
        &options,
    )
}

#[test]
fn a_hierarchy_is_built() {
    assert_data_eq!(
        told(StrategyName::Hierarchy, [80, 60], None, &[Kind::Merge]),
        str![[r#"
Pixel (80, 60) of "two balls over a floor"
160 × 120 pixels, traced backward with rays to the lights, each ray tested against 4 objects in a hierarchy, walked depth first, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Built before the first ray
  node 4 from leaf 5 (A) and leaf 6 (B), slab 0: D_min = min(-1, -3) = -3, D_max = max(1, -1) = 1
  node 4 from leaf 5 (A) and leaf 6 (B), slab 1: D_min = min(-2, -1.5) = -2, D_max = max(0, -0.5) = 0
  node 4 from leaf 5 (A) and leaf 6 (B), slab 2: D_min = min(-1, -0.5) = -1, D_max = max(1, 0.5) = 1
  node 1 from leaf 3 (C) and node 4, slab 0: D_min = min(2, -3) = -3, D_max = max(3, 1) = 3
  node 1 from leaf 3 (C) and node 4, slab 1: D_min = min(-1, -2) = -2, D_max = max(0, 0) = 0
  node 1 from leaf 3 (C) and node 4, slab 2: D_min = min(0, -1) = -1, D_max = max(1, 1) = 1
  node 0 from node 1 and leaf 2 (floor), slab 0: D_min = min(-3, -9) = -9, D_max = max(3, 9) = 9
  node 0 from node 1 and leaf 2 (floor), slab 1: D_min = min(-2, 0) = -2, D_max = max(0, 0) = 0
  node 0 from node 1 and leaf 2 (floor), slab 2: D_min = min(-1, -9) = -9, D_max = max(1, 9) = 9

Ray 0: from the eye, depth 1

  Ray 1: to the light lamp, sent on from ray 0, depth 2

"#]]
    );
}

#[test]
fn a_hierarchy_is_walked_slab_by_slab() {
    let kinds = [Kind::SlabTest, Kind::BoundTest, Kind::Node];
    assert_data_eq!(
        told(StrategyName::Hierarchy, [80, 40], Some(0), &kinds),
        str![[r#"
Pixel (80, 40) of "two balls over a floor"
160 × 120 pixels, traced backward with rays to the lights, each ray tested against 4 objects in a hierarchy, walked depth first, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Ray 0: from the eye, depth 1
  node 0: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 9)·(-331.997) = -2987.98, far (S + D_min)·T = (0 - 9)·(-331.997) = 2987.98; largest near -2987.98, smallest far 2987.98
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 - 2)·(-8.51275) = 8.51275; largest near -8.51275, smallest far 8.51275
    slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = -1/[0·0.00301207 + 0·0.117471 + 1·(-0.993072)] = 1.00698
      near (S + D_min)·T = (6 - 9)·1.00698 = -3.02093, far (S + D_max)·T = (6 + 9)·1.00698 = 15.1046; largest near -3.02093, smallest far 8.51275
  node 0: the intersection of the slabs is met from t = -3.02093 to t = 8.51275: what is below it can be looked at
  Node 0, depth 0, with 2 child nodes: entered
  node 1: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 3)·(-331.997) = -995.992, far (S + D_min)·T = (0 - 3)·(-331.997) = 995.992; largest near -995.992, smallest far 995.992
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 - 2)·(-8.51275) = 8.51275; largest near -8.51275, smallest far 8.51275
    slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = -1/[0·0.00301207 + 0·0.117471 + 1·(-0.993072)] = 1.00698
      near (S + D_min)·T = (6 - 1)·1.00698 = 5.03488, far (S + D_max)·T = (6 + 1)·1.00698 = 7.04884; largest near 5.03488, smallest far 7.04884
  node 1: the intersection of the slabs is met from t = 5.03488 to t = 7.04884: what is below it can be looked at
  node 2: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 9)·(-331.997) = -2987.98, far (S + D_min)·T = (0 - 9)·(-331.997) = 2987.98; largest near -2987.98, smallest far 2987.98
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 + 0)·(-8.51275) = -8.51275; largest near -8.51275, smallest far -8.51275
    slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = -1/[0·0.00301207 + 0·0.117471 + 1·(-0.993072)] = 1.00698
      near (S + D_min)·T = (6 - 9)·1.00698 = -3.02093, far (S + D_max)·T = (6 + 9)·1.00698 = 15.1046; largest near -3.02093, smallest far -8.51275
      the largest near, -3.02093, is not below the smallest far, -8.512755: no t in common, missed, and no more slabs are looked at
  node 2: the intersection of the slabs is missed: nothing below it is looked at
  Node 1, depth 1, with 2 child nodes: entered
  node 3: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 3)·(-331.997) = -995.992, far (S + D_min)·T = (0 + 2)·(-331.997) = -663.995; largest near -995.992, smallest far -663.995
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 - 1)·(-8.51275) = 0; largest near -8.51275, smallest far -663.995
      the largest near, -8.512755, is not below the smallest far, -663.9949: no t in common, missed, and no more slabs are looked at
  node 3: the intersection of the slabs is missed: nothing below it is looked at
  node 4: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 1)·(-331.997) = -331.997, far (S + D_min)·T = (0 - 3)·(-331.997) = 995.992; largest near -331.997, smallest far 995.992
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 - 2)·(-8.51275) = 8.51275; largest near -8.51275, smallest far 8.51275
    slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = -1/[0·0.00301207 + 0·0.117471 + 1·(-0.993072)] = 1.00698
      near (S + D_min)·T = (6 - 1)·1.00698 = 5.03488, far (S + D_max)·T = (6 + 1)·1.00698 = 7.04884; largest near 5.03488, smallest far 7.04884
  node 4: the intersection of the slabs is met from t = 5.03488 to t = 7.04884: what is below it can be looked at
  Node 4, depth 2, with 2 child nodes: entered
  node 5: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 + 1)·(-331.997) = -331.997, far (S + D_min)·T = (0 - 1)·(-331.997) = 331.997; largest near -331.997, smallest far 331.997
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 + 0)·(-8.51275) = -8.51275, far (S + D_min)·T = (1 - 2)·(-8.51275) = 8.51275; largest near -8.51275, smallest far 8.51275
    slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = -1/[0·0.00301207 + 0·0.117471 + 1·(-0.993072)] = 1.00698
      near (S + D_min)·T = (6 - 1)·1.00698 = 5.03488, far (S + D_max)·T = (6 + 1)·1.00698 = 7.04884; largest near 5.03488, smallest far 7.04884
  node 5: the intersection of the slabs is met from t = 5.03488 to t = 7.04884: what is below it can be looked at
  node 6: the slabs around it
    slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = -1/[1·0.00301207 + 0·0.117471 + 0·(-0.993072)] = -331.997
      near (S + D_max)·T = (0 - 1)·(-331.997) = 331.997, far (S + D_min)·T = (0 - 3)·(-331.997) = 995.992; largest near 331.997, smallest far 995.992
    slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = -1/[0·0.00301207 + 1·0.117471 + 0·(-0.993072)] = -8.51275
      near (S + D_max)·T = (1 - 0.5)·(-8.51275) = -4.25638, far (S + D_min)·T = (1 - 1.5)·(-8.51275) = 4.25638; largest near 331.997, smallest far 4.25638
      the largest near, 331.9974, is not below the smallest far, 4.256377: no t in common, missed, and no more slabs are looked at
  node 6: the intersection of the slabs is missed: nothing below it is looked at
  Node 5, depth 3, a leaf with 1 object: entered
  Ray 1: to the light lamp, sent on from ray 0, depth 2: nothing in between: the light is visible

"#]]
    );
}

#[test]
fn a_hierarchy_is_walked_by_a_heap() {
    // the floor lies behind the ball: its node is still in the heap when the ball is met
    let kinds = [
        Kind::Ray,
        Kind::BoundTest,
        Kind::Node,
        Kind::Queue,
        Kind::SphereTest,
        Kind::Nearest,
        Kind::RayEnd,
    ];
    assert_data_eq!(
        told(StrategyName::Heap, [80, 76], None, &kinds),
        str![[r#"
Pixel (80, 76) of "two balls over a floor"
160 × 120 pixels, traced backward with rays to the lights, each ray tested against 4 objects in a hierarchy, walked by distance, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Ray 0: from the eye, depth 1
  P - COP = (0.00303309, -0.100092, -1), of length 1.00500128
  Δ = (P - COP)/1.00500128 = (0.00301799, -0.0995937, -0.995024): normalised, so that t is a distance and the window lies at t = 1.00500128
  (x, y, z) = (0, 1, 6) + t·(0.00301799, -0.0995937, -0.995024) … (i), for t > 0
  node 0: the intersection of the slabs is met from t = -3.015 to t = 10.0408: what is below it can be looked at
  heap: node 0 goes in with key 0 (the ray starts in it); 1 node waits
  heap: node 0 is the nearest, key 0; none waits
  Node 0, depth 0, with 2 child nodes: entered
  node 1: the intersection of the slabs is met from t = 5.02501 to t = 7.03501: what is below it can be looked at
  heap: node 1 goes in with key 5.02501; 1 node waits
  node 2: the intersection of the slabs is met from t = 10.0408 to t = 10.0408: what is below it can be looked at
  heap: node 2 goes in with key 10.0408; 2 nodes wait
  heap: node 1 is the nearest, key 5.02501; 1 node waits
  Node 1, depth 1, with 2 child nodes: entered
  node 3: the intersection of the slabs is missed: nothing below it is looked at
  node 4: the intersection of the slabs is met from t = 5.02501 to t = 7.03501: what is below it can be looked at
  heap: node 4 goes in with key 5.02501; 2 nodes wait
  heap: node 4 is the nearest, key 5.02501; 1 node waits
  Node 4, depth 2, with 2 child nodes: entered
  node 5: the intersection of the slabs is met from t = 5.02501 to t = 7.03501: what is below it can be looked at
  heap: node 5 goes in with key 5.02501; 2 nodes wait
  node 6: the intersection of the slabs is missed: nothing below it is looked at
  heap: node 5 is the nearest, key 5.02501; 1 node waits
  Node 5, depth 3, a leaf with 1 object: entered
  A: sphere, center (0, 1, 0), radius 1
    a·t² + b·t + c = 0 … (iii)
    o - center = (0, 0, 6)
    a = Δ·Δ = 0.0030179915² + (-0.099593718)² + (-0.99502361)² = 1
    b = 2·Δ·(o - center) = 2·[0.0030179915·0 + (-0.099593718)·0 + (-0.99502361)·6] = -11.940283
    c = |o - center|² - r² = 0² + 0² + 6² - 1² = 35
    b² - 4ac = 142.57037 - 140 = 2.5703655 > 0: two real roots
    t = (-b ± √2.5703655)/2a = (11.940283 ± 1.603236)/2 = 5.1685237 and 6.7717596
    t = 5.16852 is the smallest that counts: a hit; t = 6.77176 lies beyond it
    → the nearest hit so far
  heap: the nearest node, 2, has key 10.0408, behind the nearest hit: the search ends

  Ray 1: to the light lamp, sent on from ray 0, depth 2
    Δ = L = (light - p)/|light - p| = [(4, 6, 5) - (0.0155986, 0.485248, 0.857197)]/7.9656 = (0.500201, 0.692321, 0.520087)
    (x, y, z) = (0.0155986, 0.485248, 0.857197) + t·(0.500201, 0.692321, 0.520087) … (i), for t ≥ ε = 5.16852e-9 up to 7.9656, just short of the light
    node 0: the intersection of the slabs is met from t = -0.700899 to t = 2.18793: what is below it can be looked at
    heap: node 0 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    heap: node 0 is the nearest, key 5.16852e-9; none waits
    Node 0, depth 0, with 2 child nodes: entered
    node 1: the intersection of the slabs is met from t = -0.700899 to t = 0.274575: what is below it can be looked at
    heap: node 1 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    node 2: the intersection of the slabs lies behind the origin, from t = -0.700899 to t = -0.700899: nothing below it is looked at
    heap: node 1 is the nearest, key 5.16852e-9; none waits
    Node 1, depth 1, with 2 child nodes: entered
    node 3: the intersection of the slabs is missed: nothing below it is looked at
    node 4: the intersection of the slabs is met from t = -0.700899 to t = 0.274575: what is below it can be looked at
    heap: node 4 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    heap: node 4 is the nearest, key 5.16852e-9; none waits
    Node 4, depth 2, with 2 child nodes: entered
    node 5: the intersection of the slabs is met from t = -0.700899 to t = 0.274575: what is below it can be looked at
    heap: node 5 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    node 6: the intersection of the slabs is missed: nothing below it is looked at
    heap: node 5 is the nearest, key 5.16852e-9; none waits
    Node 5, depth 3, a leaf with 1 object: entered
    A: sphere, center (0, 1, 0), radius 1
      1·t² + 0.1944904·t + 1.302268e-15 = 0: b² - 4ac = 0.03782653 - 5.209073e-15 = 0.03782653; t = -0.19449 lies behind the origin; t = -6.6958e-15 is 0 within ε: the surface that the ray starts on
    → nothing in between: the light is visible

  I = ambient + lights = (0.08, 0.02, 0.02) + (0.0544573, 0.0136143, 0.0136143) = (0.134457, 0.0336143, 0.0336143)

"#]]
    );
}

#[test]
fn a_grid_is_built() {
    assert_data_eq!(
        told(StrategyName::Grid, [80, 60], None, &[Kind::Assign]),
        str![[r#"
Pixel (80, 60) of "two balls over a floor"
160 × 120 pixels, traced backward with rays to the lights, each ray tested against 4 objects in the cells of a grid, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Built before the first ray
  cell (1, 0, 1) lists A, which lies in it as a whole
  cell (1, 0, 1) lists B, which lies in it as a whole
  cell (1, 0, 1) lists C, which lies in it as a whole
  cell (0, 0, 0) lists floor, a part of which lies in it
  cell (1, 0, 0) lists floor, a part of which lies in it
  cell (2, 0, 0) lists floor, a part of which lies in it
  cell (0, 0, 1) lists floor, a part of which lies in it
  cell (1, 0, 1) lists floor, a part of which lies in it
  cell (2, 0, 1) lists floor, a part of which lies in it
  cell (0, 0, 2) lists floor, a part of which lies in it
  cell (1, 0, 2) lists floor, a part of which lies in it
  cell (2, 0, 2) lists floor, a part of which lies in it

Ray 0: from the eye, depth 1

  Ray 1: to the light lamp, sent on from ray 0, depth 2

"#]]
    );
}

#[test]
fn a_grid_is_walked_cell_by_cell() {
    // the floor is met beyond the first cell
    let kinds: Vec<_> = Kind::ALL
        .into_iter()
        .filter(|kind| {
            !matches!(
                kind,
                Kind::Assign | Kind::Shade | Kind::LightTerm | Kind::Edge
            )
        })
        .collect();
    assert_data_eq!(
        told(StrategyName::Grid, [40, 80], None, &kinds),
        str![[r#"
Pixel (40, 80) of "two balls over a floor"
160 × 120 pixels, traced backward with rays to the lights, each ray tested against 4 objects in the cells of a grid, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

The pixel's centre on the window
  40.5 pixels from the left and 80.5 from the top, of 160 × 120
  P = corner + 40.5/160·right + (1 - 80.5/120)·up
    = (-0.4852936, 0.6360298, 5) + 0.253125·(0.970587, 0, 0) + 0.329167·(0, 0.72794, 0)
    = (-0.2396137, 0.8756435, 5)

Ray 0: from the eye, depth 1
  P - COP = (-0.239614, -0.124356, -1), of length 1.0357989
  Δ = (P - COP)/1.0357989 = (-0.231332, -0.120059, -0.965438): normalised, so that t is a distance and the window lies at t = 1.0357989
  (x, y, z) = (0, 1, 6) + t·(-0.231332, -0.120059, -0.965438) … (i), for t > 0
  Grid of 3 × 1 × 3 cells from (-9, 0, -9) to (9, 2, 9)
  the ray is in its box from -3.1074 to 8.32927 and starts in cell (1, 0, 2)
  Cell (1, 0, 2): t from 0 to 3.1074, 1 object listed; next planes: x at 12.9684, y at 8.32927, z at 3.1074; it leaves across z
  floor: polygon of 4 vertices
    0·x + 1·y + 0·z + 0 = 0 … (iv)
    t = -(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)
      = -(0·0 + 1·1 + 0·6 + 0)/(0·(-0.231332) + 1·(-0.120059) + 0·(-0.965438))
      = -1/(-0.120059) = 8.32927
    p = o + t·Δ = (-1.92683, 1.11022e-16, -2.0414); |B| = 1 is the largest, so y is dropped: p' = (-1.92683, -2.0414)
    1 crossing, an odd number: p lies inside, a hit
    → the nearest hit so far
    → the hit at 8.32927 lies beyond this cell, which ends at 3.107397: it is kept, and the walk goes on
  Cell (1, 0, 1): t from 3.1074 to 8.32927, 4 objects listed; next planes: x at 12.9684, y at 8.32927, z at 9.32219; it leaves across y
  A: sphere, center (0, 1, 0), radius 1
    1·t² - 11.585261·t + 35 = 0: b² - 4ac = 134.21827 - 140 = -5.781731 < 0, no real root: missed
  B: ellipsoid, center (2, 1, 0), radii (1, 0.5, 0.5)
    3.8394561·t² - 45.415714·t + 147 = 0: b² - 4ac = 2062.5871 - 2257.6002 = -195.01309 < 0, no real root: missed
  C: box from (-3, 0, -1) to (-2, 1, 0)
    -3 ≤ x ≤ -2: T = -1/(-0.231332) = 4.32279, near (S + D)·T = (0 + 2)·4.32279 = 8.64557, far (0 + 3)·4.32279 = 12.9684
    0 ≤ y ≤ 1: T = -1/(-0.120059) = 8.32927, near (S + D)·T = (1 - 1)·8.32927 = 0, far (1 + 0)·8.32927 = 8.32927
    -1 ≤ z ≤ 0: T = -1/(-0.965438) = 1.0358, near (S + D)·T = (6 + 0)·1.0358 = 6.21479, far (6 + 1)·1.0358 = 7.25059
    the largest near, 8.64557, is above the smallest far, 7.25059: no t in common, missed
  floor: tested with this ray in an earlier cell, as its mailbox says
  the nearest hit lies in this cell: no later one can hold a nearer; 2 cells visited

  Ray 1: to the light lamp, sent on from ray 0, depth 2
    Δ = L = (light - p)/|light - p| = [(4, 6, 5) - (-1.92683, 1.11022e-16, -2.0414)]/10.9867 = (0.539453, 0.546113, 0.640899)
    (x, y, z) = (-1.92683, 1.11022e-16, -2.0414) + t·(0.539453, 0.546113, 0.640899) … (i), for t ≥ ε = 8.32927e-9 up to 10.9867, just short of the light
    Grid of 3 × 1 × 3 cells from (-9, 0, -9) to (9, 2, 9)
    the ray is in its box from 0 to 3.66225 and starts in cell (1, 0, 1)
    Cell (1, 0, 1): t from 8.32927e-9 to 3.66225, 4 objects listed; next planes: x at 9.13301, y at 3.66225, z at 7.86613; it leaves across y
    A: sphere, center (0, 1, 0), radius 1
      a·t² + b·t + c = 0 … (iii)
      o - center = (-1.9268293, -1, -2.0413973)
      a = Δ·Δ = 0.53945267² + 0.54611258² + 0.64089927² = 1
      b = 2·Δ·(o - center) = 2·[0.53945267·(-1.9268293) + 0.54611258·(-1) + 0.64089927·(-2.0413973)] = -5.7877516
      c = |o - center|² - r² = (-1.9268293)² + (-1)² + (-2.0413973)² - 1² = 7.8799741
      b² - 4ac = 33.498069 - 31.519896 = 1.9781728 > 0: two real roots
      t = (-b ± √1.9781728)/2a = (5.7877516 ± 1.4064753)/2 = 2.1906382 and 3.5971135
      t = 2.19064 is the smallest that counts: a hit; t = 3.59711 lies beyond it
    one hit is enough, wherever it lies: the walk ends; 1 cell visited
    → blocked by A at t = 2.19064: the point lies in its shadow

  I = ambient + lights = (0.08, 0.02, 0.02) + (0, 0, 0) = (0.08, 0.02, 0.02)

The pixel's colour
  what the eye ray brings back: (0.08, 0.02, 0.02)
  in the picture, times 255: (20, 5, 5)

"#]]
    );
}
