//! Chapter 29: images on surfaces and as environment light. The images are drawn by formulas,
//! because the book's images may not be copied.

use super::List;
use groundtruth::background::{self, Dome};
use groundtruth::cameras::{Fisheye, Pinhole, Viewpoint};
use groundtruth::images::{Drawn, Picture};
use groundtruth::lights::Environment;
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{self, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{BeveledCylinder, Materials, Mesh, OpenCylinder, Rectangle};
use groundtruth::textures::{Filtering, Image, Mapping};

pub const SCENES: List = &[
    ("ch29/lace", lace),
    ("ch29/country", country),
    ("ch29/sphere-grid", || {
        let about =
            "figure 29.9: a grid on a sphere by the spherical mapping; lines meet at the poles";
        let mut scene = on_sphere(about, matte(0.4, 0.8, drawn(Picture::UvGrid, 960, 480, SPHERE)));
        scene.camera.eye = point(2.0, 3.0, 5.0);
        scene
    }),
    ("ch29/billiard-ball", || {
        let about = "as figure 29.11: a billiard ball, Phong with k_s .25 and e = 500";
        let image = drawn(Picture::BilliardBall, 1024, 512, SPHERE);
        let mut scene = on_sphere(about, phong(0.5, 0.8, image, 0.25, 500.0));
        scene.background = rgb(0.06, 0.2, 0.12).into();
        scene
    }),
    ("ch29/earth", || {
        let about = "as figures 29.12 and 29.13: a globe in sunlight with a dark night side";
        let mut scene = on_sphere(about, matte(0.0, 1.0, drawn(Picture::Globe, 1024, 512, SPHERE)));
        scene.lights = vec![directional("sun", vector(5.0, 2.0, 2.0), 4.0)];
        scene
    }),
    ("ch29/light-probe", light_probe),
    ("ch29/earth-nearest", || {
        let about = "figure 29.19a: a globe of 64 × 32 texels in close-up: texels are visible";
        near_earth(about, Filtering::Nearest)
    }),
    ("ch29/earth-bilinear", || {
        let about = "figure 29.19b: the same with bilinear interpolation: soft borders";
        near_earth(about, Filtering::Bilinear)
    }),
    ("ch29/uv-triangles", uv_triangles),
    ("ch29/jar", jar),
    ("ch29/sky-dome", sky_dome),
];

const SPHERE: Option<Mapping> = Some(Mapping::Spherical);

fn drawn(picture: Picture, width: u32, height: u32, mapping: Option<Mapping>) -> Image {
    Image::of_drawn(Drawn { picture, width, height }, mapping)
}

/// Figure 29.4: the generic rectangle −1 … 1 in x and z, scaled.
fn lace() -> Scene {
    let about = "as figure 29.4: lace on a rectangle of ratio 3 : 2 by the square mapping";
    let mut scene = pinhole(about, [400, 400], [point(2.0, 4.0, 3.0), Point::ORIGIN], 600.0);
    scene.background = grey(0.3).into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("light", vector(1.0, 2.0, 1.0), 3.0));
    let square =
        Rectangle { corner: point(-1.0, 0.0, -1.0), a: 2.0 * Vector::Z, b: 2.0 * Vector::X };
    let square = transformed(square, vec![Step::Scale(vector(1.0, 1.0, 1.5))]);
    let image = drawn(Picture::Lace, 512, 512, Some(Mapping::Square));
    add(&mut scene, "lace", square, matte(0.5, 0.8, image));
    scene
}

/// Figure 29.6.
fn country() -> Scene {
    let about = "as figure 29.6: a landscape around a cylinder, by the cylindrical mapping";
    let mut scene = pinhole(about, [400, 400], [point(0.0, 1.5, 6.0), Point::ORIGIN], 750.0);
    scene.background = grey(0.3).into();
    scene.lights.push(ambient(0.6));
    scene.lights.push(directional("light", vector(1.0, 1.0, 3.0), 2.0));
    let wall = OpenCylinder { y0: -1.0, y1: 1.0, radius: 1.0, inward: false };
    let image = drawn(Picture::Country, 1024, 256, Some(Mapping::Cylindrical));
    add(&mut scene, "wall", wall, matte(0.5, 0.8, image));
    // an open cylinder shows its inside, too
    scene.materials[0].two_sided = true;
    scene
}

/// The generic sphere.
fn on_sphere(about: &str, recipe: impl Into<groundtruth::materials::Kind>) -> Scene {
    let mut scene = pinhole(about, [400, 400], [point(1.5, 1.0, 6.0), Point::ORIGIN], 1050.0);
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("light", vector(2.0, 3.0, 4.0), 3.0));
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 1.0), recipe);
    scene
}

