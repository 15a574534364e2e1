//! Harmless changes: with which of them a picture agrees.

use groundtruth::film::Film;
use pictures::compare::{
    Change, Decoded, Picture, changes_that_explain, decodings, distance_of, half_pixel_directions,
    half_pixel_words,
};

use super::attempt::Judge;
use super::residuals::mean_of;
use super::{Case, Explanation, Replicas, Stored};

/// So many harmless changes are judged.
const TRIED: usize = 4;

/// Another curve is tried as if it left this part of the difference.
const ROUNDED: f64 = 0.1;

impl Judge<'_> {
    /// The most harmless change with which the picture agrees, read in one of these ways; and the way.
    pub fn explained(
        &self,
        theirs: &Picture,
        replicas: &mut Replicas<'_, '_>,
        ways: &[Stored],
    ) -> Option<(Explanation, Stored)> {
        let of = |way: &Stored| self.harmless(theirs, &replicas.films, *way);
        let mut changes: Vec<(f64, Change, Stored)> = ways.iter().flat_map(of).collect();
        // read in another way, a known factor is nearly some other one
        let rank = |(left, change, _): &(f64, Change, Stored)| {
            if change.is_known_factor() { 0.1 * left } else { *left }
        };
        changes.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
        for (_, change, way) in changes.into_iter().take(TRIED) {
            if (self.is_over)() {
                return None;
            }
            let as_theirs = read_so(theirs, way);
            let judge = self.reading(way);
            let agrees = match change {
                // theirs times the factor would be coarser than it is
                Change::Scaled(factor) => replicas.aside(|replicas| {
                    replicas.world.view.exposure_time /= factor;
                    judge.agrees(theirs, replicas)
                }),
                Change::Decoded(transfer) => {
                    let case = Case { transfer: Some(transfer), ..self.case };
                    Self { case, ..*self }.agrees(&change.applied(theirs), replicas)
                }
                _ => judge.agrees(&change.applied(&as_theirs), replicas),
            };
            if agrees == Some(true) {
                let what = change.words(["ours", "theirs"], as_theirs.transfer);
                // of a factor it is not known where it comes from
                let is_gain = matches!(change, Change::Scaled(_));
                return Some((Explanation { what, agrees: true, is_gain }, way));
            }
        }
        let alike = Picture::of_radiance(&ways[0].values(replicas.films.first()?), theirs.size);
        let half = |way: &Stored| {
            if (self.is_over)() {
                return None;
            }
            let as_theirs = read_so(theirs, *way);
            let found = half_pixel_directions(replicas.world, &as_theirs, Some(&alike));
            found.first().map(|(direction, left)| (*left, *direction, *way))
        };
        let all: Vec<(f64, [i32; 2], Stored)> = ways.iter().filter_map(half).collect();
        let (_, direction, way) = all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let agrees = replicas.aside(|replicas| {
            replicas.direction = direction;
            self.reading(way).agrees(theirs, replicas)
        });
        let what = half_pixel_words(direction, "theirs");
        Some((Explanation { what, agrees: agrees?, is_gain: false }, way))
    }

    /// The harmless changes that leave little of the difference of a picture read in one way, with the part that each
    /// leaves.
    fn harmless(
        &self,
        theirs: &Picture,
        films: &[Film],
        way: Stored,
    ) -> Vec<(f64, Change, Stored)> {
        let known = way.all(films);
        let mean: Vec<f32> = mean_of(&known).into_iter().map(|value| value as f32).collect();
        let [mean, alike] =
            [&mean, &known[0]].map(|values| Picture::of_radiance(values, theirs.size));
        let [ours, alike] = [&mean, &alike].map(Decoded::new);
        let as_theirs = read_so(theirs, way);
        let decoded = Decoded::read_by(&as_theirs, |value| f64::from(way.read(value)));
        let found = changes_that_explain(&ours, &decoded, distance_of(&ours, &alike)).into_iter();
        // where nothing says how values are encoded, the ways to read them are tried by themselves
        let found = found.filter(|(change, _)| !matches!(change, Change::Decoded(_)));
        let stated = self.transfer.into_iter().flat_map(|_| decodings(&decoded));
        // usual curves are so near to each other that rounding is a part of what is left
        let found = found.chain(stated.map(|change| (change, ROUNDED)));
        let both = |(change, left): (Change, f64)| {
            let known = change.near_known_factor().filter(|known| *known != change);
            let known = known.filter(|_| theirs.step.is_some());
            known.into_iter().chain([change]).map(move |change| (left, change, way))
        };
        found.flat_map(both).collect()
    }
}

/// The picture, encoded as it is if its values are stored in this way.
fn read_so(theirs: &Picture, way: Stored) -> Picture {
    Picture { transfer: way.transfer().unwrap_or(theirs.transfer), ..theirs.clone() }
}
