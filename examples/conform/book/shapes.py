"""The book's hit functions (ch. 3 and 19), and what the nearest hit and a shadow are (ch. 3 and 16).

A hit function gets the data of a shape, a ray o + t d and ε; it returns t and the normal of the first hit with t > ε,
or None. Normals point outward, as those of the book's convex kinds; its two-sided open kinds turn them to the viewer."""
import math

from numbers_as_in_c import along, cross, dot, over, root, sub, unit
from polynomials import quartic
from transforms import inverse_of, normal_by, point_by, vector_by
from unsupported import Unsupported


def flat_t(point, normal, o, d):
    """(a − o)·n / (d·n), without a case for d·n = 0 (ch. 3)."""
    return over(dot(sub(point, o), normal), dot(d, normal))


def plane(s, o, d, epsilon):
    n = unit(s["normal"])
    t = flat_t(s["point"], n, o, d)
    return (t, n) if t > epsilon else None


def roots(a, b, c):
    """Of a t² + b t + c, from the discriminant b² − 4 a c."""
    disc = b * b - 4 * a * c
    if disc < 0:
        return []
    e = root(disc)
    return [over(-b - e, 2 * a), over(-b + e, 2 * a)]


def sphere_roots(s, o, d):
    from_center = sub(o, s["center"])
    return roots(dot(d, d), 2 * dot(from_center, d), dot(from_center, from_center) - s["radius"] * s["radius"])


def from_sphere_center(s, o, d, t):
    return along(sub(o, s["center"]), t, d)


def sphere(s, o, d, epsilon):
    for t in sphere_roots(s, o, d):
        if t > epsilon:
            return t, [over(x, s["radius"]) for x in from_sphere_center(s, o, d, t)]
    return None


def slabs(low, high, o, d):
    """Where three slabs are entered last and left first, each with its axis, and 1/d (ch. 19, Listing 19.1). 0·∞, of a
    ray in a face, is left to the comparisons."""
    inverse = [over(1.0, x) for x in d]
    enter, leave = [], []
    for i in range(3):
        ts = [(low[i] - o[i]) * inverse[i], (high[i] - o[i]) * inverse[i]]
        near, far = ts if inverse[i] >= 0 else reversed(ts)
        enter.append(near)
        leave.append(far)
    first = 0 if enter[0] > enter[1] else 1
    first = 2 if enter[2] > enter[first] else first
    last = 0 if leave[0] < leave[1] else 1
    last = 2 if leave[2] < leave[last] else last
    return (enter[first], first), (leave[last], last), inverse


def box(s, o, d, epsilon):
    (t0, first), (t1, last), inverse = slabs(s["min"], s["max"], o, d)
    if not (t0 < t1 and t1 > epsilon):
        return None
    t, axis, side = (t0, first, -1.0) if t0 > epsilon else (t1, last, 1.0)
    normal = [0.0, 0.0, 0.0]
    normal[axis] = side if inverse[axis] >= 0 else -side
    return t, normal


def triangle(s, o, d, epsilon):
    """Cramer's rule for v₀ − o = β (v₀ − v₁) + γ (v₀ − v₂) + t d."""
    v0, v1, v2 = s["vertices"]
    (a, e, i), (b, f, j), (c, g, k) = sub(v0, v1), sub(v0, v2), d
    r, h, l = sub(v0, o)
    m, n, p = f * k - g * j, h * k - g * l, f * l - h * j
    q, z = g * i - e * k, e * j - f * i
    inverse = over(1.0, a * m + b * q + c * z)
    beta = (r * m - b * n - c * p) * inverse
    if beta < 0:
        return None
    y = e * l - h * i
    gamma = (a * n + r * q + c * y) * inverse
    if gamma < 0 or beta + gamma > 1:
        return None
    t = (a * p - b * y + r * z) * inverse
    return None if t < epsilon else (t, unit(cross(sub(v1, v0), sub(v2, v0))))


def flat(center, normal, o, d, epsilon, is_inside):
    n = unit(normal)
    t = flat_t(center, n, o, d)
    if t <= epsilon:
        return None
    return (t, n) if is_inside(sub(along(o, t, d), center)) else None


def rectangle(s, o, d, epsilon):
    a, b = s["a"], s["b"]
    return flat(s["corner"], cross(a, b), o, d, epsilon,
                lambda p: 0 <= dot(p, a) <= dot(a, a) and 0 <= dot(p, b) <= dot(b, b))


def disk(s, o, d, epsilon):
    return flat(s["center"], s["normal"], o, d, epsilon, lambda p: dot(p, p) < s["radius"] * s["radius"])


def annulus(s, o, d, epsilon):
    inner, outer = s["inner_radius"], s["outer_radius"]
    return flat(s["center"], s["normal"], o, d, epsilon, lambda p: inner * inner < dot(p, p) < outer * outer)


def cylinder(s, o, d, epsilon, is_on=lambda p: True):
    a = d[0] * d[0] + d[2] * d[2]
    b = 2 * (o[0] * d[0] + o[2] * d[2])
    c = o[0] * o[0] + o[2] * o[2] - s["radius"] * s["radius"]
    for t in roots(a, b, c):
        p = along(o, t, d)
        if t > epsilon and s["y0"] < p[1] < s["y1"] and is_on(p):
            return t, [over(p[0], s["radius"]), 0.0, over(p[2], s["radius"])]
    return None


