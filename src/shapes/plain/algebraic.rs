//! The algebraic surface (implicit surfaces: Suffern, ch. 19): the points of a box with
//! `f(x, y, z) = 0`, where `f = Σ c xⁱ yʲ zᵏ` is a polynomial of the user's own.
//!
//! In the box the ray is `m + s h` with s from −1 to 1, and `f` is a polynomial in s,
//! `F(s) = Σ c_k s^k`. It is formed about the middle of the chord, not about the ray's origin, so
//! that its coefficients keep their digits. Still it only says where to search: between the roots
//! of `F′` it is monotone. The signs there, and the hits between, are those of `f` itself.
//!
//! The usual routine, by samples along the ray (the book has none):
//! `src/shapes/textbook/algebraic.rs`.

use std::sync::Arc;

use arrayvec::ArrayVec;

use crate::invalid::{Invalid, Ranges, shown};
use crate::math::polynomial::{MAX_DEGREE, roots_between};
use crate::math::{
    Aabb, Finite, Point, Ray, Span, Tolerance, UNIT_ROUNDOFF, Vector, bracketed_root, power,
};
use crate::shapes::{
    Candidate, Context, Cuboid, Made, Shape, Specification, Surface, made, normal_along, textbook,
};

/// `coefficient · xⁱ yʲ zᵏ` for powers `[i, j, k]`.
#[kind(PartialEq)]
pub struct Term {
    /// The number before the powers; finite.
    #[schemars(extend("x-dimension" = "1/length^powers"))]
    pub coefficient: Finite,
    /// The powers of x, y and z: whole numbers whose sum is at most 16.
    pub powers: [u32; 3],
}

/// The points inside a box where the sum of the terms is zero; the normal points to where it is
/// positive. The degree is that of the textbooks' surfaces and more: up to 16.
#[kind(PartialEq)]
pub struct Algebraic {
    /// The terms of the sum; at least one is not a constant.
    pub terms: Vec<Term>,
    /// The corner of the box with the smallest coordinates.
    pub min: Point,
    /// The corner of the box with the largest coordinates.
    pub max: Point,
}

/// `x⁰, x¹, … x¹⁶` for each coordinate.
type Powers = [[f64; MAX_DEGREE + 1]; 3];

/// `f` at a point, its gradient, and the sum of the terms' magnitudes.
struct Values {
    value: f64,
    gradient: Vector,
    magnitude: f64,
}

/// The part of a ray inside the box, `m + s h` with s from −1 to 1.
struct Chord {
    m: Vector,
    h: Vector,
    /// `t = middle + s half`.
    middle: f64,
    half: f64,
}

impl Chord {
    fn new(ray: &Ray, [enter, leave]: [f64; 2]) -> Option<Self> {
        let (middle, half) = (0.5 * enter + 0.5 * leave, 0.5 * leave - 0.5 * enter);
        let finite = middle.is_finite() && half.is_finite();
        let m = ray.at(middle).to_vector();
        finite.then(|| Self { m, h: half * ray.direction, middle, half })
    }

    fn at(&self, s: f64) -> Vector {
        self.m + s * self.h
    }

    /// Ascends with `s`.
    fn t(&self, s: f64) -> f64 {
        self.middle + s * self.half
    }
}

#[derive(Clone, Debug)]
pub struct AlgebraicShape {
    pub terms: Vec<Term>,
    degree: usize,
    pub domain: Cuboid,
}

impl Specification for Algebraic {
    fn make(&self, context: &mut Context) -> Made {
        for (index, term) in self.terms.iter().enumerate() {
            term.check().map_err(|e| e.inside(index).inside("terms"))?;
        }
        let terms = gathered(&self.terms);
        let degree = terms.iter().map(Term::degree).max().unwrap_or(0) as usize;
        if degree == 0 {
            let found = match terms.as_slice() {
                [] if self.terms.is_empty() => "found no terms",
                [] => "found nothing but zero",
                _ => "found a constant",
            };
            let problem =
                format!("{found}, but a term with a power of x, y or z that is not 0 is needed");
            return Err(Invalid::field("terms", problem));
        }
        let domain = Cuboid { min: self.min, max: self.max };
        domain.build(context)?;
        check_size(&terms, degree, domain.bounds())?;
        made(AlgebraicShape { terms, degree, domain })
    }
}

