//! Page 3 as tables and plots, from its data alone.

use super::{Data, FITTED_FROM, IntegrandData, SamplerData};
use crate::convergence::CONFIDENCE;
use crate::plot::{Plot, Series};
use crate::words::*;
use text::digits::rough;
use text::document::*;

/// A sampler is as good as the best if it needs at most this multiple of its samples.
const AS_GOOD: f64 = 1.2;
/// The book's samplers, in the first plot of each integrand; the second plot has the others and
/// random.
const BOOKS: [&str; 5] = ["random", "regular", "jittered", "n rooks", "multi jittered"];

pub fn page(data: &Data) -> Element {
    let explanation = format!(
        include_str!("explanation.txt"),
        pixels = data.pixels,
        seeds = data.seeds,
        from = FITTED_FROM,
        confidence = 100.0 * CONFIDENCE
    );
    several()
        .with(prose(&explanation))
        .with(summary(data))
        .with_all(data.integrands.iter().map(section))
}

fn section(data: &IntegrandData) -> Element {
    let of_book = |s: &&SamplerData| BOOKS.contains(&&*s.sampler);
    let (book, others): (Vec<_>, Vec<_>) = data.samplers.iter().partition(of_book);
    let first = book.iter().filter(|s| s.sampler == BOOKS[0]).copied();
    let others: Vec<&SamplerData> = first.chain(others).collect();
    let plots = [
        plot(&book).figure("Five of the book's samplers."),
        plot(&others).figure("Random samples again, and the other samplers."),
    ];
    several()
        .with(beginning(data.integrand.name, data.integrand.about))
        .with(pick("What to pick.", advice(data) + &smallest(data)))
        .with(group("pictures").with_all(plots))
        .with(details(data))
}

/// The table of the samples for an error of 1 %.
fn summary(data: &Data) -> Element {
    let samplers = data.integrands[0].samplers.iter().enumerate();
    let mut table = table(samplers)
        .caption("Samples per pixel for an error of 1 %")
        .column("sampler", |(_, it)| &it.sampler);
    for IntegrandData { integrand, samplers } in &data.integrands {
        table = table.column(integrand.name, |(index, _)| samples_needed(&samplers[*index]));
    }
    table.element()
}

fn samples_needed(s: &SamplerData) -> String {
    let most = s.errors.last().map_or(0, |e| e.samples);
    s.samples_for_one_percent.map_or(format!("> {}", count(most as usize)), rough)
}

fn plot(samplers: &[&SamplerData]) -> Plot<'static> {
    let series = |s: &&SamplerData| {
        Series::joined(&s.sampler, s.errors.iter().map(|e| (f64::from(e.samples), e.rms)))
    };
    Plot {
        x: "samples per pixel",
        y: "root mean square error",
        series: samplers.iter().map(series).collect(),
        limit: Some((super::ONE_PERCENT, "1 %")),
    }
}

/// Samplers with the same samples in every pixel: their errors form patterns, which the root mean
/// square does not show.
const FIXED: [&str; 2] = ["regular", "hammersley"];

/// One sentence: the sampler with the fewest samples for 1 %, those that are as good, the number of
/// random samples, and a fixed sampler that needs even fewer.
fn advice(data: &IntegrandData) -> String {
    let known = by_need(data, false);
    let Some(&(best, fewest)) = known.first() else {
        let last = |s: &SamplerData| s.errors.last().map_or(f64::INFINITY, |e| e.rms);
        let best = data.samplers.iter().min_by(|a, b| last(a).total_cmp(&last(b)));
        return best.map_or(String::new(), |best| {
            format!("None reaches 1 %; {} has the smallest error.", best.sampler)
        });
    };
    let as_good = known[1..].iter().filter(|(_, samples)| *samples <= AS_GOOD * fewest);
    let as_good = or_as_good(as_good.map(|(s, _)| &s.sampler));
    let random = match known.iter().find(|(s, _)| s.sampler == "random") {
        Some((_, samples)) => format!("random samples need {}", rough(*samples)),
        None => "random samples do not reach it".to_owned(),
    };
    let fixed = match by_need(data, true).first() {
        Some((fixed, samples)) if *samples < fewest => format!(
            "; {} needs only {}, but has the same error in all pixels, which is visible as patterns",
            fixed.sampler,
            rough(*samples),
        ),
        _ => String::new(),
    };
    let (best, fewest) = (capital(&best.sampler), rough(fewest));
    format!("{best}{as_good}: {fewest} samples make the error 1 %; {random}{fixed}.")
}

/// One sentence: the sampler with the smallest error for each of a few numbers of samples; without fixed ones.
fn smallest(data: &IntegrandData) -> String {
    let of_number = |n: u32| {
        let of_kind = data.samplers.iter().filter(|s| !FIXED.contains(&&*s.sampler));
        let known = of_kind.filter_map(|s| Some((s, s.error(n)?)));
        let (best, least) = known.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let random = data.samplers.iter().find(|s| s.sampler == BOOKS[0])?.error(n)?;
        let (least, random) = (rough(least), rough(random));
        Some(format!("with {n} samples {} ({least}, random {random})", best.sampler))
    };
    match [4, 16, 64].into_iter().filter_map(of_number).collect::<Vec<String>>().join(", ") {
        none if none.is_empty() => none,
        found => format!(" The smallest error has {found}."),
    }
}

/// The samplers that are fixed, or those that are not, with the samples that each needs for 1 %,
/// the fewest first; without those that do not reach 1 %.
fn by_need(data: &IntegrandData, fixed: bool) -> Vec<(&SamplerData, f64)> {
    let of_kind = data.samplers.iter().filter(|s| FIXED.contains(&&*s.sampler) == fixed);
    let mut known: Vec<(&SamplerData, f64)> =
        of_kind.filter_map(|s| Some((s, s.samples_for_one_percent?))).collect();
    known.sort_by(|a, b| a.1.total_cmp(&b.1));
    known
}

fn details(data: &IntegrandData) -> Element {
    let error = |samples: u32| move |s: &&SamplerData| rough_or_dash(s.error(samples));
    let slope =
        |[slope, low, high]: [f64; 3]| with_minus(&format!("{slope:.2} ({low:.2} … {high:.2})"));
    table(&data.samplers)
        .caption(format!("{}: error and cost", capital(data.integrand.name)))
        .column("sampler", |s| &s.sampler)
        .column("error, 16 samples", error(16))
        .column("256", error(256))
        .column("4096", error(4096))
        .column("slope", |s| s.slope.map_or(DASH.to_owned(), slope))
        .column("samples for 1 %", |s| samples_needed(s))
        .column("seconds for 1 %", |s| {
            let seconds = s.samples_for_one_percent.map(|samples| samples * s.sample_seconds);
            flagged(seconds.map_or(DASH.to_owned(), time), s.disturbed)
        })
        .element()
}
