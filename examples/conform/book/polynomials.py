"""Roots of polynomials in closed form, for the torus (ch. 19): the method of Schwarze's "Cubic and Quartic Roots"
(Graphics Gems, 1990), which the book takes over. Its test for zero is |x| < 1e-90 in the sample code."""
import math

from numbers_as_in_c import arccos, over, root


def is_zero(x):
    return abs(x) < 1e-90


def cube_root(x):
    return math.copysign(abs(x) ** (1 / 3), x)


def quadratic(p, q):
    """Of x² + 2 p x + q."""
    d = p * p - q
    if is_zero(d):
        return [-p]
    return [] if d < 0 else [root(d) - p, -root(d) - p]


def cubic(a, b, c):
    """Of x³ + a x² + b x + c: Cardano's formula, with angles where there are three roots."""
    p = (b - a * a / 3) / 3
    q = (2 / 27 * a * a * a - a * b / 3 + c) / 2
    d = q * q + p * p * p
    if is_zero(d):
        u = cube_root(-q)
        roots = [0.0] if is_zero(q) else [2 * u, -u]
    elif d < 0:
        phi, size = arccos(over(-q, root(-p * p * p))) / 3, 2 * root(-p)
        roots = [size * math.cos(phi), -size * math.cos(phi + math.pi / 3), -size * math.cos(phi - math.pi / 3)]
    else:
        roots = [cube_root(root(d) - q) - cube_root(root(d) + q)]
    return [y - a / 3 for y in roots]


def quartic(c4, c3, c2, c1, c0):
    """Of c₄ x⁴ + c₃ x³ + c₂ x² + c₁ x + c₀: Ferrari's formula with the first root of the resolvent."""
    a, b, c, d = (over(x, c4) for x in (c3, c2, c1, c0))
    p = b - 3 / 8 * a * a
    q = a * a * a / 8 - a * b / 2 + c
    r = -3 / 256 * a * a * a * a + a * a * b / 16 - a * c / 4 + d
    if is_zero(r):
        roots = cubic(0.0, p, q) + [0.0]
    else:
        z = cubic(-p / 2, -r, r * p / 2 - q * q / 8)[0]
        u, v = z * z - r, 2 * z - p
        u, v = (0.0 if is_zero(x) else x for x in (u, v))
        if u < 0 or v < 0:
            return []  # rounding alone can make them negative, and then every root is lost
        u, v = root(u), root(v) if q >= 0 else -root(v)
        roots = quadratic(v / 2, z - u) + quadratic(-v / 2, z + u)
    return [y - a / 4 for y in roots]
