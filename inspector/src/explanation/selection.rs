//! The selected pixel: its samples, their sum, and the selected ray.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{self, Frame, Key, Margin, Panel, RichText, ScrollArea, Ui, vec2};
use groundtruth::explain::{self, PixelExplanation, RecordedRay, SampleExplanation};
use groundtruth::film::Tone;
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use groundtruth::trace::RayBudget;
use groundtruth::world::World;
use judge::mistakes::Mistaken;
use judge::verdict::Verdict;

use crate::explanation::copying::{self, Making};
use crate::explanation::pixel::{self, Order, SumList};
use crate::explanation::samples::Samples;
use crate::explanation::section::SectionView;
use crate::explanation::trail::{self, TrailPoint};
use crate::explanation::tree::{self, Tree};
use crate::explanation::why_not::WhyNotView;
use crate::explanation::{Shown, details, proposal};
use crate::picture::display;
use crate::picture::worker::{Background, Lost, Rendering};
use crate::splits::{Splits, part};

/// The most rays of a pixel whose samples are explained together; with more, one at a time.
const MAX_RAYS_PER_PIXEL: u64 = 30_000;
/// The most rays of a sample that is explained: a larger tree would be unreadable and take gigabytes.
const MAX_RAYS_PER_SAMPLE: u64 = 500_000;

/// The least height of tree and details in a low window, in points of the screen.
const MIN_HEIGHT: f32 = 24.0;

/// The longest wait for an explanation, which is then drawn in the frame of the click.
const MAX_WAIT: Duration = Duration::from_millis(12);
/// The least height with room for the legend of the tree's colours, in points of the screen.
const LEGEND_MIN_HEIGHT: f32 = 160.0;

/// The pixel and sample to explain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question {
    /// The number of the rendering.
    generation: u64,
    pixel: [u32; 2],
    sample: u32,
    /// The mistake of the program that is explained, if it is not ours.
    mistake: Option<&'static str>,
}

type Explained = Result<Arc<PixelExplanation>, String>;

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
    section: SectionView,
    why_not: WhyNotView,
    making: Making,
    /// Why a page or a test could not be made.
    problem: Option<String>,
    /// Whether the pixel was proposed, and not chosen by the user.
    pub is_proposed: bool,
    answered: Option<(Question, Explained)>,
    working: Background<(Question, Explained)>,
    proposing: Background<[u32; 2]>,
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
}

/// Explains all samples, or only the one asked for if all would be too many rays.
fn answer(scene: &Scene, renderer: &impl Renderer, question: Question) -> Explained {
    let mut budget = RayBudget::up_to(MAX_RAYS_PER_SAMPLE);
    renderer.sample(question.pixel, question.sample, &mut (), &mut budget);
    budget.check(|| format!("sample {}", question.sample)).map_err(|e| e.to_string())?;
    let all = budget.spent().saturating_mul(renderer.world().samples_per_pixel().into());
    let few = all <= MAX_RAYS_PER_PIXEL;
    let only = if few { None } else { Some(question.sample) };
    let explained = explain::pixel(scene, renderer, question.pixel, only);
    explained.map(Arc::new).map_err(|e| e.to_string())
}

