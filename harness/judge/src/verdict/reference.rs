//! The mean of many of our pictures, rendered before, from which pictures are taken to differ.

use groundtruth::film::Film;

use pictures::sums::{Header, Seeds, Sums};

use super::Stored;

/// The mean of replicas whose sums were kept.
#[derive(Clone, Debug)]
pub struct Reference {
    film: Film,
    seeds: Seeds,
}

impl Reference {
    /// The mean of these sums; `scene` is the header of sums of the scene that is judged, as it is rendered.
    ///
    /// # Errors
    /// They are of another scene, size, number of samples or version, or a replica has a value that is NaN or infinite.
    pub fn new(sums: &Sums, scene: &Header) -> Result<Self, String> {
        if let Some(difference) = sums.header().difference(scene) {
            return Err(format!(
                "is of {difference}; render it as the picture is rendered here, with its --size and --samples"
            ));
        }
        if let Some([x, y]) = sums.not_finite().next() {
            return Err(format!("a replica has a value that is no number at pixel {x}, {y}"));
        }
        Ok(Self { film: sums.mean(), seeds: sums.header().seeds.clone() })
    }

    /// The first seed from this one on after which the reference has none: replicas must not be in the mean that they
    /// are held against.
    pub fn first_free(&self, seed: u64) -> u64 {
        self.seeds.ranges().map(|[first, count]| first + count).fold(seed, u64::max)
    }

    /// The mean, as it is stored.
    pub fn mean(&self, stored: Stored) -> Mean {
        let values = stored.values(&self.film).into_iter().map(f64::from).collect();
        Mean { values, pictures: self.seeds.count() as f64 }
    }
}

/// The mean of pictures that are not in the pool.
#[derive(Clone, Debug)]
pub struct Mean {
    /// Three a pixel.
    pub values: Vec<f64>,
    /// Of how many pictures.
    pub pictures: f64,
}
