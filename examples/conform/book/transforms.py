"""Affine transformations and their inverses (ch. 20): rows of a matrix whose last row is 0, 0, 0, 1."""
import math

from numbers_as_in_c import cross, dot, unit
from unsupported import Unsupported

IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]


def product(a, b):
    return [[sum(row[k] * b[k][j] for k in range(3)) + (row[3] if j == 3 else 0) for j in range(4)] for row in a]


def linear(m):
    return [[*row, 0] for row in m]


def translation(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]]


def scaling(x, y, z):
    return linear([[x, 0, 0], [0, y, 0], [0, 0, z]])


def rotation(axis, degrees):
    """Counter-clockwise for an eye on the positive axis that looks at the origin."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return linear({"x": [[1, 0, 0], [0, c, -s], [0, s, c]],
                   "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                   "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


def rotation_about(point, direction, degrees):
    """The line is moved to the z axis by a translation and an orthonormal basis, and back."""
    w = unit(direction)
    u = unit(cross([0.0034, 1, 0.0071], w))
    basis = [u, cross(w, u), w]
    steps = [translation(*point), linear([list(column) for column in zip(*basis)]), rotation("z", degrees),
             linear(basis), translation(*(-x for x in point))]
    result = IDENTITY
    for step in steps:
        result = product(result, step)
    return result


def shear(a, b, c, d, e, f):
    return linear([[1, a, b], [c, 1, d], [e, f, 1]])


def inverse_shear(a, b, c, d, e, f):
    det = 1 - d * f - a * c - b * e + a * d * e + b * c * f
    rows = [[1 - d * f, b * f - a, a * d - b], [d * e - c, 1 - b * e, b * c - d], [c * f - e, a * e - f, 1 - a * c]]
    return linear([[x / det for x in row] for row in rows])


def pair(step):
    """A step's matrix and its inverse."""
    (name, data), = step.items()
    if name == "translate":
        return translation(*data), translation(*(-x for x in data))
    if name == "scale":
        x, y, z = data if isinstance(data, list) else [data] * 3
        return scaling(x, y, z), scaling(1 / x, 1 / y, 1 / z)
    if name in ("rotate_x", "rotate_y", "rotate_z"):
        return rotation(name[-1], data), rotation(name[-1], -data)
    if name == "rotate_about":
        line = data["point"], data["direction"]
        return rotation_about(*line, data["degrees"]), rotation_about(*line, -data["degrees"])
    if name == "reflect":
        across = scaling(*(-1 if axis == data else 1 for axis in "xyz"))
        return across, across
    if name == "shear":
        return shear(*data), inverse_shear(*data)
    raise Unsupported(f"{name}: the book has no inverse of any matrix")


def matrix_of(steps):
    """T_n … T₂ T₁."""
    result = IDENTITY
    for step in steps:
        result = product(pair(step)[0], result)
    return result


def inverse_of(steps):
    """T₁⁻¹ T₂⁻¹ … T_n⁻¹."""
    result = IDENTITY
    for step in steps:
        result = product(result, pair(step)[1])
    return result


def vector_by(m, v):
    return [dot(row, v) for row in m]


def point_by(m, p):
    return [dot(row, p) + row[3] for row in m]


def normal_by(inverse, n):
    """By the transposed inverse."""
    return [dot(column, n) for column in zip(*(row[:3] for row in inverse))]


def transform(q):
    return {"matrix": matrix_of(q["steps"]), "inverse": inverse_of(q["steps"])}
