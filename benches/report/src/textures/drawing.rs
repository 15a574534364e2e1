//! Page 5 as tables and plots, from its data alone.

use super::scenes::TextureScene;
use super::{Choice, Data, SceneData};
use crate::convergence::{diagrams, error_columns};
use crate::words::{beginning, capital, film, listed, pick, rough_or_dash, with_minus};
use text::digits::rough;
use text::document::*;

pub fn page(data: &Data) -> Element {
    several()
        .with(prose(include_str!("explanation.txt")))
        .with(pick("What to pick.", advice(data)))
        .with_all(data.scenes.iter().map(section))
}

/// The error of bilinear look-up with the largest number of samples, and its time, relative to
/// those of nearest look-up.
fn ratios(scene: &SceneData) -> Option<[f64; 2]> {
    let [nearest, bilinear] = &scene.choices;
    let error = bilinear.levels.last()?.rmse? / nearest.levels.last()?.rmse?;
    Some([error, bilinear.sample_seconds() / nearest.sample_seconds()])
}

fn advice(data: &Data) -> String {
    let found = data.scenes.iter().filter_map(|scene| Some((scene, ratios(scene)?)));
    let words = found.map(|(scene, [error, time])| {
        format!(
            "{} times the error of the nearest texel in {} times its time ({})",
            rough(error),
            rough(time),
            scene.subject.name
        )
    });
    let slopes = data.scenes.iter().flat_map(|scene| &scene.choices).filter_map(|c| c.slope);
    let steepest = slopes.clone().map(|[slope, ..]| slope).fold(f64::INFINITY, f64::min);
    let flattest = slopes.map(|[slope, ..]| slope).fold(f64::NEG_INFINITY, f64::max);
    let words = listed(words);
    format!(
        "Choose the look-up by the appearance of texels in close-up, squares or a blur, and reduce moiré \
         patterns by more samples. With the same number of samples, bilinear look-up has {words}; the \
         errors of both fall with N to the power of {} to {}.",
        with_minus(&rough(flattest)),
        with_minus(&rough(steepest)),
    )
}

fn section(scene: &SceneData) -> Element {
    let TextureScene { name, about, moments, .. } = scene.subject;
    let about = format!(
        "{about} {} × {} pixels{}; references of {} samples, which differ by {} between the look-ups.",
        scene.width,
        scene.height,
        if *moments == 1 { String::new() } else { format!(", {moments} frames") },
        scene.reference_samples,
        rough(scene.difference),
    );
    several()
        .with(beginning(name, about))
        .with(diagrams(&scene.choices, ("error", |level| level.rmse), None))
        .with(pictures(scene))
        .with(details(scene))
}

fn pictures(scene: &SceneData) -> Element {
    let of_choice = |choice: &Choice| {
        let [one, reference] = &choice.kind.pictures;
        let image = |picture, count: &str| {
            let words = format!("{}, {count}", choice.name);
            film(picture, 1.0, &words, words.clone())
        };
        let many = format!("{} samples", scene.reference_samples);
        [image(one, "1 sample"), image(reference, &many)]
    };
    group("crops").with_all(scene.choices.iter().flat_map(of_choice))
}

fn details(scene: &SceneData) -> Element {
    let table = table(&scene.choices)
        .caption(format!("{}: error and time", capital(scene.subject.name)))
        .group("")
        .column("look-up", |choice| &choice.name)
        .group("error, by samples");
    let samples = scene.choices[0].levels.iter().map(|level| level.samples);
    error_columns(table, samples, |level| level.rmse)
        .group("")
        .column("time per sample of all pixels", |choice| choice.sample_time())
        .column("slope", |choice| with_minus(&rough_or_dash(choice.slope.map(|[slope, ..]| slope))))
        .element()
}
