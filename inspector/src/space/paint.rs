//! The rays drawn over the backdrop: lines with arrowheads, normals, marks of lamps and occluders, and the frustum of
//! the scene's camera.

use std::collections::BTreeMap;

use eframe::egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, Visuals, vec2,
};
use explain::RecordedRay;
use groundtruth::math::{Point, atan2, ln, to_degrees};
use groundtruth::printable::name;
use groundtruth::render;
use groundtruth::world::World;
use space::{End, Segment, Sight};

use crate::explanation::tree::{BROKEN, LOCAL, kind_color};
use crate::picture::display::{halo, ink};
use crate::space::backdrop::Runs;

/// The opacity of what a surface hides.
const HIDDEN: f32 = 0.25;
/// The opacity of rays that are not lit while another is.
const DIMMED: f32 = 0.3;
/// The least angle between two rays that is written, in degrees: single precision gives less.
const LEAST_ANGLE: f64 = 1e-3;
/// The dark way behind an occluder.
const DARK: Color32 = Color32::BLACK;
/// The margin around labels, with room for the lines at the corners of the view, in points of the screen.
const LABEL_MARGIN: Vec2 = vec2(4.0, 26.0);
/// The points on each edge of the film: the edge is curved for some cameras.
const EDGE_POINTS: u32 = 12;

/// A place on the screen with the transformation that leads there.
pub struct Canvas<'a> {
    /// Where lines are drawn.
    pub painter: &'a Painter,
    /// The top left corner of the view.
    pub corner: Pos2,
    /// The camera.
    pub sight: Sight,
    /// The colours of the theme.
    pub visuals: &'a Visuals,
}

/// What is drawn of a tree.
#[derive(Default)]
pub struct Rays<'a> {
    /// The rays, in the order of their numbers.
    pub by_number: &'a [&'a RecordedRay],
    /// Their pieces.
    pub segments: &'a [Segment],
    /// The runs of each piece that are hidden, once they are known.
    pub runs: Option<&'a [Runs]>,
    /// The rays that are lit; all if there are none.
    pub lit: &'a [usize],
    /// The rays that break a law, if laws were asked.
    pub broken: Option<&'a BTreeMap<usize, Vec<String>>>,
    /// Whether they are drawn thin and dashed, as those of the other one of two trees.
    pub dashed: bool,
    /// The length of normals, in world units; no normals if `None`.
    pub normals: Option<f64>,
}

/// How strongly a ray is drawn, from 0 to 1: logarithmic from a thousandth of its sample's light to all of it. A ray without
/// light says why there is none, and is drawn in the middle.
fn weight(share: f64) -> f32 {
    match share {
        share if share > 0.0 => (1.0 + ln(share) / ln(1e3)).clamp(0.0, 1.0) as f32,
        _ => 0.5,
    }
}

/// The ray of this number among those of a tree.
pub fn numbered<'a>(rays: &[&'a RecordedRay], number: usize) -> Option<&'a RecordedRay> {
    rays.binary_search_by_key(&number, |ray| ray.number).ok().map(|at| rays[at])
}

