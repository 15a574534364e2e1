//! The plane of incidence of a hit.

use explain::{RecordedHit, RecordedRay};
use groundtruth::math::{Vector, cos_degrees, sin_degrees};
use groundtruth::printable::name;
use groundtruth::trace::RayKind;
use groundtruth::world::World;
use text::digits::short;

use super::{
    Drawing, RayAngle, Refraction, Role, Section, SectionPlane, Stroke, Window, angle_between, arc,
    object, outline_strokes, sign,
};

/// A direction whose sine to the plane is smaller is in it.
const IN_PLANE: f64 = 1e-6;
/// A smaller angle, in degrees, has no arc.
const NARROW: f64 = 0.1;
/// In a smaller angle, in degrees, its letter has no room.
const ROOMY: f64 = 12.0;
/// Half the side of the drawing, in diagonals of the object's box.
const OF_OBJECT: f64 = 0.75;
/// Half the side of the drawing, in lengths of the rays at the hit.
const OF_RAYS: f64 = 1.3;
/// The length of a ray that is cut, as a part of half the side.
const CUT: f64 = 0.8;

/// The section of a ray that hits a surface.
pub fn section(world: &World, ray: &RecordedRay) -> Option<Section> {
    let hit = ray.hit.as_ref()?;
    let incoming = ray.ray.direction.unit()?;
    let normal = if incoming.dot(hit.normal) > 0.0 { -hit.normal } else { hit.normal };
    let plane = SectionPlane::of(hit.point, normal, incoming);
    // a log may name none of its objects
    let (index, size) = object(world, &hit.object).unzip();
    let half = half_side(ray, hit, size.unwrap_or(f64::INFINITY));
    let window = Window { center: [0.0; 2], half };
    let at = Incidence { ray, hit, incoming, normal: normal.into(), plane, length: CUT * half };
    let mut drawing = Drawing {
        title: format!("Ray {} at \"{}\": plane of incidence", ray.number, name(&hit.object)),
        strokes: outline_strokes(world, &plane, window, index.as_slice()),
        ..Drawing::default()
    };
    let refraction = at.refraction();
    at.add_normals(&mut drawing, refraction.is_some());
    let mut angles = vec![at.add_incoming(&mut drawing)];
    angles.extend(at.children().map(|child| at.add_child(&mut drawing, child)));
    drawing.strokes.push(Stroke::new(Role::Normal, [[0.0; 2]]));
    if let Some(refraction) = &refraction {
        at.add_indices(&mut drawing, refraction);
        drawing.notes.push(refraction.to_string());
    }
    drawing.notes.extend(plane.is_any.then(|| ANY.to_owned()));
    Some(Section { plane, drawing, angles, refraction })
}

const ANY: &str = "The ray is along the normal: each plane that contains the normal is one of incidence. This is that of the \
                   world's x axis (of its z axis, if the normal is nearer to x).";

/// Half the side of the square that is drawn around a hit: all of a small object, and of a large one as much as the rays
/// are long.
fn half_side(ray: &RecordedRay, hit: &RecordedHit, size: f64) -> f64 {
    let inside = ray.children.iter().filter_map(|child| child.hit.as_ref());
    let inside = inside.filter(|next| next.object == hit.object);
    let longest = inside.map(|next| next.t).fold(hit.t, f64::max);
    (OF_OBJECT * size).min(OF_RAYS * longest).max(f64::MIN_POSITIVE)
}

/// A hit in its plane of incidence.
struct Incidence<'a> {
    ray: &'a RecordedRay,
    hit: &'a RecordedHit,
    incoming: Vector,
    /// On the side of the ray.
    normal: Vector,
    plane: SectionPlane,
    /// The length of rays that are cut.
    length: f64,
}

