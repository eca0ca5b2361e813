"""A machine's drawing as data: where pins are at crank angles, what joins and leads them, what loads them.

All lengths are in metres, X right and Y up from the centre of the main shaft, seen from the free end.
"""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any, cast

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.mechanisms.drawing import Block
from cranktrain.motion import Array
from cranktrain.panels.crosshead import CrossheadDrawing
from cranktrain.panels.ram import RamDrawing
from cranktrain.record import record

__all__ = [
    "CrossheadDrawing",
    "GuideDrawing",
    "LinkDrawing",
    "LoadDrawing",
    "MachineDrawing",
    "MechanismDrawing",
    "OutputDrawing",
    "RamDrawing",
    "ShaftDrawing",
]


@record
class ShaftDrawing:
    """A shaft that carries mechanisms.

    Attributes
    ----------
    name : str
    centre : Array, shape (2,)
        [m]
    is_assumed : bool
        Whether its place is not of the file, but taken so that its pistons face those of the main shaft.
    sense : float
        +1 where it turns anticlockwise, −1 where it turns clockwise.
    """

    name: str
    centre: Array
    is_assumed: bool
    sense: float


@record
class LinkDrawing:
    """A link: its name, the pins that it joins in order, and whether it turns with the shaft, as a crank does."""

    name: str
    pins: tuple[str, ...]
    is_crank: bool


@record
class GuideDrawing:
    """A straight guide.

    Attributes
    ----------
    pin : str
        What slides in it.
    direction : float
        From X, anticlockwise. [rad]
    foot : Array, shape (2,)
        Point of its line that is nearest the mechanism's shaft; NaN where the links close at no angle. [m]
    """

    pin: str
    direction: float
    foot: Array


@record
class OutputDrawing:
    """The slider that a mechanism drives, on its line of stroke.

    Attributes
    ----------
    pin : str
    foot : Array, shape (2,)
        Point of the line that is nearest the shaft. [m]
    along : Array, shape (2,)
        Unit vector of the line.
    travel : Array, shape (2,)
        Nearest and farthest place of the pin along the line, from the foot; of every half degree where the links close
        over a part of the turn only. [m]
    bore : float or None
        Of its cylinder; None where the file has none, and the slider runs between guides. [m]
    is_valve : bool
        Whether it is a valve, which bears no load.
    is_far : bool
        Whether it bounds its cylinder from the far side, driven by side rods: its crown is then the end toward its
        shaft.
    port : float or None
        Height of the ports that it opens. [m]
    crosshead : CrossheadDrawing or None
        Of a piston that works at its crank end, too: the pin is then the crosshead's, and a rod leads to the piston.
    ram : RamDrawing or None
        Of a slider without a cylinder that works downward, as a press's.
    """

    pin: str
    foot: Array
    along: Array
    travel: Array
    bore: float | None
    is_valve: bool
    is_far: bool
    port: float | None
    crosshead: CrossheadDrawing | None
    ram: RamDrawing | None


@record
class MechanismDrawing:
    """One mechanism, where it stands, at n crank angles.

    Attributes
    ----------
    name, kind, cylinder, bank, shaft : str
    throw : int
        Which of the shaft's, from 1.
    is_slave : bool
        Whether its rod hangs on another mechanism's.
    is_outlined : bool
        Whether its links are drawn in outline, as an engine's, and not as lines.
    crank_zero : float
        Direction of its crank from X where the shown crank angle is 0. [rad]
    pins : mapping of name to Array, shape (2, n)
        X and Y; NaN where the links cannot close. [m]
    links : tuple of LinkDrawing
        The crank first; every link after those that hold its first pin.
    guides : tuple of GuideDrawing
        The output's first.
    blocks : tuple of Block
        Pins that slide along a link, with that link's pins; one pin of a link that never turns.
    fixed : tuple of str
        Pins that stand still.
    ends : tuple of str
        Pins that only show how far a link reaches.
    points : tuple of str
        Points on links that the machine file asks to follow.
    paths : mapping of name to Array, shape (2, m)
        Where pins go at every 3° of a turn, from the shown crank angle 0 to 360°. [m]
    output : OutputDrawing or None
        None of a rocker.
    """

    name: str
    kind: str
    cylinder: str
    bank: str
    shaft: str
    throw: int
    is_slave: bool
    is_outlined: bool
    crank_zero: float
    pins: Mapping[str, Array]
    links: tuple[LinkDrawing, ...]
    guides: tuple[GuideDrawing, ...]
    blocks: tuple[Block, ...]
    fixed: tuple[str, ...]
    ends: tuple[str, ...]
    points: tuple[str, ...]
    paths: Mapping[str, Array]
    output: OutputDrawing | None


