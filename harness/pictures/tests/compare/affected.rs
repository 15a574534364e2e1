//! Which object differs most and how, factors by their names, and pictures of scenes in other sizes.

use std::sync::Arc;

use pictures::compare::{Affected, Change, Transfer, article, fit};

use crate::verbs::{equal, near};

/// Of pixels that differ so, each of an object that has no others.
fn affected(pixels: &[(u32, Option<[f64; 3]>)]) -> Option<Affected> {
    let objects = 1 + pixels.iter().map(|it| it.0).max().unwrap_or(0);
    let count = |object: u32| pixels.iter().filter(|it| it.0 == object).count() as u32;
    let names: Vec<(Arc<str>, u32)> =
        (0..objects).map(|object| (format!("object {object}").into(), count(object))).collect();
    let object_of: Vec<u32> = pixels.iter().map(|it| it.0).collect();
    Affected::of(&names, &object_of, |at| {
        let difference = pixels[at].1?;
        Some((difference.iter().map(|channel| channel.abs()).sum(), difference))
    })
}

/// Law: an object has a direction if its sum is at least half of its magnitudes, has another colour if the means of channels
/// are less than half of their magnitudes, and else both; not a number comes before all. Oracle: sums by hand, on both sides
/// of each border.
#[test]
fn directions_have_borders() {
    let grey = |sizes: &[f64]| sizes.iter().map(|it| (0, Some([*it; 3]))).collect::<Vec<_>>();
    let one = |color: [f64; 3]| vec![(0, Some(color))];
    for (pixels, expected) in [
        (grey(&[1.0, 1.0, 1.0, -1.0]), "is too bright"),
        (grey(&[1.0, 1.0, 1.0, -1.01]), "is too dark in some places and too bright in others"),
        (grey(&[-1.0, -1.0, -1.0, 1.0]), "is too dark"),
        (grey(&[-1.0, -1.0, -1.0, 1.01]), "is too dark in some places and too bright in others"),
        (grey(&[1.0, -1.0]), "is too dark in some places and too bright in others"),
        (one([3.0, -1.0, 0.0]), "is too bright"),
        (one([3.0, -1.01, 0.0]), "has another colour"),
        (one([-3.0, 1.0, 0.0]), "is too dark"),
        (one([-3.0, 1.01, 0.0]), "has another colour"),
        (one([1.0, f64::NAN, 0.0]), "has values that are no numbers (NaN or infinite)"),
        (one([f64::INFINITY; 3]), "has values that are no numbers (NaN or infinite)"),
    ] {
        let found = affected(&pixels).map(|it| it.direction.words());
        equal(format!("direction of {pixels:?}"), found, Some(expected));
    }
}

/// Law: the object with the largest sum of differences is named, with its number of pixels and of those that differ; one
/// with a value that is no number before all others; none if nothing differs. Oracle: objects by hand.
#[test]
fn the_object_that_differs_most_is_named() {
    let pixels = [
        (0, Some([0.4; 3])),
        (0, None),
        (0, None),
        (1, Some([0.1; 3])),
        (1, Some([0.2; 3])),
        (2, None),
        (3, Some([0.1; 3])),
    ];
    let of = |pixels: &[(u32, Option<[f64; 3]>)]| affected(pixels).expect("some differ");
    let found = of(&pixels);
    equal("most", (&*found.object, found.differing, found.pixels), ("object 0", 1, 3));
    near("its share", found.share(), 1.0 / 3.0, 1e-12);
    equal("words", &*found.words(), "object 0 is too bright, 33.3 % of its pixels");
    let more = [&pixels[..], &[(1, Some([-0.2; 3]))]].concat();
    equal("most of many small ones", &*of(&more).object, "object 1");
    for at in 3..5 {
        let mut bad = pixels.to_vec();
        bad[at].1 = Some([0.0, f64::NAN, 0.0]);
        let found = of(&bad);
        equal(
            "not a number",
            (&*found.object, found.direction.words()),
            ("object 1", "has values that are no numbers (NaN or infinite)"),
        );
    }
    equal("nothing differs", affected(&[(0, None), (1, None)]), None);
}

