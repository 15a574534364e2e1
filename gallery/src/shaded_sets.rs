//! Objects of the chapters on light and shading: the 35 spheres, the set of chapter 14, the four
//! cylinders, the two spheres before a wall.

use groundtruth::materials::{Kind as MaterialKind, Matte};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Object, Scene};
use groundtruth::shapes::{BeveledCylinder, Disk, Materials, OpenCylinder, Plane};

pub const YELLOW: Rgb = Rgb::new(1.0, 1.0, 0.0);
const BROWN: Rgb = Rgb::new(0.71, 0.40, 0.16);
const DARK_GREEN: Rgb = Rgb::new(0.0, 0.41, 0.41);
pub const ORANGE: Rgb = Rgb::new(1.0, 0.75, 0.0);
const GREEN: Rgb = Rgb::new(0.0, 0.6, 0.3);
pub const LIGHT_GREEN: Rgb = Rgb::new(0.65, 1.0, 0.30);
const DARK_YELLOW: Rgb = Rgb::new(0.61, 0.61, 0.0);
const LIGHT_PURPLE: Rgb = Rgb::new(0.65, 0.3, 1.0);
const DARK_PURPLE: Rgb = Rgb::new(0.5, 0.0, 1.0);

/// The 35 spheres: centre, radius and colour.
const SPHERES: [([f64; 3], f64, Rgb); 35] = [
    ([5.0, 3.0, 0.0], 30.0, YELLOW),
    ([45.0, -7.0, -60.0], 20.0, BROWN),
    ([40.0, 43.0, -100.0], 17.0, DARK_GREEN),
    ([-20.0, 28.0, -15.0], 20.0, ORANGE),
    ([-25.0, -7.0, -35.0], 27.0, GREEN),
    ([20.0, -27.0, -35.0], 25.0, LIGHT_GREEN),
    ([35.0, 18.0, -35.0], 22.0, GREEN),
    ([-57.0, -17.0, -50.0], 15.0, BROWN),
    ([-47.0, 16.0, -80.0], 23.0, LIGHT_GREEN),
    ([-15.0, -32.0, -60.0], 22.0, DARK_GREEN),
    ([-35.0, -37.0, -80.0], 22.0, DARK_YELLOW),
    ([10.0, 43.0, -80.0], 22.0, DARK_YELLOW),
    ([30.0, -7.0, -80.0], 10.0, DARK_YELLOW),
    ([-40.0, 48.0, -110.0], 18.0, DARK_GREEN),
    ([-10.0, 53.0, -120.0], 18.0, BROWN),
    ([-55.0, -52.0, -100.0], 10.0, LIGHT_PURPLE),
    ([5.0, -52.0, -100.0], 15.0, BROWN),
    ([-20.0, -57.0, -120.0], 15.0, DARK_PURPLE),
    ([55.0, -27.0, -100.0], 17.0, DARK_GREEN),
    ([50.0, -47.0, -120.0], 15.0, BROWN),
    ([70.0, -42.0, -150.0], 10.0, LIGHT_PURPLE),
    ([5.0, 73.0, -130.0], 12.0, LIGHT_PURPLE),
    ([66.0, 21.0, -130.0], 13.0, DARK_PURPLE),
    ([72.0, -12.0, -140.0], 12.0, LIGHT_PURPLE),
    ([64.0, 5.0, -160.0], 11.0, GREEN),
    ([55.0, 38.0, -160.0], 12.0, LIGHT_PURPLE),
    ([-73.0, -2.0, -160.0], 12.0, LIGHT_PURPLE),
    ([30.0, -62.0, -140.0], 15.0, DARK_PURPLE),
    ([25.0, 63.0, -140.0], 15.0, DARK_PURPLE),
    ([-60.0, 46.0, -140.0], 15.0, DARK_PURPLE),
    ([-30.0, 68.0, -130.0], 12.0, LIGHT_PURPLE),
    ([58.0, 56.0, -180.0], 11.0, GREEN),
    ([-63.0, -39.0, -180.0], 11.0, GREEN),
    ([46.0, 68.0, -200.0], 10.0, LIGHT_PURPLE),
    ([-3.0, -72.0, -130.0], 12.0, LIGHT_PURPLE),
];

/// The 35 spheres of several pictures of page one; `finish` makes the material of a colour.
pub fn thirty_five_spheres(
    about: &str,
    light: Light,
    finish: impl Fn(Rgb) -> MaterialKind,
) -> Scene {
    let view = [point(0.0, 0.0, 10_000.0), Point::ORIGIN];
    let mut scene = pinhole(about, [600, 600], view, 15_000.0);
    scene.image.pixel_size = 0.5;
    scene.lights.push(ambient(1.0));
    scene.lights.push(light);
    for (i, &(center, radius, color)) in SPHERES.iter().enumerate() {
        let name = format!("sphere {}", i + 1);
        add(&mut scene, &name, sphere(center.into(), radius), finish(color));
    }
    scene
}

