#!/usr/bin/env python3
"""POV-Ray answers `groundtruth conform` by `trace()` of its scene language: most shapes of chapters 3 and 19, and these
under a matrix. All questions that are there become one scene, which writes the answers into a file while it is parsed;
so a window of 64 takes one run, of about a second. With --sturm, tori and polynomials have the keyword `sturm`.

Needs: apt-get install povray
Run: groundtruth conform -- python3 examples/conform/programs/ask_povray.py"""
import json
import math
import os
import select
import subprocess
import sys
import tempfile

STURM = " sturm" if "--sturm" in sys.argv else ""


class Unsupported(Exception):
    pass


def v(numbers):
    return "<" + ", ".join(repr(float(x)) for x in numbers) + ">"


def plane(data):
    length = sum(x * x for x in data["normal"]) ** 0.5
    n = [x / length for x in data["normal"]]
    return f"plane {{ {v(n)}, {sum(x * y for x, y in zip(n, data['point']))!r} }}"


def triangle(vertices):
    return "triangle { " + ", ".join(v(x) for x in vertices) + " }"


def rectangle(data):
    p, a, b = data["corner"], data["a"], data["b"]
    q = [[x + i * y + j * z for x, y, z in zip(p, a, b)] for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return f"union {{ {triangle(q[:3])} {triangle([q[0], q[2], q[3]])} }}"


def disc(data):
    hole = f", {data['inner_radius']!r}" if "inner_radius" in data else ""
    radius = data["outer_radius" if hole else "radius"]
    return f"disc {{ {v(data['center'])}, {v(data['normal'])}, {radius!r}{hole} }}"


def cylinder(data, end=""):
    return f"cylinder {{ <0, {data['y0']!r}, 0>, <0, {data['y1']!r}, 0>, {data['radius']!r}{end} }}"


def cone(data, end=""):
    return f"cone {{ <0, 0, 0>, {data['radius']!r}, <0, {data['height']!r}, 0>, 0{end} }}"


def paraboloid(data):
    """(x² + z²)/r² − y/h = 0 below y = h."""
    h, square = data["height"], data["radius"] ** 2
    return (f"quadric {{ <{1 / square!r}, 0, {1 / square!r}>, 0, <0, {-1 / h!r}, 0>, 0 "
            f"clipped_by {{ plane {{ y, {h!r} }} }} }}")


def algebraic(data):
    """The coefficients of all powers of x, y and z, the highest of x first, then of y, then of z."""
    order = max(2, max(sum(term["powers"]) for term in data["terms"]))
    sums = {}
    for term in data["terms"]:
        powers = tuple(term["powers"])
        sums[powers] = sums.get(powers, 0.0) + term["coefficient"]
    all_powers = [(i, j, k) for i in range(order, -1, -1) for j in range(order - i, -1, -1)
                  for k in range(order - i - j, -1, -1)]
    coefficients = v(sums.get(powers, 0) for powers in all_powers)
    box = f"box {{ {v(data['min'])}, {v(data['max'])} }}"
    return f"poly {{ {order}, {coefficients}{STURM} clipped_by {{ {box} }} bounded_by {{ clipped_by }} }}"


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


def instance(data):
    """Row vectors: the matrices are transposed."""
    matrices = ""
    for rows in map(step, data["transform"]):
        matrices += f" matrix {v(row[i] for i in range(4) for row in rows[:3])}"
    return f"object {{ {shape(data['of'])}{matrices} }}"


SHAPES = {
    "plane": plane,
    "sphere": lambda data: f"sphere {{ {v(data['center'])}, {data['radius']!r} }}",
    "box": lambda data: f"box {{ {v(data['min'])}, {v(data['max'])} }}",
    "triangle": lambda data: triangle(data["vertices"]),
    "rectangle": rectangle,
    "disk": disc,
    "annulus": disc,
    "open_cylinder": lambda data: cylinder(data, " open"),
    "solid_cylinder": cylinder,
    "cone": lambda data: cone(data, " open"),
    "solid_cone": cone,
    "paraboloid": paraboloid,
    "torus": lambda data: f"torus {{ {data['swept_radius']!r}, {data['tube_radius']!r}{STURM} }}",
    "algebraic": algebraic,
    "instance": instance,
}


def shape(asked):
    (kind, data), = asked.items()
    if kind not in SHAPES or data.get("inward"):
        raise Unsupported(kind)
    return SHAPES[kind](data)


def ray(name, q):
    """What is traced: a shape in POV-Ray's language, origin and direction."""
    if name not in ("intersect", "occluded"):
        raise Unsupported(name)
    if "shape" not in q or "transform" in q or "all" in q or "span" in q or name == "occluded" and "segment" not in q:
        raise Unsupported("scenes, lists of shapes, all hits, or a part of a ray")
    if name == "intersect":
        return shape(q["shape"]), q["ray"]["origin"], q["ray"]["direction"]
    start, end = q["segment"]["from"], q["segment"]["to"]
    return shape(q["shape"]), start, [y - x for x, y in zip(start, end)]


def traced(rays):
    """Point and normal for each ray; a normal of zero where nothing is hit."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.pov"), "w") as scene:
            print('#version 3.7; #declare D = 400;\n#fopen F "answers" write', file=scene)
            for text, o, d in rays:
                print(f"#declare N = <0, 0, 0>; #declare S = {text}\n#declare P = trace(S, {v(o)}, {v(d)}, N);\n"
                      '#write(F, "[", vstr(3, P, ",", 0, D), ",", vstr(3, N, ",", 0, D), "]\\n")', file=scene)
            print("#fclose F", file=scene)
        command = ["povray", "+Iscene.pov", "+Opicture.png", "+W1", "+H1", "-D", "-GA"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if run.returncode:
            raise RuntimeError("povray: " + run.stderr[-300:])
        with open(os.path.join(folder, "answers")) as answers:
            lines = (line.replace("-nan", "NaN").replace("nan", "NaN") for line in answers)
            return [(values[:3], values[3:]) for values in map(json.loads, lines)]


def answer(name, q, point, normal):
    _, o, d = ray(name, q)
    is_hit = any(normal)
    t = sum((p - x) * y for p, x, y in zip(point, o, d)) / sum(y * y for y in d)  # trace() says only where
    if name == "occluded":
        return is_hit and t < 1
    if "triangle" in q["shape"] or "rectangle" in q["shape"]:
        normal = [-x for x in normal]  # of a triangle (v0 − v1) × (v2 − v1)
    return {"t": t, "normal": [x if x == x else "nan" for x in normal]} if is_hit else None


def replies(lines):
    """One reply for each line; if POV-Ray stops at a question, each is asked alone."""
    found, rays = [], []
    for line in lines:
        question = json.loads(line)
        number = question.pop("id")
        (name, q), = question.items()
        try:
            rays.append(ray(name, q))
            found.append((number, name, q))
        except Unsupported as what:
            yield {"id": number, "unsupported": str(what)}
    try:
        for (number, name, q), hit in zip(found, traced(rays) if rays else []):
            yield {"id": number, "answer": answer(name, q, *hit)}
    except RuntimeError as error:
        if len(found) == 1:
            yield {"id": found[0][0], "error": str(error)}
        else:
            for number, name, q in found:
                yield from replies([json.dumps({"id": number, name: q})])


def windows():
    """The lines that are there, again and again."""
    rest = b""
    while chunk := os.read(0, 1 << 20):
        rest += chunk
        while select.select([0], [], [], 0.02)[0] and (chunk := os.read(0, 1 << 20)):
            rest += chunk
        *lines, rest = rest.split(b"\n")
        yield lines


if __name__ == "__main__":
    for window in windows():
        for reply in replies(window):
            print(json.dumps(reply), flush=True)
