#!/usr/bin/env python3
"""trimesh (its own ray–triangle queries, in NumPy) answers `groundtruth conform`: triangles, rectangles as two of
them, boxes as twelve, planes, meshes, all of these under a matrix, and matrices.

Needs: pip install trimesh rtree scipy
Run: groundtruth conform -- python3 examples/conform/programs/ask_trimesh.py"""
import json
import sys

import numpy as np
import trimesh
from trimesh import intersections, transformations
from trimesh.ray.ray_triangle import RayMeshIntersector


class Unsupported(Exception):
    pass


def step(data):
    """The matrix of one step of a transform."""
    (kind, x), = data.items()
    if kind == "matrix":
        return np.array(x, float)
    if kind == "translate":
        return transformations.translation_matrix(x)
    if kind == "scale":
        return transformations.scale_and_translate(scale=x)
    if kind == "shear":
        a, b, c, d, e, f = x
        return np.array([[1, a, b, 0], [c, 1, d, 0], [e, f, 1, 0], [0, 0, 0, 1]])
    if kind == "reflect":
        return transformations.reflection_matrix([0, 0, 0], np.eye(3)["xyz".index(x)])
    if kind == "rotate_about":
        return transformations.rotation_matrix(np.radians(x["degrees"]), x["direction"], x["point"])
    if kind.startswith("rotate_"):
        return transformations.rotation_matrix(np.radians(x), np.eye(3)["xyz".index(kind[-1])])
    raise Unsupported(kind)


def steps(data):
    """Of a list of steps, the first applied first."""
    return transformations.concatenate_matrices(*[step(x) for x in reversed(data)])


def mesh(shape):
    """A shape as a mesh; its triangles turn counterclockwise for who sees the outside."""
    (kind, data), = shape.items()
    if kind == "instance":
        return mesh(data["of"]).apply_transform(steps(data["transform"]))
    if kind == "box":
        return trimesh.creation.box(bounds=[data["min"], data["max"]])
    if kind == "triangle":
        vertices, faces = data["vertices"], [[0, 1, 2]]
    elif kind == "rectangle":
        corner, a, b = (np.array(data[name], float) for name in ("corner", "a", "b"))
        vertices, faces = [corner, corner + a, corner + a + b, corner + b], [[0, 1, 2], [0, 2, 3]]
    elif kind == "mesh" and "vertices" in data:
        vertices, faces = data["vertices"], data["triangles"]
    else:
        raise Unsupported(kind)
    return trimesh.Trimesh(vertices, faces, process=False)


def hits(q, o, d, nearest=False):
    """What is hit ahead, ascending: t, in the length of d, and the normal."""
    if "shape" not in q:
        raise Unsupported("a scene, or a list of shapes")
    shape = {"instance": {"of": q["shape"], "transform": q["transform"]}} if "transform" in q else q["shape"]
    o, d = np.array([o], float), np.array([d], float)
    if "plane" in shape:
        normals = trimesh.util.unitize([shape["plane"]["normal"]])
        found = intersections.planes_lines([shape["plane"]["point"]], normals, o, d, return_distance=True)
        return [(t, list(normals[0])) for t in found[2].tolist() if t > 0]  # of the whole line
    target = mesh(shape)
    query = RayMeshIntersector(target)
    triangles, _, places = query.intersects_id(o, d, multiple_hits=not nearest, return_locations=True)
    normals = target.face_normals[triangles].tolist()
    ts = [float((place - o[0]) @ d[0] / (d[0] @ d[0])) for place in places]  # trimesh says only where
    return sorted(zip(ts, normals))


def intersect(q):
    low, high = (float(end) for end in q.get("span", [0, "inf"]))
    if low < 0:
        raise Unsupported("hits behind the origin")
    whole = low > 0 or high < np.inf  # a part of the ray: chosen from all hits
    found = hits(q, q["ray"]["origin"], q["ray"]["direction"], nearest=not (whole or q.get("all")))
    answers = [{"t": t, "normal": n} for t, n in found if not whole or low < t < high]
    return answers if q.get("all") else answers[0] if answers else None


def occluded(q):
    if "segment" not in q:
        raise Unsupported("occluded along a ray")
    start, end = np.array(q["segment"]["from"], float), np.array(q["segment"]["to"], float)
    return any(t < 1 for t, _ in hits(q, start, end - start))


def transform(q):
    matrix = steps(q["steps"])
    inverse = transformations.inverse_matrix(matrix)
    return {"matrix": matrix[:3].tolist(), "inverse": inverse[:3].tolist()}


QUESTIONS = {f.__name__: f for f in (intersect, occluded, transform)}


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
