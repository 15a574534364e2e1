//! Pictures whose samples are alike in all pixels, and what is shown of pixels that are set apart.

use groundtruth::film::Film;
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::samplers::{self, Regular};
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use judge::verdict::{self, Decision};
use pictures::compare::Picture;

use super::cases::{STRICTNESS, verdict};
use super::pictures::{film, scene, with_sampler};
use super::shared::mapped;

const SIDE: u32 = 15;

/// The row that the horizon halves.
const HORIZON: u32 = 7;

/// A matte ball on a matte ground before a black sky; half of each pixel of the middle row is ground.
fn horizon(samples: u32) -> Scene {
    seen(samples, SIDE, 0.0)
}

/// The same, of so many pixels; the camera looks so far down at the ball, by which the horizon rises.
fn seen(samples: u32, side: u32, down: f64) -> Scene {
    let view = [point(0.0, 0.0, 10.0), point(0.0, -down, 0.0)];
    let mut scene = pinhole("a horizon", [side; 2], view, 15.0);
    scene.image.samples = samples;
    add(&mut scene, "ball", sphere(Point::ORIGIN, 1.5), matte(0.0, 0.5, Rgb::WHITE));
    add(&mut scene, "ground", ground(-1.5), matte(0.0, 0.5, Rgb::WHITE));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 2.0), 3.0));
    scene
}

fn theirs(scene: &Scene) -> Film {
    film(scene, 500)
}

fn judged(scene: &Scene, theirs: &Film) -> verdict::Verdict {
    verdict(scene, &[Picture::of_film(theirs)], STRICTNESS)
}

/// Law: a pixel that all of ours halve may have any other share of its samples' colours: it is set apart, and the pictures,
/// means and page show it as it is in the file; a value beyond its samples' counts. Oracle: the value that was written.
#[test]
fn theirs_is_shown_as_it_is_in_the_file() {
    let (scene, at) = (horizon(16), [1, HORIZON]);
    let with = |factor: f64| {
        let mut film = theirs(&scene);
        film.set(at, factor * film.get(at));
        film
    };
    let (index, film) = ((HORIZON * SIDE + at[0]) as usize, with(1.5));
    let possible = judged(&scene, &film);
    assert!(!possible.fixed, "the ball's edge has noise");
    assert_eq!((possible.set_apart, &*possible.shown.excluded), (1, &[index][..]), "{possible}");
    assert_eq!(possible.shown.theirs.values, Picture::of_film(&film).values);
    let red = film.pixels().iter().map(|it| it.to_array()[0]).sum::<f64>() / f64::from(SIDE * SIDE);
    assert!((possible.means[0].theirs[0] - red).abs() < 1e-6, "{possible}");
    let [verdict, details, next] = [""; 3].map(str::to_owned);
    let told = text::told::Told { verdict, details, next };
    let page = verdict::page(&possible, "a picture", &told);
    assert!(page.contains("<h2>Not counted</h2>") && page.contains("M1 7l1 1"), "hatched");
    let impossible = judged(&scene, &with(2.5));
    assert_eq!(impossible.set_apart, 0, "{impossible}");
    assert!(!verdict::page(&impossible, "a picture", &told).contains("<svg"));
}

/// Law: a correct picture with regular samples, or one at the centre of each pixel, is explained with the arguments that
/// make ours alike, and agrees with these; a wrong one is not explained so. Oracle: the sampler that it was rendered with.
#[test]
fn samples_alike_in_all_pixels_are_recognised() {
    let regular = || samplers::Kind::from(Regular {});
    // a fifth of a pixel above its middle
    let off = |samples| seen(samples, 31, 0.2 * 10.0 / 15.0);
    let mut differ = 0;
    let glass = scene("ch28/glass-sphere", [24; 2], 4);
    for (ours, samples, arguments) in [
        (off(4), 4, "`--their-sampler regular`"),
        (off(4), 1, "`--their-samples 1 --their-sampler regular`"),
        (off(16), 9, "`--their-samples 9 --their-sampler regular`"),
        (glass, 4, "`--their-sampler regular`"),
    ] {
        let mut alike = with_sampler(ours.clone(), regular());
        alike.image.samples = samples;
        let film = theirs(&alike);
        let verdict = judged(&ours, &film);
        if verdict.decision == Decision::Differs {
            differ += 1;
            let what =
                verdict.explained.as_ref().map(|it| (it.what.contains(arguments), it.agrees));
            assert_eq!(what, Some((true, true)), "{verdict}");
        }
        assert_eq!(judged(&alike, &film).decision, Decision::Agrees);
    }
    let brighter = mapped(&theirs(&off(4)), |_, color| 1.05 * color);
    let wrong = judged(&off(4), &brighter).explained;
    assert!(!wrong.is_some_and(|it| it.what.contains("--their-sampler")));
    assert!(differ >= 3, "only {differ} of 4 are unlike ours");
}

/// Law: if channels differ by other parts, each is said; if by the same, one percentage is. Oracle: the factors.
#[test]
fn each_channel_has_its_percentage() {
    let scene = horizon(4);
    let with = |factors: [f64; 3]| {
        let factors = Rgb::from(factors);
        judged(&scene, &mapped(&theirs(&scene), |_, color| factors * color))
    };
    let coloured = with([0.6, 1.3, 1.3]);
    for ((means, factor), name) in
        coloured.means[0].channels.iter().zip([0.6, 1.3, 1.3]).zip(["red −4", "green +", "blue +"])
    {
        let relative = means.relative.expect("ours is not black");
        assert!((relative + 1.0 - factor).abs() <= means.half + 1e-3, "{relative}");
        assert!(coloured.to_string().contains(name), "{coloured}");
    }
    let json = serde_json::to_value(&coloured).expect("JSON");
    assert!(json["means"][0]["channels"][2]["relative"].as_f64() > Some(0.2), "{json}");
    assert!(!with([1.2; 3]).to_string().contains("green +"));
    let huge = with([1e38; 3]).to_string();
    assert!(huge.lines().all(|line| line.len() < 400) && huge.contains("e39 %"), "{huge}");
}
