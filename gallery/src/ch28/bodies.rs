//! Bodies of one medium in air.

use super::super::ch27;
use super::{in_air, medium};
use groundtruth::cameras::{Orthographic, Pinhole};
use groundtruth::materials::{Dielectric, Emissive, Medium};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{ConcaveLens, Materials, SolidCylinder};

pub fn glass_sphere() -> Scene {
    let about = "a glass sphere with Fresnel reflection over a checker, and a red mirror sphere";
    ch27::with_sphere(about, in_air(Medium::clear(1.5)).into())
}

pub fn air_in_glass() -> Scene {
    let about = "figure 28.5: η = 0.75: the mirror ring begins softly, because Fresnel reflection rises to 1";
    ch27::with_sphere(about, in_air(Medium::clear(0.75)).into())
}

/// Figure 28.6.
pub fn on_white(about: &str, max_depth: u32) -> Scene {
    let view = [point(0.0, 0.0, 50.0), Point::ORIGIN];
    let mut scene = pinhole(about, [600, 600], view, 4200.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth });
    scene.background = Rgb::WHITE.into();
    scene.lights.extend(ch27::lights());
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 3.0), in_air(Medium::clear(1.5)));
    scene
}

/// Figure 28.6 in close-up: the picture is 0.01 units wide.
pub fn limb() -> Scene {
    let about = "figure 28.6: the limb at depth 3, magnified: dark inside, white at the edge";
    let mut scene = on_white(about, 3);
    scene.camera.eye = point(0.0, 0.0, 500.0);
    scene.camera.look_at = point(-3.0, 0.0, 0.0);
    scene.camera.lens = Pinhole { distance: 3e7, zoom: 1.0 }.into();
    scene
}

/// Figure 28.8. Size and camera are the book's; the positions and the thickness of the filters are
/// ours, and that they do not reflect.
pub fn three_filters() -> Scene {
    let about =
        "figure 28.8: cyan, yellow and magenta filters over white; all three together are black";
    let view = [point(0.0, 10.0, 0.0), Point::ORIGIN];
    let mut scene = pinhole(about, [400, 400], view, 1.0);
    scene.camera.lens = Orthographic { zoom: 1.0 }.into();
    scene.image.pixel_size = 0.012;
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 6 });
    let filters = [
        ("cyan", rgb(0.0, 1.0, 1.0), -0.7, 0.4),
        ("yellow", rgb(1.0, 1.0, 0.0), 0.7, 0.4),
        ("magenta", rgb(1.0, 0.0, 1.0), 0.0, -0.8),
    ];
    for (i, (name, cf, x, z)) in (0..).zip(filters) {
        let y0 = 0.75 * f64::from(i);
        let (y1, radius, materials) = (y0 + 0.5, 1.25, Materials::new());
        let disk = SolidCylinder { y0, y1, radius, materials };
        let recipe = Dielectric { inside: medium(1.0, cf), ..Dielectric::default() };
        add(&mut scene, name, moved(disk, vector(x, 0.0, z)), recipe);
    }
    add(&mut scene, "plane", ground(-1.0), Emissive::new(1.0, Rgb::WHITE));
    scene
}

/// Figure 28.9; the positions of the spheres and the camera are ours.
pub fn falling_sizes() -> Scene {
    let about = "figure 28.9: five spheres of one medium, each half as large as the last and paler";
    let view = [point(0.0, 0.0, 50.0), Point::ORIGIN];
    let mut scene = pinhole(about, [600, 300], view, 2200.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 5 });
    scene.background = Rgb::WHITE.into();
    let amber = in_air(medium(1.5, rgb(0.65, 0.45, 0.0)));
    let mut left = -6.4;
    for (i, radius) in (1..).zip([3.0, 1.5, 0.75, 0.375, 0.1875]) {
        let ball = sphere(point(left + radius, 0.0, 0.0), radius);
        if i == 1 {
            add(&mut scene, "sphere 1", ball, amber.clone());
        } else {
            scene.objects.push(Object::new(&format!("sphere {i}"), "sphere 1", ball));
        }
        left += 2.0 * radius + 0.3;
    }
    scene
}

/// An empty scene with a checker of low `kd`, so that the lamp of figure 28.20 does not overexpose
/// it.
fn over_checker(about: &str, view: [Point; 2], distance: f64, floor: f64) -> Scene {
    let mut scene = pinhole(about, [600, 400], view, distance);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 8 });
    scene.background = rgb(0.7, 0.8, 0.95).into();
    scene.lights.push(ambient(0.5));
    let squares = checker3d(1.0, grey(0.4), Rgb::WHITE);
    add(&mut scene, "ground", ground(floor), matte(0.5, 0.1, squares));
    scene
}

/// Figure 28.11. The lens is the book's, the rest is ours.
pub fn concave_lens() -> Scene {
    let about =
        "figure 28.11: a concave lens shows the checker smaller, darker where it is thicker";
    let view = [point(0.0, 12.0, 14.0), Point::ORIGIN];
    let mut scene = over_checker(about, view, 900.0, -3.0);
    scene.lights.push(directional("sun", vector(1.0, 3.0, 1.0), 12.5));
    let (radius, thickness, min_distance) = (4.0, 2.0, 0.35);
    let lens = ConcaveLens { radius, thickness, min_distance, materials: Materials::new() };
    add(&mut scene, "lens", lens, in_air(medium(1.5, rgb(0.0, 0.5, 0.5))));
    scene.materials[1].casts_shadows = false;
    scene
}

/// Figure 28.20. Glass and lamp are the book's, ground and camera are ours.
pub fn glass_box() -> Scene {
    let about =
        "figure 28.20: a glass box, whose neighbouring faces are perfect mirrors from inside";
    let view = [point(4.0, 4.0, 7.0), point(0.0, -0.2, 0.0)];
    let mut scene = over_checker(about, view, 1100.0, -1.01);
    scene.lights.push(point_light("lamp", point(10.0, 20.0, 20.0), 15.0));
    let green = in_air(medium(1.5, rgb(0.64, 0.98, 0.88)));
    let corners = boxed(point(-1.0, -1.0, -1.0), point(1.0, 1.0, 1.0));
    add(&mut scene, "box", corners, green);
    scene
}

/// Figure 28.22. The blocks are the book's, ground, light and camera are ours.
pub fn ten_blocks() -> Scene {
    const THICKNESS: f64 = 0.25;
    const GAP: f64 = 0.5;
    let about = "figure 28.22: ten blocks of glass, each longer by 1 and deeper in colour";
    let view = [point(-3.0, 5.5, 16.0), point(-6.4, 1.4, -2.0)];
    let mut scene = pinhole(about, [600, 400], view, 1100.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 15 });
    scene.background = Rgb::WHITE.into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("sun", vector(1.0, 3.0, 2.0), 2.5));
    add(&mut scene, "ground", ground(-0.01), matte(0.5, 0.5, grey(0.8)));
    let cf = 1.75 * rgb(0.27, 0.49, 0.42);
    for j in 0..10 {
        let x = -10.0 + f64::from(j) * (THICKNESS + GAP);
        let length = THICKNESS + f64::from(j);
        let block = boxed(point(x, 0.0, -length), point(x + THICKNESS, 4.0, 0.0));
        let name = format!("block {}", j + 1);
        if j == 0 {
            add(&mut scene, &name, block, in_air(medium(1.5, cf)));
        } else {
            scene.objects.push(Object::new(&name, "block 1", block));
        }
    }
    scene
}
