#!/usr/bin/env python3
"""Answers `groundtruth conform` with the formulas of Suffern, *Ray Tracing from the Ground Up*, as they are printed: its
discriminants, its constant ε, its errata. What the book leaves to the reader is unsupported. What the answers are worth
is docs/book-card.md. The book's numbers are doubles, and so are Python's.

Run: groundtruth conform -- python3 examples/conform/book/book.py
With a number behind it, this is ε in all hit functions: what fails for 0, too, is not the fault of ε."""
import json
import math
import sys

sys.dont_write_bytecode = True  # nothing is left behind in this folder

import shapes
from cameras import camera_ray
from grids import grid
from light import fresnel, light, lobe
from samplers import map_of, samples
from shapes import intersect, occluded
from textures import mapping, texture
from transforms import transform
from unsupported import Unsupported

if len(sys.argv) > 1:
    shapes.only_epsilon = float(sys.argv[1])


def spelled(answer):
    """JSON has no infinity and no NaN."""
    if isinstance(answer, dict):
        return {key: spelled(value) for key, value in answer.items()}
    if isinstance(answer, list):
        return [spelled(value) for value in answer]
    is_number = isinstance(answer, float) and not math.isfinite(answer)
    return ("nan" if answer != answer else "inf" if answer > 0 else "-inf") if is_number else answer


FUNCTIONS = {f.__name__: f for f in (intersect, occluded, camera_ray, samples, lobe, fresnel, light, texture, mapping,
                                     transform, grid)}
FUNCTIONS["map"] = map_of
QUESTIONS = {name: lambda q, f=f: spelled(f(q)) for name, f in FUNCTIONS.items()}


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
