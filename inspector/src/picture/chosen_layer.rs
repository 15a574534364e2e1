//! The layer that is shown in place of the picture: found on a background thread, coarse first.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{Button, Color32, ComboBox, Context, Painter, Ui};
use groundtruth::film::{Film, Tone};
use groundtruth::render::Canvas;
use groundtruth::rgb::Rgb;
use layers::{Colors, Layer, LegendRow};
use web_time::Instant;

use crate::action::Shows;
use crate::picture::tiles::{self, Images, Tiles};
use crate::picture::view::Placement;
use crate::picture::worker::{Background, Rendering};

/// The interval at which an unfinished layer is updated.
const REFRESH: Duration = Duration::from_millis(150);
/// The opacity of the coarse layer, through which the hatching shows.
const COARSE_ALPHA: u8 = 215;

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
    shown: Option<Shown>,
    tiles: Tiles,
    developing: Background<(Shown, Images)>,
    developed: Option<Instant>,
}

/// A layer that is being found. Dropping it stops the work.
struct Finding {
    layer: Layer,
    generation: u64,
    canvas: Arc<Canvas>,
    running: Background<()>,
}

impl Drop for Finding {
    fn drop(&mut self) {
        self.canvas.cancel();
    }
}

/// The version of a layer that the tiles show.
#[derive(Clone, PartialEq)]
struct Version {
    layer: Layer,
    generation: u64,
    done: u64,
    is_finished: bool,
    tone: Tone,
}

/// A version, its colours and its legend.
struct Shown {
    version: Version,
    colors: Colors,
    legend: Vec<LegendRow>,
}

impl Finding {
    fn start(ctx: &Context, rendering: &Rendering, layer: Layer) -> Self {
        let canvas = Arc::new(Canvas::new(&rendering.world));
        let mut running = Background::default();
        let (world, found, of) = (Arc::clone(&rendering.world), Arc::clone(&canvas), layer.clone());
        let value = move |pixel| of.to_film(of.value(&*world, pixel));
        running.start_in_slices(ctx, move |slice| {
            let is_whole = found.fill_until(&value, &|| slice.is_over());
            (is_whole || found.is_cancelled()).then_some(())
        });
        Self { layer, generation: rendering.generation, canvas, running }
    }

    fn version(&mut self, tone: Tone) -> Version {
        // in this order: a layer that is finished now is completely in its film
        let _ = self.running.poll();
        let is_finished = !self.running.is_busy();
        let done = self.canvas.progress().0;
        let (layer, generation) = (self.layer.clone(), self.generation);
        Version { layer, generation, done, is_finished, tone }
    }
}

/// A layer so far: its colours, its legend and its tiles. Shows the coarse layer, or nothing, for a pixel that is not
/// found yet.
fn develop(
    canvas: &Canvas,
    world: &groundtruth::world::World,
    version: Version,
) -> (Shown, Images) {
    let layer = &version.layer;
    let size @ [width, height] = canvas.look(|film| [film.width(), film.height()]);
    let found: Vec<(Option<Rgb>, Option<Rgb>)> = canvas.look_partly(|picture| {
        let all = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        all.map(|at| (picture.get(at), picture.coarse(at))).collect()
    });
    let known = || found.iter().filter_map(|(value, _)| Some(layer.from_film((*value)?)));
    let colors = Colors::of(layer, known().flatten(), world, version.tone);
    let legend = colors.legend(layer, known());
    let color = |(value, coarse): (Option<Rgb>, Option<Rgb>)| {
        let alpha = if value.is_some() { u8::MAX } else { COARSE_ALPHA };
        let Some(value) = value.or(coarse) else { return Color32::TRANSPARENT };
        let [r, g, b] = colors.color(layer.from_film(value));
        Color32::from_rgba_unmultiplied(r, g, b, alpha)
    };
    let images = tiles::images(size, |positions| {
        positions.map(|[x, y]| color(found[y as usize * width as usize + x as usize])).collect()
    });
    (Shown { version, colors, legend }, images)
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
        let developed = self.developing.poll().and_then(Result::ok);
        let Some(layer) = &self.chosen else {
            (self.finding, self.shown) = (None, None);
            return;
        };
        let is_of = |finding: &Finding| {
            finding.layer == *layer && finding.generation == rendering.generation
        };
        if !self.finding.as_ref().is_some_and(is_of) {
            // the old one is dropped here, which stops it
            self.finding = Some(Finding::start(ctx, rendering, layer.clone()));
            (self.shown, self.developed) = (None, None);
        }
        let Some(finding) = &mut self.finding else { return };
        let wanted = finding.version(tone);
        if let Some((shown, images)) = developed
            && shown.version.layer == wanted.layer
            && shown.version.generation == wanted.generation
        {
            self.tiles.upload(ctx, images);
            self.shown = Some(shown);
        }
        let is_new = self.shown.as_ref().is_none_or(|shown| shown.version != wanted);
        let is_early = self.developed.is_some_and(|at| at.elapsed() < REFRESH);
        if !is_new || (is_early && !wanted.is_finished) || self.developing.is_busy() {
            return;
        }
        self.developed = Some(Instant::now());
        let (canvas, world) = (Arc::clone(&finding.canvas), Arc::clone(&rendering.world));
        self.developing.start(ctx, move || develop(&canvas, &world, wanted));
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
            self.shown.as_ref().is_some_and(|Shown { version, .. }| {
                let is_this = version.layer == *layer && version.generation == rendering.generation;
                is_this && version.is_finished
            })
        };
        !self.offering.is_busy()
            && !self.developing.is_busy()
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
        let finding = self.finding.as_ref().filter(|it| it.layer == layer && self.is_complete());
        Some((layer, finding.map(|finding| finding.canvas.film())))
    }

    /// The value of the layer at a pixel, if it is found; `Some(None)` where nothing is hit.
    pub fn value(&self, pixel: [u32; 2]) -> Option<Option<Rgb>> {
        let finding = self.finding.as_ref()?;
        let value = finding.canvas.look_partly(|picture| picture.get(pixel))?;
        Some(finding.layer.from_film(value))
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
        Some(self.shown.as_ref()?.colors.color(value))
    }

    /// The legend of what is shown.
    pub fn legend(&self) -> Option<(&Layer, &[LegendRow])> {
        let shown = self.shown.as_ref()?;
        Some((&shown.version.layer, &shown.legend))
    }

    /// Whether all pixels are shown.
    pub fn is_complete(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| shown.version.is_finished)
    }

    /// Draws what is shown.
    pub fn paint(&self, painter: &Painter, placement: &Placement) {
        if self.shown.is_some() {
            self.tiles.paint(painter, placement, Color32::WHITE);
        }
    }
}
