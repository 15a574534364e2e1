//! The view: zoom and pan, which map the pixels of a picture to the screen.

use eframe::egui::{EventFilter, Id, Pos2, Rect, Ui, Vec2, pos2, vec2};

/// The least and the largest zoom, in points of the screen for a pixel.
const ZOOM: std::ops::RangeInclusive<f32> = 0.02..=160.0;

/// The factor by which wheel and pinch ask to zoom, `speed` for a point of the wheel.
pub fn zoomed(ui: &Ui, speed: f32) -> f32 {
    ui.input(|input| (input.smooth_scroll_delta.y * speed).exp() * input.zoom_delta())
}

/// Lets a widget have the arrow keys, which else move the focus.
pub fn keep_arrows(ui: &Ui, id: Id) {
    let keys = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, keys));
}

/// The zoom and pan that the user chose.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Points of the screen for a pixel; the whole picture if `None`.
    zoom: Option<f32>,
    /// The point of the picture at the centre of the area, in pixels.
    center: Vec2,
}

/// The place of the picture on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Points of the screen for a pixel.
    pub scale: f32,
    /// Its top left corner on the screen.
    pub corner: Pos2,
    /// Pixels across and down.
    pub size: [u32; 2],
}

impl View {
    /// The whole picture.
    pub const WHOLE: Self = Self { zoom: None, center: Vec2::ZERO };

    /// The picture in its area of the screen.
    pub fn place(&self, area: Rect, size: [u32; 2]) -> Placement {
        let whole = extent(size);
        let (scale, center) = match self.zoom {
            Some(zoom) => (zoom, self.center),
            None => (scale_to_fit(area, whole), 0.5 * whole),
        };
        let corner = area.center() - scale * center;
        Placement { scale, corner: corner.round(), size }
    }

    /// Shows each pixel at this many points of the screen. The selected pixel stays where it is, in view; without one the
    /// centre does.
    pub fn set_zoom(&mut self, area: Rect, size: [u32; 2], zoom: f32, pixel: Option<[u32; 2]>) {
        let placement = self.place(area, size);
        let selected = pixel.map(|pixel| placement.rect(pixel).center());
        let at = selected.filter(|at| area.contains(*at)).unwrap_or(area.center());
        self.zoom_at(area, size, at, zoom / placement.scale);
        pixel.into_iter().for_each(|pixel| self.reveal(area, size, pixel));
    }

    /// Zooms so that the point of the picture at `at` stays there.
    pub fn zoom_at(&mut self, area: Rect, size: [u32; 2], at: Pos2, factor: f32) {
        let placement = self.place(area, size);
        let zoom = (placement.scale * factor).clamp(*ZOOM.start(), *ZOOM.end());
        let under = (at - placement.corner) / placement.scale;
        self.center = under + (area.center() - at) / zoom;
        self.zoom = Some(zoom);
        self.keep_inside(size);
    }

    /// Moves the picture by this much of the screen.
    pub fn pan(&mut self, area: Rect, size: [u32; 2], by: Vec2) {
        let placement = self.place(area, size);
        self.center = (area.center() - placement.corner - by) / placement.scale;
        self.zoom = Some(placement.scale);
        self.keep_inside(size);
    }

    /// Moves the picture as little as needed to make a pixel visible.
    pub fn reveal(&mut self, area: Rect, size: [u32; 2], pixel: [u32; 2]) {
        let placement = self.place(area, size);
        let (visible, wanted) = (area.shrink(4.0), placement.rect(pixel));
        if self.zoom.is_none() || visible.contains_rect(wanted) {
            return;
        }
        let last = (visible.max - wanted.size()).max(visible.min);
        self.pan(area, size, wanted.min.clamp(visible.min, last) - wanted.min);
    }

    /// Keeps some of the picture at the centre of the area.
    fn keep_inside(&mut self, size: [u32; 2]) {
        self.center = self.center.clamp(Vec2::ZERO, extent(size));
    }
}

/// The largest scale that fits; from 2 on a whole number, so that all pixels have the same size.
fn scale_to_fit(area: Rect, whole: Vec2) -> f32 {
    let scale = (area.width() / whole.x).min(area.height() / whole.y);
    let scale = if scale >= 2.0 { scale.floor() } else { scale };
    scale.clamp(*ZOOM.start() / 4.0, *ZOOM.end())
}

fn extent([width, height]: [u32; 2]) -> Vec2 {
    vec2(width as f32, height as f32)
}

impl Placement {
    /// The pixel at a position on the screen.
    pub fn pixel(&self, at: Pos2) -> Option<[u32; 2]> {
        let inside = (at - self.corner) / self.scale;
        let [width, height] = self.size;
        let whole = inside.x >= 0.0 && inside.y >= 0.0;
        let pixel = [inside.x as u32, inside.y as u32];
        (whole && pixel[0] < width && pixel[1] < height).then_some(pixel)
    }

    /// A pixel on the screen.
    pub fn rect(&self, [x, y]: [u32; 2]) -> Rect {
        self.part([x, y], [1, 1])
    }

    /// A part of the picture on the screen.
    pub fn part(&self, [x, y]: [u32; 2], size: [u32; 2]) -> Rect {
        let at = self.corner + self.scale * extent([x, y]);
        Rect::from_min_size(pos2(at.x, at.y), self.scale * extent(size))
    }

    /// The whole picture on the screen.
    pub fn whole(&self) -> Rect {
        self.part([0, 0], self.size)
    }
}
