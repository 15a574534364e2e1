//! Pictures whose samples are alike in all pixels: regular ones, the centre of the pixel, one set for all pixels.

use groundtruth::film::Film;
use groundtruth::samplers::{self, Hammersley, Regular};

use super::replicas::Replicas;

/// A way to sample that is alike in all pixels.
#[derive(Clone, Debug)]
pub struct Sampling {
    pub sampler: samplers::Kind,
    pub samples: u32,
}

/// The sides of regular grids that are tried beside that of our own number of samples.
const SIDES: [u32; 4] = [1, 2, 3, 4];

impl Sampling {
    /// Those that are tried, if ours have so many samples.
    pub fn candidates(own: u32) -> Vec<Self> {
        let mut grids: Vec<u32> = SIDES.map(|side| side * side).to_vec();
        grids.extend((own.isqrt() * own.isqrt() == own).then_some(own));
        grids.sort_unstable();
        grids.dedup();
        let regular = |samples| Self { sampler: Regular {}.into(), samples };
        let one_set = Self { sampler: Hammersley { shifted: false }.into(), samples: own };
        // of one sample, Hammersley's is the corner of the pixel, which is said otherwise
        grids.into_iter().map(regular).chain((own > 1).then_some(one_set)).collect()
    }

    pub fn is_that_of(&self, replicas: &Replicas<'_, '_>) -> bool {
        let has_sampler = match (&replicas.world.image.sampler, &self.sampler) {
            (Some(samplers::Kind::Regular(a)), samplers::Kind::Regular(b)) => a == b,
            (Some(samplers::Kind::Hammersley(a)), samplers::Kind::Hammersley(b)) => a == b,
            _ => false,
        };
        has_sampler && replicas.world.samples_per_pixel() == self.samples
    }

    /// Our first picture with these samples; `None` if the user interrupts.
    pub fn film(&self, replicas: &mut Replicas<'_, '_>) -> Option<Film> {
        let image = &mut replicas.world.image;
        (image.sampler, image.samples) = (Some(self.sampler.clone()), self.samples);
        replicas.next = replicas.first;
        replicas.render()
    }

    /// Replicas are sampled so from here on; `film` is the first of them.
    pub fn resume(&self, replicas: &mut Replicas<'_, '_>, film: Film) {
        let image = &mut replicas.world.image;
        (image.sampler, image.samples) = (Some(self.sampler.clone()), self.samples);
        replicas.next = replicas.first + 1;
        replicas.films = vec![film];
    }

    /// What is different about the picture, and the arguments that make ours alike; `own` is our number of samples.
    pub fn words(&self, own: u32) -> String {
        let side = self.samples.isqrt();
        let count = match self.samples {
            same if same == own => String::new(),
            other => format!("--their-samples {other} "),
        };
        let so = format!("`{count}--their-sampler regular` makes ours alike");
        match (&self.sampler, self.samples) {
            (samplers::Kind::Regular(_), 1) => {
                format!("its one sample is the centre of each pixel; {so}")
            }
            (samplers::Kind::Regular(_), _) => {
                format!("its samples are regular, {side} × {side}, alike in all pixels; {so}")
            }
            _ => "it has one set of samples for all pixels, Hammersley's; `--their-sampler hammersley` makes ours alike"
                .to_owned(),
        }
    }
}
