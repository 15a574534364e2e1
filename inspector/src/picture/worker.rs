//! All slow work, beside the window: reading and building scenes, rendering, explaining. The window
//! polls it in each frame and waits only for a moment.

use std::ops::Deref;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use eframe::egui;
use groundtruth::film::Tone;
use groundtruth::math::Span;
use groundtruth::render::{self, Canvas, MAX_COUNTED, RaysPerSample, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use web_time::Instant;

use crate::picture::developed::Version;
use crate::platform::{self, Slice, Task};
use crate::scene::source::Built;

/// Work beside the window that has a result.
#[derive(Debug)]
pub struct Background<T> {
    result: Option<Receiver<T>>,
}

/// What is said of work that ended without a result.
const LOST: &str = "the work stopped unexpectedly; the terminal says why";

impl<T> Default for Background<T> {
    fn default() -> Self {
        Self { result: None }
    }
}

impl<T: Send + 'static> Background<T> {
    /// Starts the work. If there was other work under way, its result is forgotten.
    pub fn start(&mut self, ctx: &egui::Context, work: impl FnOnce() -> T + Send + 'static) {
        let mut work = Some(work);
        self.start_in_slices(ctx, move |_| work.take().map(|work| work()));
    }

    /// As [`Self::start`], with work that goes on in each slice, until there is a result.
    pub fn start_in_slices(
        &mut self,
        ctx: &egui::Context,
        mut work: impl FnMut(&Slice) -> Option<T> + Send + 'static,
    ) {
        // if no thread can be started, it is dropped, and `poll` returns an error
        let mut answer = Some(self.expect(ctx));
        Task::start(ctx, move |slice| {
            let Some(result) = work(slice) else { return false };
            if let Some(answer) = answer.take() {
                answer(result);
            }
            true
        });
    }

    /// Waits for what the returned function is given, in place of work.
    pub fn expect(&mut self, ctx: &egui::Context) -> impl FnOnce(T) + Send + 'static {
        let (sender, receiver) = mpsc::sync_channel(1);
        self.result = Some(receiver);
        let ctx = ctx.clone();
        move |result| {
            // fails if other work was started meanwhile
            let _ = sender.send(result);
            ctx.request_repaint();
        }
    }

    /// Whether work is under way.
    pub fn is_busy(&self) -> bool {
        self.result.is_some()
    }

    /// The result, returned once, if it is ready; an error if the work ended without one.
    pub fn poll(&mut self) -> Option<Result<T, String>> {
        self.wait(Duration::ZERO)
    }

    /// As [`Self::poll`], if it is ready within this time.
    pub fn wait(&mut self, timeout: Duration) -> Option<Result<T, String>> {
        let result = match platform::wait(self.result.as_ref()?, timeout) {
            Ok(result) => Ok(result),
            Err(RecvTimeoutError::Timeout) => return None,
            Err(RecvTimeoutError::Disconnected) => Err(LOST.to_owned()),
        };
        self.result = None;
        Some(result)
    }
}

/// A picture that is filled beside the window. Dropping it stops the work.
#[derive(Debug)]
pub struct Growing {
    /// The picture so far.
    pub canvas: Arc<Canvas>,
    task: Task,
}

impl Growing {
    /// Starts to fill a picture of this world: `fill` is called until it returns true.
    pub fn start(
        ctx: &egui::Context,
        world: &World,
        mut fill: impl FnMut(&Canvas, &Slice) -> bool + Send + 'static,
    ) -> Self {
        let canvas = Arc::new(Canvas::new(world));
        let filled = Arc::clone(&canvas);
        let task = Task::start(ctx, move |slice| fill(&filled, slice) || filled.is_cancelled());
        Self { canvas, task }
    }

    /// Starts to render, with the coarse picture at once, even while another picture is rendered.
    pub fn render(ctx: &egui::Context, renderer: Arc<impl Renderer + Send + 'static>) -> Self {
        let of = Arc::clone(&renderer);
        Self::start(ctx, of.world(), move |canvas, slice| {
            let is_over = || slice.is_over();
            platform::at_once(|| canvas.preview(&*renderer, &is_over))
                && canvas.render_until(&*renderer, &is_over)
        })
    }

