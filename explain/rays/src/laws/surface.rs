//! Planes and balls, by the log's objects or by the rays that hit them, and the densities of what is drawn on them.

use std::f64::consts::PI;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use serde_json::Value;

use crate::log::Ray;
use crate::traced::Traced;

/// A plane, of an area if that is known, or a ball.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    Flat { point: Point, normal: Vector, area: Option<f64> },
    Ball { center: Point, radius: f64 },
}

impl Surface {
    /// Densities per steradian of a direction from a point to the lamp at this distance: those that are right, and then those of
    /// the first two mistakes.
    pub fn densities(self, from: Point, direction: Vector, far: f64) -> ([f64; 3], [f64; 2]) {
        match self {
            Self::Flat { normal, area, .. } => {
                let cos = normal.dot(direction).abs();
                let right = far * far / (cos * area.unwrap_or(1.0));
                ([right; 3], [1.0, far * far])
            }
            Self::Ball { center, radius } => {
                let to = center - from;
                let cone = 1.0 - (1.0 - radius * radius / to.length_squared()).max(0.0).sqrt();
                let normal = (1.0 / radius) * (far * direction - to);
                let cos = normal.dot(direction).abs();
                let over_area = far * far / (cos * 2.0 * PI * radius * radius);
                ([0.5 / (PI * cone), 0.5 * over_area, over_area], [1.0, far * far])
            }
        }
    }

    /// That of an object's line.
    pub fn of_line(traced: &Traced, name: &str) -> Option<Self> {
        let fields = &traced.log.objects.iter().find(|object| &*object.name == name)?.fields;
        let triple = |shape: &Value, field: &str| {
            serde_json::from_value::<[f64; 3]>(shape.get(field)?.clone()).ok().map(Vector::from)
        };
        let number = |shape: &Value, field: &str| shape.get(field)?.as_f64();
        if let Some(ball) = fields.get("sphere") {
            let center = Point::from(triple(ball, "center")?.to_array());
            return Some(Self::Ball { center, radius: number(ball, "radius")?.abs() });
        }
        let (point, normal, area) = match (fields.get("rectangle"), fields.get("disk")) {
            (Some(it), _) => {
                let across = triple(it, "a")?.cross(triple(it, "b")?);
                (triple(it, "corner")?, across, across.length())
            }
            (_, Some(it)) => {
                let radius = number(it, "radius")?;
                (triple(it, "center")?, triple(it, "normal")?, PI * radius * radius)
            }
            _ => return None,
        };
        let point = Point::from(point.to_array());
        Some(Self::Flat { point, normal: normal.unit()?, area: Some(area) })
    }

    /// That on which all hits of an object lie.
    pub fn of_hits(traced: &Traced, name: &Arc<str>) -> Option<Self> {
        let is_its = |it: &(usize, &Ray)| !it.1.is_shadow() && it.1.object.as_ref() == Some(name);
        let hit = |(index, ray): (usize, &Ray)| {
            let n = ray.normal?.unit()?;
            // turned to the outside as far as the log says so
            let is_back = ray.front == Some(false) && n.dot(ray.direction) < 0.0;
            Some((traced.end_point(index)?, if is_back { -n } else { n }))
        };
        let hits: Vec<(Point, Vector)> = traced.rays().filter(is_its).filter_map(hit).collect();
        let &(point, normal) = hits.first()?;
        if hits.iter().all(|(_, n)| n.cross(normal).length() <= 1e-3) {
            let is_plane =
                hits.iter().all(|(p, _)| (*p - point).dot(normal).abs() <= 1e-3 * traced.scale);
            let is_told = hits.len() >= 3 && is_plane;
            return is_told.then_some(Self::Flat { point, normal, area: None });
        }
        let sine = |it: &&(Point, Vector)| it.1.cross(normal).length();
        let &(other, across) = hits.iter().max_by(|a, b| sine(a).total_cmp(&sine(b)))?;
        let turn = normal - across;
        let radius = (point - other).dot(turn) / turn.length_squared();
        let center = point - radius * normal;
        let is_ball =
            hits.iter().all(|(p, n)| (*p - radius * *n).distance(center) <= 1e-3 * radius.abs());
        (hits.len() >= 4 && is_ball).then_some(Self::Ball { center, radius: radius.abs() })
    }

    /// The unit normal at a point of the surface.
    pub fn normal(self, at: Point) -> Vector {
        match self {
            Self::Flat { normal, .. } => normal,
            Self::Ball { center, radius } => (1.0 / radius) * (at - center),
        }
    }

    /// How far along a unit direction the surface is met.
    pub fn hits(self, from: Point, direction: Vector) -> Vec<f64> {
        match self {
            Self::Flat { point, normal, .. } => {
                let along = direction.dot(normal);
                let far = (point - from).dot(normal) / along;
                if along.abs() < 1e-3 { Vec::new() } else { vec![far] }
            }
            Self::Ball { center, radius } => {
                let to = center - from;
                let middle = to.dot(direction);
                let across = (to - middle * direction).length();
                // what nearly passes by is for rounding to decide
                if across > 0.999 * radius {
                    return Vec::new();
                }
                let half = (radius * radius - across * across).sqrt();
                vec![middle - half, middle + half]
            }
        }
    }
}
