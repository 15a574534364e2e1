//! PFM (Debevec's portable float map): `PF` for colours, `Pf` for grey; rows from the bottom up.

use super::{Problem, after_the_end, check_size};
use crate::images::Texels;

/// A negative scale in the header means that the least significant byte comes first. Its magnitude, for
/// which the format gives no meaning, is ignored.
pub fn decode(bytes: &[u8], max_texels: u64) -> Result<Texels, Problem> {
    let channels = if bytes[1] == b'F' { 3 } else { 1 };
    let mut rest = &bytes[2..];
    let width: u64 = number(&mut rest, "width")?;
    let height: u64 = number(&mut rest, "height")?;
    let scale: f64 = number(&mut rest, "scale")?;
    if !scale.is_finite() || scale == 0.0 {
        return Err(format!("its scale is {scale}; right are -1 and 1; it is damaged"));
    }
    check_size([width, height], max_texels)?;
    let raster = rest.split_first().map_or(rest, |(_space, raster)| raster);
    let size = (width * height * channels * 4) as usize;
    let Some((raster, after)) = raster.split_at_checked(size) else {
        return Err("the file ends before its last texel; it is damaged".to_owned());
    };
    let (samples, _) = raster.as_chunks::<4>();
    let sample = |bytes: &[u8; 4]| {
        if scale < 0.0 { f32::from_le_bytes(*bytes) } else { f32::from_be_bytes(*bytes) }
    };
    let mut colors = Vec::with_capacity((width * height) as usize);
    for row in samples.chunks_exact((width * channels) as usize).rev() {
        let texels = row.chunks_exact(channels as usize);
        colors.extend(texels.map(|c| match c {
            [r, g, b] => [r, g, b].map(sample),
            grey => [sample(&grey[0]); 3],
        }));
    }
    let note = (scale.abs() != 1.0).then(|| format!("its scale of {scale} is ignored"));
    let texels = Texels::new(width as u32, height as u32, colors);
    Ok(texels.with_notes(note).with_notes(after_the_end(after)))
}

/// The next number of the header.
fn number<T: std::str::FromStr>(rest: &mut &[u8], what: &str) -> Result<T, Problem> {
    let start = rest.trim_ascii_start();
    let end = start.iter().position(u8::is_ascii_whitespace).unwrap_or(start.len());
    let (word, after) = start.split_at(end);
    *rest = after;
    let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
    number.ok_or_else(|| {
        format!("its {what} is `{}`, not a number; it is damaged", word.escape_ascii())
    })
}
