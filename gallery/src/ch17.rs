//! Chapter 17: ambient occlusion.

use super::List;
use super::sets::city_on;
use groundtruth::cameras::Orthographic;
use groundtruth::lights::AmbientOccluder;
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::samplers::{Random, Regular};
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{PartCylinder, Rectangle, TessellatedSphere};

pub const SCENES: List = &[
    ("ch17/regular", || {
        let about = "figure 17.4: 64 regular samples give bands of constant occlusion";
        let mut scene = sphere_on_a_plane(about, 64);
        scene.image.sampler = Some(Regular {}.into());
        scene
    }),
    ("ch17/random", || {
        let about = "figure 17.6: 64 random samples leave noise";
        let mut scene = sphere_on_a_plane(about, 64);
        scene.image.sampler = Some(Random {}.into());
        scene
    }),
    ("ch17/one-sample", || {
        sphere_on_a_plane("figure 17.7a: with one sample every pixel is either lit or black", 1)
    }),
    ("ch17/sphere", || {
        sphere_on_a_plane("figure 17.7c: 64 samples; the plane is dark below the sphere", 64)
    }),
    ("ch17/sphere-in-sunlight", || {
        let about = "figure 17.8: the sphere with a directional light";
        let mut scene = sphere_on_a_plane(about, 64);
        for material in &mut scene.materials {
            material.recipe = match material.name.as_str() {
                "sphere" => matte(0.5, 0.6, rgb(1.0, 1.0, 0.0)).into(),
                _ => matte(0.5, 0.75, Rgb::WHITE).into(),
            };
        }
        scene.lights.push(directional("sun", SUN, 1.5));
        scene
    }),
    ("ch17/two-colours", || {
        let about = "the chapter's exercise: blue light where ambient light is blocked";
        let mut scene = sphere_on_a_plane(about, 64);
        let source = AmbientOccluder {
            ls: 1.0,
            color: rgb(1.0, 0.9, 0.75),
            min_amount: 0.5,
            occluded_color: Some(rgb(0.2, 0.3, 1.0)),
            max_distance: None,
        };
        scene.lights = vec![Light::new("ambient", source)];
        scene
    }),
    ("ch17/near-occlusion", || {
        let about = "occlusion counts within a distance of half the sphere's radius: a small dark ring below it";
        let mut scene = sphere_on_a_plane(about, 64);
        let source = AmbientOccluder {
            ls: 1.0,
            color: Rgb::WHITE,
            min_amount: 0.0,
            occluded_color: None,
            max_distance: Some(0.5),
        };
        scene.lights = vec![Light::new("ambient", source)];
        scene
    }),
    ("ch17/one-sided", || {
        let about = "figure 17.9: outward normals only: the inside is shaded like the outside";
        half_cylinder(about, FROM_THE_FRONT, false)
    }),
    ("ch17/half-cylinder", || {
        let about = "figure 17.10: two-sided: the inside of half a cylinder is shaded correctly";
        half_cylinder(about, FROM_THE_FRONT, true)
    }),
    ("ch17/half-cylinder-in-sunlight", || {
        let about = "figure 17.11: half a cylinder with a directional light";
        let mut scene = half_cylinder(about, FROM_THE_FRONT, true);
        scene.lights.push(directional("sun", SUN, 1.5));
        scene
    }),
    ("ch17/corner-ambient", || corner("as figure 17.12a: ambient light without occlusion", 1.0)),
    ("ch17/corner", || corner("as figure 17.12b: a bumpy mesh in a corner, min_amount 0.25", 0.25)),
    ("ch17/corner-dark", || corner("as figure 17.12c: with min_amount 0, corners are black", 0.0)),
    ("ch17/city", city),
    ("ch17/half-cylinder-inside", || {
        let about = "figure 17.14: the inside of the half cylinder, darker towards the ground";
        half_cylinder(about, INTO_IT, true)
    }),
];

/// The sun of figures 17.8 and 17.11.
const SUN: Vector = Vector::new(0.0, 150.0, 200.0);

