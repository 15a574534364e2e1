//! Chapter 23: triangle meshes.

use super::List;
use groundtruth::accel::Method;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Point, Step, Vector, cos_degrees, sin_degrees};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Intersect, Material, Object, Scene};
use groundtruth::shapes::{Compound, Kind, Lattice, Mesh, Part, TessellatedSphere};

pub const SCENES: List = &[
    ("ch23/flat-sphere", || tessellated(10, 5, false)),
    ("ch23/flat-sphere-4x2", || tessellated(4, 2, false)),
    ("ch23/flat-sphere-100x50", || tessellated(100, 50, false)),
    ("ch23/smooth-sphere", || tessellated(10, 5, true)),
    ("ch23/coarsest-sphere", coarsest),
    ("ch23/smooth-ground", smooth_ground),
    ("ch23/penguins", penguins),
    ("ch23/nested-grids", nested),
    ("ch23/leaks", || {
        let about = "leaks: the book's triangles miss rays through their common edges, so that the \
                     background is visible along the ribs of the umbrella";
        Scene { intersect: Intersect::Textbook, ..umbrella(about) }
    }),
    ("ch23/leaks-cured", || umbrella("the same with robust routines: the umbrella has no gaps")),
];

fn tessellated(horizontal: u32, vertical: u32, smooth: bool) -> Scene {
    let about = match (horizontal, smooth) {
        (4, _) => "figure 23.1: a sphere of 4 × 2 steps, flat: an octahedron",
        (100, _) => "figure 23.1: a sphere of 100 × 50 steps, flat: 9800 hardly visible triangles",
        (_, false) => "figure 23.1: a sphere of 10 × 5 steps, flat: every triangle is visible",
        (_, true) => {
            "as figure 23.1, smooth: shaded as a sphere, but the outline is still a polygon"
        }
    };
    with_mesh(about, TessellatedSphere::new(horizontal, vertical, smooth))
}

