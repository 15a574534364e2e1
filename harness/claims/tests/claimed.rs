//! Claims of lobes that have a density: of random numbers of their own, and of losing no light; and factors by name.

use std::collections::BTreeSet;

use claims::{ClaimsOptions, run};
use serde_json::{Value, json};

use super::counted::{Lambert, card, first};
use super::mistakes::scaled;
use super::rough::Rough;

/// The first law that Lambert's lobe breaks with these claims and this albedo; with numbers of its own, whose samples come in
/// another order each time.
fn broken(claims: Value, albedo: f64, is_own: bool) -> Option<&'static str> {
    let mut asked = 0;
    let change = |_: &Value, answer: Value| {
        let mut answer = scaled(answer, "f", &["weight"], albedo / 0.7);
        if let Some(samples) = answer.as_array_mut().filter(|_| is_own) {
            asked += 1;
            let count = samples.len();
            samples.rotate_left(asked % count);
        }
        answer
    };
    first(&card(&mut Lambert::new(claims, json!({}), change), 3))
}

/// Law: a lobe that draws its own numbers keeps all laws if it says so, and breaks that of repetition if it does not.
/// Oracle: Lambert's lobe.
#[test]
fn lobes_with_numbers_of_their_own_say_so() {
    assert_eq!(broken(json!({"random": true, "reciprocal": true}), 0.7, true), None);
    assert_eq!(broken(json!({"reciprocal": true}), 0.7, true), Some("repeated"));
    // the claim excuses nothing else
    assert_eq!(broken(json!({"random": true}), 1.2, true), Some("albedo"));
}

/// Law: a lobe with a density that claims to lose nothing has albedo 1; a loss of one percent is found. Oracle: its albedo.
#[test]
fn lobes_that_lose_nothing_have_albedo_1() {
    assert_eq!(broken(json!({"lossless": true}), 1.0, false), None);
    assert_eq!(broken(json!({"lossless": true}), 0.99, false), Some("albedo"));
    assert_eq!(broken(json!({}), 0.99, false), None);
}

/// Law: what loses no light keeps all laws of each configuration of OpenPBR, and a loss of one percent is found in each; they
/// are asked by names of their own, with parameters of the specification. Oracle: the albedo, and its parameter reference.
#[test]
fn the_white_furnaces_of_openpbr_find_a_loss() {
    let lobes = claims::openpbr();
    let names: BTreeSet<&String> = lobes.iter().map(|lobe| &lobe.name).collect();
    assert!(names.len() == lobes.len() && lobes.iter().all(|lobe| lobe.claims.lossless));
    for name in lobes.iter().flat_map(|lobe| lobe.parameters.keys()) {
        assert!(OPENPBR.split_whitespace().any(|known| known == name), "no parameter {name}");
    }
    for (albedo, expected) in [(1.0, None), (0.99, Some("albedo"))] {
        let change = |_: &Value, answer| scaled(answer, "f", &["weight"], albedo / 0.7);
        let mut lambert = Lambert::new(json!({}), json!({}), change);
        let card = run(&mut lambert, &lobes, ClaimsOptions { cases: 2, seed: 5 }, &mut |_| {});
        for row in &card.rows {
            let found = row.broken().next().map(|(law, _)| law.name);
            assert_eq!(found, expected, "{}: {card}", row.name);
        }
    }
}

/// The parameters of the pack, as the specification's reference names them.
const OPENPBR: &str = "base_color base_metalness base_diffuse_roughness specular_weight specular_roughness \
    specular_roughness_anisotropy specular_ior transmission_weight subsurface_weight subsurface_color \
    subsurface_scatter_anisotropy coat_weight coat_roughness coat_ior fuzz_weight fuzz_roughness geometry_thin_walled";

/// Law: 1/η² that is left out on both ways is named as η⁴. Oracle: what was planted.
#[test]
fn the_square_of_the_index_left_out_twice_is_named() {
    let card = card(&mut Rough { is_single: false, lacks: true }, 4);
    let broken = card.rows[0].broken().find(|(law, _)| law.name == "reciprocal");
    let (_, broken) = broken.expect("it is found");
    let mistake = broken.breach.mistake.as_deref().unwrap_or_default();
    assert!(mistake.contains("η⁴ (1/η² left out on both ways)"), "{card}");
}
