"""The declared train of several designs as SI arrays, in the order of Holzer's table; and what does not fit it."""

from collections.abc import Iterator, Mapping
from itertools import permutations
from math import prod
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, judged
from cranktrain.grouping import grouped
from cranktrain.language import N_, _
from cranktrain.layout.design import Design
from cranktrain.layout.specs import MAIN
from cranktrain.motion import ONE, ZERO, Array
from cranktrain.numerics.designs import by_design
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS
from cranktrain.questions.crankshaft.shaft_line import line_pins, table_of
from cranktrain.questions.crankshaft.spec import CrankshaftSpec
from cranktrain.questions.torsion.spec import TorsionSpec
from cranktrain.record import record

Node = int | str
"""What moves by itself: a throw, by its number from 1, or a disc on a shaft of its own, by its name."""
FIRST_METHOD = THROW_METHODS[0].name
"""By which the sizes of the crankshaft give its stiffness, where the file names none."""
_UNKNOWN = np.array(np.nan)


@record
class DeclaredTrain:
    """Discs as they are declared, by the rows of Holzer's table: from the free end to the output, branches before.

    Attributes
    ----------
    names : tuple of str, one for each disc
        A throw's is its number.
    throws : array of int, shape (throw,)
        Which discs the throws of `main` are.
    following : array of int, shape (disc − 1,)
        To which disc the shaft of each but the last leads, always a later one.
    free_end : int
        The disc whose amplitude is 1.
    inertia : Array, shape (design, disc)
        What is declared in [torsion], referred to the crank. [kg·m²]
    stiffness : Array, shape (design, disc − 1)
        Of the shaft that leads on from each disc, referred to the crank; NaN where it is left to the sizes. [N·m/rad]
    gaps : array of int, shape (throw − 1,)
        From which discs the shafts between neighbouring throws lead on.
    method : str or None
        By which method the sizes of the crankshaft give the stiffness that is left to them; None where all is given.
    ratio : Array, shape (design, disc)
        Turns for one of the crank.
    tried : Array, shape (design, trial)
        Frequencies at which Holzer's table is asked for. [rad/s]
    """

    needs: ClassVar[str] = N_("[torsion]")

    names: tuple[str, ...]
    throws: NDArray[np.intp]
    following: NDArray[np.intp]
    free_end: int
    inertia: Array
    stiffness: Array
    gaps: NDArray[np.intp]
    method: str | None
    ratio: Array
    tried: Array


def declared_train(spec: TorsionSpec, n_throws: int, n_designs: int = 1) -> DeclaredTrain:
    """Put the discs of all designs into one order."""
    order, following = _order(spec, n_throws)
    inertias, shafts = _inertias(spec, n_throws), _shafts(spec, n_throws)
    at = {node: place for place, node in enumerate(order)}
    return DeclaredTrain(
        names=tuple(map(str, order)),
        throws=np.array([at[throw] for throw in range(1, n_throws + 1)], dtype=np.intp),
        following=np.array([at[following[node]] for node in order[:-1]], dtype=np.intp),
        free_end=at[spec.free_end or 1],
        inertia=by_design([inertias[node] for node in order], n_designs),
        stiffness=by_design([shafts[frozenset((node, following[node]))] for node in order[:-1]], n_designs),
        gaps=np.array([_leading(at, following, throw) for throw in range(1, n_throws)], dtype=np.intp),
        method=None if not _left_to_sizes(spec, n_throws) else spec.stiffness_method or FIRST_METHOD,
        ratio=by_design([_ratio(spec, node) for node in order], n_designs),
        tried=by_design([2 * np.pi * one.array for one in spec.holzer_at or ()], n_designs),
    )


def _left_to_sizes(spec: TorsionSpec, n_throws: int) -> list[int]:
    """Gaps between throws, by the throw before them, of which [torsion] gives no stiffness."""
    given = () if spec.stiffness is None else range(1, n_throws)
    return [gap for gap in range(1, n_throws) if gap not in given and str(gap) not in spec.gap]


def _leading(at: Mapping[Node, int], following: Mapping[Node, Node], throw: int) -> int:
    """From which disc the shaft between a throw and the next leads on."""
    return at[throw] if following.get(throw) == throw + 1 else at[throw + 1]


