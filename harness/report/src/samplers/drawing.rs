//! Page 3 as tables and plots, from its data alone.

use super::{CONFIDENCE, Data, FITTED_FROM, IntegrandData, SamplerData};
use crate::html::{Table, capital, count, escaped, figure, flagged, listed, short, time};
use crate::plot::{Plot, Series};

/// A sampler is as good as the best if it needs at most this multiple of its samples.
const AS_GOOD: f64 = 1.2;
/// The book's samplers, in the first plot of each integrand; the second plot has the others and
/// random.
const BOOKS: [&str; 5] = ["random", "regular", "jittered", "n rooks", "multi jittered"];

pub fn page(data: &Data) -> String {
    let mut html = explanation(data) + &summary(data);
    for integrand in &data.integrands {
        let heading = capital(&integrand.name);
        html += &format!("<h3>{heading}</h3>\n<p>{}</p>\n", escaped(&integrand.about));
        html +=
            &format!("<p class=\"pick\"><strong>What to pick.</strong> {}</p>\n", pick(integrand));
        html += "<div class=\"pictures\">\n";
        let of_book = |s: &&SamplerData| BOOKS.contains(&&*s.sampler);
        let (book, others): (Vec<_>, Vec<_>) = integrand.samplers.iter().partition(of_book);
        let first = book.iter().filter(|s| s.sampler == BOOKS[0]).copied();
        html += &figure(&picture(&book).svg(), "Five of the book's samplers.");
        let others: Vec<&SamplerData> = first.chain(others).collect();
        html += &figure(&picture(&others).svg(), "Random samples again, and the other samplers.");
        html += "</div>\n";
        html += &table(integrand);
    }
    html
}

fn explanation(data: &Data) -> String {
    let Data { pixels, seeds, .. } = data;
    format!(
        "<p>Each integrand is a family of functions whose means are known, one function for each of \
         {pixels} pixels. A sampler's error is the root mean square difference of its mean from the \
         exact one, over these pixels and {seeds} seeds; relative to white for functions that are black \
         or white, relative to the mean for the others. Samples are drawn as in a renderer: one of 83 \
         sets and a permutation for each pixel and use.</p>\n\
         <p>On logarithmic axes a power of the number of samples is a straight line: the error of random \
         samples falls with slope −1/2, whatever the function. Slopes are fitted from {FITTED_FROM} \
         samples on, with an interval of {:.0} % confidence. Seconds are for one pixel on one thread, \
         for samples and function; tracing a ray takes much longer, so that in a renderer the number \
         of samples decides.</p>\n",
        100.0 * CONFIDENCE
    )
}

/// The table of the samples for an error of 1 %.
fn summary(data: &Data) -> String {
    let Some(first) = data.integrands.first() else { return String::new() };
    let row = |(i, sampler): (usize, &SamplerData)| {
        let of = |integrand: &IntegrandData| samples_needed(&integrand.samplers[i]);
        let cells = data.integrands.iter().map(of);
        std::iter::once(sampler.sampler.clone()).chain(cells).collect()
    };
    let names = data.integrands.iter().map(|integrand| integrand.name.clone());
    Table {
        caption: "Samples per pixel for an error of 1 %".to_owned(),
        headings: std::iter::once("sampler".to_owned()).chain(names).collect(),
        rows: first.samplers.iter().enumerate().map(row).collect(),
        ..Table::default()
    }
    .html()
}

fn samples_needed(s: &SamplerData) -> String {
    let most = s.errors.last().map_or(0, |e| e.samples);
    s.samples_for_one_percent.map_or(format!("&gt; {}", count(most as usize)), short)
}

fn picture(samplers: &[&SamplerData]) -> Plot {
    let series = |s: &&SamplerData| Series {
        name: s.sampler.clone(),
        points: s.errors.iter().map(|e| (f64::from(e.samples), e.rms)).collect(),
        joined: true,
        ..Series::default()
    };
    Plot {
        x: "samples per pixel".to_owned(),
        y: "root mean square error".to_owned(),
        series: samplers.iter().map(series).collect(),
        limit: Some((super::ONE_PERCENT, "1 %".to_owned())),
    }
}

