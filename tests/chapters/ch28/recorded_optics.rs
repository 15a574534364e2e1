//! What the recorder reports about refraction: the numbers that `explain` and the inspector show.

use explain::{RecordedHit, RecordedRay};
use testkit::properties::*;

use super::{child, glass, tinted};
use crate::prelude::*;
use crate::support::optics;
use crate::support::stage::*;

/// Angles are converted to degrees and back, and to sines: a few dozen roundings, far less than the effect of
/// a mistake.
const CLOSE: f64 = 1e-12;

/// A ray onto the plane y = 0 at this angle of incidence in degrees, from above or below.
fn onto_plane(recipe: materials::Kind, degrees: f64, phi: f64, above: bool) -> RayTree {
    let mut scene = deep_stage(Rgb::WHITE, 1);
    put(&mut scene, ground(0.0), recipe);
    let up = if above { Normal::Y } else { -Normal::Y };
    let towards = at_angle(up, cos(to_radians(degrees)), phi);
    recorded(&built(&scene), Point::ORIGIN + towards, -towards)
}

fn hit_of(node: &RecordedRay) -> RecordedHit {
    let Some(hit) = &node.hit else { panic!("the plane is ahead") };
    hit.clone()
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the recorded angles obey Snell, reflection is total exactly beyond the critical angle, R is
    /// Fresnel's and `R + T = 1`, and the media are listed in the order in which the ray meets them. Oracle:
    /// `n₁ sin θ₁ = n₂ sin θ₂`, and Fresnel's equations by sums of angles (ch. 27, 28).
    #[test]
    fn a_dielectric_tells_angles_shares_and_media(
        (inside, outside) in (1.0..2.5_f64, 1.0..2.5_f64),
        degrees in 0.0..89.9_f64,
        phi in 0.0..TAU,
        above: bool,
    ) {
        let media = [Medium::clear(outside), tinted(inside, Rgb::new(0.5, 0.0, 0.25))];
        let tree = onto_plane(glass(media[1], media[0]).into(), degrees, phi, above);
        let hit = hit_of(tree.root());
        near!(hit.angle_of_incidence, degrees, 1e-9);
        let optics = hit.optics.expect("glass refracts");
        let [front, behind] = if above { media } else { [media[1], media[0]] };
        prop_assert_eq!(optics.media, Some([front, behind]));

        let sine = front.eta / behind.eta * sin(to_radians(degrees));
        prop_assume!((sine - 1.0).abs() > 1e-9);
        prop_assert_eq!(optics.angle_of_refraction.is_none(), sine > 1.0);
        prop_assert_eq!(optics.critical_angle.is_some(), front.eta > behind.eta);
        if let Some(critical) = optics.critical_angle {
            let found = front.eta * sin(to_radians(critical));
            prop_assert!((found - behind.eta).abs() < CLOSE * behind.eta, "{critical}");
        }
        let reflected = match optics.angle_of_refraction {
            None => 1.0,
            Some(angle) => {
                prop_assert!((sin(to_radians(angle)) - sine).abs() < CLOSE, "{angle}");
                // light takes the same share on the way back, at the angle of the other side
                match front.eta < behind.eta {
                    true => optics::by_angles(sin(to_radians(degrees)), behind.eta / front.eta),
                    false => optics::by_angles(sine, front.eta / behind.eta),
                }
            }
        };
        prop_assert!((optics.reflected.r - reflected).abs() < 1e-9, "{optics:?}, not {reflected}");
        prop_assert!((optics.transmitted.r + optics.reflected.r - 1.0).abs() < CLOSE, "{optics:?}");
    }
}

/// Law: the simple transparent material reflects and transmits its constant shares at every angle, and
/// everything beyond the critical angle of 41.8103°. Oracle: `k_r`, `k_t`, and arcsin 2/3 (ch. 27).
#[test]
fn a_transparent_surface_tells_its_constant_shares() {
    let recipe = Transparent { kr: 0.1.into(), kt: 0.9.into(), ..transparent(1.5) };
    for (degrees, above, total) in
        [(30.0, true, false), (80.0, true, false), (41.81, false, false), (41.811, false, true)]
    {
        let tree = onto_plane(recipe.clone().into(), degrees, 1.0, above);
        let optics = hit_of(tree.root()).optics.expect("it refracts");
        assert_eq!(optics.media, None, "the material has no media");
        assert_eq!(optics.angle_of_refraction.is_none(), total, "{degrees}");
        let [r, t] = if total { [1.0, 0.0] } else { [0.1, 0.9] };
        near!(optics.reflected.g, r, CLOSE);
        near!(optics.transmitted.g, t, CLOSE);
        assert_eq!(optics.critical_angle.is_some(), !above);
        let refracted = child(tree.root(), RayKind::Transmitted);
        assert_eq!(refracted.is_none(), total, "{degrees}");
    }
}

fn transparent(eta: f64) -> Transparent {
    let phong = materials::Phong::default();
    Transparent { phong, kr: 0.0.into(), cr: Rgb::WHITE.into(), kt: 0.0.into(), eta }
}
