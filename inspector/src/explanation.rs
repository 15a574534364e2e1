//! The selected pixel: its samples, the sum that it is, and the ray that is looked at.

use std::sync::Arc;

use eframe::egui::{
    self, CentralPanel, Color32, DragValue, Frame, Margin, Panel, RichText, ScrollArea, Ui,
};
use groundtruth::explain::{self, PixelExplanation, SampleExplanation, short};
use groundtruth::film::Tone;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::RayCounts;
use groundtruth::world::World;

use crate::samples::Samples;
use crate::trail::{self, Station};
use crate::worker::{Background, Rendering};
use crate::{details, picture, tree};

/// A pixel of more rays is explained one sample at a time.
const MOST_RAYS_OF_A_PIXEL: u64 = 30_000;
/// A sample of more rays would be a tree that nobody reads, in gigabytes of memory.
const MOST_RAYS_OF_A_SAMPLE: u64 = 500_000;

/// The least height of tree and details in a low window, in points of the screen.
const LEAST_HEIGHT: f32 = 24.0;

/// What is to be explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Question {
    generation: u64,
    pixel: [u32; 2],
    sample: u32,
}

type Answer = Result<Arc<PixelExplanation>, String>;

/// The selected pixel and why it has its colour.
#[derive(Default)]
pub struct Selection {
    /// The pixel.
    pub pixel: Option<[u32; 2]>,
    /// The sample whose tree is shown.
    pub sample: u32,
    /// The ray whose details are shown: the way to it from the camera's ray.
    pub ray: Vec<usize>,
    /// What is below the tree.
    pub below: Below,
    /// The samples, when they are below the tree.
    pub samples: Samples,
    answered: Option<(Question, Answer)>,
    working: Background<(Question, Answer)>,
}

/// What is shown below the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Below {
    /// The selected ray.
    #[default]
    Ray,
    /// The samples of the pixel.
    Samples,
}

/// Explains all samples, or only the one asked for if all would be too many rays.
fn answer(scene: &Scene, world: &World, question: Question) -> Answer {
    let mut counts = RayCounts::default();
    render::sample(world, question.pixel, question.sample, &mut counts);
    let rays = counts.camera + counts.reflected + counts.transmitted + counts.shadow;
    if rays > MOST_RAYS_OF_A_SAMPLE {
        return Err(format!(
            "sample {} has {rays} rays, more than can be shown; a smaller max_depth or fewer \
             objects make a smaller tree",
            question.sample
        ));
    }
    let few = rays.saturating_mul(world.samples_per_pixel().into()) <= MOST_RAYS_OF_A_PIXEL;
    let only = if few { None } else { Some(question.sample) };
    Ok(Arc::new(explain::pixel(scene, world, question.pixel, only)))
}

impl Selection {
    /// Starts to explain what is selected, unless that is done or under way.
    pub fn refresh(&mut self, ctx: &egui::Context, rendering: &Rendering, generation: u64) {
        match self.working.poll() {
            Some(Ok((question, answer))) if question.generation == generation => {
                self.answered = Some((question, answer));
            }
            Some(Err(lost)) => {
                // asked once only: the same question would be lost again
                if let Some(question) = self.question(rendering, generation) {
                    self.answered = Some((question, Err(lost.to_string())));
                }
            }
            _ => {}
        }
        let Some(question) = self.question(rendering, generation) else {
            self.answered = None;
            return;
        };
        if self.working.is_busy() || self.answers(question) {
            return;
        }
        let (scene, world) = (Arc::clone(&rendering.scene), Arc::clone(&rendering.world));
        self.working.start(ctx, move || (question, answer(&scene, &world, question)));
    }

    fn question(&self, rendering: &Rendering, generation: u64) -> Option<Question> {
        let most = rendering.world.samples_per_pixel() - 1;
        self.pixel.map(|pixel| Question { generation, pixel, sample: self.sample.min(most) })
    }

    fn answers(&self, question: Question) -> bool {
        let Some((answered, answer)) = &self.answered else { return false };
        let has_it = answer.as_ref().is_ok_and(|explanation| {
            explanation.samples.iter().any(|sample| sample.index == question.sample)
        });
        let same_pixel = Question { sample: question.sample, ..*answered } == question;
        *answered == question || (same_pixel && has_it)
    }

    /// The explanation, when it is there.
    pub fn explanation(&self) -> Option<&PixelExplanation> {
        self.answered.as_ref()?.1.as_deref().ok()
    }

    /// The hits on the way to the selected ray, as the camera sees them.
    pub fn trail(&self, rendering: &Rendering) -> Vec<Station> {
        let explained = self.explanation().and_then(|explanation| {
            let mut samples = explanation.samples.iter();
            let sample = samples.find(|sample| sample.index == self.sample)?;
            Some((explanation.pixel, sample.ray.as_ref()?))
        });
        match explained {
            // an explanation of the picture before is no guide to this one
            Some((pixel, root)) if self.pixel == Some(pixel) => {
                trail::stations(&rendering.world, pixel, root, &self.ray)
            }
            _ => Vec::new(),
        }
    }

    /// Whether what is selected is not explained yet.
    pub fn is_waiting(&self) -> bool {
        let current = self.answered.as_ref().map(|(question, _)| question.pixel);
        self.working.is_busy() || current != self.pixel
    }

