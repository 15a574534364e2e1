#!/usr/bin/env python3
"""Answers `groundtruth conform` for spheres, planes, triangles, Lambertian surfaces, Fresnel's equations and the
pinhole camera, and says "unsupported" to all else. Every answer is right.

Run: groundtruth conform -- python3 examples/conform/adapter.py"""
import json
import math
import sys
from fractions import Fraction


class Unsupported(Exception):
    pass


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def along(o, t, d):
    return [x + t * y for x, y in zip(o, d)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.hypot(*v)
    return [x / length for x in v]


# Shapes: each gives (t, normal) for all hits on the whole line, ascending. Normals are unit and point outward.


def sphere(shape, o, d):
    f, r = sub(o, shape["center"]), shape["radius"]
    middle = -dot(f, d) / dot(d, d)
    # the point of the line nearest to the centre: b² − ac would lose all digits for a far origin
    nearest = along(f, middle, d)
    p = math.hypot(*nearest)
    if p > r:
        return []
    half = math.sqrt((r - p) * (r + p) / dot(d, d))
    return [(middle + x, unit(along(nearest, x, d))) for x in (-half, half)]


def plane(shape, o, d):
    n = unit(shape["normal"])
    cosine = dot(d, n)
    return [(dot(sub(shape["point"], o), n) / cosine, n)] if cosine != 0 else []


def triangle(shape, o, d):
    v = shape["vertices"]
    # on which side of each edge the ray passes; differences first: the triangle may be small and far away
    sides = [dot(d, cross(sub(v[i - 2], v[i]), sub(o, v[i]))) for i in range(3)]
    if min(sides) < 0 < max(sides):
        return []
    a, b, c = ([Fraction(x) for x in corner] for corner in v)
    # exact: the corners of a thin triangle are almost on one line, and rounding would turn its normal
    normal = [float(x) for x in cross(sub(b, a), sub(c, a))]
    return plane({"point": v[0], "normal": normal}, o, d)


SHAPES = {"sphere": sphere, "plane": plane, "triangle": triangle}


def hits(q, o, d, low, high):
    if "shape" not in q:
        raise Unsupported("a whole scene")
    (kind, shape), = q["shape"].items()
    if kind not in SHAPES or "transform" in q or "inward" in shape:
        raise Unsupported(kind)
    return [{"t": t, "normal": n} for t, n in SHAPES[kind](shape, o, d) if low < t < high]


def intersect(q):
    low, high = (float(end) for end in q.get("span", [0, "inf"]))
    found = hits(q, q["ray"]["origin"], q["ray"]["direction"], low, high)
    if q.get("all"):
        return found
    return found[0] if found else None


def occluded(q):
    if "segment" not in q or "shapes" in q:
        raise Unsupported("occluded along a ray, or by a list of shapes")
    start, end = q["segment"]["from"], q["segment"]["to"]
    return bool(hits(q, start, sub(end, start), 0, 1))


def lobe(q):
    (kind, data), = q["lobe"].items()
    if kind != "lambertian":
        raise Unsupported(kind)
    reflectance = data["reflectance"]
    is_lit = q["wo"][2] > 0
    answer = {"albedo": [x if is_lit else 0 for x in reflectance]}
    if "wi" in q:
        cosine = q["wi"][2] if is_lit and q["wi"][2] > 0 else 0
        answer["f"] = [x / math.pi if cosine > 0 else 0 for x in reflectance]
        answer["pdf"] = cosine / math.pi
    if "u" in q:
        phi, cosine = 2 * math.pi * q["u"][0], math.sqrt(1 - q["u"][1])
        sine = math.sqrt((1 - cosine) * (1 + cosine))
        wi = [sine * math.cos(phi), sine * math.sin(phi), cosine]
        answer["sample"] = {"wi": wi, "weight": reflectance, "pdf": cosine / math.pi} if is_lit else None
    return answer


def fresnel(q):
    eta = q["eta"]
    cos_i = dot(q["wo"], q["n"]) if "wo" in q else q["cos_i"]
    square = ((eta - 1) * (eta + 1) + cos_i * cos_i) / (eta * eta)  # of cos_t; factored: no cancellation near η = 1
    if square < 0:
        return {"reflected": 1, "transmitted": 0, "refracted": None}
    cos_t = math.sqrt(square)
    r_s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t)
    r_p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t)
    reflected = (r_s * r_s + r_p * r_p) / 2
    answer = {"reflected": reflected, "transmitted": 1 - reflected}
    if "wo" in q:
        answer["refracted"] = [-w / eta - (cos_t - cos_i / eta) * n for w, n in zip(q["wo"], q["n"])]
    return answer


def view(q):
    """The pinhole's frame, its distance times its zoom, and the size of the image."""
    camera, image = q["camera"], q["image"]
    if "pinhole" not in camera["lens"] or "stereo" in camera:
        raise Unsupported("this camera")
    lens = camera["lens"]["pinhole"]
    w = unit(sub(camera["eye"], camera.get("look_at", [0, 0, 0])))
    u = unit(cross(camera.get("up", [0, 1, 0]), w))
    v = cross(w, u)
    roll = math.radians(camera.get("roll", 0))
    cosine, sine = math.cos(roll), math.sin(roll)
    u, v = [cosine * x + sine * y for x, y in zip(u, v)], [cosine * y - sine * x for x, y in zip(u, v)]
    size = [image["width"], image["height"], image.get("pixel_size", 1)]
    return u, v, w, lens["distance"] * lens.get("zoom", 1), size


def camera_ray(q):
    u, v, w, distance, (width, height, pixel_size) = view(q)
    (column, row), place = q["pixel"], q.get("place", [0.5, 0.5])
    x = pixel_size * (column + place[0] - width / 2)
    y = pixel_size * (height - 1 - row + place[1] - height / 2)
    direction = [x * a + y * b - distance * c for a, b, c in zip(u, v, w)]
    return {"origin": q["camera"]["eye"], "direction": unit(direction)}


def project(q):
    u, v, w, distance, (width, height, pixel_size) = view(q)
    ahead = sub(q["point"], q["camera"]["eye"])
    depth = -dot(ahead, w)
    if depth <= 0:
        return None
    scale = distance / (depth * pixel_size)
    x, y = width / 2 + scale * dot(ahead, u), height / 2 - scale * dot(ahead, v)
    return {"image": [x, y]} if 0 <= x <= width and 0 <= y <= height else None


QUESTIONS = {f.__name__: f for f in (intersect, occluded, lobe, fresnel, camera_ray, project)}


def reply(line):
    question = json.loads(line)
    number = question.pop("id")
    (name, data), = question.items()
    if name not in QUESTIONS:
        return {"id": number, "unsupported": name}
    try:
        return {"id": number, "answer": QUESTIONS[name](data)}
    except Unsupported as what:
        return {"id": number, "unsupported": str(what)}
    except Exception as error:  # shown on the card, with the question; the next one is answered
        return {"id": number, "error": f"{type(error).__name__}: {error}"}


if __name__ == "__main__":
    for line in sys.stdin:
        # flush: a pipe keeps lines back. Print nothing else here: messages belong to sys.stderr
        print(json.dumps(reply(line)), flush=True)