fn with_mesh(about: &str, shape: TessellatedSphere) -> Scene {
    let lens = Pinhole { distance: 4000.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(10.0, 12.0, 18.0), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("sun", vector(20.0, 25.0, -4.0), 1.0));
    scene.lights.push(directional("lamp", vector(10.0, 12.0, 18.0), 2.0));
    let (object, material) = object("sphere", shape, matte(0.25, 0.75, rgb(0.1, 0.5, 1.0)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

/// Figure 23.3: the coarsest possible sphere, three horizontal and two vertical steps, shaded
/// smoothly.
fn coarsest() -> Scene {
    let about = "figure 23.3: six triangles shaded as a sphere";
    let shape = TessellatedSphere::new(3, 2, true);
    with_mesh(about, shape)
}

/// A large sphere of few triangles as the ground: towards the horizon, smooth normals turn away from the viewer.
fn smooth_ground() -> Scene {
    let about = "a smooth mesh up to its horizon, where the normals turn away from the viewer, in low sunlight";
    let view = [point(0.0, 1.5, 12.0), point(0.0, 0.0, 0.0)];
    let mut scene = pinhole(about, [600, 300], view, 500.0);
    scene.background = rgb(0.6, 0.75, 0.95).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("sun", vector(-6.0, 2.5, -1.0), 3.0));
    let planet = TessellatedSphere { radius: 20.0, ..TessellatedSphere::new(24, 16, true) };
    let steps = vec![Step::RotateX(70.0), Step::Translate(-20.0 * Vector::Y)];
    let green = phong(0.4, 0.6, rgb(0.4, 0.7, 0.3), 0.3, 8.0);
    add(&mut scene, "ground", transformed(planet, steps), green);
    let red = matte(0.4, 0.6, rgb(0.9, 0.3, 0.2));
    add(&mut scene, "sphere", sphere(point(1.5, 1.0, 3.0), 1.0), red);
    scene
}

/// Figure 23.10 without the book's file: a penguin of twelve meshes, each a scaled tessellated
/// sphere with its own material; flat on the left, smooth on the right.
fn penguins() -> Scene {
    let camera = Viewpoint::new(
        point(6.0, 4.0, 20.0),
        point(0.0, 0.15, 0.0),
        Pinhole { distance: 2300.0, zoom: 1.0 },
    );
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let about = "as figure 23.10: a penguin of twelve meshes, flat and smooth";
    let mut scene = Scene::new(about, image, camera);
    scene.background = grey(0.1).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("light", vector(10.0, 15.0, 20.0), 2.5));
    for (name, color) in [
        ("body", rgb(0.5, 0.5, 1.0)),
        ("belly", Rgb::WHITE),
        ("wings", rgb(0.5, 1.0, 0.4)),
        ("feet", rgb(1.0, 0.8, 0.34)),
        ("eyes", Rgb::WHITE),
        ("lids", rgb(1.0, 0.0, 0.0)),
    ] {
        scene.materials.push(Material::new(name, matte(0.25, 0.75, color)));
    }
    for (name, x, smooth) in [("flat", -1.3, false), ("smooth", 1.3, true)] {
        let penguin = moved(penguin(smooth), vector(x, 0.0, 0.0));
        scene.objects.push(Object::new(name, "body", penguin));
    }
    scene
}

fn penguin(smooth: bool) -> Compound {
    let sphere = TessellatedSphere::new(20, 10, smooth);
    let part = |material: &str, scale: [f64; 3], tilt: f64, center: [f64; 3]| {
        let steps =
            vec![Step::Scale(scale.into()), Step::RotateZ(tilt), Step::Translate(center.into())];
        Part::new(transformed(sphere.clone(), steps)).of_material(material)
    };
    let pair = |material: &str, scale: [f64; 3], tilt: f64, [x, y, z]: [f64; 3]| {
        [part(material, scale, -tilt, [-x, y, z]), part(material, scale, tilt, [x, y, z])]
    };
    let mut parts = vec![
        part("body", [0.75, 1.0, 0.7], 0.0, [0.0, -0.25, 0.0]),
        part("belly", [0.6, 0.85, 0.5], 0.0, [0.0, -0.3, 0.27]),
        part("body", [0.5, 0.5, 0.5], 0.0, [0.0, 1.0, 0.0]),
    ];
    parts.extend(pair("wings", [0.12, 0.6, 0.35], 25.0, [0.8, 0.0, 0.0]));
    parts.extend(pair("feet", [0.3, 0.1, 0.45], 0.0, [0.35, -1.2, 0.35]));
    parts.extend(pair("eyes", [0.16, 0.16, 0.16], 0.0, [0.2, 1.15, 0.38]));
    parts.extend(pair("lids", [0.17, 0.1, 0.17], 0.0, [0.2, 1.26, 0.38]));
    parts.push(part("feet", [0.14, 0.1, 0.35], 0.0, [0.0, 0.9, 0.6]));
    Compound { accel: None, parts }
}

/// As figure 23.12: eight levels of ten by ten instances of the previous level.
fn nested() -> Scene {
    let size = 0.2; // the width of a bumpy sphere of radius 0.1, and room for its bumps
    let mut shape = Kind::from(TessellatedSphere {
        radius: 0.08,
        bumps: 0.15,
        ..TessellatedSphere::new(64, 32, true)
    });
    let mut width = size;
    for level in 0..8 {
        let gap = if level == 0 { 0.08 } else { 0.1 * width };
        let step = width + gap;
        shape = Lattice {
            of: Box::new(shape),
            counts: [10, 1, 10],
            spacing: vector(step, 0.0, step),
            accel: Some(Method::Grid),
        }
        .into();
        width = 10.0 * width + 9.0 * gap;
    }
    let camera = Viewpoint::new(
        point(-1.0, 4.0, -1.0),
        point(6.0, 0.0, 6.5),
        Pinhole { distance: 350.0, zoom: 1.0 },
    );
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let about = "as figure 23.12: 100⁸ instances of one mesh in eight nested grids";
    let mut scene = Scene::new(about, image, camera);
    scene.background = rgb(0.7, 0.8, 1.0).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("sun", vector(-20.0, 20.0, 10.0), 2.5));
    let (object, material) = object("meshes", shape, matte(0.5, 0.75, rgb(0.9, 0.65, 0.4)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

/// Eight triangles around the camera's axis. The picture has an odd width and height, so that the
/// edges go through the centres of a row, a column and two diagonals of pixels.
fn umbrella(about: &str) -> Scene {
    let eye = point(1.0, 4.0, 4.0);
    let away = (eye - Point::ORIGIN).length();
    let mut scene = pinhole(about, [257, 257], [eye, Point::ORIGIN], 118.0 * away);
    scene.image.samples = 1;
    scene.background = rgb(1.0, 0.95, 0.7).into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("light", vector(-3.0, 5.0, 3.0), 2.5).without_shadows());
    let w = 1.0 / away * eye.to_vector();
    let u = Vector::Y.cross(w).unit().unwrap_or(Vector::X);
    let v = w.cross(u);
    let rib = |k: u32| {
        let degrees = 45.0 * f64::from(k);
        Point::ORIGIN + (cos_degrees(degrees) * u + sin_degrees(degrees) * v)
    };
    let mut vertices = vec![Point::ORIGIN + 0.5 * w];
    vertices.extend((0..8).map(rib));
    // with the same first corner, the book's formula has no gap at a common edge: so these differ
    let triangle = |k: u32| {
        let (this, next) = (1 + k, 1 + (k + 1) % 8);
        if k.is_multiple_of(2) { [this, next, 0] } else { [0, this, next] }
    };
    let mesh = Mesh::of_lists(vertices, (0..8).map(triangle).collect());
    add(&mut scene, "umbrella", mesh, matte(0.25, 0.75, rgb(0.7, 0.1, 0.2)));
    scene
}
