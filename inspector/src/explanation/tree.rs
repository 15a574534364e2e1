//! The tree of rays: a line for each ray that is not folded, with its share of the light.

use std::collections::BTreeMap;
use std::sync::Arc;

use eframe::egui::collapsing_header::paint_default_icon;
use eframe::egui::{
    Align2, Button, Color32, FontId, Label, Rect, RichText, ScrollArea, Sense, Stroke, StrokeKind,
    TextStyle, Ui, WidgetInfo, accesskit::Role, vec2,
};
use explain::{Outline, RecordedRay, RecordedTerm, Row};
use groundtruth::film::Tone;
use groundtruth::trace::{Outcome, RayKind};
use text::brief::{count, percent};

use crate::picture::display::{self, ink};

/// The share of their sample below which rays are folded together.
pub const MIN_SHARE: f64 = 0.01;
/// The explanation of the numbers beside a ray.
const SAMPLING: &str = "weight: what its light counts for the ray before it; pdf: the density of its direction, \
                        per steradian; MIS: the share that this way to find the light counts";
/// The least length of a line that is cut.
const LEAST: usize = 8;
/// The height of a line, in points of the screen.
const LINE: f32 = 18.0;
/// The indent of each step of a branch.
const INDENT: f32 = 14.0;
/// The width of a bar that stands for the whole light of the sample.
const BAR: f32 = 52.0;

/// The colour of the filled part of a bar.
const FILLED: Color32 = Color32::from_rgb(80, 130, 195);
/// The colour of reflected rays.
pub const REFLECTED: Color32 = Color32::from_rgb(255, 160, 90);
/// The colour of transmitted rays.
pub const TRANSMITTED: Color32 = Color32::from_rgb(90, 205, 255);
/// The colour of the camera's ray.
pub const CAMERA: Color32 = Color32::from_rgb(235, 235, 235);
/// The colour of shadow rays that reach their light.
pub const UNBLOCKED: Color32 = Color32::from_rgb(250, 225, 100);
/// The colour of shadow rays that an object blocks.
pub const BLOCKED: Color32 = Color32::from_rgb(185, 170, 205);
/// The colour of rays that break a law.
pub const BROKEN: Color32 = Color32::from_rgb(255, 110, 110);
/// The colour of terms without a ray, and of normals.
pub const LOCAL: Color32 = Color32::from_rgb(150, 215, 150);

/// The kinds of rays, each with its colour.
pub const KINDS: [(&str, Color32); 5] = [
    ("camera", CAMERA),
    ("reflected", REFLECTED),
    ("transmitted", TRANSMITTED),
    ("shadow, unblocked", UNBLOCKED),
    ("shadow, blocked", BLOCKED),
];

/// The place of blocked shadow rays among the kinds.
pub const OF_BLOCKED: usize = 4;

/// The place of a ray's kind among them.
pub fn kind(ray: &RecordedRay) -> usize {
    match ray.kind {
        RayKind::Camera => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow { .. } if matches!(ray.outcome, Outcome::Blocked { .. }) => OF_BLOCKED,
        RayKind::Shadow { .. } => 3,
    }
}

/// The colour of a ray's line.
pub fn kind_color(ray: &RecordedRay) -> Color32 {
    KINDS[kind(ray)].1
}

/// Shows what the colours mean.
pub fn legend(ui: &mut Ui) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.weak("Rays:");
        for (name, color) in KINDS.into_iter().chain([("no ray", LOCAL)]) {
            ui.label(RichText::new(name).color(ink(ui.visuals(), color)));
        }
    });
}

/// The view of a sample's tree.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The number of the selected ray.
    pub ray: usize,
    /// The number of the ray at the end of the path that is walked in steps.
    end: usize,
    /// The number of the ray that is pointed at in this frame, wherever it is shown.
    pub hovered: Option<usize>,
    /// The number of the ray that was pointed at in the last frame, which is lit wherever it is shown.
    pub lit: Option<usize>,
    /// What laws found of its rays, by their numbers.
    pub found: Arc<BTreeMap<usize, Vec<String>>>,
    outline: Outline,
    /// Whether the selected ray is to be scrolled into view.
    scroll: bool,
}

impl Default for Tree {
    fn default() -> Self {
        Self {
            ray: 0,
            end: 0,
            hovered: None,
            lit: None,
            found: Arc::default(),
            outline: Outline::folding_below(MIN_SHARE),
            scroll: false,
        }
    }
}

