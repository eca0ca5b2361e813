"""Tables that are written and not used: told first, with what is missing, wherever results are shown."""

import json
from typing import Any

import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.machines import ROCKER, slider, throws
from tests.sentences import OF_INERTIA_ALONE, WITHOUT_PISTONS
from tests.told import texts_of

import cranktrain as ct
from cranktrain.analysis import sentences
from cranktrain.errors import InputError
from cranktrain.io.machine_file import read_machine
from cranktrain.io.tables import csv_text, json_text

AT = throws(0, speed="1500 rpm")
PISTON = {"piston": {"mass": "1 kg"}}
CYLINDER = {"bore": "80 mm", "compression_ratio": 8, "cycle": "four-stroke"}
ALONE = f"; {OF_INERTIA_ALONE}"


def without(table: dict[str, Any], *names: str) -> dict[str, Any]:
    return {name: value for name, value in table.items() if name not in names}


def told(**machine: Any) -> list[str]:
    return list(texts_of(sentences(ct.run(ct.Machine(**{"mechanism": slider(), "shaft": AT} | machine)).unused)))


@pytest.mark.parametrize(
    ("machine", "said"),
    [
        ({"gas": DUAL_CYCLE, "cylinder": CYLINDER, "masses": PISTON}, []),
        ({"gas": DUAL_CYCLE, "cylinder": CYLINDER}, []),
        (
            {"gas": DUAL_CYCLE, "cylinder": without(CYLINDER, "compression_ratio"), "masses": PISTON},
            ["[gas] is not used: [cylinder] compression_ratio or clearance is missing" + ALONE],
        ),
        (
            {"gas": DUAL_CYCLE, "cylinder": without(CYLINDER, "compression_ratio", "cycle"), "masses": PISTON},
            ["[gas] is not used: [cylinder] compression_ratio or clearance and [cylinder] cycle are missing" + ALONE],
        ),
        (
            {"gas": DUAL_CYCLE, "cylinder": CYLINDER, "masses": PISTON, "mechanism": None}
            | {"bank": {"A": {"angle": ["0 deg", "90 deg"], "mechanism": slider()}}},
            ["[gas] is not used: [cylinder] firing_order or firing_angles is missing" + ALONE],
        ),
        (
            {"gas": DUAL_CYCLE, "cylinder": without(CYLINDER, "compression_ratio")},
            ["[gas] is not used: [cylinder] compression_ratio or clearance is missing."],
        ),
        (
            {"shaft": {}, "masses": PISTON, "gravity": True, "friction": {"piston": 0.1}}
            | {"guide": {"piston": {"length": "50 mm"}}, "evenness": {"flywheel": "1 kg·m²"}},
            ["[masses], [friction], [guide], gravity and [evenness] are not used: [shaft.main] speed is missing."],
        ),
        (
            {"gravity": True, "friction": {"piston": 0.1}}
            | {"balance": {"weight": [{"mass": "1 kg", "radius": "50 mm", "throw": 1}]}},
            ["[friction], [balance] and gravity are not used: [masses] is missing."],
        ),
        (
            {"masses": PISTON, "load": {"screw": {"on": "main", "scale": "balanced", "exponent": 2}}},
            ["[load.screw] is not used: [evenness] is missing."],
        ),
        (
            {"cylinder": {"compression_ratio": 8, "firing_order": "1", "mechanical_efficiency": 0.9}},
            [
                "[cylinder] compression_ratio is not used: [cylinder] bore is missing.",
                "[cylinder] firing_order is not used: [cylinder] cycle is missing.",
                "[cylinder] mechanical_efficiency is not used:"
                " [cylinder] bore, [cylinder] cycle and [gas] are missing.",
            ],
        ),
        (
            {"mechanism": None, "shaft": {}}
            | {
                "bank": {
                    "L": {"mechanism": slider(), "masses": PISTON},
                    "R": {"angle": "90 deg", "mechanism": slider()},
                }
            },
            ["[bank.L.masses] is not used: [shaft.main] speed is missing."],
        ),
    ],
)
def test_what_is_not_used(machine, said):
    assert told(**machine) == said


def test_examples_use_all_that_they_say():
    for name in ("3d12", "vaz_21213", "jumo_205", "mud_pump_12p160", "eccentric_press"):
        assert ct.run(read_machine(name).machine, quantities="closing_margin").unused == (), name


def test_it_is_told_whatever_is_asked_for():
    machine = ct.Machine(
        mechanism=slider(), shaft=AT, gas=DUAL_CYCLE, cylinder=without(CYLINDER, "compression_ratio"), masses=PISTON
    )
    (one,) = ct.run(machine, quantities="stroke").unused
    assert (one.table, texts_of(one.needs)) == ("[gas]", ("[cylinder] compression_ratio or clearance",))
    result = ct.run(machine)
    (said,) = texts_of(sentences(result.unused))
    assert result.summary().splitlines()[0] == said
    assert result.dataset.attrs["unused"] == [said]
    assert f"# unused: {said}\n" in list(csv_text(result, ()))
    read = json.loads("".join(json_text(result, {}, ())))
    assert read["unused"] == [
        {
            "table": "[gas]",
            "needs": ["[cylinder] compression_ratio or clearance"],
            "consequence": "forces and torque are of inertia alone",
        }
    ]


def test_gas_without_pistons_is_refused():
    with pytest.raises(InputError, match=f"gas: {WITHOUT_PISTONS}"):
        ct.run(ct.Machine(mechanism=ROCKER, shaft=AT, gas=DUAL_CYCLE))


def test_what_rests_on_no_mass_is_left_out():
    """Gas alone: nothing shakes, and to say `none` of it would be a number that nobody gave."""
    result = ct.run(ct.Machine(mechanism=slider(), shaft=AT, gas=DUAL_CYCLE, cylinder=CYLINDER))
    assert {"shaking_force_x", "flywheel_moment", "balance_weight_moment"}.isdisjoint(result.catalogue)
    assert "shaking" not in result.summary()
    assert "No masses are given: forces and torque are of the gas alone." in texts_of(result.flags)
    assert result.rolling_moment.tolist() == [result.driving_torque.tolist()]
    needs = next(missing.needs for missing in result.missing if "shaking_force_x" in missing.results)
    assert texts_of(needs) == ("[masses]",)


def test_forces_of_nothing_are_left_out():
    result = ct.run(
        ct.Machine(mechanism=slider(), shaft=AT, gas=DUAL_CYCLE, cylinder=without(CYLINDER, "compression_ratio"))
    )
    assert {"joint_force_x", "driving_torque", "reduced_inertia"}.isdisjoint(result.catalogue)
