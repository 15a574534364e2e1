//! Page 4 as tables and plots, from its data alone.

use super::scenes::LightScene;
use super::{BiasData, Choice, Data, SceneData};
use crate::convergence::{diagrams, error_columns};
use crate::words::*;
use groundtruth::math::{exp, ln};
use groundtruth::shapes::Sampling;
use statistics::quantile;
use text::digits::rough;
use text::document::*;

/// A choice is as good as the best if its time is at most this multiple of the best time.
const AS_GOOD: f64 = 1.5;

pub fn page(data: &Data) -> Element {
    let explanation =
        format!(include_str!("explanation.txt"), depth = data.depth, as_good = AS_GOOD);
    several()
        .with(prose(&explanation))
        .with(pick("What to pick.", advice(data)))
        .with(summary(data))
        .with_all(data.scenes.iter().map(section))
}

/// The same choice in a scene, or that of its tracer if the tracer does not sample lights there.
fn named<'a>(scene: &'a SceneData, choice: &Choice) -> Option<&'a Choice> {
    let same = |c: &&Choice| {
        c.kind.tracer == choice.kind.tracer
            && (c.kind.sampling == choice.kind.sampling || c.kind.sampling.is_none())
    };
    scene.choices.iter().find(same)
}

/// The highest efficiency of a choice without bias.
fn highest(scene: &SceneData) -> Option<f64> {
    let unbiased = scene.choices.iter().filter(|choice| choice.kind.unbiased);
    unbiased.filter_map(Choice::efficiency).reduce(f64::max)
}

/// The ratio of a choice's time to that of the best, for the same noise.
fn time_ratio(scene: &SceneData, choice: &Choice) -> Option<f64> {
    Some(highest(scene)? / choice.efficiency()?)
}

/// One choice in all scenes.
struct Record<'a> {
    choice: &'a Choice,
    /// The time ratio in each scene where it applies and has no bias.
    ratios: Vec<f64>,
    /// The geometric mean of them.
    mean: f64,
}

/// The choices of the scene that has the largest number of them.
fn all_choices(data: &Data) -> &[Choice] {
    let most = data.scenes.iter().max_by_key(|scene| scene.choices.len());
    most.map_or(&[], |scene| &scene.choices)
}

/// The choices that have no bias in some scene.
fn records(data: &Data) -> Vec<Record<'_>> {
    let record = |choice| {
        let ratio = |scene| {
            let here = named(scene, choice).filter(|here| here.kind.unbiased)?;
            time_ratio(scene, here)
        };
        let ratios: Vec<f64> = data.scenes.iter().filter_map(ratio).collect();
        let mean = exp(ratios.iter().map(|x| ln(*x)).sum::<f64>() / ratios.len() as f64);
        (!ratios.is_empty()).then_some(Record { choice, ratios, mean })
    };
    all_choices(data).iter().filter_map(record).collect()
}

/// One sentence for all scenes: the choice without bias that has the smallest mean time, the times
/// of the others, and the bias of the biased ones.
fn advice(data: &Data) -> String {
    let records = records(data);
    let by_mean = |a: &&Record<'_>, b: &&Record<'_>| a.mean.total_cmp(&b.mean);
    let everywhere = records.iter().filter(|record| record.ratios.len() == data.scenes.len());
    let Some(best) = everywhere.min_by(by_mean) else {
        return "No choice is without bias in every scene.".to_owned();
    };
    let others = ["path_trace", "global_trace", "path"].into_iter().filter_map(|tracer| {
        let of_tracer =
            |r: &&Record<'_>| r.choice.kind.tracer == tracer && r.choice.name != best.choice.name;
        let other = records.iter().filter(of_tracer).min_by(by_mean)?;
        Some(format!("{} {} times", words(other.choice), rough(other.mean)))
    });
    let others = listed(others);
    let missed = ["ray_cast", "whitted"].into_iter().filter_map(|tracer| {
        let all = data.scenes.iter().flat_map(|scene| &scene.choices);
        let biases = all.filter(|c| c.kind.tracer == tracer).filter_map(|c| c.kind.bias.difference);
        let largest = biases.map(|[bias, ..]| bias.abs()).reduce(f64::max)?;
        Some(format!("{} % with {tracer}", rough(100.0 * largest)))
    });
    let missed = listed(missed);
    format!(
        "Choose {}: for the same noise, its time is the shortest of all choices without bias, or at most \
         {AS_GOOD} times the shortest, in {} of {} scenes; {} times the shortest in the geometric mean and \
         {} times in the worst scene (the others in the mean: {others}). The bias of the mean is up to \
         {missed}.",
        words(best.choice),
        best.ratios.iter().filter(|ratio| **ratio <= AS_GOOD).count(),
        data.scenes.len(),
        rough(best.mean),
        rough(best.ratios.iter().copied().fold(0.0, f64::max)),
    )
}

