"""Motion: how pistons, rods, rockers and points on links move."""

from collections.abc import Iterator

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Dimension, Parts, Question, Stage
from cranktrain.questions.motion import couplers, rods
from cranktrain.questions.motion.axial_positions import axial_positions
from cranktrain.questions.motion.closing import closing
from cranktrain.questions.motion.dead_centres import dead_centres, piston_grid, piston_turn
from cranktrain.questions.motion.followed import (
    FollowedLinks,
    FollowedSliders,
    followed_of,
    link_motion,
    slider_motions,
)
from cranktrain.questions.motion.pistons import piston_motion, piston_speeds
from cranktrain.questions.motion.points import link_points_of, point_motion, point_problems
from cranktrain.questions.motion.rocker_load import load_motion, load_radius_of
from cranktrain.questions.motion.rockers import dead_positions, rocker_motion, rocker_speeds, rocker_turn


def _problems(design: Design) -> tuple[Problem, ...]:
    return point_problems(design.places)


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield link_points_of(designs.places)
    yield followed_of(FollowedLinks, designs.places[0])
    yield followed_of(FollowedSliders, designs.places[0])
    yield load_radius_of(designs.places)


QUESTION = Question(
    "motion",
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(piston_turn),
        Stage(piston_grid),
        Stage(dead_centres),
        Stage(piston_motion),
        Stage(rods.rod_motion, applies=rods.on_rods),
        Stage(piston_speeds),
        Stage(rods.rod_speeds),
        Stage(rocker_turn),
        Stage(dead_positions),
        Stage(rocker_motion),
        Stage(couplers.coupler_motion, applies=couplers.on_rods),
        Stage(rocker_speeds),
        Stage(couplers.coupler_speeds),
        Stage(load_motion),
        Stage(point_motion),
        Stage(link_motion),
        Stage(slider_motions),
        Stage(axial_positions),
        Stage(closing),
    ),
    dimensions=(Dimension("point", N_("point")), Dimension("link", N_("link")), Dimension("slider", N_("slider"))),
    headline=("stroke", "mean_piston_speed", "largest_piston_speed", "swing", "time_ratio", "closing_margin"),
)
