//! A drawing of lines and words in a plane, which a page shows as SVG and the window paints.

mod svg;

use groundtruth::trace::RayKind;

use super::End;

pub use svg::ink;

/// What a line or a word of a drawing stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The ray that arrives at the hit.
    Incoming,
    /// A ray scattered to the side that the ray came from.
    Reflected,
    /// A refracted ray.
    Transmitted,
    /// A shadow ray that reaches its light.
    Shadow,
    /// A shadow ray up to the object that blocks it.
    Blocked,
    /// The dark way behind that object.
    Dark,
    /// The normal.
    Normal,
    /// The shape that the drawing is about.
    Outline,
    /// Another shape.
    Surroundings,
    /// The arc of an angle.
    Arc,
}

impl Role {
    /// Those of rays, in the order in which they are listed: each with its name in files and in legends.
    pub(crate) const RAYS: [(Self, &str, &str); 6] = [
        (Self::Incoming, "camera", "camera"),
        (Self::Reflected, "reflected", "reflected"),
        (Self::Transmitted, "transmitted", "refracted"),
        (Self::Shadow, "shadow_unblocked", "shadow ray"),
        (Self::Blocked, "shadow_blocked", "blocked"),
        (Self::Dark, "shadow_dark", "dark"),
    ];

    /// That of a piece of a ray.
    pub fn of(kind: RayKind, end: End) -> Self {
        match (kind, end) {
            (RayKind::Camera, _) => Self::Incoming,
            (RayKind::Reflected, _) => Self::Reflected,
            (RayKind::Transmitted, _) => Self::Transmitted,
            (RayKind::Shadow { .. }, End::Dark) => Self::Dark,
            (RayKind::Shadow { .. }, End::Occluder) => Self::Blocked,
            (RayKind::Shadow { .. }, End::Hit | End::Leaves | End::Light) => Self::Shadow,
        }
    }
}

/// A line of straight pieces. One of a single point is a dot.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// What it stands for.
    pub role: Role,
    /// Its points: x to the right, y up, in world units.
    pub points: Vec<[f64; 2]>,
    /// Whether an arrowhead in its middle shows its direction.
    pub arrow: bool,
    /// Whether it is dashed: the projection of what is not in the plane, or where a ray should go.
    pub dashed: bool,
    /// The number of the ray that it is.
    pub ray: Option<usize>,
    /// The index of the object that it is an outline of.
    pub object: Option<u32>,
}

/// Words in a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The point that they belong to.
    pub at: [f64; 2],
    /// The words, on one line or more.
    pub text: String,
    /// What they belong to.
    pub role: Role,
    /// On which side of the point they stand: −1 left (below), 0 in the middle, 1 right (above); x and y.
    pub side: [i8; 2],
}

/// Lines and words in a plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// What it shows.
    pub title: String,
    /// Its lines, those first that others are drawn over.
    pub strokes: Vec<Stroke>,
    /// Its words.
    pub labels: Vec<Label>,
    /// Sentences that stand below it.
    pub notes: Vec<String>,
}

impl Stroke {
    /// A line that is not dashed, has no arrowhead and belongs to nothing.
    pub fn new(role: Role, points: impl Into<Vec<[f64; 2]>>) -> Self {
        let points = points.into();
        Self { role, points, arrow: false, dashed: false, ray: None, object: None }
    }
}

impl Drawing {
    /// Adds words at a point.
    pub(crate) fn say(&mut self, at: [f64; 2], text: impl Into<String>, role: Role, side: [i8; 2]) {
        self.labels.push(Label { at, text: text.into(), role, side });
    }

    /// The box around its lines and the points of its words: the least x and y, and the greatest; `None` if it is empty.
    pub fn bounds(&self) -> Option<[[f64; 2]; 2]> {
        let strokes = self.strokes.iter().flat_map(|stroke| &stroke.points);
        let mut points = strokes.chain(self.labels.iter().map(|label| &label.at));
        let first = *points.next()?;
        Some(points.fold([first; 2], |[low, high], point| {
            [
                [low[0].min(point[0]), low[1].min(point[1])],
                [high[0].max(point[0]), high[1].max(point[1])],
            ]
        }))
    }
}

/// The corners of an arrowhead of this length in the middle of the longest piece of a line, its tip first; `None` if every
/// piece is shorter.
pub fn arrowhead(points: &[[f64; 2]], length: f64) -> Option<[[f64; 2]; 3]> {
    let size = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
    let pieces = points.windows(2).map(|ends| {
        let [a, b] = [ends[0], ends[1]];
        (a, [b[0] - a[0], b[1] - a[1]])
    });
    let (from, way) = pieces.max_by(|(_, a), (_, b)| size(*a).total_cmp(&size(*b)))?;
    let whole = size(way);
    if whole < length {
        return None;
    }
    let [x, y] = way.map(|along| along / whole);
    // the middle of the head is that of the piece
    let at = |along: f64, aside: f64| {
        let along = 0.5 * whole + along * length;
        [from[0] + along * x - aside * length * y, from[1] + along * y + aside * length * x]
    };
    Some([at(0.5, 0.0), at(-0.5, 0.36), at(-0.5, -0.36)])
}
