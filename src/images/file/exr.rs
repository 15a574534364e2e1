//! OpenEXR, the format in which pictures are written.

use exr::meta::{BlockDescription, MetaData};

use super::{Problem, check_size, radiance};
use crate::film;
use crate::images::Texels;

/// The first layer that has channels R, G and B.
pub fn decode(bytes: &[u8], max_texels: u64) -> Result<Texels, Problem> {
    check_headers(bytes, max_texels)?;
    type Pixels = (u32, u32, Vec<[f32; 3]>);
    let read = film::decode_exr(
        bytes,
        |[width, height]| -> Pixels {
            (width, height, vec![[0.0; 3]; width as usize * height as usize])
        },
        |(width, _, colors): &mut Pixels, [x, y], color| {
            colors[y as usize * *width as usize + x as usize] = color;
        },
    );
    let (width, height, colors) = read.map_err(damaged)?;
    radiance(width, height, colors)
}

/// Checks sizes before memory is allocated.
fn check_headers(bytes: &[u8], max_texels: u64) -> Result<(), Problem> {
    /// The limits for one texel, and for the texels that are compressed together.
    const MAX_BYTES_PER_TEXEL: usize = 1 << 10;
    const MAX_BYTES_PER_BLOCK: u64 = 1 << 30;
    let meta = MetaData::read_from_buffered(bytes, false).map_err(|e| damaged(e.to_string()))?;
    for header in &meta.headers {
        let [width, height] = [header.layer_size.width(), header.layer_size.height()];
        check_size([width as u64, height as u64], max_texels)?;
        let texel = header.channels.bytes_per_pixel;
        let texels = match header.blocks {
            BlockDescription::Tiles(tiles) => {
                let [width, height] = [tiles.tile_size.width(), tiles.tile_size.height()];
                (width as u64).saturating_mul(height as u64)
            }
            BlockDescription::ScanLines => {
                (header.compression.scan_lines_per_block() * width) as u64
            }
        };
        let block = texels.saturating_mul(texel as u64);
        if texel > MAX_BYTES_PER_TEXEL || block > MAX_BYTES_PER_BLOCK {
            return Err(format!(
                "{texel} bytes a texel, {block} in a block, are too many; at most \
                 {MAX_BYTES_PER_TEXEL} and {MAX_BYTES_PER_BLOCK} fit"
            ));
        }
    }
    Ok(())
}

fn damaged(problem: String) -> Problem {
    format!("it is damaged, or has no channels R, G and B: {problem}")
}
