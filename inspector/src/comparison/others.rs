//! The pictures that ours can be compared with: those of files, and those that are made from the scene. One of them is
//! held against ours.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use eframe::egui::Context;
use judge::mistakes::Mistake;
use rays::{Logged, RayPlace};

use crate::action::{Shows, With};
use crate::comparison::entry::{Entry, MadeBeside};
use crate::comparison::opening;
use crate::comparison::pixel_command::PixelCommand;
use crate::comparison::program::Program;
use crate::comparison::recipe::{Made, Recipe};
use crate::comparison::theirs::Theirs;
use crate::picture::session::Session;
use crate::picture::worker::{Background, Rendering};
use crate::scene::source::Source;
use crate::scene::watch::Watch;

/// All pictures beside ours, in the order in which they came.
#[derive(Default)]
pub struct Others {
    entries: Vec<Entry>,
    /// The place of the one that is held against ours.
    chosen: usize,
    /// The number of the next entry or program.
    next_number: u32,
    /// The selected pixel, for which a program is run.
    pub pixel: Option<[u32; 2]>,
    /// The entry that is being made, and beside what.
    asked: Option<(u32, MadeBeside)>,
    is_stopped: Arc<AtomicBool>,
    working: Background<Made>,
    /// The view of the picture before.
    shows: Shows,
    /// The files that are read, in the order in which they were named, and what is said of each.
    opening: VecDeque<(String, Background<Result<Theirs, String>>)>,
    /// How many states were kept.
    kept: usize,
    /// The logs of rays, which are read again when they are written again.
    watch: Watch,
    /// The ray that a log begins with that was read: the first that breaks a law. Taken once.
    pub first: Option<RayPlace>,
}

/// What the user must know, and whether it is an error.
pub type Message = (String, bool);

impl Others {
    /// The picture that is held against ours, once it is made.
    pub fn shown(&self) -> Option<&Theirs> {
        self.entries.get(self.chosen)?.theirs.as_ref()
    }

    /// As [`Self::shown`].
    pub fn shown_mut(&mut self) -> Option<&mut Theirs> {
        self.entries.get_mut(self.chosen)?.theirs.as_mut()
    }

    /// Does what a user asks for.
    pub fn perform(
        &mut self,
        ctx: &Context,
        session: &mut Session,
        asked: With,
    ) -> Option<Message> {
        match asked {
            With::Picture(path) => {
                let said = format!("reading {}", path.display());
                let mut reading = Background::default();
                reading.start(ctx, move || Theirs::read(&path, None));
                self.opening.push_back((said, reading));
            }
            With::Field(change) => self.add(Recipe::Field(change)),
            With::Scene(source) => self.add(Recipe::Scene(source)),
            With::State => {
                self.kept += 1;
                let name = format!("state {}", self.kept);
                self.add(Recipe::State(name, session.rendering.built.clone()));
            }
            With::Other(index) => return self.choose_fitting(ctx, session, index),
            With::Next => {
                let next = (self.chosen + 1) % self.entries.len().max(1);
                return self.choose_fitting(ctx, session, next);
            }
            With::NoMore => self.let_go(),
            With::Flip(shows) => self.shown_mut().into_iter().for_each(|it| it.flip(shows)),
            With::Judge => {
                let theirs = self.shown_mut()?;
                let picture = theirs.pixels.picture()();
                theirs.judgement.start(ctx, &session.rendering, picture);
            }
        }
        None
    }

    /// Holds another one against ours, which is rendered at its size if it is of a file.
    fn choose_fitting(
        &mut self,
        ctx: &Context,
        session: &mut Session,
        index: usize,
    ) -> Option<Message> {
        self.choose(index);
        let of_file = self.shown().filter(|theirs| theirs.program.is_none())?;
        opening::fit(ctx, session, of_file).err().map(|problem| (problem, true))
    }

    /// Holds the picture of a file that is read now against ours, which is rendered at its size.
    pub fn accept_opened(&mut self, ctx: &Context, session: &mut Session) -> Option<Message> {
        let read = self.opening.front_mut()?.1.poll()?;
        self.opening.pop_front();
        let picture = match read.flatten() {
            Ok(picture) if session.waiting.is_none() => picture,
            Ok(_) => {
                return Some(("there is no picture of ours to compare with yet".to_owned(), true));
            }
            Err(error) => return Some((error, true)),
        };
        let mut notes = picture.notes().to_vec();
        match opening::fit(ctx, session, &picture) {
            Ok(note) => notes.extend(note),
            Err(error) => return Some((error, true)),
        }
        self.add_picture(picture);
        (!notes.is_empty()).then(|| (notes.join("; "), false))
    }

