//! Draws the window without a graphics card: triangles, their textures, and blending.

use std::collections::HashMap;

use eframe::egui::epaint::{ImageData, ImageDelta, Primitive, Vertex};
use eframe::egui::{
    Color32, ColorImage, Context, FullOutput, Pos2, TextureFilter, TextureId, TexturesDelta,
};
use egui_kittest::TestRenderer;
use image::{Rgba, RgbaImage};

/// An image, and whether it is enlarged without interpolation.
struct Texture {
    image: ColorImage,
    sharp: bool,
}

#[derive(Default)]
pub struct Software {
    textures: HashMap<TextureId, Texture>,
}

impl Software {
    fn change(&mut self, id: TextureId, change: ImageDelta) {
        let ImageData::Color(new) = change.image;
        let Some([x, y]) = change.pos else {
            let sharp = change.options.magnification == TextureFilter::Nearest;
            self.textures.insert(id, Texture { image: (*new).clone(), sharp });
            return;
        };
        let texture = &mut self.textures.get_mut(&id).expect("made before it changes").image;
        for row in 0..new.size[1] {
            let at = (y + row) * texture.size[0] + x;
            let line = &new.pixels[row * new.size[0]..][..new.size[0]];
            texture.pixels[at..at + new.size[0]].copy_from_slice(line);
        }
    }
}

impl TestRenderer for Software {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for (id, changes) in delta.set.drain() {
            changes.into_iter().for_each(|change| self.change(id, change));
        }
        delta.free.drain().for_each(|id| drop(self.textures.remove(&id)));
    }

    fn render(&mut self, ctx: &Context, output: &FullOutput) -> Result<RgbaImage, String> {
        let scale = output.pixels_per_point;
        let size = scale * ctx.content_rect().size();
        let mut picture =
            RgbaImage::from_pixel(size.x as u32, size.y as u32, Rgba([12, 12, 12, 255]));
        for clipped in ctx.tessellate(output.shapes.clone(), scale) {
            let Primitive::Mesh(mesh) = clipped.primitive else {
                return Err("paint callbacks are not drawn".to_owned());
            };
            let texture = self.textures.get(&mesh.texture_id).ok_or("no such texture")?;
            let clip = [clipped.clip_rect.min, clipped.clip_rect.max].map(|p| scale * p.to_vec2());
            for corners in mesh.indices.chunks_exact(3) {
                let corners = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
                triangle(&mut picture, texture, corners, scale, clip.map(|p| p.to_pos2()));
            }
        }
        Ok(picture)
    }
}

/// Twice the signed area of a triangle.
fn area(a: Pos2, b: Pos2, c: Pos2) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

fn triangle(
    picture: &mut RgbaImage,
    texture: &Texture,
    corners: [Vertex; 3],
    scale: f32,
    [clip_min, clip_max]: [Pos2; 2],
) {
    let [a, b, c] = corners.map(|vertex| (scale * vertex.pos.to_vec2()).to_pos2());
    let whole = area(a, b, c);
    if whole == 0.0 {
        return;
    }
    let source = |weights: [f32; 3]| -> [f32; 4] {
        let mix = |of: &dyn Fn(&Vertex) -> f32| -> f32 {
            (0..3).map(|i| weights[i] * of(&corners[i])).sum()
        };
        let texel = sample(texture, mix(&|v| v.uv.x), mix(&|v| v.uv.y));
        std::array::from_fn(|i| texel[i] * mix(&|v| v.color.to_array()[i].into()) / 255.0)
    };
    // most triangles have one colour: it is found once
    let is_plain = corners.iter().all(|v| (v.uv, v.color) == (corners[0].uv, corners[0].color));
    let plain = is_plain.then(|| source([1.0, 0.0, 0.0]));
    let low = a.min(b).min(c).max(clip_min).max(Pos2::ZERO);
    let high = a.max(b).max(c).min(clip_max);
    let (right, bottom) = (high.x.ceil() as u32, high.y.ceil() as u32);
    for y in low.y.floor() as u32..bottom.min(picture.height()) {
        for x in low.x.floor() as u32..right.min(picture.width()) {
            let p = Pos2::new(x as f32 + 0.5, y as f32 + 0.5);
            let weights = [area(b, c, p), area(c, a, p), area(a, b, p)].map(|part| part / whole);
            let clipped =
                p.x < clip_min.x || p.y < clip_min.y || p.x >= clip_max.x || p.y >= clip_max.y;
            if clipped || weights.iter().any(|&weight| weight < 0.0) {
                continue;
            }
            let source = plain.unwrap_or_else(|| source(weights));
            let target = picture.get_pixel_mut(x, y);
            for i in 0..4 {
                // premultiplied alpha
                let under = f32::from(target.0[i]) * (1.0 - source[3] / 255.0);
                target.0[i] = (source[i] + under).round() as u8;
            }
        }
    }
}

fn sample(Texture { image: texture, sharp }: &Texture, u: f32, v: f32) -> [f32; 4] {
    let neighbours = |t: f32, size: usize| {
        let at = (t * size as f32 - 0.5).clamp(0.0, (size - 1) as f32);
        let at = if *sharp { at.round() } else { at };
        (at as usize, (at as usize + 1).min(size - 1), at.fract())
    };
    let (x0, x1, fx) = neighbours(u, texture.size[0]);
    let (y0, y1, fy) = neighbours(v, texture.size[1]);
    let at = |x: usize, y: usize| -> Color32 { texture.pixels[y * texture.size[0] + x] };
    let mix = |a: f32, b: f32, t: f32| a + t * (b - a);
    std::array::from_fn(|i| {
        let channel = |x, y| f32::from(at(x, y).to_array()[i]);
        let top = mix(channel(x0, y0), channel(x1, y0), fx);
        mix(top, mix(channel(x0, y1), channel(x1, y1), fx), fy)
    })
}
