//! What the search of each strategy reads like: pixels of the first lesson's scene, for a reader's eyes.
#![allow(
    clippy::needless_raw_string_hashes,
    reason = "snapbox writes the snapshots so"
)]

use raystep::trace::{Kind, Kinds};
use raystep::{Settings, StrategyName, WorkedOptions};

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
160 × 120 pixels, traced backward with shadow rays to the lights, each ray tested against 4 objects in a hierarchy, traversed depth first, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Building, before the first ray
  node 4 from leaf 5 (A) and leaf 6 (B), slab 0: D_min = min(−1, −3) = −3, D_max = max(1, −1) = 1
  node 4 from leaf 5 (A) and leaf 6 (B), slab 1: D_min = min(−2, −1.5) = −2, D_max = max(0, −0.5) = 0
  node 4 from leaf 5 (A) and leaf 6 (B), slab 2: D_min = min(−1, −0.5) = −1, D_max = max(1, 0.5) = 1
  node 1 from leaf 3 (C) and node 4, slab 0: D_min = min(2, −3) = −3, D_max = max(3, 1) = 3
  node 1 from leaf 3 (C) and node 4, slab 1: D_min = min(−1, −2) = −2, D_max = max(0, 0) = 0
  node 1 from leaf 3 (C) and node 4, slab 2: D_min = min(0, −1) = −1, D_max = max(1, 1) = 1
  node 0 from node 1 and leaf 2 (floor), slab 0: D_min = min(−3, −9) = −9, D_max = max(3, 9) = 9
  node 0 from node 1 and leaf 2 (floor), slab 1: D_min = min(−2, 0) = −2, D_max = max(0, 0) = 0
  node 0 from node 1 and leaf 2 (floor), slab 2: D_min = min(−1, −9) = −9, D_max = max(1, 9) = 9

