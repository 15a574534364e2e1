//! Geometry in integers: the oracle of grid mode. Nothing is rounded, so every answer is exact. Where `t` is
//! a fraction, the nearest `f64` is the only correct result.

/// Three integers.
pub type Triple = [i64; 3];

/// A fraction with a denominator above zero.
#[derive(Clone, Copy, Debug)]
pub struct Fraction(pub i64, pub i64);

impl Fraction {
    /// `None` for a denominator of zero.
    pub fn new(n: i64, d: i64) -> Option<Self> {
        (d != 0).then(|| if d < 0 { Self(-n, -d) } else { Self(n, d) })
    }

    /// The nearest `f64`: both parts are far below 2⁵³, and division rounds correctly.
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

/// The `t` at which the line `o + t·d` meets the plane through `p` with normal `n`; `None` if it is parallel.
pub fn plane(o: Triple, d: Triple, p: Triple, n: Triple) -> Option<Fraction> {
    Fraction::new(dot(minus(p, o), n), dot(d, n))
}

/// The `t` of both ends of the line segment inside the closed box: of the six intersections with the planes
/// of the faces, the first and the last that lie in the box.
pub fn cuboid(o: Triple, d: Triple, min: Triple, max: Triple) -> Option<[Fraction; 2]> {
    let in_box = |t: &Fraction| {
        (0..3).all(|i| {
            let along = o[i] * t.1 + d[i] * t.0;
            min[i] * t.1 <= along && along <= max[i] * t.1
        })
    };
    let faces = (0..3).flat_map(|i| [min[i], max[i]].map(|face| Fraction::new(face - o[i], d[i])));
    let intersections: Vec<Fraction> = faces.flatten().filter(in_box).collect();
    let order = |a: &Fraction, b: &Fraction| (a.0 * b.1).cmp(&(b.0 * a.1));
    let first = intersections.iter().copied().min_by(order)?;
    let last = intersections.iter().copied().max_by(order)?;
    Some([first, last])
}

/// The `t` at which the line meets the closed triangle; `None` if it misses or lies in the plane. The line
/// misses if it passes two edges on opposite sides: then two signed volumes have opposite signs.
pub fn triangle(o: Triple, d: Triple, [a, b, c]: [Triple; 3]) -> Option<Fraction> {
    let volume = |p: Triple, q: Triple| dot(d, cross(minus(p, o), minus(q, o)));
    let volumes = [volume(a, b), volume(b, c), volume(c, a)];
    if volumes.iter().any(|&s| s < 0) && volumes.iter().any(|&s| s > 0) {
        return None;
    }
    plane(o, d, a, cross(minus(b, a), minus(c, a)))
}

/// The position of a point relative to a boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Inside,
    On,
    Outside,
}

/// Inside if `value` is below the boundary, outside if it is above.
pub fn side(value: i64, boundary: i64) -> Side {
    match value.cmp(&boundary) {
        std::cmp::Ordering::Less => Side::Inside,
        std::cmp::Ordering::Equal => Side::On,
        std::cmp::Ordering::Greater => Side::Outside,
    }
}

/// The coefficients of `a t² + 2 b t + c`, whose roots are the hits of a sphere, and `b² − a c`.
pub fn sphere(o: Triple, d: Triple, center: Triple, radius: i64) -> ([i64; 3], i64) {
    let f = minus(o, center);
    let (a, b, c) = (dot(d, d), dot(f, d), dot(f, f) - radius * radius);
    ([a, b, c], b * b - a * c)
}
