//! The picture on the screen: its textures, the pixel grid, and the mouse.

use std::sync::Arc;

use eframe::egui::{
    self, Align2, Color32, CursorIcon, FontId, Id, Key, Modifiers, Painter, Rect, Sense, Shape,
    Stroke, StrokeKind, Ui, Visuals, WidgetInfo, accesskit::Role,
};
use groundtruth::film::Tone;
use groundtruth::rgb::Rgb;

use crate::picture::chosen_layer::ChosenLayer;
use crate::picture::developed::{self, Developed, Version};
use crate::picture::tiles::Tiles;
use crate::picture::values;
use crate::picture::view::{self, Placement, View};
use crate::picture::worker::Rendering;

/// The least size of a pixel on the screen with which the grid appears.
const GRID_MIN_SCALE: f32 = 8.0;

/// The picture as shown, with its view.
pub struct Picture {
    /// Zoom and pan.
    pub view: View,
    /// The tone in which radiance is shown.
    pub tone: Tone,
    /// The layer that is shown in its place.
    pub layer: ChosenLayer,
    /// It, by the number of its rendering.
    developed: Developed<u64>,
    /// The previous picture, shown darker where the new one is not rendered yet.
    previous_tiles: Tiles,
    /// The area in which the picture was last drawn.
    area: Rect,
    /// The id of the widget, once it was drawn.
    id: Option<Id>,
}

/// The version of a picture as far as it is rendered.
fn version(rendering: &Rendering, tone: Tone) -> Version<u64> {
    // in this order: a picture that is finished now is completely in the film
    let is_finished = rendering.is_finished();
    Version { of: rendering.generation, done: rendering.canvas.seen(), is_finished, tone }
}

/// The colour of what is as it should be.
pub const AGREES: Color32 = Color32::from_rgb(120, 220, 120);

/// A colour of text and lines with contrast to the ground of the theme.
pub fn ink(visuals: &Visuals, color: Color32) -> Color32 {
    if visuals.dark_mode { color } else { color.lerp_to_gamma(Color32::BLACK, 0.65) }
}

/// The colour around lines and text of [`ink`] that are drawn over a picture.
pub fn halo(visuals: &Visuals) -> Color32 {
    if visuals.dark_mode { Color32::BLACK } else { Color32::WHITE }
}

/// The neutral ground of pictures, plots and the space view.
pub fn ground(visuals: &Visuals) -> Color32 {
    Color32::from_gray(if visuals.dark_mode { 24 } else { 225 })
}

/// Writes a text over a picture, into a corner of an area or at the middle of a side.
pub fn write(painter: &Painter, area: Rect, corner: Align2, text: String) {
    let inner = area.shrink(6.0);
    let (font, color) = (FontId::proportional(12.5), Color32::from_gray(230));
    let galley = painter.layout(text, font, color, inner.width());
    let place = corner.anchor_size(corner.pos_in_rect(&inner), galley.size());
    painter.rect_filled(place.expand(3.0), 3.0, Color32::from_black_alpha(180));
    painter.galley(place.min, galley, color);
}

/// A colour of the screen.
pub fn color(tone: &Tone, radiance: Rgb) -> Color32 {
    let [r, g, b] = tone.to_bytes(radiance);
    Color32::from_rgb(r, g, b)
}

impl Picture {
    /// A picture without pixels yet.
    pub fn new(tone: Tone) -> Self {
        Self {
            view: View::WHOLE,
            tone,
            layer: ChosenLayer::default(),
            developed: Developed::default(),
            previous_tiles: Tiles::default(),
            area: Rect::ZERO,
            id: None,
        }
    }

    /// Updates the textures with the tiles that are ready.
    pub fn refresh(&mut self, ctx: &egui::Context, rendering: &Rendering) {
        self.layer.refresh(ctx, rendering, self.tone);
        let (canvas, tone) = (Arc::clone(&rendering.canvas), self.tone);
        let develop =
            move || ((), developed::so_far(&canvas, |radiance| developed::bytes(&tone, radiance)));
        self.developed.refresh(ctx, version(rendering, tone), develop);
        if self.developed.is_whole() {
            self.previous_tiles = Tiles::default();
        }
    }

    /// Whether the screen shows this picture as far as it is rendered.
    pub fn is_fresh(&self, rendering: &Rendering) -> bool {
        let is_shown = self.developed.version() == Some(&version(rendering, self.tone));
        is_shown && self.layer.is_fresh(rendering)
    }