impl Incidence<'_> {
    fn children(&self) -> impl Iterator<Item = &RecordedRay> {
        self.ray.children.iter().filter(|child| !child.is_shadow())
    }

    /// Snell's law at the hit, with the recorded directions.
    fn refraction(&self) -> Option<Refraction> {
        let optics = self.hit.optics.as_ref()?;
        let sent = self.children().find(|child| child.kind == RayKind::Transmitted);
        let sent = sent.map(|child| angle_between(child.ray.direction, -self.normal));
        Some(Refraction {
            indices: optics.media.map_or([1.0, optics.eta], |media| media.map(|it| it.eta)),
            incidence: angle_between(-self.incoming, self.normal),
            // a path may have taken the mirrored ray
            refraction: sent.or(optics.angle_of_refraction),
        })
    }

    fn add_normals(&self, drawing: &mut Drawing, refracts: bool) {
        let normal = |end: [f64; 2]| Stroke::new(Role::Normal, [[0.0; 2], end]);
        let end = [0.0, self.length];
        drawing.strokes.push(normal(end));
        drawing.say(end, "normal", Role::Normal, [0, 1]);
        if refracts {
            drawing.strokes.push(Stroke { dashed: true, ..normal([0.0, -self.length]) });
        }
        if self.hit.shading_normal == self.hit.normal {
            return;
        }
        let shading = Vector::from(self.hit.shading_normal);
        let shading = if shading.dot(self.normal) < 0.0 { -shading } else { shading };
        let end = self.plane.along(self.length * shading);
        drawing.strokes.push(Stroke { dashed: true, ..normal(end) });
        let degrees = short(angle_between(shading, self.normal));
        drawing.notes.push(format!(
            "The shading normal is dashed: it is {degrees}° from the true normal, from which the angles are measured."
        ));
    }

    fn add_incoming(&self, drawing: &mut Drawing) -> RayAngle {
        let length = self.hit.t.min(self.length);
        let from = self.plane.along(-length * self.incoming);
        let degrees = angle_between(-self.incoming, self.normal);
        let theta = format!("θ₁ = {}°", short(degrees));
        self.add_ray(drawing, (self.ray, Role::Incoming), [from, [0.0; 2]], &theta);
        self.add_arc(drawing, from, "θ₁", degrees);
        RayAngle { ray: self.ray.number, degrees }
    }

    fn add_child(&self, drawing: &mut Drawing, child: &RecordedRay) -> RayAngle {
        let direction = child.ray.direction.unit().unwrap_or_default();
        let is_behind = direction.dot(self.normal) < 0.0;
        let normal = if is_behind { -self.normal } else { self.normal };
        let degrees = angle_between(direction, normal);
        let out_of_plane = direction.dot(self.plane.normal()).abs();
        let is_out = out_of_plane > IN_PLANE;
        let reaches = child.hit.as_ref().map(|hit| hit.t).filter(|&t| t <= 1.25 * self.length);
        let length = reaches.unwrap_or(self.length);
        let to = self.plane.along(length * direction);
        let role =
            if child.kind == RayKind::Transmitted { Role::Transmitted } else { Role::Reflected };
        let angle = match (is_out, role) {
            (true, _) => String::new(),
            (false, Role::Transmitted) => format!("θ₂ = {}°", short(degrees)),
            (false, _) => format!("{}°", short(degrees)),
        };
        self.add_ray(drawing, (child, role), [[0.0; 2], to], &angle);
        if is_out {
            let off = short((90.0 - angle_between(direction, self.plane.normal())).abs());
            let (number, degrees) = (child.number, short(degrees));
            drawing.notes.push(format!(
                "Ray {number} leaves the plane by {off}° (its projection is dashed), and is {degrees}° from the normal."
            ));
        } else {
            let theta = if role == Role::Transmitted { "θ₂" } else { "" };
            self.add_arc(drawing, to, theta, degrees);
        }
        RayAngle { ray: child.number, degrees }
    }

    /// Adds a ray with its words; its projection, if it has no angle in the plane.
    fn add_ray(
        &self,
        drawing: &mut Drawing,
        (ray, role): (&RecordedRay, Role),
        [from, to]: [[f64; 2]; 2],
        angle: &str,
    ) {
        let (dashed, number) = (angle.is_empty(), Some(ray.number));
        let stroke = Stroke { arrow: true, dashed, ray: number, ..Stroke::new(role, [from, to]) };
        drawing.strokes.push(stroke);
        let [x, y] = if role == Role::Incoming { from } else { to };
        let words = match role {
            _ if !ray.is_cast() => "uncast",
            Role::Incoming => "incoming",
            Role::Transmitted => "refracted",
            _ => "reflected",
        };
        let text = format!("{words} ray {}\n{angle}", ray.number).trim_end().to_owned();
        drawing.say([x, y], text, role, [sign(x), sign(y)]);
    }

    /// Nothing if the ray is along the normal.
    fn add_arc(&self, drawing: &mut Drawing, to: [f64; 2], theta: &str, degrees: f64) {
        if degrees < NARROW {
            return;
        }
        let length = (to[0] * to[0] + to[1] * to[1]).sqrt();
        let (stroke, label) = arc(to, 0.35 * length.min(self.length), theta);
        drawing.strokes.push(stroke);
        drawing.labels.extend(label.filter(|_| degrees > ROOMY));
    }

    /// The indices of refraction stand near the hit, where no ray is: that in front of the surface between reflected ray and
    /// surface, or beside the normal if that is narrow.
    fn add_indices(&self, drawing: &mut Drawing, refraction: &Refraction) {
        let [front, behind] = refraction.indices.map(short);
        let between = 0.5 * (refraction.incidence + 90.0);
        let (at, side) = match refraction.incidence > 45.0 {
            true => ([0.0, 0.6], [1, 0]),
            false => ([0.35 * sin_degrees(between), 0.35 * cos_degrees(between)], [0, 0]),
        };
        let at = at.map(|it| it * self.length);
        drawing.say(at, format!("n₁ = {front}"), Role::Outline, side);
        let at = [0.0, -0.4 * self.length];
        drawing.say(at, format!("n₂ = {behind}"), Role::Outline, [-1, 0]);
    }
}

