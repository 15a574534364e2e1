use std::collections::HashMap;

use super::LawReport;
use super::geometry::leaving;
use crate::log::Purpose;
use crate::traced::Traced;

/// The cosines of two random rays that are nearer to each other than this are the same draw.
const SAME: f64 = 1e-7;
/// Fewer rays may agree by accident.
const FEW: usize = 8;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut drawn: Vec<(f64, usize, usize)> = Vec::new();
    for it in
        leaving(traced).filter(|it| matches!(it.ray.kind, Some(Purpose::Diffuse | Purpose::Path)))
    {
        let Some(facing) = it.facing() else { continue };
        let depth = traced.way_up(it.index).count();
        drawn.push((facing.dot(it.leaving), it.index, depth));
    }
    if drawn.len() < FEW {
        return;
    }
    let single = traced.rounding.max(SAME);
    drawn.sort_by(|a, b| a.0.total_cmp(&b.0));
    // of random numbers so few pairs are this near that a ray has a twin rarely: by its neighbours in the sorted list
    let is_twin = |a: &(f64, usize, usize), b: &(f64, usize, usize)| (a.0 - b.0).abs() <= single;
    let twins: HashMap<usize, usize> = drawn
        .windows(2)
        .filter(|pair| is_twin(&pair[0], &pair[1]) && differs(traced, pair[0].1, pair[1].1))
        .flat_map(|pair| [(pair[0].1, pair[1].1), (pair[1].1, pair[0].1)])
        .collect();
    // expected by chance: n² · 2 · SAME pairs; a half of all rays is far from it unless there are millions
    let is_rare = 2.0 * drawn.len() as f64 * single < 0.05;
    let many = is_rare && 2 * twins.len() >= drawn.len();
    for (_, index, depth) in &drawn {
        let twin = twins.get(index).filter(|_| many);
        asked.count(*index, twin.is_none(), || {
            let other = twin.copied().unwrap_or(*index);
            let [ray, same] = [traced.ray(*index), traced.ray(other)];
            let other_depth = traced.way_up(other).count();
            let causes = [
                ("same-in-each-pixel", ray.pixel != same.pixel),
                ("same-in-each-sample", ray.pixel == same.pixel && ray.sample != same.sample),
                ("same-in-each-bounce", *depth != other_depth),
            ];
            let words = format!(
                "leaves at the same angle to the normal as {} of line {}",
                traced.name(other),
                same.line
            );
            (words, causes)
        });
    }
}

/// Whether two rays are no copies of each other: they start elsewhere or belong to other samples.
fn differs(traced: &Traced, a: usize, b: usize) -> bool {
    let [a, b] = [traced.ray(a), traced.ray(b)];
    a.pixel != b.pixel || a.sample != b.sample || (a.origin - b.origin).length() != 0.0
}
