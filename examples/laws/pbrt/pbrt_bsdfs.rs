//! The BSDFs of rs_pbrt (pbrt-v3 in Rust, in single precision) answer `groundtruth laws`.
//!
//! All numbers are those of `Bsdf::f`, `pdf` and `sample_f`. A lobe is a `Bsdf` of one or two `Bxdf`s, as the package's
//! materials make them; the weight of a sample is their f |cos θ| / pdf.
//!
//! Build: `cargo build --release --manifest-path examples/laws/pbrt/Cargo.toml`
//!
//! Run: `groundtruth laws -- examples/laws/pbrt/target/release/pbrt_bsdfs`

use std::io::{self, BufRead, Write};

use rs_pbrt::core::geometry::{Normal3f, Point2f, Vector3f};
use rs_pbrt::core::material::TransportMode;
use rs_pbrt::core::microfacet::{
    BeckmannDistribution, MicrofacetDistribution, TrowbridgeReitzDistribution,
};
use rs_pbrt::core::pbrt::Spectrum;
use rs_pbrt::core::reflection::{
    Bsdf, Bxdf, DisneyFresnel, Fresnel, FresnelBlend, FresnelConductor, FresnelDielectric,
    FresnelNoOp, FresnelSpecular, LambertianReflection, LambertianTransmission,
    MicrofacetReflection, MicrofacetTransmission, OrenNayar, SpecularReflection,
};
use rs_pbrt::materials::disney::{
    DisneyClearCoat, DisneyDiffuse, DisneyFakeSS, DisneyMicrofacetDistribution, DisneyRetro,
    DisneySheen,
};
use serde_json::{Value, json};

/// Every kind of `Bxdf`.
const ALL: u8 = 31;
/// The kind of a single direction.
const SPECULAR: u8 = 16;

fn listed() -> Value {
    let color = json!([0.1, 1.0]);
    let alpha = json!([0.001, 1.0]);
    let index = json!([1.1, 2.4]);
    let facets = |rest: Value| {
        let mut all = json!({"distribution": {"one_of": ["ggx", "beckmann"]}, "visible": {"one_of": [true, false]}});
        rest.as_object().into_iter().flatten().for_each(|(key, value)| all[key] = value.clone());
        all
    };
    let reflects = |from_below: bool| json!({"float": true, "reciprocal": true, "isotropic": true, "from_below": from_below});
    let with = |claims: &[(&str, Value)]| {
        let mut all = reflects(true);
        claims.iter().for_each(|(key, value)| all[*key] = value.clone());
        all
    };
    let lobe = |name: &str, parameters: Value, claims: Value| json!({"name": name, "parameters": parameters, "claims": claims});
    let sided = |sides: &str| with(&[("sides", sides.into())]);
    let glass = |sides: &str| with(&[("sides", sides.into()), ("eta", "eta".into())]);
    json!([
        lobe("lambertian", json!({"r": color}), reflects(true)),
        lobe("lambertian_transmission", json!({"r": color}), sided("transmits")),
        lobe("oren_nayar", json!({"r": color, "sigma": [0.0, 90.0]}), reflects(true)),
        lobe("specular_reflection", json!({}), with(&[("delta", true.into()), ("lossless", true.into())])),
        lobe(
            "fresnel_specular",
            json!({"eta": index}),
            with(&[("delta", true.into()), ("lossless", true.into()), ("sides", "both".into()), ("eta", "eta".into())])
        ),
        lobe(
            "microfacet_reflection",
            facets(json!({"alpha_x": alpha, "alpha_y": alpha})),
            with(&[("isotropic", false.into())])
        ),
        lobe("microfacet_conductor", facets(json!({"alpha": alpha})), reflects(true)),
        lobe("microfacet_transmission", facets(json!({"alpha": alpha, "eta": index})), glass("transmits")),
        lobe("rough_glass", facets(json!({"alpha": alpha, "eta": index})), glass("both")),
        // beside a coat of 0.25, the base may have what is left of 1
        lobe("plastic", json!({"r": [0.1, 0.75], "alpha": alpha}), reflects(true)),
        lobe("fresnel_blend", facets(json!({"r": color, "rs": [0.02, 1.0], "alpha": alpha})), reflects(true)),
        lobe("disney_diffuse", json!({"r": color}), reflects(true)),
        lobe("disney_fake_ss", json!({"r": color, "roughness": [0.0, 1.0]}), reflects(true)),
        lobe("disney_retro", json!({"r": color, "roughness": [0.1, 1.0]}), reflects(true)),
        lobe("disney_sheen", json!({"r": color}), reflects(true)),
        lobe("disney_clear_coat", json!({"gloss": [0.001, 0.1]}), reflects(true)),
        lobe(
            "disney_microfacet",
            json!({"r": color, "alpha": alpha, "metallic": [0.0, 1.0], "eta": index}),
            reflects(true)
        ),
    ])
}

