//! The contract of [`Material`] (Suffern, ch. 14, 15, 24, 27, 28).

use std::sync::Arc;

use groundtruth::kinds::Resources;
use groundtruth::materials::{Boundary, Kind, Material, Medium, Response};
use groundtruth::math::{Pcg32, power_of_two};
use groundtruth::rgb::Rgb;
use groundtruth::textures::TexturePoint;
use libtest_mimic::Trial;

use super::lobe::anywhere;
use super::texture::{scaled_surface, surfaces};
use super::{Holds, ensure};
use testkit::scaling::scaled;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("there_are_at_most_four_lobes_and_all_are_finite", lobes_are_few_and_finite),
            ("ambient_and_emission_are_finite_and_not_negative", other_light_is_finite),
            ("what_transmits_says_so", what_transmits_says_so),
            ("scaling_by_a_power_of_two_keeps_every_bit", scaling_keeps_every_bit),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Material> {
    kind.build(&mut Resources::default()).expect("specimens are valid")
}

const COSINES: [f64; 8] = [1.0, 0.7, 0.1, 1e-6, -1e-6, -0.1, -0.7, -1.0];

fn sound(color: Rgb) -> bool {
    color.to_array().iter().all(|c| c.is_finite() && *c >= 0.0)
}

fn emitted(material: &dyn Material, at: &groundtruth::shapes::Surface, cos_o: f64) -> Rgb {
    material
        .emission()
        .map_or(Rgb::BLACK, |emission| emission.radiance(&TexturePoint::new(at), cos_o))
}

fn response(material: &dyn Material, at: &groundtruth::shapes::Surface, cos_o: f64) -> Response {
    let mut response = Response::default();
    material.respond(&TexturePoint::new(at), cos_o, &mut response);
    response
}

/// Law: the number of lobes does not exceed their storage (one more would panic), and each lobe gives finite
/// numbers of at least 0.
fn lobes_are_few_and_finite(kind: &Kind) -> Holds {
    let material = built(kind);
    let mut random = Pcg32::new(14, 1);
    for at in surfaces().take(200) {
        for cos_o in COSINES {
            for (lobe, _) in response(&*material, &at, cos_o).lobes {
                let (wo, wi) = (anywhere(&mut random), anywhere(&mut random));
                ensure!(sound(lobe.f(wo, wi)), "{lobe:?}: f {:?}", lobe.f(wo, wi));
                let weight = lobe.sample(wo, [0.5; 2]).map(|sample| sample.weight);
                ensure!(weight.is_none_or(sound), "{lobe:?}: weight {weight:?}");
            }
        }
    }
    Ok(())
}

fn other_light_is_finite(kind: &Kind) -> Holds {
    let material = built(kind);
    for at in surfaces() {
        for cos_o in COSINES {
            let ambient = response(&*material, &at, cos_o).ambient;
            ensure!(sound(ambient), "{at:?} at {cos_o}: {ambient:?}");
            let emitted = emitted(&*material, &at, cos_o);
            ensure!(sound(emitted), "{at:?} at {cos_o}: {emitted:?}");
        }
    }
    Ok(())
}

/// Law: a material declares that it transmits light exactly if it does, and one that names its media
/// transmits light; absorption is never negative.
fn what_transmits_says_so(kind: &Kind) -> Holds {
    let material = built(kind);
    let at = surfaces().next().expect("there are some");
    let mut random = Pcg32::new(14, 2);
    let mut transmits = false;
    for _ in 0..200 {
        let wo = anywhere(&mut random);
        for (lobe, _) in response(&*material, &at, wo.z()).lobes {
            let sample = lobe.sample(wo, [0.5; 2]);
            transmits |= sample.is_some_and(|sample| sample.wi.z() * wo.z() < 0.0);
        }
    }
    let boundary = material.boundary();
    ensure!(transmits == material.transmits(), "sends light through: {transmits}");
    ensure!(transmits || boundary.is_none(), "opaque between {boundary:?}");
    if let Some(Boundary { inside, outside }) = boundary {
        let fine = |m: &Medium| m.eta > 0.0 && m.absorption.to_array().iter().all(|c| *c >= 0.0);
        ensure!([inside, outside].iter().all(fine), "{boundary:?}");
    }
    Ok(())
}

/// Law: with all lengths times 2ᵏ the lobes, ambient light and emission are the same bits, and
/// absorption per length is divided by 2ᵏ.
fn scaling_keeps_every_bit(kind: &Kind) -> Holds {
    let material = built(kind);
    for k in [1, -7, 30, -30] {
        let factor = power_of_two(k);
        let larger = built(&scaled(kind, factor));
        for at in surfaces().take(500) {
            let far = scaled_surface(&at, factor);
            for cos_o in COSINES {
                let here = response(&*material, &at, cos_o);
                let there = response(&*larger, &far, cos_o);
                ensure!(here == there, "2^{k}, {cos_o}: {there:?}, not {here:?}");
                let same = emitted(&*material, &at, cos_o) == emitted(&*larger, &far, cos_o);
                ensure!(same, "2^{k}, {cos_o}: emission differs");
            }
        }
        let expected = material.boundary().map(|Boundary { inside, outside }| Boundary {
            inside: Medium { absorption: inside.absorption / factor, ..inside },
            outside: Medium { absorption: outside.absorption / factor, ..outside },
        });
        let found = larger.boundary();
        ensure!(found == expected, "2^{k}: {found:?}, not {expected:?}");
    }
    Ok(())
}
