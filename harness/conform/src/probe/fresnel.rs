//! How light divides at a boundary, and where it goes.

use serde::{Deserialize, Serialize};

use super::numbers::{Real, Triple, triple, unit};
use groundtruth::invalid::{Invalid, direction, index_ratio};
use groundtruth::lobes::{fresnel, polarised, refract};
use groundtruth::math::Vector;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fresnel {
    eta: f64,
    cos_i: Option<f64>,
    wo: Option<Vector>,
    n: Option<Vector>,
}

#[derive(Serialize)]
pub struct FresnelAnswer {
    reflected: Real,
    transmitted: Real,
    /// Of light polarised perpendicular to the plane of incidence (s), and in it (p).
    r_s: Real,
    r_p: Real,
    t_s: Real,
    t_p: Real,
    /// Left out if no directions were given, null on total internal reflection.
    #[serde(skip_serializing_if = "Option::is_none")]
    refracted: Option<Option<Triple>>,
}

impl super::Question for Fresnel {
    type Answer = FresnelAnswer;

    fn answer(&self) -> Result<FresnelAnswer, Invalid> {
        let eta = index_ratio("eta", self.eta)?;
        let (cos_i, refracted) = match (self.cos_i, self.wo, self.n) {
            (Some(cos_i), None, None) => {
                if !(0.0..=1.0).contains(&cos_i) {
                    let problem = format!("found {cos_i}, but a cosine from 0 to 1 is needed");
                    return Err(Invalid::field("cos_i", problem));
                }
                (cos_i, None)
            }
            (None, Some(wo), Some(n)) => {
                let (wo, n) = (unit("wo", wo)?, direction("n", n)?);
                let cos_i = n.dot(wo);
                if cos_i < 0.0 {
                    let problem = "is behind the surface; turn `n` around and ask with 1/eta";
                    return Err(Invalid::field("wo", problem));
                }
                (cos_i.min(1.0), Some(refract(wo, n, eta).map(triple)))
            }
            _ => return Err(Invalid::new("needs either `cos_i`, or `wo` and `n`")),
        };
        let (mean, each) = (fresnel(cos_i, eta), polarised(cos_i, eta));
        Ok(FresnelAnswer {
            reflected: Real(mean.reflected),
            transmitted: Real(mean.transmitted),
            r_s: Real(each.s.reflected),
            r_p: Real(each.p.reflected),
            t_s: Real(each.s.transmitted),
            t_p: Real(each.p.transmitted),
            refracted,
        })
    }
}