/// Samplers with the same samples in every pixel: their errors form patterns, which the root mean
/// square does not show.
const FIXED: [&str; 2] = ["regular", "hammersley"];

/// One sentence: the sampler with the fewest samples for 1 %, those that are as good, the number of
/// random samples, and a fixed sampler that needs even fewer.
fn pick(integrand: &IntegrandData) -> String {
    let needs = |s: &&SamplerData| s.samples_for_one_percent;
    let by_need = |fixed: bool| {
        let of_kind = |s: &&SamplerData| FIXED.contains(&&*s.sampler) == fixed;
        let all = integrand.samplers.iter().filter(of_kind);
        let mut known: Vec<&SamplerData> = all.filter(|s| needs(s).is_some()).collect();
        known.sort_by(|a, b| {
            let [a, b] = [a, b].map(|s| s.samples_for_one_percent.unwrap_or(f64::INFINITY));
            a.total_cmp(&b)
        });
        known
    };
    let known = by_need(false);
    let Some(best) = known.first() else {
        let last = |s: &SamplerData| s.errors.last().map_or(f64::INFINITY, |e| e.rms);
        let all = integrand.samplers.iter();
        let best = all.min_by(|a, b| last(a).total_cmp(&last(b)));
        return best.map_or(String::new(), |best| {
            format!("None reaches 1 %; {} has the smallest error.", best.sampler)
        });
    };
    let fewest = needs(best).unwrap_or(f64::NAN);
    let as_good = known[1..].iter().filter(|s| needs(s).is_some_and(|n| n <= AS_GOOD * fewest));
    let as_good: Vec<String> = as_good.map(|s| s.sampler.clone()).collect();
    let beside = match as_good.len() {
        0 => String::new(),
        _ => format!(" (or {}, about as good)", listed(&as_good)),
    };
    let random = integrand.samplers.iter().find(|s| s.sampler == "random");
    let random = match random.and_then(|s| needs(&s)) {
        Some(n) => format!("random samples need {}", short(n)),
        None => "random samples do not reach it".to_owned(),
    };
    let fixed = match by_need(true).first() {
        Some(fixed) if needs(fixed).is_some_and(|n| n < fewest) => format!(
            "; {} needs only {}, but has the same error in all pixels, which is visible as patterns",
            fixed.sampler,
            needs(fixed).map_or(String::new(), short),
        ),
        _ => String::new(),
    };
    let best = capital(&best.sampler);
    format!("{best}{beside}: {} samples make the error 1 %; {random}{fixed}.", short(fewest))
}

fn table(integrand: &IntegrandData) -> String {
    let row = |s: &SamplerData| {
        let at = |n: u32| {
            let error = s.errors.iter().find(|e| e.samples == n);
            error.map_or(
                "–".to_owned(),
                |e| if e.rms == 0.0 { "0".to_owned() } else { short(e.rms) },
            )
        };
        let slope = match s.slope {
            Some([slope, low, high]) => {
                format!("{slope:.2} ({low:.2} … {high:.2})").replace('-', "−")
            }
            None => "–".to_owned(),
        };
        vec![
            s.sampler.clone(),
            at(16),
            at(256),
            at(4096),
            slope,
            samples_needed(s),
            flagged(s.seconds_for_one_percent().map_or("–".to_owned(), time), s.disturbed),
        ]
    };
    let headings = [
        "sampler",
        "error, 16 samples",
        "256",
        "4096",
        "slope",
        "samples for 1 %",
        "seconds for 1 %",
    ];
    Table {
        caption: format!("{}: error and cost", capital(&integrand.name)),
        headings: headings.map(str::to_owned).to_vec(),
        rows: integrand.samplers.iter().map(row).collect(),
        ..Table::default()
    }
    .html()
}
