//! Microfacets: conductors and rough dielectrics (Walter et al. 2007; Heitz 2014, 2018).

/// The methods of `Lobe` for both precisions.
macro_rules! microfacets {
    ($F:ident) => {
        impl Lobe {
            fn alpha(&self) -> [$F; 2] {
                self.roughness
            }

            fn d(&self, h: V) -> $F {
                let [mut ax, mut ay] = self.alpha();
                if self.is("roughness clamped in eval") {
                    (ax, ay) = (ax.max(0.3), ay.max(0.3));
                }
                if self.is("roughness squared in eval") {
                    (ax, ay) = (ax * ax, ay * ay);
                }
                if self.is("axes exchanged in eval") {
                    (ax, ay) = (ay, ax);
                }
                let inner = (h[0] / ax) * (h[0] / ax) + (h[1] / ay) * (h[1] / ay) + h[2] * h[2];
                let pi = if self.is("no pi in D") { 1.0 } else { PI };
                1.0 / (pi * ax * ay * inner * inner)
            }

            fn lambda(&self, w: V) -> $F {
                let [ax, ay] = self.alpha();
                let slope = (ax * w[0] * ax * w[0] + ay * w[1] * ay * w[1]) / (w[2] * w[2]);
                0.5 * ((1.0 + slope).sqrt() - 1.0)
            }

            fn g1(&self, w: V) -> $F {
                1.0 / (1.0 + self.lambda(w))
            }

            fn g2(&self, wo: V, wi: V) -> $F {
                if self.is("separable shadowing in eval") {
                    return self.g1(wo) * self.g1(wi);
                }
                1.0 / (1.0 + self.lambda(wo) + self.lambda(wi))
            }

            /// The density of visible normals.
            fn visible(&self, wo: V, h: V) -> $F {
                if self.is("pdf of all normals") {
                    return self.d(h) * h[2].abs();
                }
                self.g1(wo) * dot(wo, h).max(0.0) * self.d(h) / wo[2].abs()
            }

            fn sample_visible(&self, wo: V, u: [$F; 2]) -> V {
                let [ax, ay] = self.alpha();
                let v = match self.is("viewer not stretched") {
                    true => wo,
                    false => unit([ax * wo[0], ay * wo[1], wo[2]]),
                };
                let flat = v[0] * v[0] + v[1] * v[1];
                let t1 = match flat > 0.0 {
                    true => scaled([-v[1], v[0], 0.0], 1.0 / flat.sqrt()),
                    false => [1.0, 0.0, 0.0],
                };
                let t2 = cross(v, t1);
                let (r, phi) = (u[0].sqrt(), 2.0 * PI * u[1]);
                let (a, mut b) = (r * phi.cos(), r * phi.sin());
                let height = if self.is("height not stretched") { wo[2] } else { v[2] };
                let s = 0.5 * (1.0 + height);
                if !self.is("half disk not moved") {
                    b = (1.0 - s) * (1.0 - a * a).max(0.0).sqrt() + s * b;
                }
                let c = (1.0 - a * a - b * b).max(0.0).sqrt();
                let n = sum(sum(scaled(t1, a), scaled(t2, b)), scaled(v, c));
                unit([ax * n[0], ay * n[1], n[2].max(0.0)])
            }

            fn conductor(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                if wo[2] <= 0.0 || wi[2] <= 0.0 {
                    return ([0.0; 3], 0.0);
                }
                let h = unit(sum(wo, wi));
                let cosine = dot(wo, h);
                // Schlick 1994
                let at = if self.is("Fresnel of the viewer's angle") { wo[2] } else { cosine };
                let rest = (1.0 - at).max(0.0).powi(5);
                let shade = |f0: $F| f0 + (1.0 - f0) * rest;
                let four = if self.is("2 for 4 in f") { 2.0 } else { 4.0 };
                let below = match self.is("light's cosine not divided") {
                    true => four * wo[2],
                    false => four * wo[2] * wi[2],
                };
                let value = self.d(h) * self.g2(wo, wi) / below;
                let jacobian = if self.is("no Jacobian") { 1.0 } else { 4.0 * cosine };
                ([1.0, 0.7, 0.3].map(|f0| value * shade(f0)), self.visible(wo, h) / jacobian)
            }

            fn sample_conductor(&self, wo: V, u: [$F; 4]) -> Drawn {
                let mut u = u;
                if wo[2] <= 0.0 {
                    return None;
                }
                let mut h = self.sample_visible(wo, [u[0], u[1]]);
                let mut wi = sum(scaled(h, 2.0 * dot(wo, h)), scaled(wo, -1.0));
                for _ in 0..64 {
                    if wi[2] > 0.0 || !self.is("drawn until above") {
                        break;
                    }
                    u = [u[1] * 7.31 % 1.0, u[0] * 3.77 % 1.0, u[2], u[3]];
                    h = self.sample_visible(wo, [u[0], u[1]]);
                    wi = sum(scaled(h, 2.0 * dot(wo, h)), scaled(wo, -1.0));
                }
                if self.is("reflected about the normal") {
                    wi = [-wo[0], -wo[1], wo[2]];
                }
                if wi[2] <= 0.0 && !self.is("below the horizon") {
                    return None;
                }
                let (f, mut pdf) = self.eval(wo, wi);
                if pdf <= 0.0 {
                    return self.is("below the horizon").then_some((wi, [0.0; 3], Some(1.0)));
                }
                let mut weight = f.map(|f| f * wi[2].abs() / pdf);
                if self.is("shadowing of the light alone in weight") {
                    weight = weight.map(|w| w * self.g1(wi) / self.g2(wo, wi) * self.g1(wo));
                }
                if self.is("no shadowing in weight") {
                    weight = weight.map(|w| w / self.g2(wo, wi));
                }
                if self.is("separable shadowing in eval") {
                    let joint = 1.0 / (1.0 + self.lambda(wo) + self.lambda(wi));
                    weight = weight.map(|w| w * joint / self.g2(wo, wi));
                }
                if self.is("Jacobian in the sample alone") {
                    pdf /= 4.0 * dot(wo, h);
                }
                Some((wi, weight, Some(pdf)))
            }

            /// Both sides; viewers below are mirrored above, with the index upside down.
            fn dielectric(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                if wo[2] < 0.0 {
                    let eta = match self.is("index not inverted") {
                        true => self.eta,
                        false => 1.0 / self.eta,
                    };
                    return Self { eta, ..self.clone() }.dielectric(below(wo), below(wi));
                }
                let eta = self.eta;
                let is_reflected = wi[2] > 0.0;
                let mut h = match is_reflected {
                    true => unit(sum(wo, wi)),
                    false => unit(sum(scaled(wi, eta), wo)),
                };
                if h[2] < 0.0 && !self.is("half vector not turned up") {
                    h = scaled(h, -1.0);
                }
                let (co, ci) = (dot(wo, h), dot(wi, h));
                if co <= 0.0 || ci * wi[2] <= 0.0 || wi[2] == 0.0 || wo[2] == 0.0 {
                    return ([0.0; 3], 0.0);
                }
                let reflected = fresnel(co, eta);
                let (d, g) = (self.d(h), self.g2(wo, below_to_above(wi)));
                if is_reflected {
                    let f = d * g * reflected / (4.0 * wo[2] * wi[2]);
                    let share = if self.is("pdf without the choice") { 1.0 } else { reflected };
                    return ([f; 3], self.visible(wo, h) / (4.0 * co) * share);
                }
                let half = ci + co / eta;
                let denominator = half * half * wi[2] * wo[2];
                let mut f = (d * g * (1.0 - reflected) * ci * co / denominator).abs();
                if !self.is("no 1/eta²") {
                    f /= eta * eta;
                }
                let mut jacobian = ci.abs() / (half * half);
                if self.is("no light's cosine in the Jacobian") {
                    jacobian = 1.0 / (half * half);
                }
                if self.is("reflection's Jacobian for transmission") {
                    jacobian = 1.0 / (4.0 * co);
                }
                let share = if self.is("pdf without the choice") { 1.0 } else { 1.0 - reflected };
                ([f; 3], self.visible(wo, h) * jacobian * share)
            }

            fn sample_dielectric(&self, wo: V, u: [$F; 4]) -> Drawn {
                if wo[2] < 0.0 {
                    let eta = match self.is("index not inverted") {
                        true => self.eta,
                        false => 1.0 / self.eta,
                    };
                    let (wi, weight, pdf) =
                        Self { eta, ..self.clone() }.sample_dielectric(below(wo), u)?;
                    return Some((below(wi), weight, pdf));
                }
                let h = self.sample_visible(wo, [u[0], u[1]]);
                let co = dot(wo, h);
                let wi = if u[2] < fresnel(co, self.eta) {
                    let wi = sum(scaled(h, 2.0 * co), scaled(wo, -1.0));
                    if wi[2] <= 0.0 {
                        return None;
                    }
                    wi
                } else {
                    let sine2 = (1.0 - co * co).max(0.0) / (self.eta * self.eta);
                    if sine2 >= 1.0 {
                        return None;
                    }
                    let far = (1.0 - sine2).sqrt();
                    let wi = sum(scaled(wo, -1.0 / self.eta), scaled(h, co / self.eta - far));
                    if wi[2] >= 0.0 {
                        return None;
                    }
                    wi
                };
                let (f, pdf) = self.eval(wo, wi);
                if pdf <= 0.0 {
                    return None;
                }
                let mut weight = f.map(|f| f * wi[2].abs() / pdf);
                if self.is("no 1/eta² in weight") && wi[2] < 0.0 {
                    weight = weight.map(|w| w * self.eta * self.eta);
                }
                Some((wi, weight, Some(pdf)))
            }
        }
    };
}

pub(super) use microfacets;
