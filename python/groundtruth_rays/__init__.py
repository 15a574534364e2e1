"""Groundtruth for numpy: pictures and explanations of scenes, exact intersections, verdicts on pictures, laws of BSDFs.

A *scene* is a name of the gallery (``groundtruth list``), the path of a scene file, the text of one, or a dictionary of
the same form. What changes it is given by keywords: ``size=(width, height)``, ``samples``, ``tracer``, ``max_depth``,
``seed``, as the options of the command. Errors are ``ValueError`` with the command's text.
"""

from __future__ import annotations

import html
import json
from os import PathLike
from typing import Any, Callable, Mapping, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native

__all__ = ["Card", "ExactHits", "Explanation", "Hits", "Verdict", "ask", "explain", "intersect", "laws", "render", "verify"]

Scene = Union[str, "PathLike[str]", Mapping[str, Any]]
Floats = NDArray[np.float64]


def _text(scene: Scene) -> str:
    return json.dumps(scene) if isinstance(scene, Mapping) else str(scene)


def _changes(given: Mapping[str, Any], **more: Any) -> dict[str, Any]:
    names = ("size", "fit", "samples", "tracer", "max_depth", "seed")
    for name in given:
        if name not in names or name == "fit":
            raise TypeError(f"no change of a scene is called {name!r}: size, samples, tracer, max_depth, seed")
    return dict.fromkeys(names) | dict(given) | more


def _framed(page: str) -> str:
    """A page within a notebook, whose styles stay in it."""
    return f'<iframe srcdoc="{html.escape(page)}" style="width: 100%; height: 40em; border: 0"></iframe>'


def _triples(name: str, values: ArrayLike) -> Floats:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(f"{name}: its shape is {array.shape}, and the last axis of vectors is 3")
    return array


def render(scene: Scene, **changes: Any) -> Floats:
    """Renders a scene.

    Returns its radiance, of shape (height, width, 3): linear, row by row from the top left.
    """
    values, width, height = _native.render(_text(scene), _changes(changes))
    return np.frombuffer(values).reshape(height, width, 3).copy()


class Explanation:
    """Why a pixel has its colour: ``print`` shows the tree of rays, a notebook the page of ``explain -o``."""

    def __init__(self, native: Any) -> None:
        self._native = native

    @property
    def radiance(self) -> Floats:
        """The pixel, of shape (3,): the mean of all its samples, or the one that is explained."""
        return np.array(self._native.radiance)

    @property
    def data(self) -> dict[str, Any]:
        """Every ray with all its numbers; docs/explain-json.md describes it."""
        return json.loads(self._native.json())

    def text(self, min_share: float = 0.01) -> str:
        """As ``groundtruth explain`` prints it; rays that add less than this share of their sample are folded."""
        return self._native.text(min_share)

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return _framed(self._native.html())


def explain(scene: Scene, pixel: tuple[int, int], sample: int | None = 0, **changes: Any) -> Explanation:
    """Explains a sample of a pixel (column and row from the top left), or with ``None`` all of them."""
    return Explanation(_native.explain(_text(scene), _changes(changes), list(pixel), sample))


class Hits(NamedTuple):
    """The nearest hits of rays with a shape."""

    t: Floats
    """Along the ray, in lengths of its direction; infinite without a hit. Of the shape of the rays."""
    normal: Floats
    """Unit, geometric, with a last axis of 3; NaN without a hit."""
    shading_normal: Floats
    """The interpolated one of smooth meshes."""
    front: NDArray[np.bool_]
    """Whether the ray comes from where the normal points."""


class ExactHits(NamedTuple):
    """The nearest hits of rays with a shape, correct to the last bit."""

    t: Floats
    """As in :class:`Hits`."""
    normal: Floats
    """As in :class:`Hits`."""
    condition: Floats
    """The sum over all inputs x of |dt/dx|·|x|: times 2⁻⁵³ it is the error of t that rounding the inputs explains."""
    margin: Floats
    """No relative change of the inputs smaller than this changes the number of hits."""


def intersect(
    shape: Mapping[str, Any],
    origins: ArrayLike,
    directions: ArrayLike,
    *,
    transform: Sequence[Mapping[str, Any]] = (),
    exact: bool = False,
) -> Hits | ExactHits:
    """Intersects rays with a shape, written as in scene files: ``{"sphere": {"center": [0, 0, 0], "radius": 1}}``.

    ``origins`` and ``directions`` have a last axis of 3 and are broadcast against each other. ``exact`` asks the oracle,
    which calculates with as many digits as the answer needs.
    """
    pair = np.broadcast_arrays(_triples("origins", origins), _triples("directions", directions))
    rays = np.concatenate(pair, axis=-1)
    of = rays.shape[:-1]
    found = _native.intersect(json.dumps(shape), json.dumps(list(transform)), rays.tobytes(), exact)
    columns = np.frombuffer(found).reshape(*of, 6 if exact else 8)
    if exact:
        return ExactHits(columns[..., 0], columns[..., 3:6], columns[..., 1], columns[..., 2])
    return Hits(columns[..., 0], columns[..., 1:4], columns[..., 4:7], columns[..., 7] == 1)


