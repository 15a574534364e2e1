//! The layer that is shown in place of the picture: found on a background thread, coarse first.

use std::sync::Arc;

use eframe::egui::{Button, ComboBox, Context, Painter, Ui};
use groundtruth::film::{Film, Tone};
use groundtruth::render::Canvas;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use layers::{Colors, Layer, LegendRow};

use crate::action::Shows;
use crate::picture::developed::{self, Developed, Version};
use crate::picture::tiles::Images;
use crate::picture::view::Placement;
use crate::picture::worker::{Background, Rendering};

/// The layers of a comparison, which are chosen in the same list.
pub struct Compared<'a> {
    /// The view of the two pictures.
    pub shows: &'a mut Shows,
    /// Whether there is a verdict, and so a map of z.
    pub is_judged: bool,
}

impl Compared<'_> {
    /// Shows their entries of the list. Returns whether one was chosen.
    fn choose(&mut self, ui: &mut Ui) -> bool {
        let mut is_chosen = false;
        for wanted in [Shows::Difference, Shows::Map] {
            let Some((name, about)) = named(wanted) else { continue };
            let entry = Button::selectable(*self.shows == wanted, name);
            let is_there = wanted != Shows::Map || self.is_judged;
            let entry = ui.add_enabled(is_there, entry).on_hover_text(about);
            let entry = entry.on_disabled_hover_text("Once the picture is judged");
            if entry.clicked() {
                (*self.shows, is_chosen) = (wanted, true);
            }
        }
        is_chosen
    }
}

/// The name of a view of two pictures that is a layer, and what it is.
pub fn named(shows: Shows) -> Option<(&'static str, &'static str)> {
    match shows {
        Shows::Difference => Some(("difference", "The other picture less ours, around grey (D)")),
        Shows::Map => Some(("map of z", "The difference in standard deviations, around grey (Z)")),
        Shows::Ours | Shows::Theirs | Shows::Swipe => None,
    }
}

/// Which layer is shown, if one is, as far as it is found.
#[derive(Default)]
pub struct ChosenLayer {
    /// The layer; the picture if `None`.
    pub chosen: Option<Layer>,
    offered: Vec<Layer>,
    /// The rendering whose layers are offered.
    offered_of: Option<u64>,
    offering: Background<(u64, Vec<Layer>)>,
    finding: Option<Finding>,
    developed: Developed<Found, (Colors, Vec<LegendRow>)>,
}

/// A layer, and the rendering that it is of.
type Found = (Layer, u64);

/// A layer that is being found. Dropping it stops the work.
struct Finding {
    of: Found,
    canvas: Arc<Canvas>,
    running: Background<()>,
}

impl Drop for Finding {
    fn drop(&mut self) {
        self.canvas.cancel();
    }
}

impl Finding {
    fn start(ctx: &Context, rendering: &Rendering, of: Found) -> Self {
        let canvas = Arc::new(Canvas::new(&rendering.world));
        let mut running = Background::default();
        let (world, found) = (Arc::clone(&rendering.world), Arc::clone(&canvas));
        let layer = of.0.clone();
        let value = move |pixel| layer.to_film(layer.value(&*world, pixel));
        running.start_in_slices(ctx, move |slice| {
            let is_whole = found.fill_until(&value, &|| slice.is_over());
            (is_whole || found.is_cancelled()).then_some(())
        });
        Self { of, canvas, running }
    }

    fn version(&mut self, tone: Tone) -> Version<Found> {
        // in this order: a layer that is finished now is completely in its film
        let _ = self.running.poll();
        let is_finished = !self.running.is_busy();
        let done = self.canvas.progress().0;
        Version { of: self.of.clone(), done, is_finished, tone }
    }
}

/// A layer so far: its colours, its legend and its tiles.
fn develop(
    canvas: &Canvas,
    world: &World,
    layer: &Layer,
    tone: Tone,
) -> ((Colors, Vec<LegendRow>), Images) {
    let [width, height] = canvas.look(|film| [film.width(), film.height()]);
    let found: Vec<Rgb> = canvas.look_partly(|picture| {
        let all = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        all.filter_map(|at| picture.get(at)).collect()
    });
    let known = || found.iter().map(|value| layer.from_film(*value));
    let colors = Colors::of(layer, known().flatten(), world, tone);
    let legend = colors.legend(layer, known());
    let images = developed::so_far(canvas, |value| colors.color(layer.from_film(value)));
    ((colors, legend), images)
}