/// The terms with like ones as one, in the order of the first of each, without those that are zero.
fn gathered(terms: &[Term]) -> Vec<Term> {
    let mut gathered: Vec<Term> = Vec::new();
    for term in terms {
        match gathered.iter_mut().find(|like| like.powers == term.powers) {
            Some(like) => like.coefficient += term.coefficient,
            None => gathered.push(term.clone()),
        }
    }
    gathered.retain(|term| term.coefficient != 0.0);
    gathered
}

/// Refuses polynomials whose terms leave the range of `f64` in the box: the largest product of
/// coordinates, or the largest term, whose gradient is squared.
fn check_size(terms: &[Term], degree: usize, bounds: Aabb) -> Result<(), Invalid> {
    let size = bounds.min.to_vector().max_abs().max(bounds.max.to_vector().max_abs());
    let product = power(size, degree as f64);
    let term = |t: &Term| t.coefficient.abs() * power(size, f64::from(t.degree()));
    let largest = terms.iter().map(term).fold(0.0, f64::max);
    let [products, values] = [1e-250..1e250, 1e-100..1e100];
    if products.contains(&product) && values.contains(&largest) {
        return Ok(());
    }
    let [size, largest] = [size, largest].map(shown);
    let problem = format!(
        "of degree {degree} in coordinates up to {size} found a largest term of {largest}, but only \
         products of coordinates from {:e} to {:e} and terms from {:e} to {:e} are supported",
        products.start, products.end, values.start, values.end
    );
    Err(Invalid::field("terms", problem))
}

impl Term {
    fn degree(&self) -> u32 {
        self.powers.iter().fold(0, |sum, &power| sum.saturating_add(power))
    }

    fn check(&self) -> Result<(), Invalid> {
        self.check_ranges()?;
        if self.degree() as usize <= MAX_DEGREE {
            return Ok(());
        }
        let powers = self.powers;
        let problem = format!("found {powers:?}, but a sum of at most {MAX_DEGREE} is needed");
        Err(Invalid::field("powers", problem))
    }
}

impl AlgebraicShape {
    fn powers(&self, p: Vector) -> Powers {
        p.to_array().map(|x| {
            let mut powers = [1.0; MAX_DEGREE + 1];
            for i in 1..=self.degree {
                powers[i] = powers[i - 1] * x;
            }
            powers
        })
    }

    fn values(&self, p: Vector) -> Values {
        let table = self.powers(p);
        let mut sums = Values { value: 0.0, gradient: Vector::ZERO, magnitude: 0.0 };
        for Term { coefficient, powers } in &self.terms {
            let [i, j, k] = powers.map(|power| power as usize);
            let [x, y, z] = &table;
            let product = coefficient * (x[i] * y[j] * z[k]);
            sums.value += product;
            sums.magnitude += product.abs();
            let slope = |axis: usize, own: usize, others: f64| {
                if own == 0 { 0.0 } else { own as f64 * table[axis][own - 1] * others }
            };
            let gradient = Vector::new(
                slope(0, i, y[j] * z[k]),
                slope(1, j, x[i] * z[k]),
                slope(2, k, x[i] * y[j]),
            );
            sums.gradient += *coefficient * gradient;
        }
        sums
    }

    /// The coefficients of `F`: each term is a product of linear polynomials in s.
    fn along(&self, chord: &Chord) -> [f64; MAX_DEGREE + 1] {
        let mut sum = [0.0; MAX_DEGREE + 1];
        for Term { coefficient, powers } in &self.terms {
            let mut product = [0.0; MAX_DEGREE + 1];
            product[0] = *coefficient;
            let mut degree = 0;
            for (axis, &power) in powers.iter().enumerate() {
                let (at, rate) = (chord.m.along(axis), chord.h.along(axis));
                for _ in 0..power {
                    degree += 1;
                    for i in (1..=degree).rev() {
                        product[i] = product[i] * at + product[i - 1] * rate;
                    }
                    product[0] *= at;
                }
            }
            for (total, part) in sum.iter_mut().zip(&product[..=degree]) {
                *total += part;
            }
        }
        sum
    }

