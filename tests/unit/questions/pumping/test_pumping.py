"""Pumping unit: what may stand in its table, turned backward, weights out of line, no load twice."""

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.questions.pumping.turn_pieces import TurnPieces

UNIT = "pumping_unit_c57"


def problems(**paths):
    with pytest.raises(ct.InputError) as caught:
        ct.run(UNIT, set=paths)
    return [(problem.path, str(problem)) for problem in caught.value.problems]


def load_of(name):
    return dict(ct.load(UNIT).declared["load"][name])


@pytest.mark.parametrize(
    ("paths", "path", "said"),
    [
        ({"pumping.card": "well"}, "pumping.card", "invented_card, unbalance, counterbalance"),
        ({"pumping.counterbalance": "weights"}, "pumping.counterbalance", "must be the name of a load"),
        ({"pumping.counterbalance": "invented_card"}, "pumping.counterbalance", "must not be the load"),
        ({"pumping.counterbalance": "unbalance"}, "pumping.counterbalance", "on the crank"),
        (
            {"pumping.card": "counterbalance", "pumping.counterbalance": "unbalance"},
            "pumping.card",
            "a rope off its arc",
        ),
        ({"pumping.rated_torque": "0 N*m"}, "pumping.rated_torque", "more than 0"),
        ({"pumping.rated_load": "0 N"}, "pumping.rated_load", "more than 0"),
    ],
)
def test_refused(paths, path, said):
    found = problems(**paths)
    assert any(where.startswith(path) and said in words for where, words in found), found


def test_second_rope_is_refused():
    found = problems(**{"load.second": load_of("invented_card")})
    assert any(where == "pumping.card" and "second rope" in words for where, words in found)


def test_machine_without_rocker_is_refused():
    with pytest.raises(ct.InputError) as caught:
        ct.run("vaz_21213", set={"pumping": {"card": "gas"}})
    assert any(problem.path == "pumping" and "rocker" in str(problem) for problem in caught.value.problems)


def test_backward_torque_is_the_other_sign_at_the_same_pull():
    """With the same pull both ways the mechanism turned astern has −T at the same place of the crank."""
    same = {f"load.invented_card.{name}": ["8500 lbf"] * 5 for name in ("force", "force_back")}
    ahead, astern = (ct.run(UNIT, set={**same, "running": running}) for running in ("ahead", "astern"))
    forward, backward = (np.asarray(one.gearbox_torque) for one in (ahead, astern))
    assert backward == pytest.approx(-np.roll(forward[::-1], 1), abs=1e-9 * np.max(np.abs(forward)))
    assert float(astern.least_gearbox_torque) == pytest.approx(
        -max(float(ahead.upstroke_peak), float(ahead.downstroke_peak)), rel=1e-12
    )
    places = [np.asarray(one.rod_position) for one in (ahead, astern)]
    assert places[1] == pytest.approx(np.roll(places[0][::-1], 1), abs=1e-12)


def test_weights_ahead_of_the_pin():
    """As on units with phased cranks: T_M = −M sin(θ + τ), θ from where the pin stands up."""
    moment, phase = 5392.002 * 32 * 4.4482216152605 * 0.0254, np.radians(24.0)
    arm = {"along": f"{float(32 * np.cos(phase))!r} in", "across": f"{float(-32 * np.sin(phase))!r} in"}
    result = ct.run(UNIT, set={f"load.counterbalance.{name}": value for name, value in arm.items()})
    theta = np.radians(np.asarray(result.crank_angle))
    ahead = np.radians(float(result.weights_phase))
    assert abs(ahead) == pytest.approx(phase, rel=1e-12)
    torque = np.asarray(result.counterbalance_torque)
    assert torque == pytest.approx(-moment * np.sin(theta + ahead), abs=1e-9 * moment)
    assert float(result.counterbalance_moment) == pytest.approx(moment, rel=1e-12)


def test_least_rms_is_least():
    result = ct.run(UNIT)
    share = float(result.least_rms_moment / result.counterbalance_moment)
    rms = [
        float(ct.run(UNIT, set={"load.counterbalance.force": f"{5392.002 * share * more!r} lbf"}).rms_gearbox_torque)
        for more in (0.99, 1.0, 1.01)
    ]
    assert rms[1] == pytest.approx(float(result.least_rms_torque), rel=1e-12)
    assert rms[1] < min(rms[0], rms[2])


@pytest.mark.parametrize(("force", "word"), [("5931.2 lbf", "too heavy"), ("4853 lbf", "too light")])
def test_weights_too_heavy_or_light_are_flagged(force, word):
    assert any(word in said for said in texts_of(ct.run(UNIT, set={"load.counterbalance.force": force}).flags))


def test_designs_are_as_each_alone():
    forces = ["5000 lbf", "5392.002 lbf"]
    alone = [ct.run(UNIT, set={"load.counterbalance.force": force}) for force in forces]
    together = ct.run([ct.load(UNIT, set={"load.counterbalance.force": force}) for force in forces])
    for name in ("upstroke_peak", "equal_peaks_moment", "cyclic_load_factor", "rms_gearbox_torque"):
        assert np.ravel(getattr(together, name)) == pytest.approx(
            [float(getattr(one, name)) for one in alone], rel=1e-12
        )


@pytest.mark.parametrize("force", ["3000 lbf", "4853 lbf", "5392.002 lbf", "5931.2 lbf", "9000 lbf"])
def test_equal_peaks_take_five_trials(monkeypatch, force):
    trials = []
    tops = TurnPieces.tops
    monkeypatch.setattr(TurnPieces, "tops", lambda self, curves: trials.append(len(curves)) or tops(self, curves))
    found = ct.run(UNIT, set={"load.counterbalance.force": force})
    assert float(found.equal_peaks_moment) == pytest.approx(172544.0659585192 * 4.4482216152605 * 0.0254, rel=1e-6)
    *own, last = trials
    assert sum(own) <= 5
    assert last == 5
