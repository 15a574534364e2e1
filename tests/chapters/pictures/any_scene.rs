//! What must hold for every picture: laws tested on random scenes.

use std::collections::HashSet;
use std::mem::{Discriminant, discriminant};

use groundtruth::render::render;
use scenefile::from_toml;
use scenefile::to_toml;

use super::random_scenes::{scene, textured_scene};
use super::studio::gallery_in_small;
use crate::prelude::*;
use crate::support::number;
use testkit::scaling::scaled_scene;

fn same(color: Rgb) -> Rgb {
    color
}

/// Fails if any pixel of the scene's picture is negative, infinite or NaN, with its own tracer or with a path
/// tracer.
fn assert_sound(number: u64) -> Film {
    let scene = any(number);
    let depth = Depth { max_depth: (number % 6) as u32 };
    let paths = [Tracer::PathTrace(depth), Tracer::GlobalTrace(depth), Tracer::Path(depth)];
    assert_sound_by(number, &Scene { tracer: paths[(number % 3) as usize], ..scene.clone() });
    assert_sound_by(number, &scene)
}

fn assert_sound_by(number: u64, scene: &Scene) -> Film {
    let film = render(&built(scene));
    for at in pixels(8, 8) {
        let sound = film.get(at).to_array().iter().all(|c| c.is_finite() && *c >= 0.0);
        assert!(
            sound,
            "scene {number}, pixel {at:?} is {:?}, expected finite and at least 0",
            film.get(at)
        );
    }
    film
}

/// Scenes in each law here.
const SCENES: u64 = 200;

/// Law: no pixel of any valid scene is negative, infinite or NaN. The scenes are varied enough to test this:
/// most of their pictures are not black, and all kinds of light and material occur. Oracle: the definition of
/// radiance.
#[test]
fn no_picture_has_negative_or_infinite_light() {
    let (mut bright, mut lights, mut made_of) = (0, HashSet::new(), HashSet::new());
    let mut shapes = HashSet::new();
    let scenes = as_many(SCENES, 100_000);
    for number in 0..scenes {
        let film = assert_sound(number);
        bright += u64::from(film.pixels().iter().any(|pixel| !pixel.is_black()));
        let scene = scene(number, &same);
        let kinds = scene.lights.iter().map(|light| discriminant(&light.source));
        lights.extend(kinds.collect::<Vec<Discriminant<lights::Kind>>>());
        made_of.extend(scene.materials.iter().map(|material| discriminant(&material.recipe)));
        for object in &scene.objects {
            if let shapes::Kind::Instance(instance) = &object.shape {
                shapes.insert(discriminant(&*instance.of));
            }
        }
    }
    assert!(bright > scenes * 4 / 5, "{bright} of {scenes} pictures show anything");
    assert_eq!(lights.len(), lights::Kind::ENTRIES.len(), "kinds of light in {SCENES} scenes");
    assert_eq!(made_of.len(), materials::Kind::ENTRIES.len(), "kinds of material");
    assert!(shapes.len() + 3 > shapes::Kind::ENTRIES.len(), "{} kinds of shape", shapes.len());
}

/// Law: red, green and blue are independent: permuting the channels of all colours permutes the channels of
/// the picture, bit for bit. Oracle: the original picture.
#[test]
fn channels_are_independent() {
    let round = |color: Rgb| Rgb::new(color.b, color.r, color.g);
    for number in 0..SCENES {
        let [before, after] =
            [&same as &dyn Fn(Rgb) -> Rgb, &round].map(|tint| render(&built(&scene(number, tint))));
        for at in pixels(8, 8) {
            let (found, expected) = (after.get(at), round(before.get(at)));
            assert!(
                bits(found) == bits(expected),
                "scene {number}, {at:?}: {found:?}, expected {expected:?}"
            );
        }
    }
}

/// Law: a picture is linear in each light: with twice the strength of one light, its contribution is twice as
/// much. Oracle: the picture with the light's strength set to 0, and the difference; lamps are visible, so
/// the strength of their material is what is scaled.
#[test]
fn pictures_are_linear_in_each_light() {
    /// Sums of some hundred terms, and their difference.
    const ROUNDING: f64 = 1e-12;
    let mut tested = 0;
    for number in 0..SCENES / 2 {
        let scene = scene(number, &same);
        for which in 0..scene.lights.len() {
            let with = |factor: f64| {
                let mut scene = scene.clone();
                scaled(&mut scene, which, factor).then(|| render(&built(&scene)))
            };
            let [Some(none), Some(once), Some(twice)] = [0.0, 1.0, 2.0].map(with) else { continue };
            tested += 1;
            for at in pixels(8, 8) {
                let [none, once, twice] =
                    [&none, &once, &twice].map(|film| film.get(at).to_array());
                for i in 0..3 {
                    let (found, expected) = (twice[i] - none[i], 2.0 * (once[i] - none[i]));
                    let apart = (found - expected).abs();
                    assert!(
                        apart <= ROUNDING * twice[i].max(1.0),
                        "scene {number}, light {which}, {at:?}, channel {i}: twice the strength adds {found}, \
                         expected {expected}, apart by {apart:e}"
                    );
                }
            }
        }
    }
    assert!(tested > 100, "{tested} lights");
}

