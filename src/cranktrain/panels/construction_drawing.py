"""The steam engine's constructions of a piston's position as a drawing that turns: arcs, projection, Brix's ray."""

from collections.abc import Mapping
from typing import Literal

import numpy as np

from cranktrain.errors import InputError
from cranktrain.language import Words, _
from cranktrain.layout.frames import in_machine_axes
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.constructions import Construction, construction
from cranktrain.plans.placement import first_throw, frame, name_of_output
from cranktrain.record import record
from cranktrain.saying.scales import scale_for
from cranktrain.texts.plain_cranks import PLAIN, own_angle

_STEP = 2.0
"""Between positions, between which a page goes on smoothly. [deg]"""


@record
class ConstructedLine:
    """A straight line from one point to another by their letters, or an arc about a third."""

    start: str
    end: str
    look: Literal["link", "exact", "projection", "ray"]
    about: str = ""


@record
class ConstructionReading:
    """What is read off at a point: by which construction, the displacement over the turn in a unit, shape (n,)."""

    point: str
    name: Words
    look: Literal["exact", "projection", "ray"]
    displacement: Array


@record
class ConstructionDrawing:
    """Constructions on the crank circle.

    Attributes
    ----------
    title : Words
    radius : float
        Of the crank. [m]
    along : Array, shape (2,)
        Direction of the line of stroke away from the shaft.
    foot : Array, shape (2,)
        Where the line of stroke is nearest to the shaft, which is at 0. [m]
    points : mapping of str to Array, shape (2, n)
        By the source's letters: X and Y in the axes of the machine's drawing, at crank angles that stand evenly from 0
        to 360°, both included. [m]
    lines : tuple of ConstructedLine
    readings : tuple of ConstructionReading
    unit : str
        Of what is read.
    note : Words
    """

    title: Words
    radius: float
    along: Array
    foot: Array
    points: Mapping[str, Array]
    lines: tuple[ConstructedLine, ...]
    readings: tuple[ConstructionReading, ...]
    unit: str
    note: Words


_LINES = (
    ConstructedLine("O", "A", "link"),
    ConstructedLine("A", "B", "link"),
    ConstructedLine("A", "C", "exact", about="B"),
    ConstructedLine("A", "D", "projection"),
    ConstructedLine("P", "A′", "ray"),
    ConstructedLine("A′", "D′", "ray"),
)


def construction_drawing(machine: Machine) -> ConstructionDrawing | None:
    """Draw arcs, orthogonal projection and Brix's ray of the first crank or eccentric that is drawn.

    Parameters
    ----------
    machine : Machine

    Returns
    -------
    ConstructionDrawing or None
        None where no drawn mechanism is a slider-crank or an eccentric, or its links cannot close all round.
    """
    place = next((one for one in first_throw(machine) if one.kind.name in PLAIN), None)
    if place is None:
        return None
    shown = np.arange(0.0, 360.0 + _STEP / 2, _STEP)
    own = np.degrees(own_angle(np.deg2rad(shown) + float(machine.zero + place.phase), place.geometry))
    try:
        arcs, projected, rays = (
            construction(machine, method, own.tolist(), mechanism=place.name)
            for method in ("arc", "projection", "brix")
        )
    except InputError:  # the form and the rows say what does not close
        return None
    axes = frame(machine, place)

    def drawn(points: Array) -> Array:
        return np.stack(in_machine_axes(points[0], points[1], axes))

    still = np.zeros((2, shown.size))
    pole = still + np.array([[rays.pole], [0.0]])
    on_line = drawn(np.array([[0.0, 1.0], [arcs.geometry.offset, arcs.geometry.offset]]))
    scale = scale_for("m", arcs.stroke)
    read: dict[str, tuple[Construction, Literal["exact", "projection", "ray"], Words]] = {
        "C": (arcs, "exact", _("arcs of the rod's length, exact")),
        "D": (projected, "projection", _("orthogonal projection, (334)")),
        "D′": (rays, "ray", _("Brix's ray from P, fig. 147")),
    }
    return ConstructionDrawing(
        title=_("Position of {piston} by the source's constructions", piston=name_of_output(machine, place)),
        radius=float(arcs.geometry.crank_radius),
        along=on_line[:, 1] - on_line[:, 0],
        foot=on_line[:, 0],
        points={
            "O": still,
            "A": drawn(projected.on_circle),
            "B": drawn(arcs.piston),
            "P": drawn(pole),
            "A′": drawn(rays.on_circle),
            **{letter: drawn(one.foot) for letter, (one, _look, _words) in read.items()},
        },
        lines=_LINES,
        readings=tuple(
            ConstructionReading(letter, words, look, scale.of(one.displacement))
            for letter, (one, look, words) in read.items()
        ),
        unit=scale.label,
        note=_("S, the way from the top toward the shaft, is read on the line of stroke; letters of [steam-engine]."),
    )
