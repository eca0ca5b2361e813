"""Every number of a machine file is a column of designs: varied by itself, three designs are laid out as each alone.

Neither side is expected to be right here; what is laid out says all that the stages are given.
"""

import ast
import re
import tomllib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from pydantic import BaseModel
from tests.gas_engines import csv
from tests.machines import V12

import cranktrain as ct
from cranktrain import fluids
from cranktrain.analysis.parts import parts_of
from cranktrain.columns import in_columns, n_rows, row_of
from cranktrain.machine import machine_problems
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.kind import Kind
from cranktrain.quantities import Given
from cranktrain.spec import Spec

SOURCE = Path(ct.__file__).parent
STEP = np.radians(90)
ALL = slice(None)

EXAMPLES = (
    *("3d12_quoted_rods", "burning_cylinder", "deltic", "gas_compressor", "jumo_205e", "kamaz_740", "lms_class5"),
    *("mud_pump_12p160", "pumping_unit_c57", "shaper", "toggle_press", "traction_engine", "vaz_21213"),
)

WORKED = {
    "bank": {"A": {"mechanism": {"kind": "slider_crank", "stroke": "80 mm", "rod_length": "140 mm", "offset": "2 mm"}}},
    "shaft": {"main": {"throws": ["0 deg", "180 deg"], "spacing": "100 mm", "speed": "900 rpm"}},
    "cylinder": {
        "bore": "90 mm",
        "compression_ratio": 9.0,
        "cycle": "four-stroke",
        "firing_angles": ["0 deg", "540 deg"],
    },
    "masses": {
        "crank": {"mass": "3 kg", "along": "12 mm", "across": "1 mm", "inertia": "0.01 kg*m^2"},
        "rod": {"big_end": "0.9 kg", "small_end": "0.4 kg"},
        "piston": {"mass": "0.7 kg"},
    },
    "friction": {"piston": 0.08},
    "guide": {"piston": {"length": "60 mm", "middle": "-8 mm"}},
    "gravity": {"acceleration": "9.8 m/s^2", "direction": "30 deg"},
}
"""An engine to which the tables of fluids, balance, evenness and torsion can be added."""

