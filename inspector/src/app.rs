//! The window: its state, and where its parts stand.

use std::path::PathBuf;

use eframe::egui::{
    self, CentralPanel, Color32, Context, Frame, Margin, Panel, RichText, Theme, Ui,
    ViewportCommand,
};
use groundtruth::film;
use groundtruth::scene::Scene;

use crate::explanation::Selection;
use crate::panels::{self, Fields, Wish};
use crate::picture::{self, Mouse, Picture};
use crate::switches;
use crate::trail;
use crate::tree::Tree;
use crate::view::parse_pixel;
use crate::worker::{Background, Loaded, Progress, Rendering, Source};

/// All that the window knows.
pub struct Inspector {
    /// The picture's scene, and the picture.
    pub rendering: Rendering,
    /// How the picture is looked at.
    pub picture: Picture,
    /// The selected pixel.
    pub selection: Selection,
    /// What was typed.
    pub fields: Fields,
    /// What there is to say, and whether it is an error.
    pub message: Option<(String, bool)>,
    /// The scene with the switches as they stand.
    wanted: Scene,
    /// Counts the scenes that were rendered, so that old answers are known as old.
    generation: u64,
    loading: Background<Result<Loaded, String>>,
    saving: Background<Result<PathBuf, String>>,
    mouse: Mouse,
    title: String,
}

impl Inspector {
    /// Starts to render a scene.
    pub fn new(ctx: &Context, loaded: Loaded) -> Self {
        let wanted = loaded.scene.clone();
        let rendering = Rendering::start(ctx, loaded);
        let picture = Picture::new(picture::tone_of(&rendering));
        Self {
            title: String::new(),
            rendering,
            picture,
            selection: Selection::default(),
            fields: Fields { save: "picture.png".to_owned(), ..Fields::default() },
            message: None,
            wanted,
            generation: 0,
            loading: Background::default(),
            saving: Background::default(),
            mouse: Mouse::default(),
        }
    }

    /// Selects a pixel, if the picture has it.
    pub fn select(&mut self, pixel @ [x, y]: [u32; 2]) {
        let [width, height] = self.rendering.size();
        if x >= width || y >= height {
            let text = format!("pixel ({x}, {y}) is outside the picture of {width} × {height}");
            self.message = Some((text, true));
            return;
        }
        if self.selection.pixel != Some(pixel) {
            self.selection.tree = Tree::default();
        }
        self.selection.pixel = Some(pixel);
        self.fields.pixel = format!("{x}, {y}");
    }

    /// Opens another scene; the present one stays if there is something wrong with it.
    pub fn open(&mut self, ctx: &Context, source: Source) {
        self.message = None;
        self.loading.start(ctx, move || source.load());
    }

    /// Whether anything is still being worked out.
    pub fn is_busy(&self) -> bool {
        self.loading.is_busy()
            || self.saving.is_busy()
            || self.selection.is_waiting()
            || matches!(self.rendering.progress(), Progress::Running(..))
            || !self.picture.is_fresh(&self.rendering, self.generation)
    }

    /// Draws the window and does what the person asks for.
    pub fn show(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.take_results(&ctx);
        self.drop_files(&ctx);
        self.set_title(&ctx);

        let bar = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(8, 6));
        let wish = Panel::top("files").frame(bar).show(ui, |ui| {
            let wish = panels::files(ui, &mut self.fields, &self.rendering.source);
            self.message_line(ui);
            wish
        });
        Panel::bottom("status").frame(bar).show(ui, |ui| {
            panels::status(ui, &self.rendering, self.mouse.over, self.loading.is_busy());
        });
        let changed = Panel::left("scene")
            .frame(bar)
            .default_size(190.0)
            .show(ui, |ui| switches::show(ui, &mut self.wanted));
        let right = Panel::right("explanation").frame(bar).default_size(580.0).min_size(300.0);
        let resampled = right.show(ui, |ui| {
            ui.take_available_width();
            let of = (&self.rendering, self.generation);
            self.selection.show(ui, of, &self.picture.tone, &mut self.wanted)
        });
        Panel::top("look")
            .frame(bar)
            .show(ui, |ui| panels::look(ui, &mut self.picture, &self.rendering));
        CentralPanel::default().frame(Frame::NONE).show(ui, |ui| {
            let size = self.rendering.size();
            self.mouse = self.picture.show(ui, size, self.selection.pixel);
            let trail = self.selection.trail(&self.rendering);
            trail::paint(ui.painter(), &self.picture.placed(size), &trail);
        });
        if changed.inner || resampled.inner {
            self.rebuild(&ctx);
        }
        if let Some(pixel) = self.mouse.clicked {
            self.select(pixel);
        }
        self.step(ui);
        if let Some(wish) = wish.inner {
            self.grant(&ctx, wish);
        }

