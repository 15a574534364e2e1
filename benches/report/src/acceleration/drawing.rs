//! Page 2 as tables and plots, from its data alone.

use std::collections::BTreeSet;

use super::{Data, Run, StageData};
use crate::convergence::CONFIDENCE;
use crate::plot::{Plot, Series};
use crate::words::*;
use statistics::slope::{PowerLaw, power_law};
use text::digits::rough;
use text::document::*;

/// Slopes are fitted from this number of objects on, if there are at least three sizes.
const FITTED_FROM: usize = 1000;
/// A structure is as good as the best if its time is at most this multiple of the best time.
const AS_GOOD: f64 = 1.1;

pub fn page(data: &Data) -> Element {
    let explanation = format!(
        include_str!("explanation.txt"),
        side = data.side,
        from = FITTED_FROM,
        confidence = 100.0 * CONFIDENCE
    );
    several()
        .with(prose(&explanation))
        .with(pick("What to pick.", advice(data)))
        .with_all(data.stages.iter().map(|stage| section(stage, data.side)))
}

fn section(stage: &StageData, side: u32) -> Element {
    const DISAGREE: &str =
        "The structures disagree about some rays, which is a bug to be reported.";
    let seconds = format!("seconds for {side} × {side} rays");
    let plots = [
        plot(stage, &seconds, |run| run.picture_seconds),
        plot(stage, "tests, nodes and cells per ray", work),
    ];
    several()
        .with(beginning(stage.stage.name, stage.stage.about))
        .with_all((!stage.agree).then(|| paragraph(DISAGREE).class("bad")))
        .with(group("pictures").with_all(plots))
        .with(details(stage))
        .with_all(skipped(stage))
}

/// The names of the structures, in the order in which they first appear.
fn structures<'a>(stages: impl IntoIterator<Item = &'a StageData>) -> Vec<&'a str> {
    let mut names = Vec::new();
    for run in stages.into_iter().flat_map(|stage| &stage.runs) {
        if !names.contains(&&*run.structure) {
            names.push(&*run.structure);
        }
    }
    names
}

fn runs<'a>(stage: &'a StageData, structure: &'a str) -> impl Iterator<Item = &'a Run> {
    stage.runs.iter().filter(move |run| run.structure == structure)
}

/// The numbers of objects of all runs.
fn sizes(stage: &StageData) -> impl Iterator<Item = usize> {
    stage.runs.iter().map(|run| run.objects)
}

/// The largest ratio of a structure's time to the best time of the scene and size.
struct Regret<'a> {
    structure: &'a str,
    ratio: f64,
    /// The scene and size.
    place: String,
}

/// The regret of a structure, from a number of objects on; `None` if it was skipped in a scene.
fn regret<'a>(data: &'a Data, structure: &'a str, from: usize) -> Option<Regret<'a>> {
    let is_skipped =
        |stage: &StageData| stage.skipped.iter().any(|skipped| skipped.structure == structure);
    if data.stages.iter().any(is_skipped) {
        return None;
    }
    let of_run = |(stage, run): (&'a StageData, &'a Run)| {
        let ratio = run.picture_seconds / best(stage, run.objects)?.picture_seconds;
        Some(Regret { structure, ratio, place: place(stage, run) })
    };
    let runs = data.stages.iter().flat_map(|stage| runs(stage, structure).map(move |r| (stage, r)));
    let all = runs.filter(|(_, run)| run.objects >= from).filter_map(of_run);
    all.reduce(|worst, next| if next.ratio > worst.ratio { next } else { worst })
}

/// `bumpy mesh, 1000 objects`.
fn place(stage: &StageData, run: &Run) -> String {
    format!("{}, {} objects", stage.stage.name, count(run.objects))
}

fn best(stage: &StageData, objects: usize) -> Option<&Run> {
    let rivals = stage.runs.iter().filter(|run| run.objects == objects);
    rivals.min_by(|a, b| a.picture_seconds.total_cmp(&b.picture_seconds))
}

fn advice(data: &Data) -> String {
    let names = structures(&data.stages);
    let largest = data.stages.iter().flat_map(sizes).max();
    let from = FITTED_FROM.min(largest.unwrap_or(0) / 2);
    let mut regrets: Vec<Regret<'_>> =
        names.iter().filter_map(|name| regret(data, name, from)).collect();
    regrets.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let Some((least, others)) = regrets.split_first() else {
        return "None: every structure was too slow in some scene.".to_owned();
    };
    let name = least.structure;
    let mut text =
        format!("The {name}, if nothing is known about the scene: from {from} objects on ");
    text += &match least.ratio <= AS_GOOD {
        true => "it is the fastest in every scene, or as fast as the fastest. ".to_owned(),
        false => {
            let (ratio, place) = (rough(least.ratio), &least.place);
            format!("it takes at most {ratio} times the time of the best (in {place}). ")
        }
    };
    for Regret { structure, ratio, place } in others {
        text += &format!("The {structure} takes up to {} times ({place}). ", rough(*ratio));
    }
    text + &of_each_scene(data) + &lists(data, name)
}

