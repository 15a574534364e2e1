//! What a proposal takes for granted, names, and borders of comparisons.

use golden::compare::{differences, verdict};
use golden::{GoldenSettings, GoldenStatus, Goldens, View, leaf};
use groundtruth::film::Film;
use groundtruth::math::Pcg32;
use groundtruth::rgb::Rgb;
use groundtruth::trace::Outcome;
use groundtruth::world::World;

/// Law: a golden that says nothing of its size is 96 pixels wide, in the form of its scene, with at most 4 samples, one
/// for other views; what is said replaces it, and accepting again keeps what was said before. Oracle: `round(96 h /
/// w)`.
#[test]
fn a_proposal_takes_for_granted_what_is_documented() {
    let folder = tempfile::tempdir().expect("a folder");
    let goldens = Goldens::none(folder.path());
    for entry in gallery::scenes() {
        let image = (entry.build)().image;
        let height = (96.0 * f64::from(image.height) / f64::from(image.width)).round() as u32;
        for view in View::ALL {
            let name = format!("{}{}", entry.name, view.suffix());
            let first = golden::Golden::first_version(&name, folder.path()).expect("a scene");
            let samples = if view == View::Radiance { image.samples.min(4) } else { 1 };
            let found = (first.name(), first.view, first.size, first.samples);
            assert_eq!(found, (name, view, [96, height], samples), "name, view, size and samples");
        }
    }
    let settings = GoldenSettings {
        size: Some([7, 5]),
        samples: Some(9),
        shows: Some("three balls".to_owned()),
    };
    let mut goldens = goldens;
    let name = "ch03/three-objects";
    let first = goldens.propose(name, "  seen \n", &settings).expect("a scene");
    let found =
        (first.golden.size, first.golden.samples, &*first.golden.shows, &*first.golden.because);
    assert_eq!(found, ([7, 5], 9, "three balls", "seen"), "size, samples, what it shows and why");
    assert_eq!((first.film.width(), first.film.height()), (7, 5), "the size of the picture");
    goldens.accept(vec![first]).expect("it is written");
    let again = goldens.propose(name, "again", &GoldenSettings::default()).expect("a scene");
    let found =
        (again.golden.size, again.golden.samples, &*again.golden.shows, &*again.golden.because);
    assert_eq!(
        found,
        ([7, 5], 9, "three balls", "again"),
        "what was said before, and the new reason"
    );
}

/// Law: goldens are sorted by name, and one that is accepted again is there once, as it was accepted last; names are those of
/// the manifest and of the gallery, each once. Oracle: a sorted list.
#[test]
fn goldens_are_sorted_and_there_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut goldens = Goldens::none(folder.path());
    let names = ["ch16/shadows", "ch03/three-objects.hits", "ch03/three-objects", "ch16/shadows"];
    for (index, name) in names.into_iter().enumerate() {
        let side = 4 + index as u32;
        let settings = GoldenSettings { size: Some([side, 3]), ..GoldenSettings::default() };
        let proposal = goldens.propose(name, "seen", &settings).expect("a scene");
        goldens.accept(vec![proposal]).expect("it is written");
    }
    let read = Goldens::open(folder.path()).expect("a manifest");
    for goldens in [&goldens, &read] {
        let found: Vec<(String, u32)> =
            goldens.all().iter().map(|it| (it.name(), it.size[0])).collect();
        let expected =
            [("ch03/three-objects", 6), ("ch03/three-objects.hits", 5), ("ch16/shadows", 7)];
        assert_eq!(found, expected.map(|(name, side)| (name.to_owned(), side)), "names and widths");
    }
    let mut expected: Vec<String> = gallery::scenes().map(|it| it.name.to_owned()).collect();
    expected.push("ch03/three-objects.hits".to_owned());
    expected.sort();
    assert_eq!(read.names(), expected, "all names");
}

