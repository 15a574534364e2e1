//! What is shown of the selected pixel: its sum, the tree of a sample, and one of the tabs below it.

use std::sync::Arc;

use eframe::egui::{
    self, Align, Button, Frame, Key, Label, Layout, Margin, RichText, ScrollArea, Ui, vec2,
};
use explain::{PixelExplanation, SampleExplanation};
use groundtruth::film::Tone;
use groundtruth::scene::Scene;
use judge::verdict::Verdict;
use text::brief::{brief, count, short};

use crate::explanation::asked::{Question, sample_of};
use crate::explanation::beside::Beside;
use crate::explanation::copying::{self, Making};
use crate::explanation::samples::Samples;
use crate::explanation::section::SectionView;
use crate::explanation::selection::{Selection, Tab};
use crate::explanation::tree::{Tree, legend, swatch};
use crate::explanation::values::ValuesView;
use crate::explanation::why_not::WhyNotView;
use crate::explanation::{Shown, Subject, checks, details, pixel};
use crate::picture::display;
use crate::splits::{Splits, fixed, part};

/// The least height of tree and details in a low window, in points of the screen.
const MIN_HEIGHT: f32 = 24.0;

/// The height of two lines about another picture or pixel, which move nothing, in points of the screen.
const BESIDE_HEIGHT: f32 = 44.0;

/// The least height of the whole explanation with room for the legend of the tree's colours, in points of the screen.
const LEGEND_MIN_HEIGHT: f32 = 480.0;

/// The width of the heading with coordinates below 1,000, in points of the screen.
const HEADING_WIDTH: f32 = 126.0;

/// The least width with room for the chooser of the sample beside the pixel, in points of the screen.
const ONE_ROW_MIN_WIDTH: f32 = 505.0;

/// The parts of the explanation, as they are shown.
#[derive(Default)]
pub struct Panel {
    /// The samples, when they are below the tree.
    pub samples: Samples,
    section: SectionView,
    why_not: WhyNotView,
    /// What is made for the clipboard.
    pub making: Making,
    numbers: Beside,
    values: ValuesView,
    /// The height that the tree needed in the last frame.
    tree_height: f32,
}

