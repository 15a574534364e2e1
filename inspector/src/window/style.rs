//! The look of the window.

use eframe::egui::{Color32, Context, Stroke, Style, Theme, style::ScrollStyle};
use serde::{Deserialize, Serialize};

/// The ground of panels and text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
pub enum Ground {
    /// Dark, for judging colours.
    #[default]
    Dark,
    /// Light, for projectors.
    Light,
}

impl Ground {
    /// Makes it the present one.
    pub fn set(self, ctx: &Context) {
        ctx.set_theme(if self == Self::Light { Theme::Light } else { Theme::Dark });
    }

    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        if self == Self::Light { Self::Dark } else { Self::Light }
    }
}

/// The size of a window in which text has its usual size, in points of the screen.
const USUAL: [f32; 2] = [1400.0, 900.0];
/// The largest factor of the text in a larger window.
const LARGEST: f32 = 2.0;

/// Sets text with contrast to its ground, which is dark at first, and scroll bars beside their content, not over it.
pub fn set_style(ctx: &Context) {
    Ground::default().set(ctx);
    ctx.all_styles_mut(set_spacing);
    ctx.style_mut_of(Theme::Dark, |style| {
        let widgets = &mut style.visuals.widgets;
        widgets.noninteractive.fg_stroke.color = Color32::from_gray(215);
        widgets.inactive.fg_stroke.color = Color32::from_gray(225);
        // lines between parts that can be resized
        widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_gray(85));
        style.visuals.weak_text_color = Some(Color32::from_gray(165));
        style.visuals.selection.bg_fill = Color32::from_rgb(0, 52, 78);
        style.visuals.error_fg_color = Color32::from_rgb(255, 120, 110);
    });
    ctx.style_mut_of(Theme::Light, |style| {
        let widgets = &mut style.visuals.widgets;
        widgets.noninteractive.fg_stroke.color = Color32::from_gray(30);
        widgets.inactive.fg_stroke.color = Color32::from_gray(20);
        style.visuals.weak_text_color = Some(Color32::from_gray(85));
        style.visuals.error_fg_color = Color32::from_rgb(180, 20, 10);
        style.visuals.warn_fg_color = Color32::from_rgb(140, 65, 0);
        style.visuals.hyperlink_color = Color32::from_rgb(0, 90, 170);
        style.visuals.selection.bg_fill = Color32::from_rgb(200, 228, 255);
    });
}

fn set_spacing(style: &mut Style) {
    style.spacing.slider_width = 70.0;
    let narrow = ScrollStyle { bar_width: 7.0, bar_inner_margin: 2.0, ..ScrollStyle::thin() };
    style.spacing.scroll = ScrollStyle { floating: false, ..narrow };
}

/// The factor by which text grows in a window of this size, in points of the screen: the square root of how much larger
/// it is than the usual one, so that more can be seen, too.
pub fn growth([width, height]: [f32; 2]) -> f32 {
    let larger = (width / USUAL[0]).min(height / USUAL[1]);
    larger.sqrt().clamp(1.0, LARGEST)
}

/// Makes the text grow and shrink with the window, beside what the user does with Ctrl-+ and Ctrl-−. `grown` is the
/// factor of the last frame.
pub fn grow(ctx: &Context, grown: &mut f32) {
    let size = ctx.input(|input| input.viewport().inner_rect.map(|rect| rect.size()));
    let Some(size) = size else { return };
    // in points as they would be without any factor
    let factor = growth((ctx.zoom_factor() * size).into());
    // not for a change that nobody sees, which would move the text while the window is dragged
    if (factor / *grown - 1.0).abs() > 0.04 {
        ctx.set_zoom_factor(ctx.zoom_factor() * factor / *grown);
        *grown = factor;
    }
}
