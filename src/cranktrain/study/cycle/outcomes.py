"""Results of stages by the facts of the compiled cycle, for those stages that look at a grid of crank angles."""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields
from typing import Any, NamedTuple, TypeVar

import numpy as np

from cranktrain.analysis.outcomes import StageRun
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, Peak, around_zero
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.results.supported_shafts import SupportedShafts
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.cylinders.volumes import ChamberVolumes, SweptVolumes
from cranktrain.questions.evenness.flywheel import FlywheelSize, RimSize
from cranktrain.questions.evenness.flywheel_inertia import METHODS
from cranktrain.questions.evenness.running_speed import RunningSpeed
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.questions.forces.joint_forces import JointForces, joint_label
from cranktrain.questions.forces.largest_forces import LargestForces
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import without_rounding
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.powers import BrakePowers, IndicatedPowers
from cranktrain.questions.gas.pressures import GasPressures, PeakPressures
from cranktrain.questions.motion.dead_centres import ANGLE_ROUNDING
from cranktrain.questions.torque.torques import ShaftTorques
from cranktrain.study.cycle.given import Found

Outcome = TypeVar("Outcome")


class Cycles(NamedTuple):
    """Designs whose cycles were found: what the loop found, and what it rests on.

    Attributes
    ----------
    found : Found
    crank_angle, speed, mechanisms
    stages : StageRun
        On a grid without angles.
    joints : tuple of str
    over_grid : callable
        Gives the stages on the grid of facts, for what rests on more than numbers.
    tell_vectors : callable (loads) → Array
        Largest size, its angle, mean size of vectors at the points that were kept, shape (design, vector, 3).
    """

    found: Found
    crank_angle: CrankAngle
    speed: Speed
    mechanisms: Mechanisms
    stages: StageRun
    joints: tuple[str, ...]
    over_grid: Callable[[], StageRun]
    tell_vectors: Callable[[Array], Array]


def bare(kind: type[Outcome], **known: Any) -> Outcome:
    """Make a result of which some fields alone are known; nobody asks for the others."""
    unknown = {
        one.name: None
        for one in fields(kind)  # pyright: ignore[reportArgumentType] - every result is a record
        if one.name not in known and one.default is MISSING and one.default_factory is MISSING
    }
    return kind(**known, **unknown)


def _shaft_torques(cycles: Cycles) -> ShaftTorques:
    found = cycles.found.torque
    gross = found[:, 4]
    largest, smallest = (Peak(found[:, i + 1], found[:, i], np.zeros(len(found))) for i in (0, 2))
    work = np.zeros(len(found))
    if _has(cycles.stages, GasPressures):
        work = np.sum(cycles.stages[GasPressures].work_over(cycles.crank_angle), axis=-1)
    return bare(
        ShaftTorques,
        mean_torque=work / cycles.crank_angle.cycle,
        largest_torque=without_rounding(largest, gross),
        smallest_torque=without_rounding(smallest, gross),
    )


def _has(stages: StageRun, kind: type) -> bool:
    try:
        return stages[kind] is not None
    except KeyError:
        return False


def gas_pressures(cycles: Cycles) -> GasPressures:
    """Work by each fluid's own formula."""
    gas, swept = cycles.stages[GasInChambers], cycles.stages[SweptVolumes]
    work = gas.by_chamber((one, one.fluid.work(one.ready, one.rooms)) for one in gas.fillings)
    return bare(GasPressures, cycle=gas.cycle, indicated_work=work, indicated_mean_pressure=work / swept.swept_volume)


def _peak_pressures(cycles: Cycles) -> PeakPressures:
    gas, found = cycles.stages[GasInChambers], cycles.found.pressure
    firing, _opposite = gas.dead_centres(cycles.stages[CylinderTravel])
    zero = cycles.crank_angle.zero[..., 0]
    after = around_zero(found[..., 1] + zero - firing)
    after = np.where(np.abs(after) <= ANGLE_ROUNDING, 0.0, after)
    shown = cycles.crank_angle.counted((firing + after)[..., np.newaxis], gas.cycle)[..., 0]
    return bare(PeakPressures, peak_pressure=Extreme(shown, found[..., 0]), peak_pressure_after=after)


def _joint_peaks(cycles: Cycles) -> Peak:
    found = cycles.found.joint
    peak = Peak(found[..., 1], found[..., 0], np.zeros(found.shape[:2]))
    return without_rounding(peak, np.max(peak.value, axis=-1, keepdims=True))


def _joint_forces(cycles: Cycles) -> JointForces:
    return bare(JointForces, largest_joint_force=_joint_peaks(cycles), labels={"joint": cycles.joints})


def _crank_pin_loads(cycles: Cycles) -> CrankPinLoads:
    peaks = _joint_peaks(cycles)
    names = cycles.mechanisms.names
    largest = Extreme(*np.full((2, len(peaks.value), len(names)), np.nan))
    for batch in cycles.mechanisms.batches:
        joint = batch.kind.dynamics.joint("crank_pin")
        if joint is not None:
            reaction = batch.kind.dynamics.reactions[joint]
            rows = [cycles.joints.index(joint_label(names[i], reaction)) for i in map(int, batch.index)]
            for whole, part in zip(largest, peaks[:2], strict=True):
                whole[:, batch.index] = part[:, rows]
    return bare(CrankPinLoads, largest_crankpin_load=largest)


