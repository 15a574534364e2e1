//! What the window opens with.

use std::path::PathBuf;

use eframe::Storage;
use eframe::egui::Context;

use crate::app::Inspector;
use crate::comparison::theirs::Theirs;
use crate::scene::source::Loaded;
use crate::scene::waiting::Broken;
use crate::window::arguments::Arguments;
use crate::window::stored_settings::StoredSettings;
use crate::window::style::set_style;

/// What the window opens with.
pub struct Start {
    /// The scene, or its file that is not valid yet.
    pub scene: Result<Loaded, Broken>,
    /// The pictures that ours is compared with.
    pub theirs: Vec<Theirs>,
}

impl Start {
    /// Reads scene and picture before a window opens.
    ///
    /// # Errors
    /// A bad picture, or arguments that do not fit; the error of a scene file is in [`Self::scene`].
    pub fn read(arguments: &Arguments) -> Result<Self, String> {
        let theirs = arguments.theirs()?;
        let scene = match arguments.load(theirs.first()) {
            Ok(loaded) => Ok(loaded),
            Err(error) => Err(arguments.broken(theirs.first()).ok_or(error)?),
        };
        Ok(Self { scene, theirs })
    }

    /// The window with what the arguments ask for, and the settings of an earlier run.
    pub fn inspector(
        self,
        ctx: &Context,
        storage: Option<&dyn Storage>,
        arguments: &Arguments,
    ) -> Inspector {
        set_style(ctx);
        let mut logs: Vec<PathBuf> = Vec::new();
        let mut inspector = match self.scene {
            Err(broken) => Inspector::waiting_for(ctx, broken),
            Ok(mut loaded) => {
                let named = loaded.rays.take().into_iter();
                logs = named.chain(arguments.rays.iter().cloned()).collect();
                let mut inspector = Inspector::new(ctx, loaded);
                match arguments.pixel {
                    None if !logs.is_empty() => {}
                    Some(pixel) => inspector.explain(pixel, arguments.sample.unwrap_or(0)),
                    None => inspector.selection.propose(ctx, &inspector.session.rendering),
                }
                inspector
            }
        };
        self.theirs.into_iter().for_each(|theirs| inspector.others.add_picture(theirs));
        inspector.others.choose(0);
        logs.into_iter().for_each(|path| inspector.others.add_log(path));
        if let Some(mut command) = arguments.rays_from.clone() {
            // a log does not say how its picture encodes radiance
            let picture = arguments.compare.first().filter(|_| arguments.encoding.is_none());
            command.picture = picture.cloned();
            inspector.others.add_run(command);
        }
        // the pixel that was asked for is of the first scene
        inspector.proposes = true;
        (inspector.space.mode, inspector.selection.tab) = (arguments.view, arguments.tab);
        let stored = StoredSettings::read(storage);
        let ground = arguments.theme.unwrap_or(stored.ground);
        ground.set(ctx);
        inspector.settings = StoredSettings { ground, ..stored };
        inspector
    }
}
