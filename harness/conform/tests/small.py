#!/usr/bin/env python3
"""A small ray tracer of somebody else: answers `radiance` of whole scenes, and says "unsupported" to all else.

    small.py [--rich] [MISTAKE]

It has spheres, planes, matte and Phong surfaces (no `cs`), ambient, point and directional lights without a fall-off, and no
switches: what chapters 14 to 16 bring. With --rich it has boxes, rectangles, `cs`, fall-offs, mirrors, checkers, lamps that are
sampled, and a path tracer, too. A mistake is one of the lines with `M(...)`."""
import json
import math
import random
import sys

RICH = "--rich" in sys.argv
MISTAKE = ([a for a in sys.argv[1:] if a != "--rich"] + [""])[0]
PI = math.pi


def M(*names):
    return MISTAKE in names


class Unsupported(Exception):
    pass


def only(table, known, what):
    for key in table:
        if key not in known:
            raise Unsupported(f"{what} `{key}`")


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def mul(a, b): return [x * y for x, y in zip(a, b)]
def scale(s, a): return [s * x for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]
def unit(a): return scale(1 / math.sqrt(dot(a, a)), a)


def color(x, p=None):
    if isinstance(x, (int, float)):
        return [x, x, x]
    if isinstance(x, dict):
        (kind, data), = x.items()
        if not (RICH and kind == "checker3d"):
            raise Unsupported(f"texture `{kind}`")
        size = 1.0 if M("checker without size") else data["size"]
        cell = int if M("checker truncated") else math.floor
        even = sum(cell(c / size - 0.000187453738) for c in p) % 2 == 0
        if M("checker colours exchanged"):
            even = not even
        return color(data["color1" if even else "color2"])
    if M("blue first"):
        return [x[2], x[1], x[0]]
    return list(x)


# shapes: hit(o, d) gives every t on the line with its normal

def sphere(s, o, d):
    only(s, ("center", "radius"), "field of sphere")
    f, r = sub(o, s["center"]), s["radius"]
    a, b, c = dot(d, d), 2 * dot(f, d), dot(f, f) - r * r
    if M("a is taken for 1"):
        a = 1.0
    disc = b * b - 4 * a * c
    if disc < 0:
        return []
    roots = [(-b - math.sqrt(disc)) / (2 * a), (-b + math.sqrt(disc)) / (2 * a)]
    if M("far root"):
        roots = roots[1:]
    if M("near root alone"):
        roots = roots[:1]
    n = lambda t: sub(add(o, scale(t, d)), s["center"])
    if M("normal not of unit length"):
        return [(t, n(t)) for t in roots]
    if M("normal without the centre"):
        return [(t, scale(1 / r, add(o, scale(t, d)))) for t in roots]
    if M("normal inward"):
        return [(t, scale(-1 / r, n(t))) for t in roots]
    return [(t, scale(1 / r, n(t))) for t in roots]


def plane(s, o, d):
    n = unit(s["normal"])
    if M("plane normal turned over"):
        n = scale(-1, n)
    below = dot(d, n)
    if below == 0:
        return []
    return [(dot(sub(s["point"], o), n) / below, n)]


def rectangle(s, o, d):
    n = unit(cross(s["a"], s["b"]))
    if dot(d, n) == 0:
        return []
    t = dot(sub(s["corner"], o), n) / dot(d, n)
    p = sub(add(o, scale(t, d)), s["corner"])
    inside = all(0 <= dot(p, e) <= dot(e, e) for e in (s["a"], s["b"]))
    return [(t, n)] if inside else []


def disk(s, o, d):
    n = unit(s["normal"])
    if dot(d, n) == 0:
        return []
    t = dot(sub(s["center"], o), n) / dot(d, n)
    p = sub(add(o, scale(t, d)), s["center"])
    return [(t, n)] if dot(p, p) <= s["radius"] ** 2 else []


def box(s, o, d):
    near, far, n0, n1 = -math.inf, math.inf, None, None
    for i in range(3):
        if d[i] == 0:
            if not s["min"][i] <= o[i] <= s["max"][i]:
                return []
            continue
        t0, t1 = (s["min"][i] - o[i]) / d[i], (s["max"][i] - o[i]) / d[i]
        n = [0.0] * 3
        n[i] = 1.0
        a, b = scale(-1, n), n
        if t0 > t1:
            t0, t1, a, b = t1, t0, b, a
        if t0 > near:
            near, n0 = t0, a
        if t1 < far:
            far, n1 = t1, b
    return [(near, n0), (far, n1)] if near < far else []


def shapes():
    return {"sphere": sphere, "plane": plane, **({"rectangle": rectangle, "disk": disk, "box": box} if RICH else {})}


