//! What a BRDF or BTDF says.

use serde::{Deserialize, Serialize};

use super::numbers::{HALF_OPEN, Real, Triple, color, in_square, triple, unit};
use groundtruth::invalid::Invalid;
use groundtruth::lobes;
use groundtruth::math::Vector;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LobeQuestion {
    lobe: lobes::Lobe,
    wo: Vector,
    wi: Option<Vector>,
    u: Option<[f64; 2]>,
}

#[derive(Serialize)]
pub struct LobeAnswer {
    #[serde(skip_serializing_if = "Option::is_none")]
    f: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pdf: Option<Real>,
    albedo: Triple,
    /// Left out if it was not asked for, null where nothing is scattered.
    #[serde(skip_serializing_if = "Option::is_none")]
    sample: Option<Option<Sample>>,
}

#[derive(Serialize)]
struct Sample {
    wi: Triple,
    weight: Triple,
    pdf: Real,
}

impl super::Question for LobeQuestion {
    type Answer = LobeAnswer;

    fn answer(&self) -> Result<LobeAnswer, Invalid> {
        let lobe = &self.lobe;
        lobe.check().map_err(|e| e.inside("lobe"))?;
        let wo = unit("wo", self.wo)?;
        let wi = self.wi.map(|wi| unit("wi", wi)).transpose()?;
        let u = self.u.map(|u| in_square("u", u, HALF_OPEN)).transpose()?;
        Ok(LobeAnswer {
            f: wi.map(|wi| color(lobe.f(wo, wi))),
            pdf: wi.map(|wi| Real(lobe.pdf(wo, wi))),
            albedo: color(lobe.albedo(wo)),
            sample: u.map(|u| {
                lobe.sample(wo, u).map(|sample| Sample {
                    wi: triple(sample.wi),
                    weight: color(sample.weight),
                    pdf: Real(sample.pdf.unwrap_or(f64::INFINITY)),
                })
            }),
        })
    }
}
