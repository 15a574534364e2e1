//! Page 4 as tables and pictures, from its data alone.

use super::{BiasData, ChoiceData, Data, Level, SceneData};
use crate::film::{Film, OutOfGamut, Tone, data_uri};
use crate::math::{exp, ln};
use crate::report::html::{
    Table, capital, escaped, figure, flagged, folded, listed, short, short_or_dash, time,
};
use crate::report::plot::{Plot, Series};
use crate::shapes::Sampling;
use crate::verify::quantile;

/// A choice is as good as the best if it takes no more than this times its time.
const AS_GOOD: f64 = 1.5;

pub fn page(data: &Data) -> String {
    let mut html = explanation(data);
    html += &format!("<p class=\"pick\"><strong>What to pick.</strong> {}</p>\n", pick(data));
    html += &summary(data);
    data.scenes.iter().for_each(|scene| html += &section(scene));
    html
}

fn explanation(data: &Data) -> String {
    let depth = data.depth;
    format!(
        "<p>Small pictures of each scene are made by every tracer and every way to sample its lamps, \
         with 1 to 1024 multi-jittered samples for each pixel and max_depth {depth}, and compared with \
         a picture of reference. The <em>relative error</em> is the root mean square over pixels and \
         channels of what they are off, each in units of the brightness of its pixel (and a tenth of \
         the picture's mean, so that black ones count); it is what the eye goes by. The plain root mean \
         square error is in the table behind a click: the brightest pixels, such as the edge of a lamp, \
         make most of it. The error of the reference is taken off, in squares; where the rest is \
         smaller than that, there is a dash. Noise alone is the <em>variance</em>, from one picture to \
         the next of another seed; <em>efficiency</em> is 1/(variance × time), so that a choice of \
         twice the efficiency takes half the time for the same noise, and a choice with a bias may be \
         efficient and wrong. Where rare paths are very bright, as in caustics, few of them make the \
         variance: there, ratios of efficiency below {AS_GOOD} mean little, and an interval may be too \
         short.</p>\n\
         <p><em>Bias</em> is the difference of the mean radiances of whole pictures, with its interval \
         of 95 % confidence: light that is left out, or put in. path_trace, global_trace and path leave \
         nothing out but what lies beyond max_depth, if lamps are surfaces; ray_cast and whitted show \
         direct light (and mirrors), which is less work and another picture: on logarithmic axes their \
         errors become level where those of the others fall, with slope −1/2 or steeper.</p>\n"
    )
}

/// The choice of this name in a scene, or that of its tracer if no lamps are sampled there.
fn named<'a>(scene: &'a SceneData, choice: &ChoiceData) -> Option<&'a ChoiceData> {
    let same = |c: &&ChoiceData| {
        c.tracer == choice.tracer && (c.sampling == choice.sampling || c.sampling.is_none())
    };
    scene.choices.iter().find(same)
}

/// The highest efficiency of a choice without bias.
fn highest(scene: &SceneData) -> Option<f64> {
    let unbiased = scene.choices.iter().filter(|choice| choice.unbiased);
    unbiased.filter_map(ChoiceData::efficiency).reduce(f64::max)
}

/// How many times as long as the best a choice takes for the same noise.
fn times_longer(scene: &SceneData, choice: &ChoiceData) -> Option<f64> {
    Some(highest(scene)? / choice.efficiency()?)
}

/// One choice in all scenes.
struct Record<'a> {
    choice: &'a ChoiceData,
    /// How many times as long as the best it takes, in each scene where it applies and has no bias.
    times: Vec<Option<f64>>,
}

impl Record<'_> {
    fn longest(&self) -> f64 {
        self.times.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// The geometric mean over the scenes where it applies and has no bias.
    fn typical(&self) -> f64 {
        let logs: Vec<f64> = self.times.iter().flatten().map(|times| ln(*times)).collect();
        exp(logs.iter().sum::<f64>() / logs.len() as f64)
    }

    fn applies_everywhere(&self) -> bool {
        self.times.iter().all(Option::is_some)
    }

    /// In how many scenes it is as good as the best.
    fn wins(&self) -> usize {
        self.times.iter().flatten().filter(|times| **times <= AS_GOOD).count()
    }
}