EPS = 1e-7
if M("offset far too large"):
    EPS = 0.25
if M("no offset"):
    EPS = 0.0


def hit(objects, o, d, most=math.inf):
    best = None
    for index, thing in enumerate(objects):
        (kind, s), = thing["shape"].items()
        if kind not in shapes():
            raise Unsupported(kind)
        for t, n in shapes()[kind](s, o, d):
            nearer = best is None or t < best[0] or M("last object wins")
            if t > EPS and t < most and nearer:
                best = (t, n, thing, index)
                break
    return best


class Scene:
    def __init__(self, s):
        only(s, ("image", "camera", "tracer", "lights", "materials", "objects", "background"), "field of scene")
        tracer = s.get("tracer", "ray_cast")
        (self.tracer, data), = [(tracer, {})] if isinstance(tracer, str) else tracer.items()
        known = ("ray_cast",) + (("whitted", "path_trace") if RICH else ())
        if self.tracer not in known:
            raise Unsupported(f"tracer `{self.tracer}`")
        self.depth = data.get("max_depth", 0)
        if M("one depth less"):
            self.depth -= 1
        self.sky = color(s.get("background", 0))
        if M("background black"):
            self.sky = [0, 0, 0]
        self.objects = s["objects"]
        for thing in self.objects:
            only(thing, ("name", "material", "shape"), "field of object")
        self.lights = []
        self.ambient = [0, 0, 0]
        for item in s["lights"]:
            only(item, ("name", "source"), "field of light")
            (kind, data), = item["source"].items()
            if kind == "ambient":
                self.ambient = add(self.ambient, scale(data.get("ls", 1), color(data.get("color", 1))))
                continue
            if kind not in ("point", "directional") + (("area",) if RICH else ()):
                raise Unsupported(f"light `{kind}`")
            if data.get("attenuation", 0) != 0 and not RICH:
                raise Unsupported("attenuation")
            self.lights.append((kind, data))
        if M("ambient light is left out"):
            self.ambient = [0, 0, 0]
        if M("first light alone"):
            self.lights = self.lights[:1]
        if M("last light alone"):
            self.lights = self.lights[-1:]
        self.materials = {}
        for item in s["materials"]:
            only(item, ("name", "recipe") + (("two_sided",) if RICH else ()), "field of material")
            (kind, data), = item["recipe"].items()
            if item.get("two_sided"):
                raise Unsupported("two_sided")
            if kind not in ("matte", "phong") + (("reflective", "emissive") if RICH else ()):
                raise Unsupported(kind)
            if kind == "phong" and "cs" in data and not RICH:
                raise Unsupported("cs")
            self.materials[item["name"]] = (kind, data)

    # how much of the light of a source is there: direction, distance, radiance
    def arriving(self, kind, data, p, rng):
        if kind == "area":
            thing = next(o for o in self.objects if o["name"] == data["object"])
            (shape, s), = thing["shape"].items()
            if shape == "rectangle":
                q = add(s["corner"], add(scale(rng.random(), s["a"]), scale(rng.random(), s["b"])))
                n = cross(s["a"], s["b"])
                area, n = math.sqrt(dot(n, n)), unit(n)
                if M("lamp area 1"):
                    area = 1.0
            elif shape == "disk":
                n = unit(s["normal"])
                u = unit(cross(n, [0.0036, 1, 0.007] if abs(n[1]) < 0.9 else [1, 0, 0]))
                v, phi, r = cross(n, u), 2 * PI * rng.random(), s["radius"] * math.sqrt(rng.random())
                q = add(s["center"], add(scale(r * math.cos(phi), u), scale(r * math.sin(phi), v)))
                area = PI * s["radius"] ** 2
                if M("disk has the area of its square"):
                    area = 4 * s["radius"] ** 2
            else:
                raise Unsupported(f"lamp `{shape}`")
            way = sub(q, p)
            d2 = dot(way, way)
            wi = unit(way)
            cosine = -dot(wi, n)
            if cosine <= 0:
                return wi, math.sqrt(d2), [0, 0, 0]
            if M("lamp without its cosine"):
                cosine = 1.0
            if M("lamp without its distance"):
                d2 = 1.0
            e = self.materials[thing["material"]][1]
            L = scale(e.get("ls", 1), color(e.get("ce", 1)))
            return wi, math.sqrt(dot(way, way)) * (1 - 1e-6), scale(area * cosine / d2, L)
        L = scale(data.get("ls", 1), color(data.get("color", 1)))
        if M("colour of lamps is left out"):
            L = scale(data.get("ls", 1), [1, 1, 1])
        if M("ls of lamps is left out"):
            L = color(data.get("color", 1))
        if kind == "directional":
            to = data["direction"]
            if M("sun not normalised"):
                return to, math.inf, L
            if M("sun from the other side"):
                to = scale(-1, to)
            return unit(to), math.inf, L
        way = sub(data["location"], p)
        far = math.sqrt(dot(way, way))
        k = data.get("attenuation", 0)
        if M("1/d² everywhere"):
            k = 2
        if M("1/d everywhere"):
            k = 1
        if M("way to the lamp not normalised"):
            return way, 1.0, L
        return unit(way), far, scale(far ** -k, L)

    def is_blocked(self, p, wi, far):
        if M("no shadows"):
            return False
        if M("shadow ray does not end at its lamp"):
            far = math.inf
        if M("shadow ray ends at the square of the distance"):
            far = far * far
        if M("shadow ray ends at t = 1"):
            far = 1.0
        objects = self.objects
        if M("planes cast no shadow"):
            objects = [o for o in objects if "plane" not in o["shape"]]
        if M("spheres cast no shadow"):
            objects = [o for o in objects if "sphere" not in o["shape"]]
        if M("first object alone casts shadows"):
            objects = objects[:1]
        return hit(objects, p, wi, far) is not None

    def shade(self, p, n, wo, material, rng, ambient=True):
        kind, data = material
        mirror = data if kind == "reflective" else None
        if mirror is not None:
            data = mirror.get("phong", {"ka": 0, "kd": 0, "cd": 0})
            kind = "phong" if "ks" in data else "matte"
        if kind == "emissive":
            data, kind = data.get("matte", {"kd": 0, "cd": 0}), "matte"
        cd = color(data.get("cd", 1), p)
        if M("colour of the surface is left out"):
            cd = [1, 1, 1]
        ka, kd = data.get("ka", 0), data.get("kd", 0)
        if isinstance(ka, dict) or isinstance(kd, dict):
            raise Unsupported("amount")
        if M("kd for ka"):
            ka = kd
        if M("ka for kd"):
            kd = ka
        if M("kd is left out"):
            kd = 1.0
        L = mul(scale(ka, cd), self.ambient) if ambient else [0, 0, 0]
        if M("ambient over π"):
            L = scale(1 / PI, L)
        if M("ambient without the colour of the surface") and ambient:
            L = scale(ka, self.ambient)
        if M("viewer from the other side"):
            wo = scale(-1, wo)
        lit = [0, 0, 0]
        dark = False
        for light in self.lights:
            wi, far, Li = self.arriving(*light, p, rng)
            cosine = dot(n, wi)
            if M("cosine without its sign"):
                cosine = abs(cosine)
            if cosine <= 0 and not M("negative light"):
                continue
            if self.is_blocked(p, wi, far):
                dark = True
                if M("half light in shadow"):
                    Li = scale(0.5, Li)
                else:
                    continue
            f = scale(kd / PI, cd)
            if M("no 1/π"):
                f = scale(kd, cd)
            if M("1/π twice"):
                f = scale(kd / PI / PI, cd)
            high = [0, 0, 0]
            if kind == "phong":
                ks, cs, e = data.get("ks", 0), color(data.get("cs", 1)), data.get("exponent", 1)
                if isinstance(ks, dict):
                    raise Unsupported("amount")
                nwi = dot(n, wi)
                r = sub(scale(2 * nwi, n), wi)
                if M("r without its factor 2"):
                    r = sub(scale(nwi, n), wi)
                if M("r with the wrong sign"):
                    r = scale(-1, r)
                if M("viewing direction not normalised"):
                    wo = self.raw
                shine = dot(r, wo)
                if M("half vector"):
                    shine = dot(unit(add(wi, wo)), n)
                if M("highlight without its limit at 0"):
                    shine = abs(shine)
                if M("exponent larger by 1"):
                    e += 1
                if M("exponent is whole"):
                    e = int(e)
                if M("exponent four times as large"):
                    e *= 4
                if M("ks is left out"):
                    ks = 1.0
                if M("kd for ks"):
                    ks = kd
                if M("highlight in the surface's colour"):
                    cs = cd
                high = scale(ks * max(shine, 0) ** e, cs) if shine > 0 else [0, 0, 0]
                if M("no highlight"):
                    high = [0, 0, 0]
            if M("light is added twice"):
                Li = scale(2, Li)
            part = mul(scale(cosine, add(f, high)), Li)
            if M("no cosine"):
                part = mul(add(f, high), Li)
            if M("highlight without its cosine"):
                part = add(mul(scale(cosine, f), Li), mul(high, Li))
            if M("square of the cosine"):
                part = scale(cosine, part)
            lit = part if M("lights overwrite each other") else add(lit, part)
        if M("lights are averaged") and self.lights:
            lit = scale(1 / len(self.lights), lit)
        if M("ambient light in shadow is black") and dark:
            L = [0, 0, 0]
        return add(L, lit)

    def radiance(self, o, d, depth, rng):
        self.raw = scale(-1, d)
        d = unit(d)
        found = hit(self.objects, o, d)
        if found is None:
            return self.sky
        t, n, thing, _ = found
        p, wo = add(o, scale(t, d)), scale(-1, d)
        kind, data = material = self.materials[thing["material"]]
        front = dot(n, wo) > 0
        if not front and kind != "emissive" and "sphere" not in thing["shape"] and "box" not in thing["shape"]:
            raise Unsupported("a back side")
        if kind == "emissive":
            return scale(data.get("ls", 1), color(data.get("ce", 1))) if front else [0, 0, 0]
        out = self.shade(p, n, wo, material, rng)
        if kind == "reflective" and depth < self.depth:
            cosine = dot(n, wo)
            r = sub(scale(2 * cosine, n), wo)
            if M("mirror direction without its factor 2"):
                r = sub(scale(cosine, n), wo)
            w = scale(data.get("kr", 1), color(data.get("cr", 1)))
            if M("kr is left out"):
                w = color(data.get("cr", 1))
            if M("cr is left out"):
                w = scale(data.get("kr", 1), [1, 1, 1])
            if M("mirror times the cosine"):
                w = scale(cosine, w)
            if M("mirror in place of the surface"):
                out = [0, 0, 0]
            out = add(out, mul(w, self.radiance(p, r, depth + 1, rng)))
        return out

    # a path, without samples of lights
    def path(self, o, d, depth, rng):
        d = unit(d)
        found = hit(self.objects, o, d)
        if found is None:
            return self.sky
        t, n, thing, _ = found
        p, wo = add(o, scale(t, d)), scale(-1, d)
        kind, data = self.materials[thing["material"]]
        L = [0, 0, 0]
        inside = dot(n, wo) < 0
        if kind == "emissive":
            if inside and "sphere" not in thing["shape"]:
                return L
            L = scale(data.get("ls", 1), color(data.get("ce", 1)))
            data = data.get("matte", {"kd": 0})
        elif kind != "matte":
            raise Unsupported(f"paths from `{kind}`")
        if inside:
            n = scale(-1, n)
        if depth >= self.depth or data.get("kd", 0) == 0:
            return L
        u1, phi = rng.random(), 2 * PI * rng.random()
        cosine = 1 - u1 if M("paths even over the hemisphere") else math.sqrt(1 - u1)
        sine = math.sqrt(max(0, 1 - cosine * cosine))
        a = unit(cross(n, [0, 1, 0.1] if abs(n[1]) < 0.9 else [1, 0, 0]))
        b = cross(n, a)
        wi = add(scale(cosine, n), add(scale(sine * math.cos(phi), a), scale(sine * math.sin(phi), b)))
        f = scale(data["kd"], color(data.get("cd", 1)))
        if M("1/π twice in a path"):
            f = scale(1 / PI, f)
        if M("no 1/π in a path"):
            f = scale(PI, f)
        if M("the cosine twice in a path"):
            f = scale(cosine, f)
        return add(L, mul(f, self.path(p, wi, depth + 1, rng)))


def radiance(q):
    only(q, ("scene", "ray", "replicas") + (("samples", "seed") if RICH else ()), "field of radiance")
    scene, ray = Scene(q["scene"]), q["ray"]
    rng, count = random.Random(q.get("seed", 1)), q.get("samples", 1)
    of = scene.path if scene.tracer == "path_trace" else scene.radiance
    total = [0, 0, 0]
    for _ in range(count):
        total = add(total, of(ray["origin"], ray["direction"], 0, rng))
    mean = scale(1 / count, total)
    if M("clamped at 1"):
        mean = [min(x, 1) for x in mean]
    if M("gamma 2.2"):
        mean = [max(x, 0) ** (1 / 2.2) for x in mean]
    if M("red and green exchanged"):
        mean = [mean[1], mean[0], mean[2]]
    return {"mean": mean}


for line in sys.stdin:
    asked = json.loads(line)
    reply = {"id": asked["id"]}
    try:
        if "radiance" not in asked:
            raise Unsupported("the question")
        reply["answer"] = radiance(asked["radiance"])
    except Unsupported as why:
        reply["unsupported"] = str(why)
    print(json.dumps(reply), flush=True)