impl Tree {
    /// The selected ray; the camera's if this tree does not have it.
    pub fn selected<'a>(&self, root: &'a RecordedRay) -> &'a RecordedRay {
        root.path_to(self.ray).last().copied().unwrap_or(root)
    }

    /// The path that is walked in steps, from the camera's ray: to the selected ray, and on while only rays of it are selected.
    pub fn path<'a>(&self, root: &'a RecordedRay) -> Vec<&'a RecordedRay> {
        let path = root.path_to(self.end);
        let is_on_it = path.iter().any(|ray| ray.number == self.ray);
        if is_on_it { path } else { root.path_to(self.ray) }
    }

    /// Selects a ray, opens everything that hides it and scrolls to it.
    pub fn go_to(&mut self, root: &RecordedRay, number: usize) {
        self.ray = number;
        self.outline.reveal(&root.path_to(number));
        self.scroll = true;
    }

    /// Follows the path of most light by one ray. At its end, or from a ray that is not in this tree, starts
    /// again at the camera's ray.
    pub fn follow_largest(&mut self, root: &RecordedRay) {
        let next = root.path_to(self.ray).last().and_then(|ray| ray.largest_child());
        self.go_to(root, next.map_or(root.number, |ray| ray.number));
    }

    /// Shows the lines in view; a click selects a ray. Returns the height of all lines.
    pub fn show(&mut self, ui: &mut Ui, root: &RecordedRay, tone: &Tone) -> f32 {
        self.end = self.path(root).last().map_or(self.ray, |ray| ray.number);
        let rows = self.outline.rows(root);
        let wanted = std::mem::take(&mut self.scroll);
        let is_selected =
            |row: &Row<'_>| matches!(row, Row::Ray { ray, .. } if ray.number == self.ray);
        let wanted = rows.iter().position(is_selected).filter(|_| wanted);
        let area = ScrollArea::both().id_salt("tree").auto_shrink(false).animated(false);
        ui.spacing_mut().item_spacing = vec2(5.0, 0.0);
        ui.spacing_mut().interact_size.y = LINE;
        ui.spacing_mut().button_padding = vec2(3.0, 0.0);
        area.show_rows(ui, LINE, rows.len(), |ui, visible| {
            if let Some(line) = wanted {
                // with the lines above and below it, without scrolling sideways
                let top = ui.max_rect().top() - LINE * visible.start as f32;
                let [first, last] = [line.max(1) - 1, (line + 2).min(rows.len())];
                let y = top + LINE * first as f32..=top + LINE * last as f32;
                ui.scroll_to_rect(Rect::from_x_y_ranges(ui.clip_rect().x_range(), y), None);
            }
            ui.style_mut().wrap_mode = Some(eframe::egui::TextWrapMode::Extend);
            // lines that are cut fill the width: no scroll bar because of rounding
            ui.set_max_width(ui.available_width() - 1.0);
            for row in &rows[visible] {
                ui.horizontal(|ui| match *row {
                    Row::Ray { ray, term, indent } => self.ray_line(ui, ray, term, indent, tone),
                    Row::Local { term, indent } => {
                        bar(ui, term.share);
                        ui.add_space(INDENT * indent as f32);
                        // no children: a space in place of the triangle
                        ui.allocate_exact_size(vec2(INDENT, LINE), Sense::hover());
                        swatch(ui, display::color(tone, term.contribution));
                        let (line, color) = (term.line(), ink(ui.visuals(), LOCAL));
                        cut(ui, RichText::new(&line).color(color), &line);
                    }
                    Row::Folded { parent, indent, rays, share } => {
                        bar(ui, share);
                        ui.add_space(INDENT * (indent as f32 + 1.0));
                        let (rays, share) = (count(rays, "more ray"), percent(share));
                        let text = RichText::new(format!("{rays} from {parent}, {share}"));
                        let line = Button::selectable(false, text.weak());
                        if ui.add(line).on_hover_text("Show them").clicked() {
                            self.outline.unfolded.insert(parent);
                        }
                    }
                });
            }
        });
        LINE * rows.len() as f32
    }

    fn ray_line(
        &mut self,
        ui: &mut Ui,
        ray: &RecordedRay,
        term: Option<&RecordedTerm>,
        indent: usize,
        tone: &Tone,
    ) {
        bar(ui, ray.share);
        ui.add_space(INDENT * indent as f32);
        let (_, icon) = ui.allocate_exact_size(vec2(INDENT, LINE), Sense::click());
        if !ray.children.is_empty() {
            let closed = self.outline.closed.contains(&ray.number);
            paint_default_icon(ui, if closed { 0.0 } else { 1.0 }, &icon);
            if icon.clicked() && !self.outline.closed.remove(&ray.number) {
                self.outline.closed.insert(ray.number);
            }
        }
        swatch(ui, display::color(tone, ray.contribution));
        let broken = self.found.get(&ray.number);
        let whole = ray.line();
        let drawn = term.map_or(String::new(), RecordedTerm::sampling);
        let told = [notes(ray), &drawn].into_iter().filter(|it| !it.is_empty());
        let told = told.collect::<Vec<_>>().join(", ");
        let [line, numbers] = fitting(ui, &whole, &told);
        let mut text = RichText::new(&line).color(ink(ui.visuals(), kind_color(ray)));
        if let Some(found) = broken {
            let mark = RichText::new("×").strong().color(ui.visuals().error_fg_color);
            ui.label(mark).on_hover_text(found.join("\n"));
            text = text.color(ui.visuals().error_fg_color);
        }
        if self.lit == Some(ray.number) {
            text = text.background_color(ui.visuals().selection.bg_fill.gamma_multiply(0.5));
        }
        let is_selected = self.ray == ray.number;
        let is_short = line != whole;
        let mut line = ui.add(Button::selectable(is_selected, text));
        line.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &whole));
        if is_short {
            line = line.on_hover_text(&whole);
        }
        if line.clicked() {
            self.ray = ray.number;
        }
        if line.hovered() {
            self.hovered = Some(ray.number);
        }
        if !told.is_empty() {
            cut(ui, RichText::new(numbers).weak(), &format!("{told}\n{SAMPLING}"));
        }
    }
}

