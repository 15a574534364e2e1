//! What `explain` says about a pixel of the glass sphere, kept as text: kinds, order, and words.
//!
//! The numbers are checked elsewhere (`tests/chapters`); this golden shows changes of the text.

mod formulas;
mod paths;
mod shares;
mod sources;
mod unlit;

use std::path::Path;

use explain::{Outline, RecordedRay, Row};

use crate::prelude::*;
use testkit::same_text::{Printed, hold};

/// Holds the golden of this name to a text, up to the rounding of numbers.
fn reads_as_before(golden: &str, text: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("chapters/library/explain");
    hold(&folder.join(golden), text, Printed::Rounded);
}

#[test]
fn the_tree_of_a_pixel_of_the_glass_sphere_reads_as_before() {
    let mut scene =
        gallery::find("ch28/glass-sphere").map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(60, 60);
    scene.image.samples = 1;
    let world = World::build(&scene).expect("gallery scenes are valid");
    let explanation = explain::pixel(&scene, &world, [20, 15], None).expect("few rays");
    reads_as_before("glass_sphere.txt", &explanation.text(0.01, false));
}

/// Two nested glass spheres over a matte one, seen off their axis: a tree of many rays of which few
/// carry light.
fn nested_glass() -> RecordedRay {
    nested_glass_of(Rgb::BLACK)
}

/// The same of glass with this absorption per unit length.
fn nested_glass_of(absorption: Rgb) -> RecordedRay {
    let lens = Orthographic { zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.3, 0.2, 10.0), Point::new(0.3, 0.2, 0.0), lens);
    let mut scene = Scene::new("", Image::new(1, 1), camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 7 });
    scene.background = Rgb::new(0.2, 0.4, 0.8).into();
    let glass = |inside, outside| Dielectric { inside, outside, ..Dielectric::default() };
    let [water, crown] = [1.33, 1.52].map(|eta| Medium { eta, absorption });
    scene.materials = vec![
        Material::new("outer", glass(crown, Medium::default())),
        Material::new("inner", glass(water, crown)),
        Material::new("chalk", Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() }),
    ];
    let ball = |radius, z| Sphere { center: Point::new(0.0, 0.0, z), radius, inward: false };
    scene.objects = vec![
        Object::new("outer", "outer", ball(1.0, 0.0)),
        Object::new("inner", "inner", ball(0.7, 0.0)),
        Object::new("chalk", "chalk", ball(1.0, -3.0)),
    ];
    let world = World::build(&scene).expect("the scene is valid");
    explain::sample(&scene, &world, [0, 0], 0).ray.expect("the camera sees all its film")
}

fn all(ray: &RecordedRay) -> Vec<&RecordedRay> {
    std::iter::once(ray).chain(ray.children.iter().flat_map(all)).collect()
}

/// Law: a folded tree keeps every ray with at least the requested share, gives the number and the share of
/// the others, and loses none. Oracle: all rays of the tree, counted one by one.
#[test]
fn what_is_folded_is_counted() {
    let glass = nested_glass();
    let rays = all(&glass).len();
    assert!(rays > 100, "the tree of nested glass has {rays} rays, expected more than 100");
    assert_folds(&glass);
    let lamps = many_lamps();
    let weak = lamps.children.iter().filter(|child| child.share < 0.1).count();
    assert!(weak >= 3, "the ray has {weak} weak children, expected at least 3");
    assert_folds(&lamps);
}

/// A matte floor under many lamps, each with two thirds of the light of the one before.
fn many_lamps() -> RecordedRay {
    let mut scene = stage(Rgb::BLACK);
    let floor = Plane { point: Point::ORIGIN, normal: Vector::Z };
    put(&mut scene, floor, Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() });
    for k in 0..60 {
        let location = Point::new(0.01 * f64::from(k), 0.0, 2.0);
        let ls = groundtruth::math::power(2.0 / 3.0, f64::from(k));
        shine(&mut scene, lights::PointLight { ls, color: Rgb::WHITE, location, attenuation: 0.0 });
    }
    let world = built(&scene);
    explain::sample(&scene, &world, [0, 0], 0).ray.expect("the camera sees all its film")
}

