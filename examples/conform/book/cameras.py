"""Rays of cameras (ch. 8 to 12). Rows are counted from the bottom in the book, from the top in a question."""
import math

from numbers_as_in_c import add, cross, dot, in_frame, over, root, sub, times, unit
from unsupported import Unsupported


def frame(camera):
    """u, v, w (ch. 9), with the two views straight down and straight up set by hand."""
    eye, at = camera["eye"], camera.get("look_at", [0, 0, 0])
    if eye[0] == at[0] and eye[2] == at[2]:
        above = eye[1] > at[1]
        return ([0, 0, 1], [1, 0, 0], [0, 1, 0]) if above else ([1, 0, 0], [0, 0, 1], [0, -1, 0])
    w = unit(sub(eye, at))
    u = unit(cross(camera.get("up", [0, 1, 0]), w))
    return u, cross(w, u), w


def pinhole(lens, p, q):
    return [0, 0], [*p, -lens["distance"]]


def thin_lens(lens, p, q):
    """From a point of the lens to the point of the focal plane that the pixel's own line meets (ch. 10)."""
    f = lens["focal_distance"]
    at = times(lens["lens_radius"], q.get("lens", [0, 0]))
    return at, [x * f / lens["distance"] - y for x, y in zip(p, at)] + [-f]


def fisheye(lens, p, q):
    """ψ = r ψ_max (ch. 11). As printed, the sine and cosine of α are y/r and x/r: 0/0 in the middle of the picture."""
    if lens.get("rectangular"):
        raise Unsupported("a rectangular fisheye: an exercise")
    x, y = normalised(p, q)
    r_squared = x * x + y * y
    if r_squared > 1:
        return None
    r = root(r_squared)
    psi = r * math.radians(lens["fov"] / 2)
    return [0, 0], [math.sin(psi) * over(x, r), math.sin(psi) * over(y, r), -math.cos(psi)]


def spherical_panorama(lens, p, q):
    """Longitude and latitude (ch. 11)."""
    x, y = normalised(p, q)
    phi = math.pi - x * math.radians(lens["horizontal_fov"] / 2)
    theta = math.pi / 2 - y * math.radians(lens["vertical_fov"] / 2)
    return [0, 0], [math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi)]


def normalised(p, q):
    image = q["image"]
    s = image.get("pixel_size", 1)
    return [2 / (s * image["width"]) * p[0], 2 / (s * image["height"]) * p[1]]


LENSES = {f.__name__: f for f in (pinhole, thin_lens, fisheye, spherical_panorama)}


def film_point(q, zoom):
    """s (c − h/2 + place) with the pixel's size s over the zoom (ch. 8, 9); h/2 is a real number."""
    image, (column, row), place = q["image"], q["pixel"], q.get("place", [0.5, 0.5])
    s = image.get("pixel_size", 1) / zoom
    row = image["height"] - 1 - row
    return [s * (column - 0.5 * image["width"] + place[0]), s * (row - 0.5 * image["height"] + place[1])]


def camera_ray(q):
    camera = q["camera"]
    (name, lens), = camera["lens"].items()
    if name not in LENSES or camera.get("roll"):
        raise Unsupported("a roll angle: an exercise" if name in LENSES else name)
    u, v, w = frame(camera)
    eye, p = camera["eye"], film_point(q, lens.get("zoom", 1))
    if "stereo" in camera:
        if name != "pinhole":
            raise Unsupported(f"a stereo pair of {name}")
        eye, p = moved(camera, q["eye"], eye, p, u)
    found = LENSES[name](lens, p, q)
    if found is None:
        return {"origin": None, "direction": None}
    at, d = found
    return {"origin": in_frame_from(eye, at, u, v), "direction": unit(in_frame(d, u, v, w))}


def in_frame_from(eye, at, u, v):
    return add(eye, add(times(at[0], u), times(at[1], v)))


def moved(camera, which, eye, p, u):
    """Half the separation r tan(β/2) to a side, and the pixel's x as much to the other (ch. 12)."""
    between = sub(eye, camera.get("look_at", [0, 0, 0]))
    x = root(dot(between, between)) * math.tan(math.radians(camera["stereo"]["separation"]) / 2)
    x = x if which == "left" else -x
    return add(eye, times(-x, u)), [p[0] + x, p[1]]
