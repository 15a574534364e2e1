//! The integrands: functions of a pixel's samples whose means are known.

use std::f64::consts::PI;

use serde::Serialize;

use groundtruth::math::{Pcg32, acos, cos_degrees, exp, exp_m1, floor, maps, power, sin_degrees};

/// A family of functions, one for each pixel.
#[derive(Serialize)]
pub struct Integrand {
    /// Its name.
    pub name: &'static str,
    /// A description, and the case in a picture that it represents.
    pub about: &'static str,
    /// Whether it needs a second sample, for the lens or a lamp.
    #[serde(skip)]
    pub four_dimensional: bool,
    /// The function of a pixel, from random numbers.
    #[serde(skip)]
    pub problem: fn(&mut Pcg32) -> Problem,
}

/// A function of a pixel sample and a sample of the lens or a lamp, and its mean.
pub struct Problem {
    /// The mean over both unit squares.
    pub exact: f64,
    /// The difference that counts as an error of 100 %.
    pub scale: f64,
    /// The function.
    pub value: Box<dyn Fn([f64; 2], [f64; 2]) -> f64 + Send + Sync>,
}

impl Problem {
    /// White inside a region, black outside; the scale is 1, the difference of white and black.
    fn of_white(
        exact: f64,
        inside: impl Fn([f64; 2], [f64; 2]) -> bool + Send + Sync + 'static,
    ) -> Self {
        let value = move |pixel, lens| if inside(pixel, lens) { 1.0 } else { 0.0 };
        Self { exact, scale: 1.0, value: Box::new(value) }
    }

    /// A function whose scale is its mean.
    fn relative(
        exact: f64,
        value: impl Fn([f64; 2], [f64; 2]) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self { exact, scale: exact, value: Box::new(value) }
    }
}

/// All integrands.
pub static INTEGRANDS: [Integrand; 8] = [
    Integrand {
        name: "edge",
        about: "A straight edge through the pixel, at any angle: the outline of an object.",
        four_dimensional: false,
        problem: edge,
    },
    Integrand {
        name: "corner",
        about: "A corner of a window along the axes: the product of two steps.",
        four_dimensional: false,
        problem: corner,
    },
    Integrand {
        name: "disk",
        about: "A disk inside the pixel: a small object.",
        four_dimensional: false,
        problem: disk,
    },
    Integrand {
        name: "checker to the horizon",
        about: "A checkered ground in perspective, from one to 16 pixels below the horizon \
                (figure 4.8): details smaller than pixels.",
        four_dimensional: false,
        problem: checker,
    },
    Integrand {
        name: "cosine power",
        about: "2π cosᵉ θ over directions uniform on the hemisphere, e from 1 to 20: a glossy \
                highlight without importance sampling.",
        four_dimensional: false,
        problem: cosine_power,
    },
    Integrand {
        name: "smooth product",
        about: "A product of four exponentials of the pixel and lens coordinates: smooth shading.",
        four_dimensional: true,
        problem: smooth_product,
    },
    Integrand {
        name: "defocused edge",
        about: "An edge out of focus, blurred over up to 8 pixels by a round lens.",
        four_dimensional: true,
        problem: defocused_edge,
    },
    Integrand {
        name: "soft shadow",
        about: "A point of a penumbra, from 3 to 30 pixels wide: which part of a square lamp an edge hides, at any \
                angle.",
        four_dimensional: true,
        problem: soft_shadow,
    },
];

/// `x cos α + y sin α < c`, through a random point of the pixel.
fn edge(random: &mut Pcg32) -> Problem {
    let degrees = 360.0 * random.uniform();
    let (a, b) = (cos_degrees(degrees), sin_degrees(degrees));
    let c = a * random.uniform() + b * random.uniform();
    Problem::of_white(below_line(a, b, c), move |[x, y], _| a * x + b * y < c)
}

/// The part of the unit square where `a x + b y < c`.
///
/// With a, b ≥ 0 it is a triangle minus the parts outside the square; other signs are mirrored to
/// this case.
fn below_line(a: f64, b: f64, c: f64) -> f64 {
    if a < 0.0 {
        return below_line(-a, b, c - a);
    }
    if b < 0.0 {
        return below_line(a, -b, c - b);
    }
    if a * b < 1e-12 {
        // almost parallel to an axis: the triangles would cancel
        return (c / a.max(b)).clamp(0.0, 1.0);
    }
    let triangle = |c: f64| {
        let c = c.max(0.0);
        0.5 * c * c / (a * b)
    };
    triangle(c) - triangle(c - a) - triangle(c - b) + triangle(c - a - b)
}

fn corner(random: &mut Pcg32) -> Problem {
    let [a, b] = [random.uniform(), random.uniform()];
    Problem::of_white(a * b, move |[x, y], _| x < a && y < b)
}

