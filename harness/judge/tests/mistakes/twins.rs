//! Mistakes whose picture is that of another scene, or of another part of the same picture.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::lights::Ambient;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{Kind, TessellatedSphere};
use groundtruth::{materials, textures};
use judge::mistakes;

use super::stage::*;

const WIDTH: u32 = 32;

/// A mistake, a scene with so many samples, the change of the scene that is the same, and whether it is so bit for bit.
type Twin = (&'static str, &'static str, u32, fn(&mut Scene), bool);

/// Each mistake with the scene that it makes: a `k_d` that is π times as large; objects that cast no shadow, all or those of
/// glass; radiance that is not scaled by 1/η²; media of absorption 0; flat spheres; no bumps; one octave less.
const TWINS: [Twin; 9] = [
    ("lambertian-without-pi", "ch16/coloured-shadows", 1, larger_kd, false),
    ("no-shadows", "ch16/shadows", 4, without_shadows, true),
    ("glass-casts-no-shadow", "ch27/common-set", 1, glass_without_shadows, true),
    ("no-eta-squared", "ch28/snell-window", 4, unscaled, false),
    ("no-eta-squared", "ch28/in-a-diamond", 4, unscaled, false),
    ("no-absorption", "ch28/three-filters", 1, clear, false),
    ("flat-shading", "ch23/smooth-sphere", 1, flat, true),
    ("no-bumps", "ch31/noise-bump", 1, without_bumps, true),
    ("one-octave-less", "ch31/fbm", 1, one_octave_less, true),
];

/// Law: the picture of a mistake is that of its twin. Oracle: that scene.
#[test]
fn mistakes_have_the_pictures_of_their_twins() {
    for (mistake, name, samples, change, is_exact) in TWINS {
        let scene = small(name, WIDTH, samples);
        let mut twin = scene.clone();
        change(&mut twin);
        let (wrong, expected) = (with(mistake, &scene), ours(&twin));
        assert_eq!(share_of_differences(&wrong, &expected), 0.0, "{mistake} in {name}");
        assert!(!is_exact || bits(&wrong) == bits(&expected), "{mistake} in {name}");
        assert_ne!(bits(&ours(&scene)), bits(&expected), "{mistake} in {name} changes nothing");
    }
}

fn larger_kd(scene: &mut Scene) {
    for material in &mut scene.materials {
        let kd = match &mut material.recipe {
            materials::Kind::Matte(matte) => &mut matte.kd,
            materials::Kind::Phong(phong) => &mut phong.kd,
            other => panic!("{other:?}"),
        };
        let textures::Amount::Plain(plain) = kd else { panic!("{kd:?}") };
        *plain *= std::f64::consts::PI;
    }
}

fn without_shadows(scene: &mut Scene) {
    scene.objects.iter_mut().for_each(|object| object.casts_shadows = false);
}

fn glass_without_shadows(scene: &mut Scene) {
    for object in &mut scene.objects {
        let its = scene.materials.iter().find(|it| it.name == object.material);
        let recipe = &its.expect("it has a material").recipe;
        let is_glass =
            matches!(recipe, materials::Kind::Transparent(_) | materials::Kind::Dielectric(_));
        object.casts_shadows = !is_glass;
    }
}

fn unscaled(scene: &mut Scene) {
    scene.transparency.scales_radiance = false;
}

fn clear(scene: &mut Scene) {
    for material in &mut scene.materials {
        if let materials::Kind::Dielectric(glass) = &mut material.recipe {
            (glass.inside.absorption, glass.outside.absorption) = (Rgb::BLACK, Rgb::BLACK);
        }
    }
}

fn flat(scene: &mut Scene) {
    for object in &mut scene.objects {
        if let Kind::TessellatedSphere(TessellatedSphere { smooth, .. }) = &mut object.shape {
            *smooth = false;
        }
    }
}

fn without_bumps(scene: &mut Scene) {
    scene.materials.iter_mut().for_each(|material| material.bump = None);
}

fn one_octave_less(scene: &mut Scene) {
    for material in &mut scene.materials {
        let materials::Kind::Matte(matte) = &mut material.recipe else { panic!("{material:?}") };
        let textures::Paint::Textured(texture) = &mut matte.cd else { continue };
        let textures::Kind::Fbm(fbm) = &mut **texture else { panic!("{texture:?}") };
        fbm.noise.octaves -= 1;
    }
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
