//! What a picture file says of its own making.
//!
//! There is no time, host or path in it: equal pictures are equal files. The entries are put into files that are
//! encoded already, in this order; the `exr` crate keeps attributes of other names in no fixed order.

use serde::Serialize;

/// How a picture was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Provenance {
    /// A scene of the gallery, or what else names a scene by its content.
    pub scene: String,
    /// Columns and rows of the whole picture; of a stereo pair: of each eye's image.
    pub size: [u32; 2],
    /// Samples for each pixel.
    pub samples: u32,
    /// The seed of all random choices; of several replicas the first one.
    pub seed: u64,
    /// The replicas whose mean it is, if it is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replicas: Option<Replicas>,
    /// The tracer's name in scene files.
    pub tracer: String,
    /// The largest depth of a ray that is traced; `None` for ray casting.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_depth: Option<u32>,
    /// Which part of the picture it is, if not the whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// The known mistake of the program that made it, if it was made with one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistake: Option<String>,
    /// How radiance is shown, if not as the scene says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tone: Option<String>,
    /// The version of this program.
    pub version: &'static str,
}

/// Pictures of one scene with other seeds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Replicas {
    /// How many there are.
    pub count: u64,
    /// Their seeds, such as `0 to 7, 9`.
    pub seeds: String,
}

/// Bytes of a PNG file's signature, and of the header with its length, kind and checksum.
const HEADER: usize = 8 + 25;
/// Bytes of the chunk of the gamma, with its length, kind and checksum.
const GAMMA: usize = 16;

/// A PNG file with the gamma of its values, after its header.
pub(super) fn with_gamma(png: &[u8], gamma: f64) -> Vec<u8> {
    let (header, rest) = png.split_at(HEADER);
    let mut bytes = header.to_vec();
    // the power of radiance, in units of 1/100000
    let power = (1e5 / gamma).round().clamp(1.0, f64::from(u32::MAX >> 1)) as u32;
    chunk(&mut bytes, b"gAMA", &power.to_be_bytes());
    bytes.extend(rest);
    bytes
}

impl Provenance {
    /// The version of this program.
    pub const VERSION: &'static str = env!("CARGO_PKG_VERSION");

    /// Names and texts, in the order of the file.
    fn entries(&self) -> Vec<(&'static str, String)> {
        let [width, height] = self.size;
        let mut entries = vec![
            ("Software", format!("groundtruth {}", self.version)),
            ("Scene", self.scene.clone()),
            ("Size", format!("{width}x{height}")),
            ("Samples", self.samples.to_string()),
        ];
        match &self.replicas {
            None => entries.push(("Seed", self.seed.to_string())),
            Some(Replicas { count, seeds }) => {
                entries.extend([("Replicas", count.to_string()), ("Seeds", seeds.clone())]);
            }
        }
        entries.push(("Tracer", self.tracer.clone()));
        entries.extend(self.max_depth.map(|depth| ("MaxDepth", depth.to_string())));
        entries.extend(self.part.clone().map(|part| ("Part", part)));
        entries.extend(self.mistake.clone().map(|mistake| ("Mistake", mistake)));
        entries.extend(self.tone.clone().map(|tone| ("Tone", tone)));
        entries
    }

    /// A PNG file of [`with_gamma`] with the entries as texts, after its gamma.
    pub(super) fn in_png(&self, png: &[u8]) -> Vec<u8> {
        let (header, rest) = png.split_at(HEADER + GAMMA);
        let mut bytes = header.to_vec();
        for (name, text) in self.entries() {
            // keyword; not compressed; no language; no translated keyword
            match text.is_ascii() {
                true => chunk(&mut bytes, b"tEXt", format!("{name}\0{text}").as_bytes()),
                false => chunk(&mut bytes, b"iTXt", format!("{name}\0\0\0\0\0{text}").as_bytes()),
            }
        }
        bytes.extend(rest);
        bytes
    }

    /// An EXR file with the entries as attributes, at the end of its header. `None` if it is no file of one part.
    pub(super) fn in_exr(&self, exr: &[u8]) -> Option<Vec<u8>> {
        let end = end_of_header(exr)?;
        let mut bytes = exr[..end].to_vec();
        for (name, text) in self.entries() {
            bytes.extend(format!("{}\0string\0", name.to_lowercase()).as_bytes());
            bytes.extend(u32::try_from(text.len()).ok()?.to_le_bytes());
            bytes.extend(text.as_bytes());
        }
        let added = (bytes.len() - end) as u64;
        bytes.push(0);
        // the offsets of the blocks of rows, up to the first block
        let table = end + 1;
        let offset = |at: usize| Some(u64::from_le_bytes(*exr.get(at..)?.first_chunk()?));
        let first = usize::try_from(offset(table)?).ok()?;
        for at in (table..first).step_by(8) {
            bytes.extend((offset(at)? + added).to_le_bytes());
        }
        bytes.extend(exr.get(first..)?);
        Some(bytes)
    }
}

/// Appends a chunk of a PNG file.
fn chunk(bytes: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    let body = [kind, data].concat();
    bytes.extend((data.len() as u32).to_be_bytes());
    bytes.extend(&body);
    bytes.extend(crc32fast::hash(&body).to_be_bytes());
}

/// The place of the zero that ends the attributes of an EXR file of one part.
fn end_of_header(exr: &[u8]) -> Option<usize> {
    let text_end =
        |from: usize| Some(from + exr.get(from..)?.iter().position(|&byte| byte == 0)? + 1);
    let mut at = 8; // after the magic number and the version
    while *exr.get(at)? != 0 {
        let size = text_end(text_end(at)?)?; // after name and type
        let length = u32::from_le_bytes(*exr.get(size..)?.first_chunk()?);
        at = size + 4 + length as usize;
    }
    Some(at)
}
