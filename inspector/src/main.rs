//! `inspector [SCENE]`: opens the window.

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;
use eframe::egui;
use inspector::comparison::theirs::Theirs;
use inspector::start::Start;
use inspector::window::arguments::Arguments;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match Start::read(&arguments).map_err(Into::into).and_then(|start| open(start, arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            report(&error.to_string());
            ExitCode::from(2)
        }
    }
}

/// Ends the program that runs for a pixel with the window: it is in a process group of its own, which Ctrl-C does not reach.
#[cfg(unix)]
fn end_program_with_window() -> Result<(), Box<dyn Error>> {
    use signal_hook::consts::{SIGINT, SIGTERM};
    let mut signals = signal_hook::iterator::Signals::new([SIGINT, SIGTERM])?;
    std::thread::spawn(move || {
        for signal in signals.forever() {
            inspector::comparison::pixel_command::end_all();
            let _ = signal_hook::low_level::emulate_default_handler(signal);
        }
    });
    Ok(())
}

#[cfg(not(unix))]
fn end_program_with_window() -> Result<(), Box<dyn Error>> {
    Ok(())
}

fn report(error: &str) {
    eprintln!("error: {}", groundtruth::printable::text(error));
}

fn open(start: Start, arguments: Arguments) -> Result<(), Box<dyn Error>> {
    if let Err(broken) = &start.scene {
        report(&broken.error);
    }
    for note in start.theirs.iter().flat_map(Theirs::notes) {
        eprintln!("note: {}", groundtruth::printable::text(note));
    }
    if arguments.rays_from.is_some() {
        end_program_with_window()?;
    }
    let viewport = egui::ViewportBuilder::default()
        .with_title("Groundtruth inspector")
        .with_inner_size([1400.0, 830.0])
        .with_min_inner_size([800.0, 500.0])
        .with_position([0.0, 0.0]);
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let create = move |context: &eframe::CreationContext<'_>| {
        let inspector = start.inspector(&context.egui_ctx, context.storage, &arguments);
        Ok(Box::new(inspector) as Box<dyn eframe::App>)
    };
    eframe::run_native("groundtruth-inspector", options, Box::new(create))
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
