//! The window: its state, its layout, and what each action does.

mod perform;

use std::time::Duration;

use eframe::egui::{self, CentralPanel, Context, Frame, Margin, Ui, Vec2, vec2};

use crate::action::{Action, Shows};
use crate::comparison::bar;
use crate::comparison::menu::CompareMenu;
use crate::comparison::opening;
use crate::comparison::others::Others;
use crate::comparison::theirs::Theirs;
use crate::explanation::panel::Panel;
use crate::explanation::selection::Selection;
use crate::explanation::{Shown, Subject};
use crate::picture::display::{self, Picture};
use crate::picture::saving::Saving;
use crate::picture::session::{Opened, Session};
use crate::picture::worker::Progress;
use crate::platform;
use crate::scene::source::Loaded;
use crate::scene::waiting::Broken;
use crate::space::view::SpaceView;
use crate::splits::part;
use crate::window::chooser::FileChooser;
use crate::window::frame::WindowFrame;
use crate::window::keys;
use crate::window::panels::{self, Fields};
use crate::window::picture_pane;
use crate::window::saved;
use crate::window::scene_panel::ScenePanel;
use crate::window::stored_settings::StoredSettings;

/// The whole state of the window. Its parts are lent to the bars and panels, which change what no other part shows and
/// return the rest as actions.
pub struct Inspector {
    /// The open scene and its picture.
    pub session: Session,
    /// The view of the picture.
    pub picture: Picture,
    /// The selected pixel.
    pub selection: Selection,
    /// What is shown of it.
    pub panel: Panel,
    /// The rays of the selected pixel in space.
    pub space: SpaceView,
    /// The pictures that ours can be compared with.
    pub others: Others,
    /// The text in the fields.
    pub fields: Fields,
    /// The message, and whether it is an error.
    pub message: Option<(String, bool)>,
    menu: CompareMenu,
    /// The file chooser.
    pub chooser: FileChooser,
    /// Whether it is a part of another page, without its bars.
    pub is_embedded: bool,
    saving: Saving,
    scene: ScenePanel,
    /// What is stored for a later run.
    pub settings: StoredSettings,
    is_showing_keys: bool,
    /// Whether a pixel of each scene that is opened is explained before one is selected.
    pub proposes: bool,
    /// The pixel under the mouse.
    hovered: Option<[u32; 2]>,
    frame: WindowFrame,
}

impl Inspector {
    /// Starts to render a scene.
    pub fn new(ctx: &Context, loaded: Loaded) -> Self {
        let session = Session::new(ctx, loaded);
        Self {
            picture: Picture::new(session.rendering.world.image.tone()),
            selection: Selection::default(),
            panel: Panel::default(),
            space: SpaceView::default(),
            others: Others::default(),
            fields: Fields::default(),
            message: None,
            menu: CompareMenu::default(),
            chooser: FileChooser::default(),
            is_embedded: false,
            saving: Saving::default(),
            scene: ScenePanel::default(),
            settings: StoredSettings::default(),
            is_showing_keys: false,
            proposes: false,
            hovered: None,
            frame: WindowFrame::default(),
            session,
        }
    }

    /// Shows the error of a scene file, and waits until it is mended.
    pub fn waiting_for(ctx: &Context, mut broken: Broken) -> Self {
        let mut inspector = Self::new(ctx, broken.placeholder());
        inspector.fields.open = broken.path.display().to_string();
        inspector.message = Some((broken.error.clone(), true));
        inspector.session.waiting = Some(broken);
        inspector
    }

    /// Whether anything is still being computed.
    pub fn is_busy(&self) -> bool {
        let rendering = &self.session.rendering;
        self.session.loading.is_busy()
            || self.saving.working.is_busy()
            || self.chooser.is_open()
            || self.selection.is_waiting()
            || self.panel.making.working.is_busy()
            || matches!(rendering.progress(), Progress::Running(..))
            || !self.picture.is_fresh(rendering)
            || self.space.is_busy()
            || self.others.is_busy(rendering)
    }

    /// Draws the window and performs what the user asks for.
    pub fn show(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.accept_finished(&ctx);
        // before anything is drawn, so that the tree is in the frame of the click
        self.follow_pointing(ui);
        for action in self.draw(ui) {
            self.perform(&ctx, action);
        }
        keys::list(&ctx, &mut self.is_showing_keys);
        self.start_wanted(&ctx);
        if self.selection.is_changed() {
            ctx.request_repaint();
        }
        if self.is_busy() {
            ctx.request_repaint_after(Duration::from_millis(50));
        }
    }

