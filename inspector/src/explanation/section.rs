//! The section of the selected ray: the plane of incidence of its hit, or that of a shadow ray and its light, drawn.

use std::collections::BTreeMap;
use std::f32::consts::TAU;

use eframe::egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2,
    WidgetInfo, accesskit::Role as NodeRole, vec2,
};
use explain::RecordedRay;
use groundtruth::math::Vector;
use groundtruth::world::World;
use space::{Drawing, Label, Role, Section, arrowhead};

use crate::explanation::asked::Question;
use crate::explanation::tree::{BLOCKED, BROKEN, CAMERA, LOCAL, REFLECTED, TRANSMITTED, UNBLOCKED};
use crate::explanation::{copying, pointing};
use crate::picture::display::ink;
use crate::picture::view::zoomed;

/// The length of an arrowhead, in points of the screen.
const HEAD: f64 = 11.0;
/// The margin around the drawing, with room for words.
const MARGIN: f32 = 34.0;
/// The least height of the drawing.
const MIN_HEIGHT: f32 = 60.0;

/// The zoom: all of the drawing, and the largest.
const ZOOM: [f64; 2] = [1.0, 1e6];

/// The section that was drawn last: of which tree and ray, and the part of it that is in view.
#[derive(Default)]
pub struct SectionView {
    drawn: Option<(Question, usize, Option<Section>)>,
    view: View,
}

/// The part of the drawing that is in view.
#[derive(Clone, Copy)]
struct View {
    /// How many times larger than the whole drawing fits.
    zoom: f64,
    /// Where the middle of the fitting drawing is, in points of the screen from the middle of the view.
    moved: Vec2,
}

impl Default for View {
    fn default() -> Self {
        Self { zoom: ZOOM[0], moved: Vec2::ZERO }
    }
}

impl View {
    /// Follows the mouse: the wheel zooms under it, a drag moves, a double click fits the drawing again.
    fn follow(&mut self, ui: &Ui, response: &Response) {
        if let Some(at) = response.hover_pos() {
            let zoom = (self.zoom * f64::from(zoomed(ui, 0.005))).clamp(ZOOM[0], ZOOM[1]);
            let from_middle = at - response.rect.center();
            self.moved = from_middle + (zoom / self.zoom) as f32 * (self.moved - from_middle);
            self.zoom = zoom;
        }
        self.moved += response.drag_delta();
        if response.double_clicked() {
            *self = Self::default();
        }
        // some of the drawing stays in view
        let reach = 0.5 * self.zoom as f32 * response.rect.size();
        self.moved = self.moved.clamp(-reach, reach);
    }
}

/// A drawing at its place on the screen.
struct Place {
    center: [f64; 2],
    /// Points of the screen for a world unit.
    scale: f64,
    middle: Pos2,
}

impl Place {
    fn of(drawing: &Drawing, area: Rect, view: View) -> Option<Self> {
        let [low, high] = drawing.bounds()?;
        let room = area.shrink(MARGIN.min(0.25 * area.width().min(area.height()))).size();
        let extent = [high[0] - low[0], high[1] - low[1]].map(|side| side.max(1e-300));
        let scale = (f64::from(room.x) / extent[0]).min(f64::from(room.y) / extent[1]);
        let center = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        Some(Self { center, scale: view.zoom * scale, middle: area.center() + view.moved })
    }

    fn screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        let [right, up] = [x - self.center[0], y - self.center[1]].map(|it| it * self.scale);
        self.middle + vec2(right as f32, -up as f32)
    }
}

impl SectionView {
    /// Shows the section of a ray of this tree, if it has one, with what is broken by number and where that should go; notes
    /// the ray that is pointed at.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        world: &World,
        (question, root): (Question, &RecordedRay),
        ray: usize,
        (broken, expected): (&BTreeMap<usize, Vec<String>>, impl Fn(usize) -> Option<Vector>),
        hovered: &mut Option<usize>,
    ) {
        if self.drawn.as_ref().is_none_or(|(of, number, _)| (*of, *number) != (question, ray)) {
            let mut section = Section::of(world, root, ray);
            section.iter_mut().for_each(|section| section.expect(&expected));
            self.drawn = Some((question, ray, section));
            self.view = View::default();
        }
        let Some((.., section)) = &self.drawn else { return };
        let Some(Section { drawing, .. }) = section else {
            ui.weak("This ray hits nothing, so there is no plane of incidence.");
            return;
        };
        ui.horizontal_wrapped(|ui| {
            ui.strong(&drawing.title);
            let hint = "wheel: zoom · drag: move · double click: all of it";
            if ui.small_button("Copy as SVG").on_hover_text(hint).clicked() {
                copying::copy(ui.ctx(), drawing.svg());
            }
            copying::show_copied(ui);
        });
        for note in &drawing.notes {
            ui.label(note);
        }
        let size = vec2(ui.available_width(), ui.available_height().max(MIN_HEIGHT));
        let (response, painter) = ui.allocate_painter(size, Sense::click_and_drag());
        self.view.follow(ui, &response);
        response.widget_info(|| WidgetInfo::labeled(NodeRole::Image, true, "section"));
        *hovered = hovered.or(paint(ui, &painter, (&response, self.view), drawing, broken));
    }
}

