//! Lobes: BRDFs and BTDFs, pure functions of directions (Suffern, ch. 13–15, 24, 27, 28).
//!
//! Directions are unit, in a local frame whose z axis is the surface's stored normal, and point
//! away from the surface: `wo` to where the light goes, `wi` to where it comes from. A negative z
//! is the inner side. A material builds the lobes of a hit once, on the stack; lobes never trace.

mod fresnel_reflector;
mod fresnel_transmitter;
mod glossy_reflection;
mod glossy_specular;
mod lambertian;
mod perfect_specular;
mod perfect_transmitter;

// shared by the kinds
mod bsdf;
mod cosine_power;
mod fresnel;
mod refract;

use arrayvec::ArrayVec;

use crate::invalid::Invalid;
use crate::math::{Normal, Vector};
use crate::rgb::Rgb;

pub use bsdf::{Bsdf, BsdfSample, Lit, LobeSet, Normals};
pub(crate) use cosine_power::check_exponent;
pub use fresnel::{Fresnel, Polarised, fresnel, polarised};
pub use glossy_reflection::GlossyRule;
pub use refract::refract;

/// A direction drawn by a lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeSample {
    /// Where light is to be looked for.
    pub wi: Vector,
    /// What the light from there counts: `f |cos θ_i| / pdf`.
    pub weight: Rgb,
    /// Per steradian; `None` for the single direction of a mirror or a refraction.
    pub pdf: Option<f64>,
}

/// What a lobe promises; the contract suite proves each promise, and for the book's lobes that do
/// not keep one, proves the break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claims {
    /// `f(wi, wo) = f(wo, wi)`.
    pub reciprocal: bool,
    /// No more light leaves than arrives, for coefficients of at most 1; of refracted light that is
    /// said of the basic radiance `L/η²`, as radiance itself changes with the medium.
    pub conserves_energy: bool,
}

/// The branch by which a path continues at a hit. A branch keeps its number when others are
/// switched off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Branch {
    /// Scattered evenly.
    Diffuse = 1,
    /// Scattered about the mirror direction, as a highlight.
    Highlight = 2,
    /// Mirrored.
    Mirror = 3,
    /// Mirrored, blurred.
    Gloss = 4,
    /// Refracted.
    Refraction = 5,
}

/// What a kind of lobe answers.
trait Scattering {
    /// The name of the paths it sends on; it also says whether light samples meet the lobe.
    const BRANCH: Branch;

    /// See [`Lobe::claims`].
    fn claims(&self) -> Claims;

    /// Whether its data fit.
    fn check(&self) -> Result<(), Invalid>;

    /// The book's formula for `f`, for light from outside (`wi.z() > 0`), whatever side the viewer
    /// is on. Black for lobes of a single direction.
    fn formula(&self, _wo: Vector, _wi: Vector) -> Rgb {
        Rgb::BLACK
    }

    /// The density of `sample` at `wi`, per steradian, for viewer and light outside; 0 for lobes of
    /// a single direction.
    fn density(&self, _wo: Vector, _wi: Vector) -> f64 {
        0.0
    }

    /// See [`Lobe::selection_weight`].
    fn selection_weight(&self, wo: Vector) -> f64;

    /// See [`Lobe::sample`].
    fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample>;

    /// See [`Lobe::albedo`].
    fn albedo(&self, wo: Vector) -> Rgb;

    /// For lobes that refract: the index of refraction inside over the one outside.
    fn eta(&self) -> Option<f64> {
        None
    }

    /// Examples, each valid.
    fn specimens() -> Vec<Self>
    where
        Self: Sized;
}

macro_rules! lobes {
    ($($chapter:ident $module:ident::$Lobe:ident $name:literal),* $(,)?) => {
        $(pub use $module::$Lobe;)*

        /// One of the ways in which a surface scatters light.
        #[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Lobe {
            $(#[doc = concat!("See [`", stringify!($Lobe), "`].")] $Lobe($Lobe),)*
        }

        $(impl From<$Lobe> for Lobe {
            fn from(lobe: $Lobe) -> Self {
                Self::$Lobe(lobe)
            }
        })*

        impl Lobe {
            /// Chapter, file and examples of every lobe.
            pub const ENTRIES: &'static [crate::kinds::Entry<Self>] = &[$(crate::kinds::Entry {
                chapter: stringify!($chapter),
                module: stringify!($module),
                specimens: || $Lobe::specimens().into_iter().map(Self::from).collect(),
                formula: "", // its material has one
            }),*];

            /// Whether its data fit: nothing else checks a lobe that no material made.
            ///
            /// # Errors
            /// [`Invalid`] names the field that does not fit.
            pub fn check(&self) -> Result<(), Invalid> {
                match self {
                    $(Self::$Lobe(lobe) => lobe.check().map_err(|e| {
                        e.inside($crate::kinds::tag(stringify!($Lobe)).as_str())
                    })),*
                }
            }

            /// The book's name, in words.
            pub fn name(&self) -> &'static str {
                match self { $(Self::$Lobe(_) => $name),* }
            }

            /// The book's formula for [`Lobe::f`], which does not ask on which side the viewer is.
            fn formula(&self, wo: Vector, wi: Vector) -> Rgb {
                match self { $(Self::$Lobe(lobe) => lobe.formula(wo, wi)),* }
            }

            fn density(&self, wo: Vector, wi: Vector) -> f64 {
                match self { $(Self::$Lobe(lobe) => lobe.density(wo, wi)),* }
            }

            /// How often a path takes this lobe, in proportion to the others: about the share of
            /// light that it sends on, cheaply, and not 0 where it sends any.
            pub fn selection_weight(&self, wo: Vector) -> f64 {
                match self { $(Self::$Lobe(lobe) => lobe.selection_weight(wo)),* }
            }

            /// A direction for two numbers in `[0, 1)`; `None` where nothing is scattered.
            pub fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
                match self { $(Self::$Lobe(lobe) => lobe.sample(wo, u)),* }
            }

            /// The share of uniform light that is sent to `wo`, `∫ f |cos θ_i| dω_i`.
            pub fn albedo(&self, wo: Vector) -> Rgb {
                match self { $(Self::$Lobe(lobe) => lobe.albedo(wo)),* }
            }

            fn eta(&self) -> Option<f64> {
                match self { $(Self::$Lobe(lobe) => lobe.eta()),* }
            }

            /// The name of the paths that it sends on.
            pub fn branch(&self) -> Branch {
                match self { $(Self::$Lobe(_) => $Lobe::BRANCH),* }
            }

            /// The chapter that brings it, as `ch13`, and the file it lives in, without `.rs`.
            pub fn place(&self) -> [&'static str; 2] {
                match self { $(Self::$Lobe(_) => [stringify!($chapter), stringify!($module)]),* }
            }

            /// What it promises.
            pub fn claims(&self) -> Claims {
                match self { $(Self::$Lobe(lobe) => lobe.claims()),* }
            }
        }
    };
}

