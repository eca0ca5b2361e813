"""The sheet of torsion: nothing overlaps, and what it says is there."""

import numpy as np
import pytest
from tests.unit.questions.torsion.test_modes import FLYWHEEL, FOUR, PULLEY, four
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.viz import sheet_torsion


def geared(beside, ratio):
    return {"inertia": "3 kg·m²", "beside": beside, "stiffness": "60 kN·m/rad", "ratio": ratio}


MACHINES = {
    "inline_six": lambda: ct.load("inline_six"),
    "four": four,
    "branched": lambda: four(
        torsion__disc=FOUR["torsion"]["disc"]
        | {
            "hub": PULLEY,
            "ring": PULLEY | {"beside": "hub"},
            "generator": geared("flywheel", 2),
            "compressor": geared("flywheel", 1),
            "wheel": geared("flywheel", 0.5),
            "propeller": geared("wheel", 1),
        },
        torsion__free_end="hub",
    ),
    "long names": lambda: four(
        torsion__disc={f"{letter}_disc_with_quite_a_name": FLYWHEEL for letter in "abcdefgh"} | {"flywheel": FLYWHEEL}
    ),
    "no firing order": lambda: four(cylinder__firing_order=None),
    "two discs": lambda: ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "130 mm"},
        torsion={"throw_inertia": "1 kg·m²", "disc": {"rotor": geared(1, 1)}},
    ),
    "holzer at its own": lambda: four(torsion__holzer_at=["50 Hz", "170 Hz", "3 kHz"]),
    "slow": lambda: four(shaft__main__speed="30 rpm"),
}


@pytest.fixture(scope="module", params=MACHINES)
def result(request):
    return ct.run(MACHINES[request.param](), step_degrees=90)


@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheet_is_readable(result, size):
    figure = sheet_torsion(result, size=size)
    assert_words_are_readable(figure)
    words = {text for text, _box in words_of(figure)}
    assert {name[:12] for name in result.labels["disc"]} <= {text[:12] for text in words}
    frequencies = result.natural_frequency / (2 * np.pi)
    for mode, frequency in enumerate(frequencies[:4], start=1):
        (said,) = (text for text in words if text.startswith(f"mode {mode}, "))
        assert f"{frequency:#.4g} Hz".replace(". ", " ") in said
    tried = [text for text in words if text.endswith(" left over")]
    assert len(tried) == (2 if "trial_residual" in result.catalogue else 0)


def test_no_line_runs_through_the_name_of_a_frequency(result):
    """Levels are named as frequencies, as their axis is; a dense row of points on each line finds it."""
    figure = sheet_torsion(result)
    names = [(text, box) for text, box in words_of(figure) if text.startswith("$f_")]
    assert names[0][0] == "$f_{1}$"
    share = np.linspace(0.0, 1.0, 2001)
    for axes in figure.axes[1:]:
        for line in axes.lines:
            points = line.get_transform().transform(line.get_xydata())
            along = np.stack([np.interp(share, [0.0, 1.0], ends) for ends in points[[0, -1]].T])
            for text, box in names:
                inside = (along[0] > box.x0) & (along[0] < box.x1) & (along[1] > box.y0) & (along[1] < box.y1)
                assert not np.any(inside), text


def test_table_has_the_critical_speeds_in_sight():
    result = ct.run(ct.load("inline_six"), step_degrees=90)
    words = [text for text, _box in words_of(sheet_torsion(result))]
    assert f"{result.natural_frequency[0] / 6 * 30 / np.pi:.4g}" in words
    assert f"{result.mode_vector_sum[0, 11]:#.4g}" in words


def test_a_machine_too_slow_for_any_is_said_to_be():
    words = " ".join(text for text, _box in words_of(sheet_torsion(ct.run(MACHINES["slow"](), step_degrees=90))))
    assert "No order up to 12 has a natural frequency" in words


def test_without_torsion_there_is_no_sheet():
    with pytest.raises(InputError, match=r"needs \[torsion\]"):
        sheet_torsion(ct.run(ct.load("3d12"), step_degrees=90))


def test_without_frequencies_there_is_no_sheet():
    machine = four(torsion__throw_inertia=["0 kg·m²", *["1 kg·m²"] * 3], masses=None)
    with pytest.raises(InputError, match="no natural frequencies"):
        sheet_torsion(ct.run(machine, step_degrees=90))


def test_of_one_of_several_designs():
    both = ct.run([four(), four(torsion__disc__flywheel__inertia="9 kg·m²")], step_degrees=90)
    alone = ct.run(four(torsion__disc__flywheel__inertia="9 kg·m²"), step_degrees=90)
    of_second = [text for text, _box in words_of(sheet_torsion(both, design=1))]
    assert of_second == [text for text, _box in words_of(sheet_torsion(alone))]