/// Paints a drawing; returns the ray under the mouse.
fn paint(
    ui: &Ui,
    painter: &Painter,
    (response, view): (&Response, View),
    drawing: &Drawing,
    broken: &BTreeMap<usize, Vec<String>>,
) -> Option<usize> {
    let place = Place::of(drawing, response.rect, view)?;
    let mut lines = Vec::new();
    for stroke in &drawing.strokes {
        let is_broken = stroke.ray.is_some_and(|ray| broken.contains_key(&ray));
        let color = if is_broken { ink(ui.visuals(), BROKEN) } else { color(ui, stroke.role) };
        let points: Vec<Pos2> = stroke.points.iter().map(|&at| place.screen(at)).collect();
        let width = if stroke.ray.is_some() { 2.0 } else { 1.2 };
        let pen = Stroke::new(width, color);
        match &points[..] {
            [] => {}
            [dot] => drop(painter.circle_filled(*dot, 3.5, color)),
            _ if stroke.dashed => painter.extend(Shape::dashed_line(&points, pen, 6.0, 4.0)),
            _ => drop(painter.add(Shape::line(points.clone(), pen))),
        }
        if stroke.arrow
            && let Some(head) = arrowhead(&stroke.points, HEAD / place.scale)
        {
            let head = head.map(|at| place.screen(at)).to_vec();
            painter.add(Shape::convex_polygon(head, color, Stroke::NONE));
        }
        lines.extend(points.windows(2).map(|ends| (stroke.ray, [ends[0], ends[1]])));
    }
    let mut words = Vec::new();
    drawing.labels.iter().for_each(|label| write(ui, painter, &place, label, &lines, &mut words));
    let rays = lines.iter().filter_map(|(ray, line)| Some(((*ray)?, *line))).collect::<Vec<_>>();
    response.hover_pos().and_then(|at| pointing::nearest(&rays, at))
}

/// Writes a label at its place, or beside it where the fewest words and lines are.
fn write(
    ui: &Ui,
    painter: &Painter,
    place: &Place,
    label: &Label,
    lines: &[(Option<usize>, [Pos2; 2])],
    words: &mut Vec<Rect>,
) {
    let [x, y] = label.side.map(f32::from);
    let anchor = match label.side {
        [-1, _] => Align2::RIGHT_CENTER,
        [1, _] => Align2::LEFT_CENTER,
        [_, 1] => Align2::CENTER_BOTTOM,
        [_, -1] => Align2::CENTER_TOP,
        _ => Align2::CENTER_CENTER,
    };
    let at = place.screen(label.at) + 6.0 * Vec2::new(x, -y);
    let color = color(ui, label.role);
    let text = painter.layout_no_wrap(label.text.clone(), FontId::proportional(13.0), color);
    let own = anchor.anchor_size(at, text.size());
    // in circles around it, the nearest first
    let around = (0..6 * 12).map(|step| {
        let turn = Vec2::angled((step % 12) as f32 * TAU / 12.0);
        own.translate((step / 12 + 1) as f32 * 8.0 * turn)
    });
    let covered = |rect: &Rect| {
        let crossed = lines.iter().filter(|(_, line)| crosses(*rect, *line)).count();
        let hidden = words.iter().filter(|other| other.intersects(*rect)).count();
        (!painter.clip_rect().contains_rect(*rect), hidden, crossed)
    };
    let free = std::iter::once(own).chain(around).min_by_key(covered).unwrap_or(own);
    words.push(free);
    painter.galley(free.min, text, color);
}

/// Whether a line goes through a rectangle: their bounds meet, and not all corners are on one side of it.
fn crosses(rect: Rect, [from, to]: [Pos2; 2]) -> bool {
    let way = to - from;
    let sides = [rect.left_top(), rect.right_top(), rect.left_bottom(), rect.right_bottom()]
        .map(|corner| way.x * (corner.y - from.y) - way.y * (corner.x - from.x));
    let is_within = Rect::from_two_pos(from, to).intersects(rect);
    is_within && sides.iter().any(|it| *it >= 0.0) && sides.iter().any(|it| *it <= 0.0)
}

/// The colour of a line: rays as in the tree.
fn color(ui: &Ui, role: Role) -> Color32 {
    let text = ui.visuals().text_color();
    match role {
        Role::Incoming => ink(ui.visuals(), CAMERA),
        Role::Reflected => ink(ui.visuals(), REFLECTED),
        Role::Transmitted => ink(ui.visuals(), TRANSMITTED),
        Role::Shadow => ink(ui.visuals(), UNBLOCKED),
        Role::Blocked => ink(ui.visuals(), BLOCKED),
        Role::Dark => text.gamma_multiply(0.5),
        Role::Normal => ink(ui.visuals(), LOCAL),
        Role::Outline => text,
        Role::Surroundings => text.gamma_multiply(0.45),
        Role::Arc => text.gamma_multiply(0.8),
    }
}
