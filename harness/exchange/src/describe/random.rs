//! The random numbers that a scene's contents depend on: lattice noise, random spheres and colours.

use std::collections::BTreeSet;

use serde_json::Value;

use groundtruth::noise::Lattice;

use super::page::DescriptionPage;
use super::tables::{all_of, has};
use super::values::{row, shown};

/// The section of random numbers, if the scene has any, and of what the text cannot say.
pub fn write(page: &mut DescriptionPage, data: &Value) {
    let noises = all_of(data, "noise");
    let seeds: BTreeSet<u64> = noises.iter().filter_map(|noise| noise["seed"].as_u64()).collect();
    let draws = |picture: &str| all_of(data, "picture").iter().any(|it| *it == picture);
    let has_hash = has(data, "random_colors") || draws("country");
    let has_generator = has_hash || has(data, "random_spheres") || draws("globe");
    if !seeds.is_empty() || has_generator {
        page.heading("Random numbers");
    }
    if !seeds.is_empty() {
        page.tell("noise");
        // bumps and wood add vectors of noise
        let has_vectors = !all_of(data, "bump").is_empty() || has(data, "wood");
        for (number, seed) in seeds.into_iter().enumerate() {
            lattice(page, seed, number == 0, has_vectors);
        }
    }
    if has_generator {
        page.tell("generator");
    }
    if has_hash {
        page.tell("hash");
    }
    if has(data, "random_spheres") {
        page.tell("spheres");
    }
    if draws("label") {
        page.heading("What this text leaves out");
        page.tell("label");
    }
}

/// The tables of one seed; the permutation is the same for all.
fn lattice(page: &mut DescriptionPage, seed: u64, is_first: bool, has_vectors: bool) {
    let lattice = Lattice::new(seed);
    page.blank();
    if is_first {
        let permutation: Vec<String> = lattice.permutation().iter().map(u8::to_string).collect();
        page.line(0, &format!("P = [{}]", permutation.join(", ")));
    }
    let values: Vec<String> = lattice.values().iter().map(|&value| shown(value)).collect();
    page.line(0, &format!("The numbers of seed {seed}: [{}]", values.join(", ")));
    if has_vectors {
        let vectors: Vec<String> =
            lattice.vectors().iter().map(|vector| row(vector.to_array())).collect();
        page.line(0, &format!("The vectors of seed {seed}: [{}]", vectors.join(", ")));
    }
}
