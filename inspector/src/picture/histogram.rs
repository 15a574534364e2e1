//! The histogram of the picture: how many pixels have which radiance, in stops.

use eframe::egui::{Align2, CollapsingHeader, FontId, Rect, Sense, Ui, pos2, vec2};
use groundtruth::film::Film;

use crate::picture::worker::Rendering;

/// The least and the greatest stop; what is beyond is counted in the outermost.
const STOPS: [i32; 2] = [-12, 8];
/// The number of stops.
const COUNT: usize = (STOPS[1] - STOPS[0]) as usize;
/// The height of the bars, in points of the screen.
const HEIGHT: f32 = 60.0;

/// The pixels of a picture by their radiance, averaged over the channels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    /// The pixels of each stop: the first is from 2⁻¹² to 2⁻¹¹.
    pub stops: [u64; COUNT],
    /// The pixels that are black, negative or no number.
    pub black: u64,
}

impl Counts {
    /// Counts the pixels of a film.
    pub fn of(film: &Film) -> Self {
        let mut counts = Self { stops: [0; COUNT], black: 0 };
        for value in film.pixels().iter().map(|pixel| pixel.average()) {
            if value > 0.0 {
                // the exponent of a number is the floor of its logarithm
                let exponent = (value.to_bits() >> 52) as i32 - 1023;
                let stop = exponent.clamp(STOPS[0], STOPS[1] - 1);
                counts.stops[(stop - STOPS[0]) as usize] += 1;
            } else {
                counts.black += 1;
            }
        }
        counts
    }
}

/// The histogram of the picture that was finished last.
#[derive(Default)]
pub struct Histogram {
    counted: Option<(u64, Counts)>,
}

impl Histogram {
    /// Shows it, folded at first; it is counted when it is unfolded and the picture is finished.
    pub fn show(&mut self, ui: &mut Ui, rendering: &Rendering) {
        CollapsingHeader::new("Histogram").show(ui, |ui| {
            if !rendering.is_finished() {
                ui.weak("when the picture is finished");
                return;
            }
            if self.counted.as_ref().is_none_or(|(of, _)| *of != rendering.generation) {
                self.counted = Some((rendering.generation, rendering.canvas.look(Counts::of)));
            }
            if let Some((_, counts)) = &self.counted {
                bars(ui, counts);
                ui.weak(format!("stops (log₂ of the radiance); {} black", counts.black));
            }
        });
    }
}

/// Draws a bar for each stop.
fn bars(ui: &mut Ui, counts: &Counts) {
    let width = (ui.clip_rect().right() - ui.cursor().left() - 8.0).max(80.0);
    let (area, response) = ui.allocate_exact_size(vec2(width, HEIGHT + 14.0), Sense::hover());
    let (painter, visuals) = (ui.painter(), ui.visuals());
    let base = area.top() + HEIGHT;
    painter.rect_filled(area.with_max_y(base), 2.0, visuals.extreme_bg_color);
    let most = counts.stops.iter().copied().max().unwrap_or(0).max(1);
    let step = width / COUNT as f32;
    for (index, &count) in counts.stops.iter().enumerate() {
        let left = area.left() + step * index as f32;
        let top = base - HEIGHT * (count as f64 / most as f64) as f32;
        let bar = Rect::from_min_max(pos2(left, top), pos2(left + step - 1.0, base));
        painter.rect_filled(bar, 0.0, visuals.text_color());
        let stop = STOPS[0] + index as i32;
        if stop % 4 == 0 {
            let font = FontId::proportional(10.0);
            painter.text(pos2(left, base), Align2::CENTER_TOP, stop, font, visuals.text_color());
        }
    }
    if let Some(at) = response.hover_pos() {
        let index = (((at.x - area.left()) / step) as usize).min(COUNT - 1);
        let stop = STOPS[0] + index as i32;
        let text = format!("2^{stop} to 2^{}: {} pixels", stop + 1, counts.stops[index]);
        response.on_hover_text(text);
    }
}
