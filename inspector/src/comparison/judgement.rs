//! The verdict on their picture, the same as that of `groundtruth verify`: a button starts it, beside the window.

use std::mem::take;
use std::slice;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use eframe::egui::{
    Align2, Button, Color32, Context, FontId, Id, Rect, RichText, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, accesskit::Role, vec2,
};
use groundtruth::film::{Film, Tone};
use groundtruth::render::{Canvas, Crop};
use groundtruth::world::World;
use judge::verdict::{self, Case, Decision, Progress, Renders, Strictness, Verdict};
use pictures::compare::Picture;
use text::brief::count;

use crate::action::{Action, Shows};
use crate::picture::developed::{self, Developed, Version};
use crate::picture::display::{AGREES, ink};
use crate::picture::view::Placement;
use crate::picture::worker::{Background, Rendering};
use crate::platform::{Slice, watched};
use crate::scene::source::Built;

/// The size of the verdict's sentence, and the side of a region's number over the picture, in points of the screen.
const VERDICT: f32 = 16.0;
const NUMBER: f32 = 16.0;

/// The verdict on their picture.
#[derive(Default)]
pub struct Judgement {
    state: State,
    /// The generation of our picture that it belongs to.
    generation: u64,
    /// The map of z.
    pub map: Developed<()>,
}

#[derive(Default)]
enum State {
    /// The state before anybody asks.
    #[default]
    Nothing,
    Running(Arc<Course>, Background<Outcome>),
    Done(Outcome),
}

/// The verdict, or why there is none.
type Outcome = Result<Arc<Verdict>, String>;

/// The progress of a judgement, and whether it is to stop.
#[derive(Default)]
struct Course {
    pictures: AtomicUsize,
    /// What is known so far, once theirs was compared with ours for the first time, and whether explanations are tried, whose
    /// pictures come on top.
    known: Mutex<(String, bool)>,
    is_stopped: AtomicBool,
}

impl Course {
    fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    fn note(&self, progress: Progress<'_>) {
        let is_explaining = matches!(progress, Progress::Explaining);
        *self.known.lock().expect("no holder panics") = (format!("; {progress}"), is_explaining);
    }

    /// Renders a picture of ours within a slice; returns whether it was finished.
    fn render(&self, world: &World, canvas: &Canvas, slice: &Slice) -> bool {
        let stop = || {
            if self.is_stopped() {
                canvas.cancel();
            }
        };
        let is_whole = watched(|| canvas.render_until(world, &|| slice.is_over()), stop);
        self.pictures.fetch_add(usize::from(is_whole), Ordering::Relaxed);
        is_whole
    }

    fn words(&self) -> String {
        let rendered = self.pictures.load(Ordering::Relaxed);
        let (known, is_explaining) = &*self.known.lock().expect("no holder panics");
        let pictures = match is_explaining {
            true => count(rendered, "picture"),
            false => format!("{rendered} of at most {} pictures", Strictness::USUAL.most()),
        };
        format!("{pictures} of ours{known}")
    }
}

/// A scene as the window shows it; its seed is that of the first of our pictures.
struct Question {
    built: Built,
    theirs: Arc<Picture>,
    /// Our pictures of earlier slices: each slice judges from the beginning, and asks for the same pictures again.
    rendered: Vec<Film>,
    /// The next one, as far as it is rendered.
    under_way: Option<Canvas>,
}

impl Question {
    /// The answer, if it is found within the slice.
    fn answer(&mut self, course: &Course, slice: &Slice) -> Option<Outcome> {
        let is_paused = AtomicBool::new(false);
        let (mut rendered, mut under_way) = (take(&mut self.rendered), self.under_way.take());
        let mut asked = 0;
        let outcome = self.judged(course, &is_paused, &mut |world, canvas| {
            if slice.is_endless() {
                return course.render(world, canvas, slice);
            }
            // what is under way is of another world than a picture that is asked for after it
            if is_paused.load(Ordering::Relaxed) {
                return false;
            }
            let of @ Crop { x, y, .. } = canvas.crop();
            if asked == rendered.len() {
                let next = under_way.take().unwrap_or_else(|| Canvas::cropped(of));
                if !course.render(world, &next, &slice.doubled()) {
                    is_paused.store(!course.is_stopped(), Ordering::Relaxed);
                    under_way = Some(next);
                    return false;
                }
                rendered.push(next.film());
            }
            let film = &rendered[asked];
            canvas.fill(|[column, row]| film.get([column - x, row - y]));
            asked += 1;
            true
        });
        (self.rendered, self.under_way) = (rendered, under_way);
        (!is_paused.load(Ordering::Relaxed)).then_some(outcome)
    }

    fn judged(&self, course: &Course, is_paused: &AtomicBool, renders: Renders<'_>) -> Outcome {
        let Built { source, scene, world, .. } = &self.built;
        let (theirs, folder, seed) = (&*self.theirs, source.folder(), world.seed);
        let refusal = verdict::refusal(theirs).or_else(|| verdict::refusal_of_seed(seed));
        if let Some(problem) = refusal {
            return Err(problem);
        }
        // a world of its own: it is given other seeds
        let world = World::build_seeded(scene, folder, seed);
        let mut world = world.map_err(|error| error.to_string())?;
        let case = Case {
            is_over: &|| is_paused.load(Ordering::Relaxed) || course.is_stopped(),
            so_far: &|progress| course.note(progress),
            transfer: theirs.stated,
            ..Case::new(scene, folder, seed)
        };
        let verdict = case.verdict(&mut world, slice::from_ref(theirs), renders).map(Arc::new);
        verdict.ok_or("interrupted; too few pictures were rendered to say anything".to_owned())
    }
}

