"""From a card to the diagram of one chamber: read, put in order, placed, pegged, smoothed."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.indicator.brix import brix_angle
from cranktrain.fluids.indicator.card import Card
from cranktrain.fluids.indicator.chamber import Chamber, central_ratio
from cranktrain.fluids.indicator.cycle import Samples, one_cycle
from cranktrain.fluids.indicator.diagram import CURVES, Diagram, diagram_through, smoothed
from cranktrain.fluids.indicator.flags import (
    compression_flags,
    curve_findings,
    level_flags,
    lost_jump_flags,
    refuse_not_positive,
    rounded_jump_flags,
)
from cranktrain.fluids.indicator.noise import eaten_flags, noise_flags
from cranktrain.fluids.indicator.pegging import pegged
from cranktrain.fluids.indicator.placing import placed
from cranktrain.fluids.indicator.unrolling import OutwardAngle, dead_centres_of, unrolled
from cranktrain.language import Words, _
from cranktrain.numerics.ties import first_smallest
from cranktrain.quantities import shown


def indicator_diagram(card: Card, chamber: Chamber) -> Diagram:
    """Make the diagram of a chamber out of a card.

    Parameters
    ----------
    card : Card
    chamber : Chamber

    Returns
    -------
    Diagram
        Counted from the chamber's nominal firing: the file's dead centre is the chamber's true one.

    Raises
    ------
    InputError
        If the file is no diagram of such a machine.
    """
    trace = card.trace
    if trace.axis == "angle":
        _refuse_strokes(card)
        samples = one_cycle(trace, chamber.cycle)
        samples = samples._replace(flags=(*samples.flags, *lost_jump_flags(samples, chamber.cycle)))
        samples = placed(samples, chamber.cycle, card.firing_angle, card.sense)
        samples = _from_nominal(samples, chamber)
    else:
        _refuse_angles(card, trace.axis)
        samples = unrolled(trace, chamber, CURVES[card.interpolation], _outward(card, chamber))
    samples = samples._replace(findings=(*trace.findings, *samples.findings))
    highest = first_smallest(np.abs(samples.pressures - np.max(trace.pressures)))
    if card.peg is not None:
        samples = pegged(samples, _drawn(samples, chamber, card), card.peg, chamber, card.smoothing)
    diagram = _drawn(samples, chamber, card)
    refuse_not_positive(card, diagram.curve)
    sentences = curve_findings(diagram.curve, samples, highest, dead_centres_of(chamber.volume).top)
    flags = _flags(samples, diagram, chamber, card)
    return replace(diagram, findings=(*samples.findings, *sentences), flags=tuple(flags))


def _drawn(samples: Samples, chamber: Chamber, card: Card) -> Diagram:
    """Lay the curve through samples, smoothed if they are to be."""
    diagram = diagram_through(samples, chamber.cycle, card.interpolation)
    return diagram if card.smoothing is None else smoothed(diagram, card.smoothing, card.interpolation)


def _flags(samples: Samples, diagram: Diagram, chamber: Chamber, card: Card) -> Iterator[Words]:
    """Flag what the file has and what has become of it: levels and compression as they are used."""
    used = samples
    if card.smoothing is not None:
        used = samples._replace(angles=diagram.curve.places, pressures=diagram.curve.starts)
    yield from level_flags(used.pressures)
    yield from samples.flags
    yield from compression_flags(used, chamber)
    if card.smoothing is None:
        yield from noise_flags(samples)
    else:
        raw = diagram_through(samples, chamber.cycle, card.interpolation)
        yield from eaten_flags(raw, diagram, card.smoothing, card.interpolation)
    if card.interpolation == "spline" or card.smoothing is not None:
        yield from rounded_jump_flags(samples)


def _refuse_angles(card: Card, axis: str) -> None:
    """Refuse what only a file over the crank angle can have: strokes over a volume are told by their pressures."""
    allowed = _("is for a file over the crank angle; this one is over {axis}", axis=axis)
    given = {"firing_angle": card.firing_angle is not None, "sense": card.sense != "forward"}
    wrong = [Problem(name, None, allowed) for name, is_given in given.items() if is_given]
    if wrong:
        raise InputError(wrong)


def _refuse_strokes(card: Card) -> None:
    """Refuse a way of unrolling for a file that is over the crank angle as it is."""
    if card.unrolling != "exact":
        raise InputError([Problem("unrolling", card.unrolling, _("is for a file over volume or displacement"))])


def _from_nominal(samples: Samples, chamber: Chamber) -> Samples:
    """Count from nominal firing, where the file counts from the dead centre: an offset sets them apart."""
    top = dead_centres_of(chamber.volume).top
    if top == 0.0:
        return samples
    angles = np.mod(samples.angles + top, chamber.cycle)
    order = np.argsort(angles, kind="stable")
    sentence = _(
        "The file's dead centre is put on the machine's true one, {angle} from where the crank lies along the cylinder."
    )
    sentence = sentence.format(angle=f"{shown(top, 'deg'):.3f}°")
    return samples._replace(
        angles=angles[order], pressures=samples.pressures[order], findings=(*samples.findings, sentence)
    )


def _outward(card: Card, chamber: Chamber) -> OutwardAngle | None:
    """Choose how displacements become crank angles."""
    if card.unrolling == "exact":
        return None
    ratio = central_ratio(chamber)
    if ratio is None:
        allowed = _("is for a central slider-crank only; its construction knows no other mechanism")
        raise InputError([Problem("unrolling", card.unrolling, allowed)])
    return lambda travelled: brix_angle(2.0 * travelled, np.array(1.0), ratio)
