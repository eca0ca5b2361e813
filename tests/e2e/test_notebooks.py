"""Tasks done from an empty folder as the documents teach; and held against closed forms and other ways."""

import math
import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.notebooks import DOCS, NOTEBOOKS, cells, followed

pytest.importorskip("IPython", reason="notebooks show pictures by it")

R, L, OMEGA = 0.040, 0.136, 100 * math.pi
"""Of the in-line four. [m, rad/s]"""


@pytest.fixture(scope="module")
def after(tmp_path_factory: pytest.TempPathFactory):
    """What is known after a page was followed, by its path in the documentation."""
    done: dict[str, dict[str, Any]] = {}

    def known(page: str) -> dict[str, Any]:
        if page not in done:
            with pytest.MonkeyPatch.context() as patch:
                patch.chdir(tmp_path_factory.mktemp("empty"))
                done[page] = followed(DOCS / page)
        return done[page]

    return known


@pytest.mark.parametrize("page", NOTEBOOKS, ids=lambda page: page.stem)
def test_can_be_followed(after, page: Path):
    assert after(page.relative_to(DOCS).as_posix())


def test_a_page_is_followed_in_a_kernel(tmp_path, monkeypatch):
    """As in Jupyter, where each command is a program of its own; what builds the documentation types them itself."""
    client = pytest.importorskip("nbclient", reason="the documentation is built with the extra `docs`")
    nbformat = pytest.importorskip("nbformat")
    program = tmp_path / "cranktrain"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m cranktrain "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", os.pathsep.join([str(tmp_path), os.environ["PATH"]]))
    monkeypatch.setenv("PYTHONPATH", str(DOCS.parent / "src"))
    typed = [nbformat.v4.new_code_cell(cell) for cell in cells(DOCS / "tasks/two-stage-compressor.md")]
    resources = {"metadata": {"path": str(tmp_path)}}
    client.NotebookClient(nbformat.v4.new_notebook(cells=typed), kernel_name="python3", resources=resources).execute()
    shown = [output for cell in typed for output in cell.outputs]
    said = "".join(output.text for output in shown if output.output_type == "stream")
    assert "between the stages 3." in said
    assert "written: sheet.svg" in said
    assert any("image/svg+xml" in output.get("data", {}) for output in shown)


def rising(phi):
    """Derivative, by the angle, of the piston's distance from the shaft."""
    pin = R * np.exp(1j * phi)
    return -pin.imag - pin.imag * pin.real / np.sqrt(L**2 - pin.imag**2)


class TestInLineFour:
    """From card to flywheel."""

    def test_work_is_the_area_of_the_card(self, after):
        known = after("lessons/engine.md")
        pressure, volume = (np.append(known[name], known[name][0]) for name in ("pressure", "volume"))
        area = np.sum((pressure[1:] + pressure[:-1]) / 2 * np.diff(volume))  # by the swept volume
        # Trapezia of 1° miss the card's curvature: (π/180)²/12 of a second derivative of some tens.
        assert known["mean"] / 1e5 == pytest.approx(area, rel=5e-4)

    def test_torque_is_power_over_speed(self, after):
        known = after("lessons/engine.md")
        swept = math.pi / 4 * 0.082**2 * 2 * R
        assert known["result"].mean_torque == pytest.approx(4 * known["mean"] * swept / (4 * math.pi), rel=1e-9)

    def test_flywheel_gives_the_fluctuation_wanted(self, after):
        """By energy, on the card's own rows: work of the gas, and the inertia of pistons and rods."""
        known = after("lessons/engine.md")
        phi, gas, inertia = np.radians(np.arange(720.0)), np.zeros(720), np.zeros(720)
        for fires in (0, 540, 180, 360):
            local = phi - math.radians(fires)
            slope = rising(local)
            gauge = np.roll(known["pressure"], fires) * 1e5 - 101325
            gas += gauge * math.pi / 4 * 0.082**2 * -slope
            tilt = np.arcsin(R * np.sin(local) / L)
            turn = R * np.cos(local) / (L * np.cos(tilt))
            pin_velocity = 1j * R * np.exp(1j * local)
            centroid = pin_velocity + 0.19 / 0.715 * (slope - pin_velocity)
            inertia += 0.45 * slope**2 + 0.715 * np.abs(centroid) ** 2 + 0.00235 * turn**2
        excess = gas - gas.mean()
        work = np.concatenate([[0], np.cumsum((excess[1:] + excess[:-1]) / 2)]) * math.radians(1)
        whole = known["wheels"]["exact"] + inertia
        energy = np.mean(whole) * OMEGA**2 / 2 - np.mean(work)
        for _ in range(20):  # until the mean over the turn is the declared one
            omega = np.sqrt(2 * (energy + work) / whole)
            energy += np.mean(whole) * OMEGA * (OMEGA - 1 / np.mean(1 / omega))
        assert (omega.max() - omega.min()) / OMEGA == pytest.approx(0.02, rel=3e-3)
        assert known["running"].coefficient_of_fluctuation == pytest.approx(0.02, rel=1e-6)


