"""How stiff the straight beam is that bends as a throw does: no single stiffness does for all uses."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.equivalent_stiffness import equivalent_stiffness
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, ShaftLayouts, pin_names
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_THROW = ("pin", "throw_plane")
_PLANES = ("in", "across")


@record
class ThrowBending(StageResult):
    """EI of straight beams in place of throws, in the throw's plane and across; NaN of pins that share a span."""

    bending_by_constant_moment: Array = quantity(
        "EI_c",
        "N*m^2",
        _THROW,
        N_("EI of the straight beam that bends as the throw by equal moments at both ends"),
        _THEORY,
        "24.25",
    )
    bending_by_end_moment: Array = quantity(
        "EI_e",
        "N*m^2",
        _THROW,
        N_("EI of the straight beam that turns at an end as the throw by a moment there"),
        _THEORY,
        "24.26",
    )
    bending_by_pin_force: Array = quantity(
        "EI_p",
        "N*m^2",
        _THROW,
        N_("EI of the straight beam that sags as the throw by a force in mid-pin"),
        _THEORY,
        "24.28",
    )


def throw_bending(layouts: ShaftLayouts, shafts: Shafts) -> ThrowBending:
    """Say how stiff every throw is that stands alone between two bearings.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.25) to (24.28).
    """
    by_shaft = [_of_shaft(layout) for layout in layouts.each]
    constant, near, middle = (np.concatenate(parts, axis=1) for parts in zip(*by_shaft, strict=True))
    names = tuple(name for layout in layouts.each for name in pin_names(layout, shafts))
    return ThrowBending(constant, near, middle, labels={"pin": names, "throw_plane": _PLANES})


def _of_shaft(layout: ShaftLayout) -> tuple[Array, Array, Array]:
    """Of every pin, shape (design, pin, 2). [N·m²]"""
    shaft, declared = layout.shaft, layout.declared
    span = np.sum(declared.centres[0][:, np.newaxis] > declared.bearings[0], axis=-1) - 1
    is_between = (span >= 0) & (span < declared.bearings.shape[1] - 1)
    alone = np.flatnonzero(is_between & (np.sum(span == span[:, np.newaxis], axis=-1) == 1))
    constant, near, middle = (np.full((*declared.centres.shape, len(_PLANES)), np.nan) for _use in range(3))
    stiffness = equivalent_stiffness(shaft, layout.ends, span[alone], layout.pins[alone])
    constant[:, alone], near[:, alone], middle[:, alone] = (
        stiffness.constant_moment,
        stiffness.near_end,
        stiffness.mid_pin,
    )
    return constant, near, middle
