//! Chapter 16: shadows.

use super::List;
use super::shaded_sets::{thirty_five_spheres, two_spheres_before_a_wall};
use groundtruth::lights::PointLight;
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Intersect, Light, Material, Object, Scene};
use groundtruth::shapes::{Compound, Materials, Part, SolidCylinder, Triangle};

pub const SCENES: List = &[
    ("ch16/page-one", || {
        let about = "the picture of page one: 35 spheres with shadows on one another";
        let lamp = point_light("lamp", point(100.0, 100.0, 200.0), 3.0);
        thirty_five_spheres(about, lamp, |color| phong(0.25, 0.75, color, 0.12, 20.0).into())
    }),
    ("ch16/no-shadows", || {
        floating("figure 16.1a: without shadows the positions of objects are unclear", false)
    }),
    ("ch16/shadows", || {
        floating("figure 16.1b: the shadows of two lights make the positions clear", true)
    }),
    ("ch16/canyon", || {
        let about = "figure 16.5a: rows of boxes with shadows on one another";
        canyon(about, [point(350.0, 1000.0, 500.0), point(-175.0, 550.0, -40.0)], 350.0)
    }),
    ("ch16/canyon-from-the-light", || {
        let about = "figure 16.5b: from the position of the light, no shadow is visible";
        canyon(about, [CANYON_LAMP, point(-50.0, 300.0, -600.0)], 650.0)
    }),
    ("ch16/two-spheres", || {
        two_spheres_before_a_wall("figure 16.10a: the two spheres of figure 14.21 with shadows")
    }),
    ("ch16/coloured-shadows", coloured_shadows),
    ("ch16/mixed-shadows", mixed_shadows),
    ("ch16/surface-acne", || {
        let about = "surface acne: far from the origin, coordinates are rounded to 3 cm, but the book's \
                     epsilon is 1 mm: planet and moon have spots of their own shadow";
        Scene { intersect: Intersect::Textbook, ..eclipse(about) }
    }),
    ("ch16/surface-acne-cured", || {
        eclipse("the same with robust routines: the moon's shadow without spots")
    }),
];

/// Figure 16.1.
fn floating(about: &str, shadows: bool) -> Scene {
    let view = [point(2.0, 2.5, 15.0), point(3.0, 2.5, 0.0)];
    let mut scene = pinhole(about, [300, 200], view, 400.0);
    scene.lights.push(ambient(1.0));
    let sun = directional("sun", vector(200.0, 150.0, 125.0), 4.0);
    scene.lights.push(Light { shadows, ..sun });
    let lamp = point_light("lamp", point(-12.0, 15.0, 30.0), 4.0);
    scene.lights.push(Light { shadows, ..lamp });

    let olive = matte(0.3, 0.3, rgb(0.5, 0.6, 0.0));
    add(&mut scene, "sphere", sphere(point(0.0, 2.4, 0.0), 1.5), olive);
    let brown = matte(0.2, 0.3, rgb(0.8, 0.5, 0.0));
    add(&mut scene, "box", boxed(point(5.4, -0.5, -3.0), point(7.5, 4.75, 0.6)), brown.clone());
    let cyan = matte(0.35, 0.5, rgb(0.0, 0.5, 0.5));
    let vertices = [point(1.5, -0.5, 1.8), point(7.5, -0.5, -9.0), point(2.35, 5.8, 1.4)];
    add(&mut scene, "triangle", Triangle { vertices, normals: None }, cyan);
    let cylinder = SolidCylinder { y0: -0.5, y1: 1.0, radius: 1.0, materials: Materials::new() };
    add(&mut scene, "cylinder", cylinder, brown);
    add(&mut scene, "ground", ground(-0.5), matte(0.1, 0.2, Rgb::WHITE));
    scene
}

/// The lamp of figures 16.5.
const CANYON_LAMP: Point = Point::new(1500.0, 750.0, 250.0);

/// Figures 16.5: three rows of boxes, 50 wide and 100 apart, with heights that increase to the
/// left.
fn canyon(about: &str, view: [Point; 2], distance: f64) -> Scene {
    let mut scene = pinhole(about, [600, 400], view, distance);
    scene.lights.push(ambient(1.0));
    scene.lights.push(point_light("lamp", CANYON_LAMP, 4.5));
    for (name, right, count, height, color) in [
        ("right row", 0.0, 11, 300.0, rgb(0.0, 0.5, 0.5)),
        ("middle row", -150.0, 12, 450.0, rgb(1.0, 0.0, 0.0)),
        ("left row", -300.0, 12, 600.0, rgb(0.5, 0.6, 0.0)),
    ] {
        let at = |i: i32| {
            let front = -150.0 * f64::from(i);
            boxed(point(right - 50.0, 0.0, front - 50.0), point(right, height, front))
        };
        add(&mut scene, name, Compound::of((0..count).map(at)), matte(0.4, 0.5, color));
    }
    let squares = checker3d(50.0, grey(0.7), Rgb::WHITE);
    add(&mut scene, "ground", ground(1.0), matte(0.15, 1.0, squares));
    scene
}

