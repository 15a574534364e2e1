//! Why a light sends nothing to a point for the numbers drawn there.
//!
//! The tracer's light only answers that it has no sample; what the scene says of it tells why.

use groundtruth::background::{Directions, Sky};
use groundtruth::lights::{Area, Kind, LightContext, Spot, from_point, in_cube};
use groundtruth::math::{Normal, Point, Vector, atan2, to_degrees};
use groundtruth::shapes::Sampling;
use groundtruth::world::World;

use super::unlit::Unlit;

/// Why this light of a world has no sample for a point.
pub(super) fn why_unsent(
    world: &World,
    source: &Kind,
    from: &LightContext,
    u: &[[f64; 2]],
) -> Unlit {
    let at_light = |location| Unlit::AtLight { distance: from.point.distance(location) };
    match source {
        Kind::PointLight(light) => at_light(light.location),
        Kind::FakeSpherical(light) => at_light(light.location + light.jitter * in_cube(u)),
        Kind::Spot(light) => outside_cone(light, from.point).unwrap_or(at_light(light.location)),
        Kind::Area(light) => match cos_lamp(world, light, from.point, u[0]) {
            Some(cos_lamp) => Unlit::BehindLamp { cos_lamp },
            None => Unlit::HiddenPoint,
        },
        Kind::Environment(_) if is_black(&world.background) => Unlit::Dark,
        _ => Unlit::NoDirection,
    }
}

/// How far outside the cone of a light a point is; `None` if it is too near the light.
fn outside_cone(light: &Spot, from: Point) -> Option<Unlit> {
    let sample = from_point(from, light.location, light.ls * light.color, light.attenuation)?;
    let (axis, direction) = (Normal::new(light.direction)?, -sample.direction);
    let across = Vector::from(axis).cross(direction).length();
    let angle = to_degrees(atan2(across, axis.dot(direction)));
    Some(Unlit::OutsideCone { angle, outer: light.outer })
}

/// The cosine between the normal at the drawn point of a lamp and the direction from there to a
/// point; `None` if it drew none.
fn cos_lamp(world: &World, lamp: &Area, from: Point, u: [f64; 2]) -> Option<f64> {
    let object = world.objects().iter().find(|object| *object.name == *lamp.object)?;
    let by = |sampling| object.shape.sampled(sampling);
    let surface = match lamp.sampling {
        None => by(Sampling::SolidAngle).or_else(|| by(Sampling::Area)),
        Some(sampling) => by(sampling),
    };
    let (at, _) = surface?.sample(from, u)?;
    Some(at.normal.dot((from - at.point).unit()?))
}

/// Whether a sky by image is black everywhere.
fn is_black(sky: &Sky) -> bool {
    matches!(sky, Sky::Image(sky) if Directions::new(sky).is_black())
}
