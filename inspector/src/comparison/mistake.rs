//! The picture of a program with a known mistake, which is held against ours as that of a file is.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use eframe::egui::{ComboBox, Context, Ui};
use groundtruth::film::Film;
use groundtruth::render::{self, Canvas, Renderer};
use judge::mistakes::{self, Mistake, Mistaken};

use crate::action::{Action, Purpose, Shows};
use crate::comparison::theirs::Theirs;
use crate::picture::worker::{Background, Rendering};

/// The choice of a mistake, and the work on its picture.
#[derive(Default)]
pub struct WithMistake {
    chosen: Option<&'static Mistake>,
    /// The picture of ours, by its generation, and the mistake that the work is for.
    asked: Option<(u64, &'static Mistake)>,
    is_stopped: Arc<AtomicBool>,
    working: Background<Made>,
    /// The view of the pictures before.
    shows: Shows,
}

/// The program and its picture; `None` if the mistake changes nothing of the scene.
type Made = Result<Option<(Mistaken, Film)>, String>;

impl WithMistake {
    /// Whether a picture is being made.
    pub fn is_busy(&self) -> bool {
        self.working.is_busy()
    }

    /// Chooses a mistake, or none.
    pub fn choose(&mut self, mistake: Option<&'static Mistake>) {
        self.chosen = mistake;
    }

    /// Shows the list of mistakes: those that the scene of the gallery shows, or all; and a button for a picture of a
    /// file instead.
    pub fn show(&mut self, ui: &mut Ui, rendering: &Rendering) -> Option<Action> {
        let name = self.chosen.map_or("none", |mistake| mistake.name);
        let label = ui.label("With the mistake");
        let list = ComboBox::from_id_salt("mistake").selected_text(name).truncate();
        let list = list.width(ui.available_width().min(180.0)).show_ui(ui, |ui| {
            ui.selectable_value(&mut self.chosen, None, "none");
            for mistake in offered(rendering) {
                let entry = ui.selectable_value(&mut self.chosen, Some(mistake), mistake.name);
                entry.on_hover_text(format!("ch. {}: {}", mistake.chapter, mistake.words));
            }
        });
        let hint = "Another picture, by a program with this mistake; T flips between right and wrong, and explains the \
                    one that is shown";
        list.response.labelled_by(label.id).on_hover_text(hint);
        if self.is_busy() {
            ui.spinner();
        }
        let button = ui.button("Compare with …");
        let hint = "A picture of another program, which can also be dropped on the window: ours is rendered at its size";
        button.on_hover_text(hint).clicked().then_some(Action::Choose(Purpose::Theirs))
    }

    /// Starts to make the picture that is chosen, and puts it in the place of theirs once it is made. Returns why there
    /// is none.
    pub fn refresh(
        &mut self,
        ctx: &Context,
        rendering: &Rendering,
        theirs: &mut Option<Theirs>,
    ) -> Option<String> {
        let wanted = self.chosen.map(|mistake| (rendering.generation, mistake));
        if wanted != self.asked {
            self.is_stopped.store(true, Ordering::Relaxed);
            self.shows = theirs.take().map_or(self.shows, |theirs| theirs.shows);
            (self.asked, self.working) = (wanted, Background::default());
            if let Some((_, mistake)) = wanted {
                self.start(ctx, rendering, mistake);
            }
        }
        let made = self.working.poll()?.unwrap_or_else(|lost| Err(lost.to_string()));
        let (_, mistake) = self.asked?;
        match made {
            Ok(Some((program, film))) => {
                *theirs = Some(Theirs::with_mistake(program, film, self.shows));
                None
            }
            Ok(None) => {
                (self.chosen, self.asked) = (None, None);
                Some(format!(
                    "the scene has nothing that {} changes ({})",
                    mistake.name, mistake.words
                ))
            }
            Err(error) => {
                (self.chosen, self.asked) = (None, None);
                Some(error)
            }
        }
    }

    fn start(&mut self, ctx: &Context, rendering: &Rendering, mistake: &'static Mistake) {
        self.is_stopped = Arc::default();
        let (scene, is_stopped) = (Arc::clone(&rendering.scene), Arc::clone(&self.is_stopped));
        let (folder, seed) = (rendering.source.folder().to_owned(), rendering.world.seed);
        self.working.start(ctx, move || {
            let program = Mistaken::new(mistake, &scene, &folder, seed);
            let Some(program) = program.map_err(|error| error.to_string())? else {
                return Ok(None);
            };
            let canvas = Canvas::new(program.world());
            let stop = || {
                if is_stopped.load(Ordering::Relaxed) {
                    canvas.cancel();
                }
            };
            render::watched(|| canvas.render(&program), stop);
            let film = canvas.film();
            Ok(Some((program, film)))
        });
    }
}

/// The mistakes that a scene of the gallery shows; all of them for other scenes.
fn offered(rendering: &Rendering) -> Vec<&'static Mistake> {
    match rendering.source.entry() {
        Some(entry) => mistakes::shown_by(entry.name).iter().map(|pair| pair.mistake).collect(),
        None => mistakes::all(),
    }
}
