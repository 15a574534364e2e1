//! A cube with a corner cut out and solid textures, whose patterns continue across every edge.

use std::f64::consts::FRAC_PI_2;

use super::{dull, sand_ramp};
use groundtruth::math::{Point, cos, sin};
use groundtruth::noise::Noise;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::{Compound, Mesh, Part, PartSphere};
use groundtruth::textures::{Paint, RampFbm, Wood};

/// The radius of the ball about the corner (1, 1, 1) that is cut out.
const RADIUS: f64 = 1.5;
/// The number of straight segments of each rounded edge, whose error is less than 3e-5.
const PIECES: u32 = 128;

/// The flat faces: triangle fans about the corner of each face that is opposite to the cut.
fn flat_faces() -> Mesh {
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for axis in 0..3 {
        // counter-clockwise in the two other coordinates
        let whole = vec![[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        let on_arc = |i: u32| {
            let angle = FRAC_PI_2 * (2.0 + f64::from(i) / f64::from(PIECES));
            [1.0 + RADIUS * cos(angle), 1.0 + RADIUS * sin(angle)]
        };
        let mut cut = vec![[-1.0, -1.0], [1.0, -1.0]];
        cut.extend((0..=PIECES).rev().map(on_arc));
        cut.push([-1.0, 1.0]);
        for (height, outline) in [(-1.0, whole), (1.0, cut)] {
            let first = vertices.len() as u32;
            let at = |[a, b]: [f64; 2]| {
                Point::ORIGIN.with(axis, height).with((axis + 1) % 3, a).with((axis + 2) % 3, b)
            };
            vertices.extend(outline.iter().map(|&corner| at(corner)));
            let last = outline.len() as u32 - 1;
            triangles.extend((1..last).map(|i| [first, first + i, first + i + 1]));
        }
    }
    Mesh::of_lists(vertices, triangles)
}

fn cut_cube(about: &str, paint: impl Into<Paint>) -> Scene {
    let view = [point(6.0, 8.0, 12.0), point(0.0, -0.1, 0.0)];
    let mut scene = pinhole(about, [600, 600], view, 2850.0);
    scene.background = grey(0.5).into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("sun", vector(5.0, 12.0, 8.0), 2.5));
    let hollow = PartSphere {
        center: point(1.0, 1.0, 1.0),
        radius: RADIUS,
        phi: [180.0, 270.0],
        theta: [90.0, 180.0],
        inward: true,
    };
    let parts = vec![Part::new(flat_faces()), Part::new(hollow)];
    add(&mut scene, "cube", Compound { accel: None, parts }, dull(paint));
    scene
}

pub fn of_wood() -> Scene {
    let about = "the cut cube of figure 30.1 in wood: rings on top, grain along the sides";
    cut_cube(about, Wood::default())
}

pub fn of_sandstone() -> Scene {
    let about = "figure 31.41: a cut cube of sandstone with layers through the whole cube";
    let noise = Noise::of_octaves(4);
    cut_cube(about, RampFbm { ramp: sand_ramp(), noise, size: 0.15, perturbation: 1.0 })
}