/// Multiplies the strength of a light; `false` for the sky, which has no strength of its own.
fn scaled(scene: &mut Scene, which: usize, factor: f64) -> bool {
    match &mut scene.lights[which].source {
        lights::Kind::Ambient(light) => light.ls *= factor,
        lights::Kind::AmbientOccluder(light) => light.ls *= factor,
        lights::Kind::Directional(light) => light.ls *= factor,
        lights::Kind::PointLight(light) => light.ls *= factor,
        lights::Kind::Spot(light) => light.ls *= factor,
        lights::Kind::JitteredDirectional(light) => light.ls *= factor,
        lights::Kind::FakeSpherical(light) => light.ls *= factor,
        lights::Kind::Area(area) => {
            let lamp = scene.materials.iter_mut().find(|material| material.name == area.object);
            let Some(Material { recipe: materials::Kind::Emissive(emissive), .. }) = lamp else {
                return false;
            };
            emissive.ls = (factor * number(&emissive.ls)).into();
        }
        _ => return false,
    }
    true
}

/// Law: at every hit each light of the scene either adds light or says once why not, and a ray, but for
/// shadow rays, says why it is black exactly if it is. A light that adds nothing at any hit of a sample can be
/// switched off without a change of the sample. Oracle: the terms, and the sample of the scene without that
/// light; lamps and the sky stay on, since they are seen, too.
#[test]
fn every_light_adds_light_or_says_why_not() {
    let (mut unlit, mut switched_off) = (0, 0);
    for number in 0..SCENES {
        let scene = any(number);
        let world = built(&scene);
        for at in [[1, 2], [3, 4], [4, 3], [6, 5]] {
            let sample = explain::sample(&scene, &world, at, 0);
            let Some(root) = sample.ray else { continue };
            let mut idle: HashSet<&str> = scene.lights.iter().map(|it| it.name.as_str()).collect();
            let mut rays = vec![&root];
            while let Some(ray) = rays.pop() {
                rays.extend(&ray.children);
                if matches!(ray.kind, RayKind::Shadow { .. }) {
                    assert!(ray.unlit.is_empty() && ray.black.is_none(), "scene {number}, {at:?}");
                    continue;
                }
                assert_eq!(ray.black.is_some(), ray.radiance.is_black(), "scene {number}, {at:?}");
                assert!(ray.black.as_ref().is_none_or(|zeros| !zeros.is_empty()), "{ray:?}");
                for light in &scene.lights {
                    let adds = ray.terms.iter().any(|term| {
                        term.light.as_deref() == Some(&light.name) && !term.value.is_black()
                    });
                    let reasons = ray.unlit.iter().filter(|it| *it.light == *light.name).count();
                    let is_hit = ray.hit.is_some();
                    let expected = usize::from(is_hit && !adds);
                    assert_eq!(reasons, expected, "scene {number}, {at:?}, {}", light.name);
                    unlit += reasons;
                    if adds {
                        idle.remove(light.name.as_str());
                    }
                }
            }
            let idle = idle.into_iter().find(|name| {
                let light = scene.lights.iter().find(|light| light.name == *name);
                light.is_some_and(|light| {
                    !matches!(light.source, lights::Kind::Area(_) | lights::Kind::Environment(_))
                })
            });
            let Some(name) = idle.map(ToOwned::to_owned) else { continue };
            let mut off = scene.clone();
            for light in off.lights.iter_mut().filter(|light| light.name == name) {
                light.enabled = false;
            }
            let without = render::sample(&built(&off), at, 0, &mut ());
            assert_eq!(bits(without), bits(sample.radiance), "scene {number}, {at:?}, {name}");
            switched_off += 1;
        }
    }
    assert!(unlit > 1000 && switched_off > 100, "{unlit}, {switched_off}");
}

/// A random scene; every other one has textures.
fn any(number: u64) -> Scene {
    if number.is_multiple_of(2) { textured_scene(number) } else { scene(number, &same) }
}

/// Random scenes, and all of the gallery in small.
pub fn all() -> impl Iterator<Item = (String, Scene)> {
    let random =
        (0..as_many(SCENES / 2, SCENES)).map(|number| (format!("scene {number}"), any(number)));
    random.chain(gallery_in_small(1).map(|(name, scene)| (name.to_owned(), scene)))
}

/// Law: no absolute length matters (an absolute epsilon anywhere would): all lengths times a power of two give the
/// same picture, and so do list, grid and bvh, and the scene exported and read again, whose text is the same.
/// Oracle: the scene as it is, bit for bit.
#[test]
fn scale_acceleration_and_export_do_not_matter() {
    for (i, (name, mut scene)) in all().enumerate() {
        let original = render(&built(&scene));
        for &k in as_many(&[[-30], [5]][i % 2][..], &[-30, -3, 5, 30]) {
            let scaled = render(&built(&scaled_scene(&scene, k)));
            assert_same_bits(&format!("{name} times 2^{k}"), &scaled, &original);
        }
        let text = to_toml(&scene).expect("plain data");
        let (again, world) = from_toml(&text, Path::new("scene.toml")).expect("it reads back");
        assert_same_bits(&format!("{name}, read again"), &render(&world), &original);
        assert_eq!(to_toml(&again).expect("plain data"), text, "{name}");
        let own = scene.accel;
        let others = Method::ALL.into_iter().filter(|&it| it != own);
        for method in others.skip(as_many(i / 2 % 2, 0)).take(as_many(1, 2)) {
            scene.accel = method;
            let picture = render(&built(&scene));
            assert_same_bits(&format!("{name}, {method:?}"), &picture, &original);
        }
    }
}
