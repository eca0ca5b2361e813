"""Every kernel, compiled for numbers, gives what NumPy gives at every crank angle, for every design.

Without contraction or reordering both do the same operations, and only cos, sin and atan2 are other people's: their
results may differ by a few units in the last place. So a compiled result is right where it is NumPy's for inputs
changed by as much. That change is measured, input by input.
"""

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.contract import force_kernels

import cranktrain.fluids
import cranktrain.linkage
import cranktrain.mechanisms
from cranktrain.fluids.compressor.pressure import Compressor, compressor_pressure
from cranktrain.fluids.dual.pressure import IdealCycle, ideal_pressure
from cranktrain.fluids.state import ChamberState, VolumeLimits
from cranktrain.linkage import (
    GUIDE,
    ROD,
    Crank,
    CrankAndGround,
    CrankAndPivot,
    Ends,
    Leg,
    LinkPoint,
    OnLine,
    Pin,
    Pose,
    Slide,
    Swivel,
    Trammel,
    Triad,
    TriadDriver,
    TriadEnds,
    Yoke,
    compiled,
    crank,
    fixed,
    fixed_guide,
    rod_end,
    slide,
    turned,
)
from cranktrain.linkage.change_point import Hinged
from cranktrain.linkage.vectors import Vector
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.motion import Coefficient

NO_KERNELS = {
    "blocks.in_blocks",
    "chain.chain_dynamics",
    "chain.chain_forces",
    "chain.chain_links",
    "chain.chain_load",
    "chain.chain_made",
    "chain.chain_motion",
    "chain.triad_branch",
    "chain.triad_motion",
    "compile.compiled",
    "compile.options_of",
    "compile.uncollected",
    "kept.fingerprint",
    "kept.folder",
    "kept.is_kept",
    "kept.keep",
    "modes.triad_modes",
    "nearest.nearest_pose",
    "shorter.shorter",
    "stephenson.stephenson_size",
    "walk.pose_at",
    "walk.triad_walk",
    "walschaerts.upright",
    "walschaerts.walschaerts_size",
}
"""What supplies kernels, or takes them: `cranktrain.linkage` names it."""

ANGLES = np.array([0.0, 0.3, 1.1, 2.2, 3.3, 4.7, 5.9])
DESIGNS = 4
OTHER_LIBRARY = 8 * np.finfo(float).eps
"""NumPy's vectorised functions are good to 4 units in the last place, the mathematical library's to 1; with reserve."""


def kernels() -> dict[str, Callable[..., Any]]:
    """Every public function of the modules that hold kernels, by module and name."""
    linkage = pkgutil.walk_packages(cranktrain.linkage.__path__, "cranktrain.linkage.")
    groups = [module.name for module in linkage if not module.ispkg]
    mechanisms = [
        f"cranktrain.mechanisms.{file.parent.name}.{file.stem}"
        for name in ("kinematics.py", "forces.py")
        for file in Path(cranktrain.mechanisms.__path__[0]).glob(f"*/{name}")
    ]
    gases = [
        f"cranktrain.fluids.{folder.parent.name}.{folder.stem}"
        for folder in Path(cranktrain.fluids.__path__[0]).glob("*/pressure.py")
    ]
    found: dict[str, Callable[..., Any]] = {}
    questions = [f"cranktrain.questions.forces.{name}" for name in ("pin_load", "piston_formulas", "rod_masses")]
    for path in (
        groups
        + mechanisms
        + questions
        + gases
        + ["cranktrain.mechanisms.on_crank"]
        + ["cranktrain.fluids.state", "cranktrain.fluids.polytrope", "cranktrain.fluids.work"]
    ):
        module = importlib.import_module(path)
        for name, function in inspect.getmembers(module, inspect.isfunction):
            short = f"{path.split('.')[-1 if path in questions else 2]}.{name}"
            if function.__module__ == path and not name.startswith("_") and short not in NO_KERNELS:
                found[short] = function
    return found


KERNELS = kernels()


# An example takes the angle, `size`, through which every length and angle of the geometry passes, and the side.


def crank_pin(angle, size):
    return crank(angle, Crank(size(0.3)))


def ends(angle, size):
    return Ends(crank_pin(angle, size), fixed(size(1.1), size(0.05)))


