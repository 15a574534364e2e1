//! Chapter 27: simple transparency.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::materials::{Kind as MaterialKind, Reflective, Transparent};
use crate::math::Vector;
use crate::rgb::Rgb;
use crate::scene::{Image, Scene, Tracer, Whitted};
use crate::shapes::Rectangle;
use crate::textures::{Checker3d, Kind as TextureKind, Paint};

pub const SCENES: List = &[("ch27/common-set", common_set)];

fn common_set() -> Scene {
    let phong = phong(0.0, 0.0, Rgb::BLACK, 0.2, 2000.0);
    let glass = Transparent { phong, kr: 0.1, cr: Rgb::WHITE.into(), kt: 0.9, eta: 1.5 };
    let about =
        "the common set of chapter 27: a glass sphere over a checker, before a red mirror sphere";
    common_set_with(about, glass.into())
}

/// The chapter's set with this glass; chapter 28 uses it again.
pub(super) fn common_set_with(about: &str, glass: MaterialKind) -> Scene {
    let lens = Pinhole { distance: 2400.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(-8.0, 5.5, 40.0), point(1.0, 4.0, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(600, 600) };
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 5 });
    scene.background = rgb(0.0, 0.3, 0.25).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(point_light("high lamp", point(40.0, 50.0, 0.0), 4.5));
    scene.lights.push(point_light("front lamp", point(-10.0, 20.0, 10.0), 4.5));
    scene.lights.push(directional("left light", -Vector::X, 4.5));

    let red = Reflective {
        phong: phong(0.3, 0.3, rgb(1.0, 0.0, 0.0), 0.2, 2000.0),
        kr: 0.25,
        cr: Rgb::WHITE.into(),
    };
    let checker = Checker3d { size: 4.0, color1: grey(0.75), color2: Rgb::WHITE };
    let ground = Rectangle {
        corner: point(-20.0, 0.0, -100.0),
        a: vector(0.0, 0.0, 120.0),
        b: vector(40.0, 0.0, 0.0),
    };
    for (object, material) in [
        object("glass sphere", sphere(point(0.0, 4.5, 0.0), 3.0), glass),
        object("red sphere", sphere(point(4.0, 4.0, -6.0), 3.0), red),
        object("ground", ground, matte(0.5, 0.35, Paint(TextureKind::from(checker)))),
    ] {
        scene.objects.push(object);
        scene.materials.push(material);
    }
    scene
}