def torus(s, o, d, epsilon, is_on=lambda p: True):
    """After a test of its bounding box, the smallest root of a quartic."""
    a, b = s["swept_radius"], s["tube_radius"]
    (t0, _), (t1, _), _ = slabs([-a - b, -b, -a - b], [a + b, b, a + b], o, d)
    if not (t0 < t1 and t1 > epsilon):
        return None
    e, g, dd = dot(o, o) - a * a - b * b, dot(o, d), dot(d, d)
    four_a2 = 4 * a * a
    found = quartic(dd * dd, 4 * dd * g, 2 * dd * e + 4 * g * g + four_a2 * d[1] * d[1],
                    4 * g * e + 2 * four_a2 * o[1] * d[1], e * e - four_a2 * (b * b - o[1] * o[1]))
    for t in sorted(found):
        p = along(o, t, d)
        if t > epsilon and is_on(p):
            s_q = dot(p, p) - (a * a + b * b)
            return t, unit([p[0] * s_q, p[1] * (s_q + 2 * a * a), p[2] * s_q])
    return None


# Part objects: the azimuth is measured from +z towards +x. A range is φ_min ≤ φ ≤ φ_max within 0 … 2π; the part objects
# have no case for one that goes through 0, and with φ_min > φ_max they would have no points.


def angle(sine, cosine):
    phi = math.atan2(sine, cosine)
    return phi + 2 * math.pi if phi < 0 else phi


def has_azimuth(s, p):
    low, high = (math.radians(x) for x in s.get("phi", [0, 360]))
    return low <= angle(p[0], p[2]) <= high


def part_sphere(s, o, d, epsilon):
    """Each root in turn: a near one beside the part does not hide the far one."""
    highest, lowest = (s["radius"] * math.cos(math.radians(x)) for x in s.get("theta", [0, 180]))
    for t in sphere_roots(s, o, d):
        p = from_sphere_center(s, o, d, t)
        if t > epsilon and lowest <= p[1] <= highest and has_azimuth(s, p):
            return t, [over(x, s["radius"]) for x in p]
    return None


def part_cylinder(s, o, d, epsilon):
    return cylinder(s, o, d, epsilon, lambda p: has_azimuth(s, p))


def part_annulus(s, o, d, epsilon):
    hit = annulus({"normal": [0, 1, 0], **s}, o, d, epsilon)
    return hit if hit and has_azimuth(s, sub(along(o, hit[0], d), s["center"])) else None


def part_torus(s, o, d, epsilon):
    """The angle around the tube is measured from the outermost line upward; its range may go through 0."""
    low, high = (math.radians(x) for x in s.get("theta", [0, 360]))

    def is_on(p):
        theta = angle(p[1], math.hypot(p[0], p[2]) - s["swept_radius"])
        in_range = low <= theta <= high if low <= high else theta >= low or theta <= high
        return in_range and has_azimuth(s, p)

    return torus(s, o, d, epsilon, is_on)


def instance(s, o, d, epsilon):
    """The ray goes back through the transformation, its direction is not normalised, and so t is kept (ch. 21)."""
    back = inverse_of(s["transform"])
    hit = hit_function(s["of"])(point_by(back, o), vector_by(back, d))
    return hit and (hit[0], unit(normal_by(back, hit[1])))


# kEpsilon is a constant of each class in the sample code. (Section 3.4.1 has 1e-6, as an example.)
KINDS = {
    **{f.__name__: (f, 0.001) for f in (plane, sphere, box, triangle, rectangle, disk, annulus)},
    "open_cylinder": (cylinder, 0.001),
    **{f.__name__: (f, 0.0001) for f in (torus, part_sphere, part_cylinder, part_annulus, part_torus)},
    "instance": (instance, None),
}
only_epsilon = None  # another ε for all kinds, to see what ε alone does
K_HUGE_VALUE = 1e10


def hit_function(kind):
    (name, s), = kind.items()
    if name not in KINDS:
        raise Unsupported(name)
    if s.get("normals") or s.get("inward"):
        raise Unsupported(f"a smooth triangle, or a concave {name}")
    low, high = s.get("phi", [0, 360])
    if not 0 <= low <= high <= 360:
        raise Unsupported("a range of φ through 0: the book turns an instance")
    of, epsilon = KINDS[name]
    return lambda o, d: of(s, o, d, epsilon if only_epsilon is None else only_epsilon)


def hit_function_of(q):
    if "shape" not in q:
        raise Unsupported("a whole scene")
    return hit_function({"instance": {"of": q["shape"], "transform": q["transform"]}} if "transform" in q else q["shape"])


def intersect(q):
    """The nearest hit of the loop over all objects, which begins with t = kHugeValue: infinite t and NaN are none. There
    is no span: in its place stands ε."""
    if q.get("all"):
        raise Unsupported("all hits: the book has the nearest one")
    hit = hit_function_of(q)(q["ray"]["origin"], q["ray"]["direction"])
    return {"t": hit[0], "normal": hit[1]} if hit and hit[0] < K_HUGE_VALUE else None


def occluded(q):
    """A shadow ray to a point light (ch. 16): something is hit at t < |location − o|."""
    if "segment" not in q:
        raise Unsupported("occluded along a ray")
    start, end = q["segment"]["from"], q["segment"]["to"]
    to_light = sub(end, start)
    hit = hit_function_of(q)(start, unit(to_light))
    return bool(hit) and hit[0] < root(dot(to_light, to_light))
