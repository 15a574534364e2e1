use super::LawReport;
use super::weight::{is_finite, is_near};
use crate::traced::Traced;
use groundtruth::rgb::Rgb;
use text::digits::three;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 4.0 * traced.tolerance();
    for (index, parent) in traced.pairs() {
        let (ray, from) = (&traced.ray(index).factors, &traced.ray(parent).factors);
        let is_root = traced.parents[parent].is_none();
        let before = from.throughput.or(is_root.then_some(Rgb::WHITE));
        let (Some(throughput), Some(before), Some(own)) = (ray.throughput, before, ray.weight)
        else {
            continue;
        };
        let last = if is_root { from.weight.or(Some(Rgb::WHITE)) } else { from.weight };
        let weight = if traced.conventions.throughput_before { last } else { Some(own) };
        let Some(weight) = weight else { continue };
        let expected = before * weight;
        if !(is_finite(expected) && is_finite(throughput)) {
            continue;
        }
        asked.count(index, is_near(throughput, expected, tolerance), || {
            let is = |color: Rgb| is_near(throughput, color, tolerance);
            let causes = [
                ("own-weight-alone", is(own)),
                ("own-weight-twice", is(before * own * own)),
                ("own-weight-left-out", is(before)),
                ("always-1", is(Rgb::WHITE)),
            ];
            let [is, should] = [throughput, expected].map(|it| three(it.to_array()));
            (format!("has the throughput {is}, where the product is {should}"), causes)
        });
    }
}
