"""Holzer's table at frequencies of one's own: against chains and dynamic stiffness in 40 digits, 0 at natural ones."""

import mpmath
import numpy as np
import pytest
from tests.told import line_of

import cranktrain as ct
from cranktrain.questions.torsion.train import Train, holzer_amplitudes, holzer_table, natural_modes

INERTIA = ("0.0016958", "0.0021595", "0.0018157", "0.0012602")
STIFFNESS = ("2562", "2430", "2636")
NOSE, TAIL = ("0.0000199", "3014"), ("0.0000154", "2562")


def racing_four(*frequencies, **more):
    """Six discs in a row, in N·m/deg, as somebody printed them."""
    ends = zip(("nose", "tail"), (NOSE, TAIL), (1, 4), strict=True)
    discs = {
        name: {"inertia": f"{inertia} kg·m²", "beside": beside, "stiffness": f"{stiffness} N·m/deg"}
        for name, (inertia, stiffness), beside in ends
    }
    return ct.Machine(
        shaft={"main": {"throws": ["0 deg", "180 deg", "180 deg", "0 deg"]}},
        bank={"line": {"mechanism": {"kind": "slider_crank", "stroke": "42.5 mm", "rod_length": "90 mm"}}},
        torsion={
            "stiffness": [f"{one} N·m/deg" for one in STIFFNESS],
            "throw_inertia": [f"{one} kg·m²" for one in INERTIA],
            "free_end": "nose",
            "disc": discs,
            **({"holzer_at": list(frequencies)} if frequencies else {}),
            **more,
        },
    )


def by_chain(frequency):
    """Rows of the table, disc by disc: amplitude, torque, sum, twist."""
    yield from ([float(one) for one in row] for row in rows_of(frequency))


def rows_of(frequency):
    """The same in 40 digits."""
    mpmath.mp.dps = 40
    inertia = [mpmath.mpf(one) for one in (NOSE[0], *INERTIA, TAIL[0])]
    stiffness = [mpmath.mpf(one) * 180 / mpmath.pi for one in (NOSE[1], *STIFFNESS, TAIL[1])]
    square, amplitude, total = (2 * mpmath.pi * mpmath.mpf(frequency)) ** 2, mpmath.mpf(1), mpmath.mpf(0)
    for j, k in zip(inertia, [*stiffness, mpmath.inf], strict=True):
        torque = j * square * amplitude
        total += torque
        yield amplitude, torque, total, total / k
        amplitude -= total / k


@pytest.mark.parametrize("frequency", ["0.01", "120", "1500", "2618.7", "14914.2", "60000"])
def test_a_chain(frequency):
    found = ct.run(racing_four(f"{frequency} Hz"))
    amplitude, torque, total, twist = np.array(list(by_chain(frequency))).T
    # What cancels on the way, as near natural frequencies, is right beside what it was made of.
    gross = np.cumsum(np.abs(torque))
    for name, wanted, of in (
        ("trial_amplitude", amplitude, np.maximum.accumulate(np.abs(amplitude))),
        ("trial_torque", torque, np.maximum.accumulate(np.abs(torque))),
        ("trial_sum", total, gross),
    ):
        assert np.all(np.abs(found.dataset[name].values.ravel() - wanted) < 1e-12 * of), name
    np.testing.assert_allclose(found.dataset.trial_twist.values.ravel()[:-1], twist[:-1], rtol=1e-9)
    assert np.abs(np.ravel(found.trial_residual)[0] - total[-1]) < 1e-12 * gross[-1]
    assert all(np.all(check.passed) for check in found.checks)


def test_nothing_is_left_over_at_natural_frequencies():
    natural = ct.run(racing_four()).natural_frequency
    frequencies = [float(one) / (2 * np.pi) for one in natural]
    found = ct.run(racing_four(*(f"{one!r} Hz" for one in frequencies))).dataset
    ends = [[list(rows_of(one * (1 + mpmath.mpf(side) / 10**12)))[-1][2] for side in (-1, 1)] for one in frequencies]
    slopes = [(high - low) / 2 * 10**12 / one for (low, high), one in zip(ends, frequencies, strict=True)]
    rounding = [16 * np.spacing(one) * abs(float(slope)) for one, slope in zip(frequencies, slopes, strict=True)]
    gross = np.sum(np.abs(found.trial_torque.values), axis=-1)
    np.testing.assert_array_less(np.abs(found.trial_residual.values), rounding + 1e-14 * gross)
    np.testing.assert_array_less(np.array(rounding[:3]), 1e-10 * gross[:3])


def test_signs_change_there():
    """With one natural frequency between each two."""
    found = ct.run(racing_four(*(f"{one} Hz" for one in (100, 1500, 2300, 5000, 15000, 20000))))
    assert np.sign(np.ravel(found.trial_residual)).tolist() == [1, -1, 1, -1, 1, -1]


