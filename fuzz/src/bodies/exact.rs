//! Geometry in whole numbers: the oracle of grid mode. Nothing is rounded, so every answer is
//! right, and where `t` is a fraction its nearest `f64` is the only right one.

/// Three whole numbers.
pub type Triple = [i64; 3];

/// A fraction with a denominator above zero.
#[derive(Clone, Copy, Debug)]
pub struct Fraction(pub i64, pub i64);

impl Fraction {
    /// `None` for a denominator of zero.
    pub fn new(n: i64, d: i64) -> Option<Self> {
        (d != 0).then(|| if d < 0 { Self(-n, -d) } else { Self(n, d) })
    }

    /// The nearest number: both parts are far below 2⁵³, and division rounds correctly.
    pub fn value(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }

    pub fn is_positive(self) -> bool {
        self.0 > 0
    }
}

pub fn minus(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| a[i] - b[i])
}

pub fn dot(a: Triple, b: Triple) -> i64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

pub fn cross(a: Triple, b: Triple) -> Triple {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Where the line `o + t·d` meets the plane through `p` across `n`, unless it is parallel.
pub fn plane(o: Triple, d: Triple, p: Triple, n: Triple) -> Option<Fraction> {
    Fraction::new(dot(minus(p, o), n), dot(d, n))
}

/// The ends of the part of the line inside the closed box: of the six meetings with its faces, the
/// first and last that lie in the box.
pub fn cuboid(o: Triple, d: Triple, min: Triple, max: Triple) -> Option<[Fraction; 2]> {
    let in_box = |t: &Fraction| {
        (0..3).all(|i| {
            let along = o[i] * t.1 + d[i] * t.0;
            min[i] * t.1 <= along && along <= max[i] * t.1
        })
    };
    let faces = (0..3).flat_map(|i| [min[i], max[i]].map(|face| Fraction::new(face - o[i], d[i])));
    let meetings: Vec<Fraction> = faces.flatten().filter(in_box).collect();
    let order = |a: &Fraction, b: &Fraction| (a.0 * b.1).cmp(&(b.0 * a.1));
    let first = meetings.iter().copied().min_by(order)?;
    let last = meetings.iter().copied().max_by(order)?;
    Some([first, last])
}

/// Where the line meets the closed triangle: on no two edges does it pass on opposite sides
/// (signed volumes); `None` beside it and in its plane.
pub fn triangle(o: Triple, d: Triple, [a, b, c]: [Triple; 3]) -> Option<Fraction> {
    let volume = |p: Triple, q: Triple| dot(d, cross(minus(p, o), minus(q, o)));
    let sides = [volume(a, b), volume(b, c), volume(c, a)];
    if sides.iter().any(|&s| s < 0) && sides.iter().any(|&s| s > 0) {
        return None;
    }
    plane(o, d, a, cross(minus(b, a), minus(c, a)))
}

/// What is known of a place against a border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Inside,
    On,
    Outside,
}

/// Below the border, on it, or above.
pub fn side(value: i64, border: i64) -> Side {
    match value.cmp(&border) {
        std::cmp::Ordering::Less => Side::Inside,
        std::cmp::Ordering::Equal => Side::On,
        std::cmp::Ordering::Greater => Side::Outside,
    }
}

/// `a t² + 2 b t + c` of a sphere about `center`, and `b² − a c`.
pub fn sphere(o: Triple, d: Triple, center: Triple, radius: i64) -> ([i64; 3], i64) {
    let f = minus(o, center);
    let (a, b, c) = (dot(d, d), dot(f, d), dot(f, f) - radius * radius);
    ([a, b, c], b * b - a * c)
}
