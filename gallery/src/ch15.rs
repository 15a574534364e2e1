//! Chapter 15: specular reflection. Lights have no shadows yet.

use super::List;
use super::shaded_sets::{
    LIGHT_GREEN, ORANGE, YELLOW, before_the_set, four_cylinders, set_of, thirty_five_spheres,
};
use groundtruth::materials::{Matte, Phong};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;

pub const SCENES: List = &[
    ("ch15/page-one", || {
        spheres("the picture of page one: 35 spheres with highlights of e = 10", 10.0)
    }),
    ("ch15/exponents", || {
        let about = "figure 15.7: highlights of e = 5, 20, 100 and 1000, from wide to narrow";
        let exponents = [5.0, 20.0, 100.0, 1000.0];
        four_cylinders(about, exponents.map(|e| phong(0.25, 0.6, grey(0.5), 0.2, e).into()))
    }),
    ("ch15/set", glossy_set),
    ("ch15/fractional-exponent", || {
        let about = "figure 15.15: e = 0.25; a highlight so wide that it ends in an edge";
        spheres(about, 0.25)
    }),
];

/// Page one and figure 15.15.
fn spheres(about: &str, exponent: f64) -> Scene {
    let sun = directional("sun", vector(100.0, 100.0, 200.0), 3.0).without_shadows();
    thirty_five_spheres(about, sun, |color| {
        phong(0.25, 0.75, toned_down(color), 0.1, exponent).into()
    })
}

/// Makes bright colours darker, so that highlights are not out of range.
fn toned_down(color: Rgb) -> Rgb {
    if [YELLOW, ORANGE, LIGHT_GREEN].contains(&color) { 0.75 * color } else { color }
}

/// Figure 15.8.
fn glossy_set() -> Scene {
    let about = "figure 15.8: the set of chapter 14 with highlights of e = 50, 500, 4 and 3";
    let sun = directional("sun", vector(15.0, 15.0, 2.5), 2.0).without_shadows();
    set_of(before_the_set(about), Some(sun), |name, Matte { ka, kd, cd }| {
        let (ks, exponent) = match name {
            "yellow sphere" => (0.25, 50.0),
            "orange sphere" => (0.25, 500.0),
            "cylinder" => (0.25, 4.0),
            "box" => (0.5, 3.0),
            _ => return Matte { ka, kd, cd }.into(),
        };
        Phong { ka, kd, cd, ks: ks.into(), exponent: exponent.into(), ..Phong::default() }.into()
    })
}
