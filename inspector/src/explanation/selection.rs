//! The selected pixel: its samples, their sum, and the selected ray.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{self, Frame, Key, Margin, Panel, Rect, ScrollArea, Ui, UiBuilder, vec2};
use groundtruth::explain::{self, PixelExplanation, RecordedRay, SampleExplanation};
use groundtruth::film::Tone;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::RayBudget;
use groundtruth::world::World;

use crate::comparison::theirs::Theirs;
use crate::explanation::details;
use crate::explanation::pixel::{self, Order};
use crate::explanation::samples::Samples;
use crate::explanation::trail::{self, TrailPoint};
use crate::explanation::tree::{self, Tree};
use crate::picture::display;
use crate::picture::worker::{Background, Lost, Rendering};
use crate::window::splits::Splits;

/// A pixel with more rays is explained one sample at a time.
const MAX_RAYS_PER_PIXEL: u64 = 30_000;
/// A sample with more rays is not explained: its tree would be unreadable and take gigabytes.
const MAX_RAYS_PER_SAMPLE: u64 = 500_000;

/// The least height of tree and details in a low window, in points of the screen.
const MIN_HEIGHT: f32 = 24.0;

/// An explanation that takes at most this time is drawn in the frame of the click.
const MAX_WAIT: Duration = Duration::from_millis(12);
/// The least height with room for the legend of the tree's colours, in points of the screen.
const LEGEND_MIN_HEIGHT: f32 = 160.0;

/// The pixel and sample to explain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Question {
    generation: u64,
    pixel: [u32; 2],
    sample: u32,
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
    /// How the list of samples is sorted.
    pub order: Order,
    /// The part that is shown below the tree.
    pub tab: Tab,
    /// The samples, when they are below the tree.
    pub samples: Samples,
    answered: Option<(Question, Explained)>,
    working: Background<(Question, Explained)>,
}

/// The part that is shown below the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The selected ray.
    #[default]
    Ray,
    /// The contributions to the pixel: sources of light, and samples by value.
    Sum,
    /// The positions of the pixel's samples.
    Samples,
}

/// Explains all samples, or only the one asked for if all would be too many rays.
fn answer(scene: &Scene, world: &World, question: Question) -> Explained {
    let mut budget = RayBudget::up_to(MAX_RAYS_PER_SAMPLE);
    render::sample_within(world, question.pixel, question.sample, &mut (), &mut budget);
    budget.check(|| format!("sample {}", question.sample)).map_err(|e| e.to_string())?;
    let all = budget.spent().saturating_mul(world.samples_per_pixel().into());
    let few = all <= MAX_RAYS_PER_PIXEL;
    let only = if few { None } else { Some(question.sample) };
    let explained = explain::pixel(scene, world, question.pixel, only);
    explained.map(Arc::new).map_err(|e| e.to_string())
}

