//! What *Save* writes, and the name that is proposed for it.

use layers::Layer;

use crate::comparison::theirs::Theirs;
use crate::picture::chosen_layer::named;
use crate::picture::display::Picture;
use crate::picture::saving::Content;
use crate::picture::worker::Rendering;

/// The file name that is proposed for what is shown: the layer of the comparison, if one is, or that of the picture.
pub fn proposed_name(
    (picture, theirs): (&Picture, Option<&Theirs>),
    rendering: &Rendering,
) -> String {
    let theirs = theirs.filter(|theirs| theirs.fits(rendering));
    let beside = theirs.and_then(|theirs| named(theirs.shows)).map(str::to_owned);
    let layer = beside.or_else(|| picture.layer.chosen.as_ref().map(Layer::to_string));
    rendering.source.picture_name(layer.as_deref())
}

/// What is saved: the layer that is shown, or the picture.
///
/// # Errors
/// The layer is not finished.
pub fn content(
    picture: &Picture,
    theirs: Option<&Theirs>,
    rendering: &Rendering,
) -> Result<Content, String> {
    if let Some(beside) = theirs.and_then(|theirs| theirs.layer(rendering)) {
        let late = "the layer can be saved once it is finished".to_owned();
        return beside.ok_or(late);
    }
    match picture.layer.film() {
        None => Ok(Content::Picture),
        Some((layer, Some(film))) => Ok(Content::Layer(layer, film)),
        Some((layer, None)) => Err(format!("{layer} can be saved once it is finished")),
    }
}
