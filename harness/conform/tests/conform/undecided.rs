//! Where another answer is as good, none is wrong; a little beside, one is.

use ask::{Draw, triple};
use std::f64::consts::PI;

use conform::family::Judge;
use conform::mistakes::FACTORS;
use conform::{Judgement, Profile, laws, ours, suite};
use groundtruth::math::{cos, sin};
use serde_json::json;

use super::borders::judged;

/// Law: within a thousandth of a jump of its colours, what a texture makes of noise is not judged; beyond it, a wrong colour is
/// wrong. Oracle: the jumps of each texture by hand, on both sides of both borders.
#[test]
fn colours_beside_a_jump_are_not_judged() {
    let [red, green, blue] = [[0.8, 0.1, 0.2], [0.1, 0.7, 0.3], [0.2, 0.3, 0.9]];
    let ramp = json!({"colors": [red, green, blue, red]});
    let three = json!({"color1": red, "color2": green, "color3": blue, "expansion": 4.0, "thresholds": [0.75, 2.5]});
    // of each texture: the factor of the noise, and the jumps of the product
    for (tag, fields, factor, jumps) in [
        ("fbm", json!({"color": red, "min": -0.5, "max": 1.5}), 2.0, &[0.5, 1.5][..]),
        ("wrapped_fbm", json!({"color": red, "expansion": 4.0}), 4.0, &[1.0, 2.0, 3.0]),
        ("two_colors", json!({"color1": red, "color2": green, "expansion": 3.0}), 3.0, &[1.0, 2.0]),
        ("three_colors", three, 4.0, &[0.75, 1.0, 2.0, 2.5, 3.0]),
        ("wrapped_ramp", json!({"ramp": ramp, "expansion": 2.0}), 8.0, &[1.0, 2.0, 3.0, 5.0, 6.0]),
    ] {
        let case = json!({"texture": {"texture": {tag: fields}, "point": [0.5, 0.25, 0.125]}});
        for jump in jumps {
            for (off, is_judged) in [(-1.1e-3, true), (-9e-4, false), (9e-4, false), (1.1e-3, true)]
            {
                let noise = (jump + off) / factor;
                let found =
                    judged(laws::texture_of_noise, &case, Profile::Book, |question| match question
                        .get("noise")
                    {
                        Some(_) => json!({"value": noise, "fbm": noise, "turbulence": noise}),
                        None => json!([5.0, 6.0, 7.0]),
                    });
                let expected = if is_judged { "Wrong" } else { "Undecided" };
                let found = format!("{found:?}");
                assert!(found.starts_with(expected), "{found} of {tag} at {off:e} from {jump}");
            }
        }
    }
}

/// Law: a sample along the horizon, or where the lobe has no density, is not judged; any other is. Oracle: numbers by hand.
#[test]
fn samples_along_the_horizon_are_not_judged() {
    let lobe = json!({"lambertian": {"reflectance": [0.5, 0.5, 0.5]}});
    let case = json!({"lobe": {"lobe": lobe, "wo": [0.6, 0.0, 0.8], "u": [0.3, 0.7]}});
    for (z, pdf, expected) in [
        (0.6_f64, 0.25, "Wrong"),
        (0.6, 0.0, "Undecided"),
        (1.1e-6, 0.25, "Wrong"),
        (0.9e-6, 0.25, "Undecided"),
    ] {
        let wi = [(1.0 - z * z).sqrt(), 0.0, z];
        let found = judged(laws::sample_agrees, &case, Profile::Book, |question| {
            match question["lobe"].get("u") {
                Some(_) => json!({"sample": {"wi": wi, "pdf": 0.5, "weight": [0.5, 0.5, 0.5]}}),
                None => json!({"f": [0.1, 0.1, 0.1], "pdf": pdf}),
            }
        });
        let found = format!("{found:?}");
        assert!(
            found.starts_with(expected),
            "{found} at z = {z:e} of pdf {pdf}, expected {expected}"
        );
    }
}

