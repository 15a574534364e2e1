#!/usr/bin/env python3
"""A lamp and a map that people write, for `groundtruth laws`: both right.

Run: groundtruth laws -- python3 examples/laws/lights.py
     groundtruth laws -- python3 examples/laws/lights.py "no d²"

The second makes a mistake: the words that follow name it (see `is_made`)."""
import math
import sys

import init

MISTAKE = " ".join(sys.argv[1:])

# A lamp of sides 2 and 1 in the plane y = 2, which shines down; the unit disk, from the square.
SUBJECTS = [
    {"name": "lamp", "kind": "light", "points": [[-2, -1, -2], [2, 1.5, 2]],
     "parameters": {"radiance": [1, 20]}, "claims": {"sampling": "area"}},
    {"name": "disk", "kind": "map", "claims": {"domain": "disk", "invertible": True, "stratified": True}},
]
AREA = 2


def is_made(mistake):
    return mistake == MISTAKE


def seen(p, origin, w):
    """What comes from the direction w: radiance, pdf and distance; None where the lamp is not."""
    t = (2 - origin[1]) / w[1] if w[1] > 0 else 0
    x, z = origin[0] + t * w[0], origin[2] + t * w[2]
    if t <= 0 or abs(x) > 1 or abs(z) > 0.5:
        return None
    squared = 1 if is_made("no d²") else t * t
    return p["radiance"], squared / (AREA * w[1]), t


def evaluate(p, origin, directions):
    found = [seen(p, origin, w) or (0, 0, None) for w in directions]
    return dict(zip(("radiance", "pdf", "distance"), map(list, zip(*found))))


def sample(p, origin, u):
    way = [2 * u[0] - 1 - origin[0], 2 - origin[1], u[1] - 0.5 - origin[2]]
    length = math.hypot(*way)
    w = [c / length for c in way]
    found = seen(p, origin, w)
    return found and {"wi": w, "radiance": found[0], "pdf": found[1], "distance": found[2]}


def to_disk(u):
    r, phi = u[0] if is_made("radius without root") else math.sqrt(u[0]), 2 * math.pi * u[1]
    return [r * math.cos(phi), r * math.sin(phi)]


def from_disk(x):
    return [x[0] ** 2 + x[1] ** 2, math.atan2(x[1], x[0]) / (2 * math.pi) % 1]


def answer(question):
    if "list" in question:
        return SUBJECTS
    (kind, data), = question.items()
    if kind == "eval":
        return evaluate(data["parameters"], data["from"], data["wi"])
    if kind == "sample":
        return [sample(data["parameters"], data["from"], u) for u in data["u"]]
    if kind == "pdf":
        return [1 / math.pi for _ in data["x"]]
    return [to_disk(u) for u in data["u"]] if kind == "map" else [from_disk(x) for x in data["x"]]


init.answer = answer

if __name__ == "__main__":
    init.main()
