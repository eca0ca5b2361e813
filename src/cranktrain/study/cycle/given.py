"""What the compiled cycle is given: numbers of all designs as arrays, and room to work in."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.study.cycle.tops import Tops

Places = NDArray[np.intp]


class OfKind(NamedTuple):
    """Mechanisms of one kind.

    Attributes
    ----------
    mechanism, piston, master : array of int, shape (member,)
        Which of the machine's mechanisms each is; which piston, −1 for none; on whose rod it hangs, −1 for the crank.
    joint : array of int, shape (member, reaction)
        Which of the machine's joints each reaction is; −1 for a share of its master's.
    phase : Array, shape (design, member)
        [rad]
    ahead : Array, shape (design, member, 2)
        Its cosine and its sine.
    geometry : Array, shape (design, member, number)
        As the kind's kernels take them, in their order.
    bodies : Array, shape (design, member, 4 · link)
    gravity : Array, shape (design, member, 2)
        In the mechanism's axes. [m/s²]
    """

    mechanism: Places
    piston: Places
    master: Places
    joint: Places
    phase: Array
    ahead: Array
    geometry: Array
    bodies: Array
    gravity: Array


class OfFluid(NamedTuple):
    """Chambers that hold one fluid: which, and what its pressure takes, shape (design, own chamber, number)."""

    places: Places
    numbers: Array


class ChamberNumbers(NamedTuple):
    """The working chambers.

    Attributes
    ----------
    partner : array of int, shape (chamber, 2)
        Pistons that work in each; of a single one, that again, with an area of 0.
    area : Array, shape (design, chamber, 2)
        Of these, signed. [m²]
    start : Array, shape (design, chamber)
        Volume with all pistons at their tops. [m³]
    top : Array, shape (design, piston)
        Distance of each piston pin from its shaft there. [m]
    ambient, smallest, largest : Array, shape (design, chamber)
        [Pa, m³, m³]
    firing, least, greatest : Array, shape (design, chamber)
        φ of nominal firing, of the least volume there and of the greatest. [rad]
    kink : Array, shape (design, chamber, kink)
        Volumes at which the pressure is not smooth; NaN for none. [m³]
    sense, turn : Array, shape (kink,)
        On which branch each is.
    """

    partner: Places
    area: Array
    start: Array
    top: Array
    ambient: Array
    smallest: Array
    largest: Array
    firing: Array
    least: Array
    greatest: Array
    kink: Array
    sense: Array
    turn: Array


class TurningDesigns(NamedTuple):
    """How it turns: speed, and φ where the shown angle is 0, shape (design,); and the cycle. [rad/s, rad]"""

    speed: Array
    zero: Array
    cycle: float


class EvennessAsked(NamedTuple):
    """What is asked of how evenly it runs.

    Attributes
    ----------
    inertia : Array, shape (design, 1), or (design, 0) where there is no flywheel
        [kg·m²]
    coefficient : Array, shape (design, 1), or (design, 0) where none is wanted
    """

    inertia: Array
    coefficient: Array


class OfRepeats(NamedTuple):
    """What is alike where a cycle repeats itself; of no design where there is one mechanism alone.

    Attributes
    ----------
    kind, piston, master : array of int, shape (mechanism,)
        Of one number where it is of one kind; its piston, −1 for none; on whose rod it hangs, −1 for the crank.
    phase, firing : Array, shape (design, mechanism)
        Of its crank, and of nominal firing in the first of its chambers, NaN for none. [rad]
    numbers : Array, shape (design, mechanism, number)
        Its geometry, bodies, gravity; 0 behind those of its kind.
    fluid : array of int, shape (chamber,)
    partner : array of int, shape (chamber, 2)
        As of `ChamberNumbers`.
    angles : Array, shape (design, chamber, 3)
        φ of nominal firing, of the least volume and of the greatest. [rad]
    volumes : Array, shape (design, chamber, number)
        Areas, volumes, pressures, numbers of the fluid.
    """

    kind: Places
    piston: Places
    master: Places
    phase: Array
    firing: Array
    numbers: Array
    fluid: Places
    partner: Places
    angles: Array
    volumes: Array


class Repeats(NamedTuple):
    """What stands in each one's place after the part of a cycle that may repeat itself.

    Attributes
    ----------
    mechanism : array of int, shape (mechanism,)
    piston : array of int, shape (piston,)
    chamber : array of int, shape (chamber,)
    is_taken : array of bool, shape (mechanism,)
        Which of the mechanisms stand in another's place already.
    is_first : array of bool, shape (chamber,)
        Which chambers the others repeat.
    """

    mechanism: Places
    piston: Places
    chamber: Places
    is_taken: NDArray[np.bool_]
    is_first: NDArray[np.bool_]


class Work(NamedTuple):
    """Room for the curves of one design at the points of its panels, and for what they are made of.

    Attributes
    ----------
    cos, sin : Array, shape (point,)
        Of the crank angle φ.
    slider : Array, shape (piston, point)
        Distance of each pin from its shaft. [m]
    push : Array, shape (piston, point)
        Force of the gas on each, toward its shaft. [N]
    gas : Array, shape (point,)
        Pressure of one chamber. [Pa]
    on_rod : Array, shape (3, mechanism, point)
        What slaves do to each rod. [N, N, N·m]
    repeats : Repeats
    pole, away : Array, shape (chamber,)
        φ of the poles beside least volumes, and how far they are from the real axis. [rad]
    torque : Array, shape (2, point)
        Of the machine, and the sizes of what each mechanism has of it together. [N·m]
    running : Array, shape (4, point)
        Torque without inertia, inertia, excess work, and room for a curve. [N·m, kg·m², J]
    pressure : Array, shape (chamber, point)
        [Pa]
    joint_x, joint_y : Array, shape (joint, point)
        [N]
    rod : Array, shape (4, piston, point)
        P, N, and S at the piston pin and at the other one. [N]
    tops : Tops
    speeds : Array, shape (5,)
        As `Found.running` of one design. [rad/s, rad]
    """

    cos: Array
    sin: Array
    slider: Array
    push: Array
    gas: Array
    on_rod: Array
    repeats: Repeats
    pole: Array
    away: Array
    torque: Array
    running: Array
    pressure: Array
    joint_x: Array
    joint_y: Array
    rod: Array
    tops: Tops
    speeds: Array


class Found(NamedTuple):
    """What is found of each design; NaN of what is not asked, or of a design that is left to `run`.

    Attributes
    ----------
    is_known : array of bool, shape (design,)
    torque : Array, shape (design, 5)
        Largest, its angle, smallest, its angle, and the largest that all mechanisms have together. [N·m, rad]
    pressure : Array, shape (design, chamber, 2)
        Largest, and its angle. [Pa, rad]
    joint : Array, shape (design, joint, 2)
        Largest force, its angle. [N, rad]
    rod : Array, shape (design, piston, 6)
        Largest P, N and S, each with its angle. [N, rad]
    work : Array, shape (design,)
        Largest excess work. [J]
    flywheel : Array, shape (design, 6)
        Flywheels by each method, and what fluctuation each gives. [kg·m², 1]
    running : Array, shape (design, 5)
        Largest speed, its angle, smallest, its angle, mean over the crank angle. [rad/s, rad]
    n_panels : array of int, shape (design,)
        How many panels each design has; with their points kept where something else is asked of these.
    panel : Array, shape (design, 2, panel)
        Where each begins, and how wide it is. [rad]
    row : array of int, shape (design, panel)
        Its size, as of `PanelNodes`.
    angle : Array, shape (design, point)
        φ of the points; beyond a design's own 0. [rad]
    push : Array, shape (design, piston, point)
        Force of the gas there, of the panel's own side of a jump. [N]
    """

    is_known: NDArray[np.bool_]
    torque: Array
    pressure: Array
    joint: Array
    rod: Array
    work: Array
    flywheel: Array
    running: Array
    n_panels: Places
    panel: Array
    row: Places
    angle: Array
    push: Array
