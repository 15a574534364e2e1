//! What is open: a scene with the changes made in the window, and its picture.

use std::mem::take;
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{Context, Pos2};
use groundtruth::scene::Scene;

use crate::picture::worker::{Background, Rendering};
use crate::scene::reload;
use crate::scene::source::{Built, Loaded, Source};
use crate::scene::waiting::Broken;
use crate::scene::watch::Watch;

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
    /// Whether the file was changed, but has an error: the picture is of what it was before.
    pub is_old: bool,
    /// What is being loaded, and whether it is the open file again.
    pub what: (String, bool),
    /// Whether the scene was changed again while it was built.
    is_due: bool,
    /// The states before and after the present one, to which undo and redo lead.
    changes: [Vec<State>; 2],
    /// Where the mouse was pressed for the last change: a drag is undone at once.
    pressed: Option<Pos2>,
}

/// A scene and its seed.
type State = (Arc<Scene>, u64);

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
            is_old: false,
            what: (String::new(), false),
            is_due: false,
            changes: Default::default(),
            pressed: None,
            rendering: Rendering::start(ctx, loaded.built, 0),
        }
    }

    /// Opens another scene; the present one stays if the other is invalid.
    pub fn open(&mut self, ctx: &Context, source: Source) {
        self.what = (format!("reading {}", source.name()), false);
        self.loading.start(ctx, move || source.load());
    }

    /// Builds the scene again with its present settings and switches; after the one that is being built.
    pub fn rebuild(&mut self, ctx: &Context) {
        let pressed = ctx.input(|input| input.pointer.press_origin());
        if pressed.is_none() || pressed != self.pressed {
            let present = self.present();
            self.changes[0].push(present);
            self.changes[1].clear();
        }
        self.pressed = pressed;
        self.build(ctx);
    }

    fn build(&mut self, ctx: &Context) {
        self.is_due = self.loading.is_busy();
        if self.is_due {
            return;
        }
        self.what = ("building".to_owned(), false);
        let (built, scene, seed) = (self.rendering.built.clone(), self.wanted.clone(), self.seed);
        self.loading.start(ctx, move || built.changed(scene, seed).map(Loaded::from));
    }

    fn present(&self) -> State {
        (Arc::clone(&self.rendering.scene), self.rendering.world.seed)
    }

    /// Whether there is a change to undo.
    pub fn can_undo(&self) -> bool {
        !self.changes[0].is_empty()
    }

    /// Undoes the last change that was made in the window, or does it `again`.
    pub fn undo(&mut self, ctx: &Context, again: bool) {
        let present = self.present();
        let [past, future] = &mut self.changes;
        let [from, to] = if again { [future, past] } else { [past, future] };
        // a change that could not be built led to no other scene
        let is_other = |it: &State| !Arc::ptr_eq(&it.0, &present.0) || it.1 != present.1;
        let other = from.iter().rposition(is_other);
        from.truncate(other.map_or(0, |at| at + 1));
        if let Some((scene, seed)) = from.pop() {
            to.push(present);
            (self.wanted, self.seed) = ((*scene).clone(), seed);
            self.build(ctx);
        }
    }

    /// Reads the scene again if its file was changed; keeps the changes made in the window.
    pub fn follow_files(&mut self, ctx: &Context) {
        if self.loading.is_busy() || !self.watch.follow(ctx) {
            return;
        }
        let Built { source, read, .. } = self.rendering.built.clone();
        let (wanted, seed) = (self.wanted.clone(), self.seed);
        let asked = self.waiting.as_ref().map(|waiting| Arc::clone(&waiting.change));
        let change = move |now: Scene| match &asked {
            Some(change) => change(now),
            None => Ok(reload::with_changes(&read, &wanted, now)),
        };
        self.what = (format!("reading {}", source.name()), true);
        self.loading.start(ctx, move || source.load_changed(seed, &change));
    }

    /// Renders the scene that was loaded meanwhile, if there is one; after an error, the changes are undone.
    pub fn poll(&mut self, ctx: &Context) -> Option<Result<Opened, String>> {
        let loaded = self.loading.poll()?.flatten();
        let is_read = self.what.1 || loaded.as_ref().is_ok_and(|loaded| loaded.watch.is_some());
        self.is_old = if is_read { loaded.is_err() } else { self.is_old };
        let opened = loaded.map(|loaded| self.replace(ctx, loaded));
        if take(&mut self.is_due) && !is_read {
            // the values of a drag go on
            self.build(ctx);
            return Some(opened);
        }
        self.wanted = (*self.rendering.scene).clone();
        self.seed = self.rendering.world.seed;
        Some(opened)
    }

    fn replace(&mut self, ctx: &Context, mut loaded: Loaded) -> Opened {
        let is_same_source = loaded.built.source.name() == self.rendering.source.name();
        let waited = self.waiting.take();
        let (is_same_scene, old_size) = (is_same_source && waited.is_none(), self.rendering.size());
        if let Some(watch) = loaded.watch.take() {
            (self.watch, self.changes) = (watch, Default::default());
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
