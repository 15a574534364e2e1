//! The window: its state and its layout.

use std::time::Duration;

use eframe::egui::{
    self, CentralPanel, Context, Frame, Margin, Panel, Rect, RichText, ScrollArea, Ui, UiBuilder,
    Vec2, ViewportCommand, vec2,
};
use groundtruth::explain;
use groundtruth::scene::Scene;

use crate::comparison::bar;
use crate::comparison::theirs::Theirs;
use crate::explanation::selection::Selection;
use crate::explanation::trail;
use crate::explanation::tree::Tree;
use crate::picture::display::{self, Picture};
use crate::picture::image_settings::ImageSettings;
use crate::picture::saving::Saving;
use crate::picture::worker::{Background, Progress, Rendering};
use crate::scene::picker::ScenePicker;
use crate::scene::source::{Loaded, Source};
use crate::scene::switches;
use crate::scene::waiting::{Broken, Waiting};
use crate::scene::watch::Watch;
use crate::window::chooser::{FileChooser, Purpose};
use crate::window::keys::{self, Shortcut};
use crate::window::panels::{self, Action, Fields};
use crate::window::splits::Splits;
use crate::window::stored_settings::StoredSettings;
use pictures::parse_pixel;

/// The whole state of the window.
pub struct Inspector {
    /// The picture's scene, and the picture.
    pub rendering: Rendering,
    /// The view of the picture.
    pub picture: Picture,
    /// The selected pixel.
    pub selection: Selection,
    /// The text in the fields.
    pub fields: Fields,
    /// The message, and whether it is an error.
    pub message: Option<(String, bool)>,
    /// The picture that ours is held against.
    pub theirs: Option<Theirs>,
    /// The list of scenes.
    pub picker: ScenePicker,
    /// The desktop's file chooser.
    pub chooser: FileChooser,
    /// The scene with the present settings and switches.
    pub(crate) wanted: Scene,
    /// The present seed.
    pub(crate) seed: u64,
    /// Counts the scenes that were rendered, to recognise old answers.
    pub(crate) generation: u64,
    pub(crate) loading: Background<Result<Loaded, String>>,
    pub(crate) watch: Watch,
    /// What the command line asks for, until its scene file is valid.
    pub(crate) waiting: Option<Waiting>,
    saving: Saving,
    settings: ImageSettings,
    splits: Splits,
    is_showing_keys: bool,
    /// The pixel under the mouse.
    hovered: Option<[u32; 2]>,
    title: String,
}

impl Inspector {
    /// Starts to render a scene.
    pub fn new(ctx: &Context, mut loaded: Loaded) -> Self {
        let (wanted, seed) = (loaded.scene.clone(), loaded.world.seed);
        let watch = loaded.watch.take().unwrap_or_default();
        let rendering = Rendering::start(ctx, loaded);
        let picture = Picture::new(display::tone_of(&rendering));
        Self {
            title: String::new(),
            rendering,
            picture,
            selection: Selection::default(),
            fields: Fields { save: StoredSettings::default().save, ..Fields::default() },
            message: None,
            theirs: None,
            picker: ScenePicker::default(),
            chooser: FileChooser::default(),
            wanted,
            seed,
            generation: 0,
            loading: Background::default(),
            watch,
            waiting: None,
            saving: Saving::default(),
            settings: ImageSettings::default(),
            splits: Splits::default(),
            is_showing_keys: false,
            hovered: None,
        }
    }

    /// Shows the error of a scene file, and waits until it is mended.
    pub fn waiting_for(ctx: &Context, broken: Broken) -> Self {
        let mut inspector = Self::new(ctx, broken.placeholder());
        inspector.fields.open = broken.path.display().to_string();
        inspector.message = Some((broken.error, true));
        (inspector.watch, inspector.waiting) = (broken.watch, Some(broken.waiting));
        inspector
    }

    /// Selects a pixel, if the picture has it.
    pub fn select(&mut self, pixel @ [x, y]: [u32; 2]) {
        let [width, height] = self.rendering.size();
        if x >= width || y >= height {
            let text = format!("pixel ({x}, {y}) is outside the picture of {width} × {height}");
            self.message = Some((text, true));
            return;
        }
        self.message = None;
        if self.selection.pixel != Some(pixel) {
            self.selection.tree = Tree::default();
        }
        self.selection.pixel = Some(pixel);
        self.fields.pixel = format!("{x}, {y}");
    }

    /// Settings of an earlier run.
    pub fn restore(&mut self, stored: StoredSettings) {
        (self.splits, self.fields.save) = (stored.splits, stored.save);
    }

    /// Settings for a later run.
    pub fn stored_settings(&self) -> StoredSettings {
        StoredSettings { splits: self.splits, save: self.fields.save.clone() }
    }

