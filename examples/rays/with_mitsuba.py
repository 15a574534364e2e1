"""Rays of Mitsuba 3 (pip install mitsuba): a path tracer in Python over its scene, materials and lamp, which samples the
lamp and the materials and weighs both.
    PYTHONPATH=. RAYS=/8 python3 with_mitsuba.py > picture.ppm && groundtruth rays rays.jsonl"""
from random import random, seed

import mitsuba as mi

import rays

mi.set_variant("scalar_rgb")            # single precision
WIDTH, HEIGHT, SAMPLES = 96, 64, 4
DEEPEST, SURVIVES = 12, 0.8             # roulette from the fourth ray on
T = mi.ScalarTransform4f


def matte(r, g, b): return {"type": "diffuse", "reflectance": {"type": "rgb", "value": [r, g, b]}}
def ball(center, radius, bsdf): return {"type": "sphere", "center": center, "radius": radius, "bsdf": bsdf}


BALLS = {
    "glass": ball([-1.3, 1, 0.4], 1, {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}),
    "chalk": ball([1.2, 0.8, 0.2], 0.8, matte(0.7, 0.3, 0.2)),
    "metal": ball([0.1, 0.5, 1.6], 0.5, {"type": "roughconductor", "alpha": 0.3, "distribution": "ggx"}),
}
SCENE = mi.load_dict({
    "type": "scene",
    "camera": {"type": "perspective", "fov": 40, "to_world": T().look_at(origin=[0, 2.2, 7], target=[0, 1, 0], up=[0, 1, 0]),
               "film": {"type": "hdrfilm", "width": WIDTH, "height": HEIGHT}},
    "floor": {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(8), "bsdf": matte(0.6, 0.6, 0.6)},
    "lamp": {"type": "rectangle", "to_world": T().translate([0.5, 4, 1]).rotate([1, 0, 0], 90),
             "emitter": {"type": "area", "radiance": {"type": "rgb", "value": [9, 8, 7]}}},
    **BALLS})
KINDS = {"reflected": mi.BSDFFlags.DeltaReflection, "transmitted": mi.BSDFFlags.DeltaTransmission, "glossy": mi.BSDFFlags.Glossy}

for name, shape in BALLS.items():
    rays.line({"object": name, "sphere": {"center": shape["center"], "radius": shape["radius"]}})
rays.line({"object": "floor", "rectangle": {"corner": [-8, 0, 8], "a": [16, 0, 0], "b": [0, 0, -16]}})
rays.line({"object": "lamp", "rectangle": {"corner": [-0.5, 4, 0], "a": [2, 0, 0], "b": [0, 0, 2]}})
rays.line({"lamp": "lamp", "object": "lamp"})


def direct(si, bsdf):
    """What one point of a lamp brings, by the balance of both strategies."""
    ds, light = SCENE.sample_emitter_direction(si, [random(), random()], False)
    local = si.to_local(ds.d)
    reflected, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, local)
    if ds.pdf == 0 or pdf == 0:
        return mi.Color3f(0)
    shadow, mis = si.spawn_ray_to(ds.p), ds.pdf / (ds.pdf + pdf)
    weight = reflected * (mis / ds.pdf)
    with rays.ray("shadow", shadow.o, shadow.d) as log:
        log.text("light", "lamp")
        log.number("end", shadow.maxt)
        log.color("f", reflected / abs(local.z))
        for field, value in ("cos", abs(local.z)), ("pdf", ds.pdf), ("other_pdf", pdf), ("mis", mis):
            log.number(field, value)
        log.color("weight", weight)
        blocker = SCENE.ray_intersect(shadow)
        if blocker.is_valid():
            log.hit(blocker.t, blocker.p, blocker.n, blocker.shape.id())
            light = mi.Color3f(0)
        log.color("radiance", light * ds.pdf)
    return weight * light * ds.pdf


def scattered(si, bsdf, depth):
    choice = 1 if depth < 3 else SURVIVES if depth < DEEPEST else 0
    if random() >= choice:
        return mi.Color3f(0)
    sample, weight = bsdf.sample(mi.BSDFContext(), si, random(), [random(), random()])
    if max(weight) == 0:
        return mi.Color3f(0)
    kind = next((kind for kind, flag in KINDS.items() if mi.has_flag(sample.sampled_type, flag)), "diffuse")
    is_sharp = kind in ("reflected", "transmitted")
    factors = {"weight": weight / choice, "choice": choice * (sample.pdf if is_sharp else 1)}
    if kind == "transmitted":
        factors["eta"] = sample.eta
    if not is_sharp:
        cosine = abs(sample.wo.z)
        factors.update(cos=cosine, pdf=sample.pdf, f=weight * (sample.pdf / cosine))
    return weight / choice * radiance(kind, si.spawn_ray(si.to_world(sample.wo)), si, depth + 1, factors)


def radiance(kind, ray, sender=None, depth=0, factors={}):
    with rays.ray(kind, ray.o, ray.d) as log:
        for field, value in factors.items():
            (log.number if isinstance(value, (int, float)) else log.color)(field, value)
        si, light = SCENE.ray_intersect(ray), mi.Color3f(0)
        if si.is_valid():
            log.hit(si.t, si.p, si.n, si.shape.id())
            emitter = si.emitter(SCENE)
            if emitter is not None:
                light = emitter.eval(si)
                log.color("emitted", light)
                if "pdf" in factors:
                    pdf = SCENE.pdf_emitter_direction(sender, mi.DirectionSample3f(SCENE, si, sender))
                    mis = factors["pdf"] / (factors["pdf"] + pdf)
                    log.number("other_pdf", pdf)
                    log.number("mis", mis)
                    light = mis * light
            bsdf = si.bsdf()
            light = light + direct(si, bsdf) + scattered(si, bsdf, depth)
        log.color("radiance", light)
        return light


def main():
    print("P3", WIDTH, HEIGHT, 255)
    for y in range(HEIGHT):
        for x in range(WIDTH):
            light = mi.Color3f(0)
            for index in range(SAMPLES):
                seed(f"{x} {y} {index}")
                rays.pixel(x, y, index)
                at = [(x + random()) / WIDTH, (y + random()) / HEIGHT]
                light += radiance("camera", SCENE.sensors()[0].sample_ray(0, 0.5, at, [0.5, 0.5])[0]) / SAMPLES
            print(*(int(255.99 * min(1, max(0, c)) ** (1 / 2.2)) for c in light))


main()
