"""Torsion of whole machines: inertia of throws, what is said, critical speeds, vector sums, and what is refused."""

import cmath
import copy
import dataclasses

import mpmath as mp
import numpy as np
import pytest
from tests.told import line_of, lines_of, problems_told, texts_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.questions.torsion.critical import CriticalSpeeds, mode_vector_sums
from cranktrain.questions.torsion.modes import TorsionalModes

FLYWHEEL = {"inertia": "2 kg·m²", "beside": 4, "stiffness": "2 MN·m/rad"}
PULLEY = {"inertia": "0.02 kg·m²", "beside": 1, "stiffness": "1 MN·m/rad"}
FOUR = {
    "shaft": {"main": {"throws": ["0 deg", "180 deg", "180 deg", "0 deg"], "speed": "3000 rpm"}},
    "bank": {"line": {"mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "130 mm"}}},
    "cylinder": {"bore": "80 mm", "cycle": "four-stroke", "firing_order": "1-3-4-2"},
    "masses": {"piston": {"mass": "0.5 kg"}},
    "torsion": {"stiffness": "0.4 MN·m/rad", "throw_inertia": "0.01 kg·m²", "disc": {"flywheel": FLYWHEEL}},
}


def four(**changes):
    """The in-line four with other values by path, None to leave one out, and its result."""
    data = copy.deepcopy(FOUR)
    for path, value in changes.items():
        *tables, key = path.split("__")
        table = data
        for name in tables:
            table = table.setdefault(name, {})
        if value is None:
            del table[key]
        else:
            table[key] = value
    return ct.Machine(**data)


def run(machine, **options):
    return ct.run(machine, step_degrees=90, **options)


def piston_mean(mass, radius, rod):
    """Mean over a turn of m x′² of a piston at a central slider-crank, in 30 digits."""
    with mp.workdps(30):
        r, l = mp.mpf(radius), mp.mpf(rod)

        def slope(p):
            return r * mp.sin(p) * (1 + r * mp.cos(p) / mp.sqrt(l**2 - r**2 * mp.sin(p) ** 2))

        quarters = [i * mp.pi / 2 for i in range(5)]
        return float(mp.mpf(mass) * mp.quad(lambda p: slope(p) ** 2, quarters) / (2 * mp.pi))


class TestInertia:
    """Of a throw: the mean of the exact J(φ), and what is declared beside it."""

    def test_piston(self):
        found = run(four()).disc_inertia
        np.testing.assert_allclose(found[:4], 0.01 + piston_mean("0.5", "0.04", "0.13"), rtol=1e-14)
        assert found[4] == 2.0

    def test_crank_and_rod_of_one_throw(self):
        """Against the whole machine's reduced inertia, which forces give."""
        masses = {
            "piston": {"mass": "0.5 kg"},
            "rod": {"mass": "0.7 kg", "along": "40 mm", "inertia": "0.002 kg·m²"},
            "crank": {"mass": "3 kg", "along": "15 mm", "inertia": "0.004 kg·m²"},
        }
        machine = ct.Machine(
            mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "130 mm", "offset": "7 mm"},
            shaft={"main": {"speed": "100 rpm"}},
            masses=masses,
            torsion={"disc": {"flywheel": FLYWHEEL | {"beside": 1}}},
        )
        result = ct.run(machine)
        np.testing.assert_allclose(result.disc_inertia[0], np.mean(result.reduced_inertia), rtol=1e-14)

    def test_all_mechanisms_of_a_throw_count_on_it(self):
        """Master and slave of a V-engine: the discs together are the mean of all."""
        machine = ct.load("3d12").with_({"torsion": {"stiffness": "3 MN·m/rad"}})
        result = ct.run(machine)
        np.testing.assert_allclose(np.sum(result.disc_inertia), np.mean(result.reduced_inertia), rtol=1e-13)
        np.testing.assert_allclose(result.disc_inertia, result.disc_inertia[0], rtol=1e-13)

    def test_bank_on_some_throws(self):
        machine = four(bank__line__throws=[1, 4], cylinder__firing_order="1-2")
        found = run(machine).disc_inertia
        np.testing.assert_allclose(found[1:3], 0.01)
        np.testing.assert_allclose(found[[0, 3]], 0.01 + piston_mean("0.5", "0.04", "0.13"), rtol=1e-14)

    def test_without_masses(self):
        found = run(four(masses=None)).disc_inertia
        np.testing.assert_array_equal(found, [0.01] * 4 + [2.0])


def test_two_discs():
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "130 mm"},
        torsion={
            "throw_inertia": "2 kg·m²",
            "disc": {"rotor": {"inertia": "90 kg·m²", "beside": 1, "stiffness": "27 kN·m/rad", "ratio": "1/3"}},
        },
    )
    result = run(machine)
    referred = 90 / 9
    np.testing.assert_allclose(result.natural_frequency, [np.sqrt(27000 / 9 * (1 / 2 + 1 / referred))], rtol=1e-14)
    np.testing.assert_allclose(result.mode_shape, [[1.0, -2 / referred]], rtol=1e-14)
    np.testing.assert_array_equal(result.disc_ratio, [1.0, 1 / 3])
    np.testing.assert_allclose(result.disc_stiffness, [3000.0, np.nan])


