//! The plane through a hit, its normal and a light.

use explain::{RecordedRay, quoted};
use groundtruth::math::{Point, Vector, cos_degrees};
use groundtruth::printable::name;
use groundtruth::trace::{Outcome, RayKind};
use groundtruth::world::World;
use text::digits::short;

use super::{
    Drawing, Label, RayAngle, Role, Section, SectionPlane, Stroke, Window, angle_between, arc,
    object, outline_strokes, sign,
};
use crate::segments::{End, pieces};

/// How far a way to a light is drawn beyond the object that blocks it, in distances to that object.
const BEYOND: f64 = 3.0;
/// How far a way to a distant light is drawn, in diagonals of the object that is lit.
const OF_OBJECT: f64 = 3.0;
/// The space around the way, as a part of its length.
const MARGIN: f64 = 0.25;

/// The section of a shadow ray that the ray before it sent.
pub fn section(world: &World, before: &RecordedRay, ray: &RecordedRay) -> Option<Section> {
    let hit = before.hit.as_ref()?;
    let direction = ray.ray.direction.unit()?;
    let normal = if hit.front { hit.shading_normal } else { -hit.shading_normal };
    let plane = SectionPlane::of(hit.point, normal, direction);
    let (index, size) = object(world, &hit.object)?;
    let finite = if size.is_finite() { OF_OBJECT * size } else { hit.t };
    let pieces = pieces(world, ray, Some(before), finite);
    let (first, last) = (pieces.first()?, pieces.last()?);
    let length = match first.end {
        End::Occluder => BEYOND * (first.to - first.from).length(),
        _ => finite,
    };
    let whole = (last.to - hit.point).length();
    let (shown, is_cut) = if whole > length.max(finite) { (length, true) } else { (whole, false) };
    let end = plane.along(shown * direction);
    let window = Window {
        center: end.map(|it| 0.5 * it),
        half: (0.5 + MARGIN) * shown.max(f64::MIN_POSITIVE),
    };
    let light_object = lamp(world, ray);
    let about: Vec<u32> = [Some(index), blocker(ray), light_object].into_iter().flatten().collect();
    let mut drawing = Drawing {
        title: format!(
            "Shadow ray {} from \"{}\" to light {}: plane of the normal and the light",
            ray.number,
            name(&hit.object),
            quoted(&ray.light)
        ),
        strokes: outline_strokes(world, &plane, window, &about),
        ..Drawing::default()
    };
    let way = Way { ray, plane, direction, end, length: shown };
    way.add(&mut drawing, (first.end == End::Occluder).then_some(first.to));
    let degrees = angle_between(direction, normal.into());
    way.add_angle(&mut drawing);
    way.add_notes(&mut drawing, degrees, is_cut.then_some(last.end));
    let angles = vec![RayAngle { ray: ray.number, degrees }];
    Some(Section { plane, drawing, angles, refraction: None })
}

/// The index of the object that blocks a shadow ray.
fn blocker(ray: &RecordedRay) -> Option<u32> {
    match ray.outcome {
        Outcome::Blocked { blocked_by } => Some(blocked_by),
        _ => None,
    }
}

/// The index of the object that is the light of a shadow ray.
fn lamp(world: &World, ray: &RecordedRay) -> Option<u32> {
    let RayKind::Shadow { light } = ray.kind else { return None };
    let placed = world.lights.iter().find(|placed| placed.index == light)?;
    object(world, placed.light.object()?).map(|(index, _)| index)
}

/// A shadow ray in its plane.
struct Way<'a> {
    ray: &'a RecordedRay,
    plane: SectionPlane,
    direction: Vector,
    /// The end of what is drawn of it.
    end: [f64; 2],
    /// The length of what is drawn of it.
    length: f64,
}

impl Way<'_> {
    /// Adds the normal and the ray, dark behind the point where it is blocked.
    fn add(&self, drawing: &mut Drawing, blocked: Option<Point>) {
        let top = [0.0, 0.5 * self.length];
        drawing.strokes.push(Stroke::new(Role::Normal, vec![[0.0; 2], top]));
        let side = [-sign(self.end[0]), 1];
        drawing.labels.push(Label { at: top, text: "normal".to_owned(), role: Role::Normal, side });
        let ray = |role: Role, from: [f64; 2], to: [f64; 2]| Stroke {
            arrow: role != Role::Dark,
            ray: Some(self.ray.number),
            ..Stroke::new(role, vec![from, to])
        };
        let side = [1, 0];
        let light = format!("light {}", quoted(&self.ray.light));
        match blocked.map(|point| self.plane.to_plane(point)) {
            None => {
                drawing.strokes.push(ray(Role::Shadow, [0.0; 2], self.end));
                drawing.labels.push(Label { at: self.end, text: light, role: Role::Shadow, side });
            }
            Some(at) => {
                drawing.strokes.push(ray(Role::Dark, at, self.end));
                drawing.strokes.push(ray(Role::Blocked, [0.0; 2], at));
                drawing.strokes.push(Stroke::new(Role::Blocked, vec![at]));
                drawing.labels.push(Label { at: self.end, text: light, role: Role::Dark, side });
                let text = format!("blocked by {}", quoted(&self.ray.blocked_by));
                drawing.labels.push(Label { at, text, role: Role::Blocked, side });
            }
        }
        drawing.strokes.push(Stroke::new(Role::Normal, vec![[0.0; 2]]));
    }

    fn add_angle(&self, drawing: &mut Drawing) {
        let (stroke, label) = arc(self.plane.along(self.direction), 0.3 * self.length, "θ");
        drawing.strokes.push(stroke);
        drawing.labels.extend(label);
    }

    fn add_notes(&self, drawing: &mut Drawing, degrees: f64, cut: Option<End>) {
        let cosine = short(cos_degrees(degrees));
        drawing.notes.push(format!("θ = {}°, cos θ = {cosine}", short(degrees)));
        if self.plane.is_any {
            drawing.notes.push(ANY.to_owned());
        }
        if cut.is_some_and(|end| end != End::Leaves) {
            let distance = short(self.ray.ray.direction.length());
            drawing.notes.push(format!("The light is {distance} away: the way to it is cut."));
        }
    }
}

const ANY: &str = "The light is along the normal: each plane that contains the normal contains it. This is that of the \
                   world's x axis (of its z axis, if the normal is nearer to x).";
