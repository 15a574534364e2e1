//! Mistakes whose picture is that of another scene, or of another part of the same picture.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::lights::Ambient;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Light;
use groundtruth::shapes::{Kind, TessellatedSphere};
use groundtruth::{materials, textures};
use judge::mistakes;

use super::stage::*;

const WIDTH: u32 = 32;

/// Law: direct light without 1/π is that of a scene whose `k_d` is π times as large. Oracle: that scene.
#[test]
fn without_pi_is_a_larger_kd() {
    let scene = small("ch16/coloured-shadows", WIDTH, 1);
    let mut twin = scene.clone();
    let pi = std::f64::consts::PI;
    for material in &mut twin.materials {
        let kd = match &mut material.recipe {
            materials::Kind::Matte(matte) => &mut matte.kd,
            materials::Kind::Phong(phong) => &mut phong.kd,
            other => panic!("{other:?}"),
        };
        let textures::Amount::Plain(plain) = kd else { panic!("{kd:?}") };
        *plain *= pi;
    }
    assert_eq!(share_of_differences(&with("lambertian-without-pi", &scene), &ours(&twin)), 0.0);
}

/// Law: a scene of opaque objects without shadows is one whose objects cast none. Oracle: that scene.
#[test]
fn without_shadows_objects_cast_none() {
    let scene = small("ch16/shadows", WIDTH, 4);
    let mut twin = scene.clone();
    twin.objects.iter_mut().for_each(|object| object.casts_shadows = false);
    assert_eq!(bits(&with("no-shadows", &scene)), bits(&ours(&twin)));
}

/// Law: glass without shadows is glass whose objects cast none. Oracle: that scene.
#[test]
fn glass_without_shadows() {
    let scene = small("ch27/common-set", WIDTH, 1);
    let mut twin = scene.clone();
    for object in &mut twin.objects {
        let its = scene.materials.iter().find(|it| it.name == object.material);
        object.casts_shadows = !matches!(
            its.expect("it has a material").recipe,
            materials::Kind::Transparent(_) | materials::Kind::Dielectric(_)
        );
    }
    assert_eq!(bits(&with("glass-casts-no-shadow", &scene)), bits(&ours(&twin)));
}

/// Law: transmission without 1/η² is that of a scene with `scales_radiance = false`. Oracle: that scene.
#[test]
fn without_eta_squared_radiance_is_not_scaled() {
    for name in ["ch28/snell-window", "ch28/in-a-diamond"] {
        let scene = small(name, WIDTH, 4);
        let mut twin = scene.clone();
        twin.transparency.scales_radiance = false;
        let share = share_of_differences(&with("no-eta-squared", &scene), &ours(&twin));
        assert_eq!(share, 0.0, "{name}");
    }
}

/// Law: media that do not absorb are those of absorption 0. Oracle: that scene.
#[test]
fn without_absorption_media_are_clear() {
    let scene = small("ch28/three-filters", WIDTH, 1);
    let mut twin = scene.clone();
    for material in &mut twin.materials {
        if let materials::Kind::Dielectric(glass) = &mut material.recipe {
            glass.inside.absorption = Rgb::BLACK;
            glass.outside.absorption = Rgb::BLACK;
        }
    }
    assert_eq!(share_of_differences(&with("no-absorption", &scene), &ours(&twin)), 0.0);
}

/// Law: one bounce less or more is the same figure of the book at the next depth. Oracle: the gallery's scenes of these
/// depths.
#[test]
fn other_depths() {
    let set = |depth: u32| small(&format!("ch24/reflective-set-depth-{depth}"), WIDTH, 1);
    assert_eq!(bits(&with("one-bounce-less", &set(1))), bits(&ours(&set(0))));
    assert_eq!(bits(&with("one-bounce-less", &set(2))), bits(&ours(&set(1))));
    assert_eq!(bits(&with("one-bounce-more", &set(1))), bits(&ours(&set(2))));
    let at_zero = mistakes::replica(
        mistakes::find("one-bounce-less").expect("it is known"),
        &set(0),
        Path::new(""),
        1,
    );
    assert!(at_zero.expect("the scene is valid").is_none());
}

/// Law: a texture upside down on a sphere under ambient light is the picture upside down. Oracle: the rows of our picture,
/// from the last to the first.
#[test]
fn a_texture_upside_down() {
    let mut scene = small("ch29/earth", WIDTH, 1);
    scene.lights = vec![Light::new("ambient", Ambient { ls: 1.0, color: Rgb::WHITE })];
    for material in &mut scene.materials {
        if let materials::Kind::Matte(matte) = &mut material.recipe {
            matte.ka = 1.0.into();
        }
    }
    let eye = scene.camera.eye;
    scene.camera.eye = groundtruth::math::Point::new(eye.x(), scene.camera.look_at.y(), eye.z());
    let (right, wrong) = (ours(&scene), with("texture-upside-down", &scene));
    let mut flipped = Film::new(right.width(), right.height());
    for at in (0..right.width()).flat_map(|x| (0..right.height()).map(move |y| [x, y])) {
        flipped.set([at[0], right.height() - 1 - at[1]], right.get(at));
    }
    assert!(share_of_differences(&right, &wrong) > 0.1);
    // a texel's border may fall on a pixel's centre
    assert!(share_of_differences(&flipped, &wrong) < 0.02);
}

/// Law: flat shading of a smooth sphere is a flat sphere. Oracle: that scene.
#[test]
fn flat_shading() {
    let scene = small("ch23/smooth-sphere", WIDTH, 1);
    let mut twin = scene.clone();
    for object in &mut twin.objects {
        if let Kind::TessellatedSphere(TessellatedSphere { smooth, .. }) = &mut object.shape {
            *smooth = false;
        }
    }
    assert_eq!(bits(&with("flat-shading", &scene)), bits(&ours(&twin)));
}

/// Law: a sky turned by 90° is seen by a camera that is turned back. Oracle: that camera, in a scene of sky alone.
#[test]
fn a_turned_sky() {
    let mut scene = small("ch29/sky-dome", WIDTH, 1);
    scene.objects.clear();
    let film = with("sky-turned", &scene);
    let (eye, look_at) = (scene.camera.eye, scene.camera.look_at);
    let way = look_at - eye;
    // turned by −90° about y: (x, z) becomes (−z, x)
    let back = groundtruth::math::Vector::new(-way.z(), way.y(), way.x());
    scene.camera.look_at = eye + back;
    assert!(share_of_differences(&film, &ours(&scene)) < 0.02);
}

/// Law: sums of several octaves without the last are sums of one octave less. Oracle: the scene of that sum.
#[test]
fn one_octave_less() {
    let scene = small("ch31/fbm", WIDTH, 1);
    let mut twin = scene.clone();
    for material in &mut twin.materials {
        let materials::Kind::Matte(matte) = &mut material.recipe else { panic!("{material:?}") };
        let textures::Paint::Textured(texture) = &mut matte.cd else { continue };
        let textures::Kind::Fbm(fbm) = &mut **texture else { panic!("{texture:?}") };
        fbm.noise.octaves -= 1;
    }
    assert_eq!(bits(&with("one-octave-less", &scene)), bits(&ours(&twin)));
}