def _largest_forces(cycles: Cycles) -> LargestForces:
    value, at = (cycles.found.rod[..., place::2] for place in (0, 1))
    gross = np.fmax.reduce(value, axis=(1, 2), keepdims=True)
    peak = without_rounding(Peak(at, value, np.zeros(value.shape)), gross)
    angle, size = (np.where(peak.value > 0, part, np.nan) for part in peak[:2])
    piston, side, rod = (Extreme(angle[..., i], size[..., i]) for i in range(3))
    return bare(LargestForces, largest_piston_force=piston, largest_side_force=side, largest_rod_force=rod)


def _shaft_work(cycles: Cycles) -> ShaftWork:
    return bare(ShaftWork, largest_excess_work=cycles.found.work)


def _running_speed(cycles: Cycles) -> RunningSpeed:
    most, most_at, least, least_at, over_angle = cycles.found.running.T
    over_time = cycles.speed.value[:, 0, 0]
    return bare(
        RunningSpeed,
        coefficient_of_fluctuation=(most - least) / over_time,
        mean_speed_over_time=over_time,
        mean_speed_over_angle=over_angle,
        mean_speed_of_extremes=(most + least) / 2,
        largest_crank_speed=Extreme(most_at, most),
        smallest_crank_speed=Extreme(least_at, least),
    )


def _flywheel_size(cycles: Cycles) -> FlywheelSize:
    inertia, fluctuation = cycles.found.flywheel[:, :3], cycles.found.flywheel[:, 3:]
    return bare(
        FlywheelSize,
        flywheel_inertia=inertia,
        wanted_flywheel_moment=4 * inertia,
        flywheel_inertia_error=inertia / inertia[:, :1] - 1,
        flywheel_fluctuation=fluctuation,
        labels={"flywheel_method": METHODS},
    )


def _main_bearing_loads(cycles: Cycles) -> MainBearingLoads:
    """Loads of bearings by all methods at the points of the panels, with the gas of their own side of jumps."""
    over_grid = cycles.over_grid()
    over_grid.find([LoadedShafts, SupportedShafts])
    shafts, supported = over_grid[LoadedShafts], over_grid[SupportedShafts]
    n_points = int(np.max(np.count_nonzero(cycles.found.angle, axis=-1))) + 1
    angle = cycles.found.angle[:, np.newaxis, :n_points]
    push = cycles.found.push[..., :n_points] if shafts.loaded.gas is not None else None
    acting = shafts.loads(angle, shafts.loaded.solved(angle, gas_force=push))
    load = supported.borne(acting)
    told = cycles.tell_vectors(np.ascontiguousarray(load.reshape(len(load), -1, *load.shape[-2:])))
    cycles.found.is_known[np.any(np.isnan(told[..., 1]), axis=-1)] = False
    size, angle, mean = (told[..., i].reshape(load.shape[:3]) for i in range(3))
    gross = np.max(size, axis=(1, 2), keepdims=True, initial=0.0)
    return bare(
        MainBearingLoads,
        largest_bearing_load=without_rounding(Peak(angle, size, np.zeros_like(size)), gross),
        mean_bearing_load=mean,
        labels={"bearing_method": tuple(method.name for method in supported.methods)},
    )


class FromLoop(NamedTuple):
    """A result that the loop gives: what it is asked for, the names of the facts, and what makes the result of it.

    It is not asked for what has formulas of its own.
    """

    ask: str | None
    names: frozenset[str]
    made: Callable[[Cycles], Any]


def _peaks(*names: str) -> frozenset[str]:
    return frozenset((*names, *(f"{name}_at" for name in names)))


ASKS: Mapping[type, FromLoop] = {
    GasPressures: FromLoop(None, frozenset({"indicated_work", "indicated_mean_pressure"}), gas_pressures),
    PeakPressures: FromLoop("pressure", _peaks("peak_pressure") | {"peak_pressure_after"}, _peak_pressures),
    ShaftTorques: FromLoop("torque", _peaks("largest_torque", "smallest_torque") | {"mean_torque"}, _shaft_torques),
    JointForces: FromLoop("joint", _peaks("largest_joint_force"), _joint_forces),
    CrankPinLoads: FromLoop("joint", _peaks("largest_crankpin_load"), _crank_pin_loads),
    LargestForces: FromLoop(
        "rod", _peaks("largest_piston_force", "largest_side_force", "largest_rod_force"), _largest_forces
    ),
    ShaftWork: FromLoop("work", frozenset({"largest_excess_work"}), _shaft_work),
    RunningSpeed: FromLoop(
        "running",
        _peaks("largest_crank_speed", "smallest_crank_speed")
        | {"coefficient_of_fluctuation"}
        | {"mean_speed_over_time", "mean_speed_over_angle", "mean_speed_of_extremes"},
        _running_speed,
    ),
    FlywheelSize: FromLoop(
        "flywheel",
        frozenset({"flywheel_inertia", "wanted_flywheel_moment", "flywheel_inertia_error", "flywheel_fluctuation"}),
        _flywheel_size,
    ),
    MainBearingLoads: FromLoop("points", _peaks("largest_bearing_load") | {"mean_bearing_load"}, _main_bearing_loads),
}
"""What stages give that look at a grid."""

GRIDLESS: frozenset[type] = frozenset(
    {
        BrakePowers,
        ChamberVolumes,
        CylinderTravel,
        Firing,
        GasInChambers,
        IndicatedPowers,
        LoadedMachine,
        RimSize,
        SweptVolumes,
    }
)
"""Results whose facts are found without a grid, of what stands here and in `ASKS`."""