/// The words for a choice in a sentence.
fn words(choice: &Choice) -> String {
    let sampling = match choice.kind.sampling {
        None => "",
        Some(Sampling::Area) => " with area sampling of lights",
        Some(Sampling::SolidAngle) => " with solid-angle sampling of lights",
    };
    format!("{}{sampling}", choice.kind.tracer)
}

/// The table of the times for the same noise.
fn summary(data: &Data) -> Element {
    let mut table = table(all_choices(data))
        .caption("Time for the same noise, as a multiple of the shortest")
        .column("choice", |choice| &choice.name);
    for scene in &data.scenes {
        table = table.column(scene.subject.name, |choice| {
            named(scene, choice).map_or(DASH.to_owned(), |here| ratio_or_biased(scene, here))
        });
    }
    table.element()
}

fn ratio_or_biased(scene: &SceneData, choice: &Choice) -> String {
    match choice.kind.unbiased {
        true => rough_or_dash(time_ratio(scene, choice)),
        false => "biased".to_owned(),
    }
}

fn section(scene: &SceneData) -> Element {
    let own = scene.reference.relative_standard_error;
    let limit = (own > 0.0).then_some((own, "error of the reference"));
    let LightScene { name, about, .. } = scene.subject;
    several()
        .with(beginning(name, format!("{about} {}", reference(scene))))
        .with(pick("Here:", advice_here(scene)))
        .with(diagrams(drawn(scene), ("relative error", |level| level.relative_rmse), limit))
        .with(equal_time(scene))
        .with(details(scene))
        .with(biases(scene))
        .with(folded("Errors, noise and time for every number of samples", levels(scene)))
}

fn reference(scene: &SceneData) -> String {
    let r = &scene.reference;
    format!(
        "{} × {} pixels; the reference is {} with {} samples per pixel; its standard error is {} % \
         (radiance: {}, the mean is {}).",
        scene.width,
        scene.height,
        r.choice,
        r.samples,
        rough(100.0 * r.relative_standard_error),
        rough(r.standard_error),
        rough(r.mean),
    )
}

/// The best choice without bias, those that are as good, the time ratios of the others, and the
/// bias of the biased ones.
fn advice_here(scene: &SceneData) -> String {
    let ratio = |choice: &Choice| time_ratio(scene, choice).unwrap_or(f64::INFINITY);
    let mut unbiased: Vec<&Choice> = scene.choices.iter().filter(|c| c.kind.unbiased).collect();
    unbiased.sort_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let Some((best, others)) = unbiased.split_first() else { return String::new() };
    let (as_good, slower): (Vec<&Choice>, Vec<&Choice>) =
        others.iter().partition(|choice| ratio(choice) <= AS_GOOD);
    let as_good = or_as_good(as_good.iter().map(|choice| &choice.name));
    let slower = slower.iter().map(|c| format!("{} takes {} times", c.name, rough(ratio(c))));
    let slower = listed_in("; for the same noise ", slower, " its time").unwrap_or_default();
    let darker = |choice: &Choice| {
        let [bias, ..] = choice.kind.bias.difference?;
        let word = if bias < 0.0 { "too dark" } else { "too bright" };
        Some(format!("{} {} % {word}", choice.name, rough(100.0 * bias.abs())))
    };
    // both samplings of area lights have the same mean
    let biased = drawn(scene).filter(|c| !c.kind.unbiased).filter_map(darker);
    let biased = listed_in("; in the mean, ", biased, "").unwrap_or_default();
    format!("the best is {}{as_good}{slower}{biased}.", best.name)
}

