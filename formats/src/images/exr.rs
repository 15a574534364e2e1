//! OpenEXR, the format in which pictures are written: one layer, placed in the display window.

use std::collections::HashSet;
use std::io::Cursor;

use exr::block::UncompressedBlock;
use exr::block::reader::ChunksReader;
use exr::error::Error;
use exr::meta::header::Header;
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{SampleType, f16};

use super::exr_layers::{self, Layer};
use super::{Problem, Wrong, check_size};
use crate::images::Texels;

/// The layer `wanted`, or the only one. Texels outside the data window are black.
pub fn decode(bytes: &[u8], wanted: Option<&str>, max_texels: u64) -> Result<Texels, Wrong> {
    check_forms(bytes)?;
    let meta = MetaData::read_from_buffered(bytes, false).map_err(|e| of_crate(&e))?;
    let (layer, notes) = exr_layers::choose(&meta.headers, wanted)?;
    let header = &meta.headers[layer.part];
    check_header(header, &layer, max_texels)?;
    let mut picture = Picture::new(header, &layer);
    picture.read(bytes).map_err(|e| of_crate(&e))?;
    if picture.found != header.layer_size.area() {
        return Err(format!(
            "{} of its {} texels are missing; it is damaged",
            header.layer_size.area() - picture.found,
            header.layer_size.area()
        )
        .into());
    }
    let cropped = picture.cropped;
    let note =
        (cropped > 0).then(|| format!("{cropped} texels outside its display window are ignored"));
    let size = picture.size.map(|length| length as u32);
    let transparent = match layer.alpha {
        Some(_) => picture.colors.len() as u64 - picture.opaque,
        None => 0,
    };
    let texels = Texels { transparent, ..Texels::new(size[0], size[1], picture.colors) };
    Ok(texels.with_notes(notes).with_notes(note))
}

/// The texels of the display window, while blocks are read.
struct Picture<'a> {
    header: &'a Header,
    layer: &'a Layer,
    size: [usize; 2],
    /// From the display window's corner to that of the data window.
    offset: [i64; 2],
    colors: Vec<[f32; 3]>,
    /// The texels of the data window found so far, and those of them outside the display window.
    found: usize,
    cropped: usize,
    /// The texels of the display window whose alpha is 1; those that are in no data have none.
    opaque: u64,
}

/// Alpha from here on counts as 1: the largest number of half precision below it may be 1 with a rounding error.
const OPAQUE: f32 = 1.0 - 1.0 / 2048.0;

impl<'a> Picture<'a> {
    fn new(header: &'a Header, layer: &'a Layer) -> Self {
        let display = header.shared_attributes.display_window;
        let data = header.own_attributes.layer_position;
        let size = [display.size.width(), display.size.height()];
        let offset = [
            i64::from(data.x()) - i64::from(display.position.x()),
            i64::from(data.y()) - i64::from(display.position.y()),
        ];
        let colors = vec![[0.0; 3]; size[0] * size[1]];
        Self { header, layer, size, offset, colors, found: 0, cropped: 0, opaque: 0 }
    }

    fn read(&mut self, bytes: &[u8]) -> Result<(), Error> {
        let invalid = |problem: String| Error::Invalid(problem.into());
        let part = self.layer.part;
        let reader = exr::block::read(Cursor::new(bytes), false)?;
        let chunks = reader.filter_chunks(false, |_, tile, block| {
            block.layer == part && tile.is_largest_resolution_level()
        })?;
        let mut seen = HashSet::new();
        // in this thread, where a panic of the decoder is an error
        chunks.decompress_sequential(false, |_, block| {
            let (at, level) = (block.index.pixel_position, block.index.level);
            if block.index.layer != part || (level.x(), level.y()) != (0, 0) {
                return Err(invalid("an offset leads to another layer or level".to_owned()));
            }
            if !seen.insert((at.x(), at.y())) {
                return Err(invalid(format!(
                    "the lines from {} on are found twice, others never: its table of offsets is \
                     wrong",
                    at.y()
                )));
            }
            self.found += block.index.pixel_size.area();
            self.add(&block)
        })
    }

