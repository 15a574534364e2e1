//! A question as the oracle sees it, and its exact answer.

use ask::{number, triple};
use serde::Deserialize;
use serde_json::{Value, json};

use super::super::judgement::Profile;
use exact::backward_error;
use exact::oracle_shape;
use groundtruth::math::{Span, Step};
use groundtruth::shapes::{self, Instance};
use oracle::{Answer, Root};

/// A ray and a shape, for the library and for the oracle.
pub struct IntersectQuestion {
    pub kind: shapes::Kind,
    pub shape: oracle::Shape,
    pub ray: oracle::Ray,
    pub span: [f64; 2],
    pub all: bool,
}

impl IntersectQuestion {
    /// `None` if it is none, or about a shape that the oracle does not have.
    pub fn of(question: &Value) -> Option<Self> {
        let (name, data) = question.as_object()?.iter().next()?;
        let mut kind = shapes::Kind::deserialize(&data["shape"]).ok()?;
        if let Ok(steps) = Vec::<Step>::deserialize(&data["transform"]) {
            kind = Instance::new(kind, steps).into();
        }
        let end = |i: usize, other| data["span"].get(i).map_or(Some(other), number);
        let (ray, span) = if data.get("segment").is_some() {
            let [from, to] = ["from", "to"].map(|end| triple(&data["segment"][end]));
            let (from, to) = (from?, to?);
            let direction = std::array::from_fn(|i| to[i] - from[i]);
            (oracle::Ray { origin: from, direction }, [0.0, 1.0])
        } else {
            let [origin, direction] = ["origin", "direction"].map(|it| triple(&data["ray"][it]));
            let ray = oracle::Ray { origin: origin?, direction: direction? };
            (ray, [end(0, 0.0)?, end(1, f64::INFINITY)?])
        };
        let all = name == "intersect" && data["all"] == json!(true);
        Some(Self { shape: oracle_shape(&kind)?, kind, ray, span, all })
    }

    /// The exact roots in the span. From −∞ on, they are looked for from a point of the ray far behind the shape.
    pub fn answer(&self) -> Option<Answer> {
        let [min, max] = self.span;
        let start = if min.is_finite() { min } else { self.far_behind()? };
        let mut answer = oracle::intersect_beyond(&self.shape, &self.ray, start);
        // a root that rounding moves over the end
        let near_end = |root: &Root| max.is_finite() && (root.t - max).abs() <= 1e-9 * max.abs();
        if answer.roots.iter().any(near_end) {
            answer.margin = 0.0;
        }
        answer.roots.retain(|root| root.t < max);
        Some(answer)
    }

    /// A parameter of the line before all of its hits.
    fn far_behind(&self) -> Option<f64> {
        let built = self.kind.build(&mut shapes::Context::default()).ok()?;
        let roots = built.roots(&backward_error::ray(&self.ray), Span::LINE);
        let first = roots.first().map_or(0.0, |root| root.t);
        Some(first.min(0.0) * 2.0 - 1.0)
    }

    /// Whether no small change of the question changes the answer.
    pub fn is_decided(&self, answer: &Answer, profile: Profile) -> bool {
        answer.margin > profile.margin() * self.shape.condition()
    }
}