TABLES = {
    "balance, given": {
        "balance": {
            "weight": [
                {"mass": "1 kg", "radius": "40 mm", "throw": 1, "angle": "170 deg"},
                {"mass": "2 kg", "radius": "30 mm", "z": "20 mm", "angle": "10 deg", "place": ["50 mm", "60 mm"]},
                {
                    "throw": 2,
                    "sector": {
                        "outer_radius": "80 mm",
                        "inner_radius": "30 mm",
                        "opening": "100 deg",
                        "thickness": "20 mm",
                        "density": "7800 kg/m³",
                    },
                },
            ],
            "shafts": [{"order": 2, "forward": ["90 mm", "10 mm"], "backward": ["-90 mm", "10 mm"]}],
        }
    },
    "balance, solved for": {
        "balance": {"counterweights": "rotating", "share": 0.4, "planes": ["-10 mm", "110 mm"]},
        "cylinder": {**WORKED["cylinder"], "friction_pressure": "1 bar"},
    },
    "evenness": {
        "evenness": {
            "flywheel_moment": "8 kg*m^2",
            "coefficient": 0.02,
            "rim": {"mean_diameter": "500 mm", "width_ratio": 1.5, "other_share": 0.1},
        },
        "cylinder": {**WORKED["cylinder"], "mechanical_efficiency": 0.8},
    },
    "a motor": {
        "evenness": {"flywheel": "2 kg*m^2"},
        "drive": {"motor": {"kind": "shunt", "torque": "90 N*m", "speed": "950 rpm", "no_load_speed": "1000 rpm"}},
    },
    "a motor by its plate": {
        "drive": {
            "motor": {
                "kind": "cage",
                "power": "7.5 kW",
                "speed": "1465 rpm",
                "breakdown_ratio": 3.0,
                "starting_ratio": 2.3,
                "pull_up_ratio": 1.8,
                "flywheel_moment": "0.2 kg*m^2",
            }
        }
    },
    "a drive": {
        "drive": {
            "motor": {
                "kind": "cage",
                "curve": "kloss",
                "breakdown_torque": "95 N*m",
                "breakdown_slip": 0.2,
                "synchronous_speed": "1500 rpm",
                "inertia": "0.02 kg*m^2",
            },
            "stage": [
                {"ratio": 3, "efficiency": 0.95, "drag": "0.2 N*m"},
                {"ratio": 2, "efficiency": 0.9, "efficiency_back": 0.8},
                {"ratio": 5, "lead_angle": "10 deg", "friction_angle": "4 deg"},
            ],
            "part": {
                "coupling": {"inertia": "0.05 kg*m^2"},
                "wheel": {"on": 2, "flywheel_moment": "3 kg*m^2"},
                "gear": {"on": 3, "inertia": "2 kg*m^2"},
            },
            "brake": {"torque": "100 N*m", "delay": "50 ms", "rise_time": "80 ms"},
            "start": {
                "angle": "60 deg",
                "speed": "1 rpm",
                "duration": "5 s",
                "until_speed": "37 rpm",
                "overspeed": "60 rpm",
                "motor_off": "3 s",
                "motor_reversed": "2 s",
                "brake_on": "4 s",
                "interval": "0.01 s",
            },
            "duty": {
                "kind": "S3",
                "duty_factor": 0.3,
                "cycle_time": "8 min",
                "thermal_time_constant": "20 min",
                "pause_cooling": 0.4,
                "constant_losses": 0.2,
                "start": "unloaded",
                "starts_per_hour": "30 1/h",
                "unloaded_starts": "900 1/h",
                "start_load_factor": 0.7,
                "allowed_start_time": "2 s",
                "lowest_voltage": 0.92,
                "largest_inertia_ratio": 8,
            },
            "flywheel": {"on": 2, "largest_torque": "40 N*m"},
        }
    },
    "loads": {
        "load": {
            "cut": {
                "on": "piston",
                "force": ["1 kN", "3 kN", "2 kN"],
                "force_back": ["0.1 kN", "0.3 kN", "0.2 kN"],
                "travel": ["0 mm", "30 mm", "81 mm"],
            },
            "weight": {
                "on": "rod",
                "force": "200 N",
                "sense": "active",
                "direction": "40 deg",
                "along": "50 mm",
                "across": "5 mm",
            },
            "rope": {"on": "crank", "force": "90 N", "sense": "active", "radius": "30 mm", "direction": "70 deg"},
            "fan": {"on": "crank", "torque": "2 N*m", "at_turning": "90 rad/s", "exponent": 2},
            "cam": {"on": "crank", "torque": ["1 N*m", "3 N*m"], "crank_angles": ["20 deg", "200 deg"]},
        }
    },
    "a press": {
        "drive": {
            "motor": {
                "kind": "cage",
                "curve": "kloss",
                "breakdown_torque": "95 N*m",
                "breakdown_slip": 0.2,
                "synchronous_speed": "1500 rpm",
            },
            "stage": [{"ratio": 3}, {"ratio": 5}],
            "part": {"flywheel": {"on": 1, "inertia": "24 kg*m^2"}},
            "clutch": {
                "on": 1,
                "torque": "4800 N*m",
                "static_torque": "6000 N*m",
                "delay": "30 ms",
                "rise_time": "60 ms",
                "release_delay": "20 ms",
                "fall_time": "30 ms",
                "mean_power": "800 W",
                "driven_inertia": "0.4 kg*m^2",
            },
            "brake": {
                "on": "crank",
                "torque": "2600 N*m",
                "static_torque": "2800 N*m",
                "delay": "40 ms",
                "rise_time": "50 ms",
                "release_delay": "10 ms",
                "fall_time": "20 ms",
                "mean_power": "900 W",
            },
            "stroke": {"start_angle": "180 deg", "command_angle": "470 deg", "strokes_per_minute": 30},
        }
    },
    "torsion by sizes": {
        "torsion": {"stiffness_method": "carter", "throw_inertia": "0.02 kg*m^2"},
        "crankshaft": {
            "journal_diameter": "50 mm",
            "pin_diameter": "48 mm",
            "pin_length": "28 mm",
            "web_thickness": "18 mm",
            "web_width": "76 mm",
        },
    },
    "crankshaft": {
        "crankshaft": {
            "journal_diameter": ["55 mm", "56 mm", "57 mm"],
            "journal_bore": "9 mm",
            "pin_diameter": "50 mm",
            "pin_bore": "8 mm",
            "pin_length": "28 mm",
            "web_thickness": ["17 mm", "18 mm", "19 mm", "20 mm"],
            "web_width": "70 mm",
            "bearing_stiffness": ["300 kN/mm", "400 kN/mm"],
            "bearing_clearance": "0.05 mm",
            "bearing_width": "20 mm",
            "web_height": "110 mm",
            "density": "7800 kg/m³",
            "young_modulus": "205 GPa",
            "poisson_ratio": 0.29,
            "bearing": {
                "2": {"settlement": ["0.01 mm", "0.02 mm"], "width": "25 mm"},
                "out": {"z": "400 mm", "stiffness": "100 kN/mm", "clearance": "0.1 mm"},
            },
            "pull": {"belt": {"z": "300 mm", "force": "2 kN", "direction": "70 deg"}},
        },
        "gear": {
            "out": {
                "shafts": "main",
                "z": "330 mm",
                "radius": "80 mm",
                "direction": "30 deg",
                "pressure_angle": "21 deg",
                "helix_angle": "10 deg",
            }
        },
    },
    "torsion": {
        "torsion": {
            "stiffness": "1 MN*m/rad",
            "throw_inertia": "0.02 kg*m^2",
            "disc": {
                "flywheel": {"inertia": "1 kg*m^2", "beside": 2, "stiffness": "2 MN*m/rad"},
                "rotor": {"inertia": "3 kg*m^2", "beside": "flywheel", "stiffness": "1 MN*m/rad", "ratio": 1.5},
            },
        }
    },
}