/// Every choice of the scene with the most.
fn all_choices(data: &Data) -> &[ChoiceData] {
    let most = data.scenes.iter().max_by_key(|scene| scene.choices.len());
    most.map_or(&[], |scene| &scene.choices)
}

/// Every choice that has no bias somewhere.
fn records(data: &Data) -> Vec<Record<'_>> {
    let record = |choice| {
        let times = |scene| {
            let here = named(scene, choice).filter(|here| here.unbiased)?;
            times_longer(scene, here)
        };
        Record { choice, times: data.scenes.iter().map(times).collect() }
    };
    all_choices(data).iter().map(record).filter(|r| r.times.iter().any(Option::is_some)).collect()
}

/// One sentence for all scenes: the choice without bias that takes least in the mean, what the others
/// take, and what those with a bias leave out.
fn pick(data: &Data) -> String {
    let records = records(data);
    let by_mean = |a: &&Record<'_>, b: &&Record<'_>| a.typical().total_cmp(&b.typical());
    let everywhere = records.iter().filter(|record| record.applies_everywhere());
    let Some(best) = everywhere.min_by(by_mean) else {
        return "No choice is without bias in every scene.".to_owned();
    };
    let others = ["path_trace", "global_trace", "path"].into_iter().filter_map(|tracer| {
        let of_tracer =
            |r: &&Record<'_>| r.choice.tracer == tracer && r.choice.choice != best.choice.choice;
        let other = records.iter().filter(of_tracer).min_by(by_mean)?;
        Some(format!("{} {} times", words(other.choice), short(other.typical())))
    });
    let others = listed(&others.collect::<Vec<String>>());
    let missed = ["ray_cast", "whitted"].into_iter().filter_map(|tracer| {
        let all = data.scenes.iter().flat_map(|scene| &scene.choices);
        let biases = all.filter(|c| c.tracer == tracer).filter_map(|c| c.bias.difference);
        let largest = biases.map(|[bias, ..]| bias.abs()).reduce(f64::max)?;
        Some(format!("{} % with {tracer}", short(100.0 * largest)))
    });
    let missed = listed(&missed.collect::<Vec<String>>());
    format!(
        "Choose {}: of the choices without bias it takes the least time for the same noise, or at most \
         {AS_GOOD} times that, in {} of {} scenes, {} times the least in their geometric mean and {} \
         times in the worst of them (in the mean {others}); a picture's mean is off by up to {missed}.",
        words(best.choice),
        best.wins(),
        data.scenes.len(),
        short(best.typical()),
        short(best.longest()),
    )
}

/// A choice in a sentence.
fn words(choice: &ChoiceData) -> String {
    match choice.sampling {
        None => choice.tracer.clone(),
        Some(Sampling::Area) => format!("{} with lamps by area", choice.tracer),
        Some(Sampling::SolidAngle) => format!("{} with lamps by solid angle", choice.tracer),
    }
}

/// Time for the same noise, of all.
fn summary(data: &Data) -> String {
    let row = |choice: &ChoiceData| {
        let of = |scene: &SceneData| match named(scene, choice) {
            None => "–".to_owned(),
            Some(here) if !here.unbiased => "biased".to_owned(),
            Some(here) => short_or_dash(times_longer(scene, here)),
        };
        std::iter::once(choice.choice.clone()).chain(data.scenes.iter().map(of)).collect()
    };
    Table {
        caption: "Time for the same noise, as a multiple of the least".to_owned(),
        headings: std::iter::once("choice".to_owned())
            .chain(data.scenes.iter().map(|scene| scene.scene.clone()))
            .collect(),
        rows: all_choices(data).iter().map(row).collect(),
        ..Table::default()
    }
    .html()
}

fn section(scene: &SceneData) -> String {
    let mut html = format!(
        "<h3>{}</h3>\n<p>{} {}</p>\n",
        capital(&scene.scene),
        escaped(&scene.about),
        reference(scene)
    );
    html += &format!("<p class=\"pick\"><strong>Here:</strong> {}</p>\n", pick_here(scene));
    html.push_str("<div class=\"pictures\">\n");
    let samples = |level: &Level| f64::from(level.samples);
    html += &figure(
        &picture(scene, "samples for each pixel", samples).svg(),
        "Relative error against samples.",
    );
    let seconds = |level: &Level| level.picture_seconds;
    html += &figure(
        &picture(scene, "seconds for the picture, on one thread", seconds).svg(),
        "The same against time.",
    );
    html.push_str("</div>\n");
    html += &equal_time(scene);
    html += &table(scene).html();
    html += &biases(scene).html();
    html + &folded("Errors, noise and time of every number of samples", &levels(scene).html())
}

