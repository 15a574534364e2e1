//! Saving the picture, or a layer of it: on a separate thread, and asking before a file is replaced.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::{Context, Event, Id, Key, Modal};
use groundtruth::film::{self, Film, Format, ImageError, Provenance, Tone};
use groundtruth::render::Canvas;
use groundtruth::world::World;
use layers::Layer;
use pictures::provenance;

use crate::picture::worker::{Background, Rendering};
use crate::platform;
use crate::scene::source::Built;

/// What is saved.
#[derive(Clone, Debug)]
pub enum Content {
    /// The picture.
    Picture,
    /// A layer that is found: a film of its values.
    Layer(Layer, Film),
    /// Another film, which is no layer of the scene.
    Beside {
        /// What it is, for the file.
        name: &'static str,
        /// Its colours, for files to look at.
        colors: Film,
        /// Its values.
        values: Film,
    },
}

/// The state of saving.
#[derive(Debug, Default)]
pub struct Saving {
    /// The writing of a picture.
    pub working: Background<Result<PathBuf, String>>,
    /// The existing file that the question is about, and what is to be in it.
    asking: Option<(PathBuf, Content)>,
}

impl Content {
    fn part(&self) -> Option<String> {
        match self {
            Self::Picture => None,
            Self::Layer(layer, _) => Some(format!("layer {layer}")),
            Self::Beside { name, .. } => Some((*name).to_owned()),
        }
    }

    fn encode(
        &self,
        format: Format,
        (canvas, world): (&Canvas, &World),
        tone: Tone,
        made: &Provenance,
    ) -> std::io::Result<Vec<u8>> {
        match self {
            Self::Picture => film::encode(&canvas.film(), &tone, format, made),
            Self::Layer(layer, film) => {
                layers::encode_film(layer, film, format, (world, tone), made)
            }
            Self::Beside { colors, values, .. } => {
                let film = if format.is_for_display() { colors } else { values };
                film::encode(film, &Tone::PLAIN, format, made)
            }
        }
    }
}

impl Saving {
    /// Saves it, or asks first if the file exists.
    pub fn start(
        &mut self,
        ctx: &Context,
        (rendering, tone): (&Rendering, Tone),
        content: Content,
        to: &Path,
    ) {
        if platform::exists(to) {
            self.asking = Some((to.to_owned(), content));
        } else {
            self.write(ctx, (rendering, tone), content, to.to_owned());
        }
    }

    fn write(
        &mut self,
        ctx: &Context,
        (rendering, tone): (&Rendering, Tone),
        content: Content,
        to: PathBuf,
    ) {
        let (canvas, built) = (Arc::clone(&rendering.canvas), rendering.built.clone());
        self.working.start(ctx, move || {
            let Built { source, read, scene, world } = &built;
            let made = provenance((source.entry(), read), (scene, world), source.folder());
            let mut made = made.map_err(|error| error.to_string())?;
            let of_scene = world.image.tone();
            let format = Format::of(&to).map_err(|error| error.to_string())?;
            made.tone = (format.is_for_display() && tone != of_scene).then(|| tone.to_string());
            made.part = content.part();
            let bytes = content.encode(format, (&canvas, world), tone, &made);
            let unwritable = |source| ImageError::Unwritable { path: to.clone(), source };
            let written = bytes.and_then(|bytes| platform::save(&to, &bytes)).map_err(unwritable);
            written.map_err(|error| error.to_string())
        });
    }

    /// Asks whether to replace the file, until the user answers.
    pub fn ask(&mut self, ctx: &Context, rendering: &Rendering, tone: Tone) {
        let Some((path, _)) = &self.asking else { return };
        let enter = ctx.input(|input| input.events.iter().any(is_enter));
        let modal = Modal::new(Id::unique("replace")).show(ctx, |ui| {
            ui.set_max_width(420.0);
            ui.label(format!("{} exists. Replace it?", path.display()));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                let replace = ui.button("Replace (Enter)").clicked();
                if ui.button("Cancel (Esc)").clicked() {
                    ui.close();
                }
                replace
            })
            .inner
        });
        if modal.inner || enter {
            if let Some((path, content)) = self.asking.take() {
                self.write(ctx, (rendering, tone), content, path);
            }
        } else if modal.should_close() {
            self.asking = None;
        }
    }

    /// Whether the question is open; it then gets the keys.
    pub fn is_asking(&self) -> bool {
        self.asking.is_some()
    }

    /// The message about a picture that was written, returned once, and whether it is an error.
    pub fn poll(&mut self) -> Option<(String, bool)> {
        Some(match self.working.poll()?.flatten() {
            Ok(path) => (format!("saved {}", path.display()), false),
            Err(error) => (error, true),
        })
    }
}

/// Whether Enter was pressed. A key that is held down since before the question does not count.
fn is_enter(event: &Event) -> bool {
    matches!(event, Event::Key { key: Key::Enter, pressed: true, repeat: false, .. })
}
