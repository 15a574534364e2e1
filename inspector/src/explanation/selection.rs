//! The selected pixel: its samples, their sum, and the selected ray.

use std::collections::BTreeMap;
use std::sync::Arc;

use eframe::egui::{self, Frame, Key, Margin, Panel, ScrollArea, Ui, vec2};
use groundtruth::explain::{self, PixelExplanation, RecordedRay, SampleExplanation};
use groundtruth::film::Tone;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rays::{Logged, RayPlace};

use crate::comparison::theirs::Theirs;
use crate::explanation::asked::{Asked, Question, sample_of};
use crate::explanation::beside::Beside;
use crate::explanation::copying::Making;
use crate::explanation::pixel::{self, Order, SumList};
use crate::explanation::samples::{Linked, Samples};
use crate::explanation::section::SectionView;
use crate::explanation::trail::{self, TrailPoint};
use crate::explanation::tree::{self, Tree};
use crate::explanation::values::ValuesView;
use crate::explanation::why_not::WhyNotView;
use crate::explanation::{Shown, Subject, checks, details, proposal, verdict_text};
use crate::picture::display;
use crate::picture::worker::{Background, Rendering};
use crate::splits::{Splits, part};

/// The least height of tree and details in a low window, in points of the screen.
const MIN_HEIGHT: f32 = 24.0;

/// The least height with room for the legend of the tree's colours, in points of the screen.
const LEGEND_MIN_HEIGHT: f32 = 160.0;

/// The selected pixel and why it has its colour.
#[derive(Default)]
pub struct Selection {
    /// The pixel.
    pub pixel: Option<[u32; 2]>,
    /// The sample whose tree is shown.
    pub sample: u32,
    /// Its tree, and the ray whose details are shown.
    pub tree: Tree,
    /// The order of the list of samples.
    pub order: Order,
    /// The part that is shown below the tree.
    pub tab: Tab,
    /// The samples, when they are below the tree.
    pub samples: Samples,
    /// The sample that is pointed at in this frame, and that of the last one, whose tree is shown meanwhile.
    pointed: Option<u32>,
    previewed: Option<u32>,
    section: SectionView,
    why_not: WhyNotView,
    making: Making,
    /// Why a page or a test could not be made.
    problem: Option<String>,
    /// Whether the pixel was proposed, and not chosen by the user.
    pub is_proposed: bool,
    asked: Asked,
    /// The same pixel of the other one of two pictures that can be explained.
    beside: Asked,
    numbers: Beside,
    proposing: Background<[u32; 2]>,
    values: ValuesView,
    /// The number of a ray that is selected once its tree is there.
    sought: Option<usize>,
    /// The tree whose rays are known by their numbers, and their indices in its log.
    logged: Option<(Question, BTreeMap<usize, usize>)>,
}

/// The part that is shown below the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Tab {
    /// The selected ray.
    #[default]
    Ray,
    /// The plane of incidence of the selected ray's hit.
    Section,
    /// The contributions to the pixel: sources of light, and samples by value.
    Sum,
    /// The positions of the pixel's samples.
    Samples,
    /// The verdict on the picture that ours is compared with, once there is one.
    Verdict,
    /// What the laws found in the log of rays that is shown.
    Checks,
    /// The selected ray in both of two pictures that can be explained.
    #[value(skip)]
    Beside,
}

impl Selection {
    /// Starts to explain the selected pixel of the picture that is shown, and of the other one, unless that is done or under
    /// way. Waits for a short explanation.
    pub fn refresh(&mut self, ctx: &egui::Context, rendering: &Rendering, theirs: Option<&Theirs>) {
        if let Some(problem) = self.making.refresh(ctx) {
            self.problem = Some(problem);
        }
        let shown = Subject { rendering, program: theirs.and_then(Theirs::explained) };
        let program = theirs.and_then(|theirs| theirs.program.as_ref());
        let other = Subject { rendering, program: program.filter(|_| shown.program.is_none()) };
        let asked = self.pixel.map(|pixel| (pixel, self.sample));
        if self.beside.version() == Some(shown.version()) {
            // the pictures were flipped
            std::mem::swap(&mut self.asked, &mut self.beside);
        }
        self.asked.refresh(ctx, &shown, asked);
        self.beside.refresh(ctx, &other, asked.filter(|_| program.is_some()));
        self.read_off(shown.log());
        if let Some(number) = self.sought.take_if(|_| self.asked.pixel() == self.pixel) {
            self.go_to(number);
        }
    }

