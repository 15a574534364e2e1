//! Boundaries between several media, and cameras in a medium other than air.

use super::{dielectric, in_air, medium};
use groundtruth::cameras::{Fisheye, Viewpoint};
use groundtruth::materials::{Dielectric, Medium};
use groundtruth::math::{Point, Step, Vector, cos_degrees, sin_degrees};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    BoundaryMaterials, FishBowl, GlassOfWater, Kind, OpenCylinder, PartSphere, Sphere,
};

/// Figure 28.7. Camera and height of the water are the book's; the medium of the camera and the
/// objects are ours.
pub fn snell_window() -> Scene {
    let about = "figure 28.7: under water: the sky in a disk, the reflected bottom around it";
    let lens = Fisheye { fov: 265.0, rectangular: true };
    let mut camera = Viewpoint::new(point(0.0, 0.1, 0.0), point(0.0, 10.0, 0.0), lens);
    let water = Medium::clear(1.33);
    camera.medium = water;
    camera.exposure_time = 1.0 / (water.eta * water.eta);
    let mut scene = Scene::new(about, Image { samples: 16, ..Image::new(400, 400) }, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 4 });
    scene.background = rgb(0.6, 0.8, 1.0).into();
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(1.0, 3.0, 1.0), 4.0));
    let bottom = matte(0.6, 0.4, checker3d(10.0, rgb(0.5, 0.4, 0.3), rgb(0.9, 0.85, 0.7)));
    add(&mut scene, "bottom", ground(0.0), bottom);
    add(&mut scene, "surface", ground(10.0), in_air(water));
    scene.materials[1].casts_shadows = false;
    for (i, point) in (1..).zip(ring(18.0, 20)) {
        let at = point + 12.0 * Vector::Y;
        let tint = [rgb(1.0, 0.2, 0.1), rgb(1.0, 0.8, 0.1)][i % 2];
        add(&mut scene, &format!("ball {i}"), sphere(at, 2.0), matte(0.5, 0.6, tint));
    }
    scene
}

/// Points on the ground at this distance from the origin, at intervals of `degrees`.
fn ring(distance: f64, degrees: u32) -> impl Iterator<Item = Point> {
    (0..360 / degrees).map(move |i| {
        let azimuth = f64::from(i * degrees);
        point(distance * sin_degrees(azimuth), 0.0, distance * cos_degrees(azimuth))
    })
}

/// Figures 28.15 with these indices outside the inner boundaries. Spheres, light and the height of
/// the checker are the book's; its colours and the camera are ours.
pub fn nested_spheres(about: &str, around_diamond: f64, around_water: f64) -> Scene {
    let center = point(0.5, 0.0, 0.5);
    let view = [point(5.0, 8.0, 20.0), point(0.5, -0.5, 0.5)];
    let mut scene = pinhole(about, [400, 400], view, 950.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 7 });
    scene.background = rgb(0.6, 0.75, 0.9).into();
    scene.lights.push(ambient(0.3));
    scene.lights.push(directional("sun", Vector::Y, 7.5));
    let glass = medium(1.5, rgb(0.95, 0.95, 1.0));
    let diamond = medium(2.42, rgb(1.0, 1.0, 0.8));
    let water = medium(1.33, rgb(1.0, 0.5, 1.0));
    let outside_diamond = Medium { eta: around_diamond, ..glass };
    let outside_water = Medium { eta: around_water, ..diamond };
    for (name, radius, recipe) in [
        ("glass", 3.5, in_air(glass)),
        ("diamond", 2.0, dielectric(diamond, outside_diamond)),
        ("water", 0.6, dielectric(water, outside_water)),
    ] {
        add(&mut scene, name, sphere(center, radius), recipe);
    }
    let squares = checker3d(2.0, grey(0.3), Rgb::WHITE);
    add(&mut scene, "ground", ground(-6.5), matte(0.5, 0.25, squares));
    scene
}

/// Figure 28.34. Diamond, ring and exposure are the book's, the position of the eye is ours.
pub fn in_a_diamond() -> Scene {
    let about =
        "figure 28.34: inside a diamond: a ring of spheres outside, and its fainter reflections";
    let view = [point(0.0, 0.4, -2.0), point(0.0, 0.4, -30.0)];
    let mut scene = pinhole(about, [600, 400], view, 300.0);
    let diamond = Medium::clear(2.42);
    scene.camera.medium = diamond;
    scene.camera.exposure_time = 0.17;
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 8 });
    scene.background = rgb(0.6, 0.75, 0.95).into();
    scene.lights.push(ambient(0.6));
    scene.lights.push(directional("sun", vector(1.0, 2.0, 2.0), 1.5));
    let clear = Dielectric { inside: diamond, ..Dielectric::default() };
    add(&mut scene, "diamond", sphere(Point::ORIGIN, 4.0), clear);
    for (half, theta, color) in
        [("top", [0.0, 90.0], rgb(1.0, 0.5, 0.0)), ("bottom", [90.0, 180.0], rgb(0.1, 0.7, 0.2))]
    {
        scene.materials.push(Material::new(half, matte(0.5, 0.6, color)));
        for (i, center) in (1..).zip(ring(20.0, 20)) {
            let shape = PartSphere { center, radius: 3.5, phi: [0.0, 360.0], theta, inward: false };
            scene.objects.push(Object::new(&format!("{half} {i}"), half, shape));
        }
    }
    scene
}

