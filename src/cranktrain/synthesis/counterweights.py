"""Counterweights that relieve the main bearings of a crankshaft: of all within limits those that leave least."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, Literal

import numpy as np

from cranktrain.analysis.parts import refuse_wrong
from cranktrain.declared_types import words_of
from cranktrain.errors import Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.quantities import unlisted
from cranktrain.record import record
from cranktrain.saying.wording import number
from cranktrain.synthesis.added_weights import AddedWeights
from cranktrain.synthesis.counterweight_numbers import (
    Aimed,
    FoundWeights,
    State,
    compared_numbers,
    relief_numbers,
    relief_remarks,
)
from cranktrain.synthesis.proposal import Alternative, Length, Mass, Proposal, Ratio, not_positive, quantity_text
from cranktrain.synthesis.relief import Progress, least_largest_load, least_mean_load, without_idle
from cranktrain.synthesis.relieved_bearings import (
    Method,
    SoughtBearings,
    WeightedShaft,
    sought_bearings,
    weighted_shaft,
)
from cranktrain.synthesis.weight_places import (
    Kept,
    WeightPlace,
    alike_places,
    chosen_throws,
    kept_balance,
    throw_places,
    web_places,
)

Aim = Literal["largest", "mean"]
Weights = Literal["each", "alike", "mirrored", "webs"]
Angle = Literal["opposite", "free"]

_START, _MORE = 7 / 16, 0.5
"""Of what each weight may be: in the design that the others are compared with, and by how much one of these is more."""
_USUAL_SHARE = 2.0
"""Of a full counterweight: how heavy each may be where nothing else says it."""


@record
class CounterweightProposal(Proposal):
    """Counterweights for a machine that there is; its tables are those of the weights alone.

    Attributes
    ----------
    machine : Machine
        With them.
    taken_out : tuple of str
        Paths of what the file has instead of them.
    """

    machine: Machine
    taken_out: tuple[str, ...]


def counterweights(
    machine: Machine,
    bearing: Annotated[str, N_("Name of a main bearing, or all; all unless given.")] = "all",
    aim: Annotated[Aim, N_("What is to be least, the largest load or the mean; the largest unless given.")] = "largest",
    *,
    method: Annotated[
        Method | None, N_("Of finding loads; the best that the file has numbers for unless given.")
    ] = None,
    weights: Annotated[
        Weights, N_("Each throw has its own unless given; or all alike, or mirrored about the middle, or on webs.")
    ] = "each",
    angle: Annotated[Angle, N_("Opposite their throws, or free; opposite unless given.")] = "opposite",
    throws: Annotated[str | None, N_("Throws that may have weights, such as 1,4; all unless given.")] = None,
    radius: Annotated[Length | None, N_("Of the weights' centroids; that of the crank unless given.")] = None,
    largest_mass: Annotated[Mass | None, N_("Of a weight.")] = None,
    largest_share: Annotated[
        Ratio | None, N_("Of a full counterweight, for all that rotates; 2 unless a mass is given.")
    ] = None,
    afresh: Annotated[bool, N_("Take out the counterweights that the file has.")] = False,
    progress: Progress | None = None,
) -> CounterweightProposal:
    """Propose the counterweights that leave the least load in a main bearing, or in all.

    Parameters
    ----------
    machine : Machine
        With a [crankshaft] and all that its loads need.
    bearing : str
        Name of a main bearing of the shaft `main`, or `all`.
    aim : str
        `largest` or `mean`; of all bearings, the largest load of any, or the mean of all.
    method : str, optional
        One of the linear methods.
    weights : str
        `each` throw has its own, all are `alike`, or `mirrored` about the shaft's middle; or each of the `webs` has.
    angle : str
        `opposite` their throws, or `free`.
    throws : str, optional
        Numbers of throws with commas between.
    radius : float, optional
        [m]
    largest_mass : float, optional
        Of each weight, at that radius. [kg]
    largest_share : float, optional
        Of the full counterweight, Σ m ρ = m_rot R, of a throw. [1]
    afresh : bool
        Whether counterweights of the file, given or solved for, are to be replaced; else what is found comes to them.
    progress : callable, optional
        Is given now and then, while it searches, the load reached and what nothing goes below. [N]

    Returns
    -------
    CounterweightProposal
        With `load` and `mean_load` of what was aimed at, `share`, `shaking_force` and `shaking_couple` of order 1;
        `mass(1)`, … of every place; `largest_load(1)`, `largest_before(1)`, `mean_load(1)`, `mean_before(1)`, … of
        every bearing. The alternatives are the file as it is, and full counterweights.

    Raises
    ------
    InputError
        With all that is wrong with what was asked, or what the file lacks.

    Notes
    -----
    docs/theory/synthesis, eqs. (8.33) to (8.37).
    """
    asked = {"aim": (aim, Aim), "weights": (weights, Weights), "angle": (angle, Angle)}
    limits = {"radius": radius, "largest_mass": largest_mass, "largest_share": largest_share}
    refuse(_impossible(limits, asked))
    refuse_wrong((machine,))
    sought, n_throws = sought_bearings(machine, bearing, method), len(machine.main_shaft.throws)
    chosen, wrong = chosen_throws(throws, n_throws)
    kept = kept_balance(machine, afresh=afresh)
    refuse([*wrong, *_solved_for(machine, kept)])
    places = throw_places(machine, sought.layout, kept)
    places = web_places(places, sought.layout) if weights == "webs" else places
    places = [place for place in places if place.throw in chosen]
    radii = np.array([place.crank_radius if radius is None else radius for place in places])
    most = _most(places, radii, largest_mass, largest_share)
    groups = list(alike_places(places, weights, n_throws))
    spread = np.zeros((len(places), len(groups)))
    for unknown, group in enumerate(groups):
        spread[group, unknown] = np.min(most[group])
    turns = angle == "free"
    added = AddedWeights(machine, kept, places, radii, turns)
    shaft = _shaft(added, spread, sought, turns=turns)
    least = (least_largest_load if aim == "largest" else least_mean_load)(shaft, turns=turns, progress=progress)
    moment = spread @ _turned(without_idle(shaft, least.unknown, turns=turns), turns=turns)
    aimed = Aimed(sought.method.name, sought.layout.declared.bearing_names, sought.bearings, aim)
    weighed = FoundWeights(places, moment, np.max(spread, axis=1), radii)
    made = added.machine(moment)
    before, after = aimed.state(machine), aimed.state(made)
    return CounterweightProposal(
        title=_title(machine, aimed),
        numbers=relief_numbers(aimed, weighed, before, after),
        alternatives=tuple(_alternatives(aimed, added, weighed, before=before)),
        remarks=tuple(relief_remarks(aimed, weighed, least, kept)),
        tables=tuple(added.tables(moment, aimed.title, is_radius_wanted=radius is not None)),
        machine=made,
        taken_out=kept.taken_out,
    )


def _impossible(limits: Mapping[str, float | None], asked: Mapping[str, tuple[str, Any]]) -> Iterator[Problem]:
    """Find limits that leave nothing, and words that there are not."""
    units = {"radius": "mm", "largest_mass": "kg"}
    for name, value in limits.items():
        yield from not_positive(
            {name: value}, lambda size, name=name: quantity_text(size, units[name]) if name in units else f"{size:g}"
        )
    for name, (word, known) in asked.items():
        if word not in words_of(known):
            yield unlisted(name, word, words_of(known))


def _solved_for(machine: Machine, kept: Kept) -> Iterator[Problem]:
    """Find counterweights that the file has solved for, beside which there is nothing to be found."""
    if "counterweights" in kept.table:
        allowed = _("are solved for in the file, and would change with what is found")
        yield Problem("balance.counterweights", None, allowed, _("ask for the weights afresh, in place of those"))


def _most(
    places: Sequence[WeightPlace], radius: Array, largest_mass: float | None, largest_share: float | None
) -> Array:
    """Mass times radius that each weight may have, shape (place,). [kg·m]"""
    by_mass = np.full(len(places), np.inf) if largest_mass is None else largest_mass * radius
    share = _USUAL_SHARE if largest_share is None and largest_mass is None else largest_share
    by_share = np.array([np.inf if share is None else share * place.full - place.there for place in places])
    problems: list[Problem] = []
    for place, own in zip(places, by_share.tolist(), strict=True):
        if not place.full > 0 and not own > 0:
            allowed = _("is missing: on throw {throw} nothing rotates that says how heavy a weight may be")
            problems.append(Problem("largest_mass", None, allowed.format(throw=place.throw)))
        elif not own > 0:
            allowed = _("must be more than the weights that throw {throw} has: {there} of a full counterweight")
            there = number(place.there / place.full, "%")
            repair = _("or ask for the weights afresh, in place of those")
            problems.append(Problem("largest_share", None, allowed.format(throw=place.throw, there=there), repair))
    refuse(problems[:1])
    return np.minimum(by_mass, by_share)


def _shaft(added: AddedWeights, spread: Array, sought: SoughtBearings, *, turns: bool) -> WeightedShaft:
    """The shaft with weights: one design of middling ones, and one for each unknown with more of it."""
    n = spread.shape[1]
    start = np.concatenate([np.full(n, _START), np.zeros(n if turns else 0)])
    designs = [
        added.machine(spread @ _turned(one, turns=turns)) for one in (start, *(start + _MORE * np.eye(start.size)))
    ]
    return weighted_shaft(designs, start, _MORE, sought.which, sought.method, sought.bearings)


def _turned(unknown: Array, *, turns: bool) -> ComplexArray:
    """Unknowns as vectors: opposite the throw, + i ahead of it."""
    if not turns:
        return unknown.astype(np.complex128)
    return unknown[: unknown.size // 2] + 1j * unknown[unknown.size // 2 :]


def _title(machine: Machine, aimed: Aimed) -> Words:
    """Whose counterweights, and for what."""
    if machine.name:
        return _("{machine}: counterweights for the {aim}", machine=machine.name, aim=aimed.title)
    return _("Counterweights for the {aim}", aim=aimed.title)


def _alternatives(aimed: Aimed, added: AddedWeights, weighed: FoundWeights, *, before: State) -> Iterator[Alternative]:
    """The file as it is, and full counterweights."""
    share = np.nan if added.kept.taken_out else weighed.share(np.zeros(1))
    yield Alternative(_("as the file has it"), compared_numbers(aimed, before, share))
    more = weighed.full - weighed.there
    if np.all(more > 0):
        full = aimed.state(added.machine(more.astype(np.complex128)))
        yield Alternative(_("full counterweights"), compared_numbers(aimed, full, weighed.share(more)))