/// Figure 16.11b.
fn coloured_shadows() -> Scene {
    let about =
        "figure 16.11b: three coloured point lights; where one is blocked, the other two add up";
    let view = [point(0.0, 7.0, 10.0), point(0.0, -1.5, 0.0)];
    let mut scene = pinhole(about, [600, 540], view, 1200.0);
    for (name, color, location) in [
        ("red light", rgb(1.0, 0.0, 0.0), point(3.0, 10.0, 2.0)),
        ("green light", rgb(0.0, 1.0, 0.0), point(-3.0, 10.0, 2.0)),
        ("blue light", rgb(0.0, 0.0, 1.0), point(0.0, 10.0, -3.0)),
    ] {
        let source = PointLight { ls: 12.0, color, location, attenuation: 0.0 };
        scene.lights.push(Light::new(name, source));
    }
    let grey_matte = || matte(0.0, 0.35, grey(0.7));
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 1.0), grey_matte());
    add(&mut scene, "ground", ground(-3.0), grey_matte());
    scene
}

/// A table whose top casts no shadow, because its material does not, before a wall that casts none; one of two lamps has
/// shadows.
fn mixed_shadows() -> Scene {
    let about = "who casts shadows: the legs of the table but not its top, the sphere on it but not the wall; and the \
                 second lamp casts none";
    let view = [point(2.0, 6.0, 14.0), point(0.0, 1.2, 0.0)];
    let mut scene = pinhole(about, [300, 200], view, 480.0);
    scene.lights.push(ambient(0.5));
    scene.lights.push(point_light("lamp", point(-4.0, 8.0, 5.0), 2.5));
    let lamp = point_light("lamp without shadows", point(6.0, 5.0, 6.0), 1.0);
    scene.lights.push(Light { shadows: false, ..lamp });

    let leg =
        |x: f64, z: f64| boxed(point(x - 0.15, 0.0, z - 0.15), point(x + 0.15, 2.0, z + 0.15));
    let legs = [(-1.5, -1.0), (1.5, -1.0), (-1.5, 1.0), (1.5, 1.0)].map(|(x, z)| leg(x, z));
    let top = boxed(point(-1.8, 2.0, -1.3), point(1.8, 2.2, 1.3));
    let mut parts = legs.map(Part::new).to_vec();
    parts.push(Part::new(top).of_material("top"));
    add(&mut scene, "table", Compound { accel: None, parts }, matte(0.3, 0.7, rgb(0.7, 0.4, 0.2)));
    let top = Material::new("top", matte(0.3, 0.7, rgb(0.9, 0.7, 0.4)));
    scene.materials.push(Material { casts_shadows: false, ..top });
    let red = matte(0.3, 0.7, rgb(0.9, 0.2, 0.2));
    add(&mut scene, "sphere", sphere(point(0.3, 2.9, 0.2), 0.7), red);
    let (wall, teal) = object(
        "wall",
        boxed(point(-3.2, 0.0, -2.0), point(-3.0, 3.0, 2.5)),
        matte(0.3, 0.7, rgb(0.3, 0.6, 0.6)),
    );
    scene.objects.push(Object { casts_shadows: false, ..wall });
    scene.materials.push(teal);
    add(&mut scene, "ground", ground(0.0), matte(0.25, 0.75, Rgb::WHITE));
    scene
}

/// A planet in the shadow of its moon, in metres, a thousand times as far from the origin as the
/// Earth is from the sun.
fn eclipse(about: &str) -> Scene {
    let x = 1.5e14;
    let view = [point(x, 3e7, 1.5e8), point(x, 0.0, 0.0)];
    let mut scene = pinhole(about, [300, 200], view, 480.0);
    scene.image = Image { samples: 1, ..scene.image };
    scene.background = rgb(0.02, 0.02, 0.04).into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("sun", vector(-4.0, 2.0, 2.5), 3.0));
    let planet = sphere(point(x, 0.0, 0.0), 2.5e7);
    add(&mut scene, "planet", planet, matte(0.25, 0.75, rgb(0.3, 0.5, 1.0)));
    let moon = sphere(point(x - 2.6e7, 1.7e7, 2.2e7), 5e6);
    add(&mut scene, "moon", moon, matte(0.25, 0.75, rgb(0.8, 0.75, 0.7)));
    scene
}
