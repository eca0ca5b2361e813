"""No number that is shown as 0 is anything else: of every result of every example, in tables and pictures."""

import mpmath
import numpy as np
import pytest

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.io.examples import example_names
from cranktrain.panels.figures import aligned, column
from cranktrain.saying.amounts import figures
from cranktrain.saying.scales import scale_for

NOTHING = 1e-9
"""Of the largest of a column, and of the unit in which it stands; of an angle, of a turn."""

PLACES = {"deg", "position"}
"""Crank angles at which something stands count from one among others."""


def is_zero(text):
    return not set(text) & set("123456789–")


def lost(texts, values):
    """Of the values that are shown as 0, the largest, in parts of the largest of all or of one."""
    known = np.abs(values[np.isfinite(values)])
    zeros = [abs(value) for text, value in zip(texts, values, strict=True) if np.isfinite(value) and is_zero(text)]
    return max(zeros, default=0.0) / max(np.max(known, initial=0.0), 1.0)


@pytest.mark.parametrize("name", example_names())
def test_nothing_is_lost(name):
    result = ct.run(name, step_degrees=5.0)
    for one, entry in result.catalogue.items():
        if entry.is_fact and entry.shown not in PLACES:
            values = np.ravel(np.asarray(getattr(result, one), dtype=float))
            is_part = entry.shown == "1" and np.all(np.abs(values[np.isfinite(values)]) < 1)
            scale = scale_for(
                "%" if is_part else entry.shown, float(np.max(np.abs(values[np.isfinite(values)]), initial=0.0))
            )
            shown = np.array([float(scale.of(value)) for value in values])
            assert lost(figures(values, entry.shown).texts, shown) <= NOTHING, one
            assert lost(column(values.tolist(), scale), shown) <= NOTHING, one
            assert lost(aligned(shown), shown) <= NOTHING, one


@pytest.mark.parametrize("least", [1e-8, 3e-5, 0.06])
@pytest.mark.parametrize("unit", ["m", "N*m", "1", "J", "rad/s", "kg*m^2"])
def test_every_number_has_four_figures(unit, least):
    """Whatever stands beside it: here from `least` to 11 of the unit shown."""
    scale = scale_for(unit, 1.0)
    shown = np.array([11.23, 1.1055, -least * 1.2345, 0.0])
    values = shown * scale.one
    for texts in (figures(values, unit).texts, column(values.tolist(), scale), aligned(shown)):
        assert [float(text.replace("−", "-")) for text in texts] == pytest.approx(shown, rel=5e-4, abs=1e-15)
        figures_of_third = texts[2].lstrip("−0.").replace(".", "")
        assert len(figures_of_third) == 4


TRAIN = """
name = "Six discs"
[shaft.main]
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
[bank.line.mechanism]
kind = "slider_crank"
stroke = "42.5 mm"
rod_length = "90 mm"
[torsion]
stiffness = ["2562 N·m/deg", "2430 N·m/deg", "2636 N·m/deg"]
throw_inertia = ["0.0016958 kg·m²", "0.0021595 kg·m²", "0.0018157 kg·m²", "0.0012602 kg·m²"]
free_end = "nose"
[torsion.disc.nose]
inertia = "0.0000199 kg·m²"
beside = 1
stiffness = "3014 N·m/deg"
[torsion.disc.tail]
inertia = "0.0000154 kg·m²"
beside = 4
stiffness = "2562 N·m/deg"
"""


def test_modes_are_each_of_their_own_size(capsys, tmp_path):
    """In the highest of five modes the last disc swings 15 million times as far as the first: the others are no zeros.

    Expected: eigenvectors of K − ω²J with 40 digits, of this train of six discs.
    """
    mpmath.mp.dps = 40
    inertia = [
        mpmath.mpf(one) for one in ("0.0000199", "0.0016958", "0.0021595", "0.0018157", "0.0012602", "0.0000154")
    ]
    springs = [one * 180 / mpmath.pi for one in (3014, 2562, 2430, 2636, 2562)]
    symmetric = mpmath.zeros(6)
    for i, spring in enumerate(springs):
        for at, along, sign in ((i, i, 1), (i + 1, i + 1, 1), (i, i + 1, -1), (i + 1, i, -1)):
            symmetric[at, along] += sign * spring / mpmath.sqrt(inertia[at] * inertia[along])
    _squares, vectors = mpmath.eigsy(symmetric)
    shapes = [[vectors[i, mode] / mpmath.sqrt(inertia[i]) for i in range(6)] for mode in range(1, 6)]
    (tmp_path / "train.toml").write_text(TRAIN, encoding="utf-8")
    main(["run", str(tmp_path / "train.toml"), "--quantities", "mode_shape"])
    lines = [line.split() for line in capsys.readouterr().out.splitlines() if line.startswith("  ") and "–" not in line]
    shown = {(line[0], line[1]): float(line[2].replace("−", "-")) for line in lines if line[0] in "12345"}
    for mode, shape in enumerate(shapes):
        for disc, value in zip(("nose", "1", "2", "3", "4", "tail"), shape, strict=True):
            assert shown[str(mode + 1), disc] == pytest.approx(float(value / shape[0]), rel=6e-4)
