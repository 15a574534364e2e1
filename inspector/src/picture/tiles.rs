//! A picture as textures: squares, because graphics cards refuse large textures.

use eframe::egui::{
    Color32, ColorImage, Context, Painter, Rect, TextureFilter, TextureHandle, TextureOptions, pos2,
};

use crate::picture::view::Placement;

/// The side of a square.
const SIDE: u32 = 1024;

/// Squares of a picture, each with its top left pixel.
pub type Images = Vec<([u32; 2], ColorImage)>;

/// The squares of a picture of this size; `colors` gives those of the pixels of one of them, row by row.
pub fn images(
    [width, height]: [u32; 2],
    colors: impl Fn(&mut dyn Iterator<Item = [u32; 2]>) -> Vec<Color32>,
) -> Images {
    let corners = (0..height)
        .step_by(SIDE as usize)
        .flat_map(|y| (0..width).step_by(SIDE as usize).map(move |x| [x, y]));
    let image = |[x, y]: [u32; 2]| {
        let (right, bottom) = ((x + SIDE).min(width), (y + SIDE).min(height));
        let mut positions = (y..bottom).flat_map(|row| (x..right).map(move |column| [column, row]));
        let size = [(right - x) as usize, (bottom - y) as usize];
        ([x, y], ColorImage::new(size, colors(&mut positions)))
    };
    corners.map(image).collect()
}

/// The textures of a picture.
#[derive(Default)]
pub struct Tiles(Vec<([u32; 2], TextureHandle)>);

impl Tiles {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Shows these squares from now on.
    pub fn upload(&mut self, ctx: &Context, images: Images) {
        let same = self.0.len() == images.len()
            && self.0.iter().zip(&images).all(|((_, old), (_, new))| old.size() == new.size);
        let options = TextureOptions {
            magnification: TextureFilter::Nearest,
            minification: TextureFilter::Linear,
            ..TextureOptions::default()
        };
        if same {
            for ((_, texture), (_, image)) in self.0.iter_mut().zip(images) {
                texture.set(image, options);
            }
        } else {
            let load = |(at, image)| (at, ctx.load_texture("picture", image, options));
            self.0 = images.into_iter().map(load).collect();
        }
    }

    /// Draws them where the picture is.
    pub fn paint(&self, painter: &Painter, placement: &Placement, tint: Color32) {
        let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        for (at, texture) in &self.0 {
            let [width, height] = texture.size().map(|side| side as u32);
            let rect = placement.part(*at, [width, height]);
            if rect.intersects(painter.clip_rect()) {
                painter.image(texture.id(), rect, uv, tint);
            }
        }
    }
}