def two_vectors(angle, size):
    return Vector(size(0.3) * np.cos(angle), size(0.2)), Vector(size(-0.1), size(0.4) * np.sin(angle))


def rod(angle, size):
    return slide(crank_pin(angle, size), Slide(size(1.0), size(0.05), 1.0)).rod


def hinged(angle, size):
    return Hinged(ends(angle, size), fixed(size(0.1), size(0.02))), Pin(size(1.0), size(0.8), 1.0)


def swivel_ends(angle, size):
    return Ends(crank_pin(angle, size), fixed(size(0.1), size(-0.4)))


def floating_link(angle, size):
    """Two rods and a guide about a link that is at rest in (0.5, 0.1) while the first rod's end goes round a little."""
    end = rod_end(crank(angle, Crank(size(0.02))))
    driver = TriadEnds(end, rod_end(fixed(size(1.2), size(0.6))), fixed_guide(size(0.4), size(-0.9), size(0.6)))
    return TriadDriver(driver, Pose(size(0.5), size(0.1), size(0.01)))


def legs(size):
    """Legs as long as they are between those ends and three points of that link."""
    points = [LinkPoint(size(0.3), size(angle)) for angle in (0.5, 2.5, 4.5)]
    at = [complex(0.5, 0.1) + 0.3 * np.exp(1j * angle) for angle in (0.5, 2.5, 4.5)]
    shift = float(((at[2] - complex(0.4, -0.9)) * np.exp(-0.6j)).imag)
    return Triad(
        Leg(points[0], size(abs(at[0])), ROD),
        Leg(points[1], size(abs(at[1] - complex(1.2, 0.6))), ROD),
        Leg(points[2], size(shift), GUIDE),
    )


def slider_crank_geometry(size):
    return SliderCrank(size(0.3), size(1.0), size(0.05))


def eccentric_geometry(size):
    return Eccentric(size(0.3), size(1.0), size(0.05), size(1.9))


def crank_rocker_geometry(size, side):
    return CrankRocker(size(0.3), size(1.0), size(0.8), size(1.1), side)


def cylinder_geometry(size):
    return CrankAndPivot(size(0.3), size(0.5), size(0.05), 1.0)


def articulated_rod_geometry(size):
    return ArticulatedRod(slider_crank_geometry(size), size(0.25), size(1.2), size(1.0), size(0.8), size(0.02))


def volume(angle, size):
    middle = size(2.0)
    swing = 0.4 * middle
    return Coefficient(middle - swing * np.cos(angle), swing * np.sin(angle), swing * np.cos(angle))


def chamber(angle, size, side):
    return ChamberState(volume(angle, size).value, size(0.9), size(3.1), side, 1.0, angle)


def ideal_cycle(size):
    return IdealCycle(size(1.2), size(1.1), size(1.0), size(1.36), size(1.25), size(1.5), size(1.1))


def compressor(size):
    return Compressor(size(1.0), size(2.5), size(1.35), size(1.28), size(1.0), size(3.0), size(2.5))


def limits(size):
    return VolumeLimits(size(0.9), size(3.1))


