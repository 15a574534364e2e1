//! Files of sums.
//!
//! Text lines and an empty one (see [`Header`]); for each channel `Σk` (16 bytes) and `Σk²` (32 bytes), the least
//! significant byte first; for each value that is NaN or infinite its seed, channel and bits (8 bytes each); and a
//! digest of 16 bytes.
//!
//! The digest is the XXH3 (128 bits, without a seed) of digests of the same kind: of the header, of the sums of each
//! 4096 channels, and of the list. So the blocks of a file can be read on all cores. XXH3 finds damage by accident as
//! surely as SHA-256, with a twentieth of the work; a part that is forged on purpose is found by an audit only.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use groundtruth::film;
use groundtruth::scene::STANDARD_INPUT;
use groundtruth::world::MAX_PIXELS;
use rayon::prelude::*;
use xxhash_rust::xxh3::xxh3_128;

use super::{ChannelSums, Header, NotFinite, Sums, U256, number_of_channels};

/// Bytes of the sums of a channel.
const CHANNEL: usize = 48;
/// Bytes of an entry of the list of values that are not finite.
const ENTRY: usize = 24;
/// Bytes of the digest at the end.
const DIGEST: usize = 16;
/// The largest header; one of a single range has about 300 bytes.
const LARGEST_HEADER: u64 = 1 << 20;
/// The most entries of the list of values that are not finite that are kept in memory: 400 MB.
const MOST_ENTRIES: u64 = 1 << 24;
/// Channels of a block, which is read at a time and has a digest of its own.
const BLOCK: usize = 1 << 12;

/// A file of sums that cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// The system cannot read or write it.
    #[error("{}: {source}", path.display())]
    System {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It is not a file of sums, or its bytes were changed.
    #[error("{}: is damaged or no file of sums: {problem}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        problem: String,
    },
}

/// A file of sums, of which only the header has been read.
#[derive(Clone, Debug)]
pub struct SumsFile {
    path: PathBuf,
    header: Header,
    /// Bytes of the header.
    start: u64,
}

/// What a file holds besides header and sums.
pub(super) struct Rest {
    /// The list of values that are not finite.
    pub not_finite: Vec<NotFinite>,
    /// The digest at the end, which is right.
    pub digest: [u8; DIGEST],
}

