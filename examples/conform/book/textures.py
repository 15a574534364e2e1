"""Texture coordinates (ch. 29) and the 3D checker (ch. 30)."""
import math

from numbers_as_in_c import arccos, over, root
from shapes import angle
from unsupported import Unsupported


def square(x, y, z):
    return [(z + 1) / 2, (x + 1) / 2]


def cylindrical(x, y, z):
    return [angle(x, z) / (2 * math.pi), (y + 1) / 2]


def spherical(x, y, z):
    return [angle(x, z) / (2 * math.pi), 1 - arccos(y) / math.pi]


def probe(x, y, alpha):
    d, r = root(x * x + y * y), alpha / math.pi
    return [(1 + over(r * x, d)) / 2, (1 + over(r * y, d)) / 2]


def light_probe(x, y, z):
    return probe(x, y, arccos(z))


def panoramic(x, y, z):
    return probe(x, y, arccos(-z))


MAPPINGS = {f.__name__: f for f in (square, cylindrical, spherical, light_probe, panoramic)}


def mapping(q):
    if q["mapping"] not in MAPPINGS:
        raise Unsupported(q["mapping"])
    return MAPPINGS[q["mapping"]](*q["point"])


def texture(q):
    """Cubes of alternating colours (Listing 30.2). As printed, the offset is a length, whatever the size of the cubes."""
    (kind, data), = q["texture"].items()
    colors = [data.get("color1", [1, 1, 1]), data.get("color2", [0.5, 0.5, 0.5])]
    if kind != "checker3d" or not all(isinstance(color, list) for color in colors):
        raise Unsupported(kind)
    epsilon, size = -0.000187453738, data.get("size", 1)
    cells = sum(math.floor((x + epsilon) / size) for x in q.get("point", [0, 0, 0]))
    return colors[cells % 2]