    /// Whether anything is still being computed.
    pub fn is_busy(&self) -> bool {
        self.loading.is_busy()
            || self.saving.is_busy()
            || self.chooser.is_open()
            || self.selection.is_waiting()
            || matches!(self.rendering.progress(), Progress::Running(..))
            || !self.picture.is_fresh(&self.rendering, self.generation)
            || self.theirs.as_ref().is_some_and(|it| it.is_busy(&self.rendering, self.generation))
    }

    /// Draws the window and carries out what the user asks for.
    pub fn show(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.poll_loading(&ctx);
        self.message = self.saving.poll().or(self.message.take());
        self.drop_files(&ctx);
        self.follow_files(&ctx);
        self.set_title(&ctx);

        // before anything is drawn, so that the tree is in the frame of the click
        if let Some(pixel) = self.picture.clicked(&ctx, self.rendering.size()) {
            self.select(pixel);
        }
        self.step(ui);
        self.selection.refresh(&ctx, &self.rendering, self.generation);

        let action = self.bars(ui);
        let changed = CentralPanel::default().frame(Frame::NONE).show(ui, |ui| self.parts(ui));
        if changed.inner {
            self.rebuild(&ctx);
        }
        // before an action opens the question: the Enter that caused it must not answer it
        self.saving.ask(&ctx, &self.rendering, &self.picture);
        let chosen = self.chosen();
        if let Some(action) = action.or(chosen).or(self.shortcut(&ctx)) {
            self.perform(&ctx, action);
        }
        keys::list(&ctx, &mut self.is_showing_keys);

        self.picture.refresh(&ctx, &self.rendering, self.generation);
        if let Some(theirs) = &mut self.theirs {
            theirs.refresh(&ctx, &self.rendering, self.generation, self.picture.tone);
        }
        self.selection.refresh(&ctx, &self.rendering, self.generation);
        if self.is_busy() {
            ctx.request_repaint_after(Duration::from_millis(50));
        }
    }

