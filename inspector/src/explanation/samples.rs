//! The samples of the selected pixel: their positions in pixel, lens and light.

use eframe::egui::{
    Align2, Color32, ComboBox, FontId, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, Vec2, vec2,
};
use explain::{PixelExplanation, RecordedRay};
use groundtruth::render;
use groundtruth::samplers::{self, PathKey, Purpose, SetKey};
use groundtruth::scene::Scene;
use groundtruth::trace::RayKind;
use text::brief::{count, short};

use crate::explanation::selection::Selection;
use crate::explanation::{Shown, Subject, Version};
use crate::picture::display;
use crate::picture::worker::Rendering;

/// The largest number of points of a plot that is still readable.
const MAX_POINTS: u32 = 4096;
/// The least and the largest side of a plot, in points of the screen.
const SIDES: [f32; 2] = [120.0, 168.0];
/// The largest distance of a click from a point, in points of the screen.
const CLICK_RADIUS: f32 = 8.0;

/// The contents of the plots, computed once for each pixel of each rendering.
#[derive(Default)]
pub struct Samples {
    /// Of which picture, and the pixel.
    of: Option<(Version, [u32; 2])>,
    plots: Vec<Plot>,
    /// The light of the last plot.
    light: Option<u32>,
    /// The sample under the mouse in the last frame, whose points are lit in all plots.
    lit: Option<u32>,
}

/// The plots, by their place: the points of the pixel and of the lens are of the camera's ray, those of the light of a
/// shadow ray.
const LIGHT_PLOT: usize = 2;

/// The points of one purpose, and their plot on the screen.
pub struct Plot {
    title: &'static str,
    /// The text under the mouse.
    hint: &'static str,
    is_disk: bool,
    /// The points in sample order, in the square or the disk in it, `[−1, 1]²`, y up.
    points: Vec<[f64; 2]>,
    area: Rect,
}

impl Samples {
    /// Computes the contents, unless that is done.
    fn refresh(&mut self, subject: &Subject<'_>, pixel: [u32; 2]) {
        let version = subject.version();
        if self.of == Some((version, pixel)) {
            return;
        }
        let world = &subject.built().world;
        self.of = Some((version, pixel));
        let count = world.samples_per_pixel().min(MAX_POINTS);
        // for a stereo pair, the pixel of the eye's image
        let drawn = render::camera_sample(world, pixel, 0).map(|sample| sample.pixel);
        let count = if drawn.is_some() { count } else { 0 };
        let drawn = drawn.unwrap_or_default();
        let draw = |what, index| world.samples.draw(SetKey::new(world.seed, drawn, what), index);
        let centered = |[x, y]: [f64; 2]| [2.0 * x - 1.0, 2.0 * y - 1.0];
        let pixel_points = (0..count).map(|i| centered(draw(Purpose::Pixel, i))).collect();
        let lens = |i| render::camera_sample(world, pixel, i)?.lens;
        let lens_points = (0..count).filter_map(lens).collect();
        let sampled = world.lights.iter().find(|light| light.light.draws() > 0);
        self.light = sampled.map(|light| light.index);
        let light_points = sampled.map_or(Vec::new(), |light| {
            let (path, light) = (PathKey::CAMERA, light.index);
            let purpose = Purpose::Light { path, light, pair: 0 };
            (0..count).map(|i| centered(draw(purpose, i))).collect()
        });
        let plots = [
            ("pixel", "where in the pixel (before the filter moves it)", false, pixel_points),
            ("lens", "where on the lens", true, lens_points),
            ("light", "where on the first sampled light, at the first hit", false, light_points),
        ];
        let plot = |(title, hint, is_disk, points)| Plot {
            title,
            hint,
            is_disk,
            points,
            area: Rect::NOTHING,
        };
        self.plots = plots.map(plot).into();
    }

    /// The position of a sample on the screen, in the plot of this index.
    pub fn on_screen(&self, plot: usize, sample: usize) -> Option<Pos2> {
        let plot = self.plots.get(plot)?;
        plot.points.get(sample).map(|&point| plot.to_screen(point))
    }

    /// Shows the samples of a pixel, each point in the colour of its sample; a click on a point chooses its sample. Lights
    /// the points of the ray that is pointed at elsewhere, and notes the point that is pointed at and its ray, as far as
    /// that is in the tree. Returns whether `wanted` was changed.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        (shown, answer): (&Shown<'_>, &PixelExplanation),
        selection: &mut Selection,
        wanted: &mut Scene,
    ) -> bool {
        let rendering = shown.rendering;
        self.refresh(&shown.subject(), answer.pixel);
        let rays = selection.root().map_or([None; 2], |(_, root)| self.rays(root));
        let color = |i: u32| display::color(shown.tone, answer.radiances[i as usize]);
        let changed = choose(ui, rendering, wanted);
        // side by side if they fit
        let plots = self.plots.len() as f32;
        let gaps = (plots - 1.0) * ui.spacing().item_spacing.x;
        let side = ((ui.available_width() - gaps) / plots).floor().clamp(SIDES[0], SIDES[1]);
        ui.horizontal_wrapped(|ui| {
            let lit = self.lit.take();
            for (index, plot) in self.plots.iter_mut().enumerate() {
                let ray = rays[usize::from(index == LIGHT_PLOT)];
                let is_pointed = ray.is_some() && ray == selection.tree.lit;
                let lit = lit.or(is_pointed.then_some(selection.sample));
                if let Some(hovered) = plot.show(ui, side, &color, (&mut selection.sample, lit)) {
                    let word = short(answer.radiances[hovered as usize]);
                    ui.ctx().request_repaint();
                    plot.say(ui, format!("sample {hovered}: {word}"));
                    (self.lit, selection.pointed) = (Some(hovered), Some(hovered));
                    selection.tree.hovered = selection.tree.hovered.or(ray);
                }
            }
        });
        if answer.samples_per_pixel > MAX_POINTS {
            ui.weak(format!("the first {MAX_POINTS} samples"));
        }
        changed
    }

    /// The rays of the points: the camera's, and the shadow ray from the first hit to the light of the last plot.
    fn rays(&self, root: &RecordedRay) -> [Option<usize>; 2] {
        let to_light = self.light.map(|light| RayKind::Shadow { light });
        let shadow = root.children.iter().find(|ray| Some(ray.kind) == to_light);
        [Some(root.number), shadow.map(|ray| ray.number)]
    }
}