impl Panel {
    /// Shows the explanation; returns whether `wanted` was changed.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        selection: &mut Selection,
        shown: &Shown<'_>,
        wanted: &mut Scene,
        splits: &mut Splits,
    ) -> bool {
        let answer = match &selection.asked.answered {
            Some((_, Ok(explanation))) => Arc::clone(explanation),
            Some((_, Err(error))) => {
                ui.colored_label(ui.visuals().error_fg_color, error);
                return false;
            }
            None => {
                ui.heading("No pixel selected");
                ui.label("Click a pixel of the picture, or type its coordinates above.");
                return false;
            }
        };
        let whole = ui.available_rect_before_wrap();
        let inner = Frame::new().inner_margin(Margin::symmetric(0, 4));
        let head = egui::Panel::top("pixel").frame(inner);
        head.show(ui, |ui| self.head(ui, selection, &answer, shown));
        let head = ui.available_rect_before_wrap().top();
        let sample = sample_of(&answer, selection.shown_sample());
        let needed = head + BESIDE_HEIGHT - whole.top() + self.tree_height;
        let [above, below] = splits.show_lower(ui, whole, needed);
        let (above, margin) = (above.with_min_y(head.min(above.bottom())), vec2(0.0, 4.0));
        let height = part(ui, "tree", above, margin, |ui| {
            // below the tree, whose rows stay where they are
            if shown.theirs.is_some() || selection.pinned_beside().is_some() {
                let lines = egui::Panel::bottom("beside").min_size(0.0).frame(Frame::new());
                let lines = lines.show_separator_line(false);
                lines.show(ui, |ui| beside_lines(ui, selection, &answer, shown));
            }
            match sample {
                Some(sample) => {
                    let has_legend = whole.height() > LEGEND_MIN_HEIGHT;
                    sample_tree(ui, &mut selection.tree, sample, (shown.tone, has_legend))
                }
                None => {
                    ui.spinner();
                    self.tree_height
                }
            }
        });
        if height != self.tree_height {
            self.tree_height = height;
            ui.ctx().request_repaint();
        }
        part(ui, "details", below, margin, |ui| self.details(ui, selection, &answer, shown, wanted))
    }

    /// Shows what is below the tree; returns whether `wanted` was changed.
    fn details(
        &mut self,
        ui: &mut Ui,
        selection: &mut Selection,
        answer: &PixelExplanation,
        shown: &Shown<'_>,
        wanted: &mut Scene,
    ) -> bool {
        let verdict = shown.theirs.and_then(|theirs| theirs.judgement.verdict());
        let log = shown.subject().log();
        let is_twin = shown.beside.is_some() || selection.pinned_beside().is_some();
        // one that is not there now is shown when it is there again
        let mut shown_tab = Tab::default();
        ui.horizontal_wrapped(|ui| {
            if ui.available_width() < ONE_ROW_MIN_WIDTH {
                (ui.spacing_mut().button_padding.x, ui.spacing_mut().item_spacing.x) = (5.0, 3.0);
            }
            for (tab, name, hint, is_there) in [
                (Tab::Ray, "The ray", "The terms and numbers of the selected ray", true),
                (Tab::Section, "The section", "The plane of incidence of its hit", true),
                (Tab::Sum, "The sum", "What each light and each sample adds to the pixel", true),
                (Tab::Samples, "The samples", "Where the samples are in the pixel", true),
                (Tab::Verdict, "The verdict", "All that was judged", verdict.is_some()),
                (Tab::Checks, "Checks", "The laws that the rays are held to", log.is_some()),
                (Tab::Beside, "Side by side", "The selected ray in both pictures", is_twin),
            ] {
                if is_there {
                    ui.selectable_value(&mut selection.tab, tab, name).on_hover_text(hint);
                    shown_tab = if selection.tab == tab { tab } else { shown_tab };
                }
            }
        });
        let area = ScrollArea::both().id_salt("details").auto_shrink(false);
        let area = area.min_scrolled_height(MIN_HEIGHT);
        match shown_tab {
            Tab::Ray => drop(area.show(ui, |ui| self.ray(ui, selection, shown))),
            Tab::Checks => {
                let place = area.show(ui, |ui| log.and_then(|log| checks::show(ui, log))).inner;
                place.into_iter().for_each(|place| selection.seek(place));
            }
            Tab::Beside => {
                let ray = area.show(ui, |ui| self.side_by_side(ui, selection, shown)).inner;
                ray.into_iter().for_each(|number| selection.go_to(number));
            }
            Tab::Verdict => drop(area.show(ui, |ui| verdict.map(|it| verdict_text(ui, it)))),
            Tab::Section => self.section_of_ray(ui, selection, &shown.subject()),
            Tab::Sum => pixel::sum_list(ui, area, (answer, shown.tone), selection),
            Tab::Samples if log.is_some() => {
                let question =
                    Question { version: shown.subject().version(), pixel: answer.pixel, sample: 0 };
                let values = |ui: &mut Ui| self.values.show(ui, log?, question);
                area.show(ui, values).inner.into_iter().for_each(|place| selection.seek(place));
            }
            Tab::Samples => {
                let of = (shown, answer);
                let show = |ui: &mut Ui| self.samples.show(ui, of, selection, wanted);
                return area.show(ui, show).inner;
            }
        }
        false
    }

    fn ray(&mut self, ui: &mut Ui, selection: &mut Selection, shown: &Shown<'_>) {
        let Some((question, root)) = selection.root() else { return };
        let (ray, subject) = (selection.tree.selected(root), shown.subject());
        details::head(ui, ray);
        if let (Some(log), Some((_, indices))) = (subject.log(), &selection.logged) {
            indices.get(&ray.number).into_iter().for_each(|&index| checks::ray(ui, log, index));
        }
        let object =
            self.why_not.show(ui, &subject, (question, root), ray.number, selection.object);
        let (mut clicked, mut hovered) = (None, None);
        if subject.log().is_none() {
            clicked = details::show(ui, ray, &mut hovered);
        }
        selection.object = object;
        selection.tree.hovered = selection.tree.hovered.or(hovered);
        if let Some(number) = clicked {
            selection.go_to(number);
        }
    }

    /// Shows the selected ray of both pictures: ours at the left, whichever tree is above.
    fn side_by_side(
        &mut self,
        ui: &mut Ui,
        selection: &Selection,
        shown: &Shown<'_>,
    ) -> Option<usize> {
        let programs = [shown.subject().program, shown.beside.flatten()];
        let names = programs.map(|program| program.map_or("ours", |program| &program.name));
        match (selection.root(), selection.root_beside()) {
            (Some(this), Some(other)) => {
                let pixels = [this, other].map(|(of, _)| of.pixel);
                let pixels = pixels.map(|[x, y]| format!("({x}, {y})"));
                let whose = match selection.pinned_beside() {
                    Some(_) => (true, pixels.each_ref().map(String::as_str)),
                    None => (programs[1].is_some(), names),
                };
                self.numbers.show(ui, [this, other], selection.tree.ray, whose)
            }
            _ => {
                ui.weak("One of the two has no ray here, or is not explained yet.");
                None
            }
        }
    }

    fn section_of_ray(&mut self, ui: &mut Ui, selection: &mut Selection, subject: &Subject<'_>) {
        let (broken, mut hovered) = (Arc::clone(&selection.tree.found), selection.tree.hovered);
        match selection.root() {
            Some(tree) => {
                let ray = selection.tree.selected(tree.1);
                // where it leaves a surface both it and the ray that sent it are seen
                let leaves = broken.contains_key(&ray.number) && ray.light.is_none();
                let number = ray.parent.filter(|_| leaves).unwrap_or(ray.number);
                let expected = |number: usize| {
                    let (_, indices) = selection.logged.as_ref()?;
                    subject.log()?.verdict.expected(*indices.get(&number)?)
                };
                let (world, told) = (&subject.built().world, (&*broken, expected));
                self.section.show(ui, world, tree, number, told, &mut hovered);
            }
            None => drop(ui.weak("no ray")),
        }
        selection.tree.hovered = hovered;
    }

    /// Shows the pixel and its sum.
    fn head(
        &mut self,
        ui: &mut Ui,
        selection: &mut Selection,
        answer: &PixelExplanation,
        shown: &Shown<'_>,
    ) {
        let ([x, y], last) = (answer.pixel, answer.samples_per_pixel - 1);
        let is_narrow = ui.available_width() < ONE_ROW_MIN_WIDTH;
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            swatch(ui, display::color(shown.tone, answer.radiance));
            fixed(ui, HEADING_WIDTH, |ui| drop(ui.heading(format!("Pixel ({x}, {y})"))));
            for (by, name, hint) in [(-1, "‹", "back (Alt-Left)"), (1, "›", "forward (Alt-Right)")]
            {
                let button = ui.add_enabled(selection.can_go(by), Button::new(name).small());
                if button.on_hover_text(hint).clicked() {
                    selection.go(by);
                }
            }
            let pin = Button::new("Pin").small().selected(selection.pinned.is_some());
            let hint = "Compares the next pixel that is selected with this one (P)";
            if ui.add(pin).on_hover_text(hint).clicked() {
                selection.pin();
            }
            if last > 0 && !is_narrow {
                pixel::chooser(ui, &mut selection.sample, last);
            }
            // from the right, so that nothing else moves it
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let root = sample_of(answer, selection.sample).and_then(|it| it.ray.as_ref());
                let ray = root.map(|root| selection.tree.selected(root));
                let sample = selection.sample.min(last);
                pixel::copy_menu(ui, shown, answer, sample, ray, &mut self.making);
                match selection.is_waiting() || self.making.working.is_busy() {
                    true => drop(ui.spinner()),
                    false => copying::show_copied(ui),
                }
            });
        });
        if last > 0 && is_narrow {
            ui.horizontal(|ui| pixel::chooser(ui, &mut selection.sample, last));
        }
        if let Some(problem) = &self.making.problem {
            ui.colored_label(ui.visuals().error_fg_color, problem);
        }
        for note in &answer.notes {
            ui.weak(note);
        }
        pixel::sum(ui, answer, shown);
    }
}