    /// The bars at the top and the bottom.
    fn bars(&mut self, ui: &mut Ui) -> Option<Action> {
        let bar = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(8, 4));
        let action = Panel::top("files").frame(bar).show(ui, |ui| {
            let source = &self.rendering.source;
            let action = panels::files(ui, &mut self.fields, &mut self.picker, source);
            self.message_line(ui);
            action
        });
        let status = Panel::bottom("status").frame(bar).show(ui, |ui| {
            let (rendering, theirs) = (&self.rendering, self.theirs.as_ref());
            panels::status(ui, rendering, theirs, self.hovered, self.loading.is_busy())
        });
        self.is_showing_keys ^= status.inner;
        Panel::top("view")
            .frame(bar)
            .show(ui, |ui| panels::view_settings(ui, &mut self.picture, &self.rendering));
        if let Some(theirs) = self.theirs.as_mut().filter(|_| self.waiting.is_none()) {
            let (rendering, generation) = (&self.rendering, self.generation);
            let show = |ui: &mut Ui| bar::show(ui, theirs, rendering, generation);
            let wish = Panel::top("comparison").frame(bar).show(ui, show).inner;
            self.carry_out(ui.ctx(), wish);
        }
        action.inner
    }

    /// Selects a pixel and moves the picture if it is not in view.
    pub(crate) fn select_and_reveal(&mut self, pixel: [u32; 2]) {
        self.select(pixel);
        if self.selection.pixel == Some(pixel) {
            self.picture.reveal(self.rendering.size(), pixel);
        }
    }

    /// The scene, the picture and the explanation, side by side. Returns whether the scene was changed.
    fn parts(&mut self, ui: &mut Ui) -> bool {
        if self.waiting.is_some() {
            let text = "The picture follows when the scene file is mended.";
            ui.centered_and_justified(|ui| ui.weak(text));
            return false;
        }
        let parts = self.splits.show(ui, ui.max_rect());
        let changed = part(ui, ("scene", parts.scene), |ui| {
            ScrollArea::both().auto_shrink(false).show(ui, |ui| self.scene(ui)).inner
        });
        let resampled = part(ui, ("explanation", parts.explanation), |ui| {
            let (rendering, tone) = (&self.rendering, &self.picture.tone);
            let shown = (rendering, self.theirs.as_ref(), self.generation);
            self.selection.show(ui, shown, tone, (&mut self.wanted, &mut self.splits))
        });
        let framed = part(ui, ("picture", parts.picture), |ui| {
            let size = self.rendering.size();
            let fits = |theirs: &&mut Theirs| theirs.fits(&self.rendering);
            let theirs = self.theirs.as_mut().filter(fits);
            self.hovered =
                self.picture.show(ui, size, self.selection.pixel, |painter, placement| {
                    if let Some(theirs) = &theirs {
                        theirs.paint(painter, placement, self.generation);
                    }
                });
            let placement = self.picture.placement(size);
            let framed = theirs.and_then(|theirs| {
                theirs.show_divider(ui, parts.picture);
                theirs.judgement.show_frames(ui, &placement)
            });
            let trail = self.selection.trail(&self.rendering);
            trail::paint(ui.painter(), &placement, &trail);
            framed
        });
        if let Some(pixel) = framed {
            self.select(pixel);
        }
        changed || resampled
    }

    /// The scene's panel: its name, settings and switches. Returns whether it was changed.
    fn scene(&mut self, ui: &mut Ui) -> bool {
        if !self.wanted.about.is_empty() {
            ui.label(RichText::new(&self.wanted.about).italics());
            ui.add_space(6.0);
        }
        let changed = self.settings.show(ui, &mut self.wanted, &mut self.seed);
        for note in explain::notes(&self.rendering.world) {
            ui.label(RichText::new(note).color(ui.visuals().warn_fg_color));
        }
        ui.add_space(8.0);
        changed | switches::show(ui, &mut self.wanted)
    }

    /// The title of the window: the scene and its progress.
    fn set_title(&mut self, ctx: &Context) {
        let rendering = matches!(self.rendering.progress(), Progress::Running(..));
        let state = if rendering { " (rendering)" } else { "" };
        let title = format!("{}{state} - Groundtruth inspector", self.rendering.source.name());
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    fn message_line(&mut self, ui: &mut Ui) {
        let Some((text, is_error)) = &self.message else { return };
        let (text, is_error) = (text.clone(), *is_error);
        ui.horizontal_top(|ui| {
            if ui.small_button("×").on_hover_text("Dismiss").clicked() {
                self.message = None;
            }
            let text = RichText::new(text).monospace();
            let text = if is_error { text.color(ui.visuals().error_fg_color) } else { text };
            ui.add(egui::Label::new(text).wrap());
        });
    }

    /// The arrow keys step to the next pixel, unless they are needed elsewhere.
    fn step(&mut self, ui: &Ui) {
        let Some([x, y]) = self.selection.pixel else { return };
        if !self.picture.has_keys(ui.ctx()) || self.saving.is_asking() {
            return;
        }
        let [dx, dy] = display::arrow_step(ui);
        if [dx, dy] == [0, 0] {
            return;
        }
        let size @ [width, height] = self.rendering.size();
        let moved = |at: u32, by: i64, end: u32| (i64::from(at) + by).clamp(0, i64::from(end) - 1);
        let pixel = [moved(x, dx, width) as u32, moved(y, dy, height) as u32];
        self.select(pixel);
        self.picture.reveal(size, pixel);
    }

    /// Carries out the pressed shortcut, or returns its action.
    fn shortcut(&mut self, ctx: &Context) -> Option<Action> {
        if self.saving.is_asking() {
            return None;
        }
        let save = self.fields.save.trim();
        match keys::pressed(ctx, !self.picture.has_keys(ctx))? {
            Shortcut::File => ctx.memory_mut(|memory| memory.request_focus(panels::file_field())),
            Shortcut::Save if !save.is_empty() => return Some(Action::Save(save.into())),
            Shortcut::Save => self.message = Some(("the picture has no name".to_owned(), true)),
            Shortcut::Keys => self.is_showing_keys ^= true,
            Shortcut::NextRegion => self.select_next_region(),
            shortcut => {
                if let Some(theirs) = &mut self.theirs {
                    theirs.follow(shortcut);
                }
            }
        }
        None
    }

    /// What to do with the file that was chosen; its name is in its field.
    fn chosen(&mut self) -> Option<Action> {
        let Some((purpose, path)) = self.chooser.poll()? else {
            let text = "no file chosen (the chooser is that of the desktop's portal, or zenity); the path can be typed, too";
            self.message = Some((text.to_owned(), false));
            return None;
        };
        let name = path.display().to_string();
        Some(match purpose {
            Purpose::Scene => {
                self.fields.open = name;
                Action::Open(Source::File(path))
            }
            Purpose::Picture => {
                self.fields.save = name;
                Action::Save(path)
            }
        })
    }

    /// Carries out what the user asked for in a bar.
    fn perform(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::Open(source) => self.open(ctx, source),
            Action::Save(path) => {
                self.message = None;
                self.saving.start(ctx, &self.rendering, &self.picture, &path);
            }
            Action::Choose(purpose) => self.chooser.show(ctx, purpose),
            Action::Select(text) => match parse_pixel(&text) {
                Ok(pixel) => self.select_and_reveal(pixel),
                Err(error) => self.message = Some((error, true)),
            },
        }
    }
}

/// Shows a part of the window in its area.
fn part<T>(ui: &mut Ui, (name, area): (&str, Rect), show: impl FnOnce(&mut Ui) -> T) -> T {
    let margin = if name == "picture" { Vec2::ZERO } else { vec2(8.0, 6.0) };
    ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
    let builder = UiBuilder::new().id_salt(name).max_rect(area.shrink2(margin));
    ui.scope_builder(builder, |ui| {
        ui.set_clip_rect(ui.clip_rect().intersect(area));
        show(ui)
    })
    .inner
}

impl eframe::App for Inspector {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.stored_settings().write(storage);
    }
}
