//! Chapter 21: instances.

use super::List;
use groundtruth::accel::Method;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Pcg32, Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};
use groundtruth::shapes::{
    Archway, BeveledBox, BeveledCylinder, BeveledRing, BeveledWedge, Compound, Kind, Materials,
    Rosette, RoundRimmedBowl, SolidCylinder, TessellatedSphere, ThickRing, Torus,
};
use groundtruth::textures::{Paint, RandomColors};

pub const SCENES: List = &[
    ("ch21/many-meshes", many_meshes),
    ("ch21/ellipsoid", ellipsoid),
    ("ch21/beveled", beveled),
    ("ch21/wedges", wedges),
    ("ch21/rosette", rosette),
    ("ch21/archway", archway),
    ("ch21/nested-instance", nested_instance),
    ("ch21/squashed-spheres", squashed_spheres),
    ("ch21/bowl", bowl),
];

/// The view and the ambient light of the figures of this chapter.
pub(super) fn stage(about: &str, eye: Point, look_at: Point, distance: f64) -> Scene {
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 });
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(0.25));
    scene
}

fn random_colors(seed: u64) -> Paint {
    Paint::from(RandomColors { seed })
}

fn many_meshes() -> Scene {
    let about = "as figure 21.4: 8 × 8 instances of one bumpy mesh, rotated at random, in a grid";
    let mut scene = stage(about, point(20.0, 30.0, 40.0), Point::ORIGIN, 800.0);
    scene.lights.push(directional("light", vector(1.0, 2.0, 0.5), 3.0));
    let mesh = TessellatedSphere { bumps: 0.15, ..TessellatedSphere::new(96, 48, true) };
    let mut random = Pcg32::new(1000, 0);
    let instance = |i: u32| {
        let coordinate = |k: u32| 2.5 * f64::from(k) - 8.75;
        let steps = vec![
            Step::RotateX(360.0 * random.uniform()),
            Step::RotateY(360.0 * random.uniform()),
            Step::Translate(vector(coordinate(i % 8), 0.0, coordinate(i / 8))),
        ];
        transformed(mesh.clone(), steps)
    };
    let meshes = Compound { accel: Some(Method::Grid), ..Compound::of((0..64).map(instance)) };
    let (object, material) = object("meshes", meshes, matte(0.25, 0.75, random_colors(21)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

fn ellipsoid() -> Scene {
    let about = "figure 21.5b, plain: a unit sphere scaled by (2, 3, 1), rotated by −45° about x, raised by 1";
    let mut scene = stage(about, point(100.0, 0.0, 100.0), Point::new(0.0, 1.0, 0.0), 8000.0);
    scene.lights.push(point_light("lamp", point(100.0, 100.0, 60.0), 3.0));
    let steps =
        vec![Step::Scale(vector(2.0, 3.0, 1.0)), Step::RotateX(-45.0), Step::Translate(Vector::Y)];
    let (object, material) = object(
        "ellipsoid",
        transformed(sphere(Point::ORIGIN, 1.0), steps),
        phong(0.25, 0.75, rgb(1.0, 0.75, 0.0), 0.2, 20.0),
    );
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

/// Adds a shape of this colour to the scene.
fn add(scene: &mut Scene, name: &str, shape: impl Into<Kind>, color: Rgb) {
    let (object, material) = object(name, shape, phong(0.25, 0.75, color, 0.2, 50.0));
    scene.objects.push(object);
    scene.materials.push(material);
}

fn beveled() -> Scene {
    let about = "figures 21.6 and 21.7: cylinder, ring and box, plain above and beveled below";
    let mut scene = stage(about, point(2.0, 5.0, 14.0), point(0.0, -0.1, 0.0), 680.0);
    let light = directional("light", vector(8.0, 14.0, 10.0), 3.0);
    scene.lights.push(light.without_shadows()); // the upper row would shade the lower one
    let m = Materials::new;
    let (y0, y1, radius, bevel) = (-0.5, 0.5, 1.0, 0.05);
    let (inner_radius, outer_radius) = (0.6, 1.0);
    let (min, max) = (point(-0.8, y0, -0.8), point(0.8, y1, 0.8));
    let plain: [Kind; 3] = [
        SolidCylinder { y0, y1, radius, materials: m() }.into(),
        ThickRing { y0, y1, inner_radius, outer_radius, materials: m() }.into(),
        boxed(min, max).into(),
    ];
    let round: [Kind; 3] = [
        BeveledCylinder { y0, y1, radius, bevel, materials: m() }.into(),
        BeveledRing { y0, y1, inner_radius, outer_radius, bevel, materials: m() }.into(),
        BeveledBox { min, max, bevel, materials: m() }.into(),
    ];
    let colors = [rgb(1.0, 0.6, 0.2), rgb(0.4, 0.8, 0.4), rgb(0.4, 0.6, 1.0)];
    for (names, shapes, y) in [
        (["cylinder", "ring", "box"], plain, 1.2),
        (["beveled cylinder", "beveled ring", "beveled box"], round, -1.2),
    ] {
        for (i, (name, shape)) in names.into_iter().zip(shapes).enumerate() {
            let by = vector(2.4 * (i as f64 - 1.0), y, 0.0);
            add(&mut scene, name, moved(shape, by), colors[i]);
        }
    }
    scene
}

fn wedges() -> Scene {
    let about = "figure 21.9: three beveled wedges";
    let mut scene = stage(about, point(10.0, 40.0, 50.0), Point::ORIGIN, 3600.0);
    scene.lights.push(directional("light", vector(10.0, 20.0, -5.0), 3.0));
    for (name, phi, radii, color) in [
        ("wide", [140.0, 350.0], [1.5, 2.75], rgb(0.4, 0.7, 1.0)),
        ("narrow", [110.0, 130.0], [1.0, 2.75], rgb(1.0, 0.8, 0.3)),
        ("quarter", [0.0, 90.0], [0.5, 2.75], rgb(0.6, 0.9, 0.4)),
    ] {
        let [inner_radius, outer_radius] = radii;
        let wedge = BeveledWedge {
            y0: -0.4,
            y1: 0.4,
            inner_radius,
            outer_radius,
            phi,
            bevel: 0.15,
            materials: Materials::new(),
        };
        add(&mut scene, name, wedge, color);
    }
    scene
}

fn rosette() -> Scene {
    let about = "figure 21.11a, plain: a rosette of three rings of beveled wedges";
    let mut scene = stage(about, point(15.0, 60.0, 40.0), Point::ORIGIN, 2700.0);
    scene.lights.push(directional("light", vector(15.0, 18.0, -5.0), 3.0));
    let rosette = Rosette {
        rings: 3,
        hole_radius: 0.75,
        ring_width: 1.0,
        bevel: 0.1,
        y0: -0.25,
        y1: 0.25,
        accel: Some(Method::Grid),
        materials: Materials::new(),
    };
    add(&mut scene, "rosette", rosette, rgb(0.9, 0.85, 0.75));
    scene
}

fn archway() -> Scene {
    let about = "figure 21.11b, plain: an archway of six blocks a column and ten wedges";
    let mut scene = stage(about, point(20.0, 15.0, 60.0), point(0.0, 12.0, 0.0), 850.0);
    scene.background = rgb(0.6, 0.75, 0.95).into();
    scene.lights.push(directional("sun", vector(15.0, 20.0, 25.0), 3.0));
    let archway = Archway {
        width: 20.0,
        height: 25.0,
        depth: 3.0,
        column_width: 4.0,
        blocks: 6,
        wedges: 10,
        bevel: 0.5,
        accel: Some(Method::Grid),
        materials: Materials::new(),
    };
    add(&mut scene, "archway", archway, rgb(0.85, 0.7, 0.5));
    let (ground, material) = object("ground", ground(0.0), matte(0.3, 0.6, rgb(0.4, 0.5, 0.3)));
    scene.objects.push(ground);
    scene.materials.push(material);
    scene
}

fn nested_instance() -> Scene {
    let about = "figure 21.14: a ring and an instance, rotated by −45° about z and moved by 1";
    let mut scene = stage(about, point(4.0, 5.0, 10.0), point(0.5, 0.0, 0.0), 1100.0);
    scene.lights.push(directional("light", vector(10.0, 12.0, 8.0), 3.0));
    let ring = transformed(
        Torus { swept_radius: 1.0, tube_radius: 0.25, inward: false },
        vec![Step::Scale(vector(1.0, 1.0, 1.25))],
    );
    let steps = vec![Step::RotateZ(-45.0), Step::Translate(vector(1.0, 0.0, 0.0))];
    add(&mut scene, "ring", ring.clone(), rgb(1.0, 0.7, 0.3));
    add(&mut scene, "instance", transformed(ring, steps), rgb(0.4, 0.8, 0.9));
    scene
}

fn bowl() -> Scene {
    let about = "figure 21.16: a bowl of radii 1 and 1.2 with an opening of 120°";
    let mut scene = stage(about, point(3.0, 7.0, 10.0), point(0.0, -0.3, 0.0), 1600.0);
    scene.lights.push(directional("light", vector(5.0, 15.0, 5.0), 3.0));
    let bowl = RoundRimmedBowl {
        inner_radius: 1.0,
        outer_radius: 1.2,
        opening: 120.0,
        materials: Materials::new(),
    };
    add(&mut scene, "bowl", bowl, rgb(0.53, 0.67, 0.9));
    scene
}

fn squashed_spheres() -> Scene {
    let about = "as figure 21.15: 5 × 5 spheres, each scaled in y by four times a random number";
    let mut scene = stage(about, point(30.0, 40.0, 60.0), point(0.0, 2.5, 0.0), 1600.0);
    scene.lights.push(directional("light", vector(20.0, 25.0, 10.0), 3.0));
    let mut random = Pcg32::new(1000, 0);
    let ellipsoid = |i: u32| -> Kind {
        let height = 4.0 * random.uniform();
        let by = vector(2.25 * (f64::from(i % 5) - 2.0), height, 2.25 * (f64::from(i / 5) - 2.0));
        let steps = vec![Step::Scale(vector(1.0, height, 1.0)), Step::Translate(by)];
        transformed(sphere(Point::ORIGIN, 1.0), steps)
    };
    let spheres = Compound::of((0..25).map(ellipsoid));
    for (object, material) in [
        object("ellipsoids", spheres, phong(0.25, 0.75, random_colors(4), 0.2, 20.0)),
        object("ground", ground(0.0), matte(0.5, 0.5, grey(0.5))),
    ] {
        scene.objects.push(object);
        scene.materials.push(material);
    }
    scene
}
