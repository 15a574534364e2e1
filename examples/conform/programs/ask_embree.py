#!/usr/bin/env python3
"""Embree 4 (the library inside the Python package `embreex`, in single precision) answers `groundtruth conform`:
triangles, rectangles as its quads, boxes as six of these, spheres as its sphere points, disks as its oriented discs,
meshes, and its instances. With --robust, the scene has Embree's flag RTC_SCENE_FLAG_ROBUST.

Needs: pip install embreex
Run: groundtruth conform -- python3 examples/conform/programs/ask_embree.py --robust"""
import ctypes
import glob
import importlib.util
import json
import math
import os
import sys

# rtcore.h of Embree 4
TRIANGLES, QUADS, SPHERES, DISCS, INSTANCE = 0, 1, 50, 52, 121
INDICES, VERTICES, NORMALS = 0, 1, 3
FLOAT3, FLOAT4, FLOAT3X4_ROWS = 0x9003, 0x9004, 0x9134
UINT3, UINT4 = 0x5003, 0x5004
ROBUST = 4 if "--robust" in sys.argv else 0
NOTHING = 0xFFFFFFFF


class Unsupported(Exception):
    pass


def load():
    package = importlib.util.find_spec("embreex").submodule_search_locations[0]
    library = ctypes.CDLL(glob.glob(os.path.join(package + ".libs", "libembree4*"))[0])
    pointer, uint, size = ctypes.c_void_p, ctypes.c_uint, ctypes.c_size_t
    for name, result, arguments in [
        ("NewDevice", pointer, [ctypes.c_char_p]), ("NewScene", pointer, [pointer]),
        ("SetSceneFlags", None, [pointer, uint]), ("NewGeometry", pointer, [pointer, uint]),
        ("SetNewGeometryBuffer", pointer, [pointer, uint, uint, uint, size, size]),
        ("SetGeometryInstancedScene", None, [pointer, pointer]),
        ("SetGeometryTransform", None, [pointer, uint, uint, pointer]), ("CommitGeometry", None, [pointer]),
        ("AttachGeometry", uint, [pointer, pointer]), ("ReleaseGeometry", None, [pointer]),
        ("CommitScene", None, [pointer]), ("ReleaseScene", None, [pointer]),
        ("Intersect1", None, [pointer, pointer, pointer]), ("Occluded1", None, [pointer, pointer, pointer]),
        ("GetDeviceError", uint, [pointer]),
    ]:
        function = getattr(library, "rtc" + name)
        function.restype, function.argtypes = result, arguments
    return library


class Ray(ctypes.Structure):
    """RTCRayHit."""
    real, uint = ctypes.c_float, ctypes.c_uint
    _fields_ = [("o", real * 3), ("near", real), ("d", real * 3), ("time", real), ("far", real), ("mask", uint),
                ("id", uint), ("flags", uint), ("n", real * 3), ("uv", real * 2), ("primitive", uint),
                ("geometry", uint), ("instance", uint * 2), ("room", uint * 11)]


def fill(geometry, which, layout, kind, rows):
    """A buffer of a geometry: rows of numbers."""
    width = len(rows[0])
    address = RTC.rtcSetNewGeometryBuffer(geometry, which, 0, layout, 4 * width, len(rows))
    ctypes.memmove(address, (kind * (width * len(rows)))(*[x for row in rows for x in row]), 4 * width * len(rows))


def polygons(geometry_type, layout, vertices, faces):
    geometry = RTC.rtcNewGeometry(DEVICE, geometry_type)
    fill(geometry, VERTICES, FLOAT3, ctypes.c_float, vertices)
    fill(geometry, INDICES, layout, ctypes.c_uint, faces)
    return geometry


def step(data):
    """The rows of the matrix of a step of a transform."""
    (kind, x), = data.items()
    if kind == "matrix":
        return x
    if kind == "translate":
        return [[1, 0, 0, x[0]], [0, 1, 0, x[1]], [0, 0, 1, x[2]], [0, 0, 0, 1]]
    if kind == "scale":
        return [[x[0], 0, 0, 0], [0, x[1], 0, 0], [0, 0, x[2], 0], [0, 0, 0, 1]]
    if kind == "shear":
        a, b, c, d, e, f = x
        return [[1, a, b, 0], [c, 1, d, 0], [e, f, 1, 0], [0, 0, 0, 1]]
    if kind != "rotate_about":
        raise Unsupported(kind)
    length = math.hypot(*x["direction"])
    a, b, c = (y / length for y in x["direction"])
    # Rodrigues: the parts of a vector along the axis, across it, and across both
    s, along = math.sin(math.radians(x["degrees"])), 2 * math.sin(math.radians(x["degrees"]) / 2) ** 2
    rows = [[1 - along * (b * b + c * c), along * a * b - s * c, along * a * c + s * b],
            [along * a * b + s * c, 1 - along * (a * a + c * c), along * b * c - s * a],
            [along * a * c - s * b, along * b * c + s * a, 1 - along * (a * a + b * b)]]
    p = x["point"]
    return [[*row, y - sum(r * z for r, z in zip(row, p))] for row, y in zip(rows, p)] + [[0, 0, 0, 1]]


