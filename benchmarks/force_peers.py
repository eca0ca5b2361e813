"""The slider-crank of `tests/golden/slider_crank_inertia` in kinepy and in Exudyn: motion, reactions and torque.

kinepy finds positions by the mechanism's geometry and accelerations by second differences over the grid, whose first
and last points stay empty: it is given one angle more at either end. Exudyn steps the bodies through one turn with
their joints as constraints, the crank's angular velocity among these: index 2, Newmark's method without damping. Both
models are made beforehand; only their solutions are timed.
"""

import contextlib
import csv
import io
import json
import warnings
from math import tau
from pathlib import Path
from typing import NamedTuple

import exudyn
import kinepy
import numpy as np
from exudyn import itemInterface as items
from kinepy import units

CASE = Path(__file__).parent.parent / "tests" / "golden" / "slider_crank_inertia"
COLUMNS = {
    "F_main_on_crank_x_N": 1.0,
    "F_main_on_crank_y_N": 1.0,
    "F_crankpin_on_crank_x_N": -1.0,
    "F_crankpin_on_crank_y_N": -1.0,
    "F_wrist_on_piston_x_N": 1.0,
    "F_wrist_on_piston_y_N": 1.0,
    "N_wall_on_piston_y_N": 1.0,
    "T_drive_Nm": 1.0,
}
"""What each way gives, in order: the case's columns, with -1 where the case has the force on the other body."""


class Machine(NamedTuple):
    """A central slider-crank under its inertia alone. [m, kg, kg·m², rad/s]

    Centres of mass: the crank's along its throw from the shaft, the rod's from the crank pin.
    """

    crank_radius: float
    rod_length: float
    crank: tuple[float, float, float]
    rod: tuple[float, float, float]
    piston: tuple[float, float]
    speed: float


def machine():
    """Give the machine of the case: of crank and rod mass, centre of mass and inertia about it."""
    given = json.loads((CASE / "case.json").read_text(encoding="utf-8"))["machine"]
    return Machine(
        given["crank_radius_m"],
        given["rod_length_m"],
        (given["crank_mass_kg"], given["crank_com_x_m"], given["crank_inertia_about_com_kgm2"]),
        (given["rod_mass_kg"], given["rod_com_from_crankpin_m"], given["rod_inertia_about_com_kgm2"]),
        (given["piston_mass_kg"], given["piston_inertia_about_com_kgm2"]),
        given["crank_speed_rad_s"],
    )


def error(columns):
    """Largest error against the case's 40-digit numbers, of each column's peak; a whole number of angles a degree."""
    with (CASE / "expected.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))[:360]
    expected = np.array([[sign * float(row[name]) for row in rows] for name, sign in COLUMNS.items()])
    every = len(columns[0]) // 360
    return max(
        np.max(np.abs(column[::every] - exact)) / np.max(np.abs(exact))
        for column, exact in zip(columns, expected, strict=True)
    )


def kinepy_forces(machine, n):
    """A solution at n angles of a turn from 0, and how its columns are read, each without arguments."""
    units.set_unit_system(units.SI)
    system = kinepy.System()
    crank = system.add_solid("crank", machine.crank[0], machine.crank[2], (machine.crank[1], 0.0))
    rod = system.add_solid("rod", machine.rod[0], machine.rod[2], (machine.rod[1], 0.0))
    piston = system.add_solid("piston", *machine.piston)
    main = system.add_revolute(0, crank)
    pin = system.add_revolute(crank, rod, (machine.crank_radius, 0.0))
    wrist = system.add_revolute(rod, piston, (machine.rod_length, 0.0))
    guide = system.add_prismatic(0, piston)
    angles = np.arange(-1, n + 1) * (tau / n)
    with contextlib.redirect_stdout(io.StringIO()):
        system.pilot(main)
        system.compile()
        system.change_signs(dict.fromkeys(system._object.signs, 1))

    def solve():
        system.solve_dynamics(angles, angles.size * tau / (n * machine.speed))

    def columns():
        # A joint's force is that on its first solid.
        return -np.array([*main.force, *pin.force, *wrist.force, guide.normal, main.torque])[:, 1:-1]

    return solve, columns


def exudyn_forces(machine, n):
    """As `kinepy_forces`, by n steps over a turn; its angles are those after each step, which end where they began."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        return _exudyn_forces(machine, n)


def _exudyn_forces(machine, n):
    mbs = exudyn.SystemContainer().AddSystem()
    radius, length, speed = machine.crank_radius, machine.rod_length, machine.speed
    swing = -radius / length * speed
    (crank_mass, crank_off, crank_inertia), (rod_mass, rod_off, rod_inertia) = machine.crank, machine.rod

    def body(mass, inertia, x, velocity):
        node = mbs.AddNode(items.NodeRigidBody2D(referenceCoordinates=[x, 0.0, 0.0], initialVelocities=velocity))
        return node, mbs.AddObject(items.ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))

    def marker(number, x):
        return mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=number, localPosition=[x, 0.0, 0.0]))

    def joint(*markers):
        return mbs.AddObject(items.RevoluteJoint2D(markerNumbers=list(markers)))

    def sensor(number, kind):
        return mbs.AddSensor(items.SensorObject(objectNumber=number, outputVariableType=kind, storeInternal=True))

    ground = mbs.AddObject(items.ObjectGround())
    turning, crank = body(crank_mass, crank_inertia, crank_off, [0.0, crank_off * speed, speed])
    _node, rod = body(rod_mass, rod_inertia, radius + rod_off, [0.0, radius * speed + swing * rod_off, swing])
    _node, piston = body(*machine.piston, radius + length, [0.0, 0.0, 0.0])
    main = joint(marker(ground, 0.0), marker(crank, -crank_off))
    pin = joint(marker(crank, radius - crank_off), marker(rod, -rod_off))
    wrist = joint(marker(rod, length - rod_off), marker(piston, 0.0))
    along = {"axisMarker0": [1.0, 0.0, 0.0], "normalMarker1": [0.0, 1.0, 0.0], "constrainRotation": True}
    guide = mbs.AddObject(items.PrismaticJoint2D(markerNumbers=[marker(ground, 0.0), marker(piston, 0.0)], **along))
    fixed = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(items.NodePointGround()), coordinate=0))
    turned = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=turning, coordinate=2))
    drive = mbs.AddObject(items.CoordinateConstraint(markerNumbers=[fixed, turned], offset=speed, velocityLevel=True))
    force = exudyn.OutputVariableType.Force
    pins = [sensor(number, force) for number in (main, pin, wrist)]
    pressed, driven = sensor(guide, exudyn.OutputVariableType.ForceLocal), sensor(drive, force)
    mbs.Assemble()
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.numberOfSteps = n
    settings.timeIntegration.endTime = tau / speed
    settings.timeIntegration.verboseMode = 0
    # Without these the multipliers start some percent off and take dozens of steps to settle.
    settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    settings.solution.file.write = False
    settings.solutionSettings.sensorsWritePeriod = tau / (n * speed)

    def solve():
        mbs.SolveDynamic(settings)

    def columns():
        # Time stands first, and the row before the first step.
        x_y = [mbs.GetSensorStoredData(number)[1:, 1:3].T for number in pins]
        rows = [*x_y[0], *x_y[1], *x_y[2]]
        rows += [mbs.GetSensorStoredData(pressed)[1:, 2], mbs.GetSensorStoredData(driven)[1:, 1]]
        return -np.roll(np.array(rows), 1, axis=1)

    return solve, columns