impl ChosenLayer {
    /// Shows the list of layers, with those of a comparison below the picture; in a narrow bar without its name.
    pub fn choose(&mut self, ui: &mut Ui, is_narrow: bool, mut compared: Option<Compared<'_>>) {
        let label = (!is_narrow).then(|| ui.label("Layer"));
        let width = if is_narrow { 64.0 } else { 130.0 };
        let beside = compared.as_ref().and_then(|it| named(*it.shows));
        let of_scene = || self.chosen.as_ref().map_or("picture".to_owned(), Layer::to_string);
        let name = beside.map_or_else(of_scene, |(name, _)| name.to_owned());
        let list = ComboBox::from_id_salt("layer")
            .selected_text(name)
            .truncate()
            .width(width)
            .height(480.0);
        let entries = |ui: &mut Ui| {
            for layer in &self.offered {
                let chosen = Some(layer).filter(|layer| **layer != Layer::PICTURE).cloned();
                let is_shown = beside.is_none() && self.chosen == chosen;
                let entry = ui.selectable_label(is_shown, layer.to_string());
                if entry.on_hover_text(layer.kind().about).clicked() {
                    let is_hidden = chosen.is_some() || beside.is_some();
                    if let Some(compared) = compared.as_mut().filter(|_| is_hidden) {
                        // ours, of which it is a layer
                        *compared.shows = Shows::Ours;
                    }
                    self.chosen = chosen;
                }
                if let Some(compared) = compared.as_mut().filter(|_| *layer == Layer::PICTURE)
                    && compared.choose(ui)
                {
                    self.chosen = None;
                }
            }
        };
        let list = list.show_ui(ui, entries).response.on_hover_text("What is shown of each pixel");
        if let Some(label) = label {
            list.labelled_by(label.id);
        }
    }

    /// Starts to find the layer that is chosen, and shows it as far as it is found.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering, tone: Tone) {
        self.offer(ctx, rendering);
        let Some(layer) = &self.chosen else {
            (self.finding, self.developed) = (None, Developed::default());
            return;
        };
        let of = (layer.clone(), rendering.generation);
        if self.finding.as_ref().is_none_or(|finding| finding.of != of) {
            // the old one is dropped here, which stops it
            self.finding = Some(Finding::start(ctx, rendering, of.clone()));
            self.developed = Developed::default();
        }
        let Some(finding) = &mut self.finding else { return };
        let (canvas, world) = (Arc::clone(&finding.canvas), Arc::clone(&rendering.world));
        let develop = move || develop(&canvas, &world, &of.0, tone);
        self.developed.refresh(ctx, finding.version(tone), develop);
    }

    /// Finds out which layers the scene has.
    fn offer(&mut self, ctx: &Context, rendering: &Rendering) {
        if let Some(Ok((generation, layers))) = self.offering.poll() {
            (self.offered_of, self.offered) = (Some(generation), layers);
        }
        if self.offered_of != Some(rendering.generation) && !self.offering.is_busy() {
            let (world, generation) = (Arc::clone(&rendering.world), rendering.generation);
            self.offering.start(ctx, move || (generation, Layer::of_scene(&world)));
        }
    }

    /// Whether the screen shows all of the chosen layer.
    pub fn is_fresh(&self, rendering: &Rendering) -> bool {
        let is_shown = |layer: &Layer| {
            let version = self.developed.version().filter(|version| version.is_finished);
            version.is_some_and(|it| it.of.0 == *layer && it.of.1 == rendering.generation)
        };
        !self.offering.is_busy()
            && !self.developed.is_busy()
            && self.chosen.as_ref().is_none_or(is_shown)
    }

    /// The found part of the layer, from 0 to 1, while it is being found.
    pub fn progress(&self) -> Option<f32> {
        let finding = self.finding.as_ref().filter(|finding| finding.running.is_busy())?;
        let (done, whole) = finding.canvas.progress();
        Some(done as f32 / whole as f32)
    }

    /// The layer, and a film of its values once all are found.
    pub fn film(&self) -> Option<(Layer, Option<Film>)> {
        let layer = self.chosen.clone()?;
        let finding = self.finding.as_ref().filter(|it| it.of.0 == layer && self.is_complete());
        Some((layer, finding.map(|finding| finding.canvas.film())))
    }

    /// The value of the layer at a pixel, if it is found; `Some(None)` where nothing is hit.
    pub fn value(&self, pixel: [u32; 2]) -> Option<Option<Rgb>> {
        let finding = self.finding.as_ref()?;
        let value = finding.canvas.look_partly(|picture| picture.get(pixel))?;
        Some(finding.of.0.from_film(value))
    }

    /// The layer's name and its value at a pixel, in words.
    pub fn in_words(&self, rendering: &Rendering, pixel: [u32; 2]) -> Option<String> {
        let layer = self.chosen.as_ref()?;
        Some(match self.value(pixel) {
            None => format!("{layer} follows"),
            Some(None) => format!("{layer} none"),
            Some(Some(value)) => format!("{layer} {}", layer.in_words(value, &rendering.world)),
        })
    }

    /// The colour of a value.
    pub fn color(&self, value: Option<Rgb>) -> Option<[u8; 3]> {
        Some(self.developed.shown.as_ref()?.1.0.color(value))
    }

    /// The legend of what is shown.
    pub fn legend(&self) -> Option<(&Layer, &[LegendRow])> {
        let (version, (_, legend)) = self.developed.shown.as_ref()?;
        Some((&version.of.0, legend))
    }

    /// Whether all pixels are shown.
    pub fn is_complete(&self) -> bool {
        self.developed.is_whole()
    }

    /// Draws what is shown.
    pub fn paint(&self, painter: &Painter, placement: &Placement) {
        self.developed.paint(painter, placement, |_| true);
    }
}
