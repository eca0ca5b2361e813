"""EI of straight spans as numbers: that of the sections again, three moments in closed form, lists that do not fit."""

import numpy as np
import pytest
from tests.validation.test_crankshaft_arrangements import SECTIONS, machine

import cranktrain as ct
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayouts

ELASTIC = {"bearing_stiffness": "5e5 N/mm"}
YOUNG, DIAMETER = 206e9, 0.07


def by_sections(declared):
    """EI of the spans of the machine's only crankshaft."""
    parts = parts_of([declared], step=np.radians(1.0))
    found = run_stages(every_stage(), parts, lacking(every_stage(), parts))
    (layout,) = found[ShaftLayouts].each
    return layout.shaft.straight.bending[0].tolist()


def test_the_number_of_the_sections_changes_nothing():
    plain = machine(["0 deg", "180 deg"], crankshaft=ELASTIC)
    bending = [f"{value!r} Pa·m⁴" for value in by_sections(plain)]
    given = machine(["0 deg", "180 deg"], crankshaft={**ELASTIC, "span_bending_stiffness": bending})
    one, other = (ct.run(declared).dataset for declared in (plain, given))
    for name in ("main_bearing_load_x", "main_bearing_load_y"):
        largest = float(np.abs(one[name]).max())
        np.testing.assert_allclose(other[name], one[name], rtol=0, atol=1e-14 * largest)


@pytest.mark.parametrize("ratio", [0.25, 1.0, 6.0])
def test_three_moments_in_closed_form(ratio):
    """A shaft on three bearings, pulled between the last two, which are a plain journal's.

    2 M (l₁/EI₁ + l₂/EI₂) = F a b (l₂ + b) / l₂EI₂ of the moment over the middle one; 1 bears M/l₁ of it, the last
    F a/l₂ less M/l₂. [timoshenko], the theorem of three moments.
    """
    first, last, place = 0.26, 0.4, 0.15
    bending = YOUNG * np.pi / 64 * DIAMETER**4
    spans = [f"{ratio * bending!r} Pa·m⁴", f"{bending!r} Pa·m⁴"]
    found = ct.run(
        ct.Machine(
            mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "220 mm"},
            shaft={"main": {"speed": "0.0001 rpm"}},
            masses={"piston": {"mass": "1 g"}},
            crankshaft={
                **SECTIONS,
                "bearing_distance": "130 mm",
                "span_bending_stiffness": spans,
                "bearing": {"end": {"z": f"{130 + 1000 * last} mm"}},
                "pull": {"belt": {"z": f"{130 + 1000 * place} mm", "direction": "0 deg", "force": "1 kN"}},
            },
        )
    )
    rest = last - place
    moment = 1000 * place * rest * (last + rest) / (last * bending) / (2 * (first / (ratio * bending) + last / bending))
    ends = np.array([-moment / first, 1000 * place / last - moment / last])
    loads = found.dataset.sel(bearing_method="three_moment").main_bearing_load_y.isel(crank_angle=0)
    np.testing.assert_allclose(loads, [ends[0], 1000 - np.sum(ends), ends[1]], rtol=1e-8)


def test_as_many_as_there_are_spans():
    with pytest.raises(ct.InputError, match=r"crankshaft\.span_bending_stiffness = a list of 3: must be one value, or"):
        ct.run(machine(["0 deg", "180 deg"], crankshaft={"span_bending_stiffness": ["1 MN·m²"] * 3}))
