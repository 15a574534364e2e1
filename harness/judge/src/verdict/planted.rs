//! What would have been seen: defects planted in one of our own pictures, and the smallest gains that stand out.

use groundtruth::film::Film;

use super::{Area, Areas, Map, Pool, Ranking};

/// A planted defect.
#[derive(Clone, Debug, serde::Serialize)]
pub struct PlantedDefect {
    /// What was changed.
    pub what: String,
    /// Whether the changed picture was farther out than all others.
    pub found: bool,
}

/// Whether a changed film of ours, in the place of the first of a pool, is the farthest out of all of ours: of all but the
/// last.
pub fn planted(changed: Vec<f32>, pool: &Pool, areas: &Areas, from: usize) -> bool {
    let others = (1..pool.count() - 1).map(|index| pool.picture(index).to_vec());
    let pictures = std::iter::once(changed).chain(others).collect();
    let pool = Pool::new(areas.size, pool.stored, pictures).against_mean(pool.reference.clone());
    Ranking::of(&pool, areas, from).as_far_as(0) == 0
}

/// A film whose pixels of an area are this many times as bright.
pub fn brighter(film: &Film, areas: &Areas, area: Area, factor: f64) -> Film {
    let mut changed = film.clone();
    for pixel in areas.pixels(area) {
        let at = [pixel % areas.size[0], pixel / areas.size[0]].map(|along| along as u32);
        changed.set(at, factor * film.get(at));
    }
    changed
}

/// For each side of tiles, the gain in one tile of that side that would be farther out than any picture of ours is,
/// with the tile of median noise; `None` where the median tile is black or has no noise.
pub fn smallest_gains(pool: &Pool, areas: &Areas, ranking: &Ranking) -> Vec<(usize, Option<f64>)> {
    let theirs = pool.count() - 1;
    let map = Map::of(pool, areas, theirs, 1.0);
    let of = |(side, limit): (usize, f64)| {
        let level = side.trailing_zeros() as usize;
        let [across, down] = areas.grid(level);
        let gain = |index: usize| {
            let pixels = areas.pixels(areas.tile(level, index));
            let gains = (0..3).filter_map(|channel| {
                let mean = |pixel: &usize| pool.mean_of_others(theirs, 3 * pixel + channel);
                let sum = pixels.iter().map(mean).sum::<f64>();
                let deviation = map.variance(&pixels, channel).sqrt();
                (sum > 0.0 && deviation > 0.0).then(|| limit * deviation / sum)
            });
            gains.min_by(f64::total_cmp)
        };
        let gains: Vec<f64> = (0..across * down).filter_map(gain).collect();
        (side, statistics::quantile(&gains, 0.5))
    };
    ranking.limits(theirs).map(of).collect()
}
