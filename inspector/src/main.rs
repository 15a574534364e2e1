//! `inspector [SCENE]`: opens the window.

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;
use eframe::egui;
use inspector::app::{Inspector, set_style};
use inspector::view::parse_pixel;
use inspector::worker::{Loaded, Source};

/// Click a pixel and read why it has its colour.
#[derive(Parser)]
#[command(name = "inspector", version)]
struct Arguments {
    /// A gallery name such as ch28/glass-sphere, or a scene file
    #[arg(default_value = "ch28/glass-sphere")]
    scene: String,
    /// Explain this pixel at once: column and row from the top left, as 200,150
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // a bad scene is told where the command was typed, before there is a window
    let outcome = Source::named(&arguments.scene).and_then(|source| source.load());
    match outcome.map_err(Into::into).and_then(|loaded| open(loaded, arguments.pixel)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn open(loaded: Loaded, pixel: Option<[u32; 2]>) -> Result<(), Box<dyn Error>> {
    let viewport = egui::ViewportBuilder::default()
        .with_title("Groundtruth inspector")
        .with_inner_size([1400.0, 830.0])
        .with_min_inner_size([800.0, 500.0])
        .with_position([0.0, 0.0]);
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let start = move |context: &eframe::CreationContext<'_>| {
        set_style(&context.egui_ctx);
        let mut inspector = Inspector::new(&context.egui_ctx, loaded);
        if let Some(pixel) = pixel {
            inspector.select(pixel);
        }
        Ok(Box::new(inspector) as Box<dyn eframe::App>)
    };
    eframe::run_native("groundtruth-inspector", options, Box::new(start))
        .map_err(|error| format!("the window cannot be opened: {error}").into())
}
