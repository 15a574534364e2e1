//! The contract of [`Light`] (Suffern, ch. 14, 16).

use std::sync::Arc;

use groundtruth::lights::{Illumination, Kind, Light, LightSample, Reach};
use groundtruth::math::{Pcg32, Point, power_of_two};
use groundtruth::rgb::Rgb;
use libtest_mimic::Trial;

use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("light_is_finite_and_not_negative", light_is_finite_and_not_negative),
            ("directions_are_unit_and_lead_to_the_light", directions_lead_to_the_light),
            ("what_is_blocked_is_no_brighter", what_is_blocked_is_no_brighter),
            ("scaling_by_a_power_of_two_keeps_every_bit", scaling_keeps_every_bit),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Light> {
    kind.build(&mut ()).expect("specimens are valid")
}

fn places() -> impl Iterator<Item = Point> {
    let mut random = Pcg32::new(14, 0);
    let mut c = move || 100.0 * (random.uniform() - 0.5);
    (0..500).map(move |_| Point::new(c(), c(), c()))
}

fn sample(light: &dyn Light, place: Point) -> Option<LightSample> {
    match light.illuminate(place) {
        Illumination::Ambient(_) => None,
        Illumination::From(sample) => Some(sample),
    }
}

fn light_is_finite_and_not_negative(kind: &Kind) -> Holds {
    let light = built(kind);
    let sound = |color: Rgb| color.to_array().iter().all(|c| c.is_finite() && *c >= 0.0);
    for place in places() {
        let illumination = light.illuminate(place);
        ensure!(illumination == light.illuminate(place), "{place:?}: two answers");
        match illumination {
            Illumination::Ambient(radiance) => {
                ensure!(sound(radiance), "{place:?}: {radiance:?}");
            }
            Illumination::From(sample) => {
                ensure!(sound(sample.radiance), "{place:?}: {:?}", sample.radiance);
                ensure!(sound(sample.blocked), "{place:?}: {:?}", sample.blocked);
                ensure!(sample.pdf > 0.0 && sample.pdf.is_finite(), "{place:?}: {}", sample.pdf);
            }
        }
    }
    Ok(())
}

/// Law: the direction is unit, and a light at a place lies in it.
fn directions_lead_to_the_light(kind: &Kind) -> Holds {
    /// Two normalisations and a difference.
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    let light = built(kind);
    for place in places() {
        let Some(sample) = sample(&*light, place) else { continue };
        let length = sample.direction.length();
        ensure!((length - 1.0).abs() <= ROUNDING, "{place:?}: length {length}");
        if let Reach::To(end) = sample.reach {
            let way = end - place;
            let off = (sample.direction - way / way.length()).length();
            ensure!(off <= ROUNDING, "{place:?}: {:?} misses {end:?}", sample.direction);
        }
    }
    Ok(())
}

fn what_is_blocked_is_no_brighter(kind: &Kind) -> Holds {
    let light = built(kind);
    for place in places() {
        let Some(sample) = sample(&*light, place) else { continue };
        let pairs = sample.blocked.to_array().into_iter().zip(sample.radiance.to_array());
        let dimmer = pairs.into_iter().all(|(blocked, free)| blocked <= free);
        ensure!(dimmer, "{place:?}: {:?} above {:?}", sample.blocked, sample.radiance);
    }
    Ok(())
}

/// Law: with all lengths times 2ᵏ a place 2ᵏ times as far gets the same light from the same
/// direction, bit for bit, over 2ᵏ times the distance.
fn scaling_keeps_every_bit(kind: &Kind) -> Holds {
    let light = built(kind);
    for k in [1, -7, 30, -30] {
        let factor = power_of_two(k);
        let scaled = built(&kind.scaled(factor));
        for place in places() {
            let mut expected = light.illuminate(place);
            if let Illumination::From(LightSample { reach: Reach::To(end), .. }) = &mut expected {
                *end = end.scaled(factor);
            }
            let found = scaled.illuminate(place.scaled(factor));
            ensure!(found == expected, "{place:?}, 2^{k}: {found:?}, not {expected:?}");
        }
    }
    Ok(())
}
