//! Values as text in large pixels, and the legend of a layer.

use eframe::egui::{
    Align, Align2, Color32, FontId, Frame, Label, Layout, Painter, Rect, RichText, Sense,
    TextStyle, Ui, UiBuilder, vec2,
};
use groundtruth::rgb::Rgb;
use layers::{Layer, LegendRow};
use text::brief::brief;

use crate::picture::chosen_layer::ChosenLayer;
use crate::picture::view::Placement;
use crate::picture::worker::Rendering;

/// The least size of a pixel on the screen with which its value is written in it.
const MIN_SCALE: f32 = 64.0;
/// The largest width of the legend.
const LEGEND_WIDTH: f32 = 190.0;
/// Around its lines, and between them.
const MARGIN: f32 = 4.0;
const SPACING: f32 = 2.0;

/// Writes the values of the pixels that are on the screen into them, if they are large enough: those of the layer that
/// is shown, or red, green and blue of the picture.
pub fn write(
    painter: &Painter,
    placement: &Placement,
    rendering: &Rendering,
    layer: &ChosenLayer,
    color: impl Fn(Rgb) -> [u8; 3],
) {
    if placement.scale < MIN_SCALE {
        return;
    }
    let visible = painter.clip_rect();
    let [width, height] = placement.size;
    let first = ((visible.min - placement.corner) / placement.scale).floor();
    let last = ((visible.max - placement.corner) / placement.scale).floor();
    let along = |first: f32, last: f32, end: u32| {
        first.max(0.0) as u32..(last.max(-1.0) + 1.0).min(end as f32) as u32
    };
    let font = FontId::monospace((placement.scale / 7.0).min(14.0));
    for y in along(first.y, last.y, height) {
        for x in along(first.x, last.x, width) {
            let found = match &layer.chosen {
                None => rendering.radiance([x, y]).map(|it| (numbers(it, 3), color(it))),
                Some(of) => layer
                    .value([x, y])
                    .and_then(|value| Some((lines(of, value, rendering), layer.color(value)?))),
            };
            if let Some((text, ground)) = found {
                let at = placement.rect([x, y]).center();
                painter.text(at, Align2::CENTER_CENTER, text, font.clone(), contrasting(ground));
            }
        }
    }
}

/// A number on each line.
fn numbers(value: Rgb, count: usize) -> String {
    value.to_array()[..count].iter().map(|it| brief(*it)).collect::<Vec<_>>().join("\n")
}

/// The value of a layer, a channel on each line.
fn lines(layer: &Layer, value: Option<Rgb>, rendering: &Rendering) -> String {
    match value {
        None => String::new(),
        Some(value) if layer.names(&rendering.world).is_some() => {
            layer.in_words(value, &rendering.world)
        }
        Some(value) => numbers(value, layer.kind().channels.len()),
    }
}

/// Black on light colours, white on dark ones.
fn contrasting([r, g, b]: [u8; 3]) -> Color32 {
    let luma = 0.299 * f32::from(r) + 0.587 * f32::from(g) + 0.114 * f32::from(b);
    if luma > 140.0 { Color32::BLACK } else { Color32::WHITE }
}

/// Shows the legend of the layer in the lower left corner of an area: its name, and what has which colour.
pub fn legend(ui: &mut Ui, area: Rect, layer: &ChosenLayer) {
    let Some((of, rows)) = layer.legend() else { return };
    let line = ui.text_style_height(&TextStyle::Body) + SPACING;
    let height = line * (rows.len() + 1) as f32 - SPACING + 2.0 * MARGIN;
    let corner = area.left_bottom() + vec2(8.0, -8.0 - height);
    let place = Rect::from_min_size(corner, vec2(LEGEND_WIDTH, height)).intersect(area);
    let builder = UiBuilder::new().max_rect(place).layout(Layout::top_down(Align::Min));
    ui.scope_builder(builder, |ui| {
        ui.set_clip_rect(place.intersect(ui.clip_rect()));
        ui.visuals_mut().override_text_color = Some(Color32::from_gray(230));
        let frame = Frame::new().fill(Color32::from_black_alpha(190)).inner_margin(MARGIN);
        frame.show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(6.0, SPACING);
            ui.spacing_mut().interact_size.y = 0.0;
            let title = RichText::new(of.to_string()).strong();
            ui.add(Label::new(title).truncate().selectable(false));
            rows.iter().for_each(|row| legend_row(ui, row));
        });
    });
}

fn legend_row(ui: &mut Ui, LegendRow { color: [r, g, b], text }: &LegendRow) {
    ui.horizontal(|ui| {
        let side = ui.text_style_height(&TextStyle::Body) - 2.0;
        let (patch, _) = ui.allocate_exact_size(vec2(1.6 * side, side), Sense::empty());
        ui.painter().rect_filled(patch, 0.0, Color32::from_rgb(*r, *g, *b));
        ui.add(Label::new(text).truncate().selectable(false));
    });
}