    /// Shows it; whether `wanted` was changed.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        (rendering, generation): (&Rendering, u64),
        tone: &Tone,
        wanted: &mut Scene,
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
        Panel::top("pixel").frame(inner).show(ui, |ui| self.head(ui, &answer, rendering, tone));
        let index = self.sample.min(answer.samples_per_pixel - 1);
        let sample = answer.samples.iter().find(|sample| sample.index == index);
        let camera_ray = sample.and_then(|sample| sample.ray.as_ref());
        let height = ui.available_height();
        let panel = Panel::bottom("details").frame(inner).resizable(true);
        let panel = panel.default_size(0.45 * height).max_size((height - 150.0).max(0.45 * height));
        let changed = panel.show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.selectable_value(&mut self.below, Below::Ray, "The ray");
                ui.selectable_value(&mut self.below, Below::Samples, "The samples");
            });
            let area = ScrollArea::both().id_salt("details").auto_shrink(false);
            let area = area.min_scrolled_height(LEAST_HEIGHT);
            let shown = area.show(ui, |ui| match self.below {
                Below::Ray => {
                    if let Some(root) = camera_ray {
                        details::show(ui, tree::find(root, &self.ray).unwrap_or(root));
                    }
                    false
                }
                Below::Samples => {
                    let (of, pixel) = ((rendering, generation), answer.pixel);
                    self.samples.show(ui, of, pixel, &mut self.sample, wanted)
                }
            });
            shown.inner
        });
        CentralPanel::default().frame(inner).show(ui, |ui| {
            let Some(sample) = sample else {
                ui.spinner();
                return;
            };
            let (Some(root), Some([x, y])) = (camera_ray, sample.film) else {
                ui.strong(format!("Sample {index}"));
                ui.label("No ray: the camera sees nothing there.");
                return;
            };
            let rays = tree::count(root);
            ui.horizontal(|ui| {
                ui.strong(format!("Sample {index}"));
                ui.weak(format!("{rays} rays, at ({x:.4}, {y:.4}) on the view plane"));
            });
            tree::legend(ui);
            let area = ScrollArea::both().id_salt("tree").auto_shrink(false);
            area.min_scrolled_height(LEAST_HEIGHT).show(ui, |ui| {
                ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
                tree::show(ui, root, tone, &mut self.ray);
            });
        });
        changed.inner
    }

    fn head(&mut self, ui: &mut Ui, answer: &PixelExplanation, rendering: &Rendering, tone: &Tone) {
        let [x, y] = answer.pixel;
        ui.horizontal_wrapped(|ui| {
            tree::swatch(ui, picture::color(tone, answer.radiance));
            ui.heading(format!("Pixel ({x}, {y})"));
            if self.is_waiting() {
                ui.spinner();
            }
            let last = answer.samples_per_pixel - 1;
            if last > 0 {
                ui.separator();
                self.chooser(ui, last);
            }
        });
        let rendered = rendered(rendering, answer.pixel);
        sum(ui, answer, rendered);
        let title = format!("All {} samples of the sum", answer.samples.len());
        if answer.samples.len() > 1 {
            egui::CollapsingHeader::new(title).id_salt("samples").show(ui, |ui| {
                ScrollArea::vertical().max_height(130.0).auto_shrink([false, true]).show(
                    ui,
                    |ui| {
                        answer.samples.iter().for_each(|sample| self.sample_line(ui, sample, tone));
                    },
                );
            });
        }
    }

    fn chooser(&mut self, ui: &mut Ui, last: u32) {
        let label = ui.label("sample");
        let mut sample = self.sample.min(last);
        if ui.add_enabled(sample > 0, egui::Button::new("<")).clicked() {
            sample -= 1;
        }
        ui.add(DragValue::new(&mut sample).range(0..=last)).labelled_by(label.id);
        if ui.add_enabled(sample < last, egui::Button::new(">")).clicked() {
            sample += 1;
        }
        ui.weak(format!("of 0 to {last}"));
        self.sample = sample;
    }

    fn sample_line(&mut self, ui: &mut Ui, sample: &SampleExplanation, tone: &Tone) {
        ui.horizontal(|ui| {
            tree::swatch(ui, picture::color(tone, sample.radiance));
            let text = format!("sample {:>3}  {}", sample.index, short(sample.radiance));
            let text = RichText::new(text).monospace();
            if ui.selectable_label(self.sample == sample.index, text).clicked() {
                self.sample = sample.index;
            }
        });
    }
}

/// What the picture has at a pixel, if it has come that far.
fn rendered(rendering: &Rendering, pixel: [u32; 2]) -> Option<Rgb> {
    rendering.canvas.look_partly(|picture| picture.get(pixel))
}

/// The sum that is the pixel, and whether the picture says the same.
fn sum(ui: &mut Ui, answer: &PixelExplanation, rendered: Option<Rgb>) {
    let exposure = match answer.exposure_time {
        1.0 => String::new(),
        time => format!(", times the exposure time {time:?}"),
    };
    let what = match answer.samples_per_pixel {
        1 => "the radiance of its one sample".to_owned(),
        count => format!("the mean of its {count} samples"),
    };
    ui.label(format!("The pixel is {what}{exposure}:"));
    let total = format!("= {}", details::exact(answer.radiance.to_array()));
    ui.label(RichText::new(total).monospace().size(12.0).strong());
    let bits = |color: Rgb| color.to_array().map(f64::to_bits);
    match rendered {
        None => ui.weak("the picture has not come to this pixel yet"),
        Some(radiance) if bits(radiance) == bits(answer.radiance) => {
            let good = Color32::from_rgb(120, 220, 120);
            ui.colored_label(good, "= the pixel of the picture, bit for bit")
        }
        Some(radiance) => {
            let text = details::exact(radiance.to_array());
            let text = format!("differs from the pixel of the picture: {text}");
            ui.colored_label(ui.visuals().error_fg_color, text)
        }
    };
}
