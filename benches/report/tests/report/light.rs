//! The report's page on light transport.

use std::collections::BTreeSet;

use report::light::{BiasData, shown};
use serde_json::Value;

use super::{REPORT, SMALL, choices, list, number, text};

fn scenes() -> &'static [Value] {
    list(&REPORT.json["pages"]["light"]["scenes"])
}

/// Value, lower and upper end of its interval.
fn ends(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| number(&value["difference"][i]))
}

/// Law: five scenes, each with every tracer that applies and both ways to sample lamps, from 1 sample to
/// the largest number, with at least two pictures each; and depths, rules and pictures of equal time.
#[test]
fn every_scene_and_choice_is_there() {
    let names: Vec<&str> = scenes().iter().map(|scene| text(&scene["scene"])).collect();
    let expected =
        ["Cornell box", "glossy hall", "glass over checker", "caustic ring", "many small lights"];
    assert_eq!(names, expected);
    for scene in scenes() {
        let name = text(&scene["scene"]);
        let found: BTreeSet<&str> =
            list(&scene["choices"]).iter().map(|c| text(&c["choice"])).collect();
        let mut wanted = BTreeSet::from(["path_trace"]);
        wanted.extend(["ray_cast (area)", "ray_cast (solid angle)"]);
        wanted.extend(["global_trace (area)", "global_trace (solid angle)"]);
        wanted.extend(["path (area)", "path (solid angle)"]);
        if !["Cornell box", "many small lights"].contains(&name) {
            wanted.extend(["whitted (area)", "whitted (solid angle)"]);
        }
        assert_eq!(found, wanted, "{name}");
        let rules = list(&scene["rules"]).len();
        assert_eq!(rules, if name == "glossy hall" { 2 } else { 0 }, "{name}");
        assert!(list(&scene["depths"]).len() >= 4, "{name}");
        let crops = list(&scene["equal_time"]["crops"]);
        assert_eq!(crops.len(), wanted.len() + 1, "{name}");
    }
    for (scene, choice) in choices("light") {
        let levels = list(&choice["levels"]);
        let samples: Vec<f64> = levels.iter().map(|level| number(&level["samples"])).collect();
        let name = (&scene["scene"], &choice["choice"]);
        assert_eq!(samples, [1.0, 4.0, 16.0, 64.0, 256.0, f64::from(SMALL.samples)], "{name:?}");
        assert!(levels.iter().all(|level| level["pictures"].as_u64() >= Some(2)), "{name:?}");
    }
}

/// Law: errors are shown at 1, 16 and 256 samples as far as there are so many, and at the most, each once and ascending.
/// Oracle: columns by hand; 64 is the most of `report --samples 64`.
#[test]
fn the_last_column_has_the_most_samples_and_none_has_more() {
    for columns in [&[1][..], &[1, 4], &[1, 16, 64], &[1, 16, 256], &[1, 16, 256, 1024]] {
        assert_eq!(shown(columns[columns.len() - 1]), columns);
    }
}

/// Law: efficiency is 1/(variance · time). Oracle: the formula, from the numbers beside it.
#[test]
fn efficiency_is_one_over_variance_and_time() {
    for (scene, choice) in choices("light") {
        for level in list(&choice["levels"]) {
            let (v, t) = (number(&level["relative_variance"]), number(&level["picture_seconds"]));
            assert!(v >= 0.0 && t > 0.0, "{} {level}", scene["scene"]);
            if v == 0.0 {
                // all black: no path met a lamp
                assert!(level["efficiency"].is_null(), "{} {level}", scene["scene"]);
                continue;
            }
            let product = number(&level["efficiency"]) * v * t;
            assert!((product - 1.0).abs() < 1e-12, "{} {level}: {product}", scene["scene"]);
        }
    }
}

/// Law: unbiased choices have the mean of the reference; ray_cast is darker in the two scenes where mirrors
/// or glass carry light on, because what it leaves out is not negative. Oracle: every strategy sums the
/// same paths. Half of a 95 % interval is about two standard errors; five are allowed for means of skewed
/// values. Rare bright paths make some intervals as wide as the mean; most are narrow enough to find a bias.
#[test]
fn choices_without_bias_have_the_mean_of_the_reference() {
    let mut halves = Vec::new();
    for (scene, choice) in choices("light") {
        let [value, low, high] = ends(&choice["bias"]);
        let half = 0.5 * (high - low);
        let name = (text(&scene["scene"]), text(&choice["choice"]));
        assert!(half > 0.0, "{name:?}: {value} ± {half}");
        halves.push(half);
        let is_path = ["path_trace", "global_trace", "path"].contains(&text(&choice["tracer"]));
        assert_eq!(choice["unbiased"], is_path, "{name:?}");
        if is_path {
            assert!(value.abs() < 2.5 * half, "{name:?}: {value} ± {half}");
        }
        let dark = ["glossy hall", "glass over checker"].contains(&name.0);
        if text(&choice["tracer"]) == "ray_cast" && dark {
            assert!(high < -0.1, "{name:?}: {value} ± {half}");
        }
    }
    halves.sort_by(f64::total_cmp);
    let median = halves[halves.len() / 2];
    assert!(median < 0.2, "half of the intervals are wider than {median}: {halves:?}");
}