impl SumsFile {
    /// Reads the header of a file.
    ///
    /// # Errors
    /// [`FileError`]; the sums are not checked yet.
    pub fn open(path: &Path) -> Result<Self, FileError> {
        if path == Path::new(STANDARD_INPUT) {
            let problem = "sums are read in blocks by all cores: write the standard input to a file, and name that";
            return Err(system(path, std::io::Error::other(problem)));
        }
        // to open a pipe waits for a writer
        let kind = std::fs::metadata(path).map_err(|source| system(path, source))?;
        if !kind.is_file() {
            let problem = "it is no file: sums are read in blocks by all cores; name a file";
            return Err(system(path, std::io::Error::other(problem)));
        }
        let file = File::open(path).map_err(|source| system(path, source))?;
        let length = file.metadata().map_err(|source| system(path, source))?.len();
        let mut bytes = Vec::new();
        let mut reader = BufReader::new(file.take(LARGEST_HEADER));
        // a line of one byte is the empty one
        while reader.read_until(b'\n', &mut bytes).map_err(|source| system(path, source))? > 1 {}
        let damaged = |problem| FileError::Damaged { path: path.to_owned(), problem };
        let text = std::str::from_utf8(&bytes);
        let text = text.map_err(|_| damaged("its header is no text".to_owned()))?;
        let header = Header::parse(text).map_err(damaged)?;
        let [width, height] = header.size;
        if u64::from(width) * u64::from(height) > MAX_PIXELS {
            return Err(damaged(format!("{width}x{height} pixels are too many")));
        }
        let count = header.not_finite;
        if count > MOST_ENTRIES {
            let problem = format!("{count} values are not finite; {MOST_ENTRIES} can be merged");
            return Err(damaged(problem));
        }
        let start = bytes.len() as u64;
        let whole = header
            .not_finite
            .checked_mul(ENTRY as u64)
            .and_then(|list| list.checked_add(number_of_channels(header.size) * CHANNEL as u64))
            .and_then(|body| body.checked_add(start + DIGEST as u64));
        if whole != Some(length) {
            return Err(damaged(format!("its header does not fit its {length} bytes")));
        }
        Ok(Self { path: path.to_owned(), header, start })
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What its sums are of.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Checks every byte.
    ///
    /// # Errors
    /// [`FileError`].
    pub fn check(&self) -> Result<(), FileError> {
        self.checked().map(drop)
    }

    /// All of it.
    ///
    /// # Errors
    /// [`FileError`].
    pub fn read(&self) -> Result<Sums, FileError> {
        let mut sums = Sums::new(self.header.clone());
        let rest = self.each(&mut sums.channels, |_, sums, these| *sums = these)?;
        sums.not_finite = rest.not_finite;
        sums.count(&self.header.seeds);
        Ok(sums)
    }

    /// Calls `each` with the index of every channel, its entry of `film`, and its sums, for each of some parts of this
    /// size, in parallel; and checks the digests at their ends: what `each` did counts only if they are right. The
    /// memory is that of a block for each thread.
    ///
    /// A block of the film stays in the cache while those of all parts are read: loading and storing the film once for
    /// each part would take as long as all the rest.
    pub(super) fn each_of<T: Send>(
        parts: &[Self],
        film: &mut [T],
        each: impl Fn(usize, &mut T, ChannelSums) + Sync,
    ) -> Result<Vec<Rest>, FileError> {
        let blocks = film.par_chunks_mut(BLOCK).enumerate().map(|(block, entries)| {
            let first = block * BLOCK;
            let of_part = |part: &Self| {
                let bytes = part.bytes(part.at(first), entries.len() * CHANNEL)?;
                let sums = bytes.chunks_exact(CHANNEL).map(channel);
                for ((index, entry), sums) in (first..).zip(&mut *entries).zip(sums) {
                    each(index, entry, sums);
                }
                Ok(xxh3_128(&bytes))
            };
            parts.iter().map(of_part).collect::<Result<Vec<u128>, FileError>>()
        });
        let blocks: Vec<Vec<u128>> = blocks.collect::<Result<_, _>>()?;
        let of_part =
            |index: usize| blocks.iter().map(|digests| digests[index]).collect::<Vec<_>>();
        (0..).zip(parts).map(|(index, part)| part.rest(&of_part(index))).collect()
    }

    /// Checks the digest at the end, given those of the blocks, and reads what there is besides the sums.
    fn rest(&self, blocks: &[u128]) -> Result<Rest, FileError> {
        let count = number_of_channels(self.header.size) as usize;
        let header = self.bytes(0, self.start as usize)?;
        let list = self.bytes(self.at(count), self.header.not_finite as usize * ENTRY)?;
        let found = self.bytes(self.at(count) + list.len() as u64, DIGEST)?;
        if found != digest(&header, blocks, &list) {
            return Err(self.damaged("its bytes do not have the digest at its end"));
        }
        let not_finite: Vec<NotFinite> = list.chunks_exact(ENTRY).map(entry).collect();
        if not_finite.iter().any(|entry| entry.channel >= count as u64) {
            return Err(self.damaged("its list of values that are not finite names no pixel"));
        }
        Ok(Rest { not_finite, digest: array(&found) })
    }

    /// As [`SumsFile::each_of`], for this part alone.
    pub(super) fn each<T: Send>(
        &self,
        film: &mut [T],
        each: impl Fn(usize, &mut T, ChannelSums) + Sync,
    ) -> Result<Rest, FileError> {
        Ok(Self::each_of(std::slice::from_ref(self), film, each)?.remove(0))
    }

    /// Checks every byte, and reads what there is besides the sums.
    pub(super) fn checked(&self) -> Result<Rest, FileError> {
        let mut no_film = vec![(); number_of_channels(self.header.size) as usize];
        self.each(&mut no_film, |_, _, _| ())
    }

    /// The sums of a row, counted from the top. They are not checked: see [`SumsFile::check`].
    pub(super) fn row(&self, row: u32) -> Result<Vec<ChannelSums>, FileError> {
        let channels = 3 * self.header.size[0] as usize;
        let bytes = self.bytes(self.at(row as usize * channels), channels * CHANNEL)?;
        Ok(bytes.chunks_exact(CHANNEL).map(channel).collect())
    }

    /// Where in the file the sums of a channel begin.
    fn at(&self, channel: usize) -> u64 {
        self.start + (channel * CHANNEL) as u64
    }

    /// Some bytes of the file.
    fn bytes(&self, start: u64, count: usize) -> Result<Vec<u8>, FileError> {
        let read = || {
            let mut bytes = vec![0; count];
            let mut file = File::open(&self.path)?;
            file.seek(SeekFrom::Start(start))?;
            file.read_exact(&mut bytes)?;
            Ok(bytes)
        };
        read().map_err(|source| system(&self.path, source))
    }

    fn damaged(&self, problem: &str) -> FileError {
        FileError::Damaged { path: self.path.clone(), problem: problem.to_owned() }
    }
}

impl Sums {
    /// Writes the sums to a temporary file in the same folder, which then gets the name.
    ///
    /// # Errors
    /// [`FileError::System`]; nothing was left behind.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        let mut bytes = self.header.text().into_bytes();
        bytes.reserve(self.channels.len() * CHANNEL + self.not_finite.len() * ENTRY + DIGEST);
        let start = bytes.len();
        for sums in &self.channels {
            bytes.extend(sums.sum.to_le_bytes());
            bytes.extend(sums.squares.halves().map(u128::to_le_bytes).as_flattened());
        }
        for NotFinite { seed, channel, bits } in &self.not_finite {
            bytes.extend([seed, channel, bits].map(|number| number.to_le_bytes()).as_flattened());
        }
        let (header, body) = bytes.split_at(start);
        let (sums, list) = body.split_at(self.channels.len() * CHANNEL);
        let blocks: Vec<u128> = sums.par_chunks(BLOCK * CHANNEL).map(xxh3_128).collect();
        bytes.extend(digest(header, &blocks, list));
        film::replace(path, &bytes).map_err(|source| system(path, source))
    }
}

fn system(path: &Path, source: std::io::Error) -> FileError {
    FileError::System { path: path.to_owned(), source }
}

/// The digest at the end of a file with this header, these digests of the blocks of its sums, and this list.
fn digest(header: &[u8], blocks: &[u128], list: &[u8]) -> [u8; DIGEST] {
    let all = [&[xxh3_128(header)], blocks, &[xxh3_128(list)]].concat();
    let bytes: Vec<u8> = all.into_iter().flat_map(u128::to_le_bytes).collect();
    xxh3_128(&bytes).to_le_bytes()
}

fn entry(bytes: &[u8]) -> NotFinite {
    let [seed, channel, bits] = [0, 8, 16].map(|at| u64::from_le_bytes(array(&bytes[at..at + 8])));
    NotFinite { seed, channel, bits }
}

fn channel(bytes: &[u8]) -> ChannelSums {
    let half = |at: usize| u128::from_le_bytes(array(&bytes[at..at + 16]));
    ChannelSums { sum: half(0) as i128, squares: U256::new(half(16), half(32)) }
}

fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
    bytes.try_into().expect("the slice has this length")
}