impl Judgement {
    /// Judges a picture as one of the scene that is shown.
    pub fn start(&mut self, ctx: &Context, rendering: &Rendering, theirs: Arc<Picture>) {
        *self = Self::default();
        self.generation = rendering.generation;
        let mut question = Question {
            built: rendering.built.clone(),
            theirs,
            rendered: Vec::new(),
            under_way: None,
        };
        let (course, mut working) = (Arc::new(Course::default()), Background::default());
        let of_thread = Arc::clone(&course);
        working.start_in_slices(ctx, move |slice| question.answer(&of_thread, slice));
        self.state = State::Running(course, working);
    }

    /// Stops the work; what is known by then is said.
    pub fn stop(&self) {
        if let State::Running(course, _) = &self.state {
            course.is_stopped.store(true, Ordering::Relaxed);
        }
    }

    /// Whether it is being worked on.
    pub fn is_busy(&self) -> bool {
        matches!(self.state, State::Running(..)) || self.map.is_busy()
    }

    /// The verdict, once there is one.
    pub fn verdict(&self) -> Option<&Verdict> {
        match &self.state {
            State::Done(Ok(verdict)) => Some(verdict),
            _ => None,
        }
    }

    /// Accepts what is finished, drops what belongs to another picture of ours, and makes the map if it is shown.
    pub fn refresh(&mut self, ctx: &Context, generation: u64, is_map_shown: bool) {
        if self.generation != generation {
            *self = Self::default();
            self.generation = generation;
        }
        if let State::Running(_, working) = &mut self.state
            && let Some(outcome) = working.poll()
        {
            self.state = State::Done(outcome.flatten());
        }
        if let State::Done(Ok(verdict)) = &self.state
            && is_map_shown
        {
            let verdict = Arc::clone(verdict);
            self.map.refresh(ctx, Version::whole((), Tone::PLAIN), move || {
                let pictures = &verdict.shown;
                let map = verdict::map_film(&pictures.z, pictures.theirs.size);
                ((), developed::of_film(&map, &Tone::PLAIN))
            });
        }
    }

    /// Shows the button that starts it, which waits until both pictures are finished, and stops it. Returns whether to judge.
    pub fn button(&self, ui: &mut Ui, is_finished: bool) -> bool {
        if let State::Running(..) = &self.state {
            if ui.button("Stop").on_hover_text("What is known by then is said").clicked() {
                self.stop();
            }
            return false;
        }
        let hint = "Is the difference noise? Renders pictures of ours with other seeds, as `groundtruth verify` does";
        let button = ui.add_enabled(is_finished, Button::new("Judge")).on_hover_text(hint);
        button.on_disabled_hover_text("When both pictures are finished").clicked()
    }

    /// Shows how far it is, or the verdict; `false` if nobody asked to judge.
    pub fn show(&self, ui: &mut Ui, shows: Shows) -> bool {
        match &self.state {
            State::Nothing => return false,
            State::Running(course, _) => {
                ui.horizontal_wrapped(|ui| {
                    ui.spinner();
                    ui.label(course.words());
                });
            }
            State::Done(Err(problem)) => drop(ui.label(problem)),
            State::Done(Ok(verdict)) => {
                let color = match verdict.decision {
                    Decision::Agrees => ink(ui.visuals(), AGREES),
                    Decision::Differs => ui.visuals().error_fg_color,
                    Decision::Undecided => ui.visuals().warn_fg_color,
                };
                let z = verdict.regions.first().and_then(|region| region.z);
                let z = z.map_or(String::new(), |z| format!(", z = {z:+.1}"));
                let text = RichText::new(verdict.sentence() + &z).color(color);
                let text = text.size(VERDICT).strong();
                ui.label(text).on_hover_text(RichText::new(verdict.to_string()).monospace());
            }
        }
        if shows == Shows::Map {
            ui.weak("white: theirs is brighter, z ≥ 6 · grey: 0 · black: darker, z ≤ −6");
        }
        true
    }

    /// Frames the regions, each with its number. A click on a number selects the worst pixel.
    pub fn show_frames(&self, ui: &Ui, placement: &Placement) -> Option<Action> {
        let mut explained = None;
        for (number, region) in (1..).zip(&self.verdict()?.regions) {
            let [x, y, w, h] = region.bounds.map(|along| along as u32);
            let frame = placement.part([x, y], [w, h]);
            // at the right: rows are counted at the left
            let corner = frame.right_top() - vec2(NUMBER, 0.0);
            let tag = Rect::from_min_size(corner, vec2(NUMBER, NUMBER));
            let response = ui.interact(tag, Id::unique(("region", number)), Sense::click());
            let name = format!("region {number}");
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            for (width, color) in [(4.0, Color32::BLACK), (2.0, ORANGE)] {
                let stroke = Stroke::new(width, color);
                ui.painter().rect_stroke(frame, 0.0, stroke, StrokeKind::Middle);
            }
            ui.painter().rect_filled(tag, 0.0, ORANGE);
            let (at, font) = (tag.center(), FontId::proportional(12.0));
            ui.painter().text(at, Align2::CENTER_CENTER, number, font, Color32::BLACK);
            if response.on_hover_text(region.to_string()).clicked() {
                explained = Some(Action::Select(region.worst.map(|along| along as u32)));
            }
        }
        explained
    }
}

impl Drop for Judgement {
    fn drop(&mut self) {
        self.stop();
    }
}

/// The colour of regions, as on the page of `groundtruth verify`.
const ORANGE: Color32 = Color32::from_rgb(255, 136, 0);
