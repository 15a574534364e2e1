//! The times for the same noise, as the report's page on light prints them; and times that are not work.

use std::time::Duration;

use report::clock::*;
use serde_json::Value;

use super::tables::table;
use super::{REPORT, list};

/// The efficiency of a choice with the largest number of samples.
fn efficiency(choice: &Value) -> f64 {
    list(&choice["levels"]).last().and_then(|level| level["efficiency"].as_f64()).unwrap_or(0.0)
}

/// Law: the printed time for the same noise is 1 for the best choice without bias and not less for any other, and is
/// the ratio of efficiencies. Oracle: these ratios from the JSON, to the two digits that are printed.
#[test]
fn times_for_the_same_noise_are_ratios_to_the_best() {
    let (heads, rows) = table("Time for the same noise, as a multiple of the shortest");
    let scenes = list(&REPORT.json["pages"]["light"]["scenes"]);
    let mut judged = 0;
    for (column, scene) in scenes.iter().enumerate() {
        let name = &scene["scene"];
        assert_eq!(Some(heads[column + 1].as_str()), name.as_str());
        let choices = list(&scene["choices"]);
        let unbiased = choices.iter().filter(|choice| choice["unbiased"] == true);
        let best = unbiased.map(efficiency).fold(0.0, f64::max);
        let mut smallest = f64::INFINITY;
        for row in &rows {
            let Some(choice) = choices.iter().find(|choice| choice["choice"] == row[0].as_str())
            else {
                continue;
            };
            let shown = &row[column + 1];
            if choice["unbiased"] != true {
                assert_eq!(shown, "biased", "{name}: {choice}");
                continue;
            }
            let ratio = best / efficiency(choice);
            let Ok(printed) = shown.parse::<f64>() else {
                // a dash, or powers of ten
                assert!(ratio >= 9_950.0, "{name}, {}: {shown} for {ratio}", row[0]);
                continue;
            };
            judged += 1;
            smallest = smallest.min(printed);
            assert!(
                (printed / ratio - 1.0).abs() < 0.051,
                "{name}, {}: {printed}, not {ratio}",
                row[0]
            );
        }
        assert_eq!(smallest, 1.0, "{name}");
    }
    assert!(judged > 10, "only {judged} were judged");
}

/// Law: a waiting thread uses no processor time, and its time is flagged; a computing thread is
/// not flagged. Oracle: the length of the sleep; the definition of 10 %.
#[test]
fn waiting_is_not_work() {
    let (_, waited) = time(|| std::thread::sleep(Duration::from_millis(50)));
    assert!(waited.wall >= 0.05 && waited.cpu < 0.025, "{waited:?}");
    assert!(waited.is_disturbed());
    assert!(!Time { cpu: 0.95, wall: 1.0 }.is_disturbed());
    assert!(Time { cpu: 0.85, wall: 1.0 }.is_disturbed());
}