fn made(name: &str, p: &Value) -> Option<Bsdf> {
    let number = |key: &str| p[key].as_f64().map(|x| x as f32);
    let color = |key: &str| number(key).map(Spectrum::new);
    let ggx = |x: f32, y: f32, visible: bool| {
        MicrofacetDistribution::TrowbridgeReitz(TrowbridgeReitzDistribution::new(x, y, visible))
    };
    let facets = |x: f32, y: f32| {
        let visible = p["visible"].as_bool()?;
        Some(match p["distribution"].as_str()? {
            "ggx" => ggx(x, y, visible),
            _ => MicrofacetDistribution::Beckmann(BeckmannDistribution::new(x, y, visible)),
        })
    };
    let of_facets = |fresnel: Fresnel, distribution: MicrofacetDistribution, r: Spectrum| {
        Bxdf::MicrofacetRefl(MicrofacetReflection::new(r, distribution, fresnel, None))
    };
    let dielectric =
        |eta_i: f32, eta_t: f32| Fresnel::Dielectric(FresnelDielectric { eta_i, eta_t });
    let transmission = |distribution: MicrofacetDistribution, eta: f32| {
        let (white, mode) = (Spectrum::new(1.0), TransportMode::Radiance);
        let made = MicrofacetTransmission::new(white, distribution, 1.0, eta, mode, None);
        Bxdf::MicrofacetTrans(made)
    };
    let (white, no_op) = (Spectrum::new(1.0), Fresnel::NoOp(FresnelNoOp {}));
    let bxdfs = match name {
        "lambertian" => {
            vec![Bxdf::LambertianRefl(LambertianReflection::new(color("r")?, None))]
        }
        "lambertian_transmission" => {
            vec![Bxdf::LambertianTrans(LambertianTransmission::new(color("r")?, None))]
        }
        "oren_nayar" => {
            vec![Bxdf::OrenNayarRefl(OrenNayar::new(color("r")?, number("sigma")?, None))]
        }
        "specular_reflection" => {
            vec![Bxdf::SpecRefl(SpecularReflection::new(white, no_op, None))]
        }
        "fresnel_specular" => {
            let (eta, mode) = (number("eta")?, TransportMode::Radiance);
            vec![Bxdf::FresnelSpec(FresnelSpecular::new(white, white, 1.0, eta, mode, None))]
        }
        "microfacet_reflection" => {
            vec![of_facets(no_op, facets(number("alpha_x")?, number("alpha_y")?)?, white)]
        }
        "microfacet_conductor" => {
            let copper = Fresnel::Conductor(FresnelConductor {
                eta_i: white,
                eta_t: Spectrum::rgb(0.2, 0.92, 1.1),
                k: Spectrum::rgb(3.9, 2.45, 2.14),
            });
            vec![of_facets(copper, facets(number("alpha")?, number("alpha")?)?, white)]
        }
        "microfacet_transmission" => {
            vec![transmission(facets(number("alpha")?, number("alpha")?)?, number("eta")?)]
        }
        // as materials/glass.rs
        "rough_glass" => {
            let (distribution, eta) =
                (facets(number("alpha")?, number("alpha")?)?, number("eta")?);
            let fresnel = dielectric(1.0, eta);
            vec![of_facets(fresnel, distribution, white), transmission(distribution, eta)]
        }
        // as materials/plastic.rs, whose colours are 0.25 each unless a scene says otherwise
        "plastic" => {
            let alpha = number("alpha")?;
            let coat = of_facets(dielectric(1.5, 1.0), ggx(alpha, alpha, true), Spectrum::new(0.25));
            vec![Bxdf::LambertianRefl(LambertianReflection::new(color("r")?, None)), coat]
        }
        "fresnel_blend" => {
            let distribution = facets(number("alpha")?, number("alpha")?)?;
            let made = FresnelBlend::new(color("r")?, color("rs")?, Some(distribution), None);
            vec![Bxdf::FresnelBlnd(made)]
        }
        "disney_diffuse" => vec![Bxdf::DisDiff(DisneyDiffuse::new(color("r")?, None))],
        "disney_fake_ss" => {
            vec![Bxdf::DisSS(DisneyFakeSS::new(color("r")?, number("roughness")?, None))]
        }
        "disney_retro" => {
            vec![Bxdf::DisRetro(DisneyRetro::new(color("r")?, number("roughness")?, None))]
        }
        "disney_sheen" => vec![Bxdf::DisSheen(DisneySheen::new(color("r")?, None))],
        "disney_clear_coat" => {
            vec![Bxdf::DisClearCoat(DisneyClearCoat::new(1.0, number("gloss")?, None))]
        }
        "disney_microfacet" => {
            let alpha = number("alpha")?;
            let inner = DisneyMicrofacetDistribution::new(alpha, alpha);
            let fresnel = DisneyFresnel::new(color("r")?, number("metallic")?, number("eta")?);
            let distribution = MicrofacetDistribution::DisneyMicrofacet(inner);
            vec![of_facets(Fresnel::Disney(fresnel), distribution, white)]
        }
        _ => return None,
    };
    let (n, axis) = (Normal3f { x: 0.0, y: 0.0, z: 1.0 }, |x, y| Vector3f { x, y, z: 0.0 });
    Some(Bsdf { eta: 1.0, ns: n, ng: n, ss: axis(1.0, 0.0), ts: axis(0.0, 1.0), bxdfs })
}

