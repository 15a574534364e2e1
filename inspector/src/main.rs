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

/// What the window opens with.
struct Start {
    /// The scene, or its file that is not valid yet.
    scene: Result<Loaded, Broken>,
    /// The pictures that ours is compared with.
    theirs: Vec<Theirs>,
}

/// Reads scene and picture before a window opens. A bad picture, or arguments that do not fit, are errors; the error of
/// a scene file is reported here and in the window.
fn start(arguments: &Arguments) -> Result<Start, String> {
    let theirs = arguments.theirs()?;
    let scene = match arguments.load(theirs.first()) {
        Ok(loaded) => Ok(loaded),
        Err(error) => {
            let broken = arguments.broken(theirs.first()).ok_or(error)?;
            report(&broken.error);
            Err(broken)
        }
    };
    Ok(Start { scene, theirs })
}

fn open(Start { scene, theirs }: Start, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
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
    let (view, tab) = (arguments.view, arguments.tab);
    let ground = arguments.theme;
    let start = move |context: &eframe::CreationContext<'_>| {
        let ctx = &context.egui_ctx;
        set_style(ctx);
        let mut inspector = match scene {
            Err(broken) => Inspector::waiting_for(ctx, broken),
            Ok(loaded) => {
                let mut inspector = Inspector::new(ctx, loaded);
                match pixel {
                    Some(pixel) => inspector.explain(pixel, sample.unwrap_or(0)),
                    None => inspector.propose(ctx),
                }
                inspector
            }
        };
        theirs.into_iter().for_each(|theirs| inspector.others.add_picture(theirs));
        inspector.others.choose(0);
        (inspector.space.mode, inspector.selection.tab) = (view, tab);
        let stored = StoredSettings::read(context.storage);
        let ground = ground.unwrap_or(stored.ground);
        inspector.restore(ctx, StoredSettings { ground, ..stored });
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
