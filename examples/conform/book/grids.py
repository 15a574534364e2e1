"""The cells of a regular grid, and those that a ray passes (ch. 22)."""
import math

from numbers_as_in_c import along
from shapes import slabs
from unsupported import Unsupported

K_EPSILON = 0.0001


def cells(boxes, multiplier):
    """The grid's box, larger than that of the objects by ε, and the number of cells along each axis."""
    low = [min(box["min"][i] for box in boxes) - K_EPSILON for i in range(3)]
    high = [max(box["max"][i] for box in boxes) + K_EPSILON for i in range(3)]
    w = [b - a for a, b in zip(low, high)]
    s = (w[0] * w[1] * w[2] / len(boxes)) ** 0.3333333
    return low, high, [int(multiplier * x / s) + 1 for x in w]


def visited(low, high, n, o, d):
    (t0, _), (t1, _), inverse = slabs(low, high, o, d)
    if not (t0 < t1 and t1 > K_EPSILON):
        return
    p = o if all(a < x < b for a, x, b in zip(low, o, high)) else along(o, t0, d)
    cell = [min(max(int((p[i] - low[i]) * n[i] / (high[i] - low[i])), 0), n[i] - 1) for i in range(3)]
    step, stop, following, dt = [], [], [], []
    for i in range(3):
        enter, leave = sorted(((low[i] - o[i]) * inverse[i], (high[i] - o[i]) * inverse[i]))
        dt.append((leave - enter) / n[i])
        step.append(1 if d[i] > 0 else -1)
        stop.append(n[i] if d[i] > 0 else -1)
        following.append(math.inf if d[i] == 0 else enter + (cell[i] + 1 if d[i] > 0 else n[i] - cell[i]) * dt[i])
    while True:
        yield {"cell": list(cell)}
        i = min(range(3), key=lambda axis: following[axis])
        following[i] += dt[i]
        cell[i] += step[i]
        if cell[i] == stop[i]:
            return


def grid(q):
    if "boxes" not in q or "cell" in q:
        raise Unsupported("a grid of shapes, or the objects of a cell")
    low, high, n = cells(q["boxes"], q.get("multiplier", 2))
    answer = {"resolution": n}
    if "ray" in q:
        answer["visited"] = list(visited(low, high, n, q["ray"]["origin"], q["ray"]["direction"]))
    return answer
