//! Page 5 as tables and plots, from its data alone.

use super::scenes::TextureScene;
use super::{Choice, Data, SceneData};
use crate::convergence::{diagrams, error_columns};
use crate::html::{
    Table, capital, film, heading, listed, pick, row, short, short_or_dash, with_minus,
};

const EXPLANATION: &str = include_str!("explanation.html");

pub fn page(data: &Data) -> String {
    let sections: String = data.scenes.iter().map(section).collect();
    EXPLANATION.to_owned() + &pick("What to pick.", &advice(data)) + &sections
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
            short(error),
            short(time),
            scene.subject.name
        )
    });
    let slopes = data.scenes.iter().flat_map(|scene| &scene.choices).filter_map(|c| c.slope);
    let steepest = slopes.clone().map(|[slope, ..]| slope).fold(f64::INFINITY, f64::min);
    let flattest = slopes.map(|[slope, ..]| slope).fold(f64::NEG_INFINITY, f64::max);
    let words = listed(&words.collect::<Vec<String>>());
    format!(
        "Choose the look-up by the appearance of texels in close-up, squares or a blur, and reduce moiré \
         patterns by more samples. With the same number of samples, bilinear look-up has {words}; the \
         errors of both fall with N to the power of {} to {}.",
        with_minus(&short(flattest)),
        with_minus(&short(steepest)),
    )
}

fn section(scene: &SceneData) -> String {
    let TextureScene { name, about, moments, .. } = scene.subject;
    let about = format!(
        "{about} {} × {} pixels{}; references of {} samples, which differ by {} between the look-ups.",
        scene.width,
        scene.height,
        if *moments == 1 { String::new() } else { format!(", {moments} frames") },
        scene.reference_samples,
        short(scene.difference),
    );
    heading(name, &about)
        + &diagrams(&scene.choices, ("error", |level| level.rmse), None)
        + &pictures(scene)
        + &table(scene)
}

fn pictures(scene: &SceneData) -> String {
    let of_choice = |choice: &Choice| {
        let [one, reference] = &choice.kind.pictures;
        let image = |picture, count: &str| {
            let words = format!("{}, {count}", choice.name);
            film(picture, 1.0, &words, &words)
        };
        let many = format!("{} samples", scene.reference_samples);
        [image(one, "1 sample"), image(reference, &many)]
    };
    row("crops", &scene.choices.each_ref().map(of_choice).concat())
}

fn table(scene: &SceneData) -> String {
    let table = Table::new(format!("{}: error and time", capital(scene.subject.name)))
        .group("")
        .column("look-up", |choice: &Choice| choice.name.clone())
        .group("error, by samples");
    let samples = scene.choices[0].levels.iter().map(|level| level.samples);
    error_columns(table, samples, |level| level.rmse)
        .group("")
        .column("time per sample of all pixels", Choice::sample_time)
        .column("slope", |choice| with_minus(&short_or_dash(choice.slope.map(|[slope, ..]| slope))))
        .html(&scene.choices)
}