/// An empty scene with the book's view of the set.
pub fn before_the_set(about: &str) -> Scene {
    let view = [point(7.5, 4.0, 10.0), point(-1.0, 3.7, 0.0)];
    pinhole(about, [600, 400], view, 340.0)
}

/// Adds the two spheres, cylinder, box and plane of figures 14.5 to 14.11 to an empty scene.
pub fn matte_set(scene: Scene, light: Option<Light>) -> Scene {
    set_of(scene, light, |_, matte| matte.into())
}

/// The set with other materials: `finish` makes one from the object's name and its material in
/// chapter 14.
pub fn set_of(
    mut scene: Scene,
    light: Option<Light>,
    finish: impl Fn(&str, Matte) -> MaterialKind,
) -> Scene {
    scene.background = rgb(0.0, 0.225, 0.1875).into();
    scene.lights.push(ambient(0.5));
    scene.lights.extend(light);

    let mut put = |name: &str, shape: groundtruth::shapes::Kind, matte: Matte| {
        add(&mut scene, name, shape, finish(name, matte));
    };
    let yellow = matte(0.25, 0.75, rgb(0.75, 0.75, 0.0));
    put("yellow sphere", sphere(point(3.85, 2.3, -2.55), 2.3).into(), yellow);
    let orange = matte(0.45, 0.75, rgb(0.75, 0.25, 0.0));
    put("orange sphere", sphere(point(-0.7, 1.0, 4.2), 2.0).into(), orange);
    let wall = OpenCylinder { y0: 0.0, y1: 8.5, radius: 2.2, inward: false };
    put("cylinder", wall.into(), matte(0.4, 0.75, rgb(1.0, 0.5, 1.0)));
    let slab = boxed(point(-3.5, 0.0, -11.0), point(-2.5, 6.0, 6.5));
    put("box", slab.into(), matte(0.15, 0.5, rgb(0.75, 1.0, 0.75)));
    put("ground", ground(0.0).into(), matte(0.2, 0.97, Rgb::WHITE));
    for (name, y, normal) in
        [("cylinder top", 8.5, Vector::Y), ("cylinder bottom", 0.0, -Vector::Y)]
    {
        let disk = Disk { center: point(0.0, y, 0.0), normal, radius: 2.2 };
        scene.objects.push(Object::new(name, "cylinder", disk));
    }
    scene
}

/// The four beveled cylinders of figures 14.15 and 15.7, with these materials from left to right
/// and light from the right.
pub fn four_cylinders(about: &str, finishes: [MaterialKind; 4]) -> Scene {
    let view = [point(0.0, 0.0, 100.0), Point::ORIGIN];
    let mut scene = pinhole(about, [650, 300], view, 6000.0);
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(20.0, 0.0, 20.0), 3.0).without_shadows());
    for (i, finish) in (0_u32..).zip(finishes) {
        let cylinder = BeveledCylinder {
            y0: -2.0,
            y1: 2.0,
            radius: 1.0,
            bevel: 0.2,
            materials: Materials::new(),
        };
        let x = 2.5 * f64::from(i) - 3.75;
        let name = format!("cylinder {}", i + 1);
        add(&mut scene, &name, moved(cylinder, x * Vector::X), finish);
    }
    scene
}

/// The two spheres and the wall of figures 14.21 and 16.10a, and their lamp.
pub fn two_spheres_before_a_wall(about: &str) -> Scene {
    let view = [point(0.0, 0.0, 500.0), point(-5.0, 0.0, 0.0)];
    let mut scene = pinhole(about, [400, 400], view, 850.0);
    scene.image.pixel_size = 0.5;
    scene.lights.push(ambient(1.0));
    scene.lights.push(point_light("lamp", point(100.0, 50.0, 150.0), 3.0));
    let yellow = matte(0.25, 0.65, YELLOW);
    add(&mut scene, "yellow sphere", sphere(point(10.0, -5.0, 0.0), 27.0), yellow);
    let brown = matte(0.15, 0.85, BROWN);
    add(&mut scene, "brown sphere", sphere(point(-25.0, 10.0, -35.0), 27.0), brown);
    let wall = Plane { point: point(0.0, 0.0, -50.0), normal: Vector::Z };
    add(&mut scene, "wall", wall, matte(0.15, 0.5, rgb(0.0, 0.4, 0.2)));
    scene
}