fn reference(scene: &SceneData) -> String {
    let r = &scene.reference;
    format!(
        "{} × {} pixels; the reference is {} with {} samples for each pixel, whose own standard error \
         is {} % (radiance: {} of a mean of {}).",
        scene.width,
        scene.height,
        r.choice,
        r.samples,
        short(100.0 * r.relative_standard_error),
        short(r.standard_error),
        short(r.mean),
    )
}

/// The best without bias, those that are as good, and how much sooner and how wrong the biased are.
fn pick_here(scene: &SceneData) -> String {
    let times = |choice: &ChoiceData| times_longer(scene, choice).unwrap_or(f64::INFINITY);
    let mut unbiased: Vec<&ChoiceData> = scene.choices.iter().filter(|c| c.unbiased).collect();
    unbiased.sort_by(|a, b| times(a).total_cmp(&times(b)));
    let Some((best, others)) = unbiased.split_first() else { return String::new() };
    let as_good: Vec<String> = others
        .iter()
        .filter(|choice| times(choice) <= AS_GOOD)
        .map(|choice| choice.choice.clone())
        .collect();
    let beside = match as_good.len() {
        0 => String::new(),
        _ => format!(" (or {}, about as good)", listed(&as_good)),
    };
    let slower = others.iter().filter(|choice| times(choice) > AS_GOOD);
    let slower: Vec<String> =
        slower.map(|c| format!("{} takes {} times", c.choice, short(times(c)))).collect();
    let slower = match slower.len() {
        0 => String::new(),
        _ => format!("; for the same noise {} its time", listed(&slower)),
    };
    let darker = |choice: &ChoiceData| {
        let [bias, ..] = choice.bias.difference?;
        let word = if bias < 0.0 { "too dark" } else { "too bright" };
        Some(format!("{} {} % {word}", choice.choice, short(100.0 * bias.abs())))
    };
    // both samplings of a lamp give the same mean
    let biased = scene.choices.iter().filter(|c| !c.unbiased && is_drawn(c));
    let biased: Vec<String> = biased.filter_map(darker).collect();
    let biased = match biased.len() {
        0 => String::new(),
        _ => format!("; in the mean, {}", listed(&biased)),
    };
    format!("the best is {}{beside}{slower}{biased}.", best.choice)
}

/// At most five choices are drawn: lamps by solid angle.
fn is_drawn(choice: &ChoiceData) -> bool {
    choice.sampling != Some(Sampling::Area)
}

fn picture(scene: &SceneData, x: &str, along: impl Fn(&Level) -> f64) -> Plot {
    let series = |choice: &ChoiceData| {
        let point = |level: &Level| Some((along(level), level.relative_rmse?));
        Series {
            name: choice.choice.clone(),
            points: choice.levels.iter().filter_map(point).collect(),
            joined: true,
            ..Series::default()
        }
    };
    let own = scene.reference.relative_standard_error;
    Plot {
        x: x.to_owned(),
        y: "relative error".to_owned(),
        series: scene.choices.iter().filter(|c| is_drawn(c)).map(series).collect(),
        limit: (own > 0.0).then(|| (own, "the reference's own error".to_owned())),
    }
}

