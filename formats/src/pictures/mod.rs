//! Pictures as the bytes of files: PNG and PPM of bytes for display, EXR and PFM of linear radiance in single precision.
//! Pixels stand row by row from the top left.

mod entries;

use std::io::{BufWriter, Cursor};

use exr::image::write::layers::WritableLayers;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels,
    ReadLayers, SpecificChannels, Text, WritableImage,
};

pub use entries::{with_attributes, with_texts};

/// Netpbm's binary form with one byte a sample.
pub fn ppm([width, height]: [u32; 2], bytes: &[u8]) -> Vec<u8> {
    [format!("P6\n{width} {height}\n255\n").as_bytes(), bytes].concat()
}

/// Rows from the bottom up; a negative scale says that the least significant byte comes first.
pub fn pfm([width, height]: [u32; 2], pixels: &[[f32; 3]]) -> Vec<u8> {
    let mut bytes = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    for row in pixels.chunks_exact(width as usize).rev() {
        bytes.extend(row.iter().flatten().flat_map(|sample| sample.to_le_bytes()));
    }
    bytes
}

/// A PNG file of three bytes a pixel.
///
/// # Errors
/// Of the encoder; none is known.
///
/// # Panics
/// If there are not three bytes for each pixel.
pub fn png([width, height]: [u32; 2], bytes: Vec<u8>) -> std::io::Result<Vec<u8>> {
    let picture =
        image::RgbImage::from_raw(width, height, bytes).expect("three bytes for each pixel");
    let mut encoded = Cursor::new(Vec::new());
    picture
        .write_to(&mut BufWriter::new(&mut encoded), image::ImageFormat::Png)
        .map_err(std::io::Error::other)?;
    Ok(encoded.into_inner())
}

/// An EXR file of red, green and blue.
///
/// # Errors
/// Of the encoder; none is known.
pub fn exr([width, height]: [u32; 2], pixels: &[[f32; 3]]) -> std::io::Result<Vec<u8>> {
    let channels = SpecificChannels::rgb(|at: exr::math::Vec2<usize>| {
        let [r, g, b] = pixels[at.1 * width as usize + at.0];
        (r, g, b)
    });
    exr_bytes(&Image::from_channels((width as usize, height as usize), channels))
}

/// A channel of numbers.
#[derive(Clone, Debug)]
pub struct Channel {
    /// Its name, in the letters that EXR knows (Latin 1). A dot ends the name of its layer.
    pub name: String,
    /// Its values, row by row from the top left.
    pub values: Vec<f32>,
}

/// An EXR file of such channels, each with `width × height` values, in single precision and with the comment.
///
/// # Errors
/// A name that EXR cannot say, or that is there twice.
pub fn exr_of_channels(
    [width, height]: [u32; 2],
    channels: Vec<Channel>,
    comment: &str,
) -> std::io::Result<Vec<u8>> {
    let channel = |Channel { name, values }: Channel| {
        let refused = || std::io::Error::other(format!("EXR has no such name: {name}"));
        let name = Text::new_or_none(&name).ok_or_else(refused)?;
        Ok(AnyChannel::new(name, FlatSamples::F32(values)))
    };
    let list = channels.into_iter().map(channel).collect::<std::io::Result<_>>()?;
    // letters that it does not know are left out of a comment
    let comment: String = comment.chars().filter(|&letter| u8::try_from(letter).is_ok()).collect();
    let attributes =
        LayerAttributes { comments: Text::new_or_none(&comment), ..LayerAttributes::default() };
    let size = (width as usize, height as usize);
    let layer = Layer::new(size, attributes, Encoding::FAST_LOSSLESS, AnyChannels::sort(list));
    exr_bytes(&Image::from_layer(layer))
}

fn exr_bytes<'a, L: WritableLayers<'a>>(image: &'a Image<L>) -> std::io::Result<Vec<u8>> {
    let mut encoded = Cursor::new(Vec::new());
    image
        .write()
        .non_parallel() // the same bytes each time: goldens are kept in git
        .to_buffered(&mut encoded)
        .map_err(|error| std::io::Error::other(error.to_string()))?;
    Ok(encoded.into_inner())
}

/// Decodes the first layer with channels R, G and B of an EXR file. `create` allocates the picture for its
/// columns and rows; `set` sets the colour at a column and a row from the top.
///
/// # Errors
/// What is wrong with them.
pub fn read_exr<P: 'static>(
    bytes: &[u8],
    create: impl Fn([u32; 2]) -> P + 'static,
    set: impl Fn(&mut P, [u32; 2], [f32; 3]) + 'static,
) -> Result<P, String> {
    exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            move |size, _: &_| create([size.width() as u32, size.height() as u32]),
            move |pixels: &mut P, at, (r, g, b, _): (f32, f32, f32, f32)| {
                set(pixels, [at.x() as u32, at.y() as u32], [r, g, b]);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .map(|image| image.layer_data.channel_data.pixels)
        .map_err(|e| e.to_string())
}

/// Base 64 of RFC 4648, with padding.
pub fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { digit.into() } else { '=' });
        }
    }
    text
}