def placed(shape):
    """The matrix of an instance, or of instances in one another (this build has one level), and what is in it."""
    matrix = step({"scale": [1, 1, 1]})
    while "instance" in shape:
        for data in reversed(shape["instance"]["transform"]):
            columns = list(zip(*step(data)))
            matrix = [[sum(x * y for x, y in zip(row, column)) for column in columns] for row in matrix]
        shape = shape["instance"]["of"]
    return matrix, shape


def scene(shape, made):
    """A built scene of one shape; `made` gets all scenes, to be released."""
    (kind, data), = shape.items()
    if kind == "instance":
        matrix, within = placed(shape)
        inner = scene(within, made)
        geometry = RTC.rtcNewGeometry(DEVICE, INSTANCE)
        RTC.rtcSetGeometryInstancedScene(geometry, inner)
        rows = (ctypes.c_float * 12)(*[x for row in matrix[:3] for x in row])
        RTC.rtcSetGeometryTransform(geometry, 0, FLOAT3X4_ROWS, ctypes.addressof(rows))
    elif kind == "triangle":
        geometry = polygons(TRIANGLES, UINT3, data["vertices"], [[0, 1, 2]])
    elif kind == "mesh" and "vertices" in data:
        geometry = polygons(TRIANGLES, UINT3, data["vertices"], data["triangles"])
    elif kind == "rectangle":
        p, a, b = data["corner"], data["a"], data["b"]
        corners = [[x + i * y + j * z for x, y, z in zip(p, a, b)] for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        geometry = polygons(QUADS, UINT4, corners, [[0, 1, 2, 3]])
    elif kind == "box":
        corners = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        corners = [[(data["min"], data["max"])[side][i] for i, side in enumerate(corner)] for corner in corners]
        faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
        geometry = polygons(QUADS, UINT4, corners, faces)
    elif kind in ("sphere", "disk"):
        geometry = RTC.rtcNewGeometry(DEVICE, SPHERES if kind == "sphere" else DISCS)
        fill(geometry, VERTICES, FLOAT4, ctypes.c_float, [data["center"] + [data["radius"]]])
        if kind == "disk":
            fill(geometry, NORMALS, FLOAT3, ctypes.c_float, [data["normal"]])
    else:
        raise Unsupported(kind)
    made.append(RTC.rtcNewScene(DEVICE))
    RTC.rtcSetSceneFlags(made[-1], ROBUST)
    RTC.rtcCommitGeometry(geometry)
    RTC.rtcAttachGeometry(made[-1], geometry)
    RTC.rtcReleaseGeometry(geometry)
    RTC.rtcCommitScene(made[-1])
    return made[-1]


def cast(q, function, o, d, near, far):
    """The ray after a query."""
    if "shape" not in q or "transform" in q or q.get("all") or near < 0:
        raise Unsupported("a scene, a list of shapes, a transform beside one, all hits, or hits behind the origin")
    made = []
    room = ctypes.create_string_buffer(ctypes.sizeof(Ray) + 16)
    ray = Ray.from_buffer(room, -ctypes.addressof(room) % 16)  # aligned
    ray.o[:], ray.d[:], ray.near, ray.far, ray.mask = o, d, near, far, NOTHING
    ray.geometry = ray.instance[0] = ray.instance[1] = NOTHING
    try:
        function(scene(q["shape"], made), ctypes.addressof(ray), None)
    finally:
        for old in reversed(made):
            RTC.rtcReleaseScene(old)
    error = RTC.rtcGetDeviceError(DEVICE)
    if error:
        raise RuntimeError(f"rtcGetDeviceError says {error}")
    return ray


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def out_of_instance(matrix, n):
    """Embree leaves a normal in the coordinates of what is instanced: times the inverse transposed, of any length."""
    a, b, c = ([row[i] for row in matrix[:3]] for i in range(3))
    sign = math.copysign(1, sum(x * y for x, y in zip(a, cross(b, c))))
    return [sign * sum(x * y for x, y in zip(n, rows)) for rows in zip(cross(b, c), cross(c, a), cross(a, b))]


def intersect(q):
    low, high = (float(end) for end in q.get("span", [0, "inf"]))
    ray = cast(q, RTC.rtcIntersect1, q["ray"]["origin"], q["ray"]["direction"], low, high)
    if ray.geometry == NOTHING:
        return None
    n = list(ray.n)
    if "instance" in q["shape"]:
        n = out_of_instance(placed(q["shape"])[0], n)
    length = math.hypot(*n)  # Embree's normal has any length
    return {"t": ray.far, "normal": [x / length for x in n]}


def occluded(q):
    if "segment" not in q:
        raise Unsupported("occluded along a ray")
    start, end = q["segment"]["from"], q["segment"]["to"]
    return cast(q, RTC.rtcOccluded1, start, [y - x for x, y in zip(start, end)], 0, 1).far < 0


RTC = load()
DEVICE = RTC.rtcNewDevice(None)
QUESTIONS = {f.__name__: f for f in (intersect, occluded)}


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