    /// Takes over what was finished beside the window since the last frame.
    fn accept_finished(&mut self, ctx: &Context) {
        match self.session.poll(ctx) {
            Some(Ok(opened)) => self.accept(ctx, opened),
            Some(Err(error)) => self.message = Some((error, true)),
            None => {}
        }
        self.message = self.saving.poll().or(self.message.take());
        let opened = self.others.accept_opened(ctx, &mut self.session);
        self.message = opened.or(self.message.take());
        for path in platform::dropped(ctx) {
            self.perform(ctx, opening::named(path));
        }
        self.session.follow_files(ctx);
        self.frame.refresh(ctx, &self.session.rendering);
        self.panel.making.refresh(ctx);
        self.selection.begin_frame();
    }

    /// Explains the pixel that is clicked, stepped to, or proposed.
    fn follow_pointing(&mut self, ui: &Ui) {
        if let Some(pixel) = self.picture.clicked(ui.ctx(), self.session.rendering.size()) {
            self.others.run_again();
            self.select(pixel);
        }
        // unless the arrow keys are needed elsewhere
        let has_keys = self.picture.has_keys(ui.ctx()) && !self.saving.is_asking();
        if let Some(pixel) = self.selection.pixel.filter(|_| has_keys)
            && let Some(next) = display::stepped(ui, pixel, self.session.rendering.size())
        {
            self.selection.keep_ray();
            self.reveal(next);
        }
        if let Some(pixel) = self.selection.again.take() {
            self.reveal(pixel);
        }
        if let Some(pixel) = self.selection.proposed() {
            // nobody asked for it, so that no message is answered by it
            let message = self.message.take();
            self.select(pixel);
            (self.message, self.selection.is_proposed) = (message, true);
        }
        self.selection.refresh(ui.ctx(), &self.session.rendering, &self.others);
    }

    /// Shows everything. Returns what the user asks for.
    fn draw(&mut self, ui: &mut Ui) -> Vec<Action> {
        let ctx = ui.ctx().clone();
        let of_bars = if self.is_embedded { Vec::new() } else { self.bars(ui) };
        let central = CentralPanel::default().frame(Frame::NONE);
        let mut actions = central.show(ui, |ui| self.parts(ui)).inner;
        // an opened scene replaces one that is built again
        actions.extend(of_bars);
        // before an action opens the question: the Enter that caused it must not answer it
        self.saving.ask(&ctx, &self.session.rendering, self.picture.tone);
        match self.chooser.chosen(&mut self.fields) {
            Some(Ok(action)) => actions.push(action),
            Some(Err(why)) => self.message = Some((why.to_owned(), false)),
            None => {}
        }
        if !self.saving.is_asking() {
            let is_text = !(self.picture.has_keys(&ctx) || self.space.has_keys(&ctx));
            actions.extend(keys::pressed(&ctx, is_text));
        }
        actions
    }

    /// Starts the work that is missing of what is shown.
    fn start_wanted(&mut self, ctx: &Context) {
        let rendering = &self.session.rendering;
        self.picture.refresh(ctx, rendering);
        let selected = self.selection.pixel;
        self.others.pixel = selected;
        if let Some(problem) = self.others.refresh(ctx, rendering) {
            self.message = Some((problem, true));
        }
        if let Some(theirs) = self.others.shown_mut() {
            theirs.refresh(ctx, rendering, self.picture.tone);
        }
        match self.others.first.take() {
            Some(place) if selected.is_none() => {
                self.seek(place);
                self.space.restart();
            }
            Some(place) if selected == Some(place.pixel) => self.selection.seek(place),
            _ => {}
        }
        self.selection.refresh(ctx, &self.session.rendering, &self.others);
    }