/// Figure 29.16: the camera is at the position of the probe.
fn light_probe() -> Scene {
    let about = "as figure 29.16: a light probe as background, with a fisheye of 360°";
    let lens = Fisheye { fov: 360.0, rectangular: false };
    let camera = Viewpoint::new(Point::ORIGIN, point(0.0, 0.0, -1.0), lens);
    let image = scene::Image { samples: 16, ..scene::Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    let probe = Drawn { picture: Picture::Courtyard, width: 800, height: 800 };
    // halved, because the windows are brighter than 1
    let sky = background::Image { ls: 0.5, ..background::Image::of_drawn(probe, Dome::LightProbe) };
    scene.background = sky.into();
    scene
}

/// Figure 29.19: the picture is some dozen texels wide.
fn near_earth(about: &str, filtering: Filtering) -> Scene {
    let image = Image { filtering, ..drawn(Picture::Globe, 64, 32, SPHERE) };
    let mut scene = on_sphere(about, matte(0.4, 1.0, image));
    scene.camera.lens = Pinhole { distance: 2200.0, zoom: 1.0 }.into();
    scene.camera.look_at = point(0.3, 0.35, 0.8);
    scene
}

/// Figure 29.22: two triangles of different shape with the corners of the image at their corners.
fn uv_triangles() -> Scene {
    let about =
        "as figure 29.22: a grid on two triangles by texture coordinates, without a mapping";
    let mut scene = pinhole(about, [400, 400], [point(0.0, 0.0, 10.0), Point::ORIGIN], 1250.0);
    scene.lights.push(ambient(1.0));
    scene.background = grey(0.3).into();
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.3, 1.1], [-0.4, 0.8]];
    let vertices = corners.map(|[x, y]| point(x, y, 0.0)).to_vec();
    let uvs = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mesh = Mesh { uvs: Some(uvs), ..Mesh::of_lists(vertices, vec![[0, 1, 2], [0, 2, 3]]) };
    add(&mut scene, "triangles", mesh, matte(1.0, 0.0, drawn(Picture::UvGrid, 960, 480, None)));
    scene
}

/// Figure 29.26. The label is on the wall of the beveled cylinder, which is centred at the origin,
/// so that the wall is the generic cylinder in units of half its height.
fn jar() -> Scene {
    const HEIGHT: f64 = 3.6;
    const BEVEL: f64 = 0.5;
    let about =
        "as figure 29.26: a jar with a label on the wall of a beveled cylinder, rotated by 100°";
    let mut scene =
        pinhole(about, [400, 400], [point(0.0, 6.0, 14.0), point(0.0, 2.0, 0.0)], 700.0);
    scene.background = grey(0.5).into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("light", vector(-10.0, 15.0, 20.0), 3.0));
    let label = Image {
        unit: 0.5 * HEIGHT - BEVEL,
        ..drawn(Picture::Label, 1024, 256, Some(Mapping::Cylindrical))
    };
    scene.materials.push(Material::new("label", matte(0.4, 0.7, label)));
    let (y0, y1) = (-0.5 * HEIGHT, 0.5 * HEIGHT);
    let materials = Materials::from([("wall".to_owned(), "label".to_owned())]);
    let body = BeveledCylinder { y0, y1, radius: 3.0, bevel: BEVEL, materials };
    let steps = vec![Step::RotateY(100.0), Step::Translate(vector(0.0, 0.5 * HEIGHT, 0.0))];
    add(
        &mut scene,
        "body",
        transformed(body, steps),
        phong(0.3, 0.6, rgb(0.8, 0.4, 0.1), 0.3, 200.0),
    );
    let materials = Materials::new();
    let cap = BeveledCylinder { y0: HEIGHT, y1: 4.1, radius: 3.0, bevel: 0.05, materials };
    add(&mut scene, "cap", cap, phong(0.3, 0.6, rgb(0.7, 0.05, 0.03), 0.3, 100.0));
    add(&mut scene, "table", ground(0.0), matte(0.4, 0.6, rgb(0.6, 0.55, 0.5)));
    scene
}

/// Figure 29.27: the sky is the only light.
fn sky_dome() -> Scene {
    let about = "as figure 29.27: objects lit by an image of a sky with clouds and a sun";
    let mut scene =
        pinhole(about, [600, 400], [point(0.0, 2.0, 12.0), point(0.0, 1.6, 0.0)], 620.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 5 });
    scene.image.samples = 64;
    let sky = Drawn { picture: Picture::SkyDome, width: 1024, height: 256 };
    let sky = background::Image {
        filtering: Filtering::Bilinear,
        rotate_y: 260.0,
        ..background::Image::of_drawn(sky, Dome::Hemispherical)
    };
    scene.background = sky.into();
    scene.lights.push(Light::new("sky", Environment {}));
    add(&mut scene, "ground", ground(0.0), matte(0.0, 0.6, rgb(0.5, 0.45, 0.3)));
    let chrome = mirror(phong(0.0, 0.0, Rgb::BLACK, 0.0, 1.0), 0.9, Rgb::WHITE);
    add(&mut scene, "mirror", sphere(point(-2.6, 1.2, 0.0), 1.2), chrome);
    add(&mut scene, "white", sphere(point(0.0, 1.2, 0.0), 1.2), matte(0.0, 0.8, Rgb::WHITE));
    let steps = vec![Step::RotateY(30.0), Step::Translate(vector(2.6, 1.0, 0.0))];
    let cube = transformed(boxed(point(-1.0, -1.0, -1.0), point(1.0, 1.0, 1.0)), steps);
    scene.objects.push(Object::new("cube", "cube", cube));
    scene.materials.push(Material::new("cube", matte(0.0, 0.8, rgb(0.7, 0.2, 0.1))));
    scene
}