fn equal_time(scene: &SceneData) -> String {
    let Some(truth) = scene.equal_time.crops.last() else { return String::new() };
    let brightnesses: Vec<f64> = truth.film.pixels().iter().map(|pixel| pixel.average()).collect();
    let bright = quantile(&brightnesses, 0.9).filter(|b| *b > 0.0).unwrap_or(1.0);
    let tone = Tone { exposure: 0.7 / bright, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let image = |film: &Film, what: &str| {
        format!("<img alt=\"{}\" src=\"{}\"/>", escaped(what), data_uri(film, &tone))
    };
    let mut html = format!(
        "<p>About {} each, on one thread, and last what they should look like:</p>\n<div class=\"crops\">\n",
        time(scene.equal_time.seconds)
    );
    for crop in &scene.equal_time.crops {
        let words = format!("{}: {} samples, {}", crop.choice, crop.samples, time(crop.seconds));
        html += &figure(&image(&crop.film, &crop.choice), &words);
    }
    html + "</div>\n"
}

/// In percent: `−12.3 (−12.9 … −11.7)`.
fn percent(bias: &BiasData) -> String {
    let Some(ends) = bias.difference else { return "–".to_owned() };
    let [value, low, high] = ends.map(|end| 100.0 * end);
    let digits = if high - low < 0.2 { 2 } else { 1 };
    format!("{value:+.digits$} ({low:+.digits$} … {high:+.digits$})")
        .replace('-', "−")
        .replace(' ', "\u{a0}")
}

fn table(scene: &SceneData) -> Table {
    let most = scene.choices.iter().flat_map(|c| &c.levels).map(|l| l.samples).max().unwrap_or(1);
    let mut shown = vec![1, 16, 256, most];
    shown.dedup();
    let row = |choice: &ChoiceData| {
        let at = |n: &u32| {
            let level = choice.levels.iter().find(|level| level.samples == *n);
            short_or_dash(level.and_then(|level| level.relative_rmse).map(|e| 100.0 * e))
        };
        let disturbed = choice.levels.iter().any(|level| level.disturbed);
        let mut cells = vec![choice.choice.clone()];
        cells.extend(shown.iter().map(at));
        cells.extend([
            flagged(time(choice.sample_seconds()), disturbed),
            short_or_dash(choice.efficiency()),
            match choice.unbiased {
                true => short_or_dash(times_longer(scene, choice)),
                false => "biased".to_owned(),
            },
            percent(&choice.bias),
        ]);
        cells
    };
    let mut headings = vec!["choice".to_owned()];
    headings.extend(shown.iter().map(u32::to_string));
    let rest = ["time for a sample of each pixel", "efficiency, 1/s", "time for the same noise"];
    headings.extend(rest.map(str::to_owned));
    headings.push("bias, %".to_owned());
    Table {
        caption: format!("{}: error, time and bias", capital(&scene.scene)),
        groups: vec![
            (String::new(), 1),
            ("relative error in %, by samples".to_owned(), shown.len()),
            (format!("with {most} samples"), 3),
            ("in the mean".to_owned(), 1),
        ],
        headings,
        rows: scene.choices.iter().map(row).collect(),
    }
}

fn biases(scene: &SceneData) -> Table {
    let against = |whom: &str| {
        let whom = whom.to_owned();
        move |bias: &BiasData| vec![bias.name.clone(), whom.clone(), percent(bias)]
    };
    let deepest = format!("max_depth {}", scene.deepest);
    let depths = scene.depths.iter().map(against(&deepest));
    let rules = scene.rules.iter().map(against("the book's rule"));
    Table {
        caption: "Bias of depth limits and rules: difference of the mean, %".to_owned(),
        headings: ["choice", "against", "bias, %"].map(str::to_owned).to_vec(),
        rows: depths.chain(rules).collect(),
        ..Table::default()
    }
}

fn levels(scene: &SceneData) -> Table {
    let row = |(choice, level): (&ChoiceData, &Level)| {
        vec![
            choice.choice.clone(),
            level.samples.to_string(),
            level.pictures.to_string(),
            short_or_dash(level.rmse),
            short_or_dash(level.relative_rmse),
            short_or_dash(level.relative_variance),
            flagged(time(level.picture_seconds), level.disturbed),
            short_or_dash(level.efficiency),
        ]
    };
    let all = scene.choices.iter().flat_map(|c| c.levels.iter().map(move |level| (c, level)));
    let headings = [
        "choice",
        "samples",
        "pictures made",
        "RMSE",
        "relative RMSE",
        "relative variance",
        "time of a picture",
        "efficiency, 1/s",
    ];
    Table {
        caption: "Errors, noise and time".to_owned(),
        headings: headings.map(str::to_owned).to_vec(),
        rows: all.map(row).collect(),
        ..Table::default()
    }
}
