#!/usr/bin/env python3
"""A Whitted ray tracer: python3 whitted.py > whitted.ppm"""
import json
import math
import os
import sys

W, H = 160, 120
FOV = 50.0
EYE = (0.0, 1.6, 5.0)
TARGET = (0.0, 0.8, 0.0)
MAX_DEPTH = 6
EPS = 1e-6
AMBIENT = 0.06


# --- vectors are tuples
def add(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def mul(a, b): return (a[0] * b[0], a[1] * b[1], a[2] * b[2])
def scale(a, s): return (a[0] * s, a[1] * s, a[2] * s)
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def norm(a): return scale(a, 1.0 / math.sqrt(dot(a, a)))


class Material:
    def __init__(self, color, kd=1.0, ks=0.0, shininess=0, mirror=0.0, ior=None, color2=None):
        self.color, self.kd, self.ks, self.shininess = color, kd, ks, shininess
        self.mirror, self.ior, self.color2 = mirror, ior, color2

    def albedo(self, p):
        if self.color2 is None:
            return self.color
        odd = (math.floor(p[0]) + math.floor(p[2])) % 2
        return self.color2 if odd else self.color


class Sphere:
    def __init__(self, name, center, radius, material):
        self.name, self.center, self.radius, self.material = name, center, radius, material

    def intersect(self, o, d):
        oc = sub(o, self.center)
        b = dot(oc, d)
        c = dot(oc, oc) - self.radius * self.radius
        disc = b * b - c
        if disc < 0:
            return None
        s = math.sqrt(disc)
        t = -b - s
        if t > 0:
            return t
        t = -b + s
        if t > 0:
            return t
        return None

    def normal(self, p):
        return scale(sub(p, self.center), 1.0 / self.radius)

    def words(self):
        return {"sphere": {"center": self.center, "radius": self.radius}}


class Plane:
    def __init__(self, name, point, n, material):
        self.name, self.point, self.n, self.material = name, point, n, material

    def intersect(self, o, d):
        dn = dot(d, self.n)
        if abs(dn) < 1e-12:
            return None
        t = dot(sub(self.point, o), self.n) / dn
        return t if t > 0 else None

    def normal(self, p):
        return self.n

    def words(self):
        return {"plane": {"point": self.point, "normal": self.n}}


class Light:
    def __init__(self, name, pos, intensity):
        self.name, self.pos, self.intensity = name, pos, intensity


OBJECTS = [
    Plane("floor", (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), Material((0.85, 0.85, 0.85), color2=(0.2, 0.2, 0.25))),
    Sphere("mirrorball", (-1.3, 1.0, -0.8), 1.0, Material((0.9, 0.9, 0.9), kd=0.1, ks=0.6, shininess=80, mirror=0.8)),
    Sphere("glassball", (0.7, 0.75, 0.9), 0.75, Material((1.0, 1.0, 1.0), kd=0.0, ior=1.5)),
    Sphere("redball", (1.7, 0.9, -1.2), 0.9, Material((0.9, 0.2, 0.15), kd=0.8, ks=0.3, shininess=25)),
    Sphere("blueball", (-0.55, 0.35, 1.0), 0.35, Material((0.2, 0.3, 0.9), kd=0.7, ks=0.4, shininess=40, mirror=0.15)),
    # hangs above the lamp: must not shade anything below
    Sphere("lampshade", (-2.0, 5.0, 2.0), 0.5, Material((0.7, 0.6, 0.3))),
]
LIGHTS = [
    Light("key", (-2.0, 4.2, 2.0), (55.0, 52.0, 46.0)),
    Light("fill", (3.5, 3.0, 3.0), (12.0, 14.0, 20.0)),
]

# --- the log
LOG = open(os.environ["LOG"], "w") if "LOG" in os.environ else None
EVERY = max(1, int(os.environ.get("RAYS", "/1").lstrip("/")))
pixel = None         # [x, y] while a pixel is logged, else None
counter = 0


def new_id():
    global counter
    counter += 1
    return counter


def write(**fields):
    if pixel is not None:
        LOG.write(json.dumps(dict(pixel=pixel, **fields)) + "\n")


# --- geometry
def nearest(o, d):
    best, hit = math.inf, None
    for obj in OBJECTS:
        t = obj.intersect(o, d)
        if t is not None and t < best:
            best, hit = t, obj
    return best, hit


def reflect(d, n):
    return sub(d, scale(n, 2.0 * dot(d, n)))


def refract(d, n, eta):
    """n faces the ray; None at total internal reflection"""
    c = -dot(d, n)
    k = 1.0 - eta * eta * (1.0 - c * c)
    if k < 0:
        return None
    return add(scale(d, eta), scale(n, eta * c - math.sqrt(k)))


def fresnel(ci, ct, n1, n2):
    rs = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct)
    rp = (n1 * ct - n2 * ci) / (n1 * ct + n2 * ci)
    return 0.5 * (rs * rs + rp * rp)


