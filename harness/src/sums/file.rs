//! Files of sums.
//!
//! Text lines and an empty one (see [`Header`]); for each channel `Σk` (16 bytes) and `Σk²` (32 bytes), the least
//! significant byte first; for each value that is NaN or infinite its seed, channel and bits (8 bytes each); and the
//! SHA-256 of all bytes before it.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use groundtruth::film;
use groundtruth::world::MAX_PIXELS;
use sha2::{Digest, Sha256};

use super::{ChannelSums, Header, NotFinite, Sums, U256, number_of_channels};

/// Bytes of the sums of a channel.
const CHANNEL: usize = 48;
/// Bytes of an entry of the list of values that are not finite.
const ENTRY: usize = 24;
/// Bytes of the SHA-256 at the end.
const DIGEST: usize = 32;
/// The largest header; one of a single range has about 300 bytes.
const LARGEST_HEADER: u64 = 1 << 20;
/// Channels that are read and hashed at a time.
const CHUNK: usize = 1 << 13;

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
pub struct Part {
    path: PathBuf,
    header: Header,
    /// Bytes of the header.
    start: u64,
}

/// What [`Part::each`] reads besides the sums.
pub(super) struct Rest {
    /// The list of values that are not finite.
    pub not_finite: Vec<NotFinite>,
    /// The digest at the end, which is right.
    pub digest: [u8; DIGEST],
}

impl Part {
    /// Reads the header of a file.
    ///
    /// # Errors
    /// [`FileError`]; the sums are not checked yet.
    pub fn open(path: &Path) -> Result<Self, FileError> {
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
        self.each(|_, _| ()).map(drop)
    }

    /// All of it.
    ///
    /// # Errors
    /// [`FileError`].
    pub fn read(&self) -> Result<Sums, FileError> {
        let mut sums = Sums::new(self.header.clone());
        let channels = &mut sums.channels;
        let rest = self.each(|index, one| channels[index] = one)?;
        sums.not_finite = rest.not_finite;
        sums.count(&self.header.seeds);
        Ok(sums)
    }

    /// Calls `each` with the index and the sums of every channel, and checks the digest at the end: the sums count only
    /// if it is right. The memory is that of a block of the file.
    pub(super) fn each(
        &self,
        mut each: impl FnMut(usize, ChannelSums) + Send,
    ) -> Result<Rest, FileError> {
        let mut file = BufReader::new(self.file()?);
        let mut hash = Sha256::new();
        let mut block = vec![0; self.start as usize];
        self.read_block(&mut file, &mut block)?;
        hash.update(&block);
        let (count, mut index) = (number_of_channels(self.header.size) as usize, 0);
        while index < count {
            block.resize(CHUNK.min(count - index) * CHANNEL, 0);
            self.read_block(&mut file, &mut block)?;
            rayon::join(
                || hash.update(&block),
                || {
                    for bytes in block.chunks_exact(CHANNEL) {
                        each(index, channel(bytes));
                        index += 1;
                    }
                },
            );
        }
        let mut not_finite = Vec::new();
        for _ in 0..self.header.not_finite {
            block.resize(ENTRY, 0);
            self.read_block(&mut file, &mut block)?;
            hash.update(&block);
            let [seed, channel, bits] =
                [0, 8, 16].map(|at| u64::from_le_bytes(array(&block[at..at + 8])));
            not_finite.push(NotFinite { seed, channel, bits });
        }
        if not_finite.iter().any(|entry| entry.channel >= count as u64) {
            let problem = "its list of values that are not finite names no pixel".to_owned();
            return Err(FileError::Damaged { path: self.path.clone(), problem });
        }
        let mut digest = [0; DIGEST];
        self.read_block(&mut file, &mut digest)?;
        if hash.finalize()[..] != digest {
            let problem = "its bytes do not have the SHA-256 at its end".to_owned();
            return Err(FileError::Damaged { path: self.path.clone(), problem });
        }
        Ok(Rest { not_finite, digest })
    }

    /// The sums of a row, counted from the top. They are not checked: see [`Part::check`].
    pub(super) fn row(&self, row: u32) -> Result<Vec<ChannelSums>, FileError> {
        let mut file = self.file()?;
        let mut block = vec![0; 3 * self.header.size[0] as usize * CHANNEL];
        let start = SeekFrom::Start(self.start + u64::from(row) * block.len() as u64);
        file.seek(start).map_err(|source| system(&self.path, source))?;
        self.read_block(&mut file, &mut block)?;
        Ok(block.chunks_exact(CHANNEL).map(channel).collect())
    }

    fn file(&self) -> Result<File, FileError> {
        File::open(&self.path).map_err(|source| system(&self.path, source))
    }

    fn read_block(&self, file: &mut impl Read, block: &mut [u8]) -> Result<(), FileError> {
        file.read_exact(block).map_err(|source| system(&self.path, source))
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
        for sums in &self.channels {
            bytes.extend(sums.sum.to_le_bytes());
            bytes.extend(sums.squares.halves().map(u128::to_le_bytes).as_flattened());
        }
        for NotFinite { seed, channel, bits } in &self.not_finite {
            bytes.extend([seed, channel, bits].map(|number| number.to_le_bytes()).as_flattened());
        }
        let digest = Sha256::digest(&bytes);
        bytes.extend_from_slice(&digest);
        film::replace(path, &bytes).map_err(|source| system(path, source))
    }
}

fn system(path: &Path, source: std::io::Error) -> FileError {
    FileError::System { path: path.to_owned(), source }
}

fn channel(bytes: &[u8]) -> ChannelSums {
    let half = |at: usize| u128::from_le_bytes(array(&bytes[at..at + 16]));
    ChannelSums { sum: half(0) as i128, squares: U256::new(half(16), half(32)) }
}

fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
    bytes.try_into().expect("the slice has this length")
}