        self.picture.refresh(&ctx, &self.rendering, self.generation);
        self.selection.refresh(&ctx, &self.rendering, self.generation);
        if self.is_busy() {
            ctx.request_repaint_after(std::time::Duration::from_millis(50));
        }
    }

    /// The title tells from afar which scene it is and whether it is finished.
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
        if !self.picture.has_keys(ui.ctx()) {
            return;
        }
        let [dx, dy] = picture::arrow_step(ui);
        if [dx, dy] == [0, 0] {
            return;
        }
        let size @ [width, height] = self.rendering.size();
        let moved = |at: u32, by: i64, end: u32| (i64::from(at) + by).clamp(0, i64::from(end) - 1);
        let pixel = [moved(x, dx, width) as u32, moved(y, dy, height) as u32];
        self.select(pixel);
        self.picture.reveal(size, pixel);
    }

    fn grant(&mut self, ctx: &Context, wish: Wish) {
        match wish {
            Wish::Open(source) => self.open(ctx, source),
            Wish::Save(path) => {
                let (canvas, tone) = (self.rendering.canvas.clone(), self.picture.tone);
                self.saving.start(ctx, move || {
                    let written = film::write(&canvas.film(), &tone, &path);
                    written.map(|()| path).map_err(|error| error.to_string())
                });
            }
            Wish::Select(text) => match parse_pixel(&text) {
                Ok(pixel) => {
                    self.message = None;
                    self.select(pixel);
                    let size = self.rendering.size();
                    if self.selection.pixel == Some(pixel) {
                        self.picture.reveal(size, pixel);
                    }
                }
                Err(error) => self.message = Some((error, true)),
            },
        }
    }

    /// Builds the scene again as its switches stand.
    fn rebuild(&mut self, ctx: &Context) {
        let (source, scene) = (self.rendering.source.clone(), self.wanted.clone());
        self.loading.start(ctx, move || source.build(scene));
    }

    fn drop_files(&mut self, ctx: &Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().cloned());
        if let Some(file) = dropped {
            let path = file.path().to_owned();
            self.fields.open = path.display().to_string();
            self.open(ctx, Source::File(path));
        }
    }

    fn take_results(&mut self, ctx: &Context) {
        match self.loading.poll() {
            Some(Ok(Ok(loaded))) => self.take_scene(ctx, loaded),
            Some(Ok(Err(error))) => self.keep_scene(error),
            Some(Err(lost)) => self.keep_scene(lost.to_string()),
            None => {}
        }
        self.message = match self.saving.poll() {
            Some(Ok(Ok(path))) => Some((format!("saved {}", path.display()), false)),
            Some(Ok(Err(error))) => Some((error, true)),
            Some(Err(lost)) => Some((lost.to_string(), true)),
            None => self.message.take(),
        };
    }

    fn keep_scene(&mut self, error: String) {
        self.wanted = (*self.rendering.scene).clone();
        self.message = Some((error, true));
    }

    fn take_scene(&mut self, ctx: &Context, loaded: Loaded) {
        let same_scene = loaded.source.name() == self.rendering.source.name();
        let old_size = self.rendering.size();
        self.wanted = loaded.scene.clone();
        self.generation += 1;
        // the old rendering is dropped here, which stops it
        self.rendering = Rendering::start(ctx, loaded);
        if same_scene && self.rendering.size() == old_size {
            self.picture.begin_again();
        } else {
            self.picture = Picture::new(picture::tone_of(&self.rendering));
            self.selection = Selection::default();
            self.fields.pixel.clear();
        }
    }
}

/// Dark surroundings, against which colours are judged, and text that stands out from them.
pub fn set_style(ctx: &Context) {
    ctx.set_theme(Theme::Dark);
    ctx.style_mut_of(Theme::Dark, |style| {
        let widgets = &mut style.visuals.widgets;
        widgets.noninteractive.fg_stroke.color = Color32::from_gray(215);
        widgets.inactive.fg_stroke.color = Color32::from_gray(225);
        style.visuals.weak_text_color = Some(Color32::from_gray(165));
        style.visuals.error_fg_color = Color32::from_rgb(255, 120, 110);
        style.spacing.slider_width = 70.0;
    });
}

impl eframe::App for Inspector {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }
}
