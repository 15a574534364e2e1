//! The pictures that a verdict is about, and the object in which they differ most.

use pictures::compare::{Affected, Picture};

use super::{Areas, Map, Pool};

/// What a verdict is about, for the eye.
#[derive(Clone, Debug)]
pub struct ShownPictures {
    /// The mean of ours.
    pub ours: Picture,
    /// Theirs, as it is in the file.
    pub theirs: Picture,
    /// The pixels of theirs that are set apart, row by row.
    pub excluded: Vec<usize>,
    /// For each pixel, the largest difference of a channel, in standard deviations.
    pub z: Vec<f64>,
    /// The pixels in which all of ours agree against theirs.
    outliers: Vec<usize>,
}

/// A pixel differs from so many standard deviations on; by noise alone, about one of a hundred does.
const FAR: f64 = 3.0;

impl ShownPictures {
    pub(super) fn of(pool: &Pool, areas: &Areas, noise: f64, shown: (&[f32], &[usize])) -> Self {
        let (theirs, size) = (pool.count() - 1, areas.size.map(|side| side as u32));
        let mean: Vec<f32> = (0..pool.picture(theirs).len())
            .map(|at| pool.mean_of_others(theirs, at) as f32)
            .collect();
        let map = Map::of(pool, areas, theirs, noise);
        let (z, outliers, excluded) = (map.pixels(), map.outliers().collect(), shown.1.to_vec());
        let [ours, theirs] = [&*mean, shown.0].map(|it| Picture::of_radiance(it, size));
        Self { ours, theirs, excluded, z, outliers }
    }

    /// The object that differs most, by the squares of its differences in standard deviations.
    pub(super) fn affected(&self, areas: &Areas) -> Option<Affected> {
        let mut weights: Vec<f64> = self.z.iter().map(|z| z * z).collect();
        for pixel in &self.outliers {
            weights[*pixel] = weights[*pixel].max(2.0 * FAR * FAR);
        }
        Affected::of(&areas.objects, &areas.object_of, |pixel| {
            let [ours, theirs] =
                [&self.ours, &self.theirs].map(|it| it.values[pixel].map(f64::from));
            let difference = [0, 1, 2].map(|channel| theirs[channel] - ours[channel]);
            (weights[pixel] >= FAR * FAR).then_some((weights[pixel], difference))
        })
    }
}