/// Adds the unit direction that a ray should have had, as long as the longest ray that is drawn, with its angle to the normal.
pub fn add_expected(section: &mut Section, number: usize, direction: Vector) {
    let rays = || section.drawing.strokes.iter().filter(|stroke| stroke.ray.is_some());
    let Some(role) = rays().find(|it| it.ray == Some(number)).map(|it| it.role) else { return };
    let lengths = rays().flat_map(|it| &it.points).map(|[x, y]| (x * x + y * y).sqrt());
    let to = section.plane.along(lengths.fold(0.0, f64::max) * direction);
    let stroke = Stroke::new(role, [[0.0; 2], to]);
    section.drawing.strokes.push(Stroke { arrow: true, dashed: true, ..stroke });
    let up = section.plane.vector([0.0, if to[1] < 0.0 { -1.0 } else { 1.0 }]);
    let degrees = short(angle_between(direction, up));
    let text = format!("ray {number} should go\n{degrees}°");
    section.drawing.say(to, text, role, [sign(to[0]), sign(to[1])]);
}

/// `n₁ sin θ₁ = n₂ sin θ₂:`, and on a second line `1 × sin 41.81° = 0.6667, 1.5 × sin 26.39° = 0.6667`.
impl std::fmt::Display for Refraction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [front, behind] = self.indices;
        let side = |n: f64, degrees: f64| {
            let product = n * sin_degrees(degrees);
            format!("{} × sin {}° = {}", short(n), short(degrees), short(product))
        };
        let incident = side(front, self.incidence);
        match self.refraction {
            Some(degrees) => {
                write!(f, "n₁ sin θ₁ = n₂ sin θ₂:\n{incident}, {}", side(behind, degrees))
            }
            None => write!(
                f,
                "n₁ sin θ₁ > n₂, total internal reflection:\n{incident} > {}",
                short(behind)
            ),
        }
    }
}