class TestCrankRocker:
    """The numbers of 40 digits that the page of the theory has, and the coupler curve by crossing circles."""

    def test_swing_and_time_ratio(self, after):
        result = after("lessons/crank-rocker.md")["result"]
        assert math.degrees(result.swing[0]) == pytest.approx(60.14176317846603, rel=1e-12)
        assert result.time_ratio[0] == pytest.approx(1.03240130248581, rel=1e-12)
        assert math.degrees(result.smallest_transmission_angle[0]) == pytest.approx(51.317812546511, rel=1e-12)

    def test_proposal_takes_the_time_wanted(self, after):
        assert after("lessons/crank-rocker.md")["proposed"].time_ratio[0] == pytest.approx(1.1, rel=1e-6)

    def test_coupler_curve(self, after):
        known = after("lessons/crank-rocker.md")
        angle = np.radians(known["x"].crank_angle.values)
        pin = 0.25 * np.exp(1j * angle)
        along = 0.8 - pin
        part = (0.7**2 - 0.5**2 + np.abs(along) ** 2) / (2 * np.abs(along))
        joint = pin + along / np.abs(along) * (part + 1j * np.sqrt(0.7**2 - part**2))
        point = pin + (0.35 + 0.25j) * (joint - pin) / 0.7
        np.testing.assert_allclose(known["x"].values + 1j * known["y"].values, point, rtol=0, atol=1e-14)
        speed = np.abs(np.fft.ifft(np.fft.fft(point) * np.fft.fftfreq(360, 1 / 360))) * 2 * math.pi
        np.testing.assert_allclose(known["velocity"].values, speed, rtol=0, atol=1e-10)


def test_steam_engine_passes_the_middle_early(after):
    travel = float(after("lessons/steam.md")["travel"].sel(crank_angle=90)) / 0.0254
    assert travel == pytest.approx(6 + 30 - math.sqrt(30**2 - 6**2), rel=1e-12)


def test_stages_share_one_flow(after):
    """Between the stages by halving; work of a stage in closed form, exponent 1.3."""
    result = after("tasks/two-stage-compressor.md")["result"]
    low, high = (math.pi / 4 * bore**2 * 0.16 for bore in (0.25, 0.15))

    def taken(clearance, ratio):
        return 1 + clearance - clearance * ratio ** (1 / 1.3)

    least, most = 1.0, 9.0
    for _ in range(60):
        between = (least + most) / 2
        more = taken(0.06, between) * low / 293.15 > taken(0.08, 9 / between) * high * between / 313.15
        least, most = (between, most) if more else (least, between)
    assert result.discharge_line_pressure[0] / 1e5 == pytest.approx(between, rel=1e-12)
    assert result.inlet_flow[0] == pytest.approx(taken(0.06, between) * low * 12, rel=1e-12)
    work = sum(
        1.3 / 0.3 * suction * 1e5 * taken(clearance, ratio) * swept * (ratio ** (0.3 / 1.3) - 1)
        for suction, clearance, ratio, swept in ((1, 0.06, between, low), (between, 0.08, 9 / between, high))
    )
    assert -result.indicated_power == pytest.approx(12 * work, rel=1e-12)


def test_radial(after):
    """Strokes and dead centres from a fine turn, by complex numbers."""
    known = after("tasks/radial.md")
    turn = np.radians(np.arange(0, 360, 0.01))
    pin = 0.073 * np.exp(1j * turn)
    rod = (pin.real + np.sqrt(0.265**2 - pin.imag**2) - pin) / 0.265
    for number, degrees in enumerate(range(40, 360, 40), start=1):
        angle = math.radians(degrees)
        knuckle = (pin + 0.062 * rod * np.exp(1j * angle)) * np.exp(-1j * angle)
        place = knuckle.real + np.sqrt(0.203**2 - knuckle.imag**2)
        assert known["result"].stroke[number] == pytest.approx(np.ptp(place), abs=1e-9)
        assert degrees + known["result"].top_shift[number] == pytest.approx(0.01 * place.argmax(), abs=0.006)
    np.testing.assert_allclose(known["equal"].stroke, 0.146, rtol=0, atol=1e-8)


def test_sweep(after):
    known = after("tasks/sweep.md")
    rods, found = np.arange(30, 241, 5) / 1e3, known["found"]
    closes = rods > 0.040
    fastest = 0.040 * (50 * math.pi) ** 2 * (1 + 0.040 / rods[closes])
    np.testing.assert_allclose(found.largest_piston_acceleration[0, closes], fastest, rtol=1e-12)
    assert np.all(np.isnan(found.largest_piston_acceleration[0, ~closes]))
    largest = np.arcsin(0.040 / rods[closes])
    np.testing.assert_allclose(np.abs(found.largest_pressure_angle[0, closes]), largest, rtol=1e-12)
    # The first order's couple by the throws' vectors.
    arms = (np.arange(5) - 2) * 0.1
    for order, couple in zip(known["orders"], known["couples"], strict=True):
        exact = abs(np.sum(arms * np.exp(1j * np.radians(order)))) * 0.040 * (50 * math.pi) ** 2
        assert couple[0, 0] == pytest.approx(exact, rel=1e-12)


def test_start(after):
    """What was in motion and what the motor gave is what load and losses took, once all stands still."""
    known = after("tasks/start.md")
    stopped = known["stopped"]
    given = stopped.motor_work[-1] + stopped.kinetic_energy[0]
    assert stopped.load_work[-1] + stopped.lost_work[-1] == pytest.approx(given, rel=1e-6)
    assert known["hard"].crank_speed[-1] == pytest.approx(0, abs=1e-9)
    assert max(known["full"].load_work) > max(known["empty"].load_work)
