#!/usr/bin/env python3
"""Lobes that people write, for `groundtruth laws`: each after its paper, and right.

Run: groundtruth laws -- python3 examples/laws/bsdfs.py
     groundtruth laws -- python3 examples/laws/bsdfs.py "no Jacobian"

The second makes a mistake: the words that follow name it (see `is_made`)."""
import math
import sys

import init

MISTAKE = " ".join(sys.argv[1:])
ROUGHNESS = [0.001, 1]
RECIPROCAL = {"reciprocal": True, "isotropic": True}

init.LOBES = [
    {"name": "lambert", "parameters": {"albedo": [0, 1]}, "claims": RECIPROCAL},
    {"name": "oren_nayar", "parameters": {"sigma": [0, 1.5]}, "claims": RECIPROCAL},
    {"name": "conductor", "parameters": {"x": ROUGHNESS, "y": ROUGHNESS}, "claims": {"reciprocal": True}},
    {"name": "rough_dielectric", "parameters": {"x": ROUGHNESS, "eta": [1.1, 2.4]},
     "claims": {**RECIPROCAL, "sides": "both", "eta": "eta", "from_below": True}},
    {"name": "layered", "parameters": {"x": ROUGHNESS, "eta": [1.1, 2.4]}, "claims": RECIPROCAL},
    {"name": "mirror", "claims": {"delta": True}},
]


def is_made(mistake):
    return mistake == MISTAKE


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a] if length > 0 else [0, 0, 1]


def reflected(wo, h):
    return [2 * dot(wo, h) * x - y for x, y in zip(h, wo)]


def below(w):
    return [w[0], w[1], -w[2]]


def fresnel(cosine, eta):
    """Fresnel's equations, for the index of the far side over the near one."""
    sine2 = (1 - cosine * cosine) / (eta * eta)
    if sine2 >= 1:
        return 1
    far = math.sqrt(1 - sine2)
    s, p = (cosine - eta * far) / (cosine + eta * far), (eta * cosine - far) / (eta * cosine + far)
    return (s * s + p * p) / 2


# Microfacets: GGX (Walter et al. 2007), shadowing of both directions together (Heitz 2014), visible normals (Heitz 2018).


def d(h, x, y):
    inner = (h[0] / x) ** 2 + (h[1] / y) ** 2 + h[2] ** 2
    return 1 / (math.pi * x * y * inner * inner)


def hidden(w, x, y):
    return (math.sqrt(1 + ((x * w[0]) ** 2 + (y * w[1]) ** 2) / w[2] ** 2) - 1) / 2


def shadowing(wo, wi, x, y):
    return 1 / (1 + hidden(wo, x, y) + hidden(wi, x, y))


def visible(wo, h, x, y):
    """The density of the normals that a viewer sees."""
    return max(dot(wo, h), 0) * d(h, x, y) / (1 + hidden(wo, x, y)) / abs(wo[2])


def sample_visible(wo, u, x, y):
    v = unit([x * wo[0], y * wo[1], wo[2]])
    flat = math.hypot(v[0], v[1])
    t1 = [-v[1] / flat, v[0] / flat, 0] if flat > 0 else [1, 0, 0]
    t2 = [v[1] * t1[2] - v[2] * t1[1], v[2] * t1[0] - v[0] * t1[2], v[0] * t1[1] - v[1] * t1[0]]
    r, phi, s = math.sqrt(u[0]), 2 * math.pi * u[1], (1 + v[2]) / 2
    a = r * math.cos(phi)
    b = (1 - s) * math.sqrt(max(1 - a * a, 0)) + s * r * math.sin(phi)
    c = math.sqrt(max(1 - a * a - b * b, 0))
    n = [a * t1[i] + b * t2[i] + c * v[i] for i in range(3)]
    return unit([x * n[0], y * n[1], max(n[2], 0)])


def facets(wo, wi, x, y):
    """What reflects without its Fresnel term, the density, and the cosine at the facet."""
    h = unit([a + b for a, b in zip(wo, wi)])
    cosine = dot(wo, h)
    jacobian = 1 if is_made("no Jacobian") else 4 * cosine
    f = d(h, x, y) * shadowing(wo, wi, x, y) / (4 * wo[2] * wi[2])
    return f, visible(wo, h, x, y) / jacobian, cosine


def sample_facets(wo, u, x, y):
    wi = reflected(wo, sample_visible(wo, u, x, y))
    return wi if wi[2] > 0 else None


# The lobes: f and pdf, and a direction.


def cosine_sample(wo, u):
    r, phi = math.sqrt(u[0]), 2 * math.pi * u[1]
    return [r * math.cos(phi), r * math.sin(phi), math.sqrt(1 - u[0])]


def lambert(p, wo, wi):
    return p["albedo"] / math.pi, wi[2] / math.pi