def fluid_table(fluid):
    """The table of a fluid's example with what it leaves out, and what its file would hold."""
    table = tomllib.loads(re.sub(r"(?m)^# (\w+ = |\[)", r"\1", fluid.example))["gas"]
    degrees = np.arange(0.0, 720.0, 5.0)
    card = csv(degrees, 1e5 * (20 + 18 * np.cos(np.radians(degrees / 2) - 0.1)))
    return table | ({"text": card} if "file" in table else {})


def filled_by(fluid):
    """The engine, or a compressor like it, with a fluid in it."""
    cylinder = WORKED["cylinder"] if fluid.fires else {"bore": "90 mm", "compression_ratio": 9.0}
    return WORKED | {"cylinder": cylinder, "gas": fluid_table(fluid)}


def of_kind(kind):
    """The kind's example, with a point on a link."""
    data = tomllib.loads(kind.example)
    table = data["mechanism"] if "mechanism" in data else next(reversed(data["bank"].values()))["mechanism"]
    if links := next(place.kind.links for place in ct.Machine(**data).places if place.kind.name == kind.name):
        table["points"] = {"p": {"link": links[0], "along": "30 mm", "across": "11 mm"}}
    if "load_radius" in kind.spec.model_fields:
        table["load_radius"] = "300 mm"
    return data


MACHINES = (
    {name: lambda name=name: ct.load(name) for name in EXAMPLES}
    | {kind.name: lambda kind=kind: ct.Machine(**of_kind(kind)) for kind in KINDS}
    | {fluid.name: lambda fluid=fluid: ct.Machine(**filled_by(fluid)) for fluid in fluids.KINDS}
    | {name: lambda tables=tables: ct.Machine(**WORKED | tables) for name, tables in TABLES.items()}
    | {"a star": lambda: ct.Machine(**V12, crank_zero="15 deg")}
)

SAYS_NOTHING = (
    re.compile(r"^angle$"),  # of a machine with banks
    re.compile(r"^shaft\.\w+\.throws\.0$"),  # from which the others count
    re.compile(r"stagger$|spacing\.\d+$"),  # along a shaft whose, or another's, spacing is not given
    re.compile(r"firing_angles\.\d+$"),  # says the turn; the crank pins say where in it
    re.compile(r"crank\.\w+\.ratio$"),  # of a chain's crank is 1
    re.compile(r"leg\.\d+\.near\.\d$"),  # chooses a way of putting together, but does not move it
    re.compile(r"^drive\.motor\.pull_up_slip"),  # of a curve without a saddle
    re.compile(r"^drive\.(start|brake)\."),  # of a run over time, which is of one design
    re.compile(r"^gas\.(ambient|peg\.(pressure|exponent|angle|start|end))$"),  # of a card that says otherwise
)
"""Numbers by which nothing that is laid out need change."""

TIED = re.compile(
    r"^shaft\.\w+\.(throws\.\d+|phase)$|^bank\.\w+\.(lead|angle\.0)$|^load\.\w+\.(travel\.0|force(_back)?\.\d+)$"
    r"|^mechanism\.load_radius$|^load\.\w+_card\.radius$"
    r"|^bank\.\w+\.((exhaust|scavenge)\.)?mechanism\.(0\.)?(crank_radius|stroke|offset)$"
)
"""Numbers of opposed pistons that cannot change alone; where a travel begins; forces of 0 that resist; one arc; one
pin."""


def numbers_of(value, path=()):
    """Numbers of a spec with their paths."""
    if isinstance(value, Given):
        yield path, value.si
    elif isinstance(value, Spec):
        for name in type(value).model_fields:
            yield from numbers_of(getattr(value, name), (*path, name))
    elif isinstance(value, Mapping | tuple):
        for key, item in value.items() if isinstance(value, Mapping) else enumerate(value):
            yield from numbers_of(item, (*path, key))


