//! Laws of lights and maps: right ones keep them, and mistakes break the law that names them.

use ask::Subject;
use claims::{Kind, Law, LawStatus};
use testkit::as_many;

use super::counted::first;
use super::lamps::{self, Lamps};
use super::right::card;
use super::squares::{self, Squares};

/// A mistake: who has it, and the law that should name it.
type Planted = (&'static [&'static str], &'static str, &'static str);

const R: &[&str] = &["rectangle"];

/// One for each law of lights.
const LIGHTS: [Planted; 11] = [
    (R, "point of the last call", "repeated"),
    (R, "negative cosine", "positive"),
    (R, "not unit", "directions"),
    (R, "density of area in the sample", "same pdf"),
    (R, "cosine in the sample's radiance", "same radiance"),
    (R, "both sides shine", "sides"),
    (R, "radiance over d²", "along"),
    (R, "no d²", "distance"),
    (R, "more in the middle", "density"),
    (R, "area of the half", "whole"),
    (R, "half of it never sampled", "arriving"),
];

/// One for each law of maps.
const MAPS: [Planted; 8] = [
    (&["disk"], "numbers of its own", "repeated"),
    (&["disk"], "square not halved", "inside"),
    (&["hemisphere"], "no absolute value", "positive"),
    (&["disk"], "radius without root", "jacobian"),
    (&["disk"], "exchanged", "inverse"),
    (&["sphere"], "upper half", "density"),
    (&["sphere"], "half a sphere", "whole"),
    (&["triangle"], "scrambled", "stratified"),
];

fn assert_right(subject: &mut dyn Subject, seed: u64) {
    let (cases, open) = as_many((2, 0), (6, 1));
    let card = card(subject, cases, seed);
    assert!(!card.is_failed(), "{card}");
    for row in &card.rows {
        let undecided = row.laws.iter().filter(|it| matches!(it, LawStatus::Undecided(_))).count();
        assert!(undecided <= open, "{}: {:?}", row.name, row.laws);
    }
}

/// Law: right lights and maps raise no alarm, in double and in single precision, and all is decided. Oracle: their formulas.
#[test]
fn right_lights_and_maps_keep_all_laws() {
    for seed in 0..as_many(1, 5) {
        for is_single in [false, true] {
            assert_right(&mut Lamps::new(&lamps::ALL, "", is_single), seed);
            assert_right(&mut Squares::new(&squares::ALL, "", is_single), seed);
        }
    }
}

/// Law: a mistake of each law of lights and of maps is found, and by this law. Oracle: what was planted.
#[test]
fn each_law_of_lights_and_maps_finds_its_mistake() {
    let finds = |kind: Kind, planted: &[Planted], subject: &dyn Fn(Planted) -> Box<dyn Subject>| {
        assert!(Law::of(kind).iter().map(|law| law.name).eq(planted.iter().map(|it| it.2)));
        for planted in planted {
            let card = card(&mut *subject(*planted), 2, 1);
            assert_eq!(first(&card), Some(planted.2), "{}\n{card}", planted.1);
        }
    };
    finds(Kind::Light, &LIGHTS, &|(lights, mistake, _)| {
        Box::new(Lamps::new(lights, mistake, false))
    });
    finds(Kind::Map, &MAPS, &|(maps, mistake, _)| Box::new(Squares::new(maps, mistake, false)));
}
