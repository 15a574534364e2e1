//! Two pictures compared: what counts as a difference, and which changes are named.

mod affected;
mod changed;
mod counted;
mod encoded;
mod films;
mod shown;
mod writers;

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use pictures::compare::{
    Comparison, Differences, Picture, SizesDiffer, half_pixel_shifts, noise_note,
};

use self::films::{SIZE, film_through, rendered, world};

fn picture() -> Picture {
    Picture::of_film(&rendered("ch24/hall-of-mirrors", 1))
}

/// The picture with the value at each position taken from another, which may be outside by a pixel; there the
/// edge is repeated.
fn moved(picture: &Picture, from: impl Fn(i64, i64) -> [i64; 2]) -> Picture {
    let [width, height] = picture.size.map(i64::from);
    let at = |x: i64, y: i64| {
        let [x, y] = from(x, y);
        let (x, y) = (x.clamp(0, width - 1), y.clamp(0, height - 1));
        picture.values[(y * width + x) as usize]
    };
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Picture { values: pixels.map(|(x, y)| at(x, y)).collect(), ..picture.clone() }
}

fn mapped(picture: &Picture, change: impl Fn([f32; 3]) -> [f32; 3]) -> Picture {
    Picture {
        values: picture.values.iter().map(|color| change(*color)).collect(),
        ..picture.clone()
    }
}

fn compared(a: &Picture, b: &Picture) -> Comparison {
    Comparison::of(a, b, 0.0).expect("one size")
}

/// The best explanation of a difference.
fn explanation(a: &Picture, b: &Picture) -> String {
    let comparison = compared(a, b);
    comparison.explained_by.first().map_or("none".to_owned(), |first| first.what.clone())
}

/// Law: equal pictures do not differ; noise of another seed and a change of another kind are not explained by
/// anything. Oracle: the changes that were made.
#[test]
fn honest_pairs_are_explained_by_nothing() {
    let ours = picture();
    assert!(compared(&ours, &ours).is_same());
    for name in ["ch18/rectangle", "ch17/page-one", "ch26/cornell-box"] {
        let Some(_) = gallery::find(name) else { continue };
        let [a, b] = [1, 2].map(|seed| Picture::of_film(&rendered(name, seed)));
        let comparison = compared(&a, &b);
        assert!(comparison.differing > 0 && comparison.explained_by.is_empty(), "{comparison}");
    }
    let other = Picture::of_film(&rendered("ch14/set", 1));
    assert_eq!(explanation(&ours, &other), "none");
}

/// Law: film points that are off by half a pixel are named with their directions, for every camera without noise,
/// also in 8 bits; a shift by a third of a pixel is none by a half. Oracle: rays through points chosen by hand.
#[test]
fn a_shift_by_half_a_pixel_is_named() {
    let directions = [
        ([0.0, 0.5], "B is half a pixel too far right"),
        ([1.0, 0.5], "B is half a pixel too far left"),
        ([0.5, 0.0], "B is half a pixel too far up"),
        ([0.5, 1.0], "B is half a pixel too far down"),
        (
            [0.0, 0.0],
            "B is half a pixel too far right and half a pixel too far up (corners of pixels taken for centres)",
        ),
        (
            [1.0, 0.0],
            "B is half a pixel too far left and half a pixel too far up (corners of pixels taken for centres)",
        ),
    ];
    for name in ["ch24/hall-of-mirrors", "ch03/three-objects", "ch11/fisheye-180"] {
        let mut world = world(name);
        for (point, expected) in directions {
            let theirs = Picture::of_film(&film_through(&world, point));
            let byte = |value: f32| (255.0 * value.clamp(0.0, 1.0)).round() / 255.0;
            let in_bytes = Picture { step: Some(1.0 / 255.0), ..mapped(&theirs, |c| c.map(byte)) };
            for theirs in [theirs, in_bytes] {
                let found = half_pixel_shifts(&mut world, &theirs, "B");
                assert_eq!(found.first().map(|it| &*it.what), Some(expected), "{name}");
                // the fisheye is black outside the view plane of the unshifted picture
                assert!(found[0].left < 0.05, "{name}: {found:?}");
            }
        }
        for point in [[0.5, 0.5], [0.5 + 1.0 / 3.0, 0.5], [0.5, 1.5]] {
            let theirs = Picture::of_film(&film_through(&world, point));
            assert_eq!(half_pixel_shifts(&mut world, &theirs, "B"), [], "{name} {point:?}");
        }
        assert_eq!(world.picture_size(), SIZE, "the world is as before");
    }
}

