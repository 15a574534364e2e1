//! EXR files of named channels.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, Text,
    WritableImage,
};

use super::Provenance;

/// A channel of numbers.
#[derive(Clone, Debug)]
pub struct Channel {
    /// Its name, in the letters that EXR knows (Latin 1). A dot ends the name of its layer.
    pub name: String,
    /// Its values, row by row from the top left.
    pub values: Vec<f32>,
}

/// The bytes of an EXR file of such channels, each with `width × height` values, in single precision and with the
/// comment. It says how it was made.
///
/// # Errors
/// A name that EXR cannot say, or that is there twice.
pub fn encode_channels(
    [width, height]: [u32; 2],
    channels: Vec<Channel>,
    comment: &str,
    made: &Provenance,
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
    let mut encoded = Cursor::new(Vec::new());
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut encoded)
        .map_err(|error| std::io::Error::other(error.to_string()))?;
    Ok(made.in_exr(&encoded.into_inner()).expect("an EXR file of one part"))
}