@record
class LoadDrawing:
    """A load of the machine file on a link, at n crank angles.

    Attributes
    ----------
    name, mechanism, link : str
        As the file calls it; on what it acts: of a torque on a shaft no mechanism, and the shaft by its name.
    is_torque : bool
    is_rope : bool
        Whether its direction stays, off an arc about the link's first pin.
    size : Array, shape (n,)
        Along its way, less than 0 against that; of a torque anticlockwise; NaN of one that is found so that it balances
        the machine. [N or N·m]
    largest : float
        Largest size of all forces on what is drawn over the cycle, or of all torques: what arrows are in parts of.
        [N or N·m]
    unit : str
        In which sizes are shown.
    one : float
        What one of it is. [N or N·m]
    way : Array, shape (2, n)
        Unit vector in which a force acts; 0 of a torque.
    place : Array, shape (2, n)
        Where it acts; of a torque the link's first pin. [m]
    pin : Array, shape (2, n)
        The link's first pin. [m]
    """

    name: str
    mechanism: str
    link: str
    is_torque: bool
    is_rope: bool
    size: Array
    largest: float
    unit: str
    one: float
    way: Array
    place: Array
    pin: Array


@record
class MachineDrawing:
    """A machine at n crank angles, all mechanisms of every throw.

    Attributes
    ----------
    name : str
        Of the machine.
    crank_angle : Array, shape (n,)
        As the machine shows it. [deg]
    shafts : tuple of ShaftDrawing
        Those that carry a mechanism which is drawn.
    mechanisms : tuple of MechanismDrawing
        In the order of the file.
    left_out : tuple of str
        Mechanisms on shafts whose place is not known.
    loads : tuple of LoadDrawing
        None where the file has no loads or no speed, or where links cannot close all round.
    bounds : Array, shape (2, 2)
        Lower left and upper right corner, one after the other, of where pins come at every 3° of a turn. [m]
    unit : str
        In which lengths are said.
    one : float
        One of it. [m]
    """

    name: str
    crank_angle: Array
    shafts: tuple[ShaftDrawing, ...]
    mechanisms: tuple[MechanismDrawing, ...]
    left_out: tuple[str, ...]
    loads: tuple[LoadDrawing, ...]
    bounds: Array
    unit: str
    one: float

    def mechanism(self, name: str) -> MechanismDrawing:
        """Give a mechanism by its name.

        Raises
        ------
        InputError
            If none that is drawn has it.
        """
        found = next((one for one in self.mechanisms if one.name == name), None)
        if found is None:
            names = ", ".join(one.name for one in self.mechanisms)
            allowed = _("must be one of the mechanisms that are drawn: {names}", names=names)
            raise InputError([Problem("mechanism", name, allowed)])
        return found

    def to_dict(self) -> dict[str, Any]:
        """Give all of it as JSON has it: records as objects by their fields, arrays as lists, NaN as null."""
        return cast("dict[str, Any]", _plain(self))


def _plain(value: Any) -> object:
    """Give data as dicts, lists, texts, numbers, truths and None."""
    if is_dataclass(value):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, Block):
        return _plain(value._asdict())
    if isinstance(value, Mapping):
        return {name: _plain(one) for name, one in cast("Mapping[str, object]", value).items()}
    if isinstance(value, np.ndarray):
        return _plain(cast(Array, value).tolist())
    if isinstance(value, list | tuple):
        return [_plain(one) for one in cast("list[object]", value)]
    return None if isinstance(value, float) and not np.isfinite(value) else value
