//! A picture over ours, made on a background thread and made anew when what it shows changes.

use eframe::egui::{Color32, Context, Painter};
use groundtruth::film::{Film, Tone};

use crate::picture::display;
use crate::picture::tiles::{self, Images, Tiles};
use crate::picture::view::Placement;
use crate::picture::worker::Background;

/// Textures for a version `V` of a picture.
pub struct Layer<V> {
    tiles: Tiles,
    shown: Option<V>,
    making: Background<(V, Images)>,
}

impl<V> Default for Layer<V> {
    fn default() -> Self {
        Self { tiles: Tiles::default(), shown: None, making: Background::default() }
    }
}

impl<V: Copy + PartialEq + Send + 'static> Layer<V> {
    /// Shows what is finished; starts to make the wanted version if it is another one.
    pub fn refresh(
        &mut self,
        ctx: &Context,
        wanted: V,
        make: impl FnOnce() -> Images + Send + 'static,
    ) {
        if let Some(Ok((version, images))) = self.making.poll() {
            self.tiles.upload(ctx, images);
            self.shown = Some(version);
        }
        if self.shown != Some(wanted) && !self.making.is_busy() {
            self.making.start(ctx, move || (wanted, make()));
        }
    }

    /// Whether a version is being made.
    pub fn is_busy(&self) -> bool {
        self.making.is_busy()
    }

    /// Draws the last version if it fits; `false` if none does.
    pub fn paint(
        &self,
        painter: &Painter,
        placement: &Placement,
        fits: impl FnOnce(V) -> bool,
    ) -> bool {
        let is_ready = self.shown.is_some_and(fits);
        if is_ready {
            self.tiles.paint(painter, placement, Color32::WHITE);
        }
        is_ready
    }
}

/// A film in the colours of the screen; what is not a number is magenta.
pub fn shown(film: &Film, tone: &Tone) -> Images {
    let color = |at| {
        let radiance = film.get(at);
        let is_number = radiance.to_array().iter().all(|channel| !channel.is_nan());
        if is_number { display::color(tone, radiance) } else { Color32::from_rgb(255, 0, 255) }
    };
    tiles::images([film.width(), film.height()], |positions| positions.map(color).collect())
}