    /// The filled part, from 0 to 1; `None` once the work has ended.
    pub fn part(&self) -> Option<f32> {
        let (done, whole) = self.canvas.progress();
        (!self.task.is_ended()).then_some(done as f32 / whole as f32)
    }

    /// The version of the picture so far.
    pub fn version<K>(&self, of: K, tone: Tone) -> Version<K> {
        // in this order: a picture that is finished now is completely in its film
        let is_finished = self.task.is_ended();
        Version { of, done: self.canvas.seen(), is_finished, tone }
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        self.canvas.cancel();
    }
}

/// Our picture, which is being rendered. Dropping it stops the work.
#[derive(Debug)]
pub struct Rendering {
    /// The number of this rendering: answers about another one are dropped.
    pub generation: u64,
    /// The scene.
    pub built: Built,
    /// The picture so far.
    pub canvas: Arc<Canvas>,
    start: Instant,
    note: Arc<OnceLock<Option<String>>>,
    took: Arc<OnceLock<Duration>>,
    growing: Growing,
}

/// The progress of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Being rendered: the finished part of it, and for how long.
    Running(f32, Duration),
    /// Finished: how long it took.
    Done(Duration),
    /// Its work ended early.
    Stopped,
}

impl Rendering {
    /// Starts to render.
    pub fn start(ctx: &egui::Context, built: Built, generation: u64) -> Self {
        let (start, world) = (Instant::now(), Arc::clone(&built.world));
        let (note, took) = (Arc::<OnceLock<_>>::default(), Arc::<OnceLock<_>>::default());
        let (noted, taken) = (Arc::clone(&note), Arc::clone(&took));
        let growing = Growing::start(ctx, &built.world, move |canvas, slice| {
            let is_over = || slice.is_over();
            if !canvas.preview(&*world, &is_over) {
                return false;
            }
            noted.get_or_init(|| {
                let rays = RaysPerSample::measured(&world, MAX_COUNTED);
                let samples = canvas.progress().1 as f64 * f64::from(world.samples_per_pixel());
                rays.note(samples)
            });
            let is_whole = canvas.render_until(&*world, &is_over);
            if is_whole {
                let _ = taken.set(start.elapsed());
            }
            is_whole
        });
        let canvas = Arc::clone(&growing.canvas);
        Self { generation, built, canvas, start, note, took, growing }
    }

    /// A note for the user, if the picture has many rays.
    pub fn note(&self) -> Option<&str> {
        self.note.get()?.as_deref()
    }

    /// The progress so far.
    pub fn progress(&self) -> Progress {
        // in this order: a task that succeeds sets its time before it ends
        let part = self.growing.part();
        match (self.took.get(), part) {
            (Some(&took), _) => Progress::Done(took),
            (None, Some(part)) => Progress::Running(part, self.start.elapsed()),
            (None, None) => Progress::Stopped,
        }
    }

    /// Whether it is finished.
    pub fn is_finished(&self) -> bool {
        matches!(self.progress(), Progress::Done(_))
    }

    /// The radiance of a pixel, if it is rendered.
    pub fn radiance(&self, pixel: [u32; 2]) -> Option<Rgb> {
        self.canvas.look_partly(|picture| picture.get(pixel))
    }

    /// The index of the object that the first sample of a pixel hits.
    pub fn object_in(&self, pixel: [u32; 2]) -> Option<u32> {
        let ray = render::camera_sample(&self.world, pixel, 0)?.ray?;
        Some(self.world.hit(&ray, Span::AHEAD)?.object.index)
    }

    /// Pixels across and down.
    pub fn size(&self) -> [u32; 2] {
        self.world.picture_size()
    }
}

impl Deref for Rendering {
    type Target = Built;

    fn deref(&self) -> &Built {
        &self.built
    }
}