    /// Notes which rays of a log the tree has, and what the laws found of them.
    fn read_off(&mut self, log: Option<&Logged>) {
        let question = log.and(self.root()).map(|(question, _)| question);
        if question == self.logged.as_ref().map(|(of, _)| *of) {
            return;
        }
        let both = log.zip(question);
        let found = both.map(|(log, of)| log.findings(of.pixel, of.sample)).unwrap_or_default();
        self.tree.found = Arc::new(found);
        self.logged = both.map(|(log, of)| (of, log.tree(of.pixel, of.sample)));
    }

    /// Selects a ray of a log, once its pixel is explained.
    pub fn seek(&mut self, RayPlace { pixel, sample, number }: RayPlace) {
        (self.pixel, self.sample, self.is_proposed) = (Some(pixel), sample, false);
        self.sought = Some(number);
    }

    /// Starts to look for a pixel that is worth explaining.
    pub fn propose(&mut self, ctx: &egui::Context, rendering: &Rendering) {
        let world = Arc::clone(&rendering.world);
        self.proposing.start(ctx, move || proposal::interesting(&world));
    }

    /// The pixel that was found, returned once, unless one is selected.
    pub fn proposed(&mut self) -> Option<[u32; 2]> {
        let found = self.proposing.poll()?.ok();
        found.filter(|_| self.pixel.is_none())
    }

    /// The explanation, if it is finished.
    pub fn explanation(&self) -> Option<&PixelExplanation> {
        self.asked.explanation()
    }

    /// The explanation of the other one of two pictures, if it is finished.
    pub fn explanation_beside(&self) -> Option<&PixelExplanation> {
        self.beside.explanation()
    }

    /// The camera's ray of the selected sample, and the question that its tree answers; not that of another pixel.
    pub fn root(&self) -> Option<(Question, &RecordedRay)> {
        self.asked
            .root(self.shown_sample())
            .filter(|(question, _)| self.pixel == Some(question.pixel))
    }

    /// The same of the other one of two pictures.
    pub fn root_beside(&self) -> Option<(Question, &RecordedRay)> {
        self.beside.root(self.shown_sample())
    }

    /// The sample whose tree is shown: the one that is pointed at, if it is explained, or the chosen one.
    fn shown_sample(&self) -> u32 {
        let is_explained = |sample: &u32| {
            self.explanation().is_some_and(|answer| sample_of(answer, *sample).is_some())
        };
        self.previewed.filter(is_explained).unwrap_or(self.sample)
    }

    /// Begins a frame: what was pointed at in the last one is lit in this one.
    pub fn begin_frame(&mut self) {
        self.tree.lit = self.tree.hovered.take();
        self.previewed = self.pointed.take();
    }

    /// Whether the next frame looks other than this one, because something else is pointed at.
    pub fn is_changed(&self) -> bool {
        (self.tree.hovered, self.pointed) != (self.tree.lit, self.previewed)
    }

    /// Selects a pixel of a picture of this size.
    ///
    /// # Errors
    /// The picture has no such pixel.
    pub fn select(
        &mut self,
        pixel @ [x, y]: [u32; 2],
        [width, height]: [u32; 2],
    ) -> Result<(), String> {
        if x >= width || y >= height {
            return Err(format!("pixel ({x}, {y}) is outside the picture of {width} × {height}"));
        }
        if self.pixel != Some(pixel) {
            self.tree = Tree::default();
        }
        (self.pixel, self.is_proposed) = (Some(pixel), false);
        Ok(())
    }

    /// Selects a ray of the tree and scrolls to it.
    pub fn go_to(&mut self, number: usize) {
        let mut tree = std::mem::take(&mut self.tree);
        if let Some((_, root)) = self.root() {
            tree.go_to(root, number);
        }
        self.tree = tree;
    }

    /// The hits along the path to the selected ray, projected into the picture.
    pub fn trail(&self, world: &World) -> Vec<TrailPoint> {
        self.root().map_or(Vec::new(), |(Question { pixel, .. }, root)| {
            trail::points(world, pixel, root, self.tree.ray)
        })
    }

    /// Whether the selected pixel is not explained yet.
    pub fn is_waiting(&self) -> bool {
        let current = self.asked.pixel();
        self.asked.is_busy()
            || self.beside.is_busy()
            || self.proposing.is_busy()
            || self.making.is_busy()
            || current != self.pixel
    }