/// Law: a larger depth limit leaves out less light: the bias is never positive, and its size falls with the
/// depth to almost 0. Oracle: the paths of one seed are the same, and what a larger limit adds is not
/// negative.
#[test]
fn what_a_depth_limit_leaves_out_falls_with_the_depth() {
    for scene in scenes() {
        let biases: Vec<f64> = list(&scene["depths"]).iter().map(|b| ends(b)[0]).collect();
        let name = text(&scene["scene"]);
        assert!(biases.windows(2).all(|pair| pair[0] <= pair[1]), "{name}: {biases:?}");
        let (first, last) = (biases[0], biases[biases.len() - 1]);
        assert!(first < 0.0 && last <= 0.0 && last > -0.05, "{name}: {biases:?}");
    }
}

/// Law: the normalised rule for glossy reflection is darker than the book's by the mean cosine, which is
/// between 0 and 1: its weight f·cos/p is `k_r c_r cosθ (e + 2)/(e + 1)`. Oracle: the two formulas.
#[test]
fn the_normalised_rule_is_darker() {
    let hall = scenes().iter().find(|scene| scene["scene"] == "glossy hall").expect("the hall");
    for rule in list(&hall["rules"]) {
        let [value, _, high] = ends(rule);
        assert!(high < 0.0 && value > -0.6, "{rule}");
    }
}

/// Law: the squared error of an unbiased choice is its variance. Oracle: the variance between pictures,
/// which needs no reference. Rare bright paths affect both alike, as both come from the same pictures. At
/// some levels the reference is too noisy, so the test uses the median of the ratios.
#[test]
fn the_error_without_bias_is_the_noise() {
    /// Half of the ratios are within 4 % of 1; a wrong factor would change the square by √2 at least.
    const ALLOWED: f64 = 0.1;
    let unbiased = choices("light").filter(|(_, choice)| choice["unbiased"] == true);
    let levels = unbiased.flat_map(|(_, choice)| list(&choice["levels"]));
    let ratio = |level: &Value| {
        let error = level["relative_rmse"].as_f64()?;
        Some(error * error / number(&level["relative_variance"]))
    };
    let mut ratios: Vec<f64> = levels.filter_map(ratio).collect();
    ratios.sort_by(f64::total_cmp);
    assert!(ratios.len() > 100, "only {} levels have an error", ratios.len());
    let median = ratios[ratios.len() / 2];
    assert!(
        (median - 1.0).abs() < ALLOWED,
        "the squared error is {median} of the variance, expected 1: {ratios:?}"
    );
}

/// Law: every choice of every scene has an equal-time picture on the page, with its samples below.
#[test]
fn pictures_of_equal_time_stand_side_by_side() {
    let (_, section) = REPORT.html.split_once("<section id=\"light\">").expect("the section");
    let (section, _) = section.split_once("</section>").expect("it ends");
    let crops: Vec<&Value> =
        scenes().iter().flat_map(|scene| list(&scene["equal_time"]["crops"])).collect();
    assert_eq!(section.matches("<img ").count(), crops.len());
    assert_eq!(section.matches("src=\"data:image/png;base64,iVBOR").count(), crops.len());
    for crop in crops {
        let words = format!("{}: {} samples, ", text(&crop["choice"]), crop["samples"]);
        assert!(section.contains(&words), "{words}");
    }
}

/// Law: of two series that differ by a constant, pictures of one seed are a pair, and the interval has almost no
/// width; the noise that both have is not in it. Oracle: the constant, relative to the mean.
#[test]
fn the_noise_of_pairs_is_not_in_the_interval() {
    let truth = [1.0, 5.0, 2.0, 8.0];
    let values = truth.map(|value| value + 0.5);
    let bias = BiasData::paired(String::new(), &values, &truth);
    let [value, low, high] = bias.difference.expect("four pairs");
    assert!((value - 0.125).abs() < 1e-12 && high - low < 1e-12, "{value}: {low} to {high}");
    let alone = BiasData::new(String::new(), &values, &truth).difference.expect("four and four");
    assert!(alone[2] - alone[1] > 1.0, "unpaired, the noise is in the interval: {alone:?}");
}