    /// What is being read, in words.
    pub fn reading(&self) -> Option<&str> {
        self.opening.front().map(|(said, _)| &**said)
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.entries.len()
    }

    /// The name of each, and all that there is to say of it.
    pub fn names(&self) -> Vec<[String; 2]> {
        let both = |entry: &Entry| {
            let name = entry.name();
            [name.clone(), entry.recipe.as_ref().map_or(name, Recipe::about)]
        };
        self.entries.iter().map(both).collect()
    }

    /// The place of the one that is held against ours.
    pub fn chosen(&self) -> usize {
        self.chosen
    }

    /// Adds the picture of a file, and holds it against ours.
    pub fn add_picture(&mut self, theirs: Theirs) {
        self.push(None, Some(theirs));
    }

    /// Adds a log of rays, unless it is there, and shows its rays.
    pub fn add_log(&mut self, path: PathBuf) {
        let is_of_log = |entry: &Entry| entry.log() == Some(&path);
        match self.entries.iter().position(is_of_log) {
            Some(index) => self.choose(index),
            None => {
                self.watch.add(path.clone());
                self.add(Recipe::Scene(Source::Rays(path)));
            }
        }
        self.shows = Shows::Theirs;
    }

    /// Runs this program for each selected pixel, and shows its rays.
    pub fn add_run(&mut self, command: PixelCommand) {
        self.add(Recipe::Run(command));
        self.shows = Shows::Theirs;
    }

    /// Runs the program again that is shown, although it was run for this pixel.
    pub fn run_again(&mut self) {
        let run = self.entries.get_mut(self.chosen).filter(|entry| entry.is_run());
        run.into_iter().for_each(|entry| entry.made_beside = None);
    }

    /// The pixel that is explained if this one is asked for: the nearest one of a log.
    pub fn nearest(&self, pixel: [u32; 2]) -> Option<[u32; 2]> {
        let entry = self.entries.get(self.chosen).filter(|entry| !entry.is_run())?;
        entry.theirs.as_ref()?.explained()?.log()?.nearest(pixel)
    }

    /// Whether the one that is held against ours is being made.
    pub fn is_making(&self) -> bool {
        self.asked.is_some()
    }

    /// Lets the logs go: they were of another scene.
    pub fn forget_logs(&mut self) {
        self.entries.retain(|entry| entry.log().is_none());
        self.choose(self.chosen);
    }

    /// The log of the picture that is held against ours, if it is known by one.
    pub fn log(&self) -> Option<&Logged> {
        self.shown()?.log()
    }

    /// Whose rays stand beside those that are explained: ours if `None`; of a log that is alone those of another log that was
    /// looked at. Nobody's, if there is only one picture.
    pub fn beside(&self) -> Option<Option<&Arc<Program>>> {
        let shown = self.shown()?;
        let program = shown.program.as_ref()?;
        if shown.is_twin() {
            return Some(Some(program).filter(|_| shown.explained().is_none()));
        }
        let mut made =
            self.entries.iter().filter_map(|entry| entry.theirs.as_ref()?.program.as_ref());
        Some(Some(made.rfind(|it| it.log().is_some() && it.number != program.number)?))
    }

    /// Adds a picture that is made from the scene, and holds it against ours, side by side.
    pub fn add(&mut self, recipe: Recipe) {
        self.push(Some(recipe), None);
        self.shows = Shows::default();
    }

    fn push(&mut self, recipe: Option<Recipe>, theirs: Option<Theirs>) {
        let number = self.number();
        self.entries.push(Entry { number, recipe, made_beside: None, theirs });
        self.choose(self.entries.len() - 1);
    }

    fn number(&mut self) -> u32 {
        self.next_number += 1;
        self.next_number
    }

    /// Holds another one against ours, in the same view.
    pub fn choose(&mut self, index: usize) {
        let shows = self.shown().map_or(self.shows, |theirs| theirs.shows);
        self.shows = shows;
        self.chosen = index.min(self.entries.len().saturating_sub(1));
        if let Some(theirs) = self.shown_mut() {
            theirs.shows = shows;
        }
    }

    /// Lets the one that is held against ours go.
    pub fn let_go(&mut self) {
        if self.chosen < self.entries.len() {
            self.shows = self.shown().map_or(self.shows, |theirs| theirs.shows);
            self.entries.remove(self.chosen);
            self.choose(self.chosen);
        }
    }

