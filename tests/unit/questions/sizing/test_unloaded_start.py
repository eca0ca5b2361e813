"""A machine that starts unloaded: what its motor is then checked against, and where that is said."""

import re

import numpy as np
import pytest
from scipy.integrate import quad
from tests.told import row_of, texts_of

import cranktrain as ct
from cranktrain.cli.synthesis.proposals import give_proposal
from cranktrain.saying.amounts import measured_in
from cranktrain.synthesis.drive import drive

RPM = np.pi / 30
MASS, CRANK, RATIO, FORWARD, BACKWARD, DRAG = 200.0, 0.1, 20.0, 0.9, 0.8, 0.5
G = 9.80665
MOTOR = {
    "kind": "cage",
    "curve": "kloss",
    "power": "5.5 kW",
    "speed": "1440 rpm",
    "synchronous_speed": "1500 rpm",
    "breakdown_ratio": 2.5,
    "inertia": "0.03 kg*m^2",
}
RATED, OWN_SLIP = 5500 / (1440 * RPM), 60 / 1500
SLIP = OWN_SLIP * (2.5 + np.sqrt(2.5**2 - 1))
STARTED = {"start": "unloaded", "allowed_start_time": "2 s"}


def press(duty):
    """A yoke that lifts a weight, and presses with 5 kN."""
    return ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": "100 mm"},
        gravity=True,
        shaft={"main": {"speed": "70 rpm"}},
        masses={"piston": {"mass": f"{MASS} kg"}},
        load={"pressing": {"on": "piston", "force": "5 kN"}},
        drive={
            "motor": MOTOR,
            "stage": [
                {"ratio": RATIO, "efficiency": FORWARD, "efficiency_back": BACKWARD, "drag": f"{DRAG} N*m"},
            ],
            "part": {"wheel": {"inertia": "0.2 kg*m^2"}},
            "duty": duty,
        },
    )


def kloss(speed):
    slip = 1 - speed / (1500 * RPM)
    return 2.5 * RATED * 2 * slip * SLIP / (slip**2 + SLIP**2)


@pytest.fixture(scope="module")
def started():
    return ct.run(press(STARTED))


def test_against_the_weight_alone(started):
    """M g R sin φ at the crank: through the gear 1/η of it goes up to the motor, η′ of it comes back, drag on top."""
    at_crank = MASS * G * CRANK
    worst = at_crank / RATIO / FORWARD + DRAG
    least = min(kloss(0.0), 2.5 * RATED)
    assert started.sizing_share[0, 2] == pytest.approx(worst / (0.81 * least), rel=1e-5)


def test_time_of_the_start(started):
    """Against the mean of that over a turn, by quadrature of J dω over what is left of 0.81 of Kloss's torque."""
    mean = MASS * G * CRANK / np.pi / RATIO * (1 / FORWARD - BACKWARD) + DRAG
    inertia = 0.03 + 0.2 + MASS * CRANK**2 / 2 / RATIO**2
    time, _error = quad(lambda speed: inertia / (0.81 * kloss(speed) - mean), 0, 1500 * RPM * (1 - 2 * OWN_SLIP))
    assert started.sized_start_time[0] == pytest.approx(time, rel=1e-5)
    assert started.sizing_share[0, 3] == pytest.approx(time / 2, rel=1e-5)


def test_it_is_said_where_the_number_stands(started):
    own = ct.run(press({**STARTED, "start": "loaded"}))
    loaded, unloaded = (row_of(each, "Drive", "motor is used to").words for each in (own, started))
    assert re.search(r"% if it must start with load at the worst angle, time of a start \S+\s%$", str(loaded))
    assert re.search(r", start, unloaded \S+\s%, time of a start \S+\s%$", str(unloaded))
    for words, sized in ((loaded, own), (unloaded, started)):
        np.testing.assert_array_equal([one.value for one in measured_in(words)], sized.sizing_share[0, :4])
    assert any(flag.startswith("A start with its load at the worst angle asks") for flag in texts_of(own.flags))
    assert not any("start" in flag for flag in texts_of(started.flags))
    assert "unloaded_start" in started.labels["sizing_check"]
    np.testing.assert_array_equal(own.sizing_share[0, :2], started.sizing_share[0, :2])


def test_a_proposal_writes_it(tmp_path):
    """The file of `--unloaded-start` says so, and then passes every check of `run`."""
    path = tmp_path / "crusher.toml"
    give_proposal("drive", {"unloaded_start": True}, str(path), force=False, source="jaw_crusher")
    written = ct.load(str(path))
    proposal = drive(ct.load("jaw_crusher"), unloaded_start=True)
    assert written.drive.duty.start == proposal.machine.drive.duty.start == "unloaded"
    found = ct.run(written)
    assert float(np.nanmax(found.sizing_share[0])) <= 1
    assert not any("too small" in flag for flag in texts_of(found.flags))
    assert any("started unloaded" in one for one in texts_of(proposal.remarks))


def test_open_valves_of_a_compressor():
    """Held open they leave the pressure before them in the cylinder, here the atmosphere's within 28 Pa."""
    loaded, free = (
        ct.run("compressor_start", set={"drive.duty.start": start}).sizing_share[0, 2]
        for start in ("loaded", "unloaded")
    )
    assert free < 1e-3 * loaded + 0.02


def test_words():
    with pytest.raises(ct.InputError, match=r"drive\.duty\.start.*unloaded"):
        press({"start": "idle"})
