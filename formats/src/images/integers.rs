//! Colours of integer samples: grey or three channels, with alpha or without, encoded for display or not.

use image::DynamicImage;

use super::{Problem, Texels, Transfer};

/// The colours of integer samples, where `largest` means 1: grey, or red, green and blue; alpha is
/// ignored.
pub(super) fn integers(
    image: DynamicImage,
    largest: u16,
    transfer: Transfer,
) -> Result<Texels, Problem> {
    let linear = |sample: u32| transfer.decoded(f64::from(sample) / f64::from(largest)) as f32;
    // a table, because many texels have the same sample values
    let table: Vec<f32> = (0..=u32::from(largest)).map(linear).collect();
    let (width, height) = (image.width(), image.height());
    let channels = usize::from(image.color().channel_count());
    let colors = match image.as_bytes() {
        bytes if usize::from(image.color().bytes_per_pixel()) == channels => {
            colors(bytes.iter().map(|sample| u16::from(*sample)), channels, &table)
        }
        bytes => {
            let (pairs, _) = bytes.as_chunks::<2>();
            colors(pairs.iter().map(|pair| u16::from_ne_bytes(*pair)), channels, &table)
        }
    };
    let (colors, transparent) = colors?;
    Ok(Texels { transparent, ..Texels::new(width, height, colors) })
}

/// The colours of samples, and the number of those whose alpha is not the largest value.
fn colors(
    samples: impl Iterator<Item = u16>,
    channels: usize,
    table: &[f32],
) -> Result<(Vec<[f32; 3]>, u64), Problem> {
    let opaque = table.last().copied();
    let mut values = samples.map(|sample| {
        table.get(usize::from(sample)).copied().ok_or_else(|| {
            let largest = table.len() - 1;
            format!("found a sample of {sample}, but the largest value (maxval) is {largest}")
        })
    });
    let (mut colors, mut transparent) = (Vec::with_capacity(values.size_hint().0 / channels), 0);
    while let Some(first) = values.next() {
        let mut next = || values.next().expect("texels have all their channels");
        let first = first?;
        colors.push(if channels < 3 { [first; 3] } else { [first, next()?, next()?] });
        if channels.is_multiple_of(2) {
            transparent += u64::from(Some(next()?) != opaque);
        }
    }
    Ok((colors, transparent))
}
