//! Sets of samples, and what is drawn from them.

use serde::{Deserialize, Serialize};

use super::limits::MAX_POINTS;
use groundtruth::invalid::Invalid;
use groundtruth::samplers::{Kind, Purpose, SETS, SampleSets, SetKey};
use groundtruth::world::DEFAULT_SEED;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Samples {
    sampler: Kind,
    n: u32,
    #[serde(default = "default_seed")]
    seed: u64,
    sets: Option<u32>,
    draw: Option<Draw>,
}

fn default_seed() -> u64 {
    DEFAULT_SEED
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Draw {
    pixel: [u32; 2],
    index: u32,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum SampledPoints {
    Sets(Vec<Vec<[f64; 2]>>),
    Point([f64; 2]),
}

impl super::Question for Samples {
    type Answer = SampledPoints;

    fn answer(&self) -> Result<SampledPoints, Invalid> {
        let n = self.n;
        if !(1..=MAX_POINTS).contains(&n) {
            return Err(Invalid::field("n", format!("found {n}, but 1 to {MAX_POINTS} fit")));
        }
        let sampler = self.sampler.build(&mut ()).map_err(|e| e.inside("sampler"))?;
        let sets = || SampleSets::new(&*sampler, n, self.seed);
        match (self.sets, self.draw) {
            (None, Some(Draw { pixel, index })) => {
                let key = SetKey::new(self.seed, pixel, Purpose::Pixel);
                Ok(SampledPoints::Point(sets().draw(key, index)))
            }
            (Some(_), Some(_)) => Err(Invalid::new("needs either `sets` or `draw`, not both")),
            (count, None) => {
                let count = count.unwrap_or(1);
                let most = (MAX_POINTS / n).min(SETS as u32);
                if !(1..=most).contains(&count) {
                    let problem = format!("found {count}, but 1 to {most} sets of {n} fit");
                    return Err(Invalid::field("sets", problem));
                }
                let sets = sets();
                let set = |i: u32| sets.set(i as usize).to_vec();
                Ok(SampledPoints::Sets((0..count).map(set).collect()))
            }
        }
    }
}
