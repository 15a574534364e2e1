//! The plane through a hit, its normal and a light.

use explain::{RecordedRay, quoted};
use groundtruth::math::cos_degrees;
use groundtruth::printable::name;
use groundtruth::trace::{Outcome, RayKind};
use groundtruth::world::World;
use text::digits::short;

use super::{
    Drawing, RayAngle, Role, Section, SectionPlane, Stroke, Window, angle_between, arc, object,
    outline_strokes, sign,
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
    let blocker = match ray.outcome {
        Outcome::Blocked { blocked_by } => Some(blocked_by),
        _ => None,
    };
    let about = [Some(index), blocker, lamp(world, ray)];
    let about: Vec<u32> = about.into_iter().flatten().collect();
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
    let blocked = (first.end == End::Occluder).then(|| plane.to_plane(first.to));
    add_way(&mut drawing, ray, (end, shown), blocked);
    let (stroke, label) = arc(plane.along(direction), 0.3 * shown, "θ");
    drawing.strokes.push(stroke);
    drawing.labels.extend(label);
    let degrees = angle_between(direction, normal.into());
    let cosine = short(cos_degrees(degrees));
    drawing.notes.push(format!("θ = {}°, cos θ = {cosine}", short(degrees)));
    drawing.notes.extend(plane.is_any.then(|| ANY.to_owned()));
    if is_cut && last.end != End::Leaves {
        let distance = short(ray.ray.direction.length());
        drawing.notes.push(format!("The light is {distance} away: the way to it is cut."));
    }
    let angles = vec![RayAngle { ray: ray.number, degrees }];
    Some(Section { plane, drawing, angles, refraction: None })
}

/// The index of the object that is the light of a shadow ray.
fn lamp(world: &World, ray: &RecordedRay) -> Option<u32> {
    let RayKind::Shadow { light } = ray.kind else { return None };
    let placed = world.lights.iter().find(|placed| placed.index == light)?;
    object(world, placed.light.object()?).map(|(index, _)| index)
}

/// Adds the normal and a shadow ray, to its end in this distance, dark behind the point where it is blocked.
fn add_way(
    drawing: &mut Drawing,
    ray: &RecordedRay,
    (end, length): ([f64; 2], f64),
    blocked: Option<[f64; 2]>,
) {
    let top = [0.0, 0.5 * length];
    drawing.strokes.push(Stroke::new(Role::Normal, [[0.0; 2], top]));
    drawing.say(top, "normal", Role::Normal, [-sign(end[0]), 1]);
    let stroke = |role: Role, from: [f64; 2], to: [f64; 2]| Stroke {
        arrow: role != Role::Dark,
        ray: Some(ray.number),
        ..Stroke::new(role, [from, to])
    };
    let (side, light) = ([1, 0], format!("light {}", quoted(&ray.light)));
    match blocked {
        None => {
            drawing.strokes.push(stroke(Role::Shadow, [0.0; 2], end));
            drawing.say(end, light, Role::Shadow, side);
        }
        Some(at) => {
            drawing.strokes.push(stroke(Role::Dark, at, end));
            drawing.strokes.push(stroke(Role::Blocked, [0.0; 2], at));
            drawing.strokes.push(Stroke::new(Role::Blocked, [at]));
            drawing.say(end, light, Role::Dark, side);
            let text = format!("blocked by {}", quoted(&ray.blocked_by));
            drawing.say(at, text, Role::Blocked, side);
        }
    }
    drawing.strokes.push(Stroke::new(Role::Normal, [[0.0; 2]]));
}

const ANY: &str = "The light is along the normal: each plane that contains the normal contains it. This is that of the \
                   world's x axis (of its z axis, if the normal is nearer to x).";