def _order(spec: TorsionSpec, n_throws: int) -> tuple[list[Node], dict[Node, Node]]:
    """Order of the discs, every one after all that lead to it, and to which each leads.

    The last is the disc that the file has last on the flywheel's side.
    """
    neighbours = grouped(ends for shaft in _shafts(spec, n_throws) for ends in permutations(shaft, 2))
    outer = [
        name for name, disc in spec.disc.items() if disc.is_elastic and (n_throws == 1 or 1 not in _inward(spec, name))
    ]
    last: Node = outer[-1] if outer else n_throws
    backward: list[Node] = []
    following: dict[Node, Node] = {}
    open_ends = [last]
    while open_ends:
        node = open_ends.pop()
        backward.append(node)
        onward = [other for other in neighbours.get(node, []) if other != following.get(node)]
        following |= dict.fromkeys(onward, node)
        open_ends += onward
    return backward[::-1], following


def _shafts(spec: TorsionSpec, n_throws: int) -> dict[frozenset[Node], Array]:
    """Stiffness of every shaft by the two that it joins, referred to the crank, in the order of the file. [N·m/rad]"""
    gaps = [_UNKNOWN] if spec.stiffness is None else [gap.array for gap in spec.stiffness]
    gaps = gaps * (n_throws - 1) if len(gaps) == 1 else gaps
    gaps = [spec.gap[str(n)].torsional_stiffness if str(n) in spec.gap else gap for n, gap in enumerate(gaps, 1)]
    found: dict[frozenset[Node], Array] = {frozenset((throw, throw + 1)): gap for throw, gap in enumerate(gaps, 1)}
    return found | {
        frozenset((name, _node(spec, disc.beside))): disc.torsional_stiffness * _ratio(spec, name) ** 2
        for name, disc in spec.disc.items()
        if disc.is_elastic
    }


def _inertias(spec: TorsionSpec, n_throws: int) -> dict[Node, Array]:
    """Declared inertia of everything that moves by itself, with what sits on it rigidly. [kg·m²]"""
    throws = [inertia.array for inertia in spec.throw_inertia or ()] or [ZERO]
    throws = throws * n_throws if len(throws) == 1 else throws
    found: dict[Node, Array] = dict(enumerate(throws, 1))
    for name, disc in spec.disc.items():
        node = _node(spec, name)
        found[node] = found.get(node, ZERO) + disc.inertia.array * _ratio(spec, name) ** 2
    return found


def _inward(spec: TorsionSpec, name: Node) -> Iterator[Node]:
    """A throw or a disc, what it is beside, and so on to the throw."""
    while isinstance(name, str):
        yield name
        name = spec.disc[name].beside
    yield name


def _node(spec: TorsionSpec, name: Node) -> Node:
    """What moves a throw or a disc: itself, or what it sits on rigidly."""
    return next(node for node in _inward(spec, name) if isinstance(node, int) or spec.disc[node].is_elastic)


def _ratio(spec: TorsionSpec, name: Node) -> Array:
    """Turns of a throw or a disc for one of the crank."""
    return prod((spec.disc[node].ratio.array for node in _inward(spec, name) if isinstance(node, str)), start=ONE)


def torsion_problems(spec: TorsionSpec, design: Design) -> Iterator[Problem]:
    """Find what does not fit the crankshaft, what nothing weighs, and machines whose trains are of another kind."""
    other_trains = list(judged(_other_trains(design)))
    if other_trains:
        yield from other_trains
        return
    n_throws = len(design.shafts[MAIN].throws)
    yield from judged(_counts(spec, n_throws))
    yield from judged(_sizes(spec, n_throws, design))
    yield from judged(_discs(spec, n_throws))
    yield from judged(_weightless(spec, n_throws, design))


def _other_trains(design: Design) -> Iterator[Problem]:
    """Find machines whose trains are of another kind."""
    if len(design.shafts) > 1 or any(place.name != place.cylinder for place in design.places):
        allowed = _("is for a machine with one crankshaft and one piston in a cylinder; this version knows no other")
        yield Problem("torsion", None, allowed)


