//! The layer that is shown in place of the picture: found on a background thread, coarse first.

use std::sync::Arc;

use eframe::egui::{ComboBox, Context, Painter, Ui};
use groundtruth::film::{Film, Tone};
use groundtruth::render::Canvas;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use layers::{Colors, Layer, LegendRow};

use crate::action::Shows;
use crate::picture::developed::{self, Developed};
use crate::picture::tiles::Images;
use crate::picture::view::Placement;
use crate::picture::worker::{Background, Growing, Rendering};

/// The name of a view of two pictures that is a layer.
pub fn named(shows: Shows) -> Option<&'static str> {
    match shows {
        Shows::Difference => Some("difference"),
        Shows::Map => Some("map of z"),
        Shows::Ours | Shows::Theirs | Shows::Swipe => None,
    }
}

/// Which layer is shown, if one is, as far as it is found.
#[derive(Default)]
pub struct ChosenLayer {
    /// The layer; the picture if `None`.
    pub chosen: Option<Layer>,
    /// The layers of a rendering, once they are known.
    offered: Option<(u64, Vec<Layer>)>,
    offering: Background<(u64, Vec<Layer>)>,
    finding: Option<(Found, Growing)>,
    developed: Developed<Found, (Colors, Vec<LegendRow>)>,
}

/// A layer, and the rendering that it is of.
type Found = (Layer, u64);

/// Starts to find a layer.
fn find(ctx: &Context, rendering: &Rendering, layer: Layer) -> Growing {
    let world = Arc::clone(&rendering.world);
    let value = move |pixel| layer.to_film(layer.value(&*world, pixel));
    Growing::start(ctx, &rendering.world, move |canvas, slice| {
        canvas.fill_until(&value, &|| slice.is_over())
    })
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
    /// Shows the list of layers; in a narrow bar without its name. One that is chosen is seen in place of another picture.
    pub fn choose(&mut self, ui: &mut Ui, is_narrow: bool, shows: Option<&mut Shows>) {
        let label = (!is_narrow).then(|| ui.label("Layer"));
        let width = if is_narrow { 64.0 } else { 130.0 };
        let beside = shows.as_deref().copied().and_then(named);
        let of_scene = self.chosen.as_ref().map_or("picture".to_owned(), Layer::to_string);
        let name = beside.map_or(of_scene, str::to_owned);
        let mut is_clicked = false;
        let list = ComboBox::from_id_salt("layer")
            .selected_text(name)
            .truncate()
            .width(width)
            .height(480.0);
        let entries = |ui: &mut Ui| {
            for layer in self.offered.iter().flat_map(|(_, layers)| layers) {
                let chosen = Some(layer).filter(|layer| **layer != Layer::PICTURE).cloned();
                let is_shown = beside.is_none() && self.chosen == chosen;
                let entry = ui.selectable_label(is_shown, layer.to_string());
                if entry.on_hover_text(layer.kind().about).clicked() {
                    (self.chosen, is_clicked) = (chosen, true);
                }
            }
        };
        let list = list.show_ui(ui, entries).response.on_hover_text("What is shown of each pixel");
        if let Some(label) = label {
            list.labelled_by(label.id);
        }
        let is_hidden = self.chosen.is_some() || beside.is_some();
        // ours, of which it is a layer
        shows.filter(|_| is_clicked && is_hidden).into_iter().for_each(|it| *it = Shows::Ours);
    }

    /// Starts to find the layer that is chosen, and shows it as far as it is found.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering, tone: Tone) {
        self.offer(ctx, rendering);
        let Some(layer) = &self.chosen else {
            (self.finding, self.developed) = (None, Developed::default());
            return;
        };
        let of = (layer.clone(), rendering.generation);
        if self.finding.as_ref().is_none_or(|(found, _)| *found != of) {
            // the old one is dropped here, which stops it
            self.finding = Some((of.clone(), find(ctx, rendering, of.0.clone())));
            self.developed = Developed::default();
        }
        let Some((_, growing)) = &self.finding else { return };
        let (canvas, world) = (Arc::clone(&growing.canvas), Arc::clone(&rendering.world));
        let version = growing.version(of.clone(), tone);
        let develop = move || develop(&canvas, &world, &of.0, tone);
        self.developed.refresh(ctx, version, develop);
    }

    /// Finds out which layers the scene has.
    fn offer(&mut self, ctx: &Context, rendering: &Rendering) {
        if let Some(Ok(offered)) = self.offering.poll() {
            self.offered = Some(offered);
        }
        let is_known = self.offered.as_ref().is_some_and(|(of, _)| *of == rendering.generation);
        if !is_known && !self.offering.is_busy() {
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
        self.finding.as_ref()?.1.part()
    }

    /// The layer, and a film of its values once all are found.
    pub fn film(&self) -> Option<(Layer, Option<Film>)> {
        let layer = self.chosen.clone()?;
        let finding = self.finding.as_ref().filter(|(of, _)| of.0 == layer && self.is_complete());
        Some((layer, finding.map(|(_, growing)| growing.canvas.film())))
    }

    /// The value of the layer at a pixel, if it is found; `Some(None)` where nothing is hit.
    pub fn value(&self, pixel: [u32; 2]) -> Option<Option<Rgb>> {
        let ((layer, _), growing) = self.finding.as_ref()?;
        let value = growing.canvas.look_partly(|picture| picture.get(pixel))?;
        Some(layer.from_film(value))
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
        self.developed.paint(painter, placement);
    }
}