    /// Shows the explanation; returns whether `wanted` was changed.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        shown: &Shown<'_>,
        wanted: &mut Scene,
        splits: &mut Splits,
    ) -> bool {
        let answer = match self.asked.outcome() {
            Some(Ok(explanation)) => Arc::clone(explanation),
            Some(Err(error)) => {
                ui.colored_label(ui.visuals().error_fg_color, error);
                return false;
            }
            None => {
                ui.heading("No pixel selected");
                ui.label("Click a pixel of the picture, or type its coordinates above.");
                return false;
            }
        };
        let inner = Frame::new().inner_margin(Margin::symmetric(0, 4));
        Panel::top("pixel").frame(inner).show(ui, |ui| self.head(ui, &answer, shown));
        let sample = sample_of(&answer, self.shown_sample());
        let [above, below] = splits.show_lower(ui, ui.available_rect_before_wrap());
        let margin = vec2(0.0, 4.0);
        part(ui, "tree", above, margin, |ui| match sample {
            Some(sample) => self.sample_tree(ui, sample, shown.tone),
            None => drop(ui.spinner()),
        });
        part(ui, "details", below, margin, |ui| self.details(ui, &answer, shown, wanted))
    }

    /// Shows what is below the tree; returns whether `wanted` was changed.
    fn details(
        &mut self,
        ui: &mut Ui,
        answer: &PixelExplanation,
        shown: &Shown<'_>,
        wanted: &mut Scene,
    ) -> bool {
        let verdict = shown.theirs.and_then(|theirs| theirs.judgement.verdict());
        ui.horizontal_wrapped(|ui| {
            ui.selectable_value(&mut self.tab, Tab::Ray, "The ray");
            ui.selectable_value(&mut self.tab, Tab::Section, "The section");
            ui.selectable_value(&mut self.tab, Tab::Sum, "The sum");
            ui.selectable_value(&mut self.tab, Tab::Samples, "The samples");
            match verdict {
                Some(_) => drop(ui.selectable_value(&mut self.tab, Tab::Verdict, "The verdict")),
                None if self.tab == Tab::Verdict => self.tab = Tab::default(),
                None => {}
            }
            if shown.subject().log().is_some() {
                let tab = ui.selectable_value(&mut self.tab, Tab::Checks, "Checks");
                tab.on_hover_text("The laws that the rays are held to");
            } else if self.tab == Tab::Checks {
                self.tab = Tab::default();
            }
            if shown.theirs.is_some_and(Theirs::is_twin) {
                let tab = ui.selectable_value(&mut self.tab, Tab::Beside, "Side by side");
                tab.on_hover_text("The selected ray in both pictures, number by number");
            } else if self.tab == Tab::Beside {
                self.tab = Tab::default();
            }
        });
        let area = ScrollArea::both().id_salt("details").auto_shrink(false);
        let area = area.min_scrolled_height(MIN_HEIGHT);
        let (tone, chosen) = (shown.tone, &mut self.sample);
        match self.tab {
            Tab::Ray => drop(area.show(ui, |ui| self.ray_details(ui, shown))),
            Tab::Checks => {
                let log = shown.subject().log();
                let place = area.show(ui, |ui| log.and_then(|log| checks::show(ui, log))).inner;
                place.into_iter().for_each(|place| self.seek(place));
            }
            Tab::Beside => drop(area.show(ui, |ui| self.side_by_side(ui, shown))),
            Tab::Verdict => drop(area.show(ui, |ui| verdict.map(|it| verdict_text::show(ui, it)))),
            Tab::Section => self.section_of_ray(ui, &shown.subject().built().world),
            Tab::Sum => {
                let (order, pointed) = (&mut self.order, &mut self.pointed);
                SumList { answer, tone, order, chosen, pointed }.show(ui, area);
            }
            Tab::Samples if shown.subject().log().is_some() => {
                let log = shown.subject().log();
                let values = |ui: &mut Ui| self.values.show(ui, log?, answer.pixel);
                area.show(ui, values).inner.into_iter().for_each(|place| self.seek(place));
            }
            Tab::Samples => {
                return area.show(ui, |ui| self.samples_of(ui, shown, answer, wanted)).inner;
            }
        }
        false
    }

    /// Asks why the selected ray does not hit an object.
    pub fn ask_why_not(&mut self, object: u32) {
        (self.tab, self.why_not.object) = (Tab::Ray, Some(object));
    }

    fn ray_details(&mut self, ui: &mut Ui, shown: &Shown<'_>) {
        let mut why_not = std::mem::take(&mut self.why_not);
        let (mut clicked, mut hovered) = (None, None);
        if let Some((question, root)) = self.root() {
            let ray = self.tree.selected(root);
            details::head(ui, ray);
            if let (Some(log), Some((_, indices))) = (shown.subject().log(), &self.logged) {
                indices.get(&ray.number).into_iter().for_each(|&index| checks::ray(ui, log, index));
            }
            why_not.show(ui, &shown.subject(), (question, root), ray.number);
            if shown.subject().log().is_none() {
                clicked = details::show(ui, ray, &mut hovered);
            }
        }
        self.why_not = why_not;
        self.tree.hovered = self.tree.hovered.or(hovered);
        if let Some(number) = clicked {
            self.go_to(number);
        }
    }

    /// Shows the selected ray of both pictures: ours at the left, whichever tree is above.
    fn side_by_side(&mut self, ui: &mut Ui, shown: &Shown<'_>) {
        let mut numbers = std::mem::take(&mut self.numbers);
        let program = shown.theirs.and_then(|theirs| theirs.program.as_ref());
        let is_ours = shown.subject().program.is_none();
        match (self.root(), self.root_beside(), program) {
            (Some(this), Some(other), Some(program)) => {
                numbers.show(ui, [this, other], self.tree.ray, (is_ours, &program.name));
            }
            _ => {
                ui.weak("One of the pictures has no ray here, or is not explained yet.");
            }
        }
        self.numbers = numbers;
    }

    /// Shows the samples of the pixel; returns whether `wanted` was changed.
    fn samples_of(
        &mut self,
        ui: &mut Ui,
        shown: &Shown<'_>,
        answer: &PixelExplanation,
        wanted: &mut Scene,
    ) -> bool {
        let (mut samples, mut chosen) = (std::mem::take(&mut self.samples), self.sample);
        let root = self.root().map(|(_, root)| root);
        let mut linked = Linked { root, lit: self.tree.lit, ..Linked::default() };
        let changed = samples.show(ui, (shown, answer), &mut chosen, &mut linked, wanted);
        let Linked { sample, ray, .. } = linked;
        (self.samples, self.sample, self.pointed) = (samples, chosen, sample);
        self.tree.hovered = self.tree.hovered.or(ray);
        changed
    }

    fn section_of_ray(&mut self, ui: &mut Ui, world: &World) {
        let mut section = std::mem::take(&mut self.section);
        let (broken, mut hovered) = (Arc::clone(&self.tree.found), None);
        match self.root() {
            Some(tree) => {
                let ray = self.tree.selected(tree.1);
                // where it leaves a surface both it and the ray that sent it are seen
                let leaves = broken.contains_key(&ray.number) && ray.light.is_none();
                let number = ray.parent.filter(|_| leaves).unwrap_or(ray.number);
                section.show(ui, world, tree, number, &broken, &mut hovered);
            }
            None => drop(ui.weak("no ray")),
        }
        self.section = section;
        self.tree.hovered = self.tree.hovered.or(hovered);
    }

    fn sample_tree(&mut self, ui: &mut Ui, sample: &SampleExplanation, tone: &Tone) {
        let index = sample.index;
        let Some(root) = &sample.ray else {
            ui.strong(format!("Sample {index}"));
            ui.label("No ray: the camera sees nothing there.");
            return;
        };
        let film = sample.film;
        let film =
            film.map_or(String::new(), |[x, y]| format!(", at ({x:.4}, {y:.4}) on the view plane"));
        ui.horizontal_wrapped(|ui| {
            ui.strong(format!("Sample {index}"));
            let rays = explain::count(root.count(), "ray");
            ui.weak(rays + &film);
            let follow = ui.small_button("Follow the largest (L)");
            let hint = "Steps down the path along which most of the light comes";
            let key = !ui.ctx().text_edit_focused() && ui.input(|input| input.key_pressed(Key::L));
            if follow.on_hover_text(hint).clicked() || key {
                self.tree.follow_largest(root);
            }
        });
        // no legend in a low window: each line names its kind of ray too
        if ui.available_height() > LEGEND_MIN_HEIGHT {
            tree::legend(ui);
        }
        self.tree.show(ui, root, tone);
    }

    fn head(&mut self, ui: &mut Ui, answer: &PixelExplanation, shown: &Shown<'_>) {
        let [x, y] = answer.pixel;
        ui.horizontal_wrapped(|ui| {
            tree::swatch(ui, display::color(shown.tone, answer.radiance));
            ui.heading(format!("Pixel ({x}, {y})"));
            if self.is_waiting() {
                ui.spinner();
            }
            let last = answer.samples_per_pixel - 1;
            if last > 0 {
                ui.separator();
                pixel::chooser(ui, &mut self.sample, last);
            }
            ui.separator();
            let root = sample_of(answer, self.sample).and_then(|sample| sample.ray.as_ref());
            let ray = root.map(|root| self.tree.selected(root));
            pixel::copy_menu(ui, shown, answer, self.sample.min(last), ray, &mut self.making);
        });
        if let Some(problem) = &self.problem {
            ui.colored_label(ui.visuals().error_fg_color, problem);
        }
        if self.is_proposed {
            ui.weak("A pixel with many rays, to begin with. Click any other one.");
        }
        for note in &answer.notes {
            ui.weak(note);
        }
        pixel::sum(ui, answer, shown);
        if let Some(theirs) = shown.theirs.filter(|_| shown.subject().has_camera()) {
            pixel::theirs(ui, answer.pixel, theirs, shown);
        }
    }
}
