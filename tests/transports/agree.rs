//! A diffuse scene has one radiance: photons that reach a wide eye, photons that were stored, connecting lines and a long
//! path sampler of another make find the same.

use glam::DVec3;
use raystep::Transport;
use raystep::trace::LightOptions;

use super::room::{radiance, scene};
use super::{Block, Estimate, check_same, pictures};
use crate::seeded::Seeded;

/// How large the standard error of each mean may be.
const SIGMA: f64 = 0.005;

/// Blocks of the picture, 36 × 24 pixels of 0.1 with the middle of the wall in its own: under the first lamp, beside
/// it, and where the second lamp shines through the passage. The edge of the partition's shadow, at x = 0.4,
/// lies between the second and the third.
const PATCHES: [(&str, Block); 3] = [
    ("left", block([5, 13])),
    ("middle", block([13, 21])),
    ("right", block([23, 31])),
];

const fn block(columns: [u32; 2]) -> Block {
    let rows = [1, 23];
    Block { columns, rows }
}

/// What a transport makes of each patch, from one picture per seed.
fn by_transport(transport: Transport, seeds: u64, options: LightOptions) -> [Estimate; 3] {
    let pictures = pictures(&scene(), transport, seeds, options);
    PATCHES.map(|(name, block)| {
        let what = format!("{transport:?}, {name}");
        block.estimate(&pictures).is_within(SIGMA, &what)
    })
}

/// What the sampler of this test makes of it.
fn by_sampler(samples: u32) -> [Estimate; 3] {
    let mut chance = Seeded::new(7);
    PATCHES.map(|(name, Block { columns, rows })| {
        let samples: Vec<DVec3> = (0..samples)
            .map(|_| {
                let column = chance.within(f64::from(columns[0]), f64::from(columns[1]));
                let row = chance.within(f64::from(rows[0]), f64::from(rows[1]));
                radiance(0.1 * column - 1.8, 1.2 - 0.1 * row, &mut chance)
            })
            .collect();
        Estimate::of(&samples).is_within(SIGMA, &format!("sampler, {name}"))
    })
}

#[test]
fn four_ways_find_the_same_mean_radiance_of_three_patches_of_a_diffuse_room() {
    let usual = LightOptions::default();
    let forward = LightOptions {
        paths: 100_000,
        // a disc before the wall that the room has place for, and with nothing between the two
        aperture: Some(1.2),
        ..usual
    };
    let stored = LightOptions {
        paths: 50_000,
        nearest: 20,
        ..usual
    };
    let connected = LightOptions {
        samples: 8,
        ..usual
    };
    let ways = [
        ("sampler", by_sampler(200_000)),
        ("forward", by_transport(Transport::Forward, 48, forward)),
        ("stored", by_transport(Transport::HybridStored, 28, stored)),
        (
            "connected",
            by_transport(Transport::HybridConnected, 32, connected),
        ),
    ];
    for (i, (one, found)) in ways.iter().enumerate() {
        for (other, expected) in &ways[..i] {
            for (patch, (name, _)) in PATCHES.iter().enumerate() {
                let what = format!("{one} and {other}, {name}");
                check_same(&what, found[patch], expected[patch]);
            }
        }
    }
}
