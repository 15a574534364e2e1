//! What is open: a scene with the changes made in the window, and its picture.

use std::mem::take;
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::Context;
use groundtruth::scene::Scene;

use crate::picture::worker::{Background, Rendering};
use crate::scene::reload;
use crate::scene::source::{Built, Loaded, Source};
use crate::scene::waiting::Broken;
use crate::scene::watch::{self, Watch};

/// The open scene, and the one that is being loaded.
pub struct Session {
    /// The picture's scene, and the picture.
    pub rendering: Rendering,
    /// The scene with the present settings and switches.
    pub wanted: Scene,
    /// The present seed.
    pub seed: u64,
    /// The scene that is being loaded.
    pub loading: Background<Result<Loaded, String>>,
    /// The requests of the command line, until its scene file is valid; there is no picture before.
    pub waiting: Option<Broken>,
    watch: Watch,
}

/// The relation of a scene that was opened to the one before it.
pub struct Opened {
    /// Whether it is the same scene, perhaps changed.
    pub is_same_scene: bool,
    /// Whether it is the same scene, and its picture has the same size.
    pub is_same_view: bool,
    /// The pixel and the sample that the command line asks for.
    pub asked: Option<([u32; 2], u32)>,
    /// The log of rays for which it was opened.
    pub rays: Option<PathBuf>,
}

impl Session {
    /// Starts to render a scene.
    pub fn new(ctx: &Context, mut loaded: Loaded) -> Self {
        Self {
            wanted: (*loaded.built.scene).clone(),
            seed: loaded.built.world.seed,
            loading: Background::default(),
            watch: loaded.watch.take().unwrap_or_default(),
            waiting: None,
            rendering: Rendering::start(ctx, loaded.built, 0),
        }
    }

    /// Waits until a scene file is mended.
    pub fn waiting_for(ctx: &Context, mut broken: Broken) -> Self {
        let (session, watch) = (Self::new(ctx, broken.placeholder()), take(&mut broken.watch));
        Self { watch, waiting: Some(broken), ..session }
    }

    /// Opens another scene; the present one stays if the other is invalid.
    pub fn open(&mut self, ctx: &Context, source: Source) {
        self.loading.start(ctx, move || source.load());
    }

    /// Builds the scene again with its present settings and switches.
    pub fn rebuild(&mut self, ctx: &Context) {
        let (built, scene, seed) = (self.rendering.built.clone(), self.wanted.clone(), self.seed);
        self.loading.start(ctx, move || built.changed(scene, seed).map(Loaded::from));
    }

    /// Reads the scene again if its file was changed; keeps the changes made in the window.
    pub fn follow_files(&mut self, ctx: &Context) {
        if self.watch.is_empty() {
            return;
        }
        ctx.request_repaint_after(watch::INTERVAL);
        if self.loading.is_busy() || !self.watch.changed() {
            return;
        }
        let Built { source, read, .. } = self.rendering.built.clone();
        let (wanted, seed) = (self.wanted.clone(), self.seed);
        let asked = self.waiting.as_ref().map(|waiting| Arc::clone(&waiting.change));
        let change = move |now| match asked {
            Some(change) => change(now),
            None => Ok(reload::with_changes(&read, &wanted, now)),
        };
        self.loading.start(ctx, move || source.load_changed(seed, change));
    }

    /// Renders the scene that was loaded meanwhile, if there is one; after an error, the changes are undone.
    pub fn poll(&mut self, ctx: &Context) -> Option<Result<Opened, String>> {
        let loaded = self.loading.poll()?.unwrap_or_else(|lost| Err(lost.to_string()));
        let opened = loaded.map(|loaded| self.replace(ctx, loaded));
        self.wanted = (*self.rendering.scene).clone();
        self.seed = self.rendering.world.seed;
        Some(opened)
    }

    fn replace(&mut self, ctx: &Context, mut loaded: Loaded) -> Opened {
        let is_same_source = loaded.built.source.name() == self.rendering.source.name();
        let waited = self.waiting.take();
        let (is_same_scene, old_size) = (is_same_source && waited.is_none(), self.rendering.size());
        if let Some(watch) = loaded.watch.take() {
            self.watch = watch;
        }
        // the old rendering is dropped here, which stops it
        self.rendering = Rendering::start(ctx, loaded.built, self.rendering.generation + 1);
        Opened {
            rays: loaded.rays,
            is_same_scene,
            is_same_view: is_same_scene && self.rendering.size() == old_size,
            asked: waited.filter(|_| is_same_source).and_then(|broken| broken.asked),
        }
    }
}
