//! What the rays of programs with mistakes tell.

use conform::Profile;
use serde_json::Value;

use super::altered::{Altered, card_with, each, instead};

/// What the card says to be right, of the first failure.
fn expected(material: &str, alter: fn(&Value, Value) -> Value) -> String {
    let family = format!("trace.{material}");
    let card = card_with(&mut Altered(alter), &[&family], Profile::Careful, 12, false);
    let failure = card.rows[0].failure.as_ref().unwrap_or_else(|| panic!("{family} does not fail"));
    failure.wrong.expected.clone()
}

/// Law: an index of refraction that is wrong shows in the first refracted ray, though the order of rays is another and
/// shadow rays are not logged. Oracle: our own rays with another index.
#[test]
fn a_wrong_index_shows_in_the_first_refracted_ray() {
    let text = expected("dielectric", |question, _| {
        let mut other = instead(question, |data| {
            let recipe = &mut data["scene"]["materials"][0]["recipe"]["dielectric"];
            each(&mut recipe["inside"]["eta"], |eta| 2.0 * eta);
        });
        let rays = other["rays"].as_array_mut().expect("a log");
        rays.reverse();
        rays.retain(|ray| ray["kind"] != "shadow");
        other
    });
    assert!(text.contains("(transmitted), from ") && text.contains("° beside ours"), "{text}");
}

/// Law: a ray that goes elsewhere and one that ends elsewhere are named. Oracle: our own rays, altered.
#[test]
fn rays_that_end_elsewhere_are_named() {
    fn darker(answer: &mut Value) {
        each(&mut answer["radiance"], |x| 0.5 * x + 0.125);
    }
    let text = expected("reflective", |_, mut answer| {
        darker(&mut answer);
        if let Some(rays) = answer["rays"].as_array_mut() {
            rays.iter_mut()
                .filter(|ray| ray["kind"] == "reflected" && ray["depth"] == 1)
                .for_each(|ray| each(&mut ray["direction"], |x| -x));
        }
        answer
    });
    assert!(text.contains("(reflected), from "), "{text}");
    let text = expected("matte", |_, mut answer| {
        darker(&mut answer);
        each(&mut answer["rays"][0]["t"], |t| 0.5 * t);
        answer
    });
    assert!(text.contains("ray 0 (camera) hits") && text.contains("is nearest"), "{text}");
}

/// Law: if all rays agree, the shading differs, at the deepest ray whose light does. Oracle: our own rays, the light
/// of all of them altered.
#[test]
fn where_all_rays_agree_the_shading_differs() {
    let text = expected("reflective", |_, mut answer| {
        each(&mut answer["radiance"], |x| 0.5 * x + 0.125);
        for ray in answer["rays"].as_array_mut().into_iter().flatten() {
            each(&mut ray["radiance"], |x| 0.5 * x + 0.125);
        }
        answer
    });
    assert!(text.contains("(reflected), from ") && text.contains("where ours brings"), "{text}");
    let text = expected("reflective", |_, mut answer| {
        each(&mut answer["radiance"], |x| 0.5 * x + 0.125);
        answer
    });
    assert!(
        text.ends_with("; the rays agree with ours as far as they say; the shading differs"),
        "{text}"
    );
}
