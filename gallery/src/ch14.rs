//! Chapter 14: lights and materials. Lights have no shadows yet.

use super::List;
use super::shaded_sets::{
    before_the_set, four_cylinders, matte_set, thirty_five_spheres, two_spheres_before_a_wall,
};
use groundtruth::film::OutOfGamut;
use groundtruth::lights::{Directional, PointLight, Spot};
use groundtruth::materials::Emissive;
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene};

pub const SCENES: List = &[
    ("ch14/page-one", || {
        spheres("the picture of page one: 35 matte spheres under a directional light", 3.0)
    }),
    ("ch14/ambient-set", || {
        set("figure 14.5: the set in ambient light only: every object has a constant colour", None)
    }),
    ("ch14/set", || {
        let about =
            "figure 14.7: two spheres, a cylinder, a box and a plane under a directional light";
        set(about, Some(directional("sun", LAMP - Point::ORIGIN, 2.0).without_shadows()))
    }),
    ("ch14/point-set", || {
        let about =
            "figure 14.10: the set under a point light, whose direction changes along the box";
        set(about, Some(point_light("lamp", LAMP, 2.0).without_shadows()))
    }),
    ("ch14/attenuated-set", attenuated_set),
    ("ch14/spot-set", spot_set),
    ("ch14/diffuse-reflectance", || {
        let about = "figure 14.15: cylinders with kd 0.1, 0.4, 0.7 and 1";
        four_cylinders(about, [0.1, 0.4, 0.7, 1.0].map(|kd| matte(0.25, kd, grey(0.5)).into()))
    }),
    ("ch14/two-spheres", two_spheres),
    ("ch14/out-of-gamut", || {
        let about = "figure 14.22: 35 overexposed spheres; colours above 1 are shown in red";
        let mut scene = spheres(about, 4.5);
        scene.image.out_of_gamut = OutOfGamut::ClampToColor;
        scene
    }),
    ("ch14/max-to-one", || {
        spheres("figure 14.23: colours above 1 are divided by their largest channel", 4.5)
    }),
    ("ch14/white-light", || {
        four_spheres("figure 14.24: four coloured spheres in white light", Rgb::WHITE)
    }),
    ("ch14/orange-light", || {
        let about = "figure 14.26: four coloured spheres in orange light, which has no blue";
        four_spheres(about, rgb(1.0, 0.5, 0.0))
    }),
];

/// The lamp of figures 14.10 and 14.11; that of 14.7 shines from this direction.
const LAMP: Point = Point::new(15.0, 15.0, 2.5);

/// Page one, and figures 14.22 and 14.23.
fn spheres(about: &str, ls: f64) -> Scene {
    let sun = directional("sun", vector(100.0, 100.0, 200.0), ls).without_shadows();
    thirty_five_spheres(about, sun, |color| matte(0.25, 0.75, color).into())
}

/// Figures 14.5 to 14.10.
fn set(about: &str, light: Option<Light>) -> Scene {
    matte_set(before_the_set(about), light)
}

/// Figure 14.11. In the book's view the lamp is not in the picture.
fn attenuated_set() -> Scene {
    let about = "figure 14.11 from farther away, with the lamp: its light decreases as 1/d²";
    let view = [point(18.0, 9.0, 30.0), point(3.5, 6.5, 0.0)];
    let source = PointLight { ls: 600.0, color: Rgb::WHITE, location: LAMP, attenuation: 2.0 };
    let light = Light::new("lamp light", source).without_shadows();
    let mut scene = matte_set(pinhole(about, [600, 400], view, 500.0), Some(light));
    let (mut lamp, glow) = object("lamp", sphere(LAMP, 0.75), Emissive::new(1.0, Rgb::WHITE));
    lamp.casts_shadows = false;
    scene.objects.push(lamp);
    scene.materials.push(glow);
    scene
}

/// Not in the book.
fn spot_set() -> Scene {
    let about = "a spot light on the set (not in the book): a cone of light with a soft edge";
    let source = Spot {
        ls: 2.0,
        color: Rgb::WHITE,
        location: LAMP,
        direction: point(0.5, 2.0, 0.0) - LAMP,
        inner: 10.0,
        outer: 16.0,
        attenuation: 0.0,
    };
    set(about, Some(Light::new("spot", source).without_shadows()))
}

/// Figure 14.21.
fn two_spheres() -> Scene {
    let about = "figure 14.21: two matte spheres in front of a wall, without shadows";
    let mut scene = two_spheres_before_a_wall(about);
    for light in &mut scene.lights {
        light.shadows = false;
    }
    scene
}

/// Figures 14.24 and 14.26.
fn four_spheres(about: &str, color: Rgb) -> Scene {
    let view = [point(0.0, 25.0, 100.0), Point::ORIGIN];
    let mut scene = pinhole(about, [600, 300], view, 6500.0);
    scene.lights.push(ambient(1.0));
    let source = Directional { ls: 3.0, color, direction: vector(200.0, 250.0, 300.0) };
    scene.lights.push(Light::new("sun", source).without_shadows());
    for (name, x, color) in [
        ("red sphere", -3.3, rgb(1.0, 0.0, 0.0)),
        ("orange sphere", -1.1, rgb(1.0, 0.5, 0.0)),
        ("yellow sphere", 1.1, rgb(1.0, 1.0, 0.0)),
        ("green sphere", 3.3, rgb(0.0, 1.0, 0.0)),
    ] {
        add(&mut scene, name, sphere(Point::ORIGIN + x * Vector::X, 1.0), matte(0.0, 0.75, color));
    }
    add(&mut scene, "ground", ground(-1.0), matte(0.25, 0.5, Rgb::WHITE));
    scene
}