/// Figures 17.4 to 17.7.
fn sphere_on_a_plane(about: &str, samples: u32) -> Scene {
    let view = [point(25.0, 20.0, 45.0), point(0.0, 1.0, 0.0)];
    let mut scene = pinhole(about, [400, 400], view, 5000.0);
    scene.image.samples = samples;
    scene.lights.push(occluder(0.0));
    let yellow = matte(0.75, 0.0, rgb(1.0, 1.0, 0.0));
    add(&mut scene, "sphere", sphere(point(0.0, 1.0, 0.0), 1.0), yellow);
    add(&mut scene, "ground", ground(0.0), matte(0.75, 0.0, Rgb::WHITE));
    scene
}

/// The eye, the point that it looks at, and the distance of the view plane.
type View = ([Point; 2], f64);
const FROM_THE_FRONT: View = ([Point::new(-5.0, 2.0, 10.0), Point::new(0.35, 0.45, 0.0)], 2000.0);
const INTO_IT: View = ([Point::new(-10.0, 2.0, 0.0), Point::new(0.35, 0.45, 0.0)], 1500.0);

/// Figures 17.9 to 17.11, and 17.14.
fn half_cylinder(about: &str, (view, distance): View, two_sided: bool) -> Scene {
    let mut scene = pinhole(about, [400, 400], view, distance);
    scene.image.samples = 64;
    scene.lights.push(occluder(0.0));
    let wall = PartCylinder { y0: 0.0, y1: 1.0, radius: 1.0, phi: [0.0, 180.0], inward: false };
    let (wall, mut orange) = object("half cylinder", wall, matte(0.85, 0.6, rgb(1.0, 0.5, 0.0)));
    orange.two_sided = two_sided;
    scene.objects.push(wall);
    scene.materials.push(orange);
    add(&mut scene, "ground", ground(0.0), matte(0.5, 0.75, Rgb::WHITE));
    scene
}

/// As figure 17.12: a bumpy sphere instead of the book's bunny, in the book's corner.
fn corner(about: &str, min_amount: f64) -> Scene {
    let view = [point(20.0, 10.0, 40.0), point(-0.025, 0.11, 0.0)];
    let mut scene = pinhole(about, [400, 400], view, 70_000.0);
    scene.image.samples = 64;
    scene.lights.push(occluder(min_amount));
    scene.lights.push(directional("sun", vector(20.0, 40.0, 20.0), 1.5));
    let mesh =
        TessellatedSphere { radius: 0.065, bumps: 0.15, ..TessellatedSphere::new(96, 48, true) };
    let steps = vec![Step::RotateX(50.0), Step::Translate(vector(-0.03, 0.1, 0.0))];
    let pale_blue = matte(0.5, 0.5, rgb(0.5, 0.75, 1.0));
    add(&mut scene, "mesh", transformed(mesh, steps), pale_blue);

    let corner = point(-0.13, 0.033, -0.1);
    let [x, y, z] = [0.45 * Vector::X, 0.25 * Vector::Y, 0.45 * Vector::Z];
    let ground = matte(0.5, 0.5, Rgb::WHITE);
    add(&mut scene, "ground", Rectangle { corner, a: z, b: x }, ground);
    let green = matte(0.5, 0.75, rgb(0.5, 1.0, 0.75));
    add(&mut scene, "left wall", Rectangle { corner, a: y, b: z }, green);
    let yellow = matte(0.5, 0.5, rgb(1.0, 1.0, 0.5));
    add(&mut scene, "back wall", Rectangle { corner, a: x, b: y }, yellow);
    scene
}

/// Figure 17.13b.
fn city() -> Scene {
    let about = "figure 17.13b: the city through an orthographic camera, min_amount 0.25";
    let view = [point(100.0, 100.0, 50.0), point(0.0, 10.0, 0.0)];
    let mut scene = pinhole(about, [600, 400], view, 1.0);
    scene.camera.lens = Orthographic { zoom: 1.0 }.into();
    scene.image.pixel_size = 0.31;
    scene.image.samples = 36;
    let grounds = [matte(0.4, 0.5, rgb(0.3, 0.5, 0.3)), matte(0.3, 0.5, grey(0.85))];
    city_on(&mut scene, occluder(0.25), grounds);
    scene
}
