//! A picture on the screen: made on a background thread, and made anew when another version of it is wanted.

use std::time::Duration;

use eframe::egui::{Color32, Context, Painter};
use groundtruth::film::{Film, Tone};
use groundtruth::render::Canvas;
use groundtruth::rgb::Rgb;
use web_time::Instant;

use crate::picture::tiles::{Images, Tiles, images};
use crate::picture::view::Placement;
use crate::picture::worker::Background;

/// The interval at which an unfinished picture is updated.
const REFRESH: Duration = Duration::from_millis(150);
/// The opacity of the coarse picture, through which the hatching shows.
const COARSE_ALPHA: u8 = 215;

/// The version of a picture: which one, how much of it, and in which tone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Version<K> {
    /// Which picture.
    pub of: K,
    /// The number of its values so far, of the coarse picture or its own.
    pub done: u64,
    /// Whether the film is complete; the count of pixels alone does not tell, because it is raised a little
    /// before the last pixels are in the film.
    pub is_finished: bool,
    /// The tone in which radiance is shown.
    pub tone: Tone,
}

impl<K> Version<K> {
    /// That of a whole picture.
    pub fn whole(of: K, tone: Tone) -> Self {
        Self { of, done: 0, is_finished: true, tone }
    }
}

/// The textures of the version that is shown, and what else was found out about it.
pub struct Developed<K, T = ()> {
    /// The textures.
    pub tiles: Tiles,
    /// The version that they show.
    pub shown: Option<(Version<K>, T)>,
    started: Option<Instant>,
    developing: Background<(Version<K>, T, Images)>,
}

impl<K, T> Default for Developed<K, T> {
    fn default() -> Self {
        let developing = Background::default();
        Self { tiles: Tiles::default(), shown: None, started: None, developing }
    }
}

impl<K: Clone + PartialEq + Send + 'static, T: Send + 'static> Developed<K, T> {
    /// Shows what is finished, if it is of the wanted picture; starts to make the wanted version if it is another one, of
    /// an unfinished picture not too often.
    pub fn refresh(
        &mut self,
        ctx: &Context,
        wanted: Version<K>,
        develop: impl FnOnce() -> (T, Images) + Send + 'static,
    ) {
        if let Some(Ok((version, more, images))) = self.developing.poll()
            && version.of == wanted.of
        {
            self.tiles.upload(ctx, images);
            self.shown = Some((version, more));
        }
        let more_of_it = self.version().is_some_and(|shown| {
            !wanted.is_finished && Version { done: wanted.done, ..shown.clone() } == wanted
        });
        let too_soon = more_of_it && self.started.is_some_and(|at| at.elapsed() < REFRESH);
        if self.version() == Some(&wanted) || too_soon || self.developing.is_busy() {
            return;
        }
        self.started = Some(Instant::now());
        self.developing.start(ctx, move || {
            let (more, images) = develop();
            (wanted, more, images)
        });
    }

    /// The version that is shown.
    pub fn version(&self) -> Option<&Version<K>> {
        self.shown.as_ref().map(|(version, _)| version)
    }

    /// Whether all of a picture is shown.
    pub fn is_whole(&self) -> bool {
        self.version().is_some_and(|version| version.is_finished)
    }

    /// Whether a version is being made.
    pub fn is_busy(&self) -> bool {
        self.developing.is_busy()
    }

    /// Draws the version that is shown; `false` if none is.
    pub fn paint(&self, painter: &Painter, placement: &Placement) -> bool {
        self.tiles.paint(painter, placement, Color32::WHITE);
        self.shown.is_some()
    }
}

/// A picture so far, in these colours. Locks it for one tile at a time. Shows the coarse picture, or nothing, for a pixel
/// that is not there yet.
pub fn so_far(canvas: &Canvas, color: impl Fn(Rgb) -> [u8; 3]) -> Images {
    let show = |(value, coarse): (Option<Rgb>, Option<Rgb>)| {
        let alpha = if value.is_some() { u8::MAX } else { COARSE_ALPHA };
        let Some(value) = value.or(coarse) else { return Color32::TRANSPARENT };
        let [r, g, b] = color(value);
        Color32::from_rgba_unmultiplied(r, g, b, alpha)
    };
    let size = canvas.look(|film| [film.width(), film.height()]);
    images(size, |positions| {
        let pixels: Vec<_> = canvas.look_partly(|picture| {
            positions.map(|at| (picture.get(at), picture.coarse(at))).collect()
        });
        pixels.into_iter().map(show).collect()
    })
}

/// Radiance in the colours of the screen; what is not a number is magenta.
pub fn bytes(tone: &Tone, radiance: Rgb) -> [u8; 3] {
    let is_number = radiance.to_array().iter().all(|channel| !channel.is_nan());
    if is_number { tone.to_bytes(radiance) } else { [255, 0, 255] }
}

/// A film in the colours of the screen.
pub fn of_film(film: &Film, tone: &Tone) -> Images {
    let color = |at| {
        let [r, g, b] = bytes(tone, film.get(at));
        Color32::from_rgb(r, g, b)
    };
    images([film.width(), film.height()], |positions| positions.map(color).collect())
}