    /// Keeps the last picture beneath a new one of the same size.
    pub fn restart(&mut self) {
        let last = std::mem::take(&mut self.developed);
        if self.previous_tiles.is_empty() || last.is_whole() {
            self.previous_tiles = last.tiles;
        }
    }

    /// Zooms to this many points for a pixel; the selected one stays in view.
    pub fn set_zoom(&mut self, size: [u32; 2], zoom: f32, selected: Option<[u32; 2]>) {
        self.view.set_zoom(self.area, size, zoom, selected);
    }

    /// Whether the picture gets the keys: no other widget has the focus.
    pub fn has_keys(&self, ctx: &egui::Context) -> bool {
        ctx.memory(|memory| memory.focused()).is_none_or(|focused| Some(focused) == self.id)
    }

    /// The place of the picture on the screen.
    pub fn placement(&self, size: [u32; 2]) -> Placement {
        self.view.place(self.area, size)
    }

    /// Moves the picture if the pixel is not visible.
    pub fn reveal(&mut self, size: [u32; 2], pixel: [u32; 2]) {
        self.view.reveal(self.area, size, pixel);
    }

    /// The pixel that is clicked in this frame, known before the picture is drawn.
    pub fn clicked(&self, ctx: &egui::Context, size: [u32; 2]) -> Option<[u32; 2]> {
        let response = ctx.read_response(self.id?)?;
        let at = if response.clicked() { response.interact_pointer_pos() } else { None };
        self.placement(size).pixel(at?)
    }

    /// Draws the picture or the layer, with what `over` draws on its pixels, and handles the mouse. Returns the pixel
    /// under the mouse.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        rendering: &Rendering,
        selected: Option<[u32; 2]>,
        over: impl FnOnce(&Painter, &Placement),
    ) -> Option<[u32; 2]> {
        let (response, painter) = ui.allocate_painter(ui.available_size(), Sense::click_and_drag());
        let size = rendering.size();
        (self.area, self.id) = (response.rect, Some(response.id));
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "picture"));
        let pointer = response.hover_pos();
        if let Some(at) = pointer {
            let factor = view::zoomed(ui, 0.005);
            if factor != 1.0 {
                self.view.zoom_at(self.area, size, at, factor);
            }
        }
        if response.dragged() {
            self.view.pan(self.area, size, response.drag_delta());
        }
        let placement = self.placement(size);
        let hovered = pointer.and_then(|at| placement.pixel(at));
        let cursor = match (response.dragged(), hovered) {
            (true, _) => CursorIcon::Grabbing,
            (false, Some(_)) => CursorIcon::Crosshair,
            (false, None) => CursorIcon::Default,
        };
        let response = response.on_hover_cursor(cursor);
        if response.clicked() || response.dragged() {
            response.request_focus();
        }
        view::keep_arrows(ui, response.id);
        self.paint(&painter, (&placement, rendering, ui.visuals()), selected, over);
        values::legend(ui, self.area, &self.layer);
        hovered
    }

    fn paint(
        &self,
        painter: &Painter,
        (placement, rendering, visuals): (&Placement, &Rendering, &Visuals),
        selected: Option<[u32; 2]>,
        over: impl FnOnce(&Painter, &Placement),
    ) {
        let whole = placement.whole();
        painter.rect_filled(painter.clip_rect(), 0.0, ground(visuals));
        painter.rect_filled(whole, 0.0, Color32::BLACK);
        let is_layer = self.layer.chosen.is_some();
        if !is_layer {
            self.previous_tiles.paint(painter, placement, Color32::from_gray(90));
        }
        if !(if is_layer { self.layer.is_complete() } else { self.developed.is_whole() }) {
            hatch(&painter.with_clip_rect(painter.clip_rect().intersect(whole)));
        }
        if is_layer {
            self.layer.paint(painter, placement);
        } else {
            self.developed.paint(painter, placement);
        }
        let tone = |radiance| self.tone.to_bytes(radiance);
        values::write(painter, placement, rendering, &self.layer, tone);
        over(painter, placement);
        if placement.scale >= GRID_MIN_SCALE {
            grid(painter, placement);
        }
        let edge = Stroke::new(1.0, ground(visuals).lerp_to_gamma(Color32::from_gray(128), 0.5));
        painter.rect_stroke(whole, 0.0, edge, StrokeKind::Outside);
        if let Some(pixel) = selected {
            mark(painter, placement.rect(pixel), SELECTED);
        }
    }
}

/// The least scale at which coordinates are written.
const COORDINATES_MIN_SCALE: f32 = 12.0;
/// The least distance between coordinates at an edge, in points of the screen.
const COORDINATES: f32 = 36.0;

