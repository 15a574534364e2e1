//! Chapter 19: the objects of the book, and compound objects.

use super::List;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Point, Step};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Intersect, Material, Object, Scene};
use groundtruth::shapes::{
    Algebraic, Annulus, ConcaveLens, Cone, CutFace, FlatRimmedBowl, Kind, Materials, Paraboloid,
    PartAnnulus, PartCylinder, PartSphere, PartTorus, RoundRimmedBowl, SolidCone, SolidCylinder,
    Term, ThickRing, Torus,
};

pub const SCENES: List = &[
    ("ch19/torus", torus),
    ("ch19/solid-cylinder", solid_cylinder),
    ("ch19/cone", cone),
    ("ch19/colored-cylinder", colored_cylinder),
    ("ch19/bowls", bowls),
    ("ch19/colored-ring", colored_ring),
    ("ch19/part-objects", part_objects),
    ("ch19/more-objects", more_objects),
    ("ch19/algebraic", algebraic),
    ("ch19/lost-roots", || {
        let about = "lost roots: at a distance of 3000 radii, rounding errors of the book's quartic turn \
                     hits into misses and misses into hits: the outline of the torus is ragged";
        Scene { intersect: Intersect::Textbook, ..far_torus(about) }
    }),
    ("ch19/lost-roots-cured", || {
        far_torus("the same with robust routines: the torus is complete, its outline sharp")
    }),
];

/// A view from above and the right, with light from the right behind the camera.
fn stage(about: &str, look_at: Point, distance: f64) -> Scene {
    let lens = Pinhole { distance, zoom: 1.0 };
    let camera = Viewpoint::new(point(4.0, 6.0, 10.0), look_at, lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.background = grey(0.05).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("light", vector(15.0, 15.0, 2.5), 3.0));
    scene
}

/// A wider view for two rows of objects.
fn wide_stage(about: &str, distance: f64) -> Scene {
    let mut scene = stage(about, Point::ORIGIN, distance);
    scene.camera.eye = point(0.0, 6.0, 11.0);
    scene.image = Image { samples: 16, ..Image::new(600, 400) };
    scene.lights[1].shadows = false; // so that no object shades another
    scene
}

fn add(scene: &mut Scene, name: &str, shape: impl Into<Kind>, color: Rgb, two_sided: bool) {
    let (object, material) = object(name, shape, phong(0.25, 0.75, color, 0.15, 50.0));
    scene.objects.push(object);
    scene.materials.push(Material { two_sided, ..material });
}

fn torus() -> Scene {
    let about = "figure 19.16: a torus of radii 2 and 0.15";
    let mut scene = stage(about, Point::ORIGIN, 850.0);
    let torus = Torus { swept_radius: 2.0, tube_radius: 0.15, inward: false };
    add(&mut scene, "torus", torus, rgb(1.0, 0.6, 0.2), false);
    scene
}

fn solid_cylinder() -> Scene {
    let mut scene = stage("figure 19.23a: a solid cylinder", Point::ORIGIN, 1200.0);
    let cylinder = SolidCylinder { y0: -1.0, y1: 1.0, radius: 1.0, materials: Materials::new() };
    add(&mut scene, "cylinder", cylinder, rgb(0.5, 0.75, 0.25), false);
    scene
}

fn cone() -> Scene {
    let about = "figure 19.25b: a cone of height 2 and radius 1, its base open";
    let mut scene = stage(about, point(0.0, 0.9, 0.0), 1200.0);
    let cone = Cone { height: 2.0, radius: 1.0, inward: false };
    add(&mut scene, "cone", cone, rgb(0.4, 0.6, 1.0), true);
    scene
}

fn colored_cylinder() -> Scene {
    let about = "figure 19.29a: one cylinder of two materials, cyan caps and a yellow wall";
    let mut scene = stage(about, Point::ORIGIN, 1200.0);
    let materials = [("bottom", "cyan"), ("top", "cyan"), ("wall", "yellow")];
    let materials = materials.map(|(part, material)| (part.to_owned(), material.to_owned()));
    let cylinder =
        SolidCylinder { y0: -1.0, y1: 1.0, radius: 1.0, materials: Materials::from(materials) };
    scene.objects.push(Object::new("cylinder", "yellow", cylinder));
    for (name, color) in [("cyan", rgb(0.0, 1.0, 1.0)), ("yellow", rgb(1.0, 1.0, 0.0))] {
        scene.materials.push(Material::new(name, matte(0.25, 0.75, color)));
    }
    scene
}