impl Selection {
    /// Starts to explain the selected pixel, unless that is done or under way. Waits for a short
    /// explanation.
    pub fn refresh(
        &mut self,
        ctx: &egui::Context,
        rendering: &Rendering,
        mistaken: Option<&Arc<Mistaken>>,
    ) {
        if let Some(problem) = self.making.refresh(ctx) {
            self.problem = Some(problem);
        }
        let finished = self.working.poll();
        let mistake = mistaken.map(|program| program.mistake().name);
        let Some(question) = self.question(rendering, mistake) else {
            self.answered = None;
            return;
        };
        self.accept(finished, question);
        if self.working.is_busy() || self.answers(question) {
            return;
        }
        let (scene, world) = (Arc::clone(&rendering.scene), Arc::clone(&rendering.world));
        let mistaken = mistaken.map(Arc::clone);
        self.working.start(ctx, move || {
            let answer = match mistaken {
                None => answer(&scene, &*world, question),
                Some(program) => answer(&program.scene, &*program, question),
            };
            (question, answer)
        });
        let finished = self.working.wait(MAX_WAIT);
        self.accept(finished, question);
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

    fn accept(&mut self, finished: Option<Result<(Question, Explained), Lost>>, asked: Question) {
        match finished {
            Some(Ok((question, answer))) if question.generation == asked.generation => {
                self.answered = Some((question, answer));
            }
            // not asked again: the same question would fail again
            Some(Err(lost)) => self.answered = Some((asked, Err(lost.to_string()))),
            Some(Ok(_)) | None => {}
        }
    }

    fn question(&self, rendering: &Rendering, mistake: Option<&'static str>) -> Option<Question> {
        let last = rendering.world.samples_per_pixel() - 1;
        let (generation, sample) = (rendering.generation, self.sample.min(last));
        self.pixel.map(|pixel| Question { generation, pixel, sample, mistake })
    }

    fn answers(&self, question: Question) -> bool {
        let Some((answered, answer)) = &self.answered else { return false };
        let has_it = answer.as_ref().is_ok_and(|explanation| {
            explanation.samples.iter().any(|sample| sample.index == question.sample)
        });
        let same_pixel = Question { sample: question.sample, ..*answered } == question;
        *answered == question || (same_pixel && has_it)
    }

    /// The explanation, if it is finished.
    pub fn explanation(&self) -> Option<&PixelExplanation> {
        self.answered.as_ref()?.1.as_deref().ok()
    }

    /// The camera's ray of the selected sample, and the question that its tree answers; not that of another pixel.
    pub fn root(&self) -> Option<(Question, &RecordedRay)> {
        let (question, _) = self.answered.as_ref()?;
        let sample = self.sample_of(self.explanation()?)?;
        let is_current = self.pixel == Some(question.pixel);
        let root = sample.ray.as_ref().filter(|_| is_current)?;
        Some((Question { sample: sample.index, ..*question }, root))
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
    pub fn trail(&self, rendering: &Rendering) -> Vec<TrailPoint> {
        self.root().map_or(Vec::new(), |(Question { pixel, .. }, root)| {
            trail::points(&rendering.world, pixel, root, self.tree.ray)
        })
    }

    /// Whether the selected pixel is not explained yet.
    pub fn is_waiting(&self) -> bool {
        let current = self.answered.as_ref().map(|(question, _)| question.pixel);
        self.working.is_busy()
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
        let answer = match &self.answered {
            Some((_, Ok(explanation))) => Arc::clone(explanation),
            Some((_, Err(error))) => {
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
        let sample = self.sample_of(&answer);
        let [above, below] = splits.show_lower(ui, ui.available_rect_before_wrap());
        let margin = vec2(0.0, 4.0);
        part(ui, "tree", above, margin, |ui| match sample {
            Some(sample) => self.sample_tree(ui, sample, shown.tone),
            None => drop(ui.spinner()),
        });
        part(ui, "details", below, margin, |ui| self.details(ui, &answer, shown, wanted))
    }

    /// The sample whose tree is shown, if it is explained.
    fn sample_of<'a>(&self, answer: &'a PixelExplanation) -> Option<&'a SampleExplanation> {
        let index = self.sample.min(answer.samples_per_pixel - 1);
        answer.samples.iter().find(|sample| sample.index == index)
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
        });
        let area = ScrollArea::both().id_salt("details").auto_shrink(false);
        let area = area.min_scrolled_height(MIN_HEIGHT);
        let (tone, chosen) = (shown.tone, &mut self.sample);
        match self.tab {
            Tab::Ray => drop(area.show(ui, |ui| self.ray_details(ui, shown.rendering))),
            Tab::Verdict => drop(area.show(ui, |ui| verdict.map(|verdict| read(ui, verdict)))),
            Tab::Section => self.section_of_ray(ui, &shown.rendering.world),
            Tab::Sum => SumList { answer, tone, order: &mut self.order, chosen }.show(ui, area),
            Tab::Samples => {
                let show = |ui: &mut Ui| self.samples.show(ui, shown, answer, chosen, wanted);
                return area.show(ui, show).inner;
            }
        }
        false
    }

    /// Asks why the selected ray does not hit an object.
    pub fn ask_why_not(&mut self, object: u32) {
        (self.tab, self.why_not.object) = (Tab::Ray, Some(object));
    }

    fn ray_details(&mut self, ui: &mut Ui, rendering: &Rendering) {
        let mut why_not = std::mem::take(&mut self.why_not);
        let (mut clicked, mut hovered) = (None, None);
        if let Some((question, root)) = self.root() {
            let ray = self.tree.selected(root);
            details::head(ui, ray);
            why_not.show(ui, rendering, (question, root), ray.number);
            clicked = details::show(ui, ray, &mut hovered);
        }
        self.why_not = why_not;
        self.tree.hovered = self.tree.hovered.or(hovered);
        if let Some(number) = clicked {
            self.go_to(number);
        }
    }

    fn section_of_ray(&mut self, ui: &mut Ui, world: &World) {
        let mut section = std::mem::take(&mut self.section);
        let (selected, mut hovered) = (self.tree.ray, None);
        match self.root() {
            Some(tree) => section.show(ui, world, tree, selected, &mut hovered),
            None => drop(ui.weak("no ray")),
        }
        self.section = section;
        self.tree.hovered = self.tree.hovered.or(hovered);
    }

    fn sample_tree(&mut self, ui: &mut Ui, sample: &SampleExplanation, tone: &Tone) {
        let index = sample.index;
        let (Some(root), Some([x, y])) = (&sample.ray, sample.film) else {
            ui.strong(format!("Sample {index}"));
            ui.label("No ray: the camera sees nothing there.");
            return;
        };
        ui.horizontal_wrapped(|ui| {
            ui.strong(format!("Sample {index}"));
            let rays = explain::count(root.count(), "ray");
            ui.weak(format!("{rays}, at ({x:.4}, {y:.4}) on the view plane"));
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
            let mistake = self.answered.as_ref().and_then(|(question, _)| question.mistake);
            let with = mistake.map_or(String::new(), |name| format!(" with {name}"));
            ui.heading(format!("Pixel ({x}, {y}){with}"));
            if self.is_waiting() {
                ui.spinner();
            }
            let last = answer.samples_per_pixel - 1;
            if last > 0 {
                ui.separator();
                pixel::chooser(ui, &mut self.sample, last);
            }
            ui.separator();
            let root = self.sample_of(answer).and_then(|sample| sample.ray.as_ref());
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
        pixel::sum(ui, answer, shown.radiance(answer.pixel));
        if let Some(theirs) = shown.theirs {
            pixel::theirs(ui, answer.pixel, theirs, shown);
        }
    }
}

/// Shows a verdict as the command prints it, to be read, selected and copied.
fn read(ui: &mut Ui, verdict: &Verdict) {
    let text = verdict.to_string();
    ui.horizontal(|ui| {
        if ui.small_button("Copy the verdict").clicked() {
            ui.ctx().copy_text(text.clone());
            copying::set_copied(ui.ctx());
        }
        copying::show_copied(ui);
    });
    ui.label(RichText::new(text).monospace().size(12.0));
}
