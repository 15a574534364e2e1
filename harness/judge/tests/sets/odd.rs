//! Pictures that stand out: with values that are no numbers, with negative ones, or far from their set.

use judge::sets::{Method, Odd, SetsDecision};
use pictures::compare::Picture;

use super::synthetic::{Noise, SIZE, pictures, verdict};

/// The pictures, one of them of one value.
fn with_one(mut set: Vec<Picture>, which: usize, value: f32) -> Vec<Picture> {
    set[which].values.fill([value; 3]);
    set
}

/// Law: values that are no numbers on one side only make a difference, and their picture is named first; on both sides they are
/// left out, and told. Oracle: where they are put.
#[test]
fn values_that_are_no_numbers() {
    let (before, after) = (pictures(Noise::Even, 0..5), pictures(Noise::Even, 5..10));
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let with = |mut set: Vec<Picture>| {
            set[2].values[7] = [value; 3];
            set
        };
        for (sets, side, other) in [
            ([before.clone(), with(after.clone())], "after", "before"),
            ([with(before.clone()), after.clone()], "before", "after"),
        ] {
            let found = verdict(&sets[0], &sets[1]);
            assert_eq!((found.decision, found.method.clone()), (SetsDecision::Differ, Method::Odd));
            let words = format!(
                "differ: picture 3 {side}: 3 values no number, left out everywhere; no picture {other} is so"
            );
            assert_eq!(found.sentence(), words);
        }
        let found = verdict(&with(before.clone()), &with(after.clone()));
        assert_eq!(found.decision, SetsDecision::Agree, "{found}");
        let told = found.to_string();
        for words in ["picture 3 before: 3 values no number", "picture 3 after: 3 values no number"]
        {
            assert!(told.contains(words), "{words}: {told}");
        }
    }
    let [a, b] = [&before, &after].map(|set| with_one(set[..1].to_vec(), 0, f32::NAN));
    let found = verdict(&a, &b);
    assert_eq!(found.decision, SetsDecision::CannotTell, "{found}");
    assert!(found.sentence().contains("each value is no number"), "{found}");
    assert_eq!(verdict(&before[..1], &b).decision, SetsDecision::Differ);
}

/// Law: a picture of one value far from the noise of its set is named first, and makes a difference if only one side has such a
/// picture. Of pictures with honest noise none is called far, with or without single bright pixels. Oracle: it is planted; the noise is a
/// tenth of a mean of about 1.
#[test]
fn a_picture_far_from_its_set_is_named() {
    for noise in [Noise::Even, Noise::Fireflies, Noise::Filtered] {
        let sets = || [pictures(noise, 0..5), pictures(noise, 5..10)];
        let [before, after] = sets();
        let honest = verdict(&before, &after);
        assert!(honest.odd.iter().all(|odd| *odd == Odd::default()), "{honest}");
        for value in [1e20, f32::MAX, -5.0, 30.0] {
            let found = verdict(&before, &with_one(after.clone(), 4, value));
            assert_eq!(found.decision, SetsDecision::Differ, "{value}: {found}");
            let words = "differ: picture 5 after: far from the others of its set";
            assert!(found.sentence().starts_with(words), "{value}: {found}");
            let far: Vec<usize> = (0..10).filter(|index| found.odd[*index].is_far).collect();
            assert_eq!(far, [9], "{value}");
            let negative = if value < 0.0 { 3 * (SIZE[0] * SIZE[1]) as usize } else { 0 };
            assert_eq!(found.odd[9].negative, negative);
        }
    }
    // negative values alone, which filters make, are told, and are no difference
    let [before, mut after] = [pictures(Noise::Even, 0..5), pictures(Noise::Even, 5..10)];
    after[1].values[40][2] = -0.01;
    let found = verdict(&before, &after);
    assert!(found.to_string().contains("picture 2 after: 1 value negative"), "{found}");
    assert_eq!(found.decision, SetsDecision::Agree, "{found}");
}
