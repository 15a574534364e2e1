//! Chapter 17: ambient occlusion.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod exact;
mod mean;

use groundtruth::lights::AmbientOccluder;

use crate::prelude::*;
use crate::support::stage::*;

/// The ambient coefficient and the colour of the surfaces.
pub const KA: f64 = 0.75;
pub const CD: Rgb = Rgb::new(1.0, 0.5, 0.25);
/// The strength, the colour and the least amount of the light.
pub const LS: f64 = 1.5;
pub const COLOR: Rgb = Rgb::new(0.5, 1.0, 0.75);
pub const MIN: f64 = 0.25;

/// A surface that reflects ambient light only.
pub fn chalk() -> Matte {
    Matte { ka: KA.into(), kd: 0.0.into(), cd: CD.into() }
}

pub fn occluder() -> AmbientOccluder {
    AmbientOccluder {
        ls: LS,
        color: COLOR,
        min_amount: MIN,
        occluded_color: None,
        max_distance: None,
    }
}

/// The radiance of chalk where this share of the sky is visible.
pub fn shade(visible: f64) -> Rgb {
    (KA * LS * (visible + MIN * (1.0 - visible))) * (CD * COLOR)
}

pub fn ball(center: Point, radius: f64) -> Sphere {
    Sphere { center, radius, inward: false }
}

/// A plane through the origin in the light of the occluder; the background is bright, as it must not
/// contribute.
pub fn floor(normal: Vector) -> Scene {
    let mut scene = stage(Rgb::new(3.0, 5.0, 7.0));
    put(&mut scene, Plane { point: Point::ORIGIN, normal }, chalk());
    shine(&mut scene, occluder());
    scene
}