def test_result_is_labelled():
    result = run(four())
    assert result.labels["disc"] == ("1", "2", "3", "4", "flywheel")
    assert result.labels["mode"] == ("1", "2", "3", "4")
    assert result.dataset["mode_shape"].dims == ("mode", "disc")
    assert result.dataset["critical_speed"].sel(mode=1, order=4) == pytest.approx(result.natural_frequency[0] / 4)


def test_checks_hold():
    checks = {check.name: check for check in run(four()).checks}
    assert checks["holzer"].passed.all()
    assert checks["torsional_modes"].passed.all()


def test_answers():
    result = run(four())
    first = result.natural_frequency[0] / (2 * np.pi)
    said = line_of(result, "Torsion", "natural frequencies")
    assert said.startswith(f"{first:.1f} Hz, ")
    assert said.endswith(" Hz and 1 more")
    below, above = (60 * first / order for order in (10, 8))  # of 8.5, 9 and 9.5 the cylinders work against each other
    assert below < 3000 < above
    said = f"{below:.0f} rpm (order 10), {above:.0f} rpm (order 8)"
    assert line_of(result, "Torsion", "next critical speeds") == said


def test_no_speed_is_needed():
    result = run(four(shaft__main__speed=None))
    np.testing.assert_array_equal(result.natural_frequency, run(four()).natural_frequency)
    assert [line.partition(":")[0] for line in lines_of(result, "Torsion")] == ["natural frequencies"]
    assert result.critical_speed.shape == (4, 48)


