"""A small recursive tracer that writes down its rays: a glass ball and a hollow one over a checkered floor, under the
sky. Glass sends both rays, each with its part of the light by Fresnel's equations; all else is lit by a lamp.
    PYTHONPATH=. RAYS=/4 python3 tracer.py > picture.ppm && groundtruth rays rays.jsonl"""
from math import floor, inf, sqrt

import rays


def add(a, b): return tuple(x + y for x, y in zip(a, b))
def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def times(a, b): return tuple(x * y for x, y in zip(a, b))
def scale(s, a): return tuple(s * x for x in a)
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return scale(1 / sqrt(dot(a, a)), a)


EPSILON = 1e-9      # of t: a ray starts exactly at the hit, and nearer surfaces than this are skipped
INDEX = 1.5
LAMP = (3, 6, 2)
POWER = (40, 40, 36)


class Ball:
    def __init__(self, name, center, radius, color=None):
        self.name, self.center, self.radius, self.color = name, center, radius, color
        # the negative radius of a hollow turns its normal, as in "Ray Tracing in One Weekend"
        rays.line({"object": name, "sphere": {"center": center, "radius": abs(radius), "inward": radius < 0}})

    def meet(self, o, d):
        between = sub(o, self.center)
        a, half = dot(d, d), dot(between, d)
        square = half * half - a * (dot(between, between) - self.radius ** 2)
        roots = ((-half - sqrt(square)) / a, (-half + sqrt(square)) / a) if square >= 0 else ()
        return next((t for t in roots if t > EPSILON), inf)

    def normal(self, point): return scale(1 / self.radius, sub(point, self.center))


class Floor:
    name, color = "floor", (0.8, 0.8, 0.8)

    def __init__(self, height):
        self.height = height
        rays.line({"object": self.name, "plane": {"point": [0, height, 0], "normal": [0, 1, 0]}})

    def meet(self, o, d):
        t = (self.height - o[1]) / d[1] if d[1] else inf
        return t if t > EPSILON else inf

    def normal(self, point): return (0, 1, 0)


SCENE = [Floor(0), Ball("glass", (-0.9, 1, 0), 1), Ball("shell", (1.3, 0.9, 0.3), 0.9), Ball("hollow", (1.3, 0.9, 0.3), -0.8),
         Ball("cherry", (0.1, 0.4, -1.6), 0.4, (0.8, 0.1, 0.1)), Ball("pea", (0.2, 0.25, 1.4), 0.25, (0.3, 0.7, 0.2))]
rays.line({"lamp": "bulb", "point": LAMP})


def nearest(o, d):
    t, thing = min(((thing.meet(o, d), thing) for thing in SCENE), key=lambda pair: pair[0])
    return (t, thing) if t < inf else (inf, None)


def sky(d):
    s = 0.5 + 0.5 * unit(d)[1]
    return add(scale(1 - s, (1, 1, 1)), scale(s, (0.4, 0.6, 1)))


def direct(thing, point, n):
    """What a matte thing reflects of the lamp; glass blocks it, too."""
    way = sub(LAMP, point)                      # t is 1 at the lamp
    square = dot(way, way)
    cosine = dot(way, n) / sqrt(square)
    if cosine <= 0:
        return (0, 0, 0)
    checker = (floor(point[0]) + floor(point[2])) % 2 if thing.name == "floor" else 0
    with rays.ray("shadow", point, way) as log:
        log.text("light", "bulb")
        log.number("end", 1)
        t, blocker = nearest(point, way)
        if t < 1:
            log.number("t", t)
            log.text("object", blocker.name)
            return (0, 0, 0)
    return scale(cosine / square * (0.3 if checker else 1), times(thing.color, POWER))


def fresnel(cos_front, cos_behind, ratio):
    """The part that is reflected; `ratio` is the index in front over the one behind."""
    s = (ratio * cos_front - cos_behind) / (ratio * cos_front + cos_behind)
    p = (ratio * cos_behind - cos_front) / (ratio * cos_behind + cos_front)
    return (s * s + p * p) / 2


def radiance(kind, o, d, weight=1, depth=6, **factors):
    with rays.ray(kind, o, d) as log:
        log.color("weight", weight)
        for name, number in factors.items():
            log.number(name, number)
        t, thing = nearest(o, d)
        if thing is None:
            log.color("emitted", sky(d))
            log.color("radiance", sky(d))
            return sky(d)
        point = add(o, scale(t, d))
        n = thing.normal(point)
        log.hit(t, point, n, thing.name)
        if thing.color:
            light = direct(thing, point, n)
            light = add(light, scale(0.1, thing.color))
            log.color("direct", light)
        else:
            light = glass(point, unit(d), n, weight, depth)
        log.color("radiance", light)
        return light


def glass(point, d, n, weight, depth):
    ratio, cosine = 1 / INDEX, -dot(d, n)
    if cosine < 0:
        ratio, cosine, n = INDEX, -cosine, scale(-1, n)
    mirrored = add(d, scale(2 * cosine, n))
    square = 1 - ratio * ratio * (1 - cosine * cosine)
    share = fresnel(cosine, sqrt(square), ratio) if square > 0 else 1
    light = (0, 0, 0)
    if depth > 0:
        light = add(light, scale(share, radiance("reflected", point, mirrored, share, depth - 1)))
    if depth > 0 and square > 0:
        through = add(scale(ratio, d), scale(ratio * cosine - sqrt(square), n))
        factors = {"eta_from": INDEX if ratio > 1 else 1, "eta_to": 1 if ratio > 1 else INDEX}
        light = add(light, scale(1 - share, radiance("refracted", point, through, 1 - share, depth - 1, **factors)))
    return light


def main():
    width, height = 96, 64
    print("P3", width, height, 255)
    for y in range(height):
        for x in range(width):
            rays.pixel(x, y)
            d = ((x + 0.5 - width / 2) / height, (height / 2 - y - 0.5) / height - 0.2, -1.1)
            light = radiance("camera", (0, 1.7, 4.5), unit(d))
            print(*(int(255.99 * sqrt(min(1, c))) for c in light))


main()