def branched():
    """Two branches with a fork of their own on the last disc but one."""
    inertia, stiffness = np.array([[0.7, 1.3, 0.4, 2.0, 0.9, 1.1, 3.0]]), np.array([[5.0, 7.0, 2.0, 9.0, 4.0, 6.0]])
    return Train(inertia, stiffness, np.array([2, 2, 5, 4, 5, 6]))


@pytest.mark.parametrize("speed", [0.3, 1.7, 4.4, 12.0])
def test_branches(speed):
    """K a − ω²J a is 0 at all discs but the last, by elimination in 40 digits."""
    train = branched()
    mpmath.mp.dps = 40
    n = 7
    matrix = mpmath.matrix(n, n)
    for disc, (k, onto) in enumerate(zip(train.stiffness[0].tolist(), train.following.tolist(), strict=True)):
        for row, column, sign in ((disc, disc, 1), (onto, onto, 1), (disc, onto, -1), (onto, disc, -1)):
            matrix[row, column] += sign * mpmath.mpf(k)
    for disc, j in enumerate(train.inertia[0].tolist()):
        matrix[disc, disc] -= mpmath.mpf(speed) ** 2 * mpmath.mpf(j)
    inner = mpmath.matrix([[matrix[i, k] for k in range(n - 1)] for i in range(n - 1)])
    right = mpmath.matrix([-matrix[i, n - 1] for i in range(n - 1)])
    wanted = np.array([*map(float, mpmath.lu_solve(inner, right)), 1.0])
    found = holzer_amplitudes(train, np.array([[speed]]))
    shape = found[0, 0] / found[0, 0, -1]
    np.testing.assert_allclose(shape, wanted, rtol=1e-11)
    left = holzer_table(train, np.array([[speed]]), shape[np.newaxis, np.newaxis]).total[0, 0, -1]
    assert left == pytest.approx(speed**2 * float(np.sum(train.inertia[0] * wanted)), rel=1e-12)


def test_a_branch_that_comes_as_a_node():
    """At its own frequency alone, with the fork held, it moves and nothing else of what meets it."""
    train = Train(np.array([[2.0, 3.0, 1.0, 5.0]]), np.array([[8.0, 3.0, 4.0]]), np.array([2, 2, 3]))
    found = holzer_amplitudes(train, np.array([[2.0]]))[0, 0]
    assert found[1] == 0.0 and found[2] == 0.0 and found[0] != 0.0
    assert found[3] == pytest.approx(-found[0] * 2.0 * 4.0 / 4.0)


def test_natural_frequencies_of_branches():
    train = branched()
    modes = natural_modes(train)
    found = holzer_amplitudes(train, modes.speed)
    table = holzer_table(train, modes.speed, found)
    np.testing.assert_array_less(np.abs(table.total[..., -1]), 1e-12 * np.sum(np.abs(table.torque), axis=-1))


def test_one_wording_of_many():
    """In kHz as in Hz, one as in a list; many designs as one."""
    machines = [racing_four("120 Hz"), racing_four("0.15 kHz")]
    together = ct.run(machines).trial_residual
    for own, machine in zip(together, machines, strict=True):
        np.testing.assert_array_equal(np.ravel(own), np.ravel(ct.run(machine).trial_residual))
    np.testing.assert_allclose(
        np.ravel(ct.run(racing_four("0.12 kHz")).trial_residual), np.ravel(together[0]), rtol=1e-14
    )


def test_the_row():
    left = list(by_chain("120"))[-1][2] * np.pi / 180
    said = line_of(ct.run(racing_four("120 Hz")), "Torsion", "left over at 120.0 Hz")
    assert said == f"{left:.4g} N·m/deg, Holzer"


def test_nobody_who_does_not_ask_has_any():
    assert "trial_residual" not in ct.run(racing_four()).catalogue


@pytest.mark.parametrize(
    "given, wanted",
    [
        ("0 Hz", "must be"),
        ("-5 Hz", "must be"),
        ("120", "must be a frequency"),
        ("120 mm", "measures a length"),
        ("120 mm", "or in rpm, rad/s"),
        ("0 rad/s", "more than 0 rad/s"),
        ([], ""),
    ],
    ids=str,
)
def test_refused(given, wanted):
    with pytest.raises(ct.InputError) as found:
        racing_four(holzer_at=given)
    assert "torsion.holzer_at" in str(found.value)
    assert wanted in str(found.value)


@pytest.mark.parametrize(
    "given", ["120 Hz", "7200 rpm", "7200 1/min", "7200 об/мин", "0.12 kHz", "753.9822368615503 rad/s"]
)
def test_a_frequency_may_be_given_as_an_angular_one(given):
    """7200 oscillations in a minute are 120 in a second, 240 π rad in a second."""
    assert ct.run(racing_four(given)).trial_frequency == pytest.approx(240 * np.pi, rel=2e-15)