class TestVectorSums:
    """How far the cylinders add up in each mode."""

    def test_by_hand(self):
        result = run(four())
        for mode in range(4):
            for place, order in enumerate(np.arange(1, 49) / 2):
                total = sum(
                    result.mode_shape[mode, throw] * cmath.exp(-1j * order * np.radians(angle))
                    for throw, angle in enumerate([0, 540, 180, 360])
                )
                assert result.mode_vector_sum[mode, place] == pytest.approx(abs(total), abs=1e-11)

    def test_two_cylinders_on_a_throw(self):
        """A V8: each counts with the amplitude of the throw that it is on."""
        machine = ct.load("kamaz_740").with_({"torsion": {"stiffness": "2 MN·m/rad", "throw_inertia": "0.2 kg·m²"}})
        result = run(machine)
        angles = np.radians(result.firing_angle)
        throws = [int(name[0]) - 1 for name in result.labels["cylinder"]]
        for place, order in enumerate(np.arange(1, 49) / 2):
            total = np.sum(result.mode_shape[0, throws] * np.exp(-1j * order * angles))
            assert result.mode_vector_sum[0, place] == pytest.approx(abs(total), abs=1e-11)

    @pytest.mark.parametrize("name", ["kamaz_740", "vaz_21213"])
    def test_they_are_what_the_cylinders_torques_do(self, name):
        """Every mechanism's own torque over the cycle, by order and times its amplitude, against one cylinder's."""
        table = {"stiffness": "2 MN·m/rad", "throw_inertia": ["0.1 kg·m²", "0.3 kg·m²", "0.2 kg·m²", "0.4 kg·m²"]}
        result = ct.run(ct.load(name).with_({"torsion": table}))
        orders = np.fft.rfft(result.mechanism_torque, axis=-1)[:, 1:25]
        throws = [int(name[0]) - 1 for name in result.labels["mechanism"]]
        assert np.min(np.abs(orders[0])) > 1e-4 * np.max(np.abs(orders[0]))
        for mode in range(3):
            together = np.abs(np.sum(result.mode_shape[mode, throws][:, np.newaxis] * orders, axis=0))
            np.testing.assert_allclose(
                together / np.abs(orders[0]), result.mode_vector_sum[mode, :24], rtol=1e-8, atol=1e-8
            )

    @pytest.mark.parametrize("name", ["kamaz_740", "3d12", "vaz_21213", "r_1340"])
    def test_on_a_rigid_shaft_they_are_the_phase_stars(self, name):
        """As the stage gives them for a mode in which all discs turn as one."""
        from cranktrain.analysis import every_stage
        from cranktrain.analysis.outcomes import run_stages
        from cranktrain.analysis.parts import parts_of
        from cranktrain.analysis.stages import lacking

        disc = {"rotor": {"inertia": "2 kg·m²", "beside": 1, "stiffness": "2 MN·m/rad"}}
        machine = ct.load(name)
        table = {"throw_inertia": "0.1 kg·m²", "disc": disc}
        if len(machine.main_shaft.throws) > 1:
            table["stiffness"] = "1 MN·m/rad"
        machine = machine.with_({"torsion": table})
        parts = parts_of([machine], step=np.radians(90))
        known = parts | run_stages(every_stage(), parts, lacking(every_stage(), parts))
        modes = known[TorsionalModes]
        rigid = dataclasses.replace(modes, mode_shape=np.ones_like(modes.mode_shape[:, :1]))
        (stage,) = (one for one in every_stage() if one.function is mode_vector_sums)
        needs = {need: known[kind] for need, kind in stage.needs.items()} | {"modes": rigid}
        stars = run(machine).phase_star_sum
        np.testing.assert_array_equal(mode_vector_sums(**needs).mode_vector_sum[0, 0], stars)

    def test_they_need_a_firing_order(self):
        result = run(four(cylinder__firing_order=None))
        (needs,) = (missing.needs for missing in result.missing if "mode_vector_sum" in missing.results)
        assert texts_of(needs) == ("[cylinder] firing_order or firing_angles",)
        assert result.critical_speed.shape == (4, 48)

    def test_a_pump_has_whole_orders(self):
        result = run(four(cylinder__firing_order=None, cylinder__cycle=None))
        assert result.labels["order"][:2] == ("1", "2")
        np.testing.assert_allclose(result.critical_speed[2, :2], result.natural_frequency[2] / [1, 2])


class TestFreeEnd:
    """Where the amplitude is 1."""

    def test_throw_1_unless_given(self):
        result = run(four(torsion__disc__pulley=PULLEY))
        np.testing.assert_array_equal(result.mode_shape[:, result.labels["disc"].index("1")], 1.0)

    def test_given(self):
        result = run(four(torsion__disc__pulley=PULLEY, torsion__free_end="pulley"))
        np.testing.assert_array_equal(result.mode_shape[:, result.labels["disc"].index("pulley")], 1.0)
        assert texts_of(result.flags) == texts_of(run(four()).flags)

    def test_a_node_there_is_said(self):
        """Two equal rotors beside the flywheel swing against each other; the crankshaft does not notice."""
        rotor = {"inertia": "1 kg·m²", "beside": "flywheel", "stiffness": "1 kN·m/rad"}
        result = run(four(torsion__disc__port=rotor, torsion__disc__starboard=rotor))
        (mode,) = np.flatnonzero(np.isclose(result.natural_frequency, np.sqrt(1000)))
        flags = [flag for flag in texts_of(result.flags) if "is a node" in flag]
        assert len(flags) == 1
        assert flags[0].startswith(f"In mode {mode + 1} the free end 1 is a node: its amplitudes are 1 at ")
        np.testing.assert_array_equal(result.mode_vector_sum[mode] < 1e-12, True)


