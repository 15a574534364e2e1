//! `inspector [SCENE]`: opens the window.

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;
use eframe::egui;
use inspector::app::Inspector;
use inspector::comparison::theirs::Theirs;
use inspector::scene::source::Loaded;
use inspector::window::arguments::Arguments;
use inspector::window::stored_settings::StoredSettings;
use inspector::window::style::set_style;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // reports a bad picture or scene in the terminal, before a window opens
    let loaded = arguments.theirs().and_then(|theirs| {
        let loaded = arguments.load(theirs.as_ref())?;
        Ok((loaded, theirs))
    });
    match loaded.map_err(Into::into).and_then(|loaded| open(loaded, &arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}", groundtruth::printable::text(&error.to_string()));
            ExitCode::from(2)
        }
    }
}

fn open(
    (loaded, theirs): (Loaded, Option<Theirs>),
    arguments: &Arguments,
) -> Result<(), Box<dyn Error>> {
    for note in theirs.iter().flat_map(Theirs::notes) {
        eprintln!("note: {}", groundtruth::printable::text(note));
    }
    let viewport = egui::ViewportBuilder::default()
        .with_title("Groundtruth inspector")
        .with_inner_size([1400.0, 830.0])
        .with_min_inner_size([800.0, 500.0])
        .with_position([0.0, 0.0]);
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let (pixel, sample) = (arguments.pixel, arguments.sample);
    let start = move |context: &eframe::CreationContext<'_>| {
        set_style(&context.egui_ctx);
        let mut inspector = Inspector::new(&context.egui_ctx, loaded);
        inspector.theirs = theirs;
        inspector.restore(StoredSettings::read(context.storage));
        if let Some(pixel) = pixel {
            inspector.select(pixel);
            inspector.selection.sample = sample.unwrap_or(0);
        }
        Ok(Box::new(inspector) as Box<dyn eframe::App>)
    };
    eframe::run_native("groundtruth-inspector", options, Box::new(start))
        .map_err(|error| format!("the window cannot be opened: {error}").into())
}
