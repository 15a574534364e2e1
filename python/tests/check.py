"""The laws of the module, against numpy and the command; and the notebooks, each run from a fresh kernel."""

import json
import math
import subprocess
from pathlib import Path

import nbformat
import numpy as np
from nbclient import NotebookClient

import groundtruth_rays as gt

SCENE = "ch28/glass-sphere"
SMALL = {"size": (48, 48), "samples": 4}


def command(*words):
    done = subprocess.run(["groundtruth", *words], capture_output=True, text=True)
    return done.stdout, done.stderr


def raises(text, function, *arguments, **named):
    try:
        function(*arguments, **named)
    except ValueError as error:
        assert text in str(error), error
    else:
        raise AssertionError(f"nothing is raised that says {text!r}")


def check_pictures():
    picture = gt.render(SCENE, **SMALL)
    assert picture.shape == (48, 48, 3) and picture.dtype == np.float64
    # the command's PFM is single precision, from the bottom
    command("render", SCENE, "--size", "48x48", "--samples", "4", "-o", "picture.pfm")
    stored = np.frombuffer(Path("picture.pfm").read_bytes()[-48 * 48 * 12 :], dtype="<f4")
    assert np.array_equal(picture.astype(np.float32), stored.reshape(48, 48, 3)[::-1])
    explained = gt.explain(SCENE, (20, 30), sample=None, **SMALL)
    assert np.array_equal(explained.radiance, picture[30, 20])
    text, _ = command("explain", SCENE, "20,30", "--size", "48x48", "--samples", "4")
    assert str(gt.explain(SCENE, (20, 30), **SMALL)) == text
    assert gt.explain(SCENE, (20, 30), **SMALL).data["pixel"] == [20, 30]
    assert explained._repr_html_().startswith("<iframe") and "Why pixel (20, 30)" in explained._repr_html_()
    _, error = command("explain", SCENE, "480,30", "--size", "48x48")
    raises(error.removeprefix("error: ").strip(), gt.explain, SCENE, (480, 30), size=(48, 48))
    _, error = command("render", "ch99/nothing", "-o", "no.png")
    raises(error.removeprefix("error: ").strip(), gt.render, "ch99/nothing")
    Path("picture.pfm").unlink()


def check_rays():
    random = np.random.default_rng(1)
    origins = random.normal(size=(7, 5, 3)) * 3
    directions = random.normal(size=(5, 3))
    sphere = {"sphere": {"center": [0, 0, 0], "radius": 1}}
    for exact in (False, True):
        hits = gt.intersect(sphere, origins, directions, exact=exact)
        # |o + t d|² = 1 by its formula
        a = (directions**2).sum(-1)
        b = (origins * directions).sum(-1)
        c = (origins**2).sum(-1) - 1
        inside = b * b - a * c
        with np.errstate(invalid="ignore"):
            both = (np.stack([-b - np.sqrt(inside), -b + np.sqrt(inside)]) / a)
        both = np.where((inside > 0) & (both > 0), both, np.inf)
        assert np.allclose(hits.t, both.min(0)) and np.isfinite(hits.t).any()
        points = origins + np.where(np.isfinite(hits.t), hits.t, np.nan)[..., None] * directions
        assert np.allclose(hits.normal, points, equal_nan=True)
    assert hits.t.shape == (7, 5) and (hits.margin > 0).all()
    front = gt.intersect(sphere, [[0, 0, 5], [0, 0, 0]], [0, 0, -1]).front
    assert front.tolist() == [True, False]
    stretched = gt.intersect(sphere, [0, 0, 5], [0, 0, -1], transform=[{"scale": [1, 1, 2]}])
    assert stretched.t == 3
    raises("radius", gt.intersect, {"sphere": {"center": [0, 0, 0], "radius": -1}}, [0, 0, 5], [0, 0, -1])
    raises("ray 1", gt.intersect, sphere, [0, 0, 5], [[0, 0, -1], [0, 0, 0]])
    raises("origins", gt.intersect, sphere, [0, 5], [0, 0, -1])
    assert math.isclose(gt.ask({"fresnel": {"cos_i": 1, "eta": 1.5}})["reflected"], 0.04)
    raises("eta", gt.ask, {"fresnel": {"cos_i": 1, "eta": 0}})


def check_verdicts():
    small = {"size": (40, 40), "samples": 4}
    ours = [gt.render("ch18/rectangle", seed=seed, **small) for seed in (501, 502, 503)]
    assert gt.verify("ch18/rectangle", ours[0], samples=4).agrees
    assert gt.verify("ch18/rectangle", ours, samples=4).agrees
    wrong = gt.verify("ch18/rectangle", 1.2 * ours[0], samples=4)
    assert wrong.agrees is False and "differs" in str(wrong) and wrong.data["verdict"] == str(wrong).split("\n")[0]
    raises("NaN", gt.verify, "ch18/rectangle", ours[0] * np.nan)
    raises("(40, 3)", gt.verify, "ch18/rectangle", ours[0][0])


def lambert(albedo_of_samples=1.0):
    def evaluate(wo, wi, albedo):
        return np.where((wo[:, 2] > 0) & (wi[:, 2] > 0), albedo / math.pi, 0)

    def density(wo, wi, albedo):
        return np.where((wo[:, 2] > 0) & (wi[:, 2] > 0), wi[:, 2] / math.pi, 0)

    def sample(wo, u, albedo):
        radius, angle = np.sqrt(u[:, 0]), 2 * math.pi * u[:, 1]
        wi = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1 - u[:, 0])], -1)
        return wi, np.full(len(u), albedo * albedo_of_samples), wi[:, 2] / math.pi

    return evaluate, density, sample


def check_laws():
    claims = {"claims": {"reciprocal": True, "isotropic": True}, "parameters": {"albedo": [0, 1]}}
    right = gt.laws(*lambert(), **claims)
    assert right.holds, right
    wrong = gt.laws(*lambert(2.0), **claims)
    assert not wrong.holds and "factor" in str(wrong) or "weight" in str(wrong), wrong
    # what a function raises comes out as it is
    raises("no such lobe", gt.laws, *lambert()[:2], lambda wo, u, albedo: no_lobe(), **claims)


def no_lobe():
    raise ValueError("no such lobe")


def check_notebooks():
    for path in sorted(Path(__file__).parents[1].glob("notebooks/*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
        print(f"{path.name}: {sum(cell.cell_type == 'code' for cell in notebook.cells)} cells run")


for check in (check_pictures, check_rays, check_verdicts, check_laws, check_notebooks):
    check()
    print(check.__name__.replace("_", " "), "holds")