/// The choices in the plots, which have at most five series: all but area sampling.
fn drawn(scene: &SceneData) -> impl Iterator<Item = &Choice> + Clone {
    scene.choices.iter().filter(|choice| choice.kind.sampling != Some(Sampling::Area))
}

fn equal_time(scene: &SceneData) -> Element {
    let Some(truth) = scene.equal_time.crops.last() else { return several() };
    let brightnesses: Vec<f64> = truth.film.pixels().iter().map(|pixel| pixel.average()).collect();
    let bright = quantile(&brightnesses, 0.9).filter(|b| *b > 0.0).unwrap_or(1.0);
    let crops = scene.equal_time.crops.iter().map(|crop| {
        let words = format!("{}: {} samples, {}", crop.choice, crop.samples, time(crop.seconds));
        film(&crop.film, 0.7 / bright, &crop.choice, words)
    });
    let seconds = time(scene.equal_time.seconds);
    let about = format!("About {seconds} each, on one thread; the last one is the reference:");
    several().with(paragraph(about)).with(group("crops").with_all(crops))
}

/// In percent: `−12.3 (−12.9 … −11.7)`.
fn percent(bias: &BiasData) -> String {
    let Some(ends) = bias.difference else { return DASH.to_owned() };
    let [value, low, high] = ends.map(|end| 100.0 * end);
    let digits = if high - low < 0.2 { 2 } else { 1 };
    with_minus(&format!("{value:+.digits$} ({low:+.digits$} … {high:+.digits$})"))
        .replace(' ', "\u{a0}")
}

/// The numbers of samples whose errors have a column, ascending; the last is the largest.
pub fn shown(most: u32) -> Vec<u32> {
    [1, 16, 256].into_iter().filter(|samples| *samples < most).chain([most]).collect()
}

fn details(scene: &SceneData) -> Element {
    let most = scene.choices.iter().flat_map(|c| &c.levels).map(|l| l.samples).max().unwrap_or(1);
    let table = table(&scene.choices)
        .caption(format!("{}: error, time and bias", capital(scene.subject.name)))
        .group("")
        .column("choice", |choice| &choice.name)
        .group("relative error in %, by samples");
    error_columns(table, shown(most), |level| level.relative_rmse.map(|e| 100.0 * e))
        .group(&format!("with {most} samples"))
        .column("time per sample of all pixels", |choice| choice.sample_time())
        .column("efficiency, 1/s", |choice| rough_or_dash(choice.efficiency()))
        .column("time for the same noise", |choice| ratio_or_biased(scene, choice))
        .group("in the mean")
        .column("bias, %", |choice| percent(&choice.kind.bias))
        .element()
}

fn biases(scene: &SceneData) -> Element {
    let deepest = format!("max_depth {}", scene.deepest);
    let depths = scene.depths.iter().map(|bias| (bias, &*deepest));
    let rules = scene.rules.iter().map(|bias| (bias, "the book's rule"));
    table(depths.chain(rules))
        .caption("Bias of depth limits and rules: difference of the mean, %")
        .column("choice", |(bias, _)| &bias.name)
        .column("compared with", |(_, other)| *other)
        .column("bias, %", |(bias, _)| percent(bias))
        .element()
}

fn levels(scene: &SceneData) -> Element {
    let all = scene.choices.iter().flat_map(|c| c.levels.iter().map(|level| (&*c.name, level)));
    table(all)
        .caption("Errors, noise and time")
        .column("choice", |(choice, _)| *choice)
        .column("samples", |(_, level)| level.samples.to_string())
        .column("pictures", |(_, level)| level.pictures.to_string())
        .column("RMSE", |(_, level)| rough_or_dash(level.rmse))
        .column("relative RMSE", |(_, level)| rough_or_dash(level.relative_rmse))
        .column("relative variance", |(_, level)| rough_or_dash(level.relative_variance))
        .column("time of a picture", |(_, l)| flagged(time(l.picture_seconds), l.disturbed))
        .column("efficiency, 1/s", |(_, level)| rough_or_dash(level.efficiency))
        .element()
}