def oren_nayar(p, wo, wi):
    """Oren and Nayar 1994, the qualitative model."""
    sigma2 = p["sigma"] ** 2
    a, b = 1 - sigma2 / (sigma2 + 0.33) / 2, 0.45 * sigma2 / (sigma2 + 0.09)
    sines = [math.hypot(w[0], w[1]) for w in (wi, wo)]
    flat = sines[0] * sines[1]
    turn = max((wi[0] * wo[0] + wi[1] * wo[1]) / flat, 0) if flat > 0 else 0
    (far, _), (near, tangent) = sorted(((s, s / w[2]) for s, w in zip(sines, (wi, wo))), reverse=True)
    return 0.7 / math.pi * (a + b * turn * far * tangent), wi[2] / math.pi


def conductor(p, wo, wi):
    f, pdf, cosine = facets(wo, wi, p["x"], p["y"])
    rest = (1 - cosine) ** 5  # Schlick 1994
    return [f * (f0 + (1 - f0) * rest) for f0 in (1, 0.7, 0.3)], pdf


def rough_dielectric(p, wo, wi):
    x, eta = p["x"], p["eta"]
    if wi[2] > 0:
        f, pdf, cosine = facets(wo, wi, x, x)
        share = fresnel(cosine, eta)
        return f * share, pdf * share
    h = unit([eta * a + b for a, b in zip(wi, wo)])
    h = h if h[2] > 0 else [-a for a in h]
    co, ci = dot(wo, h), dot(wi, h)
    if co <= 0 or ci >= 0 or wi[2] == 0:
        return 0, 0
    share, half = 1 - fresnel(co, eta), (ci + co / eta) ** 2
    f = abs(d(h, x, x) * shadowing(wo, below(wi), x, x) * share * ci * co / (half * wi[2] * wo[2]))
    if not is_made("no 1/eta²"):
        f /= eta * eta
    return f, visible(wo, h, x, x) * abs(ci) / half * share


def sample_rough_dielectric(p, wo, u):
    h = sample_visible(wo, u, p["x"], p["x"])
    co, eta = dot(wo, h), p["eta"]
    if u[2] < fresnel(co, eta):
        wi = reflected(wo, h)
        return wi if wi[2] > 0 else None
    sine2 = (1 - co * co) / (eta * eta)
    if sine2 >= 1:
        return None
    far = math.sqrt(1 - sine2)
    wi = [(co / eta - far) * a - b / eta for a, b in zip(h, wo)]
    return wi if wi[2] < 0 else None


def choice(p, wo):
    return min(0.2 + 0.6 * fresnel(wo[2], p["eta"]), 0.9)


def layered(p, wo, wi):
    """A rough coat over a diffuse base, whose light passes the coat twice."""
    f, pdf, cosine = facets(wo, wi, p["x"], p["x"])
    through = (1 - fresnel(wo[2], p["eta"])) * (1 - fresnel(wi[2], p["eta"]))
    share = choice(p, wo)
    return f * fresnel(cosine, p["eta"]) + through / math.pi, share * pdf + (1 - share) * wi[2] / math.pi


def sample_layered(p, wo, u):
    if u[2] < choice(p, wo):
        return sample_facets(wo, u, p["x"], p["x"])
    return cosine_sample(wo, u)


VALUES = {f.__name__: f for f in (lambert, oren_nayar, conductor, rough_dielectric, layered)}
SAMPLES = {"conductor": lambda p, wo, u: sample_facets(wo, u, p["x"], p["y"]),
           "rough_dielectric": sample_rough_dielectric, "layered": sample_layered}


def evaluate(name, p, wo, wi):
    if wo[2] < 0 and name == "rough_dielectric":
        return evaluate(name, {**p, "eta": 1 / p["eta"]}, below(wo), below(wi))
    is_below = wo[2] <= 0 or wi[2] <= 0 and name != "rough_dielectric"
    return (0, 0) if is_below or name == "mirror" else VALUES[name](p, wo, wi)


def sample(name, p, wo, u):
    if name == "mirror":
        return [-wo[0], -wo[1], wo[2]], 0.9, None
    if wo[2] < 0 and name == "rough_dielectric":
        drawn = sample(name, {**p, "eta": 1 / p["eta"]}, below(wo), u)
        return drawn and (below(drawn[0]), *drawn[1:])
    wi = SAMPLES.get(name, lambda p, wo, u: cosine_sample(wo, u))(p, wo, u) if wo[2] > 0 else None
    if wi is None:
        return None
    f, pdf = evaluate(name, p, wo, wi)
    if pdf <= 0:
        return None
    cosine = abs(wi[2]) ** (2 if is_made("cosine twice") else 1)
    weight = [c * cosine / pdf for c in f] if isinstance(f, list) else f * cosine / pdf
    return wi, weight, pdf


init.evaluate, init.sample = evaluate, sample

if __name__ == "__main__":
    init.main()