fn assert_folds(root: &RecordedRay) {
    let rays = all(root);
    assert_eq!(
        rays.iter().map(|ray| ray.number).collect::<Vec<_>>(),
        (0..rays.len()).collect::<Vec<_>>()
    );
    for min_share in [0.0, 0.001, 0.01, 0.1] {
        let (mut shown, mut hidden, mut folding) = (Vec::new(), 0, Vec::new());
        for row in Outline::folding_below(min_share).rows(root) {
            match row {
                Row::Ray { ray, .. } => shown.push(ray.number),
                Row::Local { .. } => {}
                Row::Folded { parent, rays: count, share, .. } => {
                    hidden += count;
                    folding.push(parent);
                    let small: Vec<_> =
                        rays[parent].children.iter().filter(|c| c.share < min_share).collect();
                    assert_eq!(count, small.iter().map(|child| all(child).len()).sum::<usize>());
                    let sum: f64 = small.iter().map(|child| child.share).sum();
                    assert!((share - sum).abs() < 1e-15, "{share} of hidden rays, not {sum}");
                }
            }
        }
        assert_eq!(shown.len() + hidden, rays.len(), "{min_share}");
        // folding a single ray saves no line
        for number in &shown {
            let weak = rays[*number].children.iter().filter(|child| child.share < min_share);
            let weak: usize = weak.map(|child| all(child).len()).sum();
            assert_eq!(folding.contains(number), weak > 1, "{weak} weak rays below ray {number}");
        }
        assert_eq!(hidden == 0, min_share == 0.0);
        let large = rays.iter().filter(|ray| ray.share >= min_share);
        assert!(large.map(|ray| ray.number).all(|number| shown.contains(&number)));
        // few rays matter: what carries the light is near the top
        assert!(min_share < 0.01 || shown.len() < 20, "{} rows", shown.len());
    }
}

/// Law: revealing a ray opens the rows that hide it. Oracle: the rows before and after.
#[test]
fn a_hidden_ray_is_revealed() {
    let root = nested_glass();
    let mut outline = Outline::folding_below(0.05);
    let is_shown = |outline: &Outline, number: usize| {
        outline
            .rows(&root)
            .iter()
            .any(|row| matches!(row, Row::Ray { ray, .. } if ray.number == number))
    };
    let numbers = all(&root).into_iter().map(|ray| ray.number);
    let hidden = numbers.rev().find(|&number| !is_shown(&outline, number)).expect("some are small");
    outline.reveal(&root.path_to(hidden));
    assert!(is_shown(&outline, hidden));
    outline.closed.insert(0);
    assert_eq!(outline.rows(&root).len(), 1);
    outline.reveal(&root.path_to(hidden));
    assert!(is_shown(&outline, hidden));
}

/// Law: mean, standard error, least and greatest are those of the samples. Oracle: the sums written
/// out, on a pixel at the rim of the sphere.
#[test]
fn the_samples_statistics_are_theirs() {
    let mut scene = (gallery::find("ch28/glass-sphere").expect("listed").build)();
    scene.image.resize(48, 48);
    scene.image.samples = 16;
    let world = World::build(&scene).expect("gallery scenes are valid");
    let explained = explain::pixel(&scene, &world, [7, 20], Some(3)).expect("few rays");
    let reds: Vec<f64> = explained.radiances.iter().map(|radiance| radiance.r).collect();
    let mean = reds.iter().sum::<f64>() / 16.0;
    let squares: f64 = reds.iter().map(|red| (red - mean) * (red - mean)).sum();
    let statistics = explained.statistics;
    let error = statistics.standard_error.expect("more than one sample").r;
    let found = statistics.mean.r;
    assert!((found - mean).abs() < 1e-14, "the mean is {found}, not {mean}");
    assert!(error > 1e-3 && (error - (squares / 15.0 / 16.0).sqrt()).abs() < 1e-14, "{error}");
    let value = |index: u32| explained.radiances[index as usize].average();
    let [least, greatest] = [statistics.least, statistics.greatest].map(value);
    for i in 0..16 {
        let range = least..=greatest;
        assert!(range.contains(&value(i)), "sample {i} is {}, not in {range:?}", value(i));
    }
    assert_eq!(explained.samples[0].radiance, explained.radiances[3]);
}

/// A floor under water, lit from two above and seen from one above.
const UNDER_WATER: &str = include_str!("explain/under_water.toml");

/// Law: the lines of a shadow ray give the light that it found and what the medium left of it. Oracle: Beer's
/// law, `exp(−2σ)`: 0.368 and 0.607.
#[test]
fn a_shadow_ray_says_what_the_medium_absorbs() {
    let path = std::path::Path::new("under_water.toml");
    let (scene, world) = scenefile::from_toml(UNDER_WATER, path).expect("it is valid");
    let explained = explain::pixel(&scene, &world, [0, 0], None).expect("few rays");
    let text = explained.text(0.0, false);
    let shadow: Vec<&str> = text.lines().skip_while(|line| !line.contains("shadow ray")).collect();
    assert!(shadow[2].ends_with("+ 3  light \"lamp\": weight 1 × light 3"), "{text}");
    assert!(shadow[3].ends_with("× (0.368, 0.607, 1)  through the medium"), "{text}");
}
