"""Exact mechanics of any machine with a crank in it: how it moves, which forces act, how evenly it runs.

Machines
    An example by its name, a machine file, or its tables as a dict; quantities are texts with units. `save` writes one.

    >>> import cranktrain as ct
    >>> ct.example_names()[:3]
    ('10d100', '38d8', '3d12')
    >>> ct.load("3d12")
    <Machine 3D12 marine diesel, 60° V12 with articulated rods: 12 pistons, 6 throws, banks L, R; 1500 rpm>
    >>> faster = ct.load("3d12", set={"shaft.main.speed": "1800 rpm"})
    >>> pump = ct.Machine(
    ...     name="a pump",
    ...     mechanism={"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"},
    ...     shaft={"main": {"speed": "120 rpm"}},
    ... )
    >>> longer = pump.with_({"mechanism.rod_length": "36 in"})
    >>> longer.mechanism.rod_length, longer.mechanism.rod_length.si
    (<36 in>, 0.9144)

Results
    `run` takes a name, a file, a dict, a machine, or a list of these. A quantity is an attribute, a read-only array in
    the unit of its entry in the catalogue, computed when it is first read; `dir(result)` has them all.

    >>> result = ct.run(pump)
    >>> result
    <Result of a pump: ... quantities, 1 check holds, ...>
    >>> round(float(result.stroke[0]), 4)
    0.3048
    >>> result.catalogue["stroke"]
    <stroke S [m]: Stroke, between the true dead centres>
    >>> way = ct.behind("stroke", pump)  # print it: tables of the file, then stages, each with its file and equations
    >>> result.piston_velocity.shape, result.crank_angle.shape
    ((1, 360), (360,))
    >>> result.facts["mean_piston_speed"]
    <mean_piston_speed c_m = <1> m/s>
    >>> print(result.summary().splitlines()[1])
      stroke: 12.00 in
    >>> [check.verdict() for check in result.checks]
    ['holds']
    >>> len(result.flags) > 0
    True
    >>> result.needs_of("gas_pressure")
    ('[cylinder] bore', ... '[gas]')
    >>> round(result.dataset["piston_displacement"].sel(piston="1", crank_angle=180).item(), 4)
    0.3048

Part of it, and many designs
    >>> list(ct.run(pump, quantities="stroke").dataset)
    ['stroke']
    >>> ct.run([pump, longer], quantities="largest_piston_speed").largest_piston_speed.shape
    (2, 1)
    >>> curve = ct.sweep(pump, {"rod_length": "5..40 in:8"}, "largest_piston_speed").plot()  # NaN where it cannot turn

Units and language
    What is shown has the units of the machine's file, or others that are asked for; arrays have those of the catalogue.

    >>> with ct.units("cm, ft/s"), ct.in_language("en"):
    ...     print(result.summary().splitlines()[1])
      stroke: 30.48 cm

A motor
    With `[drive]`, `run` knows how the machine runs with its motor, and `start` runs it over time, a `Start`.

    >>> started = ct.start("tilting_table", set={"drive.start.duration": "0.5 s"})
    >>> started
    <Start of Tilting table with a crank-rocker drive (illustrative): 0.5 s, the time asked for is over>
    >>> started.motor_torque.shape == started.time.shape
    True

Pictures
    Figures of matplotlib, `cranktrain[plot]`, which a notebook shows; `ct.viz` has plans and constructions too.

    >>> figure, sheet = result.plot("piston_velocity", "piston_acceleration"), result.sheet()
    >>> plan = ct.viz.plan_positions(pump, 12)
    >>> ct.viz.save(plan, "positions.svg")  # doctest: +SKIP
    >>> drawn = ct.drawing(pump, [0, 90])  # the same machine as data: shafts, pins, links, paths; drawn.to_dict()

Two machines
    >>> compared = ct.compare(pump, longer, quantities="largest_piston_speed")
    >>> print(f"{compared.rows[0].percent:.2f} %")
    -0.59 %
    >>> overlaid = compared.plot("piston_velocity")

The texts
    >>> ct.textbook.drive("tilting_table").numbered("(14)")[0].verdict
    'right'

Mistakes
    >>> try:
    ...     pump.with_({"mechanism.rod_length": "30 kg"})
    ... except ct.InputError as error:
    ...     print(error.problems[0].path, error.problems[0].given)
    mechanism.rod_length 30 kg
"""

from importlib import import_module
from typing import TYPE_CHECKING

from cranktrain.version import VERSION

if TYPE_CHECKING:
    from cranktrain import textbook, viz
    from cranktrain.analysis import Result
    from cranktrain.analysis.comparison import Comparison
    from cranktrain.errors import InputError, Problem
    from cranktrain.io.any_machine import load
    from cranktrain.io.examples import example_names
    from cranktrain.language import in_language
    from cranktrain.machine import Machine
    from cranktrain.public import behind, compare, drawing, run, start, sweep, units
    from cranktrain.study.start import Start
    from cranktrain.study.sweep import Sweep

__all__ = [
    "Comparison",
    "InputError",
    "Machine",
    "Problem",
    "Result",
    "Start",
    "Sweep",
    "__version__",
    "behind",
    "compare",
    "drawing",
    "example_names",
    "in_language",
    "load",
    "run",
    "start",
    "sweep",
    "textbook",
    "units",
    "viz",
]

__version__ = VERSION

# Imported when first asked for: the terminal's help and lists do without NumPy and pydantic.
_HOMES = {
    "Comparison": "analysis.comparison",
    "InputError": "errors",
    "Machine": "machine",
    "Problem": "errors",
    "Result": "analysis",
    "Start": "study.start",
    "Sweep": "study.sweep",
    "behind": "public",
    "compare": "public",
    "drawing": "public",
    "example_names": "io.examples",
    "in_language": "language",
    "load": "io.any_machine",
    "run": "public",
    "start": "public",
    "sweep": "public",
    "textbook": "textbook",
    "units": "public",
    "viz": "viz",
}


def __getattr__(name: str) -> object:
    if name in _HOMES:
        home = import_module(f"{__name__}.{_HOMES[name]}")
        return home if name == _HOMES[name] else getattr(home, name)
    if name.startswith("_"):
        raise AttributeError(f"cranktrain has no {name}")
    from cranktrain.quantities import nearest  # only after a mistake

    meant = nearest(name, __all__)
    raise AttributeError(f"cranktrain has no {name}" + (f"; did you mean {meant}?" if meant else ""))


def __dir__() -> list[str]:
    return [
        *(name for name in globals() if name.startswith("__")),
        *(name for name in __all__ if name != "__version__"),
    ]
