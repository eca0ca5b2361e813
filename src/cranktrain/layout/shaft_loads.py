"""Loads of a machine file on a shaft: torques of given size, or of one found so that it balances the machine."""

from collections.abc import Container, Iterator, Mapping
from functools import partial
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.load_laws import ByAngle, Law, LoadState
from cranktrain.layout.load_tables import LoadSpec, LoadTables
from cranktrain.layout.loads import LOAD, Laid, is_on_shaft, law_of
from cranktrain.motion import ZERO, Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.polyline import polyline_mean
from cranktrain.record import record


class TorqueOnShaft(NamedTuple):
    """One load on one shaft.

    Attributes
    ----------
    name, shaft : str
        Of the load, and of the shaft that it is on.
    sense : float
        In which its size counts as the shaft runs: −1 where it resists.
    law : Law
        Of its size. [N·m] One that balances the machine has its shape here: 1 at 1 rad/s, or the torques as given.
    is_balanced, resists : bool
    """

    name: str
    shaft: str
    sense: float
    law: Law
    is_balanced: bool
    resists: bool

    def value(self, shown: Array, speed: Array) -> Array:
        """Torque as the shaft runs, at crank angles as they are shown and speeds, shape (design, 1, n). [N·m]"""
        return self.sense * self.law.value(LoadState(*np.broadcast_arrays(shown, ZERO, speed)))


@record
class LoadsOnShafts:
    """Loads on the shafts of a machine, which all turn alike fast: their torques add up at the crank."""

    needs: ClassVar[str] = N_('[load.NAME] on = "main"')

    each: tuple[TorqueOnShaft, ...]

    @property
    def given(self) -> tuple[TorqueOnShaft, ...]:
        """Those whose sizes are known."""
        return tuple(load for load in self.each if not load.is_balanced)

    @property
    def balanced(self) -> TorqueOnShaft | None:
        """The one whose size is found."""
        return next((load for load in self.each if load.is_balanced), None)


def shaft_loads_of(designs: Designs, together: LoadTables) -> LoadsOnShafts | None:
    """Put the loads of all designs, as `tables_together` gives them, to the shafts; None where there is none."""
    whole = designs.together
    found = torques_on_shafts(together, whole.shafts, designs.by_design, is_astern=whole.orientation.is_astern)
    return LoadsOnShafts(found) if found else None


def torques_on_shafts(
    loads: LoadTables, shafts: Container[str], laid: Laid, *, is_astern: bool
) -> tuple[TorqueOnShaft, ...]:
    """Put loads to shafts, their numbers laid into arrays of all designs, of a machine that runs astern or not."""
    return tuple(
        TorqueOnShaft(
            name,
            spec.on,
            -1.0 if spec.sense == "resisting" or is_astern else 1.0,
            law_of(laid, spec),
            spec.is_balanced,
            spec.sense == "resisting",
        )
        for name, spec in loads.get(LOAD, {}).items()
        if is_on_shaft(LOAD, spec, shafts)
    )


def on_shafts(design: Design) -> Mapping[str, LoadSpec]:
    """Loads of the file that are on a shaft: torques of the machine's own table, on a shaft's name."""
    own = design.loads.get(LOAD, {})
    return {name: spec for name, spec in own.items() if is_on_shaft(LOAD, spec, design.shafts)}


def _mean(spec: LoadSpec) -> float:
    """Mean of a load's sizes over the crank angles. [N·m]"""
    law = law_of(partial(by_design, n_designs=1), spec)
    assert isinstance(law, ByAngle)
    return polyline_mean(law.polylines[0])


def shaft_load_problems(design: Design) -> Iterator[Problem]:
    """Find what a shaft has not, and two loads that would both balance the machine."""
    balanced = ""
    for name, spec in on_shafts(design).items():
        where = f"{LOAD}.{name}"
        allowed = _("is for what goes to and fro, and a shaft turns all round; list the sizes over crank_angles")
        given = {"swing": spec.swing, "torque_back": spec.torque_back, "counts": spec.counts == "against" or None}
        yield from (Problem(f"{where}.{key}", None, allowed) for key, one in given.items() if one is not None)
        if spec.is_balanced and balanced:
            allowed = _("must not stand beside [load.{other}], which balances the machine", other=balanced)
            yield Problem(f"{where}.scale", spec.scale, allowed)
        if spec.is_balanced and spec.crank_angles is not None and _mean(spec) <= 0:
            allowed = _('must have a mean of more than 0, or no factor makes them a load; or write scale = "given"')
            yield Problem(f"{where}.torque", None, allowed)
        balanced = name if spec.is_balanced else balanced