/// Writes columns and rows at the upper and the left edge, if pixels are large.
pub fn coordinates(painter: &Painter, placement: &Placement) {
    if placement.scale < COORDINATES_MIN_SCALE {
        return;
    }
    let area = painter.clip_rect();
    let visible = area.intersect(placement.whole());
    let step = (COORDINATES / placement.scale).ceil() as usize;
    for (axis, range) in [visible.x_range(), visible.y_range()].into_iter().enumerate() {
        for index in (0..placement.size[axis]).step_by(step) {
            let mut at = placement.rect([index; 2]).center();
            if !range.shrink(6.0).contains(at[axis]) {
                continue;
            }
            at[1 - axis] = area.min[1 - axis] + [12.0, 8.0][1 - axis];
            let ground = Rect::from_center_size(at, [22.0, 14.0].into());
            painter.rect_filled(ground, 2.0, Color32::from_black_alpha(170));
            let (font, color) = (FontId::proportional(10.5), Color32::from_gray(225));
            painter.text(at, Align2::CENTER_CENTER, index, font, color);
        }
    }
}

/// Hatches the visible area, to mark pixels that are not rendered yet.
pub fn hatch(painter: &Painter) {
    const STEP: f32 = 7.0;
    let visible = painter.clip_rect();
    let stroke = Stroke::new(1.0, Color32::from_gray(85));
    let lines = ((visible.width() + visible.height()) / STEP).max(0.0) as u32;
    for line in 1..=lines {
        let from = visible.left_top() + egui::vec2(line as f32 * STEP, 0.0);
        painter.line_segment([from, from + visible.height() * egui::vec2(-1.0, 1.0)], stroke);
    }
}

/// Draws lines between the pixels that are on the screen.
fn grid(painter: &Painter, placement: &Placement) {
    let visible = painter.clip_rect().intersect(placement.whole());
    let stroke = Stroke::new(1.0, Color32::from_rgba_unmultiplied(128, 128, 128, 110));
    let lines = |from: f32, to: f32, start: f32| {
        let (first, last) = ((from - start) / placement.scale, (to - start) / placement.scale);
        let scale = placement.scale;
        (first.ceil() as i64..=last.floor() as i64).map(move |line| start + line as f32 * scale)
    };
    for x in lines(visible.left(), visible.right(), placement.corner.x) {
        painter.vline(x, visible.y_range(), stroke);
    }
    for y in lines(visible.top(), visible.bottom(), placement.corner.y) {
        painter.hline(visible.x_range(), y, stroke);
    }
}

/// The colour of the frame around the selected pixel.
const SELECTED: Color32 = Color32::from_rgb(255, 230, 60);
/// The colour of the frame around the pinned pixel.
pub const PINNED: Color32 = Color32::from_rgb(120, 220, 255);

/// Draws a frame around a pixel, and four strokes that lead to it.
pub fn mark(painter: &Painter, pixel: Rect, color: Color32) {
    let frame = pixel.expand((3.0 - 0.5 * pixel.width()).max(1.0));
    for (stroke, color) in [(4.0, Color32::BLACK), (2.0, color)] {
        let stroke = Stroke::new(stroke, color);
        painter.rect_stroke(frame, 0.0, stroke, StrokeKind::Outside);
        for (inner, outward) in [
            (frame.left_center(), egui::vec2(-1.0, 0.0)),
            (frame.right_center(), egui::vec2(1.0, 0.0)),
            (frame.center_top(), egui::vec2(0.0, -1.0)),
            (frame.center_bottom(), egui::vec2(0.0, 1.0)),
        ] {
            painter
                .add(Shape::line_segment([inner + 3.0 * outward, inner + 10.0 * outward], stroke));
        }
    }
}

/// The pixel of a picture of this size to which the arrow keys lead from another; with shift, ten pixels away.
pub fn stepped(ui: &Ui, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> Option<[u32; 2]> {
    let [dx, dy] = ui.input(|input| {
        let length = match input.modifiers {
            // these go back and forward
            Modifiers { alt: true, .. } => 0,
            Modifiers { shift: true, .. } => 10,
            _ => 1,
        };
        let pressed = |key| input.num_presses(key) as i64;
        let x = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
        let y = pressed(Key::ArrowDown) - pressed(Key::ArrowUp);
        [length * x, length * y]
    });
    let moved = |at: u32, by: i64, end: u32| (i64::from(at) + by).clamp(0, i64::from(end) - 1);
    ([dx, dy] != [0, 0]).then(|| [moved(x, dx, width) as u32, moved(y, dy, height) as u32])
}