class TestRefused:
    """What only the tables together show."""

    @pytest.mark.parametrize(
        ("changes", "path", "words"),
        [
            ({"torsion__stiffness": None}, "torsion.stiffness", "one for each of the 3 gaps"),
            ({"torsion__stiffness": ["1 MN·m/rad"] * 4}, "torsion.stiffness", "one for each gap between throws: 3"),
            ({"torsion__throw_inertia": ["1 kg·m²"] * 3}, "torsion.throw_inertia", "one for each throw: 4"),
            ({"torsion__disc__flywheel__beside": 5}, "torsion.disc.flywheel.beside", "1 to 4"),
            ({"masses": None, "torsion__throw_inertia": None}, "torsion.throw_inertia", "on throw 1, 2, 3, 4"),
            (
                {"bank__line__throws": [1, 4], "cylinder__firing_order": "1-2", "torsion__throw_inertia": None},
                "torsion.throw_inertia",
                "on throw 2, 3",
            ),
        ],
    )
    def test_refused(self, changes, path, words):
        with pytest.raises(InputError) as refused:
            run(four(**changes))
        (problem,) = problems_told(refused.value.problems)
        assert problem.path == path
        assert words in problem.allowed

    def test_one_throw_alone(self):
        machine = {"mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "130 mm"}}
        for table, path in (
            ({"throw_inertia": "1 kg·m²"}, "torsion.disc"),
            (
                {"throw_inertia": "1 kg·m²", "stiffness": "1 MN·m/rad", "disc": {"f": FLYWHEEL | {"beside": 1}}},
                "torsion.stiffness",
            ),
        ):
            with pytest.raises(InputError) as refused:
                run(ct.Machine(**machine, torsion=table))
            assert [problem.path for problem in refused.value.problems] == [path]

    @pytest.mark.parametrize("name", ["10d100", "deltic"])
    def test_several_crankshafts(self, name):
        with pytest.raises(InputError, match="one crankshaft and one piston in a cylinder"):
            run(ct.load(name).with_({"torsion": {"stiffness": "1 MN·m/rad"}}))


def test_throws_without_inertia_are_said():
    """A mass of which nothing moves on these throws: the check cannot be judged, and no number is made up."""
    result = run(four(torsion__throw_inertia=["0 kg·m²", "1 kg·m²", "1 kg·m²", "1 kg·m²"], masses=None))
    assert np.isnan(result.natural_frequency).all()
    assert any("no inertia: 1;" in flag for flag in texts_of(result.flags))
    (check,) = (check for check in result.checks if check.name == "holzer")
    assert str(check.verdict()) == "needs an inertia of every disc"


def test_designs():
    machines = [four(torsion__disc__flywheel__inertia=f"{size} kg·m²") for size in (1, 3)]
    result = run(machines)
    for design, machine in enumerate(machines):
        for name in ("natural_frequency", "mode_shape", "holzer_sum", "mode_vector_sum", "critical_speed"):
            np.testing.assert_array_equal(getattr(result, name)[design], getattr(run(machine), name))


def test_links_that_cannot_close_have_no_frequencies():
    machine = four(bank__line__mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "30 mm"})
    result = run(machine, partial=True)
    assert np.isnan(result.natural_frequency).all()
    (check,) = (check for check in result.checks if check.name == "holzer")
    assert str(check.verdict()) == "needs a full turn"
    assert lines_of(result, "Torsion") == []


class TestMajorOrders:
    """Next to the machine's speed are critical speeds of orders that excite the mode much."""

    @pytest.mark.parametrize("rpm", [120, 700, 1500, 2900, 6100, 15000, 200000])
    def test_the_nearest_on_both_sides(self, rpm):
        """Found here by looking at all orders, with the vector sums of this module's own phasors."""
        result = run(four(shaft__main__speed=f"{rpm} rpm"))
        orders = np.arange(1, 49) / 2
        shape = result.mode_shape[0, :4]
        phasors = np.exp(-1j * orders[:, np.newaxis] * np.radians([0, 540, 180, 360]))
        sums = np.abs(phasors @ shape)
        speeds = result.natural_frequency[0] / orders * 30 / np.pi
        every = zip(speeds.tolist(), orders.tolist(), sums.tolist(), strict=True)
        major = [(speed, order) for speed, order, one in every if one >= 0.5 * max(sums)]
        slower = max((one for one in major if one[0] <= rpm), default=None)
        faster = min((one for one in major if one[0] > rpm), default=None)
        found = result.get(CriticalSpeeds).beside(0)
        assert [orders[place] for place in found] == [one[1] for one in (slower, faster) if one is not None]

    def test_where_nothing_fires_all_orders_count(self):
        result = run(four(cylinder__firing_order=None))
        first = result.natural_frequency[0] * 30 / np.pi
        orders = np.ceil(first * 2 / 3000) / 2, np.floor(first * 2 / 3000) / 2
        near = [(first / order, order) for order in orders]
        said = line_of(result, "Torsion", "next critical speeds")
        assert all(f"{speed:.0f} rpm (order {order:g})" in said for speed, order in near)
        assert result.get(CriticalSpeeds).sums is None