    fn add(&mut self, block: &UncompressedBlock) -> Result<(), Error> {
        for line in block.lines(&self.header.channels) {
            let channel = line.location.channel;
            if !self.layer.channels.contains(&channel) && self.layer.alpha != Some(channel) {
                continue;
            }
            let samples: Vec<f32> = match self.header.channels.list[channel].sample_type {
                SampleType::F32 => line.read_samples::<f32>().collect::<Result<_, _>>()?,
                SampleType::F16 => line
                    .read_samples::<f16>()
                    .map(|s| s.map(f16::to_f32))
                    .collect::<Result<_, _>>()?,
                SampleType::U32 => line
                    .read_samples::<u32>()
                    .map(|s| s.map(|s| s as f32))
                    .collect::<Result<_, _>>()?,
            };
            let start = [line.location.position.x(), line.location.position.y()];
            for (i, sample) in samples.into_iter().enumerate() {
                self.set([start[0] + i, start[1]], channel, sample);
            }
        }
        Ok(())
    }

    fn set(&mut self, at: [usize; 2], channel: usize, sample: f32) {
        let at = [0, 1].map(|i| usize::try_from(at[i] as i64 + self.offset[i]).ok());
        let inside = |i: usize| at[i].filter(|at| *at < self.size[i]);
        let (Some(x), Some(y)) = (inside(0), inside(1)) else {
            self.cropped += usize::from(channel == self.layer.channels[0]);
            return;
        };
        if self.layer.alpha == Some(channel) {
            self.opaque += u64::from(sample >= OPAQUE);
            return;
        }
        let color = &mut self.colors[y * self.size[0] + x];
        for (value, _) in color.iter_mut().zip(self.layer.channels).filter(|(_, c)| *c == channel) {
            *value = sample;
        }
    }
}

/// Checks sizes and forms before memory is allocated.
fn check_header(header: &Header, layer: &Layer, max_texels: u64) -> Result<(), Problem> {
    /// The limits for one texel, and for the texels that are compressed together.
    const MAX_BYTES_PER_TEXEL: usize = 1 << 10;
    const MAX_BYTES_PER_BLOCK: u64 = 1 << 30;
    let [width, height] = [header.layer_size.width(), header.layer_size.height()];
    check_size([width as u64, height as u64], max_texels)?;
    let display = header.shared_attributes.display_window.size;
    check_size([display.width() as u64, display.height() as u64], max_texels)?;
    let used = layer.channels.into_iter().chain(layer.alpha);
    let mut sampling = used.map(|channel| header.channels.list[channel].sampling);
    if sampling.any(|sampling| (sampling.x(), sampling.y()) != (1, 1)) {
        return Err("channels of a lower resolution (subsampled) are not supported".to_owned());
    }
    let texel = header.channels.bytes_per_pixel;
    let texels = match header.blocks {
        BlockDescription::Tiles(tiles) => {
            let [width, height] = [tiles.tile_size.width(), tiles.tile_size.height()];
            (width as u64).saturating_mul(height as u64)
        }
        BlockDescription::ScanLines => (header.compression.scan_lines_per_block() * width) as u64,
    };
    let block = texels.saturating_mul(texel as u64);
    if texel > MAX_BYTES_PER_TEXEL || block > MAX_BYTES_PER_BLOCK {
        return Err(format!(
            "{texel} bytes a texel, {block} in a block, are too many; at most \
             {MAX_BYTES_PER_TEXEL} and {MAX_BYTES_PER_BLOCK} fit"
        ));
    }
    Ok(())
}

/// Fails for a compression that the format does not define; the decoder calls such a file invalid.
fn check_forms(bytes: &[u8]) -> Result<(), Problem> {
    const ATTRIBUTE: &[u8] = b"\0compression\0compression\0\x01\0\0\0";
    const LAST_KNOWN: u8 = 9;
    let found = bytes.windows(ATTRIBUTE.len()).take(1 << 16).position(|w| w == ATTRIBUTE);
    match found.and_then(|at| bytes.get(at + ATTRIBUTE.len())) {
        Some(&number) if number > LAST_KNOWN => {
            Err(format!("compression {number} is not supported; save it with ZIP compression"))
        }
        _ => Ok(()),
    }
}

fn of_crate(error: &Error) -> Problem {
    match error {
        Error::NotSupported(what) => format!("{what}: not supported"),
        other => format!("it is damaged: {other}"),
    }
}
