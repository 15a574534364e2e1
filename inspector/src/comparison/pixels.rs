//! The pixels of a picture that ours is compared with: all of a file's or a log's, or those that a program has rendered so far.

use std::sync::Arc;

use eframe::egui::{Color32, Context, Painter};
use groundtruth::film::{Film, Tone};
use groundtruth::render::Crop;
use groundtruth::rgb::Rgb;
use pictures::compare::Picture;

use crate::picture::developed::{self, Developed, Version};
use crate::picture::display::hatch;
use crate::picture::view::Placement;
use crate::picture::worker::Growing;

/// The pixels.
pub enum Pixels {
    /// All, of a file or a log; of a file with its values as they are stored.
    Whole(Arc<Film>, Option<Arc<Picture>>),
    /// Those that a program has rendered so far.
    Growing(Growing),
}

impl Pixels {
    /// Pixels across and down.
    pub fn size(&self) -> [u32; 2] {
        match self {
            Self::Whole(film, _) => [film.width(), film.height()],
            Self::Growing(growing) => {
                let Crop { width, height, .. } = growing.canvas.crop();
                [width, height]
            }
        }
    }

    /// The radiance of a pixel; `None` outside, and where it is not rendered yet.
    pub fn radiance(&self, pixel @ [x, y]: [u32; 2]) -> Option<Rgb> {
        let [width, height] = self.size();
        if x >= width || y >= height {
            return None;
        }
        match self {
            Self::Whole(film, _) => Some(film.get(pixel)),
            Self::Growing(growing) => growing.canvas.look_partly(|picture| picture.get(pixel)),
        }
    }

    /// The rendered part, from 0 to 1, while a program renders it.
    pub fn part(&self) -> Option<f32> {
        if let Self::Growing(growing) = self { growing.part() } else { None }
    }

    /// What makes a picture as of a file of them, once they are all there.
    pub fn picture(&self) -> Box<dyn FnOnce() -> Arc<Picture> + Send> {
        match self {
            Self::Whole(film, stored) => {
                let (film, stored) = (Arc::clone(film), stored.clone());
                Box::new(move || stored.unwrap_or_else(|| Picture::of_film(&film).into()))
            }
            Self::Growing(growing) => {
                let canvas = Arc::clone(&growing.canvas);
                Box::new(move || Picture::of_film(&canvas.film()).into())
            }
        }
    }

    /// Makes their colours on the screen.
    pub fn develop(&self, ctx: &Context, layer: &mut Developed<()>, tone: Tone) {
        match self {
            Self::Whole(film, _) => {
                let film = Arc::clone(film);
                let shown = move || ((), developed::of_film(&film, &tone));
                layer.refresh(ctx, Version::whole((), tone), shown);
            }
            Self::Growing(growing) => {
                let canvas = Arc::clone(&growing.canvas);
                let color = move |radiance| developed::bytes(&tone, radiance);
                let shown = move || ((), developed::so_far(&canvas, color));
                layer.refresh(ctx, growing.version((), tone), shown);
            }
        }
    }

    /// Draws them as far as they are there; what is hatched is still to come. `false` if nothing is there.
    pub fn paint(&self, painter: &Painter, layer: &Developed<()>, placement: &Placement) -> bool {
        if self.part().is_some() {
            let missing = painter.clip_rect().intersect(placement.whole());
            painter.rect_filled(missing, 0.0, Color32::BLACK);
            hatch(&painter.with_clip_rect(missing));
        }
        layer.paint(painter, placement)
    }
}
