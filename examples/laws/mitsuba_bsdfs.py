#!/usr/bin/env python3
"""Mitsuba 3's BSDFs (in single precision) answer `groundtruth laws`.

Needs: pip install mitsuba
Run: groundtruth laws -- python3 examples/laws/mitsuba_bsdfs.py

All numbers are those of `BSDF.eval`, `pdf` and `sample`. Their `wi` is our `wo` and the other way round, and their `eval`
has the cosine, which is divided out."""
import functools

import mitsuba as mi

import init

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)  # its warnings go to the standard output

ROUGHNESS = [0.001, 1]  # from Mitsuba's smallest: it clamps what is below 10⁻⁴
COLOR = [0.1, 1]  # a black lobe has no samples
INDEX = [1.1, 2.4]
FACETS = {"distribution": {"one_of": ["ggx", "beckmann"]}, "sample_visible": {"one_of": [True, False]}}
REFLECTS = {"float": True, "reciprocal": True, "isotropic": True}
GLASS = {**REFLECTS, "sides": "both", "from_below": True, "eta": "int_ior"}
PRINCIPLED = {"base_color": COLOR, "roughness": ROUGHNESS}

init.LOBES = [
    {"name": name, "parameters": parameters, "claims": claims} for name, parameters, claims in [
        ("diffuse", {"reflectance": COLOR}, REFLECTS),
        ("twosided", {"reflectance": COLOR}, {**REFLECTS, "from_below": True}),
        ("conductor", {}, {"float": True, "delta": True, "lossless": True}),
        ("roughconductor", {"alpha_u": ROUGHNESS, "alpha_v": ROUGHNESS, **FACETS}, {"float": True, "reciprocal": True}),
        ("roughconductor_gold", {"alpha": ROUGHNESS, **FACETS}, REFLECTS),
        ("dielectric", {"int_ior": INDEX}, {**GLASS, "reciprocal": False, "delta": True, "lossless": True}),
        ("thindielectric", {"int_ior": INDEX},
         {"float": True, "sides": "both", "from_below": True, "delta": True, "lossless": True}),
        ("roughdielectric", {"alpha": ROUGHNESS, "int_ior": INDEX, **FACETS}, GLASS),
        ("plastic", {"diffuse_reflectance": COLOR, "int_ior": INDEX, "nonlinear": {"one_of": [False, True]}}, REFLECTS),
        ("roughplastic", {"diffuse_reflectance": COLOR, "alpha": ROUGHNESS, "int_ior": INDEX,
                          "nonlinear": {"one_of": [False, True]}, **FACETS}, REFLECTS),
        ("principled", {**PRINCIPLED, "metallic": [0, 1], "specular": [0, 1], "spec_tint": [0, 1]}, REFLECTS),
        ("principled_anisotropic", {**PRINCIPLED, "metallic": [0, 1], "anisotropic": [0, 1]},
         {"float": True, "reciprocal": True}),
        ("principled_sheen", {**PRINCIPLED, "sheen": [0, 1], "sheen_tint": [0, 1], "flatness": [0, 1]}, REFLECTS),
        ("principled_clearcoat", {**PRINCIPLED, "clearcoat": [0, 1], "clearcoat_gloss": [0, 1]}, REFLECTS),
        ("principled_glass", {**PRINCIPLED, "spec_trans": [0, 1], "eta": INDEX}, {**GLASS, "eta": "eta"}),
        ("principledthin", {**PRINCIPLED, "spec_trans": [0, 1], "diff_trans": [0, 2], "eta": INDEX},
         {**REFLECTS, "sides": "both", "from_below": True}),
        ("blendbsdf", {"weight": [0, 1], "reflectance": COLOR, "alpha": ROUGHNESS}, REFLECTS),
        ("mask", {"opacity": [0.1, 1], "reflectance": COLOR}, {**REFLECTS, "sides": "both"}),
    ]
]


def rgb(value):
    return {"type": "rgb", "value": [value] * 3}


def described(name, p):
    """The dictionary from which Mitsuba makes the BSDF."""
    if name in ("twosided", "mask"):
        (nested, rest) = {"type": "diffuse", "reflectance": rgb(p["reflectance"])}, {k: p[k] for k in p if k == "opacity"}
        return {"type": name, "nested": nested, **rest}
    if name == "blendbsdf":
        coat = {"type": "roughconductor", "alpha": p["alpha"]}
        return {"type": name, "weight": p["weight"], "a": {"type": "diffuse", "reflectance": rgb(p["reflectance"])}, "b": coat}
    plugin, _, variety = name.partition("_")
    # the index of air is 1.000277 otherwise
    outside = {"ext_ior": 1.0} if "int_ior" in p else {}
    made = {"type": plugin, **outside, **{k: rgb(x) if k.endswith(("reflectance", "base_color")) else x for k, x in p.items()}}
    return {**made, "material": "Au"} if variety == "gold" else made


@functools.lru_cache(maxsize=4)
def made(name, parameters):
    return mi.load_dict(described(name, dict(parameters)))


CONTEXT = mi.BSDFContext()
SINGLE = mi.BSDFFlags.Delta | mi.BSDFFlags.Null


class Seen:
    """A BSDF and its viewer, kept for all directions of a question."""
    asked, bsdf, interaction = (), None, None

    @classmethod
    def of(cls, name, parameters, wo):
        asked = (name, parameters, wo)
        if len(cls.asked) != 3 or any(a is not b for a, b in zip(asked, cls.asked)):
            cls.asked, cls.bsdf = asked, made(name, tuple(sorted(parameters.items())))
            cls.interaction = mi.SurfaceInteraction3f()
            cls.interaction.wi = mi.Vector3f(wo)
        return cls.bsdf, cls.interaction


def three(color):
    return [float(color[i]) for i in range(3)]


def evaluate(name, parameters, wo, wi):
    bsdf, interaction = Seen.of(name, parameters, wo)
    wi = mi.Vector3f(wi)
    value, cosine = bsdf.eval(CONTEXT, interaction, wi), abs(wi[2])
    f = [x / cosine if x else 0 for x in three(value)]
    return f, float(bsdf.pdf(CONTEXT, interaction, wi))


def sample(name, parameters, wo, u):
    bsdf, interaction = Seen.of(name, parameters, wo)
    drawn, weight = bsdf.sample(CONTEXT, interaction, u[2], u[:2])
    weight, is_single = three(weight), mi.has_flag(drawn.sampled_type, SINGLE)
    # a weight of 0 says that there is no sample, as in Mitsuba's own χ² test (mitsuba.chi2.BSDFAdapter)
    if weight == [0, 0, 0]:
        return None
    return three(drawn.wo), weight, None if is_single else float(drawn.pdf)


init.evaluate, init.sample = evaluate, sample

if __name__ == "__main__":
    init.main()
