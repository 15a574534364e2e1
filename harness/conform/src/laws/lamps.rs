//! Lamps in closed form: where a ray meets them, how densely their samples lie, and what they send to a surface
//! (Suffern, ch. 18).

use ask::triple;
use serde::Deserialize;
use serde_json::Value;

use groundtruth::math::{Frame, Normal, Point, Step, Transform, Vector, atan2, sin};
use std::f64::consts::PI;

/// The surface of a lamp, placed.
pub struct Lamp {
    place: Transform,
    form: Form,
}

/// A lamp in its own coordinates.
enum Form {
    /// Triangles in one plane.
    Flat(Vec<[Point; 3]>),
    Disk {
        center: Point,
        normal: Normal,
        radius: f64,
    },
    Ball {
        center: Point,
        radius: f64,
    },
}

/// Where a ray meets a lamp.
pub struct LampMeeting {
    pub t: f64,
    /// Between the true normal there and the way back; negative on the inner side.
    pub cosine: f64,
    /// In the coordinates of the shape itself.
    pub local: Point,
}

fn point(value: &Value) -> Option<Point> {
    triple(value).map(Point::from)
}

impl Lamp {
    /// The lamp of a shape as scene files have it: rectangle, disk, sphere, triangle, flat mesh, or an instance of
    /// one. `None` for others, and for spheres that are stretched.
    pub fn of(shape: &Value) -> Option<Self> {
        let (tag, data) = shape.as_object()?.iter().next()?;
        if tag == "instance" {
            let steps = Vec::<Step>::deserialize(&data["transform"]).ok()?;
            let inner = Self::of(&data["of"])?;
            let place = Transform::from_steps(&steps).ok()?.after(&inner.place);
            let is_stretched = matches!(inner.form, Form::Ball { .. }) && !place.is_similarity();
            return (!is_stretched).then_some(Self { place, form: inner.form });
        }
        let form = match tag.as_str() {
            "rectangle" => {
                let (p, [a, b]) =
                    (point(&data["corner"])?, [triple(&data["a"])?, triple(&data["b"])?]);
                let [a, b] = [a, b].map(Vector::from);
                Form::Flat(vec![[p, p + a, p + a + b], [p, p + a + b, p + b]])
            }
            "triangle" => Form::Flat(vec![corners(&data["vertices"], [0, 1, 2])?]),
            "mesh" => {
                let of = |it: &Value| {
                    let index = |i: usize| it[i].as_u64().map(|index| index as usize);
                    corners(&data["vertices"], [index(0)?, index(1)?, index(2)?])
                };
                Form::Flat(data["triangles"].as_array()?.iter().map(of).collect::<Option<_>>()?)
            }
            "disk" => Form::Disk {
                center: point(&data["center"])?,
                normal: Normal::new(Vector::from(triple(&data["normal"])?))?,
                radius: data["radius"].as_f64()?,
            },
            "sphere" => {
                Form::Ball { center: point(&data["center"])?, radius: data["radius"].as_f64()? }
            }
            _ => return None,
        };
        Some(Self { place: Transform::from_steps(&[]).ok()?, form })
    }

    /// Whether each side is seen from a half of space, as of a plane.
    pub fn is_flat(&self) -> bool {
        !matches!(self.form, Form::Ball { .. })
    }

    /// Its triangles where they are.
    fn triangles(&self) -> Vec<[Point; 3]> {
        let Form::Flat(triangles) = &self.form else { return Vec::new() };
        triangles.iter().map(|corners| corners.map(|p| self.place.point(p))).collect()
    }

    /// The radius of a ball where it is.
    fn outer_radius(&self, radius: f64) -> f64 {
        self.place.vector(radius * Vector::X).length()
    }

    /// A point of a flat lamp and its unit normal, by the inverse transposed matrix.
    fn plane(&self) -> Option<(Point, Normal)> {
        let (p, n) = match &self.form {
            Form::Flat(triangles) => {
                let [p, q, r] = *triangles.first()?;
                (p, Normal::new((q - p).cross(r - p))?)
            }
            Form::Disk { center, normal, .. } => (*center, *normal),
            Form::Ball { .. } => return None,
        };
        Some((self.place.point(p), Normal::new(self.place.covector(n))?))
    }

    /// The side of a flat lamp that a point is on: positive in front.
    pub fn side(&self, from: Point) -> Option<f64> {
        let (p, n) = self.plane()?;
        Some(n.dot((from - p).unit()?))
    }

    /// The area.
    pub fn area(&self) -> f64 {
        match &self.form {
            Form::Flat(_) => self
                .triangles()
                .iter()
                .map(|[p, q, r]| 0.5 * (*q - *p).cross(*r - *p).length())
                .sum(),
            Form::Disk { normal, radius, .. } => {
                let frame = Frame::around(*normal);
                let [a, b] = [frame.u, frame.v].map(|axis| self.place.vector(axis));
                PI * radius * radius * a.cross(b).length()
            }
            Form::Ball { radius, .. } => {
                4.0 * PI * self.outer_radius(*radius) * self.outer_radius(*radius)
            }
        }
    }

    /// The area in its own coordinates.
    pub fn inner_area(&self) -> f64 {
        match &self.form {
            Form::Flat(triangles) => {
                triangles.iter().map(|[p, q, r]| 0.5 * (*q - *p).cross(*r - *p).length()).sum()
            }
            Form::Disk { radius, .. } => PI * radius * radius,
            Form::Ball { radius, .. } => 4.0 * PI * radius * radius,
        }
    }

