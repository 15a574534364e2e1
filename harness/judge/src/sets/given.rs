//! The pictures that are given, and their regions.

use crate::verdict::Areas;
use crate::verdict::residuals::mean_of;
use pictures::compare::{Decoded, Picture};

/// The pictures of one scene before and after a change.
#[derive(Clone, Debug)]
pub struct Sets {
    /// Their tiles, and the regions that the user gave.
    pub areas: Areas,
    /// The radiances of each picture before, three a pixel, row by row from the top left.
    pub before: Vec<Vec<f32>>,
    /// The same after.
    pub after: Vec<Vec<f32>>,
    /// The variance of each value by rounding when it was stored.
    pub rounding: Vec<f64>,
}

/// More colours in a picture of regions are no regions.
const MOST_REGIONS: usize = 4096;

impl Sets {
    /// The sets of these pictures, all of one size; `regions` has a colour for each region.
    ///
    /// # Errors
    /// If it is of another size, or has too many colours.
    pub fn new(sets: [Vec<Picture>; 2], regions: Option<&Picture>) -> Result<Self, String> {
        let first = &sets[0][0];
        let decoded = Decoded::new(first);
        let rounding = |value: &f32| {
            let [low, high] = decoded.interval(*value);
            // evenly spread over the interval
            Some((high - low) * (high - low) / 12.0).filter(|it| it.is_finite()).unwrap_or(0.0)
        };
        let rounding = first.values.as_flattened().iter().map(rounding).collect();
        let areas = match regions {
            None => Areas::tiles(first.size.map(|side| side as usize)),
            Some(regions) => regions_of(regions, first.size)?,
        };
        let [before, after] = sets.map(|set| set.into_iter().map(radiances).collect());
        Ok(Self { areas, before, after, rounding })
    }

    /// The numbers of pictures before and after.
    pub fn sizes(&self) -> [usize; 2] {
        [self.before.len(), self.after.len()]
    }

    /// All pictures, those before first.
    pub(super) fn all(&self) -> impl Iterator<Item = &Vec<f32>> {
        self.before.iter().chain(&self.after)
    }

    /// The mean of a set as a picture.
    pub(super) fn mean_picture(&self, set: &[Vec<f32>]) -> Picture {
        let mean: Vec<f32> = mean_of(set).into_iter().map(|value| value as f32).collect();
        Picture::of_radiance(&mean, self.areas.size.map(|side| side as u32))
    }

    /// The mean of all pictures.
    pub(super) fn mean_of_all(&self) -> Vec<f64> {
        let [n, m] = self.sizes().map(|count| count as f64);
        let [before, after] = [&self.before, &self.after].map(|set| mean_of(set));
        before.iter().zip(after).map(|(a, b)| (n * a + m * b) / (n + m)).collect()
    }

    /// Values that are no numbers in some picture become 0 in all; whether all do.
    pub(super) fn without_not_finite(mut self) -> (Self, bool) {
        let is_finite = |index: usize| self.all().all(|picture| picture[index].is_finite());
        let bad: Vec<usize> = (0..self.rounding.len()).filter(|index| !is_finite(*index)).collect();
        for picture in self.before.iter_mut().chain(&mut self.after) {
            bad.iter().for_each(|index| picture[*index] = 0.0);
        }
        let are_all = bad.len() == self.rounding.len();
        (self, are_all)
    }

    /// Whether all pictures of each set have the same values: there is no noise, or only one picture.
    pub(super) fn is_fixed(&self) -> bool {
        let is_same = |set: &[Vec<f32>]| set.iter().all(|picture| *picture == set[0]);
        is_same(&self.before) && is_same(&self.after)
    }
}

/// The radiances of a picture, in the place of its values.
fn radiances(mut picture: Picture) -> Vec<f32> {
    if picture.step.is_some() {
        let decoded = Decoded::new(&picture);
        let linear = |color: &[f32; 3]| decoded.linear(*color).map(|value| value as f32);
        picture.values = picture.values.iter().map(linear).collect();
    }
    picture.values.into_flattened()
}

/// The regions of a picture with a colour for each.
fn regions_of(picture: &Picture, size: [u32; 2]) -> Result<Areas, String> {
    let ([width, height], [w, h]) = (picture.size, size);
    if picture.size != size {
        return Err(format!(
            "it has {width} × {height} pixels, the pictures {w} × {h}; each pixel has a region"
        ));
    }
    let name = |bits: &[u32; 3]| {
        let [r, g, b] = bits.map(|bits| (255.0 * f32::from_bits(bits)).round() as u8);
        format!("region #{r:02x}{g:02x}{b:02x}").into()
    };
    let colors = picture.values.iter().map(|color| color.map(f32::to_bits));
    let areas = Areas::by_key(size.map(|side| side as usize), colors, name);
    if areas.objects.len() > MOST_REGIONS {
        return Err(format!(
            "it has more than {MOST_REGIONS} colours; a picture of regions has one for each, without smooth edges"
        ));
    }
    Ok(areas)
}
