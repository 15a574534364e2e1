//! The sum of several parts, each seed once.

use std::path::{Path, PathBuf};

use super::file::{FileError, Part};
use super::{Header, Overflow, Seeds, Sums};

/// Parts that cannot be added, which no other order or division would change.
#[derive(Debug, thiserror::Error)]
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

/// Two files that contradict each other.
#[derive(Debug, thiserror::Error)]
pub enum Contradiction {
    /// Both have these seeds, and one has others.
    #[error("{} and {} both have {common}: render one of them anew, with the other seeds alone", both[0].display(), both[1].display())]
    Overlap {
        /// The files.
        both: [PathBuf; 2],
        /// What both have.
        common: Seeds,
    },
    /// Both have the same seeds, but other sums.
    #[error("{} and {} have the same {seeds} but differ at pixel {}, {}: one of the machines is faulty; render them a third time to see which", both[0].display(), both[1].display(), pixel[0], pixel[1])]
    Differs {
        /// The files.
        both: [PathBuf; 2],
        /// What both have.
        seeds: Seeds,
        /// The first pixel that differs; column and row from the top left.
        pixel: [u32; 2],
    },
}

/// The sum of several parts.
#[derive(Debug)]
pub struct Merged {
    /// The sum.
    pub sums: Sums,
    /// The parts that count; no two have a common seed.
    pub used: Vec<(PathBuf, Header)>,
    /// Parts that come twice, with the same bits: each with the one that counts.
    pub twice: Vec<[PathBuf; 2]>,
}

/// Adds the parts in these files, of which there is at least one. `progress` is called after each file.
///
/// # Errors
/// [`MergeError`].
pub fn merged(files: &[PathBuf], mut progress: impl FnMut()) -> Result<Merged, MergeError> {
    let part = Part::read(&files[0])?;
    let first = part.header.clone();
    let mut merged = Merged { sums: Sums::new(first.clone()), used: Vec::new(), twice: Vec::new() };
    merged.add(&files[0], part)?;
    progress();
    for path in &files[1..] {
        let part = Part::read(path)?;
        if let Some(difference) = part.header.difference(&first) {
            let [path, first] = [path, &files[0]].map(PathBuf::clone);
            return Err(MergeError::Foreign { path, first, difference });
        }
        merged.add(path, part)?;
        progress();
    }
    Ok(merged)
}

impl Merged {
    /// The seeds that are wanted, and that no part has.
    pub fn missing(&self) -> Seeds {
        let Header { wanted, seeds, .. } = self.sums.header();
        wanted.without(seeds)
    }

    fn add(&mut self, path: &Path, part: Part) -> Result<(), MergeError> {
        let common = |(_, other): &&(PathBuf, Header)| {
            !other.seeds.intersection(&part.header.seeds).is_empty()
        };
        if let Some((other, header)) = self.used.iter().find(common) {
            let both = [path.to_owned(), other.clone()];
            if header.seeds != part.header.seeds {
                let common = header.seeds.intersection(&part.header.seeds);
                return Err(Contradiction::Overlap { both, common }.into());
            }
            let expected = Part::read(other)?;
            let mut pairs = part.channels().zip(expected.channels());
            if let Some(index) = pairs.position(|(found, expected)| found != expected) {
                let pixel = self.sums.place(index / 3);
                let seeds = part.header.seeds.clone();
                return Err(Contradiction::Differs { both, seeds, pixel }.into());
            }
            drop(pairs);
            self.twice.push(both);
            return Ok(());
        }
        self.sums.add_each(part.channels().map(Some))?;
        let header = &mut self.sums.header;
        header.seeds = header.seeds.union(&part.header.seeds);
        header.wanted = header.wanted.union(&part.header.wanted).union(&header.seeds);
        if header.arguments != part.header.arguments {
            header.arguments.clear();
        }
        self.used.push((path.to_owned(), part.header));
        Ok(())
    }
}
