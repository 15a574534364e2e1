//! Names and texts in picture files that are encoded already, in their order: the `exr` crate keeps attributes of other
//! names in no fixed one.

/// Bytes of a PNG file's signature, and of the header with its length, kind and checksum.
const HEADER: usize = 8 + 25;

/// A PNG file with the gamma of its values and the entries as texts, after its header.
pub fn with_texts(png: &[u8], gamma: f64, entries: &[(&str, String)]) -> Vec<u8> {
    let (header, rest) = png.split_at(HEADER);
    let mut bytes = header.to_vec();
    // the power of radiance, in units of 1/100000
    let power = (1e5 / gamma).round().clamp(1.0, f64::from(u32::MAX >> 1)) as u32;
    chunk(&mut bytes, b"gAMA", &power.to_be_bytes());
    for (name, text) in entries {
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
pub fn with_attributes(exr: &[u8], entries: &[(&str, String)]) -> Option<Vec<u8>> {
    let end = end_of_header(exr)?;
    let mut bytes = exr[..end].to_vec();
    for (name, text) in entries {
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
