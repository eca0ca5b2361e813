"""Crankshaft: what its main bearings carry, by every method from the split shaft to the crank frame."""

from collections.abc import Iterator

from cranktrain.errors import Problem, judged
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import ANY_NAME, Parts, Question, ResultDimension, Stage, TableFile, Use, table
from cranktrain.questions.crankshaft import rows
from cranktrain.questions.crankshaft.loads.gears import declared_gears, gear_problems
from cranktrain.questions.crankshaft.loads.load_places import loaded_shafts
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts, loads_over_cycle
from cranktrain.questions.crankshaft.parts import declared_crankshafts
from cranktrain.questions.crankshaft.problems import crankshaft_problems
from cranktrain.questions.crankshaft.results import (
    bearings_between_events,
    crank_sizes,
    housing_spread,
    journal_loads,
    main_bearing_loads,
    pressures,
    section_torques,
    shaft_events,
    shaft_peaks,
    shaft_places,
    supported_shafts,
    throw_bending,
    unlikely,
)
from cranktrain.questions.crankshaft.shaft_layout import shaft_layouts, with_rods
from cranktrain.questions.crankshaft.spec import CrankshaftSpec, GearSpec


def _problems(design: Design) -> Iterator[Problem]:
    spec = design.table(CrankshaftSpec)
    if spec is not None:
        yield from judged(crankshaft_problems(spec, design))
    yield from gear_problems(design.tables.get("gear", {}), design)


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield declared_crankshafts(designs)
    yield declared_gears(designs)


_HOMES = (("crankshaft",), ("crankshaft", ANY_NAME))
"""Where pulls may stand: in the table of all shafts, or in one shaft's."""


QUESTION = Question(
    "crankshaft",
    tables={"crankshaft": CrankshaftSpec, "gear": GearSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(shaft_layouts, applies=with_rods),
        Stage(shaft_places.shaft_places),
        Stage(crank_sizes.crank_sizes),
        Stage(throw_bending.throw_bending),
        Stage(loaded_shafts),
        Stage(supported_shafts.supported_shafts),
        Stage(loads_over_cycle),
        Stage(shaft_events.shaft_events),
        Stage(shaft_events.shaft_points),
        Stage(bearings_between_events.bearings_between_events),
        Stage(shaft_peaks.shaft_peaks),
        Stage(main_bearing_loads.main_bearing_loads),
        Stage(housing_spread.housing_spread, applies=housing_spread.in_elastic_bearings),
        Stage(journal_loads.journal_loads),
        Stage(journal_loads.journal_wear),
        Stage(section_torques.section_torques),
        Stage(pressures.crank_pin_pressures, applies=pressures.have_rod_widths),
        Stage(pressures.main_bearing_pressures, applies=pressures.have_bearing_widths),
        Stage(unlikely.unlikely_crankshafts),
    ),
    dimensions=(
        ResultDimension("bearing_method", N_("bearing method"), own=0),
        ResultDimension("bearing", N_("bearing")),
        ResultDimension("pin", N_("pin")),
        ResultDimension("throw_plane", N_("plane of the throw")),
        ResultDimension("section", N_("section"), titles=section_torques.SECTION_TITLES),
    ),
    headline=("largest_bearing_load",),
    title=N_("Main bearings"),
    rows=(rows.bearing_rows, rows.torque_rows),
    offers={"main_bearing_load_x": N_("loads of main bearings")},
    curve_tables={
        "bearings": ("main_bearing_load_x", "main_bearing_load_y", "journal_load_along", "journal_load_across"),
    },
    files=tuple(TableFile((*home, "pull", ANY_NAME), None, N_("the file of a pull")) for home in _HOMES),
    uses=(Use(table("crankshaft"), (main_bearing_loads.MainBearingLoads,)), Use(table("gear"), (LoadedShafts,))),
)