def shade(p, n, view, mat, me):
    """direct light: a shadow ray for each lamp"""
    total = (0.0, 0.0, 0.0)
    for light in LIGHTS:
        to_light = sub(light.pos, p)
        dist = math.sqrt(dot(to_light, to_light))
        l = scale(to_light, 1.0 / dist)
        cos = dot(n, l)
        if cos <= 0:
            continue
        o = add(p, scale(l, EPS))
        t, blocker = nearest(o, l)
        blocked = blocker is not None and t < dist
        f = scale(mat.albedo(p), mat.kd / math.pi)
        if mat.ks > 0:
            h = norm(add(l, view))
            spec = mat.ks * (mat.shininess + 8) / (8 * math.pi) * max(0.0, dot(n, h)) ** mat.shininess
            f = add(f, (spec, spec, spec))
        weight = scale(f, cos)
        arriving = (0.0, 0.0, 0.0) if blocked else scale(light.intensity, 1.0 / (dist * dist))
        total = add(total, mul(weight, arriving))
        write(ray=new_id(), parent=me, kind="shadow", origin=o, direction=l, end=dist, light=light.name,
              t=t if blocked else None, by=blocker.name if blocked else None,
              f=f, cos=cos, weight=weight, radiance=arriving)
    return total


def trace(o, d, depth, parent=None, kind="camera", weight=None, **more):
    if depth > MAX_DEPTH:
        return (0.0, 0.0, 0.0)
    me = new_id()
    fields = dict(ray=me, kind=kind, origin=o, direction=d)
    if parent is not None:
        fields.update(parent=parent, weight=weight)
    fields.update(more)
    t, obj = nearest(o, d)
    if obj is None:
        up = max(0.0, d[1])
        sky = (0.35 + 0.1 * up, 0.45 + 0.15 * up, 0.6 + 0.3 * up)
        write(t=None, radiance=sky, **fields)
        return sky

    p = add(o, scale(d, t))
    normal = obj.normal(p)
    mat = obj.material
    entering = dot(d, normal) < 0
    n = normal if entering else scale(normal, -1.0)
    view = scale(d, -1.0)

    color = (0.0, 0.0, 0.0)
    ambient = (0.0, 0.0, 0.0)
    if mat.kd > 0 or mat.ks > 0:
        ambient = scale(mat.albedo(p), AMBIENT * mat.kd)
        color = add(color, ambient)
        color = add(color, shade(p, n, view, mat, me))

    if mat.mirror > 0:
        r = reflect(d, n)
        back = trace(add(p, scale(r, EPS)), r, depth + 1, me, "reflected", mat.mirror)
        color = add(color, scale(back, mat.mirror))

    if mat.ior is not None:
        n1, n2 = (1.0, mat.ior) if entering else (mat.ior, 1.0)
        tr = refract(d, n, n1 / n2)
        if tr is None:
            R = 1.0
        else:
            R = fresnel(-dot(d, n), -dot(tr, n), n1, n2)
        T = 1.0 - R
        r = reflect(d, n)
        back = trace(add(p, scale(r, EPS)), r, depth + 1, me, "reflected", R)
        color = add(color, scale(back, R))
        if tr is not None:
            through = trace(add(p, scale(tr, EPS)), tr, depth + 1, me, "transmitted", T, eta_from=n1, eta_to=n2)
            color = add(color, scale(through, T))

    write(t=t, point=p, normal=normal, object=obj.name, direct=ambient, radiance=color, **fields)
    return color


def camera_ray(x, y):
    forward = norm(sub(TARGET, EYE))
    right = norm(cross(forward, (0.0, 1.0, 0.0)))
    up = cross(right, forward)
    half = math.tan(math.radians(FOV) / 2)
    sx = (2.0 * (x + 0.5) / W - 1.0) * half * W / H
    sy = (1.0 - 2.0 * (y + 0.5) / H) * half
    return EYE, norm(add(forward, add(scale(right, sx), scale(up, sy))))


def byte(v):
    return max(0, min(255, int(255 * max(0.0, v) ** (1 / 2.2) + 0.5)))


def main():
    global pixel, counter
    if LOG:
        LOG.write(json.dumps({"rays": 1, "program": "whitted.py", "size": [W, H]}) + "\n")
        for obj in OBJECTS:
            LOG.write(json.dumps({"object": obj.name, **obj.words()}) + "\n")
        for light in LIGHTS:
            LOG.write(json.dumps({"lamp": light.name, "point": light.pos}) + "\n")
    out = ["P3", f"{W} {H}", "255"]
    for y in range(H):
        for x in range(W):
            pixel = [x, y] if LOG and x % EVERY == 0 and y % EVERY == 0 else None
            counter = 0
            o, d = camera_ray(x, y)
            c = trace(o, d, 0)
            out.append("%d %d %d" % (byte(c[0]), byte(c[1]), byte(c[2])))
    sys.stdout.write("\n".join(out) + "\n")


main()