/// Law: a map and its inverse lead back to 16 (e + 1) times what the profile allows. Oracle: a u that is off by a little less
/// and a little more.
#[test]
fn the_way_back_of_a_map_is_held() {
    let u = [0.375, 0.75];
    for (to, slack) in
        [(json!({"disk": {}}), 16.0), (json!({"hemisphere": {"exponent": 3.0}}), 64.0)]
    {
        let case = json!({"map": {"to": to, "u": u}});
        for profile in Profile::ALL {
            for (part, is_right) in [(0.9, true), (1.1, false)] {
                let off = part * slack * profile.allowed() * f64::EPSILON / 2.0 * u[1];
                let found = judged(laws::map_and_back, &case, profile, |question| {
                    match question["map"].get("u") {
                        Some(_) => json!([0.0, 0.0, 1.0]),
                        None => json!([u[0] - off, u[1]]),
                    }
                });
                assert_eq!(found.is_right(), is_right, "u off by {off:e} of {to}: {found:?}");
            }
        }
    }
}

/// Law: directions whose density is wrong around the normal alone are found, and right ones are right. Oracle: the azimuths of
/// Lambertian directions, changed.
#[test]
fn directions_are_held_around_the_normal_too() {
    let lobe = json!({"lambertian": {"reflectance": [0.5, 0.5, 0.5]}});
    let case = json!({"lobe": {"lobe": lobe, "wo": [0.0, 0.0, 1.0], "u": [0.3, 0.7]}});
    type Azimuth = fn(f64) -> f64;
    let azimuths: [(&str, Azimuth, bool); 5] = [
        ("right", |phi| phi, true),
        ("turned and mirrored", |phi| 1.0 - phi, true),
        ("half of them", |phi| 0.5 * phi, false),
        ("denser ahead", |phi| phi - 0.5 * sin(phi), false),
        ("no last quarter", |phi| 0.75 * phi, false),
    ];
    for (name, azimuth, is_right) in azimuths {
        let mut draw = Draw::new(5);
        let found = judged(laws::density, &case, Profile::Book, |_| {
            let (r2, phi) = (draw.between(0.0, 1.0), azimuth(draw.between(-PI, PI)));
            let [x, y] = [cos(phi), sin(phi)].map(|c| r2.sqrt() * c);
            let wi = [x, y, (1.0 - r2).sqrt()];
            json!({"sample": {"wi": wi, "pdf": wi[2] / PI, "weight": [0.5, 0.5, 0.5]}})
        });
        assert_eq!(found.is_right(), is_right, "azimuths: {name}; {found:?}");
    }
}

/// Law: a mean that is a multiple of the irradiance is named as this one, or not named. Oracle: our own answers with this much
/// radiance.
#[test]
fn a_wrong_irradiance_says_its_factor() {
    let mut seen = 0;
    for family in suite::all() {
        let Judge::Law(law) = family.judge else { continue };
        if !family.name.starts_with("light.") || !family.name.contains("mean") {
            continue;
        }
        for case in (family.cases)(4, 2) {
            for (mistake, factor) in
                FACTORS.into_iter().filter(|(_, it)| [0.5, 2.0, PI].contains(it))
            {
                let found = judged(law, &case, Profile::Book, |question| {
                    let mut answer = ours(question).expect("an answer");
                    if let Some(radiance) = triple(&answer["radiance"]) {
                        answer["radiance"] = json!(radiance.map(|x| factor * x));
                    }
                    answer
                });
                if let Judgement::Wrong(wrong) = found {
                    let is_it = wrong.clues.iter().all(|it| *it == mistake);
                    assert!(is_it, "{}: {:?}, made {factor}", family.name, wrong.clues);
                    seen += wrong.clues.len();
                }
            }
        }
    }
    assert!(seen > 10, "wrong irradiances that are named: {seen}");
}
