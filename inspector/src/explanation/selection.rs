//! The selected pixel: its samples, their sum, and the selected ray.

use std::collections::BTreeMap;
use std::sync::Arc;

use eframe::egui::Context;
use explain::{PixelExplanation, RecordedRay};
use groundtruth::trace::RayKind;
use groundtruth::world::World;
use rays::{Logged, RayPlace};

use crate::comparison::others::Others;
use crate::comparison::theirs::Theirs;
use crate::explanation::asked::{Asked, Question, sample_of};
use crate::explanation::trail::{self, TrailPoint};
use crate::explanation::tree::Tree;
use crate::explanation::{Subject, proposal};
use crate::picture::worker::{Background, Rendering};

/// The selected pixel and why it has its colour.
#[derive(Default)]
pub struct Selection {
    /// The pixel.
    pub pixel: Option<[u32; 2]>,
    /// The sample whose tree is shown.
    pub sample: u32,
    /// Its tree, and the ray whose details are shown.
    pub tree: Tree,
    /// The part that is shown below the tree.
    pub tab: Tab,
    /// The index of the object of which is asked why the selected ray does not hit it.
    pub object: Option<u32>,
    /// The sample that is pointed at in this frame, and that of the last one, whose tree is shown meanwhile.
    pub pointed: Option<u32>,
    previewed: Option<u32>,
    /// Whether the pixel was proposed, and not chosen by the user.
    pub is_proposed: bool,
    /// Its explanation in the picture that is shown.
    pub asked: Asked,
    /// The same pixel of the other one of two pictures that can be explained.
    pub beside: Asked,
    proposing: Background<[u32; 2]>,
    /// The number of a ray that is selected once its tree is there.
    sought: Option<usize>,
    /// The path to a ray of another pixel, whose like is selected then.
    path: Vec<Step>,
    /// The pixel whose rays stand beside those of the selected one.
    pub pinned: Option<[u32; 2]>,
    visited: Visited,
    /// One of the visited pixels, to which the window goes in the next frame.
    pub again: Option<[u32; 2]>,
    /// The tree whose rays are known by their numbers, and their indices in its log.
    pub logged: Option<(Question, BTreeMap<usize, usize>)>,
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

/// The pixels that were selected, as the pages of a browser.
#[derive(Default)]
struct Visited {
    pixels: Vec<[u32; 2]>,
    /// The place of the present one.
    at: usize,
    /// Whether arrow keys led to it, and lead to the next one: of several such steps the last one is kept.
    is_step: [bool; 2],
}

impl Visited {
    fn next(&self, by: isize) -> Option<(usize, [u32; 2])> {
        let at = self.at.checked_add_signed(by)?;
        Some((at, *self.pixels.get(at)?))
    }

    fn visit(&mut self, pixel: [u32; 2]) {
        let [was_step, is_step] = self.is_step;
        if self.pixels.get(self.at) != Some(&pixel) {
            self.pixels.truncate(self.at + usize::from(!(was_step && is_step)));
            self.pixels.push(pixel);
            (self.at, self.is_step) = (self.pixels.len() - 1, [is_step, false]);
        }
    }
}

/// What leads from a ray to the next one.
type Step = (RayKind, Option<Arc<str>>);

fn step_to(ray: &RecordedRay) -> Step {
    (ray.kind, ray.light.clone())
}

impl Selection {
    /// Starts to explain the selected pixel of the picture that is shown, and of the other one, unless that is done or under
    /// way. Waits for a short explanation.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering, others: &Others) {
        let shown = Subject { rendering, program: others.shown().and_then(Theirs::explained) };
        let other = others.beside();
        let (program, is_twin) = (other.flatten(), other.is_some());
        let asked = self.pixel.map(|pixel| (pixel, self.sample));
        let is_flipped = self.beside.pixel() == self.pixel;
        if is_flipped && self.beside.version() == Some(shown.version()) {
            std::mem::swap(&mut self.asked, &mut self.beside);
        }
        self.asked.refresh(ctx, &shown, asked);
        match self.pinned_beside() {
            Some(pinned) => self.beside.refresh(ctx, &shown, Some((pinned, self.sample))),
            None => {
                let other = Subject { rendering, program };
                self.beside.refresh(ctx, &other, asked.filter(|_| is_twin));
            }
        }
        self.read_off(shown.log());
        if self.asked.pixel() == self.pixel {
            let path = std::mem::take(&mut self.path);
            let like = self.root().and_then(|(_, root)| {
                path.iter()
                    .try_fold(root, |ray, step| ray.children.iter().find(|it| step_to(it) == *step))
            });
            let like = like.map(|ray| ray.number).filter(|number| *number > 0);
            self.sought.take().or(like).into_iter().for_each(|number| self.go_to(number));
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

    /// The pinned pixel, if another one is selected.
    pub fn pinned_beside(&self) -> Option<[u32; 2]> {
        self.pinned.filter(|pinned| Some(*pinned) != self.pixel)
    }

    /// Pins the selected pixel, or lets the pinned one go.
    pub fn pin(&mut self) {
        self.pinned = if self.pinned.is_some() { None } else { self.pixel };
    }

    /// Goes back (−1) or forward (1) through the pixels that were selected.
    pub fn go(&mut self, by: isize) {
        if let Some((at, pixel)) = self.visited.next(by) {
            (self.visited.at, self.visited.is_step) = (at, [false; 2]);
            self.again = Some(pixel);
        }
    }

    /// Whether there is a pixel to go to.
    pub fn can_go(&self, by: isize) -> bool {
        self.visited.next(by).is_some()
    }

    /// Of the pixel that is explained next, selects the ray to which the same kinds of rays lead as to this one.
    pub fn keep_ray(&mut self) {
        self.visited.is_step[1] = true;
        let path = self.root().map_or(Vec::new(), |(_, root)| root.path_to(self.tree.ray));
        self.path = path.into_iter().skip(1).map(step_to).collect();
    }

    /// Starts to look for a pixel that is worth explaining.
    pub fn propose(&mut self, ctx: &Context, rendering: &Rendering) {
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
    pub fn shown_sample(&self) -> u32 {
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
        self.visited.visit(pixel);
        (self.pixel, self.is_proposed) = (Some(pixel), false);
        Ok(())
    }

    /// Selects a ray of the tree and scrolls to it.
    pub fn go_to(&mut self, number: usize) {
        let tree = self.asked.root(self.shown_sample());
        if let Some((_, root)) = tree.filter(|(question, _)| self.pixel == Some(question.pixel)) {
            self.tree.go_to(root, number);
        }
    }

    /// Asks why the selected ray does not hit an object.
    pub fn ask_why_not(&mut self, object: u32) {
        (self.tab, self.object) = (Tab::Ray, Some(object));
    }

    /// The hits along the path to the selected ray, projected into the picture.
    pub fn trail(&self, world: &World) -> Vec<TrailPoint> {
        self.root().map_or(Vec::new(), |(Question { pixel, .. }, root)| {
            trail::points(world, pixel, root, self.tree.ray)
        })
    }

    /// Whether the selected pixel is not explained yet.
    pub fn is_waiting(&self) -> bool {
        let is_asked = self.asked.working.is_busy() || self.beside.working.is_busy();
        is_asked || self.proposing.is_busy() || self.asked.pixel() != self.pixel
    }
}
