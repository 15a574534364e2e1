//! What is said of a picture, as data.

use serde::Serialize;
use text::brief::count;

use pictures::compare::Affected;

use super::{
    Answer, Area, Areas, Causes, Decision, DifferingArea, Map, Means, Negative, PlantedDefect,
    Pool, ShownPictures, Stored,
};

/// What is said of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// `agrees`, `differs` or `undecided`.
    pub decision: Decision,
    /// What decided, if it was nothing else that `differs`.
    pub decided_by: Option<DecidedBy>,
    /// The negative values of theirs.
    pub negative: Option<Negative>,
    /// What was assumed of how the picture stores its values.
    pub assumed: String,
    /// The same as data.
    #[serde(skip)]
    pub stored: Stored,
    /// The number of pictures that were judged.
    pub pictures: usize,
    /// The seed of the replica that has the same bits.
    pub equal_to_seed: Option<u64>,
    /// The means of the picture and of its objects.
    pub means: Vec<Means>,
    /// The noise of its pixels, relative to ours.
    pub noise: f64,
    /// Whether single pixels and pairs of them were left out, because the noise is unlike ours.
    pub coarse: bool,
    /// Whether ours are made of independent samples, because the noise is nearer to that of these.
    pub independent: bool,
    /// The number of our pictures that it was held against.
    pub replicas: usize,
    /// The number of these that are at least as far out.
    pub as_far: usize,
    /// The number of our pictures in the mean that it was held against, if that was rendered before.
    pub reference: Option<u64>,
    /// The level at which it was decided.
    pub level: f64,
    /// Whether the scene has no random numbers that show.
    pub fixed: bool,
    /// The number of pixels that were set apart: all of ours agree there, and a correct picture need not.
    pub set_apart: usize,
    /// A relative margin for the means, and whether they are within it.
    pub margin: Option<(f64, Answer)>,
    /// The object that differs most, if the picture does.
    pub affected: Option<Affected>,
    /// Where it differs.
    pub regions: Vec<DifferingRegion>,
    /// The change that explains the difference.
    pub explained: Option<Explanation>,
    /// The known mistakes that explain the difference.
    pub causes: Causes,
    /// Whether nothing says how the picture encodes radiance, so that it is read as it fits best.
    pub is_guessed: bool,
    /// Of a JPEG that agrees no further, by how many steps of 1/255 the means of its blocks may be off.
    pub loss: Option<f64>,
    /// Defects that would have been found or not.
    pub plants: Vec<PlantedDefect>,
    /// For tiles of each side, the gain that would stand out.
    pub gains: Vec<(usize, Option<f64>)>,
    /// The pictures.
    #[serde(skip)]
    pub shown: ShownPictures,
}

/// What alone decided that a picture differs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DecidedBy {
    /// The mean of this area, outside the interval that noise and rounding leave.
    Mean(String),
    /// A negative value.
    Negative,
}

/// A simple change that explains a difference.
#[derive(Clone, Debug, Serialize)]
pub struct Explanation {
    /// What is different about the picture.
    pub what: String,
    /// Whether it agrees but for that.
    pub agrees: bool,
    /// Whether it is a factor of all radiance.
    pub is_gain: bool,
}

/// A region in which a picture differs.
#[derive(Clone, Debug, Serialize)]
pub struct DifferingRegion {
    /// Where: a tile, an object, or pixels.
    pub name: String,
    /// Left column, top row, columns and rows of the box around it.
    pub bounds: [usize; 4],
    /// In standard deviations; `None` where all our pictures agree.
    pub z: Option<f64>,
    /// The mean of our pictures: red, green, blue.
    pub ours: [f64; 3],
    /// The mean of theirs.
    pub theirs: [f64; 3],
    /// The pixel that is farthest out: x right and y down, from 0.
    pub worst: [usize; 2],
}

impl Verdict {
    /// Says also whether the means of the picture and of its objects are within a relative margin of ours.
    pub fn hold_to(&mut self, margin: f64) {
        // a picture with the same bits is within any margin; intervals allow for rounding and may be wider
        let answer = match self.equal_to_seed {
            Some(_) => Answer::Agrees,
            None => Means::within(&self.means, margin),
        };
        self.margin = Some((margin, answer));
        let printed = self.means.iter().filter(|it| it.is_beyond(margin));
        let outside = printed.filter(|it| it.is_outside()).map(|it| it.name.clone()).next();
        if let Some(name) = outside.filter(|_| self.decision == Decision::Agrees) {
            (self.decision, self.decided_by) = (Decision::Differs, Some(DecidedBy::Mean(name)));
        }
    }
}

impl DifferingRegion {
    /// An area, with its pixel that is farthest out; `shown` is the picture as it is in the file.
    pub fn of_area(
        pool: &Pool,
        areas: &Areas,
        map: &Map,
        (difference, shown): (DifferingArea, &[f32]),
    ) -> Self {
        let (pixels, z) = (areas.pixels(difference.area), map.pixels());
        let name = match difference.area {
            Area::Object(object) => areas.objects[object].0.to_string(),
            Area::Structure(object) => format!("the fine structure of {}", areas.objects[object].0),
            Area::Tile { .. } => shown_by(areas, &pixels),
        };
        let apart = |pixel: usize| z[pixel].abs();
        Self { z: Some(difference.z), ..Self::new((pool, areas), &pixels, name, shown, apart) }
    }

    /// Pixels in which all our pictures agree against it; `shown` is the picture as it is in the file.
    pub fn of_pixels(pool: &Pool, areas: &Areas, pixels: &[usize], shown: &[f32]) -> Self {
        let theirs = pool.count() - 1;
        let apart = |pixel: usize| {
            let values = (3 * pixel..3 * pixel + 3)
                .map(|at| f64::from(pool.picture(theirs)[at]) - pool.mean_of_others(theirs, at));
            values.map(f64::abs).fold(0.0, f64::max)
        };
        let name = format!("{} of {}", count(pixels.len(), "pixel"), shown_by(areas, pixels));
        Self::new((pool, areas), pixels, name, shown, apart)
    }

    fn new(
        (pool, areas): (&Pool, &Areas),
        pixels: &[usize],
        name: String,
        shown: &[f32],
        apart: impl Fn(usize) -> f64,
    ) -> Self {
        let worst = pixels.iter().max_by(|a, b| apart(**a).total_cmp(&apart(**b)));
        let worst = *worst.expect("there are pixels");
        let (theirs, width, count) = (pool.count() - 1, pool.size[0], pixels.len() as f64);
        let mean = |value: &dyn Fn(usize) -> f64, channel: usize| {
            pixels.iter().map(|pixel| value(3 * pixel + channel)).sum::<f64>() / count
        };
        let of_ours = |at| pool.mean_of_others(theirs, at);
        let of_theirs = |at: usize| f64::from(shown[at]);
        Self {
            name,
            bounds: areas.bounds(pixels),
            z: None,
            ours: [0, 1, 2].map(|channel| mean(&of_ours, channel)),
            theirs: [0, 1, 2].map(|channel| mean(&of_theirs, channel)),
            worst: [worst % width, worst / width],
        }
    }
}

/// The object that most of these pixels show.
fn shown_by(areas: &Areas, pixels: &[usize]) -> String {
    let mut counts = vec![0_usize; areas.objects.len()];
    pixels.iter().for_each(|pixel| counts[areas.object_of[*pixel] as usize] += 1);
    let most = (0..counts.len()).max_by_key(|object| counts[*object]).unwrap_or_default();
    areas.objects[most].0.to_string()
}
