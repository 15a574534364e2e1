//! Chapter 14: lights and materials. No light casts shadows yet.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::math::{Point, Vector};
use crate::rgb::Rgb;
use crate::scene::{Image, Material, Object, Scene};
use crate::shapes::{Disk, OpenCylinder};

pub const SCENES: List = &[("ch14/page-one", page_one), ("ch14/set", set)];

const YELLOW: Rgb = Rgb::new(1.0, 1.0, 0.0);
const BROWN: Rgb = Rgb::new(0.71, 0.40, 0.16);
const DARK_GREEN: Rgb = Rgb::new(0.0, 0.41, 0.41);
const ORANGE: Rgb = Rgb::new(1.0, 0.75, 0.0);
const GREEN: Rgb = Rgb::new(0.0, 0.6, 0.3);
const LIGHT_GREEN: Rgb = Rgb::new(0.65, 1.0, 0.30);
const DARK_YELLOW: Rgb = Rgb::new(0.61, 0.61, 0.0);
const LIGHT_PURPLE: Rgb = Rgb::new(0.65, 0.3, 1.0);
const DARK_PURPLE: Rgb = Rgb::new(0.5, 0.0, 1.0);

/// The 35 spheres: centre, radius, and which of the colours.
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

fn page_one() -> Scene {
    let eye = point(0.0, 0.0, 10_000.0);
    let camera = Viewpoint::new(eye, Point::ORIGIN, Pinhole { distance: 15_000.0, zoom: 1.0 });
    let image = Image { pixel_size: 0.5, samples: 16, ..Image::new(600, 600) };
    let about = "the picture of page one: 35 matte spheres under a directional light";
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(100.0, 100.0, 200.0), 3.0).without_shadows());
    for (i, &(center, radius, color)) in SPHERES.iter().enumerate() {
        let (object, material) = object(
            &format!("sphere {}", i + 1),
            sphere(center.into(), radius),
            matte(0.25, 0.75, color),
        );
        scene.objects.push(object);
        scene.materials.push(material);
    }
    scene
}

/// The two spheres, cylinder, box and plane of figures 14.5 to 14.11, in the light of 14.7.
fn set() -> Scene {
    let lens = Pinhole { distance: 340.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(7.5, 4.0, 10.0), point(-1.0, 3.7, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let about = "figure 14.7: two spheres, a cylinder, a box and a plane under a directional light";
    let mut scene = Scene::new(about, image, camera);
    scene.background = rgb(0.0, 0.225, 0.1875).into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("sun", vector(15.0, 15.0, 2.5), 2.0).without_shadows());

    let mut add = |(object, material): (Object, Material)| {
        scene.objects.push(object);
        scene.materials.push(material);
    };
    let yellow = matte(0.25, 0.75, rgb(0.75, 0.75, 0.0));
    add(object("yellow sphere", sphere(point(3.85, 2.3, -2.55), 2.3), yellow));
    let orange = matte(0.45, 0.75, rgb(0.75, 0.25, 0.0));
    add(object("orange sphere", sphere(point(-0.7, 1.0, 4.2), 2.0), orange));
    let wall = OpenCylinder { y0: 0.0, y1: 8.5, radius: 2.2, inward: false };
    add(object("cylinder", wall, matte(0.4, 0.75, rgb(1.0, 0.5, 1.0))));
    let slab = boxed(point(-3.5, 0.0, -11.0), point(-2.5, 6.0, 6.5));
    add(object("box", slab, matte(0.15, 0.5, rgb(0.75, 1.0, 0.75))));
    add(object("ground", ground(0.0), matte(0.2, 0.97, Rgb::WHITE)));
    for (name, y, normal) in
        [("cylinder top", 8.5, Vector::Y), ("cylinder bottom", 0.0, -Vector::Y)]
    {
        let disk = Disk { center: point(0.0, y, 0.0), normal, radius: 2.2 };
        scene.objects.push(Object::new(name, "cylinder", disk));
    }
    scene
}