impl Canvas<'_> {
    fn screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.corner + vec2(x as f32, y as f32)
    }

    /// The part of a segment that is in view, on the screen.
    pub fn line(&self, from: Point, to: Point) -> Option<[Pos2; 2]> {
        Some(self.sight.clip(from, to)?.map(|(at, _)| self.screen(at)))
    }

    /// Draws a line over a wider one, so that it can be seen on any ground; a thin one alone, as a thousand faint rays would
    /// darken the scene.
    fn stroke(&self, line: [Pos2; 2], width: f32, color: Color32, opacity: f32) {
        let halo = if color == DARK { Color32::from_gray(150) } else { halo(self.visuals) };
        let both = [(width + 2.0, halo), (width, color)];
        for (width, color) in both.into_iter().skip(usize::from(width < 1.0)) {
            self.painter.line_segment(line, Stroke::new(width, color.gamma_multiply(opacity)));
        }
    }

    /// Draws the rays. Returns the pieces that are in view, on the screen.
    pub fn rays(&self, rays: &Rays<'_>) -> Vec<(usize, [Pos2; 2])> {
        let mut drawn = Vec::new();
        for (index, segment) in rays.segments.iter().enumerate() {
            let Some(ray) = numbered(rays.by_number, segment.ray) else { continue };
            let is_lit = rays.lit.contains(&segment.ray);
            let is_broken = rays.broken.is_some_and(|it| it.contains_key(&segment.ray));
            let dimmed = if rays.lit.is_empty() || is_lit { 1.0 } else { DIMMED };
            let weight = weight(ray.share);
            let width = if is_lit || is_broken { 3.0 } else { 0.8 + 1.4 * weight };
            let dimmed = if is_lit || is_broken { dimmed } else { dimmed * (0.4 + 0.6 * weight) };
            let color = match segment.end {
                _ if is_broken => ink(self.visuals, BROKEN),
                End::Dark => DARK,
                _ => ink(self.visuals, kind_color(ray)),
            };
            let whole = [([0.0, 1.0], false)];
            let runs = rays.runs.and_then(|runs| runs.get(index)).map_or(&whole[..], Vec::as_slice);
            let at = |part: f64| segment.from + part * (segment.to - segment.from);
            for &([start, end], hidden) in runs {
                let opacity = if hidden { HIDDEN * dimmed } else { dimmed };
                if let Some(line) = self.line(at(start), at(end)) {
                    if rays.dashed {
                        let pen = Stroke::new(1.5, color.gamma_multiply(opacity));
                        self.painter.extend(Shape::dashed_line(&line, pen, 7.0, 6.0));
                        continue;
                    }
                    self.stroke(line, width, color, opacity);
                    drawn.push((segment.ray, line));
                }
            }
            let is_hidden = runs.last().is_some_and(|(_, hidden)| *hidden);
            let opacity = if is_hidden { HIDDEN * dimmed } else { dimmed };
            self.end(segment, color, opacity);
            if segment.end == End::Hit
                && let (Some(length), Some(hit)) = (rays.normals, &ray.hit)
            {
                let normal = if hit.front { hit.shading_normal } else { -hit.shading_normal };
                if let Some(line) = self.line(hit.point, hit.point + length * normal) {
                    self.stroke(line, 1.0, ink(self.visuals, LOCAL), opacity);
                }
            }
        }
        drawn
    }

    /// Writes the numbers of rays at their ends, with the name of the object or lamp there, each once; of a ray that ends out
    /// of view at the border, where an arrow leads there.
    pub fn labels(&self, rays: &[&RecordedRay], segments: &[Segment]) {
        let inner = self.painter.clip_rect().shrink2(LABEL_MARGIN);
        let (mut named, mut taken) = (Vec::new(), Vec::<Rect>::new());
        for segment in segments.iter().filter(|it| it.end != End::Dark) {
            let Some(ray) = rays.iter().find(|ray| ray.number == segment.ray) else { continue };
            let ends = self.sight.clip(segment.from, segment.to);
            let Some([(from, _), (tip, part)]) = ends else { continue };
            let [from, tip] = [from, tip].map(|at| self.screen(at));
            let there = match segment.end {
                End::Hit => ray.hit.as_ref().map(|hit| &*hit.object),
                End::Occluder => ray.blocked_by.as_deref(),
                End::Light | End::Leaves | End::Dark => ray.light.as_deref().or(Some("background")),
            };
            let there = there.filter(|there| !named.contains(there));
            named.extend(there);
            let text = there.map_or(String::new(), |there| format!(" {}", name(there)));
            let color = ink(self.visuals, kind_color(ray));
            if part < 1.0 {
                self.arrowhead(tip, (tip - from).normalized(), color, 1.0);
            }
            let text = format!("{}{text}", ray.number);
            let text = self.painter.layout_no_wrap(text, FontId::proportional(12.0), color);
            let beside = |(ring, [x, y]): (u8, [f32; 2])| {
                let away = 0.5 * text.size() + f32::from(ring) * vec2(6.0, 5.0);
                let corner = tip + away * vec2(x, y) - 0.5 * text.size();
                Rect::from_min_size(corner.clamp(inner.min, inner.max - text.size()), text.size())
            };
            let sides = [[1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [-1.0, 1.0]];
            let places = (1..4).flat_map(|ring| sides.map(|side| (ring, side))).map(beside);
            let is_free = |place: &Rect| !taken.iter().any(|other| other.intersects(*place));
            if let Some(place) = places.into_iter().find(is_free) {
                let ground = halo(self.visuals).gamma_multiply(0.7);
                self.painter.rect_filled(place.expand(1.0), 2.0, ground);
                self.painter.galley(place.min, text, color);
                taken.push(place);
            }
        }
    }

    /// Rings the place where two rays part, with the angle between them.
    pub fn parting(&self, [this, other]: [&RecordedRay; 2]) {
        let [a, b] = [this, other].map(|ray| ray.ray.direction);
        let angle = to_degrees(atan2(a.cross(b).length(), a.dot(b)));
        let end = || this.hit.as_ref().or(other.hit.as_ref()).map(|hit| hit.point);
        let (at, text) = match angle > LEAST_ANGLE {
            true => (Some(this.ray.origin), format!("{angle:.2}°")),
            false => (end(), "they part here".to_owned()),
        };
        let Some(at) = at.and_then(|at| self.sight.project(at)) else { return };
        let (at, strong) = (self.screen(at), self.visuals.strong_text_color());
        for (width, color) in [(4.0, halo(self.visuals)), (2.0, strong)] {
            self.painter.circle_stroke(at, 9.0, Stroke::new(width, color));
        }
        let font = FontId::proportional(13.0);
        // labels are at the right
        let place = at + vec2(-12.0, -12.0);
        self.painter.text(place, Align2::RIGHT_BOTTOM, text, font, strong);
    }

    /// Marks the end of a piece: an arrowhead where it goes on or hits, a dot at a lamp, a cross at an occluder.
    fn end(&self, segment: &Segment, color: Color32, opacity: f32) {
        let (Some(tip), Some([start, end])) =
            (self.sight.project(segment.to), self.line(segment.from, segment.to))
        else {
            return;
        };
        let tip = self.screen(tip);
        if (tip - end).length() > 1.0 {
            return;
        }
        let along = (end - start).normalized();
        match segment.end {
            End::Hit | End::Leaves if (end - start).length() > 4.0 => {
                self.arrowhead(tip, along, color, opacity);
            }
            End::Light => {
                let edge = Stroke::new(1.0, halo(self.visuals).gamma_multiply(opacity));
                self.painter.circle(tip, 4.0, color.gamma_multiply(opacity), edge);
            }
            End::Occluder => {
                for across in [vec2(4.0, 4.0), vec2(4.0, -4.0)] {
                    self.stroke([tip - across, tip + across], 2.0, color, opacity);
                }
            }
            End::Hit | End::Leaves | End::Dark => {}
        }
    }

    fn arrowhead(&self, tip: Pos2, along: Vec2, color: Color32, opacity: f32) {
        let edge = Stroke::new(1.0, halo(self.visuals).gamma_multiply(opacity));
        let (side, back) = (4.0 * along.rot90(), tip - 9.0 * along);
        let head = vec![tip, back + side, back - side];
        self.painter.add(Shape::convex_polygon(head, color.gamma_multiply(opacity), edge));
    }

    /// Draws the scene's camera: the edges of its film, `length` before the eye, and the pixel.
    pub fn frustum(&self, world: &World, pixel: Option<[u32; 2]>, length: f64) {
        let column = pixel.map_or(0, |[column, _]| column);
        let Some((eye, column)) = world.view.eye_of_column(column, world.image.width) else {
            return;
        };
        let half = world.image.pixel_size * 0.5;
        let [x, y] = [world.image.width, world.image.height].map(|side| half * f64::from(side));
        let on_film =
            |film: [f64; 2]| eye.ray(film, [0.0, 0.0]).map(|ray| (ray.origin, ray.at(length)));
        let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
        let color = ink(self.visuals, Color32::from_gray(210));
        let draw = |from: Point, to: Point| {
            if let Some(line) = self.line(from, to) {
                self.painter.line_segment(line, Stroke::new(1.0, color.gamma_multiply(0.6)));
            }
        };
        for (corner, next) in corners.into_iter().zip(corners.into_iter().cycle().skip(1)) {
            if let Some((origin, at)) = on_film(corner) {
                draw(origin, at);
            }
            let between = |step: u32| {
                let part = f64::from(step) / f64::from(EDGE_POINTS);
                [0, 1].map(|axis| corner[axis] + part * (next[axis] - corner[axis]))
            };
            let edge: Vec<_> = (0..=EDGE_POINTS).map(|step| on_film(between(step))).collect();
            for pair in edge.windows(2) {
                if let [Some((_, from)), Some((_, to))] = pair {
                    draw(*from, *to);
                }
            }
        }
        let middle =
            pixel.map(|[_, row]| render::film_point(&world.image, [column, row], [0.5, 0.5]));
        if let Some((_, at)) = middle.and_then(on_film)
            && let Some(at) = self.sight.project(at)
        {
            let edge = Stroke::new(1.0, Color32::BLACK);
            self.painter.circle(self.screen(at), 3.0, Color32::from_rgb(255, 230, 60), edge);
        }
    }
}