/// The fastest structure at the largest size of each scene.
fn of_each_scene(data: &Data) -> String {
    let fastest_of = |stage| Some((stage, best(stage, sizes(stage).max()?)?));
    let fastest: Vec<(&StageData, &Run)> = data.stages.iter().filter_map(fastest_of).collect();
    let winners: BTreeSet<&str> = fastest.iter().map(|(_, run)| &*run.structure).collect();
    if let (Some(winner), 1) = (winners.first(), winners.len()) {
        return format!("At the largest size of every scene the {winner} is the fastest. ");
    }
    let words =
        fastest.iter().map(|(stage, run)| format!("{} ({})", run.structure, place(stage, run)));
    format!("The fastest at the largest sizes: {}. ", listed(words))
}

/// The scenes in which a list is the fastest for few objects.
fn lists(data: &Data, pick: &str) -> String {
    let pays = |stage: &&StageData| {
        let fastest = |run: &Run| best(stage, run.objects);
        runs(stage, "list").filter_map(fastest).any(|best| best.structure == "list")
    };
    let scenes: Vec<&str> = data.stages.iter().filter(pays).map(|it| it.stage.name).collect();
    if scenes.is_empty() && pick != "list" {
        let least = data.stages.iter().flat_map(sizes).min();
        return format!("A list is not the fastest even for {} objects.", least.unwrap_or(0));
    }
    format!("A list is the fastest for few objects of: {}.", listed(&scenes))
}

/// Tests, and nodes or cells.
fn work(run: &Run) -> f64 {
    run.tests_per_ray + run.steps_per_ray
}

/// The power law of points of numbers of objects.
fn fit(all: &[(f64, f64)]) -> Option<(PowerLaw, [f64; 2])> {
    // 0.9: a mesh cannot have every number of triangles, so "1000" may be a few less
    let large: Vec<_> = all.iter().copied().filter(|p| p.0 >= 0.9 * FITTED_FROM as f64).collect();
    let fitted = if large.len() >= 3 { &large } else { all };
    let ends = [fitted.first()?.0, fitted.last()?.0];
    Some((power_law(fitted, CONFIDENCE)?, ends))
}

fn signed(x: f64) -> String {
    let text = format!("{x:.2}");
    if text == "-0.00" { "0.00".to_owned() } else { with_minus(&text) }
}

/// The diagram of a quantity of the runs, with the slopes below it.
fn plot(stage: &StageData, y: &str, of: fn(&Run) -> f64) -> Element {
    let mut slopes = Vec::new();
    let series = |name: &str| {
        let points = runs(stage, name).map(|run| (run.objects as f64, of(run)));
        let mut series = Series::joined(name, points);
        series.fit = fit(&series.points);
        if let Some((law, _)) = series.fit {
            let slope = signed(law.exponent);
            let [low, high] = law.interval.map(signed);
            slopes.push(format!("{name} {slope} ({low} to {high})"));
            series.name = format!("{name}: slope {slope}");
        }
        series
    };
    let series = structures([stage]).into_iter().map(series).collect();
    let plot = Plot { x: "objects", y, series, limit: None };
    plot.figure(format!("{}. Slopes: {}.", capital(stage.stage.name), listed(&slopes)))
}

/// The powers of ten only; all sizes are in `report.json`.
fn details(stage: &StageData) -> Element {
    let objects: BTreeSet<usize> = sizes(stage).collect();
    let shown: BTreeSet<usize> = objects.into_iter().step_by(2).collect();
    let names = structures([stage]);
    let all = names.iter().flat_map(|name| runs(stage, name));
    table(all.filter(|run| shown.contains(&run.objects)))
        .caption(format!("{}, by number of objects", capital(stage.stage.name)))
        .column("structure", |run| &run.structure)
        .column("objects", |run| count(run.objects))
        .column("build", |run| time(run.build_seconds))
        .column("memory", |run| run.memory_bytes.map_or(DASH.to_owned(), |n| bytes(n as f64)))
        .column("picture", |run| flagged(time(run.picture_seconds), run.disturbed))
        .column("tests per ray", |run| rough(run.tests_per_ray))
        .column("nodes or cells per ray", |run| rough(run.steps_per_ray))
        .column("rays timed", |run| count(run.timed_rays))
        .element()
}

/// One sentence for each structure that was skipped.
fn skipped(stage: &StageData) -> Vec<Element> {
    let names: BTreeSet<&str> = stage.skipped.iter().map(|s| &*s.structure).collect();
    let sentence = |name: &str| {
        let skipped = || stage.skipped.iter().filter(|s| s.structure == name);
        let sizes = listed(skipped().map(|s| count(s.objects)));
        let why = skipped().next().map_or("", |s| &*s.why);
        let words = format!("Skipped: {name}, for {sizes} objects ({why}).");
        paragraph(words).class("about")
    };
    names.into_iter().map(sentence).collect()
}
