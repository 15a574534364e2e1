//! Shared by the chapters' laws: how cases are generated.

use crate::properties::*;
use groundtruth::cameras::{View, ViewPlane};
use groundtruth::math::{Normal, Point, Ray, Vector};
use groundtruth::render;
use groundtruth::textures::Amount;
use groundtruth::world::World;
use proptest::test_runner::{FileFailurePersistence, RngSeed};
use serde::Serialize;
use serde::de::DeserializeOwned;
use toml::Value;

/// Half the distance from 1 to the next number: the largest relative error of one rounding.
pub const U: f64 = f64::EPSILON / 2.0;

/// A film for views whose rays do not depend on its size.
pub const ANY_FILM: ViewPlane = ViewPlane { width: 1.0, height: 1.0 };

/// The ray of a film point, through the centre of the lens, of a camera that sees all its film.
pub trait Seen {
    /// That ray of a point of the film.
    fn seen(&self, film: [f64; 2]) -> Ray;
}

impl Seen for View {
    fn seen(&self, film: [f64; 2]) -> Ray {
        self.eyes()[0].ray(film, [0.0; 2]).expect("the camera sees all its film")
    }
}

/// The camera's ray of a sample, and its point on the film.
pub fn camera_ray(world: &World, pixel: [u32; 2], index: u32) -> (Ray, [f64; 2]) {
    let sample = render::camera_sample(world, pixel, index).expect("the picture has no gap");
    (sample.ray.expect("the camera sees all its film"), sample.film)
}

/// How laws are tested: with the same cases every time, and first those that failed before. The environment
/// variable `LAWS_SEED` selects other cases, and `LAWS_CASES` their number.
pub fn laws() -> ProptestConfig {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    ProptestConfig {
        cases: number("LAWS_CASES").unwrap_or(512) as u32,
        rng_seed: RngSeed::Fixed(number("LAWS_SEED").unwrap_or(2007)),
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::default()
    }
}

/// Directions all over the sphere, among them the axes and those within rounding of them.
pub fn unit() -> impl Strategy<Value = Normal> {
    let component = || prop_oneof![6 => -1.0..1.0_f64, 1 => Just(0.0), 1 => -1e-12..1e-12_f64];
    (component(), component(), component())
        .prop_filter_map("not zero", |(x, y, z)| Normal::new(Vector::new(x, y, z)))
}

/// Points within `reach` of the origin on each axis.
pub fn point(reach: f64) -> impl Strategy<Value = Point> {
    let c = move || -reach..reach;
    (c(), c(), c()).prop_map(|(x, y, z)| Point::new(x, y, z))
}

/// The value of an amount that is a plain number, not a texture.
pub fn number(amount: &Amount) -> f64 {
    let Amount::Plain(value) = amount else { panic!("{amount:?} is no plain number") };
    *value
}

/// The same kind with another value of a field; `None` if it has no such field.
pub fn with_field<Kind, Field>(kind: &Kind, field: &str, value: Field) -> Option<Kind>
where
    Kind: Serialize + DeserializeOwned,
    Value: From<Field>,
{
    let mut data = Value::try_from(kind).expect("it is plain data");
    let (_, fields) = data.as_table_mut()?.iter_mut().next()?;
    fields.as_table_mut()?.insert(field.to_owned(), value.into());
    data.try_into().ok()
}
