//! Judges at their borders: answers by hand that just keep a law or just break it, in each channel, entry and stratum.

use ask::{Asking, Stop};
use conform::family::Judge;
use conform::{Judgement, Profile, laws, ours, suite};
use serde_json::{Value, json};

use super::altered::Says;

type Law = fn(&mut Asking<'_>, &Value, Profile) -> Result<Judgement, Stop>;

/// The judgement of a law on a subject that answers so.
pub fn judged(
    law: Law,
    case: &Value,
    profile: Profile,
    answer: impl FnMut(&Value) -> Value,
) -> Judgement {
    let mut subject = Says(answer);
    law(&mut Asking::new(&mut subject), case, profile).expect("everything is answered")
}

/// Relative errors that a profile just allows, and just does not: 100 u, and 10⁻⁴ (docs/conform.md).
const ERRORS: [(Profile, f64, bool); 4] = [
    (Profile::Careful, 90.0 * f64::EPSILON / 2.0, true),
    (Profile::Careful, 110.0 * f64::EPSILON / 2.0, false),
    (Profile::Book, 0.9e-4, true),
    (Profile::Book, 1.1e-4, false),
];

fn holds(found: &Judgement, is_right: bool, what: &str) {
    assert_eq!(found.is_right(), is_right, "{what}: {found:?}");
    assert_eq!(found.is_wrong(), !is_right, "{what}: {found:?}");
}

/// Law: an albedo is at most 1 in each channel, to what the profile allows, and shares add up to 1, in the mean and for each
/// polarisation. Oracle: sums on both sides of what is allowed.
#[test]
fn shares_are_held_to_one_by_both_profiles() {
    let lobe =
        json!({"lobe": {"lobe": {"lambertian": {"reflectance": [1, 1, 1]}}, "wo": [0, 0, 1]}});
    let fresnel = json!({"fresnel": {"eta": 1.5, "cos_i": 0.5}});
    for (profile, error, is_right) in ERRORS {
        for channel in 0..3 {
            let mut albedo = [0.25; 3];
            albedo[channel] = 1.0 + error;
            let found = judged(laws::energy, &lobe, profile, |_| json!({"albedo": albedo}));
            holds(&found, is_right, &format!("an albedo of {albedo:?}, {profile:?}"));
        }
        for (r, t) in [("reflected", "transmitted"), ("r_s", "t_s"), ("r_p", "t_p")] {
            for sign in [-1.0, 1.0] {
                let answer = |_: &Value| {
                    let mut shares = json!({"reflected": 0.25, "transmitted": 0.75, "r_s": 0.5, "t_s": 0.5, "r_p": 0.0, "t_p": 1.0});
                    shares[r] = json!(0.5);
                    shares[t] = json!(0.5 + sign * error);
                    shares
                };
                let found = judged(laws::shares_add_up, &fresnel, profile, answer);
                holds(&found, is_right, &format!("{r} + {t} off by {error:e}, {profile:?}"));
            }
        }
    }
    let found =
        judged(laws::shares_add_up, &fresnel, Profile::Careful, |_| json!({"reflected": 0.5}));
    holds(&found, true, "shares that are left out");
}

/// Law: f is the same with both directions exchanged, in each channel. Oracle: one of them off.
#[test]
fn reciprocity_is_held_in_each_channel() {
    let (wo, wi) = (json!([0.6, 0.0, 0.8]), json!([0.0, 0.8, 0.6]));
    let lobe = json!({"lambertian": {"reflectance": [0.5, 0.5, 0.5]}});
    let case = json!({"lobe": {"lobe": lobe, "wo": wo, "wi": wi}});
    for (profile, error, is_right) in ERRORS {
        for channel in 0..3 {
            let answer = |question: &Value| {
                let mut f = [0.125, 0.5, 0.25];
                // an error counts as a share of the largest channel
                if question["lobe"]["wo"] == wi {
                    f[channel] += 0.5 * error;
                }
                json!({"f": f})
            };
            let found = judged(laws::reciprocity, &case, profile, answer);
            holds(
                &found,
                is_right,
                &format!("f off by {error:e} in channel {channel}, {profile:?}"),
            );
        }
    }
}

/// Law: a sample is unit, its pdf is `pdf` there, and its weight f cos θ / pdf in each channel. Oracle: our sample of a
/// Lambertian lobe, one number of it off.
#[test]
fn each_number_of_a_sample_is_held() {
    let case = json!({"lobe": {
        "lobe": {"lambertian": {"reflectance": [0.5, 0.25, 0.75]}}, "wo": [0.6, 0, 0.8], "u": [0.3, 0.7]}});
    let change = |place: &str, by: f64, profile: Profile| {
        judged(laws::sample_agrees, &case, profile, |question| {
            let mut answer = ours(question).expect("an answer");
            if let Some(slot) = answer.pointer_mut(place) {
                *slot = json!(slot.as_f64().expect("a number") * (1.0 + by));
            }
            answer
        })
    };
    holds(&change("/none", 0.0, Profile::Careful), true, "our own sample");
    for place in [
        "/sample/wi/0",
        "/sample/wi/1",
        "/sample/wi/2",
        "/sample/pdf",
        "/sample/weight/0",
        "/sample/weight/1",
        "/sample/weight/2",
        "/f/0",
        "/f/1",
        "/f/2",
        "/pdf",
    ] {
        for (profile, by, is_right) in [
            (Profile::Careful, 1e-10, false),
            (Profile::Careful, 1e-15, true),
            (Profile::Book, 1e-2, false),
            (Profile::Book, 1e-6, true),
        ] {
            holds(
                &change(place, by, profile),
                is_right,
                &format!("{place} off by {by:e}, {profile:?}"),
            );
        }
    }
}

/// Law: matrix times inverse is 1, in each of its twelve entries. Oracle: one entry off, of a matrix without zeros.
#[test]
fn each_entry_of_a_product_is_held() {
    let case = json!({"transform": {"steps": [
        {"scale": [2, 0.5, 1.5]}, {"rotate_x": 30}, {"rotate_y": 50}, {"rotate_z": -20}, {"translate": [1, -2, 3]}]}});
    for name in ["matrix", "inverse"] {
        for at in 0..12 {
            for (by, is_right) in [(0.0, true), (1e-15, true), (1e-9, false)] {
                let found = judged(laws::inverse_is_inverse, &case, Profile::Careful, |question| {
                    let mut answer = ours(question).expect("an answer");
                    let slot = &mut answer[name][at / 4][at % 4];
                    *slot = json!(slot.as_f64().expect("a number") + by);
                    answer
                });
                holds(&found, is_right, &format!("entry {at} of the {name} off by {by:e}"));
            }
        }
    }
}

/// Law: a set has as many points as asked for, each of two numbers of at least 0 and below 1, one in each stratum of
/// its sampler, in each set. Oracle: sets of nine points in the middles of their strata, changed by hand.
#[test]
fn sets_are_held_to_their_strata() {
    let middle = |i: usize, n: usize| (i as f64 + 0.5) / n as f64;
    let cells: Vec<[f64; 2]> = (0..9).map(|i| [middle(i % 3, 3), middle(i / 3, 3)]).collect();
    let rooks: Vec<[f64; 2]> = (0..9).map(|i| [middle(i, 9), middle(2 * i % 9, 9)]).collect();
    let both: Vec<[f64; 2]> =
        (0..9).map(|i| [middle(3 * (i % 3) + i / 3, 9), middle(3 * (i / 3) + i % 3, 9)]).collect();
    let judge = |sampler: &str, sets: &Value, count: usize| {
        let case = json!({"samples": {"sampler": {sampler: {}}, "n": 9, "seed": 1, "sets": count}});
        judged(laws::stratified, &case, Profile::Careful, |_| sets.clone())
    };
    for (sampler, set) in [
        ("jittered", &cells),
        ("regular", &cells),
        ("n_rooks", &rooks),
        ("multi_jittered", &both),
        ("random", &cells),
    ] {
        let is_free = sampler == "random";
        holds(&judge(sampler, &json!([set, set]), 2), true, &format!("two sets of {sampler}"));
        for count in [1, 3] {
            let found = judge(sampler, &json!([set, set]), count);
            holds(&found, false, &format!("two sets of {sampler} for {count}"));
        }
        let changed = |change: &dyn Fn(&mut Vec<Vec<f64>>)| {
            let mut second: Vec<Vec<f64>> = set.iter().map(|point| point.to_vec()).collect();
            change(&mut second);
            judge(sampler, &json!([set, second]), 2)
        };
        for (what, change, is_right) in [
            (
                "a point less",
                &(|set: &mut Vec<Vec<f64>>| drop(set.pop())) as &dyn Fn(&mut Vec<Vec<f64>>),
                false,
            ),
            ("a point more", &|set: &mut Vec<Vec<f64>>| set.push(vec![0.5, 0.5]), false),
            ("a number more", &|set: &mut Vec<Vec<f64>>| set[8].push(0.5), false),
            ("a number less", &|set: &mut Vec<Vec<f64>>| set[8].truncate(1), false),
            ("x = 0", &|set: &mut Vec<Vec<f64>>| set[0][0] = 0.0, true),
            (
                "y just below 1",
                &|set: &mut Vec<Vec<f64>>| set[8][1] = set[8][1].max(1.0 - f64::EPSILON / 2.0),
                is_free || sampler != "n_rooks",
            ),
            ("x = 1", &|set: &mut Vec<Vec<f64>>| set[8][0] = 1.0, false),
            ("y = 1", &|set: &mut Vec<Vec<f64>>| set[8][1] = 1.0, false),
            ("x below 0", &|set: &mut Vec<Vec<f64>>| set[0][0] = -f64::MIN_POSITIVE, false),
            ("NaN", &|set: &mut Vec<Vec<f64>>| set[3][1] = f64::NAN, false),
            ("a point twice", &|set: &mut Vec<Vec<f64>>| set[7] = set[8].clone(), is_free),
            ("a row twice", &|set: &mut Vec<Vec<f64>>| set[7][1] = set[1][1], is_free),
            ("a column twice", &|set: &mut Vec<Vec<f64>>| set[7][0] = set[8][0], is_free),
        ] {
            holds(&changed(change), is_right, &format!("{what}, {sampler}"));
        }
    }
    for nothing in [json!(null), json!([]), json!([[]]), json!({}), json!([[[0.5]]])] {
        let found = judge("random", &nothing, 1);
        holds(&found, false, &format!("{nothing} for a set"));
    }
}

/// The judgement of the family of this name on an answer.
fn of_family(name: &str, question: &Value, answer: &Value, profile: Profile) -> Judgement {
    let all = suite::all();
    let family =
        all.iter().find(|family| family.name == name).unwrap_or_else(|| panic!("no {name}"));
    match family.judge {
        Judge::Answer(judge, rules) => judge(question, answer, profile, rules),
        Judge::Law(_) => panic!("{name} is a law"),
    }
}

/// Law: an answer may be off by 100 u·cond (10⁻⁴·cond with *book*), and not by a tenth more; cond is the larger of 1
/// and the sum of the changes that relative changes of each number of the question make. Oracle: conditions by hand:
/// less than 1 for a Lambertian f, three times the largest reflectance for its albedo, 12 for the sum of the
/// translations 4 − 4 + 4.
#[test]
fn answers_are_allowed_their_condition_and_no_more() {
    let lobe = json!({"lobe": {
        "lobe": {"lambertian": {"reflectance": [0.5, 0.25, 0.75]}}, "wo": [0, 0, 1], "wi": [0, 0, 1]}});
    let steps: Vec<Value> = [4, -4, 4].map(|x| json!({"translate": [x, 0, 0]})).into();
    let transform = json!({"transform": {"steps": steps}});
    let names: Vec<String> = suite::all().into_iter().map(|it| it.name).collect();
    let transforms = names
        .iter()
        .find(|it| it.starts_with("transform.") && !it.ends_with(".inverse"))
        .expect("one");
    for (name, question, pointers, cond) in [
        ("lobe.lambertian.values", &lobe, &["/f/0", "/f/1", "/f/2", "/pdf"][..], 1.0),
        ("lobe.lambertian.values", &lobe, &["/albedo/1"], 3.0 * 0.75),
        (transforms, &transform, &["/matrix/0/3"], 12.0),
    ] {
        for (profile, unit) in
            [(Profile::Careful, 100.0 * f64::EPSILON / 2.0), (Profile::Book, 1e-4)]
        {
            for pointer in pointers {
                for (share, is_right) in [(-1.1, false), (-0.9, true), (0.9, true), (1.1, false)] {
                    let mut answer = ours(question).expect("an answer");
                    let slot = answer.pointer_mut(pointer).expect("it is there");
                    *slot = json!(slot.as_f64().expect("a number") + share * cond * unit);
                    let found = of_family(name, question, &answer, profile);
                    let what =
                        format!("{pointer} of {name} off by {share} of what {profile:?} allows");
                    holds(&found, is_right, &what);
                }
            }
        }
    }
}

/// Law: a hit or miss that a relative change of 10⁻¹³ of the question reverses is not judged (10⁻⁵ with *book*); one
/// that only a few times that change reverses is (docs/conform.md). Oracle: rays at the distances 1 − δ and 1 + δ from
/// the centre of the unit ball.
#[test]
fn near_misses_are_judged_from_their_margin_on() {
    for (profile, delta, is_judged) in [
        (Profile::Careful, 1e-15, false),
        (Profile::Careful, 1e-14, false),
        (Profile::Careful, 1e-12, true),
        (Profile::Book, 1e-12, false),
        (Profile::Book, 1e-6, false),
        (Profile::Book, 6e-5, true),
        (Profile::Book, 1e-3, true),
    ] {
        for side in [-1.0, 1.0] {
            let x = 1.0 + side * delta;
            let question = json!({"intersect": {
                "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}},
                "ray": {"origin": [x, 0, 1], "direction": [0, 0, -1]}}});
            // a hit in place of a miss, and none in place of a hit
            let wrong = match side > 0.0 {
                true => json!({"t": 1.0, "normal": [1, 0, 0]}),
                false => json!(null),
            };
            let found = of_family("intersect.sphere.ordinary", &question, &wrong, profile);
            assert_eq!(found.is_wrong(), is_judged, "a ray at {x}, {profile:?}: {found:?}");
            let segment = json!({"occluded": {
                "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}},
                "segment": {"from": [x, 0, 1], "to": [x, 0, -1]}}});
            let found = of_family("occluded.sphere.segment", &segment, &json!(side > 0.0), profile);
            assert_eq!(found.is_wrong(), is_judged, "a segment at {x}, {profile:?}: {found:?}");
        }
    }
}
