//! Which of several parts count, and their sum.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::{ChannelSums, FileError, Header, Overflow, Seeds, Sums, SumsFile, place};

/// Parts that cannot be added, which no other order or division would change.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// A file cannot be used.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file is not of the picture of the first one.
    #[error("{}: is of {difference}; the first file is {}: merge them apart", path.display(), first.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// The first file.
        first: PathBuf,
        /// What differs.
        difference: String,
    },
    /// The sum of a pixel does not fit.
    #[error(transparent)]
    Overflow(#[from] Overflow),
    /// Two files contradict each other.
    #[error(transparent)]
    Contradiction(#[from] Contradiction),
}

/// Two files that contradict each other, or a file and what is rendered here.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Contradiction {
    /// Both have these seeds, and each has others, so that neither can be left out.
    #[error("{} and {} both have {common}, and neither has all of the other: render one of them anew", both[0].display(), both[1].display())]
    Overlap {
        /// The files.
        both: [PathBuf; 2],
        /// What both have.
        common: Seeds,
    },
    /// Both have the same seeds, but other sums.
    #[error("{} and {} have the same {seeds} but differ at {at}: one of the machines is faulty; --audit tells which", both[0].display(), both[1].display())]
    Differs {
        /// The files.
        both: [PathBuf; 2],
        /// What both have.
        seeds: Seeds,
        /// The first pixel that differs, or what else does.
        at: String,
    },
    /// The sums are not those that are rendered here.
    #[error("{}: pixel {}, {} is not what is rendered here from its {seeds}: that machine is faulty, or this one", path.display(), pixel[0], pixel[1])]
    Audit {
        /// The file.
        path: PathBuf,
        /// The first pixel that differs; column and row from the top left.
        pixel: [u32; 2],
        /// The seeds that were rendered.
        seeds: Seeds,
    },
}

/// Parts that are read together. More would hardly be faster, and slower where a disk reads one file at a time.
const AT_A_TIME: usize = 8;

/// Which parts count.
#[derive(Debug)]
pub struct Plan {
    /// The parts that count; no two have a common seed.
    pub used: Vec<SumsFile>,
    /// Parts that come twice, each with the one that counts.
    pub twice: Vec<[SumsFile; 2]>,
    /// Parts whose seeds another one has, with more of them, each with that one, which counts.
    pub inside: Vec<[SumsFile; 2]>,
    /// The seeds that are wanted, and that no part has.
    pub missing: Seeds,
}

impl Plan {
    /// Chooses among parts, of which there is at least one: those with more seeds count first.
    ///
    /// # Errors
    /// [`MergeError`], except for an overflow. A file that is damaged is named first: its header may be the reason of
    /// the other errors.
    pub fn new(parts: Vec<SumsFile>) -> Result<Self, MergeError> {
        Self::chosen(&parts).or_else(|error| {
            parts.iter().try_for_each(SumsFile::check)?;
            Err(error)
        })
    }

    fn chosen(parts: &[SumsFile]) -> Result<Self, MergeError> {
        let first = &parts[0];
        for part in parts {
            if let Some(difference) = part.header().difference(first.header()) {
                let [path, first] = [part, first].map(|part| part.path().to_owned());
                return Err(MergeError::Foreign { path, first, difference });
            }
        }
        let mut parts = parts.to_vec();
        parts.sort_by_key(|part| std::cmp::Reverse(part.header().seeds.count()));
        let wanted = parts.iter().fold(Seeds::default(), |all, part| {
            all.union(&part.header().wanted).union(&part.header().seeds)
        });
        let mut plan = Self { used: vec![], twice: vec![], inside: vec![], missing: wanted };
        for part in parts {
            plan.place(part)?;
        }
        Ok(plan)
    }

