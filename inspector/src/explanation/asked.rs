//! The explanation of a pixel, found on a background thread.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::Context;
use explain::{PixelExplanation, RecordedRay, SampleExplanation};
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use groundtruth::trace::RayBudget;
use rays::Logged;

use crate::explanation::{Subject, Version};
use crate::picture::worker::Background;

/// The most rays of a pixel whose samples are explained together; with more, one at a time.
const MAX_RAYS_PER_PIXEL: u64 = 30_000;
/// The most rays of a sample that is explained: a larger tree would be unreadable and take gigabytes.
const MAX_RAYS_PER_SAMPLE: u64 = 500_000;

/// The longest wait for an explanation, which is then drawn in the frame of the click.
const MAX_WAIT: Duration = Duration::from_millis(12);

/// The pixel and sample to explain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question {
    /// Of which picture.
    pub version: Version,
    /// The pixel.
    pub pixel: [u32; 2],
    /// The sample; the last one, if there are not so many.
    pub sample: u32,
}

/// The explanation, or why there is none.
pub type Explained = Result<Arc<PixelExplanation>, String>;

/// The last question, and its answer.
#[derive(Default)]
pub struct Asked {
    /// Of which question, once it is answered.
    pub answered: Option<(Question, Explained)>,
    /// The work on it.
    pub working: Background<(Question, Explained)>,
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

/// What a log has of a pixel.
fn read_off(log: &Logged, Question { pixel: pixel @ [x, y], sample, .. }: Question) -> Explained {
    let missing = || format!("the log has no ray of pixel ({x}, {y})");
    log.explanation(pixel, sample).map(Arc::new).ok_or_else(missing)
}

impl Asked {
    /// Starts to explain a sample of a pixel, unless that is done or under way. Waits for a short explanation.
    pub fn refresh(
        &mut self,
        ctx: &Context,
        subject: &Subject<'_>,
        asked: Option<([u32; 2], u32)>,
    ) {
        let finished = self.working.poll();
        let Some((pixel, sample)) = asked else {
            self.answered = None;
            return;
        };
        let sample = sample.min(subject.samples_of(pixel) - 1);
        let question = Question { version: subject.version(), pixel, sample };
        self.accept(finished, question);
        if self.working.is_busy() || self.answers(question) {
            return;
        }
        let Subject { rendering, program } = *subject;
        let (ours, program) = (rendering.built.clone(), program.map(Arc::clone));
        self.working.start(ctx, move || {
            let answer = match program {
                None => answer(&ours.scene, &*ours.world, question),
                Some(program) => match program.log() {
                    Some(log) => read_off(log, question),
                    None => answer(program.scene(), &*program, question),
                },
            };
            (question, answer)
        });
        let finished = self.working.wait(MAX_WAIT);
        self.accept(finished, question);
    }

    fn accept(&mut self, finished: Option<Result<(Question, Explained), String>>, asked: Question) {
        match finished {
            Some(Ok((question, answer))) if question.version == asked.version => {
                self.answered = Some((question, answer));
            }
            // not asked again: the same question would fail again
            Some(Err(lost)) => self.answered = Some((asked, Err(lost))),
            Some(Ok(_)) | None => {}
        }
    }

    fn answers(&self, question: Question) -> bool {
        let Some((answered, answer)) = &self.answered else { return false };
        let has_it = answer.as_ref().is_ok_and(|explanation| {
            explanation.samples.iter().any(|sample| sample.index == question.sample)
        });
        let same_pixel = Question { sample: question.sample, ..*answered } == question;
        *answered == question || (same_pixel && has_it)
    }

    /// The picture that the answer is of.
    pub fn version(&self) -> Option<Version> {
        self.answered.as_ref().map(|(question, _)| question.version)
    }

    /// The pixel that the answer is of.
    pub fn pixel(&self) -> Option<[u32; 2]> {
        self.answered.as_ref().map(|(question, _)| question.pixel)
    }

    /// The explanation, if it is finished.
    pub fn explanation(&self) -> Option<&PixelExplanation> {
        self.answered.as_ref()?.1.as_deref().ok()
    }

    /// The camera's ray of a sample, and the question that its tree answers.
    pub fn root(&self, sample: u32) -> Option<(Question, &RecordedRay)> {
        let (question, _) = self.answered.as_ref()?;
        let sample = sample_of(self.explanation()?, sample)?;
        let root = sample.ray.as_ref()?;
        Some((Question { sample: sample.index, ..*question }, root))
    }
}

/// A sample of a pixel, the last one if there are not so many; if it is explained.
pub fn sample_of(answer: &PixelExplanation, sample: u32) -> Option<&SampleExplanation> {
    let index = sample.min(answer.samples_per_pixel - 1);
    answer.samples.iter().find(|sample| sample.index == index)
}