Ray 0: eye ray, depth 1

  Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2

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
160 × 120 pixels, traced backward with shadow rays to the lights, each ray tested against 4 objects in a hierarchy, traversed depth first, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Ray 0: eye ray, depth 1
  Bounding volume of node 0, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 9)·(−331.997) = −2987.98, far = (S + D_min)·T = (0 − 9)·(−331.997) = 2987.98
      interval: max near −2987.98 ≤ min far 2987.98 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 − 2)·(−8.51275) = 8.51275
      interval: max near −8.51275 ≤ min far 8.51275 so far
    S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = −1/[0·0.00301207 + 0·0.117471 + 1·(−0.993072)] = 1.00698
      near, far: near = (S + D_min)·T = (6 − 9)·1.00698 = −3.02093, far = (S + D_max)·T = (6 + 9)·1.00698 = 15.1046
      interval: max near −3.02093 ≤ min far 8.51275 so far
  bounding volume of node 0 (slabs): hit, inside for t in [−3.02093, 8.51275], so the node can be entered
  node 0, depth 0, with 2 child nodes: entered
  Bounding volume of node 1, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 3)·(−331.997) = −995.992, far = (S + D_min)·T = (0 − 3)·(−331.997) = 995.992
      interval: max near −995.992 ≤ min far 995.992 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 − 2)·(−8.51275) = 8.51275
      interval: max near −8.51275 ≤ min far 8.51275 so far
    S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = −1/[0·0.00301207 + 0·0.117471 + 1·(−0.993072)] = 1.00698
      near, far: near = (S + D_min)·T = (6 − 1)·1.00698 = 5.03488, far = (S + D_max)·T = (6 + 1)·1.00698 = 7.04884
      interval: max near 5.03488 ≤ min far 7.04884 so far
  bounding volume of node 1 (slabs): hit, inside for t in [5.03488, 7.04884], so the node can be entered
  Bounding volume of node 2, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 9)·(−331.997) = −2987.98, far = (S + D_min)·T = (0 − 9)·(−331.997) = 2987.98
      interval: max near −2987.98 ≤ min far 2987.98 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 + 0)·(−8.51275) = −8.51275
      interval: max near −8.51275 ≤ min far −8.51275 so far
    S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = −1/[0·0.00301207 + 0·0.117471 + 1·(−0.993072)] = 1.00698
      near, far: near = (S + D_min)·T = (6 − 9)·1.00698 = −3.02093, far = (S + D_max)·T = (6 + 9)·1.00698 = 15.1046
      interval: max near −3.02093 > min far −8.512755: no t in common, missed; no more slabs are tested
  bounding volume of node 2 (slabs): missed, so nothing below the node is tested
  node 1, depth 1, with 2 child nodes: entered
  Bounding volume of node 3, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 3)·(−331.997) = −995.992, far = (S + D_min)·T = (0 + 2)·(−331.997) = −663.995
      interval: max near −995.992 ≤ min far −663.995 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 − 1)·(−8.51275) = 0
      interval: max near −8.512755 > min far −663.9949: no t in common, missed; no more slabs are tested
  bounding volume of node 3 (slabs): missed, so nothing below the node is tested
  Bounding volume of node 4, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 1)·(−331.997) = −331.997, far = (S + D_min)·T = (0 − 3)·(−331.997) = 995.992
      interval: max near −331.997 ≤ min far 995.992 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 − 2)·(−8.51275) = 8.51275
      interval: max near −8.51275 ≤ min far 8.51275 so far
    S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = −1/[0·0.00301207 + 0·0.117471 + 1·(−0.993072)] = 1.00698
      near, far: near = (S + D_min)·T = (6 − 1)·1.00698 = 5.03488, far = (S + D_max)·T = (6 + 1)·1.00698 = 7.04884
      interval: max near 5.03488 ≤ min far 7.04884 so far
  bounding volume of node 4 (slabs): hit, inside for t in [5.03488, 7.04884], so the node can be entered
  node 4, depth 2, with 2 child nodes: entered
  Bounding volume of node 5, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 + 1)·(−331.997) = −331.997, far = (S + D_min)·T = (0 − 1)·(−331.997) = 331.997
      interval: max near −331.997 ≤ min far 331.997 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 + 0)·(−8.51275) = −8.51275, far = (S + D_min)·T = (1 − 2)·(−8.51275) = 8.51275
      interval: max near −8.51275 ≤ min far 8.51275 so far
    S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·1 + 1·6 = 6, T = −1/[0·0.00301207 + 0·0.117471 + 1·(−0.993072)] = 1.00698
      near, far: near = (S + D_min)·T = (6 − 1)·1.00698 = 5.03488, far = (S + D_max)·T = (6 + 1)·1.00698 = 7.04884
      interval: max near 5.03488 ≤ min far 7.04884 so far
  bounding volume of node 5 (slabs): hit, inside for t in [5.03488, 7.04884], so the node can be entered
  Bounding volume of node 6, slab by slab
    S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·1 + 0·6 = 0, T = −1/[1·0.00301207 + 0·0.117471 + 0·(−0.993072)] = −331.997
      near, far: near = (S + D_max)·T = (0 − 1)·(−331.997) = 331.997, far = (S + D_min)·T = (0 − 3)·(−331.997) = 995.992
      interval: max near 331.997 ≤ min far 995.992 so far
    S, T of slab 1, (A, B, C) = (0, 1, 0): S = 0·0 + 1·1 + 0·6 = 1, T = −1/[0·0.00301207 + 1·0.117471 + 0·(−0.993072)] = −8.51275
      near, far: near = (S + D_max)·T = (1 − 0.5)·(−8.51275) = −4.25638, far = (S + D_min)·T = (1 − 1.5)·(−8.51275) = 4.25638
      interval: max near 331.9974 > min far 4.256377: no t in common, missed; no more slabs are tested
  bounding volume of node 6 (slabs): missed, so nothing below the node is tested
  node 5, depth 3, a leaf with 1 object: entered
  Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2: no object is in between, so the light is visible

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
160 × 120 pixels, traced backward with shadow rays to the lights, each ray tested against 4 objects in a hierarchy, traversed in the order of distance, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Ray 0: eye ray, depth 1
  direction: P − COP = (0.00303309, −0.100092, −1), of length 1.00500128
  Δ = (P − COP)/1.00500128 = (0.00301799, −0.0995937, −0.995024): normalised, so t is a distance and the window is at t = 1.00500128
  ray: (x, y, z) = (0, 1, 6) + t·(0.00301799, −0.0995937, −0.995024) … (i), for t > 0
  bounding volume of node 0 (slabs): hit, inside for t in [−3.015, 10.0408], so the node can be entered
  heap: node 0 goes in with key 0 (the ray starts in it); 1 node waits
  heap: node 0 is the nearest, key 0; none waits
  node 0, depth 0, with 2 child nodes: entered
  bounding volume of node 1 (slabs): hit, inside for t in [5.02501, 7.03501], so the node can be entered
  heap: node 1 goes in with key 5.02501; 1 node waits
  bounding volume of node 2 (slabs): hit, inside for t in [10.0408, 10.0408], so the node can be entered
  heap: node 2 goes in with key 10.0408; 2 nodes wait
  heap: node 1 is the nearest, key 5.02501; 1 node waits
  node 1, depth 1, with 2 child nodes: entered
  bounding volume of node 3 (slabs): missed, so nothing below the node is tested
  bounding volume of node 4 (slabs): hit, inside for t in [5.02501, 7.03501], so the node can be entered
  heap: node 4 goes in with key 5.02501; 2 nodes wait
  heap: node 4 is the nearest, key 5.02501; 1 node waits
  node 4, depth 2, with 2 child nodes: entered
  bounding volume of node 5 (slabs): hit, inside for t in [5.02501, 7.03501], so the node can be entered
  heap: node 5 goes in with key 5.02501; 2 nodes wait
  bounding volume of node 6 (slabs): missed, so nothing below the node is tested
  heap: node 5 is the nearest, key 5.02501; 1 node waits
  node 5, depth 3, a leaf with 1 object: entered
  A: sphere, centre (0, 1, 0), radius 1
    frame: o − centre = (0, 0, 6)
    a, b, c of a·t² + b·t + c = 0 … (iii)
    a = Δ·Δ = 0.0030179915² + (−0.099593718)² + (−0.99502361)² = 1
    b = 2·Δ·(o − centre) = 2·[0.0030179915·0 + (−0.099593718)·0 + (−0.99502361)·6] = −11.940283
    c = |o − centre|² − r² = 0² + 0² + 6² − 1² = 35
    discriminant: b² − 4ac = 142.57037 − 140 = 2.5703655 > 0: two real roots
    roots: t = (−b ± √2.5703655)/2a = (11.940283 ± 1.603236)/2 = 5.1685237 and 6.7717596
    the program computes the same with less rounding: b² − 4ac as 4(a·r² − |Δ × (o − centre)|²), and the root nearer to 0 as c/(a·t) of the other
    root that counts: t = 5.16852, the smallest that counts: a hit; t = 6.77176 lies beyond it
    → nearest hit so far
  heap: node 2 is the nearest, key 10.0408, behind the nearest hit: the search ends

  Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2
    direction: Δ = L = (light − p)/|light − p| = [(4, 6, 5) − (0.0155986, 0.485248, 0.857197)]/7.9656 = (0.500201, 0.692321, 0.520087)
    ray: (x, y, z) = (0.0155986, 0.485248, 0.857197) + t·(0.500201, 0.692321, 0.520087) … (i), for t ≥ ε = 5.16852e-9 up to 7.9656, just short of the light
    bounding volume of node 0 (slabs): hit, inside for t in [−0.700899, 2.18793], so the node can be entered
    heap: node 0 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    heap: node 0 is the nearest, key 5.16852e-9; none waits
    node 0, depth 0, with 2 child nodes: entered
    bounding volume of node 1 (slabs): hit, inside for t in [−0.700899, 0.274575], so the node can be entered
    heap: node 1 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    bounding volume of node 2 (slabs): behind the origin, inside for t in [−0.700899, −0.700899], so nothing below the node is tested
    heap: node 1 is the nearest, key 5.16852e-9; none waits
    node 1, depth 1, with 2 child nodes: entered
    bounding volume of node 3 (slabs): missed, so nothing below the node is tested
    bounding volume of node 4 (slabs): hit, inside for t in [−0.700899, 0.274575], so the node can be entered
    heap: node 4 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    heap: node 4 is the nearest, key 5.16852e-9; none waits
    node 4, depth 2, with 2 child nodes: entered
    bounding volume of node 5 (slabs): hit, inside for t in [−0.700899, 0.274575], so the node can be entered
    heap: node 5 goes in with key 5.16852e-9 (the ray starts in it); 1 node waits
    bounding volume of node 6 (slabs): missed, so nothing below the node is tested
    heap: node 5 is the nearest, key 5.16852e-9; none waits
    node 5, depth 3, a leaf with 1 object: entered
    A: sphere, centre (0, 1, 0), radius 1
      discriminant of t² + 0.1944904·t + 1.302268e-15 = 0: b² − 4ac = 0.03782653 − 5.209073e-15 = 0.03782653
      root that counts: none, t = −0.19449 lies behind the origin; t = −6.6958e-15 is 0 within ε: the surface that the ray starts on: missed
    → visibility: no object is in between, so the light is visible

  colour of the ray: I = ambient + lights = (0.08, 0.02, 0.02) + (0.0544573, 0.0136143, 0.0136143) = (0.134457, 0.0336143, 0.0336143)