fn colored_ring() -> Scene {
    let about = "figure 19.29b: a thick ring of three materials";
    let mut scene = stage(about, Point::ORIGIN, 1800.0);
    let materials =
        [("bottom", "orange"), ("top", "orange"), ("inner_wall", "green"), ("outer_wall", "blue")];
    let materials = materials.map(|(part, material)| (part.to_owned(), material.to_owned()));
    let ring = ThickRing {
        y0: -0.25,
        y1: 0.25,
        inner_radius: 0.5,
        outer_radius: 1.0,
        materials: Materials::from(materials),
    };
    scene.objects.push(Object::new("ring", "blue", ring));
    for (name, color) in [
        ("orange", rgb(1.0, 0.6, 0.1)),
        ("green", rgb(0.4, 0.9, 0.3)),
        ("blue", rgb(0.3, 0.5, 1.0)),
    ] {
        scene.materials.push(Material::new(name, matte(0.25, 0.75, color)));
    }
    scene
}

fn bowls() -> Scene {
    let about = "figure 19.27: a bowl with a flat rim and one with a round rim";
    let lens = Pinhole { distance: 900.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(1.0, 2.0, 5.0), point(0.0, -0.35, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(900, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.background = grey(0.05).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("light", vector(10.0, 20.0, 15.0), 3.0));
    let (inner_radius, outer_radius, opening) = (0.9, 1.0, 180.0);
    let materials = Materials::new;
    let flat = FlatRimmedBowl { inner_radius, outer_radius, opening, materials: materials() };
    let round = RoundRimmedBowl { inner_radius, outer_radius, opening, materials: materials() };
    let flat = moved(flat, vector(-1.15, 0.0, 0.0));
    let round = moved(round, vector(1.15, 0.0, 0.0));
    add(&mut scene, "flat-rimmed", flat, rgb(0.15, 0.75, 0.9), false);
    add(&mut scene, "round-rimmed", round, rgb(0.53, 0.67, 0.34), false);
    scene
}

fn part_objects() -> Scene {
    let about = "parts of a sphere, a torus, a cylinder and an annulus, a paraboloid and a ring";
    let mut scene = wide_stage(about, 700.0);
    let at = |shape: Kind, x: f64, z: f64| moved(shape, vector(x, 0.0, z));
    let sphere = PartSphere {
        center: Point::ORIGIN,
        radius: 1.0,
        phi: [300.0, 210.0],
        theta: [30.0, 150.0],
        inward: false,
    };
    let torus = PartTorus {
        swept_radius: 0.9,
        tube_radius: 0.3,
        phi: [330.0, 240.0],
        theta: [180.0, 90.0],
        inward: false,
    };
    let cylinder =
        PartCylinder { y0: -0.75, y1: 0.75, radius: 1.0, phi: [350.0, 200.0], inward: false };
    let annulus = PartAnnulus {
        center: Point::ORIGIN,
        normal: vector(0.0, 1.0, 0.0),
        inner_radius: 0.5,
        outer_radius: 1.2,
        phi: [90.0, 20.0],
    };
    let ring = Annulus {
        center: Point::ORIGIN,
        normal: vector(0.0, 2.0, 1.0),
        inner_radius: 0.6,
        outer_radius: 1.0,
    };
    let paraboloid = Paraboloid { height: 1.5, radius: 1.0, inward: false };
    for (name, shape, x, z, color) in [
        ("sphere", Kind::from(sphere), -2.9, -1.8, rgb(1.0, 0.4, 0.3)),
        ("torus", torus.into(), 0.0, -1.8, rgb(1.0, 0.75, 0.2)),
        ("cylinder", cylinder.into(), 2.9, 1.6, rgb(0.4, 0.8, 0.3)),
        ("annulus", annulus.into(), -2.7, 1.6, rgb(0.3, 0.7, 0.9)),
        ("ring", ring.into(), 0.0, 1.6, rgb(0.5, 0.5, 1.0)),
        ("paraboloid", paraboloid.into(), 2.7, -1.8, rgb(0.9, 0.5, 0.9)),
    ] {
        add(&mut scene, name, at(shape, x, z), color, true);
    }
    scene
}

fn more_objects() -> Scene {
    let about = "a solid cone, a concave lens, a cut face, an ellipsoid, a hemisphere and a box";
    let mut scene = wide_stage(about, 800.0);
    let materials = Materials::new;
    let cone = SolidCone { height: 1.8, radius: 1.0, materials: materials() };
    let cone =
        transformed(cone, vec![Step::RotateX(-55.0), Step::Translate(vector(-2.9, 0.0, -1.5))]);
    let lens =
        ConcaveLens { radius: 1.0, thickness: 1.0, min_distance: 0.2, materials: materials() };
    let lens =
        transformed(lens, vec![Step::RotateX(35.0), Step::Translate(vector(0.0, 0.0, -1.8))]);
    let face = CutFace { size: 2.0, radius: 0.7 };
    let face =
        transformed(face, vec![Step::RotateX(30.0), Step::Translate(vector(2.8, 0.0, -1.8))]);
    let ellipsoid = vec![
        Step::Scale(vector(1.2, 0.4, 0.8)),
        Step::RotateZ(30.0),
        Step::Translate(vector(-2.7, 0.0, 1.6)),
    ];
    let hemisphere = PartSphere {
        center: point(0.0, -0.4, 1.6),
        radius: 1.0,
        phi: [0.0, 360.0],
        theta: [0.0, 90.0],
        inward: false,
    };
    let solid = transformed(
        boxed(point(-0.8, -0.5, -0.6), point(0.8, 0.5, 0.6)),
        vec![Step::RotateY(25.0), Step::Translate(vector(2.7, 0.0, 1.6))],
    );
    for (name, shape, color) in [
        ("cone", cone, rgb(1.0, 0.4, 0.3)),
        ("lens", lens, rgb(0.3, 0.7, 0.9)),
        ("face", face, rgb(1.0, 0.75, 0.2)),
        ("ellipsoid", transformed(sphere(Point::ORIGIN, 1.0), ellipsoid), rgb(0.9, 0.5, 0.9)),
        ("hemisphere", hemisphere.into(), rgb(0.4, 0.8, 0.3)),
        ("box", solid, rgb(0.5, 0.5, 1.0)),
    ] {
        add(&mut scene, name, shape, color, true);
    }
    scene
}

/// The first is `x⁴ − 5x² + y⁴ − 5y² + z⁴ − 5z² + 11.8`, the second Taubin's heart
/// `(x² + y² + 9z²/4 − 1)³ − x²y³ − 9y³z²/80`.
fn algebraic() -> Scene {
    let about = "algebraic surfaces of degree 4 and 6: a tangle cube and a heart";
    let mut scene = stage(about, Point::ORIGIN, 570.0);
    scene.camera.eye = point(2.0, 3.0, 12.0);
    scene.image = Image { samples: 16, ..Image::new(400, 200) };
    let term = |coefficient, powers| Term { coefficient, powers };
    let cube = |half: f64| (point(-half, -half, -half), point(half, half, half));
    let mut tangle = vec![term(11.8, [0; 3])];
    for axis in 0..3 {
        let power = |n| std::array::from_fn(|i| if i == axis { n } else { 0 });
        tangle.extend([term(1.0, power(4)), term(-5.0, power(2))]);
    }
    let (min, max) = cube(2.5);
    let tangle = Algebraic { terms: tangle, min, max };
    let factorial = |n: u32| f64::from((1..=n).product::<u32>());
    let mut heart = vec![term(-1.0, [2, 3, 0]), term(-9.0 / 80.0, [0, 3, 2])];
    for [i, j, k] in
        (0..64).map(|n| [n % 4, n / 4 % 4, n / 16]).filter(|n| n.iter().sum::<u32>() <= 3)
    {
        let rest = 3 - i - j - k; // of the −1
        let ways = 6.0 / [i, j, k, rest].map(factorial).iter().product::<f64>();
        let sign = if rest % 2 == 0 { 1.0 } else { -1.0 };
        heart.push(term(
            sign * ways * (1..=k).map(|_| 2.25).product::<f64>(),
            [2 * i, 2 * j, 2 * k],
        ));
    }
    let (min, max) = cube(1.5);
    let heart = Algebraic { terms: heart, min, max };
    let beside = |x: f64, size: f64| {
        vec![Step::Scale(vector(size, size, size)), Step::Translate(vector(x, 0.0, 0.0))]
    };
    add(&mut scene, "tangle", transformed(tangle, beside(-2.0, 0.6)), rgb(0.4, 0.6, 1.0), false);
    add(&mut scene, "heart", transformed(heart, beside(2.0, 1.2)), rgb(1.0, 0.25, 0.3), false);
    scene
}

/// A torus from far away with a small field of view.
fn far_torus(about: &str) -> Scene {
    let view = [point(2000.0, 3000.0, 5000.0), Point::ORIGIN];
    let mut scene = pinhole(about, [300, 200], view, 250_000.0);
    scene.image.samples = 1;
    scene.background = rgb(0.02, 0.02, 0.04).into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("light", vector(1.0, 2.0, 0.5), 3.0).without_shadows());
    let torus = Torus { swept_radius: 2.0, tube_radius: 0.5, inward: false };
    groundtruth::scene::build::add(
        &mut scene,
        "torus",
        torus,
        matte(0.25, 0.75, rgb(1.0, 0.6, 0.2)),
    );
    scene
}