impl Lobe {
    /// Radiance towards `wo` for irradiance from `wi`, per steradian; black unless both are
    /// outside, and for lobes of a single direction.
    pub fn f(&self, wo: Vector, wi: Vector) -> Rgb {
        if outside(wo, wi) { self.formula(wo, wi) } else { Rgb::BLACK }
    }

    /// The density of [`Lobe::sample`] at `wi`, per steradian; 0 unless both directions are
    /// outside, and for lobes of a single direction.
    pub fn pdf(&self, wo: Vector, wi: Vector) -> f64 {
        if outside(wo, wi) { self.density(wo, wi) } else { 0.0 }
    }

    /// Whether light comes from a single direction, which only a ray can find.
    pub fn is_specular(&self) -> bool {
        matches!(self.branch(), Branch::Mirror | Branch::Refraction)
    }

    /// Whether ray casting and Whitted's tracer let lights' samples meet it; for the others they
    /// trace rays.
    pub fn is_lit(&self) -> bool {
        matches!(self.branch(), Branch::Diffuse | Branch::Highlight)
    }

    /// Whether its light comes from the other side of the surface.
    pub fn refracts(&self) -> bool {
        self.eta().is_some()
    }

    /// For lobes that refract: the index of refraction behind the surface over the one in front of
    /// it, as seen from `wo`.
    pub fn relative_eta(&self, wo: Vector) -> Option<f64> {
        self.eta().map(|eta| relative(eta, wo))
    }
}

lobes! {
    ch13 lambertian::Lambertian "Lambertian",
    ch15 glossy_specular::GlossySpecular "glossy specular",
    ch24 perfect_specular::PerfectSpecular "perfect specular",
    ch25 glossy_reflection::GlossyReflection "glossy reflection",
    ch27 perfect_transmitter::PerfectTransmitter "perfect transmitter",
    ch28 fresnel_reflector::FresnelReflector "Fresnel reflector",
    ch28 fresnel_transmitter::FresnelTransmitter "Fresnel transmitter",
}

/// Which normal the z axis of a lobe's frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalKind {
    /// The interpolated normal of a smooth mesh.
    Shading,
    /// The true normal: sides and refraction must not be fooled by interpolation.
    Geometry,
}

/// The most lobes of a material; one more panics.
pub const MAX_LOBES: usize = 4;

/// The lobes of one hit.
pub type Lobes = ArrayVec<(Lobe, NormalKind), MAX_LOBES>;

/// Whether both directions are on the outer side.
fn outside(wo: Vector, wi: Vector) -> bool {
    wo.z() > 0.0 && wi.z() > 0.0
}

/// The sample of a lobe that drew this direction; `None` unless viewer and light are outside.
fn drawn(lobe: &impl Scattering, wo: Vector, wi: Vector) -> Option<LobeSample> {
    if !outside(wo, wi) {
        return None;
    }
    let pdf = lobe.density(wo, wi);
    let weight = (wi.z() / pdf) * lobe.formula(wo, wi);
    (pdf > 0.0).then_some(LobeSample { wi, weight, pdf: Some(pdf) })
}

/// The index behind the surface over the one in front of it, for a viewer in direction `wo`.
fn relative(eta: f64, wo: Vector) -> f64 {
    if wo.z() < 0.0 { 1.0 / eta } else { eta }
}

/// The normal of the local frame on the side of `w`.
fn normal_towards(w: Vector) -> Normal {
    if w.z() < 0.0 { -Normal::Z } else { Normal::Z }
}

/// The mirror image of `w` about the local normal.
fn mirrored(w: Vector) -> Vector {
    Vector::new(-w.x(), -w.y(), w.z())
}