EXAMPLES: dict[str, Callable[..., tuple[Any, ...]]] = {
    **force_kernels.EXAMPLES,
    "articulated_rod.articulated_rod": lambda angle, size, side: (angle, articulated_rod_geometry(size)),
    "articulated_rod.articulated_rod_gap": lambda angle, size, side: (angle, articulated_rod_geometry(size)),
    "compressor.corners": lambda angle, size, side: (compressor(size), limits(size)),
    "compressor.compressor_pressure": lambda angle, size, side: (chamber(angle, size, side), compressor(size)),
    "compressor.compressor_slope": lambda angle, size, side: (
        chamber(angle, size, side),
        compressor_pressure(chamber(angle, size, side), compressor(size)),
        volume(angle, size).first,
        compressor(size),
    ),
    "compressor.compressor_work": lambda angle, size, side: (compressor(size), limits(size)),
    "compressor.capacity": lambda angle, size, side: (compressor(size), limits(size)),
    "compressor.discharge_temperature": lambda angle, size, side: (compressor(size), limits(size)),
    "compressor.suction_heating": lambda angle, size, side: (compressor(size), limits(size)),
    "dual.corner_pressures": lambda angle, size, side: (ideal_cycle(size), 3.1 + 0.1 * np.cos(angle)),
    "dual.ideal_mean_pressures": lambda angle, size, side: (ideal_cycle(size), 3.1 + 0.1 * np.cos(angle)),
    "dual.ideal_pressure": lambda angle, size, side: (chamber(angle, size, side), ideal_cycle(size)),
    "dual.ideal_slope": lambda angle, size, side: (
        chamber(angle, size, side),
        ideal_pressure(chamber(angle, size, side), ideal_cycle(size)),
        volume(angle, size).first,
        ideal_cycle(size),
    ),
    "crank.crank": lambda angle, size, side: (angle, Crank(size(0.3))),
    "crank_rocker.crank_rocker": lambda angle, size, side: (angle, crank_rocker_geometry(size, side)),
    "change_point.crossed_parallelogram": lambda angle, size, side: hinged(angle, size),
    "change_point.kite": lambda angle, size, side: hinged(angle, size),
    "change_point.out_of_line": lambda angle, size, side: hinged(angle, size)[:1],
    "change_point.parallelogram": lambda angle, size, side: hinged(angle, size),
    "crank_rocker.crank_rocker_gap": lambda angle, size, side: (angle, crank_rocker_geometry(size, side)),
    "crank_rocker.crank_rocker_least_gap": lambda angle, size, side: (crank_rocker_geometry(size, side),),
    "eccentric.eccentric": lambda angle, size, side: (angle, eccentric_geometry(size)),
    "eccentric.eccentric_gap": lambda angle, size, side: (angle, eccentric_geometry(size)),
    "eccentric.eccentric_least_gap": lambda angle, size, side: (eccentric_geometry(size),),
    "legs.block_along": lambda angle, size, side: (OnLine(rod(angle, size), crank_pin(angle, size)),),
    "legs.fixed_guide": lambda angle, size, side: (size(0.4), size(-0.9), size(0.6)),
    "legs.rod_between": lambda angle, size, side: (crank_pin(angle, size), fixed(size(1.1), size(0.05))),
    "legs.rod_end": lambda angle, size, side: (crank_pin(angle, size),),
    "pin.line_between": lambda angle, size, side: (ends(angle, size),),
    "pin.line_from_crank": lambda angle, size, side: (CrankAndGround(crank_pin(angle, size), size(1.1)),),
    "pin.pin": lambda angle, size, side: (ends(angle, size), Pin(size(1.0), size(0.8), side)),
    "pin.pin_from_crank": lambda angle, size, side: (
        CrankAndGround(crank_pin(angle, size), size(1.1)),
        Pin(size(1.0), size(0.8), side),
    ),
    "pin.pin_gap": lambda angle, size, side: (ends(angle, size), Pin(size(1.0), size(0.8), side)),
    "polytrope.polytropic_work": lambda angle, size, side: (size(2.0), 1.5 + np.cos(angle), size(1.3)),
    "polytrope.polytropic_slope": lambda angle, size, side: (size(2.0), size(1.3), 1.5 + np.cos(angle), -np.sin(angle)),
    "state.chamber_state": lambda angle, size, side: (
        volume(angle, size),
        VolumeLimits(size(1.0), size(3.0)),
        angle,
        4 * np.pi,
    ),
    "point.arm_of": lambda angle, size, side: (rod(angle, size), LinkPoint(size(0.2), size(0.7))),
    "point.fixed": lambda angle, size, side: (size(1.1), size(0.05)),
    "point.point": lambda angle, size, side: (rod(angle, size), LinkPoint(size(0.2), size(0.7))),
    "point.turned": lambda angle, size, side: (crank_pin(angle, size), size(0.7)),
    "oscillating_cylinder.oscillating_cylinder": lambda angle, size, side: (angle, cylinder_geometry(size)),
    "scotch_yoke.scotch_yoke": lambda angle, size, side: (angle, ScotchYoke(size(0.3), size(0.1), size(1.2))),
    "scotch_yoke.scotch_yoke_gap": lambda angle, size, side: (angle, ScotchYoke(size(0.3), size(0.1), size(1.2))),
    "slotted_lever.slotted_lever": lambda angle, size, side: (angle, cylinder_geometry(size)),
    "slide.slide": lambda angle, size, side: (crank_pin(angle, size), Slide(size(1.0), size(0.05), side)),
    "slide.slide_gap": lambda angle, size, side: (crank_pin(angle, size), Slide(size(1.0), size(0.05), side)),
    "slider_crank.slider_crank": lambda angle, size, side: (angle, slider_crank_geometry(size)),
    "slider_crank.slider_crank_gap": lambda angle, size, side: (angle, slider_crank_geometry(size)),
    "slider_crank.slider_crank_least_gap": lambda angle, size, side: (slider_crank_geometry(size),),
    "swivel.crank_swivel_gap": lambda angle, size, side: (
        angle,
        CrankAndPivot(size(0.3), size(0.9), size(0.05), side),
    ),
    "swivel.swivel": lambda angle, size, side: (swivel_ends(angle, size), Swivel(size(0.05), side)),
    "swivel.swivel_gap": lambda angle, size, side: (swivel_ends(angle, size), Swivel(size(0.05), side)),
    "trammel.trammel": lambda angle, size, side: (rod(angle, size), Trammel(size(0.1), size(0.01))),
    "trammel.turned_link": lambda angle, size, side: (rod(angle, size), size(0.7)),
    "triad.triad": lambda angle, size, side: (floating_link(angle, size), legs(size)),
    "vectors.at_arm": lambda angle, size, side: two_vectors(angle, size),
    "vectors.between": lambda angle, size, side: ends(angle, size),
    "vectors.cross": lambda angle, size, side: two_vectors(angle, size),
    "vectors.crossed": lambda angle, size, side: (force_kernels.moving_wrench(angle, size), force_kernels.wrench(size)),
    "vectors.direction": lambda angle, size, side: (rod(angle, size),),
    "vectors.dot": lambda angle, size, side: two_vectors(angle, size),
    "vectors.moving_between": lambda angle, size, side: ends(angle, size),
    "vectors.rotated": lambda angle, size, side: (Vector(size(0.2), size(0.1)), np.cos(angle), np.sin(angle)),
    "vectors.swept": lambda angle, size, side: (
        crank_pin(angle, size),
        Vector(size(0.2), size(0.1)),
        rod(angle, size).angle,
    ),
    "work.friction_power": lambda angle, size, side: (size(1.5), size(2.0), size(6.3), size(157.0)),
    "work.friction_power_by_efficiency": lambda angle, size, side: (size(2.0) * np.cos(angle), size(0.8)),
    "work.indicated_power": lambda angle, size, side: (size(1.5), size(6.3), size(157.0)),
    "yoke.yoke": lambda angle, size, side: (turned(crank_pin(angle, size), size(0.1)), Yoke(size(0.1), size(1.2))),
}


