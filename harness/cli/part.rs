//! `--part K/N`: work that several machines share.

use pictures::sums::Seeds;

/// `K/N`: one of N parts, counted from 0.
#[derive(Clone, Copy)]
pub struct PartOf {
    index: u32,
    count: u32,
}

/// All in one part.
impl Default for PartOf {
    fn default() -> Self {
        Self { index: 0, count: 1 }
    }
}

impl PartOf {
    /// Parses `K/N`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        match parts.and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?))) {
            Some((index, count)) if index < count => Ok(Self { index, count }),
            Some((_, count)) if count > 0 => {
                Err(format!("the parts of {count} are 0/{count} to {}/{count}", count - 1))
            }
            _ => Err("a part is written as 0/8".to_owned()),
        }
    }

    /// Its contiguous share of the seeds from `first` on.
    ///
    /// # Errors
    /// There are fewer replicas than parts, or the seeds do not fit in 64 bits.
    pub fn seeds(self, first: u64, replicas: u32) -> Result<Seeds, String> {
        let PartOf { index, count } = self;
        if count > replicas {
            return Err(format!("--part: {replicas} replicas have at most {replicas} parts"));
        }
        let start = |part: u32| u64::from(part) * u64::from(replicas) / u64::from(count);
        let [start, end] = [start(index), start(index + 1)];
        let seeds = first.checked_add(start).and_then(|first| Seeds::range(first, end - start));
        seeds.ok_or_else(|| "--seed: the seeds of the replicas do not fit in 64 bits".to_owned())
    }

    /// Every N-th entry of a list, from K on: neighbours in a list mostly cost the same.
    pub fn of_list<T>(self, list: impl Iterator<Item = T>) -> impl Iterator<Item = T> {
        list.skip(self.index as usize).step_by(self.count as usize)
    }
}