/// The names of the materials of a vessel.
const GLASS_AIR: &str = "glass and air";
const WATER_AIR: &str = "water and air";
const WATER_GLASS: &str = "water and glass";

/// Adds a vessel and its three materials, which cast no shadows.
fn add_vessel(scene: &mut Scene, shape: impl Into<Kind>, glass: Medium, water: Medium) {
    for (name, inside, outside) in [
        (GLASS_AIR, glass, Medium::default()),
        (WATER_AIR, water, Medium::default()),
        (WATER_GLASS, water, glass),
    ] {
        let mut material = Material::new(name, dielectric(inside, outside));
        material.casts_shadows = false;
        scene.materials.push(material);
    }
    scene.objects.push(Object::new("vessel", GLASS_AIR, shape));
}

fn boundary_materials() -> BoundaryMaterials {
    let [glass_air, water_air, water_glass] =
        [GLASS_AIR, WATER_AIR, WATER_GLASS].map(|name| Some(name.to_owned()));
    BoundaryMaterials { glass_air, water_air, water_glass }
}

/// Figure 28.38. Glass, straw and camera are the book's; ground and lights are ours.
pub fn glass_of_water() -> Scene {
    let about = "figure 28.38: a glass of water; the straw looks broken at the water surface";
    let view = [point(5.0, 6.0, 10.0), point(0.0, 1.0, 0.0)];
    let mut scene = pinhole(about, [600, 600], view, 2000.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    scene.background = rgb(0.85, 0.9, 0.95).into();
    scene.lights.push(ambient(0.7));
    scene.lights.push(directional("sun", vector(1.0, 3.0, 2.0), 3.0));
    let glass = medium(1.5, rgb(0.65, 1.0, 0.75));
    let water = medium(1.33, rgb(1.0, 0.25, 1.0));
    let vessel = GlassOfWater { materials: boundary_materials(), ..GlassOfWater::default() };
    add_vessel(&mut scene, vessel, glass, water);
    let straw = OpenCylinder { y0: -1.2, y1: 1.7, radius: 0.05, inward: false };
    let leaning = vec![Step::RotateZ(40.0), Step::Translate(vector(0.0, 1.25, 0.0))];
    let straw = transformed(straw, leaning);
    add(&mut scene, "straw", straw, matte(0.6, 0.6, rgb(1.0, 0.3, 0.1)));
    scene.materials[3].two_sided = true;
    let squares = checker3d(0.75, grey(0.6), Rgb::WHITE);
    add(&mut scene, "table", ground(-0.01), matte(0.5, 0.4, squares));
    scene
}

/// The centres of the bubbles in the bowl.
const BUBBLES: [[f64; 3]; 6] = [
    [-0.35, -0.5, 0.2],
    [-0.3, -0.25, 0.15],
    [-0.38, 0.02, 0.2],
    [0.3, -0.6, 0.0],
    [0.4, -0.15, 0.1],
    [0.35, 0.1, 0.05],
];

/// Figure 28.39 without the fish. Bowl and media are the book's; camera, ground, lights and the
/// positions of the bubbles are ours.
pub fn fish_bowl() -> Scene {
    let about = "as figure 28.39: a fish bowl of water with bubbles: lenses with dark rims";
    let view = [point(0.0, 2.2, 8.0), point(0.0, -0.1, 0.0)];
    let mut scene = pinhole(about, [400, 400], view, 1200.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 8 });
    scene.background = rgb(0.85, 0.9, 0.95).into();
    scene.lights.push(ambient(0.7));
    scene.lights.push(directional("sun", vector(1.0, 3.0, 2.0), 3.0));
    let glass = medium(1.5, 2.0 * rgb(0.27, 0.49, 0.42));
    let water = medium(1.33, rgb(0.75, 1.0, 0.75));
    let vessel = FishBowl { materials: boundary_materials(), ..FishBowl::default() };
    add_vessel(&mut scene, vessel, glass, water);
    let mut bubble = Material::new("bubble", dielectric(Medium::default(), water));
    bubble.casts_shadows = false;
    scene.materials.push(bubble);
    for (i, center) in (1..).zip(BUBBLES.map(Point::from)) {
        let shape = Sphere { center, radius: 0.045, inward: false };
        scene.objects.push(Object::new(&format!("bubble {i}"), "bubble", shape));
    }
    let squares = checker3d(0.75, grey(0.6), Rgb::WHITE);
    add(&mut scene, "table", ground(-1.11), matte(0.5, 0.4, squares));
    scene
}