/// What is special about the hit of a ray.
fn notes(ray: &RecordedRay) -> &'static str {
    let Some(hit) = &ray.hit else { return "" };
    let is_total = hit.optics.as_ref().map(|optics| optics.angle_of_refraction.is_none());
    match (hit.front, is_total) {
        (true, Some(true)) => "total reflection",
        (false, Some(true)) => "inside, total reflection",
        (false, Some(false)) => "inside",
        (true, _) | (false, None) => "",
    }
}

/// A ray's line and what stands beside it, in the room that is left: words go before numbers, first the lobe, then the
/// parent, which the indent shows, the kind, which the colour shows, and t, which the details have, then other words.
fn fitting(ui: &Ui, line: &str, told: &str) -> [String; 2] {
    let is_number = |part: &&str| part.contains(|letter: char| letter.is_ascii_digit());
    let numbers = told.split(", ").filter(is_number).collect::<Vec<_>>().join(", ");
    let lobe = told.rsplit_once(", ").filter(|(_, last)| !is_number(last));
    let unnamed = lobe.map_or(told, |(rest, _)| rest);
    let parts: Vec<&str> = line.split("  ").collect();
    let without = |left_out: usize| {
        let part = |(at, part): (usize, &&str)| match (at, left_out) {
            (1, 1..) if part.starts_with("from ") => None,
            (2, 2..) => part.strip_prefix("shadow ray ").map(str::to_owned),
            (3, 3..) if part.starts_with("t ") => None,
            _ => Some((*part).to_owned()),
        };
        parts.iter().enumerate().filter_map(part).collect::<Vec<_>>().join("  ")
    };
    let numbers = &*numbers;
    let tried = [(0, told), (0, unnamed), (1, unnamed), (2, unnamed), (3, unnamed), (3, numbers)];
    let font = TextStyle::Button.resolve(ui.style());
    let width = |text: &str| {
        ui.painter().layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE).size().x
    };
    // the paddings of the button, and what rounding takes
    let room = ui.available_width() - ui.spacing().item_spacing.x - 8.0;
    let fits = |&(left_out, told): &(usize, &str)| width(&without(left_out)) + width(told) <= room;
    if let Some((left_out, told)) = tried.into_iter().find(fits) {
        return [without(left_out), told.to_owned()];
    }
    // at last the name of what is hit is cut
    let mut line = without(3);
    while line.len() > LEAST && width(&line) + width("…") + width(numbers) > room {
        line.pop();
    }
    [line + "…", numbers.to_owned()]
}

/// Shows a text at the end of a line, cut with an ellipsis where the line ends; `hint` is shown under the mouse.
fn cut(ui: &mut Ui, text: RichText, hint: &str) {
    ui.add(Label::new(text).truncate().show_tooltip_when_elided(false)).on_hover_text(hint);
}

/// Shows the share of a ray as a bar and a percentage.
fn bar(ui: &mut Ui, share: f64) {
    let (area, _) = ui.allocate_exact_size(vec2(BAR, LINE), Sense::hover());
    let mut part = area.shrink2(vec2(0.0, 2.0));
    let painter = ui.painter();
    let visuals = ui.visuals();
    painter.rect_filled(part, 2.0, visuals.faint_bg_color.lerp_to_gamma(visuals.text_color(), 0.1));
    part.set_width(BAR * share.clamp(0.0, 1.0) as f32);
    painter.rect_filled(part, 2.0, visuals.panel_fill.lerp_to_gamma(FILLED, 0.7));
    let (at, font) = (area.right_center() - vec2(4.0, 0.0), FontId::proportional(11.5));
    painter.text(at, Align2::RIGHT_CENTER, percent(share), font, visuals.text_color());
}

/// Shows a small square of a colour.
pub fn swatch(ui: &mut Ui, color: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(12.0, 12.0), Sense::hover());
    ui.painter().rect_filled(rect, 2.0, color);
    let edge = Stroke::new(1.0, Color32::from_gray(110));
    ui.painter().rect_stroke(rect, 2.0, edge, StrokeKind::Inside);
}
