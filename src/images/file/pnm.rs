//! PPM, PGM and PBM (Netpbm's `ppm(5)`, `pgm(5)`, `pbm(5)`): P1 to P6, the format of the book.

use std::io::{Cursor, Read};

use image::codecs::pnm::{GraymapHeader, PixmapHeader, PnmDecoder, PnmHeader};

use super::{Encoding, Problem, check_size, damaged, integers, samples};
use crate::images::Texels;

/// Samples are divided by maxval. The decoder would round them to 8 or 16 bits and hide samples
/// above maxval, so it gets a header whose maxval needs no scaling.
pub fn decode(
    bytes: &[u8],
    encoding: Option<Encoding>,
    max_texels: u64,
) -> Result<Texels, Problem> {
    let (raster, header) = PnmDecoder::new(Cursor::new(bytes)).map_err(damaged)?.into_inner();
    check_size([header.width(), header.height()].map(u64::from), max_texels)?;
    let (unscaled, largest) = unscaled(header);
    let mut start = Vec::new();
    unscaled.write(&mut start).expect("nothing fails that is written to memory");
    let mut reader = Cursor::new(start).chain(raster);
    let image = samples(PnmDecoder::new(&mut reader).map_err(damaged)?)?;
    let mut left = Vec::new();
    reader.read_to_end(&mut left).expect("nothing fails that is read from memory");
    if left.iter().any(|byte| !byte.is_ascii_whitespace()) {
        let (width, height) = (image.width(), image.height());
        return Err(format!(
            "{} bytes are left after {width} × {height} texels; the size in its header is wrong",
            left.len()
        ));
    }
    integers(image, largest, encoding)
}

/// The same header with the largest maxval of the same number of bytes, and the sample that means
/// 1.
fn unscaled(header: PnmHeader) -> (PnmHeader, u16) {
    let full = |maxval: u32| if maxval <= 255 { 255 } else { u32::from(u16::MAX) };
    if let Some(&PixmapHeader { encoding, height, width, maxval }) = header.as_pixmap() {
        let header = PixmapHeader { encoding, height, width, maxval: full(maxval) };
        return (header.into(), maxval as u16);
    }
    if let Some(&GraymapHeader { encoding, height, width, maxwhite }) = header.as_graymap() {
        let header = GraymapHeader { encoding, height, width, maxwhite: full(maxwhite) };
        return (header.into(), maxwhite as u16);
    }
    // bits become 0 and 255
    (header, 255)
}
