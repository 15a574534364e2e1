//! Lobes as people write them, in single and in double precision, each with the mistakes that people make.
//!
//! They are written after the papers and not after the library: a second derivation. Directions are in the local frame;
//! `is("…")` says which mistake is made.

mod microfacets;

use microfacets::microfacets;

/// Written twice by one macro: for `f32` and `f64`.
macro_rules! scattering {
    ($module:ident, $F:ident) => {
        #[allow(clippy::disallowed_methods)] // as people write it: the standard library's functions
        pub mod $module {
            use std::$F::consts::PI;

            use super::microfacets;

            pub type V = [$F; 3];
            pub type Drawn = Option<(V, [$F; 3], Option<$F>)>;

            /// A lobe with its parameters, and the mistake that it has (none: empty).
            #[derive(Clone, Debug)]
            pub struct Lobe {
                pub name: String,
                pub roughness: [$F; 2],
                pub eta: $F,
                pub mistake: &'static str,
            }

            pub fn dot(a: V, b: V) -> $F {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            fn scaled(a: V, by: $F) -> V {
                a.map(|x| x * by)
            }

            fn sum(a: V, b: V) -> V {
                [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
            }

            fn cross(a: V, b: V) -> V {
                let of = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
                [of(1, 2), of(2, 0), of(0, 1)]
            }

            pub fn unit(a: V) -> V {
                let length = dot(a, a).sqrt();
                if length > 0.0 { scaled(a, 1.0 / length) } else { [0.0, 0.0, 1.0] }
            }

            fn below(a: V) -> V {
                [a[0], a[1], -a[2]]
            }

            /// Fresnel's equations between dielectrics, for η of the far side over the near one.
            pub fn fresnel(cosine: $F, eta: $F) -> $F {
                let sine2 = (1.0 - cosine * cosine).max(0.0) / (eta * eta);
                if sine2 >= 1.0 {
                    return 1.0;
                }
                let far = (1.0 - sine2).sqrt();
                let s = (cosine - eta * far) / (cosine + eta * far);
                let p = (eta * cosine - far) / (eta * cosine + far);
                0.5 * (s * s + p * p)
            }

            microfacets!($F);

            impl Lobe {
                fn is(&self, mistake: &str) -> bool {
                    self.mistake == mistake
                }

                /// f and pdf.
                pub fn eval(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                    match &*self.name {
                        "lambert" => self.lambert(wo, wi),
                        "oren_nayar" => self.oren_nayar(wo, wi),
                        "conductor" => self.conductor(wo, wi),
                        "rough_dielectric" => self.dielectric(wo, wi),
                        "layered" => self.layered(wo, wi),
                        _ => ([0.0; 3], 0.0),
                    }
                }

                /// A direction, its weight and its pdf.
                pub fn sample(&self, wo: V, u: [$F; 4]) -> Drawn {
                    match &*self.name {
                        "lambert" | "oren_nayar" => self.sample_cosine(wo, u),
                        "conductor" => self.sample_conductor(wo, u),
                        "rough_dielectric" => self.sample_dielectric(wo, u),
                        "layered" => self.sample_layered(wo, u),
                        "mirror" => self.sample_mirror(wo, u),
                        _ => self.sample_glass(wo, u),
                    }
                }

                // ── diffuse ──

                fn lambert(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                    if wo[2] * wi[2] <= 0.0 && !self.is("lit from behind") {
                        return ([0.0; 3], 0.0);
                    }
                    let cosine = wi[2].abs();
                    let f = if self.is("no 1/pi in f") { 0.8 } else { 0.8 / PI };
                    let pdf = if self.is("no 1/pi in pdf") { cosine } else { cosine / PI };
                    ([f, 0.5 * f, f], pdf)
                }

                /// Oren and Nayar 1994, the qualitative model.
                fn oren_nayar(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                    if wo[2] * wi[2] <= 0.0 {
                        return ([0.0; 3], 0.0);
                    }
                    let sigma2 = self.roughness[0] * self.roughness[0];
                    let a = 1.0 - 0.5 * sigma2 / (sigma2 + 0.33);
                    let b = 0.45 * sigma2 / (sigma2 + 0.09);
                    let [ci, co] = [wi[2].abs(), wo[2].abs()];
                    let [si, so] = [ci, co].map(|c: $F| (1.0 - c * c).max(0.0).sqrt());
                    let mut turn = if si * so > 0.0 {
                        (wi[0] * wo[0] + wi[1] * wo[1]) / (si * so)
                    } else {
                        0.0
                    };
                    if self.is("azimuth from a fixed axis") {
                        turn = if si > 0.0 { wi[0] / si } else { 0.0 };
                    }
                    if !self.is("azimuth not clamped") {
                        turn = turn.max(0.0);
                    }
                    // the sine of the larger angle, the tangent of the smaller
                    let (mut sine, mut tangent) =
                        if ci < co { (si, so / co) } else { (so, si / ci) };
                    if self.is("angles of viewer and light") {
                        (sine, tangent) = (so, si / ci);
                    }
                    let f = 0.7 / PI * (a + b * turn * sine * tangent);
                    ([f; 3], ci / PI)
                }

                fn sample_cosine(&self, wo: V, u: [$F; 4]) -> Drawn {
                    let radius = if self.is("radius without root") { u[0] } else { u[0].sqrt() };
                    let phi = 2.0 * PI * u[1];
                    let (x, y) = (radius * phi.cos(), radius * phi.sin());
                    let mut z = (1.0 - radius * radius).max(0.0).sqrt();
                    let mut wi = [x, y, z];
                    if self.is("uniform hemisphere")
                        || self.is("few of them uniform") && u[2] < 0.055
                    {
                        z = u[0];
                        let r = (1.0 - z * z).max(0.0).sqrt();
                        wi = [r * phi.cos(), r * phi.sin(), z];
                    }
                    if self.is("not unit") {
                        wi = [x, y, 1.0];
                    }
                    if wo[2] < 0.0 && !self.is("always above") {
                        wi = below(wi);
                    }
                    let (f, mut pdf) = self.eval(wo, wi);
                    if pdf <= 0.0 {
                        return None;
                    }
                    let mut cosine = wi[2].abs();
                    if self.is("cosine twice") {
                        cosine *= cosine;
                    }
                    if self.is("no cosine") {
                        cosine = 1.0;
                    }
                    if self.is("pi in weight") {
                        cosine *= PI;
                    }
                    let weight = f.map(|f| f * cosine / pdf);
                    if self.is("pdf in degrees of area") {
                        pdf *= 2.0;
                    }
                    Some((wi, weight, Some(pdf)))
                }

                // ── a rough coat over a diffuse base ──

                fn choice(&self, wo: V) -> $F {
                    (0.2 + 0.6 * fresnel(wo[2].abs(), self.eta)).min(0.9)
                }

                fn base(&self, wo: V, wi: V) -> $F {
                    if self.is("base not dimmed by the coat") {
                        return 1.0 / PI;
                    }
                    let through = |w: V| 1.0 - fresnel(w[2].abs(), self.eta);
                    through(wo) * through(wi) / PI
                }

                fn coat(&self, wo: V, wi: V) -> ($F, $F) {
                    let h = unit(sum(wo, wi));
                    let co = dot(wo, h);
                    let f =
                        self.d(h) * self.g2(wo, wi) * fresnel(co, self.eta) / (4.0 * wo[2] * wi[2]);
                    (f, self.visible(wo, h) / (4.0 * co))
                }

                fn layered(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                    if wo[2] <= 0.0 || wi[2] <= 0.0 {
                        return ([0.0; 3], 0.0);
                    }
                    let (coat, visible) = self.coat(wo, wi);
                    let f = coat + self.base(wo, wi);
                    let (p, cosine) = (self.choice(wo), wi[2] / PI);
                    let pdf = if self.is("pdfs added without probabilities") {
                        visible + cosine
                    } else if self.is("half and half in the pdf") {
                        0.5 * visible + 0.5 * cosine
                    } else {
                        p * visible + (1.0 - p) * cosine
                    };
                    ([f; 3], pdf)
                }

                fn sample_layered(&self, wo: V, u: [$F; 4]) -> Drawn {
                    if wo[2] <= 0.0 {
                        return None;
                    }
                    let p = self.choice(wo);
                    let chosen = if self.is("number used twice") { u[0] } else { u[2] };
                    let is_coat = chosen < p;
                    let wi = if is_coat {
                        let h = self.sample_visible(wo, [u[0], u[1]]);
                        sum(scaled(h, 2.0 * dot(wo, h)), scaled(wo, -1.0))
                    } else {
                        let (r, phi) = (u[0].sqrt(), 2.0 * PI * u[1]);
                        [r * phi.cos(), r * phi.sin(), (1.0 - u[0]).max(0.0).sqrt()]
                    };
                    if wi[2] <= 0.0 {
                        return None;
                    }
                    let (mut f, mut pdf) = self.eval(wo, wi);
                    if pdf <= 0.0 {
                        return None;
                    }
                    let (coat, visible) = self.coat(wo, wi);
                    if self.is("value of the chosen alone") {
                        f = [if is_coat { coat } else { self.base(wo, wi) }; 3];
                    }
                    let weight = f.map(|f| f * wi[2] / pdf);
                    if self.is("pdf of the chosen alone") {
                        pdf = if is_coat { visible } else { wi[2] / PI };
                    }
                    Some((wi, weight, Some(pdf)))
                }

                // ── single directions ──

                fn sample_mirror(&self, wo: V, _: [$F; 4]) -> Drawn {
                    let mut weight = [0.9; 3];
                    if self.is("mirror over cosine") {
                        weight = weight.map(|w: $F| w / wo[2].abs());
                    }
                    let mut wi = [-wo[0], -wo[1], wo[2]];
                    if self.is("mirrored through the surface") {
                        wi = scaled(wo, -1.0);
                    }
                    Some((wi, weight, None))
                }

                fn sample_glass(&self, wo: V, u: [$F; 4]) -> Drawn {
                    let eta = if wo[2] < 0.0 { 1.0 / self.eta } else { self.eta };
                    let reflected = fresnel(wo[2].abs(), eta);
                    let is_reflected = u[2] < reflected;
                    let share = if is_reflected { reflected } else { 1.0 - reflected };
                    let mut weight = if self.is("not divided by the choice") { share } else { 1.0 };
                    if is_reflected {
                        return Some(([-wo[0], -wo[1], wo[2]], [weight; 3], None));
                    }
                    let sine2 = (1.0 - wo[2] * wo[2]).max(0.0) / (eta * eta);
                    let far = (1.0 - sine2).max(0.0).sqrt();
                    weight /= eta * eta;
                    let z = if wo[2] < 0.0 { far } else { -far };
                    Some(([-wo[0] / eta, -wo[1] / eta, z], [weight; 3], None))
                }
            }

            fn below_to_above(w: V) -> V {
                [w[0], w[1], w[2].abs()]
            }
        }
    };
}

scattering!(single, f32);
scattering!(double, f64);