/// Law: a name in a sentence has its article, if it is no label. Oracle: by hand.
#[test]
fn names_have_articles() {
    for (name, expected) in [
        ("glass sphere", "the glass sphere"),
        ("the floor", "the floor"),
        ("theatre", "the theatre"),
        ("box 1", "box 1"),
        ("Cornell", "Cornell"),
    ] {
        equal("name in a sentence", &*article(name), expected);
    }
}

/// Law: a factor within 1 % of π, 1/π, ½, 2 or 4π has its name, and else four digits, or a power of ten if it is very small
/// or large. Oracle: factors on both sides of each border.
#[test]
fn factors_have_names() {
    use std::f64::consts::PI;
    let words = |factor: f64| Change::Scaled(factor).words(["A", "B"], Transfer::Linear);
    let known = [(PI, "π"), (1.0 / PI, "1/π"), (0.5, "1/2"), (2.0, "2"), (4.0 * PI, "4π")];
    for (value, name) in known {
        for part in [0.9902, 1.0, 1.0098] {
            equal("factor", words(value * part), format!("B is A divided by {name}"));
        }
        for part in [0.9895, 1.0105] {
            let factor = value * part;
            equal("factor", words(factor), format!("B is A divided by {factor:.4}"));
        }
    }
    for (factor, expected) in [
        (1e-3, "0.0010"),
        (0.9e-3, "9.00e-4"),
        (9_999.0, "9999.0000"),
        (1e4, "1.00e4"),
        (-3.0, "-3.0000"),
    ] {
        equal("factor", words(factor), format!("B is A divided by {expected}"));
    }
}

/// Law: a scene gets the size of another picture, and has its shape if its shorter side is that of the picture, rounded up
/// or down; of a stereo pair, each eye has half of the columns that are not the gap. Oracle: by hand.
#[test]
fn scenes_get_the_size_of_a_picture() {
    let scene = |name: &str, size: [u32; 2]| {
        let mut scene = gallery::find(name).map(|entry| (entry.build)()).expect("listed");
        scene.image.resize(size[0], size[1]);
        scene
    };
    for (own, other, is_alike) in [
        ([300, 200], [30, 20], true),
        // 20.67 rows, rounded down and up, and no further
        ([300, 200], [31, 20], true),
        ([300, 200], [31, 21], true),
        ([300, 200], [31, 19], false),
        ([300, 200], [31, 22], false),
        ([300, 200], [28, 20], false),
        ([300, 200], [33, 21], true),
        ([300, 200], [33, 20], false),
        ([300, 200], [1, 1], true),
        ([200, 300], [67, 100], true),
        ([200, 300], [65, 100], false),
        ([300, 200], [300, 201], true),
        ([300, 200], [300, 202], false),
    ] {
        let mut scene = scene("ch03/single-sphere", own);
        equal(format!("{own:?} has the shape of {other:?}"), fit(&mut scene, other), Ok(is_alike));
        equal("its size", [scene.image.width, scene.image.height], other);
    }
    let pair = || scene("ch12/three-spheres", [40, 30]);
    let gap = pair().camera.stereo.expect("a pair").gap;
    for (more, eye) in [(2, Some(1)), (40, Some(20)), (0, None), (1, None), (41, None)] {
        let mut pair = pair();
        let fitted = fit(&mut pair, [gap + more, 30]).is_ok();
        equal(format!("a pair of {more} columns and the gap"), fitted, eye.is_some());
        if let Some(eye) = eye {
            equal("columns of an eye", pair.image.width, eye);
        }
    }
    equal("a pair of fewer columns than the gap", fit(&mut pair(), [gap - 1, 30]).is_err(), true);
}