def leaves(value: Any) -> Iterator[Any]:
    """Numbers and arrays of nested tuples, in order."""
    if isinstance(value, tuple):
        for part in value:
            yield from leaves(part)
    else:
        yield value


def rebuilt(value: Any, parts: Iterator[Any]) -> Any:
    """The same nested tuples with other leaves."""
    if not isinstance(value, tuple):
        return next(parts)
    inside = [rebuilt(part, parts) for part in value]
    return type(value)(*inside) if hasattr(value, "_fields") else tuple(inside)


def one_machine(name: str, angle: Any) -> Any:
    """Arguments for one machine, numbers as plain numbers."""
    arguments = EXAMPLES[name](angle, float, 1.0)
    return rebuilt(arguments, iter([float(x) if np.ndim(x) == 0 else x for x in leaves(arguments)]))


def designs(name: str) -> Any:
    """Arguments for designs on a leading axis: the first is the one machine, the others hardly all close."""
    random = np.random.default_rng(0)

    def size(value: float) -> np.ndarray:
        return value * np.concatenate([[[1.0]], np.exp(random.uniform(-1.3, 1.3, (DESIGNS - 1, 1)))])

    side = np.where(np.arange(DESIGNS) % 2, -1.0, 1.0)[:, np.newaxis]
    with np.errstate(invalid="ignore"):
        return EXAMPLES[name](ANGLES, size, side)