    /// The mistake of the one that is held against ours.
    pub fn mistake(&self) -> Option<&'static Mistake> {
        let recipe = self.entries.get(self.chosen)?.recipe.as_ref()?;
        if let Recipe::Mistake(mistake) = recipe { Some(mistake) } else { None }
    }

    /// Holds the picture of a program with this mistake against ours, in place of that with another one; without one, lets
    /// it go.
    pub fn set_mistake(&mut self, mistake: Option<&'static Mistake>) {
        let is_of_mistake = |entry: &Entry| matches!(entry.recipe, Some(Recipe::Mistake(_)));
        let at = self.entries.iter().position(is_of_mistake);
        at.into_iter().for_each(|at| self.choose(at));
        match (at, mistake.map(Recipe::Mistake)) {
            (None, None) => {}
            (None, Some(recipe)) => self.add(recipe),
            (Some(_), None) => self.let_go(),
            (Some(at), Some(recipe)) => {
                let number = self.number();
                self.entries[at] =
                    Entry { number, recipe: Some(recipe), made_beside: None, theirs: None };
            }
        }
    }

    /// Whether anything is still being computed for what is shown.
    pub fn is_busy(&self, rendering: &Rendering) -> bool {
        let is_due = self.wanted(rendering).is_some();
        is_due
            || self.working.is_busy()
            || !self.opening.is_empty()
            || self.shown().is_some_and(|theirs| theirs.is_busy(rendering))
    }

    /// What must be made: the entry, and the rendering of ours.
    fn wanted(&self, rendering: &Rendering) -> Option<(u32, MadeBeside)> {
        let entry = self.entries.get(self.chosen).filter(|entry| entry.recipe.is_some())?;
        let pixel = if entry.is_run() { Some(self.pixel?) } else { None };
        let beside = (rendering.generation, pixel);
        (entry.made_beside != Some(beside)).then_some((entry.number, beside))
    }

    /// Starts to make the picture that is chosen, and holds it against ours once it is made. Returns why there is none, or
    /// not all of it.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering) -> Option<String> {
        if self.watch.follow(ctx) {
            let of_log = self.entries.iter_mut().filter(|entry| entry.log().is_some());
            of_log.for_each(|entry| entry.made_beside = None);
        }
        let wanted = self.wanted(rendering);
        if wanted != self.asked {
            self.is_stopped.store(true, Ordering::Relaxed);
            (self.asked, self.working) = (wanted, Background::default());
            if wanted.is_some() {
                self.start(ctx, rendering);
            }
        }
        let made = self.working.poll()?.flatten();
        let (_, beside) = self.asked.take()?;
        let problem = match made {
            Ok(Some((mut program, film))) => {
                program.number = self.number();
                let first = program.log().and_then(Logged::first_place);
                let problem = program.problem.take();
                let theirs = Theirs::of_program(ctx, program, film, self.shows);
                let entry = self.entries.get_mut(self.chosen)?;
                self.first = first.filter(|_| entry.theirs.is_none());
                (entry.theirs, entry.made_beside) = (Some(theirs), Some(beside));
                return problem;
            }
            Ok(None) => self.mistake().map_or(String::new(), |mistake| {
                let (name, words) = (mistake.name, mistake.words);
                format!("the scene has nothing that {name} changes ({words})")
            }),
            Err(error) => error,
        };
        match self.entries.get_mut(self.chosen) {
            Some(entry) if entry.is_run() => {
                (entry.theirs, entry.made_beside) = (None, Some(beside));
            }
            Some(entry) if entry.log().is_some() && entry.theirs.is_some() => {
                entry.made_beside = Some(beside);
            }
            _ => self.let_go(),
        }
        Some(problem)
    }

    fn start(&mut self, ctx: &Context, rendering: &Rendering) {
        let Some(entry) = self.entries.get_mut(self.chosen) else { return };
        let Some(recipe) = &entry.recipe else { return };
        self.is_stopped = Arc::default();
        let (pixel, is_stopped) = (self.pixel.unwrap_or_default(), Arc::clone(&self.is_stopped));
        let (recipe, ours) = (recipe.clone(), rendering.built.clone());
        self.working.start(ctx, move || recipe.make(ours, (pixel, &is_stopped)));
        let log = entry.theirs.as_ref().and_then(Theirs::log);
        let has_pixel = log.is_some_and(|log| log.nearest(pixel) == Some(pixel));
        if entry.log().is_some() || has_pixel {
            // shown until the program has written a whole one
            return;
        }
        // one beside an earlier picture of ours, or of another pixel
        self.shows = entry.theirs.take().map_or(self.shows, |theirs| theirs.shows);
    }
}

impl Drop for Others {
    fn drop(&mut self) {
        self.is_stopped.store(true, Ordering::Relaxed);
        if self.entries.get(self.chosen).is_some_and(Entry::is_run) {
            // the program ends before the window does
            let _ = self.working.wait(Duration::from_secs(1));
        }
    }
}
