use std::f64::consts::PI;

use super::LawReport;
use super::geometry::leaving;
use crate::log::Factors;
use crate::traced::Traced;
use groundtruth::rgb::Rgb;
use text::digits::three;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 2.0 * traced.tolerance();
    let geometric: std::collections::HashMap<usize, f64> = leaving(traced)
        .filter_map(|it| Some((it.index, it.facing()?.dot(it.leaving).abs())))
        .collect();
    for (index, ray) in traced.log.rays.iter().enumerate() {
        let Factors { weight: Some(weight), f: Some(f), cos, pdf, choice, mis, .. } = &ray.factors
        else {
            continue;
        };
        let factor =
            cos.unwrap_or(1.0) / (pdf.unwrap_or(1.0) * choice.unwrap_or(1.0)) * mis.unwrap_or(1.0);
        let expected = factor * *f;
        if !(is_finite(expected) && is_finite(*weight)) {
            continue;
        }
        // of a scattered ray the MIS weight belongs to what is emitted at its hit
        let without_mis = expected * Rgb::grey(1.0 / mis.unwrap_or(1.0));
        let is_split = !ray.is_shadow() && is_near(*weight, without_mis, tolerance);
        // several rays of one kind may share what their surface brings
        let alike = |parent: usize| {
            traced.children[parent].iter().filter(|&&it| traced.ray(it).kind == ray.kind).count()
        };
        let parts = traced.parents[index].map_or(1, alike) as f64;
        let is_part = is_near(*weight, expected / parts, tolerance);
        asked.count(index, is_split || is_part || is_near(*weight, expected, tolerance), || {
            let is = |times: f64| {
                let near = |it: Rgb| is_near(*weight, times * it, tolerance);
                times.is_finite() && (near(expected) || !ray.is_shadow() && near(without_mis))
            };
            let cosine = cos.or(geometric.get(&index).copied()).unwrap_or(1.0);
            let is_told = |factor: Option<f64>| factor.is_some_and(|it| (it - 1.0).abs() > 1e-3);
            let [pdf, choice] = [pdf, choice].map(|it| it.unwrap_or(1.0));
            let is_albedo = f.max() > 0.0 && is_near(*weight, Rgb::grey(factor), tolerance);
            let causes = [
                ("cosine-missing", cos.is_some() && is(1.0 / cosine)),
                ("cosine-twice", is(cosine)),
                ("pdf-missing", is(pdf)),
                ("pi-missing", is(PI)),
                ("pi-too-much", is(1.0 / PI)),
                ("choice-missing", is(choice)),
                ("mis-missing", is_told(*mis) && is(1.0 / mis.unwrap_or(1.0))),
                ("choice-twice", is(1.0 / choice)),
                ("brdf-missing", is_albedo),
            ];
            let [is, should] = [weight, &expected].map(|it| three(it.to_array()));
            (format!("counts {is}, where its factors give {should}"), causes)
        });
    }
}

pub fn is_finite(color: Rgb) -> bool {
    color.to_array().iter().all(|x| x.is_finite())
}

/// Whether two colours are the same but for this relative error of the larger channel.
pub fn is_near(a: Rgb, b: Rgb, tolerance: f64) -> bool {
    let size =
        |color: Rgb| color.to_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    size(a - b) <= tolerance * size(a).max(size(b))
}
