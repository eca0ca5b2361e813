"""Facts from one grid, curves on another: what is the same whatever the step, and what is told of a coarse one."""

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.machines import slider, throws
from tests.told import texts_of

import cranktrain as ct


def engine(**changes) -> ct.Machine:
    tables = {
        "shaft": throws(0, speed="1500 rpm"),
        "mechanism": slider(),
        "cylinder": {"bore": "80 mm", "compression_ratio": 16, "cycle": "four-stroke", "firing_order": "1"},
        "masses": {"piston": {"mass": "0.6 kg"}},
        "gas": DUAL_CYCLE,
    }
    return ct.Machine(**(tables | changes))


def coarse(result: ct.Result) -> list[str]:
    """What is told of too coarse a step."""
    return [flag for flag in texts_of(result.flags) if "coarse" in flag]


@pytest.mark.parametrize(("step", "shared", "precision"), [(30, 1, 0.0), (7.5, 0.5, 1e-7)])
def test_curves_stand_on_the_grid_that_is_asked_for(step, shared, precision):
    """At the crank angles that a finer step has too they are the same, speeds over the cycle as well."""
    machine = engine(evenness={"flywheel": "2 kg·m²"})
    fine, coarse = (ct.run(machine, step_degrees=degrees) for degrees in (shared, step))
    assert coarse.crank_angle.tolist() == [step * i for i in range(round(720 / step))]
    sizes = {name: np.nanmax(np.abs(getattr(fine, name)), initial=0.0) for name in fine.catalogue}
    for name, entry in coarse.catalogue.items():
        if not entry.is_fact:
            expected = getattr(fine, name)[..., :: round(step / shared)]
            # What is only rounding, as forces across a rod that weighs nothing, is so beside others of its unit.
            beside = max(sizes[other] for other, of in fine.catalogue.items() if of.unit == entry.unit)
            scale = max(sizes[name], 1e-9 * beside, 1e-6)
            np.testing.assert_allclose(getattr(coarse, name), expected, atol=precision * scale, rtol=0, err_msg=name)


def test_a_coarse_step_is_told_with_the_curves_that_lose_most():
    (said,) = coarse(ct.run(engine(), step_degrees=30))
    assert said.startswith("A step of 30 deg is coarse for curves, though not for facts:")
    # p falls to a half within 30° of its peak: straight lines miss much of that.
    assert "%" in said and "more." in said


@pytest.mark.parametrize("step", [0.1, 1])
def test_a_fine_step_is_not(step):
    assert not coarse(ct.run(engine(), step_degrees=step))


def test_a_gentle_curve_is_not_coarse_at_five_degrees():
    pump = ct.Machine(shaft=throws(0, speed="60 rpm"), mechanism=slider())
    assert not coarse(ct.run(pump, step_degrees=5))


def test_rounding_about_a_constant_is_no_curve():
    """The shaking couple of one throw is nothing; what rounding makes of it is not coarse."""
    said = " ".join(texts_of(ct.run(engine(), step_degrees=30, quantities=["shaking_couple_x"]).flags))
    assert "shaking_couple" not in said