    /// Shows the bars at the top and the bottom.
    fn bars(&mut self, ui: &mut Ui) -> Vec<Action> {
        let (rendering, mut actions) = (&self.session.rendering, Vec::new());
        let shown = (&self.picture, self.others.shown());
        self.fields.propose(saved::proposed_name(shown, rendering));
        let bar = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(8, 4));
        egui::Panel::top("files").frame(bar).show(ui, |ui| {
            let source = &rendering.source;
            actions.extend(panels::files(ui, &mut self.fields, source));
        });
        egui::Panel::bottom("status").frame(bar).show(ui, |ui| {
            let theirs = self.others.shown();
            let loading = self.session.loading.is_busy().then_some(&*self.session.what.0);
            let loading = loading.or(self.others.reading());
            let shown = (theirs, &self.picture.layer);
            let pointed = (self.hovered, self.selection.is_proposed);
            actions.extend(panels::status(ui, rendering, shown, pointed, loading));
        });
        egui::Panel::top("view").frame(bar).show(ui, |ui| {
            let (theirs, mode) = (self.others.shown_mut(), &mut self.space.mode);
            let shown = (rendering, self.selection.pixel);
            panels::view_settings(ui, &mut self.picture, theirs, mode, shown);
        });
        if self.session.waiting.is_none() {
            let (menu, others) = (&mut self.menu, &mut self.others);
            let bar = egui::Panel::top("comparison").frame(bar);
            bar.show(ui, |ui| actions.extend(bar::show(ui, menu, others, rendering)));
        }
        panels::message(ui.ctx(), &mut self.message);
        actions
    }

    /// Shows the scene, the picture and the explanation, side by side.
    fn parts(&mut self, ui: &mut Ui) -> Vec<Action> {
        if self.session.waiting.is_some() {
            let text = "The picture follows when the scene file is mended.";
            ui.centered_and_justified(|ui| ui.weak(text));
            return Vec::new();
        }
        let (scene, [picture, explanation]) = self.settings.splits.show(ui, ui.max_rect());
        for area in scene.into_iter().chain([explanation, picture]) {
            ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
        }
        let margin = vec2(8.0, 6.0);
        let mut pointed = None;
        let is_changed = scene.is_some_and(|area| {
            let panel =
                |ui: &mut Ui| self.scene.show(ui, &mut self.session, &self.others, &mut pointed);
            part(ui, "scene", area, margin, panel)
        });
        let is_resampled = part(ui, "explanation", explanation, margin, |ui| {
            let Session { rendering, wanted, .. } = &mut self.session;
            let (theirs, tone) = (self.others.shown(), &self.picture.tone);
            let (beside, view) = (self.others.beside(), self.space.mode);
            let shown = Shown { rendering, theirs, beside, tone, view };
            self.panel.show(ui, &mut self.selection, &shown, wanted, &mut self.settings.splits)
        });
        self.space.pointed = pointed;
        let [of_picture, of_space] = self.space.mode.divide(picture);
        self.hovered = None;
        let mut actions = Vec::new();
        let Self { picture, others, selection, space, .. } = self;
        let rendering = &self.session.rendering;
        if let Some(area) = of_picture {
            let show =
                |ui: &mut Ui| picture_pane::show(ui, area, picture, others, selection, rendering);
            let (hovered, framed) = part(ui, "picture", area, Vec2::ZERO, show);
            self.hovered = hovered;
            actions.extend(framed);
            if self.session.is_old {
                panels::mark_old(ui, area);
            }
        }
        if let Some(area) = of_space {
            let program = others.shown().and_then(Theirs::explained);
            let is_both = others.shown().is_some_and(|theirs| theirs.shows == Shows::Swipe)
                || selection.pinned.is_some();
            let subject = (&Subject { rendering, program }, is_both);
            let show = |ui: &mut Ui| space.show(ui, area, subject, selection);
            part(ui, "space", area, Vec2::ZERO, show);
        }
        actions.extend((is_changed || is_resampled).then_some(Action::Rebuild));
        actions
    }

    /// Shows a scene that was opened; keeps what still belongs to it.
    fn accept(&mut self, ctx: &Context, opened: Opened) {
        let rendering = &self.session.rendering;
        self.message = None;
        if opened.is_same_view {
            self.picture.restart();
        } else {
            self.picture = Picture::new(rendering.world.image.tone());
        }
        let [width, height] = rendering.size();
        let is_outside = |[x, y]: [u32; 2]| x >= width || y >= height;
        if !opened.is_same_scene || self.selection.pixel.is_some_and(is_outside) {
            (self.selection, self.panel) = (Selection::default(), Panel::default());
            self.fields.pixel.clear();
        }
        if !opened.is_same_scene {
            self.space.restart();
            // a name that was typed was for the other scene
            self.fields.save.clone_from(&self.fields.proposed);
            self.others.forget_logs();
            match opened.rays {
                Some(path) => self.others.add_log(path),
                None if self.proposes => self.selection.propose(ctx, rendering),
                None => {}
            }
        }
        let last = rendering.world.samples_per_pixel() - 1;
        self.selection.sample = self.selection.sample.min(last);
        if let Some((pixel, sample)) = opened.asked {
            self.explain(pixel, sample);
        }
    }
}

impl eframe::App for Inspector {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.settings.write(storage);
    }
}
