//! Page 2 as tables and plots, from its data alone.

use std::collections::BTreeSet;

use super::{Data, Run, StageData};
use crate::html::{Table, bytes, capital, count, escaped, figure, flagged, listed, short, time};
use crate::plot::{Plot, Series};
use statistics::slope::{PowerLaw, power_law};

/// Slopes are fitted from this number of objects on, if there are at least three sizes.
const FITTED_FROM: usize = 1000;
/// The confidence level of the intervals of slopes.
const CONFIDENCE: f64 = 0.95;
/// A structure is as good as the best if its time is at most this multiple of the best time.
const AS_GOOD: f64 = 1.1;

pub fn page(data: &Data) -> String {
    let mut html = explanation(data);
    html += &format!("<p class=\"pick\"><strong>What to pick.</strong> {}</p>\n", pick(data));
    for stage in &data.stages {
        html += &format!("<h3>{}</h3>\n<p>{}</p>\n", capital(&stage.stage), escaped(&stage.about));
        if !stage.agree {
            html.push_str(
                "<p class=\"bad\">The structures disagree about some rays, which is a bug to be \
                 reported.</p>\n",
            );
        }
        html += "<div class=\"pictures\">\n";
        let time = format!("seconds for {0} × {0} rays", data.side);
        html += &figure(&picture(stage, &time, picture_time).svg(), &caption(stage, picture_time));
        let work = figure(&picture(stage, WORK, work).svg(), &caption(stage, work));
        html += &(work + "</div>\n");
        html += &table(stage).html();
        html += &skipped(stage);
    }
    html
}

fn explanation(data: &Data) -> String {
    let side = data.side;
    format!(
        "<p>The acceleration structures are compared: a <em>list</em> of all objects, a regular \
         <em>grid</em>, grids within a grid, and a bounding volume hierarchy (<em>bvh</em>). All find \
         the same first hit. The time for a picture is that of the first hits of {side} × {side} rays \
         on one thread, without shading; tests, and nodes or cells, are counted per ray.</p>\n\
         <p>On logarithmic axes a power of the number of objects is a straight line, and its slope is \
         the exponent: 1 for a list, about 1/3 for a grid over evenly spread objects, near 0 for \
         a structure whose time hardly depends on the number of objects. Slopes are fitted from \
         {FITTED_FROM} objects on (from the first, if fewer than three sizes are as large), with an \
         interval of {:.0} % confidence. Where not every ray is timed, the time is extrapolated.</p>\n",
        100.0 * CONFIDENCE
    )
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

/// The largest ratio of a structure's time to the best time of the scene and size, with scene and
/// size; `None` if the structure was skipped in a scene.
fn regret<'a>(data: &'a Data, structure: &str, from: usize) -> Option<(f64, &'a StageData, usize)> {
    let mut worst: Option<(f64, &StageData, usize)> = None;
    for stage in &data.stages {
        if stage.skipped.iter().any(|skipped| skipped.structure == structure) {
            return None;
        }
        for run in runs(stage, structure).filter(|run| run.objects >= from) {
            let ratio = run.picture_seconds / best(stage, run.objects)?.picture_seconds;
            if worst.is_none_or(|(so_far, ..)| ratio > so_far) {
                worst = Some((ratio, stage, run.objects));
            }
        }
    }
    worst
}

fn best(stage: &StageData, objects: usize) -> Option<&Run> {
    let rivals = stage.runs.iter().filter(|run| run.objects == objects);
    rivals.min_by(|a, b| a.picture_seconds.total_cmp(&b.picture_seconds))
}

/// The recommendation.
fn pick(data: &Data) -> String {
    let names = structures(&data.stages);
    let largest = data.stages.iter().flat_map(|s| &s.runs).map(|run| run.objects).max();
    let from = FITTED_FROM.min(largest.unwrap_or(0) / 2);
    let regrets = names.iter().filter_map(|&name| Some((name, regret(data, name, from)?)));
    let mut regrets: Vec<_> = regrets.collect();
    regrets.sort_by(|(_, a), (_, b)| a.0.total_cmp(&b.0));
    let Some((name, (ratio, stage, objects))) = regrets.first() else {
        return "None: every structure was too slow in some scene.".to_owned();
    };
    let mut text =
        format!("The {name}, if nothing is known about the scene: from {from} objects on ");
    text += &if *ratio <= AS_GOOD {
        "it is the fastest in every scene, or as fast as the fastest. ".to_owned()
    } else {
        let (ratio, stage) = (short(*ratio), &stage.stage);
        format!(
            "it takes at most {ratio} times the time of the best (in {stage}, {} objects). ",
            count(*objects)
        )
    };
    for (other, (ratio, stage, objects)) in &regrets[1..] {
        let (ratio, stage) = (short(*ratio), &stage.stage);
        text += &format!(
            "The {other} takes up to {ratio} times ({stage}, {} objects). ",
            count(*objects)
        );
    }
    text + &of_each_scene(data) + &lists(data, name)
}

/// The fastest structure at the largest size of each scene.
fn of_each_scene(data: &Data) -> String {
    let largest = |stage: &'_ StageData| stage.runs.iter().map(|run| run.objects).max();
    let fastest: Vec<(&StageData, &Run)> = data
        .stages
        .iter()
        .filter_map(|stage| Some((stage, best(stage, largest(stage)?)?)))
        .collect();
    let winners: BTreeSet<&str> = fastest.iter().map(|(_, run)| &*run.structure).collect();
    if let (Some(winner), 1) = (winners.first(), winners.len()) {
        return format!("At the largest size of every scene the {winner} is the fastest. ");
    }
    let words = |(stage, run): &(&StageData, &Run)| {
        format!("{} ({}, {} objects)", run.structure, stage.stage, count(run.objects))
    };
    let words: Vec<String> = fastest.iter().map(words).collect();
    format!("The fastest at the largest sizes: {}. ", listed(&words))
}

