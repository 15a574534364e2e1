//! The report's page on textures.

use super::{choices, list, number};

/// Law: two scenes, each with both texture filters, from 1 to 256 samples.
#[test]
fn every_scene_and_look_up_is_there() {
    let found: Vec<_> = choices("textures")
        .map(|(scene, choice)| (scene["scene"].as_str(), choice["filtering"].as_str()))
        .collect();
    let names = ["checker to the horizon", "turning globe"];
    let filterings = ["nearest", "bilinear"];
    let expected: Vec<_> =
        names.iter().flat_map(|s| filterings.iter().map(|f| (Some(*s), Some(*f)))).collect();
    assert_eq!(found, expected);
    for (scene, choice) in choices("textures") {
        let samples: Vec<f64> =
            list(&choice["levels"]).iter().map(|level| number(&level["samples"])).collect();
        assert_eq!(samples, [1.0, 4.0, 16.0, 64.0, 256.0], "{}", scene["scene"]);
    }
}

/// Law: four times as many samples at least halve the error, as multi-jittered samples are no worse than
/// independent ones, whose error is proportional to `N^(−1/2)`. The rms error of one sample of values from
/// 0 to 1 is at most ½. Oracle: the variance of a number from 0 to 1 is at most ¼. From few pictures the
/// ratio of two errors is known to 25 %.
#[test]
fn errors_fall_as_samples_are_spent() {
    for (scene, choice) in choices("textures") {
        let levels = list(&choice["levels"]).iter();
        let errors: Vec<f64> = levels.map(|level| number(&level["rmse"])).collect();
        let name = (&scene["scene"], &choice["filtering"]);
        assert!(errors[0] > 0.01 && errors[0] <= 0.5, "{name:?}, one sample: {}", errors[0]);
        for pair in errors.windows(2) {
            assert!(pair[1] <= 0.5 * 1.25 * pair[0], "{name:?}: {} then {}", pair[0], pair[1]);
        }
    }
}
