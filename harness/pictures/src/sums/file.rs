//! Files of sums.
//!
//! A line with the format, a line with the header as JSON; for each channel `Σk` (16 bytes), `Σk²` (32 bytes) and the sum of
//! what is not finite (8 bytes), the least significant byte first; and the XXH3 digest of all this (128 bits, without a
//! seed). It finds damage by accident as surely as SHA-256, with a twentieth of the work; a part that is forged on purpose is
//! found by rendering it again.

use std::path::{Path, PathBuf};

use groundtruth::film;
use scenefile::STANDARD_INPUT;
use xxhash_rust::xxh3::xxh3_128;

use super::{ChannelSums, Header, Sums, U256};

/// The first line; the number is that of the format.
const FORMAT: &str = "groundtruth sums 4\n";
/// Bytes of the sums of a channel.
const CHANNEL: usize = 56;
/// Bytes of the digest at the end.
const DIGEST: usize = 16;

/// A file of sums that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// Why.
    pub problem: String,
}

/// The bytes of a file whose digest is right.
pub(super) struct Part {
    pub header: Header,
    bytes: Vec<u8>,
    start: usize,
}

impl Part {
    /// Reads a file, and checks every byte.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        Self::parsed(path).map_err(|problem| FileError { path: path.to_owned(), problem })
    }

    fn parsed(path: &Path) -> Result<Self, String> {
        if path == Path::new(STANDARD_INPUT) {
            return Err("write the standard input to a file, and name that".to_owned());
        }
        // to open a pipe waits for a writer
        let kind = std::fs::metadata(path).map_err(|e| e.to_string())?;
        if !kind.is_file() {
            return Err("it is no file: name a file".to_owned());
        }
        let bytes = std::fs::read(path).map_err(|e| e.to_string())?;
        let damaged = |problem: &str| format!("is damaged or no file of sums: {problem}");
        let rest = match bytes.strip_prefix(FORMAT.as_bytes()) {
            Some(rest) => rest,
            None if bytes.starts_with(b"groundtruth sums ") => {
                let problem = format!("its format is not `{}`", FORMAT.trim());
                return Err(damaged(&problem));
            }
            None => return Err(damaged("it does not begin as one")),
        };
        let digest = bytes.len().checked_sub(DIGEST).map(|end| bytes.split_at(end));
        if digest.is_none_or(|(all, digest)| xxh3_128(all).to_le_bytes() != digest) {
            return Err(damaged("its bytes do not have the digest at its end"));
        }
        let length = rest.iter().position(|byte| *byte == b'\n').unwrap_or_default();
        let header: Header =
            serde_json::from_slice(&rest[..length]).map_err(|e| damaged(&e.to_string()))?;
        let start = FORMAT.len() + length + 1;
        if header.seeds.is_empty() || header.size.contains(&0) {
            return Err(damaged("it is of no replica or of no pixel"));
        }
        let body = header.channels().checked_mul(CHANNEL);
        let whole = body.and_then(|body| body.checked_add(start + DIGEST));
        if whole != Some(bytes.len()) {
            return Err(damaged(&format!("its header does not fit its {} bytes", bytes.len())));
        }
        Ok(Self { header, bytes, start })
    }

    /// The sums of each channel.
    pub fn channels(&self) -> impl Iterator<Item = ChannelSums> {
        let body = &self.bytes[self.start..self.bytes.len() - DIGEST];
        body.chunks_exact(CHANNEL).map(channel)
    }
}

impl Sums {
    /// Reads a file of sums.
    ///
    /// # Errors
    /// [`FileError`]: the system cannot read it, or its bytes were changed.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        let part = Part::read(path)?;
        Ok(Self { channels: part.channels().collect(), header: part.header })
    }

    /// Writes the sums to a temporary file in the same folder, which then gets the name.
    ///
    /// # Errors
    /// [`FileError`]; nothing was left behind.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        let header = serde_json::to_string(&self.header).expect("texts and numbers are plain");
        let mut bytes = format!("{FORMAT}{header}\n").into_bytes();
        bytes.reserve(self.channels.len() * CHANNEL + DIGEST);
        for sums in &self.channels {
            bytes.extend(sums.sum.to_le_bytes());
            bytes.extend(sums.squares.halves().map(u128::to_le_bytes).as_flattened());
            bytes.extend(sums.others.to_le_bytes());
        }
        bytes.extend(xxh3_128(&bytes).to_le_bytes());
        film::replace(path, &bytes)
            .map_err(|e| FileError { path: path.to_owned(), problem: e.to_string() })
    }
}

fn channel(bytes: &[u8]) -> ChannelSums {
    let half = |at: usize| u128::from_le_bytes(array(&bytes[at..at + 16]));
    let others = u64::from_le_bytes(array(&bytes[48..]));
    ChannelSums { sum: half(0) as i128, squares: U256::new(half(16), half(32)), others }
}

fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
    bytes.try_into().expect("the slice has this length")
}