fn vector(value: &Value) -> Option<Vector3f> {
    let at = |i: usize| value[i].as_f64().map(|x| x as f32);
    Some(Vector3f { x: at(0)?, y: at(1)?, z: at(2)? })
}

/// A number as the protocol writes it.
fn shown(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { json!(x.to_string()) }
}

fn evaluated(bsdf: &Bsdf, wo: &Vector3f, wi: &[Value]) -> Option<Value> {
    let (mut f, mut pdf) = (Vec::new(), Vec::new());
    for wi in wi {
        let wi = vector(wi)?;
        f.push(bsdf.f(wo, &wi, ALL).c.map(|x| shown(x.into())));
        pdf.push(shown(bsdf.pdf(wo, &wi, ALL).into()));
    }
    Some(json!({"f": f, "pdf": pdf}))
}

fn sampled(bsdf: &Bsdf, wo: &Vector3f, u: &Value) -> Option<Value> {
    let u = Point2f { x: u[0].as_f64()? as f32, y: u[1].as_f64()? as f32 };
    // it is written only if it is not 0
    let (mut wi, mut pdf, mut kind) = (Vector3f::default(), 0.0, u8::MAX);
    let f = bsdf.sample_f(wo, &mut wi, &u, &mut pdf, ALL, &mut kind);
    let is_single = kind & SPECULAR != 0;
    // f = 0 is how the integrators are told that there is no sample; it is one where `pdf` knows of it
    if pdf == 0.0 || f.is_black() && (is_single || bsdf.pdf(wo, &wi, ALL) == 0.0) {
        return Some(Value::Null);
    }
    let weight = f.c.map(|f| shown(f64::from(f) * f64::from(wi.z.abs()) / f64::from(pdf)));
    let wi = [wi.x, wi.y, wi.z].map(|x| shown(x.into()));
    let pdf = if is_single { Value::Null } else { shown(pdf.into()) };
    Some(json!({"wi": wi, "weight": weight, "pdf": pdf}))
}

/// The answer; `None` if the question lacks something.
fn answer(question: &Value) -> Option<Value> {
    if question.get("list").is_some() {
        return Some(listed());
    }
    let is_eval = question.get("eval").is_some();
    let data = &question[if is_eval { "eval" } else { "sample" }];
    let bsdf = made(data["lobe"].as_str()?, &data["parameters"])?;
    let wo = vector(&data["wo"])?;
    match is_eval {
        true => evaluated(&bsdf, &wo, data["wi"].as_array()?),
        false => data["u"].as_array()?.iter().map(|u| sampled(&bsdf, &wo, u)).collect(),
    }
}

fn main() -> io::Result<()> {
    let mut output = io::stdout();
    for line in io::stdin().lock().lines() {
        let question: Value = serde_json::from_str(&line?)?;
        let id = &question["id"];
        let reply = match answer(&question) {
            Some(answer) => json!({"id": id, "answer": answer}),
            None => json!({"id": id, "error": "the question lacks something"}),
        };
        writeln!(output, "{reply}")?;
        output.flush()?;
    }
    Ok(())
}
