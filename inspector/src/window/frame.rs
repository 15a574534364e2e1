//! The frame of the window: its title, and the size of its text.

use eframe::egui::{Context, ViewportCommand};

use crate::picture::worker::{Progress, Rendering};
use crate::window::style;

/// Title and text size of the window.
pub struct WindowFrame {
    title: String,
    /// The factor by which text has grown with the window.
    grown: f32,
}

impl Default for WindowFrame {
    fn default() -> Self {
        Self { title: String::new(), grown: 1.0 }
    }
}

impl WindowFrame {
    /// Sets what has changed: the title (the scene and its progress), and the size of the text.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering) {
        style::grow(ctx, &mut self.grown);
        let is_running = matches!(rendering.progress(), Progress::Running(..));
        let state = if is_running { " (rendering)" } else { "" };
        let title = format!("{}{state} - Groundtruth inspector", rendering.source.name());
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}
