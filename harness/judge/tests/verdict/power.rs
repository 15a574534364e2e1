//! Which defects are found.

use groundtruth::film::Film;
use groundtruth::math::hash;
use groundtruth::render;
use judge::verdict::{Areas, Decision};
use pictures::compare;
use testkit::as_many;

use super::pictures::{scene, world};
use super::shared::{FLOATS, Shared, mapped};

/// The picture of a program with a defect, from one of our films and its seed.
type Defect<'a> = (&'static str, Box<dyn Fn(&Film, u64) -> Film + 'a>);

/// The film with the pixels that are wanted this many times as bright.
fn brighter(film: &Film, factor: f64, wanted: impl Fn([u32; 2]) -> bool) -> Film {
    mapped(film, |at, color| if wanted(at) { factor * color } else { color })
}

fn brighter_patch(film: &Film, seed: u64) -> Film {
    let last = u64::from(film.width()) - 16;
    let corner = [0, 1].map(|along| (hash(&[seed, along]) % (last + 1)) as u32);
    let is_inside =
        |at: [u32; 2]| at.iter().zip(corner).all(|(at, corner)| (corner..corner + 16).contains(at));
    brighter(film, 1.3, is_inside)
}

/// The film of a scene whose film points lie half a pixel to the right of, and below, the centres.
pub fn half_a_pixel_off(name: &str, [side, samples]: [u32; 2], seed: u64) -> Film {
    let mut world = world(&scene(name, [side; 2], samples), seed);
    let [x, y] = compare::shift(&mut world, [1, 1]);
    let canvas = render::Canvas::cropped(render::Crop { x, y, width: side, height: side });
    canvas.render(&world);
    canvas.film()
}

/// The defects that are planted in a scene's pictures.
fn defects<'a>(name: &'a str, size: [u32; 2], areas: &'a Areas) -> Vec<Defect<'a>> {
    let objects = (0..).zip(&areas.objects).filter(|(_, it)| &*it.0 != "the background");
    let largest: u32 = objects.max_by_key(|(_, it)| it.1).expect("it has objects").0;
    let is_inside =
        move |[x, y]: [u32; 2]| areas.object_of[y as usize * areas.size[0] + x as usize] == largest;
    vec![
        ("1 % everywhere", Box::new(|film, _| brighter(film, 1.01, |_| true))),
        ("a patch of 16 × 16, 1.3 times as bright", Box::new(brighter_patch)),
        ("half a pixel off", Box::new(move |_, seed| half_a_pixel_off(name, size, seed))),
        ("10 % in the largest object", Box::new(move |film, _| brighter(film, 1.1, is_inside))),
    ]
}

/// For each defect of a scene, in how many of `seeds` it is found; printed.
fn found(name: &str, [side, samples]: [u32; 2], seeds: u64) -> Vec<(&'static str, u64)> {
    let shared = Shared::usual(name, [side, samples, 99]);
    let mut world = world(&scene(name, [side; 2], samples), 1);
    let defects = defects(name, [side, samples], &shared.areas);
    let mut found = vec![0; defects.len()];
    for seed in 0..seeds {
        world.reseed(50_000 + seed);
        let film = render::render(&world);
        for ((_, defect), found) in defects.iter().zip(&mut found) {
            let theirs = defect(&film, 50_000 + seed);
            let decision = shared.judged(&world, &theirs, FLOATS, seed).decision;
            *found += u64::from(decision == Decision::Differs);
        }
    }
    let found = defects.iter().map(|(what, _)| *what).zip(found).collect();
    println!("{name}: found in so many of {seeds}: {found:?}");
    found
}

/// Scenes with noise of all sorts; the last three are path tracers.
const SCENES: [&str; 10] = [
    "ch05/lamp",
    "ch10/near-focus",
    "ch17/sphere",
    "ch18/rectangle",
    "ch18/environment",
    "ch18/page-one",
    "ch25/glossy-hall",
    "ch26/dome",
    "ch26/cornell-box",
    "ch26/mirror-caustic",
];

/// Law: in pictures with noise a gain of 1 % everywhere, of 10 % in the largest object, a patch of 16 × 16 that is 1.3 times as
/// bright, and film points half a pixel off are found: for two seeds, or in 95 of 100 with 128 × 128 pixels and 64 samples.
/// Oracle: the defect that was planted.
#[test]
fn defects_are_found() {
    let (scenes, size, seeds, least) =
        as_many((&SCENES[3..4], [64, 16], 2, 2), (&SCENES[..], [128, 64], 100, 95));
    for scene in scenes {
        for (what, times) in found(scene, size, seeds) {
            assert!(times >= least, "{scene}, {what}: found in {times} of {seeds}");
        }
    }
}