fn disk(random: &mut Pcg32) -> Problem {
    let r = 0.1 + 0.4 * random.uniform();
    let [cx, cy] = [0; 2].map(|_| r + (1.0 - 2.0 * r) * random.uniform());
    let inside = move |[x, y]: [f64; 2], _| (x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r;
    Problem::of_white(PI * r * r, inside)
}

/// A pixel of the ground, with rows counted downward from the horizon. The view plane is at the
/// distance of 20 pixels; the side of a square is half the height of the eye.
fn checker(random: &mut Pcg32) -> Problem {
    const DISTANCE: f64 = 20.0;
    const SQUARE: f64 = 0.5;
    let row = 1.0 + f64::from(random.below(16));
    let column = f64::from(random.below(40)) - 20.0;
    // the point where the ray of film point (x, −y) hits the ground, in squares
    let ahead = move |y: f64| DISTANCE / (SQUARE * y);
    let aside = move |x: f64, y: f64| x / (SQUARE * y);
    let odd = |a: f64| floor(a).rem_euclid(2.0) == 1.0;

    // Along x the function is a square wave, whose integral is y times a triangle wave of x/y. The
    // integral is linear in y between `breaks`: the y where a square begins, or where an edge of a
    // square crosses a side of the pixel. So the midpoint rule between them is exact.
    let mut breaks = vec![row, row + 1.0];
    for numerator in [DISTANCE / SQUARE, column / SQUARE, (column + 1.0) / SQUARE] {
        let ends = [numerator / (row + 1.0), numerator / row];
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let (first, last) = (floor(low) as i64 + 1, high.ceil() as i64);
        breaks.extend((first..last).map(|k| numerator / k as f64).filter(|y| y.is_finite()));
    }
    breaks.sort_by(f64::total_cmp);
    // the integral of the square wave from 0: it rises to 1 in even squares and falls to 0 in odd
    // ones
    let wave = |a: f64| {
        let a = a.rem_euclid(2.0);
        if a < 1.0 { a } else { 2.0 - a }
    };
    let exact: f64 = breaks
        .windows(2)
        .filter(|pair| pair[1] > pair[0])
        .map(|pair| {
            let middle = 0.5 * (pair[0] + pair[1]);
            let sign = if odd(ahead(middle)) { -1.0 } else { 1.0 };
            let across = wave(aside(column + 1.0, middle)) - wave(aside(column, middle));
            (pair[1] - pair[0]) * 0.5 * (1.0 + sign * SQUARE * middle * across)
        })
        .sum();
    Problem::of_white(exact, move |[u, v], _| {
        let (x, y) = (column + u, row + v);
        odd(ahead(y)) == odd(aside(x, y))
    })
}

fn cosine_power(random: &mut Pcg32) -> Problem {
    let e = 1.0 + 19.0 * random.uniform();
    let value = move |u, _| 2.0 * PI * power(maps::hemisphere(u, 0.0).z().max(0.0), e);
    Problem::relative(2.0 * PI / (e + 1.0), value)
}

/// `∏ exp(aₖ xₖ)`, a from −2 to 2: the mean of each factor is `(eᵃ − 1)/a`.
fn smooth_product(random: &mut Pcg32) -> Problem {
    let a = [0; 4].map(|_| 4.0 * random.uniform() - 2.0);
    let mean = |a: f64| if a == 0.0 { 1.0 } else { exp_m1(a) / a };
    let value = move |[x, y]: [f64; 2], [lx, ly]: [f64; 2]| {
        exp(a[0] * x + a[1] * y + a[2] * lx + a[3] * ly)
    };
    Problem::relative(a.map(mean).iter().product(), value)
}

/// `x + r l < c`, where x is the pixel coordinate, l the lens coordinate, and the blur is `2r`
/// pixels wide.
fn defocused_edge(random: &mut Pcg32) -> Problem {
    let r = 0.5 + 3.5 * random.uniform();
    let c = 0.5 + r * (2.0 * random.uniform() - 1.0);
    let exact = r * (mean_excess(c / r) - mean_excess((c - 1.0) / r));
    let inside = move |[x, _]: [f64; 2], lens| x + r * maps::disk(lens)[0] < c;
    Problem::of_white(exact, inside)
}

/// `a l + b m < c + s x`: the point (l, m) of the lamp is on one side of the edge, which the pixel coordinate x moves by
/// `s`; the penumbra is `(a + b)/s` pixels wide.
fn soft_shadow(random: &mut Pcg32) -> Problem {
    // not so near to an axis that the cubes would cancel
    let degrees = 5.0 + 80.0 * random.uniform();
    let (a, b) = (cos_degrees(degrees), sin_degrees(degrees));
    let s = (a + b) / (3.0 + 27.0 * random.uniform());
    let c = (a + b + s) * random.uniform() - s;
    // the integral of `below_line` from 0 to c
    let triangle = |c: f64| power(c.max(0.0), 3.0) / (6.0 * a * b);
    let integral = |c: f64| triangle(c) - triangle(c - a) - triangle(c - b) + triangle(c - a - b);
    let exact = (integral(c + s) - integral(c)) / s;
    Problem::of_white(exact, move |[x, _], [l, m]| a * l + b * m < c + s * x)
}

/// The mean of `max(z − l, 0)`, where l is the first coordinate of a point of the unit disk, with
/// the density `2/π √(1 − l²)`.
pub fn mean_excess(z: f64) -> f64 {
    if z.abs() >= 1.0 {
        return z.max(0.0);
    }
    let root = ((1.0 - z) * (1.0 + z)).sqrt();
    let arc_sine = 0.5 * PI - acos(z);
    let probability = 0.5 + (z * root + arc_sine) / PI; // of l < z
    z * probability + 2.0 / (3.0 * PI) * root * root * root
}
