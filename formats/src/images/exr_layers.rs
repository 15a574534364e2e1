//! Which channels of an EXR file are the image: layers, views and grey.

use exr::meta::header::Header;
use exr::prelude::ChannelDescription;

use super::{Problem, Wrong};

/// Three channels of one part of a file, or one for all three.
pub struct Layer {
    /// The index of the part.
    pub part: usize,
    /// The indices of its channels R, G and B.
    pub channels: [usize; 3],
    /// The index of its channel A, if it has one.
    pub alpha: Option<usize>,
    /// How a scene names it; empty for the main image.
    name: String,
    view: Option<String>,
}

/// The layer of this name, or the only one; the main image (of channels without a prefix) precedes named
/// ones.
pub fn choose(headers: &[Header], wanted: Option<&str>) -> Result<(Layer, Vec<String>), Wrong> {
    let colors = all(headers, colors_of);
    let greys = all(headers, grey_of);
    if let Some(wanted) = wanted {
        let layers = colors.into_iter().chain(greys);
        let (mut fit, others): (Vec<_>, Vec<_>) =
            layers.partition(|layer| layer.name == wanted || layer.view.as_deref() == Some(wanted));
        return match fit.len() {
            0 => {
                let others = names(&others);
                Err(Wrong::layer(format!("it has no layer `{wanted}`; it has {others}")))
            }
            1 => Ok((fit.remove(0), Vec::new())),
            _ => {
                let fit = names(&fit);
                Err(Wrong::layer(format!("`{wanted}` can be each of {fit}; name one of them")))
            }
        };
    }
    let mut layers = if colors.is_empty() { greys } else { colors };
    if let Some(main) = layers.iter().position(|layer| layer.name.is_empty()) {
        let main = layers.remove(main);
        let note = format!("its other layers are ignored: {}", names(&layers));
        return Ok((main, if layers.is_empty() { Vec::new() } else { vec![note] }));
    }
    match layers.len() {
        0 => Err(without_colors(headers).into()),
        1 => Ok((layers.remove(0), Vec::new())),
        _ => {
            let layers = names(&layers);
            Err(Wrong::layer(format!("it has several layers; choose one: layer = {layers}")))
        }
    }
}

fn names(layers: &[Layer]) -> String {
    let names: Vec<String> = layers.iter().map(|layer| format!("\"{}\"", layer.name)).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// Every layer whose first channel `channels_of` accepts, in the order of the file.
fn all(
    headers: &[Header],
    channels_of: fn(&[ChannelDescription], &str) -> Option<[usize; 3]>,
) -> Vec<Layer> {
    let mut layers: Vec<Layer> = Vec::new();
    for (part, header) in headers.iter().enumerate().filter(|(_, header)| !header.deep) {
        let part_name = header.own_attributes.layer_name.as_ref().map(ToString::to_string);
        // a file of one part has no need of its name
        let part_name = part_name.filter(|_| headers.len() > 1);
        let view = header.own_attributes.view_name.as_ref().map(ToString::to_string);
        let list = &header.channels.list;
        let mut prefixes: Vec<String> =
            list.iter().map(|c| split(&c.name.to_string()).0.to_owned()).collect();
        prefixes.sort();
        prefixes.dedup();
        for prefix in prefixes {
            let Some(channels) = channels_of(list, &prefix) else { continue };
            let alpha = index(list, &prefix, "A");
            let names = [part_name.as_deref().unwrap_or_default(), prefix.as_str()];
            let names: Vec<&str> = names.into_iter().filter(|name| !name.is_empty()).collect();
            layers.push(Layer { part, channels, alpha, name: names.join("."), view: view.clone() });
        }
    }
    layers
}

/// `("ViewLayer.Combined", "R")` from `ViewLayer.Combined.R`.
fn split(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or(("", name))
}

fn index(list: &[ChannelDescription], prefix: &str, last: &str) -> Option<usize> {
    list.iter().position(|channel| split(&channel.name.to_string()) == (prefix, last))
}

fn colors_of(list: &[ChannelDescription], prefix: &str) -> Option<[usize; 3]> {
    let [r, g, b] = ["R", "G", "B"].map(|last| index(list, prefix, last));
    Some([r?, g?, b?])
}

fn grey_of(list: &[ChannelDescription], prefix: &str) -> Option<[usize; 3]> {
    let has_chroma = ["RY", "BY"].iter().any(|last| index(list, prefix, last).is_some());
    index(list, prefix, "Y").filter(|_| !has_chroma).map(|y| [y; 3])
}

fn without_colors(headers: &[Header]) -> Problem {
    let channels = headers.iter().flat_map(|header| &header.channels.list);
    let channels: Vec<String> = channels.map(|channel| channel.name.to_string()).collect();
    if headers.iter().all(|header| header.deep) {
        return "deep EXR files are not supported; flatten it".to_owned();
    }
    if channels.iter().any(|name| matches!(split(name).1, "RY" | "BY")) {
        return "luminance and chroma (channels Y, RY and BY) are not supported; convert it to R, G \
                and B"
            .to_owned();
    }
    format!("it has no channels R, G and B, nor Y; it has {}", channels.join(", "))
}