impl Selection {
    /// Starts to explain the selected pixel, unless that is done or under way. Waits for a short
    /// explanation.
    pub fn refresh(&mut self, ctx: &egui::Context, rendering: &Rendering, generation: u64) {
        let finished = self.working.poll();
        let Some(question) = self.question(rendering, generation) else {
            self.answered = None;
            return;
        };
        self.accept(finished, question);
        if self.working.is_busy() || self.answers(question) {
            return;
        }
        let (scene, world) = (Arc::clone(&rendering.scene), Arc::clone(&rendering.world));
        self.working.start(ctx, move || (question, answer(&scene, &world, question)));
        let finished = self.working.wait(MAX_WAIT);
        self.accept(finished, question);
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

    fn question(&self, rendering: &Rendering, generation: u64) -> Option<Question> {
        let last = rendering.world.samples_per_pixel() - 1;
        self.pixel.map(|pixel| Question { generation, pixel, sample: self.sample.min(last) })
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

    /// The hits along the path to the selected ray, projected into the picture.
    pub fn trail(&self, rendering: &Rendering) -> Vec<TrailPoint> {
        let explained = self.explanation().and_then(|explanation| {
            let mut samples = explanation.samples.iter();
            let sample = samples.find(|sample| sample.index == self.sample)?;
            Some((explanation.pixel, sample.ray.as_ref()?))
        });
        match explained {
            // not for an explanation of an earlier picture
            Some((pixel, root)) if self.pixel == Some(pixel) => {
                trail::points(&rendering.world, pixel, root, self.tree.ray)
            }
            _ => Vec::new(),
        }
    }

    /// Whether the selected pixel is not explained yet.
    pub fn is_waiting(&self) -> bool {
        let current = self.answered.as_ref().map(|(question, _)| question.pixel);
        self.working.is_busy() || current != self.pixel
    }

    /// Shows the explanation; returns whether `wanted` was changed.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        (rendering, theirs, generation): (&Rendering, Option<&Theirs>, u64),
        tone: &Tone,
        (wanted, splits): (&mut Scene, &mut Splits),
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
        Panel::top("pixel").frame(inner).show(ui, |ui| {
            self.head(ui, &answer, rendering, tone);
            if let Some(theirs) = theirs {
                pixel::theirs(ui, answer.pixel, theirs, generation, tone);
            }
        });
        let index = self.sample.min(answer.samples_per_pixel - 1);
        let sample = answer.samples.iter().find(|sample| sample.index == index);
        let camera_ray = sample.and_then(|sample| sample.ray.as_ref());
        let [above, below] = splits.show_lower(ui, ui.available_rect_before_wrap());
        part(ui, ("tree", above), |ui| match sample {
            Some(sample) => self.sample_tree(ui, sample, tone),
            None => drop(ui.spinner()),
        });
        part(ui, ("details", below), |ui| {
            ui.horizontal(|ui| {
                ui.selectable_value(&mut self.tab, Tab::Ray, "The ray");
                ui.selectable_value(&mut self.tab, Tab::Sum, "The sum");
                ui.selectable_value(&mut self.tab, Tab::Samples, "The samples");
            });
            let area = ScrollArea::both().id_salt("details").auto_shrink(false);
            let area = area.min_scrolled_height(MIN_HEIGHT);
            match self.tab {
                Tab::Ray => {
                    let details = |ui: &mut Ui| {
                        if let Some(root) = camera_ray {
                            self.ray_details(ui, root);
                        }
                    };
                    area.show(ui, details);
                    false
                }
                Tab::Sum => {
                    pixel::parts(ui, area, &answer, tone, (&mut self.order, &mut self.sample));
                    false
                }
                Tab::Samples => {
                    let color = |i: u32| display::color(tone, answer.radiances[i as usize]);
                    let of = (rendering, generation, answer.pixel);
                    let show =
                        |ui: &mut Ui| self.samples.show(ui, of, &color, &mut self.sample, wanted);
                    area.show(ui, show).inner
                }
            }
        })
    }

    fn ray_details(&mut self, ui: &mut Ui, root: &RecordedRay) {
        if let Some(number) = details::show(ui, self.tree.selected(root)) {
            self.tree.go_to(root, number);
        }
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

    fn head(&mut self, ui: &mut Ui, answer: &PixelExplanation, rendering: &Rendering, tone: &Tone) {
        let [x, y] = answer.pixel;
        ui.horizontal_wrapped(|ui| {
            tree::swatch(ui, display::color(tone, answer.radiance));
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
            let index = self.sample.min(last);
            let sample = answer.samples.iter().find(|sample| sample.index == index);
            let root = sample.and_then(|sample| sample.ray.as_ref());
            let ray = root.map(|root| self.tree.selected(root));
            pixel::copy_menu(ui, rendering, answer.pixel, index, ray);
        });
        for note in &answer.notes {
            ui.weak(note);
        }
        pixel::sum(ui, answer, rendered(rendering, answer.pixel));
    }
}

/// Shows a part of the explanation in its area.
fn part<T>(ui: &mut Ui, (name, area): (&str, Rect), show: impl FnOnce(&mut Ui) -> T) -> T {
    let builder = UiBuilder::new().id_salt(name).max_rect(area.shrink2(vec2(0.0, 4.0)));
    ui.scope_builder(builder, |ui| {
        ui.set_clip_rect(ui.clip_rect().intersect(area));
        show(ui)
    })
    .inner
}

/// The picture's radiance at a pixel, if it is rendered.
fn rendered(rendering: &Rendering, pixel: [u32; 2]) -> Option<Rgb> {
    rendering.canvas.look_partly(|picture| picture.get(pixel))
}
