//! The look of the window.

use eframe::egui::{Color32, Context, Stroke, Theme, style::ScrollStyle};

/// Sets a dark background for judging colours, text with contrast to it, and scroll bars beside their content,
/// not over it.
pub fn set_style(ctx: &Context) {
    ctx.set_theme(Theme::Dark);
    ctx.style_mut_of(Theme::Dark, |style| {
        let widgets = &mut style.visuals.widgets;
        widgets.noninteractive.fg_stroke.color = Color32::from_gray(215);
        widgets.inactive.fg_stroke.color = Color32::from_gray(225);
        // lines between parts that can be resized
        widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_gray(85));
        style.visuals.weak_text_color = Some(Color32::from_gray(165));
        style.visuals.error_fg_color = Color32::from_rgb(255, 120, 110);
        style.spacing.slider_width = 70.0;
        let narrow = ScrollStyle { bar_width: 7.0, bar_inner_margin: 2.0, ..ScrollStyle::thin() };
        style.spacing.scroll = ScrollStyle { floating: false, ..narrow };
    });
}