/// The scenes in which a list is the fastest for few objects.
fn lists(data: &Data, pick: &str) -> String {
    let pays = |stage: &&StageData| {
        stage.runs.iter().any(|run| {
            let wins = best(stage, run.objects).is_some_and(|best| best.structure == "list");
            run.structure == "list" && wins
        })
    };
    let scenes: Vec<String> =
        data.stages.iter().filter(pays).map(|stage| stage.stage.clone()).collect();
    if scenes.is_empty() && pick != "list" {
        let least = data.stages.iter().flat_map(|s| &s.runs).map(|run| run.objects).min();
        return format!("A list is not the fastest even for {} objects.", least.unwrap_or(0));
    }
    format!("A list is the fastest for few objects of: {}.", listed(&scenes))
}

/// The quantity of a run that is drawn.
type Quantity = fn(&Run) -> f64;

fn picture_time(run: &Run) -> f64 {
    run.picture_seconds
}

/// The axis label of [`work`].
const WORK: &str = "tests, nodes and cells per ray";

/// Tests, and nodes or cells if they are counted.
fn work(run: &Run) -> f64 {
    run.tests_per_ray + run.steps_per_ray.unwrap_or(0.0)
}

/// The fitted slope, and the ends of the line.
fn slope(stage: &StageData, structure: &str, of: Quantity) -> Option<(PowerLaw, [f64; 2])> {
    let all: Vec<(f64, f64)> =
        runs(stage, structure).map(|run| (run.objects as f64, of(run))).collect();
    // 0.9: a mesh cannot have every number of triangles, so "1000" may be a few less
    let large: Vec<_> = all.iter().copied().filter(|p| p.0 >= 0.9 * FITTED_FROM as f64).collect();
    let fitted = if large.len() >= 3 { large } else { all };
    let ends = [fitted.first()?.0, fitted.last()?.0];
    Some((power_law(&fitted, CONFIDENCE)?, ends))
}

fn signed(x: f64) -> String {
    let text = format!("{x:.2}");
    if text == "-0.00" { "0.00".to_owned() } else { text.replace('-', "−") }
}

fn picture(stage: &StageData, y: &str, of: Quantity) -> Plot {
    let series = |name: &str| {
        let fit = slope(stage, name, of);
        let legend = fit
            .map_or(name.to_owned(), |(law, _)| format!("{name}: slope {}", signed(law.exponent)));
        let points = runs(stage, name).map(|run| (run.objects as f64, of(run)));
        Series { name: legend, points: points.collect(), fit, joined: true, ..Series::default() }
    };
    Plot {
        x: "objects".to_owned(),
        y: y.to_owned(),
        series: structures([stage]).into_iter().map(series).collect(),
        limit: None,
    }
}

fn caption(stage: &StageData, of: Quantity) -> String {
    let words = |&name: &&str| {
        let (law, _) = slope(stage, name, of)?;
        let [low, high] = law.interval.map(signed);
        Some(format!("{name} {} ({low} to {high})", signed(law.exponent)))
    };
    let slopes: Vec<String> = structures([stage]).iter().filter_map(words).collect();
    format!("{}. Slopes: {}.", capital(&stage.stage), listed(&slopes))
}

/// The powers of ten only; all sizes are in `report.json`.
fn table(stage: &StageData) -> Table {
    let objects: BTreeSet<usize> = stage.runs.iter().map(|run| run.objects).collect();
    let shown: BTreeSet<usize> = objects.into_iter().step_by(2).collect();
    let row = |run: &Run| {
        vec![
            run.structure.clone(),
            count(run.objects),
            time(run.build_seconds),
            run.memory_bytes.map_or("–".to_owned(), |count| bytes(count as f64)),
            flagged(time(run.picture_seconds), run.disturbed),
            short(run.tests_per_ray),
            run.steps_per_ray.map_or("–".to_owned(), short),
            count(run.timed_rays),
        ]
    };
    let names = structures([stage]);
    let all = names.iter().flat_map(|name| runs(stage, name));
    let headings = [
        "structure",
        "objects",
        "build",
        "memory",
        "picture",
        "tests per ray",
        "nodes or cells per ray",
        "rays timed",
    ];
    Table {
        caption: format!("{}, by number of objects", capital(&stage.stage)),
        groups: Vec::new(),
        headings: headings.map(str::to_owned).into(),
        rows: all.filter(|run| shown.contains(&run.objects)).map(row).collect(),
    }
}

/// One sentence for each structure that was skipped.
fn skipped(stage: &StageData) -> String {
    let mut html = String::new();
    let mut names: Vec<&str> = stage.skipped.iter().map(|s| &*s.structure).collect();
    names.dedup();
    names.sort_unstable();
    names.dedup();
    for name in names {
        let skipped: Vec<_> = stage.skipped.iter().filter(|s| s.structure == name).collect();
        let sizes: Vec<String> = skipped.iter().map(|s| count(s.objects)).collect();
        let why = skipped.first().map_or("", |s| &*s.why);
        html += &format!(
            "<p class=\"about\">Skipped: {name}, for {} objects ({}).</p>\n",
            listed(&sizes),
            escaped(why)
        );
    }
    html
}