/// Law: a note says that another seed changes pixels exactly of scenes that draw random numbers, and leaves the
/// world as it was; another sampling is no shift. Oracle: scenes with soft and with hard shadows.
#[test]
fn noise_is_noted_where_the_seed_counts() {
    for (name, has_noise) in
        [("ch24/hall-of-mirrors", false), ("ch18/rectangle", true), ("ch26/cornell-box", true)]
    {
        let mut world = world(name);
        let picture = Picture::of_film(&render::render(&world));
        let comparison = compared(&picture, &mapped(&picture, |color| color.map(|c| c + 0.5)));
        let note = noise_note(&mut world, &comparison, name);
        assert_eq!(note.is_some(), has_noise, "{name}: {note:?}");
        let other = Picture::of_film(&rendered(name, 2));
        assert_eq!(half_pixel_shifts(&mut world, &other, "B"), [], "noise is no shift");
        assert_eq!(Picture::of_film(&render::render(&world)).values, picture.values);
    }
}

/// Law: the largest difference is listed with its region, also if ten regions are larger, and once. Oracle: a
/// picture of bars and one pixel, drawn by hand.
#[test]
fn the_worst_region_is_listed_once() {
    let black = Picture::of_film(&Film::new(30, 4));
    let mut theirs = black.clone();
    for column in 0..12 {
        theirs.values[2 * column] = [0.5; 3];
        theirs.values[30 + 2 * column] = [0.5; 3];
    }
    theirs.values[3 * 30 + 29] = [f32::NAN, 0.0, 0.0];
    let comparison = compared(&black, &theirs);
    let listed: Vec<_> = comparison.listed().map(|region| region.worst).collect();
    assert_eq!((comparison.regions.len(), listed.len(), listed[10]), (10, 11, [29, 3]));
    assert!(comparison.to_string().contains("largest difference: inf at (29, 3)"), "{comparison}");
    theirs.values[..60].fill([0.0; 3]);
    assert_eq!(compared(&black, &theirs).listed().count(), 1, "NaN is one region");
}

/// Law: differences are signed, 0 within an integer's interval or the tolerance, and magenta where they are NaN; a
/// share of them is within each scale. Oracle: values chosen by hand.
#[test]
fn differences_are_shown_around_grey() {
    let mut film = Film::new(5, 1);
    (0..5).for_each(|x| film.set([x, 0], Rgb::grey(0.5)));
    let ours = Picture::of_film(&film);
    let mut theirs = ours.clone();
    theirs.values[1] = [0.6; 3];
    theirs.values[2] = [0.3; 3];
    theirs.values[3] = [f32::NAN; 3];
    theirs.values[4] = [0.501; 3];
    let differences = Differences::of(&ours, &theirs, 0.01);
    assert!((differences.within(0.5) - 0.1).abs() < 1e-6);
    assert!((differences.within(1.0) - 0.2).abs() < 1e-6);
    let shown = differences.film(differences.within(1.0));
    let near = |x: u32, grey: f64| (shown.get([x, 0]) - Rgb::grey(grey)).max().abs() < 1e-5;
    assert!(near(0, 0.5) && near(1, 0.75) && near(2, 0.0) && near(4, 0.5), "{shown:?}");
    assert_eq!(shown.get([3, 0]), Rgb::new(1.0, 0.0, 1.0));
    let bytes = Picture { step: Some(1.0 / 255.0), ..mapped(&ours, |c| c.map(|_| 127.0 / 255.0)) };
    let differences = Differences::of(&ours, &bytes, 0.0).film(1.0);
    assert!(differences.pixels().iter().all(|pixel| *pixel == Rgb::grey(0.5)));
}

/// Law: pictures of two sizes are not compared. Oracle: none; the error names both.
#[test]
fn sizes_must_be_equal() {
    let [a, b] = [[4, 5], [5, 4]].map(|[w, h]| Picture::of_film(&Film::new(w, h)));
    assert_eq!(Comparison::of(&a, &b, 0.0).err(), Some(SizesDiffer([4, 5], [5, 4])));
}
