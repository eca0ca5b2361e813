"""Crank-rocker: the four-bar linkage of pumping units, jaw crushers, tilting tables and shakers."""

from dataclasses import replace
from functools import cache, partial
from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.change_points import ChangePoints, Form
from cranktrain.mechanisms.crank_rocker.drawing import crank_rocker_drawing
from cranktrain.mechanisms.crank_rocker.facts import CrankRockers, transmission, transmission_rows
from cranktrain.mechanisms.crank_rocker.forces import DYNAMICS
from cranktrain.mechanisms.crank_rocker.kinematics import (
    CrankRocker,
    CrankRockerMotion,
    crank_rocker,
    crank_rocker_gap,
    crank_rocker_least_gap,
)
from cranktrain.mechanisms.crank_rocker.spec import (
    CrankRockerSpec,
    crank_rocker_advice,
    crank_rocker_form,
    crank_rocker_geometry,
)
from cranktrain.mechanisms.crank_rocker.through import apart, crank_rocker_through, in_line
from cranktrain.mechanisms.kind import Kind
from cranktrain.mechanisms.output import ROCKER

__all__ = ["KIND", "CrankRocker", "CrankRockerMotion", "CrankRockerSpec", "crank_rocker"]


@cache
def _of_form(form: Form) -> Kind[CrankRockerMotion, CrankRocker]:
    """Give the kind of those linkages that pass change points in one form; the kind itself of those that do not."""
    if not form:
        return KIND
    return replace(
        KIND,
        structure=form,
        motion=partial(crank_rocker_through, form),
        gap=partial(apart, form),
        least_gap=None,
        drawing=partial(crank_rocker_drawing, form=form),
        change_points=ChangePoints(in_line, "rod_length", {"": form}),
    )


KIND = Kind(
    name="crank_rocker",
    title=N_("crank-rocker, a four-bar linkage"),
    spec=CrankRockerSpec,
    geometry=crank_rocker_geometry,
    motion=crank_rocker,
    gap=crank_rocker_gap,
    least_gap=crank_rocker_least_gap,
    lengths=("crank_radius", "rod_length", "rocker_length", "ground_length"),
    output=ROCKER,
    has_rod=True,
    links=("rod", "rocker"),
    drawing=crank_rocker_drawing,
    closing_advice=crank_rocker_advice,
    members=CrankRockers,
    structure_of=crank_rocker_form,
    of_structure=_of_form,
    stages=(transmission,),
    rows=(transmission_rows,),
    dynamics=DYNAMICS,
    is_outlined=True,
    handles=(
        Handle("A", ("crank_radius",)),
        Handle("B", ("rod_length", "rocker_length")),
        Handle("C", ("ground_length",)),
    ),
    speed="10 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "crank_rocker"
crank_radius = "100 mm"
rod_length = "360 mm"
rocker_length = "280 mm"
ground_length = "400 mm"          # shaft centre to the rocker's pivot
side = "left"                     # of the line from crank pin to pivot, where its joint lies
# load_radius = "500 mm"          # radius about the pivot at which the load is carried
# load_direction = "with"         # "against": its travel counts against the rocker's angle

# [mechanism.points.bucket]       # a coupler point to follow
# link = "rod"
# along = "180 mm"
# across = "60 mm"
""",
)