def with_numpy(name: str, arguments: Any) -> list[np.ndarray]:
    with np.errstate(all="ignore"):
        return [np.asarray(x) for x in leaves(KERNELS[name](*arguments))]


def tolerances(name: str, arguments: Any) -> list[np.ndarray]:
    """By how much the results change when the inputs and the results themselves do by a few last places."""
    step = 1e-7
    given = list(leaves(arguments))
    results = with_numpy(name, arguments)
    changes = [np.maximum(np.abs(result), 1.0) for result in results]
    with np.errstate(all="ignore"):
        for i, value in enumerate(given):
            changed = [*given[:i], value + step * np.maximum(np.abs(value), 1.0), *given[i + 1 :]]
            other = with_numpy(name, rebuilt(arguments, iter(changed)))
            changes = [c + np.abs(o - r) / step for c, o, r in zip(changes, other, results, strict=True)]
    return [np.where(np.isnan(change), np.inf, OTHER_LIBRARY * change) for change in changes]


def assert_same(name: str, arguments: Any, allowed: list[np.ndarray]) -> list[np.ndarray]:
    """The compiled kernel gives what NumPy gives: numbers, infinity and NaN."""
    expected = with_numpy(name, arguments)
    got = [np.asarray(x) for x in leaves(compiled(KERNELS[name])(*arguments))]
    assert [x.shape for x in got] == [x.shape for x in expected]
    for ours, numpys, tolerance in zip(got, expected, allowed, strict=True):
        np.testing.assert_array_equal(np.isfinite(ours), np.isfinite(numpys))
        np.testing.assert_array_equal(ours[~np.isfinite(ours)], numpys[~np.isfinite(ours)])
        finite = np.isfinite(ours)
        assert np.all(np.abs(ours - numpys)[finite] <= tolerance[finite])
    return expected


def test_every_kernel_has_an_example():
    assert set(EXAMPLES) == set(KERNELS), "a kernel needs an example of its arguments in EXAMPLES, above"


def picked(parts: Iterable[Any], shape: tuple[int, ...], at: tuple[int, ...]) -> list[Any]:
    """Of numbers and arrays what stands at one place of the whole."""
    return [np.broadcast_to(part, shape)[at] for part in parts]


@pytest.mark.parametrize("name", EXAMPLES)
def test_numbers(name):
    allowed = tolerances(name, one_machine(name, ANGLES))
    for at, angle in enumerate(ANGLES):
        arguments = one_machine(name, float(angle))
        expected = assert_same(name, arguments, picked(allowed, ANGLES.shape, (at,)))
        # An array would be right too, and forty times as slow: loops with one in them are not fused.
        assert {type(x) for x in leaves(compiled(KERNELS[name])(*arguments))} == {float}
        # Forces ask a crank as a link for its angle's derivatives alone: the angle itself is NaN.
        unknown = [value for value in expected if not np.all(np.isfinite(value))]
        assert len(unknown) <= name.endswith(("_links", ".crank_link"))
    many, shape = designs(name), (DESIGNS, len(ANGLES))
    allowed = tolerances(name, many)
    for at in np.ndindex(shape):
        arguments = rebuilt(many, map(float, picked(leaves(many), shape, at)))
        assert_same(name, arguments, picked(allowed, shape, at))


def test_designs_include_some_that_do_not_close():
    """Or NaN would not have been compared."""
    opens = {name for name in EXAMPLES if any(np.any(np.isnan(x)) for x in with_numpy(name, designs(name)))}
    closing = {"articulated_rod", "crank_rocker", "pin", "slide", "slider_crank", "swivel", "triad"}
    assert opens >= {f"{name}.{name}" for name in closing}


def test_division_by_zero_is_no_exception():
    """A slot along the guide is crossed nowhere."""
    still = fixed(0.0, 0.0)
    slot = fixed_guide(0.0, 0.0, 0.0)._replace(origin=still)
    got = compiled(KERNELS["trammel.trammel"])(slot, Trammel(0.1, 0.0))
    assert not any(np.isfinite(x) for x in leaves(got))


def test_a_kernel_is_compiled_once():
    assert compiled(crank) is compiled(crank)