    /// The area of something round over those that other formulas give: `2πr`, `πr`, `r²` for `πr²`; `πr²`, `2πr²`,
    /// `4πr³/3` for `4πr²`.
    pub fn area_ratios(&self) -> impl Iterator<Item = f64> + use<> {
        let ratios = match &self.form {
            Form::Flat(_) => vec![0.5, 2.0],
            Form::Disk { radius: r, .. } => vec![0.5 * r, *r, PI],
            Form::Ball { radius, .. } => vec![4.0, 2.0, 3.0 / self.outer_radius(*radius)],
        };
        ratios.into_iter()
    }

    /// The solid angle that it fills for a point outside; `None` for disks. Triangles by van Oosterom and Strackee
    /// (1983), balls by `2π (1 − cos θ) = 4π sin² θ/2`.
    pub fn solid_angle(&self, from: Point) -> Option<f64> {
        match &self.form {
            Form::Flat(_) => {
                let of = |corners: [Point; 3]| {
                    let [a, b, c] = corners.map(|p| (p - from).unit().unwrap_or(Vector::X));
                    let volume = a.dot(b.cross(c)).abs();
                    2.0 * atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a))
                };
                Some(self.triangles().into_iter().map(of).sum())
            }
            Form::Ball { center, radius } => {
                let sine = self.outer_radius(*radius) / from.distance(self.place.point(*center));
                let half = sin(0.5 * atan2(sine, ((1.0 - sine) * (1.0 + sine)).sqrt()));
                Some(4.0 * PI * half * half)
            }
            Form::Disk { .. } => None,
        }
    }

    /// `∫ cos θ dω` over the lamp, for a surface that has all of it on the side of its normal: polygons by Lambert's
    /// formula, balls and disks seen from their axis by symmetry. `None` for other disks.
    pub fn irradiance(&self, from: Point, normal: Normal) -> Option<f64> {
        let round = |axis: Vector, sine: f64| PI * sine * sine * normal.dot(axis);
        match &self.form {
            Form::Flat(_) => {
                let of = |corners: [Point; 3]| {
                    let unit = corners.map(|p| (p - from).unit().unwrap_or(Vector::X));
                    let edge = |i: usize| {
                        let (a, b) = (unit[i], unit[(i + 1) % 3]);
                        let cross = a.cross(b);
                        let angle = atan2(cross.length(), a.dot(b));
                        cross.unit().map_or(0.0, |axis| 0.5 * angle * normal.dot(axis))
                    };
                    (edge(0) + edge(1) + edge(2)).abs()
                };
                Some(self.triangles().into_iter().map(of).sum())
            }
            Form::Ball { center, radius } => {
                let to = self.place.point(*center) - from;
                Some(round(to.unit()?, self.outer_radius(*radius) / to.length()))
            }
            Form::Disk { center, radius, .. } => {
                let (to, (_, n)) = (self.place.point(*center) - from, self.plane()?);
                let is_on_axis =
                    self.place.is_similarity() && n.dot(to.unit()?).abs() > 1.0 - 1e-12;
                let r = self.outer_radius(*radius);
                is_on_axis
                    .then(|| round(to / to.length(), r / (to.length_squared() + r * r).sqrt()))
            }
        }
    }

    /// Where a ray from outside in a unit direction meets it nearest to this distance; points less than a share
    /// `slack` of its size beyond its border count.
    pub fn meeting(
        &self,
        from: Point,
        direction: Vector,
        distance: f64,
        slack: f64,
    ) -> Option<LampMeeting> {
        let of = |t: f64, normal: Normal| LampMeeting {
            t,
            cosine: -normal.dot(direction),
            local: self.place.inverse().point(from + t * direction),
        };
        if let Form::Ball { center, radius } = &self.form {
            let (to, r) = (self.place.point(*center) - from, self.outer_radius(*radius));
            let middle = to.dot(direction);
            let off = (to - middle * direction).length();
            if off > r * (1.0 + slack) {
                return None;
            }
            let half = ((r - off) * (r + off)).max(0.0).sqrt();
            let ends = [middle - half, middle + half];
            let nearer = |t: &f64, s: &f64| (t - distance).abs().total_cmp(&(s - distance).abs());
            let t = ends.into_iter().min_by(nearer)?;
            return Some(of(t, Normal::new(t * direction - to)?));
        }
        let (p, n) = self.plane()?;
        let t = (p - from).dot(n) / n.dot(direction);
        let meeting = of(t, n);
        let is_inside = match &self.form {
            Form::Flat(triangles) => triangles.iter().any(|it| is_in(it, meeting.local, slack)),
            Form::Disk { center, radius, .. } => {
                meeting.local.distance(*center) <= radius * (1.0 + slack)
            }
            Form::Ball { .. } => false,
        };
        (t > 0.0 && is_inside).then_some(meeting)
    }
}

fn corners(vertices: &Value, of: [usize; 3]) -> Option<[Point; 3]> {
    let [p, q, r] = of.map(|i| point(&vertices[i]));
    Some([p?, q?, r?])
}

/// Whether a point of the plane of a triangle is in it: by the areas over its edges.
fn is_in(&[p, q, r]: &[Point; 3], at: Point, slack: f64) -> bool {
    let whole = (q - p).cross(r - p);
    let share = |a: Point, b: Point| (a - at).cross(b - at).dot(whole) / whole.length_squared();
    [share(p, q), share(q, r), share(r, p)].into_iter().all(|share| share >= -slack)
}