/// Law: the name of a golden is that of its scene and view; a path of a scene file counts without its folders. Oracle: names by
/// hand.
#[test]
fn names_are_divided_into_scene_and_view() {
    for (name, view, scene) in [
        ("ch03/three-objects", View::Radiance, "ch03/three-objects"),
        ("ch03/three-objects.hits", View::Hits, "ch03/three-objects"),
        ("ch03/three-objects.normals", View::Normals, "ch03/three-objects"),
        ("a/b.toml.hits", View::Hits, "a/b.toml"),
        ("x.hits.normals", View::Normals, "x.hits"),
        ("hits", View::Radiance, "hits"),
    ] {
        assert_eq!(View::split(name), (view, scene), "view and scene of {name}");
    }
    for (name, expected) in [
        ("a/b/c.toml", "c.toml"),
        ("a/b/c.toml.hits", "c.toml.hits"),
        ("c.toml", "c.toml"),
        ("ch03/three-objects", "ch03/three-objects"),
        ("a/toml", "a/toml"),
    ] {
        assert_eq!(leaf(name), expected, "the name without folders of {name}");
    }
}

fn film(width: u32, height: u32, of: impl Fn(u32, u32) -> Rgb) -> Film {
    let mut film = Film::new(width, height);
    for y in 0..height {
        for x in 0..width {
            film.set([x, y], of(x, y));
        }
    }
    film
}

/// Law: the verdict is *drift* if each channel differs by at most 10⁻⁶ of the larger size, whatever signs and sizes.
/// Oracle: the inequality in double precision, for pairs of single-precision numbers on both sides of the border.
#[test]
fn drift_is_relative_for_all_sizes_and_signs() {
    let mut random = Pcg32::new(77, 5);
    let mut seen = [0; 3];
    for _ in 0..400 {
        let a = (random.uniform() - 0.5) as f32
            * [1e-30_f32, 1e-3, 1.0, 1e20][random.below(4) as usize];
        let steps = random.below(16);
        let b = f32::from_bits(a.to_bits() + steps);
        let b = if random.below(8) == 0 { -b } else { b };
        let [wide_a, wide_b] = [a, b].map(f64::from);
        let expected = match (a.to_bits() == b.to_bits(), (wide_a - wide_b).abs()) {
            (true, _) => GoldenStatus::Same,
            (_, off) if off <= 1e-6 * wide_a.abs().max(wide_b.abs()) => GoldenStatus::Drift,
            _ => GoldenStatus::Changed,
        };
        let pictures =
            [wide_a, wide_b].map(|x| film(2, 1, |at, _| Rgb::grey(if at == 1 { x } else { 0.5 })));
        assert_eq!(verdict(&pictures[0], &pictures[1]), expected, "the verdict of {a:e} and {b:e}");
        seen[expected as usize] += 1;
    }
    assert!(seen.iter().all(|n| *n > 20), "verdicts seen: {seen:?}");
}

/// Law: bits are compared, not values; what is not a number is never drift, and the worst; other sizes are a change.
/// Oracle: pictures by hand.
#[test]
fn what_is_not_a_number_is_the_worst() {
    let grey = film(8, 6, |_, _| Rgb::grey(0.5));
    let mut other = film(8, 6, |_, _| Rgb::grey(0.5));
    other.set([1, 2], Rgb::grey(9.0));
    other.set([3, 0], Rgb::new(0.5, f64::NAN, 0.5));
    assert_eq!(verdict(&grey, &other), GoldenStatus::Changed, "NaN against a number");
    assert_eq!(verdict(&other, &other), GoldenStatus::Same, "the same bits");
    let found: Vec<_> = differences(&grey, &other).iter().map(|d| d.pixel).collect();
    assert_eq!(found, [[3, 0], [1, 2]], "the worst first");
    let [wide, high] = [[8, 6], [6, 8]].map(|[width, height]| Film::new(width, height));
    assert_eq!(verdict(&wide, &high), GoldenStatus::Changed, "another size");
}

