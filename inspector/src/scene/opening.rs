//! Opening scenes, rebuilding them after changes, and reading changed files again.

use std::sync::Arc;

use eframe::egui::Context;

use crate::app::Inspector;
use crate::explanation::tree::Tree;
use crate::picture::display::{self, Picture};
use crate::picture::worker::Rendering;
use crate::scene::source::{Loaded, Source};
use crate::scene::waiting::Waiting;
use crate::scene::{reload, watch};

impl Inspector {
    /// Opens another scene; the present one stays if the other is invalid.
    pub fn open(&mut self, ctx: &Context, source: Source) {
        self.message = None;
        self.loading.start(ctx, move || source.load());
    }

    /// Builds the scene again with its present settings and switches.
    pub(crate) fn rebuild(&mut self, ctx: &Context) {
        let Rendering { source, read, .. } = &self.rendering;
        let (source, read, scene, seed) =
            (source.clone(), read.clone(), self.wanted.clone(), self.seed);
        self.loading.start(ctx, move || source.rebuild(read, scene, seed));
    }

    /// Reads the scene again if its file was changed; keeps the changes made in the window.
    pub(crate) fn follow_files(&mut self, ctx: &Context) {
        if self.watch.is_empty() {
            return;
        }
        ctx.request_repaint_after(watch::INTERVAL);
        if self.loading.is_busy() || !self.watch.changed() {
            return;
        }
        let Rendering { source, read, .. } = &self.rendering;
        let (source, before, wanted, seed) =
            (source.clone(), read.clone(), self.wanted.clone(), self.seed);
        let asked = self.waiting.as_ref().map(|waiting| Arc::clone(&waiting.change));
        let change = move |now| match asked {
            Some(change) => change(now),
            None => Ok(reload::with_changes(&before, &wanted, now)),
        };
        self.loading.start(ctx, move || source.load_changed(seed, change));
    }

    /// Opens a file that is dropped on the window.
    pub(crate) fn drop_files(&mut self, ctx: &Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().cloned());
        if let Some(file) = dropped {
            let path = file.path().to_owned();
            self.fields.open = path.display().to_string();
            self.open(ctx, Source::File(path));
        }
    }

    /// Shows the scene that was loaded meanwhile, if there is one.
    pub(crate) fn poll_loading(&mut self, ctx: &Context) {
        match self.loading.poll() {
            Some(Ok(Ok(loaded))) => self.show_scene(ctx, loaded),
            Some(Ok(Err(error))) => self.keep_scene(error),
            Some(Err(lost)) => self.keep_scene(lost.to_string()),
            None => {}
        }
    }

    fn keep_scene(&mut self, error: String) {
        self.wanted = (*self.rendering.scene).clone();
        self.seed = self.rendering.world.seed;
        self.message = Some((error, true));
    }

    fn show_scene(&mut self, ctx: &Context, mut loaded: Loaded) {
        let is_same_file = loaded.source.name() == self.rendering.source.name();
        let waited = self.waiting.take();
        let is_same_scene = is_same_file && waited.is_none();
        let old_size = self.rendering.size();
        self.message = None;
        self.wanted = loaded.scene.clone();
        self.seed = loaded.world.seed;
        if let Some(watch) = loaded.watch.take() {
            self.watch = watch;
        }
        self.generation += 1;
        // the old rendering is dropped here, which stops it
        self.rendering = Rendering::start(ctx, loaded);
        if is_same_scene && self.rendering.size() == old_size {
            self.picture.restart();
        } else {
            self.picture = Picture::new(display::tone_of(&self.rendering));
        }
        if !is_same_scene {
            self.selection.tree = Tree::default();
        }
        self.keep_selection();
        if let Some(Waiting { pixel: Some(pixel), sample, .. }) = waited.filter(|_| is_same_file) {
            self.selection.sample = sample;
            self.select(pixel);
        }
    }

    /// The pixel stays selected if the picture has it.
    fn keep_selection(&mut self) {
        let [width, height] = self.rendering.size();
        if self.selection.pixel.is_some_and(|[x, y]| x >= width || y >= height) {
            self.selection = Default::default();
            self.fields.pixel.clear();
        }
        let last = self.rendering.world.samples_per_pixel() - 1;
        self.selection.sample = self.selection.sample.min(last);
    }
}
