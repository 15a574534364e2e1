"""Vectors, and the arithmetic of C++ where Python's differs: 1/0 is infinite, √−1 is no number, and neither is an error."""
import math


def over(a, b):
    try:
        return a / b
    except ZeroDivisionError:
        return math.nan if a == 0 or math.isnan(a) else math.copysign(math.inf, a) * math.copysign(1, b)


def root(x):
    return math.nan if x < 0 else math.sqrt(x)


def arccos(x):
    return math.acos(x) if -1 <= x <= 1 else math.nan


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def times(k, v):
    return [k * x for x in v]


def along(o, t, d):
    return [x + t * y for x, y in zip(o, d)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = root(dot(v, v))
    return [over(x, length) for x in v]


def in_frame(p, u, v, w):
    """The vector with these coordinates in the frame (ch. 2)."""
    return [p[0] * a + p[1] * b + p[2] * c for a, b, c in zip(u, v, w)]