def with_number(value, path, si):
    """The spec with another number at a path."""
    if not path:
        return replace(value, si=si, text=f"{si!r} in SI units")
    key, *rest = path
    if isinstance(value, Spec):
        return BaseModel.model_copy(value, update={key: with_number(getattr(value, key), rest, si)})
    if isinstance(value, Mapping):
        return {**value, key: with_number(value[key], rest, si)}
    return tuple(with_number(item, rest, si) if i == key else item for i, item in enumerate(value))


def laid_out(machines):
    """All that is laid out of some designs."""
    return tuple(parts_of(machines, step=STEP).values())


@cache
def names_in(kind):
    """Fields of a part that holds others; none of what is one thing by itself."""
    holds = is_dataclass(kind) and not issubclass(kind, Kind | fluids.Fluid)
    return tuple(field.name for field in fields(kind)) if holds else ()


def pairs(part, alone, rows):
    """Arrays and numbers in what is laid out, in order: of several designs what some rows hold, and one's alone."""
    assert type(part) is type(alone)
    if isinstance(part, np.ndarray):
        own = part if part.shape == alone.shape else part[rows]
        if part.dtype != object:
            yield own, alone
            return
        for one, other in zip(own.flat, alone.flat, strict=True):
            yield from pairs(one, other, ALL)
    elif isinstance(part, float):
        yield part, alone
    elif isinstance(part, tuple):
        for one, other in zip(part, alone, strict=True):
            yield from pairs(one, other, rows)
    else:
        for name in names_in(type(part)):
            yield from pairs(getattr(part, name), getattr(alone, name), rows)


def equal(one, other):
    """Whether two arrays or numbers are the same; NaN is."""
    if isinstance(one, float) or isinstance(other, float):
        return np.array_equal(one, other, equal_nan=True)
    is_alike = one.shape == other.shape and one.dtype == other.dtype
    return (is_alike and one.tobytes() == other.tobytes()) or np.array_equal(one, other, equal_nan=True)


def is_same(part, alone, rows=ALL):
    return all(one is other or equal(one, other) for one, other in pairs(part, alone, rows))


def spreads_over_designs(node: ast.AST) -> bool:
    """Whether a number, or a column, is made one of each design by hand: `np.broadcast_to(number, n_designs)`."""
    if not isinstance(node, ast.Call) or getattr(node.func, "attr", "") != "broadcast_to" or len(node.args) < 2:
        return False
    return re.fullmatch(r"\(?(\w+\.)*n_designs(,\))?", ast.unparse(node.args[1])) is not None


def test_a_number_becomes_one_of_each_design_on_two_roads():
    """Where this fails: put it together by `in_columns` of tables, or by `by_design` of numbers."""
    found = {
        path.relative_to(SOURCE).as_posix(): node.lineno
        for path in SOURCE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if spreads_over_designs(node)
    }
    assert found == {}


@pytest.mark.parametrize(
    ("names", "home"),
    [(("in_columns", "row_of"), "columns.py"), (("by_design", "of_designs"), "numerics/designs.py")],
)
def test_a_road_has_one_place(names, home):
    """A method of `Designs` is the same function, of as many designs as there are."""
    defined = [
        (node.name, path.relative_to(SOURCE).as_posix())
        for path in SOURCE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef) and node.name in names and not node.decorator_list
    ]
    assert sorted(set(defined) - {("by_design", "layout/design.py")}) == sorted((name, home) for name in names)


@pytest.mark.parametrize("name", MACHINES)
def test_every_number_is_a_column(name):
    machine = MACHINES[name]()
    first, still = laid_out([machine]), []
    assert not machine_problems(machine, partial=True)
    for path, si in numbers_of(machine):
        said = ".".join(map(str, path))
        others = [with_number(machine, path, si + more * (si or 1.0)) for more in (1e-5, -1.5e-5)]
        if any(machine_problems(one, partial=True) for one in others):
            assert TIED.search(said), said
            continue
        alone, together = [first, *(laid_out([one]) for one in others)], laid_out([machine, *others])
        for design, own in enumerate(alone):
            assert is_same(together, own, slice(design, design + 1)), (said, design)
        if all(is_same(own, first) for own in alone):
            still.append(said)
    assert [said for said in still if not any(known.search(said) for known in SAYS_NOTHING)] == []


def test_rows_are_the_designs():
    machines = [ct.Machine(**WORKED, gas=fluid_table(fluids.KINDS[1]), name=name) for name in ("one", "other")]
    machines[1] = with_number(machines[1], ("cylinder", "bore"), 0.1)
    together = in_columns(machines)
    assert n_rows(together) == 2
    assert n_rows(machines[0]) == 1
    for i, machine in enumerate(machines):
        assert list(numbers_of(row_of(together, i))) == list(numbers_of(machine))
    # the first one says all that is no number
    assert together.name == "one"
