"""Sample sets (ch. 4 and 5) and their maps to disk, hemisphere and sphere (ch. 6, 7, 18)."""
import math
import random

from unsupported import Unsupported

RAND_MAX = 2 ** 31 - 1
NUM_SETS = 83


def rand_float(rng):
    """rand() / RAND_MAX (ch. 2): 1 is one of its values, though a rare one, and a sample of 1 is outside the square."""
    return rng.randint(0, RAND_MAX) / RAND_MAX


def regular(n, rng):
    side = int(math.sqrt(n))
    return [[(k + 0.5) / side, (j + 0.5) / side] for j in range(side) for k in range(side)]


def pure_random(n, rng):
    return [[rand_float(rng), rand_float(rng)] for _ in range(n)]


def jittered(n, rng):
    side = int(math.sqrt(n))
    return [[(k + rand_float(rng)) / side, (j + rand_float(rng)) / side] for j in range(side) for k in range(side)]


def n_rooks(n, rng):
    """On the diagonal, then the x and the y are shuffled."""
    xs, ys = ([(j + rand_float(rng)) / n for j in range(n)] for _ in range(2))
    rng.shuffle(xs)
    rng.shuffle(ys)
    return [list(point) for point in zip(xs, ys)]


def multi_jittered(n, rng):
    """The canonical arrangement, then x is shuffled within the cells of a column, y within those of a row; the partner of
    index j is from j on."""
    side = int(math.sqrt(n))
    xs = [[(i * side + j + rand_float(rng)) / n for j in range(side)] for i in range(side)]
    ys = [[(j * side + i + rand_float(rng)) / n for j in range(side)] for i in range(side)]
    for i in range(side):
        for j in range(side):
            k = rng.randint(j, side - 1)
            xs[i][j], xs[i][k] = xs[i][k], xs[i][j]
    for i in range(side):
        for j in range(side):
            k = rng.randint(j, side - 1)
            ys[j][i], ys[k][i] = ys[k][i], ys[j][i]
    return [[xs[i][j], ys[i][j]] for i in range(side) for j in range(side)]


def hammersley(n, rng):
    """(i/n, Φ(i)): Φ mirrors the binary digits of i at the point. The same for every set."""
    return [[i / n, phi(i)] for i in range(n)]


def phi(i):
    x, f = 0.0, 0.5
    while i:
        x += f * (i % 2)
        i, f = i // 2, f / 2
    return x


PATTERNS = {"regular": regular, "random": pure_random, "jittered": jittered, "n_rooks": n_rooks,
            "multi_jittered": multi_jittered, "hammersley": hammersley}


class Sampler:
    """83 sets and, for each, an order of its samples, which are made once (ch. 5)."""

    def __init__(self, pattern, n, seed):
        self.rng = random.Random(seed)
        self.sets = [pattern(n, self.rng) for _ in range(NUM_SETS)]
        self.orders = [self.rng.sample(range(n), n) for _ in range(NUM_SETS)]
        self.jump = 0

    def sample_unit_square(self, index):
        """A pixel's first sample draws its set: pixels share 83 sets, and so their first samples are among 83 points."""
        if index == 0:
            self.jump = self.rng.randrange(NUM_SETS)
        return self.sets[self.jump][self.orders[self.jump][index]]


samplers = {}


def samples(q):
    (kind, data), = q["sampler"].items()
    if kind not in PATTERNS or data.get("shifted"):
        raise Unsupported(kind)
    key = kind, q["n"], q.get("seed", 1)
    if "draw" not in q:
        rng = random.Random(str(key))
        return [PATTERNS[kind](q["n"], rng) for _ in range(q.get("sets", 1))]
    if key not in samplers:
        samplers[key] = Sampler(PATTERNS[kind], q["n"], str(key))
    return samplers[key].sample_unit_square(q["draw"]["index"])


def to_disk(u):
    """Shirley's concentric map, by four sectors (ch. 6)."""
    a, b = 2 * u[0] - 1, 2 * u[1] - 1
    if a > -b:
        r, phi = (a, b / a) if a > b else (b, 2 - a / b)
    else:
        r, phi = (-a, 4 + b / a) if a < b else (-b, 6 - a / b if b != 0 else 0.0)
    phi *= math.pi / 4
    return [r * math.cos(phi), r * math.sin(phi)]


def to_hemisphere(u, e):
    """The density is proportional to cos^e θ (ch. 7)."""
    cos_phi, sin_phi = math.cos(2 * math.pi * u[0]), math.sin(2 * math.pi * u[0])
    cosine = (1 - u[1]) ** (1 / (e + 1))
    sine = math.sqrt(1 - cosine * cosine)
    return [sine * cos_phi, sine * sin_phi, cosine]


def to_sphere(u):
    z = 1 - 2 * u[0]
    r = math.sqrt(1 - z * z)
    return [r * math.cos(2 * math.pi * u[1]), r * math.sin(2 * math.pi * u[1]), z]


def map_of(q):
    if "u" not in q:
        raise Unsupported("the way back from a point to its sample")
    (to, data), = q["to"].items()
    maps = {"disk": to_disk, "sphere": to_sphere, "hemisphere": lambda u: to_hemisphere(u, data["exponent"])}
    return maps[to](q["u"])
