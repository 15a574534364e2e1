"""Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). Python 3.6.

    RAYS=120,80 python tracer.py    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
                                    RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
    RAYS_FILE=other.jsonl           to another file

    rays.pixel(x, y, sample)                                    before the camera's ray of a sample
    with rays.ray("reflected", origin, direction) as log:       where a ray begins: camera, reflected, transmitted,
                                                                diffuse, path, shadow; the ray around is its parent
        log.hit(t, point, normal, "ball")                       where it ends; not called if it hits nothing
        log.number("pdf", pdf); log.color("weight", w)          what else is known: see docs/rays.md
        log.color("radiance", L)                                what it brings back

Vectors are lists, arrays, or have .x, .y, .z. log.end() is for whom `with` does not suit. Without RAYS a call tests a bool."""
import json
import os
import re
import sys
import threading


class _State(threading.local):
    on = False                  # whether this thread is in a chosen pixel
    x = y = sample = next = 0
    open = None                 # the number of the ray around the next one


_state, _lock, _out, _chosen = _State(), threading.Lock(), None, []


def _start():
    global _out
    for item in os.environ.get("RAYS", "").split(";"):
        found = re.match(r"(?:(?:(\d+)x(\d+)\+)?(\d+)[,+](\d+)|/(0*[1-9]\d*))$", item.strip())
        if found:
            width, height, x, y, step = (int(n or 0) for n in found.groups())
            far = 1 << 30 if step else 1
            _chosen.append((x, y, width or far, height or far, step or 1))
        elif item:
            return sys.stderr.write("rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not %s\n" % item)
    if _chosen:
        process = sys.modules.get("multiprocessing.process")    # its processes write into the first one's file
        child = process is not None and process.current_process().name != "MainProcess"
        name, flags = os.environ.get("RAYS_FILE", "rays.jsonl"), os.O_WRONLY | os.O_CREAT | os.O_APPEND
        try:
            _out = os.open(name, flags | (0 if child else os.O_TRUNC), 0o666)
        except OSError as error:
            return sys.stderr.write("rays: %s\n" % error)
        if not child:
            line('{"rays": 1}')


def line(text):
    """A line of its own: {"object": "ball", "sphere": {...}} or {"lamp": "sun", ...}, as text or dict."""
    if _out is not None:
        text = text if isinstance(text, str) else json.dumps(text)
        with _lock:
            os.write(_out, (text + "\n").encode())


def pixel(x, y, sample=0):
    if _out is not None:
        s = _state
        s.x, s.y, s.sample, s.next, s.open = int(x), int(y), int(sample), 0, None
        s.on = any(0 <= x - left < width and 0 <= y - top < height and (x - left) % step == (y - top) % step == 0
                   for left, top, width, height, step in _chosen)


def ray(kind, origin, direction):
    return _Ray(kind, origin, direction) if _state.on else _nothing


def _json(v):
    if hasattr(v, "x"):
        v = (v.x, v.y, v.z)
    return "[%s]" % ", ".join(map(_json, v)) if hasattr(v, "__len__") else repr(float(v))


class _Nothing:
    def number(self, field, x): pass
    color = flag = text = number
    def hit(self, t, point, normal, object=None): pass
    def end(self): pass
    def __enter__(self): return self
    def __exit__(self, *error): self.end()


class _Ray(_Nothing):
    def __init__(self, kind, origin, direction):
        s = _state
        self.own, self.before = s.next, s.open
        s.next, s.open = s.next + 1, s.next
        self.line = '{"pixel": [%d, %d], "sample": %d, "ray": %d' % (s.x, s.y, s.sample, self.own)
        if self.before is not None:
            self._put("parent", self.before)
        self.text("kind", kind)
        self._put("origin", _json(origin))
        self._put("direction", _json(direction))

    def _put(self, field, value): self.line += ', "%s": %s' % (field, value)
    def number(self, field, x): self._put(field, repr(float(x)))
    def flag(self, field, x): self._put(field, "true" if x else "false")
    def text(self, field, value): self._put(field, json.dumps(str(value)))
    def color(self, field, v): self._put(field, _json(v))

    def hit(self, t, point, normal, object=None):
        for field, value in ("t", t), ("point", point), ("normal", normal):
            self._put(field, _json(value))
        if object is not None:
            self.text("object", object)

    def end(self):
        if self.line:
            _state.open = self.before if (_state.open or 0) >= self.own else _state.open
            line(self.line + "}")
            self.line = None


_nothing = _Nothing()
_start()
