//! Background threads for all slow work: reading and building scenes, rendering, explaining. The window
//! polls them in each frame and waits only for a moment.

use std::fmt;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, OnceLock};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use eframe::egui;
use groundtruth::math::Span;
use groundtruth::render::{self, Canvas, MAX_COUNTED, RaysPerSample};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use crate::scene::source::{Loaded, Source};

/// Rays of depth 128 are traced on the stack; unoptimised builds need more than the usual 2 MB.
const STACK: usize = 16 << 20;

/// A task on a background thread.
#[derive(Debug)]
pub struct Background<T> {
    result: Option<Receiver<T>>,
}

/// The thread ended without a result.
#[derive(Clone, Copy, Debug)]
pub struct Lost;

impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the work stopped unexpectedly; the terminal says why")
    }
}

impl<T> Default for Background<T> {
    fn default() -> Self {
        Self { result: None }
    }
}

impl<T: Send + 'static> Background<T> {
    /// Starts the work. If there was other work under way, its result is forgotten.
    pub fn start(&mut self, ctx: &egui::Context, work: impl FnOnce() -> T + Send + 'static) {
        let (sender, receiver) = mpsc::sync_channel(1);
        let ctx = ctx.clone();
        // if no thread can be started, the sender is dropped, and `poll` returns `Lost`
        let _ = Builder::new().stack_size(STACK).spawn(move || {
            // fails if other work was started meanwhile
            let _ = sender.send(work());
            ctx.request_repaint();
        });
        self.result = Some(receiver);
    }

    /// Whether work is under way.
    pub fn is_busy(&self) -> bool {
        self.result.is_some()
    }

    /// The result, returned once, if it is ready.
    pub fn poll(&mut self) -> Option<Result<T, Lost>> {
        self.wait(Duration::ZERO)
    }

    /// The result, returned once, if it is ready within this time.
    pub fn wait(&mut self, timeout: Duration) -> Option<Result<T, Lost>> {
        let result = match self.result.as_ref()?.recv_timeout(timeout) {
            Ok(result) => Ok(result),
            Err(RecvTimeoutError::Timeout) => return None,
            Err(RecvTimeoutError::Disconnected) => Err(Lost),
        };
        self.result = None;
        Some(result)
    }
}

/// A picture that is being rendered. Dropping it stops the work.
#[derive(Debug)]
pub struct Rendering {
    /// The number of this rendering: answers about another one are dropped.
    pub generation: u64,
    /// The source of the scene.
    pub source: Source,
    /// The scene as its source says it.
    pub read: Scene,
    /// The scene as it is rendered.
    pub scene: Arc<Scene>,
    /// The scene, built.
    pub world: Arc<World>,
    /// The picture so far.
    pub canvas: Arc<Canvas>,
    start: Instant,
    note: Arc<OnceLock<Option<String>>>,
    took: Arc<OnceLock<Duration>>,
    thread: Option<JoinHandle<()>>,
}

/// The progress of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Being rendered: the finished part of it, and for how long.
    Running(f32, Duration),
    /// Finished: how long it took.
    Done(Duration),
    /// Its thread ended early.
    Stopped,
}

impl Rendering {
    /// Starts to render.
    pub fn start(ctx: &egui::Context, loaded: Loaded, generation: u64) -> Self {
        let Loaded { source, read, scene, world, .. } = loaded;
        let (scene, world) = (Arc::new(scene), Arc::new(world));
        let canvas = Arc::new(Canvas::new(&world));
        let (start, took) = (Instant::now(), Arc::new(OnceLock::new()));
        let note = Arc::new(OnceLock::new());
        let work = {
            let (canvas, world) = (Arc::clone(&canvas), Arc::clone(&world));
            let (note, took, ctx) = (Arc::clone(&note), Arc::clone(&took), ctx.clone());
            move || {
                canvas.preview(&*world);
                let rays = RaysPerSample::measured(&world, MAX_COUNTED);
                let samples = canvas.progress().1 as f64 * f64::from(world.samples_per_pixel());
                let _ = note.set(rays.note(samples));
                canvas.render(&*world);
                let _ = took.set(start.elapsed());
                ctx.request_repaint();
            }
        };
        let thread = Builder::new().stack_size(STACK).spawn(work).ok();
        Self { generation, source, read, scene, world, canvas, start, note, took, thread }
    }

    /// A note for the user, if the picture has many rays.
    pub fn note(&self) -> Option<&str> {
        self.note.get()?.as_deref()
    }

    /// The progress so far.
    pub fn progress(&self) -> Progress {
        // in this order: a thread that succeeds sets its time before it ends
        let ended = self.thread.as_ref().is_none_or(JoinHandle::is_finished);
        if let Some(&took) = self.took.get() {
            return Progress::Done(took);
        }
        if ended {
            return Progress::Stopped;
        }
        let (done, whole) = self.canvas.progress();
        Progress::Running(done as f32 / whole as f32, self.start.elapsed())
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

impl Drop for Rendering {
    fn drop(&mut self) {
        self.canvas.cancel();
    }
}