/// Law: differing pixels are listed with their place, both colours and their largest channel's difference, the largest
/// first, and equal ones by rows. Oracle: the differences, set by hand in another order.
#[test]
fn differences_are_sorted_and_equal_ones_stay_in_order() {
    let good = film(4, 3, |_, _| Rgb::grey(1.0));
    let off = [([3, 0], 0.25), ([0, 1], 0.5), ([2, 1], 0.25), ([1, 2], -0.5), ([3, 2], 0.125)];
    let bad = film(4, 3, |x, y| {
        let by = off.iter().find(|it| it.0 == [x, y]).map_or(0.0, |it| it.1);
        let mut color = [1.0; 3];
        // the largest difference is in another channel each time
        color[(x + y) as usize % 3] += by;
        color[(x + y + 1) as usize % 3] -= 0.5 * by;
        color.into()
    });
    let found: Vec<([u32; 2], f64)> =
        differences(&good, &bad).iter().map(|it| (it.pixel, it.size)).collect();
    let expected = [([0, 1], 0.5), ([1, 2], 0.5), ([3, 0], 0.25), ([2, 1], 0.25), ([3, 2], 0.125)];
    assert_eq!(found, expected, "pixels and sizes of differences");
    let first = differences(&good, &bad)[0];
    assert_eq!((first.expected, first.got), ([1.0; 3], [1.0, 1.5, 0.75]), "both colours");
}

/// Law: the picture of hits has t, the object's place from 1, and the number of rays that were cast, of the first
/// sample; that of normals the normal there; both are 0 where nothing is hit. Oracle: the recorded tree of that sample.
#[test]
fn views_are_those_of_the_recorded_tree() {
    for name in ["ch24/hall-of-mirrors", "ch16/shadows", "ch28/glass-sphere"] {
        let mut scene = (gallery::find(name).expect("a scene").build)();
        scene.image.resize(9, 6);
        scene.image.samples = 4;
        let world = World::build(&scene).expect("it is valid");
        let [normals, hits] = [View::Normals, View::Hits].map(|view| view.render(&world));
        let mut most = 0;
        for y in 0..6 {
            for x in 0..9 {
                let root = explain::sample(&scene, &world, [x, y], 0).ray.expect("a ray");
                let is_cast = |outcome: Outcome| outcome != Outcome::TooDeep;
                let rays = root.rays().iter().filter(|ray| is_cast(ray.outcome)).count();
                let hit = root.hit.as_ref();
                let place = |name: &str| {
                    let names = world.names.objects.iter();
                    names.map(|it| &**it).position(|it| it == name).map_or(0, |at| at + 1)
                };
                let object = hit.map_or(0, |hit| place(&hit.object));
                let expected = [hit.map_or(0.0, |hit| hit.t), object as f64, rays as f64];
                let found = hits.get([x, y]).to_array();
                assert_eq!(found, expected, "t, object and rays of {name} at {x}, {y}");
                let expected = hit.map_or([0.0; 3], |hit| hit.normal.to_array());
                assert_eq!(
                    normals.get([x, y]).to_array(),
                    expected,
                    "normal of {name} at {x}, {y}"
                );
                most = most.max(rays);
            }
        }
        assert!(most > 1, "rays of the largest tree of {name}: {most}");
    }
}

/// Law: for eyes a picture of normals is moved into 0 … 1, one of hits has each channel over its largest value, and the picture
/// itself stays. Oracle: these formulas, with a channel that is 0 everywhere.
#[test]
fn pictures_for_eyes_are_scaled_by_channel() {
    for turn in 0..3 {
        let turned = |[a, b, c]: [f64; 3]| {
            let mut color = [a, b, c];
            color.rotate_right(turn);
            color
        };
        let numbers = film(3, 2, |x, y| Rgb::from(turned([f64::from(x), f64::from(4 * y), 0.0])));
        for [x, y] in (0..6).map(|at| [at % 3, at / 3]) {
            let at = |view: View| view.for_eyes(&numbers).get([x, y]).to_array();
            let [a, b] = [f64::from(x), f64::from(4 * y)];
            assert_eq!(at(View::Radiance), turned([a, b, 0.0]), "the picture at {x}, {y}");
            assert_eq!(at(View::Hits), turned([a / 2.0, b / 4.0, 0.0]), "hits at {x}, {y}");
            let normals = turned([0.5 + 0.5 * a, 0.5 + 0.5 * b, 0.5]);
            assert_eq!(at(View::Normals), normals, "normals at {x}, {y}");
        }
    }
}
