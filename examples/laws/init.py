#!/usr/bin/env python3
"""Answers the questions of `groundtruth laws`: name your lobes, and fill in two functions.

Run: groundtruth laws -- python3 my_bsdfs.py
docs/laws.md describes the questions and the claims, and examples/laws/bsdfs.py is one with more lobes.

All directions are unit vectors in the local frame of the surface: z is the normal. `wo` points to the viewer, `wi` to
the light. The lobe below is Lambert's; put yours in its place."""
import json
import math
import sys

# What you have: names, from where parameters are drawn, and what you claim. A claim that is left out is not tested.
LOBES = [
    {"name": "lambert",
     "parameters": {"albedo": [0, 1]},  # from 0 to 1; {"one_of": ["copper", "gold"]} chooses, a number is fixed
     "claims": {"reciprocal": True, "isotropic": True}},
]


def evaluate(name, parameters, wo, wi):
    """f(wo, wi), without a cosine, as three numbers or one; and the density of `sample` at wi, per steradian."""
    if wo[2] <= 0 or wi[2] <= 0:
        return 0, 0
    return parameters["albedo"] / math.pi, wi[2] / math.pi


def sample(name, parameters, wo, u):
    """A direction for random numbers in [0, 1), of which there are four; its weight f |cos| / pdf; and its density, which
    is None for a single direction. None for no sample at all."""
    if wo[2] <= 0:
        return None
    r, phi = math.sqrt(u[0]), 2 * math.pi * u[1]
    wi = [r * math.cos(phi), r * math.sin(phi), math.sqrt(1 - u[0])]
    return wi, parameters["albedo"], wi[2] / math.pi


# The protocol: a question is a line, and so is its answer, with the same id.


def answer(question):
    if "list" in question:
        return LOBES
    (kind, data), = question.items()
    name, parameters, wo = data["lobe"], data["parameters"], data["wo"]
    if kind == "eval":
        values = [evaluate(name, parameters, wo, wi) for wi in data["wi"]]
        return {"f": [f for f, _ in values], "pdf": [pdf for _, pdf in values]}
    drawn = [sample(name, parameters, wo, u) for u in data["u"]]
    return [it and dict(zip(("wi", "weight", "pdf"), it)) for it in drawn]


def reply(line):
    question = json.loads(line)
    number = question.pop("id")
    try:
        return {"id": number, "answer": answer(question)}
    except Exception as error:
        return {"id": number, "error": f"{type(error).__name__}: {error}"}


def main():
    for line in sys.stdin:
        # flush: a pipe keeps lines back. Print nothing else here: messages belong to sys.stderr
        print(json.dumps(reply(line)), flush=True)


if __name__ == "__main__":
    main()
