//! Both eyes of a stereo pair.

use serde_json::{Value, json};
use testkit::properties::*;

use super::{ask, close, numbers};
use testkit::cases::laws;

fn pair(separation: f64) -> Value {
    json!({"eye": [0, 0, 10], "look_at": [0, 0, 0], "lens": {"pinhole": {"distance": 20}},
        "stereo": {"viewing": "parallel", "separation": separation}})
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a point on an eye's ray is seen by this eye at the ray's place in its pixel, and by the other elsewhere.
    /// Oracle: the place that was asked for.
    #[test]
    fn each_eye_sees_the_points_of_its_rays(
        separation in 1.0..30.0_f64, pixel in (0_u32..40, 0_u32..30),
        place in (0.01..0.99_f64, 0.01..0.99_f64), t in 2.0..40.0_f64
    ) {
        for side in ["left", "right"] {
            let image = json!({"width": 40, "height": 30, "pixel_size": 0.25});
            let ray = ask(&json!({"camera_ray": {"camera": pair(separation), "image": image,
                "pixel": [pixel.0, pixel.1], "place": [place.0, place.1], "eye": side}}));
            let (origin, direction) = (numbers(&ray["origin"]), numbers(&ray["direction"]));
            let point: Vec<f64> = (0..3).map(|axis| origin[axis] + t * direction[axis]).collect();
            let seen = ask(&json!({"project": {"camera": pair(separation), "image": image, "point": point}}));
            prop_assert!(close(&seen[side]["film"], &numbers(&ray["film"]), 1e-10), "{side}: {seen} {ray}");
            // y counts from the bottom of a pixel, and from the top of the image
            let expected = [f64::from(pixel.0) + place.0, f64::from(pixel.1) + 1.0 - place.1];
            prop_assert!(close(&seen[side]["image"], &expected, 1e-9), "{side}: {seen}, not {expected:?}");
        }
    }
}
