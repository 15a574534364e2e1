//! `inspector [SCENE]`: opens the window.

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;
use eframe::egui;
use inspector::app::Inspector;
use inspector::comparison::theirs::Theirs;
use inspector::scene::source::Loaded;
use inspector::scene::waiting::Broken;
use inspector::window::arguments::Arguments;
use inspector::window::stored_settings::StoredSettings;
use inspector::window::style::set_style;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match start(&arguments).map_err(Into::into).and_then(|start| open(start, &arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            report(&error.to_string());
            ExitCode::from(2)
        }
    }
}

fn report(error: &str) {
    eprintln!("error: {}", groundtruth::printable::text(error));
}

/// The scene, or its file that is not valid yet.
enum Start {
    Scene(Box<Loaded>),
    Broken(Broken),
}

/// Reads scene and picture before a window opens. A bad picture, or arguments that do not fit, are errors; the error of
/// a scene file is reported here and in the window.
fn start(arguments: &Arguments) -> Result<(Start, Option<Theirs>), String> {
    let theirs = arguments.theirs()?;
    let start = match arguments.load(theirs.as_ref()) {
        Ok(loaded) => Start::Scene(Box::new(loaded)),
        Err(error) => match arguments.broken(theirs.as_ref()) {
            Some(broken) => {
                report(&broken.error);
                Start::Broken(broken)
            }
            None => return Err(error),
        },
    };
    Ok((start, theirs))
}

fn open(
    (start, theirs): (Start, Option<Theirs>),
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
        let ctx = &context.egui_ctx;
        set_style(ctx);
        let mut inspector = match start {
            Start::Broken(broken) => Inspector::waiting_for(ctx, broken),
            Start::Scene(loaded) => {
                let mut inspector = Inspector::new(ctx, *loaded);
                if let Some(pixel) = pixel {
                    inspector.select(pixel);
                    inspector.selection.sample = sample.unwrap_or(0);
                }
                inspector
            }
        };
        inspector.theirs = theirs;
        inspector.restore(StoredSettings::read(context.storage));
        Ok(Box::new(inspector) as Box<dyn eframe::App>)
    };
    eframe::run_native("groundtruth-inspector", options, Box::new(start))
        .map_err(|error| no_window(&error).into())
}

/// Why no window opens, in one line; without a screen, what helps.
fn no_window(error: &eframe::Error) -> String {
    if cfg!(target_os = "linux") && matches!(error, eframe::Error::WinitEventLoop(_)) {
        let display = std::env::var("DISPLAY").map_or("DISPLAY is not set".to_owned(), |display| {
            format!("DISPLAY is {display}, where none answers")
        });
        return format!(
            "no screen for the window: {display}; scripts/headless.sh installs a virtual one, for `xvfb-run -a inspector`"
        );
    }
    format!("the window cannot be opened: {error}")
}
