"""Facts of three machines against 30-digit quadrature and root search: a jump of the gas, kinks of friction, a card.

Nothing here goes through the package: motion by the closed form of a central slider-crank, forces by hand, integrals by
mpmath between the events, extremes by roots of the derivative or at the events, from the side on which they are larger.
"""

from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

import mpmath
import numpy as np
import pytest
from mpmath import mpf

import cranktrain as ct

mpmath.mp.dps = 40
RADIUS, ROD, BORE, MASS, OMEGA = mpf("0.05"), mpf("0.18"), mpf("0.09"), mpf("1.3"), mpf(200)
AREA = mpmath.pi * BORE**2 / 4
AMBIENT = mpf(101325)
TURN = 2 * mpmath.pi
TABLES: dict[str, Any] = {
    "shaft": {"main": {"speed": "200 rad/s"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
    "masses": {"piston": {"mass": "1.3 kg"}},
}


def quadrature(curve: Any, edges: list[mpf]) -> mpf:
    """Gauss's, since all is smooth between events."""
    return mpmath.quad(curve, edges, method="gauss-legendre")


class Moving(NamedTuple):
    """Distance of the piston from its top, x′ and x″; sine of the pressure angle."""

    x: mpf
    first: mpf
    second: mpf
    lean: mpf


@cache
def moving(phi: mpf) -> Moving:
    sine, cosine = mpmath.sin(phi), mpmath.cos(phi)
    root = mpmath.sqrt(ROD**2 - (RADIUS * sine) ** 2)
    first = RADIUS * sine + RADIUS**2 * sine * cosine / root
    second = RADIUS * cosine + RADIUS**2 * mpmath.cos(2 * phi) / root + RADIUS**4 * (sine * cosine) ** 2 / root**3
    return Moving(RADIUS + ROD - RADIUS * cosine - root, first, second, RADIUS * sine / ROD)


def inertia(now: Moving) -> mpf:
    """Of the piston, toward the shaft."""
    return -MASS * OMEGA**2 * now.second


class Case(NamedTuple):
    """A machine, its torque and the force in its piston pin just after an angle, and its events in one turn."""

    tables: dict[str, Any]
    torque: Any
    pin: Any
    events: list[mpf]


def otto() -> Case:
    """A two-stroke by the ideal Otto cycle: its pressure jumps at the top."""
    ratio, low, high, start, heat = mpf(8), mpf("1.32"), mpf("1.26"), mpf(100000), mpf("3.2")
    swept = 2 * RADIUS * AREA
    clearance = swept / (ratio - 1)

    def pressure(phi: mpf) -> mpf:
        volume = clearance + AREA * moving(phi).x
        if phi < mpmath.pi:
            return start * ratio**low * heat * (clearance / volume) ** high
        return start * ((clearance + swept) / volume) ** low

    def push(phi: mpf) -> mpf:
        return (pressure(phi) - AMBIENT) * AREA + inertia(moving(phi))

    tables = TABLES | {
        "cylinder": {"bore": "90 mm", "compression_ratio": 8, "cycle": "two-stroke", "firing_order": "1"},
        "gas": {
            "kind": "otto",
            "start_pressure": "100 kPa",
            "compression_exponent": "1.32",
            "expansion_exponent": "1.26",
            "pressure_ratio": 3.2,
        },
    }
    return Case(
        tables,
        lambda phi: push(phi) * moving(phi).first,
        lambda phi: abs(push(phi)) / mpmath.sqrt(1 - moving(phi).lean ** 2),
        [mpf(0), mpmath.pi, TURN],
    )


def rubbing() -> Case:
    """Without gas, with friction of 0.12 between piston and wall, which bends where N = 0."""
    friction = mpf("0.12")

    def parts(phi: mpf) -> tuple[mpf, mpf]:
        """Along the rod, which is massless, from the crank's side; its component along the stroke and its tangent."""
        now = moving(phi)
        tangent = now.lean / mpmath.sqrt(1 - now.lean**2)
        along = -MASS * OMEGA**2 * now.second  # m s̈ of the piston, away from the shaft
        sense = mpmath.sign(-now.first)
        # tan θ = −tan β: N₀ = X₀ tan β; friction −μσ|N| acts on the piston with it.
        normal = along * tangent / (1 - friction * sense * mpmath.sign(along * tangent) * tangent)
        return along + friction * sense * abs(normal), tangent

    def torque(phi: mpf) -> mpf:
        force, tangent = parts(phi)
        driving = RADIUS * (mpmath.cos(phi) * -force * tangent - mpmath.sin(phi) * force)
        return -driving

    def pin(phi: mpf) -> mpf:
        force, tangent = parts(phi)
        return abs(force) * mpmath.sqrt(1 + tangent**2)

    still = [mpmath.findroot(lambda phi: moving(phi).second, start) for start in (mpf("1.3"), mpf("4.98"))]
    events = sorted([mpf(0), mpmath.pi, TURN, *still])
    return Case(TABLES | {"friction": {"piston": 0.12}}, torque, pin, events)


def card() -> Case:
    """A steam engine's card by corners: between equal pressures and at jumps nothing is left to the interpolation."""
    steps = [(mpf(0), mpf(9)), (mpf(112), mpf("2.5")), (mpf(180), mpf("1.2")), (mpf(310), mpf(4))]
    rows = ["angle [deg];pressure [bar]"]
    for place, (at, level) in enumerate(steps):
        end = steps[place + 1][0] if place + 1 < len(steps) else mpf(360)
        rows += [f"{mpmath.nstr(at + (end - at) * k / 12, 20)};{mpmath.nstr(level, 10)}" for k in range(13)]

    def pressure(phi: mpf) -> mpf:
        return [level for at, level in steps if phi >= mpmath.radians(at)][-1] * 100000

    def push(phi: mpf) -> mpf:
        return (pressure(phi) - AMBIENT) * AREA + inertia(moving(phi))

    tables = TABLES | {
        "cylinder": {"bore": "90 mm", "compression_ratio": 12, "cycle": "two-stroke", "firing_order": "1"},
        "gas": {"kind": "indicator", "file": "card.csv", "text": "\n".join(rows), "firing_angle": "0 deg"},
    }
    return Case(
        tables,
        lambda phi: push(phi) * moving(phi).first,
        lambda phi: abs(push(phi)) / mpmath.sqrt(1 - moving(phi).lean ** 2),
        [*(mpmath.radians(at) for at, _level in steps), TURN],
    )


@pytest.fixture(scope="module", autouse=True)
def thirty_digits():
    """Half as many points as for forty, and still twice the digits of what is checked."""
    with mpmath.workdps(30):
        yield


CASES = {"jump": otto, "friction": rubbing, "card": card}


@pytest.fixture(scope="module", params=CASES)
def both(request: pytest.FixtureRequest) -> tuple[Case, Any]:
    case = CASES[request.param]()
    case = case._replace(torque=cache(case.torque))  # quadratures over the same intervals ask at the same angles
    return case, ct.run(ct.Machine(**case.tables))


def pieces(case: Case) -> list[mpf]:
    """Ends of the intervals of the quadrature."""
    edges = [edge for one, other in pairwise(case.events) for edge in (one, (one + other) / 2)]
    return [*edges, case.events[-1]]


def extreme(case: Case, curve: Any, sign: int) -> tuple[float, float]:
    """Largest value of sign times a curve, and the curve's own value and angle [deg] there."""
    found: list[tuple[mpf, mpf]] = []
    aside = mpf(10) ** -25
    for start, end in pairwise(case.events):
        # Closer near the ends, beside which friction may let a force rise.
        grid = [start + (end - start) * (1 - mpmath.cos(mpmath.pi * k / 90)) / 2 for k in range(1, 90)]
        values = [sign * curve(phi) for phi in grid]
        found += [(sign * curve(start + aside), start), (sign * curve(end - aside), end)]
        for place in range(1, len(grid) - 1):
            if values[place] > max(values[place - 1], values[place + 1]):
                root = mpmath.findroot(lambda phi: mpmath.diff(curve, phi), grid[place])
                found.append((sign * curve(root), root))
    best = max(value for value, _angle in found)
    first = min(angle % TURN for value, angle in found if value >= best * (1 - mpf(10) ** -15))
    return float(sign * best), float(mpmath.degrees(first))


def test_mean_torque(both):
    case, result = both
    mean = quadrature(case.torque, pieces(case)) / TURN
    assert result.mean_torque == pytest.approx(float(mean), rel=1e-10, abs=1e-10 * float(result.largest_torque))
    if "gas" in case.tables:
        assert result.mean_torque * 2 * np.pi == pytest.approx(float(result.gas_work[()]), rel=1e-12)


def test_orders(both):
    case, result = both
    scale = float(np.max(result.torque_order_amplitude))
    for order in (1, 2, 3, 7, 24):
        wave = quadrature(lambda phi, k=order: case.torque(phi) * mpmath.expj(k * phi), cut(case, order)) / mpmath.pi
        amplitude, phase = float(abs(wave)), float(mpmath.degrees(mpmath.arg(wave)))
        assert result.torque_order_amplitude[order - 1] == pytest.approx(amplitude, abs=1e-9 * scale), order
        off = (result.torque_order_phase[order - 1] - phase + 180) % 360 - 180
        assert off * amplitude == pytest.approx(0, abs=1e-7 * scale), order


def cut(case: Case, order: int) -> list[mpf]:
    """Intervals that are narrow enough for an order."""
    edges = pieces(case)
    n_parts = 1 + order // 6
    return [one + (other - one) * k / n_parts for one, other in pairwise(edges) for k in range(n_parts)] + [edges[-1]]


@pytest.mark.parametrize("name", ["largest_torque", "smallest_torque"])
def test_extremes_of_the_torque(both, name):
    case, result = both
    value, angle = extreme(case, case.torque, 1 if name.startswith("largest") else -1)
    assert getattr(result, name) == pytest.approx(value, rel=1e-9)
    assert getattr(result, f"{name}_at") == pytest.approx(angle, abs=np.degrees(1e-6))


def test_the_largest_force_of_a_joint(both):
    case, result = both
    value, angle = extreme(case, case.pin, 1)
    joint = result.labels["joint"].index("1.wrist_pin")
    assert result.largest_joint_force[joint] == pytest.approx(value, rel=1e-9)
    assert result.largest_joint_force_at[joint] == pytest.approx(angle, abs=np.degrees(1e-6))


def test_excess_work(both):
    """Of the torque without inertia, whose work is ½Jω² with J = m x′².

    Between two points of the grid the work is a cubic: a jump ΔT in a step h is rounded off by up to ΔT h/8.
    """
    case, _result = both
    if "gas" not in case.tables:
        pytest.skip("friction that inertia makes stays in the torque")
    ends = pieces(case)
    mean = quadrature(case.torque, ends) / TURN

    def gas(phi: mpf) -> mpf:
        now = moving(phi)
        return case.torque(phi) - inertia(now) * now.first - mean

    # The work turns back where the torque is its mean, at a root or at a jump.
    found, total = [mpf(0)], mpf(0)
    marks = sorted({mark for one, other in pairwise(case.events) for mark in mpmath.linspace(one, other, 25)})
    inside = [mark + mpf(10) ** -25 for mark in marks[:-1]], [mark - mpf(10) ** -25 for mark in marks[1:]]
    for one, other in zip(*inside, strict=True):
        if gas(one) * gas(other) < 0:
            root = mpmath.findroot(gas, (one, other), solver="anderson")
            found.append(total + quadrature(gas, [one, root]))
        total += quadrature(gas, [one, other])
        found.append(total)
    assert float(total) == pytest.approx(0, abs=1e-12 * float(max(found)))
    aside = mpf(10) ** -25
    leaps = [abs(gas(event + aside) - gas(event - aside)) for event in case.events[1:-1]]
    rounded = float(max(leaps)) * np.radians(1) / 8
    run = ct.run(ct.Machine(**case.tables, evenness={"flywheel": "3 kg·m²"}))
    assert run.largest_excess_work == pytest.approx(float(max(found) - min(found)), rel=1e-6, abs=rounded)
