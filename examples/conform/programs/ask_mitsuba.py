#!/usr/bin/env python3
"""Mitsuba 3 (in single precision) answers `groundtruth conform`: spheres, disks, rectangles, cylinders, boxes as its
cubes, triangles, meshes, and instances of these; diffuse surfaces, mirrors and dielectrics; Fresnel's equations;
perspective and orthographic cameras; point and directional lights; Shirley and Chiu's map.

Needs: pip install mitsuba
Run: groundtruth conform -- python3 examples/conform/programs/ask_mitsuba.py [scalar_rgb or another variant]"""
import json
import math
import sys

import mitsuba as mi

mi.set_variant(sys.argv[1] if len(sys.argv) > 1 else "scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)  # its warnings go to the standard output
T = mi.ScalarTransform4f
NEAR = 0.01  # of cameras


class Unsupported(Exception):
    pass


def one(x):
    """A number; of the arrays of other variants than scalar ones, the first. NaN is no JSON."""
    x = float(x) if isinstance(x, (int, float)) else float(x[0])
    return "nan" if math.isnan(x) else x


def three(v):
    return [one(v[i]) for i in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def rgb(value):
    return {"type": "rgb", "value": value if isinstance(value, list) else [value] * 3}


def mesh(vertices, faces):
    made = mi.Mesh("mesh", len(vertices), len(faces))
    values = mi.traverse(made)
    values["vertex_positions"] = [x for vertex in vertices for x in vertex]
    values["faces"] = [i for face in faces for i in face]
    values.update()
    return made


def step(data):
    (kind, x), = data.items()
    if kind == "matrix":
        return T(x)
    if kind == "translate":
        return T().translate(x)
    if kind == "scale":
        return T().scale(x)
    if kind == "shear":
        a, b, c, d, e, f = x
        return T([[1, a, b, 0], [c, 1, d, 0], [e, f, 1, 0], [0, 0, 0, 1]])
    if kind == "rotate_about":
        p, axis = x["point"], [y / math.hypot(*x["direction"]) for y in x["direction"]]
        return T().translate(p) @ T().rotate(axis, x["degrees"]) @ T().translate([-y for y in p])
    raise Unsupported(kind)


def placed(asked):
    """The transform of an instance, or of instances in one another, and what is in it."""
    place = T()
    while "instance" in asked:
        for data in reversed(asked["instance"]["transform"]):
            place = place @ step(data)
        asked = asked["instance"]["of"]
    return place, asked


def shape(asked):
    (kind, data), = asked.items()
    if data.get("inward"):
        raise Unsupported("inward")
    if kind == "sphere":
        return {"type": "sphere", "center": data["center"], "radius": data["radius"]}
    if kind == "disk":
        # from the unit disk, whose normal is z
        length, r = math.hypot(*data["normal"]), data["radius"]
        n = [x / length for x in data["normal"]]
        x = cross(n, [float(i == min(range(3), key=lambda j: abs(n[j]))) for i in range(3)])
        x = [r * a / math.hypot(*x) for a in x]
        columns = zip(x, cross(n, x), n, data["center"])
        return {"type": "disk", "to_world": T([list(row) for row in columns] + [[0, 0, 0, 1]])}
    if kind == "rectangle":
        # from the square of x and y from −1 to 1
        a, b = ([x / 2 for x in data[name]] for name in "ab")
        middle = [p + x + y for p, x, y in zip(data["corner"], a, b)]
        columns = zip(a, b, cross(a, b), middle)
        return {"type": "rectangle", "to_world": T([list(row) for row in columns] + [[0, 0, 0, 1]])}
    if kind == "open_cylinder":
        return {"type": "cylinder", "p0": [0, data["y0"], 0], "p1": [0, data["y1"], 0], "radius": data["radius"]}
    if kind == "box":
        middle = [(x + y) / 2 for x, y in zip(data["min"], data["max"])]
        half = [(y - x) / 2 for x, y in zip(data["min"], data["max"])]
        return {"type": "cube", "to_world": T().translate(middle) @ T().scale(half)}
    if kind == "triangle":
        return mesh(data["vertices"], [[0, 1, 2]])
    if kind == "mesh" and "vertices" in data:
        return mesh(data["vertices"], data["triangles"])
    if kind == "instance":
        return {"type": "instance", "group": {"type": "ref", "id": "group"}, "to_world": placed(asked)[0]}
    raise Unsupported(kind)


def scene(q):
    if "shape" not in q or "transform" in q or "all" in q or "span" in q:
        raise Unsupported("scenes, lists of shapes, a transform beside one, all hits, or a part of a ray")
    made = {"type": "scene"}
    if "instance" in q["shape"]:
        made["group"] = {"type": "shapegroup", "shape": shape(placed(q["shape"])[1])}
    made["shape"] = shape(q["shape"])
    return mi.load_dict(made)


def intersect(q):
    kept = scene(q)  # until the numbers are read: some variants compute them only then
    hit = kept.ray_intersect(mi.Ray3f(q["ray"]["origin"], q["ray"]["direction"]))
    return {"t": one(hit.t), "normal": three(hit.n)} if one(hit.is_valid()) else None


def occluded(q):
    if "segment" not in q:
        raise Unsupported("occluded along a ray")
    start, end = q["segment"]["from"], q["segment"]["to"]
    ray = mi.Ray3f(start, [y - x for x, y in zip(start, end)])
    ray.maxt = 1.0
    kept = scene(q)
    return bool(one(kept.ray_test(ray)))


def lobe(q):
    """Mitsuba's wi is the question's wo; it leaves the cosine in f."""
    (kind, data), = q["lobe"].items()
    parts = {"lambertian": 0, "perfect_specular": 0, "fresnel_reflector": 0, "fresnel_transmitter": 1}
    if kind not in parts or kind != "lambertian" and "u" not in q:
        raise Unsupported(kind)
    reflectance = rgb(data.get("reflectance", 1))
    bsdf = mi.load_dict({
        "lambertian": {"type": "diffuse", "reflectance": reflectance},
        "perfect_specular": {"type": "conductor", "material": "none", "specular_reflectance": reflectance},
    }.get(kind) or {"type": "dielectric", "int_ior": float(data["eta"]), "ext_ior": 1.0})
    context, at = mi.BSDFContext(), mi.SurfaceInteraction3f()
    context.component = parts[kind]
    at.wi = q["wo"]
    answer = {}
    if kind == "lambertian":
        answer["albedo"] = three(bsdf.eval_diffuse_reflectance(at))
    if "wi" in q:
        cosine = q["wi"][2]
        answer["f"] = [x / cosine if cosine > 0 else x for x in three(bsdf.eval(context, at, q["wi"]))]
        answer["pdf"] = one(bsdf.pdf(context, at, q["wi"]))
    if "u" in q:
        sample, weight = bsdf.sample(context, at, 0.5, q["u"])
        is_one = max(three(weight)) > 0
        answer["sample"] = {"wi": three(sample.wo), "weight": three(weight), "pdf": one(sample.pdf)} if is_one else None
    return answer


def fresnel(q):
    cos_i = sum(x * y for x, y in zip(q["wo"], q["n"])) if "wo" in q else q["cos_i"]
    reflected, cos_t, _, eta_ti = mi.fresnel(cos_i, q["eta"])
    answer = {"reflected": one(reflected), "transmitted": 1 - one(reflected)}
    if "wo" in q:
        direction = mi.refract(mi.Vector3f(q["wo"]), mi.Normal3f(q["n"]), cos_t, eta_ti)
        answer["refracted"] = three(direction) if one(reflected) < 1 else None
    return answer


def camera(q):
    asked, image = q["camera"], q["image"]
    (kind, lens), = asked["lens"].items()
    if kind not in ("pinhole", "orthographic") or "stereo" in asked:
        raise Unsupported(kind)
    place = T().look_at(asked["eye"], asked.get("look_at", [0, 0, 0]), asked.get("up", [0, 1, 0]))
    place = place @ T().rotate([0, 0, 1], -asked.get("roll", 0))  # about the direction of view
    half = image["width"] * image.get("pixel_size", 1) / 2 / lens.get("zoom", 1)
    film = {"type": "hdrfilm", "width": image["width"], "height": image["height"]}
    if kind == "orthographic":
        return mi.load_dict({"type": "orthographic", "to_world": place @ T().scale([half, half, 1]), "film": film,
                             "near_clip": NEAR})
    fov = 2 * math.degrees(math.atan(half / lens["distance"]))
    return mi.load_dict({"type": "perspective", "fov": fov, "fov_axis": "x", "to_world": place, "film": film,
                         "near_clip": NEAR})


def camera_ray(q):
    (column, row), place = q["pixel"], q.get("place", [0.5, 0.5])
    at = [(column + place[0]) / q["image"]["width"], (row + 1 - place[1]) / q["image"]["height"]]
    sensor = camera(q)
    ray, _ = sensor.sample_ray(0, 0.5, at, [0.5, 0.5])
    o, d = three(ray.o), three(ray.d)
    if "pinhole" in q["camera"]["lens"]:
        o = three(sensor.world_transform().translation())  # its rays begin at the plane `near_clip`
    else:
        o = [x - NEAR * y for x, y in zip(o, d)]
    return {"origin": o, "direction": d}


def project(q):
    if "pinhole" not in q["camera"]["lens"]:
        raise Unsupported("where a point is seen, by other cameras than the perspective one")
    at = mi.SurfaceInteraction3f()
    at.p = q["point"]
    sensor = camera(q)
    sample, weight = sensor.sample_direction(at, [0.5, 0.5])
    return {"image": [one(sample.uv[0]), one(sample.uv[1])]} if one(weight[0]) > 0 else None


def light(q):
    (kind, data), = q["light"].items()
    strength = [data.get("ls", 1) * x for x in rgb(data.get("color", 1))["value"]]
    if kind == "point" and data.get("attenuation", 0) == 2:
        emitter = {"type": "point", "position": data["location"], "intensity": rgb(strength)}
    elif kind == "directional":
        emitter = {"type": "directional", "direction": [-x for x in data["direction"]], "irradiance": rgb(strength)}
    else:
        raise Unsupported(kind)
    at = mi.SurfaceInteraction3f()
    at.p = q["from"]
    # with something in it: a directional light is as far away as the scene is large
    lit = mi.load_dict({"type": "scene", "emitter": emitter, "shape": {"type": "sphere"}})
    sample, arriving = lit.emitters()[0].sample_direction(at, [0.5, 0.5])
    distance = "inf" if kind == "directional" else one(sample.dist)
    return {"direction": three(sample.d), "distance": distance, "radiance": three(arriving)}


def map(q):
    if "disk" not in q["to"]:
        raise Unsupported("other maps than of the disk")
    found = (mi.warp.square_to_uniform_disk_concentric(q["u"]) if "u" in q else
             mi.warp.uniform_disk_to_square_concentric(q["point"]))
    return [one(found[0]), one(found[1])]


QUESTIONS = {f.__name__: f for f in (intersect, occluded, lobe, fresnel, camera_ray, project, light, map)}


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
