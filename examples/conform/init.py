#!/usr/bin/env python3
"""Answers the questions of `groundtruth conform`: fill in what your ray tracer has.

Run: groundtruth conform -- python3 my_tracer.py
docs/probe.md describes the questions, docs/conform.md the run, and examples/conform/adapter.py is one filled in.

Each function below is a question. It gets the question's data and returns the answer, as JSON: numbers, lists,
dictionaries, None for null. Infinity is written "inf". What you do not have is unsupported: raise Unsupported, also
for one shape among others."""
import json
import sys


class Unsupported(Exception):
    pass


def intersect(q):  # {"shape": …, "ray": {"origin": […], "direction": […]}} -> {"t": …, "normal": […]} or None
    raise Unsupported("intersect")


def occluded(q):  # {"shape": …, "segment": {"from": […], "to": […]}} -> True or False
    raise Unsupported("occluded")


def camera_ray(q):  # {"camera": …, "image": …, "pixel": [x, y]} -> {"origin": […], "direction": […]}
    raise Unsupported("camera_ray")


def project(q):  # {"camera": …, "image": …, "point": […]} -> {"image": [x, y]} or None
    raise Unsupported("project")


def samples(q):  # {"sampler": …, "n": 16, "seed": 1, "sets": 2} -> [[[x, y], …], …]
    raise Unsupported("samples")


def map(q):  # {"to": …, "u": [a, b]} -> a point; {"to": …, "point": […]} -> [a, b]
    raise Unsupported("map")


def lobe(q):  # {"lobe": …, "wo": […], "wi": […]} -> {"f": [r, g, b], "pdf": …, "albedo": [r, g, b]}
    raise Unsupported("lobe")


def fresnel(q):  # {"eta": …, "cos_i": …} -> {"reflected": …, "transmitted": …}
    raise Unsupported("fresnel")


def light(q):  # {"light": …, "from": […]} -> {"direction": […], "distance": …, "radiance": [r, g, b]}
    raise Unsupported("light")


def texture(q):  # {"texture": …, "point": […]} -> [r, g, b]
    raise Unsupported("texture")


def mapping(q):  # {"mapping": "spherical", "point": […]} -> [u, v]
    raise Unsupported("mapping")


def noise(q):  # {"noise": …, "point": […]} -> {"value": …, "fbm": …, "turbulence": …}
    raise Unsupported("noise")


def transform(q):  # {"steps": […]} -> {"matrix": [three rows of four], "inverse": [three rows of four]}
    raise Unsupported("transform")


def grid(q):  # {"boxes": […], "multiplier": 2} -> {"resolution": [nx, ny, nz]}
    raise Unsupported("grid")


def radiance(q):  # {"scene": …, "ray": …} -> {"mean": [r, g, b]}
    raise Unsupported("radiance")


def trace(q):  # {"scene": …, "ray": …} -> {"radiance": [r, g, b], "rays": [{"kind": "camera", "origin": …, "direction": …, "t": …}, …]}
    raise Unsupported("trace")


# The protocol: a question is a line, and so is its answer, with the same id.

QUESTIONS = {f.__name__: f for f in (
    intersect, occluded, camera_ray, project, samples, map, lobe, fresnel, light, texture, mapping, noise, transform,
    grid, radiance, trace)}


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