    /// Finds where a part belongs; all with more seeds have been placed before.
    fn place(&mut self, part: SumsFile) -> Result<(), Contradiction> {
        let seeds = &part.header().seeds;
        let common = |other: &SumsFile| seeds.intersection(&other.header().seeds);
        match self.used.iter().find(|other| !common(other).is_empty()) {
            Some(other) if seeds == &other.header().seeds => self.twice.push([part, other.clone()]),
            Some(other) if seeds.is_within(&other.header().seeds) => {
                self.inside.push([part, other.clone()]);
            }
            Some(other) => {
                let both = [part.path().to_owned(), other.path().to_owned()];
                return Err(Contradiction::Overlap { both, common: common(other) });
            }
            None => {
                self.missing = self.missing.without(seeds);
                self.used.push(part);
            }
        }
        Ok(())
    }

    /// Adds the parts that count, and checks every byte of the others. `progress` is called after each file.
    ///
    /// # Errors
    /// [`MergeError`].
    pub fn sums(&self, mut progress: impl FnMut()) -> Result<Sums, MergeError> {
        let mut sums = Sums::new(self.header());
        for parts in self.used.chunks(AT_A_TIME) {
            sums.add_parts(parts)?;
            parts.iter().for_each(|_| progress());
        }
        sums.not_finite.sort_unstable();
        sums.count(&Seeds::default());
        for [part, _] in &self.inside {
            part.check()?;
            progress();
        }
        for [part, other] in &self.twice {
            check_equal(part, other)?;
            progress();
        }
        Ok(sums)
    }

    /// The header of all parts that count, together.
    fn header(&self) -> Header {
        let first = self.used[0].header();
        let headers = || self.used.iter().map(SumsFile::header);
        let wanted = headers().fold(Seeds::default(), |all, it| all.union(&it.wanted));
        let agree = headers().all(|header| header.arguments == first.arguments);
        let arguments = if agree { first.arguments.clone() } else { Vec::new() };
        Header { wanted, arguments, ..first.clone() }
    }
}

impl Sums {
    fn add_parts(&mut self, parts: &[SumsFile]) -> Result<(), MergeError> {
        let overflow = First::default();
        let add = |index, sums: &mut ChannelSums, these| match sums.checked_add(these) {
            Some(sum) => *sums = sum,
            None => overflow.note(index),
        };
        let rests = SumsFile::each_of(parts, &mut self.channels, add)?;
        if let Some(index) = overflow.get() {
            return Err(super::overflow(index, self.header.size[0]).into());
        }
        for (part, rest) in parts.iter().zip(rests) {
            self.not_finite.extend(rest.not_finite);
            self.count(&part.header().seeds);
        }
        Ok(())
    }
}

/// The smallest index that was noted, by any thread.
struct First(AtomicUsize);

impl Default for First {
    fn default() -> Self {
        Self(AtomicUsize::new(usize::MAX))
    }
}

impl First {
    fn note(&self, index: usize) {
        self.0.fetch_min(index, Ordering::Relaxed);
    }

    fn get(self) -> Option<usize> {
        Some(self.0.into_inner()).filter(|&index| index < usize::MAX)
    }
}

/// Fails unless two parts of the same seeds have the same sums.
fn check_equal(part: &SumsFile, other: &SumsFile) -> Result<(), MergeError> {
    let [a, b] = [part.checked()?, other.checked()?];
    let is_one_command = part.header() == other.header();
    if a.digest == b.digest && is_one_command {
        return Ok(());
    }
    let mut expected = other.read()?.channels;
    let different = First::default();
    part.each(&mut expected, |index, expected, found| {
        if found != *expected {
            different.note(index);
        }
    })?;
    let width = part.header().size[0];
    let at = match different.get() {
        Some(index) => {
            let ([x, y], _) = place(index as u64, width);
            format!("pixel {x}, {y}")
        }
        None if a.not_finite != b.not_finite => "their values that are not finite".to_owned(),
        None => return Ok(()),
    };
    let both = [part.path().to_owned(), other.path().to_owned()];
    Err(Contradiction::Differs { both, seeds: part.header().seeds.clone(), at }.into())
}