    /// For each hit, an s where `f` is negative and one where it is positive, or twice the s where
    /// it is zero; ascending. None of a line that lies in the surface.
    fn brackets(&self, chord: &Chord) -> ArrayVec<[f64; 2], MAX_DEGREE> {
        let coefficients = self.along(chord);
        let slopes: [f64; MAX_DEGREE] =
            std::array::from_fn(|i| (i + 1) as f64 * coefficients[i + 1]);
        let stationary = roots_between(&slopes, -1.0, 1.0);
        let mut brackets = ArrayVec::new();
        // −1, 0 or 1: with a zero of its own sign, f and −f have the same roots
        let sign = |s: f64| {
            let value = self.values(chord.at(s)).value;
            if value == 0.0 { 0.0 } else { value.signum() }
        };
        let mut left = (-1.0, sign(-1.0));
        let mut in_surface = left.1 == 0.0;
        for s in stationary.into_iter().chain([1.0]) {
            let here = (s, sign(s));
            // the capacity suffices: there is at most one hit more than stationary points
            if left.1 == 0.0 && here.1 != 0.0 {
                let _ = brackets.try_push([left.0; 2]);
            } else if left.1 * here.1 < 0.0 {
                let bracket = if here.1 < 0.0 { [s, left.0] } else { [left.0, s] };
                let _ = brackets.try_push(bracket);
            }
            left = here;
            in_surface &= left.1 == 0.0;
        }
        if left.1 == 0.0 && !in_surface {
            let _ = brackets.try_push([left.0; 2]);
        }
        brackets
    }

    fn solve(&self, chord: &Chord, bracket: [f64; 2]) -> f64 {
        let f = |s: f64| {
            let Values { value, gradient, .. } = self.values(chord.at(s));
            [value, gradient.dot(chord.h)]
        };
        let tolerance = Tolerance { value: 0.0, step: UNIT_ROUNDOFF };
        bracketed_root(f, bracket, 0.5 * (bracket[0] + bracket[1]), tolerance)
    }

    /// The hits inside the span, ascending.
    fn hits(&self, ray: &Ray, span: Span) -> impl Iterator<Item = Candidate> {
        let chord = self.domain.chord(ray).and_then(|ends| Chord::new(ray, ends));
        let brackets = chord.as_ref().map(|chord| self.brackets(chord)).unwrap_or_default();
        brackets.into_iter().filter_map(move |bracket| {
            let chord = chord.as_ref()?;
            let [first, last] = [bracket[0].min(bracket[1]), bracket[0].max(bracket[1])];
            if chord.t(last) <= span.min || chord.t(first) >= span.max {
                return None;
            }
            let t = chord.t(self.solve(chord, bracket));
            span.contains(t).then(|| Candidate::at(t))
        })
    }
}

impl Shape for AlgebraicShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hits(ray, span).next()
    }

    /// One step of Newton's method along the gradient moves the point onto the surface, but not
    /// where the gradient is mere rounding, as where sheets meet.
    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let size = self.domain.min.to_vector().abs().max(self.domain.max.to_vector().abs());
        // half of the digits are all that a root has where the gradient vanishes
        let most = UNIT_ROUNDOFF.sqrt() * size.max_abs();
        // every term: a rounding for each factor, each of a coordinate that is some roundings off,
        // and one for each sum
        let roundings = (8 * self.degree + self.terms.len() + 8) as f64;
        let noise = |values: &Values| {
            roundings * UNIT_ROUNDOFF * values.magnitude / values.gradient.length()
        };
        let raw = ray.at(at.t);
        let there = self.values(raw.to_vector());
        let step = if noise(&there) < most {
            (there.value / there.gradient.length_squared()) * there.gradient
        } else {
            Vector::ZERO
        };
        let point = raw - step;
        let here = self.values(point.to_vector());
        let own = 12.0 * UNIT_ROUNDOFF * size.max_abs();
        let error = own
            + if noise(&here) < most {
                // a step leaves the more of a multiple root, at most `degree` times the next step
                let left = self.degree as f64 * here.value.abs() / here.gradient.length();
                noise(&here) + left
            } else {
                let far = ray.origin.to_vector().max_abs() + (at.t * ray.direction).max_abs();
                most + 8.0 * UNIT_ROUNDOFF * far
            };
        Surface::new(point, error, normal_along(here.gradient, ray))
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hits(ray, span).collect()
    }

    fn bounds(&self) -> Aabb {
        self.domain.bounds()
    }

    fn textbook(&self, epsilon: f64) -> Option<Arc<dyn Shape>> {
        textbook::form(self.clone(), self.clone(), epsilon)
    }
}