impl Plot {
    fn to_screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        let half = 0.5 * self.area.width() - 6.0;
        self.area.center() + half * vec2(x as f32, -y as f32)
    }

    /// Shows the points, that of the chosen sample and the lit one marked; a click chooses a sample. Returns the sample under
    /// the mouse.
    fn show(
        &mut self,
        ui: &mut Ui,
        side: f32,
        color: &dyn Fn(u32) -> Color32,
        (sample, lit): (&mut u32, Option<u32>),
    ) -> Option<u32> {
        let show = |ui: &mut Ui| {
            ui.label(self.title).on_hover_text(self.hint);
            let (area, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
            self.area = area;
            let painter = ui.painter_at(area);
            painter.rect_filled(area, 2.0, display::ground(ui.visuals()));
            let edge = Stroke::new(1.0, Color32::from_gray(110));
            let [low, high] = [[-1.0, 1.0], [1.0, -1.0]].map(|corner| self.to_screen(corner));
            if self.is_disk {
                painter.circle_stroke(area.center(), 0.5 * (high.x - low.x), edge);
            } else {
                let square = Rect::from_two_pos(low, high);
                painter.rect_stroke(square, 0.0, edge, StrokeKind::Outside);
            }
            if self.points.is_empty() {
                let font = FontId::proportional(13.0);
                let grey = ui.visuals().weak_text_color();
                painter.text(area.center(), Align2::CENTER_CENTER, "not used", font, grey);
            }
            let radius = if self.points.len() > 400 { 1.2 } else { 2.4 };
            // an edge, so that dark points are visible
            let edge = Stroke::new(0.7, Color32::from_gray(120));
            for (index, &point) in (0..).zip(&self.points) {
                painter.circle(self.to_screen(point), radius, color(index), edge);
            }
            if let Some(&chosen) = self.points.get(*sample as usize) {
                let at = self.to_screen(chosen);
                let color = display::ink(ui.visuals(), Color32::from_rgb(255, 200, 60));
                painter.circle_filled(at, radius + 1.0, color);
                let ring = Stroke::new(1.5, color);
                painter.circle_stroke(at, radius + 4.0, ring);
            }
            if let Some(&lit) = lit.and_then(|lit| self.points.get(lit as usize)) {
                let ring = Stroke::new(2.5, ui.visuals().strong_text_color());
                painter.circle_stroke(self.to_screen(lit), radius + 5.5, ring);
            }
            if let (true, Some(at)) = (response.clicked(), response.interact_pointer_pos())
                && let Some(nearest) = self.nearest(at)
            {
                *sample = nearest;
            }
            response.hover_pos().and_then(|at| self.nearest(at))
        };
        ui.vertical(show).inner
    }

    /// Writes a line into the plot, at the end that is away from the mouse.
    fn say(&self, ui: &Ui, text: String) {
        let at = ui.input(|input| input.pointer.hover_pos());
        let is_low = at.is_some_and(|at| at.y > self.area.center().y);
        let corner = if is_low { Align2::CENTER_TOP } else { Align2::CENTER_BOTTOM };
        display::write(ui.painter(), self.area, corner, text);
    }

    /// The sample nearest to a position on the screen, if it is near.
    fn nearest(&self, at: Pos2) -> Option<u32> {
        let distance = |point: &[f64; 2]| self.to_screen(*point).distance(at);
        let nearest =
            (0..).zip(&self.points).min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        nearest.filter(|(_, point)| distance(point) <= CLICK_RADIUS).map(|(index, _)| index)
    }
}

/// Shows the chooser of the sampler, with the number of samples after rounding up. Returns whether it was
/// changed.
fn choose(ui: &mut Ui, rendering: &Rendering, wanted: &mut Scene) -> bool {
    let mut changed = false;
    ui.horizontal(|ui| {
        let label = ui.label("Sampler");
        let image = &mut wanted.image;
        let words = |kind: &samplers::Kind| format!("{kind:?}");
        let default =
            "As in the book: multi-jittered, and a single sample in the centre of the pixel";
        let all = samplers::named();
        let current = image.sampler.as_ref().map(words);
        let name = all.iter().find(|(_, kind)| Some(words(kind)) == current);
        let shown = name.map_or("default", |(name, _)| name.as_str());
        let combo = ComboBox::from_id_salt("sampler").selected_text(shown).width(190.0);
        let combo = combo.show_ui(ui, |ui| {
            let none = ui.selectable_label(image.sampler.is_none(), "default");
            if none.on_hover_text(default).clicked() {
                image.sampler = None;
                changed = true;
            }
            for (name, kind) in &all {
                if ui.selectable_label(Some(words(kind)) == current, name).clicked() {
                    image.sampler = Some(kind.clone());
                    changed = true;
                }
            }
        });
        combo.response.labelled_by(label.id);
        let used = rendering.world.samples_per_pixel();
        ui.label(count(used as usize, "sample"));
        if used != rendering.scene.image.samples {
            ui.weak(format!("rounded up to {used}"));
        }
    });
    changed
}