class _Told:
    """What a command says: ``print`` shows its text, a notebook its page."""

    def __init__(self, text: str, page: str, data: str) -> None:
        self._text, self._page, self._data = text, page, data

    @property
    def data(self) -> dict[str, Any]:
        """All its numbers, as the command's ``--json``."""
        return json.loads(self._data)

    def __str__(self) -> str:
        return self._text

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return _framed(self._page)


class Verdict(_Told):
    """What ``groundtruth verify`` says of pictures."""

    agrees: bool | None
    """Whether they agree with ours; ``None`` if nobody can say."""


def verify(scene: Scene, pictures: ArrayLike, **changes: Any) -> Verdict:
    """Judges pictures of a scene: is the difference from ours noise?

    ``pictures`` is linear radiance of shape (height, width, 3), or (n, height, width, 3) for several with other random
    numbers; ours are rendered at their size.
    """
    array = np.asarray(pictures, dtype=np.float32)
    if array.ndim not in (3, 4) or array.shape[-1] != 3 or 0 in array.shape:
        raise ValueError(f"pictures: their shape is {array.shape}, not (height, width, 3) or (n, height, width, 3)")
    height, width = array.shape[-3:-1]
    each = [picture.tobytes() for picture in array.reshape(-1, height, width, 3)]
    size = [width, height]
    agrees, *told = _native.verify(_text(scene), _changes(changes, fit=size), each, size)
    verdict = Verdict(*told)
    verdict.agrees = agrees
    return verdict


class Card(_Told):
    """What ``groundtruth laws`` says of functions."""

    holds: bool
    """Whether they hold all laws that were judged."""


def laws(
    eval: Callable[..., ArrayLike],
    pdf: Callable[..., ArrayLike],
    sample: Callable[..., tuple[ArrayLike, ArrayLike, ArrayLike]],
    *,
    claims: Mapping[str, Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    name: str = "bsdf",
    cases: int = 8,
    seed: int = 1,
) -> Card:
    """Holds a BSDF to its laws: energy, reciprocity, a density that integrates to 1 and fits the samples (docs/laws.md).

    The functions work on arrays of n unit vectors in the local frame of the surface, z along the normal; ``wo`` points to
    the viewer, ``wi`` to the light:

    - ``eval(wo, wi, **parameters)``: f without a cosine, of shape (n,) or (n, 3);
    - ``pdf(wo, wi, **parameters)``: the density of ``sample``, per steradian, of shape (n,);
    - ``sample(wo, u, **parameters)``, with u of shape (n, 4) in [0, 1): wi of shape (n, 3), the weight f·|cos|/pdf of
      shape (n,) or (n, 3), and the density of shape (n,); a row of wi that is NaN is no sample.

    ``claims`` and ``parameters`` are those of a program that `groundtruth laws` asks: ``{"reciprocal": True}``, and
    ``{"albedo": [0, 1]}`` for a range.
    """
    listed = [{"name": name, "parameters": dict(parameters or {}), "claims": dict(claims or {})}]

    def answer(question: str) -> str:
        ((kind, data),) = json.loads(question).items()
        if kind == "list":
            return json.dumps(listed)
        many = np.array(data["wi"] if kind == "eval" else data["u"], dtype=np.float64)
        wo = np.broadcast_to(np.array(data["wo"], dtype=np.float64), (len(many), 3))
        of = data["parameters"]
        if kind == "eval":
            f, density = (_rows(it.__name__, it(wo, many, **of), len(many)) for it in (eval, pdf))
            return json.dumps({"f": f, "pdf": density})
        wi, weight, density = sample(wo, many, **of)
        wi = np.asarray(wi, dtype=np.float64)
        columns = (_rows("sample", column, len(many)) for column in (wi, weight, density))
        drawn = [dict(zip(("wi", "weight", "pdf"), row)) for row in zip(*columns)]
        missing = np.isnan(wi).any(axis=-1)
        return json.dumps([None if none else it for it, none in zip(drawn, missing)])

    holds, *told = _native.laws(answer, cases, seed)
    card = Card(*told)
    card.holds = holds
    return card


def _rows(name: str, values: ArrayLike, count: int) -> list[Any]:
    """As lists, one for each of ``count`` rows; what is not finite is a word, as JSON has no number for it."""
    array = np.asarray(values, dtype=np.float64)
    if array.ndim == 0 or len(array) != count:
        raise ValueError(f"{name} returns an array of shape {array.shape}, not with {count} rows")
    if np.isfinite(array).all():
        return array.tolist()
    words = {np.inf: "inf", -np.inf: "-inf"}
    flat = [x if np.isfinite(x) else words.get(x, "nan") for x in array.ravel().tolist()]
    return np.array(flat, dtype=object).reshape(array.shape).tolist()


def ask(question: Mapping[str, Any]) -> Any:
    """Asks the probe (docs/probe.md): ``ask({"fresnel": {"cos_i": 1, "eta": 1.5}})``."""
    reply = json.loads(_native.ask(json.dumps(question)))
    if "error" in reply:
        raise ValueError(reply["error"])
    return reply["answer"]