/// Shows the pixel in the other picture, or the pinned one.
fn beside_lines(ui: &mut Ui, selection: &Selection, answer: &PixelExplanation, shown: &Shown<'_>) {
    if let Some(theirs) = shown.theirs.filter(|_| shown.subject().has_camera()) {
        let other = selection.beside.explanation().filter(|_| theirs.is_twin());
        let explained = match theirs.explained() {
            Some(_) => [other, Some(answer)],
            None => [Some(answer), other],
        };
        let radiance = |it: &PixelExplanation| (it.pixel == answer.pixel).then_some(it.radiance);
        let explained = explained.map(|it| it.and_then(radiance));
        pixel::theirs(ui, answer.pixel, (theirs, explained), shown);
    }
    let beside = selection.beside.explanation();
    let pinned = beside.filter(|it| Some(it.pixel) == selection.pinned_beside());
    if let Some(PixelExplanation { pixel: [x, y], radiance, .. }) = pinned {
        ui.horizontal_wrapped(|ui| {
            swatch(ui, display::color(shown.tone, *radiance));
            let text = format!("pinned ({x}, {y}): {}", short(*radiance));
            ui.label(RichText::new(text).monospace().size(12.0));
        });
    }
}

/// Shows the tree of a sample; returns the height that it needs.
fn sample_tree(
    ui: &mut Ui,
    tree: &mut Tree,
    sample: &SampleExplanation,
    (tone, has_legend): (&Tone, bool),
) -> f32 {
    let (index, top) = (sample.index, ui.cursor().top());
    let Some(root) = &sample.ray else {
        ui.strong(format!("Sample {index}"));
        ui.label("No ray: the camera sees nothing there.");
        return ui.cursor().top() - top;
    };
    let film = |[x, y]: [f64; 2]| format!(", at ({}, {}) on the view plane", brief(x), brief(y));
    let film = sample.film.map_or(String::new(), film);
    ui.horizontal(|ui| {
        ui.strong(format!("Sample {index}"));
        let follow = ui.small_button("Follow the largest (L)");
        let hint = "Steps down the path along which most of the light comes";
        let key = !ui.ctx().text_edit_focused() && ui.input(|input| input.key_pressed(Key::L));
        if follow.on_hover_text(hint).clicked() || key {
            tree.follow_largest(root);
        }
        let rays = count(root.count(), "ray");
        ui.add(Label::new(RichText::new(rays + &film).weak()).truncate());
    });
    // no legend in a low window: each line names its kind of ray too
    if has_legend {
        legend(ui);
    }
    let used = ui.cursor().top() - top;
    // with the margins around it
    used + tree.show(ui, root, tone) + 10.0
}

/// Shows a verdict as the command prints it, to be read, selected and copied.
fn verdict_text(ui: &mut Ui, verdict: &Verdict) {
    let text = verdict.to_string();
    ui.horizontal(|ui| {
        if ui.small_button("Copy the verdict").clicked() {
            copying::copy(ui.ctx(), text.clone());
        }
        copying::show_copied(ui);
    });
    ui.label(RichText::new(text).monospace().size(12.0));
}