def _discs(spec: TorsionSpec, n_throws: int) -> Iterator[Problem]:
    """Find discs beside no throw, and one throw with nothing to twist against."""
    allowed = _("must be one of the throws of the shaft `main`, 1 to {n}", n=n_throws)
    for name, disc in spec.disc.items():
        if isinstance(disc.beside, int) and disc.beside > n_throws:
            yield Problem(f"torsion.disc.{name}.beside", str(disc.beside), allowed)
    if n_throws == 1 and not any(disc.is_elastic for disc in spec.disc.values()):
        allowed = _("must hold a disc with a stiffness, or there is nothing that one throw could twist against")
        yield Problem("torsion.disc", None, allowed)


def _weightless(spec: TorsionSpec, n_throws: int, design: Design) -> Iterator[Problem]:
    """Find throws of which nothing says what they weigh."""
    carrying = {place.throw for place in design.places} if design.weighed.bodies else set[int]()
    if spec.throw_inertia is None and (bare := sorted(set(range(n_throws)) - carrying)):
        allowed = _("is missing; in [masses] there is nothing on throw {throws}")
        yield Problem("torsion.throw_inertia", None, allowed.format(throws=", ".join(str(throw + 1) for throw in bare)))


def _counts(spec: TorsionSpec, n_throws: int) -> Iterator[Problem]:
    """Find lists that are as long as neither throws nor gaps are."""
    n_gaps = n_throws - 1
    n_given = 0 if spec.stiffness is None else len(spec.stiffness)
    no_gap = _("is for the gaps between throws; this crankshaft has one throw")
    if n_given and n_gaps == 0:
        yield Problem("torsion.stiffness", None, no_gap)
    elif n_given not in (0, 1, n_gaps):
        allowed = _("must be one value, or one for each gap between throws: {gaps}", gaps=n_gaps)
        yield Problem("torsion.stiffness", _("a list of {n}", n=n_given), allowed)
    numbers = [str(gap) for gap in range(1, n_throws)]
    for name, gap in spec.gap.items():
        if not numbers:
            yield Problem(f"torsion.gap.{name}", None, no_gap)
        elif name not in numbers:
            allowed = _("must be the number of a throw before another: {numbers}", numbers=", ".join(numbers))
            yield Problem(f"torsion.gap.{name}", None, allowed)
        elif not gap.is_elastic:
            yield Problem(f"torsion.gap.{name}.stiffness", None, _("is missing; give it, or length and diameter"))
    if spec.throw_inertia is not None and len(spec.throw_inertia) not in (1, n_throws):
        allowed = _("must be one value, or one for each throw: {throws}", throws=n_throws)
        yield Problem("torsion.throw_inertia", _("a list of {n}", n=len(spec.throw_inertia)), allowed)


def _sizes(spec: TorsionSpec, n_throws: int, design: Design) -> Iterator[Problem]:
    """Find a stiffness that is left out where no sizes give it, and a method for sizes that nobody asks."""
    crankshaft = design.table(CrankshaftSpec)
    table = None if crankshaft is None else table_of(crankshaft, MAIN)
    method, path = spec.stiffness_method, "torsion.stiffness_method"
    if n_throws == 1:
        if method is not None:
            yield Problem(path, method, _("is for the gaps between throws; this crankshaft has one throw"))
    elif not (left := _left_to_sizes(spec, n_throws)):
        if method is not None and spec.stiffness is None:
            yield Problem(
                path, method, _("is for a stiffness by the sizes of [crankshaft]; here all gaps have their own")
            )
    elif table is None:
        if method is not None:
            yield Problem(path, method, _("needs [crankshaft], whose sizes give the stiffness"))
            return
        allowed = _("is missing; give one value, or one for each of the {gaps} gaps between throws, or [crankshaft]")
        if spec.gap:
            allowed = _("is missing; give it for gaps {left} between throws, or [crankshaft]")
        yield Problem("torsion.stiffness", None, allowed.format(gaps=n_throws - 1, left=", ".join(map(str, left))))
    elif line_pins(table, design, MAIN) is None:
        allowed = _("is missing; [crankshaft] gives it where `spacing` of the shaft says where its throws stand")
        yield Problem("torsion.stiffness", None, allowed)