"#]]
    );
}

#[test]
fn a_grid_is_built() {
    assert_data_eq!(
        told(StrategyName::Grid, [80, 60], None, &[Kind::Assign]),
        str![[r#"
Pixel (80, 60) of "two balls over a floor"
160 × 120 pixels, traced backward with shadow rays to the lights, each ray tested against 4 objects in the cells of a grid, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Building, before the first ray
  cell [1, 0, 1] lists A, all of which is in it
  cell [1, 0, 1] lists B, all of which is in it
  cell [1, 0, 1] lists C, all of which is in it
  cell [0, 0, 0] lists floor, a part of which is in it
  cell [1, 0, 0] lists floor, a part of which is in it
  cell [2, 0, 0] lists floor, a part of which is in it
  cell [0, 0, 1] lists floor, a part of which is in it
  cell [1, 0, 1] lists floor, a part of which is in it
  cell [2, 0, 1] lists floor, a part of which is in it
  cell [0, 0, 2] lists floor, a part of which is in it
  cell [1, 0, 2] lists floor, a part of which is in it
  cell [2, 0, 2] lists floor, a part of which is in it

Ray 0: eye ray, depth 1

  Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2

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
160 × 120 pixels, traced backward with shadow rays to the lights, each ray tested against 4 objects in the cells of a grid, depth up to 5
bounds are padded by 1e-10 of the coordinates, so rounding cuts off no hit

Window point: the pixel's centre
  40.5 pixels from the left and 80.5 from the top, of 160 × 120
  P = corner + 40.5/160·right + (1 − 80.5/120)·up
    = (−0.4852936, 0.6360298, 5) + 0.253125·(0.970587, 0, 0) + 0.329167·(0, 0.72794, 0)
    = (−0.2396137, 0.8756435, 5)

Ray 0: eye ray, depth 1
  direction: P − COP = (−0.239614, −0.124356, −1), of length 1.0357989
  Δ = (P − COP)/1.0357989 = (−0.231332, −0.120059, −0.965438): normalised, so t is a distance and the window is at t = 1.0357989
  ray: (x, y, z) = (0, 1, 6) + t·(−0.231332, −0.120059, −0.965438) … (i), for t > 0
  grid of 3 × 1 × 3 cells from (−9, 0, −9) to (9, 2, 9)
  the ray is in its box for t in [−3.1074, 8.32927] and starts in cell [1, 0, 2]
  cell [1, 0, 2]: t in [0, 3.1074], 1 object listed
    next planes: x at t = 12.9684, y at t = 8.32927, z at t = 3.1074; the ray leaves the cell across z
  floor: polygon of 4 vertices
    plane: 0·x + y + 0·z + 0 = 0 … (iv)
    t = −(A·x₀ + B·y₀ + C·z₀ + D)/(A·Δx + B·Δy + C·Δz) … (v)
      = −(0·0 + 1·1 + 0·6 + 0)/(0·(−0.231332) + 1·(−0.120059) + 0·(−0.965438))
      = −1/(−0.120059) = 8.32927
    p = o + t·Δ = (−1.92683, 1.11022e-16, −2.0414)
    axis: |B| = 1 is the largest coefficient, so y is dropped
    p′ = (−1.92683, −2.0414)
    inside or outside: 1 crossing, an odd number, so p lies inside: a hit
    → nearest hit so far
    → hit outside the cell: t = 8.32927 is beyond the end of the cell at 3.107397, so the hit is kept and the traversal continues
  cell [1, 0, 1]: t in [3.1074, 8.32927], 4 objects listed
    next planes: x at t = 12.9684, y at t = 8.32927, z at t = 9.32219; the ray leaves the cell across y
  A: sphere, centre (0, 1, 0), radius 1
    discriminant of t² − 11.585261·t + 35 = 0: b² − 4ac = 134.21827 − 140 = −5.781731 < 0, no real root: missed
  B: ellipsoid, centre (2, 1, 0), radii (1, 0.5, 0.5)
    discriminant of 3.8394561·t² − 45.415714·t + 147 = 0: b² − 4ac = 2062.5871 − 2257.6002 = −195.01309 < 0, no real root: missed
  C: box from (−3, 0, −1) to (−2, 1, 0)
    near, far of a slab: S is the coordinate of o along its axis, D is minus the coordinate of a plane, and T is −1 over the component of Δ along the axis
    near, far of −3 ≤ x ≤ −2: T = −1/(−0.231332) = 4.32279, near = (S + D)·T = (0 + 2)·4.32279 = 8.64557, far = (S + D)·T = (0 + 3)·4.32279 = 12.9684
    near, far of 0 ≤ y ≤ 1: T = −1/(−0.120059) = 8.32927, near = (S + D)·T = (1 − 1)·8.32927 = 0, far = (S + D)·T = (1 + 0)·8.32927 = 8.32927
    near, far of −1 ≤ z ≤ 0: T = −1/(−0.965438) = 1.0358, near = (S + D)·T = (6 + 0)·1.0358 = 6.21479, far = (S + D)·T = (6 + 1)·1.0358 = 7.25059
    interval: max near 8.64557 > min far 7.25059: no t in common, missed
  mailbox of floor: tested with this ray in an earlier cell, so not again
  end of the traversal: the nearest hit is in this cell, so no later cell has a nearer one; 2 cells visited

  Ray 1: shadow ray to light "lamp", spawned by ray 0, depth 2
    direction: Δ = L = (light − p)/|light − p| = [(4, 6, 5) − (−1.92683, 1.11022e-16, −2.0414)]/10.9867 = (0.539453, 0.546113, 0.640899)
    ray: (x, y, z) = (−1.92683, 1.11022e-16, −2.0414) + t·(0.539453, 0.546113, 0.640899) … (i), for t ≥ ε = 8.32927e-9 up to 10.9867, just short of the light
    grid of 3 × 1 × 3 cells from (−9, 0, −9) to (9, 2, 9)
    the ray is in its box for t in [0, 3.66225] and starts in cell [1, 0, 1]
    cell [1, 0, 1]: t in [8.32927e-9, 3.66225], 4 objects listed
      next planes: x at t = 9.13301, y at t = 3.66225, z at t = 7.86613; the ray leaves the cell across y
    A: sphere, centre (0, 1, 0), radius 1
      frame: o − centre = (−1.9268293, −1, −2.0413973)
      a, b, c of a·t² + b·t + c = 0 … (iii)
      a = Δ·Δ = 0.53945267² + 0.54611258² + 0.64089927² = 1
      b = 2·Δ·(o − centre) = 2·[0.53945267·(−1.9268293) + 0.54611258·(−1) + 0.64089927·(−2.0413973)] = −5.7877516
      c = |o − centre|² − r² = (−1.9268293)² + (−1)² + (−2.0413973)² − 1² = 7.8799741
      discriminant: b² − 4ac = 33.498069 − 31.519896 = 1.9781728 > 0: two real roots
      roots: t = (−b ± √1.9781728)/2a = (5.7877516 ± 1.4064753)/2 = 2.1906382 and 3.5971135
      the program computes the same with less rounding: b² − 4ac as 4(a·r² − |Δ × (o − centre)|²), and the root nearer to 0 as c/(a·t) of the other
      root that counts: t = 2.19064, the smallest that counts: a hit; t = 3.59711 lies beyond it
    end of the traversal: one hit is enough for a shadow ray; 1 cell visited
    → visibility: blocked by A at t = 2.19064, so the point is in its shadow

  colour of the ray: I = ambient + lights = (0.08, 0.02, 0.02) + (0, 0, 0) = (0.08, 0.02, 0.02)

Colour of the pixel
  from the eye ray: (0.08, 0.02, 0.02)
  times 255, in the picture: (20, 5, 5)

"#]]
    );
}
